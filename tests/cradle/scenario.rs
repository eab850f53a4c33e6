//! Scenarios that are none, and what one of them is called.

use cradle_verify::cradle::parse_list;
use cradle_verify::cradle::{Scenario, ScenarioError};
use nalgebra::DVector;

fn refusal(masses: &str, before: &str, after: &str) -> String {
    let list = |text| parse_list(text).unwrap();
    Scenario::new(list(masses), list(before), list(after))
        .unwrap_err()
        .to_string()
}

#[test]
fn what_is_no_scenario_is_refused_with_the_reason() {
    assert_eq!(
        refusal("1, 1", "1", "0, 1, 0"),
        "each ball needs a mass, a velocity before and a velocity after, but there are 2, 1 and 3 of them"
    );
    assert_eq!(
        refusal("1, -2/3", "1, 0", "0, 1"),
        "ball 2 has the mass -2/3: it must be positive"
    );
    let nothing = || DVector::from_vec(vec![]);
    assert_eq!(
        Scenario::new(nothing(), nothing(), nothing()),
        Err(ScenarioError::NoBalls)
    );
}

#[test]
fn a_scenario_of_ones_own_is_told_in_a_sentence() {
    let list = |text| parse_list(text).unwrap();
    let scenario = Scenario::new(list("1, 1, 1"), list("1, 0, 0"), list("0, 1/2, 1/2")).unwrap();
    assert_eq!(
        scenario.sentence(),
        "three balls, one moving before and two after"
    );
}
