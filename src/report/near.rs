//! The equations that were perhaps meant.

use crate::derivation::Derivation;
use crate::sorted;

/// The numbers and names nearest to one that is not there: at most five.
pub fn near_misses(derivation: &Derivation, label: &str) -> Vec<String> {
    let label = label.trim().trim_start_matches("claim ").trim();
    let label = label.trim_start_matches('(').trim_end_matches(')');
    let label: String = label.chars().take(64).collect();
    // Of numbers at the same distance the nearer ones come first.
    let number: Option<u64> = label.parse().ok();
    let apart = |own: &str| Some(own.parse::<u64>().ok()?.abs_diff(number?));
    let mut all: Vec<(usize, Option<u64>, String)> = Vec::new();
    for equation in &derivation.equations {
        for own in [&equation.tag, &equation.name].into_iter().flatten() {
            let far = strsim::osa_distance(&label.to_lowercase(), &own.to_lowercase());
            let part = label.chars().count() > 2 && own.contains(label.as_str());
            if part || far <= 1 + label.chars().count() / 4 {
                all.push((if part { 0 } else { far }, apart(own), own.clone()));
            }
        }
    }
    sorted::sort(&mut all);
    all.dedup();
    all.into_iter().take(5).map(|(_, _, own)| own).collect()
}
