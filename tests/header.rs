//! include/hug.h is what cbindgen makes of src/capi.
#![allow(missing_docs)]

use std::fs;
use std::path::Path;

#[test]
fn header_is_generated() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let config = cbindgen::Config::from_file(root.join("cbindgen.toml")).expect("cbindgen.toml");
    let mut made = Vec::new();
    cbindgen::Builder::new()
        .with_crate(root)
        .with_config(config)
        .generate()
        .expect("the interface is valid")
        .write(&mut made);
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
