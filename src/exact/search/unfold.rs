//! Which definitions must be put in before anything can be computed.

use std::cell::LazyCell;
use std::sync::Arc;

use crate::algebra::{Expr, Formula, Function, Symbol};
use crate::kernel::{Claim, Domain, Standing, applied_definition, definition, pi_is_the_number};
use crate::sorted::Set;

/// The hypotheses `symbol = term` whose symbol is differentiated, integrated, taken to a limit, summed up to
/// or stands in a function: what is done to the symbol must be done to the term. So too where a root is taken of a symbol that is not
/// declared positive, for the term may be seen to be.
pub fn definitions_to_unfold(claim: &Claim) -> Vec<usize> {
    // Most claims have nothing of the kind.
    if !claim.formulas().any(has_operands) {
        return Vec::new();
    }
    let pi = LazyCell::new(|| pi_is_the_number(claim));
    let hypotheses = claim.hypotheses.iter().map(|own| own.formula.clone());
    let mut formulas: Vec<Arc<Formula>> = hypotheses.collect();
    formulas.push(claim.goal.clone().into());
    let goal = formulas.len() - 1;
    let mut chosen = Vec::new();
    loop {
        let mut found = Operands::default();
        for term in formulas.iter().flat_map(|own| own.terms()) {
            found.collect(term);
        }
        for formula in &formulas {
            if let Formula::AllEqual { to, .. } = &**formula {
                found.counts.extend(to.free_symbols());
            }
            if let Some((symbol, term)) = definition(formula)
                && term.any(&is_exponential)
                && !formulas[goal].names().contains(&symbol)
            {
                found.decaying.insert(symbol);
            }
        }
        let next = (0..goal).find_map(|at| {
            if chosen.contains(&at) {
                return None;
            }
            if let Some((applied, term)) = applied_definition(&formulas[at]) {
                let is_asked =
                    || found.applied.contains(&applied) || applies(&formulas[goal], &applied);
                let fits = claim.hypotheses[at].standing == Standing::Identity && is_asked();
                return fits.then_some((at, applied, term));
            }
            let (symbol, term) = definition(&formulas[at])?;
            let rank = |term: &Expr| found.rank(&symbol, term, claim);
            let others = || formulas[..goal].iter().filter_map(|own| definition(own));
            let own = rank(&term);
            if own < BEST && others().any(|(name, other)| name == symbol && rank(&other) > own) {
                return None;
            }
            // A value at one point says nothing of how the symbol moves; a count does not move.
            let positive = || claim.domains.get(&symbol).is_some_and(Domain::is_positive);
            // What is constant has no slope to be found.
            let constant = claim.is_constant(&symbol);
            let fits = match found.moving.contains(&symbol) && !constant {
                true => claim.hypotheses[at].standing == Standing::Identity,
                false if found.counts.contains(&symbol) => true,
                false if found.called.contains(&symbol) => true,
                false if found.rooted.contains(&symbol) && !positive() => true,
                false if found.decaying.contains(&symbol) && !term.any(&is_exponential) => true,
                // Another name for what stands in a function, and so may have no rational value.
                false if matches!(&term, Expr::Symbol(own) if found.called.contains(own)) => true,
                // What is made of logarithms of numbers has no rational value: `T = \frac{\ln 2}{k}`.
                false if term.any(&Expr::is_logarithm_of_number) => true,
                // Beside the number π a value need not be rational: what nothing else speaks of needs none. Of what is constant and made of
                // what moves it says how that moves: `V = \pi r^2 h`.
                false => {
                    is_alone(&symbol, at, &formulas) && *pi && !(constant && found.moves(&term))
                }
            };
            let number = symbol.name() == "\\pi" && *pi;
            let fits = fits && !number && !found.variables.contains(&symbol);
            fits.then_some((at, Expr::Symbol(symbol), term))
        });
        let Some((at, unfolded, term)) = next else {
            return chosen;
        };
        chosen.push(at);
        for formula in &mut formulas {
            let put_in = |t: &Expr| match &unfolded {
                Expr::Symbol(symbol) => t.substitute(symbol, &term),
                applied => t.replace(applied, &term),
            };
            *formula = formula.map_terms(put_in).into();
        }
        // What is defined by what is defined may grow without end.
        let is_great = |own: &Arc<Formula>| {
            own.terms()
                .into_iter()
                .any(|term| !term.has_fewer_parts_than(MOST_PARTS))
        };
        if formulas.iter().any(is_great) {
            chosen.pop();
            return chosen;
        }
    }
}

/// Terms of more parts than these are not put in for symbols.
const MOST_PARTS: usize = 2_000;

fn is_exponential(part: &Expr) -> bool {
    matches!(part, Expr::Call(Function::Exp, _))
}

/// Whether a formula speaks of the function that is applied, for whichever argument.
fn applies(formula: &Formula, applied: &Expr) -> bool {
    let Expr::Apply(function, _) = applied else {
        return false;
    };
    let is_it = |part: &Expr| matches!(part, Expr::Apply(own, _) if own == function);
    formula.terms().iter().any(|term| term.any(&is_it))
}

/// Whether no other formula speaks of a symbol.
fn is_alone(symbol: &Symbol, at: usize, formulas: &[Arc<Formula>]) -> bool {
    let mut others = formulas
        .iter()
        .enumerate()
        .filter(|(other, _)| *other != at);
    !others.any(|(_, formula)| formula.terms().iter().any(|term| term.mentions(symbol)))
}

/// Whether something is done to a symbol in a formula, or it speaks of `\pi`.
fn has_operands(formula: &Formula) -> bool {
    let is_operand = |part: &Expr| match part {
        Expr::Call(..) => true,
        Expr::Symbol(symbol) => symbol.name() == "\\pi",
        Expr::Apply(..) => true,
        _ => part.binder().is_some() || part.is_root(),
    };
    matches!(formula, Formula::AllEqual { .. })
        || formula.terms().iter().any(|term| term.any(&is_operand))
}

/// The rank of a term of which partial derivatives are meant rather than of another.
const BEST: u8 = 2;

/// A partial derivative of a symbol.
struct Slope {
    name: Symbol,
    variable: Symbol,
    held: Vec<Symbol>,
}

/// The symbols to which something is done.
#[derive(Default)]
struct Operands {
    /// Under a derivative, a limit or an integral.
    moving: Set<Symbol>,
    /// Unknown functions, applied, in the same places.
    applied: Set<Expr>,
    /// In the upper limit of a sum.
    counts: Set<Symbol>,
    /// Below a root.
    rooted: Set<Symbol>,
    /// In the argument of a function: equal arguments must look alike.
    called: Set<Symbol>,
    /// Equal to what has an exponential in it, `N = N_0 e^{-k t}`, and not spoken of in the goal: where another value is put in, `N = N_0/2`, the
    /// exponential has one.
    decaying: Set<Symbol>,
    /// What is differentiated by, goes to a limit or is integrated over.
    variables: Set<Symbol>,
    /// What is differentiated partially by itself.
    partial: Vec<Slope>,
}

impl Operands {
    /// Whether a term speaks of what is differentiated, or of what is differentiated by.
    fn moves(&self, term: &Expr) -> bool {
        let mut names = self.moving.iter().chain(&self.variables);
        names.any(|own| term.mentions(own))
    }

    /// How well a term may be what partial derivatives of a symbol are meant of: it is written in the variables, and in nothing else but what
    /// is held fixed.
    fn rank(&self, symbol: &Symbol, term: &Expr, claim: &Claim) -> u8 {
        let own = || self.partial.iter().filter(|own| own.name == *symbol);
        if !own().all(|own| term.mentions(&own.variable)) {
            return 0;
        }
        let is_known = |name: &Symbol| {
            let held = |own: &Slope| own.variable == *name || own.held.contains(name);
            claim.is_constant(name) || own().all(held)
        };
        match term.free_symbols().iter().all(is_known) {
            true => BEST,
            false => 1,
        }
    }

    fn collect(&mut self, term: &Expr) {
        match term {
            Expr::Derivative { body, variable }
            | Expr::Partial { body, variable, .. }
            | Expr::Limit { body, variable, .. }
            | Expr::Integral { body, variable, .. } => {
                self.moving
                    .extend(body.free_symbols().into_iter().filter(|s| s != variable));
                self.variables.insert(variable.clone());
                self.variables.extend(term.held().iter().cloned());
                applications(body, &mut self.applied);
                if let (Expr::Partial { .. }, Some(name)) = (term, innermost(body)) {
                    self.partial.push(Slope {
                        name: name.clone(),
                        variable: variable.clone(),
                        held: term.held().to_vec(),
                    });
                }
                if let Expr::Integral { from, to, .. } = term {
                    // The limits come to stand in the functions of the integrand.
                    if body.any(&|part| matches!(part, Expr::Call(..))) {
                        self.called.extend(from.free_symbols());
                        self.called.extend(to.free_symbols());
                    }
                }
            }
            Expr::Call(_, argument) => self.called.extend(argument.free_symbols()),
            Expr::Series { to, .. } => self.counts.extend(to.free_symbols()),
            Expr::Power(base, _) if term.is_root() => self.rooted.extend(base.free_symbols()),
            _ => {}
        }
        for child in term.children() {
            self.collect(child);
        }
    }
}

/// The symbol of which a derivative is taken, or one of one.
fn innermost(term: &Expr) -> Option<&Symbol> {
    match term {
        Expr::Symbol(symbol) => Some(symbol),
        Expr::Partial { body, .. } => innermost(body),
        _ => None,
    }
}

fn applications(term: &Expr, found: &mut Set<Expr>) {
    if let Expr::Apply(..) = term {
        found.insert(term.clone());
    }
    term.children().for_each(|child| applications(child, found));
}
