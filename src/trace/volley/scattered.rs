//! Which rays a volley is for.

use core::ops::Range;

use super::super::query::Query;
use super::super::stream::Port;
use crate::arena::View;
use crate::ray::Ray;

/// Pairs of rays that are looked at.
const PAIRS: usize = 8;

/// Which part of the scene's longest side is near.
const NEAR: f32 = 1.0 / 128.0;

/// Whether most of these rays begin far from the one before. Where they do not, as rays that go on from
/// neighbouring pixels, one finds in the caches what the other had there, and goes most of its
/// way as was foreseen: such rays are quicker one by one. A volley spares the others waiting.
#[inline(never)]
pub fn scattered<Q: Query>(
    view: &View<'_>,
    port: &mut dyn Port<Q::Out>,
    rays: &Range<usize>,
) -> bool {
    let (lower, upper) = view.bounds();
    let side = |k: usize| upper[k] - lower[k];
    let near = NEAR * side(0).max(side(1)).max(side(2));
    let mut pair = [Ray::new([0.0; 3], [0.0; 3]); 2];
    let mut far = 0;
    for i in 0..PAIRS {
        let at = rays.start + rays.len() / PAIRS * i;
        for (ray, at) in pair.iter_mut().zip(at..rays.end) {
            port.ray(at, ray);
        }
        let [a, b] = [pair[0].org, pair[1].org];
        far += usize::from((0..3).any(|k| (a[k] - b[k]).abs() > near));
    }
    2 * far >= PAIRS
}
