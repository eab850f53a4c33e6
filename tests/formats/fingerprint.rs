//! Fingerprints: a published hash of what a statement says, so that a baseline outlives this program.

use std::path::Path;

use cradle_verify::derivation::Derivation;
use serde_json::Value;

use crate::common;

/// FNV-1a with 64 bits, as it is published.
fn fnv(bytes: impl IntoIterator<Item = u8>) -> u64 {
    let start = 0xcbf2_9ce4_8422_2325_u64;
    let step = |hash: u64, byte: u8| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3);
    bytes.into_iter().fold(start, step)
}

/// What a baseline records of the statements of a page: what each says, and its fingerprint.
fn recorded(source: &str) -> Vec<[String; 2]> {
    let derivation = Derivation::from_markdown("page.md", source);
    let baseline = common::reported(&derivation, |report| {
        report.baseline(Path::new(".")).written()
    });
    let baseline: Value = serde_json::from_str(&baseline).unwrap();
    let lines = baseline["statements"].as_array().unwrap();
    let line = |line: &Value| {
        ["statement", "fingerprint"].map(|key| line[key].as_str().unwrap().to_owned())
    };
    lines.iter().map(line).collect()
}

#[test]
fn the_hash_is_the_published_one() {
    // Published test vectors.
    assert_eq!(fnv(*b""), 0xcbf2_9ce4_8422_2325);
    assert_eq!(fnv(*b"a"), 0xaf63_dc4c_8601_ec8c);
    assert_eq!(fnv(*b"foobar"), 0x8594_4171_f739_67e8);
    let lines = recorded("$$ a = b \\tag{1} $$\n\n$$ c = d $$\n");
    assert_eq!(lines.len(), 2);
    for [statement, fingerprint] in lines {
        // A byte that is in no text ends each part of what is hashed.
        let bytes = statement.bytes().chain([0xff]);
        assert_eq!(fingerprint, format!("{:016x}", fnv(bytes)));
    }
}

#[test]
fn what_says_the_same_is_known_by_the_same() {
    let lines = recorded("$$ a = b \\tag{1} $$\n\n$$ a = b \\tag{2} $$\n\n$$ a = c $$\n");
    let lines: Vec<_> = lines
        .iter()
        .map(|[says, known]| (&says[..], known))
        .collect();
    let [(other, c), (first, b), (second, again)] = lines[..] else {
        panic!("{lines:?}");
    };
    assert_eq!([other, first, second], ["a = c", "a = b", "a = b"]);
    assert!(b == again && b != c);
}
