//! Text of LaTeX, taken from the front: names, arguments, options.

/// An argument that is taken as it stands is no longer; it keeps a run of unclosed braces from costing a scan each.
const LONGEST: usize = 1000;

/// What is left to read.
pub(super) struct Reader<'s> {
    pub rest: &'s str,
}

impl<'s> Reader<'s> {
    /// Leaves out so many bytes, or what there is.
    pub(super) fn skip(&mut self, bytes: usize) {
        self.rest = self.rest.get(bytes..).unwrap_or("");
    }

    pub(super) fn take(&mut self, sign: &str) -> bool {
        let after = self.rest.strip_prefix(sign);
        self.rest = after.unwrap_or(self.rest);
        after.is_some()
    }

    /// The longest run of characters of a kind.
    pub(super) fn run(&mut self, of: impl Fn(char) -> bool) -> &'s str {
        let end = self.rest.find(|c| !of(c)).unwrap_or(self.rest.len());
        self.split(end)
    }

    fn split(&mut self, at: usize) -> &'s str {
        let (before, rest) = self.rest.split_at(at);
        self.rest = rest;
        before
    }

    /// White space within a paragraph.
    pub(super) fn blank(&mut self) {
        let end = self.rest.find(|c: char| !c.is_whitespace());
        let blank = &self.rest[..end.unwrap_or(self.rest.len())];
        if blank.matches('\n').count() < 2 {
            self.skip(blank.len());
        }
    }

    /// The name of a command: letters, or one character.
    pub(super) fn name(&mut self) -> &'s str {
        let name = self.run(|c| c.is_ascii_alphabetic());
        if !name.is_empty() {
            self.take("*");
            return name;
        }
        self.one()
    }

    fn one(&mut self) -> &'s str {
        self.split(self.rest.chars().next().map_or(0, char::len_utf8))
    }

    /// An argument as it stands: what is in braces, or one character.
    pub(super) fn argument(&mut self) -> &'s str {
        if !self.rest.starts_with('{') {
            return match self.rest.starts_with(['\\', '}']) {
                true => "",
                false => self.one(),
            };
        }
        let mut depth = 0usize;
        for (at, c) in self.rest.char_indices().take(LONGEST) {
            match c {
                '{' => depth += 1,
                '}' => depth -= 1,
                _ => continue,
            }
            if depth == 0 {
                let inside = &self.rest[1..at];
                self.skip(at + 1);
                return inside;
            }
        }
        ""
    }

    /// What is in brackets, if there are any.
    pub(super) fn options(&mut self) -> Option<&'s str> {
        let inside = self.rest.strip_prefix('[')?;
        let (end, _) = inside
            .char_indices()
            .take(LONGEST)
            .find(|(_, c)| *c == ']')?;
        self.skip(end + 2);
        Some(&inside[..end])
    }
}
