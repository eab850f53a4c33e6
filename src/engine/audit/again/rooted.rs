//! Roots that solve no equation: "Equilibria satisfy $r N (1 - N/K) = H$, a quadratic with roots $$N_\pm = …$$"
//!
//! A new name for a root would be defined by what stands for it. Put into the equation that the words before it speak of, it must solve that.

use crate::algebra::{Expr, Formula, Symbol, effort};
use crate::derivation::{Assumed, Goal, Source};
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
        if !goal.is_said_outright() || !self.says(&ROOTS) || self.is_of_another_law() {
            return None;
        }
        let (solved, unknown) = self.equation_of(root, value, premises)?;
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

    /// The equation that something is said to be a root of, and the unknown of it: what the last sentence says, what is cited, or what stands
    /// just before.
    fn equation_of(
        &self,
        root: &Symbol,
        value: &Expr,
        premises: &[usize],
    ) -> Option<(Formula, Symbol)> {
        let said = self.derivation.written_before(self.at);
        let cited = self.usable.assumed.iter().filter(|own| match own.source {
            Source::Equation(at) => premises.contains(&at),
            _ => false,
        });
        let cited = cited.map(|own| (*own.formula).clone());
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
