//! Points of claims with limits and integrals: whether the laws can be kept along the way that these go.
//!
//! What is taken of a limit or an integral depends on what runs in it; at a point all other symbols in it are taken as constant. A law that
//! speaks of the variable holds wherever this runs, and so do those that speak of what must move with it. At one point alone `p V = c` is
//! true of any constants.
//!
//! **Statement.** Let each law that speaks of the variable, or of what moves with it, have an unknown of its own that it *leads*: a symbol
//! that may move and stands in no limit or integral over the variable. If the matrix of the partial derivatives of these laws by what they lead
//! is regular at the point, then they hold around it with everything else constant (implicit functions). What must not be negative, or not
//! vanish, is asked not to be 0 if it speaks of what moves. A law that is `0 = 0` with the values of what does not move needs to lead nothing: it
//! holds wherever the rest goes.

use super::witness::Point;
use super::{Origin, Reject, Sign, Standing};
use crate::algebra::{Atom, Expr, Formula, Polynomial, Symbol, Var, expr_of_atom};
use crate::sorted::Set;

/// What runs, and what is inside of what it runs in.
#[derive(Default)]
struct Running {
    variables: Set<Symbol>,
    inside: Set<Symbol>,
}

impl Running {
    /// Collects what runs in a term; in derivatives, too, if it is said what may move.
    fn collect(&mut self, term: &Expr, derivatives: Option<&dyn Fn(&Symbol) -> bool>) {
        match term {
            Expr::Limit { body, variable, .. } | Expr::Integral { body, variable, .. } => {
                self.add(body, variable);
            }
            Expr::Derivative { body, variable } => {
                // Of constants, too: that their slope is 0 is known only if the laws let them be.
                let names = body.free_symbols();
                let explicit = names.contains(variable);
                if derivatives.is_some_and(|may_move| explicit || !names.iter().any(may_move)) {
                    self.add(body, variable);
                }
            }
            _ => {}
        }
        (term.children()).for_each(|part| self.collect(part, derivatives));
    }

    fn add(&mut self, body: &Expr, variable: &Symbol) {
        self.variables.insert(variable.clone());
        self.inside.extend(body.free_symbols());
    }
}

impl Point<'_> {
    /// Whether the laws can hold along the way that limits and integrals go.
    pub(super) fn laws_can_keep_up(&mut self) -> Result<(), Reject> {
        let problem = self.problem;
        let mut running = Running::default();
        // A course says itself how derivatives are tied together.
        let may_move = |symbol: &Symbol| self.may_move(symbol);
        let derivatives = self.at.course.is_none().then_some(&may_move as _);
        let terms = problem.statements().flat_map(Formula::terms);
        terms.for_each(|term| running.collect(term, derivatives));
        if running.variables.is_empty() {
            return Ok(());
        }
        let mut laws: Vec<Law> = Vec::new();
        for (fact, origin) in problem.facts.iter().zip(&problem.origins) {
            let Origin::Hypothesis(at) = *origin else {
                continue;
            };
            let standing = problem.formulas.get(at).map(|own| own.1);
            if standing == Some(Standing::Identity) && !fact.polynomial.is_zero() {
                laws.push(Law {
                    fact: &fact.polynomial,
                    sign: fact.sign,
                    names: self.names(&fact.polynomial),
                    lead: None,
                });
            }
        }
        let mut moving = running.variables.clone();
        while let Some(at) = self.behind(&laws, &moving)? {
            let (symbol, var) = self.lead(&laws, at, &running, &moving)?;
            laws[at].lead = Some(var);
            moving.insert(symbol);
        }
        let unsure = |law: &&Law| law.sign != Sign::Zero && law.mentions(&moving);
        for law in laws.iter().filter(unsure) {
            if self.number(law.fact)?.is_zero() {
                return Err(Reject::NoCourse);
            }
        }
        let led = laws.iter().filter_map(|law| Some((law.fact, law.lead?)));
        let led: Vec<(&Polynomial, Var)> = led.collect();
        self.can_be_solved(&led)
    }

    /// The first law that speaks of what moves, leads nothing yet, and is not true wherever that goes.
    fn behind(&mut self, laws: &[Law], moving: &Set<Symbol>) -> Result<Option<usize>, Reject> {
        for (at, law) in laws.iter().enumerate() {
            if law.is_behind(moving) && !self.is_always_so(law.fact, moving)? {
                return Ok(Some(at));
            }
        }
        Ok(None)
    }

    /// Whether a law is `0 = 0` once the values of all symbols are put in that do not move: `A (k - m \omega^2) \cos(\omega t) = 0` where
    /// `k = m \omega^2`.
    fn is_always_so(&mut self, law: &Polynomial, moving: &Set<Symbol>) -> Result<bool, Reject> {
        let mut left = law.clone();
        for var in law.vars() {
            if let Atom::Symbol(symbol) = self.atoms.atom(var)
                && !moving.contains(symbol)
                && let Some(value) = self.at.symbols.get(symbol)
            {
                left = left.substitute(var, &Polynomial::constant(value.into()))?;
            }
        }
        Ok(left.is_zero())
    }

    /// What a law may lead: of what may move, what the fewest laws speak of.
    fn lead(
        &mut self,
        laws: &[Law],
        at: usize,
        running: &Running,
        moving: &Set<Symbol>,
    ) -> Result<(Symbol, Var), Reject> {
        let mut found: Option<(usize, (Symbol, Var))> = None;
        for symbol in &laws[at].names {
            let var = self.atoms.find(&Atom::Symbol(symbol.clone()));
            let Some(var) = var.filter(|_| {
                !moving.contains(symbol)
                    && !running.inside.contains(symbol)
                    && self.may_move(symbol)
            }) else {
                continue;
            };
            let slope = laws[at].fact.derivative(var);
            if self.number(&slope)?.is_zero() {
                continue;
            }
            let others = laws.iter().filter(|law| law.names.contains(symbol)).count();
            if found.as_ref().is_none_or(|(fewest, _)| others < *fewest) {
                found = Some((others, (symbol.clone(), var)));
            }
        }
        found.map(|own| own.1).ok_or(Reject::NoCourse)
    }

    /// The symbols of which a polynomial speaks.
    fn names(&self, polynomial: &Polynomial) -> Set<Symbol> {
        let terms = polynomial
            .vars()
            .into_iter()
            .map(|var| expr_of_atom(self.atoms.atom(var)));
        let is_slope = |term: &Expr| matches!(term, Expr::Derivative { .. });
        let moving = terms.filter(|term| !is_slope(term) && !self.stands_still(term));
        moving.flat_map(|term| term.free_symbols()).collect()
    }
}

/// What a hypothesis says wherever its symbols go.
struct Law<'a> {
    fact: &'a Polynomial,
    sign: Sign,
    names: Set<Symbol>,
    lead: Option<Var>,
}

impl Law<'_> {
    fn mentions(&self, moving: &Set<Symbol>) -> bool {
        self.names.iter().any(|name| moving.contains(name))
    }

    /// Whether it speaks of what moves and leads nothing yet.
    fn is_behind(&self, moving: &Set<Symbol>) -> bool {
        self.sign == Sign::Zero && self.lead.is_none() && self.mentions(moving)
    }
}
