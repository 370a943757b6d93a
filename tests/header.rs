//! include/hug.h is what cbindgen makes of src/capi.
#![allow(missing_docs)]

use std::fs;
use std::path::Path;

#[test]
fn header_is_generated() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let config = cbindgen::Config::from_file(root.join("cbindgen.toml")).expect("cbindgen.toml");
    let mut made = Vec::new();
    let mut builder = cbindgen::Builder::new().with_config(config);
    // These files alone: constants of other modules are no part of the interface.
    let files = [
        "types.rs",
        "soa_types.rs",
        "stat_types.rs",
        "build.rs",
        "rebuild.rs",
        "fault.rs",
        "query.rs",
        "budget.rs",
        "stream.rs",
        "stream_soa.rs",
        "stats.rs",
        "distribution.rs",
        "profile.rs",
        "all.rs",
        "filter.rs",
        "nearest.rs",
        "advise.rs",
    ];
    for file in files {
        builder = builder.with_src(root.join("src/capi").join(file));
    }
    builder.generate().expect("the interface is valid").write(&mut made);
    let text = String::from_utf8_lossy(&made);
    for line in text.lines().filter(|line| line.starts_with("#define")) {
        assert!(line.starts_with("#define HUG_"), "a name without prefix: {line}");
    }
    let path = root.join("include/hug.h");
    if std::env::var_os("HUG_BLESS").is_some() {
        fs::write(&path, &made).expect("include/ is writable");
    }
    let kept = fs::read(&path).expect("include/hug.h");
    assert!(
        kept == made,
        "include/hug.h is out of date: HUG_BLESS=1 cargo test --features capi --test header"
    );
}
