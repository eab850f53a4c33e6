//! Statements that a reader may take in another way than they are read: is the verdict another one then?
//!
//! Nothing is done for what can be read in one way only. Where a statement fails or stays open, its other readings are
//! judged as it was, then those of the equations that it cites; where it holds, it is asked whether another reading would
//! be refuted.

use std::sync::Arc;

use crate::algebra::{Formula, Symbol};
use crate::derivation::{Assumed, Kind, Source, formulas, goals};
use crate::document::Span;
use crate::kernel::Standing;
use crate::notation::{Choice, Other, Statement};
use crate::search::{self, Decision};

use super::premise::Usable;
use super::{Auditor, Entry, Note, Verdict};
use crate::sorted::Set;

/// More places of this kind are not tried for one statement.
const MOST_CHOICES: usize = 6;

/// Another reading, and what it comes to.
#[derive(Clone, Debug)]
pub struct OtherReading {
    /// The equation that is written so: the one that is judged, or one that it cites.
    pub equation: usize,
    /// The place in it that can be taken in two ways.
    pub span: Span,
    /// The way that is not taken.
    pub choice: Choice,
    /// That equation's statement as it is read.
    pub read: Statement,
    /// The same in the other reading.
    pub other: Statement,
    /// The verdict as read.
    pub verdict: Verdict,
    /// The verdict on what is judged in the other reading.
    pub otherwise: Verdict,
}

/// Whether what is a function in one reading, and a factor in the other, is a symbol in the premises.
fn is_spoken_of(product: &Statement, read: &Statement, usable: &Usable) -> bool {
    let symbols = |statement| {
        let formulas = formulas(statement);
        let all = formulas.iter().flat_map(Formula::free_symbols);
        all.collect::<Set<Symbol>>()
    };
    let (fewer, assumed) = (symbols(read), &usable.assumed);
    let spoken = |symbol: &Symbol| {
        let mut all = assumed.iter().map(|assumed| &assumed.formula);
        all.any(|formula| formula.free_symbols().contains(symbol))
    };
    symbols(product).difference(&fewer).all(spoken)
}

/// From what a statement is judged.
pub(super) struct Circumstances<'a> {
    pub at: usize,
    pub part: usize,
    pub usable: &'a Usable,
    pub premises: &'a [usize],
    pub says_so: bool,
    pub defines: bool,
}

impl Auditor<'_> {
    /// What to say of other readings of a statement, given its verdict as read.
    pub(super) fn other_reading(
        &self,
        statement: &Statement,
        entry: &Entry,
        how: &Circumstances,
    ) -> Option<Note> {
        let cited = || how.premises.iter().flat_map(|&p| self.choices(p));
        let open = matches!(entry.verdict, Verdict::Fails | Verdict::Undecided);
        if statement.others.is_empty() && !(open && cited().next().is_some()) {
            return None;
        }
        let dimensions = self.shared.dimensions.wait();
        let ill = dimensions.conflicts.contains_key(&(how.at, how.part));
        let verdict = if ill {
            Verdict::IllDimensioned
        } else {
            entry.verdict
        };
        let note = |(equation, span, choice): (usize, Span, Choice),
                    read: &Statement,
                    other: &Statement,
                    otherwise| {
            Note::OtherReading(Box::new(OtherReading {
                equation,
                span,
                choice,
                read: read.clone(),
                other: other.clone(),
                verdict,
                otherwise,
            }))
        };
        let plausible = |other: &&Other| {
            other.choice != Choice::Product || is_spoken_of(&other.statement, statement, how.usable)
        };
        let others = statement.others.iter().filter(plausible);
        for other in others.take(MOST_CHOICES) {
            let otherwise = match verdict {
                Verdict::Holds => self.refuted_otherwise(other.choice, &other.statement, how),
                Verdict::Given => None,
                // A premise that is missing may be all that is wrong.
                Verdict::IllDimensioned if entry.kind == Kind::Given => Some(Verdict::Given),
                _ => self
                    .holds(&other.statement, how.usable, how)
                    .then_some(Verdict::Holds),
            };
            let agrees = |formula: &Formula| {
                dimensions
                    .agreement(self.derivation, how.at, formula)
                    .is_some()
            };
            let Some(otherwise) = otherwise else { continue };
            if ill && !formulas(&other.statement).iter().all(agrees) {
                continue;
            }
            let place = (how.at, other.span, other.choice);
            return Some(note(place, statement, &other.statement, otherwise));
        }
        if !open || ill {
            return None;
        }
        let choices: Set<Choice> = cited().filter(|c| *c != Choice::Product).collect();
        for choice in choices.into_iter().take(MOST_CHOICES) {
            let Some((usable, premise)) = self.reread(how, choice) else {
                continue;
            };
            let own = statement.others.iter().find(|other| other.choice == choice);
            let all = std::iter::once(statement).chain(own.map(|other| &other.statement));
            for statement in all {
                if self.holds(statement, &usable, how) {
                    let (equation, read, other) = premise;
                    let place = (equation, other.span, choice);
                    return Some(note(place, read, &other.statement, Verdict::Holds));
                }
            }
        }
        None
    }

    /// The choices that a reader has in an equation.
    fn choices(&self, at: usize) -> impl Iterator<Item = Choice> {
        let statements = self.derivation.equations[at].statements().iter();
        let others = statements.flat_map(|statement| &statement.others);
        others.map(|other| other.choice)
    }

    /// Whether a statement follows from what is cited.
    fn holds(&self, statement: &Statement, usable: &Usable, how: &Circumstances) -> bool {
        let entry = self.statement(statement, &Circumstances { usable, ..*how });
        // That a mass is divided out is no doubt about what is meant.
        let of_one = |own: &Formula| own.free_symbols().len() < 2;
        let otherwise = |note: &Note| match note {
            Note::UnstatedCondition(conditions) => !conditions.iter().all(of_one),
            note => matches!(note, Note::Miscited { .. } | Note::InconsistentPremises(_)),
        };
        entry.verdict == Verdict::Holds && !entry.notes.iter().any(otherwise)
    }

    /// Whether a link of a statement is refuted. That a function is meant to be a factor is not asked where all is well.
    fn refuted_otherwise(
        &self,
        choice: Choice,
        statement: &Statement,
        how: &Circumstances,
    ) -> Option<Verdict> {
        if choice == Choice::Product || how.defines || !how.usable.cases.is_empty() {
            return None;
        }
        let mut assumed = how.usable.assumed.clone();
        for goal in goals(statement) {
            let step = |formula: &Formula| Assumed {
                formula: Arc::new(formula.clone()),
                standing: Standing::AtPoint,
                source: Source::Step,
            };
            let suppositions = goal.suppositions.iter().map(step);
            let all: Vec<Assumed> = assumed.iter().cloned().chain(suppositions).collect();
            let claim = self.derivation.claim(how.at, &all, &goal.formula);
            if !search::is_scaling(&goal.formula)
                && let Decision::Refuted(_) = search::decide(claim, &self.hints())
            {
                return Some(Verdict::Fails);
            }
            assumed.push(step(&goal.formula));
        }
        None
    }

    /// What is cited, with one choice made otherwise in all of it, and the first place where that changes something.
    #[allow(clippy::type_complexity)]
    fn reread(
        &self,
        how: &Circumstances,
        choice: Choice,
    ) -> Option<(Usable, (usize, &Statement, &Other))> {
        let mut usable = how.usable.clone();
        let mut first = None;
        for &premise in how.premises {
            for statement in self.derivation.equations[premise].statements() {
                let Some(other) = statement.others.iter().find(|o| o.choice == choice) else {
                    continue;
                };
                for (read, otherwise) in formulas(statement).iter().zip(formulas(&other.statement))
                {
                    let own = usable.assumed.iter_mut().find(|assumed| {
                        assumed.source == Source::Equation(premise) && *assumed.formula == *read
                    });
                    if let Some(own) = own
                        && *read != otherwise
                    {
                        own.formula = Arc::new(otherwise);
                        first = first.or(Some((premise, statement, other)));
                    }
                }
            }
        }
        Some((usable, first?))
    }
}
