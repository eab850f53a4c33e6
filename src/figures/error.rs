use std::fmt;

use crate::algebra::EvaluateError;

/// Why a figure cannot be drawn.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum FigureError {
    /// The derivation has no equation of this number or name.
    NoEquation(String),
    /// An equation does not give the symbol by a term.
    NotSolved {
        /// The equation.
        label: String,
        /// The symbol, as LaTeX.
        symbol: String,
    },
    /// A law has no value at a point of the figure.
    Evaluate {
        /// The equation.
        label: String,
        /// Why not.
        error: EvaluateError,
    },
    /// What is left after a collision is not the same share of every energy.
    NoShare(String),
    /// A point that ought to keep both conservation laws does not.
    NotConserved(String),
    /// The font that ships inside cannot write a character.
    NoGlyph(char),
    /// The picture could not be made.
    Picture(String),
}

impl fmt::Display for FigureError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            FigureError::NoEquation(label) => write!(f, "there is no equation {label} to draw"),
            FigureError::NotSolved { label, symbol } => {
                write!(f, "equation {label} does not say what `{symbol}` is")
            }
            FigureError::Evaluate { label, error } => {
                write!(f, "equation {label} cannot be drawn: {error}")
            }
            FigureError::NoShare(label) => {
                write!(
                    f,
                    "by {label} what a collision leaves is no share of the energy between 0 and 1"
                )
            }
            FigureError::NotConserved(label) => {
                write!(
                    f,
                    "an outcome that ought to be on the circle does not keep {label}"
                )
            }
            FigureError::NoGlyph(character) => write!(
                f,
                "the font of PNG and PDF has no `{}` (U+{:04X})",
                character.escape_debug(),
                u32::from(*character)
            ),
            FigureError::Picture(message) => write!(f, "the picture could not be made: {message}"),
        }
    }
}

impl std::error::Error for FigureError {}
