//! What is said between one display and the next.

use crate::algebra::BigRational;
use crate::document::{Citation, Extent, Premise, Prose, Slope, Span, Subject};
use crate::notation::Spanned;

use super::super::rows::Part;

/// What is said between one display and the next.
#[derive(Default)]
pub(super) struct Between {
    pub(super) given: bool,
    pub(super) derived: bool,
    pub(super) from: Option<Vec<Spanned<Premise>>>,
    pub(super) name: Option<String>,
    pub(super) numeric: Option<Option<BigRational>>,
    /// What says that the display is derived.
    pub(super) derives: Option<Span>,
    pub(super) cited: Vec<Citation>,
    /// How many of these stand above the last heading.
    cited_above: usize,
    pub(super) mentioned: Vec<Span>,
    pub(super) named: Vec<usize>,
    /// Conditions that are met at one place, and where that is.
    pub(super) initial: Vec<(Span, Span)>,
    /// What is supposed and could not be read.
    pub(super) unread: Vec<Span>,
    /// What is put as a condition in words that are not understood.
    pub(super) conditions: Vec<Span>,
    /// Whether words say that the display follows from something.
    pub(super) concludes: Option<bool>,
    /// Whether they cite something just before the display.
    cites: bool,
    /// Whether they say what something is meant by.
    pub(super) defines: bool,
    /// Whether they go on from the display before.
    pub(super) relative: bool,
    /// Whether they give a reason that is no equation.
    pub(super) reasons: bool,
    /// Whether they put a condition that is no equation.
    pub(super) puts_condition: bool,
    /// The names of laws that they give for a reason.
    pub(super) laws_named: Vec<Span>,
    /// The last sentence of them.
    pub(super) said_last: Option<Span>,
    /// The quantity that they name as what the display says.
    pub(super) subject: Option<Subject>,
    /// Whether they go on with what was said before the display before.
    pub(super) goes_on: bool,
    /// Whether they say that all factors change.
    pub(super) all_vary: bool,
    /// Whether they divide something by something.
    pub(super) divides: bool,
    /// The slope that they take of what they cite.
    pub(super) takes: Option<Slope>,
    /// What they put in elsewhere.
    pub(super) inserted: Option<Citation>,
    /// Whether they are a mere "where" or "with".
    pub(super) meant: bool,
    /// Whether they announce several laws.
    pub(super) laws: bool,
    /// Whether they announce several things by their names: where a page begins with these, all are laws.
    pub(super) several: bool,
    /// Whether they say that the display takes the place of what they cite: it is given.
    pub(super) replaces: bool,
    /// Of how much the display is said.
    pub(super) extent: Option<Extent>,
    /// Whether they say that something stands still: what comes next follows from that.
    pub(super) rests: bool,
    /// Where a slope is said to be zero that nobody has written yet.
    pub(super) slope: Option<Span>,
}

impl Between {
    /// Takes up a piece of text, with those of its citations that are of the next display.
    pub(super) fn hear(&mut self, prose: &Prose, cited: &[Citation]) {
        if !cited.is_empty() {
            let above = std::mem::take(&mut self.cited_above);
            self.cited.drain(..above.min(self.cited.len()));
        }
        self.cited.extend_from_slice(cited);
        self.relative |= prose.is_relative && self.concludes.is_none();
        self.concludes = prose.concludes.or(self.concludes);
        self.reasons |= prose.reasons;
        self.laws_named.extend_from_slice(&prose.laws_named);
        self.said_last = prose.said_last.or(self.said_last);
        self.subject = prose.subject;
        self.goes_on |= prose.goes_on;
        self.all_vary |= prose.all_vary;
        self.divides |= prose.divides;
        self.takes = prose.slope;
        self.meant |= prose.says_what_is_meant;
        self.laws |= prose.announces_laws;
        self.several = prose.announces_several;
        self.replaces |= prose.replaces;
        self.given |= prose.replaces;
        self.puts_condition |= prose.puts_condition;
        self.extent = prose.extent.or(self.extent);
        self.cites |= prose.closing > 0;
        self.defines |= prose.defines;
    }

    /// Turns to a new section: what it cites itself takes the place of what is cited above its heading.
    pub(super) fn turn(&mut self) {
        self.cited_above = self.cited.len();
    }

    /// Whether nothing is said of what the display comes from.
    pub(super) fn is_uncited(&self) -> bool {
        let stated = self.given || self.derived || self.from.is_some() || self.numeric.is_some();
        self.cited.is_empty() && !stated && !self.rests
    }

    /// Whether all that is cited is the display itself: "Torricelli's law @eq-law:" announces what is displayed next.
    pub(super) fn announces_all(&self, read: &[Part]) -> bool {
        self.cited.iter().all(|cited| {
            read.iter().any(|part| match cited.key {
                true => part.keys.contains(&cited.tag),
                false => part.tag.as_ref() == Some(&cited.tag),
            })
        })
    }

    /// Whether words cite something, or say that the display follows, and none that it defines anything.
    pub(super) fn draws(&self, read: &[Part]) -> bool {
        // What is announced is not cited.
        let cites = self.cites && !self.announces_all(read);
        (self.concludes == Some(true) || cites || self.rests) && !self.defines
    }
}
