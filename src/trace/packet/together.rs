//! Which rays of a stream go as packets.

use super::{ENOUGH, Packet, RAYS, Tables};
use crate::arena::View;
use crate::options::Structure;
use crate::simd::{Kernel, Lanes};
use crate::trace::query::{Last, Query};
use crate::trace::stream::Port;

/// Takes rays from `next` on as packets, as long as they are packets and that is worth it.
pub(in crate::trace) struct Together<'a, 'p, Q: Query> {
    pub view: &'a View<'a>,
    pub port: &'p mut dyn Port<Q::Out>,
    /// The next ray of the stream, and their number.
    pub next: usize,
    pub n: usize,
}

/// What became of it.
pub(in crate::trace) struct Progress {
    /// The first ray that is still to be answered.
    pub next: usize,
    /// Whether there was a packet that was worth it.
    pub worth: bool,
    /// Whether the last rays looked at were a packet at all.
    pub alike: bool,
}

impl<Q: Query, L: Lanes> Kernel<L> for Together<'_, '_, Q> {
    type Out = Progress;
    #[inline(always)]
    fn run(self, l: L) -> Progress {
        let Self { view, port, mut next, n } = self;
        let mut tables = Tables::NONE;
        let (mut worth, mut alike) = (false, true);
        while n - next >= RAYS {
            for (i, ray) in tables.rays.iter_mut().enumerate() {
                port.ray(next + i, ray);
            }
            let Some(mut packet) = Packet::<Q, L>::new(l, view, &mut tables) else {
                alike = false;
                break;
            };
            packet.run();
            if packet.lost {
                break;
            }
            let mut last = Last::NONE;
            for (i, (query, ray)) in packet.queries.iter().zip(&packet.tables.rays).enumerate() {
                port.put(next + i, query.found_next(&packet.sections, ray, &mut last));
            }
            next += RAYS;
            if packet.work > ENOUGH {
                break;
            }
            worth = true;
        }
        Progress { next, worth, alike }
    }
}

/// Whether a scene is one for packets: not a HUG, whose grids are in many voxels, nor one
/// with grids that are turned.
pub(in crate::trace) fn suits(view: &View) -> bool {
    let header = view.header();
    header.structure != Structure::Hug as u32 && header.frames.count == 0
}

#[cfg(test)]
mod tests {
    use super::{Progress, RAYS, Together, suits};
    use crate::options::{Options, Structure};
    use crate::ray::{Hit, Ray};
    use crate::simd::{Lanes, Portable};
    use crate::trace::query::Closest;
    use crate::trace::stream::Slices;
    use crate::{Geometry, Scene};
    use std::vec;
    use std::vec::Vec;

    /// Sixty-four rays from a camera `away` from a sheet of `n` by `n` squares, not quite
    /// flat: whether they were answered, and whether that was worth it.
    fn outcome(n: u32, away: f32, spread: f32) -> [bool; 2] {
        let place = |i: u32| i as f32 / n as f32;
        let corner = |i: u32| [place(i % (n + 1)), place(i / (n + 1)), (i % 7) as f32 * 1e-3];
        let vertices: Vec<[f32; 3]> = (0..(n + 1) * (n + 1)).map(corner).collect();
        let square = |i: u32| {
            let a = i / n * (n + 1) + i % n;
            [[a, a + 1, a + n + 2], [a, a + n + 2, a + n + 1]]
        };
        let indices: Vec<[u32; 3]> = (0..n * n).flat_map(square).collect();
        let options = Options { structure: Structure::Recursive, ..Options::default() };
        let geometry = Geometry::from_mesh(&vertices, &indices);
        let scene = Scene::build(&[geometry], &options).expect("the soup is valid");
        let view = scene.view();
        let step = |i: usize| (i as f32 - 3.5) * spread;
        let ray = |i: usize| Ray::new([0.51, 0.52, away], [step(i % 8), step(i / 8), -1.0]);
        let rays: Vec<Ray> = (0..RAYS).map(ray).collect();
        let mut answers = vec![Hit::miss(7.0); RAYS];
        let mut port = Slices { rays: &rays, answers: &mut answers };
        assert!(suits(&view));
        let together = Together::<Closest> { view: &view, port: &mut port, next: 0, n: RAYS };
        let Progress { next, worth, .. } = Portable.run(together);
        if next > 0 {
            for (ray, hit) in rays.iter().zip(&answers) {
                assert!(hit.is_hit());
                assert_eq!(*hit, view.intersect(ray));
            }
        }
        [next > 0, worth]
    }

    /// Rays that are alike do go together, and say so when it was not worth it.
    #[test]
    fn some_are_worth_it() {
        assert_eq!(outcome(40, 3.0, 1e-3), [true, true]);
        assert!(!outcome(400, 3.0, 2e-2)[1]);
        assert_eq!(outcome(40, 3.0, 1.0), [false, false]);
    }
}
