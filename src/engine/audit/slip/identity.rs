//! Links that are identities but for a slip of the pen: `= \frac{1}{R} (\frac14 - \frac1{16})^{-1} = \frac{3}{16 R}`.
//!
//! Both sides speak of the same, and with one small edit they are the same whatever stands before. That is left open where premises do not
//! agree, were not understood, or say too little for what else the statement says; but none of them says of the link what would make it true.

use crate::algebra::{Expr, Formula, Symbol, effort};
use crate::derivation::{Assumed, Goal};
use crate::kernel::Claim;
use crate::notation::{Statement, has_decimals};
use crate::search::{self, Change, Decision, Edit, Effort, Mended};
use crate::sorted::Set;

use super::super::entry::Entry;
use super::super::readings::Circumstances;
use super::super::stated::quantities;
use super::super::{Auditor, Judged, Note, Outcome, Verdict, judge};
use super::{samples, slips};

/// How much work may be done for one link.
const MOST_WORK: u64 = 1_000_000;
/// So many edits are tried.
const MOST_TRIED: usize = 40;
/// So many premises are held against a link.
const MOST_PREMISES: usize = 12;

impl Auditor<'_> {
    /// Says of a statement that is left open that it fails, where one of its links is an identity but for a slip.
    pub(in crate::audit) fn look_for_slip_in_identity(
        &self,
        statement: &Statement,
        how: &Circumstances,
        mut entry: Entry,
    ) -> Entry {
        let is_derived = self.derivation.equations[how.at].unread.is_empty();
        if entry.verdict != Verdict::Undecided || !is_derived {
            return entry;
        }
        let open = entry.judged.iter().enumerate();
        let open = open.filter(|(_, own)| matches!(own.outcome, Outcome::Open(_)));
        let found = open.into_iter().find_map(|(at, own)| {
            let may_be_one = may_be_identity(&own.goal);
            let held = || self.held_as_identity(statement, how, &entry, own);
            let found = may_be_one.then(|| effort::altogether(MOST_WORK, held));
            Some((at, found.flatten()?))
        });
        let Some((at, (refuted, mended, constant))) = found else {
            return entry;
        };
        entry.judged[at] = refuted;
        entry.verdict = Verdict::Fails;
        entry.mended = Some(Box::new(mended));
        entry.numeric = None;
        entry
            .notes
            .retain(|own| !matches!(own, Note::TakenAsConstant(_)));
        if !constant.is_empty() {
            entry.notes.push(Note::TakenAsConstant(constant));
        }
        entry
    }

    /// A link refuted where all is positive, the edit that makes an identity of it, and what that holds constant.
    fn held_as_identity(
        &self,
        statement: &Statement,
        how: &Circumstances,
        entry: &Entry,
        open: &Judged,
    ) -> Option<(Judged, Mended, Vec<Symbol>)> {
        let goal = &open.goal;
        let mut symbols = goal.formula.free_symbols();
        let page = &self.derivation.pages[self.derivation.equations[how.at].page];
        symbols.retain(|own| page.is_quantity(own));
        let positive: Vec<Assumed> = symbols.iter().map(judge::positive).collect();
        // What stands outside of what runs is not run over.
        let runs = |part: &Expr| matches!(part, Expr::Integral { .. } | Expr::Limit { .. });
        let terms = goal.formula.terms();
        let constant: Vec<Symbol> = match terms.into_iter().any(|term| term.any(&runs)) {
            true => symbols.into_iter().collect(),
            false => Vec::new(),
        };
        let claim = |assumed: &[Assumed], formula: &Formula| -> Claim {
            let claim = self.derivation.claim(how.at, assumed, formula);
            search::with_constants(claim, constant.iter().cloned())
        };
        let bare = claim(&positive, &goal.formula);
        let Decision::Refuted(refuted) = search::decide(bare.clone(), &self.hints()) else {
            return None;
        };
        let witness = Some(refuted.witness());
        let slips = slips(statement, &entry.judged, goal, &bare, witness).and_rarer();
        let samples = samples::anywhere(&goal.formula);
        let is_likely = |own: &Formula| !samples.are_enough() || samples.are_true_with(own);
        let plain = slips.such_that(is_likely);
        let plain = plain.filter(|edit| is_plain(&edit.change)).take(MOST_TRIED);
        // What a link comes to is wrong sooner than what it begins with.
        let (later, first): (Vec<Edit>, Vec<Edit>) = plain.partition(|edit| edit.left_kept);
        let mut shown = later.into_iter().chain(first).filter_map(|edit| {
            let claim = claim(&positive, &edit.formula);
            let derived = search::prove_unconditionally(claim, Effort::Light)?;
            Some(Mended::of(derived.proven, edit.change))
        });
        let mended = shown.next()?;
        // What is said of the same symbols could be why the link holds: `n^2 = n` where `n = 1`.
        let names = goal.formula.names();
        let is_of_the_same = |own: &&Assumed| {
            let of = own.formula.names();
            !of.is_empty() && of.iter().all(|own| names.contains(own) || own.is_unit())
        };
        let about: Vec<&Assumed> = open.assumed.iter().filter(is_of_the_same).collect();
        let leaves_false = |own: &&Assumed| {
            let mut all = positive.clone();
            all.push((*own).clone());
            let decision = search::decide(claim(&all, &goal.formula), &self.hints());
            matches!(decision, Decision::Refuted(_))
        };
        if about.len() > MOST_PREMISES || !about.iter().all(leaves_false) {
            return None;
        }
        let judged = Judged {
            goal: goal.clone(),
            assumed: positive,
            outcome: Outcome::Refuted(refuted.into()),
        };
        Some((judged, mended, constant))
    }
}

/// Whether both sides of an equation speak of the same, and of no figures that are rounded.
fn may_be_identity(goal: &Goal) -> bool {
    let Some((left, right)) = goal.formula.as_equation() else {
        return false;
    };
    let (named, others): (Set<Symbol>, Set<Symbol>) = (quantities(left), quantities(right));
    goal.rounding.is_none()
        && !goal.questioned
        && goal.suppositions.is_empty()
        && !named.is_empty()
        && named == others
        && ![left, right].into_iter().any(has_decimals)
        && !goal.formula.speaks_of_slopes()
}

/// Whether an edit is one that leaves the symbols as they are: another symbol may be meant to be the same.
fn is_plain(change: &Change) -> bool {
    use Change::{Coefficient, Exponent, Function, Inverted, Sign};
    matches!(change, Coefficient | Exponent | Function | Inverted | Sign)
}
