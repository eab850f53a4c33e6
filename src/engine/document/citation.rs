//! Which equations prose cites: "equations (13) and (17)", "Eqs. (2)–(5)", `\eqref{key}`, "(42)".

use super::number::expand_range;
use super::prose::{self, Placed, Token};
use super::words::Listed;
use super::{Citation, Span};

/// Keys of `\ref` that name no equation.
const ELSEWHERE: [&str; 9] = [
    "fig:", "tab:", "sec:", "ch:", "chap:", "app:", "alg:", "lst:", "subsec:",
];

/// The most characters above a relation sign.
const LONGEST_REMARK: usize = 200;

/// What a word that introduces a citation allows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Introduction {
    /// "formula", "relation": a tag in parentheses.
    Word,
    /// "equation": also "equation 5".
    Singular,
    /// "equations": also "equations 5, 6 and 7".
    Plural,
}

/// Whether a word introduces a citation.
pub(super) fn introduces(word: &str) -> Option<Introduction> {
    const WORDS: [&str; 5] = ["formula", "formulas", "formulae", "relation", "relations"];
    let among = |words: &[&str]| words.has_in_any_case(word);
    match word.as_bytes().first()? {
        b'e' | b'E' => match () {
            () if among(&["equation", "eq", "eqn"]) => Some(Introduction::Singular),
            () if among(&["equations", "eqs", "eqns"]) => Some(Introduction::Plural),
            () => None,
        },
        b'f' | b'F' | b'r' | b'R' if among(&WORDS) => Some(Introduction::Word),
        _ => None,
    }
}

/// The citations in prose, in order.
pub(super) fn read(tokens: &[Placed<'_>]) -> Vec<Citation> {
    let mut citations = Vec::new();
    let mut at = 0;
    while at < tokens.len() {
        if let (Token::KeyRange(first, last), span) = tokens[at] {
            for (tag, through) in [(first, Some(last)), (last, None)] {
                citations.push(Citation {
                    tag: tag.trim().to_owned(),
                    through: through.map(|key| key.trim().to_owned()),
                    key: true,
                    span,
                    explicit: true,
                });
            }
            at += 1;
            continue;
        }
        let mut list = at;
        let mut introduction = None;
        if let (Token::Word(word), _) = tokens[at] {
            introduction = introduces(word);
            list += 1;
            if matches!(tokens.get(list), Some((Token::Mark('.'), _))) {
                list += 1;
            }
            if introduction.is_none() {
                at += 1;
                continue;
            }
        }
        let end = read_list(tokens, list, introduction, &mut citations);
        at = if end > list { end } else { at + 1 };
    }
    citations
}

/// The equations that are cited above the relation signs of a display, `\overset{\eqref{law}}{=}`, and beside its rows, `&& \text{by (1)}`.
pub(crate) fn above_signs(source: &str, body: Span) -> Vec<Citation> {
    let text = source.get(body.start..body.end).unwrap_or("");
    let mut end = 0;
    let remarks = text.match_indices('{').filter_map(|(brace, _)| {
        let before = &text[..brace];
        let above = before.ends_with("\\overset") || before.ends_with("\\stackrel");
        let beside = brace >= end && is_reason(before, &text[brace + 1..]);
        let length = (above || beside).then(|| closed_within(&text[brace + 1..]))??;
        end = brace + 1 + length;
        while beside && let Some(reference) = text.get(end + 1..).and_then(length_of_reference) {
            end += reference;
        }
        let own = usize::from(end > brace + 1 + length);
        Some(Span::new(body.start + brace + 1, body.start + end + own))
    });
    remarks
        .flat_map(|remark| read(&prose::tokens(source, remark, &[], &[])))
        .collect()
}

/// Whether words in braces begin as a reason does that cites something.
fn is_reason(before: &str, words: &str) -> bool {
    const TEXT: [&str; 4] = ["\\text", "\\textrm", "\\mbox", "\\hbox"];
    const CITING: [&str; 7] = ["by", "from", "using", "see", "with", "via", "cf."];
    let words = words.trim_start().trim_start_matches(['(', '[']);
    let first = words.split([' ', '~', '}']).next().unwrap_or("");
    TEXT.iter().any(|text| before.ends_with(text))
        && CITING.contains(&first.to_lowercase().as_str())
}

/// How long the reference is that a text begins with.
fn length_of_reference(text: &str) -> Option<usize> {
    const COMMANDS: [&str; 3] = ["\\eqref{", "\\ref{", "\\cref{"];
    let inside = text.trim_start_matches([' ', '~']);
    let named = COMMANDS.iter().find_map(|own| inside.strip_prefix(own))?;
    let length = named.chars().take(LONGEST_REMARK).position(|c| c == '}')?;
    let after = named.char_indices().nth(length)?.0 + 1;
    Some(text.len() - named.len() + after)
}

/// Where the brace that is open here is closed, if that is not far away.
fn closed_within(text: &str) -> Option<usize> {
    let mut depth = 1_usize;
    for (at, c) in text.char_indices().take(LONGEST_REMARK) {
        match c {
            '{' => depth += 1,
            '}' => depth -= 1,
            _ => {}
        }
        if depth == 0 {
            return Some(at);
        }
    }
    None
}

/// Reads citations joined by commas, "and", "or" from `at` on; where they end.
fn read_list(
    tokens: &[Placed<'_>],
    mut at: usize,
    introduction: Option<Introduction>,
    citations: &mut Vec<Citation>,
) -> usize {
    let mut end = at;
    let mut listed = false;
    while let Some((first, span)) = element(tokens, at, introduction, listed) {
        let key = matches!(tokens[at].0, Token::Keys(_));
        let explicit = introduction.is_some() && looks_like_tag(&first) || key;
        if listed && introduction.is_some() && !explicit {
            break;
        }
        end = at + 1;
        match range_end(tokens, end, introduction) {
            Some((after, last, last_span)) if !first.contains(['-', '–', '—', ',']) => {
                let span = span.to(last_span);
                let whole = |tag: &str| tag.bytes().all(|byte| byte.is_ascii_digit());
                // Where only the document knows what is between them, it is asked.
                let mut through = (key || !whole(&first) || !whole(&last)).then(|| last.clone());
                for tag in expand_range(&first, &last) {
                    citations.push(Citation {
                        tag,
                        through: through.take(),
                        key,
                        span,
                        explicit,
                    });
                }
                end = after;
            }
            _ => inside(tokens[at].0, &first, span, explicit, citations),
        }
        listed = true;
        let separated = separator(tokens, end);
        if separated == end {
            break;
        }
        at = separated;
    }
    end
}

/// The tag at `at`.
fn element(
    tokens: &[Placed<'_>],
    at: usize,
    introduction: Option<Introduction>,
    listed: bool,
) -> Option<(String, Span)> {
    let &(token, span) = tokens.get(at)?;
    match token {
        Token::Tag(tag) => Some((tag.trim().to_owned(), span)),
        Token::Keys(keys) => Some((keys.trim().to_owned(), span)),
        Token::Number(number) => {
            // "From equations 17 and 18, 2 balls leave" does not cite equation 2.
            let comma = matches!(tokens.get(at.wrapping_sub(1)), Some((Token::Mark(','), _)));
            let noun = matches!(tokens.get(at + 1), Some((Token::Word(word), _)) if !joins(word));
            let allowed = match introduction {
                Some(Introduction::Plural) => !(listed && comma && noun),
                Some(Introduction::Singular) => !listed,
                _ => false,
            };
            allowed.then(|| (number.to_owned(), span))
        }
        _ => None,
    }
}

/// `–(5)`, "to (5)" at `at`: where it ends, and the last tag.
fn range_end(
    tokens: &[Placed<'_>],
    at: usize,
    introduction: Option<Introduction>,
) -> Option<(usize, String, Span)> {
    let ranged = match tokens.get(at)?.0 {
        Token::Dash => true,
        Token::Word("to" | "through") => {
            introduction.is_some()
                || matches!(tokens.get(at.wrapping_sub(1)), Some((Token::Keys(_), _)))
                || is_wide(tokens, at)
        }
        _ => false,
    };
    match tokens.get(at + 1)? {
        (Token::Tag(tag) | Token::Keys(tag), span) if ranged => {
            Some((at + 2, tag.trim().to_owned(), *span))
        }
        (Token::Number(tag), span) if ranged && introduction == Some(Introduction::Plural) => {
            Some((at + 2, (*tag).to_owned(), *span))
        }
        _ => None,
    }
}

/// "(1) to (4)" means what lies between them too; "(1) to (2)" may be a step from one to the other.
fn is_wide(tokens: &[Placed<'_>], at: usize) -> bool {
    let number = |at: usize| match tokens.get(at) {
        Some((Token::Tag(tag), _)) => tag.trim().parse::<u32>().ok(),
        _ => None,
    };
    let ends = (number(at.wrapping_sub(1)), number(at + 1));
    matches!(ends, (Some(first), Some(last)) if last > first.saturating_add(1))
}

/// Past a comma, "and", "or", "&" or a comma and one of those.
fn separator(tokens: &[Placed<'_>], mut at: usize) -> usize {
    if matches!(tokens.get(at), Some((Token::Mark(','), _))) {
        at += 1;
    }
    match tokens.get(at) {
        Some((Token::Word("and" | "or"), _) | (Token::Mark('&'), _)) => at + 1,
        _ => at,
    }
}

fn joins(word: &str) -> bool {
    matches!(word, "and" | "or" | "to" | "through")
}

/// "equation (elastic collision)" need not exist; "equation (E)" and "equation (2a)" must.
fn looks_like_tag(tag: &str) -> bool {
    tag.chars().count() <= 2 || tag.chars().any(char::is_numeric)
}

/// The tags of one parenthesis: one, or for `(2, 3)` and `(2–5)` after "equations" several.
fn inside(token: Token<'_>, text: &str, span: Span, explicit: bool, citations: &mut Vec<Citation>) {
    let key = matches!(token, Token::Keys(_));
    let mut cite = |tag: &str| {
        citations.push(Citation {
            tag: tag.to_owned(),
            through: None,
            key,
            span,
            explicit,
        });
    };
    if !key && !explicit {
        if !text.contains([',', ' ']) {
            cite(text);
        }
        return;
    }
    for part in text
        .split(',')
        .map(str::trim)
        .filter(|part| !part.is_empty())
    {
        if key {
            if !ELSEWHERE.iter().any(|prefix| part.starts_with(prefix)) {
                cite(part);
            }
            continue;
        }
        let numeric = |end: &&str| !end.is_empty() && end.bytes().all(|byte| byte.is_ascii_digit());
        let ends: Vec<&str> = part
            .split(['-', '–', '—'])
            .map(str::trim)
            .filter(numeric)
            .collect();
        match ends[..] {
            [first, last] => expand_range(first, last).iter().for_each(|tag| cite(tag)),
            _ => cite(part),
        }
    }
}
