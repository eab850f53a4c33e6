//! What is left out: comments, but for directives, and text that is not TeX.

use super::super::Span;
use super::super::directive::{self, Comment};
use super::assemble::{Assembler, Frame};
use super::token::{self, Place, Token};

impl Assembler<'_> {
    /// A comment in the file that is read: a directive is kept, anything else goes with the end of its line.
    pub(super) fn comment(&mut self) {
        let Some(Frame::File { file, at, .. }) = self.frames.last() else {
            return;
        };
        let (file, from) = (*file, *at);
        let source = self.source(file);
        let end_of_line = |from: usize| {
            source[from..]
                .find(['\n', '\r'])
                .map_or(source.len(), |length| from + length)
        };
        let after_line = |end: usize| match &source[end..] {
            rest if rest.starts_with("\r\n") => end + 2,
            "" => end,
            _ => end + 1,
        };
        let signs = source[from..].len() - source[from..].trim_start_matches('%').len();
        let body = from + signs;
        let end = end_of_line(body);
        self.go_to(after_line(end));
        let ours = !matches!(
            directive::read(&source, Span::new(body, end)),
            Comment::Other
        );
        if !ours || self.skipping {
            return;
        }
        // It is read like text, for the author's commands may stand in it.
        let mut tokens = vec![Token::written(Place::new(file, from, from + 1))];
        self.spell(file, Span::new(body, end), &mut tokens);
        // Whole lines of comment that are set in by two spaces go on with it.
        let mut next = after_line(end);
        loop {
            let line = source[next..].trim_start_matches([' ', '\t']);
            let text = line.trim_start_matches('%');
            let goes_on = text.len() < line.len()
                && (text.starts_with("  ") || text.starts_with('\t'))
                && !text
                    .trim_start_matches([' ', '\t'])
                    .starts_with(['\n', '\r']);
            if !goes_on {
                break;
            }
            let body = source.len() - text.len();
            let end = end_of_line(body);
            tokens.push(self.coin("\r", Place::new(file, next, body)));
            self.spell(file, Span::new(body, end), &mut tokens);
            next = after_line(end);
        }
        self.go_to(next);
        tokens.push(self.coin("\n", Place::new(file, next, next)));
        self.frames.push(Frame::Tokens { tokens, at: 0 });
    }

    /// The tokens of a part of a file.
    pub(super) fn spell(&self, file: usize, span: Span, tokens: &mut Vec<Token>) {
        let source = self.source(file);
        let mut at = span.start;
        while at < span.end {
            let length = token::length(&source[at..span.end], self.at_letter).max(1);
            tokens.push(Token::written(Place::new(file, at, at + length)));
            at += length;
        }
    }

    /// Leaves out an environment whose text is not TeX.
    pub(super) fn verbatim(&mut self, token: Token, name: &str) {
        let Some(Frame::File { file, at, .. }) = self.frames.last() else {
            let message = format!("`{name}` cannot begin in a macro");
            return self.problem(token.origin, message, "write it out");
        };
        let (file, from) = (*file, *at);
        let source = self.source(file);
        let end = format!("\\end{{{name}}}");
        match source[from..].find(&end) {
            Some(length) => {
                let to = from + length + end.len();
                self.go_to(to);
                self.put(" ", Place::new(file, token.text.span.start, to), false);
            }
            None => {
                let message = format!("this `{name}` is never ended: it hides all that follows");
                self.missing(token.origin, message, &format!("end it with `{end}`"));
                self.go_to(source.len());
            }
        }
    }

    /// `\verb|…|` and its like: text that is not TeX.
    pub(super) fn raw(&mut self, token: Token, name: &str) {
        let Some(Frame::File { file, at, .. }) = self.frames.last() else {
            // In the argument of a command TeX does not read it either.
            return self.emit(token);
        };
        let (file, mut from) = (*file, *at);
        let source = self.source(file);
        let mut skip = |open: char, close: char| {
            if source[from..].starts_with(open) {
                let line = source[from..]
                    .find(['\n', '\r'])
                    .unwrap_or(source.len() - from);
                from += source[from..from + line]
                    .find(close)
                    .map_or(0, |length| length + 1);
            }
        };
        match name {
            "lstinline" => skip('[', ']'),
            "mintinline" => {
                skip('[', ']');
                skip('{', '}');
            }
            "verb" if source[from..].starts_with('*') => from += 1,
            _ => {}
        }
        let mut rest = source[from..].chars();
        let closing = match rest.next() {
            Some('{') if name != "verb" => '}',
            Some(mark) if !mark.is_alphanumeric() && !mark.is_whitespace() => mark,
            _ => return self.emit(token),
        };
        let body = source.len() - rest.as_str().len();
        let line = source[body..]
            .find(['\n', '\r'])
            .unwrap_or(source.len() - body);
        match source[body..body + line].find(closing) {
            Some(length) => {
                let to = body + length + closing.len_utf8();
                self.go_to(to);
                self.put(" ", Place::new(file, token.text.span.start, to), false);
            }
            None => self.problem(
                token.origin,
                format!("this `\\{name}` is not ended on its line"),
                "close it",
            ),
        }
    }
}
