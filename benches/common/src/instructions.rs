//! The instruction sets that this processor can run queries on.

use hug::Isa;

/// Those with a name of their own here, and whatever the library chooses by itself.
pub fn available() -> Vec<Isa> {
    let chosen = hug::isa();
    let mut all: Vec<Isa> =
        [Isa::Portable, Isa::Avx2].into_iter().filter(|&isa| hug::force_isa(isa)).collect();
    hug::force_isa(chosen);
    if !all.contains(&chosen) {
        all.push(chosen);
    }
    all
}

/// Makes queries use `isa`, one of [`available`].
pub fn force(isa: Isa) {
    assert!(hug::force_isa(isa), "{} is not on this processor", name(isa));
}

/// Lower-case name.
pub fn name(isa: Isa) -> String {
    isa.name().to_string_lossy().into_owned()
}
