//! Whole symbol names, in the one spelling that the rest of the tool knows.
//!
//! `v'_1`, `v_1'`, `{v_1}'` and `v_{1}^{\prime}` are one symbol. Its canonical name is: `\Delta` if it has one, the
//! letter with its accent, primes, other marks (`^*`), subscript; a subscript of one character stands without braces,
//! any other with them. `\mathrm{…}` and `\operatorname{…}` print like `\text{…}` and are written so.

use super::{Kind, Parser, Read, refuse, refuse_with};
use crate::algebra::{Expr, Symbol};
use crate::document::Span;
use crate::notation::commands::{self, ACCENTS, LETTERS, SUBSCRIPTS};

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

/// What a superscript holds.
pub(super) struct Superscript {
    pub(super) power: Option<Expr>,
    pub(super) primes: usize,
    pub(super) marks: String,
    /// Where the power is one thing in brackets, `^{(2)}`: its place.
    bracketed: Option<Span>,
}

impl Superscript {
    /// `u^{(2)}` is an order, an index or a derivative as often as a power.
    pub(super) fn refuse_order(&self) -> Read<()> {
        match self
            .bracketed
            .filter(|_| self.power.as_ref().is_some_and(may_count))
        {
            Some(span) => refuse_with(
                span,
                "this may be an order, an index or a power",
                "for a power leave out the brackets; for an order or an index write a subscript, as in `u_{(2)}`",
            ),
            None => Ok(()),
        }
    }
}

/// Whether a term may be an order or an index: `2`, `n`, `n + 1`; `-t/\tau` is none.
fn may_count(term: &Expr) -> bool {
    match term {
        Expr::Number(_) | Expr::Symbol(_) | Expr::Element { .. } => true,
        Expr::Sum(parts) => parts.iter().all(|part| match part {
            Expr::Negate(inner) => matches!(**inner, Expr::Number(_)),
            part => may_count(part),
        }),
        _ => false,
    }
}

impl Name {
    /// The name without its subscript: of `u'_i`, the sequence `u'`.
    fn stem(&self) -> String {
        let mut stem = format!("{}{}", self.head, "'".repeat(self.primes));
        match self.marks.as_str() {
            "" => {}
            mark if mark.len() == 1 => stem.push_str(&format!("^{mark}")),
            mark if mark.matches('\\').count() == 1 && mark.starts_with('\\') => {
                stem.push_str(&format!("^{mark}"));
            }
            marks => stem.push_str(&format!("^{{{marks}}}")),
        }
        stem
    }

    pub(super) fn canonical(&self) -> String {
        match &self.subscript {
            None => self.stem(),
            Some(subscript) => with_subscript(&self.stem(), &subscript.text),
        }
    }
}

/// Adds a subscript to a name.
pub(crate) fn with_subscript(stem: &str, text: &str) -> String {
    if text.chars().count() == 1 {
        format!("{stem}_{text}")
    } else {
        format!("{stem}_{{{text}}}")
    }
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
            let head = match parser.peek() {
                Kind::Command("Delta") => return parser.difference(),
                Kind::Command(accent) if commands::find(ACCENTS, accent).is_some() => {
                    return parser.accent(accent);
                }
                Kind::Upright(text) | Kind::Operator(text) | Kind::Text(text)
                    if parser.starts_name(parser.at) =>
                {
                    format!("\\text{{{text}}}")
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

    /// Primes, subscript and superscripts, in whatever order they come.
    pub(super) fn suffixes(&mut self, mut name: Name, start: usize) -> Read<Name> {
        let mut raised = false;
        let mut raised_at = None;
        loop {
            let at = self.at;
            match self.peek() {
                Kind::Char('\'') if raised => {
                    return refuse_with(
                        self.span(),
                        "a prime after a superscript",
                        "write the prime first",
                    );
                }
                Kind::Char('\'') => {
                    self.advance();
                    name.primes += 1;
                }
                Kind::Char('_') => {
                    self.advance();
                    let subscript = self.subscript(start)?;
                    if name.subscript.is_some() {
                        return refuse_with(
                            self.since(at),
                            "this is a second subscript on the same symbol",
                            "write both in one pair of braces",
                        );
                    }
                    name.subscript = Some(subscript);
                }
                Kind::Char('^') => {
                    let script = self.superscript()?;
                    script.refuse_order()?;
                    // A name that braces closed off, `{E^*}`, may still be raised.
                    let marked = !name.marks.is_empty() && !script.marks.is_empty();
                    if raised || marked || name.power.is_some() {
                        return refuse_with(
                            self.since(at),
                            "this is a second superscript on the same symbol",
                            "use parentheses, as in `(E^*)^2`",
                        );
                    }
                    raised = script.power.is_some() || !script.marks.is_empty();
                    name.primes += script.primes;
                    name.marks.push_str(&script.marks);
                    name.power = script.power;
                    raised_at = Some(self.since(at));
                }
                _ => {
                    if let Some(span) = raised_at {
                        self.doubt_power(&name, span);
                    }
                    return Ok(name);
                }
            }
        }
    }

    fn subscript(&mut self, start: usize) -> Read<Subscript> {
        let span = self.span();
        let mut subscript = Subscript {
            text: String::new(),
            bound: false,
        };
        match self.peek() {
            Kind::Open => {
                self.advance();
                self.subscript_content(&mut subscript)?;
                self.close(span)?;
                if subscript.text.is_empty() {
                    return refuse(span, "this subscript is empty");
                }
            }
            Kind::Number(text) if text.len() > 1 => {
                let stem = self.source_like(start);
                let (first, rest) = text.split_at(1);
                let message =
                    format!("TeX takes only the `{first}` of `{text}` into the subscript");
                let help = format!(
                    "write `{stem}_{{{text}}}`, or `{stem}_{first} \\cdot {rest}` for a product"
                );
                return refuse_with(span, message, help);
            }
            Kind::Char('+' | '-' | '*') if !matches!(self.kind(self.at + 1), Kind::Number(_)) => {
                self.subscript_piece(&mut subscript)?;
            }
            Kind::Command(name) if commands::find(ACCENTS, name).is_some() => {
                return refuse_with(span, "this cannot be a subscript", "put it in braces");
            }
            Kind::Number(_)
            | Kind::Letter(_)
            | Kind::Command(_)
            | Kind::Text(_)
            | Kind::Upright(_)
            | Kind::Operator(_) => {
                self.subscript_piece(&mut subscript)?;
            }
            Kind::End | Kind::Close => return refuse(span, "a subscript is missing after this"),
            Kind::Bad(_) => return self.unexpected(),
            _ => {
                return refuse_with(
                    span,
                    "this cannot be a subscript",
                    "put the subscript in braces",
                );
            }
        }
        Ok(subscript)
    }

    /// The letter before a faulty script, for a helpful suggestion.
    fn source_like(&self, start: usize) -> String {
        match self.kind(start) {
            Kind::Letter(c) => c.to_string(),
            Kind::Command(name) => format!("\\{name}"),
            _ => "x".to_owned(),
        }
    }

    fn subscript_content(&mut self, subscript: &mut Subscript) -> Read<()> {
        self.nested(|parser| {
            while !matches!(parser.peek(), Kind::Close | Kind::End) {
                parser.subscript_piece(subscript)?;
            }
            Ok(())
        })
    }

    fn subscript_piece(&mut self, subscript: &mut Subscript) -> Read<()> {
        let span = self.span();
        let piece = match self.peek() {
            Kind::Number(text) => text.replace("{,}", ",").replace("\\,", ""),
            Kind::Letter(c) => c.to_string(),
            Kind::Command(accent) if commands::find(ACCENTS, accent).is_some() => {
                let name = self.head()?;
                // What was read last is taken below.
                self.at -= 1;
                name.canonical()
            }
            Kind::Text(words) => format!("\\text{{{}}}", words.trim()),
            Kind::Upright(text) | Kind::Operator(text) => format!("\\text{{{text}}}"),
            Kind::Char(c) if "+-,*/()'".contains(c) => c.to_string(),
            Kind::Command(name)
                if commands::find(LETTERS, name).is_some()
                    || commands::find(SUBSCRIPTS, name).is_some() =>
            {
                format!("\\{name}")
            }
            Kind::Char(sign @ ('_' | '^')) => {
                self.advance();
                let mut inner = Subscript {
                    text: String::new(),
                    bound: false,
                };
                let open = self.span();
                if self.accept(Kind::Open) {
                    self.subscript_content(&mut inner)?;
                    self.close(open)?;
                } else if matches!(self.peek(), Kind::Number(text) if text.len() == 1)
                    || self.is_letter(self.at)
                {
                    self.subscript_piece(&mut inner)?;
                } else {
                    return refuse_with(self.span(), "this cannot be a script", "put it in braces");
                }
                if inner.text.is_empty() {
                    return refuse(open, "this script is empty");
                }
                subscript.bound |= inner.bound;
                let script = with_subscript("", &inner.text).split_off(1);
                subscript.text.push(sign);
                subscript.text.push_str(&script);
                return Ok(());
            }
            Kind::Open => {
                self.advance();
                self.subscript_content(subscript)?;
                return self.close(span);
            }
            Kind::Command(_) | Kind::Bad(_) => return self.unexpected(),
            _ => return refuse(span, "this cannot stand in a subscript"),
        };
        self.advance();
        subscript.bound |= self.bound.contains(&piece);
        let letter_next = piece.starts_with(|c: char| c.is_ascii_alphabetic());
        let after_command = subscript.text.rsplit_once('\\').is_some_and(|(_, name)| {
            !name.is_empty() && name.chars().all(|c| c.is_ascii_alphabetic())
        });
        if letter_next && after_command {
            subscript.text.push(' ');
        }
        // `^2` and a 0 after it are not `^20`.
        let digit = |text: &str| text.len() == 1 && text.bytes().all(|b| b.is_ascii_digit());
        let script = subscript.text.rsplit_once(['_', '^']);
        if piece.starts_with(|c: char| c.is_ascii_digit())
            && let Some((before, last)) = script
            && digit(last)
        {
            let sign = &subscript.text[before.len()..=before.len()];
            subscript.text = format!("{before}{sign}{{{last}}}");
        }
        subscript.text.push_str(&piece);
        Ok(())
    }

    /// A superscript, which may hold primes and marks of the name, a power, or both.
    pub(super) fn superscript(&mut self) -> Read<Superscript> {
        self.advance();
        let span = self.span();
        let mut script = Superscript {
            power: None,
            primes: 0,
            marks: String::new(),
            bracketed: None,
        };
        match self.peek() {
            Kind::Open => {
                self.advance();
                while self.mark(&mut script) {}
                if matches!(self.peek(), Kind::Char('+' | '-'))
                    && self.kind(self.at + 1) == Kind::Close
                {
                    let sign = if self.peek() == Kind::Char('+') {
                        "+"
                    } else {
                        "-"
                    };
                    script.marks.push_str(sign);
                    self.advance();
                }
                let marked = script.primes > 0 || !script.marks.is_empty();
                if !(marked && self.peek() == Kind::Close) {
                    let from = self.at;
                    script.power = Some(self.inside(false, Self::sum)?.expr);
                    script.bracketed = self.brackets_all(from);
                }
                self.close(span)?;
            }
            Kind::Number(text) if text.len() > 1 => {
                let (first, _) = text.split_at(1);
                let message =
                    format!("TeX takes only the `{first}` of `{text}` into the superscript");
                return refuse_with(span, message, format!("write `^{{{text}}}`"));
            }
            Kind::Char(sign @ ('+' | '-')) => {
                self.advance();
                script.marks.push(sign);
            }
            _ if self.mark(&mut script) => {}
            Kind::Command("circ") => return self.unexpected(),
            Kind::Number(_) | Kind::Letter(_) | Kind::Command(_) => {
                script.power = Some(self.argument("^")?)
            }
            Kind::End | Kind::Close => return refuse(span, "a superscript is missing after this"),
            Kind::Bad(_) => return self.unexpected(),
            _ => {
                return refuse_with(
                    span,
                    "this cannot be a superscript",
                    "put the superscript in braces",
                );
            }
        }
        Ok(script)
    }

    /// Whether what was read from a place on is one thing in brackets, perhaps in braces, which do not show.
    fn brackets_all(&self, from: usize) -> Option<Span> {
        let (start, end) = self.last_group?;
        let around = start.checked_sub(from)?;
        let braces =
            |mut tokens: std::ops::Range<usize>, kind| tokens.all(|at| self.kind(at) == kind);
        let all = end + around == self.at
            && braces(from..start, Kind::Open)
            && braces(end..self.at, Kind::Close);
        all.then(|| self.since(from))
    }

    fn mark(&mut self, script: &mut Superscript) -> bool {
        let mark = match self.peek() {
            Kind::Command("prime") => {
                script.primes += 1;
                self.advance();
                return true;
            }
            Kind::Char('*') | Kind::Command("ast") => "*",
            Kind::Command("star") => "\\star",
            Kind::Command("dagger") => "\\dagger",
            _ => return false,
        };
        script.marks.push_str(mark);
        self.advance();
        true
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
