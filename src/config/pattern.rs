//! Patterns of paths: `chapters/*.md`, `**/*.tex`. `*` and `?` stay within a name, `**` is any number of folders.

/// What may be written.
pub(super) const HELP: &str = "a pattern is a path told from the folder of this file, with `/`: `paper.tex`, `chapters/*.md`, \
                               `**/*.tex`";
/// A pattern with more parts is none that anybody writes.
const MOST_PARTS: usize = 64;

/// A pattern of paths.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Pattern {
    text: String,
}

impl Pattern {
    /// Reads a pattern.
    ///
    /// # Errors
    /// It is empty, leads out of the file system's tree, or is endless.
    pub(super) fn new(text: &str) -> Result<Pattern, String> {
        let text = text.trim().trim_start_matches("./");
        if text.is_empty() {
            return Err("this pattern is empty".into());
        }
        if text.contains('\\') {
            return Err("a path is written with `/` on every system".into());
        }
        if text.split('/').count() > MOST_PARTS {
            return Err(format!("a pattern has at most {MOST_PARTS} parts"));
        }
        Ok(Pattern {
            text: text.to_owned(),
        })
    }

    /// As it was written.
    pub fn text(&self) -> &str {
        &self.text
    }

    /// The folder in which all that it matches stands, and what of it is left to match there; nothing is left of what is
    /// simply a path.
    pub fn folder(&self) -> (&str, Option<&str>) {
        let Some(wild) = self.text.find(['*', '?']) else {
            return (&self.text, None);
        };
        match self.text[..wild].rfind('/') {
            Some(slash) => (&self.text[..slash.max(1)], Some(&self.text[slash + 1..])),
            None => ("", Some(&self.text)),
        }
    }
}

/// Whether a path, told from the folder of the pattern, is one of those that a pattern means.
pub fn matches(pattern: &str, path: &str) -> bool {
    let pattern: Vec<&str> = pattern.split('/').collect();
    let path: Vec<&str> = path.split('/').collect();
    aligned(
        &pattern,
        &path,
        |part| *part == "**",
        |part, name| {
            let (part, name): (Vec<char>, Vec<char>) =
                (part.chars().collect(), name.chars().collect());
            aligned(&part, &name, |c| *c == '*', |c, own| *c == '?' || c == own)
        },
    )
}

/// Whether two lists agree one by one, where a wild item of the first stands for any number of items of the second. Goes
/// back to the last wild item alone, so the time is at most the product of the lengths.
fn aligned<T>(
    pattern: &[T],
    items: &[T],
    wild: impl Fn(&T) -> bool,
    same: impl Fn(&T, &T) -> bool,
) -> bool {
    let (mut at, mut item, mut last) = (0, 0, None);
    while item < items.len() {
        match pattern.get(at) {
            Some(own) if wild(own) => {
                last = Some((at, item));
                at += 1;
            }
            Some(own) if same(own, &items[item]) => (at, item) = (at + 1, item + 1),
            _ => match last {
                Some((star, from)) => {
                    last = Some((star, from + 1));
                    (at, item) = (star + 1, from + 1);
                }
                None => return false,
            },
        }
    }
    pattern[at..].iter().all(wild)
}
