//! Meshes from PLY files: triangles, or polygons as fans of them.

use hug_kit::Mesh;
use ply_rs_bw::parser::{Parser, Reader};
use ply_rs_bw::ply::{DefaultElement, PropertyAccess, PropertyAccessResult};
use std::fmt::Display;
use std::fs::File;
use std::io::{BufRead, BufReader};
use std::path::Path;

#[derive(Default)]
struct Vertex([f32; 3]);

impl PropertyAccess for Vertex {
    fn new() -> Self {
        Self::default()
    }

    fn set_float(&mut self, name: &str, value: f32) -> PropertyAccessResult {
        match name {
            "x" => self.0[0] = value,
            "y" => self.0[1] = value,
            "z" => self.0[2] = value,
            _ => return PropertyAccessResult::Ignored,
        }
        PropertyAccessResult::Set
    }

    fn set_double(&mut self, name: &str, value: f64) -> PropertyAccessResult {
        self.set_float(name, value as f32)
    }
}

/// Indices as they are in the file: one below 0 becomes one that no vertex has.
#[derive(Default)]
struct Face(Vec<u32>);

impl Face {
    fn set(&mut self, name: &str, corners: impl Iterator<Item = u32>) -> PropertyAccessResult {
        if name != "vertex_indices" && name != "vertex_index" {
            return PropertyAccessResult::Ignored;
        }
        self.0.extend(corners);
        PropertyAccessResult::Set
    }
}

impl PropertyAccess for Face {
    fn new() -> Self {
        Self::default()
    }

    fn set_list_int(&mut self, name: &str, value: Vec<i32>) -> PropertyAccessResult {
        self.set(name, value.into_iter().map(|i| u32::try_from(i).unwrap_or(u32::MAX)))
    }

    fn set_list_uint(&mut self, name: &str, value: Vec<u32>) -> PropertyAccessResult {
        self.set(name, value.into_iter())
    }
}

/// The mesh of a PLY file of any of the three encodings.
pub fn read(path: &Path) -> Result<Mesh, String> {
    let failed = |what: &dyn Display| format!("{}: {}", path.display(), one_line(what));
    let file = File::open(path).map_err(|error| failed(&error))?;
    let mut buffered = BufReader::new(file);
    let begins = buffered.fill_buf().map_err(|error| failed(&error))?;
    if begins.is_empty() {
        return Err(failed(&"is empty"));
    }
    if !begins.starts_with(b"ply") {
        return Err(failed(&"does not begin as a PLY file does (OBJ files must end in .obj)"));
    }
    let mut reader = Reader::new(buffered);
    let (vertices, faces) = (Parser::<Vertex>::new(), Parser::<Face>::new());
    let header = vertices.read_header(&mut reader).map_err(|error| failed(&error))?;
    let mut mesh = Mesh::default();
    for (name, element) in &header.elements {
        match name.as_str() {
            "vertex" => {
                let read = vertices.read_payload_for_element(&mut reader, element, &header);
                let read = read.map_err(|error| failed(&error))?;
                mesh.vertices = read.into_iter().map(|v| v.0).collect();
            }
            "face" => {
                let read = faces.read_payload_for_element(&mut reader, element, &header);
                let read = read.map_err(|error| failed(&error))?;
                mesh.indices = read.iter().flat_map(fan).collect();
            }
            _ => {
                Parser::<DefaultElement>::new()
                    .read_payload_for_element(&mut reader, element, &header)
                    .map_err(|error| failed(&error))?;
            }
        }
    }
    if mesh.indices.is_empty() {
        return Err(failed(&"has no faces that can be read"));
    }
    let count = mesh.vertices.len();
    if mesh.indices.iter().flatten().any(|&i| i as usize >= count) {
        return Err(failed(&"a face names a vertex that is not there"));
    }
    Ok(mesh)
}

/// The reader's errors take several lines, some of them about its grammar.
fn one_line(what: &dyn Display) -> String {
    let text = what.to_string();
    let grammar = |line: &str| line.contains("ParseError {") || line.contains("expected one of");
    let mut lines: Vec<&str> = text.lines().map(str::trim).collect();
    lines.retain(|line| !line.is_empty() && !grammar(line));
    lines.join(" ")
}

fn fan(face: &Face) -> impl Iterator<Item = [u32; 3]> + '_ {
    face.0.windows(2).skip(1).map(|edge| [face.0[0], edge[0], edge[1]])
}
