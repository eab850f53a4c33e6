//! What is said to be zero, or to have a value, and not written as an equation: "Setting the derivative to zero gives", "which vanishes at
//! $x = a$", "It must be equal to one, so", "Equating (1) and (2)".
//!
//! A sentence that leads on to a display and puts such a condition in words that are not understood is kept as that: what does not
//! follow may follow from it.

use super::super::conclusion;
use super::super::prose::{Placed, Token, among, begins_with, lead};
use super::super::words::Words;
use super::super::{Span, Supposition, SuppositionKind, Vanishing};
use super::around::follows;
use super::mathematics::{is_slope, is_value, says_zero, stated, text};
use super::neglected;
use super::resting;
use super::stationary;
use super::words::{DENYING, DOUBTFUL};

/// In a longer sentence nothing is looked for that stands in its middle.
const LONGEST: usize = 200;
/// How many tokens may stand between "setting" or "the derivative" and "zero".
const MOST_BETWEEN: usize = 8;
/// These set something to a value.
const SETTING: &[&str] = &["setting", "set", "putting", "put", "equating", "equate"];
/// These set two things equal without a word that says so.
const EQUATING: &[&str] = &["equating", "equate"];
/// What is differentiated has one of these.
const SLOPES: &[&str] = &["derivative", "slope", "gradient"];
/// Something is said to be by one of these of it.
const VALUES: &[&str] = &["value", "values", "expression"];
/// A sentence with one of these is about a state that lasts.
const AT_REST: &[&str] = &["equilibrium", "equilibria", "steady", "stationary"];
/// These are numbers.
const NUMBERS: &[&str] = &["one", "unity", "zero", "nought"];
/// Of these several stand in an equation: which are set equal is not said by what is cited.
static PARTS: Words = Words::of(&[
    "coefficient",
    "coefficients",
    "power",
    "powers",
    "term",
    "terms",
    "part",
    "parts",
    "component",
    "components",
    "exponents",
    "degrees",
    "factors",
    "derivative",
    "derivatives",
    "slopes",
    "difference",
    "sum",
    "product",
]);
/// What is zero or has a value is said with one of these, or with a "0".
static PUTTING: Words = Words::of(&[
    "over",
    "respect",
    "setting",
    "set",
    "putting",
    "put",
    "equating",
    "equate",
    "vanish",
    "vanishes",
    "zero",
    "nought",
    "equal",
    "equals",
    "be",
    "neglecting",
    "ignoring",
    "neglect",
    "ignore",
    "negligible",
    "neglected",
    "ignored",
]);
/// A sentence in which a pronoun is the quantity of the display before it begins with one of these, or with the pronoun.
const BEFORE_PRONOUN: &[&str] = &[
    "at", "in", "for", "on", "since", "because", "as", "but", "and", "now", "there", "here",
    "which",
];
/// No longer sentence leads on from the one before that puts the condition: "Hence", "With (2) this means".
const MOST_LEADING_ON: usize = 6;

/// What prose says to be zero, or to have a value, in order.
pub(super) fn read(source: &str, tokens: &[Placed<'_>]) -> Vec<Supposition> {
    let mut found = Vec::new();
    let sentences: Vec<&[Placed<'_>]> = tokens
        .split(|(token, _)| token.is_stop())
        .map(|sentence| &sentence[lead(sentence)..])
        .filter(|sentence| !sentence.is_empty())
        .collect();
    let puts = |(token, _): &Placed<'_>| token.is_among(&PUTTING) || says_zero(source, *token);
    for (number, &sentence) in sentences.iter().enumerate() {
        // What leads on to a display is said of it.
        let leads = sentence.as_ptr_range().end == tokens.as_ptr_range().end;
        // Most sentences say nothing of the kind.
        if !sentence.iter().any(puts) {
            found.extend(resting::read(source, sentence, leads));
            continue;
        }
        // "The field vanishes at the centre. Differentiating (2)," gives the slope everywhere.
        let next_leads = |next: &&[Placed<'_>]| {
            next.as_ptr_range().end == tokens.as_ptr_range().end
                && next.len() <= MOST_LEADING_ON
                && !among(next, 0, &["differentiating"])
        };
        let leads_over = leads || sentences.get(number + 1).is_some_and(next_leads);
        // "with $a > 0$. This vanishes": before it is the display.
        let is_first = number == 0 || number == 1 && is_tail(sentences[0]);
        if leads_over {
            let slopes = stationary::read(source, sentence);
            if !slopes.is_empty() {
                found.extend(slopes);
                continue;
            }
        }
        let named = || leads.then(|| named(sentence)).flatten();
        let own = equated(source, sentence)
            .or_else(|| asserted(source, sentence, is_first, leads))
            .or_else(|| set(source, sentence))
            .or_else(|| neglected::read(source, sentence))
            .or_else(named);
        let own = own.filter(|own| {
            let vanishes = matches!(own.kind, SuppositionKind::Vanishes(_));
            !vanishes || !is_said_in_symbols(source, sentence)
        });
        found.extend(own.iter().flat_map(|first| also_set(sentence, first)));
        match own {
            Some(mut own) => {
                if let SuppositionKind::Vanishes(what) = own.kind
                    && (0..sentence.len()).any(|at| among(sentence, at, AT_REST))
                {
                    own.kind = SuppositionKind::StandsStill(what);
                }
                found.push(own);
            }
            None => {
                let relative = match number {
                    0 => of_display(source, sentence, leads),
                    _ => Vec::new(),
                };
                if leads_over && relative.is_empty() {
                    found.extend(not_understood(source, sentence));
                }
                found.extend(relative);
            }
        }
    }
    found
}

/// Whether a sentence is the end of one that a display stands in.
fn is_tail(sentence: &[Placed<'_>]) -> bool {
    matches!(sentence.first(), Some((Token::Word(word), _)) if word.starts_with(char::is_lowercase))
}

/// Whether the token at a place denies or doubts what the sentence says.
fn is_doubtful(sentence: &[Placed<'_>], at: usize) -> bool {
    // "If we set the derivative to zero, we find" does so.
    let set_by_us = || among(sentence, at, &["if"]) && among(sentence, at + 1, &["we"]);
    // "which leads to" draws a conclusion.
    let draws = || among(sentence, at, &["leads"]) && among(sentence, at + 1, &["to"]);
    among(sentence, at, &DENYING) && !draws() || among(sentence, at, &DOUBTFUL) && !set_by_us()
}

fn is_sure(sentence: &[Placed<'_>]) -> bool {
    !(0..sentence.len()).any(|at| is_doubtful(sentence, at))
}

/// "Setting $F$ to zero", "Setting the derivative equal to zero", "where the derivative vanishes".
fn set(source: &str, sentence: &[Placed<'_>]) -> Option<Supposition> {
    let zero = (0..sentence.len()).find(|&at| says_zero(source, sentence[at].0))?;
    if !is_sure(sentence) {
        return None;
    }
    let near = zero.saturating_sub(MOST_BETWEEN)..zero;
    let slope = near.clone().find(|&at| {
        among(sentence, at, SLOPES) && !follows(at, sentence, &["second", "third", "higher"])
    });
    let sets = near.clone().find(|&at| among(sentence, at, SETTING));
    let (what, body) = match (sets, slope) {
        // "Setting the derivative (1) to zero" names it; "the derivative of (1)" is of what (1) gives.
        (_, Some(slope)) => match by_number(sentence, slope + 1) {
            Some(at) => (Vanishing::Cited, sentence[at].1),
            None => (Vanishing::Slope, sentence[slope].1),
        },
        (Some(sets), None) => {
            let own = (sets + 1..zero).find_map(|at| {
                let side = side(sentence, at).map(|own| (own, at));
                side.or_else(|| Some((thing(sentence, at)?, at)))
            });
            // "Setting the variation of (9) to zero" sets something else.
            let is_of = |at: usize| {
                among(sentence, at - 1, &["of"]) && !among(sentence, at.saturating_sub(2), VALUES)
            };
            if own.is_some_and(|((what, _), at)| {
                matches!(what, Vanishing::Cited | Vanishing::Term) && is_of(at)
            }) {
                return None;
            }
            let what = own
                .map(|own| own.0)
                // "Set equal to zero:"
                .or_else(|| (sets == 0).then_some((Vanishing::Display, sentence[sets].1)));
            match (what, result_of_differentiating(sentence, sets)) {
                (None | Some((Vanishing::Display, _)), Some(slope)) => (Vanishing::Slope, slope),
                (what, _) => what?,
            }
        }
        (None, None) => return None,
    };
    let kind = SuppositionKind::Vanishes(what);
    Some(Supposition { kind, body })
}

/// "Differentiating (1) and setting the result to zero" sets the derivative to zero.
fn result_of_differentiating(sentence: &[Placed<'_>], sets: usize) -> Option<Span> {
    const DIFFERENTIATING: &[&str] = &["differentiating", "differentiate", "differentiation"];
    let mut before = 0..sets;
    let at = before.find(|&at| among(sentence, at, DIFFERENTIATING))?;
    Some(sentence[at].1)
}

/// What is set to the same in one go: "Setting (4) and (5) to zero".
fn also_set(sentence: &[Placed<'_>], first: &Supposition) -> Vec<Supposition> {
    let SuppositionKind::Vanishes(what @ (Vanishing::Cited | Vanishing::Term)) = first.kind else {
        return Vec::new();
    };
    let is_first = |at: &usize| thing(sentence, *at) == Some((what, first.body));
    let Some(mut at) = (0..sentence.len()).find(is_first) else {
        return Vec::new();
    };
    let mut found = Vec::new();
    loop {
        let joins = |at: usize| {
            among(sentence, at, &["and"]) || sentence.get(at).is_some_and(|own| own.0.is_mark(','))
        };
        let next = at + 1 + (at + 1..sentence.len()).take_while(|&at| joins(at)).count();
        match thing(sentence, next).filter(|own| own.0 == what && next > at + 1) {
            Some((_, body)) => found.push(Supposition {
                kind: first.kind,
                body,
            }),
            None => return found,
        }
        at = next;
    }
}

/// Where the number stands by which the equation is known that a word before speaks of: "the derivative (1)", "the slope in (1)".
fn by_number(sentence: &[Placed<'_>], after: usize) -> Option<usize> {
    let words = &["in", "from", "given", "by", "equation", "eq"];
    let at = (after..sentence.len()).find(|&at| !among(sentence, at, words))?;
    cites(sentence, at).then_some(at)
}

fn cites(sentence: &[Placed<'_>], at: usize) -> bool {
    sentence.get(at).is_some_and(|(token, _)| token.cites())
}

/// What a token is that names something with a value: mathematics, a pronoun, a number of an equation.
fn thing(sentence: &[Placed<'_>], at: usize) -> Option<(Vanishing, Span)> {
    let (token, span) = *sentence.get(at)?;
    Some(match token {
        Token::Math(body) => (Vanishing::Term, body),
        Token::Word("this" | "it" | "This" | "It") => (Vanishing::Display, span),
        Token::Tag(_) | Token::Keys(_) => (Vanishing::Cited, span),
        _ => return None,
    })
}

/// "The right-hand side of (1)", "its left side", where the token is "left" or "right".
fn side(sentence: &[Placed<'_>], at: usize) -> Option<(Vanishing, Span)> {
    let what = match () {
        () if among(sentence, at, &["left", "lefthand"]) => Vanishing::LeftSide,
        () if among(sentence, at, &["right", "righthand"]) => Vanishing::RightSide,
        () => return None,
    };
    let end = end_of_side(sentence, at)?;
    Some((what, sentence[end - 1].1))
}

/// Where the words end that name a side, with the equation that it is of.
fn end_of_side(sentence: &[Placed<'_>], at: usize) -> Option<usize> {
    let dash = |at: usize| matches!(sentence.get(at), Some((Token::Dash, _)));
    let mut at = at + 1;
    at += usize::from(dash(at));
    at += usize::from(among(sentence, at, &["hand"]));
    if !among(sentence, at, &["side", "sides"]) {
        return None;
    }
    at += 1;
    if among(sentence, at, &["of", "in"]) {
        let named = (at + 1..sentence.len())
            .find(|&at| !among(sentence, at, &["the", "this", "last", "equation", "eq"]))?;
        let refers = among(sentence, named - 1, &["this", "equation"]) && named > at + 1;
        return match cites(sentence, named) {
            true => Some(named + 1),
            // "of this equation"
            false => refers.then_some(named),
        };
    }
    Some(at)
}

/// "Equating (1) and (2)", "Setting (1) equal to $m g$", "Equating the two expressions".
fn equated(source: &str, sentence: &[Placed<'_>]) -> Option<Supposition> {
    let sets = (0..sentence.len()).find(|&at| among(sentence, at, SETTING))?;
    if !is_sure(sentence) {
        return None;
    }
    let equates = among(sentence, sets, EQUATING);
    let mut things: Vec<(Vanishing, Span)> = Vec::new();
    let (mut says_equal, mut sides) = (equates, None);
    for at in sets + 1..sentence.len() {
        match sentence[at].0 {
            token if says_zero(source, token) => return None,
            Token::Word(_) if among(sentence, at, &["equal"]) => says_equal = true,
            token @ Token::Word(_) => {
                let ends = among(sentence, at, &["into", "in", "for", "we", "then", "where"]);
                if ends || conclusion::draws_on(token) {
                    break;
                }
                if token.is_among(&PARTS) {
                    return None;
                }
                // "Equating the right-hand sides of (1) and (2)"
                let side = side(sentence, at).map(|own| own.0);
                sides = side.or(sides);
                if among(sentence, at, &["two", "both"]) && things.is_empty() {
                    let span = sentence[at].1;
                    things = vec![(Vanishing::Previous, span), (Vanishing::Display, span)];
                }
            }
            Token::Mark(_) => break,
            _ => {}
        }
        // "Setting this equal to one"
        let value = || value_at(source, sentence, at).filter(|_| things.len() == 1 && says_equal);
        let own = thing(sentence, at).or_else(value);
        things.extend(own);
    }
    // "Equating both (1) and (2)"
    if things.len() == 4 {
        things.drain(..2);
    }
    let [(what, body), (to, value)] = things[..] else {
        return None;
    };
    let of_side = |own: Vanishing| match (own, sides) {
        (Vanishing::Cited, Some(side)) => side,
        _ => own,
    };
    says_equal.then_some(Supposition {
        kind: SuppositionKind::Equals(of_side(what), of_side(to), value),
        body,
    })
}

/// "It must be equal to one, so", "the right-hand side of (1) vanishes", "(1) is zero for".
fn asserted(
    source: &str,
    sentence: &[Placed<'_>],
    is_first: bool,
    leads: bool,
) -> Option<Supposition> {
    if sentence.len() > LONGEST || !is_sure(sentence) {
        return None;
    }
    (0..sentence.len()).find_map(|at| {
        let (what, body, after) = match side(sentence, at) {
            Some((what, body)) => (what, body, end_of_side(sentence, at)?),
            None => {
                let (what, body) = match among(sentence, at, &["which"]) {
                    true => (Vanishing::Display, sentence[at].1),
                    false => thing(sentence, at)?,
                };
                (what, body, at + 1)
            }
        };
        let is_pronoun = what == Vanishing::Display;
        let (must, value) = verb(sentence, after)?;
        if conclusion::read(&sentence[..at]) == Some(true) {
            return None;
        }
        // "Half of the maximum is reached when this equals $1/2$, so": the words before it are about something else.
        let when = leads && at > 0 && among(sentence, at - 1, &["when", "where", "once"]);
        let refers = is_first && (at == 0 || when || begins_with(sentence, BEFORE_PRONOUN));
        if is_pronoun && !refers {
            return None;
        }
        let leads_where = |at: usize| among(sentence, at, WHERE);
        match says_zero(source, sentence.get(value)?.0) {
            // "$v$ is zero" tells of a moment what others read; where "it" is zero, may come after it.
            true if !must && what == Vanishing::Term && !is_worked_out(source, sentence, at) => {
                None
            }
            true if !must && among(sentence, at, &["which"]) => None,
            true if is_pronoun && leads_where(value + 1) && value + 2 < sentence.len() => None,
            true => Some(Supposition {
                kind: SuppositionKind::Vanishes(what),
                body,
            }),
            // "This is $1/2$" may be what comes of it, "This equals $1/2$ for" says where.
            false if must || is_pronoun && (when || leads_to_where(sentence, value)) => {
                let (to, value) = value_at(source, sentence, value)?;
                let kind = SuppositionKind::Equals(what, to, value);
                Some(Supposition { kind, body })
            }
            false => None,
        }
    })
}

/// Whether the mathematics at a place is a slope, or says what it is that vanishes there: "a maximum where $dm/dn = 1 - n$ vanishes".
fn is_worked_out(source: &str, sentence: &[Placed<'_>], at: usize) -> bool {
    let leads = at > 0 && among(sentence, at - 1, &["where", "when", "if", "once", "which"]);
    let is_such = |own: &str| own.contains('=') || is_slope(own) || own.contains("\\frac{d");
    leads
        && matches!(sentence[at].0, Token::Math(body) if source.get(body.range()).is_some_and(is_such))
}

/// Whether a sentence ends after the value at a place with a word that says where that is: "This equals $1/2$ for".
fn leads_to_where(sentence: &[Placed<'_>], value: usize) -> bool {
    among(sentence, value + 1, &["for", "at", "when"]) && sentence.len() == value + 2
}

/// Whether the words that begin at a place say what must be, "must be equal to", "has to equal", and where the value stands that they lead to.
fn verb(sentence: &[Placed<'_>], at: usize) -> Option<(bool, usize)> {
    let says = |at: usize, words: &[&str]| among(sentence, at, words);
    let skip = |at: usize, words: &[&str]| at + usize::from(says(at, words));
    let at = skip(at, &["also", "then", "now", "again", "therefore"]);
    if says(at, &["vanishes", "vanish"]) {
        return Some((false, at));
    }
    let (must, at) = match () {
        () if says(at, &["must", "should", "shall"]) => (true, at + 1),
        () if says(at, &["has", "have", "needs", "need", "is", "ought"])
            && says(at + 1, &["to"]) =>
        {
            (true, at + 2)
        }
        () => (false, at),
    };
    if must {
        let at = skip(at, &["also", "then", "now", "again"]);
        return match () {
            () if says(at, &["vanish"]) => Some((true, at)),
            () if says(at, &["equal"]) => Some((true, at + 1)),
            () if says(at, &["be"]) && says(at + 1, &["equal"]) && says(at + 2, &["to"]) => {
                Some((true, at + 3))
            }
            () if says(at, &["be"]) => Some((true, at + 1)),
            () => None,
        };
    }
    let (linked, equal) = (says(at, &["is", "are"]), says(at, &["equals"]));
    let to = says(at + 1, &["equal"]) && says(at + 2, &["to"]);
    match () {
        () if linked && to => Some((false, at + 3)),
        () if linked || equal => Some((false, at + 1)),
        () => None,
    }
}

/// The value that stands at a place: a term, a number, "one", or what an equation is of that is cited.
fn value_at(source: &str, sentence: &[Placed<'_>], at: usize) -> Option<(Vanishing, Span)> {
    let (token, span) = *sentence.get(at)?;
    match token {
        token if stated(source, token).is_some() => None,
        Token::Number(number) if number.bytes().all(|b| b.is_ascii_digit()) => {
            Some((Vanishing::Term, span))
        }
        Token::Word(_) if among(sentence, at, NUMBERS) => Some((Vanishing::Term, span)),
        Token::Word(_) => None,
        _ => thing(sentence, at),
    }
}

/// With one of these a sentence ends that a display says where of.
const WHERE: &[&str] = &["for", "at", "if", "when", "where"];

/// "At the highest point the velocity vanishes, so": what has a name, and is not concluded to be zero.
fn named(sentence: &[Placed<'_>]) -> Option<Supposition> {
    let zero = (1..sentence.len()).find(|&at| {
        among(sentence, at, &["vanishes", "vanish"])
            || among(sentence, at, &["is", "are", "becomes"])
                && among(sentence, at + 1, &["zero", "nought"])
    })?;
    let before = &sentence[..zero];
    let (Token::Word(noun), body) = sentence[zero - 1] else {
        return None;
    };
    let is_noun = zero >= 2 && among(sentence, zero - 2, &["the", "its", "their"]);
    let is_display = among(sentence, zero - 1, &["this", "it"]);
    // "This vanishes for".
    let says_zero = zero + usize::from(!among(sentence, zero, &["vanishes", "vanish"]));
    let leads = || among(sentence, says_zero + 1, WHERE) && sentence.len() == says_zero + 2;
    let says = match is_display {
        true => leads(),
        false => is_noun && noun.bytes().all(|b| b.is_ascii_lowercase()),
    };
    if !says || !is_sure(sentence) || conclusion::read(before) == Some(true) {
        return None;
    }
    let kind = SuppositionKind::Vanishes(match is_display {
        true => Vanishing::Display,
        false => Vanishing::Named,
    });
    Some(Supposition { kind, body })
}

/// "…, which vanishes at $x = a$" after a display, "It vanishes at $x = a$, so" before another; also "which is zero when", before one.
fn of_display(source: &str, sentence: &[Placed<'_>], leads: bool) -> Vec<Supposition> {
    let words = |(token, _): &Placed<'_>| !matches!(token, Token::Mark(',' | ';'));
    let Some(first) = sentence.iter().position(words) else {
        return Vec::new();
    };
    let says = |at: usize, words: &[&str]| among(sentence, first + at, words);
    let after = match () {
        () if !(says(0, &["which"]) || leads && says(0, &["it", "this"])) => {
            return Vec::new();
        }
        () if says(1, &["vanishes"]) => 2,
        () if says(1, &["is", "becomes"]) && says(2, &["zero"]) => 3,
        () => return Vec::new(),
    };
    // "which is zero at $s = 2 f$, where" sets a case.
    let goes_on = among(sentence, sentence.len() - 1, &["where"]);
    if !says(after, &["at", "when", "where", "for"])
        || goes_on && after + 1 < sentence.len() - first
    {
        return Vec::new();
    }
    let (_, span) = sentence[first];
    let kind = SuppositionKind::Vanishes(Vanishing::Told);
    let mut found = vec![Supposition { kind, body: span }];
    match sentence.get(first + after + 1) {
        Some(&(Token::Math(body), _)) if is_value(text(source, body)) => {
            let kind = SuppositionKind::Fact {
                runs_on: true,
                of_case: true,
            };
            found.push(Supposition { kind, body });
            found
        }
        // "which is zero when" leads to where.
        None => found,
        Some(_) => Vec::new(),
    }
}

/// Whether a sentence goes on with what vanishes in symbols: "the flux vanishes everywhere, $J = 0$".
fn is_said_in_symbols(source: &str, rest: &[Placed<'_>]) -> bool {
    rest.windows(2).any(|pair| match pair {
        [(comma, _), (Token::Math(body), _)] if comma.is_mark(',') => {
            let text = source.get(body.range()).unwrap_or_default().trim_end();
            text.ends_with("= 0") || text.ends_with("=0")
        }
        _ => false,
    })
}

/// What a sentence puts as a condition in words, where these are not understood: "Both sides vanish", "Equating coefficients".
fn not_understood(source: &str, sentence: &[Placed<'_>]) -> Option<Supposition> {
    let says = |at: usize, words: &[&str]| among(sentence, at, words);
    let mut tokens = sentence.iter();
    let is_written = tokens.any(|(token, _)| stated(source, *token).is_some());
    let denies = (0..sentence.len()).any(|at| {
        says(
            at,
            &[
                "not", "never", "cannot", "nowhere", "neither", "nor", "none", "no",
            ],
        )
    });
    if is_written || denies {
        return None;
    }
    const BEING: &[&str] = &["is", "are", "be", "being", "becomes", "become"];
    let puts = |at: usize| {
        let zero = || says_zero(source, sentence[at].0) && !says(at, &["vanish", "vanishes"]);
        let after = |words: &[&str]| follows(at, sentence, words);
        let last = at + 1 == sentence.len();
        says(at, &["vanish", "vanishes"])
            || zero() && (after(BEING) || after(&["to", "equals", "equal"]))
            || says(at, EQUATING)
            || says(at, &["equals"]) && !last
            || says(at, &["equal"])
                && after(BEING)
                && !(says(at + 1, &["to"]) && at + 2 == sentence.len())
    };
    let sets = (0..sentence.len()).find(|&at| says(at, SETTING));
    let set_equal = |at: usize| says(at, &["equal"]) && sets.is_some_and(|sets| sets < at);
    let at = (0..sentence.len()).find(|&at| puts(at) || set_equal(at))?;
    // What comes after "so" is concluded.
    let draws = |(token, _): &Placed<'_>| conclusion::draws_on(*token);
    if sentence[..at].iter().any(draws) {
        return None;
    }
    let clause = |(token, _): &Placed<'_>| matches!(token, Token::Mark(',' | ';' | ':'));
    let begin = sentence[..at].iter().rposition(clause);
    let end = sentence[at..].iter().position(clause);
    let begin = begin.map_or(0, |comma| comma + 1);
    let end = end.map_or(sentence.len(), |comma| at + comma);
    let body = sentence[begin].1.to(sentence[end - 1].1);
    let kind = SuppositionKind::Unread;
    Some(Supposition { kind, body })
}
