//! Whether what is told is given as a reason: "since $a = b$", "Since no heat is lost, $a = b$"; and whether it is so everywhere.

use super::super::Span;
use super::super::words::Listed;
use super::words::REASONS;

/// Whether the word before mathematics gives it as a reason: "since $a = b$".
pub fn is_reason(source: &str, body: Span) -> bool {
    let before = source.get(..body.start).unwrap_or_default();
    let before = before.trim_end_matches(|c: char| !c.is_alphabetic());
    let word = before.rsplit(|c: char| !c.is_alphabetic()).next();
    // "They have the same size where $s = t$" says at which place.
    let is_place = |word: &str| {
        let before = before[..before.len() - word.len()].trim_end();
        word == "where" && before.ends_with(char::is_alphabetic)
    };
    word.is_some_and(|word| REASONS.has_in_any_case(word) && !is_place(word))
        || follows_a_reason(source, body)
}

/// What is so everywhere is said with these after it, "$J = 0$ everywhere"; and so is what is put into a law that is integrated.
const EVERYWHERE: [&str; 5] = [
    "everywhere",
    "throughout",
    "identically",
    "integrating",
    "integration",
];
/// Where nothing changes, what is told is so everywhere: "In equilibrium $J = 0$".
const AT_REST: [&str; 6] = [
    "equilibrium",
    "thermal equilibrium",
    "the steady state",
    "a steady state",
    "steady state",
    "the stationary state",
];
/// What comes after these is so at a place.
const PLACES: &[&str] = &[
    "at", "from", "to", "between", "for", "when", "until", "where",
];
/// Before what is found from a condition.
const FINDING: [&str; 8] = [
    "gives", "yields", "implies", "requires", "forces", "makes", "so", "hence",
];
/// More of a sentence is not looked at.
const LONGEST: usize = 200;

/// The text before mathematics, as far as it is looked at.
fn near_before(source: &str, body: Span) -> &str {
    let before = source.get(..body.start).unwrap_or_default();
    let near = before.len().saturating_sub(LONGEST);
    let near = (near..=before.len()).find(|&at| before.is_char_boundary(at));
    &before[near.unwrap_or_default()..]
}

/// Whether the sentence around mathematics says that it is so everywhere, and not at one place: "$J = 0$ everywhere", "In equilibrium $J = 0$".
pub fn is_everywhere(source: &str, body: Span) -> bool {
    let before = near_before(source, body);
    // A constant of integration is one for good.
    if finds_constant(source, body) {
        return true;
    }
    let sentence = before.rsplit(['.', '\n', ';']).next();
    let begins = sentence.unwrap_or_default().trim_start();
    let begins = begins
        .strip_prefix("In ")
        .or_else(|| begins.strip_prefix("At "));
    let rests = begins.is_some_and(|own| AT_REST.iter().any(|words| own.starts_with(words)));
    let after = source.get(body.end..).unwrap_or_default();
    let ends = after.char_indices().take(LONGEST);
    let end = ends
        .map(|(at, _)| at)
        .find(|&at| after[at..].starts_with(['.', ';', '=']) || after[at..].starts_with("\n\n"));
    let mut words = after[..end.unwrap_or_default()].split(|c: char| !c.is_alphabetic());
    let word = before
        .trim_end_matches(|c: char| !c.is_alphabetic())
        .rsplit(|c: char| !c.is_alphabetic())
        .next();
    let is_place = word.is_some_and(|word| PLACES.has_in_any_case(word));
    !is_place && (rests || words.any(|word| EVERYWHERE.contains(&word)))
}

/// Whether the words before mathematics find that a constant of integration is nought: "The condition $v(0) = 0$ gives $C_2 = 0$".
pub(super) fn finds_constant(source: &str, body: Span) -> bool {
    let before = near_before(source, body).trim_end_matches(['$', '\\', '(']);
    let word = before
        .trim_end()
        .rsplit(|c: char| !c.is_alphabetic())
        .next();
    word.is_some_and(|word| FINDING.contains(&&*word.to_lowercase()))
        && says_constant_is_nought(source.get(body.range()).unwrap_or_default())
}

/// Whether mathematics says of what is named as constants of integration are, `C_2 = 0`, that it is nought.
fn says_constant_is_nought(text: &str) -> bool {
    let parts = text.split_once('=');
    let Some((name, "0")) = parts.map(|(name, value)| (name.trim(), value.trim())) else {
        return false;
    };
    let is_index = |own: &str| {
        let own = own.strip_prefix('_').unwrap_or_default();
        let own = own.trim_start_matches('{').trim_end_matches('}');
        own.len() == 1 && own.bytes().all(|own| own.is_ascii_digit())
    };
    let index_of = name.strip_prefix(['A', 'B', 'C', 'D']);
    name == "C" || index_of.is_some_and(is_index)
}

/// Whether the sentence before mathematics says that it is put into something, or tried: "Inserting $x = A \cos\omega t$ in (2)".
pub fn is_tried(source: &str, body: Span) -> bool {
    const TRYING: &[&str] = &[
        "insert",
        "inserting",
        "substitute",
        "substituting",
        "substitution",
        "put",
        "putting",
        "plug",
        "plugging",
        "try",
        "trying",
        "trial",
        "ansatz",
        "guess",
        "guessing",
    ];
    let before = near_before(source, body);
    let sentence = before.rsplit(['.', ';']).next();
    let mut words = (sentence.unwrap_or_default()).split(|c: char| !c.is_alphabetic());
    words.any(|word| TRYING.has_in_any_case(word))
}

/// Whether the clause before mathematics gives a reason in words: "Since no heat is lost, $a = b$".
fn follows_a_reason(source: &str, body: Span) -> bool {
    let before = source.get(..body.start).unwrap_or_default();
    let before =
        before.trim_end_matches(|c: char| c.is_whitespace() || matches!(c, '$' | '(' | '\\'));
    let Some(before) = before.strip_suffix(',') else {
        return false;
    };
    let clause = before.rsplit([',', '.', ';', ':', '$', '}', ')']).next();
    let mut words = clause.unwrap_or_default().split_whitespace();
    let (first, next) = (words.next(), words.next());
    let rest = words.count();
    let is =
        |word: Option<&str>, among: &[&str]| word.is_some_and(|word| among.has_in_any_case(word));
    // "As a check," gives none.
    let describes = is(
        next,
        &[
            "a", "an", "in", "for", "we", "to", "with", "can", "shown", "expected",
        ],
    );
    is(first, &["since", "because"]) && rest > 0 || is(first, &["as"]) && rest > 1 && !describes
}
