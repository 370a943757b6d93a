//! Where an arena with nodes ends: no earlier than seven triangles behind the last, as leaves are read
//! eight at a time.

use crate::common::aligned::Aligned;
use crate::common::layout::*;
use crate::common::{adversarial_rays, assert_same, build, ray};
use crate::{compact, options};
use hug::{Error, View};
use hug_kit::soups;

#[test]
fn there_is_room_for_eight_triangles() {
    let mesh = soups::clustered(8);
    for options in [options(), compact()] {
        let bytes = Aligned::copy(build(&mesh, &options).view().bytes());
        assert_eq!((count(&bytes, NODES), count(&bytes, TRIANGLES)), (1, 8));
        let end_of_nodes = record(&bytes, NODES, 1).next_multiple_of(64);
        let end = record(&bytes, TRIANGLES, 15).next_multiple_of(64);
        assert_eq!(bytes.len(), end);
        assert!(end > end_of_nodes);
        assert!(bytes[record(&bytes, NODES, 1)..].iter().all(|&byte| byte == 0));
        let view = View::open(&bytes).expect("an arena");
        for (_, one) in adversarial_rays(&mesh, 9, 40) {
            let one = ray(&one);
            assert_same(&view.intersect(&one), &view.intersect_brute(&one), &one, &"at the end");
        }
        let mut short = bytes.clone();
        put64(&mut short, BYTES, end as u64 - 64);
        assert_eq!(View::open(&short[..end - 64]).err(), Some(Error::Sections));
    }
}

/// Counts whose sections end next to the last address there is.
#[test]
fn too_many_triangles_for_an_address() {
    for options in [options(), compact()] {
        let mut forged = Aligned::copy(build(&soups::clustered(8), &options).view().bytes());
        for section in [GRIDS, VOXELS, REFS] {
            put64(&mut forged, section + 8, 0);
        }
        let least = (u64::MAX - 4096) / 48;
        for triangles in (least..=u64::MAX / 48).chain([u64::MAX]) {
            put64(&mut forged, TRIANGLES + 8, triangles);
            assert_eq!(View::open(&forged).err(), Some(Error::Sections), "{triangles}");
        }
    }
}
