//! Relations between logarithms of numbers that are false, though no side has a rational value anywhere: `t = \frac{\ln 3}{k}` where
//! `e^{k t} = 2`, or `\ln 3 < \ln 2`.

use super::{Consistency, Decision, Effort, consistency_posed, prove_unconditionally};
use crate::algebra::{Atom, Expr, Function};
use crate::kernel::{Assignment, Obligation};

/// Refutes a relation where logarithms are spoken of: the opposite is proved, and a point is found at which the hypotheses are true.
pub(super) fn decide(obligation: &Obligation, hints: &[Assignment]) -> Option<Decision> {
    let is_logarithm = |atom: &Atom| matches!(atom, Atom::Opaque(Expr::Call(Function::Ln, _)));
    let atoms = &obligation.problem().atoms;
    if !atoms.iter().any(|(_, atom)| is_logarithm(atom)) {
        return None;
    }
    let mut claim = obligation.claim().clone();
    claim.goal = claim.goal.denied()?;
    let opposite = prove_unconditionally(claim.clone(), Effort::Full)?;
    let premises = Obligation::of_premises(claim, obligation.unfold().to_vec()).ok()?;
    let Consistency::Model(model) = consistency_posed(&premises, hints) else {
        return None;
    };
    let refuted = obligation.refuted_by_opposite(&opposite.proven, model.point().clone());
    refuted.ok().map(Decision::Refuted)
}
