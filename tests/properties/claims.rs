//! The claims of page 1.4, attacked in two ways that know nothing of each other, and what is true instead.

use cradle_verify::audit::Verdict;
use cradle_verify::derivation::{Checker, Point};
use num_traits::{Signed, Zero};
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::TestRunner;

use super::broken::stands_up;
use super::pages::{holds, report};
use super::physics::*;

/// Balls that leave no faster than the first came, and none backwards: then as many leave as came.
const REPAIRED: &str = r"
<!-- check:
symbols n, k: count, natural
symbols v_0: velocity, in [1, 1]
symbols u_i: velocity, in (0, 1]
-->

<!-- check: law -->
$$ n v_0 = \sum_{i=1}^k u_i \tag{1} $$

<!-- check: law -->
$$ n v_0^2 = \sum_{i=1}^k u_i^2 \tag{2} $$

<!-- check: claim count; derived; from (1), (2) -->
$$ k = n $$

<!-- check: claim velocities; derived; from (1), (2) -->
$$ u_1 = u_2 = \dots = u_k = v_0 $$
";

#[test]
fn a_hunt_refutes_what_the_two_laws_do_not_give() {
    for label in ["6", "23", "n-in-n-out", "27", "41", "33"] {
        let refuted = report()
            .hunt(label)
            .unwrap_or_else(|| panic!("({label}) withstands"));
        stands_up(&refuted).unwrap_or_else(|problem| panic!("({label}): {problem}"));
    }
}

#[test]
fn no_hunt_refutes_what_is_proved_from_what_it_cites() {
    for entry in &report().audit().entries {
        let stale = |code: &str| matches!(code, "miscited" | "citations-shifted");
        let miscited = entry.notes.iter().any(|n| stale(n.code()));
        let equation = &report().derivation().equations[entry.equation];
        let label = equation.label().unwrap();
        if entry.verdict == Verdict::Holds && !miscited && label != "33" {
            assert!(report().hunt(label).is_none(), "({label})");
        }
    }
}

#[test]
fn two_laws_alone_let_more_balls_leave_than_came() {
    let mut runner = TestRunner::deterministic();
    let mut found = 0;
    for _ in 0..64 {
        let cradle = conserved().new_tree(&mut runner).unwrap().current();
        let at = cradle.point();
        found += usize::from(
            holds(report(), "17", &at)
                && holds(report(), "18", &at)
                && !holds(report(), "n-in-n-out", &at),
        );
    }
    assert!(found > 16, "{found}");
}

#[test]
fn the_repaired_claim_withstands() {
    let repaired = Checker::from_markdown("repaired.md", REPAIRED);
    for label in ["count", "velocities"] {
        assert!(repaired.hunt(label).is_none(), "{label}");
    }
    for entry in &repaired.audit().entries {
        assert_ne!(entry.verdict, Verdict::Fails);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn colliding_balls_never_refute_the_repaired_claim(cradle in collided()) {
        let repaired = Checker::from_markdown("repaired.md", REPAIRED);
        // In units of the velocity of those that come in.
        let unit = Cradle {
            after: cradle.after.iter().map(|u| u / &cradle.v0).collect(),
            v0: ratio(1, 1),
            ..cradle
        };
        let at: Point = unit.point();
        for label in ["1", "2", "count", "velocities"] {
            prop_assert!(holds(&repaired, label, &at), "{}", label);
        }
    }

    #[test]
    fn nor_does_any_list_that_both_laws_allow(cradle in conserved()) {
        let within = |u: &cradle_verify::algebra::BigRational| {
            let share = u / &cradle.v0;
            share.is_positive() && share <= ratio(1, 1)
        };
        prop_assert!(cradle.after.iter().all(|u| !u.is_zero()));
        if cradle.after.iter().all(within) {
            prop_assert!(cradle.after.iter().all(|u| *u == cradle.v0));
            prop_assert_eq!(cradle.after.len(), cradle.moving);
        }
    }
}
