use std::ops::Range;

use crate::algebra::{Expr, Formula, Symbol};
use crate::derivation::{Assumed, Goal, Kind, Source};
use crate::document::Span;
use crate::kernel::{HoldsForEvery, Model, Proven, Refuted, Scales, ScalesNot, Standing};
use crate::notation::{Mark, SyntaxError};
use crate::search::{Implied, Mended, Repair, Stop};

use super::again::expanded::is_of_expansion;
use super::{Numeric, OtherReading};

/// The audit of one statement of an equation.
#[derive(Clone, Debug)]
pub struct Entry {
    /// The equation, by its position in the derivation.
    pub equation: usize,
    /// Which of the display's statements, from 0, of how many.
    pub part: usize,
    /// How many statements the display has.
    pub parts: usize,
    /// What kind of statement it is.
    pub kind: Kind,
    /// What was found.
    pub verdict: Verdict,
    /// The evidence, a link at a time.
    pub judged: Vec<Judged>,
    /// The equations that it was judged from.
    pub premises: Vec<usize>,
    /// The failing equations that it comes from.
    pub rests_on: Vec<usize>,
    /// What else there is to say.
    pub notes: Vec<Note>,
    /// For a numeric claim: what the figures say. It is no proof, so the verdict stays `undecided`.
    pub numeric: Option<Box<Numeric>>,
    /// For what is given: a point at which all that is given with it holds.
    pub model: Option<Model>,
    /// For what fails: what its premises give instead.
    pub implied: Option<Box<Implied>>,
    /// For what fails: what is one small edit away, and follows.
    pub mended: Option<Box<Mended>>,
    /// For what fails: what would have to be supposed besides for it to follow.
    pub missing: Vec<Formula>,
}

/// What was found of a statement.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Verdict {
    /// Nothing to derive.
    Given,
    /// Every link is proved.
    Holds,
    /// Some link is refuted.
    Fails,
    /// Sides or summands differ in dimension.
    IllDimensioned,
    /// Neither was found.
    Undecided,
}

impl Verdict {
    /// All verdicts, in the order of summaries.
    pub const ALL: [Verdict; 5] = [
        Verdict::Given,
        Verdict::Holds,
        Verdict::Fails,
        Verdict::IllDimensioned,
        Verdict::Undecided,
    ];

    /// The word for it.
    pub fn word(self) -> &'static str {
        match self {
            Verdict::Given => "given",
            Verdict::Holds => "holds",
            Verdict::Fails => "fails",
            Verdict::IllDimensioned => "ill-dimensioned",
            Verdict::Undecided => "undecided",
        }
    }
}

/// One link with its evidence.
#[derive(Clone, Debug)]
pub struct Judged {
    /// What was to be shown, and where it stands.
    pub goal: Goal,
    /// What it was judged from, in the order of the claim's hypotheses.
    pub assumed: Vec<Assumed>,
    /// What was found.
    pub outcome: Outcome,
}

impl Judged {
    /// What is put into a law that it is said to solve, where the law is what was judged.
    pub fn solution(&self) -> Option<&Assumed> {
        let first = self.assumed.first()?;
        let is_put = first.source == Source::Taken && first.standing == Standing::Identity;
        is_put.then_some(first)
    }

    /// Whether it is an approximation that was judged by the series of its sides: those are compared, and not what is printed.
    pub fn is_expanded(&self) -> bool {
        is_of_expansion(&self.goal.formula)
    }

    /// Whether how its sides change was judged, and not what is printed: both are differentiated by the same.
    pub fn is_of_change(&self) -> bool {
        match self.goal.formula.as_equation() {
            Some((
                Expr::Derivative { variable, .. },
                Expr::Derivative {
                    variable: other, ..
                },
            )) => variable == other,
            _ => false,
        }
    }

    /// Whether it was judged from the law of propagation of uncertainty.
    pub fn is_propagated(&self) -> bool {
        let mut assumed = self.assumed.iter();
        assumed.any(|own| own.source == Source::Propagation)
    }
}

/// The evidence for or against a link.
#[derive(Clone, Debug)]
pub enum Outcome {
    /// It defines a symbol: nothing to show.
    Defined,
    /// It is stated rather than derived, as far as can be told ([`Note::TakenAsGiven`]): nothing to show.
    Stated,
    /// The kernel's proof.
    Proven(Box<Proven>),
    /// The kernel's proof for every element of a sequence.
    ForEvery(Box<HoldsForEvery>),
    /// The kernel's counterexample.
    Refuted(Box<Refuted>),
    /// The kernel's proof of a scaling relation.
    Scales(Box<Scales>),
    /// The kernel's two situations against a scaling relation, and what follows instead.
    ScalesNot(Box<ScalesNot>, Option<Box<Repair>>),
    /// Neither.
    Open(Stop),
}

impl Outcome {
    /// Neither proved nor refuted, for a reason in words.
    pub(super) fn open(reason: impl Into<String>) -> Outcome {
        Outcome::Open(Stop {
            reason: reason.into(),
            ..Stop::default()
        })
    }

    /// Whether the kernel has seen it proved.
    pub fn is_proven(&self) -> bool {
        matches!(
            self,
            Outcome::Proven(_) | Outcome::ForEvery(_) | Outcome::Scales(_)
        )
    }

    /// Whether the kernel has seen it refuted.
    pub fn is_refuted(&self) -> bool {
        matches!(self, Outcome::Refuted(_) | Outcome::ScalesNot(..))
    }
}

/// What there is to say beside a verdict.
#[derive(Clone, Debug)]
pub enum Note {
    /// An equation that it comes from fails.
    RestsOn(Vec<usize>),
    /// An equation that it comes from is not proved, or only under a condition that nothing states.
    RestsOnUnproved(Vec<usize>),
    /// It does not follow from what it cites; it does from what is named.
    Miscited {
        /// What it cites.
        cited: Vec<usize>,
        /// What it follows from.
        instead: Vec<Source>,
    },
    /// The same, and so do the other miscited steps of its page: each follows once one number is added to all that
    /// they cite.
    CitationsShifted {
        /// What is to be added.
        by: i64,
        /// What it cites.
        cited: Vec<usize>,
        /// What it follows from.
        instead: Vec<Source>,
        /// All such steps, told with the first of them; with the others nothing.
        steps: Vec<usize>,
    },
    /// It follows without these, which it cites.
    UnusedPremise(Vec<usize>),
    /// It cites nothing and does not follow from the equation before it; it does from what is named.
    Uncited(Vec<Source>),
    /// It follows only where these hold, and nothing says that they do.
    UnstatedCondition(Vec<Formula>),
    /// What it is to follow from cannot all be true.
    InconsistentPremises(Vec<Source>),
    /// The author ticks what fails, or crosses out what holds.
    WrongMark(Mark),
    /// It cites an equation that is not there.
    UnknownCitation(String, Span),
    /// It cites what is only derived later.
    CitesLater(usize),
    /// It cites what was derived for particular values that are not in effect here.
    OutOfScope(usize),
    /// It has the number of an earlier equation.
    DuplicateTag(usize),
    /// It could not be read.
    Unreadable(SyntaxError),
    /// It is said to follow from equations that could not be read.
    UnreadablePremise(Vec<usize>),
    /// It, or an equation that it cites, can be read in another way, and the verdict is another one then.
    OtherReading(Box<OtherReading>),
    /// It follows from nothing that stands before, and nothing says that it should: it cites nothing, no word draws a
    /// conclusion, and it speaks of these symbols first, or says how great one is that was measured.
    TakenAsGiven(Vec<Symbol>),
    /// It follows if these do not change. Nothing says so, and nothing differentiates them.
    TakenAsConstant(Vec<Symbol>),
    /// A numeric claim that is false whatever the figures are within their bounds.
    NumericNotSupported,
    /// The search broke down on it: a defect of this program.
    GivenUp,
}

impl Note {
    /// The stable code.
    pub fn code(&self) -> &'static str {
        match self {
            Note::RestsOn(_) => "rests-on",
            Note::RestsOnUnproved(_) => "rests-on-unproved",
            Note::Miscited { .. } => "miscited",
            Note::CitationsShifted { .. } => "citations-shifted",
            Note::UnusedPremise(_) => "unused-premise",
            Note::Uncited(_) => "uncited",
            Note::UnstatedCondition(_) => "unstated-condition",
            Note::InconsistentPremises(_) => "inconsistent-premises",
            Note::WrongMark(_) => "wrong-mark",
            Note::UnknownCitation(..) => "unknown-citation",
            Note::CitesLater(_) => "cites-later",
            Note::OutOfScope(_) => "out-of-scope",
            Note::DuplicateTag(_) => "duplicate-tag",
            Note::Unreadable(_) => "unreadable",
            Note::UnreadablePremise(_) => "unreadable-premise",
            Note::TakenAsGiven(_) => "taken-as-given",
            Note::TakenAsConstant(_) => "taken-as-constant",
            Note::NumericNotSupported => "numeric-not-supported",
            Note::OtherReading(_) => "other-reading",
            Note::GivenUp => "given-up",
        }
    }

    /// Whether it is told only where somebody asks for one equation: most authors need not know.
    pub fn is_quiet(&self) -> bool {
        match self {
            Note::UnusedPremise(_) => true,
            // What holds as it is read is most likely meant so.
            Note::OtherReading(other) => other.verdict == Verdict::Holds,
            _ => false,
        }
    }

    /// Whether it is something to mend, rather than to know.
    pub fn is_finding(&self) -> bool {
        match self {
            Note::Uncited(_)
            | Note::OutOfScope(_)
            | Note::RestsOnUnproved(_)
            | Note::OtherReading(_)
            | Note::TakenAsGiven(_)
            | Note::TakenAsConstant(_)
            | Note::UnusedPremise(_) => false,
            Note::CitationsShifted { steps, .. } => !steps.is_empty(),
            _ => true,
        }
    }
}

impl Entry {
    /// Refuted, or ill-dimensioned.
    pub fn is_wrong(&self) -> bool {
        matches!(self.verdict, Verdict::Fails | Verdict::IllDimensioned)
    }

    /// Whether it says what a new symbol is that names a value, and was shown. It is a definition to those who use it, whatever has to be so for
    /// the symbol to name that value.
    pub(super) fn names_a_value(&self) -> bool {
        let takes = |own: &Assumed| own.source == Source::Taken;
        let names = |own: &Judged| own.outcome.is_proven() && own.assumed.iter().any(takes);
        self.judged.first().is_some_and(names)
    }

    /// Notes symbols that a proof takes as constant.
    pub(super) fn takes_as_constant(&mut self, symbols: Vec<Symbol>) {
        let known = self.notes.iter_mut().find_map(|note| match note {
            Note::TakenAsConstant(known) => Some(known),
            _ => None,
        });
        match known {
            Some(known) => {
                let new = symbols.into_iter().filter(|own| !known.contains(own));
                let new: Vec<Symbol> = new.collect();
                known.extend(new);
            }
            None => self.notes.push(Note::TakenAsConstant(symbols)),
        }
    }

    /// The author crosses it out, and it is wrong.
    pub fn fails_as_marked(&self) -> bool {
        self.is_wrong()
            && self.kind == Kind::Marked
            && !self.notes.iter().any(|n| matches!(n, Note::WrongMark(_)))
    }

    /// The author asserts it, and it is wrong.
    pub fn is_mistake(&self) -> bool {
        self.is_wrong() && !self.fails_as_marked()
    }

    /// Whether there is something to mend.
    pub fn is_finding(&self) -> bool {
        self.is_mistake() || self.notes.iter().any(Note::is_finding)
    }

    /// A numeric claim that is true whatever the figures are within their bounds, and of which nothing else is wrong.
    pub fn is_supported(&self) -> bool {
        let supported = self.numeric.as_ref().is_some_and(|n| n.is_supported());
        supported && self.verdict == Verdict::Undecided
    }

    /// The first link that is a scaling relation and refuted, if no other link is.
    pub fn rescaled(&self) -> Option<(&Judged, &ScalesNot, Option<&Repair>)> {
        self.judged.iter().find_map(|judged| match &judged.outcome {
            Outcome::ScalesNot(refuted, repair) => Some((judged, &**refuted, repair.as_deref())),
            _ => None,
        })
    }

    /// The first link that is refuted at a point.
    pub fn refuted(&self) -> Option<(&Judged, &Refuted)> {
        self.judged.iter().find_map(|judged| match &judged.outcome {
            Outcome::Refuted(refuted) => Some((judged, &**refuted)),
            _ => None,
        })
    }
}

/// Of one part of an equation, nothing yet but its kind and a verdict.
pub(super) fn blank(
    equation: usize,
    part: usize,
    parts: usize,
    kind: Kind,
    verdict: Verdict,
) -> Entry {
    Entry {
        equation,
        part,
        parts,
        kind,
        verdict,
        judged: Vec::new(),
        premises: Vec::new(),
        rests_on: Vec::new(),
        notes: Vec::new(),
        numeric: None,
        model: None,
        implied: None,
        mended: None,
        missing: Vec::new(),
    }
}

/// What the links together say of the statement.
pub(super) fn verdict(judged: &[Judged]) -> Verdict {
    let any = |test: fn(&Outcome) -> bool| judged.iter().any(|j| test(&j.outcome));
    if any(Outcome::is_refuted) {
        Verdict::Fails
    } else if judged.is_empty() || any(|o| matches!(o, Outcome::Open(_))) {
        Verdict::Undecided
    } else if matches!(judged, [only] if matches!(only.outcome, Outcome::Defined)) {
        Verdict::Given
    } else {
        Verdict::Holds
    }
}

/// The entries of equations that stand one after another.
pub(super) fn of_equations(entries: &[Entry], equations: Range<usize>) -> &[Entry] {
    let before = |at: usize| entries.partition_point(|own| own.equation < at);
    &entries[before(equations.start)..before(equations.end)]
}

/// Leaves open what was refuted without something that it may follow from.
pub(super) fn leave_open(entry: &mut Entry, reason: &str) {
    for judged in &mut entry.judged {
        if matches!(judged.outcome, Outcome::Refuted(_)) {
            judged.outcome = Outcome::open(reason);
        }
    }
    (entry.implied, entry.mended) = (None, None);
    entry.missing.clear();
    entry.verdict = Verdict::Undecided;
}
