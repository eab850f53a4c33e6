//! Some equations judged, and only what these depend on: nothing comes out differently from the whole audit.

use cradle_verify::audit::{Audit, Entry};
use cradle_verify::proofs;

/// Every so many equations one is asked for.
const APART: usize = 11;

#[test]
fn what_is_judged_alone_is_judged_the_same() {
    let derivation = proofs::report();
    let whole = Audit::of(&derivation);
    let told = |entry: &Entry| {
        let holds = entry.judged.iter().map(|judged| judged.outcome.is_proven());
        let instead = entry.implied.as_deref();
        (
            entry.part,
            entry.verdict,
            entry.rests_on.clone(),
            holds.collect::<Vec<bool>>(),
            instead.map(|implied| implied.proven.claim().goal.clone()),
        )
    };
    let mut fewest = derivation.equations.len();
    for at in (0..derivation.equations.len()).step_by(APART) {
        let alone = Audit::of_these(&derivation, &[at]);
        let found: Vec<_> = alone.of_equation(at).iter().map(told).collect();
        let expected: Vec<_> = whole.of_equation(at).iter().map(told).collect();
        assert!(!found.is_empty());
        assert_eq!(found, expected, "{}", derivation.equations[at].reference());
        assert!(alone.entries.len() <= whole.entries.len());
        fewest = fewest.min(alone.entries.len());
    }
    // Not all was judged each time.
    assert!(fewest < derivation.equations.len() / 4);
}
