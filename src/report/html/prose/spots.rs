//! What in a document is not plain text, in order of place.

use std::ops::Range;

use crate::document::{Item, Span};
use crate::sorted;

use super::super::{Page, words};

/// A place that is not plain text.
pub(super) struct Spot {
    pub span: Span,
    pub kind: Kind,
}

/// What is there.
pub(super) enum Kind {
    /// An equation, by position.
    Display(usize),
    /// Mathematics in a line, without its fences.
    Math(Span),
    /// The number of an equation, which is cited.
    Cited(usize),
}

/// The spots of a document, gone through once from the first to the last.
pub(super) struct Spots<'a> {
    pub all: Vec<Spot>,
    source: &'a str,
    next: usize,
    /// Up to here everything has been written.
    done: usize,
}

/// A piece of text between two spots, or a spot.
pub(super) enum Piece<'s> {
    Text(&'s str),
    Spot(&'s Spot),
}

impl<'a> Spots<'a> {
    pub(super) fn of(page: &Page<'a>, at: usize) -> Spots<'a> {
        let derivation = page.report.derivation;
        let document = &derivation.pages[at].document;
        let equations = derivation.equations.iter().enumerate();
        let displays = equations
            .filter(|(_, e)| e.page == at)
            .map(|(own, e)| Spot {
                span: e.span,
                kind: Kind::Display(own),
            });
        let mut all: Vec<Spot> = displays.collect();
        for item in &document.items {
            match item {
                Item::Prose(prose) => {
                    all.extend(prose.math.iter().map(|math| Spot {
                        span: math.span,
                        kind: Kind::Math(math.body),
                    }));
                    all.extend(prose.citations.iter().filter_map(|citation| {
                        let at = page.anchors.cited(&citation.tag)?;
                        Some(Spot {
                            span: citation.span,
                            kind: Kind::Cited(at),
                        })
                    }));
                }
                Item::Heading { span, .. } => {
                    let moved = |s: Span| Span::new(s.start + span.start, s.end + span.start);
                    let found = words::dollars(document.text(*span)).into_iter();
                    all.extend(found.map(|(span, body)| Spot {
                        span: moved(span),
                        kind: Kind::Math(moved(body)),
                    }));
                }
                Item::Display { .. } | Item::Directives { .. } => {}
            }
        }
        // A display goes before whatever is in it, and what overlaps it is left out.
        let rank = |kind: &Kind| match kind {
            Kind::Display(_) => 0,
            Kind::Math(_) => 1,
            Kind::Cited(_) => 2,
        };
        sorted::sort_by_key(&mut all, |spot| (spot.span.start, rank(&spot.kind)));
        let displays: Vec<Span> = all
            .iter()
            .filter(|s| matches!(s.kind, Kind::Display(_)))
            .map(|s| s.span)
            .collect();
        let mut end = 0;
        all.retain(|spot| {
            let is_display = matches!(spot.kind, Kind::Display(_));
            let after = displays.partition_point(|d| d.end <= spot.span.start);
            let clear = displays.get(after).is_none_or(|d| d.start >= spot.span.end);
            let kept = is_display || clear && spot.span.start >= end;
            if kept {
                end = end.max(spot.span.end);
            }
            kept
        });
        Spots {
            all,
            source: &document.source,
            next: 0,
            done: 0,
        }
    }

    /// Displays before a place that no text has led to.
    pub(super) fn missed(&mut self, before: usize) -> Vec<usize> {
        let mut missed = Vec::new();
        while let Some(spot) = self.all.get(self.next)
            && spot.span.start < before
        {
            if let Kind::Display(at) = spot.kind {
                missed.push(at);
            }
            self.next += 1;
            self.done = self.done.max(spot.span.end);
        }
        missed
    }

    /// Whether any spot lies in a range of the source.
    pub(super) fn touches(&self, range: &Range<usize>) -> bool {
        let next = self.all.get(self.next);
        self.done > range.start || next.is_some_and(|spot| spot.span.start < range.end)
    }

    /// What stands in a range of the source, piece by piece.
    pub(super) fn pass(&mut self, range: &Range<usize>, mut each: impl FnMut(Piece<'_>)) {
        let mut at = range.start.max(self.done);
        while let Some(spot) = self.all.get(self.next)
            && spot.span.start < range.end
        {
            if spot.span.start >= at {
                let before = self.source.get(at..spot.span.start).unwrap_or_default();
                each(Piece::Text(before));
            }
            each(Piece::Spot(spot));
            at = at.max(spot.span.end);
            self.done = self.done.max(spot.span.end);
            self.next += 1;
        }
        if at < range.end {
            each(Piece::Text(
                self.source.get(at..range.end).unwrap_or_default(),
            ));
        }
    }
}
