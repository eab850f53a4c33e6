//! A document read from top to bottom: what headings, text and directives between two displays say of the next one.

mod adjectives;
mod asides;
mod between;
mod by_name;
mod display;
mod prose;
mod suppositions;

use std::ops::Range;
use std::vec;

use crate::algebra::Symbol;
use crate::document::{Citation, Directive, Extent, Item, Span, SuppositionKind};
use crate::sorted::Set;

use self::between::Between;
use super::Equation;
use super::definition::Known;
use super::page::Page;
use super::qualities::Sayings;
use super::rows::{self, Part};

/// What has been read of a page.
pub(super) struct Reader<'p> {
    pub(super) page: &'p mut Page,
    number: usize,
    /// The displays that are still to come, read.
    ahead: vec::IntoIter<Vec<Part>>,
    pub(super) equations: Vec<Equation>,
    /// What was put in elsewhere by the words before the last display: "it" in what goes on from there.
    inserted: Option<Citation>,
    /// Of each equation, what says that it is derived.
    derived: Vec<Option<Span>>,
    pub(super) level: u8,
    section: String,
    /// Where the section begins.
    pub(super) begins: usize,
    /// What is supposed here, as positions in the page's locals.
    pub(super) active: Vec<usize>,
    /// The cases that the text counted last, in order: "Either $x > 0$ or $x < 0$".
    pub(super) alternatives: Vec<Span>,
    /// The slopes that are zero in the displays to which the words before them lead.
    pub(super) stationary: Vec<usize>,
    /// What is told in passing.
    pub(super) told: Vec<usize>,
    /// What is said of symbols by adjectives.
    pub(super) sayings: Sayings,
    /// The cases whose sentence goes on with the next display.
    pub(super) running: Vec<usize>,
    /// The values of examples that were supposed before this are over.
    pub(super) example: usize,
    between: Between,
    /// Whether nothing that introduces the next display makes it a step: at the beginning and after a heading nothing does.
    bare: bool,
    /// Whether the next display, where nothing more than an "and" is said before it, is one of several laws.
    laws: bool,
    /// The display with which the circumstances begin that the text is about.
    circumstances: Option<usize>,
    /// Where the text came to another place: "Outside".
    elsewhere: Option<usize>,
    /// Values for kinds of things, each with the words that name the kind: "$\beta = 2/5$ for a ball".
    kinds: Vec<(Span, Span)>,
    /// The sentences that introduced displays so far.
    introduced: Vec<Span>,
    /// The letters that this section introduces anew.
    pub(super) anew: Set<Symbol>,
    /// The first display of the section.
    first_here: usize,
    /// Of how much the display before is said.
    extent: Extent,
    /// The same where something is cited, too.
    told_extent: Extent,
    /// The equations of the display that the text goes on from.
    last: Range<usize>,
    /// What is spoken of before the last display.
    known: Known,
    /// The same with the last display.
    pub(super) spoken_of: Known,
    /// What displays speak of so far.
    pub(super) displayed: Known,
    /// The words that are numbers of displays.
    names: asides::Names,
}

impl<'p> Reader<'p> {
    /// At the top of a page whose declarations are read.
    pub fn new(page: &'p mut Page, number: usize, items: &[Item]) -> Self {
        let names = asides::Names::of(&page.document.source);
        Reader {
            ahead: rows::read_ahead(&page.document.source, items, &page.context).into_iter(),
            page,
            number,
            equations: Vec::new(),
            inserted: None,
            derived: Vec::new(),
            level: 0,
            section: String::new(),
            begins: 0,
            active: Vec::new(),
            alternatives: Vec::new(),
            stationary: Vec::new(),
            told: Vec::new(),
            sayings: Sayings::default(),
            running: Vec::new(),
            example: 0,
            between: Between::default(),
            bare: true,
            laws: false,
            circumstances: None,
            elsewhere: None,
            kinds: Vec::new(),
            introduced: Vec::new(),
            anew: Set::new(),
            first_here: 0,
            extent: Extent::Throughout,
            told_extent: Extent::Throughout,
            last: 0..0,
            known: Known::default(),
            spoken_of: Known::default(),
            displayed: Known::default(),
            names,
        }
    }

    /// The equations, and of each what says that it is derived.
    pub fn finish(self) -> (Vec<Equation>, Vec<Option<Span>>) {
        (self.equations, self.derived)
    }

    /// Reads on.
    pub fn item(&mut self, item: &Item) {
        match item {
            Item::Heading {
                level,
                title,
                cases,
                span,
            } => {
                let names_document = self.equations.is_empty() && cases.is_empty();
                if self.page.title.is_empty() && names_document {
                    self.page.title = title.clone();
                }
                self.heading(*level, title, *span);
                for case in cases {
                    self.suppose(case.kind, case.body);
                }
                // What comes next need not be all that is said of the case.
                self.running.clear();
            }
            Item::Prose(prose) => match self.names.without_asides(prose) {
                Some(prose) => self.prose(&prose),
                None => self.prose(prose),
            },
            Item::Directives { clauses, .. } => {
                for clause in clauses {
                    self.directive(&clause.value, clause.span);
                }
            }
            Item::Display { span, body, layout } => self.display(*span, *body, layout.as_deref()),
        }
    }

    fn heading(&mut self, level: u8, title: &str, span: Span) {
        (self.level, self.section) = (level, title.to_owned());
        (self.last, self.bare, self.laws) = (0..0, true, false);
        (self.circumstances, self.first_here) = (None, self.equations.len());
        (self.elsewhere, self.anew) = (None, Set::new());
        (self.extent, self.told_extent) = (Extent::Throughout, Extent::Throughout);
        self.leave_section();
        self.leave_stationary();
        self.between.turn();
        self.begins = span.start;
        let locals = &self.page.locals;
        self.active.retain(|&at| locals[at].outlasts(level));
        let stays = |at: &usize| locals[*at].lasts || locals[*at].level < level;
        self.told.retain(stays);
        self.sayings.below(level);
    }

    fn directive(&mut self, directive: &Directive, span: Span) {
        let between = &mut self.between;
        if let Directive::Derived | Directive::From(_) | Directive::Numeric(_) = directive {
            between.derives = Some(span);
        }
        let mut suppose = |body: Span, kind| {
            let active = &mut self.active;
            self.page.suppose(body, kind, self.level, active, true);
        };
        match directive {
            Directive::Given => between.given = true,
            Directive::Derived => between.derived = true,
            Directive::From(premises) => between.from = Some(premises.clone()),
            Directive::Claim(name) => between.name = Some(name.value.clone()),
            Directive::Assuming(body) => suppose(*body, SuppositionKind::Assume),
            Directive::Let(body) => suppose(*body, SuppositionKind::Let),
            Directive::Numeric(near) => between.numeric = Some(near.clone()),
            Directive::Symbols { .. } | Directive::Data { .. } => {}
        }
    }
}
