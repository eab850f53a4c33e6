//! What a statement works out of numbers alone: `x_2/x_1 = e^{-0.631} = 0.532`.
//!
//! Nothing that is cited bears on that, so it is weighed even in what is given. A long number may be rounded, be it on the way or at the
//! end; what is wrong whatever it was rounded from is an arithmetic slip.

use num_traits::Zero;

use crate::algebra::{BigInt, BigRational, Expr, Relation, Symbol};
use crate::derivation::{Goal, goals};
use crate::document::Span;
use crate::interval::{Compared, Figures};
use crate::notation::{Statement, has_units, is_figures, plain, without_units};
use crate::sorted::Map;

use super::super::{Auditor, Entry, Judged, Note, Outcome, Verdict};
use super::decimals::FEWEST_DIGITS;
use super::rounded::near_whole;
use super::{Link, Numeric, Weighed, decimals, is_evaluable, likened, weigh};

/// A whole number with fewer digits is seldom rounded: `12`.
const FEWEST_WHOLE: usize = 3;

impl Auditor<'_> {
    /// Says where numbers do not come to what a statement says that they do, if nothing else is said of it.
    pub(in crate::audit) fn reckon(&self, at: usize, statement: &Statement, entry: &mut Entry) {
        let is_open = matches!(entry.verdict, Verdict::Given | Verdict::Undecided);
        let is_told = |note: &Note| matches!(note, Note::NumericNotSupported);
        let is_weighed = match &entry.numeric {
            Some(own) => *own.outcome() != Weighed::Contradicted || entry.notes.iter().any(is_told),
            None => false,
        };
        if !is_open || is_weighed || self.derivation.equations[at].numeric.is_some() {
            return;
        }
        let page = self.derivation.equations[at].page;
        let source = &self.derivation.pages[page].document.source;
        // A profit has that letter, too.
        let is_a_symbol =
            |own: &Symbol| !own.is_unit() && self.derivation.pages[page].domains.get(own).is_some();
        let links = goals(statement).into_iter();
        let links = links.filter(|own| !own.formula.names().iter().any(is_a_symbol));
        let goals: Vec<Goal> = links.collect();
        let mut links = Vec::new();
        for (at, goal) in goals.iter().enumerate() {
            // What a chain came to, and goes on from, was rounded however few its digits are: `= 2.1 \cdot 10^6\,\mathrm{s} = 25\,\mathrm{d}`.
            let is_result = at > 0 && goals[at - 1].sides.1 == goal.sides.0;
            let fewest = match is_result && goals[at - 1].rounding.is_some() {
                true => 1,
                false => FEWEST_DIGITS,
            };
            links.extend(reckoned(goal.clone(), Some(source), fewest));
        }
        let is_wrong = |link: &Link| link.outcome == Weighed::Contradicted;
        if !links.iter().any(is_wrong) {
            let right = links.iter().filter(|own| own.outcome == Weighed::Supported);
            return say_what_is_right(entry, right.count());
        }
        links.retain(is_wrong);
        entry.verdict = Verdict::Undecided;
        entry.notes.push(Note::NumericNotSupported);
        entry.numeric = Some(Box::new(Numeric::of_links(links)));
    }
}

/// Says of a statement that is left open that what it works out is right, where nothing else in it is open but what it is that is worked out:
/// `P = 400 \cdot 28.3 = 11\,320`.
fn say_what_is_right(entry: &mut Entry, right: usize) {
    let is_settled =
        |own: &Judged| own.outcome.is_proven() || matches!(own.outcome, Outcome::Defined);
    let open = entry.judged.iter().filter(|own| !is_settled(own));
    let Some(first) = entry.judged.first().filter(|own| !is_settled(own)) else {
        return;
    };
    let Some((of, number)) = first.goal.formula.as_equation() else {
        return;
    };
    let is_worked_out = is_figures(number) && !is_figures(of);
    if right == 0 || open.count() != right + 1 || !is_worked_out || entry.numeric.is_some() {
        return;
    }
    if entry.verdict != Verdict::Undecided || !matches!(first.outcome, Outcome::Open(_)) {
        return;
    }
    let of = plain(of);
    entry.judged[0].outcome = Outcome::open(format!(
        "what it works out is right, and that this is `{of}` follows from nothing before"
    ));
}

/// A relation between numbers that is not so as they stand, and may be so as they are rounded, weighed.
pub(super) fn agreed_loosely(goal: &Goal, source: &str) -> Option<Link> {
    let is_wrong = |link: &Link| link.outcome == Weighed::Contradicted;
    let loosely = reckoned(goal.clone(), Some(source), FEWEST_DIGITS);
    let loosely = loosely.filter(|link| !is_wrong(link))?;
    let exactly = reckoned(goal.clone(), None, FEWEST_DIGITS)?;
    (is_wrong(&exactly) || ends_in_whole(goal, &exactly)).then_some(loosely)
}

/// Whether a whole number of some digits is said to be what is worked out to none: `738 + \frac{1200}{0.718} = 2410`, and not `10/4 = 3`.
fn ends_in_whole(goal: &Goal, exactly: &Link) -> bool {
    let left = exactly.sides.as_ref().map(|(left, _)| left);
    let is_whole = left.is_some_and(|own| own.low() == own.high() && own.low().is_integer());
    // Of its digits half a unit of the last one is the share.
    let digits = |share: &BigRational| (share.recip() / BigInt::from(2)).to_integer().to_string();
    let is_long = (exactly.near.as_ref()).is_some_and(|own| digits(own).len() >= FEWEST_WHOLE);
    goal.rounding.is_none() && !is_whole && is_long
}

/// A relation between numbers, weighed, those of the fewest digits or more as they may be rounded; as they stand where no text tells how many
/// digits they have. Nothing of what is none.
fn reckoned(goal: Goal, source: Option<&str>, fewest: usize) -> Option<Link> {
    let goal = near_whole(&goal);
    let (left, relation, right) = likened(&goal.formula)?;
    let is_number = |term: &Expr| is_figures(term) && is_evaluable(term);
    if !goal.suppositions.is_empty()
        || goal.questioned
        || matches!(without_units(left), Expr::Number(_))
        || !is_number(left)
        || !is_number(right)
        || has_units(left) != has_units(right)
    {
        return None;
    }
    let near = goal.rounding.as_ref().map(|own| own.share.clone());
    // What is added up to about so much was added up before it was rounded: `0.54 + 0.25 \approx 0.78`.
    let fewest = match (left, relation) {
        (Expr::Sum(_), Relation::Approximately) => fewest.min(FEWEST_DIGITS - 1),
        _ => fewest,
    };
    let mut figures = Vec::new();
    let rounded = |span: Span| match source {
        Some(own) => own.get(span.range()).map(|text| long(text, fewest)),
        None => Some(Map::new()),
    };
    let loose_left = decimals::loosened(left, &rounded(goal.sides.0)?, &mut figures)?;
    // How near the number is that it comes to is known.
    let rounded_right = match near {
        Some(_) => Map::new(),
        None => rounded(goal.sides.1)?,
    };
    let loose_right = decimals::loosened(right, &rounded_right, &mut figures)?;
    let Compared {
        left,
        right,
        difference,
        ratio,
    } = Figures::from_iter(figures)
        .compared(&loose_left, &loose_right)
        .ok()?;
    let relation = match (&near, relation) {
        (Some(_), _) => Relation::Approximately,
        // Nothing says how near `≈` is meant.
        (None, Relation::Approximately) => return None,
        (None, own) => own,
    };
    let outcome = weigh(relation, &difference, ratio.as_ref(), near.as_ref());
    Some(Link {
        goal,
        sides: Some((left, right)),
        ratio,
        near,
        outcome,
    })
}

/// The numbers in a text that may be rounded, decimals with the fewest digits or more, each with half a unit of its last digit.
fn long(text: &str, fewest: usize) -> Map<BigRational, BigRational> {
    let mut all = decimals::decimals(text, fewest);
    let is_part = |c: char| c.is_ascii_digit() || c == '.';
    for number in text.split(|c: char| !is_part(c)) {
        let significant = number.trim_end_matches('0').len();
        if let Ok(value) = number.parse::<BigInt>()
            && significant >= FEWEST_WHOLE
            && !value.is_zero()
        {
            let half = BigRational::new(1.into(), 2.into());
            all.insert(BigRational::from_integer(value), half);
        }
    }
    all
}
