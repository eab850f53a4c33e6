//! Uncertainties of what is calculated: "The uncertainty is $$\frac{\sigma_v}{v} = \frac12 \cot\frac{\theta}{2}\, \sigma_\theta$$" after
//! $v = 2 \sqrt{g L} \sin\frac{\theta}{2}$.
//!
//! **Statement.** To first order, and where what is measured is independent, $\sigma_y^2 = \sum_i (\partial y/\partial x_i)^2 \sigma_{x_i}^2$ for
//! $y = f(x_1, \dots, x_n)$: the law of propagation of uncertainty (JCGM 100:2008, 5.1.2). It is what words mean that speak of
//! uncertainties, and it is told that it was taken. What has no $\sigma$ in the step is exact.

use crate::algebra::{Expr, Formula, Relation, Symbol, split_subscript};
use crate::derivation::{Assumed, Goal, Source};
use crate::sorted::Set;

use super::judge::{Judge, step};

/// With one of these words a step is about uncertainties.
const UNCERTAIN: [&str; 8] = [
    "uncertainty",
    "uncertainties",
    "error",
    "errors",
    "propagation",
    "propagating",
    "deviation",
    "deviations",
];
/// The letter of a standard uncertainty.
const SIGMA: &str = "\\sigma";
/// So many quantities with uncertainties are looked at in a step.
const MOST_MEASURED: usize = 6;

impl Judge<'_> {
    /// The law of propagation for the uncertainty of which a goal speaks, where words call it one and a premise says from what the quantity is
    /// calculated; nothing otherwise.
    pub(super) fn propagated(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        premises: &[usize],
    ) -> Vec<Assumed> {
        let names = goal.formula.names();
        let measured: Vec<(Symbol, &Symbol)> = (names.iter())
            .filter_map(|sigma| Some((measured_by(sigma)?, sigma)))
            .collect();
        // "and (3) with the exponents 1 and −2 gives": what is cited speaks of uncertainties.
        let is_of_uncertainties = |own: &Assumed| {
            let names = own.formula.names();
            let uncertain = names.iter().filter(|own| measured_by(own).is_some());
            matches!(own.source, Source::Equation(_)) && uncertain.count() >= 2
        };
        if !(2..=MOST_MEASURED).contains(&measured.len())
            || !self.says(&UNCERTAIN) && !assumed.iter().any(is_of_uncertainties)
        {
            return Vec::new();
        }
        let told = self.derivation.told(self.at);
        let [others, _] = self.others(premises);
        let calculated = assumed.iter().chain(&told).chain(others).find_map(|own| {
            let (Expr::Symbol(of), term) = own.formula.as_equation()? else {
                return None;
            };
            let (_, sigma) = measured.iter().find(|(own, _)| own == of)?;
            let parts = measured.iter().filter(|(own, _)| term.mentions(own));
            let parts: Vec<&(Symbol, &Symbol)> = parts.filter(|(own, _)| own != of).collect();
            // Every other uncertainty is one of what it is calculated from.
            (parts.len() + 1 == measured.len()).then_some((own, *sigma, term, parts))
        });
        let Some((said, sigma, term, parts)) = calculated else {
            return Vec::new();
        };
        let square = |own: Expr| Expr::Power(own.into(), Expr::integer(2).into());
        let share = |(of, sigma): &&(Symbol, &Symbol)| {
            let slope = slope(term, of);
            Expr::Product([square(slope), square(Expr::Symbol((*sigma).clone()))].into())
        };
        let shares: Vec<Expr> = parts.iter().map(share).collect();
        let sum = match &shares[..] {
            [single] => single.clone(),
            _ => Expr::Sum(shares.into()),
        };
        let law = Formula::equal(square(Expr::Symbol(sigma.clone())), sum);
        let at_least_nought = |own: &Symbol| Formula::Relation {
            left: Expr::Symbol(own.clone()),
            relation: Relation::GreaterOrEqual,
            right: Expr::integer(0),
        };
        let signs = measured.iter().map(|(_, sigma)| at_least_nought(sigma));
        let all: Vec<Formula> = [law].into_iter().chain(signs).collect();
        let said = Some(said).filter(|own| !assumed.contains(own)).cloned();
        let law = all.iter().map(|own| Assumed {
            source: Source::Propagation,
            ..step(own)
        });
        said.into_iter().chain(law).collect()
    }
}

/// What a symbol is the standard uncertainty of: `v` of `\sigma_v`.
fn measured_by(sigma: &Symbol) -> Option<Symbol> {
    let (stem, index) = split_subscript(sigma.name())?;
    (stem == SIGMA).then(|| Symbol::new(index))
}

/// How a term changes with one symbol where none of its others does.
fn slope(term: &Expr, variable: &Symbol) -> Expr {
    let others: Set<Symbol> = term.free_symbols();
    let held = others.into_iter().filter(|own| own != variable);
    Expr::Partial {
        body: term.clone().into(),
        variable: variable.clone(),
        held: Some(held.collect()),
    }
}
