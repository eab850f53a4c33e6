//! Premises that no author joins: equations of two cases that are not cited, and true together only where hardly anything is left.

use crate::algebra::{Atom, Atoms, Expr, Formula, Lowering, Symbol};
use crate::derivation::{Assumed, Goal, Source};
use crate::search;

use super::super::judge::{Found, Judge};
use super::super::{Judged, Outcome};

/// Why nothing is proved from what stands before and is not cited.
const TOGETHER: &str =
    "with what stands before and is not cited it is so only where something else vanishes";

impl Judge<'_> {
    /// The step judged from what it cites alone, where it follows only with premises that no author joins, and these can all be true only
    /// where something that it speaks of is 0: those of two cases, "at the top" and "on landing", are mostly true together where nothing
    /// is thrown.
    pub(in crate::audit) fn alone_after_all(
        &self,
        goal: &Goal,
        steps: &[(usize, Formula)],
        premises: &[usize],
        found: &Found,
    ) -> Option<Found> {
        goal.formula.as_equation()?;
        let is_own = |own: &Assumed| match own.source {
            Source::Equation(at) => premises.contains(&at),
            _ => true,
        };
        let joined = &found.judged.assumed;
        let says_zero = || goal.formula.terms().contains(&&Expr::integer(0));
        if joined.iter().all(is_own) || says_zero() {
            return None;
        }
        // What is false may be what makes it vanish.
        if !self.failing(premises).is_empty() {
            return None;
        }
        let claim = self.derivation.claim(self.at, joined, &goal.formula);
        let constants = found.constant.iter().cloned();
        let posed = self.pose_claim(search::with_constants(claim, constants));
        if !posed.is_ok_and(|posed| search::makes_goal_vanish(&posed)) {
            return None;
        }
        let assumed = self.cited(goal, steps, premises);
        let mut own = Found::open(Judged {
            goal: goal.clone(),
            assumed: assumed.clone(),
            outcome: Outcome::open(TOGETHER),
        });
        if let Some(refuted) = self.counterexample(&assumed, &goal.formula) {
            own.judged.outcome = Outcome::Refuted(refuted.into());
            self.instead(goal, &assumed, premises, &mut own);
        }
        Some(own)
    }

    /// The step judged without an equation that nobody cites and that alone speaks of an unknown, where the proof makes use of it: that
    /// `s^2 + 2 g s + w^2 = 0` has a root says that `w^2 \leq g^2`, and who goes on to what is so for weak damping means none that is real.
    pub(in crate::audit) fn without_roots(
        &self,
        goal: &Goal,
        steps: &[(usize, Formula)],
        premises: &[usize],
        found: &Found,
    ) -> Option<Found> {
        goal.formula.as_equation()?;
        // What is so throughout says nothing of where something has a root.
        if !self.cites_loosely() || !found.constant.is_empty() {
            return None;
        }
        let used = &found.judged.assumed;
        let elsewhere = |own: &Assumed, symbol: &Symbol| {
            let mut others = used.iter().filter(|other| *other != own);
            goal.formula.names().contains(symbol)
                || others.any(|other| other.formula.names().contains(symbol))
        };
        // What is said of every whole number is used at some, and π is no unknown.
        let page = &self.derivation.pages[self.derivation.equations[self.at].page];
        let is_known = |symbol: &Symbol| match page.domains.get(symbol) {
            Some(own) => own.integer,
            None => page.is_number(symbol),
        };
        // What a function is has a value for every argument.
        let is_function = |own: &Assumed| {
            let sides = own.formula.as_equation();
            sides.is_some_and(|(left, _)| left.is_value_somewhere())
        };
        let root_of = |own: &Assumed| {
            let mut names = own.formula.names().into_iter();
            let root = names.find(|symbol| {
                !is_known(symbol) && !elsewhere(own, symbol) && is_curved_in(&own.formula, symbol)
            });
            Some((own.source, root.filter(|_| !is_function(own))?))
        };
        let (source, root) = used.iter().find_map(root_of)?;
        let Source::Equation(at) = source else {
            return None;
        };
        // The rest of its chain says more than that: `E = \frac{n^2 \pi^2 k^2}{2 m a^2} = \frac{n^2 h^2}{8 m a^2}`.
        let speaks = |own: &Assumed| own.source == source && own.formula.names().contains(&root);
        let assumed = self.cited(goal, steps, premises).into_iter();
        let assumed = assumed.filter(|own| !speaks(own)).collect();
        let premises: Vec<usize> = premises.iter().copied().chain([at]).collect();
        Some(self.judged(goal, assumed, &premises))
    }
}

/// Whether an equation says of a symbol that a polynomial in it vanishes which may have no root.
fn is_curved_in(formula: &Formula, symbol: &Symbol) -> bool {
    let mut atoms = Atoms::default();
    let mut lowering = Lowering::plain(&mut atoms);
    let sides = formula.as_equation();
    let difference = sides.and_then(|(left, right)| {
        let (left, right) = (lowering.lower(left).ok()?, lowering.lower(right).ok()?);
        left.minus(&right).ok()
    });
    let own = atoms.find(&Atom::Symbol(symbol.clone()));
    let degree = difference
        .zip(own)
        .map(|(difference, own)| difference.numerator().degree_in(own));
    degree.is_some_and(|degree| degree > 1)
}
