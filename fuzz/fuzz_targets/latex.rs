//! Any bytes as a LaTeX document: read, with every display accounted for and every place within the file.
#![no_main]

#[path = "../../tests/robust/checks.rs"]
#[allow(dead_code)]
mod checks;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    if let Err(what) = checks::file("page.tex", bytes) {
        panic!("{what}");
    }
});
