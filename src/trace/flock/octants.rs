//! Rays of a stream by the axes along which they descend.

use core::ops::Range;

use super::super::stream::Port;
use super::BLOCK;
use crate::ray::Ray;
use crate::simd::Lanes;

/// Places of rays, one set of axes after the other.
pub struct Octants {
    places: [u16; BLOCK],
    ends: [usize; 8],
}

impl Octants {
    /// Of these rays, [`BLOCK`] of them at most.
    #[inline(always)]
    pub fn new<L: Lanes, Out>(l: L, port: &mut dyn Port<Out>, rays: &Range<usize>) -> Self {
        let mut octants = [0u8; BLOCK];
        let mut ends = [0; 8];
        let mut ray = Ray::new([0.0; 3], [0.0; 3]);
        for (octant, index) in octants.iter_mut().zip(rays.clone()) {
            port.ray(index, &mut ray);
            let [_, dir, _] = ray.rows();
            *octant = l.signs(l.load_f32(dir)) as u8 % 8;
            ends[usize::from(*octant)] += 1;
        }
        let mut sum = 0;
        for end in &mut ends {
            (*end, sum) = (sum, sum + *end);
        }
        let mut places = [0; BLOCK];
        for (place, octant) in octants.iter().enumerate().take(rays.len()) {
            let end = &mut ends[usize::from(*octant) % 8];
            places[*end % BLOCK] = place as u16;
            *end += 1;
        }
        Self { places, ends }
    }

    /// Places of those that descend along the axes that `octant`, below 8, has a bit for, in their
    /// order.
    #[inline(always)]
    pub fn of(&self, octant: usize) -> &[u16] {
        let start = if octant == 0 { 0 } else { self.ends[octant - 1] };
        &self.places[start..self.ends[octant]]
    }
}
