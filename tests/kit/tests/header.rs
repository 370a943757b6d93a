//! The header and the functions behind it name the same things and lay them out alike.

use hug_kit::rays::{FRAME, Hit, NONE, RANDOM_COUNT, Ray};
use hug_kit::{Bounds, View};
use std::collections::BTreeSet;

const HEADER: &str = include_str!("../include/hug_kit.h");
const SOURCES: [&str; 4] = [
    include_str!("../src/capi/mod.rs"),
    include_str!("../src/capi/scenes.rs"),
    include_str!("../src/capi/rays.rs"),
    include_str!("../src/capi/arbiter.rs"),
];

/// The identifiers `kit_...` that stand before an opening parenthesis, comments left out.
fn functions(text: &str, introduced_by: &str) -> BTreeSet<String> {
    let is_comment = |line: &&str| {
        let line = line.trim_start();
        line.starts_with("/*") || line.starts_with('*') || line.starts_with("//")
    };
    let code: Vec<&str> = text.lines().filter(|l| !is_comment(l)).collect();
    let code = code.join("\n");
    code.match_indices("kit_")
        .filter_map(|(start, _)| {
            let name: String = code[start..]
                .chars()
                .take_while(|c| c.is_ascii_alphanumeric() || *c == '_')
                .collect();
            let called = code[start + name.len()..].starts_with('(');
            (called && code[..start].ends_with(introduced_by)).then_some(name)
        })
        .collect()
}

#[test]
fn header_declares_what_is_exported() {
    let declared: BTreeSet<String> =
        [" ", "*"].iter().flat_map(|before| functions(HEADER, before)).collect();
    let exported: BTreeSet<String> =
        SOURCES.iter().flat_map(|source| functions(source, "extern \"C\" fn ")).collect();
    assert_eq!(declared, exported);
    assert!(!declared.is_empty());
}

#[test]
fn layouts_and_constants_are_those_of_the_header() {
    assert_eq!(size_of::<Ray>(), 48);
    assert_eq!(size_of::<Hit>(), 40);
    assert_eq!(size_of::<View>(), 40);
    assert_eq!(size_of::<Bounds>(), 24);
    assert!(HEADER.contains(&format!("KIT_NONE {NONE:#x}u")));
    assert!(HEADER.contains(&format!("KIT_FRAME {FRAME}u")));
    assert!(HEADER.contains(&format!("KIT_RANDOM_COUNT {RANDOM_COUNT}u")));
}
