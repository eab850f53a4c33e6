//! Where text comes from: a document may be put together from several files, from the cells of a notebook, and from what
//! its author's macros stand for. Spans are places in the text put together; this leads back to what the author saved.

use std::sync::Arc;

use super::Span;
use super::source::{Lines, Position};

/// A file that a document was read from, or a cell of a notebook.
#[derive(Clone, Debug)]
pub struct File {
    /// As it should be named in findings.
    pub path: String,
    /// Its text, byte for byte as its author saved it.
    pub source: Arc<str>,
    /// Where it is in its notebook, if it is a cell of one.
    pub cell: Option<Cell>,
    lines: Lines,
}

/// Where a cell is in what its author saved.
#[derive(Clone, Debug)]
pub struct Cell {
    /// The path of the notebook.
    pub notebook: String,
    /// Which of its cells, from 1.
    pub number: usize,
    /// For each line of the cell the line of the notebook on which it stands; none where that is not known.
    pub(super) saved: Vec<usize>,
}

impl Cell {
    /// The line of the notebook on which a line of the cell stands; the first one where that is not known.
    pub fn saved_line(&self, line: usize) -> usize {
        let own = self.saved.get(line.saturating_sub(1));
        own.or(self.saved.last()).copied().unwrap_or(1)
    }
}

impl File {
    /// A file of this path and text.
    pub fn new(path: impl Into<String>, source: impl Into<Arc<str>>) -> File {
        let source = source.into();
        File {
            path: path.into(),
            lines: Lines::of(&source),
            source,
            cell: None,
        }
    }

    /// A cell of a notebook.
    pub(super) fn of_notebook(cell: Cell, source: String) -> File {
        File {
            cell: Some(cell.clone()),
            ..File::new(format!("{}:cell {}", cell.notebook, cell.number), source)
        }
    }

    /// The line and column of a byte; past the end, those of the end.
    pub fn position(&self, offset: usize) -> Position {
        self.lines.position(&self.source, offset)
    }
}

/// A stretch of text, from its start to that of the next, and where it comes from.
#[derive(Clone, Copy, Debug)]
struct Piece {
    start: usize,
    file: usize,
    at: Span,
    /// Copied byte for byte; otherwise all of it comes from all of `at`, as what a macro stands for does.
    copied: bool,
}

/// The files of a document, and which part of its text comes from where.
#[derive(Clone, Debug, Default)]
pub struct Origin {
    /// The files, the one that was asked for first.
    pub files: Vec<File>,
    pieces: Vec<Piece>,
}

impl Origin {
    /// A document that is one file, as it stands.
    pub(super) fn whole(path: impl Into<String>, source: Arc<str>) -> Origin {
        Origin {
            files: vec![File::new(path, source)],
            pieces: Vec::new(),
        }
    }

    /// Notes that the text from `start` on is a copy of a part of a file, or what stands for it.
    pub(super) fn push(&mut self, start: usize, file: usize, at: Span, copied: bool) {
        if let Some(last) = self.pieces.last_mut() {
            let follows = copied
                && last.copied
                && last.file == file
                && last.at.end == at.start
                && start - last.start == last.at.end - last.at.start;
            if follows {
                last.at.end = at.end;
                return;
            }
            if !copied && !last.copied && last.file == file && last.at == at {
                return;
            }
        }
        self.pieces.push(Piece {
            start,
            file,
            at,
            copied,
        });
    }

    /// The file that the start of a span comes from, and the smallest part of it that all of the span which comes from
    /// there covers.
    pub fn of(&self, span: Span) -> (usize, Span) {
        if self.pieces.is_empty() {
            return (0, span);
        }
        let first = self
            .pieces
            .partition_point(|piece| piece.start <= span.start);
        let first = first.saturating_sub(1);
        let mut found: Option<(usize, Span)> = None;
        for (at, piece) in self.pieces.iter().enumerate().skip(first) {
            if at > first && piece.start >= span.end {
                break;
            }
            let own = match piece.copied {
                false => piece.at,
                true => {
                    let place = |offset: usize| {
                        let into = offset.saturating_sub(piece.start);
                        (piece.at.start + into).min(piece.at.end)
                    };
                    Span::new(place(span.start), place(span.end))
                }
            };
            found = match found {
                None => Some((piece.file, own)),
                Some((file, so_far)) if file == piece.file => Some((file, so_far.to(own))),
                other => other,
            };
        }
        found.unwrap_or((0, Span::default()))
    }
}
