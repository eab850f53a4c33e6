//! Conditions: those that are plain are followed; of the others no branch is read.

use super::assemble::Assembler;
use super::names::CONDITIONS;
use super::token::Token;

impl Assembler<'_> {
    /// `\newif\ifdraft`
    pub(super) fn new_switch(&mut self) {
        self.skip_blank();
        let Some(token) = self.next_token() else {
            return;
        };
        let name = self.text(token).strip_prefix("\\if").map(str::to_owned);
        if let Some(name) = name.filter(|name| !name.is_empty()) {
            self.switches.insert(name, false);
        }
    }

    /// `\drafttrue`, `\draftfalse`
    pub(super) fn switch(&mut self, command: &str) -> bool {
        for (ending, value) in [("true", true), ("false", false)] {
            if let Some(name) = command.strip_suffix(ending)
                && let Some(switch) = self.switches.get_mut(name)
            {
                *switch = value;
                return true;
            }
        }
        false
    }

    /// Whether a command begins a condition that `\fi` ends.
    pub(super) fn is_condition(&self, command: &str) -> bool {
        let own = || {
            command
                .strip_prefix("if")
                .and_then(|name| self.switches.get(name))
        };
        command.starts_with("if") && (CONDITIONS.contains(&command) || own().is_some())
    }

    pub(super) fn condition(&mut self, token: Token, command: &str) {
        let own = command
            .strip_prefix("if")
            .and_then(|name| self.switches.get(name));
        let value = match command {
            "iftrue" => Some(true),
            "iffalse" => Some(false),
            _ => own.copied(),
        };
        match value {
            Some(true) => self.open_conditions += 1,
            Some(false) => {
                if self.skip_branch(token, true) {
                    self.open_conditions += 1;
                }
            }
            None => {
                if !self.preamble {
                    let message = format!("what `\\{command}` decides is not known here");
                    let help = "neither branch is read: write what is to be read without it";
                    self.missing(token.origin, message, help);
                }
                self.skip_branch(token, false);
            }
        }
    }

    /// At the `\else` of a branch that was read.
    pub(super) fn leave_branch(&mut self, token: Token) {
        self.open_conditions -= 1;
        self.skip_branch(token, false);
    }

    /// Leaves out what stands up to the `\fi`, or up to the `\else` where there is a branch to read; whether it was one.
    fn skip_branch(&mut self, begin: Token, stops_at_else: bool) -> bool {
        let outer = std::mem::replace(&mut self.skipping, true);
        let mut depth = 0_usize;
        let (mut reached, mut ended) = (false, false);
        while let Some(token) = self.next_token() {
            let Some(name) = self.text(token).strip_prefix('\\').map(str::to_owned) else {
                continue;
            };
            match name.as_str() {
                "fi" if depth == 0 => {
                    ended = true;
                    break;
                }
                "fi" => depth -= 1,
                "else" if depth == 0 && stops_at_else => {
                    (reached, ended) = (true, true);
                    break;
                }
                "newcommand" | "renewcommand" | "providecommand" | "def" | "gdef" | "let"
                    if !stops_at_else =>
                {
                    self.skip_blank();
                    let mut named = self.next_token();
                    if named.is_some_and(|token| self.text(token) == "{") {
                        named = self.next_token();
                    }
                    let named = named.map(|token| self.text(token).to_owned());
                    if let Some(defined) = named.as_deref().and_then(|n| n.strip_prefix('\\')) {
                        let why = "its definition depends on a condition";
                        self.set_unknown(defined.to_owned(), why);
                    }
                }
                name if self.is_condition(name) => depth += 1,
                _ => {}
            }
        }
        self.skipping = outer;
        if !ended {
            let message =
                "this branch of a condition is never ended: it hides all that follows in its file";
            self.problem(begin.origin, message, "end it with `\\fi`");
        }
        reached
    }
}
