use std::borrow::{Borrow, Cow};
use std::cmp::Ordering;
use std::fmt;
use std::hash::{Hash, Hasher};
use std::sync::Arc;

/// So many bytes of a name are looked at first.
const START: usize = 8;

/// A symbol by its whole name in canonical LaTeX: `v'_1`, `E^*`, `\rho_{\text{air}}`, `\dot{\delta}`.
///
/// Two symbols are the same when their canonical names are; they are ordered by name, so no output
/// depends on the order in which a document happened to mention them.
#[derive(Clone, Eq)]
pub struct Symbol {
    /// The first bytes of the name as a number: most names differ in these, and their order is that of the names.
    start: u64,
    name: Arc<str>,
}

/// Most symbols that are compared differ at the start or are copies of one another: then no letter has to be looked at.
impl Ord for Symbol {
    #[inline]
    fn cmp(&self, other: &Symbol) -> Ordering {
        match self.start.cmp(&other.start) {
            Ordering::Equal if Arc::ptr_eq(&self.name, &other.name) => Ordering::Equal,
            // Of names that are no longer than their starts only the lengths can differ.
            Ordering::Equal if self.name.len().max(other.name.len()) <= START => {
                self.name.len().cmp(&other.name.len())
            }
            Ordering::Equal => self.name.cmp(&other.name),
            order => order,
        }
    }
}

impl PartialEq for Symbol {
    #[inline]
    fn eq(&self, other: &Symbol) -> bool {
        self.cmp(other).is_eq()
    }
}

/// As its name is hashed, which a symbol can be asked for by.
impl Hash for Symbol {
    fn hash<H: Hasher>(&self, state: &mut H) {
        self.name.hash(state);
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
        let name = name.into();
        let mut start = [0; START];
        for (slot, byte) in start.iter_mut().zip(name.bytes()) {
            *slot = byte;
        }
        let start = u64::from_be_bytes(start);
        Symbol { start, name }
    }

    /// The canonical LaTeX name.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// `M`, of `M_{\max}`.
    pub fn without_subscript(&self) -> Option<Symbol> {
        split_subscript(self.name()).map(|(stem, _)| Symbol::new(stem))
    }

    /// Whether it is the name of another symbol with something added, and so names a special value of that: `\omega_0`, `f'` or `E^*`.
    pub fn is_variant_of(&self, whole: &Symbol) -> bool {
        let added = self.name.strip_prefix(whole.name());
        added.is_some_and(|added| added.starts_with(['_', '\'', '^']))
    }

    /// Whether it is the name of another symbol with more primes or fewer, whatever their indices: `w'_L` and `w`.
    pub fn differs_by_primes(&self, other: &Symbol) -> bool {
        fn parts(name: &str) -> (&str, &str) {
            let stem = split_subscript(name).map_or(name, |(stem, _)| stem);
            stem.split_at(stem.trim_end_matches('\'').len())
        }
        let ((letter, primes), (other, others)) = (parts(self.name()), parts(other.name()));
        letter == other && primes != others
    }

    /// Whether its name is written with brackets, and says what it is a value of: `\langle x^2 \rangle`, `\text{E}[X]`.
    pub fn is_bracketed(&self) -> bool {
        opens_bracket(self.name())
    }

    /// Whether it is the real or the imaginary part of something: `\text{Re}(Z)`.
    pub fn is_part(&self) -> bool {
        let parts = ["\\text{Re}(", "\\text{Im}("];
        parts.iter().any(|own| self.name.starts_with(own))
    }

    /// Whether it stands for a unit of measurement: `\unit{m}`.
    pub fn is_unit(&self) -> bool {
        self.name.starts_with("\\unit{")
    }
}

/// Symbols are compared by name, so a set of them can be asked for a name.
impl Borrow<str> for Symbol {
    fn borrow(&self) -> &str {
        &self.name
    }
}

impl fmt::Display for Symbol {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.name)
    }
}

impl fmt::Debug for Symbol {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.name)
    }
}

/// What stands in a name between a letter and the line on which another meaning of it is declared; no author can type it.
const MEANING: char = '\u{1f}';

/// A symbol that is printed like another, and is another: what is declared on a line under the letter of something else. `None` for the elements
/// of a sequence.
pub fn another_meaning(letter: &Symbol, line: usize) -> Option<Symbol> {
    Some(Symbol::new(match split_subscript(letter.name()) {
        Some((_, index)) if index.len() == 1 && index.bytes().all(|b| b.is_ascii_lowercase()) => {
            return None;
        }
        Some((stem, _)) => {
            let under = letter.name().get(stem.len()..)?;
            format!("{stem}{MEANING}{line}{under}")
        }
        None => format!("{letter}{MEANING}{line}"),
    }))
}

/// A name as it is printed, and the line on which its meaning is declared, where it is not the only one of its letter.
pub fn as_printed(name: &str) -> (Cow<'_, str>, Option<usize>) {
    let Some((before, rest)) = name.split_once(MEANING) else {
        return (Cow::Borrowed(name), None);
    };
    let after = rest.trim_start_matches(|c: char| c.is_ascii_digit());
    let line = rest[..rest.len() - after.len()].parse().ok();
    (Cow::Owned(format!("{before}{after}")), line)
}

/// Whether brackets stand in a name, outside of braces.
fn opens_bracket(name: &str) -> bool {
    let mut depth = 0usize;
    name.char_indices().any(|(at, c)| {
        match c {
            '{' => depth += 1,
            '}' => depth = depth.saturating_sub(1),
            _ => {}
        }
        depth == 0 && (matches!(c, '[' | '(') || c == '\\' && name[at..].starts_with("\\langle"))
    })
}

/// Takes the subscript off a canonical name: `v'_1` is `v'` and `1`. What stands in brackets has none of its own.
pub fn split_subscript(name: &str) -> Option<(&str, &str)> {
    let mut depth = 0usize;
    for (at, c) in name.char_indices() {
        match c {
            '{' | '[' | '(' => depth += 1,
            '}' | ']' | ')' => depth = depth.saturating_sub(1),
            '\\' if name[at..].starts_with("\\langle") => depth += 1,
            '\\' if name[at..].starts_with("\\rangle") => depth = depth.saturating_sub(1),
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
