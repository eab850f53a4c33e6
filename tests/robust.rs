//! Any file at all ends in an answer or in a clear error: pages damaged at random, and those that once did harm.
//!
//! This is what the fuzzer in `fuzz/` does for hours, done for some seconds with nothing but the toolchain, and always with the
//! same pages. `CRADLE_FUZZ_ROUNDS=100000 CRADLE_FUZZ_SEED=7 cargo test --test all robust::` goes on for longer, with others.

mod checks;
mod harmful;
mod mutate;
mod panics;
mod seeds;

use std::time::{Duration, Instant};

use checks::Checked;
use mutate::{Chance, damaged};

/// A page that takes longer than this hangs; the slowest takes a hundredth of it, on a machine with nothing else to do.
const HANGS: Duration = Duration::from_secs(120);

fn setting(name: &str, usual: u64) -> u64 {
    let asked_for = std::env::var(name).ok();
    asked_for
        .and_then(|text| text.parse().ok())
        .unwrap_or(usual)
}

/// Damages pages of one kind, some times over, and looks at what becomes of each.
fn rounds(usual: u64, pages: &[(String, Vec<u8>)], check: impl Fn(&str, &[u8]) -> Checked) {
    let rounds = setting("CRADLE_FUZZ_ROUNDS", usual);
    let seed = setting("CRADLE_FUZZ_SEED", 0);
    for round in 0..rounds {
        let mut chance = Chance::new(seed.wrapping_mul(1 << 32).wrapping_add(round));
        let (name, page) = &pages[chance.below(pages.len())];
        let (_, other) = &pages[chance.below(pages.len())];
        let bytes = damaged(page, other, &mut chance);
        one(name, &bytes, &check);
    }
}

/// One input; what is amiss is told with the input itself.
fn one(name: &str, bytes: &[u8], check: impl Fn(&str, &[u8]) -> Checked) {
    let told = |what: &str| -> ! {
        let folder = concat!(env!("CARGO_TARGET_TMPDIR"), "/robust");
        let path = format!("{folder}/{}", name.replace('/', "-"));
        let kept = std::fs::create_dir_all(folder).and_then(|()| std::fs::write(&path, bytes));
        let kept = kept.map_or_else(|error| error.to_string(), |()| path);
        panic!(
            "{what}\nthe input, from {name}, is kept in {kept}:\n{}",
            String::from_utf8_lossy(bytes)
        )
    };
    let start = Instant::now();
    let checked = panics::caught(|| check(name, bytes));
    if let Err(what) = checked {
        told(&what);
    }
    if start.elapsed() > HANGS {
        told(&format!("took {:?}", start.elapsed()));
    }
}

fn is_read(name: &str, bytes: &[u8]) -> Checked {
    checks::file(name, bytes).map(drop)
}

fn is_audited(name: &str, bytes: &[u8]) -> Checked {
    match checks::file(name, bytes)? {
        Some(derivation) => checks::audit(&derivation),
        None => Ok(()),
    }
}

fn is_notation(_: &str, bytes: &[u8]) -> Checked {
    checks::notation(&String::from_utf8_lossy(bytes))
}

#[test]
fn damaged_markdown_is_read() {
    rounds(400, &seeds::pages("md"), is_read);
}

#[test]
fn damaged_latex_is_read() {
    rounds(400, &seeds::pages("tex"), is_read);
}

#[test]
fn damaged_notebooks_are_read() {
    rounds(400, &seeds::notebooks(), is_read);
}

#[test]
fn damaged_formulas_are_read() {
    rounds(2_000, &seeds::formulas(), is_notation);
}

#[test]
fn damaged_pages_are_audited_to_the_end() {
    let mut pages = seeds::pages("md");
    pages.extend(seeds::pages("tex"));
    rounds(40, &pages, is_audited);
}

#[test]
fn no_bytes_are_too_strange() {
    let mut chance = Chance::new(1);
    for name in ["a.md", "a.tex", "a.ipynb"] {
        for length in [0, 1, 2, 3, 100, 5_000] {
            let bytes: Vec<u8> = (0..length)
                .map(|_| u8::try_from(chance.below(256)).unwrap_or(0))
                .collect();
            one(name, &bytes, is_audited);
        }
    }
}

/// Each of these was once a panic, a hang or an exhausted stack.
#[test]
fn what_once_did_harm_is_audited() {
    let folder = concat!(env!("CARGO_MANIFEST_DIR"), "/tests/robust/inputs");
    let inputs = seeds::files(folder.as_ref());
    assert!(!inputs.is_empty());
    for (name, bytes) in inputs {
        one(&name, &bytes, is_audited);
    }
}

/// The same of what is too long to be kept; in parts, as each takes its time.
fn long_part(part: usize, parts: usize) {
    let made = harmful::made().into_iter();
    let own: Vec<_> = made.skip(part).step_by(parts).collect();
    assert!(!own.is_empty());
    for (name, bytes) in own {
        one(&name, &bytes, is_audited);
    }
}

#[test]
fn what_is_too_long_is_audited() {
    long_part(0, 3);
}

#[test]
fn what_is_too_long_is_audited_too() {
    long_part(1, 3);
}

#[test]
fn all_that_is_too_long_is_audited() {
    long_part(2, 3);
}
