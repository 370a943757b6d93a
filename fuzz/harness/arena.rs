//! Small arenas to begin with, and the places in them that are worth a change.

use super::block::Block;
use super::input::Input;
use hug::{Filter, Geometry, Hierarchy, Options, Scene, Structure};
use std::sync::LazyLock;

/// Two clumps, a large triangle over both, and repetitions: some kilobytes as an arena.
fn triangles() -> Vec<[f32; 3]> {
    let mut vertices = vec![[-4.0, -4.0, -4.0], [4.0, -4.0, 0.0], [0.0, 4.0, 4.0]];
    for i in 0..18 {
        let side = if i % 2 == 0 { 3.0 } else { -3.0 };
        let (x, y) = ((i % 3) as f32 / 8.0 + side, (i / 3) as f32 / 8.0 - side);
        vertices.extend([[x, y, 0.0], [x + 0.2, y, 0.1], [x, y + 0.3, 0.2]]);
        if i % 5 == 0 {
            vertices.extend_from_within(vertices.len() - 3..);
        }
    }
    vertices
}

static SAMPLES: LazyLock<Vec<Vec<u8>>> = LazyLock::new(|| {
    let base = Options { maxp: 3, min_cluster: 1, ..Options::default() };
    let of = |structure| Options { structure, ..base };
    let hug = of(Structure::Hug);
    let paper = Options { hierarchy: Hierarchy::Paper, filter: Filter::ThreeLevels, ..hug };
    let fine = Options { alpha: 2.0, exit_boxes: false, ..of(Structure::Uniform) };
    let vertices = triangles();
    let indices: Vec<[u32; 3]> =
        (0..vertices.len() as u32 / 3).map(|i| [3 * i, 3 * i + 1, 3 * i + 2]).collect();
    let soup = [Geometry::from_mesh(&vertices, &indices)];
    let tree = Options { tree: true, ..of(Structure::Recursive) };
    let options = [of(Structure::Uniform), of(Structure::Recursive), hug, paper, fine, tree];
    let bytes = |options| Scene::build(&soup, options).map(|s| s.view().bytes().to_vec());
    options.iter().map(|o| bytes(o).expect("a valid soup")).collect()
});

/// One of the samples.
pub fn sample(input: &mut Input<'_>) -> Block {
    Block::copy(&SAMPLES[input.below(SAMPLES.len())])
}

fn get64(bytes: &[u8], at: usize) -> u64 {
    u64::from_le_bytes(bytes[at..at + 8].try_into().expect("eight bytes"))
}

/// A change of four bytes: anywhere, or in the header, a grid, a voxel, a list or a node.
pub fn damage(bytes: &mut [u8], input: &mut Input<'_>) {
    let words = bytes.len() / 4;
    // Where the sections are that an intact header names.
    let section = |i: usize| get64(bytes, 32 + 16 * i) as usize / 4;
    let region = match input.below(7) {
        0 => [0, 80],
        kind @ 1..=3 => [section(kind - 1), section(kind)],
        4 => [section(3), words],
        // That of the nodes, the last.
        5 => [get64(bytes, 256) as usize / 4, words],
        _ => [0, words],
    };
    let [start, end] = region.map(|word| word.min(words));
    let at = 4 * (start + input.below(65536) % end.saturating_sub(start).max(1)).min(words - 1);
    let word = u32::from_le_bytes(bytes[at..at + 4].try_into().expect("four bytes"));
    let new = match input.below(8) {
        0 => input.bits(),
        1 => word ^ 1 << input.below(32),
        2 => word.wrapping_add(1),
        3 => word.wrapping_sub(1),
        4 => input.float().to_bits(),
        5 => word.wrapping_add(u32::from(input.byte()) << 8),
        6 => input.one_of(&[0, 1, u32::MAX, 1 << 31, 1 << 30, 2 << 30]),
        _ => word.rotate_left(8),
    };
    bytes[at..at + 4].copy_from_slice(&new.to_le_bytes());
}
