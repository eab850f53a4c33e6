//! The equations that were perhaps meant.

use crate::derivation::Derivation;

/// The numbers and names nearest to one that is not there: at most five.
pub fn near_misses(derivation: &Derivation, label: &str) -> Vec<String> {
    let label = label.trim().trim_start_matches("claim ").trim();
    let label = label.trim_start_matches('(').trim_end_matches(')');
    let label: String = label.chars().take(64).collect();
    let mut all: Vec<(usize, String)> = Vec::new();
    for equation in &derivation.equations {
        for own in [&equation.tag, &equation.name].into_iter().flatten() {
            let far = distance(&label.to_lowercase(), &own.to_lowercase());
            let part = label.chars().count() > 2 && own.contains(label.as_str());
            if part || far <= 1 + label.chars().count() / 4 {
                all.push((if part { 0 } else { far }, own.clone()));
            }
        }
    }
    all.sort();
    all.dedup();
    all.into_iter().take(5).map(|(_, own)| own).collect()
}

/// How many letters must be changed, inserted or dropped.
fn distance(left: &str, right: &str) -> usize {
    let right: Vec<char> = right.chars().collect();
    let mut row: Vec<usize> = (0..=right.len()).collect();
    for (i, own) in left.chars().enumerate() {
        let mut diagonal = std::mem::replace(&mut row[0], i + 1);
        for (j, other) in right.iter().enumerate() {
            let changed = diagonal + usize::from(own != *other);
            diagonal = row[j + 1];
            row[j + 1] = changed.min(diagonal + 1).min(row[j] + 1);
        }
    }
    row[right.len()]
}
