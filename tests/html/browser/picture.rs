//! The picture of the page in the documentation: it says of what it was taken, and that must still be so.
//!
//! What a browser paints depends on its version and on the fonts of the system, so the picture is not compared dot by
//! dot. It carries the hash of what is to be seen on it, the top of the page with its style, and this is computed anew.
//! `docs/figures/redraw` takes it again.

use std::path::{Path, PathBuf};

use serde_json::json;

use super::Stage;
use crate::html::built_in;
use crate::html::hash::{base64, sha256};

/// What the chunk of text in the picture is called.
const KEYWORD: &[u8] = b"Source\0";

fn file() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/figures/report.png")
}

/// What is on the picture, as text: the style, and the page down to its first finding, whatever the version is called.
fn seen(page: &str) -> &str {
    let start = page.find("<style>").unwrap();
    let end = page.find("class=\"finding ").unwrap();
    let rest = &page[end..];
    &page[start..end + rest.find("</li>").unwrap()]
}

fn stamp(page: &str) -> String {
    format!("sha256-{}", base64(&sha256(seen(page).as_bytes())))
}

/// The chunks of a picture, each with its place.
fn chunks(png: &[u8]) -> Vec<(usize, &[u8], &[u8])> {
    let mut found = Vec::new();
    let mut at = 8;
    while let Some(length) = png.get(at..at + 4) {
        let length = u32::from_be_bytes(length.try_into().unwrap()) as usize;
        found.push((at, &png[at + 4..at + 8], &png[at + 8..at + 8 + length]));
        at += length + 12;
    }
    found
}

/// The check sum of PNG, bit by bit.
fn check_sum(bytes: &[u8]) -> u32 {
    let step = |sum: u32, byte: &u8| {
        (0..8).fold(sum ^ u32::from(*byte), |sum, _| {
            sum >> 1 ^ (0xedb8_8320 & (sum & 1).wrapping_neg())
        })
    };
    !bytes.iter().fold(u32::MAX, step)
}

fn stamped(png: &[u8], stamp: &str) -> Vec<u8> {
    let end = chunks(png)
        .into_iter()
        .find(|(_, kind, _)| *kind == b"IEND")
        .unwrap()
        .0;
    let chunk = [b"tEXt", KEYWORD, stamp.as_bytes()].concat();
    let length = u32::try_from(chunk.len() - 4).unwrap().to_be_bytes();
    [
        &png[..end],
        &length,
        &chunk,
        &check_sum(&chunk).to_be_bytes(),
        &png[end..],
    ]
    .concat()
}

/// Takes it, where a browser is asked for it.
fn take(page: &str) {
    let stage = Stage::new("picture").expect("a browser to take the picture with");
    std::fs::write(stage.folder.join("page.html"), page).unwrap();
    stage.looks("screen", "light").unwrap();
    let hidden = json!({"hidden": true});
    stage
        .session
        .tell("Emulation.setScrollbarsHidden", &hidden)
        .unwrap();
    stage.shows("page.html", 1100).unwrap();
    let taken = stage
        .session
        .tell("Page.captureScreenshot", &json!({"format": "png"}))
        .unwrap();
    let png = decoded(taken["data"].as_str().unwrap());
    std::fs::write(file(), stamped(&png, &stamp(page))).unwrap();
}

fn decoded(text: &str) -> Vec<u8> {
    let letters = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let value = |letter: &u8| letters.iter().position(|own| own == letter);
    let values: Vec<usize> = text.as_bytes().iter().filter_map(value).collect();
    let bytes = |four: &[usize]| {
        let all = (0..4).fold(0, |all, at| all << 6 | four.get(at).copied().unwrap_or(0));
        let three = [(all >> 16) as u8, (all >> 8) as u8, all as u8];
        three.into_iter().take(four.len() - 1)
    };
    values.chunks(4).flat_map(bytes).collect()
}

#[test]
fn the_picture_in_the_documentation_is_of_this_page() {
    let page = built_in();
    if std::env::var_os("REDRAW").is_some() {
        take(page);
    }
    let png = std::fs::read(file()).unwrap();
    let chunks = chunks(&png);
    let text = chunks.iter().find(|(_, kind, _)| *kind == b"tEXt");
    let (_, kind, text) = text.expect("the picture does not say what it was taken of");
    let sum = &png[text.as_ptr() as usize - png.as_ptr() as usize + text.len()..][..4];
    assert_eq!(sum, check_sum(&[*kind, text].concat()).to_be_bytes());
    let said = text
        .strip_prefix(KEYWORD)
        .and_then(|said| std::str::from_utf8(said).ok());
    assert_eq!(
        said,
        Some(stamp(page).as_str()),
        "docs/figures/report.png is of another page: `docs/figures/redraw` takes it anew"
    );
}

#[test]
fn what_is_decoded_is_what_was_encoded() {
    for length in 0..10u8 {
        let bytes: Vec<u8> = (0..length).map(|at| at.wrapping_mul(91)).collect();
        assert_eq!(decoded(&base64(&bytes)), bytes);
    }
    assert_eq!(check_sum(b"123456789"), 0xcbf4_3926);
}
