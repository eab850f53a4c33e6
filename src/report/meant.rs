//! Which equations are meant by a number, a name, a key or a place.

use std::path::Path;

use crate::derivation::{Derivation, Equation};
use crate::document::Position;

/// The equations that a text names: all of a number or a name, which are one by mistake; else the one of a key; else those
/// at a place, `page.md:7:4`, `7:4`, `page.md:7` or `line 7`.
pub fn meant(derivation: &Derivation, label: &str) -> Vec<usize> {
    let Some(found) = derivation.find(label) else {
        return at_place(derivation, label);
    };
    let is_same = |own: &Equation| match (&found.tag, &found.name) {
        (Some(_), _) => own.tag == found.tag,
        (None, Some(_)) => own.name == found.name,
        (None, None) => std::ptr::eq(own, found),
    };
    positions(derivation, is_same)
}

fn positions(derivation: &Derivation, is_meant: impl Fn(&Equation) -> bool) -> Vec<usize> {
    let equations = derivation.equations.iter().enumerate();
    let meant = equations.filter(|(_, own)| is_meant(own));
    meant.map(|(at, _)| at).collect()
}

/// A place as somebody writes it.
struct Place<'a> {
    /// Any file, if none is named.
    file: Option<&'a str>,
    line: usize,
    column: Option<usize>,
}

impl Place<'_> {
    /// Reads `page.md:7:4` and shorter ones; what comes before the numbers is a file.
    fn read(text: &str) -> Option<Place<'_>> {
        let text = text.trim();
        let text = text.strip_prefix("the equation at ").unwrap_or(text);
        if let Some(line) = text.strip_prefix("line ") {
            let line = line.trim().parse().ok()?;
            return Some(Place {
                file: None,
                line,
                column: None,
            });
        }
        let (before, last) = text.rsplit_once(':')?;
        let last = last.parse().ok()?;
        let (file, line) = match before.rsplit_once(':') {
            Some((file, line)) => (Some(file), line.parse().ok()),
            None => (None, before.parse().ok()),
        };
        Some(match line {
            Some(line) => Place {
                file,
                line,
                column: Some(last),
            },
            None => Place {
                file: Some(before),
                line: last,
                column: None,
            },
        })
    }

    fn is_in(&self, path: &str) -> bool {
        let file = self
            .file
            .map(|file| file.strip_prefix("./").unwrap_or(file));
        file.is_none_or(|file| Path::new(path).ends_with(file))
    }
}

/// The equations that begin at a place; if there is none, those around it.
fn at_place(derivation: &Derivation, text: &str) -> Vec<usize> {
    let Some(place) = Place::read(text) else {
        return Vec::new();
    };
    let span = |own: &Equation| {
        let (file, span) = derivation.pages[own.page].document.written_at(own.body);
        let ends = (file.position(span.start), file.position(span.end));
        place.is_in(&file.path).then_some(ends)
    };
    let begins = |own: &Equation| {
        span(own).is_some_and(|(start, _)| {
            start.line == place.line && place.column.is_none_or(|column| column == start.column)
        })
    };
    let around = |own: &Equation| {
        let at = |position: Position| (position.line, place.column.map(|_| position.column));
        let asked = (place.line, place.column);
        span(own).is_some_and(|(start, end)| at(start) <= asked && asked <= at(end))
    };
    match positions(derivation, begins) {
        none if none.is_empty() => positions(derivation, around),
        found => found,
    }
}
