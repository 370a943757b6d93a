//! A small median-split tree: enough for pictures.

use hug_kit::rays::Ray;
use hug_kit::{Bounds, Mesh};

const LEAF: usize = 4;

struct Node {
    bounds: Bounds,
    /// A leaf's triangles, or the two children.
    content: Result<std::ops::Range<usize>, [usize; 2]>,
}

pub struct Tracer<'a> {
    mesh: &'a Mesh,
    order: Vec<u32>,
    nodes: Vec<Node>,
}

impl<'a> Tracer<'a> {
    pub fn new(mesh: &'a Mesh) -> Self {
        let count = mesh.indices.len();
        let mut tracer = Self { mesh, order: (0..count as u32).collect(), nodes: Vec::new() };
        tracer.split(0..count);
        tracer
    }

    fn split(&mut self, range: std::ops::Range<usize>) -> usize {
        let mesh = self.mesh;
        let part = &mut self.order[range.clone()];
        let corners = part.iter().flat_map(|&i| mesh.triangle(i as usize));
        let bounds = Bounds::of(corners).expect("scenes are not empty");
        let node = self.nodes.len();
        self.nodes.push(Node { bounds, content: Ok(range.clone()) });
        if range.len() > LEAF {
            let extent = [0, 1, 2].map(|k| bounds.hi[k] - bounds.lo[k]);
            let axis = (0..3).max_by(|&a, &b| extent[a].total_cmp(&extent[b])).expect("axes");
            let centre = |&i: &u32| mesh.triangle(i as usize).iter().map(|v| v[axis]).sum::<f32>();
            let half = range.len() / 2;
            part.select_nth_unstable_by(half, |a, b| centre(a).total_cmp(&centre(b)));
            let middle = range.start + half;
            let children = [self.split(range.start..middle), self.split(middle..range.end)];
            self.nodes[node].content = Err(children);
        }
        node
    }

    /// Distance and triangle of the first hit.
    pub fn closest(&self, ray: &Ray) -> Option<(f64, usize)> {
        let (org, dir) = (ray.org.map(f64::from), ray.dir.map(f64::from));
        let mut best = None;
        let mut open = vec![0];
        while let Some(node) = open.pop() {
            let node = &self.nodes[node];
            let limit = best.map_or(f64::INFINITY, |(t, _)| t);
            if !meets(&node.bounds, org, dir, limit) {
                continue;
            }
            match &node.content {
                Err(children) => open.extend(children),
                Ok(range) => {
                    for &prim in &self.order[range.clone()] {
                        let found = pierce(self.mesh.triangle(prim as usize), org, dir);
                        if let Some(t) = found
                            && best.is_none_or(|(least, _)| t < least)
                        {
                            best = Some((t, prim as usize));
                        }
                    }
                }
            }
        }
        best
    }
}

fn meets(bounds: &Bounds, org: [f64; 3], dir: [f64; 3], limit: f64) -> bool {
    let (mut near, mut far) = (0.0f64, limit);
    for k in 0..3 {
        let a = (f64::from(bounds.lo[k]) - org[k]) / dir[k];
        let b = (f64::from(bounds.hi[k]) - org[k]) / dir[k];
        near = near.max(a.min(b));
        far = far.min(a.max(b));
    }
    near <= far * (1.0 + 1e-12)
}

/// Moeller and Trumbore's test.
fn pierce(corners: [[f32; 3]; 3], org: [f64; 3], dir: [f64; 3]) -> Option<f64> {
    let [a, b, c] = corners.map(|v| glam::DVec3::from_array(v.map(f64::from)));
    let (org, dir) = (glam::DVec3::from_array(org), glam::DVec3::from_array(dir));
    let (e1, e2, s) = (b - a, c - a, org - a);
    let p = dir.cross(e2);
    let det = e1.dot(p);
    let u = s.dot(p) / det;
    let q = s.cross(e1);
    let v = dir.dot(q) / det;
    let t = e2.dot(q) / det;
    (u >= 0.0 && v >= 0.0 && u + v <= 1.0 && t > 0.0).then_some(t)
}
