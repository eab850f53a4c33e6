//! The source, taken from the front.

use super::Setter;

impl<'s> Setter<'s> {
    pub(super) fn take(&mut self, sign: &str) -> bool {
        let after = self.rest.strip_prefix(sign);
        self.rest = after.unwrap_or(self.rest);
        after.is_some()
    }

    /// Takes the longest run of characters of a kind.
    pub(super) fn run(&mut self, of: impl Fn(char) -> bool) -> &'s str {
        let end = self.rest.find(|c| !of(c)).unwrap_or(self.rest.len());
        let (run, rest) = self.rest.split_at(end);
        self.rest = rest;
        run
    }

    /// White space and comments mean nothing.
    pub(super) fn skip_blank(&mut self) {
        loop {
            self.run(char::is_whitespace);
            if !self.take("%") {
                return;
            }
            self.run(|c| c != '\n');
        }
    }

    /// The name of a command, behind its backslash.
    pub(super) fn name(&mut self) -> &'s str {
        let name = self.run(|c| c.is_ascii_alphabetic());
        if !name.is_empty() {
            return name;
        }
        let length = self.rest.chars().next().map_or(0, char::len_utf8);
        let (name, rest) = self.rest.split_at(length);
        self.rest = rest;
        name
    }

    /// The name of the command that comes next.
    pub(super) fn peeked(&self) -> Option<&'s str> {
        let after = self.rest.strip_prefix('\\')?;
        let end = after.find(|c: char| !c.is_ascii_alphabetic());
        Some(&after[..end.unwrap_or(after.len())])
    }

    pub(super) fn one(&mut self, c: char) -> &'s str {
        let (own, rest) = self.rest.split_at(c.len_utf8());
        self.rest = rest;
        own
    }
}
