//! Any text as the inside of a display: refused at a place, or read and printed so that it reads the same again.
#![no_main]

#[path = "../../tests/robust/checks.rs"]
#[allow(dead_code)]
mod checks;

libfuzzer_sys::fuzz_target!(|source: &str| {
    if let Err(what) = checks::notation(source) {
        panic!("{what}");
    }
});
