//! Canonical names that are written with brackets, `\langle x^2 \rangle`, `\text{Cov}(X, Y)`, `P(X > 3)`, `[\text{H}^+]`, taken apart for those
//! who print them.

use crate::algebra::{Expr, Relation};
use crate::document::Span;
use crate::notation::{read_expr, relation_latex};

const RELATIONS: [Relation; 12] = [
    Relation::Equal,
    Relation::NotEqual,
    Relation::Less,
    Relation::LessOrEqual,
    Relation::Greater,
    Relation::GreaterOrEqual,
    Relation::Scales,
    Relation::Proportional,
    Relation::Approximately,
    Relation::Tends,
    Relation::MuchLess,
    Relation::MuchGreater,
];

/// A name with brackets.
pub(super) struct Bracketed<'n> {
    /// What is before them, perhaps nothing.
    pub head: &'n str,
    /// The brackets as they are printed.
    pub around: (&'static str, &'static str),
    content: &'n str,
    /// What is written after them.
    pub scripts: &'n str,
}

/// What stands between brackets.
pub(super) enum Piece<'n> {
    /// A term, where it can be read: a chemical formula with a charge cannot.
    Term(Result<Expr, &'n str>),
    Relation(Relation),
    /// A comma, a bar, a sign of sets.
    Sign(&'static str),
}

impl<'n> Bracketed<'n> {
    /// Takes a canonical name apart; `None` where it has no brackets.
    pub(super) fn of(name: &'n str) -> Option<Bracketed<'n>> {
        let mut depth = 0usize;
        let (open, _) = name.char_indices().find(|&(at, c)| {
            match c {
                '{' => depth += 1,
                '}' => depth = depth.saturating_sub(1),
                _ => {}
            }
            depth == 0 && opening(&name[at..]).is_some()
        })?;
        let (sign, around) = opening(&name[open..])?;
        let inside = &name[open + sign.len()..];
        let end = outermost(inside)
            .find(|&(at, depth)| depth == 0 && closes(&inside[at..]))?
            .0;
        let closing = if sign == "\\langle" {
            "\\rangle".len()
        } else {
            1
        };
        Some(Bracketed {
            head: &name[..open],
            around,
            content: inside[..end].trim(),
            scripts: &inside[end + closing..],
        })
    }

    /// Whether it is a concentration, in whose name figures stand below the line.
    pub(super) fn is_concentration(&self) -> bool {
        self.head.is_empty() && self.around.0 == "["
    }

    /// What is between the brackets, as it is written.
    pub(super) fn content(&self) -> &'n str {
        self.content
    }

    /// What is between the brackets.
    pub(super) fn pieces(&self) -> Vec<Piece<'n>> {
        let mut pieces = Vec::new();
        let mut from = 0;
        let content = self.content;
        let ends = outermost(content).filter(|&(at, depth)| {
            depth == 0 && (content[at..].starts_with(' ') || content[at..].starts_with(','))
        });
        for at in ends.map(|(at, _)| at) {
            let Some((sign, length)) = (at >= from).then(|| sign(&content[at..])).flatten() else {
                continue;
            };
            pieces.push(term(&content[from..at]));
            pieces.push(sign);
            from = at + length;
        }
        pieces.push(term(&content[from..]));
        pieces
    }
}

/// The bracket that a text begins with, and how it is printed.
fn opening(text: &str) -> Option<(&'static str, (&'static str, &'static str))> {
    let all = [
        ("[", ("[", "]")),
        ("(", ("(", ")")),
        ("\\langle", ("⟨", "⟩")),
    ];
    all.into_iter().find(|(sign, _)| text.starts_with(sign))
}

fn closes(text: &str) -> bool {
    text.starts_with([']', ')']) || text.starts_with("\\rangle")
}

/// The places of a text, each with how many brackets and braces around it are open there.
fn outermost(text: &str) -> impl Iterator<Item = (usize, usize)> {
    let mut depth = 0usize;
    text.char_indices().map(move |(at, c)| {
        let rest = &text[at..];
        let before = depth;
        if c == '{' || opening(rest).is_some() {
            depth += 1;
        } else if c == '}' || closes(rest) {
            depth = depth.saturating_sub(1);
        }
        (at, before)
    })
}

/// The sign that a text begins with, and how long it is with the spaces around it.
fn sign(text: &str) -> Option<(Piece<'static>, usize)> {
    if text.starts_with(", ") {
        return Some((Piece::Sign(", "), 2));
    }
    let word = text.strip_prefix(' ')?.split(' ').next()?;
    let length = word.len() + 2;
    let piece = match word {
        "\\mid" | "|" => Piece::Sign("|"),
        "\\cap" => Piece::Sign(" ∩ "),
        "\\cup" => Piece::Sign(" ∪ "),
        word => {
            let mut all = RELATIONS.into_iter();
            Piece::Relation(all.find(|own| relation_latex(*own) == word)?)
        }
    };
    Some((piece, length))
}

fn term(text: &str) -> Piece<'_> {
    Piece::Term(read_expr(text, Span::new(0, text.len())).map_err(|_| text))
}
