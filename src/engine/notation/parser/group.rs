//! Groups: delimiters that a reader sees, and braces that a reader does not.

use super::function::name_raised;
use super::vector::refuse_vector;
use super::{Factor, Kind, Parser, Read, Shape, refuse, refuse_with};
use crate::algebra::{Expr, Function};
use crate::document::Span;

/// An opening delimiter, and how the closing one must look.
pub(super) struct Delimiter {
    pub(super) left: bool,
    pub(super) close: &'static str,
    pub(super) function: Option<Function>,
}

impl Parser<'_> {
    pub(super) fn open(&mut self) -> Read<Span> {
        let span = self.span();
        if self.accept(Kind::Open) {
            Ok(span)
        } else {
            refuse(span, "an opening brace is missing before this")
        }
    }

    /// `{…}`, which TeX does not print.
    pub(super) fn braces(&mut self) -> Read<Factor> {
        let start = self.at;
        let open = self.open()?;
        let content = self.inside(false, Self::sum)?;
        let end = self.at;
        self.close(open)?;
        if let Some(last) = self
            .last_name
            .take_if(|last| last.start == start + 1 && last.end == end)
        {
            let name = self.suffixes(last.name, start)?;
            return self.finish_name(start, name);
        }
        if name_raised(&content.expr).is_some() && self.at_argument() {
            let factor = Factor {
                expr: content.expr,
                shape: content.shape,
                span: self.since(start),
                braces: false,
            };
            return self.application(start, factor);
        }
        self.scripts(start, content.expr, content.shape, true)
    }

    /// `\underline{\underline{R I}}`: what is underlined. A line below a single name makes another name of it.
    fn underline_content(&mut self) -> Read<Factor> {
        let start = self.at;
        self.advance();
        let open = self.open()?;
        let content = match self.peek() {
            Kind::Command("underline") => {
                let inner = self.nested(Self::underline_content)?;
                (inner.expr, inner.shape)
            }
            _ => {
                let content = self.inside(false, Self::sum)?;
                (content.expr, content.shape)
            }
        };
        self.close(open)?;
        Ok(Factor {
            expr: content.0,
            shape: content.1,
            span: self.since(start),
            braces: content.1 == Shape::Loose,
        })
    }

    pub(super) fn underline(&mut self) -> Read<Factor> {
        let start = self.at;
        let factor = self.underline_content()?;
        if let Expr::Symbol(_) | Expr::Element { .. } | Expr::Apply(..) = factor.expr {
            let message = "whether this line is part of the name above it is not clear";
            return refuse_with(
                self.since(start),
                message,
                "use `\\boxed{…}`, or leave it out",
            );
        }
        self.scripts(start, factor.expr, factor.shape, factor.braces)
    }

    /// `\underbrace{…}_{words}`: what is braced; the words under it are for people.
    pub(super) fn underbrace(&mut self) -> Read<Factor> {
        let start = self.at;
        self.advance();
        let open = self.open()?;
        let content = self.inside(false, Self::sum)?;
        self.close(open)?;
        if matches!(self.peek(), Kind::Char('_' | '^')) {
            self.advance();
            let open = self.open()?;
            let mut depth = 1usize;
            while depth > 0 {
                match self.peek() {
                    Kind::Open | Kind::BoxOpen => depth += 1,
                    Kind::Close | Kind::BoxClose => depth -= 1,
                    Kind::End => return self.close(open).and_then(|()| self.unexpected()),
                    Kind::Bad(_) => return self.unexpected(),
                    _ => {}
                }
                self.advance();
            }
        }
        let braces = content.shape == Shape::Loose;
        self.scripts(start, content.expr, content.shape, braces)
    }

    /// The opening delimiter here, if there is one; takes it.
    pub(super) fn delimiter(&mut self) -> Option<Delimiter> {
        let left = self.peek() == Kind::Command("left");
        let (close, function) = match self.kind(self.at + usize::from(left)) {
            Kind::Char('(') => (")", None),
            Kind::Char('[') | Kind::Command("lbrack") => ("]", None),
            Kind::Command("{" | "lbrace") => ("}", None),
            Kind::Char('|') | Kind::Command("lvert" | "vert") => ("|", Some(Function::Abs)),
            Kind::Command("lceil") => ("⌉", Some(Function::Ceiling)),
            Kind::Command("lfloor") => ("⌋", Some(Function::Floor)),
            _ => return None,
        };
        self.at += 1 + usize::from(left);
        Some(Delimiter {
            left,
            close,
            function,
        })
    }

    pub(super) fn at_delimiter(&self) -> bool {
        match self.peek() {
            Kind::Char('[') | Kind::Command("left") if self.starts_bracketed(self.at) => false,
            Kind::Char('(' | '[') => true,
            Kind::Char('|') => !self.bar,
            Kind::Command("left") => self.kind(self.at + 1) != Kind::Char('.'),
            Kind::Command(name) => {
                matches!(
                    name,
                    "{" | "lbrace" | "lbrack" | "lvert" | "lceil" | "lfloor"
                )
            }
            _ => false,
        }
    }

    pub(super) fn group(&mut self, delimiter: Delimiter) -> Read<Expr> {
        let open = self.since(self.at - 1 - usize::from(delimiter.left));
        let bar = delimiter.close == "|" && !delimiter.left;
        let content = self.inside(bar, Self::sum)?;
        self.end_group(&delimiter, open)?;
        let Some(function) = delimiter.function else {
            return Ok(content.expr);
        };
        let message = "magnitudes of vectors are not read";
        refuse_vector(&content.expr, content.span, message)?;
        Ok(Expr::Call(function, content.expr.into()))
    }

    pub(super) fn end_group(&mut self, delimiter: &Delimiter, open: Span) -> Read<()> {
        let right = self.peek() == Kind::Command("right");
        let found = match self.kind(self.at + usize::from(right)) {
            Kind::Char(')') => ")",
            Kind::Char(']') | Kind::Command("rbrack") => "]",
            Kind::Command("}" | "rbrace") => "}",
            Kind::Char('|') | Kind::Command("rvert" | "vert") => "|",
            Kind::Command("rceil") => "⌉",
            Kind::Command("rfloor") => "⌋",
            Kind::End => return refuse(open, "this is never closed"),
            Kind::Relation(..) => {
                let help = "state a condition as a statement of its own, after a comma";
                return refuse_with(
                    self.span(),
                    "a relation sign cannot stand inside a group",
                    help,
                );
            }
            _ => return self.unexpected(),
        };
        let start = self.at;
        self.at += 1 + usize::from(right);
        if found != delimiter.close || right != delimiter.left {
            let expected = delimiter.close;
            let right = if delimiter.left { "\\right" } else { "" };
            return refuse(
                self.since(start),
                format!("`{right}{expected}` is expected here, to close what was opened"),
            );
        }
        Ok(())
    }
}
