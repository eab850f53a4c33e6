//! The nearest true formula to a false one: a slip of the pen undone.
//!
//! Of the formulas that are one small edit away ([`edits`]) most are false at the known counterexample, or at another
//! point on the premises; the few that are left go to the kernel.

mod edits;
mod rarer;
mod vacuous;

use std::cell::OnceCell;
use std::collections::{BTreeMap, HashMap};
use std::mem::{self, Discriminant};

use num_traits::{One, Signed, Zero};

use crate::algebra::{BigRational, Expr, Formula, Relation, Symbol, Values};
use crate::kernel::{Assignment, Claim, Domain, Hypothesis, Obligation, Proven, Standing};

use super::{
    Effort, defines_afresh, pose, prove_posed, prove_unconditionally, refute, refuted, unfold,
};
use crate::sorted::Set;
pub use edits::{Change, Edit};
use edits::{Names, edits};
use rarer::rarer_edits;
use vacuous::{is_vacuous, says_nothing};

/// How many edits that are true at every point are handed to the prover.
const MOST_TRIED: usize = 6;
/// How much less likely a slip is that is false at a point.
const REFUTED: u32 = 8;
/// What coefficients cost that few pens slip by.
const RARE: u32 = 16;
/// How many are where functions or derivatives have no value at a point.
const MOST_UNWEIGHED: usize = 40;
/// How many of these are tried in earnest, and how many of those that have no value.
const IN_EARNEST: usize = 2;
const UNWEIGHED_IN_EARNEST: usize = 8;
/// How many bounds are: none of them is seen at first sight.
const BOUNDS_IN_EARNEST: usize = 4;
/// How many choices a search for a further point may try.
const CHOICES: usize = 120;
/// Symbols that are given a number of their own.
const MOST_PINNED: usize = 12;
/// Symbols that one may have been mistaken for.
const MOST_NAMES: usize = 16;

/// A formula one edit away from what is printed, that follows.
#[derive(Clone, Debug)]
pub struct Mended {
    /// The kernel's word for it.
    pub proven: Proven,
    /// What was changed.
    pub change: Change,
    /// The kernel's word for the next link of its chain, which begins with the right side, once that is changed.
    pub next: Option<Proven>,
    /// What must hold besides, and nothing says so.
    pub under: Vec<Formula>,
}

impl Mended {
    /// What follows as it is, whatever comes next.
    pub fn of(proven: Proven, change: Change) -> Mended {
        Mended {
            proven,
            change,
            next: None,
            under: Vec::new(),
        }
    }
}

/// What a refuted link of a chain has to do with its neighbours.
#[derive(Clone, Debug, Default)]
pub struct InChain {
    /// The left side is right, as far as the links beside it tell: only the right side is wrong.
    pub left_settled: bool,
    /// The other way round.
    pub right_settled: bool,
    /// The link that goes on with the right side.
    pub next: Option<Formula>,
}

impl InChain {
    /// The next link after an edit of the right side.
    fn next_after(&self, edit: &Edit) -> Option<Formula> {
        let (Formula::Relation { right: changed, .. }, false) = (&edit.formula, edit.right_kept)
        else {
            return None;
        };
        match self.next.clone()? {
            Formula::Relation {
                relation, right, ..
            } => Some(Formula::Relation {
                left: changed.clone(),
                relation,
                right,
            }),
            Formula::AllEqual { .. } => None,
        }
    }
}

/// The likeliest slip of the pen in a refuted goal: one edit with which it follows from the claim's hypotheses.
///
/// `evaluate` gives the values that a point has under a claim; `hints` are points at which premises like these are known to hold. Nothing where no edit is good: what would follow from
/// no premises at all is none, unless what is printed is a piece of algebra.
///
/// In a chain an edit that leaves the next link true, or makes it so, goes before others.
pub fn mended(
    claim: &Claim,
    chain: &InChain,
    witness: &Assignment,
    hints: &[Assignment],
    evaluate: impl Fn(&Claim, &Assignment) -> Values,
) -> Option<Mended> {
    let mut candidates = Candidates::new(claim, chain);
    (candidates.left).retain(|edit| !defines_afresh(claim, &edit.formula));
    candidates.weigh_at_points(claim, witness, hints, evaluate);
    candidates.sort(claim, chain);
    candidates.first_proved(claim, chain)
}

/// The slips of the pen that may have been made in a refuted goal, the likeliest first. Whether the goal follows without one of them is for who
/// asks to find out: more may be known than the claim says, so that what is false at a point comes late, and is not left out.
pub struct Slips<'a> {
    claim: &'a Claim,
    chain: InChain,
    /// By what speaks against each, and in which order they were made.
    left: BTreeMap<(u32, usize), Slip>,
    /// Points at which all premises hold.
    points: Vec<Assignment>,
}

struct Slip {
    edit: Edit,
    /// Whether it was held against the points.
    is_weighed: bool,
}

impl<'a> Slips<'a> {
    /// As [`mended`].
    pub fn of(
        claim: &'a Claim,
        chain: &InChain,
        witness: Option<&Assignment>,
        evaluate: impl Fn(&Claim, &Assignment) -> Values,
    ) -> Slips<'a> {
        let mut candidates = Candidates::new(claim, chain);
        let all = candidates.left.clone();
        if let Some(witness) = witness {
            candidates.weigh_at_points(claim, witness, &[], evaluate);
        }
        let own = claim.goal.names();
        // What an equation is solved for is right.
        let is_solved = matches!(claim.goal.as_equation(), Some((Expr::Symbol(_), _)));
        let is_rare = |edit: &Edit| edit.change == Change::Coefficient && edit.cost >= RARE;
        // Those that are left stand in the same order.
        let mut kept = candidates.left.into_iter().peekable();
        let mut seen: HashMap<Discriminant<Change>, u32> = HashMap::new();
        let mut left = BTreeMap::new();
        for edit in all {
            let is_true = kept.next_if(|own| own.formula == edit.formula).is_some();
            if is_rare(&edit) || is_solved && !edit.left_kept {
                continue;
            }
            let seen = seen.entry(mem::discriminant(&edit.change)).or_insert(0);
            let before = *seen;
            *seen += 1;
            // There are many numbers to slip by.
            let before = match edit.change {
                Change::Coefficient | Change::Sign => before / 6,
                _ => before,
            };
            // What the goal does not speak of at all is seldom missing.
            let is_foreign = !edit.formula.names().is_subset(&own);
            let more = u32::from(is_foreign) + 2 * u32::from(!is_true);
            let doubt = edit.cost + 2 * before + 6 * more;
            let slip = Slip {
                edit,
                is_weighed: false,
            };
            left.insert((doubt, left.len()), slip);
        }
        Slips {
            claim,
            chain: chain.clone(),
            left,
            points: witness.cloned().into_iter().collect(),
        }
    }

    /// With those that are rarer, of which there are too many to try them all.
    #[must_use]
    pub fn and_rarer(mut self) -> Slips<'a> {
        let is_solved = matches!(self.claim.goal.as_equation(), Some((Expr::Symbol(_), _)));
        let left_settled = self.chain.left_settled || is_solved;
        let rarer = rarer_edits(&self.claim.goal).into_iter();
        let rarer = rarer.filter(|edit| {
            (edit.left_kept || !left_settled) && (edit.right_kept || !self.chain.right_settled)
        });
        for edit in rarer {
            let slip = Slip {
                edit,
                is_weighed: false,
            };
            self.left.insert((slip.edit.cost, self.left.len()), slip);
        }
        self
    }

    /// Only those that are found worth a try.
    #[must_use]
    pub fn such_that(mut self, is_likely: impl Fn(&Formula) -> bool) -> Slips<'a> {
        self.left.retain(|_, slip| is_likely(&slip.edit.formula));
        self
    }

    /// Takes a point at which one was false for one at which others may be.
    pub fn heed(&mut self, point: &Assignment) {
        self.points.push(point.clone());
    }

    fn is_refuted(&self, edit: &Edit) -> bool {
        let own = Claim {
            goal: edit.formula.clone(),
            ..self.claim.clone()
        };
        let posed = pose(own).ok();
        let is_false = |posed: &Obligation| {
            let mut points = self.points.iter();
            points.any(|point| refuted(posed, point.clone()).is_some())
        };
        posed.is_none_or(|posed| is_false(&posed))
    }
}

impl Iterator for Slips<'_> {
    type Item = Edit;

    fn next(&mut self) -> Option<Edit> {
        loop {
            let ((doubt, at), slip) = self.left.pop_first()?;
            let edit = &slip.edit;
            if slip.is_weighed {
                return Some(slip.edit);
            }
            if says_nothing(self.claim, &edit.change, &edit.formula) {
                continue;
            }
            if !self.is_refuted(edit) {
                return Some(slip.edit);
            }
            let weighed = Slip {
                is_weighed: true,
                ..slip
            };
            self.left.insert((doubt + REFUTED, at), weighed);
        }
    }
}

/// The edits that are false at no point that was looked at.
struct Candidates {
    left: Vec<Edit>,
    /// These points, the counterexample first.
    points: Vec<Values>,
}

impl Candidates {
    fn new(claim: &Claim, chain: &InChain) -> Candidates {
        let mut left = edits(&claim.goal, &names(claim));
        left.retain(|edit| edit.left_kept || !chain.left_settled);
        left.retain(|edit| edit.right_kept || !chain.right_settled);
        Candidates {
            left,
            points: Vec::new(),
        }
    }

    fn weigh(&mut self, goal: &Formula, values: Values) {
        let printed = Printed::new(goal, &values);
        self.left.retain(|edit| !printed.is_false(edit, &values));
        self.points.push(values);
    }

    fn weigh_at_points(
        &mut self,
        claim: &Claim,
        witness: &Assignment,
        hints: &[Assignment],
        evaluate: impl Fn(&Claim, &Assignment) -> Values,
    ) {
        self.weigh(&claim.goal, evaluate(claim, witness));
        for hint in hints.iter().filter(|hint| is_admissible(claim, hint)) {
            if self.left.is_empty() {
                return;
            }
            let values = evaluate(claim, hint);
            let mut premises = claim.hypotheses.iter();
            if says_how_all_varies(&claim.goal, &values)
                && premises.all(|h| values.holds(&h.formula) == Ok(true))
            {
                self.weigh(&claim.goal, values);
            }
        }
        // What is proved at first sight, or not at all, is not worth a long search for points.
        let light = !claim.sequences.is_empty() && !claim.goal.is_inequality();
        let shifts = if light { 0 } else { 2 };
        for shift in 0..shifts {
            if self.left.is_empty() {
                return;
            }
            if let Some((pinned, point)) = generic(claim, shift) {
                let values = evaluate(&pinned, &point);
                if says_how_all_varies(&claim.goal, &values) {
                    self.weigh(&claim.goal, values);
                }
            }
        }
    }

    /// The likeliest first.
    fn sort(&mut self, claim: &Claim, chain: &InChain) {
        let points = &self.points;
        let begins = matches!(
            &claim.goal,
            Formula::Relation {
                left: Expr::Symbol(_),
                ..
            }
        );
        // Of several bounds that hold the nearest true one is the tightest.
        if claim.goal.is_inequality() {
            let letters = |change: &Change| {
                matches!(
                    change,
                    Change::Symbol { .. } | Change::Factor | Change::Summand
                )
            };
            self.left.sort_by_cached_key(|edit| {
                // Half of what a bound is for is nearer to it, and says nothing else.
                let named = begins && !edit.left_kept;
                let slack = points.first().and_then(|there| slack(edit, there));
                (letters(&edit.change), named, slack, edit.cost)
            });
        }
        if chain.next.is_some() {
            // A symbol that a chain begins with is what it is about.
            let breaks = |edit: &Edit| {
                let next = chain.next_after(edit);
                next.is_some_and(|next| points.iter().any(|p| p.holds(&next) == Ok(false)))
            };
            let left = &mut self.left;
            left.sort_by_cached_key(|edit| breaks(edit) || begins && !edit.left_kept);
        }
    }

    /// Whether most of what is left was seen to be true somewhere; elsewhere the right one may stand far down.
    fn are_weighed(&self) -> bool {
        // At one point much is true by chance.
        let [there, _, ..] = &self.points[..] else {
            return false;
        };
        let open = |edit: &&Edit| there.holds(&edit.formula).is_err();
        self.left.iter().filter(open).count() <= MOST_TRIED
    }

    fn first_proved(&self, claim: &Claim, chain: &InChain) -> Option<Mended> {
        let with = |goal: &Formula| Claim {
            goal: goal.clone(),
            ..claim.clone()
        };
        let weighed = !claim.sequences.is_empty() || self.are_weighed();
        let at_sight = if weighed { MOST_TRIED } else { MOST_UNWEIGHED };
        // Sums with a symbolic number of terms are proved at first sight or after a long search.
        let in_earnest = match claim.goal.is_inequality() {
            true if claim.sequences.is_empty() => BOUNDS_IN_EARNEST,
            false if !claim.sequences.is_empty() => 0,
            false if !weighed => UNWEIGHED_IN_EARNEST,
            _ => IN_EARNEST,
        };
        // What is not seen at first sight is read already when it is tried in earnest.
        let read = self.left.iter().map(|edit| (edit, OnceCell::new()));
        let read: Vec<(&Edit, OnceCell<_>)> = read.take(at_sight.max(in_earnest)).collect();
        for (effort, most) in [(Effort::Light, at_sight), (Effort::Full, in_earnest)] {
            for (edit, posed) in read.iter().take(most) {
                let posed = posed.get_or_init(|| pose(with(&edit.formula)).ok());
                let derived = posed.as_ref().and_then(|posed| prove_posed(posed, effort));
                let Some(derived) = derived else {
                    continue;
                };
                if is_vacuous(claim, &edit.change, &edit.formula) || is_slack(claim, edit) {
                    continue;
                }
                let next = chain.next_after(edit);
                let next = next.and_then(|next| prove_unconditionally(with(&next), Effort::Light));
                return Some(Mended {
                    proven: derived.proven,
                    change: edit.change.clone(),
                    next: next.map(|derived| derived.proven),
                    under: Vec::new(),
                });
            }
        }
        None
    }
}

/// Whether a point says how all varies that a goal differentiates: where nothing is said of a symbol, it would stand still.
fn says_how_all_varies(goal: &Formula, values: &Values) -> bool {
    let is_unsaid = |term: &Expr| {
        let Expr::Derivative { body, variable } = term else {
            return false;
        };
        let is_said = |symbol: &Symbol| {
            symbol == variable
                || values.terms.contains_key(symbol)
                || values.constants.contains(symbol)
                || values
                    .slopes
                    .contains_key(&(symbol.clone(), variable.clone()))
        };
        values.terms.contains_key(variable) || !body.free_symbols().iter().all(is_said)
    };
    !goal.terms().iter().any(|term| term.any(&is_unsaid))
}

/// Whether the symbols that a point gives a value lie where they may.
fn is_admissible(claim: &Claim, point: &Assignment) -> bool {
    let mut values = point.symbols.iter();
    values.all(|(symbol, value)| claim.domains.get(symbol).is_none_or(|d| d.contains(value)))
}

/// How far apart the sides of an edited inequality are at a point; nothing where only the relation was edited.
fn slack(edit: &Edit, values: &Values) -> Option<BigRational> {
    let Formula::Relation { left, right, .. } = &edit.formula else {
        return None;
    };
    if matches!(edit.change, Change::Strict | Change::Relation) {
        return None;
    }
    let (left, right) = (values.value(left).ok()?, values.value(right).ok()?);
    Some((left - right).abs())
}

/// The sides of a printed goal at a point, if they have values there.
struct Printed {
    left: Option<BigRational>,
    right: Option<BigRational>,
}

impl Printed {
    fn new(goal: &Formula, values: &Values) -> Printed {
        let (left, right) = match goal {
            Formula::Relation { left, right, .. } => (values.value(left), values.value(right)),
            Formula::AllEqual { .. } => {
                return Printed {
                    left: None,
                    right: None,
                };
            }
        };
        Printed {
            left: left.ok(),
            right: right.ok(),
        }
    }

    /// Whether an edited formula is false at the point. The side that is as printed is not worked out again.
    fn is_false(&self, edit: &Edit, values: &Values) -> bool {
        let Formula::Relation {
            left,
            relation,
            right,
        } = &edit.formula
        else {
            return true;
        };
        let value = |own: &Option<BigRational>, kept: bool, side: &Expr| match kept {
            true => own.clone(),
            false => values.value(side).ok(),
        };
        let (Some(left), Some(right)) = (
            value(&self.left, edit.left_kept, left),
            value(&self.right, edit.right_kept, right),
        ) else {
            return false;
        };
        let there = Formula::Relation {
            left: Expr::Number(left),
            relation: *relation,
            right: Expr::Number(right),
        };
        values.holds(&there) == Ok(false)
    }
}

/// What may be written for a symbol, or beside it: nobody writes what is supposed to be 0.
fn names(claim: &Claim) -> Names {
    let vanishes = |symbol: &&Symbol| claim.hypotheses.iter().any(|h| is_nought(h, symbol));
    let all = claim.free_symbols().into_iter();
    let all = all.filter(|symbol| !vanishes(symbol)).cloned();
    let all: Vec<Symbol> = all.take(MOST_NAMES).collect();
    let (nought, one) = (BigRational::zero(), BigRational::one());
    let is_share = |symbol: &Symbol| {
        let domain = claim.domains.get(symbol);
        let ends = domain.and_then(|d| Some((&d.lower.as_ref()?.0, &d.upper.as_ref()?.0)));
        ends == Some((&nought, &one))
    };
    Names {
        shares: all.iter().filter(|s| is_share(s)).cloned().collect(),
        all,
    }
}

/// Whether a hypothesis says that a symbol is 0.
pub(super) fn is_nought(hypothesis: &Hypothesis, symbol: &Symbol) -> bool {
    match hypothesis.formula.as_equation() {
        Some((Expr::Symbol(own), Expr::Number(value))) => own == symbol && value.is_zero(),
        _ => false,
    }
}

/// Whether an edited number makes a bound that nothing comes near, where premises leave bounds that are reached.
fn is_slack(claim: &Claim, edit: &Edit) -> bool {
    let Formula::Relation { left, right, .. } = &edit.formula else {
        return false;
    };
    let strict = |h: &Hypothesis| {
        let relation = |f: &Formula| match f {
            Formula::Relation { relation, .. } => Some(*relation),
            Formula::AllEqual { .. } => None,
        };
        matches!(
            relation(&h.formula),
            Some(Relation::Less | Relation::Greater)
        )
    };
    if edit.change != Change::Coefficient
        || !edit.formula.is_inequality()
        || claim.hypotheses.is_empty()
        || claim.hypotheses.iter().any(strict)
    {
        return false;
    }
    is_never_reached(claim, left, right)
}

/// Whether no point is known on the premises at which two terms are equal.
fn is_never_reached(claim: &Claim, left: &Expr, right: &Expr) -> bool {
    let mut reached = claim.clone();
    reached.hypotheses.push(Hypothesis {
        formula: Formula::equal(left.clone(), right.clone()).into(),
        standing: Standing::AtPoint,
    });
    model(&reached).is_none()
}

/// A point on the premises at which nothing is true by chance: the symbols on the right of the goal are different
/// primes, or their reciprocals, as far as the premises leave them free.
fn generic(claim: &Claim, shift: usize) -> Option<(Claim, Assignment)> {
    let (left, right) = match &claim.goal {
        Formula::Relation { left, right, .. } => (left, right),
        Formula::AllEqual { .. } => return None,
    };
    let mut symbols: Set<Symbol> = right.free_symbols();
    if symbols.is_empty() {
        symbols = left.free_symbols();
    }
    let (mut pinned, mut last) = (claim.clone(), None);
    for (at, symbol) in symbols.into_iter().enumerate().take(MOST_PINNED) {
        let value = chosen(claim, &symbol, at * (shift + 1) + shift);
        let Some(value) = value else { continue };
        pinned.hypotheses.push(Hypothesis {
            formula: Formula::number(symbol, value).into(),
            standing: Standing::AtPoint,
        });
        // What the premises tie together cannot be chosen freely.
        match model(&pinned) {
            None => drop(pinned.hypotheses.pop()),
            found => last = found,
        }
    }
    let mut point = last.or_else(|| model(&pinned))?;
    // Of what no premise speaks a model says nothing.
    for (at, symbol) in claim.goal.free_symbols().into_iter().enumerate() {
        let value = chosen(claim, &symbol, at + shift);
        if let Some(value) = value.filter(|_| !point.symbols.contains_key(&symbol)) {
            point.symbols.insert(symbol, value);
        }
    }
    Some((pinned, point))
}

/// A prime, its reciprocal or its negative, where the symbol's domain has it.
fn chosen(claim: &Claim, symbol: &Symbol, at: usize) -> Option<BigRational> {
    const PRIMES: [i64; 12] = [2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37];
    let whole = BigRational::from_integer(PRIMES[at % PRIMES.len()].into());
    let domain = claim.domains.get(symbol);
    let fits = |value: &BigRational| domain.is_none_or(|d: &Domain| d.contains(value));
    [whole.clone(), whole.recip(), -whole]
        .into_iter()
        .find(fits)
}

fn model(claim: &Claim) -> Option<Assignment> {
    let unfold = unfold::definitions_to_unfold(claim);
    let premises = Obligation::of_premises(claim.clone(), unfold).ok()?;
    let mut points = refute::Points::of_premises(&premises);
    let found = points.next(CHOICES).into_iter();
    found
        .map(|point| premises.model(point))
        .find_map(Result::ok)
        .map(|m| m.point().clone())
}
