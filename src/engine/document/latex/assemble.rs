//! Putting a document together: one text from files and macros, with its comments and verbatim parts left out.

use std::collections::BTreeMap;
use std::rc::Rc;
use std::sync::Arc;

use super::super::{File, Origin, Problem, Span};
use super::define::{Environment, Meaning};
use super::expand::Budget;
use super::files::Library;
use super::token::{self, Place, Token};
use crate::sorted::Tree;

/// What tokens that no file spells are spelt from.
const COINED: &str = "\\operatorname{}#1\r\n";

/// A document put together.
#[derive(Debug)]
pub(super) struct Assembled {
    pub text: String,
    pub origin: Origin,
    /// What is wrong wherever it stands; inside a display it is what hinders reading that.
    pub problems: Vec<Problem>,
    /// What hinders reading a display, and is no harm elsewhere.
    pub obstacles: Vec<Problem>,
    /// Where another file's page begins, and which file's.
    pub pages: Vec<(usize, usize)>,
    /// Where something is missing that may have had equations in it: what is counted on from here is not known.
    pub lost: Vec<usize>,
}

/// Where tokens come from.
pub(super) enum Frame {
    /// A file, from `at` on.
    File {
        file: usize,
        at: usize,
        include: bool,
        /// Where its body begins, if it is a document of its own of which only the body is taken in.
        body: Option<usize>,
        /// Whether `@` was a letter where the file was taken in.
        at_letter: bool,
    },
    /// What a macro stands for, or what was put back.
    Tokens { tokens: Vec<Token>, at: usize },
}

pub(super) struct Assembler<'l> {
    pub library: &'l dyn Library,
    pub origin: Origin,
    pub frames: Vec<Frame>,
    pub macros: BTreeMap<String, Meaning>,
    pub environments: Tree<String, Rc<Environment>>,
    /// What definitions replaced, to be restored where their group ends.
    pub undo: Vec<(String, Option<Meaning>)>,
    pub scopes: Vec<usize>,
    /// The author's own switches.
    pub switches: Tree<String, bool>,
    /// Conditions whose branch is being read.
    pub open_conditions: usize,
    /// Whether what is read now is left out, its comments too.
    pub skipping: bool,
    pub preamble: bool,
    /// Whether the document has begun: one that is taken in now is taken in without its preamble.
    pub begun: bool,
    pub at_letter: bool,
    pub budget: Budget,
    /// How many arguments were never closed: each costs a look at all that follows.
    pub runaways: usize,
    pub bytes: usize,
    coined: Arc<str>,
    text: String,
    problems: Vec<Problem>,
    obstacles: Vec<Problem>,
    pages: Vec<(usize, usize)>,
    lost: Vec<usize>,
    /// Whether a letter put next would become part of the command put last.
    after_command: bool,
}

/// Puts a document together.
pub(super) fn assemble(path: String, source: Arc<str>, library: &dyn Library) -> Assembled {
    let mut assembler = Assembler {
        library,
        origin: Origin::default(),
        frames: Vec::new(),
        macros: BTreeMap::new(),
        environments: Tree::new(),
        undo: Vec::new(),
        scopes: Vec::new(),
        switches: Tree::new(),
        open_conditions: 0,
        skipping: false,
        preamble: source.contains("\\begin{document}"),
        begun: false,
        at_letter: false,
        budget: Budget::default(),
        runaways: 0,
        bytes: source.len(),
        coined: COINED.into(),
        text: String::with_capacity(source.len()),
        problems: Vec::new(),
        obstacles: Vec::new(),
        pages: Vec::new(),
        lost: Vec::new(),
        after_command: false,
    };
    assembler.open_file(path, source, false, false);
    while assembler.step() {}
    if assembler.open_conditions > 0 {
        let message = "a condition (`\\if…`) is never ended";
        let start = Assembler::start_of(0);
        assembler.problem(start, message, "end it with `\\fi`");
    }
    Assembled {
        text: assembler.text,
        origin: assembler.origin,
        problems: assembler.problems,
        obstacles: assembler.obstacles,
        pages: assembler.pages,
        lost: assembler.lost,
    }
}

impl Assembler<'_> {
    /// Begins to read a file; an empty one leaves its place too.
    pub(super) fn open_file(
        &mut self,
        path: String,
        source: Arc<str>,
        include: bool,
        package: bool,
    ) {
        let file = self.origin.files.len();
        let start = source.len() - source.trim_start_matches('\u{feff}').len();
        let body = self.begun.then(|| body(&source)).flatten();
        self.origin.files.push(File::new(path, source));
        if body.is_some() {
            self.begin_scope();
        }
        if include {
            self.paragraph(Self::start_of(file));
            self.pages.push((self.text.len(), file));
        }
        self.frames.push(Frame::File {
            file,
            at: start,
            include,
            body,
            at_letter: self.at_letter,
        });
        self.at_letter |= package;
    }

    pub(super) fn close_file(&mut self) {
        let Some(Frame::File {
            file,
            at,
            include,
            body,
            at_letter,
        }) = self.frames.pop()
        else {
            return;
        };
        if body.is_some() {
            self.end_scope();
        }
        self.at_letter = at_letter;
        self.paragraph(Place::new(file, at, at));
        if let (true, Some(outer)) = (include, self.innermost_file()) {
            self.paragraph(Place::new(file, at, at));
            self.pages.push((self.text.len(), outer));
        }
    }

    fn paragraph(&mut self, place: Place) {
        self.put("\n", place, false);
    }

    pub(super) fn innermost_file(&self) -> Option<usize> {
        self.open_files().last().copied()
    }

    /// The files that are being read, the outermost first.
    pub(super) fn open_files(&self) -> Vec<usize> {
        let file = |frame: &Frame| match frame {
            Frame::File { file, .. } => Some(*file),
            Frame::Tokens { .. } => None,
        };
        self.frames.iter().filter_map(file).collect()
    }

    pub(super) fn source(&self, file: usize) -> Arc<str> {
        match self.origin.files.get(file) {
            Some(file) => file.source.clone(),
            None => self.coined.clone(),
        }
    }

    pub(super) fn text(&self, token: Token) -> &str {
        let file = self.origin.files.get(token.text.file);
        let source = file.map_or(&self.coined, |file| &file.source);
        source.get(token.text.span.range()).unwrap_or_default()
    }

    /// A token that no file spells.
    pub(super) fn coin(&self, text: &str, origin: Place) -> Token {
        let at = COINED.find(text).unwrap_or(COINED.len());
        Token {
            text: Place::new(usize::MAX, at, (at + text.len()).min(COINED.len())),
            origin,
            frozen: false,
        }
    }

    /// Text for the result that no file spells.
    pub(super) fn insert(&mut self, text: &str, place: Place) {
        self.put(text, place, false);
    }

    /// Tokens as they are spelt.
    pub(super) fn spelt(&self, tokens: &[Token]) -> String {
        tokens.iter().map(|&token| self.text(token)).collect()
    }

    /// One step; whether there is more to do.
    fn step(&mut self) -> bool {
        match self.frames.last_mut() {
            None => return false,
            Some(Frame::Tokens { tokens, at }) => match tokens.get(*at).copied() {
                Some(token) => {
                    *at += 1;
                    self.dispatch(token, false);
                }
                None => drop(self.frames.pop()),
            },
            Some(Frame::File { file, at, body, .. }) => {
                let (file, from, body) = (*file, *at, *body);
                let source = self.source(file);
                let rest = source.get(from..).unwrap_or_default();
                if let Some(body) = body.filter(|&body| from < body) {
                    let comment = next_comment(&source[from..body]).map(|at| from + at);
                    self.go_to(comment.unwrap_or(body));
                    if comment.is_some() {
                        self.comment();
                    }
                    return true;
                }
                let plain = rest.find(['\\', '%', '{', '}']).unwrap_or(rest.len());
                if plain > 0 {
                    self.go_to(from + plain);
                    self.put(&rest[..plain], Place::new(file, from, from + plain), true);
                } else if rest.is_empty() {
                    self.close_file();
                } else if rest.starts_with('%') {
                    self.comment();
                } else {
                    let length = token::length(rest, self.at_letter);
                    self.go_to(from + length);
                    let token = Token::written(Place::new(file, from, from + length));
                    self.dispatch(token, true);
                }
            }
        }
        true
    }

    /// Goes on in the innermost frame, which is a file, from another place.
    pub(super) fn go_to(&mut self, place: usize) {
        if let Some(Frame::File { at, .. }) = self.frames.last_mut() {
            *at = place;
        }
    }

    /// The next token wherever it comes from, but not beyond the end of a file.
    pub(super) fn next_token(&mut self) -> Option<Token> {
        loop {
            match self.frames.last_mut()? {
                Frame::Tokens { tokens, at } => match tokens.get(*at).copied() {
                    Some(token) => {
                        *at += 1;
                        return Some(token);
                    }
                    None => drop(self.frames.pop()),
                },
                Frame::File { file, at, .. } => {
                    let (file, from) = (*file, *at);
                    let source = self.source(file);
                    let rest = source.get(from..).unwrap_or_default();
                    if rest.is_empty() {
                        return None;
                    }
                    if rest.starts_with('%') {
                        self.comment();
                        continue;
                    }
                    let length = token::length(rest, self.at_letter);
                    self.go_to(from + length);
                    return Some(Token::written(Place::new(file, from, from + length)));
                }
            }
        }
    }

    pub(super) fn put_back(&mut self, token: Token) {
        if let Some(Frame::File { file, at, .. }) = self.frames.last_mut()
            && token == Token::written(token.text)
            && (token.text.file, token.text.span.end) == (*file, *at)
        {
            *at = token.text.span.start;
            return;
        }
        self.frames.push(Frame::Tokens {
            tokens: vec![token],
            at: 0,
        });
    }

    /// Takes white space and comments.
    pub(super) fn skip_blank(&mut self) {
        while let Some(token) = self.next_token() {
            if !self.text(token).starts_with(char::is_whitespace) {
                return self.put_back(token);
            }
        }
    }

    /// Text for the result, and where it comes from.
    pub(super) fn put(&mut self, text: &str, place: Place, copied: bool) {
        if self.after_command && text.starts_with(|c: char| c.is_ascii_alphabetic()) {
            self.origin
                .push(self.text.len(), place.file, place.span, false);
            self.text.push(' ');
        }
        self.origin
            .push(self.text.len(), place.file, place.span, copied);
        self.text.push_str(text);
        self.after_command = false;
    }

    /// A token for the result, as it is.
    pub(super) fn emit(&mut self, token: Token) {
        let source = self.source(token.text.file);
        let text = source.get(token.text.span.range()).unwrap_or_default();
        self.put(text, token.origin, token.origin == token.text);
        self.after_command =
            text.starts_with('\\') && text.ends_with(|c: char| c.is_ascii_alphabetic());
    }

    /// Something wrong at a place: a space is put there, so that it has a place in the text.
    pub(super) fn problem(&mut self, place: Place, message: impl Into<String>, help: &str) {
        let span = self.mark(place);
        self.problems.push(Problem::new(span, message, help));
    }

    /// The same, where text is left out that may have had equations in it.
    pub(super) fn missing(&mut self, place: Place, message: impl Into<String>, help: &str) {
        self.lost.push(self.text.len());
        self.problem(place, message, help);
    }

    /// Something at a place that would be misread in a display.
    pub(super) fn obstacle(&mut self, place: Place, message: impl Into<String>, help: &str) {
        let span = self.mark(place);
        self.obstacles.push(Problem::new(span, message, help));
    }

    fn mark(&mut self, place: Place) -> Span {
        let start = self.text.len();
        self.origin.push(start, place.file, place.span, false);
        self.text.push(' ');
        self.after_command = false;
        Span::new(start, start + 1)
    }
}

/// Where the body of a document begins, if that is what a file holds.
fn body(source: &str) -> Option<usize> {
    const BEGIN: &str = "\\begin{document}";
    let mut begins = source.match_indices(BEGIN);
    let begin = begins.find(|&(at, _)| {
        let line = source[..at].rsplit(['\n', '\r']).next();
        line.is_none_or(|line| next_comment(line).is_none())
    });
    begin.map(|(at, _)| at + BEGIN.len())
}

/// Where a comment begins.
fn next_comment(text: &str) -> Option<usize> {
    let mut signs = text.match_indices('%');
    let comment = signs.find(|&(at, _)| {
        let before = &text[..at];
        (before.len() - before.trim_end_matches('\\').len()).is_multiple_of(2)
    });
    comment.map(|(at, _)| at)
}
