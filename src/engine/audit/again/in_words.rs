//! What words before a step say of where it comes from, and is not checked: "By symmetry the best response of firm 2 is", "By induction".

use crate::algebra::{Expr, Formula, Symbol, split_subscript};
use crate::derivation::{Assumed, Goal, formulas, in_a_row, renamed, words_of};
use crate::document::{GENERAL, Inline};
use crate::sorted::Map;

use super::super::judge::{Found, Judge, step};
use crate::search::{self, Decision, Effort};

/// With one of these a text says that something is so for the same reason.
const ALIKE: [&str; 10] = [
    "symmetry",
    "symmetric",
    "similarly",
    "likewise",
    "analogously",
    "analogy",
    "analogous",
    "correspondingly",
    "similar",
    "same",
];
/// "Firm 2 will follow the analogue of (3)" means another equation than (3).
const ANALOGUE: [&str; 5] = [
    "analogue",
    "analog",
    "counterpart",
    "equivalent",
    "analogues",
];
/// What words say of what does not change, and of what they say it.
const CONSERVED: &str = "conserved";
const CONSERVABLE: [&str; 5] = ["energy", "angular momentum", "momentum", "charge", "mass"];
/// With one of these it may take back what it writes, or say what something else is said to say.
const DENYING: [&str; 13] = [
    "not",
    "no",
    "never",
    "nor",
    "neither",
    "without",
    "unless",
    "unlike",
    "contrast",
    "than",
    "different",
    "differs",
    "far",
];
const INDUCTION: [&str; 1] = ["induction"];
/// So many equations in the text before are looked at.
const MOST_WRITTEN: usize = 4;
/// So many premises are tried one by one with what is written.
const MOST_BESIDE: usize = 8;
/// So many equations before are looked at.
const MOST_BEFORE: usize = 6;

impl Judge<'_> {
    /// Leaves open what was refuted and says of others what an equation before says, where the words give that as the reason. Whether all
    /// that it came from is so of these, too, nobody has shown.
    pub(in crate::audit) fn heed_symmetry(&self, goal: &Goal, found: &mut Found) {
        if !found.judged.outcome.is_refuted() || !self.says(&ALIKE) {
            return;
        }
        let page = self.derivation.equations[self.at].page;
        let start = self.derivation.equations_of(page).start;
        let before = start.max(self.at.saturating_sub(MOST_BEFORE))..self.at;
        let mut before = self.derivation.equations[before].iter().rev();
        let is_alike = before.any(|own| {
            let mut said = own.statements().iter().flat_map(formulas);
            said.any(|said| is_image(&said, &goal.formula))
        });
        if is_alike {
            found.leave_open(
                "it says of others what stands before, and that these are alike is not checked",
            );
        }
    }

    /// Whether it is drawn from the analogue of something, which nobody writes.
    pub(in crate::audit) fn draws_on_analogues(&self) -> bool {
        self.says_in_a_row(&ANALOGUE, &["of"])
    }

    /// Leaves open what is drawn from the analogue of an equation, and was refuted by that equation itself.
    pub(in crate::audit) fn heed_analogues(&self, found: &mut Found) {
        if found.judged.outcome.is_refuted() && self.draws_on_analogues() {
            found.leave_open(
                "it is drawn from what is like an equation before, and that is not written",
            );
        }
    }

    /// Leaves open what was refuted after a law that only words name: "Kinetic energy is conserved as well", where no display says that.
    pub(in crate::audit) fn heed_laws_in_words(&self, found: &mut Found) {
        if !found.judged.outcome.is_refuted() || found.mended.is_some() {
            return;
        }
        let before = self.derivation.text_before(self.at).to_lowercase();
        let sentences = before.split(['.', ';', ':']);
        let conserved = sentences.filter(|own| own.contains(CONSERVED));
        let subject = |sentence: &str| {
            let what = sentence.split(CONSERVED).next().unwrap_or_default();
            CONSERVABLE.into_iter().find(|own| what.contains(own))
        };
        let start = self
            .derivation
            .equations_of(self.derivation.equations[self.at].page)
            .start;
        let leads = |what: &str| {
            let mut before = (start..self.at).filter_map(|at| self.derivation.leading(at));
            before.any(|text| text.to_lowercase().contains(what))
        };
        if let Some(what) = conserved.filter_map(subject).find(|what| !leads(what)) {
            found.leave_open(format!(
                "words say that {what} is conserved, and no display says what that is"
            ));
        }
    }

    /// Leaves open what follows with an equation that is written in the text before it, in whatever words.
    pub(in crate::audit) fn heed_what_is_written(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        found: &mut Found,
    ) {
        if !found.judged.outcome.is_refuted() {
            return;
        }
        let denies = |text: &str| words_of(text).any(|word| DENYING.contains(&&*word));
        // "Substituting $V = w + 2 v$ from (2)" says of (2) what can be seen there.
        let is_read_off = |after: &str| words_of(after).next().is_some_and(|own| own == "from");
        // "The target stands still only if $w = 0$. In general": what is written before that is of a case that is over.
        let left = self.derivation.last_word_before(self.at, &GENERAL);
        let is_so = |math: &Inline| {
            let (before, after) = self.derivation.sentence_around(self.at, math);
            math.span.end > left && !denies(before) && !denies(after) && !is_read_off(after)
        };
        // "Equation (7) solved for the pressure drop is $p = 32 \mu L U/D^2$. Comparing with (8) we get"
        let mut written = self.derivation.written_in(self.at, is_so);
        // The nearest are meant first.
        written.reverse();
        let is_known = |own: &Formula| assumed.iter().any(|known| *known.formula == *own);
        let names = goal.formula.names();
        // "We need $m N \ge 987$. In second order $N \ge 987/2$" is drawn from that, with more than is written.
        let is_bound = |own: &Formula| own.as_equation().is_none() && !is_known(own);
        let mut bounds = written.iter().filter(|own| is_bound(own));
        if is_bound_by_number(&goal.formula)
            && bounds.any(|own| *own != goal.formula && !own.names().is_disjoint(&names))
        {
            found.leave_open(super::NAMED);
            return;
        }
        // What is put in is gone, and what is so at a place says nothing of slopes.
        let is_put = |own: &Formula| {
            let set = own.set_to_number();
            set.is_none_or(|set| !names.contains(set)) && !own.speaks_of_slopes()
        };
        written.retain(|own| own.as_equation().is_some() && is_put(own));
        written.retain(|own| !is_known(own) && *own != goal.formula);
        // "$f = 3$ for monatomic and $f = 5$ for diatomic gases": neither.
        let is_rival =
            |own: &Formula, other: &Formula| match (own.as_equation(), other.as_equation()) {
                (Some((left, right)), Some((of, value))) => left == of && right != value,
                _ => false,
            };
        let has_no_rival = |own: &&Formula| !written.iter().any(|other| is_rival(own, other));
        let meant = written.iter().filter(has_no_rival).take(MOST_WRITTEN);
        let written: Vec<Formula> = meant.cloned().collect();
        let follows = |words: &[Formula]| {
            let words: Vec<Assumed> = words.iter().map(step).collect();
            let all: Vec<Assumed> = assumed.iter().chain(&words).cloned().collect();
            let is_shown = |from: &[Assumed]| {
                let decision = self.decide_from(from, &goal.formula);
                // What is divided out is not 0.
                let divided = || {
                    let posed = self.pose(from, &goal.formula);
                    posed.is_ok_and(|posed| {
                        search::missing_conditions(&posed, None, Effort::Light, &[]).is_some()
                    })
                };
                matches!(decision, Some(Decision::Proven { .. })) || divided()
            };
            // From much that does not matter it may not be seen.
            let with_one = || {
                let mut others = assumed.iter().take(MOST_BESIDE);
                others.any(|own| is_shown(&[words.as_slice(), std::slice::from_ref(own)].concat()))
            };
            (is_shown(&all) || with_one())
                && !is_shown(&words)
                && !self.is_contradictory(&all, goal)
        };
        let alone = |own: &Formula| follows(std::slice::from_ref(own));
        if written.iter().any(alone) || written.len() > 1 && follows(&written) {
            found.leave_open(super::NAMED);
        }
    }

    /// Leaves open what is said to be so by induction, and was refuted as if it followed at once.
    pub(in crate::audit) fn heed_induction(&self, found: &mut Found) {
        if found.judged.outcome.is_refuted() && found.mended.is_none() && self.says(&INDUCTION) {
            found.leave_open("it is said to be so by induction, and that was not understood");
        }
    }

    /// Whether the last sentence before the step has one of these words.
    pub(in crate::audit) fn says(&self, such: &[&str]) -> bool {
        self.is_led_to_by(self.at, such)
    }

    /// Whether one of some words stands there, and one of others after it.
    pub(in crate::audit) fn says_in_a_row(&self, first: &[&str], next: &[&str]) -> bool {
        in_a_row(&self.derivation.leading_words(self.at), first, next)
    }

    /// The same of the last sentence before another display.
    pub(in crate::audit) fn is_led_to_by(&self, at: usize, such: &[&str]) -> bool {
        let mut words = self.derivation.leading_words(at).into_iter();
        words.any(|word| such.contains(&&*word))
    }
}

/// Whether one formula becomes the other where symbols change places, `q_1` and `q_2`, or others of the same letter come in.
fn is_image(one: &Formula, other: &Formula) -> bool {
    let (mut from, mut to) = (Vec::new(), Vec::new());
    one.terms()
        .into_iter()
        .for_each(|term| collect(term, &mut from));
    other
        .terms()
        .into_iter()
        .for_each(|term| collect(term, &mut to));
    if from.len() != to.len() || from == to {
        return false;
    }
    let mut put: Map<Symbol, Symbol> = Map::new();
    for (own, new) in from.iter().zip(&to) {
        if put
            .insert(own.clone(), new.clone())
            .is_some_and(|old| old != *new)
        {
            return false;
        }
    }
    let stem = |symbol: &Symbol| {
        let name = symbol.name();
        let stem = split_subscript(name).map_or(name, |(stem, _)| stem);
        stem.trim_end_matches('\'').to_owned()
    };
    let fits = |own: &Symbol, new: &Symbol| match put.get(new) {
        _ if own == new => true,
        Some(back) => back == own,
        None => stem(own) == stem(new),
    };
    let rename = |symbol: &Symbol| put.get(symbol).unwrap_or(symbol).clone();
    put.iter().all(|(own, new)| fits(own, new))
        && one.map_terms(|term| renamed(term, &rename)) == *other
}

/// The symbols of a term as they stand.
fn collect(term: &Expr, symbols: &mut Vec<Symbol>) {
    if let Expr::Symbol(symbol) = term {
        symbols.push(symbol.clone());
    }
    term.children().for_each(|part| collect(part, symbols));
}

/// Whether a formula bounds something by a number: `N \ge 987/2`.
fn is_bound_by_number(formula: &Formula) -> bool {
    let [left, right] = formula.terms()[..] else {
        return false;
    };
    let is_number = |term: &Expr| {
        let is_nought = *term == Expr::integer(0);
        term.is_arithmetic() && term.free_symbols().is_empty() && !is_nought
    };
    formula.as_equation().is_none() && is_number(left) != is_number(right)
}
