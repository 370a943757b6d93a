//! The kit's ray sets for one scene and view. Sets that start on surfaces start where hug finds
//! the hits, which are exact: the rays are the same whatever structure finds them.

use bytemuck::cast;
use clap::ValueEnum;
use hug::{Hit, Ray, View};
use hug_kit::{Bounds, rays};

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub enum Set {
    Primary,
    Shadow,
    Bounce1,
    Bounce2,
    Random,
}

impl Set {
    pub const ALL: [Self; 5] =
        [Self::Primary, Self::Shadow, Self::Bounce1, Self::Bounce2, Self::Random];

    pub fn name(self) -> &'static str {
        match self {
            Self::Primary => "primary",
            Self::Shadow => "shadow",
            Self::Bounce1 => "bounce1",
            Self::Bounce2 => "bounce2",
            Self::Random => "random",
        }
    }
}

/// Every set, of a frame of `size` x `size` pixels.
pub struct RaySets([Vec<Ray>; 5]);

impl RaySets {
    pub fn new(scene: &View<'_>, bounds: &Bounds, camera: &hug_kit::View, size: u32) -> Self {
        let primary: Vec<rays::Ray> = rays::primary(camera, size).collect();
        let hits = trace(scene, &primary);
        let shadow = rays::shadow(bounds, size, &primary, &hits).collect();
        let first: Vec<rays::Ray> = rays::bounce(1, bounds, &primary, &hits).collect();
        let second = rays::bounce(2, bounds, &first, &trace(scene, &first)).collect();
        let random = random(bounds, size as usize * size as usize);
        Self([primary, shadow, first, second, random].map(own))
    }

    pub fn get(&self, set: Set) -> &[Ray] {
        &self.0[set as usize]
    }
}

fn random(bounds: &Bounds, count: usize) -> Vec<rays::Ray> {
    rays::random(bounds).take(count.min(rays::RANDOM_COUNT)).collect()
}

fn trace(scene: &View<'_>, set: &[rays::Ray]) -> Vec<rays::Hit> {
    set.iter().map(|&ray| cast::<Hit, rays::Hit>(scene.intersect(&cast(ray)))).collect()
}

/// The library's records, which have the kit's layout.
fn own(set: Vec<rays::Ray>) -> Vec<Ray> {
    set.into_iter().map(cast).collect()
}
