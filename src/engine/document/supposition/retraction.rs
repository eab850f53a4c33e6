//! What a text takes back: what it tells and then calls wrong, disputes, or says otherwise.

use super::super::prose::{Placed, Token, among, begins_with, ends_sentence, in_lower_case};
use super::super::{Span, Supposition, SuppositionKind};
use super::around::follows;
use super::mathematics::{is_bound, is_number};
use super::words::{BESIDE, DISPUTING, HEADING, REFERRING, RETRACTING};
use super::{is_fact, is_no_meaning};
use crate::sorted::{self, Map, Set};

/// What one of these says is so.
const SPEAKING: [&str; 16] = [
    "law",
    "equation",
    "continuity",
    "energy",
    "momentum",
    "charge",
    "mass",
    "rule",
    "theorem",
    "principle",
    "relation",
    "definition",
    "condition",
    "conservation",
    "geometry",
    "symmetry",
];
/// So many words before a relation may say that it is not so there.
const MOST_BESIDE: usize = 3;

/// Of so many values in a piece of text, the first, it is asked what they are of.
const MOST_VALUES: usize = 32;
/// What a value is of that is named after it, "for a cylinder", has no more words.
const MOST_OF_KIND: usize = 5;

/// Takes out values of which the text gives different ones for different things, "with $\beta = 1/2$ for a cylinder and $\beta = 2/5$ for a
/// ball": each is so of its own alone. One by itself, "with $\beta = 1/2$ for a cylinder.", may be what the text is about.
pub(super) fn tell_kinds_apart(
    source: &str,
    tokens: &[Placed<'_>],
    found: &mut Vec<Supposition>,
    mentions: &mut Vec<Span>,
) {
    use SuppositionKind::{Assume, Case, Define, Fact, Figure, Known, Let, Meaning, OfKind};
    // What the sentence says that leads on to the display is said of that.
    let leads_from = tokens
        .iter()
        .rposition(|token| ends_sentence(source, token))
        .map_or(0, |stop| tokens[stop].1.end);
    let gives = |own: &Supposition| {
        matches!(
            own.kind,
            Assume | Case { .. } | Define | Fact { .. } | Figure | Known | Let | Meaning
        )
    };
    let mut values: Vec<(Span, &str, &str, Option<Span>)> = (0..tokens.len())
        .filter_map(|at| {
            let Token::Math(body) = tokens[at].0 else {
                return None;
            };
            let (left, right) = sides(source, body)?;
            Some((body, left, right, of_kind(tokens, at)))
        })
        .collect();
    values.truncate(MOST_VALUES);
    let mut kinds = Vec::new();
    for &(body, left, right, kind) in &values {
        let is_number = |body: Span| source.get(body.range()).is_some_and(is_number);
        let same_sentence = |other: Span| {
            let between = tokens.iter().filter(|(_, span)| {
                body.start.min(other.start) < span.start && span.end < body.end.max(other.end)
            });
            !between
                .into_iter()
                .any(|token| ends_sentence(source, token))
        };
        let is_rival = |other: &&(Span, &str, &str, Option<Span>)| {
            let &&(other, its_left, its_right, its_kind) = other;
            let parted = || {
                kind.is_some() && its_kind.is_some()
                    || is_number(body) && is_number(other) && same_sentence(other)
            };
            left == its_left && right != its_right && parted()
        };
        let is_apart = values.iter().any(|other| is_rival(&other));
        if is_apart && body.start >= leads_from && leads_from > 0 {
            // "For a monatomic gas $f = 3$. For a diatomic gas $f = 5$, so": what comes next is said of that.
            let kind = kind.map(SuppositionKind::OfKind);
            found.extend(kind.map(|kind| Supposition { kind, body }));
        } else if is_apart {
            kinds.push((body, kind, true));
        } else if let Some(kind) = kind
            && source.get(kind.range()).is_some_and(is_any)
            && body.end <= leads_from
        {
            kinds.push((body, Some(kind), false));
        }
    }
    for (body, kind, is_apart) in kinds {
        let mut own = found.extract_if(.., |own| own.body == body && gives(own));
        let first = own.next();
        drop(own);
        match (kind, first) {
            (_, None) if !is_apart => {}
            (Some(_), Some(own)) if !is_apart && own.kind != Define => found.push(own),
            (Some(kind), _) => {
                found.push(Supposition {
                    kind: OfKind(kind),
                    body,
                });
                if !is_apart {
                    found.push(Supposition {
                        kind: Fact {
                            runs_on: true,
                            of_case: true,
                        },
                        body,
                    });
                }
            }
            _ => mentions.push(body),
        }
    }
    sorted::sort(mentions);
}

/// "a ball", "an ideal gas": one of many.
fn is_any(kind: &str) -> bool {
    kind.starts_with("a ") || kind.starts_with("an ")
}

/// What a value is of: the words after "for" that come after it, or with which its sentence begins.
fn of_kind(tokens: &[Placed<'_>], at: usize) -> Option<Span> {
    let is_word = |(token, _): &&Placed<'_>| match token {
        Token::Word(_) => !token.is_among(&["and", "or", "while", "whereas", "but"]),
        _ => false,
    };
    let is_for = |at: usize| {
        tokens
            .get(at)
            .is_some_and(|(token, _)| token.is_among(&["for"]))
    };
    let named = |words: &[Placed<'_>]| {
        let is_some = (1..=MOST_OF_KIND).contains(&words.len());
        is_some.then(|| words[0].1.to(words[words.len() - 1].1))
    };
    if is_for(at + 1) {
        let words = tokens[at + 2..].iter().take_while(is_word).count();
        return named(&tokens[at + 2..at + 2 + words]);
    }
    // "where for a monatomic gas $f = 3$"
    let words = tokens[..at].iter().rev().take_while(is_word).count();
    let begin = (at - words..at).rev().find(|&at| is_for(at))?;
    named(&tokens[begin + 1..at])
}

/// Takes back what a sentence tells that disputes it, or that the next one does, or the heading before it; and what is supposed, where
/// the next sentence takes it back. What is told is then only named.
pub(super) fn take_back(
    source: &str,
    tokens: &[Placed<'_>],
    found: &mut Vec<Supposition>,
    mentions: &mut Vec<Span>,
) {
    if found.is_empty() {
        return;
    }
    let mut sentences = tokens
        .split_inclusive(|token| ends_sentence(source, token))
        .peekable();
    let mut before: &[Placed<'_>] = &[];
    // In the order of the text.
    let mut said = std::mem::take(found).into_iter().peekable();
    while let Some(sentence) = sentences.next() {
        let heading = std::mem::replace(&mut before, sentence);
        let mut own = Vec::new();
        if let Some((_, last)) = sentence.last() {
            while let Some(next) = said.next_if(|own| own.body.start < last.end) {
                own.push(next);
            }
        }
        if own.is_empty() {
            continue;
        }
        let denied = sentences.peek().copied().is_some_and(retracts);
        let disputed = denied || heads(heading) || disputes(sentence);
        // "Points above the line $y = 2 x$".
        let beside = |body: Span| {
            let before = sentence.partition_point(|(_, span)| span.end <= body.start);
            let near = &sentence[before.saturating_sub(MOST_BESIDE)..before];
            near.iter().any(|(token, _)| token.is_among(&BESIDE))
        };
        let is_taken_back = |own: &Supposition| {
            let supposes = supposes(own);
            // A length is positive whatever is said of it.
            let bounds = source.get(own.body.range()).is_some_and(is_bound);
            let taken = is_fact(own.kind) && disputed || supposes && denied;
            !bounds && (taken || (supposes || is_fact(own.kind)) && beside(own.body))
        };
        let ambiguous = ambiguous(source, &own);
        let is_ambiguous = |own: &Supposition| {
            supposes(own) && sides(source, own.body).is_some_and(|own| ambiguous.contains(own.0))
        };
        for own in own {
            match is_taken_back(&own) || is_ambiguous(&own) {
                false => found.push(own),
                true if is_no_meaning(&own) => mentions.push(own.body),
                true => {}
            }
        }
    }
    found.extend(said);
    sorted::sort(mentions);
}

/// Whether a sentence says of what it tells that others say it, or that it is to be shown. "The ratio $k = a/b$ is called the gain" only
/// gives a name.
fn disputes(sentence: &[Placed<'_>]) -> bool {
    let names = |at: usize| {
        among(sentence, at, &["called"])
            && follows(at, sentence, &["is", "are"])
            && among(sentence, at + 1, &["the", "a", "an"])
    };
    // "Continuity says $A V = a v$", and no student does.
    let is_law = |at: usize| {
        let before = at.checked_sub(1).map(|before| sentence[before].0);
        let subject = match before {
            Some(Token::Word(word)) => in_lower_case(word),
            _ => return false,
        };
        among(sentence, at, &["says"]) && SPEAKING.contains(&&*subject)
    };
    (0..sentence.len()).any(|at| among(sentence, at, &DISPUTING) && !names(at) && !is_law(at))
}

fn supposes(own: &Supposition) -> bool {
    use SuppositionKind::{Assume, Case, Figure, Let};
    matches!(own.kind, Case { .. } | Figure | Let | Assume)
}

/// The left sides to which a sentence supposes different right ones: "Let $y = x^3$ in the first case and $y = x^2$ in the second".
fn ambiguous<'a>(source: &'a str, said: &[Supposition]) -> Set<&'a str> {
    let mut first: Map<&str, &str> = Map::new();
    let mut found = Set::new();
    let supposed = said.iter().filter(|own| supposes(own));
    for (left, right) in supposed.filter_map(|own| sides(source, own.body)) {
        if *first.entry(left).or_insert_with(|| right) != right {
            found.insert(left);
        }
    }
    found
}

fn sides(source: &str, body: Span) -> Option<(&str, &str)> {
    let (left, right) = source.get(body.range())?.split_once('=')?;
    Some((left.trim(), right.trim()))
}

/// "Claim.": whether a sentence says what the next one is.
fn heads(sentence: &[Placed<'_>]) -> bool {
    let words = sentence
        .iter()
        .filter(|(token, _)| matches!(token, Token::Word(_)));
    words.take(3).count() <= 2 && sentence.iter().any(|(token, _)| token.is_among(&HEADING))
}

/// "This is wrong."
fn retracts(sentence: &[Placed<'_>]) -> bool {
    let mut tokens = sentence.iter().map(|(token, _)| token);
    begins_with(sentence, &REFERRING) && tokens.any(|token| token.is_among(&RETRACTING))
}
