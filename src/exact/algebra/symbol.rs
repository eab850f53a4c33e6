use std::borrow::Borrow;
use std::cmp::Ordering;
use std::fmt;
use std::sync::Arc;

/// A symbol by its whole name in canonical LaTeX: `v'_1`, `E^*`, `\rho_{\text{air}}`, `\dot{\delta}`.
///
/// Two symbols are the same when their canonical names are; they are ordered by name, so no output
/// depends on the order in which a document happened to mention them.
#[derive(Clone, PartialEq, Eq, Hash)]
pub struct Symbol(Arc<str>);

/// Most symbols that are compared are copies of one another: then no letter has to be looked at.
impl Ord for Symbol {
    fn cmp(&self, other: &Symbol) -> Ordering {
        match Arc::ptr_eq(&self.0, &other.0) {
            true => Ordering::Equal,
            false => self.0.cmp(&other.0),
        }
    }
}

impl PartialOrd for Symbol {
    fn partial_cmp(&self, other: &Symbol) -> Option<Ordering> {
        Some(self.cmp(other))
    }
}

impl Symbol {
    /// The symbol of this canonical name. The notation reader makes names canonical; nothing here does.
    pub fn new(name: impl Into<Arc<str>>) -> Self {
        Symbol(name.into())
    }

    /// The canonical LaTeX name.
    pub fn name(&self) -> &str {
        &self.0
    }

    /// `M`, of `M_{\max}`.
    pub fn without_subscript(&self) -> Option<Symbol> {
        split_subscript(self.name()).map(|(stem, _)| Symbol::new(stem))
    }

    /// Whether it stands for a unit of measurement: `\unit{m}`.
    pub fn is_unit(&self) -> bool {
        self.0.starts_with("\\unit{")
    }
}

/// Symbols are compared by name, so a set of them can be asked for a name.
impl Borrow<str> for Symbol {
    fn borrow(&self) -> &str {
        &self.0
    }
}

impl fmt::Display for Symbol {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

impl fmt::Debug for Symbol {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}

/// Takes the subscript off a canonical name: `v'_1` is `v'` and `1`.
pub fn split_subscript(name: &str) -> Option<(&str, &str)> {
    let mut depth = 0usize;
    for (at, c) in name.char_indices() {
        match c {
            '{' => depth += 1,
            '}' => depth = depth.saturating_sub(1),
            '_' if depth == 0 => {
                let (stem, text) = (name.get(..at)?, name.get(at + 1..)?);
                let inner = text
                    .strip_prefix('{')
                    .and_then(|text| text.strip_suffix('}'));
                return Some((stem, inner.unwrap_or(text)));
            }
            _ => {}
        }
    }
    None
}
