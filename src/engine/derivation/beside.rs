//! What stands beside documents, in a file of its own, and holds in each of them; and where a document says otherwise.

use std::collections::BTreeSet;
use std::sync::Arc;

use crate::algebra::Symbol;
use crate::document::{Attribute, File, Problem, Span};
use crate::kernel::Domain;
use crate::notation::Spanned;
use crate::sorted::Tree;

use super::page::{Page, dimension_of, is_empty, narrow, no_value};
use super::{Equation, Kind};

/// What an author has written once for several documents. Spans are places in [`Beside::file`].
#[derive(Clone, Debug)]
pub struct Beside {
    /// The file that it stands in.
    pub file: Arc<File>,
    /// The symbols that it declares, in its order.
    pub symbols: Vec<Shared>,
    /// The numbers, keys and names of equations that are given.
    pub given: Vec<Spanned<String>>,
    /// How grave a code is, where that is not as usual.
    pub severity: Tree<String, Severity>,
    /// How much the search may try.
    pub budget: Budget,
}

/// A symbol declared beside documents.
#[derive(Clone, Debug)]
pub struct Shared {
    /// The symbol.
    pub symbol: Symbol,
    /// Its name.
    pub span: Span,
    /// What it is declared to be.
    pub attributes: Vec<Spanned<Attribute>>,
}

/// How grave an author wants a code to be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Severity {
    /// To be mended: as grave as an equation that is wrong.
    Error,
    /// To be mended.
    Warning,
    /// Good to know.
    Note,
    /// Not told.
    Off,
}

/// How much may be tried before a statement is left undecided.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Budget {
    /// How many choices of values a search for a counterexample may try.
    pub points: Option<usize>,
}

/// What a document says otherwise than the file beside it, where what the document says counts; or than it has said before.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Clash {
    /// What they differ about.
    pub about: About,
    /// Where the document says it.
    pub own: Span,
    /// Where the file does, as a place of the document ([`crate::document::Document::beside_at`]), or the document before.
    pub beside: Span,
}

/// What a document and the file beside it, or two declarations of a document, differ about.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum About {
    /// The dimension of a symbol.
    Dimension(Symbol),
    /// Where a symbol may lie: the document allows more, or nothing that the file allows.
    Domain(Symbol),
    /// Where a symbol may lie, between two declarations of the document: the first counts.
    TwoDomains(Symbol),
    /// Whether a symbol is Euler's number.
    Euler(Symbol),
    /// Whether an equation, named as in the file, is given.
    Given(String),
}

/// Where a symbol is declared, and whether with a dimension.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Place {
    /// Its name in the declaration.
    pub span: Span,
    /// A dimension is among what it is declared to be.
    pub dimension: bool,
}

impl Beside {
    /// What is wrong with the declarations that only their meaning shows: a dimension that is none, two dimensions of a
    /// symbol, bounds that leave it no value.
    pub fn problems(&self) -> Vec<Problem> {
        let mut problems = Vec::new();
        let mut known: Tree<&Symbol, crate::algebra::Dimension> = Tree::new();
        let mut domains: Tree<&Symbol, Domain> = Tree::new();
        let mut told = BTreeSet::new();
        for shared in &self.symbols {
            let mut own = Vec::new();
            let dimension = dimension_of(&shared.attributes, &mut own);
            // Names that share their attributes share what is wrong with them.
            own.retain(|problem: &Problem| told.insert(problem.span));
            problems.extend(own);
            let domain = domains.entry(&shared.symbol).or_default();
            narrow(domain, &shared.attributes);
            if is_empty(domain) {
                problems.push(no_value(&shared.symbol, shared.span));
            }
            let Some(dimension) = dimension else {
                continue;
            };
            match known.get(&shared.symbol) {
                Some(before) if *before != dimension => problems.push(Problem::new(
                    shared.span,
                    format!("`{}` is declared with two dimensions", shared.symbol),
                    "give one of the two another name, or declare it in the documents",
                )),
                Some(_) => {}
                None => drop(known.insert(&shared.symbol, dimension)),
            }
        }
        problems
    }
}

impl Page {
    /// Takes up what the file beside the document declares, as if it stood before the document, but for what `own`, the
    /// document by itself, says otherwise.
    pub(super) fn take_up(&mut self, beside: &Beside, own: &Page) {
        let mut shared = own.clone();
        shared.domains.clear();
        shared.dimensions.clear();
        shared.euler.clear();
        shared.declared.clear();
        shared.problems.clear();
        for symbol in &beside.symbols {
            let span = self.document.beside_at(symbol.span);
            let dimension = dimension_of(&symbol.attributes, &mut Vec::new());
            shared.declare(symbol.symbol.clone(), span, &symbol.attributes);
            shared.declare_dimension(symbol.symbol.clone(), span, dimension.as_ref());
        }
        for (symbol, domain) in shared.domains.iter() {
            let places = &shared.declared[symbol];
            self.declared.insert(symbol.clone(), places.clone());
            let there = |dimension: bool| found(places, dimension);
            let here = own.declared.get(symbol);
            let here = |dimension: bool| here.and_then(|all| found(all, dimension));
            let mut clash = |about: About, dimension: bool| {
                let (own, beside) = (here(dimension), there(dimension));
                if let (Some(own), Some(beside)) = (own, beside) {
                    self.clashes.push(Clash { about, own, beside });
                }
            };
            let is_euler = shared.euler.contains(symbol);
            if here(false).is_some() && is_euler != own.euler.contains(symbol) {
                // A letter is either a number or a quantity: nothing of the one fits the other.
                clash(About::Euler(symbol.clone()), false);
                continue;
            }
            if is_euler {
                self.euler.insert(symbol.clone());
            }
            match (shared.dimensions.get(symbol), own.dimensions.get(symbol)) {
                (Some(theirs), Some(ours)) if theirs != ours => {
                    clash(About::Dimension(symbol.clone()), true);
                }
                (Some(theirs), None) => {
                    self.dimensions.insert(symbol.clone(), theirs.clone());
                }
                _ => {}
            }
            match own.domains.get(symbol) {
                Some(ours) if !narrows(ours, domain) => {
                    clash(About::Domain(symbol.clone()), false);
                    self.domains.insert(symbol.clone(), Domain::default());
                }
                _ => drop(self.domains.insert(symbol.clone(), domain.clone())),
            }
        }
    }

    /// Makes equations given that the file beside the document names, but for those that the document derives: what of
    /// each says so is in `derived`.
    pub(super) fn give(
        &mut self,
        beside: &Beside,
        equations: &mut [Equation],
        derived: &[Option<Span>],
    ) {
        for (position, label) in beside.given.iter().enumerate() {
            let named = bare(&label.value);
            let Some(first) = equations.iter().position(|e| is_called(e, named)) else {
                continue;
            };
            self.given.insert(position);
            // A key of `subequations` names several, a claim the whole display.
            let whole = equations[first].name.as_deref() == Some(named);
            let from = if whole {
                first - equations[first].row.min(first)
            } else {
                first
            };
            for at in from..equations.len() {
                let named = is_called(&equations[at], named) || (from..=first).contains(&at);
                if !named || equations[at].kind == Kind::Given {
                    continue;
                }
                if let Some(own) = derived[at] {
                    let about = About::Given(label.value.clone());
                    let beside = self.document.beside_at(label.span);
                    let clash = Clash { about, own, beside };
                    if !self.clashes.contains(&clash) {
                        self.clashes.push(clash);
                    }
                    continue;
                }
                let equation = &mut equations[at];
                equation.kind = Kind::Given;
                equation.defines.clear();
                (equation.opens, equation.bare, equation.uncited) = (false, false, false);
            }
        }
    }

    /// Where a symbol is declared, if that is in the file beside the document alone.
    pub fn declared_beside(&self, symbol: &Symbol) -> Option<Span> {
        let places = self.declared.get(symbol)?;
        let end = self.document.source.len();
        let beside = |place: &&Place| place.span.start > end;
        let all = places.iter().all(|place| beside(&place));
        places.first().filter(|_| all).map(|place| place.span)
    }
}

/// The first place, with a dimension where one is asked for.
fn found(places: &[Place], dimension: bool) -> Option<Span> {
    let mut places = places.iter().filter(|place| place.dimension || !dimension);
    places.next().map(|place| place.span)
}

/// Whether all that a document says of a symbol can be added to what the file says: no bound is wider, and there is
/// room between them.
pub(super) fn narrows(own: &Domain, beside: &Domain) -> bool {
    type End = Option<(crate::algebra::BigRational, bool)>;
    let within = |ours: &End, theirs: &End, tighter: bool| match (ours, theirs) {
        (Some((own, strict)), Some((other, other_strict))) => match own == other {
            true => *strict || !*other_strict,
            false => (own > other) == tighter,
        },
        _ => true,
    };
    let both = Domain {
        lower: own.lower.clone().or_else(|| beside.lower.clone()),
        upper: own.upper.clone().or_else(|| beside.upper.clone()),
        nonzero: own.nonzero || beside.nonzero,
        ..Domain::default()
    };
    within(&own.lower, &beside.lower, true)
        && within(&own.upper, &beside.upper, false)
        && !is_empty(&both)
}

/// A label without what it may be written with: `(3)`, `claim momentum`.
fn bare(label: &str) -> &str {
    let label = label.trim();
    let label = label.strip_prefix("claim ").unwrap_or(label).trim();
    let inside = label.strip_prefix('(').and_then(|l| l.strip_suffix(')'));
    inside.unwrap_or(label).trim()
}

fn is_called(equation: &Equation, label: &str) -> bool {
    let of_group = [format!("({label})"), format!("{{{label}}}")];
    equation.tag.as_deref() == Some(label)
        || equation.name.as_deref() == Some(label)
        || equation.keys.iter().any(|key| key == label)
        || equation.group.iter().any(|own| of_group.contains(own))
}
