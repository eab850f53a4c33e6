//! Places as programs want them: paths told from one folder, with `/`, and text that stays on its line.

use std::path::{Component, Path};

/// A path as it is the same on every machine: told from `here` if it is inside, without `.`, with `/`.
///
/// What is no file, such as standard input, keeps its name.
pub(super) fn relative(path: &str, here: &Path) -> String {
    let own = Path::new(path);
    let own = own.strip_prefix(here).unwrap_or(own);
    let mut parts: Vec<String> = Vec::new();
    let mut root = "";
    for part in own.components() {
        match part {
            Component::CurDir => {}
            Component::RootDir => root = "/",
            part => parts.push(part.as_os_str().to_string_lossy().into_owned()),
        }
    }
    match parts.is_empty() {
        true => path.to_owned(),
        false => format!("{root}{}", parts.join("/")),
    }
}

/// The same as a URI reference: what may not stand in one is written as `%` and two digits for each byte.
pub(super) fn uri(path: &str) -> String {
    let mut text = String::new();
    if path.starts_with('/') {
        text += "file://";
    }
    for byte in path.bytes() {
        match byte {
            b'a'..=b'z' | b'A'..=b'Z' | b'0'..=b'9' => text.push(char::from(byte)),
            b'-' | b'.' | b'_' | b'~' | b'/' => text.push(char::from(byte)),
            _ => text += &format!("%{byte:02X}"),
        }
    }
    text
}

/// Text on one line: white space becomes a space, and other control characters show that they are there.
pub(super) fn one_line(text: &str) -> String {
    text.chars()
        .map(|c| match c {
            '\n' | '\r' | '\t' | '\u{2028}' | '\u{2029}' => ' ',
            c if unseen(c) => '\u{fffd}',
            c => c,
        })
        .collect()
}

/// Control characters, and those that turn the direction of what follows.
fn unseen(c: char) -> bool {
    c.is_control() || matches!(c, '\u{202a}'..='\u{202e}' | '\u{2066}'..='\u{2069}' | '\u{feff}')
}
