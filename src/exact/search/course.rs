//! Points at which derivatives are tied together: which law says what of what moves.

use num_traits::Zero;

use crate::algebra::{
    Atom, Atoms, BigRational, Expr, Formula, Polynomial, Rational, Symbol, Values, Var,
};
use crate::kernel::{
    Assignment, Claim, Course, Fact, Obligation, Origin, Problem, Sign, Standing, slope_along,
};
use crate::sorted::{Map, Set};

/// How many choices of what a law is solved for are tried.
const MOST_CHOICES: usize = 200;

/// The same point as one through which things move, where derivatives occur.
///
/// What is said of the point alone is true there, and leads nothing. Not where that is a slope: of what the author takes as constant
/// something would have to move, so that the laws agree.
pub fn in_motion(
    claim: &Claim,
    problem: &Problem,
    values: &Map<Var, Rational>,
    point: &Assignment,
) -> Option<Assignment> {
    let has_slope = |formula: &Formula| {
        let mut terms = formula.terms().into_iter();
        terms.any(|term| term.any(&|part| matches!(part, Expr::Derivative { .. })))
    };
    let leads = |at: usize| {
        let law = claim.hypotheses.get(at);
        law.is_some_and(|law| law.standing == Standing::Identity || has_slope(&law.formula))
    };
    let mut point = point.clone();
    let mut course = Course::default();
    let said = said_to_move(claim);
    let mut orders: Map<Symbol, (usize, Var)> = Map::new();
    let mut moving: Set<Var> = Set::new();
    let mut by = None;
    for (var, atom) in problem.atoms.iter() {
        let Atom::Opaque(term @ Expr::Derivative { variable, .. }) = atom else {
            continue;
        };
        by = Some(variable);
        let (symbol, order) = differentiated(term)?;
        let value = values.get(&var).map_or_else(one, Rational::to_big);
        // That something moves of which the author does not say so is no objection.
        if !said.contains(symbol) && !value.is_zero() {
            return None;
        }
        let key = (symbol.clone(), variable.clone());
        match order {
            1 => drop(point.derivatives.insert(key, value)),
            order => {
                let higher = course.higher.entry(key).or_default();
                while higher.len() < order - 1 {
                    higher.push(one());
                }
                higher[order - 2] = value;
            }
        }
        moving.insert(var);
        for name in [symbol, variable] {
            moving.extend(problem.atoms.find(&Atom::Symbol(name.clone())));
        }
        let highest = orders.entry(symbol.clone()).or_insert((0, var));
        *highest = (order, var).max(*highest);
    }
    let variable = by?;
    for key in course.higher.keys() {
        point.derivatives.entry(key.clone()).or_insert_with(one);
    }
    let mut laws: Vec<(usize, &Polynomial)> = Vec::new();
    for (Fact { polynomial, sign }, origin) in problem.facts.iter().zip(&problem.origins) {
        if let (Sign::Zero, Origin::Hypothesis(at)) = (sign, origin)
            && !polynomial.is_zero()
            && leads(*at)
        {
            laws.push((*at, polynomial));
        }
    }
    let mut choice = Choice {
        claim,
        atoms: &problem.atoms,
        variable,
        laws,
        highest: orders.values().map(|own| own.1).collect(),
        differentiated: orders.keys().cloned().collect(),
        values,
        left: MOST_CHOICES,
    };
    let leads = choice.extend(Map::new(), &moving)?;
    course.leads = leads
        .into_iter()
        .map(|(law, var)| {
            let term = match problem.atoms.atom(var) {
                Atom::Opaque(term) => term.clone(),
                atom => crate::algebra::expr_of_atom(atom),
            };
            (law, term)
        })
        .collect();
    point.course = Some(course);
    // What was put in has the value that its definition gives it there.
    let defined = point.unfold.iter().filter_map(|&at| {
        let hypothesis = claim.hypotheses.get(at)?;
        crate::kernel::definition(&hypothesis.formula)
    });
    let mut defined: Vec<(Symbol, Expr)> = defined.collect();
    for (symbol, _) in &defined {
        point.symbols.remove(symbol);
    }
    // One may be defined by another.
    while let Some(at) = defined.iter().position(|(symbol, term)| {
        let there = Values {
            symbols: point.symbols.clone(),
            slopes: point.derivatives.clone(),
            higher: point.course.iter().flat_map(|c| c.higher.clone()).collect(),
            still: true,
            ..Values::default()
        };
        let value = there.value(term).ok();
        value.is_some_and(|value| point.symbols.insert(symbol.clone(), value).is_none())
    }) {
        defined.remove(at);
    }
    Some(point)
}

/// The same for a point of another claim about the same symbols, which may ask more.
pub(super) fn moved(obligation: &Obligation, point: &Assignment) -> Option<Assignment> {
    let problem = obligation.as_written();
    let value = |atom: &Atom| match atom {
        Atom::Symbol(symbol) => point.symbols.get(symbol),
        Atom::Opaque(term @ Expr::Derivative { variable, .. }) => {
            let (symbol, order) = differentiated(term)?;
            let key = (symbol.clone(), variable.clone());
            match order {
                1 => point.derivatives.get(&key),
                order => point.course.as_ref()?.higher.get(&key)?.get(order - 2),
            }
        }
        _ => None,
    };
    let values = problem.atoms.iter();
    let values = values.filter_map(|(var, atom)| Some((var, value(atom)?.into())));
    let point = Assignment {
        unfold: obligation.unfold().to_vec(),
        symbols: point.symbols.clone(),
        ..Assignment::default()
    };
    in_motion(obligation.claim(), problem, &values.collect(), &point)
}

/// The symbols that are differentiated where the author writes it. Nobody differentiates what does not change: where that is a term with
/// nothing in it that moves, all of it may.
pub(super) fn said_to_move(claim: &Claim) -> Set<Symbol> {
    let mut found = Set::new();
    let mut bodies = Vec::new();
    for term in claim.formulas().flat_map(Formula::terms) {
        term.collect_differentiated(&mut found);
        differentiated_terms(term, &mut bodies);
    }
    let mut moving = Set::new();
    for (body, variable) in bodies {
        let symbols = body.free_symbols();
        if !symbols
            .iter()
            .any(|own| own == variable || found.contains(own))
        {
            moving.extend(symbols.into_iter().filter(|own| !claim.is_constant(own)));
        }
    }
    found.extend(moving);
    found
}

/// The terms of more than a symbol that are differentiated, with the variable.
fn differentiated_terms<'a>(term: &'a Expr, found: &mut Vec<(&'a Expr, &'a Symbol)>) {
    if let Expr::Derivative { body, variable } = term
        && differentiated(term).is_none()
    {
        found.push((body, variable));
    }
    (term.children()).for_each(|part| differentiated_terms(part, found));
}

fn one() -> BigRational {
    BigRational::from_integer(1.into())
}

/// The symbol that is differentiated, and how often.
pub(super) fn differentiated(term: &Expr) -> Option<(&Symbol, usize)> {
    match term {
        Expr::Symbol(symbol) => Some((symbol, 0)),
        Expr::Derivative { body, .. } => {
            let (symbol, order) = differentiated(body)?;
            Some((symbol, order + 1))
        }
        _ => None,
    }
}

struct Choice<'a> {
    claim: &'a Claim,
    atoms: &'a Atoms,
    variable: &'a Symbol,
    laws: Vec<(usize, &'a Polynomial)>,
    highest: Vec<Var>,
    differentiated: Set<Symbol>,
    values: &'a Map<Var, Rational>,
    left: usize,
}

impl Choice<'_> {
    fn value(&self, polynomial: &Polynomial) -> Option<Rational> {
        let value = |var: Var| Some(self.values.get(&var).cloned().unwrap_or_else(Rational::one));
        polynomial.evaluate(value).ok()?
    }

    /// Gives each law that speaks of something moving an unknown of its own.
    fn extend(&mut self, leads: Map<usize, Var>, moving: &Set<Var>) -> Option<Map<usize, Var>> {
        self.left = self.left.checked_sub(1)?;
        let open = self.laws.iter().find(|(at, law)| {
            !leads.contains_key(at) && law.vars().iter().any(|var| moving.contains(var))
        });
        let Some(&(at, law)) = open else {
            return Some(leads);
        };
        // What is differentiated by leads nothing. Of what speaks of no slope the page mostly says more than the laws of motion do: there no
        // other choice is looked for than the first.
        let is_slope = |part: &Expr| matches!(part, Expr::Derivative { .. });
        let mut goal = self.claim.goal.terms().into_iter();
        let is_of_slopes = goal.any(|term| term.any(&is_slope));
        let may_lead = |symbol: &Symbol| {
            let excluded = is_of_slopes && symbol == self.variable;
            !excluded && !self.differentiated.contains(symbol) && !self.claim.is_constant(symbol)
        };
        let mut candidates = self.highest.clone();
        candidates.extend(law.vars().into_iter().filter(
            |&var| matches!(self.atoms.atom(var), Atom::Symbol(symbol) if may_lead(symbol)),
        ));
        // A law may lead what it does not speak of, if its slope does.
        let slope = slope_along(law, self.atoms, self.variable, moving);
        let slope = slope.filter(|own| self.value(own).is_some_and(|value| value.is_zero()));
        let led = self.highest.iter().filter(|var| law.degree_in(**var) == 0);
        let led = slope
            .iter()
            .flat_map(|own| led.clone().map(move |&var| (own, var)));
        let candidates = candidates.into_iter().map(|var| (law, var));
        let candidates: Vec<(&Polynomial, Var)> = led.chain(candidates).collect();
        for (law, var) in candidates {
            if leads.values().any(|own| *own == var) || law.degree_in(var) == 0 {
                continue;
            }
            let slope = self.value(&law.derivative(var));
            if slope.is_none_or(|slope| slope.is_zero()) {
                continue;
            }
            let (mut leads, mut moving) = (leads.clone(), moving.clone());
            leads.insert(at, var);
            moving.insert(var);
            if let Some(found) = self.extend(leads, &moving) {
                return Some(found);
            }
        }
        None
    }
}
