//! Any bytes as a document, audited to the end and shown in every format. The first byte says what it is written in.
//!
//! Run it with `-timeout=60`: what takes longer hangs.
#![no_main]

#[path = "../../tests/robust/checks.rs"]
mod checks;

libfuzzer_sys::fuzz_target!(|bytes: &[u8]| {
    let name = match bytes.first() {
        Some(b'\\' | b'%') => "page.tex",
        Some(b'{') => "page.ipynb",
        _ => "page.md",
    };
    let checked = match checks::file(name, bytes) {
        Ok(Some(derivation)) => checks::audit(&derivation),
        Ok(None) => Ok(()),
        Err(what) => Err(what),
    };
    if let Err(what) = checked {
        panic!("{what}");
    }
});
