//! One soup in every structure, and all ways to ask about it.

use super::{assert_same, configurations};
use hug::{Counters, Geometry, Hit, Ray, Scene};

/// The same triangles, built with every configuration.
pub struct Everywhere(pub Vec<(&'static str, Scene)>);

impl Everywhere {
    pub fn build(soup: &[Geometry<'_>]) -> Self {
        let build = |options| Scene::build(soup, &options).expect("the soup is valid");
        Self(configurations().into_iter().map(|(name, options)| (name, build(options))).collect())
    }

    /// The hit, after making sure that every structure and every kind of query
    /// says the same.
    #[track_caller]
    pub fn shoot(&self, ray: &Ray) -> Hit {
        let expected = self.0[0].1.view().intersect_brute(ray);
        for (name, scene) in &self.0 {
            let (view, mut counters) = (scene.view(), Counters::default());
            assert_same(&view.intersect(ray), &expected, ray, name);
            let counted = view.intersect_counted(ray, &mut counters);
            assert_same(&counted, &expected, ray, &format!("{name}, counted"));
            let any = view.occluded_counted(ray, &mut counters);
            assert_eq!(any, expected.is_hit(), "{name}, counted: {ray:?}");
            assert_eq!(view.occluded(ray), expected.is_hit(), "{name}: {ray:?}");
            // Scenes of a few triangles are walked by streams and counted queries alone.
            let mut many = [Hit::miss(0.0); 13];
            view.intersect_n(&[*ray; 13], &mut many);
            assert_same(&many[12], &expected, ray, &format!("{name}, in a stream"));
            let accepted = view.intersect_filtered(ray, |_| true);
            assert_same(&accepted, &expected, ray, &format!("{name}, filtered"));
            let first = view.hits(ray).next().unwrap_or(Hit::miss(ray.tmax));
            assert_same(&first, &expected, ray, &format!("{name}, the first of all"));
            let neither = ray.with_flags(Ray::CULL_BACK | Ray::CULL_FRONT);
            assert!(!view.intersect(&neither).is_hit(), "{name}: {neither:?}");
        }
        expected
    }

    /// Asserts a miss, and that its record is the one documented.
    #[track_caller]
    pub fn miss(&self, ray: &Ray) {
        let hit = self.shoot(ray);
        assert!(!hit.is_hit(), "{ray:?} hit {hit:?}");
        assert_same(&hit, &Hit::miss(ray.tmax), ray, &"the record of a miss");
    }

    /// Asserts a hit on a triangle at a parameter.
    #[track_caller]
    pub fn hit(&self, ray: &Ray, t: f32, geom: u32, prim: u32) {
        let hit = self.shoot(ray);
        let found = (hit.t.to_bits(), hit.geom, hit.prim);
        assert_eq!(found, (t.to_bits(), geom, prim), "{ray:?} found {hit:?}");
    }

    /// Asserts a hit at a parameter, on whatever triangle.
    #[track_caller]
    pub fn hit_at(&self, ray: &Ray, t: f32) {
        let hit = self.shoot(ray);
        assert!(
            hit.is_hit() && hit.t.to_bits() == t.to_bits(),
            "{ray:?} found {hit:?}, not t = {t}"
        );
    }
}
