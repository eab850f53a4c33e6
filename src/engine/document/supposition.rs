//! What prose supposes: "Let $v_1 = 0$", "taking $v'_2 \neq 0$", "At $\mu = 1$", "Setting $Q = 0$", "With $g = 10$ …",
//! "For $N = 3$, …", and what a symbol of a display means: "…, where $k = m \omega^2$".
//!
//! A supposition becomes a hypothesis of what follows, so one too many can make anything true.
//! In doubt nothing is read: not a conclusion drawn in the same sentence ("then", "gives"), not an
//! alternative ("or"), not a condition ("if"), not a negation, not a question, not a proof by contradiction. A value that is
//! named and not supposed is kept as a mention: where a step fails without it, the finding can say so.

use super::conclusion;
use super::prose::{Placed, Token};
use super::{Span, Supposition, SuppositionKind};

/// After these, too, a sentence no longer supposes.
const CONCLUDING: [&str; 20] = [
    "show",
    "shows",
    "have",
    "see",
    "whether",
    "us",
    "we",
    "want",
    "need",
    "because",
    "since",
    "derivative",
    "gradient",
    "logarithm",
    "limit",
    "difference",
    "sum",
    "average",
    "square",
    "equation",
];
/// With these, a sentence supposes nothing that could be used.
const DOUBTFUL: [&str; 19] = [
    "or",
    "either",
    "if",
    "unless",
    "contradiction",
    "contradicts",
    "contrary",
    "otherwise",
    "example",
    "instance",
    "wrong",
    "wrongly",
    "false",
    "fails",
    "fail",
    "violates",
    "violated",
    "impossible",
    "absurd",
];
/// With these besides, a sentence supposes nothing by a mere "with" or "where": they may deny what it names.
const DENYING: [&str; 9] = [
    "not", "never", "no", "cannot", "neither", "nor", "would", "were", "without",
];
/// Before these, a value is named: supposed or not.
const NAMING: [&str; 20] = [
    "with",
    "where",
    "for",
    "when",
    "at",
    "if",
    "since",
    "because",
    "as",
    "while",
    "setting",
    "putting",
    "taking",
    "inserting",
    "substituting",
    "using",
    "letting",
    "choosing",
    "case",
    "let",
];
/// Before these, an introductory word means its opposite.
const NEGATING: [&str; 8] = [
    "not", "without", "never", "cannot", "nor", "don", "can", "needn",
];
/// Words between "taking" and what is taken: "taking the non-trivial solution $…$".
const PATIENCE: usize = 6;

/// How many words may stand between "for" and what it supposes.
const MOST_DESCRIBING: usize = 3;

/// How far a supposition reaches.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Reach {
    /// "Let", "Assume" as the verb of the sentence: all of it.
    Sentence,
    /// "…, taking $…$ and $…$, …": what is joined to it.
    Joined {
        /// Words that may still come before the first.
        patience: usize,
        /// A comma has just been read.
        comma: bool,
        /// Something has been supposed.
        found: bool,
        /// "At $…$": a comma ends it.
        short: bool,
    },
}

/// The suppositions in prose, in order, and the values that it names besides.
pub(super) fn read(source: &str, tokens: &[Placed<'_>]) -> (Vec<Supposition>, Vec<Span>) {
    let mut found: Vec<Supposition> = Vec::new();
    let mut mentions: Vec<Span> = Vec::new();
    let mut named = false;
    let mut sentence = 0;
    let mut begun = false;
    let mut doubtful = false;
    let mut active: Option<(SuppositionKind, Reach)> = None;
    // Something in the sentence is introduced by no verb, but by "with" or "where".
    let mut careful = false;
    for (index, &(token, span)) in tokens.iter().enumerate() {
        match token {
            Token::Stop => {
                if source.get(span.range()) == Some("?") {
                    mentions.extend(found.drain(sentence..).map(|s| s.body));
                }
                (named, careful) = (false, false);
                (sentence, begun, doubtful, active) = (found.len(), false, false, None);
                continue;
            }
            Token::Word(word) => {
                let word = word.to_lowercase();
                let denies = careful && DENYING.contains(&word.as_str());
                if denies || DOUBTFUL.contains(&word.as_str()) {
                    mentions.extend(found.drain(sentence..).map(|s| s.body));
                    doubtful = true;
                }
                let concludes = || conclusion::draws(&word) || CONCLUDING.contains(&word.as_str());
                if doubtful || active.is_some() && concludes() {
                    active = None;
                } else if let Some(introduced) = introduction(source, &word, index, tokens, begun) {
                    active = Some(introduced);
                    careful = matches!(&*word, "with" | "where")
                        || begun && matches!(&*word, "for" | "when" | "since" | "as");
                } else if let Some((kind, reach)) = active {
                    active = reach.past_word(&word).map(|reach| (kind, reach));
                }
                named = NAMING.contains(&word.as_str()) || named && word == "and";
                begun = true;
            }
            Token::Math(body) => {
                begun = true;
                let text = source.get(body.range()).unwrap_or_default();
                if let Some((kind, reach)) = active {
                    if relates(text) {
                        found.push(Supposition { kind, body });
                        named = false;
                    }
                    active = reach.past_math(relates(text)).map(|reach| (kind, reach));
                }
                if named && relates(text) {
                    mentions.push(body);
                }
            }
            Token::Mark(',') => {
                if let Some((kind, reach)) = active {
                    active = reach.past_comma().map(|reach| (kind, reach));
                }
            }
            // A bullet or an emphasis before the first word is nothing; inside, a mark ends a phrase.
            _ => {
                if matches!(active, Some((_, Reach::Joined { .. }))) && token != Token::Dash {
                    active = None;
                }
            }
        }
    }
    mentions.sort();
    (found, mentions)
}

/// The supposition that the word at `index` introduces.
fn introduction(
    source: &str,
    word: &str,
    index: usize,
    tokens: &[Placed<'_>],
    begun: bool,
) -> Option<(SuppositionKind, Reach)> {
    let after = |by: usize| tokens.get(index + by).map(|(token, _)| *token);
    let direct = matches!(after(1), Some(Token::Math(_)));
    let that = matches!(after(1), Some(Token::Word("that")));
    let comma = matches!(after(2), Some(Token::Mark(',')));
    let text = |body: Span| source.get(body.range()).unwrap_or_default();
    let next = |is: fn(&str) -> bool| match after(1) {
        Some(Token::Math(body)) => is(text(body)),
        _ => false,
    };
    let value = || next(is_value);
    // "For equal springs $k_1 = k_2$, …"
    let described = || {
        let words = |token: &&Placed<'_>| matches!(token.0, Token::Word(_));
        let rest = tokens.get(index + 1..).unwrap_or_default();
        let between = rest.iter().take(MOST_DESCRIBING).take_while(words).count();
        match rest.get(between..between + 2) {
            Some([(Token::Math(body), _), (Token::Mark(','), _)]) => is_value(text(*body)),
            _ => false,
        }
    };
    let negated = || {
        let before = index.checked_sub(1).and_then(|before| tokens.get(before));
        matches!(before, Some((Token::Word(word), _))
            if NEGATING.contains(&word.to_lowercase().as_str()))
    };
    let capital =
        matches!(tokens[index].0, Token::Word(word) if word.starts_with(char::is_uppercase));
    // In the middle of a sentence that only a display can have begun.
    let goes_on = || {
        let comma = |token: &Placed<'_>| matches!(token.0, Token::Mark(',' | ';'));
        !capital && tokens[..index].iter().all(comma)
    };
    let joined = |short| Reach::Joined {
        patience: PATIENCE,
        comma: false,
        found: false,
        short,
    };
    let introduced = match word {
        "let" if !begun || direct => Some((SuppositionKind::Let, Reach::Sentence)),
        "at" if !begun && direct => Some((SuppositionKind::Let, joined(true))),
        // "For $N = 3$ the values are …" tells of an example; a comma sets a case.
        "for" | "when" if !begun && comma && value() => Some((SuppositionKind::Let, joined(true))),
        "for" if !begun && described() => Some((SuppositionKind::Let, joined(true))),
        "case" if comma && value() => Some((SuppositionKind::Let, joined(true))),
        // That something is not 0 is no value that something could be made true with.
        "for" | "when" | "where" | "since" | "as" | "with" if next(is_nonzero) && !goes_on() => {
            Some((SuppositionKind::Let, joined(true)))
        }
        "setting" if !begun && value() => Some((SuppositionKind::Let, joined(true))),
        "with" if !begun && capital && value() => Some((SuppositionKind::Let, joined(true))),
        "where" | "with" | "for" if (value() || next(is_bound)) && goes_on() => {
            Some((SuppositionKind::Define, Reach::Sentence))
        }
        "assume" | "suppose" if !begun => Some((SuppositionKind::Assume, Reach::Sentence)),
        "assume" | "suppose" | "assuming" | "supposing" | "taking" => {
            Some((SuppositionKind::Assume, joined(false)))
        }
        "provided" if direct || that => Some((SuppositionKind::Assume, joined(false))),
        "given" if that => Some((SuppositionKind::Assume, joined(false))),
        _ => None,
    };
    introduced.filter(|_| !negated())
}

impl Reach {
    fn past_word(self, word: &str) -> Option<Reach> {
        let Reach::Joined {
            patience,
            found,
            short,
            ..
        } = self
        else {
            return Some(self);
        };
        let patience = patience.checked_sub(1)?;
        let joins = matches!(word, "and" | "that" | "both" | "also");
        (joins || !found).then_some(Reach::Joined {
            patience,
            comma: false,
            found,
            short,
        })
    }

    fn past_math(self, relation: bool) -> Option<Reach> {
        Some(match self {
            Reach::Joined {
                patience,
                found,
                short,
                ..
            } => Reach::Joined {
                patience,
                comma: false,
                found: found || relation,
                short,
            },
            Reach::Sentence => self,
        })
    }

    fn past_comma(self) -> Option<Reach> {
        match self {
            Reach::Sentence => Some(self),
            Reach::Joined {
                found,
                short,
                comma,
                ..
            } if !found || short || comma => None,
            Reach::Joined {
                patience,
                found,
                short,
                ..
            } => Some(Reach::Joined {
                patience,
                comma: true,
                found,
                short,
            }),
        }
    }
}

/// Whether inline math is one equation. "For $x > 0$, … For $x < 0$, …" goes through cases: neither holds from there on.
fn is_value(math: &str) -> bool {
    relates(math) && math.matches('=').count() == 1 && !relates(&math.replace('=', " "))
}

/// Whether inline math is one inequality, which bounds what it speaks of.
fn is_bound(math: &str) -> bool {
    relates(math) && !math.contains('=')
}

/// Whether inline math says that something is not 0.
fn is_nonzero(math: &str) -> bool {
    let not = ["\\neq", "\\ne", "≠"]
        .iter()
        .find_map(|sign| math.split_once(sign));
    not.is_some_and(|(left, right)| !relates(left) && right.trim() == "0")
}

/// Whether inline math states a relation, and no inference: a relation sign outside braces.
fn relates(math: &str) -> bool {
    let mut depth = 0_usize;
    let mut relation = false;
    let mut chars = math.char_indices();
    while let Some((at, c)) = chars.next() {
        match c {
            '{' => depth += 1,
            '}' => depth = depth.saturating_sub(1),
            '=' | '<' | '>' | '≠' | '≤' | '≥' | '⩽' | '⩾' => relation |= depth == 0,
            '⇒' | '⇔' => return false,
            '\\' => {
                let name = &math[at + 1..];
                let name = &name[..name
                    .find(|c: char| !c.is_ascii_alphabetic())
                    .unwrap_or(name.len())];
                match name {
                    "neq" | "ne" | "le" | "leq" | "ge" | "geq" | "lt" | "gt" | "leqslant"
                    | "geqslant" => relation |= depth == 0,
                    "Rightarrow" | "implies" | "iff" | "Leftrightarrow" | "therefore" => {
                        return false;
                    }
                    "left" | "right" => drop(chars.nth(name.len())),
                    "" => drop(chars.next()),
                    _ => {}
                }
            }
            _ => {}
        }
    }
    relation
}
