//! Slopes along a motion: `\frac{dI}{dS}` where laws say how `I` and `S` change in time. Who divides one law by the other means
//! `\frac{dI}{dt} = \frac{dI}{dS} \frac{dS}{dt}`, and does not write it.

use crate::algebra::{Expr, Formula, Symbol};
use crate::derivation::{Assumed, Goal, dotted};
use crate::sorted::Set;

use super::judge::{Judge, taken};

/// So many slopes of one thing by another are looked at in a step.
const MOST_SLOPES: usize = 4;

impl Judge<'_> {
    /// That a slope of which a goal speaks is that of one thing by another along the motion of both; nothing where laws speak of it
    /// themselves.
    pub(super) fn along_the_motion(&self, goal: &Goal, assumed: &[Assumed]) -> Vec<Assumed> {
        let mut slopes = Set::new();
        let terms = goal.formula.terms();
        terms
            .into_iter()
            .for_each(|term| collect(term, &mut slopes));
        if slopes.is_empty() || slopes.len() > MOST_SLOPES {
            return Vec::new();
        }
        let mut known = Set::new();
        let terms = assumed.iter().flat_map(|own| own.formula.terms());
        terms.for_each(|term| collect(term, &mut known));
        let moves =
            |own: &Symbol, variable: &Symbol| known.contains(&(own.clone(), variable.clone()));
        let variables: Set<&Symbol> = known.iter().map(|(_, variable)| variable).collect();
        let names = Formula::names_in(assumed.iter().flat_map(|own| own.formula.terms()));
        let along = |(of, by): &(Symbol, Symbol)| {
            let times = variables
                .iter()
                .filter(|own| moves(of, own) && moves(by, own));
            let rate = |own: &Symbol| match times.clone().next() {
                Some(time) => Some(Expr::Symbol(own.clone()).differentiated_by(time)),
                // `\dot S` says so, too.
                None => {
                    let rate = dotted(own, false);
                    names.contains(&rate).then_some(Expr::Symbol(rate))
                }
            };
            let slope = Expr::Symbol(of.clone()).differentiated_by(by);
            let carried = Expr::Product([slope, rate(by)?].into());
            Some(taken(&Formula::equal(rate(of)?, carried)))
        };
        let new = slopes.iter().filter(|own| !known.contains(own));
        new.filter_map(along).collect()
    }
}

/// The slopes of symbols by symbols in a term: of what, and by what.
fn collect(term: &Expr, found: &mut Set<(Symbol, Symbol)>) {
    if let Expr::Derivative { body, variable } = term
        && let Expr::Symbol(of) = &**body
    {
        found.insert((of.clone(), variable.clone()));
    }
    term.children().for_each(|part| collect(part, found));
}
