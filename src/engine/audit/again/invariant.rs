//! What is the same in two states: "Along an isentrope $T v^{\gamma - 1}$ is constant", `T V^{\gamma - 1} = \text{const}`, and then
//! `\frac{T_2}{T_1} = r^{\gamma - 1}`.
//!
//! Which states lie on one curve the words say, and are not understood; but a ratio of two of them, with the states written below, is of
//! these two. A step that this decides is refuted where it is one slip away from what follows, and no step is refuted that follows.

use crate::algebra::{Expr, Formula, Symbol, effort, split_subscript};
use crate::derivation::{Assumed, Goal, Source, renamed, values_at, words_of};
use crate::document::Inline;
use crate::notation::read_expr;
use crate::search::{self, Change, Decision, Effort, InChain, Mended, Slips};
use crate::sorted::{Map, Set};

use super::super::Judged;
use super::super::instances::states;
use super::super::judge::{Found, Judge, taken};
use super::obeys::refuted_of;

/// So much work is done for that, as [`effort`] counts it.
const MOST_WORK: u64 = 2_000_000;
/// So many edits are tried.
const MOST_EDITS: usize = 40;
/// A step compares few states.
const MOST_PAIRS: usize = 3;
/// So many terms that are said not to change are looked at, the nearest first.
const MOST_TOLD: usize = 3;
/// After mathematics these say that it does not change: "is constant", "remains constant", "is conserved".
const STAYING: [&str; 5] = ["is", "remains", "stays", "are", "remain"];
const SAME: [&str; 5] = ["constant", "conserved", "unchanged", "fixed", "invariant"];

/// What does not change, and who says so.
struct Invariant {
    term: Expr,
    said: Option<Assumed>,
}

impl Judge<'_> {
    /// What to say of a ratio of states that what does not change says otherwise.
    pub(in crate::audit) fn as_no_ratio_of_states(
        &self,
        goal: &Goal,
        judged: &Judged,
    ) -> Option<Found> {
        let is_plain = goal.is_said_outright() && goal.rounding.is_none();
        if !is_plain || goal.formula.as_equation().is_none() {
            return None;
        }
        let steps = judged
            .assumed
            .iter()
            .filter(|own| own.source == Source::Step);
        let steps: Vec<Assumed> = steps.cloned().collect();
        // Few steps speak of states.
        let is_state = |own: &Symbol| split_subscript(own.name()).is_some();
        if !goal.formula.names().iter().any(is_state) && steps.is_empty() {
            return None;
        }
        let invariants = self.invariants();
        if invariants.is_empty() {
            return None;
        }
        let held = || {
            let mut all = invariants.iter();
            all.find_map(|own| self.held_between_states(goal, judged, &steps, own))
        };
        effort::within(MOST_WORK, held)
    }

    /// What is said not to change in the text since the display before, and by what is cited.
    fn invariants(&self) -> Vec<Invariant> {
        let source = &self.derivation.pages[self.derivation.equations[self.at].page]
            .document
            .source;
        let stays = |end: usize| {
            let after = source.get(end..).unwrap_or_default();
            let after = after.split(['.', ',', ';', '$']).next().unwrap_or_default();
            let words: Vec<String> = words_of(after).take(3).collect();
            let words: Vec<&str> = words.iter().map(String::as_str).collect();
            match words[..] {
                [is, "the", "same"] => STAYING.contains(&is),
                [is, same, ..] => STAYING.contains(&is) && SAME.contains(&same),
                _ => false,
            }
        };
        let told = self.derivation.inline_before(self.at);
        let told: Vec<&Inline> = told.filter(|own| stays(own.span.end)).collect();
        let told = told.into_iter().rev().take(MOST_TOLD);
        let told = told.filter_map(|own| read_expr(source, own.body).ok());
        let told = told.map(|term| Invariant { term, said: None });
        let is_constant = |side: &Expr| matches!(side, Expr::Symbol(own) if self.derivation.is_some_constant(own));
        let cited = self.usable.assumed.iter().filter_map(|own| {
            let (left, right) = own.formula.as_equation()?;
            let term = match (is_constant(left), is_constant(right)) {
                (false, true) => left,
                (true, false) => right,
                _ => return None,
            };
            Some(Invariant {
                term: term.clone(),
                said: Some(own.clone()),
            })
        });
        told.chain(cited)
            .filter(|own| !matches!(own.term, Expr::Symbol(_)))
            .collect()
    }

    fn held_between_states(
        &self,
        goal: &Goal,
        judged: &Judged,
        steps: &[Assumed],
        invariant: &Invariant,
    ) -> Option<Found> {
        let of = Formula::names_in(std::iter::once(&invariant.term));
        let mut known = self.usable.assumed.clone();
        known.extend(self.derivation.told(self.at));
        known.retain(|own| {
            !own.formula
                .names()
                .iter()
                .any(|own| self.derivation.is_some_constant(own))
        });
        let formulas = || {
            steps
                .iter()
                .chain(&known)
                .map(|own| &*own.formula)
                .chain([&goal.formula])
        };
        let spoken: Set<Symbol> = formulas().flat_map(Formula::names).collect();
        let compared = steps.iter().map(|own| &*own.formula).chain([&goal.formula]);
        let mut pairs: Vec<[String; 2]> = Vec::new();
        for side in compared.flat_map(Formula::terms) {
            for pair in states_compared(side, &of) {
                if !pairs.contains(&pair) {
                    pairs.push(pair);
                }
            }
        }
        if pairs.is_empty() || pairs.len() > MOST_PAIRS {
            return None;
        }
        let same = pairs
            .iter()
            .filter_map(|pair| between(&invariant.term, pair, &of, &spoken));
        let same = same.map(|formula| match &invariant.said {
            Some(said) => Assumed {
                formula: formula.into(),
                ..said.clone()
            },
            None => taken(&formula),
        });
        let mut all: Vec<Assumed> = same.collect();
        if all.is_empty() {
            return None;
        }
        all.extend(steps.iter().cloned());
        all.extend(known);
        let symbols = all.iter().flat_map(|own| own.formula.free_symbols());
        let symbols = symbols.chain(goal.formula.free_symbols()).collect();
        all.extend(self.meant_positive(symbols));
        let claim = |formula: &Formula| self.derivation.claim(self.at, &all, formula);
        let bare = claim(&goal.formula);
        let posed = self.pose_claim(bare.clone()).ok()?;
        let refuted = match self.decide(&posed) {
            Decision::Refuted(refuted) => refuted,
            Decision::Proven { .. } if judged.outcome.is_refuted() => {
                let mut found = Found::open(judged.clone());
                found.leave_open(
                    "it follows where both states are of one curve, and only words say of which",
                );
                return Some(found);
            }
            _ => return None,
        };
        let slips = Slips::of(
            &bare,
            &InChain::default(),
            Some(refuted.witness()),
            values_at,
        );
        let slips = slips.and_rarer().filter(|edit| is_slip(&edit.change));
        let mended = slips.take(MOST_EDITS).find_map(|edit| {
            let derived = search::prove_unconditionally(claim(&edit.formula), Effort::Light)?;
            Some(Mended::of(derived.proven, edit.change))
        })?;
        let mut found = refuted_of(goal, &goal.formula, &all, refuted);
        found.mended = Some(mended.into());
        Some(found)
    }
}

/// Whether an edit leaves what is spoken of as it is, or takes one state for another.
fn is_slip(change: &Change) -> bool {
    use Change::{Coefficient, Exchanged, Exponent, Inverted, Sign, Summand};
    matches!(
        change,
        Coefficient | Exchanged { .. } | Exponent | Inverted | Sign | Summand
    )
}

/// The two states of which a term has the same symbol, `\frac{T_2}{T_1}`.
fn states_compared(term: &Expr, of: &Set<Symbol>) -> Vec<[String; 2]> {
    let names = Formula::names_in(std::iter::once(term));
    let pair = |own: &Symbol| match states(own, &names)[..] {
        [(one, _), (other, _)] => Some([one.to_owned(), other.to_owned()]),
        _ => None,
    };
    of.iter().filter_map(pair).collect()
}

/// That a term is the same in two states: what has a name in some has these there, and the rest does not change.
fn between(
    term: &Expr,
    pair: &[String; 2],
    of: &Set<Symbol>,
    spoken: &Set<Symbol>,
) -> Option<Formula> {
    let known = of.iter().map(|own| (own, states(own, spoken)));
    let known: Vec<(&Symbol, Vec<(&str, &Symbol)>)> =
        known.filter(|(_, states)| !states.is_empty()).collect();
    let there = |state: &String| {
        let named = known.iter().map(|(own, states)| {
            let (_, name) = states.iter().find(|(own, _)| own == state)?;
            Some((*own, *name))
        });
        let named: Map<&Symbol, &Symbol> = named.collect::<Option<_>>()?;
        Some(renamed(term, &|own: &Symbol| {
            (*named.get(own).unwrap_or(&own)).clone()
        }))
    };
    let (one, other) = (there(&pair[0])?, there(&pair[1])?);
    (one != other).then(|| Formula::equal(one, other))
}
