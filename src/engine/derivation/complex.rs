//! What is said of complex numbers, as what is said of their real and their imaginary parts: `Z = R + j X` as `\text{Re}(Z) = R` and
//! `\text{Im}(Z) = X`. Claims are about real numbers, and so they stay.
//!
//! A symbol is real unless something shows that it is not: an equation that gives it by what is complex, `Z = R + j X`, or one side of an
//! equation that could not be as complex as the other, `V/I = R + j X`. A statement of which it is not clear what in it is complex, or of
//! which the parts cannot be written, is left as it is, and nothing is decided of it.

mod parts;

use std::collections::BTreeSet;

use crate::algebra::{Atoms, Expr, Formula, Function, Lowering, Relation, Symbol};
use crate::notation::{Clause, Side, Statement, measured};
use crate::sorted::Set;

use super::Equation;
use super::equation::{conditions, formulas, of_page, of_pages, terms_of_clause};
use super::page::Page;
pub(crate) use parts::parts_of;
use parts::{Complex, Kind, Parts, is_zero, part_names};

/// What is complex with what is complex, and so on: so many times at most.
const MOST_ROUNDS: usize = 12;

/// Which symbols of a document are complex, as far as it shows.
struct Natures<'a> {
    units: &'a BTreeSet<Symbol>,
    complex: BTreeSet<Symbol>,
    /// What is positive, compared or a number, and cannot be complex.
    real: BTreeSet<Symbol>,
    /// What stands in the argument of a function: it is real unless an equation gives it otherwise.
    likely_real: BTreeSet<Symbol>,
    /// What stands in terms with the unit, `R` of `R + j X`: it is real unless nothing else in an equation can be complex.
    beside_unit: BTreeSet<Symbol>,
    /// What is differentiated.
    moving: BTreeSet<Symbol>,
    /// What is real, and given by something complex: of these nothing is decided.
    disputed: BTreeSet<Symbol>,
}

/// Sides that are equal.
struct Said {
    sides: Vec<Expr>,
    /// In a display, and not in the text: what is said there may be so in one case.
    shown: bool,
}

/// Takes apart what a document says of complex numbers; `own` are its pages, and `units` the letters for the imaginary unit. What is left
/// complex is noted on the pages.
pub(super) fn take_apart(
    own: &[usize],
    pages: &mut [Page],
    equations: &mut [Equation],
    units: &BTreeSet<Symbol>,
) {
    let mut natures = Natures::of(own, pages, equations, units);
    let chains = said(own, pages, equations);
    let mut is_settled = false;
    for _ in 0..MOST_ROUNDS {
        is_settled = !natures.learn(&chains);
        if is_settled {
            break;
        }
    }
    if !is_settled {
        // What else is complex is not known.
        let names = chains
            .iter()
            .flat_map(|own| Formula::names_in(own.sides.iter()));
        natures.disputed.extend(names);
    }
    let shown = chains.iter().filter(|own| own.shown);
    let disputed: Vec<Symbol> = shown
        .flat_map(|own| natures.disputed_by(&own.sides))
        .collect();
    natures.disputed.extend(disputed);
    for equation in of_pages(own, equations) {
        natures.take_equation_apart(equation);
    }
    for &at in own {
        let page = &mut pages[at];
        for local in &mut page.locals {
            let formulas = std::mem::take(&mut local.formulas);
            local.formulas = formulas
                .into_iter()
                .flat_map(|formula| match natures.formula_apart(&formula) {
                    Some(parts) => parts.into_iter().map(Into::into).collect(),
                    None => vec![formula],
                })
                .collect();
        }
        for symbol in &natures.complex {
            let (re, im) = part_names(symbol);
            if let Some(dimension) = page.dimensions.get(symbol).cloned() {
                page.dimensions.insert(re.clone(), dimension.clone());
                page.dimensions.insert(im.clone(), dimension);
            }
            if let Some(quantity) = page.quantities.get(symbol).copied() {
                page.quantities.insert(re, quantity);
                page.quantities.insert(im, quantity);
            }
        }
        let all = units
            .iter()
            .chain(&natures.complex)
            .chain(&natures.disputed);
        page.complex = all.cloned().collect();
    }
}

/// What the displays of some pages say is equal, and their text.
fn said(own: &[usize], pages: &[Page], equations: &[Equation]) -> Vec<Said> {
    let equations = own
        .iter()
        .flat_map(|&at| &equations[of_page(at, equations)]);
    let clauses = equations
        .flat_map(Equation::statements)
        .flat_map(|own| &own.clauses);
    let displayed = clauses
        .filter_map(equal_sides)
        .map(|sides| Said { sides, shown: true });
    let locals = own.iter().flat_map(|&at| &pages[at].locals);
    let told = locals.flat_map(|local| &local.formulas);
    let told = told.filter_map(|formula| {
        let (left, right) = formula.as_equation()?;
        let (sides, shown) = (vec![left.clone(), right.clone()], false);
        Some(Said { sides, shown })
    });
    displayed.chain(told).collect()
}

impl<'a> Natures<'a> {
    fn of(
        own: &[usize],
        pages: &[Page],
        equations: &[Equation],
        units: &'a BTreeSet<Symbol>,
    ) -> Natures<'a> {
        let mut natures = Natures {
            units,
            complex: BTreeSet::new(),
            real: BTreeSet::new(),
            likely_real: BTreeSet::new(),
            beside_unit: BTreeSet::new(),
            moving: BTreeSet::new(),
            disputed: BTreeSet::new(),
        };
        for &at in own {
            let page = &pages[at];
            let confined = page
                .domains
                .iter()
                .filter(|(_, own)| own.lower.is_some() || own.upper.is_some() || own.integer);
            natures
                .real
                .extend(confined.map(|(symbol, _)| symbol.clone()));
            let told = page.locals.iter().flat_map(|local| &local.formulas);
            told.for_each(|formula| natures.see(formula));
            for equation in &equations[of_page(at, equations)] {
                for (symbol, said) in &equation.said {
                    if said.has_sign() {
                        natures.real.insert(symbol.clone());
                    }
                }
                for statement in equation.statements() {
                    let all = formulas(statement).into_iter().chain(conditions(statement));
                    all.for_each(|formula| natures.see(&formula));
                }
            }
        }
        natures.real.retain(|own| !units.contains(own));
        natures.likely_real.retain(|own| !units.contains(own));
        let moving = &natures.moving;
        (natures.beside_unit).retain(|own| !units.contains(own) && !moving.contains(own));
        natures
    }

    /// What a formula shows to be real.
    fn see(&mut self, formula: &Formula) {
        if formula.is_inequality() {
            self.real.extend(formula.names());
        }
        self.real.extend(formula.set_to_number().cloned());
        for term in formula.terms() {
            self.see_term(term);
            if self.has_unit(term) {
                self.beside_unit
                    .extend(Formula::names_in([term].into_iter()));
            }
        }
    }

    fn see_term(&mut self, term: &Expr) {
        match term {
            Expr::Call(function, inner) if *function != Function::Abs => {
                self.likely_real
                    .extend(Formula::names_in([&**inner].into_iter()));
            }
            Expr::Derivative { body, .. } | Expr::Partial { body, .. } => {
                self.moving.extend(Formula::names_in([&**body].into_iter()));
            }
            _ => {}
        }
        self.likely_real.extend(term.binder().cloned());
        term.children().for_each(|child| self.see_term(child));
    }

    /// Whether the unit stands in a term and in no argument of a function: `R + j X`, and not `A e^{i k x}`.
    fn has_unit(&self, term: &Expr) -> bool {
        match term {
            Expr::Symbol(own) => self.units.contains(own),
            Expr::Call(..) => false,
            _ => term.children().any(|child| self.has_unit(child)),
        }
    }

    fn complex(&self) -> Complex<'_> {
        Complex {
            units: self.units,
            complex: &self.complex,
        }
    }

    fn concerns(&self, term: &Expr) -> bool {
        self.complex().concerns(term)
    }

    /// The parts of a term, with what comes to nothing left out.
    fn parts(&self, term: &Expr) -> Option<Parts> {
        let mut parts = self.complex().parts(term)?;
        for part in [&mut parts.re, &mut parts.im] {
            if !is_zero(part) && comes_to_nothing(part) {
                *part = Expr::integer(0);
            }
        }
        Some(parts)
    }

    fn kind(&self, term: &Expr) -> Option<Kind> {
        Some(self.parts(term)?.kind())
    }

    /// What a side names, where it is nothing but a name that may be complex.
    fn named<'e>(&self, side: &'e Expr) -> Option<&'e Symbol> {
        let (Expr::Symbol(name) | Expr::Apply(name, _)) = side else {
            return None;
        };
        let may_be = !self.units.contains(name) && !self.real.contains(name);
        may_be.then_some(name)
    }

    /// Goes through what is said once more; whether anything was found that is complex.
    fn learn(&mut self, chains: &[Said]) -> bool {
        let before = self.complex.len();
        for own in chains {
            let given = self.given_by(own);
            self.complex.extend(given);
        }
        if self.complex.len() == before {
            let real = chains.iter().flat_map(|own| self.given_as_real(&own.sides));
            let real: Set<Symbol> = real.collect();
            let shown = chains
                .iter()
                .flat_map(|own| self.shown_by(&own.sides, &real));
            let shown: Vec<Symbol> = shown.collect();
            self.complex.extend(shown);
        }
        self.complex.len() > before
    }

    /// The symbols that sides which are equal give by something complex.
    fn given_by(&self, Said { sides, shown }: &Said) -> Vec<Symbol> {
        let is_complex = |term: &Expr| {
            let is_real = |own: Parts| own.is_real();
            self.concerns(term) && !self.parts(term).is_some_and(is_real)
        };
        let is_new = |own: &Symbol| !self.complex.contains(own);
        let named = sides.iter().filter_map(|side| self.named(side));
        let new = named.filter(|own| is_new(own)).cloned();
        match sides.iter().find(|side| is_complex(side)) {
            None => Vec::new(),
            // "At resonance $Z = R$" says that it is real there.
            Some(side) if self.named(side).is_some() => new
                .filter(|own| *shown && !self.beside_unit.contains(own))
                .collect(),
            Some(_) => new.collect(),
        }
    }

    /// The symbols that cannot be complex, and that sides which are equal give by something that is.
    fn disputed_by(&self, sides: &[Expr]) -> Vec<Symbol> {
        let is_complex = |side: &Expr| self.kind(side).is_some_and(|own| own == Kind::Mixed);
        let is_disputed = |side: &Expr| match side {
            Expr::Symbol(own) if self.real.contains(own) => Some(own.clone()),
            _ => None,
        };
        match sides.iter().any(is_complex) {
            true => sides.iter().filter_map(is_disputed).collect(),
            false => Vec::new(),
        }
    }

    /// The symbols that sides which are equal give by something real, `\tau = R C`.
    fn given_as_real(&self, sides: &[Expr]) -> Vec<Symbol> {
        let is_real = |side: &Expr| {
            let unnamed = self.named(side).is_none();
            unnamed && self.parts(side).is_some_and(|own| own.is_real())
        };
        let named = sides.iter().filter_map(|side| self.named(side));
        match sides.iter().any(is_real) {
            true => named.cloned().collect(),
            false => Vec::new(),
        }
    }

    /// The symbols that must be complex for sides to be equal: `V` and `I` of `V/I = R + j X`.
    fn shown_by(&self, sides: &[Expr], given_real: &Set<Symbol>) -> Vec<Symbol> {
        let unnamed = sides.iter().filter(|side| self.named(side).is_none());
        let kinds: Option<Vec<(&Expr, Kind)>> =
            unnamed.map(|side| Some((side, self.kind(side)?))).collect();
        let kinds = kinds.unwrap_or_default();
        let is = |kind| kinds.iter().any(|own| own.1 == kind);
        let may_be = |own: &Symbol| !self.is_settled(own) && !given_real.contains(own);
        let mut names: Set<Symbol> = Set::new();
        for (side, kind) in &kinds {
            if matches!(kind, Kind::Real | Kind::Imaginary) {
                let mut own: Set<Symbol> = Formula::names_in([*side].into_iter());
                // Of what stands with the unit it is shown how it is complex.
                let shown = self.has_unit(side);
                own.retain(|name| may_be(name) && (!shown || self.moving.contains(name)));
                names.extend(own);
            }
        }
        if names.iter().any(|own| !self.beside_unit.contains(own)) {
            names.retain(|own| !self.beside_unit.contains(own));
        }
        match (is(Kind::Mixed), is(Kind::Real) && is(Kind::Imaginary)) {
            (true, _) => names.into_iter().collect(),
            // `i \dot a = b a`: what moves, and not its frequency.
            (false, true) => {
                let moving = names.iter().filter(|own| self.moving.contains(*own));
                let moving: Vec<Symbol> = moving.cloned().collect();
                match moving.is_empty() {
                    true => names.into_iter().collect(),
                    false => moving,
                }
            }
            (false, false) => Vec::new(),
        }
    }

    /// Whether it is known what a symbol is.
    fn is_settled(&self, symbol: &Symbol) -> bool {
        let sets = [self.units, &self.complex, &self.real, &self.likely_real];
        sets.iter().any(|own| own.contains(symbol))
            || measured(symbol).is_some()
            || symbol.name() == "\\pi"
    }

    /// The parts of sides that are equal; `None` where they cannot be written, or it is not clear what in them is complex.
    fn sides_apart(&self, sides: &[Expr]) -> Option<Vec<Parts>> {
        let mut kinds = Vec::new();
        let mut all = Vec::new();
        for side in sides {
            let is_disputed = || self.disputed.iter().any(|own| side.mentions(own));
            if is_rounded(side) && self.concerns(side) || is_disputed() {
                return None;
            }
            let parts = self.parts(side)?;
            let is_complex = |own: &Symbol| self.complex.contains(own);
            if !self.named(side).is_some_and(is_complex) {
                kinds.push(parts.kind());
            }
            all.push(parts);
        }
        // "If $Z = U$": whether `U` is complex as well is not clear.
        let is_unclear = |side: &Expr| {
            self.named(side).is_some_and(|own| {
                let sets = [&self.complex, &self.likely_real, &self.beside_unit];
                !sets.iter().any(|known| known.contains(own))
            })
        };
        let is_name = |side: &Expr| self.named(side).is_some();
        if sides.iter().all(is_name) && sides.iter().any(is_unclear) {
            return None;
        }
        kinds.retain(|own| *own != Kind::Zero);
        let is_named = kinds.len() < sides.len() && sides.iter().any(is_name);
        let is_plain = |side: &&Expr| !self.concerns(side) && !is_zero(side) && !is_name(side);
        let all_real = kinds.iter().all(|own| *own == Kind::Real);
        if !all_real && sides.iter().any(|side| is_plain(&side)) {
            return None;
        }
        // Of what changes by a law with the unit it is shown that it is complex; the rest are numbers in the law.
        let settled = || {
            let names = Formula::names_in(sides.iter());
            let is_known = |own: &Symbol| self.is_settled(own) || self.beside_unit.contains(own);
            let moves = |own: &Symbol| self.moving.contains(own) && self.complex.contains(own);
            names.iter().all(is_known) || names.iter().any(moves)
        };
        let same = kinds.windows(2).all(|pair| pair[0] == pair[1]);
        let is_clear = same && !kinds.contains(&Kind::Mixed);
        (is_clear || is_named || settled()).then_some(all)
    }

    fn formula_apart(&self, formula: &Formula) -> Option<Vec<Formula>> {
        if !formula.terms().into_iter().any(|own| self.concerns(own)) {
            return None;
        }
        let Formula::Relation {
            left,
            relation,
            right,
        } = formula
        else {
            return None;
        };
        let [left, right] = match relation {
            Relation::Equal => self.sides_apart(&[left.clone(), right.clone()])?,
            _ => vec![self.real_parts(left)?, self.real_parts(right)?],
        }
        .try_into()
        .ok()?;
        let is_said = |(left, right): &(Expr, Expr)| left != right;
        let parts = [(left.re, right.re), (left.im, right.im)];
        let related = |(left, right)| Formula::Relation {
            left,
            relation: *relation,
            right,
        };
        Some(parts.into_iter().filter(is_said).map(related).collect())
    }

    fn real_parts(&self, term: &Expr) -> Option<Parts> {
        self.parts(term).filter(Parts::is_real)
    }

    fn take_equation_apart(&self, equation: &mut Equation) {
        let complex = self.complex.iter().filter_map(|symbol| {
            let said = equation.said.get(symbol)?;
            Some((part_names(symbol), said.clone()))
        });
        for ((re, im), said) in complex.collect::<Vec<_>>() {
            equation.said.insert(re, said.clone());
            equation.said.insert(im, said);
        }
        let Ok(statements) = &mut equation.statements else {
            return;
        };
        if !statements.iter().any(|own| self.speaks(own)) {
            return;
        }
        let (mut all, mut defines) = (Vec::new(), Set::new());
        for (at, statement) in std::mem::take(statements).into_iter().enumerate() {
            let parts = match self.speaks(&statement) {
                true => self.statement_apart(statement),
                false => vec![statement],
            };
            for own in parts {
                if equation.defines.contains(&at) {
                    defines.insert(all.len());
                }
                all.push(own);
            }
        }
        (*statements, equation.defines) = (all, defines);
    }

    fn speaks(&self, statement: &Statement) -> bool {
        let mut clauses = statement.clauses.iter().chain(&statement.under);
        clauses.any(|own| terms_of_clause(own).any(|term| self.concerns(term)))
    }

    /// The statements about the parts; the statement as it is where it is not clear which these are.
    fn statement_apart(&self, statement: Statement) -> Vec<Statement> {
        let ([Clause::Chain { sides, links }], []) = (&statement.clauses[..], &statement.under[..])
        else {
            return vec![statement];
        };
        let terms: Vec<Expr> = sides.iter().map(|own| own.expr.clone()).collect();
        let parts = match links.iter().all(|own| own.relation == Relation::Equal) {
            true => self.sides_apart(&terms),
            false => terms.iter().map(|own| self.real_parts(own)).collect(),
        };
        let Some(parts) = parts else {
            return vec![statement];
        };
        let with = |of: fn(&Parts) -> &Expr| {
            let terms = parts.iter().map(of);
            if terms.clone().all(is_zero) {
                return None;
            }
            let side = |(own, term): (&Side, &Expr)| Side {
                expr: term.clone(),
                // Which of the summands there it is that they come from, is not told.
                terms: match *term == own.expr {
                    true => own.terms.clone(),
                    false => vec![own.span],
                },
                ..own.clone()
            };
            // `\text{Im}(a) = 0 = 0` says no more than its beginning.
            let nought = terms.clone().skip(1).all(is_zero);
            let length = if nought { 2 } else { sides.len() };
            Some(Statement {
                clauses: vec![Clause::Chain {
                    sides: sides.iter().zip(terms).map(side).take(length).collect(),
                    links: links[..length - 1].to_vec(),
                }],
                others: Vec::new(),
                doubts: Vec::new(),
                ..statement.clone()
            })
        };
        let apart: Vec<Statement> = [with(|own| &own.re), with(|own| &own.im)]
            .into_iter()
            .flatten()
            .collect();
        match apart.is_empty() {
            true => vec![statement],
            false => apart,
        }
    }
}

/// The sides of a chain of equalities.
fn equal_sides(clause: &Clause) -> Option<Vec<Expr>> {
    match clause {
        Clause::Chain { sides, links } => {
            let equal = links.iter().all(|own| own.relation == Relation::Equal);
            equal.then(|| sides.iter().map(|own| own.expr.clone()).collect())
        }
        Clause::AllEqual { .. } => None,
    }
}

/// Whether a term is 0 whatever the symbols in it are.
pub(crate) fn comes_to_nothing(term: &Expr) -> bool {
    let mut atoms = Atoms::default();
    let value = Lowering::plain(&mut atoms).lower(term);
    value.is_ok_and(|own| own.is_zero())
}

/// Whether numbers in a term may be rounded: `-0.40 + 0.30 j`. Such are weighed.
fn is_rounded(term: &Expr) -> bool {
    term.any(&|part| match part {
        Expr::Number(own) => !own.is_integer(),
        Expr::Symbol(own) => measured(own).is_some(),
        _ => false,
    })
}
