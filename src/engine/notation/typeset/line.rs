//! A line of elements that is being set, side by side.

use super::signs::Class;
use crate::notation::escape;

/// A thin space, as before and behind the name of a function.
const THIN: &str = "<mspace width=\"0.17em\"/>";

/// One element.
pub(super) struct Atom {
    pub markup: String,
    pub class: Class,
}

impl Atom {
    pub(super) fn ordinary(markup: String) -> Atom {
        Atom {
            markup,
            class: Class::Ordinary,
        }
    }

    /// What leaves nothing on the page, or only space.
    pub(super) fn trace(markup: impl Into<String>) -> Atom {
        Atom {
            markup: markup.into(),
            class: Class::None,
        }
    }

    /// A space of a width, if it has one.
    pub(super) fn space(width: &str) -> Atom {
        match width {
            "0" => Atom::trace(""),
            width => Atom::trace(format!("<mspace width=\"{width}\"/>")),
        }
    }

    /// A sign of a class.
    pub(super) fn sign(shown: &str, class: Class) -> Atom {
        let shown = escape(shown);
        let markup = match class {
            Class::Ordinary => format!("<mi>{shown}</mi>"),
            Class::Open | Class::Close => format!("<mo stretchy=\"false\">{shown}</mo>"),
            _ => format!("<mo>{shown}</mo>"),
        };
        Atom { markup, class }
    }
}

/// Elements side by side.
pub(super) struct Line {
    pub markup: String,
    last: Class,
    count: usize,
    /// Whether a bar that stands for itself is open.
    bar: bool,
    /// Whether it goes on with what stands in the cell before.
    goes_on: bool,
}

impl Line {
    pub(super) fn new(goes_on: bool) -> Line {
        Line {
            markup: String::new(),
            last: Class::None,
            count: 0,
            bar: false,
            goes_on,
        }
    }

    pub(super) fn push(&mut self, atom: Atom) {
        if atom.markup.is_empty() {
            return;
        }
        let class = atom.class;
        let ended = matches!(self.last, Class::Ordinary | Class::Close);
        let is_function = |class| matches!(class, Class::Function | Class::Limits);
        let apart = is_function(class) && (ended || is_function(self.last))
            || is_function(self.last) && class == Class::Ordinary;
        if apart {
            self.markup += THIN;
        }
        self.markup += &match (class, ended) {
            (Class::Binary, false) => formed(&atom.markup, self.goes_on && self.count == 0),
            _ => atom.markup,
        };
        self.count += 1;
        if class != Class::None {
            self.last = class;
        }
    }

    /// A bar, which looks alike on both sides of what it encloses: one that may open something, or one that closes.
    pub(super) fn bar(&mut self, opens: bool) -> Atom {
        self.bar = opens && !self.bar;
        Atom {
            markup: "<mo stretchy=\"false\" lspace=\"0\" rspace=\"0\">|</mo>".to_owned(),
            class: if self.bar { Class::Open } else { Class::Close },
        }
    }

    pub(super) fn is_empty(&self) -> bool {
        self.count == 0
    }

    /// All of it as one element.
    pub(super) fn grouped(self) -> String {
        match self.count {
            1 => self.markup,
            _ => format!("<mrow>{}</mrow>", self.markup),
        }
    }
}

/// A sign with nothing before it: that of a number, or one between terms whose first is in another cell.
fn formed(markup: &str, between: bool) -> String {
    let form = if between { "infix" } else { "prefix" };
    match markup.strip_prefix("<mo>") {
        Some(rest) if rest.starts_with(['+', '−', '±', '∓']) => {
            format!("<mo form=\"{form}\">{rest}")
        }
        _ => markup.to_owned(),
    }
}
