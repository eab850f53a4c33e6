//! Putting in what the author's commands stand for, within bounds.

use std::rc::Rc;

use super::assemble::{Assembler, Frame};
use super::define::{Macro, Meaning};
use super::token::Token;

/// The most macros that one use may come to: people's macros come to some ten.
const STEPS: usize = 20_000;
/// The most tokens that one use may come to.
const TOKENS: usize = 400_000;
/// The most tokens that a document may come to.
const ALL_TOKENS: usize = 16_000_000;
/// After so many arguments that are never closed no more are looked for.
const RUNAWAYS: usize = 16;

/// What has been spent.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Budget {
    steps: usize,
    tokens: usize,
    all_tokens: usize,
}

impl Budget {
    fn is_spent(&self) -> bool {
        self.steps > STEPS || self.tokens > TOKENS || self.all_tokens > ALL_TOKENS
    }
}

impl Assembler<'_> {
    /// A command that is no definition: what it stands for, if it is the author's.
    pub(super) fn use_command(&mut self, token: Token, name: &str, from_file: bool) {
        match self.macros.get(name).cloned() {
            None => self.emit(token),
            Some(Meaning::Unknown(why)) => {
                self.emit(token);
                let message = format!("`\\{name}` is not put in: {why}");
                self.obstacle(token.origin, message, "define it by `\\newcommand`");
            }
            Some(Meaning::Macro(meaning)) => {
                if from_file {
                    (self.budget.steps, self.budget.tokens) = (0, 0);
                }
                self.call(token, &meaning, name);
            }
        }
    }

    /// Puts in a macro: its arguments are taken, and what it stands for is read next.
    pub(super) fn call(&mut self, token: Token, meaning: &Rc<Macro>, name: &str) {
        let mut origin = token.origin;
        let mut arguments: Vec<Vec<Token>> = Vec::new();
        if meaning.sized {
            self.size();
        }
        let mut defaulted = false;
        if let Some(default) = &meaning.default {
            let given = self.optional();
            defaulted = given.is_none();
            arguments.push(given.unwrap_or_else(|| default.clone()));
        }
        while arguments.len() < meaning.parameters {
            let Some((argument, last)) = self.argument_to_its_end() else {
                let message = format!("an argument of `\\{name}` is missing, or never closed");
                return self.problem(token.origin, message, "give it in braces");
            };
            if token.origin == token.text {
                origin = origin.to(last.origin);
            }
            arguments.push(argument);
        }
        let mut tokens: Vec<Token> = Vec::with_capacity(meaning.body.len());
        let mut body = meaning.body.iter().copied();
        let mine = |token: Token| Token { origin, ..token };
        // What stands for an argument that is not given was written nowhere else either.
        if let (true, Some(default)) = (defaulted, arguments.first_mut()) {
            default.iter_mut().for_each(|token| *token = mine(*token));
        }
        while let Some(next) = body.next() {
            if self.text(next) != "#" {
                tokens.push(mine(next));
                continue;
            }
            let Some(after) = body.next() else { break };
            match self.text(after) {
                "#" => tokens.push(mine(after)),
                digit => {
                    let number = digit.parse().unwrap_or(0_usize);
                    match number.checked_sub(1).and_then(|at| arguments.get(at)) {
                        Some(argument) => tokens.extend(argument),
                        None => tokens.extend([mine(next), mine(after)]),
                    }
                }
            }
            if tokens.len() > TOKENS {
                break;
            }
        }
        self.budget.steps += 1;
        self.budget.tokens += tokens.len() + 1;
        self.budget.all_tokens += tokens.len() + 1;
        if self.budget.is_spent() {
            // All that is left of this use goes with it.
            while matches!(self.frames.last(), Some(Frame::Tokens { .. })) {
                self.frames.pop();
            }
            let message = format!("`\\{name}` comes to too much: it may call itself");
            return self.missing(token.origin, message, "write out what it should stand for");
        }
        while let Some(Frame::Tokens { tokens, at }) = self.frames.last()
            && *at >= tokens.len()
        {
            self.frames.pop();
        }
        self.frames.push(Frame::Tokens { tokens, at: 0 });
    }

    /// `*` or `[\big]` after the name of a delimiter.
    fn size(&mut self) {
        if self.optional().is_some() {
            return;
        }
        if let Some(next) = self.next_token()
            && self.text(next) != "*"
        {
            self.put_back(next);
        }
    }

    /// An argument: the inside of braces, or a single token.
    pub(super) fn argument(&mut self) -> Option<Vec<Token>> {
        self.argument_to_its_end().map(|(inside, _)| inside)
    }

    /// An argument, and the token that it ends with: the brace, if it is in braces.
    fn argument_to_its_end(&mut self) -> Option<(Vec<Token>, Token)> {
        self.skip_blank();
        let first = self.next_token()?;
        match self.text(first) {
            "{" => self.until(first, "}"),
            "}" => {
                self.put_back(first);
                None
            }
            _ => Some((vec![first], first)),
        }
    }

    /// `[…]`, if that is what follows.
    pub(super) fn optional(&mut self) -> Option<Vec<Token>> {
        self.skip_blank();
        let open = self.next_token()?;
        if self.text(open) != "[" {
            self.put_back(open);
            return None;
        }
        self.until(open, "]").map(|(inside, _)| inside)
    }

    /// The inside of a group whose `{` has been taken, without its `}`.
    pub(super) fn group_after(&mut self, open: Token) -> Option<Vec<Token>> {
        self.until(open, "}").map(|(inside, _)| inside)
    }

    /// What stands before the token that closes what was opened, and that token.
    fn until(&mut self, open: Token, close: &str) -> Option<(Vec<Token>, Token)> {
        if self.runaways >= RUNAWAYS {
            return None;
        }
        // Where the file stands, to go on there if nothing closes what was opened.
        let file = self.frames.iter().rev().find_map(|frame| match frame {
            Frame::File { at, .. } => Some(*at),
            Frame::Tokens { .. } => None,
        });
        let mut depth = 0_usize;
        let mut inside = Vec::new();
        while let Some(token) = self.next_token() {
            match self.text(token) {
                text if text == close && depth == 0 => return Some((inside, token)),
                "{" => depth += 1,
                "}" => {
                    depth = depth
                        .checked_sub(1)
                        .or_else(|| (close == "]").then_some(0))?
                }
                _ => {}
            }
            inside.push(token);
        }
        self.runaways += 1;
        if let Some(back) = file {
            self.go_to(back);
        }
        let message = match close {
            "]" => "this bracket is never closed",
            _ => "this brace is never closed",
        };
        self.problem(open.origin, message, "close it");
        None
    }
}
