//! Items moved to where their text stands in a longer one: the cell of a notebook among all cells.
//!
//! All that has a place is taken apart by name, so that what is added to an item cannot be forgotten here.

use super::{
    Citation, Directive, Inserted, Item, Layout, Named, Prose, Slope, Span, Supposition,
    SuppositionKind,
};

impl Span {
    /// As many bytes further on.
    pub(super) fn shifted(self, by: usize) -> Span {
        Span::new(self.start + by, self.end + by)
    }
}

impl Item {
    /// With all its places so many bytes further on.
    pub(super) fn moved(mut self, by: usize) -> Item {
        match &mut self {
            Item::Heading {
                level: _,
                title: _,
                cases,
                span,
            } => {
                shift(span, by);
                cases.iter_mut().for_each(|own| move_supposition(own, by));
            }
            Item::Prose(prose) => move_prose(prose, by),
            Item::Display { span, body, layout } => {
                shift(span, by);
                shift(body, by);
                if let Some(layout) = layout {
                    move_layout(layout, by);
                }
            }
            Item::Directives { clauses, span } => {
                shift(span, by);
                for clause in clauses {
                    shift(&mut clause.span, by);
                    move_directive(&mut clause.value, by);
                }
            }
        }
        self
    }
}

fn shift(span: &mut Span, by: usize) {
    *span = span.shifted(by);
}

fn shift_all<'a>(spans: impl IntoIterator<Item = &'a mut Span>, by: usize) {
    spans.into_iter().for_each(|span| shift(span, by));
}

fn move_prose(prose: &mut Prose, by: usize) {
    let Prose {
        span,
        math,
        citations,
        suppositions,
        qualities,
        quantities,
        subject: _,
        changing,
        mentions,
        leading,
        named,
        concludes: _,
        closing: _,
        tail: _,
        says_from: _,
        reasons: _,
        laws_named,
        said_last,
        of_places,
        slope,
        inserted,
        all_vary: _,
        divides: _,
        defines: _,
        is_relative: _,
        says_what_is_meant: _,
        puts_condition: _,
        announces_laws: _,
        announces_several: _,
        replaces: _,
        goes_on: _,
        joins: _,
        extent: _,
    } = prose;
    shift(span, by);
    // Where nothing leads on, that has no place.
    if leading.end > 0 {
        shift(leading, by);
    }
    shift_all(said_last, by);
    shift_all(changing, by);
    shift_all(mentions, by);
    shift_all(laws_named, by);
    shift_all(of_places, by);
    for inline in math {
        shift_all([&mut inline.span, &mut inline.body], by);
    }
    citations.iter_mut().for_each(|own| move_citation(own, by));
    suppositions
        .iter_mut()
        .for_each(|own| move_supposition(own, by));
    for quality in qualities {
        shift(&mut quality.body, by);
    }
    for quantity in quantities {
        shift_all([&mut quantity.body, &mut quantity.first], by);
    }
    for Named { body, is_drawn: _ } in named {
        shift(body, by);
    }
    if let Some(Slope {
        cited,
        by: variable,
        by_time: _,
        twice: _,
    }) = slope
    {
        shift(cited, by);
        shift_all(variable, by);
    }
    let Inserted { cited, again: _ } = inserted;
    if let Some(cited) = cited {
        move_citation(cited, by);
    }
}

fn move_citation(citation: &mut Citation, by: usize) {
    shift(&mut citation.span, by);
}

fn move_supposition(supposition: &mut Supposition, by: usize) {
    use SuppositionKind::{
        Abbreviation, Alternative, Anew, Arbitrary, Assume, AtRest, Case, Common, Compared,
        Contradicted, Contrary, Define, Elsewhere, Equals, Fact, Figure, General, InAllCases,
        Initial, Known, Let, Meaning, Moment, OfKind, Otherwise, SolvedFor, StandsStill,
        StationaryBy, TakenUp, Unread, Vanishes,
    };
    let Supposition { kind, body } = supposition;
    shift(body, by);
    match kind {
        Initial(place) | OfKind(place) | Abbreviation(place) | Equals(_, _, place) => {
            shift(place, by);
        }
        StationaryBy { of, partial: _ } => shift_all(of, by),
        Compared { relation: _, to } => shift_all(to, by),
        Let
        | Case { .. }
        | Fact { .. }
        | Figure
        | Meaning
        | Moment
        | Known
        | Vanishes(_)
        | StandsStill(_)
        | AtRest
        | Unread
        | Alternative
        | TakenUp(_)
        | Contrary
        | Contradicted
        | SolvedFor
        | Arbitrary
        | Anew
        | Common
        | General
        | Otherwise
        | Elsewhere
        | InAllCases
        | Assume
        | Define => {}
    }
}

fn move_layout(layout: &mut Layout, by: usize) {
    let Layout {
        rows,
        columns: _,
        group: _,
        obstacle,
    } = layout;
    shift_all(rows.iter_mut().flat_map(|row| &mut row.pieces), by);
    if let Some(problem) = obstacle {
        shift(&mut problem.span, by);
    }
}

fn move_directive(directive: &mut Directive, by: usize) {
    match directive {
        Directive::Given | Directive::Derived | Directive::Numeric(_) => {}
        Directive::From(premises) => {
            premises.iter_mut().for_each(|own| shift(&mut own.span, by));
        }
        Directive::Claim(name) => shift(&mut name.span, by),
        Directive::Assuming(body) | Directive::Let(body) => shift(body, by),
        Directive::Symbols { names, attributes } => {
            shift_all(names, by);
            attributes
                .iter_mut()
                .for_each(|own| shift(&mut own.span, by));
        }
        Directive::Data {
            names,
            low: _,
            high: _,
            source: _,
        } => shift_all(names, by),
    }
}
