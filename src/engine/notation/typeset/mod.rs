//! LaTeX mathematics as it was typed, set for a browser: what it looks like, whatever it means.
//!
//! The reader says what a formula means and refuses what it does not know. A page shows what its author wrote, read or not, so this goes
//! through the source by itself and sets every command that it knows; of others the name shows. It never fails.
//!
//! `alphabet` and `signs` are what letters and commands look like, `line` puts elements side by side, `scripts` below and above each other,
//! `table` in rows and cells; `words` is for text within mathematics, `command` for commands that take arguments, `quantity` for those of
//! siunitx, and `reader` takes the source from the front.
//!
//! **Invariant:** the time is linear in the length of the source, the nesting of what comes out is bounded, and every character of the
//! source passes through `escape`. Deliberately absent: any knowledge of what a formula means.

mod alphabet;
mod command;
mod line;
mod quantity;
mod reader;
mod scripts;
mod shorthand;
mod signs;
mod table;
mod words;

pub(in crate::notation) use alphabet::{Face, accent};

use line::{Atom, Line};
use signs::Class;

/// Groups within groups, deeper than anybody writes.
const DEEPEST: usize = 24;

/// LaTeX mathematics as elements of MathML, without the `<math>` around them.
pub fn typeset(source: &str) -> String {
    Setter::of(source).formula()
}

/// What a line ends with. What ends one that is farther out ends those in it, too.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Ends {
    /// The source.
    Whole,
    /// A row or a cell of the formula.
    Rows,
    /// A cell of an environment.
    Cell,
    Brace,
    Bracket,
    /// `\right`
    Fence,
    /// The end of mathematics within text.
    Dollar,
}

struct Setter<'s> {
    rest: &'s str,
    depth: usize,
    face: Face,
    /// How many braces, `\left`s and environments are open.
    braces: usize,
    fences: usize,
    environments: usize,
}

impl<'s> Setter<'s> {
    fn of(source: &'s str) -> Setter<'s> {
        Setter {
            rest: source,
            depth: 0,
            face: Face::Plain,
            braces: 0,
            fences: 0,
            environments: 0,
        }
    }

    /// Something within something else, in whose typeface it begins.
    fn nested<T>(&mut self, inner: impl FnOnce(&mut Self) -> T) -> T {
        let face = self.face;
        self.depth += 1;
        let set = inner(self);
        self.depth -= 1;
        self.face = face;
        set
    }

    /// Whether a line ends here. What ends it is taken where nobody else has to see it.
    fn ends(&mut self, ends: Ends) -> bool {
        match self.rest.as_bytes().first() {
            None => true,
            Some(b'}') if ends == Ends::Brace => self.take("}"),
            Some(b'}') => self.braces > 0,
            Some(b']') if ends == Ends::Bracket => self.take("]"),
            Some(b'$') if ends == Ends::Dollar => self.take("$"),
            Some(b'&') => matches!(ends, Ends::Cell | Ends::Rows),
            Some(b'\\') if self.rest.starts_with("\\\\") => {
                matches!(ends, Ends::Cell | Ends::Rows)
            }
            Some(b'\\') => match self.peeked() {
                Some("right") => self.fences > 0,
                Some("end") => match ends {
                    Ends::Rows => false,
                    _ => self.environments > 0,
                },
                _ => false,
            },
            Some(_) => false,
        }
    }

    /// Elements up to what ends them.
    fn line(&mut self, ends: Ends, goes_on: bool) -> Line {
        let mut line = Line::new(goes_on);
        loop {
            self.skip_blank();
            if self.ends(ends) {
                return line;
            }
            if self.peeked() == Some("over") && self.depth < DEEPEST {
                self.take("\\over");
                let above = std::mem::replace(&mut line, Line::new(false)).grouped();
                let below = self.nested(|own| own.line(ends, false)).grouped();
                let fraction = format!("<mfrac>{above}{below}</mfrac>");
                line.push(Atom::ordinary(fraction));
                return line;
            }
            self.element(&mut line);
        }
    }

    /// One element with its scripts.
    fn element(&mut self, line: &mut Line) {
        let Some(c) = self.rest.chars().next() else {
            return;
        };
        if c == '|' {
            self.take("|");
            // With scripts it closes something: `|_{x = a}`.
            let bar = match self.has_scripts() {
                true => self.scripted(line.bar(false)),
                false => line.bar(true),
            };
            line.push(bar);
            return;
        }
        let atom = self.atom();
        line.push(match self.has_scripts() {
            true => self.scripted(atom),
            false => atom,
        });
    }

    /// One element.
    fn atom(&mut self) -> Atom {
        let Some(c) = self.rest.chars().next() else {
            return Atom::trace("");
        };
        match c {
            '\\' => {
                self.take("\\");
                self.command()
            }
            '{' => Atom::ordinary(self.group()),
            // A script of nothing.
            '_' | '^' | '\'' => Atom::ordinary("<mrow></mrow>".to_owned()),
            '0'..='9' => Atom::ordinary(self.number()),
            c if c.is_alphabetic() => {
                let letters = match self.face.is_of_words() {
                    true => self.run(|c| c.is_alphanumeric()),
                    false => self.one(c),
                };
                Atom::ordinary(self.face.letters(letters))
            }
            c => {
                let own = self.one(c);
                character(c, own)
            }
        }
    }

    /// Digits with a decimal sign between them: `9.81`, `9{,}81`.
    fn number(&mut self) -> String {
        let digit = |c: char| c.is_ascii_digit();
        let mut number = self.run(digit).to_owned();
        for (typed, shown) in [("{,}", ","), (".", ".")] {
            let after = self.rest.strip_prefix(typed);
            if after.is_some_and(|after| after.starts_with(digit)) {
                self.take(typed);
                number = format!("{number}{shown}{}", self.run(digit));
                break;
            }
        }
        match self.face {
            Face::Blackboard => format!("<mn>{}</mn>", self.face.characters(&number)),
            Face::Bold => format!("<mn class=\"mathbf\">{number}</mn>"),
            _ => format!("<mn>{number}</mn>"),
        }
    }

    /// What is in braces, as one element.
    fn group(&mut self) -> String {
        self.take("{");
        if self.depth >= DEEPEST {
            return String::new();
        }
        self.braces += 1;
        let line = self.nested(|own| own.line(Ends::Brace, false));
        self.braces -= 1;
        line.grouped()
    }
}

/// A character that stands for itself.
fn character(c: char, own: &str) -> Atom {
    let class = words::character(c);
    match c {
        '-' => Atom::sign("−", class),
        '*' => Atom::sign("∗", class),
        '·' => Atom::sign("⋅", class),
        '~' => Atom::space("0.28em"),
        '/' => Atom {
            markup: "<mo lspace=\"0\" rspace=\"0\">/</mo>".to_owned(),
            class: Class::Open,
        },
        '}' | '&' | '$' => Atom::trace(""),
        '°' | '∞' | '∅' => Atom::sign(own, Class::Ordinary),
        _ if class == Class::Ordinary && c.is_ascii() => Atom::ordinary(words::mtext(own)),
        _ if class == Class::Ordinary => {
            let markup = format!("<mo>{}</mo>", crate::notation::escape(own));
            Atom::ordinary(markup)
        }
        _ => Atom::sign(own, class),
    }
}
