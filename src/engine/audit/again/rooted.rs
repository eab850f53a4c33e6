//! Roots that solve no equation: "Equilibria satisfy $r N (1 - N/K) = H$, a quadratic with roots $$N_\pm = …$$"
//!
//! A new name for a root would be defined by what stands for it. Put into the equation that the words before it speak of, it must solve that.

use crate::algebra::{Expr, Formula, Symbol, effort};
use crate::derivation::{Assumed, Goal, Source, formulas};
use crate::kernel::Standing;
use crate::search::Decision;
use crate::sorted::Set;

use super::super::judge::{Found, Judge, taken};
use super::borrowed::chain_of;
use super::obeys::refuted_of;

/// With one of these the words before a display say that it solves something.
const ROOTS: [&str; 12] = [
    "root",
    "roots",
    "solution",
    "solutions",
    "solve",
    "solved",
    "solves",
    "solving",
    "quadratic",
    "zeros",
    "zeroes",
    "satisfied",
];
/// So much work is done, as [`effort`] counts it.
const MOST_WORK: u64 = 500_000;

impl Judge<'_> {
    /// What to say of a root that does not solve the equation that it is said to be one of.
    pub(in crate::audit) fn as_no_root(&self, goal: &Goal, premises: &[usize]) -> Option<Found> {
        let (Expr::Symbol(root), value) = goal.formula.as_equation()? else {
            return None;
        };
        if !self.is_said_to_solve(goal) {
            return None;
        }
        let (solved, unknown) = self.equation_of(root, value, premises)?;
        // `P = \frac{V^2 R}{…}` is so for some `P` whatever the root: "It falls to half where … gives a quadratic equation whose roots are".
        if let Some((Expr::Symbol(of), _)) = solved.as_equation()
            && *of != unknown
            && !value.mentions(of)
        {
            return None;
        }
        let own = Expr::Symbol(root.clone());
        let there = solved.map_terms(|term| term.substitute(&unknown, &own));
        let speaks = |own: &Assumed| {
            let names = own.formula.names();
            names.contains(&unknown) || names.contains(root)
        };
        // What says what the symbols are, and those in that.
        let [near, _] = self.others(premises);
        let besides = self.usable.assumed.iter().chain(near);
        let besides = besides.filter(|own| !speaks(own) && !own.formula.speaks_of_slopes());
        let mut symbols = goal.formula.names();
        symbols.extend(there.names());
        let known = solved.names();
        let is_said_by = |own: &Assumed, symbol: &Symbol| {
            let said = own.formula.said_of();
            said.is_some_and(|(of, value)| of == symbol && value.free_symbols().is_subset(&known))
        };
        // What else it is made of may be of another state: `T_2 = T_1 V_2/V_1` beside `P V = n R T`.
        let is_known = |symbol: &Symbol| {
            let is_number = symbol.is_unit() || symbol.name() == "\\pi";
            is_number
                || known.contains(symbol)
                || besides.clone().any(|own| is_said_by(own, symbol))
        };
        if !value.free_symbols().iter().all(is_known) {
            return None;
        }
        let means = |own: &Assumed, symbols: &Set<Symbol>| match own.formula.as_equation() {
            Some((Expr::Symbol(name), _)) => symbols.contains(name),
            Some(_) => false,
            None => own.formula.names().is_subset(symbols),
        };
        let mut assumed = vec![Assumed {
            standing: Standing::Identity,
            ..taken(&goal.formula)
        }];
        assumed.extend(chain_of(
            &mut besides.cloned().collect(),
            &mut symbols,
            means,
        ));
        let assumed = self.where_all_is_positive(goal, assumed);
        effort::within(MOST_WORK, || match self.decide_from(&assumed, &there)? {
            Decision::Refuted(refuted) => Some(refuted_of(goal, &there, &assumed, refuted)),
            _ => None,
        })
    }

    /// What to say of a value that is said to solve a system of equations together with what stands beside it, and does not: "Solving the pair
    /// (4) we get $$q_1^* = …, \qquad q_2^* = …$$".
    pub(in crate::audit) fn as_no_root_of_system(
        &self,
        goal: &Goal,
        premises: &[usize],
    ) -> Option<Found> {
        let (Expr::Symbol(_), value) = goal.formula.as_equation()? else {
            return None;
        };
        if !self.is_said_to_solve(goal) {
            return None;
        }
        let own = self.derivation.equations[self.at].statements();
        let roots: Vec<Symbol> = own.iter().flat_map(formulas).filter_map(root_of).collect();
        let cited: Vec<&Formula> = self.cited_laws(premises).collect();
        let named = Formula::names_in(cited.iter().flat_map(|own| own.terms()));
        if roots.len() < 2 || roots.iter().any(|own| named.contains(own)) {
            return None;
        }
        let unknowns: Vec<Symbol> = (roots.iter())
            .map(|root| {
                let is_one = |own: &&Symbol| root.is_variant_of(own) || is_starred(root, own);
                let mut all = named.iter().filter(is_one);
                all.next().filter(|_| all.next().is_none()).cloned()
            })
            .collect::<Option<_>>()?;
        let is_unknown = |own: &Symbol| unknowns.contains(own);
        // `\omega_+` and `\omega_-` are the two roots of one equation.
        let is_twice = |at: usize| unknowns[..at].contains(&unknowns[at]);
        if (0..unknowns.len()).any(is_twice) {
            return None;
        }
        let values = own.iter().flat_map(formulas);
        let speaks = |own: &Formula| own.names().iter().any(is_unknown);
        if values.clone().any(|own| speaks(&own)) || !value.free_symbols().is_subset(&named) {
            return None;
        }
        let system = cited.into_iter().filter(|own| speaks(own));
        let system = system.filter(|own| own.as_equation().is_some() && !own.speaks_of_slopes());
        let put_in = |law: &Formula| {
            law.map_terms(|term| {
                (unknowns.iter().zip(&roots)).fold(term.clone(), |term, (of, root)| {
                    term.substitute(of, &Expr::Symbol(root.clone()))
                })
            })
        };
        let system: Vec<Formula> = system.map(put_in).collect();
        if system.len() < roots.len() {
            return None;
        }
        let values = values.map(|own| Assumed {
            standing: Standing::Identity,
            ..taken(&own)
        });
        let values = self.where_all_is_positive(goal, values.collect());
        let assumed = self.where_all_is_positive(goal, system.iter().map(taken).collect());
        effort::within(MOST_WORK, || {
            // It is this one that is wrong, and not what stands beside it; that shows where all of them are put in.
            self.counterexample(&assumed, &goal.formula)?;
            system.iter().find_map(|law| {
                let refuted = self.counterexample(&values, law)?;
                Some(refuted_of(goal, law, &values, refuted))
            })
        })
    }

    /// Whether words say that a goal solves something, and not another law than stands before.
    fn is_said_to_solve(&self, goal: &Goal) -> bool {
        goal.is_said_outright() && self.says(&ROOTS) && !self.is_of_another_law()
    }

    /// What the equations say that are cited.
    fn cited_laws(&self, premises: &[usize]) -> impl Iterator<Item = &Formula> {
        let cited = self.usable.assumed.iter().filter(|own| match own.source {
            Source::Equation(at) => premises.contains(&at),
            _ => false,
        });
        cited.map(|own| &*own.formula)
    }

    /// The equation that something is said to be a root of, and the unknown of it: what the last sentence says, what is cited, or what stands
    /// just before.
    fn equation_of(
        &self,
        root: &Symbol,
        value: &Expr,
        premises: &[usize],
    ) -> Option<(Formula, Symbol)> {
        let said = self.derivation.written_before(self.at);
        let cited = self.cited_laws(premises).cloned();
        let unknown = |formula: &Formula| {
            let (left, right) = formula.as_equation()?;
            let is_one = |own: &&Symbol| root.is_variant_of(own) && !value.mentions(own);
            let of = formula.names().iter().find(is_one).cloned()?;
            let is_plain = !formula.speaks_of_slopes() && !formula.names().contains(root);
            // What is given by it is no root: `N = r + 1`.
            let is_given = |side: &Expr, other: &Expr| {
                *side == Expr::Symbol(of.clone()) && !other.mentions(&of)
            };
            let is_open = !is_given(left, right) && !is_given(right, left);
            (is_plain && is_open).then_some(of)
        };
        let mut found = said
            .into_iter()
            .chain(cited)
            .filter_map(|own| unknown(&own).map(|of| (own, of)));
        let first = found.next()?;
        // Nobody knows which of two is meant.
        found.all(|other| other == first).then_some(first)
    }
}

/// What an equation gives, if it gives a symbol.
fn root_of(formula: Formula) -> Option<Symbol> {
    match formula.as_equation()? {
        (Expr::Symbol(root), value) if !value.mentions(root) => Some(root.clone()),
        _ => None,
    }
}

/// Whether a name is that of another with a star: `q_1^*`, which is written `q^*_1`.
fn is_starred(own: &Symbol, other: &Symbol) -> bool {
    const STAR: &str = "^*";
    own.name().contains(STAR) && own.name().replacen(STAR, "", 1) == other.name()
}
