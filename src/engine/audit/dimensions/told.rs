//! The units in which a text gives its quantities, where no dimension is declared: `\rho = 998\,\mathrm{kg/m^3}`.
//!
//! Many texts leave units out where they calculate: only what is said in symbols is compared. A statement is at fault where it disagrees with
//! itself once these have the dimensions that the text gives them in. What the text calls by the names of quantities, "a rod of length $L$", is
//! less certain: with these all that the page says is held together, and one statement is at fault where all the others agree without it.

use std::cell::LazyCell;
use std::sync::Arc;

use crate::algebra::{Dimension, Expr, Formula, Function, Rational, Symbol};
use crate::derivation::{Derivation, Source, formulas, without_dots};
use crate::dimension::{Conflict, Inference, occur};
use crate::document::Quantity;
use crate::kernel::dimension::Scope;
use crate::notation::{has_decimals, has_units, is_figures, measured, si_beside};
use crate::sorted::{self, Set, Tree};

use super::by_name::{chooses_units, constants, quantities, time};
use super::{Dimensions, constants_of_pieces, is_crossed_out, readings, scope, spoken_of};

/// Of so many statements that disagree it is asked whether all others agree.
const MOST_INVOLVED: usize = 12;

/// What a text says that symbols are measured in.
pub type Told = Tree<Symbol, Measured>;

/// What a symbol is measured in, and how that is known.
#[derive(Clone, Debug)]
pub struct Measured {
    /// Its dimension.
    pub dimension: Dimension,
    /// How that is known.
    pub by: Tells,
}

/// How it is known what a symbol is measured in.
#[derive(Clone, Debug)]
pub enum Tells {
    /// Its value is given in units.
    Units(Formula),
    /// Its value is given in units that stand beside it: "$d = 2.00$ mm".
    Beside(Formula),
    /// The text calls it by the name of a quantity.
    Name(Quantity),
    /// By it are rates, where nothing else is said.
    Rates,
    /// Its letter is that of a constant of nature.
    Letter(&'static str),
}

impl Tells {
    /// Whether the text says so plainly. A name may be used for something else, and a letter all the more.
    fn is_plain(&self) -> bool {
        match self {
            Tells::Units(_) => true,
            Tells::Name(quantity) => quantity.is_explained,
            Tells::Beside(_) | Tells::Rates | Tells::Letter(_) => false,
        }
    }

    /// Whether one name says both.
    fn is_said_with(&self, other: &Tells) -> bool {
        match (self, other) {
            (Tells::Name(own), Tells::Name(other)) => own.first == other.first,
            _ => false,
        }
    }
}

/// A statement in symbols, or what is supposed.
struct Row {
    source: Source,
    part: usize,
    formulas: Vec<Formula>,
    is_crossed: bool,
}

impl Dimensions {
    /// Holds each statement against the units that its page tells, and all of them against one another.
    pub(super) fn told(derivation: &Derivation) -> Dimensions {
        let mut all = Dimensions::default();
        for page in 0..derivation.pages.len() {
            let mut rows = rows(derivation, page);
            let told = in_units(derivation, page);
            let firm = known(&told)
                .into_entries()
                .filter(|(_, own)| own.by.is_plain());
            let is_amiss = all.alone(derivation, page, &rows, &firm.collect());
            let told = with_names(derivation, page, told, &mut rows);
            // That something is a time alone contradicts nothing.
            let is_named = (told.iter()).any(|(_, own)| !matches!(own.by, Tells::Rates));
            if is_named && !is_amiss && !chooses_units(&derivation.pages[page]) {
                all.together(derivation, page, &rows, &told);
            }
            all.told.push(told);
        }
        all
    }

    /// Each statement of a page by itself. Gives whether one is at fault.
    fn alone(&mut self, derivation: &Derivation, page: usize, rows: &[Row], told: &Told) -> bool {
        if told.is_empty() {
            return false;
        }
        let scope = Arc::new(self.scope_with(derivation, page, told));
        let mut is_amiss = false;
        for row in rows {
            if let Source::Equation(at) = row.source
                && let Err(conflict) = row.read(&mut Inference::default(), &scope, &row.source)
            {
                self.conflicts.insert((at, row.part), *conflict);
                is_amiss = true;
            }
        }
        is_amiss
    }

    /// All statements of a page held against one another. That they do not agree is said where they would without one of them, and would
    /// not whatever is measured otherwise than its name says.
    fn together(&mut self, derivation: &Derivation, page: usize, rows: &[Row], told: &Told) {
        let scope = Arc::new(self.scope_with(derivation, page, told));
        let Some(first) = disagreement(rows, &scope, None) else {
            return;
        };
        let mut involved: Vec<usize> = first.origins.clone();
        sorted::sort(&mut involved);
        involved.dedup();
        let is_at_fault = |at: &usize| {
            let is_statement = matches!(rows[*at].source, Source::Equation(_));
            is_statement && disagreement(rows, &scope, Some(*at)).is_none()
        };
        let mut at_fault = involved.into_iter().rev().take(MOST_INVOLVED);
        let Some(at) = at_fault.find(is_at_fault) else {
            return;
        };
        let parts = first.evidence.parts().iter();
        let names: Set<Symbol> = parts.flat_map(|part| part.formula.names()).collect();
        for name in &names {
            if let Some(doubted) = told.get(name)
                && !doubted.by.is_plain()
            {
                let others = told
                    .iter()
                    .filter(|(own, other)| *own != name && !doubted.by.is_said_with(&other.by));
                let others = others
                    .map(|(own, told)| (own.clone(), told.clone()))
                    .collect();
                let scope = Arc::new(self.scope_with(derivation, page, &others));
                if disagreement(rows, &scope, None).is_none() {
                    return;
                }
            }
        }
        let Source::Equation(equation) = rows[at].source else {
            return;
        };
        // What is at fault is read last: then it disagrees with the others.
        let mut inference = Inference::default();
        for (other, row) in rows.iter().enumerate() {
            if other != at {
                let _ = row.read(&mut inference, &scope, &row.source);
            }
        }
        if let Err(conflict) = rows[at].read(&mut inference, &scope, &rows[at].source) {
            let rest = rows[at].but_a_letter_named_anew(derivation, equation, rows);
            let agrees = |rest: &[Formula]| {
                let readings = readings(&scope, rest.to_vec());
                (inference.read(&readings, &rows[at].source, rows[at].is_crossed)).is_ok()
            };
            if !rest.is_some_and(agrees) {
                self.conflicts.insert((equation, rows[at].part), *conflict);
            }
        }
    }

    fn scope_with(&mut self, derivation: &Derivation, page: usize, told: &Told) -> Scope {
        let dimensions = told
            .iter()
            .map(|(own, told)| (own.clone(), told.dimension.clone()));
        scope(derivation, page, &dimensions.collect(), self)
    }
}

impl Row {
    /// Writes what has dots as what it is the rate of: with each other they say what both are measured in.
    fn write_rates(&mut self, time: &Symbol) {
        let is_dotted = |part: &Expr| dotted(part).is_some();
        for formula in &mut self.formulas {
            if formula.terms().into_iter().any(|term| term.any(&is_dotted)) {
                *formula = formula.map_terms(|term| with_rates(term, time));
            }
        }
    }

    /// A chain without the letter with which it begins, where only another section speaks of that and it may be something else here: `Q` is
    /// a charge, and then $$Q = \frac{\omega_0}{\Delta\omega} = \frac{1}{R} \sqrt{\frac{L}{C}}$$ the quality of a circuit.
    fn but_a_letter_named_anew(
        &self,
        derivation: &Derivation,
        equation: usize,
        rows: &[Row],
    ) -> Option<&[Formula]> {
        let [Formula::Relation { left, .. }, rest @ ..] = &self.formulas[..] else {
            return None;
        };
        let Expr::Symbol(letter) = left else {
            return None;
        };
        let section = derivation.section_start(equation);
        let is_before = |own: &Source| match *own {
            Source::Local(page, at) => {
                let start = derivation.equations[section].span.start;
                derivation.local(page, at).span.start < start
            }
            Source::Equation(other) => other < section || other == equation,
            _ => true,
        };
        let speaks = |row: &&Row| row.formulas.iter().any(|own| own.names().contains(letter));
        let mut speaking = rows.iter().filter(speaks);
        (!rest.is_empty() && speaking.all(|row| is_before(&row.source))).then_some(rest)
    }

    /// Reads it on top of what is known.
    fn read<O: Clone>(
        &self,
        inference: &mut Inference<O>,
        scope: &Arc<Scope>,
        origin: &O,
    ) -> Result<(), Box<Conflict<O>>> {
        let readings = readings(scope, self.formulas.clone());
        inference.read(&readings, origin, self.is_crossed)
    }
}

/// A term with `\frac{dx}{dt}` for `\dot x`.
fn with_rates(term: &Expr, time: &Symbol) -> Expr {
    match dotted(term) {
        Some((name, dots)) => {
            (0..dots).fold(Expr::Symbol(name), |term, _| term.differentiated_by(time))
        }
        None => term.map_children(|part| with_rates(part, time)),
    }
}

/// What has the dots in a symbol that has some, and how many they are.
fn dotted(term: &Expr) -> Option<(Symbol, u8)> {
    match term {
        Expr::Symbol(own) => without_dots(own),
        _ => None,
    }
}

/// The first disagreement of some rows, but for one that is left out.
fn disagreement(
    rows: &[Row],
    scope: &Arc<Scope>,
    but: Option<usize>,
) -> Option<Box<Conflict<usize>>> {
    let mut inference = Inference::default();
    let mut read = (rows.iter().enumerate()).filter(|(at, _)| but != Some(*at));
    read.find_map(|(at, row)| row.read(&mut inference, scope, &at).err())
}

/// What a page says in symbols.
fn rows(derivation: &Derivation, page: usize) -> Vec<Row> {
    let mut rows = Vec::new();
    let locals = derivation.pages[page].locals.iter().enumerate();
    for (at, local) in locals {
        let formulas = local
            .formulas
            .iter()
            .map(|own| Formula::clone(own))
            .filter(|own| is_symbolic(own) && !super::is_trial(own));
        rows.push((
            local.span.start,
            Row {
                source: Source::Local(page, at),
                part: 0,
                formulas: formulas.collect(),
                is_crossed: false,
            },
        ));
    }
    let spoken = LazyCell::new(|| spoken_of(derivation, page));
    for at in derivation.equations_of(page) {
        let equation = &derivation.equations[at];
        let constants = constants_of_pieces(equation.statements(), &spoken);
        let is_constant = |own: &Symbol| constants.contains(own);
        for (part, statement) in equation.statements().iter().enumerate() {
            // What they are in another piece they need not be in this one.
            if part > 0
                && !constants.is_empty()
                && formulas(statement)
                    .iter()
                    .any(|own| own.free_symbols().iter().any(is_constant))
            {
                continue;
            }
            rows.push((
                equation.span.start,
                Row {
                    source: Source::Equation(at),
                    part,
                    formulas: formulas(statement)
                        .into_iter()
                        .filter(is_symbolic)
                        .collect(),
                    is_crossed: is_crossed_out(statement),
                },
            ));
        }
    }
    for (_, row) in &mut rows {
        // "$x = \dot x = 0$"
        if row.formulas.iter().any(is_zero) {
            row.formulas.retain(|own| !is_of_two_names(own));
        }
    }
    // What is said with the imaginary unit may be a function of it that is read as a product.
    let own = &derivation.pages[page];
    if !own.complex.is_empty() {
        let is_real = |formula: &Formula| {
            let names = formula.names();
            !names.iter().any(|name| own.is_imaginary_unit(name))
        };
        for (_, row) in &mut rows {
            row.formulas.retain(is_real);
        }
    }
    rows.sort_by_key(|(start, _)| *start);
    rows.into_iter().map(|(_, row)| row).collect()
}

/// What is told of a page's symbols with units and by names. Where dots are rates by the time, its rows are written so.
fn with_names(
    derivation: &Derivation,
    page: usize,
    mut told: Tree<Symbol, Option<Measured>>,
    rows: &mut [Row],
) -> Told {
    let page = &derivation.pages[page];
    for (symbol, own) in quantities(page) {
        let known = told.entry(symbol).or_insert_with(|| Some(own.clone()));
        // "A ball of diameter $d$" and "$d = 2.00$ mm" agree, and then there is no doubt.
        if let Some(Measured {
            dimension,
            by: Tells::Beside(words),
        }) = known
        {
            *known = (*dimension == own.dimension).then(|| Measured {
                dimension: own.dimension,
                by: Tells::Units(words.clone()),
            });
        }
    }
    let (symbol, own) = time();
    let time = told.entry(symbol.clone()).or_insert(Some(own.clone()));
    if (time.as_ref()).is_some_and(|time| time.dimension == own.dimension) {
        rows.iter_mut().for_each(|row| row.write_rates(&symbol));
    }
    let mut names: Set<Symbol> = Set::new();
    for formula in rows.iter().flat_map(|row| &row.formulas) {
        occur::symbols(formula, &mut |symbol| {
            names.insert(symbol.clone());
        });
    }
    // A `G(s) = …` is a function, and no constant of nature.
    let given = rows.iter().flat_map(|row| &row.formulas);
    let given: Set<&Symbol> = given
        .filter_map(|formula| match formula.as_equation() {
            Some((Expr::Apply(name, _), _)) => Some(name),
            _ => None,
        })
        .collect();
    let of_nature = constants(page, &names).into_iter();
    for (symbol, own) in of_nature.filter(|own| !given.contains(&own.0)) {
        told.entry(symbol).or_insert(Some(own));
    }
    let told = known(&told);
    let spoken_of = told.iter().filter(|(symbol, _)| names.contains(*symbol));
    let spoken_of = spoken_of.map(|(symbol, own)| (symbol.clone(), own.clone()));
    spoken_of.collect()
}

/// What of this is known for certain.
fn known(told: &Tree<Symbol, Option<Measured>>) -> Told {
    let known = |(symbol, own): (&Symbol, &Option<Measured>)| Some((symbol.clone(), own.clone()?));
    told.iter().filter_map(known).collect()
}

/// What a page tells with units; nothing of what it gives in several dimensions, or once without units.
fn in_units(derivation: &Derivation, page: usize) -> Tree<Symbol, Option<Measured>> {
    let last = derivation.equations_of(page).last();
    let printed = last
        .map(|at| derivation.figures_before(at))
        .unwrap_or_default();
    // "$d = 2.00$ mm" is read as it is put in, in metres.
    let source = &derivation.pages[page].document.source;
    let mut beside: Vec<(Formula, Formula)> = Vec::new();
    for own in printed.iter().filter(|own| own.equation.is_none()) {
        let formula = &own.goal.formula;
        if let Some((of, value)) = formula.as_equation()
            && !has_units(value)
            && let Some(unit) = si_beside(source, own.span.end)
        {
            let value = Expr::Product([value.clone(), unit].into());
            beside.push((formula.clone(), Formula::equal(of.clone(), value)));
        }
    }
    let with_unit = |formula: Formula| match beside.iter().find(|own| own.0 == formula) {
        Some((_, own)) => (own.clone(), true),
        None => (formula, false),
    };
    let locals = derivation.pages[page].locals.iter();
    let supposed = locals.flat_map(|local| local.formulas.iter().map(|own| Formula::clone(own)));
    let printed = printed.iter().map(|own| own.goal.formula.clone());
    let mut found: Tree<Symbol, Option<Measured>> = Tree::new();
    for (formula, is_beside) in supposed.chain(printed).map(with_unit) {
        let Some((Expr::Symbol(symbol), value)) = formula.as_equation() else {
            continue;
        };
        if !is_figures(value) || *value == Expr::integer(0) {
            continue;
        }
        let own = dimension_of(value).filter(|_| has_units(value));
        let own = own.map(|dimension| Measured {
            dimension,
            by: match is_beside {
                true => Tells::Beside(formula.clone()),
                false => Tells::Units(formula.clone()),
            },
        });
        let known = found.entry(symbol.clone()).or_insert_with(|| own.clone());
        let dimension = |of: &Option<Measured>| of.as_ref().map(|own| own.dimension.clone());
        if dimension(known) != dimension(&own) {
            *known = None;
        }
    }
    found
}

/// The dimension of so many units.
fn dimension_of(quantity: &Expr) -> Option<Dimension> {
    let one = Rational::from(1);
    match quantity {
        Expr::Number(_) => Some(Dimension::none()),
        Expr::Negate(inner) => dimension_of(inner),
        Expr::Symbol(unit) => measured(unit).map(Dimension::base),
        Expr::Product(factors) => {
            let mut all = Dimension::none();
            for factor in factors.iter() {
                all.multiply(&dimension_of(factor)?, &one);
            }
            Some(all)
        }
        Expr::Quotient(over, under) => Some(dimension_of(over)?.over(&dimension_of(under)?)),
        Expr::Power(base, exponent) => match &**exponent {
            Expr::Number(exponent) => {
                Some(dimension_of(base)?.power(&Rational::from(exponent.clone())))
            }
            _ => None,
        },
        _ => None,
    }
}

/// Whether one side of a formula is 0.
fn is_zero(formula: &Formula) -> bool {
    formula
        .terms()
        .into_iter()
        .any(|own| *own == Expr::integer(0))
}

/// Whether both sides of a formula are names, or how fast something changes.
fn is_of_two_names(formula: &Formula) -> bool {
    let is_name = |own: &Expr| {
        matches!(
            own,
            Expr::Symbol(_) | Expr::Apply(..) | Expr::Derivative { .. } | Expr::Partial { .. }
        )
    };
    formula.terms().into_iter().all(is_name)
}

/// Whether a formula is said in symbols, but for a side that is so many units: no numbers are put in, and no unit may be left out.
fn is_symbolic(formula: &Formula) -> bool {
    let is_quantity = |term: &Expr| has_units(term) && dimension_of(term).is_some();
    let is_plain = |term: &Expr| {
        let is_figure = is_figures(term) && *term != Expr::integer(0);
        !is_figure && !has_units(term) && !has_decimals(term) && !term.any(&may_lack_units)
    };
    let mut terms = formula.terms().into_iter();
    terms.all(|term| is_quantity(term) || is_plain(term))
}

/// Whether a part of a term may be a number of units, or is a logarithm of one: `5 + 2 t`, `\ln p`.
fn may_lack_units(part: &Expr) -> bool {
    let is_one = |own: &Expr| *own == Expr::integer(1) || *own == Expr::integer(-1);
    let is_number = |own: &Expr| match own {
        Expr::Negate(inner) => matches!(**inner, Expr::Number(_)) && !is_one(inner),
        own => matches!(own, Expr::Number(_)) && !is_one(own),
    };
    match part {
        Expr::Sum(terms) => terms.iter().any(is_number),
        Expr::Call(Function::Ln, of) => !matches!(**of, Expr::Quotient(..)),
        _ => false,
    }
}
