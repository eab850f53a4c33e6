//! Subscripts and superscripts: what of them belongs to a name, and what is a power.

use super::super::{Kind, Parser, Read, refuse, refuse_with};
use super::{Name, Subscript, upright, with_subscript};
use crate::algebra::Expr;
use crate::document::Span;
use crate::notation::commands::{self, ACCENTS, LETTERS, SUBSCRIPTS};

/// What a superscript holds.
pub(in crate::notation::parser) struct Superscript {
    pub power: Option<Expr>,
    pub primes: usize,
    pub marks: String,
    /// Where the power is one thing in brackets, `^{(2)}`: its place.
    bracketed: Option<Span>,
}

impl Superscript {
    /// `u^{(2)}` is an order, an index or a derivative as often as a power.
    pub fn refuse_order(&self) -> Read<()> {
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

impl Parser<'_> {
    /// Primes, subscript and superscripts, in whatever order they come.
    pub(in crate::notation::parser) fn suffixes(
        &mut self,
        mut name: Name,
        start: usize,
    ) -> Read<Name> {
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
                Kind::Char('^') if self.at_degrees() && self.may_be_standard(&name) => {
                    if raised || !name.marks.is_empty() {
                        return self.unexpected();
                    }
                    self.at += self.length_of_degrees();
                    name.marks.push_str("\\circ");
                    raised = true;
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

    /// Whether a circle belongs to a name, for what is so in the standard state, `\Delta G^\circ`: that of an angle does not.
    fn may_be_standard(&self, name: &Name) -> bool {
        let letter = name.head.rsplit([' ', '{']).next().unwrap_or(&name.head);
        let is_angle = letter
            .strip_prefix('\\')
            .is_some_and(|own| own != "mu" && own.starts_with(|c: char| c.is_ascii_lowercase()));
        !self.angle && !is_angle
    }

    /// What to say of degrees that are none of an angle, where `\circ` stands.
    fn degrees_elsewhere<T>(&mut self) -> Read<T> {
        if self.is_scale(self.at + 1) {
            return refuse_with(
                self.span(),
                "temperatures on a scale of degrees are not read: their zero is another than that of the kelvin",
                "write the temperature in kelvin",
            );
        }
        self.unexpected()
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
            Kind::Number(text) if text.bytes().all(|byte| byte.is_ascii_digit()) => text.to_owned(),
            Kind::Number(text) => text.replace("{,}", ",").replace("\\,", ""),
            Kind::Letter(c) => c.to_string(),
            Kind::Command(accent) if commands::find(ACCENTS, accent).is_some() => {
                let name = self.head()?;
                // What was read last is taken below.
                self.at -= 1;
                name.canonical()
            }
            Kind::Text(words) => format!("\\text{{{}}}", words.trim()),
            Kind::Upright(text) | Kind::Operator(text) => upright(text),
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
                    || sign == '^' && matches!(self.peek(), Kind::Char('+' | '-'))
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
    pub(in crate::notation::parser) fn superscript(&mut self) -> Read<Superscript> {
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
                if self.kind(self.at + 1) == Kind::Close {
                    self.upright_label(&mut script);
                }
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
            _ if self.mark(&mut script) || self.upright_label(&mut script) => {}
            Kind::Command("circ") => return self.degrees_elsewhere(),
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

    /// Upright letters by themselves are a label, `E^{\text{kin}}`, and no power.
    fn upright_label(&mut self, script: &mut Superscript) -> bool {
        let (Kind::Text(text) | Kind::Upright(text) | Kind::Operator(text)) = self.peek() else {
            return false;
        };
        let is_word = text.chars().count() > 1 && text.chars().all(char::is_alphabetic);
        if is_word {
            script.marks.push_str(&upright(text));
            self.advance();
        }
        is_word
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
}
