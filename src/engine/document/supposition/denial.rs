//! How far a denial reaches in its sentence: "does not have $v = 0$" says that it is not so, "does not move ($v = 0$)" that it is.

use super::super::conclusion;
use super::super::prose::{Placed, Token};
use super::super::words::Words;
use super::around::follows;

/// What comes after one of these in its clause is not so.
pub(super) static DENIALS: Words = Words::of(&["not", "no", "never", "cannot"]);
/// Denied, these deny all that the sentence says: "We do not assume that the body is at rest, $v = 0$", "It is not so that".
static OF_ALL: Words = Words::of(&[
    "assume", "suppose", "require", "need", "use", "claim", "say", "mean", "know", "so", "true",
]);
/// Who denies these denies that something is nought: "is not at rest ($v = 0$)".
static NOUGHT: Words = Words::of(&["rest", "zero", "vanish", "equal", "stationary"]);

/// What a sentence has denied so far.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Denial {
    /// Nothing that bears on what comes next.
    None,
    /// Something in the clause that is being read.
    Here,
    /// Something in the clause before, which what comes next may say in other words: "has no velocity, $v = 0$".
    Before,
    /// All that it says.
    Whole,
}

impl Denial {
    /// After the word at `index` of the sentence.
    pub(super) fn past_word(self, index: usize, sentence: &[Placed<'_>]) -> Denial {
        let word = sentence[index].0;
        let next = sentence.get(index + 1).map(|(token, _)| *token);
        // "so", "we have", the last letter of "i.e."
        let concludes = || conclusion::draws_on(word) || word.is_among(&["have", "e"]) && index > 0;
        match self {
            Denial::Whole => self,
            _ if word.is_among(&DENIALS) => match next {
                Some(next) if next.is_among(&OF_ALL) => Denial::Whole,
                _ => Denial::Here,
            },
            Denial::Here if word.is_among(&NOUGHT) => Denial::Whole,
            Denial::Here | Denial::Before if concludes() && !follows(index, sentence, &DENIALS) => {
                Denial::None
            }
            _ => self,
        }
    }

    /// After a mark.
    pub(super) fn past_mark(self, mark: Token<'_>) -> Denial {
        match self {
            Denial::Here if mark.is_mark('(') => Denial::None,
            Denial::Here if mark.is_mark(',') => Denial::Before,
            _ => self,
        }
    }
}
