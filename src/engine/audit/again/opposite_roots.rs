//! Equations with roots of opposite terms, `\lambda = -\gamma \pm \sqrt{\gamma^2 - \omega_0^2}` and `\omega_d = \sqrt{\omega_0^2 - \gamma^2}`:
//! where one root is a number the other is imaginary, so that a step is drawn from one of them.

use crate::algebra::{Expr, Formula};
use crate::derivation::{Assumed, Source, comes_to_nothing};
use crate::sorted::Set;

use super::super::judge::Judge;

impl Judge<'_> {
    /// Leaves out what an equation says of the root of a term where another, which is nearer to the step, says something of the root of its
    /// opposite; or the nearer one, where the step speaks of what is said of the other alone.
    pub(super) fn leave_out_opposite_roots(&self, gathered: &mut Vec<Assumed>) {
        let of = |own: &Assumed| match own.source {
            Source::Equation(at) => Some((at, terms_below_roots(&own.formula))),
            _ => None,
        };
        let below: Vec<(usize, Vec<Expr>)> = gathered.iter().filter_map(of).collect();
        let all = || below.iter().filter(|(_, terms)| !terms.is_empty());
        if all().nth(1).is_none() {
            return;
        }
        let spoken = self.derivation.equations[self.at].symbols();
        let speaks_of = |at: usize, other: usize| {
            let own = self.derivation.equations[at].symbols();
            let other = self.derivation.equations[other].symbols();
            own.difference(&other).any(|own| spoken.contains(own))
        };
        let mut left_out: Set<usize> = Set::new();
        for (one, terms) in all() {
            let mut others = all().filter(|(other, _)| other > one);
            let is_opposed = |(_, other): &&(usize, Vec<Expr>)| {
                { terms.iter() }.any(|own| other.iter().any(|other| are_opposite(own, other)))
            };
            if let Some((other, _)) = others.find(is_opposed) {
                let is_of_first = speaks_of(*one, *other) && !speaks_of(*other, *one);
                left_out.insert(if is_of_first { *other } else { *one });
            }
        }
        gathered.retain(|own| match own.source {
            Source::Equation(at) => !left_out.contains(&at),
            _ => true,
        });
    }
}

/// What square roots are taken of in a formula, where it is a sum.
fn terms_below_roots(formula: &Formula) -> Vec<Expr> {
    fn collect(term: &Expr, below: &mut Vec<Expr>) {
        if term.is_root()
            && let Expr::Power(base, _) = term
            && matches!(**base, Expr::Sum(_))
            && !below.contains(base)
        {
            below.push((**base).clone());
        }
        term.children().for_each(|part| collect(part, below));
    }
    let mut below = Vec::new();
    formula
        .terms()
        .into_iter()
        .for_each(|term| collect(term, &mut below));
    below
}

/// Whether two terms add up to nothing.
fn are_opposite(one: &Expr, other: &Expr) -> bool {
    comes_to_nothing(&Expr::Sum([one.clone(), other.clone()].into()))
}
