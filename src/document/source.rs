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
        write!(f, "not UTF-8 text: byte {offset}, on line {line}")
    }
}

impl std::error::Error for NotUtf8 {}

/// The bytes as text.
pub(super) fn decode(bytes: &[u8]) -> Result<&str, NotUtf8> {
    std::str::from_utf8(bytes).map_err(|error| {
        let offset = error.valid_up_to();
        NotUtf8 {
            offset,
            line: line_starts(&bytes[..offset]).len(),
        }
    })
}

/// Where each line starts; found once, then asked by bisection.
#[derive(Clone, Debug)]
pub(super) struct Lines {
    starts: Vec<usize>,
}

impl Lines {
    pub(super) fn of(source: &str) -> Lines {
        Lines {
            starts: line_starts(source.as_bytes()),
        }
    }

    pub(super) fn position(&self, source: &str, offset: usize) -> Position {
        let mut offset = offset.min(source.len());
        while !source.is_char_boundary(offset) {
            offset -= 1;
        }
        let line = self.starts.partition_point(|&start| start <= offset);
        let start = line.checked_sub(1).map_or(0, |index| self.starts[index]);
        let before = source[start..offset].trim_start_matches('\u{feff}');
        Position {
            line: line.max(1),
            column: before.chars().count() + 1,
        }
    }
}

/// `\n`, `\r\n` and a lone `\r` each end a line.
fn line_starts(bytes: &[u8]) -> Vec<usize> {
    let mut starts = vec![0];
    for (index, &byte) in bytes.iter().enumerate() {
        if byte == b'\n' || (byte == b'\r' && bytes.get(index + 1) != Some(&b'\n')) {
            starts.push(index + 1);
        }
    }
    starts
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn columns_count_characters_on_every_kind_of_line() {
        let source = "\u{feff}a\r\nδ = 1\rz";
        let lines = Lines::of(source);
        let at = |needle: &str| {
            let position = lines.position(source, source.find(needle).unwrap());
            (position.line, position.column)
        };
        assert_eq!(at("a"), (1, 1));
        assert_eq!(at("="), (2, 3));
        assert_eq!(at("z"), (3, 1));
    }

    #[test]
    fn an_offset_past_the_end_or_inside_a_character_is_rounded_down() {
        let lines = Lines::of("δ");
        assert_eq!(lines.position("δ", 1), lines.position("δ", 0));
        assert_eq!(lines.position("δ", 99).column, 2);
    }

    #[test]
    fn bytes_that_are_not_text_are_placed() {
        assert_eq!(decode(b"a\nb\xff"), Err(NotUtf8 { offset: 3, line: 2 }));
        assert_eq!(decode(b"a"), Ok("a"));
    }
}
