//! The order of triangles along a curve through all cells of a fine grid (Morton 1966): what is
//! near in space is mostly near along it.

use super::item::Frame;
use crate::Error;
use crate::build::control::{Control, TASKS, parts};
use crate::build::gather::Soup;
use crate::build::scratch::cut;

/// Where the middle of a triangle's box lies along the curve, and the triangle's place in the soup.
pub type Key = [u64; 2];

/// Triangles of a task.
const SHARE: usize = 4096;
/// Bits of a cell's coordinate. Middles are below 2.
const BITS: u32 = 21;
/// Bits by which keys are parted among tasks, and by which these sort.
const COARSE: u32 = 11;
const DIGIT: u32 = 11;
/// Keys that are sorted one by one.
const FEW: usize = 32;

/// A bit of each number, then the next: three bits for each of their bits.
#[inline(always)]
fn interleave(cell: [u32; 3]) -> u64 {
    let spread = |x: u32| {
        let x = u64::from(x);
        let x = (x | x << 32) & 0x001f_0000_0000_ffff;
        let x = (x | x << 16) & 0x001f_0000_ff00_00ff;
        let x = (x | x << 8) & 0x100f_00f0_0f00_f00f;
        let x = (x | x << 4) & 0x10c3_0c30_c30c_30c3;
        (x | x << 2) & 0x1249_2492_4924_9249
    };
    spread(cell[0]) | spread(cell[1]) << 1 | spread(cell[2]) << 2
}

/// The keys of all triangles, sorted; `keys` is twice as many.
pub fn sorted<'a>(
    soup: &Soup<'_>,
    frame: &Frame,
    keys: &'a mut [Key],
    control: &mut Control<'_>,
) -> Result<&'a [Key], Error> {
    let n = soup.triangles.len();
    let (keys, room) = keys[..2 * n].split_at_mut(n);
    let chunk = SHARE * TASKS;
    for (i, (to, from)) in keys.chunks_mut(chunk).zip(soup.triangles.chunks(chunk)).enumerate() {
        let starts = (i * chunk..).step_by(SHARE);
        let mut rest = to.chunks_mut(SHARE).zip(from.chunks(SHARE)).zip(starts);
        let mut tasks = parts(|| rest.next());
        control.each(&mut tasks, |((to, from), start)| {
            for (place, (to, triangle)) in (*start as u64..).zip(to.iter_mut().zip(*from)) {
                *to = [interleave(frame.cell(triangle, 1 << (BITS - 1))), place];
            }
        })?;
        control.count(from.len());
        control.at(i * chunk, 2 * n)?;
    }
    let cell = |key: &Key| (key[0] >> (3 * BITS - COARSE)) as usize;
    let mut ends = [0u32; 1 << COARSE];
    keys.iter().for_each(|key| ends[cell(key)] += 1);
    let mut sum = 0;
    for end in &mut ends {
        sum += core::mem::replace(end, sum);
    }
    for key in &*keys {
        let to = &mut ends[cell(key)];
        room[*to as usize] = *key;
        *to += 1;
    }
    control.count(n);
    let (mut ends, mut start) = (ends.iter(), 0);
    let (mut rest, mut rest_of_room) = (keys, &mut *room);
    let mut tasks = parts(|| {
        let mut ends = ends.by_ref().map(|&end| end as usize);
        let end = ends.find(|&end| end - start >= n.div_ceil(TASKS) || end == n)?;
        let count = end - start;
        start = end;
        (count > 0).then(|| (cut(&mut rest_of_room, count), cut(&mut rest, count)))
    });
    control.each(&mut tasks, |(keys, room)| sort(keys, room))?;
    control.at(n, n)?;
    Ok(room)
}

/// Sorts keys by the digits in which they differ, the last first; `room` is as many.
fn sort(keys: &mut [Key], room: &mut [Key]) {
    if keys.len() <= FEW {
        for i in 1..keys.len() {
            let (mut at, key) = (i, keys[i]);
            while at > 0 && keys[at - 1] > key {
                keys[at] = keys[at - 1];
                at -= 1;
            }
            keys[at] = key;
        }
        return;
    }
    let differ = keys.iter().fold(0, |all, key| all | (key[0] ^ keys[0][0]));
    let (mut from, mut to) = (keys, room);
    let mut swapped = false;
    for shift in (0..3 * BITS).step_by(DIGIT as usize) {
        let digit = |key: u64| (key >> shift) as usize % (1 << DIGIT);
        if digit(differ) == 0 {
            continue;
        }
        let mut ends = [0u32; 1 << DIGIT];
        from.iter().for_each(|key| ends[digit(key[0])] += 1);
        let mut sum = 0;
        for end in &mut ends {
            sum += core::mem::replace(end, sum);
        }
        for key in &*from {
            let at = &mut ends[digit(key[0])];
            to[*at as usize] = *key;
            *at += 1;
        }
        (from, to) = (to, from);
        swapped = !swapped;
    }
    if swapped {
        to.copy_from_slice(from);
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::{vec, vec::Vec};

    /// Keys become ascending, wherever their digits differ, and none is lost.
    #[test]
    fn in_order() {
        for count in [1, 2, FEW, FEW + 1, 5000] {
            for mask in [u64::MAX >> 1, 0xf, 0xff << 40, 0] {
                let hash = |i: u64| (i + 1).wrapping_mul(0x9e37_79b9_7f4a_7c15) & mask;
                let mut keys: Vec<Key> = (0..count as u64).map(|i| [hash(i), i]).collect();
                let mut expected = keys.clone();
                expected.sort_unstable();
                sort(&mut keys, &mut vec![[0; 2]; count]);
                assert_eq!(keys, expected);
            }
        }
    }
}
