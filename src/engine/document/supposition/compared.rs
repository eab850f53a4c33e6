//! Cases put in words: "If $x$ is negative, then", "For positive $q$ we get", "When $m_1$ exceeds $m_2$,", "*Negative $x$.*".
//!
//! Such a sentence leads on to a display, supposes something, or is no more than the name of the case. What it says in a sentence that
//! comes to its end is told of that sentence alone.

use super::super::prose::{Placed, Token, lead};
use super::super::words::Words;
use super::super::{Span, Supposition, SuppositionKind};
use super::cases::{self, COMPARED};
use super::denial::DENIALS;
use super::introduction::goes_on_then;
use super::words::DISPUTING;
use crate::algebra::Relation;

/// These begin a clause that says what is so in a case: "If $x$ is negative".
const BEFORE_CLAUSE: &[&str] = &["if", "when", "whenever", "once", "should", "were"];
/// These suppose what the clause after them says, and what comes in other sentences is said of that.
const SUPPOSING: &[&str] = &["suppose", "assume", "let"];
/// These may stand between that and the clause: "Suppose now that".
const AFTER_SUPPOSING: &[&str] = &["that", "now", "next", "first", "then", "instead", "also"];
/// These begin a sentence about a kind of thing: "For positive $x$".
const BEFORE_KIND: &[&str] = &["for", "with", "taking", "choosing"];
/// With one of these a sentence goes on from the case before: "whereas if", "Yet for".
const JOINING: &[&str] = &[
    "and",
    "or",
    "but",
    "yet",
    "while",
    "whereas",
    "else",
    "similarly",
    "likewise",
    "conversely",
    "however",
    "instead",
];
/// What comes after the name of a case: "For negative $x$ this is".
const GOING_ON: &[&str] = &[
    "this", "we", "one", "it", "then", "the", "equation", "and", "but", "so", "they", "that",
];
/// Words between "if" and what is spoken of: "If the charge $q$ is negative".
const MOST_DESCRIBING: usize = 3;
/// These stand between what is spoken of and what is said of it.
const LINKING: &[&str] = &[
    "is", "are", "be", "was", "were", "becomes", "become", "turns", "turn", "gets", "get",
    "remains", "remain", "stays", "stay", "goes",
];
/// These may stand before a kind of thing.
const ARTICLES: &[&str] = &["a", "an", "the", "any", "every", "all", "some"];
/// So many things are said to be greater than nought at once.
const MOST_LISTED: usize = 4;
/// No more tokens stand before what a case is, "Special case (2):".
const LONGEST_LABEL: usize = 7;
/// A sentence with one of these says of more than one case, or doubts it.
static DOUBTED: Words = Words::of(&["or", "either", "neither", "nor", "would", "were", "if"]);

/// The cases that the sentences put in words, in order.
pub(super) fn read(source: &str, tokens: &[Placed<'_>]) -> Vec<Supposition> {
    let mut found = Vec::new();
    let mut start = 0;
    while start < tokens.len() {
        let length = tokens[start..]
            .iter()
            .position(|(token, _)| token.is_stop())
            .unwrap_or(tokens.len() - start);
        let end = start + length;
        if length > 0 && tokens[start..end].iter().any(|(token, _)| is_sign(*token)) {
            found.extend(of_sentence(source, start, end, tokens));
        }
        start = end + 1;
    }
    found
}

/// The cases that a heading puts in words: "Case 2: negative $x$".
pub(super) fn of_title(tokens: &[Placed<'_>]) -> Vec<Supposition> {
    let begins = (0..tokens.len()).filter(|&at| {
        let before = tokens[..at].last().map(|(token, _)| *token);
        matches!(
            before,
            None | Some(Token::Mark(':' | '(' | ',') | Token::Stop | Token::Dash)
        ) || before.is_some_and(|token| token.is_among(&["of", "for", "case", "if", "when"]))
    });
    let said = |at: usize| {
        let mut clause = Clause { tokens, at };
        let kinds = clause.kinds().filter(|_| clause.ends());
        clause.at = at;
        kinds.or_else(|| clause.clauses().filter(|_| clause.ends()))
    };
    begins.filter_map(said).next().unwrap_or_default()
}

/// Whether a word compares: most sentences have none.
fn is_sign(token: Token<'_>) -> bool {
    token.is_among(&SIGNS)
}

/// What says how something lies to nought, or to something else.
static SIGNS: Words = Words::of(&[
    "positive",
    "negative",
    "nonnegative",
    "nonpositive",
    "nonzero",
    "greater",
    "larger",
    "bigger",
    "higher",
    "less",
    "smaller",
    "lower",
    "above",
    "below",
    "least",
    "most",
    "exceeds",
    "exceed",
    "equals",
    "equal",
    "not",
]);

fn of_sentence(source: &str, start: usize, end: usize, tokens: &[Placed<'_>]) -> Vec<Supposition> {
    let sentence = &tokens[start..end];
    // "Case 2: negative $x$"
    let labelled =
        (start..end.min(start + LONGEST_LABEL)).rfind(|&at| cases::is_labelled(source, at, tokens));
    let begin = labelled.unwrap_or(start + lead(sentence));
    let is_label = labelled.is_some() || source[..tokens[begin].1.start].ends_with(['*', '{', '_']);
    let mut clause = Clause {
        tokens: &tokens[..end],
        at: begin,
    };
    let leads = end == tokens.len() || goes_on_then(&tokens[begin..]);
    clause.skip_joints();
    let (said, lasts) = if clause.skips(BEFORE_CLAUSE)
        || clause.skips_words(&["as", "soon", "as"])
        || clause.skips_where()
        || clause.skips_case()
    {
        clause.skip_joints();
        (clause.clauses(), false)
    } else if clause.skips(&["now"]) | clause.skips(SUPPOSING) && clause.at > begin {
        while clause.skips(AFTER_SUPPOSING) {}
        (clause.clauses(), true)
    } else if clause.skips(BEFORE_KIND) || clause.skips_words(&["in", "the", "case", "of"]) {
        (clause.kinds(), false)
    } else if clause.skips_words(&["the", "case", "of"]) || is_label {
        let said = clause.kinds().or_else(|| clause.clauses());
        (said.filter(|_| clause.is_over()), true)
    } else {
        return Vec::new();
    };
    let said = said.unwrap_or_default();
    let rest = &clause.tokens[clause.at..];
    let doubted = rest.iter().any(|(token, _)| is_doubtful(*token));
    match (lasts || is_label || leads) && !doubted {
        true => said,
        false => Vec::new(),
    }
}

/// Whether a word around the case says that it is none: "greater than" and "exceeds" compare what is so, and no cases.
fn is_doubtful(token: Token<'_>) -> bool {
    let compares = || token.is_among(&["than", "exceeds", "exceed"]);
    [&DOUBTED, &DENIALS, &COMPARED, &DISPUTING]
        .iter()
        .any(|words| token.is_among(*words))
        && !compares()
}

/// Reads on in a sentence.
struct Clause<'t, 'a> {
    tokens: &'t [Placed<'a>],
    at: usize,
}

impl<'a> Clause<'_, 'a> {
    fn next(&self) -> Option<Token<'a>> {
        self.tokens.get(self.at).map(|(token, _)| *token)
    }

    fn skips(&mut self, words: &[&str]) -> bool {
        let skips = self.next().is_some_and(|token| token.is_among(words));
        self.at += usize::from(skips);
        skips
    }

    fn skips_words(&mut self, phrase: &[&str]) -> bool {
        let rest = &self.tokens[self.at..];
        let mut both = rest.iter().zip(phrase);
        let skips =
            rest.len() >= phrase.len() && both.all(|((token, _), word)| token.is_among(&[*word]));
        if skips {
            self.at += phrase.len();
        }
        skips
    }

    /// "whereas", "on the other hand,"
    fn skip_joints(&mut self) {
        let before = self.at;
        let is_joint = |own: &mut Self| {
            own.skips(JOINING)
                || own.skips_words(&["on", "the", "other", "hand"])
                || own.skips_words(&["by", "contrast"])
                || own.skips_words(&["in", "contrast"])
                || own.at > before && own.skips_mark(',')
        };
        self.skips_mark(',');
        while is_joint(self) {}
    }

    fn skips_mark(&mut self, mark: char) -> bool {
        let skips = self.next().is_some_and(|token| token.is_mark(mark));
        self.at += usize::from(skips);
        skips
    }

    /// "Where" at the beginning of a sentence: in the middle of one it says what is so.
    fn skips_where(&mut self) -> bool {
        self.next() == Some(Token::Word("Where")) && self.skips(&["where"])
    }

    /// "In the case that", "in case".
    fn skips_case(&mut self) -> bool {
        let before = self.at;
        let case = self.skips_words(&["in", "the", "case"]) || self.skips_words(&["in", "case"]);
        let skips = case && !self.next().is_some_and(|token| token.is_among(&["of"]));
        if skips {
            self.skips(&["that", "where", "when"]);
        } else {
            self.at = before;
        }
        skips
    }

    fn math(&mut self) -> Option<Span> {
        let Some(Token::Math(body)) = self.next() else {
            return None;
        };
        self.at += 1;
        Some(body)
    }

    /// "$x$, $y$ and $z$"
    fn listed(&mut self) -> Option<Vec<Span>> {
        let mut found = vec![self.math()?];
        while found.len() < MOST_LISTED {
            let before = self.at;
            self.skips_mark(',');
            self.skips(&["and"]);
            match self.math() {
                Some(next) => found.push(next),
                None => {
                    self.at = before;
                    break;
                }
            }
        }
        Some(found)
    }

    /// Whether the case ends here, and what is said of it begins.
    fn is_over(&self) -> bool {
        match self.next() {
            None => true,
            Some(
                Token::Mark(',' | ':' | ')')
                | Token::Dash
                | Token::Stop
                | Token::Tag(_)
                | Token::Keys(_),
            ) => true,
            Some(token) => token.is_among(GOING_ON),
        }
    }

    /// Whether nothing more is said.
    fn ends(&self) -> bool {
        let rest = &self.tokens[self.at..];
        rest.iter()
            .all(|(token, _)| token.is_stop() || matches!(token, Token::Mark(_)))
    }

    /// "positive", "non-negative", "strictly positive".
    fn sign(&mut self) -> Option<Relation> {
        let start = self.at;
        let denied = self.skips(&["not"]);
        self.skips(&["strictly"]);
        let non = self.skips(&["non"]);
        if non && self.next() == Some(Token::Dash) {
            self.at += 1;
        }
        let word = match self.next() {
            Some(Token::Word(word)) => word.to_ascii_lowercase(),
            _ => String::new(),
        };
        self.at += 1;
        let non = non || denied;
        let relation = match (non, word.as_str()) {
            (false, "positive") => Some(Relation::Greater),
            (false, "negative") => Some(Relation::Less),
            (true, "negative") | (false, "nonnegative") => Some(Relation::GreaterOrEqual),
            (true, "positive") | (false, "nonpositive") => Some(Relation::LessOrEqual),
            (true, "zero") | (false, "nonzero") => Some(Relation::NotEqual),
            _ => None,
        };
        if relation.is_none() {
            self.at = start;
        }
        relation
    }

    /// "greater than", "equal to", "below", "at least", and what stands after it.
    fn than(&mut self) -> Option<(Relation, Option<Span>)> {
        let before = self.at;
        let (relation, joins) = match () {
            () if self.skips(&["greater", "larger", "bigger", "higher"]) => {
                (Relation::Greater, "than")
            }
            () if self.skips(&["less", "smaller", "lower"]) => (Relation::Less, "than"),
            () if self.skips(&["equal"]) => (Relation::Equal, "to"),
            () if self.skips(&["above"]) => (Relation::Greater, ""),
            () if self.skips(&["below"]) => (Relation::Less, ""),
            () if self.skips_words(&["at", "least"]) => (Relation::GreaterOrEqual, ""),
            () if self.skips_words(&["at", "most"]) => (Relation::LessOrEqual, ""),
            () => return None,
        };
        let other = match joins.is_empty() || self.skips(&[joins]) {
            true => self.value(),
            false => None,
        };
        if other.is_none() {
            self.at = before;
        }
        Some((relation, other?))
    }

    /// Mathematics or a number; none for nought in words.
    fn value(&mut self) -> Option<Option<Span>> {
        let value = match self.tokens.get(self.at)? {
            (Token::Math(body), _) => Some(*body),
            (Token::Number(_), span) => Some(*span),
            (token, _) if token.is_among(&["zero", "nought"]) => None,
            _ => return None,
        };
        self.at += 1;
        Some(value)
    }

    /// What is said once or more often, with "and" between; after it the case ends.
    fn joined(
        &mut self,
        one: fn(&mut Self) -> Option<Vec<Supposition>>,
    ) -> Option<Vec<Supposition>> {
        let mut found = one(self)?;
        loop {
            let before = self.at;
            self.skips_mark(',');
            match self.skips(&["and"]).then(|| one(self)).flatten() {
                Some(more) => found.extend(more),
                None => {
                    self.at = before;
                    return self.is_over().then_some(found);
                }
            }
        }
    }

    /// "the charge $q$ is negative and $a$ exceeds $b$", one or several.
    fn clauses(&mut self) -> Option<Vec<Supposition>> {
        self.joined(Clause::clause)
    }

    /// "the charge $q$ is negative", "$a$ and $b$ are equal", "$m$ exceeds $M$".
    fn clause(&mut self) -> Option<Vec<Supposition>> {
        let mut described = 0;
        while !matches!(self.next()?, Token::Math(_)) {
            let word = self.next();
            if !matches!(word, Some(own @ Token::Word(_)) if !is_doubtful(own)) {
                return None;
            }
            described += 1;
            self.at += 1;
            if described > MOST_DESCRIBING {
                return None;
            }
        }
        let of = self.listed()?;
        let all = |relation, to| {
            of.iter()
                .map(|&body| compared(body, relation, to))
                .collect()
        };
        if self.skips(&["exceeds", "exceed"]) {
            let to = self.value()?;
            return Some(all(Relation::Greater, to));
        }
        if self.skips(&["equals", "equal"]) {
            let to = self.value()?;
            return Some(all(Relation::Equal, to));
        }
        self.skips(LINKING);
        self.skips(&["both", "all", "itself"]);
        if let Some((relation, to)) = self.than() {
            return Some(all(relation, to));
        }
        // "$x$ is not 1", "$a$ is not equal to $b$"
        let before = self.at;
        if self.skips(&["not"]) {
            self.skips_words(&["equal", "to"]);
            if let Some(to) = self.value() {
                return Some(all(Relation::NotEqual, to));
            }
            self.at = before;
        }
        if self.skips(&["equal"]) {
            let (first, rest) = of.split_first()?;
            let equal = |&body: &Span| compared(body, Relation::Equal, Some(*first));
            return (!rest.is_empty()).then(|| rest.iter().map(equal).collect());
        }
        let relation = self.sign()?;
        self.skips(&["number", "numbers"]);
        Some(all(relation, None))
    }

    /// "positive $x$ and negative $y$", one or several.
    fn kinds(&mut self) -> Option<Vec<Supposition>> {
        self.joined(Clause::kind)
    }

    /// "a negative charge $q$", "positive values of $x$", "$x$ positive", "$x$ less than 1".
    fn kind(&mut self) -> Option<Vec<Supposition>> {
        self.skips(ARTICLES);
        let sign = self.sign();
        // "values of", "charges"
        for _ in 0..MOST_DESCRIBING {
            match self.next() {
                Some(Token::Word(word)) if !GOING_ON.contains(&word) => self.at += 1,
                _ => break,
            }
        }
        let of = self.listed()?;
        let (relation, to) = match sign {
            Some(relation) => (relation, None),
            None => match self.sign() {
                Some(relation) => (relation, None),
                None => self.than()?,
            },
        };
        let said = of.into_iter().map(|body| compared(body, relation, to));
        Some(said.collect())
    }
}

fn compared(body: Span, relation: Relation, to: Option<Span>) -> Supposition {
    Supposition {
        kind: SuppositionKind::Compared { relation, to },
        body,
    }
}
