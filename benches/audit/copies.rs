//! Sections 1 and 3 of the report over and over, as if different authors had written them.
//!
//! In each copy every symbol but the counts has a name of its own (`v_0` becomes `\mathrm{v7}_0`), every equation a
//! number of its own ((23) becomes (723)), and every claim a name of its own.

use cradle_verify::document::Document;
use cradle_verify::proofs;

/// The counts of section 1.4: they stand in subscripts too, where a name cannot be changed so simply.
const KEPT: &str = "ikndN";

/// Every page of every copy.
pub fn documents(copies: usize) -> Vec<Document> {
    let algebra = |path: &str| path.contains("/1.") || path.contains("/3.");
    let pages = proofs::PAGES.iter().filter(|(path, _)| algebra(path));
    let pages: Vec<_> = pages.collect();
    (1..=copies)
        .flat_map(|copy| {
            pages.iter().map(move |(path, source)| {
                let source = renamed(source, copy);
                Document::markdown(format!("copy-{copy}/{path}"), source)
            })
        })
        .collect()
}

/// Prose, mathematics and comments take turns; each is renamed in its own way.
fn renamed(source: &str, copy: usize) -> String {
    let mut out = String::new();
    let mut rest = source;
    loop {
        let start = rest.find('$').into_iter().chain(rest.find("<!--")).min();
        let Some(start) = start else {
            return out + &prose(rest, copy);
        };
        out += &prose(&rest[..start], copy);
        rest = &rest[start..];
        let (fence, close) = match () {
            () if rest.starts_with("$$") => ("$$", "$$"),
            () if rest.starts_with('$') => ("$", "$"),
            () => ("<!--", "-->"),
        };
        let end = rest[fence.len()..].find(close).expect("it is closed") + fence.len();
        let (inside, after) = (&rest[fence.len()..end], &rest[end + close.len()..]);
        let inside = match fence {
            "<!--" => prose(&symbols(inside, copy, true), copy),
            _ => symbols(inside, copy, false),
        };
        out += &format!("{fence}{inside}{close}");
        rest = after;
    }
}

/// `(23)` becomes `(723)`, `claim mass-ratio` becomes `claim mass-ratio.7`.
fn prose(text: &str, copy: usize) -> String {
    let mut out = String::new();
    for (at, piece) in text.split('(').enumerate() {
        if at > 0 {
            out.push('(');
            let digits = piece.bytes().take_while(u8::is_ascii_digit).count();
            if (1..=2).contains(&digits) && piece[digits..].starts_with(')') {
                let number: usize = piece[..digits].parse().expect("digits");
                out += &format!("{}", 100 * copy + number);
                out += &claims(&piece[digits..], copy);
                continue;
            }
        }
        out += &claims(piece, copy);
    }
    out
}

fn claims(text: &str, copy: usize) -> String {
    let mut pieces = text.split("claim ");
    let mut out = pieces.next().unwrap_or_default().to_owned();
    for piece in pieces {
        let own = |c: char| c.is_ascii_alphanumeric() || c == '-';
        let end = piece.find(|c| !own(c)).unwrap_or(piece.len());
        let (name, after) = piece.split_at(end);
        let name = match name.contains('-') || text.contains("check:") {
            true => format!("{name}.{copy}"),
            false => name.to_owned(),
        };
        out += &format!("claim {name}{after}");
    }
    out
}

/// Gives every symbol its own name. In a comment a letter is a symbol only if it stands by itself.
fn symbols(text: &str, copy: usize, comment: bool) -> String {
    let letters = |from: usize| {
        let bytes = text[from..].bytes();
        bytes.take_while(u8::is_ascii_alphabetic).count()
    };
    let mut out = String::new();
    let mut at = 0;
    while at < text.len() {
        let rest = &text[at..];
        let first = rest.chars().next().expect("not at the end");
        if let Some(number) = rest.strip_prefix("\\tag{") {
            let (number, _) = number.split_once('}').expect("a tag is closed");
            let own: usize = number.parse().expect("a number");
            out += &format!("\\tag{{{}}}", 100 * copy + own);
            at += "\\tag{}".len() + number.len();
        } else if let Some(words) = rest.strip_prefix("\\text{") {
            let (words, _) = words.split_once('}').expect("a text is closed");
            out += &format!("\\text{{{words}}}");
            at += "\\text{}".len() + words.len();
        } else if first == '\\' {
            let command = &rest[1..1 + letters(at + 1)];
            match command {
                "mu" | "eta" => out += &format!("\\mathrm{{{command}{copy}}}"),
                _ => out += &format!("\\{command}"),
            }
            at += 1 + command.len();
        } else if first.is_ascii_alphabetic() {
            let word = letters(at);
            let whole = comment && word > 1;
            let end = at + if whole { word } else { 1 };
            let subscript = text[..at].ends_with(['_', '{']) && text[..at].contains('_');
            let subscript = subscript && text[..at].trim_end_matches('{').ends_with('_');
            match whole || subscript || KEPT.contains(first) {
                true => out += &text[at..end],
                false => out += &format!("\\mathrm{{{first}{copy}}}"),
            }
            at = end;
        } else {
            out.push(first);
            at += first.len_utf8();
        }
    }
    out
}
