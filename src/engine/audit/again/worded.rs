//! A new symbol that the words before its display give as a term: "The impulse on the second body is $m_2 (v_2 - u_2)$; inserting (4),
//! $$J = \mu (1 + e) (u_1 - u_2)$$"
//!
//! By itself the display would define the symbol. What it is drawn from says what the term is, and so whether that is what is printed. It is
//! told to be wrong only where a slip of the pen is found: the words may be of something else.

use crate::algebra::{Expr, Formula};
use crate::derivation::Goal;
use crate::notation::read_expr;

use super::super::judge::{Judge, taken};
use super::there::There;

/// Words that put what is cited into something.
const PUTTING: [&str; 8] = [
    "inserting",
    "insert",
    "substituting",
    "substitute",
    "putting",
    "using",
    "with",
    "by",
];
/// Before a term that something is said to be.
const SAYING: [&str; 4] = [" is", " equals", " are", " was"];
/// So many words may stand between the term and the display: with more, that may be of something else.
const MOST_WORDS: usize = 4;

impl Judge<'_> {
    /// What would define a symbol, judged as what the words before it give as a term.
    pub(in crate::audit) fn as_term_in_words(
        &self,
        goal: &Goal,
        premises: &[usize],
    ) -> Option<There> {
        let (new, named) = self.defined_anew(goal)?;
        if !goal.is_of(new)
            || !goal.is_said_outright()
            || !self.names_its_premises()
            || !self.says(&PUTTING)
        {
            return None;
        }
        let term = self.term_said()?;
        let symbols = term.free_symbols();
        let is_plain = !term.mentions(new) && !term.any(&|part| !part.is_arithmetic());
        if !is_plain || symbols.len() < 2 || symbols == named {
            return None;
        }
        let mut assumed = self.cited(goal, &[], premises);
        assumed.push(taken(&Formula::equal(Expr::Symbol(new.clone()), term)));
        let found = self.judged(goal, assumed, premises);
        let outcome = &found.judged.outcome;
        match () {
            () if outcome.is_proven() && found.contradictory.is_empty() => {
                Some(There::Solved(found.into()))
            }
            () if outcome.is_refuted() && found.mended.is_some() => {
                Some(There::Refuted(found.into()))
            }
            () => None,
        }
    }

    /// The term that something is said to be right before a display.
    fn term_said(&self) -> Option<Expr> {
        let page = self.derivation.equations[self.at].page;
        let source = &self.derivation.pages[page].document.source;
        let math = self.derivation.inline_before(self.at).last()?;
        let before = source.get(..math.span.start)?.trim_end();
        let between = source.get(math.span.end..self.derivation.equations[self.at].span.start)?;
        let is_said = SAYING.iter().any(|word| before.ends_with(word));
        if !is_said || words_in(between) > MOST_WORDS {
            return None;
        }
        let term = read_expr(source, math.body).ok()?;
        (!matches!(term, Expr::Symbol(_) | Expr::Number(_))).then_some(term)
    }
}

/// How many words a text has, but for comments, and commands with what stands in their braces: `\eqref{v2}`.
fn words_in(text: &str) -> usize {
    let parts = text.split("<!--");
    let parts = parts.map(|part| part.rsplit("-->").next().unwrap_or_default());
    let words = parts.flat_map(|part| part.split(|c: char| c.is_whitespace() || c == '~'));
    let is_word = |part: &&str| !part.contains('\\') && part.chars().any(char::is_alphabetic);
    words.filter(is_word).count()
}
