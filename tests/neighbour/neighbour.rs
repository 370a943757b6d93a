//! Another static library in Rust, with a runtime of its own: it allocates, formats,
//! starts a thread and catches a panic.

/// 42, the long way round.
#[unsafe(no_mangle)]
pub extern "C" fn neighbour_answer() -> i32 {
    let text = std::thread::spawn(|| format!("{}", 6 * 7)).join().unwrap_or_default();
    let caught = std::panic::catch_unwind(|| std::panic::resume_unwind(Box::new(0u8)));
    if caught.is_err() { text.parse().unwrap_or(-1) } else { -2 }
}
