//! A step tried again with what stands before, the nearest first.

use std::cell::OnceCell;
use std::rc::Rc;

use crate::algebra::{Expr, Formula};
use crate::derivation::{Assumed, Goal, Source};
use crate::kernel::{Assignment, Obligation, Proven};
use crate::search::{self, Effort};
use crate::sorted::Set;

use super::super::Outcome;
use super::super::judge::{Found, Judge, NEARBY, condition, sources};
use super::borrowed::speaks_of_all;
use super::conditions::collect_divisors;

/// What a step that does not follow from what it cites may be tried with.
pub(in crate::audit) struct Attempt {
    cited: Vec<Assumed>,
    /// The likeliest first.
    others: Vec<Assumed>,
    pub(super) witness: Option<Assignment>,
    whole: OnceCell<Whole>,
}

/// The goal from all that a step may be tried with.
enum Whole {
    Posed(Rc<Obligation>),
    /// The kernel cannot read it.
    Unread,
    /// All of it is true somewhere where the goal is not, so that no part of it will do.
    Doomed,
}

impl Judge<'_> {
    /// What a step that does not follow may be tried with: what is cited, and what is not but stands before.
    /// The witness against it may stand against all of these too.
    pub(in crate::audit) fn attempts(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        premises: &[usize],
        witness: Option<Assignment>,
    ) -> Vec<Attempt> {
        let others = self.others(premises);
        self.attempts_with(goal, assumed, premises, witness, others)
    }

    fn attempts_with(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        premises: &[usize],
        witness: Option<Assignment>,
        others: &[Vec<Assumed>],
    ) -> Vec<Attempt> {
        let mut attempts = Vec::new();
        let failing = self.failing(premises);
        let sound = self.sound(assumed, &failing);
        let against = self.refuted_from(&failing);
        for others in others {
            if others.is_empty() || !speaks_of_all(assumed.iter().chain(others), &goal.formula) {
                continue;
            }
            // Together with what it was refuted from, what fails would prove nearly anything.
            let mut harmless = others.clone();
            harmless.retain(|own| !against.contains(&own.source));
            let mut choices = Vec::new();
            if sound.len() < assumed.len() {
                choices.push((sound.clone(), others.clone()));
            }
            if !harmless.is_empty() {
                choices.push((assumed.to_vec(), harmless));
            }
            attempts.extend(choices.into_iter().map(|(cited, others)| Attempt {
                cited,
                others,
                witness: witness.clone(),
                whole: OnceCell::new(),
            }));
        }
        attempts
    }

    /// The goal from all of an attempt, once it is asked for.
    fn whole<'a>(&self, goal: &Goal, attempt: &'a Attempt) -> &'a Whole {
        attempt.whole.get_or_init(|| {
            let Attempt { cited, others, .. } = attempt;
            let all: Vec<Assumed> = cited.iter().chain(others).cloned().collect();
            let Ok(posed) = self.pose(&all, &goal.formula) else {
                return Whole::Unread;
            };
            let known = self.auditor.hints();
            match search::is_doomed(&posed, attempt.witness.iter().chain(&*known)) {
                true => Whole::Doomed,
                false => Whole::Posed(posed),
            }
        })
    }

    /// Tries again with what stands before, cited or not.
    pub(in crate::audit) fn rescue(
        &self,
        goal: &Goal,
        attempts: &[Attempt],
        stages: &[(usize, Effort)],
        found: &mut Found,
    ) -> bool {
        for attempt in attempts {
            let Attempt { cited, others, .. } = attempt;
            let mut last = None;
            for (stage, &(most, effort)) in stages.iter().enumerate() {
                // Where there are no more of them, the same would be tried again.
                let most = most.min(others.len());
                if last.replace((most, effort)) == Some((most, effort)) {
                    continue;
                }
                // To try the nearest is less work than to look at all of them.
                let looked_at = attempt.whole.get().is_some();
                let is_few = stage == 0 && most < others.len();
                if (looked_at || !is_few) && matches!(self.whole(goal, attempt), Whole::Doomed) {
                    break;
                }
                let near = others.iter().take(most);
                let all: Vec<Assumed> = cited.iter().chain(near).cloned().collect();
                let posed = match most < others.len() {
                    true => self.pose(&all, &goal.formula).ok(),
                    false => match self.whole(goal, attempt) {
                        Whole::Posed(posed) => Some(Rc::clone(posed)),
                        _ => None,
                    },
                };
                let Some(posed) = posed else {
                    continue;
                };
                let Some(derived) = search::prove_posed(&posed, effort) else {
                    continue;
                };
                let cited = cited.len();
                let (mut kept, mut least) = self.least_borrowed(all, cited, goal, &posed, derived);
                if self.is_contradictory(&kept, goal) {
                    continue;
                }
                if let Some(own) = self.kept_from_vanishing(goal, &attempt.cited, &kept) {
                    (kept, least) = own;
                    found.may_follow = true;
                }
                let from = sources(&kept);
                if let Some(reason) = self.in_other_letters(&from) {
                    found.leave_open(reason);
                    return true;
                }
                found.instead = from;
                found.conditions.clear();
                found.judged.assumed = kept;
                found.judged.outcome = Outcome::Proven(least.into());
                return true;
            }
        }
        false
    }

    /// A step that follows from what it cites as long as something does not vanish by which an equation that it does not cite divides. It
    /// could be said to follow from that equation in the place of what it cites, but no reader would.
    fn kept_from_vanishing(
        &self,
        goal: &Goal,
        cited: &[Assumed],
        kept: &[Assumed],
    ) -> Option<(Vec<Assumed>, Proven)> {
        if !self.names_its_premises() {
            return None;
        }
        let is_cited = |own: &&Assumed| cited.iter().any(|other| other.source == own.source);
        let (_, borrowed): (Vec<&Assumed>, Vec<&Assumed>) = kept.iter().partition(is_cited);
        let mut divisors = Vec::new();
        for own in &borrowed {
            own.formula
                .terms()
                .into_iter()
                .for_each(|term| collect_divisors(term, &mut divisors));
        }
        if divisors.is_empty() {
            return None;
        }
        let factors = divisors.into_iter().flat_map(|own| match own {
            Expr::Product(factors) => factors.to_vec(),
            own => vec![own],
        });
        let conditions = factors.map(|own| condition(&Formula::nonzero(own)));
        let divided: Vec<Assumed> = cited.iter().cloned().chain(conditions).collect();
        let posed = self.pose(&divided, &goal.formula).ok()?;
        search::prove_posed(&posed, Effort::Light)?;
        let mut all: Vec<Assumed> = cited.to_vec();
        all.extend(borrowed.into_iter().cloned());
        let posed = self.pose(&all, &goal.formula).ok()?;
        let derived = search::prove_posed(&posed, Effort::Light)?;
        Some((all, derived.proven))
    }

    /// An equation of a section above that speaks of a letter which the section of this one introduces anew.
    fn in_other_letters(&self, sources: &[Source]) -> Option<String> {
        let own = &self.derivation.equations[self.at];
        if own.anew.is_empty() {
            return None;
        }
        let start = self.derivation.section_start(self.at);
        let (cited, ..) = self.derivation.premises(self.at);
        let mut above = sources.iter().filter_map(|source| match *source {
            Source::Equation(other) if other < start => Some(other),
            _ => None,
        });
        let letter = above.find_map(|other| {
            let spoken_of = self.derivation.equations[other].symbols();
            let mut anew = own.anew.iter().filter(|_| !cited.contains(&other));
            anew.find(|&letter| spoken_of.contains(letter))
        })?;
        Some(format!(
            "it follows from what stands above, where `{letter}` may mean something else"
        ))
    }

    /// Tries a step again from some equations before.
    pub(super) fn rescue_from(
        &self,
        open: &[usize],
        goal: &Goal,
        assumed: &[Assumed],
        premises: &[usize],
        found: &mut Found,
    ) -> bool {
        if open.is_empty() {
            return false;
        }
        let open = [self.gathered(open)];
        let attempts = self.attempts_with(goal, assumed, premises, None, &open);
        self.rescue(goal, &attempts, &NEARBY, found)
    }

    /// Tries a step that is not proved from what is itself left open, or holds under conditions.
    pub(in crate::audit) fn rescue_from_open(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        premises: &[usize],
        found: &mut Found,
    ) -> bool {
        let open = self.open_on_this_page(premises);
        self.rescue_from(&open, goal, assumed, premises, found)
    }

    /// Tries a step that does not follow from what it says it does with what stands before under conditions, where no directive says what
    /// follows from what: "Expressed by the frequency, the energy (5) becomes" goes on from what the frequency is, too.
    pub(in crate::audit) fn rescue_from_conditional(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        premises: &[usize],
        found: &mut Found,
    ) -> bool {
        if self.is_directed() || !self.failing(premises).is_empty() {
            return false;
        }
        let mut conditional = self.open_on_this_page(premises);
        conditional.retain(|&own| {
            let on = self.auditor.unproved(self.at, &Set::from([own]));
            !self.is_undecided(own) && !on.iter().any(|&other| self.is_undecided(other))
        });
        // So does what speaks of some symbol on which what is cited is silent.
        let mut silent = goal.formula.names();
        silent.retain(|own| !own.is_unit());
        for cited in assumed.iter().filter(|own| !own.source.is_of_statement()) {
            let spoken_of = cited.formula.names();
            silent.retain(|own| !spoken_of.contains(own));
        }
        let speaks = |own: &&usize| {
            let mut all = self.derivation.equations[**own].symbols().into_iter();
            self.is_on_this_page(**own) && all.any(|symbol| silent.contains(&symbol))
        };
        conditional.extend(self.before(premises).sound.iter().filter(speaks));
        let with = || {
            let near = self.gathered(&conditional).into_iter();
            let all = assumed.iter().cloned().chain(near.take(NEARBY[1].0));
            all.collect::<Vec<_>>()
        };
        self.rescue_from(&conditional, goal, assumed, premises, found)
            || !conditional.is_empty()
                && (self.follows_with(&conditional, goal, assumed, found)
                    || self.follows_where_positive(goal, &with(), false, found))
    }

    /// The same, where symbols that could be anything are not 0.
    pub(in crate::audit) fn follows_from_open(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        premises: &[usize],
        found: &mut Found,
    ) -> bool {
        // From what fails anything may follow, if only hard enough is tried.
        if !self.failing(premises).is_empty() {
            return false;
        }
        let open = self.open_on_this_page(premises);
        if open.is_empty() {
            return false;
        }
        self.follows_with(&open, goal, assumed, found)
    }

    /// Whether a step follows with some equations before, where symbols that could be anything are not 0.
    pub(super) fn follows_with(
        &self,
        equations: &[usize],
        goal: &Goal,
        assumed: &[Assumed],
        found: &mut Found,
    ) -> bool {
        let near = self.gathered(equations);
        let is_told = |own: &Assumed| matches!(own.source, Source::Local(..));
        let mut follows = |others: Vec<Assumed>| {
            let near = others.into_iter().take(NEARBY[1].0);
            let all = assumed.iter().cloned().chain(near).collect();
            self.under_conditions(goal, all, None, (true, Effort::Light), found)
        };
        let mut stated = near.clone();
        stated.retain(|own| !is_told(own));
        // Whether signs can be as they are meant may be hard to see beside what the text tells: `x = A \cos\omega t`.
        let some = stated.len() < near.len();
        follows(near) || some && follows(stated)
    }
}
