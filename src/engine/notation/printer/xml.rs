//! Text for XML and HTML: what markup is made of as entities.

/// Text between tags or in an attribute. `strange` says what becomes of each control character, line ends among them, and of what may
/// not stand in XML at all.
pub fn escape_by(text: &str, strange: impl Fn(char) -> Option<char>) -> String {
    let mut escaped = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '&' => escaped += "&amp;",
            '<' => escaped += "&lt;",
            // `]]>` may not stand in text.
            '>' => escaped += "&gt;",
            '"' => escaped += "&quot;",
            '\'' => escaped += "&#39;",
            c if c.is_control() || matches!(c, '\u{fffe}' | '\u{ffff}') => {
                escaped.extend(strange(c));
            }
            c => escaped.push(c),
        }
    }
    escaped
}

/// The same for a page: lines stay lines, and what may not stand in XML shows as a replacement.
pub fn escape(text: &str) -> String {
    escape_by(text, |c| match c {
        '\n' | '\t' => Some(c),
        '\r' => None,
        _ => Some(char::REPLACEMENT_CHARACTER),
    })
}
