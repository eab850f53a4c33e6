//! Offsets for the machine, lines and columns for people.

use std::fmt;

/// A place as editors show it.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct Position {
    /// The line, from 1.
    pub line: usize,
    /// The column, from 1, counted in characters; a byte order mark takes none.
    pub column: usize,
}

/// A file that is not UTF-8 text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct NotUtf8 {
    /// The first byte that is not.
    pub offset: usize,
    /// Its line, from 1.
    pub line: usize,
}

impl fmt::Display for NotUtf8 {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let NotUtf8 { offset, line } = self;
        write!(f, "not UTF-8 text: byte {}, on line {line}", offset + 1)
    }
}

impl std::error::Error for NotUtf8 {}

/// So many bytes are looked at in one go.
const MANY: usize = 64;

/// Where the next character stands, from an offset on, by which a text commands who shows it: line ends and tabs do not, nor what sets
/// colours.
pub fn next_command(text: &str, mut from: usize) -> Option<usize> {
    // What such a character begins with in UTF-8, and little else.
    let may_begin = |byte: &u8| matches!(byte, 0..=8 | 0xB..=0x1F | 0x7F | 0xC2);
    // Of many bytes at once it is seen that none of them does.
    let has_none = |bytes: &&[u8]| !bytes.iter().fold(false, |any, own| any | may_begin(own));
    loop {
        let rest = text.as_bytes().get(from..)?;
        from += MANY * rest.chunks(MANY).take_while(has_none).count();
        let at = from + text.as_bytes().get(from..)?.iter().position(may_begin)?;
        let rest = &text[at..];
        let next = rest.chars().next()?;
        let commands = next.is_control() && !matches!(next, '\n' | '\t');
        if commands && !is_color(rest) {
            return Some(at);
        }
        from = at + next.len_utf8();
    }
}

/// Whether text starts with a sequence that sets colours: `ESC [ digits and semicolons m`.
fn is_color(text: &str) -> bool {
    let Some(rest) = text.strip_prefix("\u{1b}[") else {
        return false;
    };
    let inside = |c: char| c.is_ascii_digit() || c == ';';
    rest.trim_start_matches(inside).starts_with('m')
}

/// The bytes as text.
pub(super) fn decode(bytes: &[u8]) -> Result<&str, NotUtf8> {
    if is_utf16(bytes) {
        let offset = bytes.iter().position(|&byte| byte == 0).unwrap_or(0);
        return Err(NotUtf8 { offset, line: 1 });
    }
    std::str::from_utf8(bytes).map_err(|error| {
        let offset = error.valid_up_to();
        NotUtf8 {
            offset,
            line: line_starts(&bytes[..offset]).len(),
        }
    })
}

/// Whether every second byte is zero, or nearly every: UTF-16 of plain letters without a mark at its beginning.
fn is_utf16(bytes: &[u8]) -> bool {
    let start = &bytes[..bytes.len().min(1024)];
    let pairs = start.chunks_exact(2);
    let (all, mut halves) = (pairs.len(), [0, 0]);
    for pair in pairs {
        halves[0] += usize::from(pair[0] == 0 && pair[1] != 0);
        halves[1] += usize::from(pair[1] == 0 && pair[0] != 0);
    }
    all >= 2 && halves.iter().any(|&zero| 4 * zero > 3 * all)
}

/// Of so many bytes the characters are counted once: a line may be very long, and much be asked of it.
const BLOCK: usize = 1024;

/// Where each line starts; found once, then asked by bisection.
#[derive(Clone, Debug)]
pub(super) struct Lines {
    starts: Vec<usize>,
    /// How many characters begin before each block of bytes.
    before: Vec<usize>,
}

impl Lines {
    pub(super) fn of(source: &str) -> Lines {
        let mut sum = 0;
        let counted = source.as_bytes().chunks(BLOCK).map(|block| {
            let before = sum;
            sum += characters(block);
            before
        });
        let before = counted.collect();
        Lines {
            starts: line_starts(source.as_bytes()),
            before,
        }
    }

    /// How many characters begin before an offset.
    fn characters_before(&self, source: &str, offset: usize) -> usize {
        let block = offset / BLOCK;
        let Some(before) = self.before.get(block) else {
            // The end of a text that ends with a block.
            return source.chars().count();
        };
        before + characters(&source.as_bytes()[block * BLOCK..offset])
    }

    pub(super) fn position(&self, source: &str, offset: usize) -> Position {
        let mut offset = offset.min(source.len());
        while !source.is_char_boundary(offset) {
            offset -= 1;
        }
        let line = self.starts.partition_point(|&start| start <= offset);
        let start = line.checked_sub(1).map_or(0, |index| self.starts[index]);
        let mark = usize::from(source[start..offset].starts_with('\u{feff}'));
        let before = |at| self.characters_before(source, at);
        Position {
            line: line.max(1),
            column: before(offset) - before(start) - mark + 1,
        }
    }
}

/// How many characters begin in a part of a text.
fn characters(bytes: &[u8]) -> usize {
    if bytes.is_ascii() {
        return bytes.len();
    }
    let begins = |byte: &&u8| **byte & 0b1100_0000 != 0b1000_0000;
    bytes.iter().filter(begins).count()
}

/// Room is made for a line of each so many bytes.
const LINE_LENGTH: usize = 32;

/// `\n`, `\r\n` and a lone `\r` each end a line.
pub(super) fn line_starts(bytes: &[u8]) -> Vec<usize> {
    let mut starts = Vec::with_capacity(bytes.len() / LINE_LENGTH + 1);
    starts.push(0);
    for (at, byte) in bytes.iter().enumerate() {
        if *byte == b'\n' || *byte == b'\r' && bytes.get(at + 1) != Some(&b'\n') {
            starts.push(at + 1);
        }
    }
    starts
}
