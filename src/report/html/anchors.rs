//! What the parts of the page are called in links: each its own name, whatever the author numbers how.

use std::collections::BTreeSet;

use crate::audit::Entry;
use crate::report::Report;
use crate::sorted::Tree;

/// The names, by position in the derivation.
pub(super) struct Anchors {
    equations: Vec<String>,
    /// The first equation of each number or name.
    labels: Tree<String, usize>,
    /// The first equation of each key.
    keys: Tree<String, usize>,
}

impl Anchors {
    /// `eq-23` where the number is made of letters and digits and is the first such, otherwise by position, `eq--7`.
    pub(super) fn of(report: &Report<'_>) -> Anchors {
        let mut taken: BTreeSet<String> = BTreeSet::new();
        let (mut labels, mut keys) = (Tree::new(), Tree::new());
        let mut equations = Vec::new();
        for (at, equation) in report.derivation.equations.iter().enumerate() {
            for label in [&equation.tag, &equation.name].into_iter().flatten() {
                labels.entry(label.clone()).or_insert(at);
            }
            for key in &equation.keys {
                keys.entry(key.clone()).or_insert(at);
            }
            let plain = |c: char| c.is_ascii_alphanumeric() || matches!(c, '.' | '-' | '_');
            let named = equation.label().filter(|label| {
                let starts = label.starts_with(|c: char| c.is_ascii_alphanumeric());
                starts && label.len() <= 40 && label.chars().all(plain)
            });
            let own = named.map(|label| format!("eq-{label}"));
            let own = own.filter(|own| !taken.contains(own));
            // No label starts with a dash, so this is nobody else's.
            let own = own.unwrap_or_else(|| format!("eq--{}", at + 1));
            taken.insert(own.clone());
            equations.push(own);
        }
        Anchors {
            equations,
            labels,
            keys,
        }
    }

    /// The name of an equation's place.
    pub(super) fn equation(&self, at: usize) -> &str {
        self.equations.get(at).map_or("", String::as_str)
    }

    /// The equation that prose cites by its number.
    pub(super) fn cited(&self, label: &str) -> Option<usize> {
        self.labels.get(label).copied()
    }

    /// The equation that LaTeX cites by its key.
    pub(super) fn by_key(&self, key: &str) -> Option<usize> {
        self.keys.get(key).copied()
    }
}

/// The name of a document's place.
pub(super) fn document(page: usize) -> String {
    format!("doc-{}", page + 1)
}

/// The name of the evidence for a statement of an equation, within the fold: a browser unfolds what a link leads into.
pub(super) fn evidence(equation: &str, entry: &Entry) -> String {
    // No label has a colon in a name, so this is nobody else's.
    format!("{equation}:{}", entry.part + 1)
}
