//! What a derivation says of dimensions, put to the inference: scopes of symbols, statements in reading order.

mod by_name;
mod told;

use std::cell::LazyCell;
use std::collections::BTreeSet;
use std::ops::Deref;
use std::sync::Arc;

use crate::algebra::{Base, Dimension, Expr, Formula, Function, Rational, Symbol, element_parts};
use crate::derivation::{Derivation, Kind, Source, conditions, formulas, without_dots};
use crate::dimension::{Conflict, Inference, Reading, occur};
use crate::kernel::dimension::{Form, Said, Scope, Unknown, WellDimensioned};
use crate::notation::{Mark, Statement, measured};
use crate::sorted::Tree;

pub use self::told::Tells;
use self::told::Told;
use super::{Entry, Note, Verdict};

/// Statements that compare what differs in dimension, and what is known of all the others.
#[derive(Clone, Debug, Default)]
pub struct Dimensions {
    /// The conflicts, by equation and statement.
    pub conflicts: Tree<(usize, usize), Conflict<Source>>,
    /// Suppositions at fault, by page and position.
    pub suppositions: Tree<(usize, usize), Conflict<Source>>,
    /// The names of the unknowns.
    pub unknowns: Vec<Symbol>,
    /// What each page tells of what its symbols are measured in, where no dimension is declared.
    pub told: Vec<Told>,
    inference: Inference<Source>,
    /// What is said of the symbols of each page; empty where no dimension is declared.
    scopes: Vec<Arc<Scope>>,
    /// The statements under values that fix a unit: not compared.
    skipped: BTreeSet<usize>,
}

impl Dimensions {
    /// Reads a derivation. Where no dimension is declared, each statement is held only against the units that the text tells.
    pub fn of(derivation: &Derivation) -> Dimensions {
        match derivation.pages.iter().all(|p| p.dimensions.is_empty()) {
            true => Dimensions::told(derivation),
            false => Dimensions::inferred(derivation),
        }
    }

    /// Reads a derivation even where nothing is declared: then what is inferred says how dimensions hang together.
    pub fn inferred(derivation: &Derivation) -> Dimensions {
        let mut all = Dimensions::default();
        for page in 0..derivation.pages.len() {
            let scope = scope(derivation, page, &Tree::new(), &mut all);
            all.scopes.push(Arc::new(scope));
            all.page(derivation, page);
        }
        all
    }

    /// The kernel's evidence that a formula of an equation is well-dimensioned, where dimensions are declared.
    pub fn agreement(
        &self,
        derivation: &Derivation,
        at: usize,
        formula: &Formula,
    ) -> Option<WellDimensioned> {
        let scope = self.scopes.get(derivation.equations[at].page)?;
        let compared = !self.skipped.contains(&at);
        compared
            .then(|| self.inference.agreement(formula, scope))
            .flatten()
    }

    /// The dimension of a symbol of a page as far as it is known, and whether that is declared, there or on a page that it
    /// cites. Nothing for what does not occur.
    pub fn of_symbol(&self, page: usize, symbol: &Symbol) -> Option<(Form, bool)> {
        self.known(self.scopes.get(page)?.symbols.get(symbol)?)
    }

    /// The same for the elements of a sequence.
    pub fn of_sequence(&self, page: usize, sequence: &Symbol) -> Option<(Form, bool)> {
        self.known(self.scopes.get(page)?.sequences.get(sequence)?)
    }

    fn known(&self, said: &Said) -> Option<(Form, bool)> {
        let declared = matches!(said, Said::Declared(_));
        Some((self.inference.value(&Form::said(said)), declared))
    }

    /// Gives the verdict `ill-dimensioned` to the entries of an equation that deserve it. A counterexample that was
    /// found stays beside it.
    pub(super) fn mark(&self, entries: &mut [Entry]) {
        for entry in entries {
            if !self.conflicts.contains_key(&(entry.equation, entry.part)) {
                continue;
            }
            let ticked = entry.kind == Kind::Marked && entry.verdict == Verdict::Holds;
            entry.verdict = Verdict::IllDimensioned;
            entry.rests_on.clear();
            let rests = |note: &Note| matches!(note, Note::RestsOn(_) | Note::RestsOnUnproved(_));
            entry.notes.retain(|note| !rests(note));
            let crossed = |note: &Note| matches!(note, Note::WrongMark(Mark::Cross));
            match entry.notes.iter().position(crossed) {
                Some(at) => drop(entry.notes.remove(at)),
                None if ticked => entry.notes.push(Note::WrongMark(Mark::Tick)),
                None => {}
            }
        }
    }

    fn page(&mut self, derivation: &Derivation, page: usize) {
        let from = derivation.equations.partition_point(|e| e.page < page);
        let to = derivation.equations.partition_point(|e| e.page <= page);
        let locals = &derivation.pages[page].locals;
        let mut pending = (0..locals.len()).peekable();
        // What has a number for a value, by supposition: under `let v_0 = 1`, velocities may be compared with numbers.
        let mut numbers: Tree<usize, Vec<Said>> = Tree::new();
        let spoken = LazyCell::new(|| spoken_of(derivation, page));
        for at in from..to {
            let equation = &derivation.equations[at];
            while let Some(local) = pending.next_if(|&l| locals[l].span.start < equation.span.start)
            {
                self.supposition(derivation, page, local, &mut numbers);
            }
            let mut fixed = equation
                .locals
                .iter()
                .filter_map(|l| numbers.get(l))
                .flatten();
            if fixed.any(|said| self.is_quantity(said)) {
                self.skipped.insert(at);
                continue;
            }
            let own_constants = constants_of_pieces(equation.statements(), &spoken);
            for (part, statement) in equation.statements().iter().enumerate() {
                let mut compared = formulas(statement);
                compared.extend(conditions(statement));
                let scope = match own_constants.is_empty() {
                    true => Arc::clone(&self.scopes[page]),
                    false => self.scope_of_piece(page, &own_constants),
                };
                let readings = readings(&scope, compared);
                let crossed = is_crossed_out(statement);
                let read = self
                    .inference
                    .read(&readings, &Source::Equation(at), crossed);
                if let Err(conflict) = read {
                    self.conflicts.insert((at, part), *conflict);
                }
            }
        }
        for local in pending {
            self.supposition(derivation, page, local, &mut numbers);
        }
    }

    /// What is said of the symbols of a page, but for what may be another thing in each piece.
    fn scope_of_piece(&mut self, page: usize, own: &BTreeSet<Symbol>) -> Arc<Scope> {
        let mut scope = Scope::clone(&self.scopes[page]);
        for symbol in own {
            if matches!(scope.symbols.get(symbol), Some(Said::Unknown(_))) {
                let unknown = self.unknown(symbol);
                scope.symbols.insert(symbol.clone(), unknown);
            }
        }
        Arc::new(scope)
    }

    fn supposition(
        &mut self,
        derivation: &Derivation,
        page: usize,
        at: usize,
        numbers: &mut Tree<usize, Vec<Said>>,
    ) {
        let local = derivation.local(page, at);
        let mut formulas = local.formulas.clone();
        formulas.retain(|own| !is_trial(own));
        formulas.retain(|formula| match number_for(&self.scopes[page], formula) {
            Some(said) => {
                numbers.entry(at).or_default().push(said);
                false
            }
            None => true,
        });
        let formulas = formulas.iter().map(|f| Formula::clone(f)).collect();
        let readings = readings(&self.scopes[page], formulas);
        if let Err(conflict) = self
            .inference
            .read(&readings, &Source::Local(page, at), false)
        {
            self.suppositions.insert((page, at), *conflict);
        }
    }

    /// Whether something is known to be more than a pure number.
    fn is_quantity(&self, said: &Said) -> bool {
        let value = self.inference.value(&Form::said(said));
        value
            .dimension()
            .is_some_and(|dimension| !dimension.is_none())
    }

    fn unknown(&mut self, name: &Symbol) -> Said {
        self.unknowns.push(name.clone());
        Said::Unknown(Unknown(self.unknowns.len() - 1))
    }
}

fn readings(scope: &Arc<Scope>, formulas: Vec<Formula>) -> Vec<Reading> {
    let reading = |formula| Reading {
        formula,
        scope: Arc::clone(scope),
    };
    formulas.into_iter().map(reading).collect()
}

/// How many displays of a page speak of each symbol; what is supposed besides counts for two.
fn spoken_of(derivation: &Derivation, page: usize) -> Tree<Symbol, usize> {
    let mut found = Tree::new();
    let mut count = |formulas: Vec<Formula>, times: usize| {
        let all: BTreeSet<Symbol> = formulas.iter().flat_map(Formula::free_symbols).collect();
        for symbol in all {
            *found.entry(symbol).or_default() += times;
        }
    };
    for at in derivation.equations_of(page) {
        let statements = derivation.equations[at].statements().iter();
        count(statements.flat_map(formulas).collect(), 1);
    }
    for local in &derivation.pages[page].locals {
        count(
            local
                .formulas
                .iter()
                .map(|own| Formula::clone(own))
                .collect(),
            2,
        );
    }
    found
}

/// The symbols that stand in a display by pieces alone, `(A + B t) e^{-γ t}` for `γ = ω` and `A e^{α t} + B e^{β t}` for `γ > ω`: constants,
/// and in each piece they may be others.
fn constants_of_pieces(
    pieces: &[Statement],
    spoken: &impl Deref<Target = Tree<Symbol, usize>>,
) -> BTreeSet<Symbol> {
    if pieces.len() < 2 || pieces.iter().any(|own| own.under.is_empty()) {
        return BTreeSet::new();
    }
    let formulas: Vec<Formula> = pieces.iter().flat_map(formulas).collect();
    let own = formulas.iter().flat_map(Formula::free_symbols);
    own.filter(|own| spoken.get(own) == Some(&1)).collect()
}

/// Whether a supposition is one that is tried, `x = e^{s t}`: the amplitude is left out, and with it the dimension.
fn is_trial(formula: &Formula) -> bool {
    use Function::{Cos, Exp, Sin};
    let is_name = |side: &Expr| matches!(side, Expr::Symbol(_) | Expr::Apply(..));
    let is_wave = |side: &Expr| matches!(side, Expr::Call(Exp | Sin | Cos, _));
    // "A wave of unit amplitude comes from the left, $\psi = e^{i k x} + r e^{-i k x}$"
    let is_shape = |side: &Expr| match side {
        Expr::Sum(terms) => terms.iter().any(is_wave),
        side => is_wave(side),
    };
    formula
        .as_equation()
        .is_some_and(|(left, right)| is_name(left) && is_shape(right))
}

/// What a supposition such as `v_0 = 1` gives a number to.
fn number_for(scope: &Scope, formula: &Formula) -> Option<Said> {
    let zero = Expr::integer(0);
    let number = |term: &Expr| closed(term) && *term != zero;
    match formula {
        Formula::Relation {
            left: Expr::Symbol(symbol),
            right,
            ..
        } if number(right) => scope.symbols.get(symbol).cloned(),
        Formula::AllEqual {
            sequence,
            value: Some(value),
            ..
        } if number(value) => scope.sequences.get(sequence).cloned(),
        _ => None,
    }
}

/// Whether no name occurs in a term.
fn closed(term: &Expr) -> bool {
    let formula = Formula::nonzero(term.clone());
    let mut open = formula.sequences().len();
    occur::symbols(&formula, &mut |_| open += 1);
    open == 0
}

fn is_crossed_out(statement: &Statement) -> bool {
    statement
        .mark
        .as_ref()
        .is_some_and(|m| m.value == Mark::Cross)
}

/// What is said of the symbols of a page: declared there, or on a page whose equations it cites, or known there;
/// otherwise unknown, and the page's own.
fn scope(
    derivation: &Derivation,
    page: usize,
    told: &Tree<Symbol, Dimension>,
    all: &mut Dimensions,
) -> Scope {
    let own = &derivation.pages[page];
    let from = derivation.equations.partition_point(|e| e.page < page);
    let to = derivation.equations.partition_point(|e| e.page <= page);
    let mut cited: Vec<usize> = Vec::new();
    for at in from..to {
        let (premises, ..) = derivation.premises(at);
        let pages = premises
            .iter()
            .map(|&premise| derivation.equations[premise].page);
        cited.extend(pages.filter(|&other| other != page));
    }
    let mut seen = BTreeSet::new();
    cited.retain(|&other| seen.insert(other));

    let equations = derivation.equations[from..to].iter();
    let mut stated: Vec<Formula> = equations
        .flat_map(|e| e.statements())
        .flat_map(|statement| [formulas(statement), conditions(statement)].concat())
        .collect();
    stated.extend(
        own.locals
            .iter()
            .flat_map(|l| l.formulas.iter().map(|f| Formula::clone(f))),
    );

    let declared = |symbol: &Symbol| {
        let there = cited
            .iter()
            .filter_map(|&other| derivation.pages[other].dimensions.get(symbol));
        own.dimensions
            .get(symbol)
            .or_else(|| there.into_iter().next())
    };
    let earlier = |all: &Dimensions, find: &dyn Fn(&Scope) -> Option<Said>| {
        let before = cited.iter().filter(|&&other| other < page);
        before
            .filter_map(|&other| all.scopes.get(other))
            .find_map(|scope| find(scope))
    };
    let mut scope = Scope::default();
    let of_page = own.dimensions.iter().chain(told.iter());
    scope
        .symbols
        .extend(of_page.map(|(s, d)| (s.clone(), Said::Declared(d.clone()))));
    let mut graded: BTreeSet<&Symbol> = BTreeSet::new();
    for formula in &stated {
        occur::graded(formula, &mut |sequence| {
            graded.insert(sequence);
        });
    }
    for formula in &stated {
        occur::sequences(formula, &mut |sequence| {
            let element = format!("{sequence}_");
            let declared = || {
                own.dimensions
                    .keys()
                    .any(|s| s.name().starts_with(&element))
            };
            if graded.contains(sequence) && !declared() {
                return;
            }
            if scope.sequences.contains_key(sequence) {
                return;
            }
            let there = || {
                cited
                    .iter()
                    .find_map(|&other| derivation.pages[other].element_dimension(sequence))
            };
            let said = match own.element_dimension(sequence).or_else(there) {
                Some(dimension) => Said::Declared(dimension.clone()),
                None => earlier(all, &|scope| scope.sequences.get(sequence).cloned())
                    .unwrap_or_else(|| all.unknown(sequence)),
            };
            scope.sequences.insert(sequence.clone(), said);
        });
    }
    for formula in &stated {
        occur::symbols(formula, &mut |symbol| {
            if scope.symbols.contains_key(symbol) {
                return;
            }
            let element =
                || element_parts(symbol).and_then(|(sequence, _)| scope.sequences.get(&sequence));
            let dotted = || {
                let (name, dots) = without_dots(symbol)?;
                Some(
                    declared(&name)?
                        .over(&Dimension::base(Base::Time).power(&Rational::from(i32::from(dots)))),
                )
            };
            // Nobody declares π, but who means something else by it.
            let is_number = !own.domains.contains_key(symbol);
            let pi = || (is_number && symbol.name() == "\\pi").then(Dimension::none);
            let unit = || measured(symbol).map(Dimension::base);
            let known = declared(symbol).cloned().or_else(dotted).or_else(pi);
            let said = match known.or_else(unit) {
                Some(dimension) => Said::Declared(dimension),
                None => element()
                    .cloned()
                    .or_else(|| earlier(all, &|scope| scope.symbols.get(symbol).cloned()))
                    .unwrap_or_else(|| all.unknown(symbol)),
            };
            scope.symbols.insert(symbol.clone(), said);
        });
    }
    scope
}
