//! The arbiter for C.

use super::{Error, input, inputs, output, status};
use crate::arbiter::{self, Claim, Triangle, Verdict};
use crate::rays::{Hit, NONE, Ray};

/// The layout of `kit_soup`: one geometry, id 0.
#[repr(C)]
pub struct KitSoup {
    vertices: *const f32,
    vertex_count: usize,
    indices: *const u32,
    triangle_count: usize,
}

const GEOM: u32 = 0;

/// A soup whose arrays have been looked at.
struct Soup<'a> {
    vertices: &'a [[f32; 3]],
    indices: Option<&'a [[u32; 3]]>,
    triangle_count: usize,
}

impl<'a> Soup<'a> {
    /// # Safety
    /// `soup` is NULL or valid for a read, and its arrays are NULL or as long as it says.
    unsafe fn new(soup: *const KitSoup) -> Result<Self, Error> {
        // SAFETY: all by the caller's promise.
        unsafe {
            let soup = input(soup)?;
            let vertices = inputs(soup.vertices.cast::<[f32; 3]>(), soup.vertex_count)?;
            let triangle_count = soup.triangle_count;
            if triangle_count >= NONE as usize {
                return Err(Error::Range);
            }
            let indices = match soup.indices.is_null() {
                true => None,
                false => Some(inputs(soup.indices.cast::<[u32; 3]>(), triangle_count)?),
            };
            Ok(Self { vertices, indices, triangle_count })
        }
    }

    fn corners(&self, prim: usize) -> Result<Triangle, Error> {
        let [a, b, c] = match self.indices {
            Some(indices) => indices[prim].map(|v| v as usize),
            None => [3 * prim, 3 * prim + 1, 3 * prim + 2],
        };
        let vertex = |v: usize| self.vertices.get(v).copied().ok_or(Error::Soup);
        Ok([vertex(a)?, vertex(b)?, vertex(c)?])
    }

    /// Every triangle, once it is certain that all their vertices exist.
    fn triangles(&self) -> Result<impl Iterator<Item = (u32, u32, Triangle)>, Error> {
        let prims = 0..self.triangle_count;
        prims.clone().try_for_each(|p| self.corners(p).map(drop))?;
        Ok(prims.map(|p| (GEOM, p as u32, self.corners(p).expect("looked at above"))))
    }

    fn claim(&self, prim: u32) -> Result<Option<Claim>, Error> {
        match prim {
            NONE => Ok(None),
            _ if prim as usize >= self.triangle_count => Err(Error::Range),
            _ => Ok(Some(Claim { geom: GEOM, prim, corners: self.corners(prim as usize)? })),
        }
    }
}

fn normal([v0, v1, v2]: &Triangle) -> [f32; 3] {
    let wide = |v: &[f32; 3]| glam::DVec3::from_array(v.map(f64::from));
    let (v0, v1, v2) = (wide(v0), wide(v1), wide(v2));
    (v1 - v0).cross(v2 - v0).to_array().map(|c| c as f32)
}

/// # Safety
/// `soup` is NULL or valid with its arrays NULL or as long as it says, `ray` is NULL or valid for
/// a read, `out` NULL or valid for a write.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn kit_exact_closest(
    soup: *const KitSoup,
    ray: *const Ray,
    out: *mut Hit,
) -> i32 {
    // SAFETY: all by the caller's promise.
    status(|| unsafe {
        let (soup, ray) = (Soup::new(soup)?, input(ray)?);
        let hit = match arbiter::closest(ray, soup.triangles()?) {
            Some(found) => Hit {
                t: found.hit.t,
                u: found.hit.u,
                v: found.hit.v,
                ng: normal(&soup.corners(found.prim as usize)?),
                geom: found.geom,
                prim: found.prim,
                inst: NONE,
                reserved: 0,
            },
            None => Hit {
                t: ray.tmax,
                u: 0.0,
                v: 0.0,
                ng: [0.0; 3],
                geom: NONE,
                prim: NONE,
                inst: NONE,
                reserved: 0,
            },
        };
        output(out, hit)
    })
}

/// # Safety
/// `soup` is NULL or valid with its arrays NULL or as long as it says, `ray` is NULL or valid for
/// a read, `out` NULL or valid for a write.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn kit_judge_closest(
    soup: *const KitSoup,
    ray: *const Ray,
    ours: u32,
    theirs: u32,
    out: *mut Verdict,
) -> i32 {
    // SAFETY: all by the caller's promise.
    status(|| unsafe {
        let (soup, ray) = (Soup::new(soup)?, input(ray)?);
        let (ours, theirs) = (soup.claim(ours)?, soup.claim(theirs)?);
        output(out, arbiter::judge(ray, ours.as_ref(), theirs.as_ref()))
    })
}

/// # Safety
/// `soup` is NULL or valid with its arrays NULL or as long as it says, `ray` is NULL or valid for
/// a read, `out` NULL or valid for a write.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn kit_judge_occluded(
    soup: *const KitSoup,
    ray: *const Ray,
    ours: i32,
    theirs: i32,
    out: *mut Verdict,
) -> i32 {
    // SAFETY: all by the caller's promise.
    status(|| unsafe {
        let (soup, ray) = (Soup::new(soup)?, input(ray)?);
        let (ours, theirs) = (ours != 0, theirs != 0);
        output(out, arbiter::judge_occluded(ray, ours, theirs, soup.triangles()?))
    })
}
