//! The C entry points with any descriptor that keeps to the one rule that cannot be
//! checked: memory is as long as the counts say, unless they are refused unread.

use super::block::Block;
use super::calls::{pointer, query};
use super::input::Input;
use hug::capi::types::*;
use hug::capi::*;
use std::ffi::c_void;
use std::ptr::{null, null_mut};

/// Every block comes back, and the call of number `refuse` gets none.
#[derive(Default)]
struct Ledger {
    live: Vec<(usize, Block)>,
    calls: usize,
    refuse: usize,
}

unsafe extern "C" fn take(size: usize, _: usize, user: *mut c_void) -> *mut c_void {
    // SAFETY: `user` is a ledger, used by one thread.
    let ledger = unsafe { &mut *user.cast::<Ledger>() };
    ledger.calls += 1;
    if ledger.calls == ledger.refuse || size > 1 << 26 {
        return null_mut();
    }
    let mut block = Block::zeroed(size);
    // Nothing may count on zeros.
    block.bytes_mut().fill(0xa5);
    let start = block.bytes_mut().as_mut_ptr();
    ledger.live.push((start as usize, block));
    start.cast()
}

unsafe extern "C" fn give(memory: *mut c_void, size: usize, user: *mut c_void) {
    // SAFETY: as above.
    let ledger = unsafe { &mut *user.cast::<Ledger>() };
    let found = ledger.live.iter().position(|(start, _)| *start == memory as usize);
    let (_, block) = ledger.live.remove(found.expect("a block of this ledger"));
    assert_eq!(block.bytes().len(), size);
}

unsafe extern "C" fn watch(user: *mut c_void, fraction: f64) -> i32 {
    assert!((0.0..=1.0).contains(&fraction));
    // SAFETY: `user` is a counter, used by one thread.
    let left = unsafe { &mut *user.cast::<u32>() };
    *left = left.wrapping_sub(1);
    i32::from(*left == 0)
}

unsafe extern "C" fn backwards(_: *mut c_void, tasks: usize, task: hug_task_fn, on: *mut c_void) {
    for i in (0..tasks).rev() {
        // SAFETY: called as documented.
        unsafe { task.expect("a task")(on, i) };
    }
}

/// Indices mostly in range.
fn indices(input: &mut Input<'_>, vertices: usize) -> Vec<u32> {
    let n = 3 * input.below(33);
    let index = |input: &mut Input<'_>| {
        if input.rarely(64) { input.bits() } else { input.below(vertices.max(1)) as u32 }
    };
    (0..n).map(|_| index(input)).collect()
}

fn geometry(input: &mut Input<'_>, floats: &[f32], indices: &[u32]) -> hug_geometry {
    let stride = input.one_of(&[0, 0, 0, 12, 16, 20, 13, 8, 4096]);
    let step = if stride == 0 { 12 } else { stride };
    let bytes = size_of_val(floats);
    let most = if bytes < 12 { 0 } else { (bytes - 12) / step + 1 };
    let refused = usize::MAX - input.below(8);
    let index_type = input.below(4) as u32;
    // A 16-bit list has room for twice as many.
    let triangles = match index_type {
        HUG_INDEX_NONE => input.below(most / 3 + 2),
        HUG_INDEX_U16 => 2 * indices.len() / 3,
        _ => indices.len() / 3,
    };
    hug_geometry {
        vertices: pointer(input, floats.as_ptr()),
        vertex_count: if input.rarely(32) { refused } else { most - input.below(2).min(most) },
        vertex_stride: stride,
        indices: pointer(input, indices.as_ptr()).cast(),
        triangle_count: if input.rarely(32) { refused } else { triangles },
        index_type,
        mask: if input.rarely(8) { input.bits() } else { 0 },
    }
}

/// The options: mostly zeros, that is the defaults; explicit counts stay small.
fn fill(desc: &mut hug_build_desc, input: &mut Input<'_>, thresholds: &[f32; 15]) {
    desc.structure = input.below(5) as u32;
    let chosen = input.bits();
    let wants = |bit: u32| chosen >> bit & 3 == 3;
    if wants(0) {
        desc.gridding = input.below(3) as u32;
    }
    if wants(2) {
        desc.counts = [(); 3].map(|()| input.below(34) as u32);
    }
    if wants(4) {
        (desc.alpha, desc.world_alpha) = (input.float(), input.float());
    }
    if wants(6) {
        (desc.maxp, desc.max_depth) = (input.bits() >> input.below(32), input.below(18) as u32);
    }
    if wants(8) {
        (desc.filter_levels, desc.filter_share) = (input.below(18) as u32, input.float());
    }
    if wants(10) {
        desc.filter_levels = input.below(17) as u32;
        desc.filter_thresholds = pointer(input, thresholds.as_ptr());
    }
    if wants(12) {
        (desc.connectivity, desc.min_cluster) = (input.float(), input.below(32) as u32);
    }
    if wants(14) {
        (desc.delta, desc.hierarchy) = (input.below(3) as u32, input.below(3) as u32);
    }
    if wants(16) {
        desc.max_refs = input.below(64) as u32;
    }
    if wants(18) {
        desc.flags = input.below(32) as u32;
    }
    if wants(20) {
        (desc.quality, desc.reserved) = (input.below(4) as u32, u32::from(input.rarely(8)));
    }
    // What came later is chosen by bits that were not looked at before.
    if wants(22) {
        (desc.clustering, desc.overlap_power) = (input.below(3) as u32, input.float());
    }
    if wants(24) {
        desc.gridding = input.below(5) as u32;
    }
    if wants(26) {
        (desc.orientation, desc.turn_below) = (input.below(5) as u32, input.float());
    }
}

/// What is told before a build, with as much memory as this one has.
///
/// # Safety
/// The descriptor keeps to the rule.
unsafe fn survey(desc: *const hug_build_desc, scratch_bytes: usize) {
    let mut scratch = Block::zeroed(scratch_bytes);
    let s = scratch.bytes_mut();
    // SAFETY: zeros are a value of every field; the rest by the caller.
    unsafe {
        let mut advice: hug_advice = std::mem::zeroed();
        advice.struct_size = size_of_val(&advice);
        assert_ne!(hug_advise(desc, &mut advice), HUG_ERROR_INTERNAL);
        assert!(advice.reason <= HUG_REASON_CLUSTERED);
        let mut found: hug_clusterings = std::mem::zeroed();
        found.struct_size = size_of_val(&found);
        let start = s.as_mut_ptr().cast();
        assert_ne!(hug_survey(desc, start, s.len(), &mut found), HUG_ERROR_INTERNAL);
        assert!(found.pairs <= found.plane_pairs);
    }
}

/// hug_measure and hug_build_into, with as much memory as it says or a little less.
fn build_into(desc: *const hug_build_desc, input: &mut Input<'_>) {
    let (mut arena_bytes, mut scratch_bytes) = (0, 0);
    // SAFETY: the descriptor keeps to the rule; the memory is there.
    unsafe {
        let status = hug_measure(desc, &mut arena_bytes, &mut scratch_bytes);
        assert_ne!(status, HUG_ERROR_INTERNAL);
        if status != HUG_OK || arena_bytes.max(scratch_bytes) > 1 << 26 {
            return;
        }
        survey(desc, scratch_bytes);
        let less = |input: &mut Input<'_>| if input.rarely(8) { 64 * input.below(64) } else { 0 };
        let mut arena = Block::zeroed(arena_bytes.saturating_sub(less(input)));
        let mut scratch = Block::zeroed(scratch_bytes.saturating_sub(less(input)));
        let (a, s) = (arena.bytes_mut(), scratch.bytes_mut());
        let mut scene = null();
        let (a_start, s_start) = (a.as_mut_ptr().cast(), s.as_mut_ptr().cast());
        let status = hug_build_into(desc, s_start, s.len(), a_start, a.len(), &mut scene);
        assert_ne!(status, HUG_ERROR_INTERNAL);
        assert_eq!(status == HUG_OK, !scene.is_null());
        if status == HUG_OK {
            query(scene, input);
        }
    }
}

/// The target.
pub fn descriptors(data: &[u8]) {
    let mut input = Input::new(data);
    let floats: Vec<f32> = (0..input.below(97)).map(|_| input.float()).collect();
    let list = indices(&mut input, floats.len() / 3);
    let geometries: Vec<hug_geometry> =
        (0..input.below(4)).map(|_| geometry(&mut input, &floats, &list)).collect();
    let thresholds = [(); 15].map(|()| input.float());
    let mut ledger = Ledger { refuse: input.below(8), ..Ledger::default() };
    let mut left = u32::from(input.byte()).wrapping_sub(1);
    // SAFETY: zeros are a value of every field.
    let mut desc: hug_build_desc = unsafe { std::mem::zeroed() };
    desc.struct_size =
        if input.rarely(16) { input.below(600) } else { size_of::<hug_build_desc>() };
    desc.geometries = pointer(&mut input, geometries.as_ptr());
    desc.geometry_count = if input.rarely(32) { usize::MAX } else { geometries.len() };
    fill(&mut desc, &mut input, &thresholds);
    let callbacks = input.byte();
    if callbacks & 1 == 0 {
        desc.alloc = Some(take);
        desc.free = Some(give);
    }
    if callbacks & 6 == 6 {
        desc.progress = Some(watch);
    }
    if callbacks & 24 == 24 {
        desc.parallel_for = Some(backwards);
    }
    desc.user = (&raw mut ledger).cast();
    desc.progress_user = (&raw mut left).cast();
    // Of a later version: fields behind the known ones.
    let mut long = [0usize; 80];
    if input.rarely(16) {
        long[60 + input.below(20)] = 1;
    }
    let place: *mut hug_build_desc = long.as_mut_ptr().cast();
    // SAFETY: large enough, and aligned.
    unsafe { place.write(desc) };
    // SAFETY: the descriptor keeps to the rule.
    unsafe {
        let (mut geom, mut prim) = (0, 0);
        let status = hug_find_fault(place, &mut geom, &mut prim);
        assert_ne!(status, HUG_ERROR_INTERNAL);
    }
    build_into(place, &mut input);
    let at = if input.rarely(32) { place.wrapping_byte_add(1) } else { place };
    let mut scene = null_mut();
    // SAFETY: the descriptor keeps to the rule.
    unsafe {
        let status = hug_build(at, &mut scene);
        assert_ne!(status, HUG_ERROR_INTERNAL);
        assert_eq!(status == HUG_OK, !scene.is_null());
        if status == HUG_OK {
            query(scene, &mut input);
            assert_ne!(hug_rebuild(scene, place), HUG_ERROR_INTERNAL);
            query(scene, &mut input);
        }
        hug_free(scene);
    }
    assert!(ledger.live.is_empty(), "{} blocks were not freed", ledger.live.len());
}
