//! A letter with two meanings. `symbols k: …` below a heading may say something else of `k` than a section before did: from
//! there to the end of its section the letter is another symbol, which is printed like the first.
//!
//! So a premise of before that speaks of `k` speaks of the old one, wherever it is cited.

use crate::algebra::{Dimension, Expr, Symbol, another_meaning};
use crate::document::{Attribute, Item, Span};
use crate::kernel::Domain;
use crate::notation::Spanned;
use crate::sorted::Tree;

use super::Equation;
use super::equation::each_side;
use super::page::{Page, adds_to, bounds_in};
use super::supposed::Local;

/// The meanings that the declarations of a page give to letters.
#[derive(Clone, Debug, Default)]
pub(super) struct Meanings {
    /// Where each symbol may lie, as its first declaration with bounds has it, and where that is.
    pub(super) bounded: Tree<Symbol, (Domain, Span)>,
    /// What each letter is in parts of the page, the first to begin first.
    parts: Tree<Symbol, Vec<(Span, Symbol)>>,
}

impl Meanings {
    /// What a letter is at a place, where that is not what it is on the page.
    fn other(&self, letter: &Symbol, place: usize) -> Option<&Symbol> {
        let mut parts = self.parts.get(letter)?.iter().rev();
        let part = parts.find(|(part, _)| part.start <= place && place < part.end);
        part.map(|(_, own)| own)
    }

    /// What a letter is at a place.
    pub(super) fn at(&self, letter: &Symbol, place: usize) -> Symbol {
        self.other(letter, place).unwrap_or(letter).clone()
    }

    /// The symbol of a letter, or of the letter below its dots.
    fn meant(&self, symbol: &Symbol, place: usize) -> Option<Symbol> {
        let dotted = || {
            let (accent, letter) = symbol.name().strip_suffix('}')?.split_once('{')?;
            let is_dot = ["\\dot", "\\ddot", "\\dddot"].contains(&accent);
            let own = self.other(&Symbol::new(letter), place).filter(|_| is_dot)?;
            Some(Symbol::new(format!("{accent}{{{own}}}")))
        };
        self.other(symbol, place).cloned().or_else(dotted)
    }

    /// Makes the letters in equations and suppositions the symbols that they are where these stand.
    pub(super) fn settle(&self, equations: &mut [Equation], locals: &mut [Local]) {
        if self.parts.is_empty() {
            return;
        }
        for equation in equations {
            let place = equation.body.start;
            let own = |symbol: &Symbol| self.meant(symbol, place).unwrap_or(symbol.clone());
            for statement in equation.statements.iter_mut().flatten() {
                each_side(statement, &mut |term, _| *term = renamed(term, &own));
                for run in &mut statement.runs {
                    run.symbol = own(&run.symbol);
                }
                for before in &mut statement.before {
                    before.name = own(&before.name);
                }
                statement.quantified = statement.quantified.iter().map(own).collect();
            }
            equation.introduces = equation.introduces.iter().map(own).collect();
            equation.disputed = equation.disputed.iter().map(own).collect();
            equation.released = equation.released.iter().map(own).collect();
            let said = std::mem::take(&mut equation.said).into_iter();
            equation.said = said.map(|(symbol, said)| (own(&symbol), said)).collect();
        }
        for local in locals {
            let place = local.span.start;
            let own = |symbol: &Symbol| self.meant(symbol, place).unwrap_or(symbol.clone());
            for formula in &mut local.formulas {
                *formula = formula.map_terms(|term| renamed(term, &own)).into();
            }
            local.rename(&own);
        }
    }
}

impl Page {
    /// The symbol that a declaration is about. Where it stands under another heading than what was declared of the letter before, and
    /// says otherwise, that is a new one.
    pub(super) fn declared_as(
        &self,
        letter: &Symbol,
        span: Span,
        (attributes, dimension): (&[Spanned<Attribute>], Option<&Dimension>),
        section: Option<Span>,
        meanings: &mut Meanings,
    ) -> Symbol {
        let current = meanings.at(letter, span.start);
        let Some(section) = section else {
            return current;
        };
        // What stands in a file beside the document is narrowed by it, or clashes with it.
        let end = self.document.source.len();
        let above = |span: Span| span.start < section.start && span.start < end;
        let domain = bounds_in(attributes);
        let bounded = meanings.bounded.get(&current);
        let lies_elsewhere = domain != Domain::default()
            && bounded.is_some_and(|(before, place)| above(*place) && !adds_to(&domain, before));
        let places = self.declared.get(&current).into_iter().flatten();
        let mut measured = places.filter(|place| place.dimension);
        let is_above = measured.next().is_some_and(|place| above(place.span));
        let before = self.dimensions.get(&current).filter(|_| is_above);
        let has_another = dimension
            .zip(before)
            .is_some_and(|(own, before)| own != before);
        if !lies_elsewhere && !has_another {
            return current;
        }
        let line = self.document.position(span.start).line;
        let Some(own) = another_meaning(letter, line) else {
            return current;
        };
        if self.declared.contains_key(&own) {
            return current;
        }
        let part = Span::new(span.start, section.end);
        let parts = meanings.parts.entry(letter.clone()).or_default();
        parts.push((part, own.clone()));
        own
    }
}

/// Of each item, where the section ends that it is the heading of.
pub(super) fn section_ends(items: &[Item]) -> Vec<usize> {
    let end = items.last().map_or(0, |item| item.span().end + 1);
    let mut ends = vec![end; items.len()];
    let mut open: Vec<(u8, usize)> = Vec::new();
    for (at, item) in items.iter().enumerate() {
        let Item::Heading { level, span, .. } = item else {
            continue;
        };
        while let Some((_, ended)) = open.pop_if(|(own, _)| *own >= *level) {
            ends[ended] = span.start;
        }
        open.push((*level, at));
    }
    ends
}

/// A term with other names in it, bound ones too.
pub(crate) fn renamed(term: &Expr, own: &impl Fn(&Symbol) -> Symbol) -> Expr {
    let mut term = term.map_children(|child| renamed(child, own));
    match &mut term {
        Expr::Symbol(symbol)
        | Expr::Apply(symbol, _)
        | Expr::Element { index: symbol, .. }
        | Expr::Series { index: symbol, .. }
        | Expr::Derivative {
            variable: symbol, ..
        }
        | Expr::Integral {
            variable: symbol, ..
        }
        | Expr::Limit {
            variable: symbol, ..
        } => *symbol = own(symbol),
        _ => {}
    }
    term
}
