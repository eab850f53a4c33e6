//! What the sentence that leads on to a step names and does not suppose plainly: "An object at $g = 2 f$ is thus imaged at".
//!
//! A step that does not follow from what it cites, nor with what stands before, may be meant to follow from that as well; what it was
//! taken from is told. No step follows from words that say as much as it does.

use crate::algebra::{Expr, Formula, Symbol, split_subscript};
use crate::derivation::{Assumed, Goal, Source};
use crate::kernel::Standing;
use crate::notation::{plain_formula, read_expr};
use crate::search::{self, Decision, Effort};

use super::super::Outcome;
use super::super::judge::{Found, Judge, NEARBY, taken};
use super::there::{join, whole};
use crate::sorted::Set;

/// So much that words say is held against one another.
const MOST_SAID: usize = 6;

impl Judge<'_> {
    /// What a step may be taken from, with what the words before it name, and tell in passing; nothing where they name nothing, or what
    /// cannot be so.
    pub(in crate::audit) fn with_what_is_named(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        premises: &[usize],
    ) -> Option<Vec<Assumed>> {
        let mut named = self.derivation.named(self.at);
        named.extend(self.special_value(goal, assumed, premises));
        let mut told = self.derivation.told_just_before(self.at);
        let is_known = |own: &Assumed| assumed.iter().any(|known| known.formula == own.formula);
        named.retain(|own| !is_known(own));
        told.retain(|own| !is_known(own));
        if named.is_empty() && told.is_empty() {
            return None;
        }
        // What is put in is gone: "with $V = V_0$ at $t = 0$" is no reason for what still speaks of the time.
        let names = goal.formula.names();
        let all = assumed.iter().chain(&named);
        let is_put = |name: &Symbol| {
            all.clone()
                .any(|own| own.formula.set_to_number() == Some(name))
        };
        let is_left = |own: &Assumed| leaves(&own.formula, &names);
        if !names.iter().all(is_put) && named.iter().any(is_left) {
            named.clear();
        }
        told.retain(|own| !is_left(own));
        let both = named.iter().chain(&told).cloned().collect();
        let choices = match told.is_empty() {
            true => vec![named],
            false => vec![both, named],
        };
        choices.into_iter().find_map(|mut words| {
            let alone = || {
                let alone = self.derivation.claim(self.at, &words, &goal.formula);
                search::prove_unconditionally(alone, Effort::Light).is_some()
            };
            if words.is_empty() || alone() {
                return None;
            }
            words.splice(0..0, assumed.iter().cloned());
            (!self.is_contradictory(&words, goal)).then_some(words)
        })
    }

    /// That something has the special value that the words just before name, with what says what that is: "When the body starts from
    /// $h_{\min}$, (8) becomes" is said where `h` is that. Nothing where the step still speaks of either.
    fn special_value(&self, goal: &Goal, assumed: &[Assumed], premises: &[usize]) -> Vec<Assumed> {
        let own = &self.derivation.equations[self.at];
        let (Some(said), false) = (own.said_last, self.is_directed()) else {
            return Vec::new();
        };
        let source = &self.derivation.pages[own.page].document.source;
        let names = goal.formula.names();
        let is_spoken_of = |own: &Symbol| {
            let mut all = assumed.iter();
            all.any(|known| known.formula.names().contains(own))
        };
        let inline = self.derivation.inline_before(self.at);
        let last = inline.filter(|math| said.start <= math.span.start);
        let special = last.filter_map(|math| match read_expr(source, math.body) {
            Ok(Expr::Symbol(value)) => Some((whole(&value)?, value)),
            _ => None,
        });
        let is_meant = |(quantity, value): &(Symbol, Symbol)| {
            let is_gone = !names.contains(quantity) && !names.contains(value);
            is_gone && is_spoken_of(quantity) && !is_spoken_of(value)
        };
        let mut special = special.filter(is_meant);
        let (Some((quantity, value)), None) = (special.next(), special.next()) else {
            return Vec::new();
        };
        let [others, _] = self.others(premises);
        let open = self.open_before(premises);
        let all = || others.iter().chain(&open);
        let Some(meaning) = all().find(|own| own.is_of(&value)) else {
            return Vec::new();
        };
        let of_chain = all().filter(|own| own.source == meaning.source).cloned();
        let mut all = vec![taken(&Formula::same(&quantity, &value))];
        join(of_chain, &mut all);
        all
    }

    /// Whether the step follows from `all`: what it may be taken from, with what the words before it name.
    pub(in crate::audit) fn follows_from_words(
        &self,
        goal: &Goal,
        all: &[Assumed],
        premises: &[usize],
        found: &mut Found,
    ) -> bool {
        // What is told of a case in passing has been tried, and nothing is put under more conditions for it.
        let own = &self.derivation.equations[self.at];
        let is_tried = |assumed: &Assumed| match assumed.source {
            Source::Local(page, at) => {
                let passing = own.told.contains(&at) && !own.named.contains(&at);
                passing && self.derivation.local(page, at).is_case()
            }
            _ => false,
        };
        let mut all = all.to_vec();
        all.retain(|own| !is_tried(own));
        let follows = self.holds_under(goal, all.clone(), &[], Effort::Light, found)
            || {
                let attempts = self.attempts(goal, &all, premises, None);
                self.rescue(goal, &attempts, &NEARBY, found)
            }
            || self.under_conditions(goal, all.clone(), None, (false, Effort::Light), found)
            // What is the first to speak of something may rather say what that is.
            || goal.formula.names().is_disjoint(&own.introduces)
                && self.follows_with_others(goal, &all, premises, Effort::Light, found);
        if follows {
            found.may_follow = true;
        }
        follows
    }

    /// Leaves open what was refuted as if something were so at one point alone, or for one element, of which the words may say it for all:
    /// "With $x = t^3$", where a slope of `x` is taken, and "If all are equal, $m_i = m$".
    pub(in crate::audit) fn heed_what_is_said_of_all(
        &self,
        goal: &Goal,
        all: &[Assumed],
        found: &mut Found,
    ) {
        if !found.judged.outcome.is_refuted() {
            return;
        }
        if speaks_of_elements(all, goal) {
            found.leave_open(super::ELEMENT);
            return;
        }
        // Of what is put in for `y` the slope of `x` is taken, too; that it is a slope itself, `\tau = -\mu \frac{du}{dr}`, is none of those.
        let is_slope = |law: &Formula, symbol: &Symbol, value: &Expr| {
            let takes = |part: &Expr| match part {
                Expr::Derivative { variable, .. } => variable != symbol && value.mentions(variable),
                _ => false,
            };
            let formulas = all.iter().map(|own| &*own.formula);
            let mut formulas = formulas.filter(|own| *own != law).chain([&goal.formula]);
            formulas.any(|own| own.terms().into_iter().any(|term| term.any(&takes)))
        };
        let mut put = all.iter().filter(|own| {
            matches!(own.source, Source::Local(..)) && own.standing == Standing::AtPoint
        });
        let moving = put.find(|own| match own.formula.as_equation() {
            Some((Expr::Symbol(symbol), value)) => is_slope(&own.formula, symbol, value),
            _ => false,
        });
        if let Some(own) = moving {
            found.leave_open(format!(
                "it may follow where `{}` is so throughout, and nothing says that it is",
                plain_formula(&own.formula)
            ));
        }
    }

    /// Refutes a step where what the words name is so, too, and says from what; returns whether that was found.
    pub(in crate::audit) fn heed_what_is_named(
        &self,
        goal: &Goal,
        all: &[Assumed],
        found: &mut Found,
    ) -> bool {
        let Some(decision) = self.decide_from(all, &goal.formula) else {
            return true;
        };
        let mut all = all.to_vec();
        let decision = match decision {
            Decision::Open(_) if self.leave_out_what_follows(&mut all) => {
                self.decide_from(&all, &goal.formula)
            }
            decision => Some(decision),
        };
        match decision {
            Some(Decision::Refuted(refuted)) if !speaks_of_elements(&all, goal) => {
                found.judged.outcome = Outcome::Refuted(refuted.into());
                found.judged.assumed = all;
                true
            }
            _ => false,
        }
    }

    /// Leaves out one of what words say that follows from the rest of it, and stands in the way of a point: "when $\cos x = -1$, that is
    /// $x = \pi$". Gives whether there is one.
    fn leave_out_what_follows(&self, all: &mut Vec<Assumed>) -> bool {
        let is_said = |own: &Assumed| matches!(own.source, Source::Local(..));
        let said: Vec<Assumed> = all.iter().filter(|own| is_said(own)).cloned().collect();
        let follows = |own: &&Assumed| {
            let rest: Vec<Assumed> = said.iter().filter(|other| other != own).cloned().collect();
            let decision = self.decide_from(&rest, &own.formula);
            matches!(decision, Some(Decision::Proven { .. }))
        };
        let followed = (2..=MOST_SAID)
            .contains(&said.len())
            .then(|| said.iter().find(follows));
        let Some(followed) = followed.flatten() else {
            return false;
        };
        all.retain(|own| own != followed);
        true
    }
}

/// Whether a step still speaks of a symbol that is given a value, and of what it is said to be.
fn leaves(named: &Formula, names: &Set<Symbol>) -> bool {
    match named.as_equation() {
        Some((Expr::Symbol(symbol), Expr::Number(_))) => names.contains(symbol),
        Some((Expr::Symbol(symbol), Expr::Symbol(value))) => {
            names.contains(symbol) && names.contains(value)
        }
        _ => false,
    }
}

/// Whether the text tells something of an element whose index runs, `a_i = a`, and equations speak of the sequence: it is said of all.
pub(in crate::audit) fn speaks_of_elements(all: &[Assumed], goal: &Goal) -> bool {
    let is_local = |own: &&Assumed| matches!(own.source, Source::Local(..));
    let formulas = all.iter().map(|own| &*own.formula);
    let sequences: Set<Symbol> = formulas
        .chain([&goal.formula])
        .flat_map(Formula::sequences)
        .collect();
    let names: Set<Symbol> = all
        .iter()
        .filter(|own| !is_local(own))
        .flat_map(|own| own.formula.names())
        .collect();
    // `m_i` of `m_1`, `m_2` and `m_3`.
    let is_numbered = |stem: &str| {
        names.iter().any(|own| {
            let parts = split_subscript(own.name());
            parts.is_some_and(|(other, index)| other == stem && index.parse::<u32>().is_ok())
        })
    };
    let is_element = |symbol: &Symbol| {
        let parts = split_subscript(symbol.name());
        parts.is_some_and(|(stem, index)| {
            Symbol::new(index).can_be_index()
                && (sequences.contains(&Symbol::new(stem)) || is_numbered(stem))
        })
    };
    let mut told = all.iter().filter(is_local);
    told.any(|own| own.formula.names().iter().any(is_element))
}
