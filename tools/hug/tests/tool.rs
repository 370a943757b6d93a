//! The tool as a person runs it.

use std::fs;
use std::io::Cursor;
use std::path::{Path, PathBuf};
use std::process::{Command, Output};

fn hug(arguments: &[&str]) -> Output {
    let mut command = Command::new(env!("CARGO_BIN_EXE_hug"));
    command.env_remove("HUG_SCENES").args(arguments).output().expect("the tool runs")
}

#[track_caller]
fn printed(arguments: &[&str]) -> String {
    let output = hug(arguments);
    let said = String::from_utf8_lossy(&output.stderr);
    assert!(output.status.success(), "{arguments:?}: {said}");
    String::from_utf8_lossy(&output.stdout).into_owned()
}

/// The one line on standard error.
#[track_caller]
fn refused(arguments: &[&str]) -> String {
    let output = hug(arguments);
    assert!(!output.status.success() && output.stdout.is_empty(), "{arguments:?}");
    String::from_utf8_lossy(&output.stderr).trim_end().to_owned()
}

/// A folder of the test's own, empty.
fn folder(name: &str) -> PathBuf {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("tool").join(name);
    let _ = fs::remove_dir_all(&folder);
    fs::create_dir_all(&folder).expect("a folder below the target");
    folder
}

/// A file in it, as the argument that names it.
fn file(folder: &Path, name: &str, bytes: impl AsRef<[u8]>) -> String {
    let path = folder.join(name);
    fs::write(&path, bytes).expect("a file that can be written");
    path.to_str().expect("a path in UTF-8").to_owned()
}

const CORNERS: [[f32; 3]; 5] =
    [[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0], [0.5, 0.5, 1.0]];
const FACES: [&[i32]; 5] = [&[0, 1, 2, 3], &[0, 1, 4], &[1, 2, 4], &[2, 3, 4], &[3, 0, 4]];

fn header(format: &str) -> String {
    let vertex = "element vertex 5\nproperty float x\nproperty float y\nproperty float z\n";
    let face = "element face 5\nproperty list uchar int vertex_indices\nend_header\n";
    format!("ply\nformat {format} 1.0\n{vertex}{face}")
}

/// A pyramid, six triangles, in each of the formats.
fn pyramids(folder: &Path) -> [String; 3] {
    let mut text = header("ascii");
    let mut binary = header("binary_little_endian").into_bytes();
    let mut obj = String::from("# a pyramid\no pyramid\n");
    for [x, y, z] in CORNERS {
        text += &format!("{x} {y} {z}\n");
        binary.extend([x, y, z].iter().flat_map(|c| c.to_le_bytes()));
        obj += &format!("v {x} {y} {z}\n");
    }
    for face in FACES {
        let list: Vec<String> = face.iter().map(i32::to_string).collect();
        text += &format!("{} {}\n", face.len(), list.join(" "));
        binary.push(face.len() as u8);
        binary.extend(face.iter().flat_map(|i| i.to_le_bytes()));
        let list: Vec<String> = face.iter().map(|i| (i + 1).to_string()).collect();
        obj += &format!("f {}\n", list.join(" "));
    }
    [file(folder, "a.ply", text), file(folder, "b.ply", binary), file(folder, "c.obj", obj)]
}

#[test]
fn every_format_is_the_same_scene() {
    let folder = folder("formats");
    let mut arenas = Vec::new();
    for scene in pyramids(&folder) {
        let out = format!("{scene}.hug");
        let said = printed(&["build", &scene, "--out", &out]);
        assert!(said.contains("6 triangles") && said.contains(&out), "{said}");
        arenas.push(fs::read(out).expect("the arena"));
    }
    assert!(arenas[0] == arenas[1] && arenas[0] == arenas[2]);
}

#[test]
fn a_saved_scene_is_the_scene() {
    let folder = folder("saved");
    let [scene, ..] = pyramids(&folder);
    let saved = format!("{scene}.hug");
    printed(&["save", &scene, "--out", &saved, "--structure", "hug", "--threads", "2"]);
    let info = printed(&["info", &saved]);
    for part in ["structure    Hug", "triangles    6", "| references", "| all"] {
        assert!(info.contains(part), "{part}: {info}");
    }
    let built = printed(&["info", &scene, "--structure", "hug"]);
    assert_eq!(info.split_once('\n').unwrap().1, built.split_once('\n').unwrap().1);

    let camera = ["--camera", "2,-3,2,0.5,0.5,0.3,0,0,1,40", "--size", "32"];
    for mode in ["shaded", "depth", "steps"] {
        let pictures = [&scene, &saved].map(|from| {
            let out = format!("{from}-{mode}.png");
            let arguments = ["render", from, "--structure", "hug", "--mode", mode, "--out", &out];
            printed(&[&arguments[..], &camera].concat());
            fs::read(out).expect("a picture")
        });
        assert!(pictures[0] == pictures[1], "{mode}");
        let mut reader =
            png::Decoder::new(Cursor::new(&pictures[0])).read_info().expect("a PNG file");
        let mut pixels = vec![0; 32 * 32];
        reader.next_frame(&mut pixels).expect("a whole picture");
        assert!(pixels.iter().any(|&p| p != pixels[0]), "{mode}: one grey only");
    }
}

#[test]
fn structures_are_compared() {
    let small = ["compare", "surface:2000", "--size", "24", "--rounds", "1", "--check", "4"];
    let said = printed(&[&small[..], &["--structure", "auto,g20,r50,u.f2.1"]].concat());
    for name in ["auto", "g20", "r50", "u.f2.1", "bounce2", "agree bit for bit"] {
        assert!(said.contains(name), "{name}: {said}");
    }
}

#[test]
fn the_report_is_made() {
    let folder = folder("report");
    let out = folder.join("out");
    let arguments = ["report", "--scene", "surface:500", "--structure", "auto", "--size", "16"];
    let out = ["--rounds", "1", "--quiet", "--out", out.to_str().expect("UTF-8")];
    let said = printed(&[&arguments[..], &out].concat());
    assert!(fs::metadata(said.trim_end()).is_ok_and(|page| page.len() > 1000), "{said}");
}

#[test]
fn errors_name_the_file_and_the_reason() {
    let folder = folder("errors");
    let [scene, ..] = pyramids(&folder);
    let cut = file(&folder, "cut.ply", header("ascii") + "0 0 0\n");
    let said = refused(&["build", &cut]);
    assert!(said.starts_with(&format!("{cut}: ")) && said.lines().count() == 1, "{said}");

    let wrong = fs::read_to_string(&scene).unwrap().replace("3 1 2 4", "3 1 2 9");
    let wrong = file(&folder, "wrong.ply", wrong);
    let said = refused(&["build", &wrong]);
    assert!(said.starts_with(&format!("{wrong}: ")) && said.contains("vertex"), "{said}");

    let starts = |arguments: &[&str], with: &str| {
        let said = refused(arguments);
        assert!(said.starts_with(with) && said.lines().count() == 1, "{said}");
    };
    let garbage = [0x81u8, 0x00, 0xff, 0x0a].repeat(500);
    for (name, bytes, reason) in [
        ("nothing.ply", &[][..], "is empty"),
        ("garbage.ply", &garbage, "does not begin as a PLY file does"),
        ("garbage.hug", &garbage, "does not begin as a PLY file does"),
        ("garbage.obj", &garbage, "is not text"),
        ("header.ply", b"ply\nformat ascii 1.0\nelement vert", "Line 3: Couldn't parse line."),
        ("no.obj", b"", "has no faces"),
        ("word.obj", b"v 0 zero 0\n", "position parse error"),
        ("far.obj", b"v 0 0 0\nf 1 2 3\n", "face vertex index out of bounds"),
    ] {
        let name = file(&folder, name, bytes);
        starts(&["build", &name], &format!("{name}: {reason}"));
        starts(&["render", &name], &format!("{name}: {reason}"));
    }
    let nan = fs::read_to_string(&scene).unwrap().replace("1 1 0\n", "1 nan 0\n");
    let nan = file(&folder, "nan.ply", nan);
    starts(&["build", &nan], &format!("{nan}: Line 12: Couldn't read element line."));
    let mut filled = header("binary_little_endian").into_bytes();
    filled.extend([0xff; 5 * 12]);
    filled.extend(FACES.iter().flat_map(|_| [&[3u8][..], &[0; 12]].concat()));
    let filled = file(&folder, "filled.ply", filled);
    starts(&["build", &filled], &format!("{filled}: no finite vertex"));
    let here = folder.to_str().expect("UTF-8");
    starts(&["info", here], &format!("{here}: a folder, not a file"));
    starts(&["build", &scene, "-o", here], &format!("{here}: "));
    starts(&["render", &scene, "-o", "no such folder/x.png"], "no such folder/x.png: ");
    starts(&["build", "nowhere.ply"], "nowhere.ply: no such file");

    let empty = file(&folder, "empty.obj", "v 0 0 0\n");
    assert!(refused(&["info", &empty]).starts_with(&format!("{empty}: has no faces")));

    let saved = format!("{scene}.hug");
    printed(&["build", &scene, "-o", &saved]);
    let mut bytes = fs::read(&saved).unwrap();
    bytes.truncate(bytes.len() - 64);
    let short = file(&folder, "short.hug", bytes);
    assert!(refused(&["info", &short]).contains("shorter than its header says"));

    let said = refused(&["build", &scene, "-o", "no such folder/x.hug"]);
    assert!(said.starts_with("no such folder/x.hug: "), "{said}");
    assert!(refused(&["render", "nowhere"]).starts_with("nowhere: no such scene"));
    assert!(refused(&["build", &scene, "--structure", "tree"]).contains("a data structure"));
    assert!(refused(&["render", &saved, "--camera", "1,2,3"]).contains("--camera"));
    assert!(refused(&["render", &saved, "--view", "front"]).contains("--camera"));
}

#[test]
fn help_says_what_a_scene_is() {
    for command in ["build", "info", "render", "compare"] {
        let help = printed(&[command, "--help"]);
        assert!(help.contains("Usage: hug ") && help.contains("PLY file"), "{help}");
    }
    let help = printed(&["--help"]);
    for command in ["build", "info", "render", "compare", "report"] {
        assert!(help.contains(command), "{command}");
    }
}

/// What is counted is the same on every machine: these are the kitchen's own figures.
#[test]
fn counts() {
    let text = printed(&[
        "count",
        "kitchen",
        "-q",
        "--size",
        "8",
        "--structure",
        "hug,hug+components,uniform+overlap",
    ]);
    assert!(text.contains("most triangles are small and stand together"), "{text}");
    let row = |name: &str| -> Vec<f64> {
        let start = format!("| {name} ");
        let line = text.lines().find(|line| line.starts_with(&start)).expect(&text);
        line.split('|').filter_map(|cell| cell.trim().parse().ok()).collect()
    };
    let (projections, components) = (row("hug"), row("hug+components"));
    assert_eq!([&projections, &components].map(Vec::len), [10, 10]);
    assert!(components[0] < projections[0] && components[1] > projections[1], "{text}");
    assert_eq!(row("uniform+overlap")[1], 1.0, "{text}");
    assert!(text.contains("| advised: TwoLevels(0.05), Components |"), "{text}");
    let structures = "hug+components,hug+components+search+turn=1";
    let given = ["count", "kitchen", "clustered:900", "-q", "--size", "8"];
    let text = printed(&[&given[..], &["--structure", structures]].concat());
    assert!(text.contains(" turned |"), "{text}");
    let (_, means) = text.split_once("geometric means over 2 scenes").expect(&text);
    let all: Vec<&str> = means.lines().filter(|line| line.starts_with('|')).collect();
    assert_eq!(all.len(), 2 + 3, "{text}");
    assert_eq!(all[2].matches(" 1.00 ").count(), 6, "the first against itself: {text}");
    assert!(all[4].starts_with("| advised "), "{text}");
    let error = refused(&["count", "kitchen", "-q", "--structure", "hug+island"]);
    assert!(error.contains("+island: unknown"), "{error}");
}
