//! What the lexer makes: tokens with their places, and what is no token.

use crate::algebra::Relation;
use crate::document::Span;
use crate::notation::{Connective, Mark, Spanned, SyntaxError};

/// What a token is. `Copy`, borrowing its text from the source.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::notation) enum Kind<'s> {
    /// One letter.
    Letter(char),
    /// Digits, perhaps with a decimal point or `{,}` between them, or `\,` between groups of three.
    Number(&'s str),
    /// `\name`, without the backslash.
    Command(&'s str),
    /// `\qty{3}{m}`: a number and a unit, either of which may be empty.
    Quantity(&'s str, &'s str),
    /// `\text{…}`: words.
    Text(&'s str),
    /// `\mathrm{…}`, `\operatorname{…}`: an upright name.
    Upright(&'s str),
    /// `\operatorname{…}` of a function that is not known: an upright name that must not be taken as a factor.
    Operator(&'s str),
    /// `\eqref{…}`: keys.
    Reference(&'s str),
    /// Any other character.
    Char(char),
    /// `{`
    Open,
    /// `}`
    Close,
    /// `\\`
    Row,
    /// `\quad` or `\qquad`
    Wide,
    /// `&` between a case and its condition. Made by `fold`.
    Cell,
    /// `\begin{…}`
    Begin(&'s str),
    /// `\end{…}`
    Finish(&'s str),
    /// The word `and` outside `\text`.
    And,
    /// The error of this number, kept in [`Lexed::errors`].
    Bad(usize),
    /// A whole relation sign, questioned or not. Made by `fold`, as are the next four.
    Relation(Relation, bool),
    /// `\Rightarrow`, `\iff`
    Connective(Connective),
    /// ✓ or ✗
    Mark(Mark),
    /// `\boxed{` around one or more whole clauses.
    BoxOpen,
    /// Its `}`.
    BoxClose,
    /// The end of the formula.
    End,
}

/// A token and its place.
#[derive(Clone, Copy, Debug)]
pub(in crate::notation) struct Token<'s> {
    pub kind: Kind<'s>,
    pub span: Span,
    /// Whether a thin space, or a like one that the author asked for, stands before it.
    pub spaced: bool,
}

/// All that the lexer found.
#[derive(Default)]
pub(in crate::notation) struct Lexed<'s> {
    pub tokens: Vec<Token<'s>>,
    pub tags: Vec<Spanned<String>>,
    pub labels: Vec<Spanned<String>>,
    pub errors: Vec<SyntaxError>,
}

impl<'s> Lexed<'s> {
    /// Adds what was found further on.
    pub fn append(&mut self, other: Lexed<'s>) {
        let before = self.errors.len();
        self.tokens
            .extend(other.tokens.into_iter().map(|token| Token {
                kind: match token.kind {
                    Kind::Bad(number) => Kind::Bad(number + before),
                    kind => kind,
                },
                ..token
            }));
        self.tags.extend(other.tags);
        self.labels.extend(other.labels);
        self.errors.extend(other.errors);
    }
}
