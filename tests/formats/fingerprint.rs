//! Fingerprints: a published hash of what a statement is called and says, so that a baseline outlives this program.

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

/// What a baseline records of the statements of a page.
fn recorded(source: &str) -> Vec<[String; 3]> {
    let derivation = Derivation::from_markdown("page.md", source);
    let baseline = common::reported(&derivation, |report| {
        report.baseline(Path::new(".")).written()
    });
    let baseline: Value = serde_json::from_str(&baseline).unwrap();
    let lines = baseline["statements"].as_array().unwrap();
    let line = |line: &Value| {
        ["equation", "statement", "fingerprint"].map(|key| line[key].as_str().unwrap().to_owned())
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
    for [equation, statement, fingerprint] in lines {
        // A byte that is in no text ends each part: what moves from one to the other is something else.
        let parts = [equation, statement].map(|part| [part.as_bytes(), &[0xff]].concat());
        assert_eq!(fingerprint, format!("{:016x}", fnv(parts.concat())));
    }
}

#[test]
fn what_is_the_same_is_numbered() {
    let lines = recorded("$$ a = b $$\n\n$$ a = b $$\n\n$$ a = c $$\n");
    let [first, second, other] = &lines[..] else {
        panic!("{lines:?}");
    };
    assert_eq!(second[2], format!("{}:2", first[2]));
    assert_ne!(other[2], first[2]);
}
