//! Deciding whether untrusted bytes are an arena.
//!
//! One pass over everything, no allocation, O(size). What it establishes is
//! what `view` relies on, and that every walk ends: grids only point to later
//! grids of lower level, whose numbers of entries (`walks`) add up.

use super::layout::{
    ALIGN, BYTE_ORDER, COVERS, EMPTY, EXIT_BITS, EXIT_MAX, Frame, GRID, GRID_BIT, Grid, Header,
    LIST, LIST_HEAD, MAGIC, MAX_WALKS, PAYLOAD, REF_WORDS, TAG_SHIFT, TURNED, Triangle, VERSION,
    sections,
};
use super::node::{Node, QuantizedNode, TREE_UNITS};
use super::tree;
use crate::Error;
use crate::geometry::MAX_TRIANGLES;
use crate::options::{MAX_COUNT, MAX_LEVELS};
use crate::ray::NONE;

/// Checks what the header alone can tell: magic, byte order, version, size.
///
/// # Errors
/// The reason why these bytes cannot be an arena.
#[cfg(feature = "capi")]
pub fn check_header(bytes: &[u8]) -> Result<(), Error> {
    header(bytes).map(|_| ())
}

fn header(bytes: &[u8]) -> Result<&Header, Error> {
    if !(bytes.as_ptr() as usize).is_multiple_of(ALIGN) {
        return Err(Error::Alignment);
    }
    if bytes.len() < MAGIC.len() {
        return Err(Error::Truncated);
    }
    if bytes[..MAGIC.len()] != MAGIC {
        return Err(Error::Magic);
    }
    // In every version they are what follows; headers may be shorter.
    let words = bytes.get(MAGIC.len()..MAGIC.len() + 8).ok_or(Error::Truncated)?;
    let [byte_order, version] =
        [0, 4].map(|at| bytemuck::pod_read_unaligned::<u32>(&words[at..at + 4]));
    if byte_order != BYTE_ORDER {
        return Err(Error::Endianness);
    }
    if version != VERSION {
        return Err(Error::Version);
    }
    let head = bytes.get(..size_of::<Header>()).ok_or(Error::Truncated)?;
    let header: &Header = bytemuck::try_from_bytes(head).map_err(|_| Error::Alignment)?;
    if header.bytes > bytes.len() as u64 {
        return Err(Error::Truncated);
    }
    Ok(header)
}

fn require(ok: bool, error: Error) -> Result<(), Error> {
    if ok { Ok(()) } else { Err(error) }
}

fn agree(ok: bool) -> Result<(), Error> {
    require(ok, Error::Corrupt)
}

/// Checks everything.
pub fn check(bytes: &[u8]) -> Result<(), Error> {
    let h = header(bytes)?;
    let counts = (h.grids.count, h.voxels.count, h.refs.count, h.triangles.count);
    let (expected, size) = sections(&h.counts()).map_err(|_| Error::Sections)?;
    let placed = expected == h.sections() && size == h.bytes;
    require(placed && [0, counts.0].contains(&h.frames.count), Error::Sections)?;
    agree(is_unit(h.unit) && h.levels as usize <= MAX_LEVELS)?;
    agree((1..=3).contains(&h.structure))?;
    agree(counts.0 < u64::from(GRID_BIT) && counts.3 <= MAX_TRIANGLES as u64)?;
    agree(counts.1 <= u64::from(u32::MAX) && counts.2 <= u64::from(u32::MAX))?;
    let grids: &[Grid] = section(bytes, h.grids.offset, counts.0)?;
    let voxels: &[u32] = section(bytes, h.voxels.offset, counts.1)?;
    let refs: &[u32] = section(bytes, h.refs.offset, counts.2)?;
    let triangles: &[Triangle] = section(bytes, h.triangles.offset, counts.3)?;
    agree(grids.is_empty() == triangles.is_empty())?;
    let named = |&number: &u32| number == NONE || u64::from(number) < counts.3;
    require(h.occluders.iter().all(named), Error::Reference)?;
    agree(triangles.iter().all(|t| t.corners().as_flattened().iter().all(|x| x.is_finite())))?;
    agree(h.reserved == [0; 5] && h.quantized <= 1.min(h.nodes.count))?;
    agree(h.nodes.count == 0 || TREE_UNITS.contains(&h.unit))?;
    let nodes = h.nodes;
    if h.quantized == 0 {
        tree::check::<Node>(section(bytes, nodes.offset, nodes.count)?, counts.3)?;
    } else {
        tree::check::<QuantizedNode>(section(bytes, nodes.offset, nodes.count)?, counts.3)?;
    }
    if grids.is_empty() {
        return agree(voxels.is_empty() && refs.is_empty());
    }
    let frames: &[Frame] = section(bytes, h.frames.offset, h.frames.count)?;
    let (mut next, mut end) = (0u64, 0);
    for (i, grid) in grids.iter().enumerate() {
        agree(u64::from(grid.first) == next && in_range(grid))?;
        let turned = grid.flags & TURNED != 0;
        agree(!turned || i > 0 && frames.get(i).is_some_and(is_rotation))?;
        agree(u32::from(grid.level) < h.levels)?;
        next += grid.voxels();
        agree(next <= counts.1)?;
        end = lists(i, grid, grids, voxels, (refs, end), counts.3)?;
    }
    agree(u64::from(grids[0].walks) <= MAX_WALKS * counts.0)?;
    agree(next == counts.1 && end == refs.len())
}

fn section<T: bytemuck::Pod>(bytes: &[u8], offset: u64, count: u64) -> Result<&[T], Error> {
    let start = usize::try_from(offset).map_err(|_| Error::Sections)?;
    let len = (count as usize).checked_mul(size_of::<T>()).ok_or(Error::Sections)?;
    let end = start.checked_add(len).ok_or(Error::Sections)?;
    let part = bytes.get(start..end).ok_or(Error::Sections)?;
    bytemuck::try_cast_slice(part).map_err(|_| Error::Sections)
}

/// A box cut into counts in range, of a place and size that `f32` triangles can
/// have: the walk's arithmetic then stays finite.
fn in_range(grid: &Grid) -> bool {
    grid.flags & !(COVERS | TURNED) == 0
        && (0..3).all(|k| {
            (1..=MAX_COUNT).contains(&u32::from(grid.n[k]))
                && (-1e45..=1e45).contains(&grid.lo[k])
                && (1e-25..=4.0).contains(&grid.cell[k])
                && (0.999..=1.001).contains(&(grid.cell[k] * grid.inv_cell[k]))
        })
}

/// A rotation, or a reflection, to well within the walk's error, about a place that `f32`
/// triangles can have. The fourth lanes are 0.
fn is_rotation(frame: &Frame) -> bool {
    let a = &frame.axes;
    let dot = |i: usize, j: usize| (0..3).map(|k| a[i][k] * a[j][k]).sum::<f64>();
    let near = |x: f64, to: f64| (x - to).abs() < 1e-12;
    let units = (0..3).all(|i| near(dot(i, i), 1.0) && near(dot(i, (i + 1) % 3), 0.0));
    let place = frame.origin.iter().all(|x| (-1e45..=1e45).contains(x));
    units && place && frame.origin[3] == 0.0 && a.iter().all(|column| column[3] == 0.0)
}

/// A power of two, in the range of the reciprocals of boxes of `f32` numbers.
fn is_unit(x: f64) -> bool {
    (1e-45..=1e46).contains(&x) && x.to_bits() << 12 == 0
}

/// The voxels of a grid: exit boxes inside it, lists one after the other from
/// `end` on, in order, without repetition, and down only. Returns the new end.
fn lists(
    number: usize,
    grid: &Grid,
    grids: &[Grid],
    voxels: &[u32],
    (refs, mut end): (&[u32], usize),
    triangles: u64,
) -> Result<usize, Error> {
    let below = |child: u32| -> Result<u64, Error> {
        let child = child as usize;
        let below = grids.get(child).ok_or(Error::Reference)?;
        require(child > number && below.level < grid.level, Error::Cycle)?;
        Ok(u64::from(below.walks))
    };
    let mut most = 0u64;
    let n = grid.n.map(u32::from);
    let [nx, ny, nz] = n;
    let mut voxel = voxels[grid.first as usize..].iter();
    let cells = (0..nz).flat_map(|z| (0..ny).flat_map(move |y| (0..nx).map(move |x| [x, y, z])));
    for (at, &word) in cells.zip(&mut voxel) {
        let payload = word & PAYLOAD;
        let mut walks = 0;
        match word >> TAG_SHIFT {
            EMPTY => agree(exit_inside(payload, at, n))?,
            GRID => walks = below(payload)?,
            LIST => {
                require(payload as usize == end, Error::Reference)?;
                let head = refs.get(end..end + LIST_HEAD).ok_or(Error::Reference)?;
                agree(exit_inside(head[0], at, n))?;
                let rest = &refs[end + LIST_HEAD..];
                let list = rest.get(..head[1] as usize).ok_or(Error::Reference)?;
                require(list.is_sorted_by(|a, b| a < b), Error::Reference)?;
                for &r in list {
                    if r & GRID_BIT == 0 {
                        require(u64::from(r) < triangles, Error::Reference)?;
                    } else {
                        walks += below(r & !GRID_BIT)?;
                    }
                }
                let boxes = rest[list.len()..].get(..list.len()).ok_or(Error::Reference)?;
                agree(boxes.iter().all(|b| b >> TAG_SHIFT == 0))?;
                end += LIST_HEAD + REF_WORDS * list.len();
            }
            _ => agree(false)?,
        }
        most = most.max(walks);
    }
    agree(u64::from(grid.walks) == most + 1)?;
    Ok(end)
}

fn exit_inside(word: u32, at: [u32; 3], n: [u32; 3]) -> bool {
    word >> TAG_SHIFT == 0
        && (0..3).all(|k| {
            let reach = |side: usize| word >> ((2 * k + side) as u32 * EXIT_BITS) & EXIT_MAX;
            reach(0) <= at[k] && at[k] + reach(1) < n[k]
        })
}
