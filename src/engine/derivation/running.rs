//! Which indices run through sequences, and what is said of every index.
//!
//! An index runs on a page where it is a natural number, declared or inferred (`counts`) (or an integer from 0 or more on, without an upper
//! bound and not `constant`) and has a recurrence in it: something that speaks of an element and of another a fixed
//! number of places away, as `E_{n+1} = e^2 E_n` does. Where nothing of the kind is written, `v_1` and `v_n` are labels.

use std::cell::LazyCell;
use std::collections::BTreeSet;

use crate::algebra::{
    Atoms, Expr, Formula, Lowering, Place, Symbol, mentions_symbol, running_symbol,
};
use crate::kernel::{Domain, ForEvery};

use super::{Assumed, Derivation, Equation, Kind, Page, Source, formulas};
use crate::sorted::{Map, Set};

/// An index that runs through sequences on a page.
#[derive(Clone, Debug)]
pub struct Running {
    /// The index.
    pub index: Symbol,
    /// Symbols without it in their name that may depend on it all the same: something is given that ties them to it.
    pub varying: Set<Symbol>,
}

/// The indices that run on a page.
pub(super) fn running(page: &Page, equations: &[Equation]) -> Vec<Running> {
    let indices = page.domains.iter().filter(|(symbol, domain)| {
        let from = domain.lower.as_ref().is_some_and(|(bound, _)| {
            *bound >= crate::algebra::BigRational::from_integer(0.into())
        });
        let runs = domain.integer && from && domain.upper.is_none() && !domain.constant;
        runs && symbol.can_be_index()
    });
    let given = equations.iter().flat_map(|equation| {
        let statements = equation.statements().iter().enumerate();
        let whole = equation.kind == Kind::Given || equation.opens;
        let given = statements.filter(move |(part, _)| whole || equation.defines.contains(part));
        given.flat_map(|(_, statement)| formulas(statement))
    });
    let all = || {
        let statements = equations.iter().flat_map(|equation| equation.statements());
        statements.flat_map(formulas)
    };
    let mut indices = indices.map(|(symbol, _)| symbol).peekable();
    if indices.peek().is_none() {
        return Vec::new();
    }
    let given: Vec<Formula> = given.collect();
    let found = indices.filter(|index| {
        let numbered = LazyCell::new(|| numbered(equations, index));
        all().any(|f| {
            let is_numbered = |stem| numbered.contains(&stem);
            recurs(&offsets(&f, index)) || family(&f, index).is_some_and(is_numbered)
        })
    });
    let found = found.map(|index| Running {
        index: index.clone(),
        varying: varying(page, &given, index),
    });
    found.collect()
}

/// For each sequence whose elements run with an index, the least and the greatest of their offsets.
pub(super) type Offsets = Map<Symbol, (i64, i64)>;

/// Those in a formula.
pub(super) fn offsets(formula: &Formula, index: &Symbol) -> Offsets {
    let mut offsets = Offsets::new();
    for symbol in formula.free_symbols() {
        if let Some((stem, Place::Running(offset))) = symbol.place(index) {
            let (least, greatest) = offsets.entry(stem).or_insert((offset, offset));
            (*least, *greatest) = (offset.min(*least), offset.max(*greatest));
        }
    }
    offsets
}

/// The sequence all of whose elements an equation gives, in terms of the index: `E` of `E_n = n^2 E_0`.
pub(super) fn family(formula: &Formula, index: &Symbol) -> Option<Symbol> {
    let Some((Expr::Symbol(symbol), right)) = formula.as_equation() else {
        return None;
    };
    let (stem, Place::Running(0)) = symbol.place(index)? else {
        return None;
    };
    let shifted = |own: &Symbol| {
        let place = own.place(index).filter(|place| place.0 == stem);
        place.is_some_and(|(_, place)| !matches!(place, Place::Number(_)))
    };
    let named = right.free_symbols();
    (named.contains(index) && !named.iter().any(shifted)).then_some(stem)
}

/// Whether an equation gives the elements of a sequence by one of them of which it is not true itself: `f_0` of `f_n = n f_0 \sqrt{1 + B n^2}`
/// is no element of those, but a quantity of its own.
fn is_by_another(formula: &Formula, index: &Symbol) -> bool {
    let Some((stem, (_, right))) = family(formula, index).zip(formula.as_equation()) else {
        return false;
    };
    let is_itself = |own: &Symbol, number: i64| {
        let mut atoms = Atoms::default();
        let mut lowering = Lowering::plain(&mut atoms);
        let there = lowering.lower(&right.substitute(index, &Expr::integer(number)));
        let own = lowering.lower(&Expr::Symbol(own.clone()));
        let difference = there.and_then(|there| Ok(there.minus(&own?)?));
        difference.is_ok_and(|own| own.is_zero())
    };
    right
        .free_symbols()
        .iter()
        .any(|own| match own.place(index) {
            Some((of, Place::Number(number))) => of == stem && !is_itself(own, number.into()),
            _ => false,
        })
}

/// The sequences of which some equation has an element with its number: `E` where there is an `E_1`.
pub(super) fn numbered(equations: &[Equation], index: &Symbol) -> BTreeSet<Symbol> {
    let symbols = equations.iter().flat_map(Equation::symbols);
    let stems = symbols.filter_map(|own| match own.place(index)? {
        (stem, Place::Number(_)) => Some(stem),
        _ => None,
    });
    stems.collect()
}

/// Whether two elements of one sequence, a fixed number of places from each other, are among those that run with an index.
pub(super) fn recurs(offsets: &Offsets) -> bool {
    offsets.values().any(|(least, greatest)| least < greatest)
}

/// Whether a formula that is given can be meant for every index: it shows the index on both sides, or speaks besides of
/// nothing that could depend on it.
fn shows_index(page: &Page, formula: &Formula, index: &Symbol) -> bool {
    let Formula::Relation { left, right, .. } = formula else {
        return false;
    };
    left.depends_on(index) && right.depends_on(index) || {
        let constant = |s: &Symbol| page.domains.get(s).is_some_and(|d| d.constant);
        let mut plain = plain(formula, index).into_iter().peekable();
        // `u_{n+1} = 0` may be said of one ball among many.
        plain.peek().is_some() && plain.all(|symbol| constant(&symbol))
    }
}

/// Whether a formula says no more than the declared domain of an index: "For $n \geq 1$" of a natural number.
fn is_declared(page: &Page, formula: &Formula, index: &Symbol) -> bool {
    let domain = page.domains.get(index);
    let own = Expr::Symbol(index.clone());
    domain.is_some_and(|domain| domain.formulas(&own).contains(formula))
}

/// The symbols and sequences of a formula that are neither an index nor have it in their names.
fn plain(formula: &Formula, index: &Symbol) -> Set<Symbol> {
    let all = formula.names().into_iter();
    let shows = |symbol: &Symbol| {
        let place = symbol.place(index).map(|(_, place)| place);
        symbol == index || matches!(place, Some(Place::Running(_) | Place::Unclear))
    };
    all.filter(|symbol| !shows(symbol)).collect()
}

/// The plain symbols that something ties to an index, directly or through others.
fn varying(page: &Page, given: &[Formula], index: &Symbol) -> Set<Symbol> {
    let constant = |s: &Symbol| page.domains.get(s).is_some_and(|d| d.constant);
    let runs = |stem: &Symbol| {
        given.iter().any(|f| {
            let symbols = f.free_symbols();
            let mut places = symbols.iter().filter_map(|s| s.place(index));
            places.any(|(own, place)| own == *stem && matches!(place, Place::Running(_)))
        })
    };
    let locals = page.locals.iter().flat_map(|local| &local.formulas);
    let all: Vec<&Formula> = given.iter().chain(locals.map(|f| &**f)).collect();
    let mut varying = Set::new();
    loop {
        let before = varying.len();
        for formula in &all {
            let plain = plain(formula, index);
            let tied = match formula.depends_on(index) {
                true => !shows_index(page, formula, index),
                false => !plain.is_disjoint(&varying),
            };
            if tied {
                let element = |s: &Symbol| matches!(s.place(index), Some((stem, Place::Number(_))) if runs(&stem));
                let own = plain.into_iter().filter(|s| !constant(s) && !element(s));
                varying.extend(own);
            }
        }
        if varying.len() == before {
            return varying;
        }
    }
}

impl Derivation {
    /// The indices that run on a page.
    pub fn running(&self, page: usize) -> &[Running] {
        self.running
            .get(page)
            .map(Vec::as_slice)
            .unwrap_or_default()
    }

    /// Whether something that is given is said of every value of an index: no hypothesis about the index is in effect
    /// where it stands but what is declared of it anyway, and nothing in it may depend on the index without showing it.
    pub fn is_given_throughout(&self, at: usize, formula: &Formula, running: &Running) -> bool {
        let equation = &self.equations[at];
        let page = &self.pages[equation.page];
        let mut locals = equation
            .locals
            .iter()
            .flat_map(|&at| &page.locals[at].formulas);
        formula.depends_on(&running.index)
            && shows_index(page, formula, &running.index)
            && !is_by_another(formula, &running.index)
            && !locals.any(|local| running.ties(local) && !is_declared(page, local, &running.index))
    }

    /// The claim that a goal follows for every value of an index, for each index that runs where it or its premises stand.
    /// `is_throughout` says which hypotheses are said of every value.
    pub fn for_every(
        &self,
        at: usize,
        assumed: &[Assumed],
        goal: &Formula,
        is_throughout: impl Fn(&Assumed, &Symbol) -> bool,
    ) -> Vec<ForEvery> {
        let own = self.equations[at].page;
        let others = assumed.iter().filter_map(|a| match a.source {
            Source::Equation(premise) => Some(self.equations[premise].page),
            _ => None,
        });
        let mut pages: Vec<usize> = std::iter::once(own).chain(others).collect();
        let mut seen = Set::new();
        pages.retain(|&page| seen.insert(page));
        let running = pages.iter().flat_map(|&page| self.running(page));
        let mut indices: Set<&Symbol> = running.map(|running| &running.index).collect();
        let summed = limits_of_sums(goal);
        indices.extend(&summed);
        let found = indices.into_iter().filter_map(|index| {
            let declared = |page: &usize| self.pages[*page].domains.get(index);
            let runs = |symbol: &Symbol| {
                let running = |f: &Formula| {
                    let symbols = f.free_symbols();
                    let mut places = symbols.iter().filter_map(|s| s.place(index));
                    let own = symbol.place(index).map(|(stem, _)| stem);
                    places.any(|(stem, place)| {
                        Some(stem) == own && matches!(place, Place::Running(_))
                    })
                };
                assumed.iter().any(|a| running(&a.formula))
            };
            if !goal.depends_on(index) && !goal.free_symbols().iter().any(runs) {
                return None;
            }
            let range = pages.iter().find_map(declared)?;
            // Another page may let the same letter run elsewhere.
            let alike = |a: &Assumed| match a.source {
                Source::Equation(premise) => declared(&self.equations[premise].page) == Some(range),
                _ => false,
            };
            let hypotheses = assumed.iter().enumerate();
            let throughout: Set<usize> = hypotheses
                .filter(|(_, a)| a.formula.depends_on(index) && alike(a) && is_throughout(a, index))
                .map(|(position, _)| position)
                .collect();
            if throughout.is_empty() && !summed.contains(index) {
                return None;
            }
            let running = pages.iter().flat_map(|&page| self.running(page));
            let varying = running
                .filter(|running| running.index == *index)
                .flat_map(|running| running.varying.clone());
            let varying = varying.collect();
            let mut claim = self.claim(at, assumed, goal);
            claim.domains.insert(index.clone(), range.clone());
            let mut elements: Map<Symbol, Domain> = Map::new();
            for symbol in Formula::free_symbols_of(claim.formulas()) {
                if let Some((stem, _)) = symbol.place(index)
                    && !elements.contains_key(&stem)
                {
                    let general = running_symbol(&stem, index, 0);
                    let mut domains = pages
                        .iter()
                        .filter_map(|&p| self.pages[p].domains.get(&general));
                    if let Some(domain) = domains.next() {
                        elements.insert(stem, domain.clone());
                    }
                }
            }
            Some(ForEvery {
                claim,
                index: index.clone(),
                throughout,
                elements,
                varying,
            })
        });
        found.collect()
    }
}

/// The symbols that say how far the sums of a formula go, where their terms show the index.
fn limits_of_sums(formula: &Formula) -> Set<Symbol> {
    fn collect(term: &Expr, found: &mut Set<Symbol>) {
        if let Expr::Series {
            index, to, body, ..
        } = term
            && mentions_symbol(body, index)
        {
            found.extend(to.free_symbols());
        }
        let children = term.children();
        children.for_each(|child| collect(child, found));
    }
    let mut found = Set::new();
    let terms = formula.terms().into_iter();
    terms.for_each(|term| collect(term, &mut found));
    found
}

impl Running {
    /// Whether a formula speaks of the index, or of something that may depend on it.
    pub fn ties(&self, formula: &Formula) -> bool {
        formula.depends_on(&self.index) || !plain(formula, &self.index).is_disjoint(&self.varying)
    }
}
