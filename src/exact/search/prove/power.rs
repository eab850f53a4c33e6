//! What roots and powers are, where only a proof tells that their base is not negative.

use super::{Effort, Prover};
use crate::algebra::{Atom, Expr, TooLarge, Var};
use crate::kernel::{Fact, Problem, Proof, Sign};

/// So many roots of a goal are looked into.
const MOST_POWERS: usize = 4;

impl Prover {
    /// Adds what the roots and powers of the goal are, where that follows from a sign of their base that must be proved:
    /// `v = b \sqrt{x}` from `v^2 = b^2 x`, which says that `x` is not negative.
    pub(in super::super) fn learn_powers(&mut self, problem: &Problem) -> Result<(), TooLarge> {
        let powers = problem.goal.polynomial.vars().into_iter().filter(|var| {
            let atom = problem.atoms.atom(*var);
            matches!(atom, Atom::Opaque(Expr::Power(..)))
        });
        let mut found = false;
        for power in powers.take(MOST_POWERS) {
            found |= self.learn_power(problem, power);
        }
        if found {
            self.read_equations()?;
            self.take_roots(problem.takes_powers_apart())?;
        }
        Ok(())
    }

    /// Whether anything was learnt of one of them.
    fn learn_power(&mut self, problem: &Problem, power: Var) -> bool {
        let Some(polynomial) = problem.sign_of_base(power) else {
            return false;
        };
        if self.knows(&polynomial, Sign::NonNegative) {
            return false;
        }
        let sign = |sign| Fact {
            polynomial: polynomial.clone(),
            sign,
        };
        let proved = [Sign::Positive, Sign::NonNegative]
            .map(sign)
            .into_iter()
            .find_map(|fact| Some((self.prove(&fact, Effort::Full)?, fact)));
        let Some((proof, fact)) = proved else {
            return false;
        };
        let base = self.add(fact, proof);
        let told = problem.about_power(power, &self.knowledge);
        for fact in told.unwrap_or_default() {
            self.add(fact, Proof::OfPower { power, base });
        }
        true
    }
}
