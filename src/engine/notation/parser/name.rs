//! Whole symbol names, in the one spelling that the rest of the tool knows.
//!
//! `v'_1`, `v_1'`, `{v_1}'` and `v_{1}^{\prime}` are one symbol. Its canonical name is: `\Delta` if it has one, the
//! letter with its accent, primes, other marks (`^*`), subscript; a subscript of one character stands without braces,
//! any other with them. `\mathrm{…}` and `\operatorname{…}` print like `\text{…}` and are written so.

mod script;

use super::{Kind, Parser, Read, refuse, refuse_with};
use crate::algebra::{Expr, Symbol};
use crate::document::Span;
use crate::notation::commands::{self, ACCENTS, LETTERS};
pub(super) use script::Superscript;

/// A name in its parts.
#[derive(Clone, Default)]
pub(super) struct Name {
    /// `\Delta`, accent and letter.
    head: String,
    primes: usize,
    /// `*`, `\dagger`: the superscripts that are part of the name.
    marks: String,
    subscript: Option<Subscript>,
    /// The power, which is no part of the name.
    pub(super) power: Option<Expr>,
}

#[derive(Clone)]
struct Subscript {
    text: String,
    /// Whether a bound index occurs in it.
    bound: bool,
}

impl Name {
    /// The name without its subscript: of `u'_i`, the sequence `u'`.
    fn stem(&self) -> String {
        let mut stem = self.head.clone();
        stem.extend(std::iter::repeat_n('\'', self.primes));
        match self.marks.as_str() {
            "" => {}
            mark if mark.len() == 1 => stem.push_str(&format!("^{mark}")),
            mark if mark.matches('\\').count() == 1
                && mark.starts_with('\\')
                && !mark.ends_with('}') =>
            {
                stem.push_str(&format!("^{mark}"));
            }
            marks => stem.push_str(&format!("^{{{marks}}}")),
        }
        stem
    }

    pub(super) fn canonical(&self) -> String {
        match &self.subscript {
            None => self.stem(),
            Some(subscript) => subscripted(self.stem(), &subscript.text),
        }
    }
}

/// Adds a subscript to a name.
pub(crate) fn with_subscript(stem: &str, text: &str) -> String {
    subscripted(stem.to_owned(), text)
}

/// A word as a name. The numbers below the line of a formula, `\mathrm{H_2O}`, are no less part of it than the letters; a charge stands above
/// it, `\mathrm{CO_3^{2-}}`.
fn upright(text: &str) -> String {
    let (word, charge) = text.split_once('^').unwrap_or((text, ""));
    charged(word, charge)
}

/// A word with the charge that stands above it.
pub(super) fn charged(word: &str, charge: &str) -> String {
    let word = word.replace(['_', '{', '}'], "");
    let charge = charge.trim_matches(['{', '}']);
    match charge.len() {
        0 => format!("\\text{{{word}}}"),
        1 => format!("\\text{{{word}}}^{charge}"),
        _ => format!("\\text{{{word}}}^{{{charge}}}"),
    }
}

fn subscripted(mut stem: String, text: &str) -> String {
    let bare = text.chars().take(2).count() == 1;
    let (open, close) = if bare { ("_", "") } else { ("_{", "}") };
    stem.reserve(open.len() + text.len() + close.len());
    stem.push_str(open);
    stem.push_str(text);
    stem.push_str(close);
    stem
}

/// Words that join statements; in `\text{…}` they are never a symbol.
pub(super) const PROSE: &[&str] = &[
    "and",
    "or",
    "if",
    "for",
    "where",
    "when",
    "with",
    "since",
    "so",
    "then",
    "hence",
    "thus",
    "is",
    "as",
    "at",
    "but",
    "because",
    "given",
    "iff",
    "all",
    "every",
    "any",
    "let",
    "by",
    "from",
    "are",
    "in",
    "on",
    "to",
    "not",
    "therefore",
    "whence",
    "also",
    "while",
    "giving",
    "unless",
    "we",
    "which",
];

impl Parser<'_> {
    /// Whether the token at this place starts a name.
    pub(super) fn starts_name(&self, at: usize) -> bool {
        match self.kind(at) {
            Kind::Letter(_) | Kind::Upright(_) | Kind::Operator(_) => true,
            Kind::Text(words) => {
                !words.is_empty()
                    && words.chars().all(char::is_alphanumeric)
                    && !PROSE.contains(&words)
            }
            Kind::Command("left" | "langle" | "Pr") | Kind::Char('[') => self.starts_bracketed(at),
            Kind::Command(name) => {
                commands::find(LETTERS, name).is_some() || commands::find(ACCENTS, name).is_some()
            }
            _ => false,
        }
    }

    /// Whether the token at this place is a bare letter.
    pub(super) fn is_letter(&self, at: usize) -> bool {
        match self.kind(at) {
            Kind::Letter(_) => true,
            Kind::Command(name) => commands::find(LETTERS, name).is_some(),
            _ => false,
        }
    }

    /// A bare letter as a name.
    pub(super) fn single_letter(&mut self) -> Read<Name> {
        let head = match self.peek() {
            Kind::Letter(c) => c.to_string(),
            Kind::Command(name) => format!("\\{name}"),
            _ => return self.no_term(),
        };
        self.advance();
        Ok(Name {
            head,
            ..Name::default()
        })
    }

    /// A name with all its scripts, and the power if there is one.
    pub(super) fn name(&mut self) -> Read<Name> {
        let start = self.at;
        let name = self.head()?;
        self.suffixes(name, start)
    }

    /// `\Delta`, accent and letter, without scripts unless the accent is over them.
    fn head(&mut self) -> Read<Name> {
        self.nested(|parser| {
            if let Some(head) = parser.bracketed()? {
                return Ok(Name {
                    head,
                    ..Name::default()
                });
            }
            let head = match parser.peek() {
                Kind::Command("Delta") => return parser.difference(),
                Kind::Command(accent) if commands::find(ACCENTS, accent).is_some() => {
                    return parser.accent(accent);
                }
                Kind::Upright(text) | Kind::Operator(text) | Kind::Text(text)
                    if parser.starts_name(parser.at) =>
                {
                    upright(text)
                }
                _ if parser.is_letter(parser.at) => return parser.single_letter(),
                _ => return parser.no_term(),
            };
            parser.advance();
            Ok(Name {
                head,
                ..Name::default()
            })
        })
    }

    /// `\Delta` directly before a symbol belongs to its name.
    fn difference(&mut self) -> Read<Name> {
        let span = self.span();
        self.advance();
        let name = if self.starts_name(self.at) {
            self.head()?
        } else if self.peek() == Kind::Open {
            let help = "for a difference write `\\Delta E`, for a product `\\Delta \\cdot {…}`";
            return refuse_with(
                span.to(self.span()),
                "whether this is a difference or a product is not clear",
                help,
            );
        } else {
            return Ok(Name {
                head: "\\Delta".to_owned(),
                ..Name::default()
            });
        };
        Ok(Name {
            head: format!("\\Delta {}", name.head),
            ..name
        })
    }

    fn accent(&mut self, accent: &str) -> Read<Name> {
        let start = self.at;
        self.advance();
        let open = self.span();
        let name = if self.accept(Kind::Open) {
            if accent == "overline" && !self.is_lone_name() {
                return Ok(Name {
                    head: self.mean_below_a_line(start, open)?,
                    ..Name::default()
                });
            }
            if !self.starts_name(self.at) {
                return refuse(
                    self.span(),
                    format!("`\\{accent}` is read only over a single name"),
                );
            }
            let name = self.nested(Self::name)?;
            if name.power.is_some() || self.peek() != Kind::Close && self.peek() != Kind::End {
                return refuse(
                    self.since(start),
                    format!("`\\{accent}` is read only over a single name"),
                );
            }
            self.close(open)?;
            name
        } else if self.is_letter(self.at) {
            self.single_letter()?
        } else if matches!(self.peek(), Kind::Command(name) if commands::find(ACCENTS, name).is_some())
        {
            self.head()?
        } else {
            return refuse(
                self.since(start),
                format!("`\\{accent}` needs a name after it"),
            );
        };
        // Single letters are italic anyhow.
        Ok(match accent == "mathit" && name.head.len() == 1 {
            true => name,
            false => Name {
                head: format!("\\{accent}{{{}}}", name.head),
                ..name
            },
        })
    }

    /// Whether a name and nothing else stands before the brace that closes here.
    fn is_lone_name(&mut self) -> bool {
        let start = self.at;
        let so_far = (self.before.len(), self.choices.len(), self.doubts.len());
        let read = self.starts_name(start).then(|| self.nested(Self::name));
        let ends = matches!(self.peek(), Kind::Close | Kind::End);
        self.at = start;
        self.before.truncate(so_far.0);
        self.choices.truncate(so_far.1);
        self.doubts.truncate(so_far.2);
        matches!(read, Some(Ok(name)) if name.power.is_none() && ends)
    }

    /// The term that a name stands for here: a symbol, or the element of a sequence at a bound index.
    pub(super) fn symbol(&self, name: &Name, span: Span) -> Read<Expr> {
        match &name.subscript {
            Some(subscript) if self.bound.contains(&subscript.text) => Ok(Expr::Element {
                sequence: Symbol::new(name.stem()),
                index: Symbol::new(subscript.text.as_str()),
            }),
            Some(subscript) if subscript.bound => refuse(
                span,
                "the index of the sum stands in a longer subscript, which is not read: only `u_i` itself is",
            ),
            _ => Ok(Expr::Symbol(Symbol::new(name.canonical()))),
        }
    }
}
