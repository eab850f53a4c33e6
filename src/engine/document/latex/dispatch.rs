//! What becomes of each token.

use super::assemble::{Assembler, Frame};
use super::files::How;
use super::names::VERBATIM;
use super::token::Token;

impl Assembler<'_> {
    pub(super) fn dispatch(&mut self, token: Token, from_file: bool) {
        let source = self.source(token.text.file);
        let text = source.get(token.text.span.range()).unwrap_or_default();
        match text {
            "{" => self.begin_scope(),
            "}" => self.end_scope(),
            _ => {}
        }
        let Some(name) = text.strip_prefix('\\') else {
            return self.emit(token);
        };
        if token.frozen {
            return self.emit(token);
        }
        match name {
            "begin" => self.begin(token),
            "end" => self.end(token),
            "begingroup" | "bgroup" => self.begin_scope(),
            "endgroup" | "egroup" => self.end_scope(),
            "verb" | "lstinline" | "mintinline" | "url" | "path" | "href" => self.raw(token, name),
            "input" | "subfile" | "subfileinclude" | "include" => {
                let how = match name {
                    "include" | "subfileinclude" => How::Include,
                    _ => How::Input,
                };
                if let Some(file) = self.file_name() {
                    self.take_in(token, &file, how);
                }
            }
            "InputIfFileExists" | "IfFileExists" => self.if_exists(token, name),
            "import" | "subimport" => {
                let folder = self.file_name().unwrap_or_default();
                let file = self.file_name().unwrap_or_default();
                let path = format!("{}/{file}", folder.trim_end_matches('/'));
                self.take_in(token, &path, How::Input);
            }
            "usepackage" | "RequirePackage" => {
                self.optional();
                for name in self.file_name().unwrap_or_default().split(',') {
                    self.take_in(token, name, How::Package);
                }
            }
            "endinput" => {
                while matches!(self.frames.last(), Some(Frame::Tokens { .. })) {
                    self.frames.pop();
                }
                self.close_file();
            }
            "makeatletter" => self.at_letter = true,
            "makeatother" => self.at_letter = false,
            "catcode" | "ExplSyntaxOn" | "csname" | "expandafter" if !self.preamble => {
                let message = format!("`\\{name}` changes how TeX reads, which is not followed");
                self.problem(token.origin, message, "write what it stands for");
            }
            "newif" => self.new_switch(),
            "else" if self.open_conditions > 0 => self.leave_branch(token),
            "fi" if self.open_conditions > 0 => self.open_conditions -= 1,
            _ if self.is_condition(name) => self.condition(token, name),
            _ if self.switch(name) => {}
            _ if self.defines(token, name) => {}
            _ => self.use_command(token, name, from_file),
        }
    }

    /// `\begin{…}`
    pub(super) fn begin(&mut self, token: Token) {
        let Some((tokens, name)) = self.braced_name() else {
            return self.emit(token);
        };
        if VERBATIM.contains(&name.as_str()) {
            return self.verbatim(token, &name);
        }
        self.begin_scope();
        if name == "document" {
            (self.preamble, self.begun) = (false, true);
        }
        if let Some(environment) = self.environments.get(&name).cloned() {
            return self.call(token, &environment.begin, &name);
        }
        self.emit(token);
        tokens.into_iter().for_each(|token| self.emit(token));
    }

    /// `\end{…}`
    pub(super) fn end(&mut self, token: Token) {
        let Some((tokens, name)) = self.braced_name() else {
            return self.emit(token);
        };
        if name == "document" && self.end_body() {
            return;
        }
        self.end_scope();
        if let Some(environment) = self.environments.get(&name).cloned() {
            return self.call(token, &environment.end, &name);
        }
        self.emit(token);
        tokens.into_iter().for_each(|token| self.emit(token));
        if name == "document" {
            self.frames.clear();
        }
    }

    /// Ends what is taken in of a document of its own, if that is what is being read.
    fn end_body(&mut self) -> bool {
        let is_body = |frame: &Frame| matches!(frame, Frame::File { body: Some(_), .. });
        let Some(own) = self.frames.iter().rposition(is_body) else {
            return false;
        };
        while self.frames.len() > own {
            match self.frames.last() {
                Some(Frame::Tokens { .. }) => drop(self.frames.pop()),
                _ => self.close_file(),
            }
        }
        true
    }

    /// The name in braces that follows, with its braces.
    pub(super) fn braced_name(&mut self) -> Option<(Vec<Token>, String)> {
        let open = self.next_token()?;
        if self.text(open) != "{" {
            self.put_back(open);
            return None;
        }
        let mut tokens = vec![open];
        // No environment has a longer name.
        while tokens.len() < 64 {
            let Some(token) = self.next_token() else {
                break;
            };
            tokens.push(token);
            match self.text(token) {
                "}" => {
                    let name = self.spelt(&tokens[1..tokens.len() - 1]);
                    return Some((tokens, name.trim().to_owned()));
                }
                "{" | "\n" => break,
                _ => {}
            }
        }
        self.frames.push(Frame::Tokens { tokens, at: 0 });
        None
    }
}
