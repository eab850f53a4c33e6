//! What stands below and above an element, and the arguments of commands.

use super::line::Atom;
use super::signs::Class;
use super::{DEEPEST, Ends, Setter};

const PRIME: &str = "<mo lspace=\"0\" rspace=\"0\">′</mo>";

impl Setter<'_> {
    /// What a command or a script takes: a group, or the one sign that follows.
    pub(super) fn argument(&mut self) -> String {
        self.skip_blank();
        let missing = || "<mrow></mrow>".to_owned();
        if self.depth >= DEEPEST || self.ends(Ends::Whole) || self.rest.starts_with("\\\\") {
            return missing();
        }
        let markup = match self.rest.as_bytes().first() {
            Some(b'&' | b'$' | b'_' | b'^') => return missing(),
            Some(b'0'..=b'9') => format!("<mn>{}</mn>", self.one('0')),
            _ => self.nested(|own| own.atom()).markup,
        };
        match markup.is_empty() {
            true => missing(),
            false => markup,
        }
    }

    pub(super) fn has_scripts(&mut self) -> bool {
        self.skip_blank();
        while matches!(self.peeked(), Some("limits" | "nolimits")) {
            self.take("\\");
            self.name();
            self.skip_blank();
        }
        self.rest.starts_with(['_', '^', '\'', '’', '′'])
    }

    /// An element with the scripts behind it, one of each kind.
    pub(super) fn scripted(&mut self, base: Atom) -> Atom {
        let (mut below, mut above, mut primes) = (None, None, String::new());
        while self.has_scripts() {
            match self.rest.as_bytes().first() {
                Some(b'_') if below.is_none() => {
                    self.take("_");
                    below = Some(self.argument());
                }
                Some(b'^') if above.is_none() => {
                    self.take("^");
                    above = Some(self.argument());
                }
                Some(b'_' | b'^') => break,
                _ => {
                    let own = self.run(|c| matches!(c, '\'' | '’' | '′'));
                    primes += &PRIME.repeat(own.chars().count());
                }
            }
        }
        let class = base.class;
        let (one, other, both) = match class {
            Class::Limits | Class::Large => ("munder", "mover", "munderover"),
            _ => ("msub", "msup", "msubsup"),
        };
        let base = match (primes.is_empty(), base.markup.is_empty()) {
            (true, false) => base.markup,
            _ => format!("<mrow>{}{primes}</mrow>", base.markup),
        };
        let markup = match (below, above) {
            (Some(below), Some(above)) => format!("<{both}>{base}{below}{above}</{both}>"),
            (Some(below), None) => format!("<{one}>{base}{below}</{one}>"),
            (None, Some(above)) => format!("<{other}>{base}{above}</{other}>"),
            (None, None) => base,
        };
        let class = match class {
            Class::Binary | Class::None => Class::Ordinary,
            class => class,
        };
        Atom { markup, class }
    }
}
