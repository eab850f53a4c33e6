//! Commands that take arguments: fractions, roots, accents, fences, boxes.

use super::alphabet::{self, Face};
use super::line::Atom;
use super::signs::{Class, function, sign, space};
use super::words::mtext;
use super::{Ends, Setter};
use crate::notation::commands::{is_binomial, is_fraction};
use crate::notation::escape;

impl<'s> Setter<'s> {
    /// A command, behind its backslash.
    pub(super) fn command(&mut self) -> Atom {
        let name = self.name();
        if name == "dots" {
            return self.dots();
        }
        if let Some((shown, class)) = sign(name) {
            return self.known(name, shown, class);
        }
        if let Some((word, class)) = function(name) {
            let markup = match class {
                Class::Limits => {
                    format!("<mo movablelimits=\"true\" lspace=\"0\" rspace=\"0\">{word}</mo>")
                }
                _ => format!("<mi>{word}</mi>"),
            };
            return Atom { markup, class };
        }
        if let Some(width) = space(name) {
            return Atom::space(width);
        }
        if let Some(class) = drawn(name) {
            let inside = self.argument();
            return Atom::ordinary(format!("<mrow class=\"{class}\">{inside}</mrow>"));
        }
        if let Some((over, stretchy)) = alphabet::accent(name) {
            let base = self.argument();
            let class = match name {
                "overbrace" => Class::Large,
                _ => Class::Ordinary,
            };
            let markup = format!(
                "<mover accent=\"true\">{base}<mo stretchy=\"{stretchy}\">{over}</mo></mover>"
            );
            return Atom { markup, class };
        }
        if let Some(face) = Face::of(name) {
            return self.faced(name, face);
        }
        self.structure(name)
    }

    /// Three dots: between signs of addition or equality in the middle of the line, and else on it.
    fn dots(&mut self) -> Atom {
        self.skip_blank();
        let shown = match self.rest.starts_with(['+', '-', '=', '<', '>']) {
            true => "⋯",
            false => "…",
        };
        Atom::sign(shown, Class::Ordinary)
    }

    fn known(&self, name: &str, shown: &str, class: Class) -> Atom {
        let is_capital = name.starts_with(|c: char| c.is_ascii_uppercase());
        let is_letter = shown.chars().all(char::is_alphabetic);
        if class == Class::Ordinary && is_letter {
            let face = match self.face {
                Face::Plain if is_capital => Face::Upright,
                face => face,
            };
            return Atom::ordinary(face.letters(shown));
        }
        Atom::sign(shown, class)
    }

    /// `\mathrm{…}`, and `\rm` for the rest of the group.
    fn faced(&mut self, name: &str, face: Face) -> Atom {
        if matches!(name, "rm" | "bf" | "sf" | "tt" | "it" | "cal") {
            self.face = face;
            return Atom::trace("");
        }
        self.take("*");
        let before = std::mem::replace(&mut self.face, face);
        let markup = self.argument();
        self.face = before;
        let class = match name {
            "operatorname" => Class::Function,
            _ => Class::Ordinary,
        };
        Atom { markup, class }
    }

    fn structure(&mut self, name: &str) -> Atom {
        if let Some(markup) = self.abbreviation(name) {
            return Atom::ordinary(markup);
        }
        let markup = match name {
            _ if is_fraction(name) => {
                let (above, below) = (self.argument(), self.argument());
                format!("<mfrac>{above}{below}</mfrac>")
            }
            _ if is_binomial(name) => {
                let (above, below) = (self.argument(), self.argument());
                format!(
                    "<mrow><mo>(</mo><mfrac linethickness=\"0\">{above}{below}</mfrac><mo>)</mo></mrow>"
                )
            }
            "sqrt" => self.root(),
            "text" | "textrm" | "textnormal" | "textit" | "textsf" | "texttt" | "mbox" | "hbox" => {
                match self.text() {
                    words if words.matches("<m").count() == 1 => words,
                    words => format!("<mrow>{words}</mrow>"),
                }
            }
            "left" => return Atom::ordinary(self.fenced()),
            "right" | "middle" => self.delimiter("infix"),
            "big" | "Big" | "bigg" | "Bigg" | "bigl" | "Bigl" | "biggl" | "Biggl" | "bigr"
            | "Bigr" | "biggr" | "Biggr" | "bigm" | "Bigm" => self.delimiter("infix"),
            "stackrel" | "overset" => {
                let (over, base) = (self.argument(), self.argument());
                let markup = format!("<mover>{base}{over}</mover>");
                let class = Class::Relation;
                return Atom { markup, class };
            }
            "underset" => {
                let (under, base) = (self.argument(), self.argument());
                let markup = format!("<munder>{base}{under}</munder>");
                let class = Class::Relation;
                return Atom { markup, class };
            }
            "not" => return self.negated(),
            "underbrace" => {
                let base = self.argument();
                let markup = format!("<munder>{base}<mo stretchy=\"true\">⏟</mo></munder>");
                let class = Class::Large;
                return Atom { markup, class };
            }
            "fbox" | "framebox" => format!("<mrow class=\"boxed\">{}</mrow>", self.text()),
            "begin" => self.environment(),
            "num" | "qty" | "SI" | "unit" | "si" | "ang" => self.quantity(name),
            "eqref" | "ref" | "cref" | "Cref" | "autoref" => {
                let key = self.raw();
                mtext(&format!("({key})"))
            }
            "pmod" => format!(
                "<mrow><mspace width=\"1em\"/><mo stretchy=\"false\">(</mo><mi>mod</mi><mspace width=\"0.28em\"/>{}<mo stretchy=\"false\">)</mo></mrow>",
                self.argument()
            ),
            "mathop" | "mathbin" | "mathrel" | "mathord" | "mathopen" | "mathclose" | "smash"
            | "substack" => self.argument(),
            "color" | "label" | "tag" | "hspace" | "vspace" | "mspace" | "phantom" | "hphantom"
            | "vphantom" | "cite" | "end" | "footnotesize" => {
                self.take("*");
                self.raw();
                return Atom::space(match name {
                    "hspace" | "phantom" | "hphantom" => "1em",
                    _ => "0",
                });
            }
            "textcolor" | "colorbox" => {
                self.raw();
                self.argument()
            }
            "bmod" | "mod" => "<mo lspace=\"0.22em\" rspace=\"0.22em\">mod</mo>".to_owned(),
            "" => return Atom::trace(""),
            other => format!("<mi>{}</mi>", escape(other)),
        };
        Atom::ordinary(markup)
    }

    fn root(&mut self) -> String {
        self.skip_blank();
        if self.depth < super::DEEPEST && self.take("[") {
            let degree = self.nested(|own| own.line(Ends::Bracket, false)).grouped();
            return format!("<mroot>{}{degree}</mroot>", self.argument());
        }
        format!("<msqrt>{}</msqrt>", self.argument())
    }

    /// `\left( … \right)`, behind the first command.
    fn fenced(&mut self) -> String {
        let open = self.delimiter("prefix");
        if self.depth >= super::DEEPEST {
            return open;
        }
        self.fences += 1;
        let inside = self.nested(|own| own.line(Ends::Fence, false)).markup;
        self.fences -= 1;
        let close = match self.peeked() == Some("right") && self.take("\\right") {
            true => self.delimiter("postfix"),
            false => String::new(),
        };
        format!("<mrow>{open}{inside}{close}</mrow>")
    }

    /// The fence behind `\left`, `\right` or `\big`; nothing for a full stop.
    fn delimiter(&mut self, form: &str) -> String {
        match self.single() {
            "." | "" => String::new(),
            "<" => fence("⟨", form),
            ">" => fence("⟩", form),
            shown => fence(shown, form),
        }
    }

    /// The one sign that comes next.
    fn single(&mut self) -> &'s str {
        self.skip_blank();
        match self.rest.chars().next() {
            Some('\\') => {
                self.take("\\");
                let name = self.name();
                sign(name).map_or(name, |(shown, _)| shown)
            }
            Some(c) if !"{}&$".contains(c) => self.one(c),
            _ => "",
        }
    }

    /// `\not=`: the sign that follows, struck out.
    fn negated(&mut self) -> Atom {
        match self.single() {
            "=" => Atom::sign("≠", Class::Relation),
            "∈" => Atom::sign("∉", Class::Relation),
            shown => Atom::sign(&format!("{shown}\u{338}"), Class::Relation),
        }
    }
}

fn fence(shown: &str, form: &str) -> String {
    format!(
        "<mo form=\"{form}\" stretchy=\"true\" lspace=\"0\" rspace=\"0\">{}</mo>",
        escape(shown)
    )
}

/// What the style sheet draws around an argument, or through it.
fn drawn(command: &str) -> Option<&'static str> {
    Some(match command {
        "boxed" => "boxed",
        "overline" => "overline",
        "underline" => "underline",
        "cancel" | "bcancel" | "xcancel" => "cancel",
        _ => return None,
    })
}
