//! Queries with a budget of steps, and how many steps suffice.

use super::build::hug_scene;
use super::guard::guard;
use super::query::{hug_intersect, read, view};
use super::types::{hug_hit, hug_ray, hug_status};
use crate::{Error, Hit};

/// hug_intersect_within and hug_occluded_within: the steps did not suffice.
pub const HUG_TRUNCATED: i32 = -1;

/// hug_intersect in at most so many steps: boxes of grids, voxels traversed and
/// triangles tested, as hug_counters counts them (grids + voxels + tests). Returns
/// HUG_TRUNCATED, and writes the record of a miss, if they do not suffice; else
/// what hug_intersect does. The same ray needs the same number of steps on every
/// machine; hug_most_steps suffice for any.
///
/// It takes longer than hug_intersect, as it counts; hug_intersect itself knows
/// nothing of budgets.
///
/// # Safety
/// Each pointer is valid or NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hug_intersect_within(
    scene: *const hug_scene,
    ray: *const hug_ray,
    hit: *mut hug_hit,
    steps: u64,
) -> i32 {
    if scene.is_null() || ray.is_null() || hit.is_null() {
        // SAFETY: the same contract.
        return unsafe { hug_intersect(scene, ray, hit) };
    }
    // SAFETY: not NULL, valid by contract.
    unsafe {
        let ray = read(ray);
        let found = view(scene).intersect_within(&ray, steps);
        hit.cast::<Hit>().write_unaligned(found.unwrap_or(Hit::miss(ray.tmax)));
        found.map_or(HUG_TRUNCATED, |hit| i32::from(hit.is_hit()))
    }
}

/// hug_occluded in at most so many steps, as hug_intersect_within: 1, 0 or
/// HUG_TRUNCATED. With scene or ray NULL: 0.
///
/// # Safety
/// Each pointer is valid or NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hug_occluded_within(
    scene: *const hug_scene,
    ray: *const hug_ray,
    steps: u64,
) -> i32 {
    if scene.is_null() || ray.is_null() {
        return 0;
    }
    // SAFETY: not NULL, valid by contract.
    let found = unsafe { view(scene).occluded_within(&read(ray), steps) };
    found.map_or(HUG_TRUNCATED, i32::from)
}

/// How many steps suffice for any ray in the scene: an upper bound on the sum of
/// grids, voxels and tests of hug_counters for one ray, 0 for an empty scene. It
/// holds for every scene that hug_open accepts, whoever made it. Of a structure with
/// many levels it is far above what rays take. A ray that takes the tree of boxes, as
/// those that are counted do not, looks at each of its nodes and triangles once at most. Cost: linear in the arena, with no
/// allocation.
///
/// # Safety
/// scene must be valid or NULL, steps writable or NULL.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn hug_most_steps(scene: *const hug_scene, steps: *mut u64) -> hug_status {
    guard(|| {
        if scene.is_null() || steps.is_null() {
            return Err(Error::Null);
        }
        // SAFETY: not NULL, valid by contract.
        unsafe { steps.write_unaligned(view(scene).most_steps()) };
        Ok(())
    })
}
