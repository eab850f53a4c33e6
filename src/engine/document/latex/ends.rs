//! Where arguments, paragraphs and mathematics end.

use super::names;

/// The longest argument that is looked for in text.
const LONGEST_ARGUMENT: usize = 20_000;

/// The length of `[…]` or `{…}` at the start of `rest`, braces in it counted.
pub(super) fn bracketed(rest: &str, open: char, close: char) -> Option<usize> {
    if !rest.starts_with(open) {
        return None;
    }
    let mut depth = 0_usize;
    let mut escaped = false;
    for (at, c) in rest.char_indices().take(LONGEST_ARGUMENT).skip(1) {
        if std::mem::take(&mut escaped) {
            continue;
        }
        match c {
            '\\' => escaped = true,
            c if c == close && depth == 0 => return Some(at + c.len_utf8()),
            '{' => depth += 1,
            '}' => depth = depth.checked_sub(1)?,
            _ => {}
        }
    }
    None
}

/// The end of a line, and the next line blank.
pub(super) fn ends_paragraph(tail: &[u8]) -> bool {
    let [b'\n', after @ ..] = tail else {
        return false;
    };
    let text = after
        .iter()
        .find(|byte| !matches!(byte, b' ' | b'\t' | b'\r'));
    matches!(text, Some(b'\n'))
}

/// Whether text begins with what cannot stand in a display.
pub(super) fn stops(text: &str) -> bool {
    if let Some(rest) = text.strip_prefix("\\begin{") {
        let name = rest.split('}').next().unwrap_or_default();
        return names::display(name.trim_end_matches('*')).is_some() || name == "document";
    }
    if text.starts_with("\\end{document}") {
        return true;
    }
    let Some(command) = text.strip_prefix('\\') else {
        return false;
    };
    let letters = command.find(|c: char| !c.is_ascii_alphabetic());
    names::heading(&command[..letters.unwrap_or(command.len())]).is_some()
}

/// The `$$` that closes; or where the search ends.
pub(super) fn dollars_end(bytes: &[u8], from: usize) -> Result<usize, usize> {
    let (mut at, mut depth, mut words) = (from, 0_usize, false);
    loop {
        match bytes.get(at..).unwrap_or_default() {
            [] => return Err(bytes.len()),
            [b'$', b'$', ..] if !(words && depth > 0) => return Ok(at),
            [b'$', ..] if depth > 0 => {
                words = !words;
                at += 1;
            }
            [b'$', ..] => return Err(at),
            tail @ [b'\n', ..] if ends_paragraph(tail) => return Err(at),
            tail @ [b'\\', b'b' | b'e' | b's' | b'c' | b'p', ..] if stops(as_text(tail)) => {
                return Err(at);
            }
            [b'\\', b'[', ..] => return Err(at),
            [b'\\', ..] => at += 2,
            [b'{', ..] => (depth, at) = (depth + 1, at + 1),
            [b'}', ..] => (depth, at) = (depth.saturating_sub(1), at + 1),
            _ => at += 1,
        }
    }
}

/// The `\]` that closes; or where the search ends.
pub(super) fn bracket_end(bytes: &[u8], from: usize) -> Result<usize, usize> {
    let mut at = from;
    loop {
        match bytes.get(at..).unwrap_or_default() {
            [] => return Err(bytes.len()),
            [b'\\', b']', ..] => return Ok(at),
            [b'$', b'$', ..] | [b'\\', b'[', ..] => return Err(at),
            tail @ [b'\n', ..] if ends_paragraph(tail) => return Err(at),
            tail @ [b'\\', b'b' | b'e' | b's' | b'c' | b'p', ..] if stops(as_text(tail)) => {
                return Err(at);
            }
            [b'\\', ..] => at += 2,
            _ => at += 1,
        }
    }
}

/// Enough of the text at some bytes to know a command: they begin with one, so on the bound of a character.
pub(super) fn as_text(tail: &[u8]) -> &str {
    let tail = &tail[..tail.len().min(40)];
    match std::str::from_utf8(tail) {
        Ok(text) => text,
        Err(error) => std::str::from_utf8(&tail[..error.valid_up_to()]).unwrap_or_default(),
    }
}

/// The `\end` of an environment, and the place behind it; or where the search ends.
pub(in crate::document) fn environment_end(
    text: &str,
    from: usize,
    name: &str,
) -> Result<(usize, usize), usize> {
    let bytes = text.as_bytes();
    let mut open: Vec<&str> = Vec::new();
    let mut at = from;
    loop {
        match bytes.get(at..).unwrap_or_default() {
            [] => return Err(bytes.len()),
            [b'$', b'$', ..] | [b'\\', b'[', ..] => return Err(at),
            [b'%', rest @ ..] => {
                let line = rest.iter().position(|byte| *byte == b'\n');
                at += line.map_or(rest.len(), |line| line) + 1;
            }
            tail @ [b'\\', b'b' | b'e' | b's' | b'c' | b'p', ..] => {
                if stops(as_text(tail)) {
                    return Err(at);
                }
                let rest = &text[at..];
                let named = |command: &str| -> Option<&str> {
                    let rest = rest.strip_prefix(command)?;
                    let end = rest.bytes().take(64).position(|byte| byte == b'}')?;
                    rest.get(..end)
                };
                if let Some(inner) = named("\\begin{") {
                    open.push(inner);
                } else if let Some(ended) = named("\\end{") {
                    match open.pop() {
                        None if ended.trim() == name => {
                            return Ok((at, at + "\\end{}".len() + ended.len()));
                        }
                        Some(begun) if begun == ended => {}
                        _ => return Err(at),
                    }
                }
                at += 2;
            }
            [b'\\', ..] => at += 2,
            _ => at += 1,
        }
    }
}

/// Where inline mathematics ends; a `$` in braces belongs to words in it.
pub(super) fn inline_end(bytes: &[u8], from: usize, closes: &[u8]) -> Option<usize> {
    let (mut at, mut depth) = (from, 0_usize);
    loop {
        let tail = bytes.get(at..)?;
        if depth == 0 && tail.starts_with(closes) {
            return Some(at);
        }
        match tail {
            [] => return None,
            [b'\n', ..] if ends_paragraph(tail) => return None,
            [b'\\', b'[' | b'(', ..] => return None,
            [b'$', ..] if depth == 0 => return None,
            [b'\\', ..] if stops(as_text(tail)) => return None,
            [b'\\', ..] => at += 2,
            [b'{', ..] => (depth, at) = (depth + 1, at + 1),
            [b'}', ..] => (depth, at) = (depth.checked_sub(1)?, at + 1),
            _ => at += 1,
        }
    }
}
