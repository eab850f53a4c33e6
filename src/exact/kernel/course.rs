//! Points at which derivatives are tied together: whether anything can move through them as the premises ask.
//!
//! At a point the premises say what the values of `x`, `dx/dt`, `d²x/dt²` … are; as laws they say it all along the way. So
//! it is not enough that they are true at the point: there must be functions of the variable that pass through it with
//! these derivatives and keep every law true around it.
//!
//! **Statement.** Let each law that speaks of something that moves be an equation `f = 0`, and let it have an unknown of its
//! own that it *leads*: the highest derivative of a symbol that occurs, or a symbol no derivative of which occurs. If the
//! matrix of the partial derivatives of the laws by the unknowns that they lead is regular at the point, then the laws can be solved
//! for these near the point (implicit functions), what is left is a system of explicit differential equations with
//! analytic right sides, and it has a solution through every initial point (Cauchy); the symbols that are led by none
//! move as any polynomial with the given derivatives. What must not be negative, or not vanish, is asked not to be 0 at the
//! point, so that it has its sign around it.
//!
//! Roots, exponentials and logarithms of what moves are analytic where what they are taken of is not 0, or positive: they *follow* it, and
//! bring no unknown along. The partial derivatives of a law are taken through them by the chain rule.
//!
//! A law in which what it leads does not occur, `p V = c` with `dp/dV`, is taken by its slope along the way, `V dp/dV + p = 0`: it is true
//! at the point, and where its slope is 0 all along, it stays so.

use std::borrow::Cow;

use super::in_pi::InPi;
use super::witness::Point;
use super::{Origin, Reject, Sign, Standing};
use crate::algebra::{
    Atom, Atoms, Expr, Function, Polynomial, Rational, Symbol, Var, element_parts, expr_of_atom,
};
use crate::sorted::{Map, Set};

/// A derivative as a symbol, a variable and an order.
fn derivative(term: &Expr) -> Option<(&Symbol, &Symbol, usize)> {
    let Expr::Derivative { body, variable } = term else {
        return None;
    };
    match &**body {
        Expr::Symbol(symbol) => Some((symbol, variable, 1)),
        inner => {
            let (symbol, own, order) = derivative(inner)?;
            (own == variable).then_some((symbol, own, order + 1))
        }
    }
}

/// The slope of a law along the way, by the slopes of what moves. `None` where one of them is no unknown of its own.
pub fn slope_along(
    law: &Polynomial,
    atoms: &Atoms,
    variable: &Symbol,
    moving: &Set<Var>,
) -> Option<Polynomial> {
    let mut slope = Polynomial::zero();
    for var in law.vars().into_iter().filter(|var| moving.contains(var)) {
        let own = expr_of_atom(atoms.atom(var));
        let rate = match own == Expr::Symbol(variable.clone()) {
            true => Polynomial::one(),
            false => Polynomial::var(atoms.find(&Atom::Opaque(own.differentiated_by(variable)))?),
        };
        slope = slope.plus(&law.derivative(var).times(&rate).ok()?);
    }
    Some(slope)
}

/// What moves at a point.
struct Motion {
    variable: Symbol,
    /// The symbols whose derivatives occur, each with the highest order.
    orders: Map<Symbol, usize>,
    /// Everything that may change with the variable, the variable included.
    moving: Set<Var>,
}

impl Point<'_> {
    /// The value of a derivative at a point that says how everything moves.
    pub(super) fn along_the_way(&self, term: &Expr) -> Result<Rational, Reject> {
        let (symbol, variable, order) = derivative(term).ok_or(Reject::NoValue)?;
        let key = (symbol.clone(), variable.clone());
        let value = match order {
            1 => self.at.derivatives.get(&key),
            order => {
                let course = self.at.course.as_ref();
                course.and_then(|c| c.higher.get(&key)?.get(order - 2))
            }
        };
        value.map(Rational::from).ok_or(Reject::NoValue)
    }

    /// Whether there are functions that pass through the point and keep the laws true around it.
    pub(super) fn course_exists(&mut self) -> Result<(), Reject> {
        let at = self.at;
        let Some(course) = &at.course else {
            return Ok(());
        };
        let problem = self.problem;
        let mut motion = self.motion()?;
        if !self.may_move(&motion.variable) {
            return Err(Reject::NoCourse);
        }
        // What is led moves.
        let mut leads: Map<usize, Var> = Map::new();
        for (&law, term) in &course.leads {
            let atom = match term {
                Expr::Symbol(symbol) => {
                    if !self.may_move(symbol) || motion.orders.contains_key(symbol) {
                        return Err(Reject::NoCourse);
                    }
                    Atom::Symbol(symbol.clone())
                }
                term => {
                    let (symbol, _, order) = derivative(term).ok_or(Reject::NoCourse)?;
                    if motion.orders.get(symbol) != Some(&order) {
                        return Err(Reject::NoCourse);
                    }
                    Atom::Opaque(term.clone())
                }
            };
            let var = self.atoms.find(&atom).ok_or(Reject::NoCourse)?;
            if leads.values().any(|own| *own == var)
                || *term == Expr::Symbol(motion.variable.clone())
            {
                return Err(Reject::NoCourse);
            }
            motion.moving.insert(var);
            leads.insert(law, var);
        }
        self.nothing_else_moves(&mut motion)?;
        let moves = |p: &Polynomial| p.vars().iter().any(|var| motion.moving.contains(var));
        let mut laws: Vec<(Cow<'_, Polynomial>, Var)> = Vec::new();
        for (fact, origin) in problem.facts.iter().zip(&problem.origins) {
            if !moves(&fact.polynomial) {
                continue;
            }
            let hypothesis = match origin {
                Origin::Hypothesis(at) => Some(*at),
                _ => None,
            };
            let standing = hypothesis
                .and_then(|at| problem.formulas.get(at))
                .map(|f| f.1);
            // What is said of the point alone is true there, and that is all.
            if standing == Some(Standing::AtPoint) {
                continue;
            }
            match (fact.sign, hypothesis.and_then(|at| leads.get(&at))) {
                (Sign::Zero, Some(&lead)) if fact.polynomial.degree_in(lead) > 0 => {
                    laws.push((Cow::Borrowed(&fact.polynomial), lead));
                }
                (Sign::Zero, Some(&lead)) => {
                    let (atoms, by) = (&*self.atoms, &motion.variable);
                    let slope = slope_along(&fact.polynomial, atoms, by, &motion.moving);
                    let slope = slope.ok_or(Reject::NoCourse)?;
                    if !self.meets(&slope, Sign::Zero)? {
                        return Err(Reject::NoCourse);
                    }
                    laws.push((Cow::Owned(slope), lead));
                }
                (Sign::Zero, None) => return Err(Reject::NoCourse),
                _ if self.number(&fact.polynomial)?.is_zero() => return Err(Reject::NoCourse),
                _ => {}
            }
        }
        for value in &problem.integers {
            if moves(value.numerator()) || value.denominator().any(|(factor, _)| moves(factor)) {
                return Err(Reject::NoCourse);
            }
        }
        let laws: Vec<(&Polynomial, Var)> =
            laws.iter().map(|(law, lead)| (&**law, *lead)).collect();
        self.can_be_solved(&laws)
    }

    /// Whether laws can be solved near the point, each for its unknown: the matrix of the partial derivatives is regular.
    pub(super) fn can_be_solved(&mut self, laws: &[(&Polynomial, Var)]) -> Result<(), Reject> {
        let mut matrix = Vec::with_capacity(laws.len());
        for (law, _) in laws {
            let mut row = Vec::with_capacity(laws.len());
            for &(_, lead) in laws {
                row.push(self.partial(law, lead)?);
            }
            matrix.push(InPi::without_common_power(&row).ok_or(Reject::NoValue)?);
        }
        match is_regular(matrix) {
            true => Ok(()),
            false => Err(Reject::NoCourse),
        }
    }

    /// The partial derivative of a law by an unknown, through the roots and functions that follow it.
    fn partial(&mut self, law: &Polynomial, lead: Var) -> Result<InPi, Reject> {
        let mut whole = self.number(&law.derivative(lead))?;
        for var in law.vars() {
            let Atom::Opaque(term) = self.atoms.atom(var).clone() else {
                continue;
            };
            if derivative(&term).is_some() || self.stands_still(&term) {
                continue;
            }
            let Some(of) = follows(&term) else {
                let by = expr_of_atom(self.atoms.atom(lead)).free_symbols();
                if term.free_symbols().iter().any(|own| by.contains(own)) {
                    return Err(Reject::NoCourse);
                }
                continue;
            };
            let of = self.lowered(of)?;
            let (above, below) = (of.numerator().clone(), of.expanded_denominator()?);
            let (over, under) = (self.partial(&above, lead)?, self.partial(&below, lead)?);
            if over.is_zero() && under.is_zero() {
                continue;
            }
            let by = self.number(&law.derivative(var))?;
            let rational = |own: InPi| own.as_rational().ok_or(Reject::NoCourse);
            let (over, under) = (rational(over)?, rational(under)?);
            let above = rational(self.number(&above)?)?;
            let below = rational(self.number(&below)?)?;
            let value = rational(self.number(&Polynomial::var(var))?)?;
            if below.is_zero() || above.is_zero() && !is_exponential(&term) {
                return Err(Reject::NoCourse);
            }
            // (n/d)' = n'/d − n d'/d²
            let slope = over / below.clone() - &above * &under / (&below * &below);
            let follows = match &term {
                Expr::Power(_, exponent) => match &**exponent {
                    Expr::Number(exponent) => below / above * Rational::from(exponent) * value,
                    _ => return Err(Reject::NoCourse),
                },
                Expr::Call(Function::Exp, _) => value,
                _ => below / above,
            };
            whole = whole.plus(&by.scaled(&(slope * follows)));
        }
        Ok(whole)
    }

    /// The variable and what is differentiated by it.
    fn motion(&self) -> Result<Motion, Reject> {
        let mut found: Option<Motion> = None;
        for (var, atom) in self.atoms.iter() {
            let Atom::Opaque(term @ Expr::Derivative { .. }) = atom else {
                continue;
            };
            if self.stands_still(term) {
                continue;
            }
            let (symbol, variable, order) = derivative(term).ok_or(Reject::NoCourse)?;
            let motion = found.get_or_insert_with(|| Motion {
                variable: variable.clone(),
                orders: Map::new(),
                moving: Set::new(),
            });
            if motion.variable != *variable || symbol == variable || !self.may_move(symbol) {
                return Err(Reject::NoCourse);
            }
            let highest = motion.orders.entry(symbol.clone()).or_default();
            *highest = order.max(*highest);
            motion.moving.insert(var);
        }
        let mut motion = found.ok_or(Reject::NoCourse)?;
        let own = motion.orders.keys().chain([&motion.variable]).cloned();
        let own: Vec<Symbol> = own.collect();
        motion.moving.extend(
            own.into_iter()
                .filter_map(|s| self.atoms.find(&Atom::Symbol(s))),
        );
        Ok(motion)
    }

    /// Whether a symbol may change: it is no count, no element of a sequence, and no number by its domain.
    pub(super) fn may_move(&self, symbol: &Symbol) -> bool {
        let element = element_parts(symbol)
            .is_some_and(|(sequence, _)| self.problem.sequences.contains(&sequence));
        let number = self.problem.pi_is_the_number() && symbol.name() == "\\pi";
        let fixed =
            self.claim.domains.get(symbol).is_some_and(|d| {
                d.integer || d.constant || d.lower.is_some() && d.lower == d.upper
            });
        !element && !number && !fixed && !self.problem.is_count(symbol)
    }

    /// Whether no sum or integral speaks of what moves: these are not followed. Roots and functions are, where they are analytic.
    fn nothing_else_moves(&mut self, motion: &mut Motion) -> Result<(), Reject> {
        // What is within roots and functions joins the unknowns as they are looked at.
        let mut looked_at = 0;
        loop {
            let next = self.atoms.iter().nth(looked_at);
            let Some((var, atom)) = next.map(|(var, atom)| (var, atom.clone())) else {
                return Ok(());
            };
            looked_at += 1;
            let stays = |symbol: &Symbol| {
                let own = self.atoms.find(&Atom::Symbol(symbol.clone()));
                *symbol != motion.variable
                    && !motion.orders.contains_key(symbol)
                    && own.is_none_or(|own| !motion.moving.contains(&own))
            };
            let is_settled = match &atom {
                Atom::Symbol(_) => true,
                Atom::Opaque(term) if derivative(term).is_some() || self.stands_still(term) => true,
                Atom::Opaque(term) => term.free_symbols().iter().all(stays),
                _ => false,
            };
            if is_settled || motion.moving.contains(&var) {
                continue;
            }
            match &atom {
                Atom::Opaque(term) if self.is_analytic(term)? => {
                    motion.moving.insert(var);
                }
                _ => return Err(Reject::NoCourse),
            }
        }
    }

    /// Whether a root, an exponential or a logarithm is analytic around the point: what it is taken of is positive there.
    fn is_analytic(&mut self, term: &Expr) -> Result<bool, Reject> {
        let Some(of) = follows(term) else {
            return Ok(false);
        };
        let value = self.lowered(of)?;
        let value = self.fraction(&value)?.ok_or(Reject::NoCourse)?;
        Ok(value.is_positive() || is_exponential(term))
    }
}

/// What a root, an exponential or a logarithm is taken of.
fn follows(term: &Expr) -> Option<&Expr> {
    match term {
        Expr::Power(base, exponent) if matches!(**exponent, Expr::Number(_)) => Some(base),
        Expr::Call(Function::Exp | Function::Ln, of) => Some(of),
        _ => None,
    }
}

fn is_exponential(term: &Expr) -> bool {
    matches!(term, Expr::Call(Function::Exp, _))
}

/// Whether a square matrix can be inverted.
fn is_regular(mut rows: Vec<Vec<Rational>>) -> bool {
    let size = rows.len();
    for at in 0..size {
        let Some(pivot) = (at..size).find(|&row| !rows[row][at].is_zero()) else {
            return false;
        };
        rows.swap(at, pivot);
        let (above, below) = rows.split_at_mut(at + 1);
        let lead = &above[at];
        for row in below {
            let factor = &row[at] / &lead[at];
            for (own, other) in row.iter_mut().zip(lead).skip(at) {
                *own = &*own - &(other * &factor);
            }
        }
    }
    true
}
