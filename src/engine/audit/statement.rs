//! One statement judged from what it may use: its links one after another, and what they come to together.

use crate::algebra::{Expr, Formula, Symbol, effort};
use crate::derivation::{Assumed, Beyond, Equation, Goal, Kind, Source, goals};
use crate::document::Span;
use crate::kernel::Standing;
use crate::notation::{Connective, Statement};
use crate::search::{self, Consistency, Decision};
use crate::sorted::Set;

use super::again::UNSAID;
use super::again::there::There;
use super::again::vanishing_there::is_of_zero;
use super::entry::{blank, leave_open, verdict};
use super::judge::{Found, Judge, UNCLEAR, beyond};
use super::mark::mark;
use super::premise::Usable;
use super::readings::Circumstances;
use super::{Auditor, Entry, Judged, Note, Outcome, Verdict, numeric, stated};

/// How many earlier steps of its statement a step may use, the last ones.
const MOST_STEPS: usize = 64;
/// So far back is looked for displays that could not be read and speak of something in a step that fails.
const MOST_BEFORE: usize = 64;

/// Why nothing is proved from figures that are rounded, where they do not agree.
const FIGURES: &str = "the figures before it are rounded, and not all can be exact";

/// Why nothing is proved from what words say and displays do not agree with.
const TOLD: &str =
    "what the text says before it does not agree with what it cites, as far as it is understood";

/// What was found of the links of a statement besides what is said of each.
#[derive(Default)]
struct Links {
    /// What those that come later may use, with its clause.
    steps: Vec<(usize, Formula)>,
    /// What they follow from, where that is not what is cited.
    instead: Set<Source>,
    may_follow: bool,
    /// The conditions under which some were proved.
    conditions: Vec<Formula>,
    /// What would be a definition follows from what stands before, or what follows there is something else.
    shown: bool,
    contradicted: bool,
}

impl Auditor<'_> {
    pub(super) fn statement(&self, statement: &Statement, how: &Circumstances) -> Entry {
        let &Circumstances { at, usable, .. } = how;
        let equation = &self.derivation.equations[at];
        let mut entry = blank(at, 0, 1, equation.kind, Verdict::Holds);
        let judge = Judge::new(self, at, usable);
        let links = self.links(&judge, statement, how, &mut entry);
        stated::leave_condition(&mut entry, equation);
        entry.verdict = verdict(&entry.judged);
        if entry.verdict == Verdict::Fails {
            // With what another link needs the one that fails does not follow.
            entry.notes.retain(|note| match note {
                Note::UnstatedCondition(told) => {
                    !told.iter().all(|own| links.conditions.contains(own))
                }
                _ => true,
            });
        }
        self.weigh_rounded(&judge, how.premises, &mut entry);
        if matches!(entry.verdict, Verdict::Fails | Verdict::Undecided)
            && !links.contradicted
            && !is_refuted_by_propagation(&entry)
            && let Some(symbols) = judge.stated(&entry)
        {
            if entry.numeric.is_none() {
                return stated::given(entry, symbols);
            }
            // What might be a law, but for the figures that speak against it.
            if entry.verdict == Verdict::Fails {
                numeric::open_by_figures(&mut entry);
            }
        }
        if entry.verdict == Verdict::Given {
            entry.kind = Kind::Given;
            let unchecked = (!links.shown).then(|| judge.unchecked(&entry));
            entry.notes.extend(unchecked.flatten());
        }
        let used = used(&entry);
        if entry.verdict == Verdict::Holds && how.premises.iter().all(|own| !used.contains(own)) {
            entry.notes.extend(judge.begins_unchecked(&entry));
        }
        if !links.instead.is_empty() {
            entry.notes.push(self.instead(how, links, &used));
        }
        if how.says_so && (entry.verdict != Verdict::Holds || !entry.notes.is_empty()) {
            let missing = usable.out_of_scope.iter();
            entry.notes.extend(missing.map(|&p| Note::OutOfScope(p)));
        }
        self.open_in_doubt(equation, usable, &mut entry);
        if entry.verdict == Verdict::Undecided {
            if !usable.unreadable.is_empty() {
                let unreadable = usable.unreadable.clone();
                entry.notes.push(Note::UnreadablePremise(unreadable));
            }
            let numeric = self.concerned(entry.judged.iter(), &usable.numeric);
            if !numeric.is_empty() && entry.numeric.is_none() {
                entry.notes.push(Note::RestsOnUnproved(numeric));
            }
        }
        entry.premises = used.iter().copied().collect();
        if entry.verdict == Verdict::Holds {
            entry.rests_on = self.failing(at, &used);
            if !entry.rests_on.is_empty() {
                entry.notes.insert(0, Note::RestsOn(entry.rests_on.clone()));
            }
            let mut open = self.unproved(at, &used);
            open.retain(|premise| !entry.rests_on.contains(premise));
            if !open.is_empty() {
                entry.notes.push(Note::RestsOnUnproved(open));
            }
        }
        mark(statement, &mut entry);
        entry
    }

    /// Judges the links of a statement, one after another.
    fn links(
        &self,
        judge: &Judge,
        statement: &Statement,
        how: &Circumstances,
        entry: &mut Entry,
    ) -> Links {
        let mut links = Links::default();
        for (position, goal) in goals(statement).into_iter().enumerate() {
            if position == 0
                && let Some(found) = self.begun(judge, &goal, how, &mut links)
            {
                links.steps.push((goal.clause, goal.formula));
                self.take_up(found, &mut links, entry);
                continue;
            }
            let recent = &links.steps[links.steps.len().saturating_sub(MOST_STEPS)..];
            let mut found = judge.goal(&goal, recent, how.premises);
            if effort::is_spent()
                && !found.judged.outcome.is_proven()
                && let Some(identity) = judge.as_identity(&goal)
            {
                found = identity;
            }
            if !found.judged.outcome.is_proven()
                && let Some(concluded) = judge.as_concluded(&goal, recent, how.premises)
            {
                found = concluded;
            }
            if !found.judged.outcome.is_proven()
                && is_set_out_from(statement, &goal)
                && (is_put_to_nought(statement, &goal)
                    || judge.sets_out() && !goal.formula.speaks_of_slopes())
                && !is_stationary(&found.judged)
                && !(found.judged.outcome.is_refuted()
                    && found.mended.is_some()
                    && !entry.judged.is_empty())
            {
                found = Found::open(Judged {
                    goal: goal.clone(),
                    assumed: Vec::new(),
                    outcome: Outcome::Stated,
                });
            }
            // "$1 - u^2/c^2 = … \ge 0$": of what nothing before speaks, nobody says where it lies either.
            let was_unsaid = entry.judged.last().is_some_and(
                |own| matches!(&own.outcome, Outcome::Open(stop) if stop.reason == UNSAID),
            );
            if was_unsaid
                && goal.formula.as_equation().is_none()
                && found.judged.outcome.is_refuted()
                && found.mended.is_none()
            {
                found.leave_open(UNSAID);
            }
            // The next clause of an implication is judged as if this one were true.
            let goes_on = found.judged.outcome.is_proven() || statement.clauses.len() > 1;
            if goes_on && goal.suppositions.is_empty() {
                links.steps.push((goal.clause, goal.formula));
            }
            self.take_up(found, &mut links, entry);
        }
        links
    }

    /// Why premises of loose prose that contradict one another may agree as they are meant.
    fn may_agree(&self, at: usize, contradictory: &[Source]) -> Option<&'static str> {
        let page = &self.derivation.pages[self.derivation.equations[at].page];
        let is_told = |own: &Source| matches!(own, Source::Local(..));
        match contradictory {
            _ if page.directs => None,
            all if all.iter().any(|own| self.is_rounded(own)) => Some(FIGURES),
            all if all.iter().any(is_told) => Some(TOLD),
            _ => None,
        }
    }

    /// Whether a premise ends in a number that is rounded.
    fn is_rounded(&self, source: &Source) -> bool {
        let Source::Equation(premise) = *source else {
            return false;
        };
        let mut said = self.derivation.equations[premise].statements().iter();
        said.any(|own| goals(own).iter().any(|goal| goal.rounding.is_some()))
    }

    /// What is found of a first link that defines something, or would if what stands before did not say what that is; nothing of others.
    fn begun(
        &self,
        judge: &Judge,
        goal: &Goal,
        how: &Circumstances,
        links: &mut Links,
    ) -> Option<Found> {
        let instance = || judge.as_instance(goal, how.premises);
        if let Some(found) = how.defines.then(instance).flatten() {
            return Some(found);
        }
        if how.defines
            && let Some(found) = judge
                .as_no_solution(goal, how.premises, None)
                .or_else(|| judge.as_no_root(goal, how.premises))
                .or_else(|| judge.as_no_root_of_system(goal, how.premises))
                .or_else(|| judge.as_no_integral(goal))
                .or_else(|| judge.as_no_integral_of_law(goal, how.premises))
                .or_else(|| judge.as_no_value_at_a_place(goal, how.premises))
                .or_else(|| {
                    let found = judge.as_no_frequency(goal, how.premises);
                    found.filter(|own| own.judged.outcome.is_refuted())
                })
                .or_else(|| judge.as_no_zero(goal))
        {
            links.contradicted = true;
            return Some(found);
        }
        let there = judge.as_value_there(goal, how.premises, how.defines);
        let solved = || judge.as_solved(goal, how.premises);
        let worded = || judge.as_term_in_words(goal, how.premises);
        let there = there
            .or_else(|| how.defines.then(solved).flatten())
            .or_else(|| how.defines.then(worded).flatten());
        match there {
            Some(There::Solved(found)) => Some(*found),
            Some(There::Refuted(found)) => {
                links.contradicted = true;
                Some(*found)
            }
            Some(There::Shown) if names_a_symbol(&goal.formula) => {
                links.shown = true;
                Some(self.defined(goal, how))
            }
            None | Some(There::Shown) => how.defines.then(|| self.defined(goal, how)),
        }
    }

    /// The first link of what defines something.
    fn defined(&self, goal: &Goal, how: &Circumstances) -> Found {
        // What could not be read may have spoken of it: then it is no definition.
        let is_drawn = self.derivation.equations[how.at].drawn;
        let outcome = match is_drawn && !how.usable.unreadable.is_empty() {
            true => Outcome::open("it is said to follow from what could not be read"),
            false => Outcome::Defined,
        };
        Found::open(Judged {
            goal: goal.clone(),
            assumed: Vec::new(),
            outcome,
        })
    }

    /// Enters what was found of a link.
    fn take_up(&self, mut found: Found, links: &mut Links, entry: &mut Entry) {
        if !found.constant.is_empty() {
            entry.takes_as_constant(found.constant);
        }
        let (still, mut conditions): (Vec<Formula>, _) =
            found.conditions.into_iter().partition(stated::stands_still);
        match stated::constants(&found.judged, &still) {
            Some(symbols) if !self.says_otherwise(entry.equation, &still) => {
                entry.takes_as_constant(symbols);
            }
            _ => conditions.extend(still),
        }
        // Links of a chain may need the same.
        let told = |own: &Formula| {
            let mut notes = entry.notes.iter();
            notes.any(|note| matches!(note, Note::UnstatedCondition(told) if told.contains(own)))
        };
        conditions.retain(|own| !told(own));
        let all = std::mem::take(&mut conditions);
        for own in all {
            if !conditions.contains(&own) {
                conditions.push(own);
            }
        }
        if !conditions.is_empty() {
            if found.judged.outcome.is_proven() {
                links.conditions.extend(conditions.iter().cloned());
            }
            entry.notes.push(Note::UnstatedCondition(conditions));
        }
        // A contradiction that was looked for is no fault.
        let sought = |own: &Source| match own {
            Source::Local(page, local) => self.derivation.local(*page, *local).is_contrary,
            _ => false,
        };
        // Nor are figures one that are rounded, and do not agree to the last digit; nor what the words of loose prose say, and may say of
        // something else.
        if let Some(reason) = self.may_agree(entry.equation, &found.contradictory) {
            found.contradictory.clear();
            if let Outcome::Open(stop) = &mut found.judged.outcome {
                stop.reason = reason.to_owned();
            }
        }
        if !found.contradictory.is_empty() && !found.contradictory.iter().any(sought) {
            let contradictory = Note::InconsistentPremises(found.contradictory);
            entry.notes.push(contradictory);
        }
        links.instead.extend(found.instead);
        links.may_follow |= found.may_follow;
        if entry.implied.is_none() && entry.mended.is_none() {
            (entry.implied, entry.mended) = (found.implied, found.mended);
            entry.missing = found.missing;
        }
        entry.judged.push(found.judged);
    }

    /// What to say of a step that does not follow from what is cited, but from something else.
    fn instead(&self, how: &Circumstances, links: Links, used: &Set<usize>) -> Note {
        let mut instead = links.instead;
        // A link of a chain may need what another does not.
        instead.extend(used.iter().map(|&premise| Source::Equation(premise)));
        let cites = how.says_so && !how.premises.is_empty() && !links.may_follow;
        match cites && !self.goes_on(how.at, how.premises, &instead) {
            true => Note::Miscited {
                cited: how.premises.to_vec(),
                instead: instead.into_iter().collect(),
            },
            false => Note::Uncited(instead.into_iter().collect()),
        }
    }

    /// The premises among some that speak of a symbol in what is judged.
    pub(super) fn concerned<'a>(
        &self,
        judged: impl Iterator<Item = &'a Judged>,
        premises: &[usize],
    ) -> Vec<usize> {
        let mut names: Set<Symbol> = judged.flat_map(|own| own.goal.formula.names()).collect();
        names.retain(|own| !own.is_unit());
        let speaks = |own: &usize| {
            !self.derivation.equations[*own]
                .symbols()
                .is_disjoint(&names)
        };
        premises.iter().copied().filter(speaks).collect()
    }

    /// Leaves open what fails where a premise could not be had that may be just what is needed.
    fn open_in_doubt(&self, equation: &Equation, usable: &Usable, entry: &mut Entry) {
        // What an approximation says is worked out from what it is taken from alone.
        if (entry.refuted()).is_some_and(|(own, _)| own.is_expanded()) {
            return;
        }
        // Figures say nothing of what they do not speak of.
        let refuted = entry.judged.iter().filter(|own| own.outcome.is_refuted());
        let numeric = self.concerned(refuted, &usable.numeric);
        // What is one slip away from what follows says no more than that, whatever could not be read.
        let unreadable = match entry.mended {
            Some(_) => &Vec::new(),
            None => &usable.unreadable,
        };
        let missing = [unreadable, &usable.later, &numeric, &usable.in_limit];
        let missing = missing.into_iter().any(|premises| !premises.is_empty());
        if entry.verdict == Verdict::Fails && missing {
            match entry.numeric {
                Some(_) => numeric::open_by_figures(entry),
                None => entry.verdict = Verdict::Undecided,
            }
        }
        if entry.verdict == Verdict::Fails
            && !equation.unread.is_empty()
            && !self.only_says_where_it_begins(equation, entry)
            && !only_says_what_vanishes(equation, entry)
        {
            leave_open(entry, &self.unread(equation));
        }
        if entry.verdict == Verdict::Fails
            && entry.mended.is_none()
            && let Some(symbol) = self.spoken_of_unreadably(equation, entry)
        {
            let reason = format!(
                "of `{symbol}` something is said before that could not be read, and nothing else"
            );
            leave_open(entry, &reason);
        }
        if entry.verdict == Verdict::Fails
            && equation.puts_condition
            && speaks_first(equation, entry)
        {
            let reason =
                "it is said under a condition in words, and nothing before speaks of all of it";
            leave_open(entry, reason);
        }
        if entry.verdict == Verdict::Fails && self.may_need_another_case(usable, equation, entry) {
            leave_open(
                entry,
                "it may follow from what it cites and is derived for a case",
            );
        }
        // Nor does what is said of complex numbers say anything of a slip in real ones.
        if entry.verdict == Verdict::Fails
            && let Some(own) = usable.beyond
            && !(own == Beyond::Complex && entry.mended.is_some())
        {
            leave_open(entry, beyond(own));
        }
        if entry.verdict == Verdict::Fails && usable.has_presumed {
            leave_open(entry, UNCLEAR);
        }
    }

    /// A symbol of which what is refuted is the first to speak readably, and a display before on the page that could not be read speaks, too.
    fn spoken_of_unreadably(&self, equation: &Equation, entry: &Entry) -> Option<Symbol> {
        let source = &self.derivation.pages[equation.page].document.source;
        let start = self.derivation.equations_of(equation.page).start;
        let before = start.max(entry.equation.saturating_sub(MOST_BEFORE))..entry.equation;
        let before = self.derivation.equations[before].iter();
        let unread: Vec<&Equation> = before.filter(|other| other.statements.is_err()).collect();
        if unread.is_empty() {
            return None;
        }
        let refuted = entry.judged.iter().filter(|own| own.outcome.is_refuted());
        let names: Set<Symbol> = refuted.flat_map(|own| own.goal.formula.names()).collect();
        let is_spoken_of = |own: &Symbol| {
            let mut all = unread
                .iter()
                .filter_map(|other| source.get(other.body.range()));
            all.any(|text| stands_in(own.name(), text))
        };
        let is_read = |own: &Symbol| self.derivation.is_spoken_of_before(entry.equation, own);
        let mut names = names.into_iter();
        names.find(|own| is_spoken_of(own) && !is_read(own))
    }

    /// Whether nothing refutes a step with what it cites and is derived for a case that is not in effect here. Directives say which it is
    /// that is meant.
    fn may_need_another_case(&self, usable: &Usable, equation: &Equation, entry: &Entry) -> bool {
        let at = entry.equation;
        let left = |premise: &usize| {
            let offer = self.offer(at, *premise);
            let mut under = offer.iter().flat_map(|own| &own.under);
            under.any(|&own| self.derivation.is_left_in_words(at, own))
        };
        let for_all = |own: &Statement| !own.quantified.is_empty();
        if usable.out_of_scope.is_empty()
            || equation.statements().iter().any(for_all)
            || self.derivation.pages[equation.page].directs
            || usable.out_of_scope.iter().all(left)
        {
            return false;
        }
        let mut refuted = entry.judged.iter().filter(|own| own.outcome.is_refuted());
        refuted.any(|judged| {
            let mut all = judged.assumed.clone();
            all.extend(self.of_other_cases(at, usable));
            let claim = self.derivation.claim(at, &all, &judged.goal.formula);
            let Ok(posed) = search::pose(claim) else {
                return true;
            };
            let together = search::consistency_posed(&posed, &self.hints());
            if matches!(together, Consistency::Contradictory(_)) {
                return false;
            }
            let decision = search::decide_within(&posed, &self.hints(), None);
            !matches!(decision, Decision::Refuted(_))
        })
    }

    /// What a step cites that is derived for cases which are not in effect here, with these.
    pub(super) fn of_other_cases(&self, at: usize, usable: &Usable) -> Vec<Assumed> {
        let offers = usable.out_of_scope.iter();
        let offers = offers.filter_map(|&own| Some((own, self.offer(at, own)?)));
        let all = offers.flat_map(|(premise, offer)| {
            let said = offer.formulas.iter().map(move |formula| Assumed {
                formula: formula.clone(),
                standing: Standing::AtPoint,
                source: Source::Equation(premise),
            });
            let cases = offer.under.iter().flat_map(|&(page, local)| {
                let formulas = self.derivation.local(page, local).formulas.iter();
                formulas.map(move |formula| Assumed {
                    formula: formula.clone(),
                    standing: Standing::AtPoint,
                    source: Source::Local(page, local),
                })
            });
            said.chain(cases)
        });
        all.collect()
    }

    /// Whether what was not understood only says where something begins that does not obey its law: "At the clamp both $w$ and $w'$ vanish".
    fn only_says_where_it_begins(&self, equation: &Equation, entry: &Entry) -> bool {
        const VANISHING: [&str; 3] = ["vanish", "vanishes", "zero"];
        let refuted = entry.refuted().map(|own| own.0);
        let Some(refuted) = refuted.filter(|own| own.solution().is_some()) else {
            return false;
        };
        let moved = Formula::differentiated_in([&refuted.goal.formula].into_iter());
        let source = &self.derivation.pages[equation.page].document.source;
        let is_of_it = |name: &str| {
            let name = name.trim().trim_end_matches('\'');
            moved.iter().any(|own| own.name() == name)
        };
        let begins = |said: &Span| {
            let text = source.get(said.range()).unwrap_or_default();
            let pieces: Vec<&str> = text.split('$').collect();
            let mut words = pieces.iter().step_by(2).flat_map(|own| own.split(' '));
            let mut formulas = pieces.iter().skip(1).step_by(2);
            formulas.all(|own| is_of_it(own)) && words.any(|own| VANISHING.contains(&own))
        };
        equation.unread.iter().all(begins)
    }

    /// What is supposed before an equation and could not be read.
    fn unread(&self, equation: &Equation) -> String {
        let source = &self.derivation.pages[equation.page].document.source;
        let unread = equation
            .unread
            .iter()
            .filter_map(|own| source.get(own.range()));
        let unread: Vec<String> = unread.map(|own| format!("`{}`", own.trim())).collect();
        format!(
            "what is supposed before it is not understood: {}",
            unread.join(", ")
        )
    }
}

/// Whether what was not understood only says what vanishes where a step has a name for that: "when the reactance vanishes".
fn only_says_what_vanishes(equation: &Equation, entry: &Entry) -> bool {
    let refuted = entry.refuted().map(|own| own.0);
    equation.unread.len() == 1 && refuted.is_some_and(is_of_zero)
}

/// Whether something is judged from a slope that is said to be 0: what is put to 0 is that, and no new law.
fn is_stationary(judged: &Judged) -> bool {
    let is_flat = |own: &Assumed| match own.formula.as_equation() {
        Some((Expr::Derivative { .. } | Expr::Partial { .. }, value)) => *value == Expr::integer(0),
        _ => false,
    };
    let said = |own: &&Assumed| matches!(own.source, Source::Local(..));
    judged.assumed.iter().filter(said).any(is_flat)
}

/// Whether a name stands in the source of a display, not as a part of a longer one.
fn stands_in(name: &str, text: &str) -> bool {
    let mut places = text.match_indices(name);
    places.any(|(at, _)| {
        let before = text[..at].chars().next_back();
        let after = text[at + name.len()..].chars().next();
        let is_letter = |c: Option<char>| c.is_some_and(char::is_alphabetic);
        before != Some('\\') && !is_letter(before) && !is_letter(after)
    })
}

/// Whether something is refuted that speaks of what no equation before does.
fn speaks_first(equation: &Equation, entry: &Entry) -> bool {
    let mut refuted = entry.judged.iter().filter(|own| own.outcome.is_refuted());
    refuted.any(|own| {
        let names = own.goal.formula.names();
        !names.is_disjoint(&equation.introduces)
    })
}

/// Whether something is refuted with the law of propagation: an uncertainty that it speaks of is no new symbol of a law.
fn is_refuted_by_propagation(entry: &Entry) -> bool {
    let mut judged = entry.judged.iter();
    judged.any(|own| own.outcome.is_refuted() && own.is_propagated())
}

/// The equations that the evidence for a statement makes use of.
fn used(entry: &Entry) -> Set<usize> {
    let assumed = entry.judged.iter().flat_map(|j| j.assumed.iter());
    let premises = assumed.filter_map(|a| match a.source {
        Source::Equation(premise) => Some(premise),
        _ => None,
    });
    let mut used: Set<usize> = premises.collect();
    used.extend(entry.numeric.iter().flat_map(|own| numeric::used(own)));
    used
}

impl Judge<'_> {
    /// Whether nobody says where what a display sets out from comes from: "One behind the other, the extensions add:
    /// $$x = \frac{F}{k_1} + \frac{F}{k_2} \Rightarrow k = \frac{k_1 k_2}{k_1 + k_2}$$".
    fn sets_out(&self) -> bool {
        self.cites_loosely() && !self.derivation.equations[self.at].drawn
    }
}

/// Whether a goal is of what `\Rightarrow` leads on from.
fn is_set_out_from(statement: &Statement, goal: &Goal) -> bool {
    let next = statement.connectives.first();
    goal.clause == 0 && next.is_some_and(|own| own.value == Connective::Implies)
}

/// Whether a goal puts to nought what the next clause is drawn from: `\frac{dD}{dx} = 1 - \frac{a}{x^2} = 0 \Rightarrow x = \sqrt{a}` supposes that.
fn is_put_to_nought(statement: &Statement, goal: &Goal) -> bool {
    let mut clause = goals(statement);
    clause.retain(|own| own.clause == goal.clause);
    // What it comes to is said before; `4 r - h = 0 \Rightarrow` alone is an equation like any other.
    let ends = clause.len() > 1 || goal.formula.speaks_of_slopes();
    let ends = ends
        && clause
            .last()
            .is_some_and(|last| last.formula == goal.formula);
    let sides = goal.formula.as_equation();
    ends && sides.is_some_and(|(_, right)| *right == Expr::integer(0))
}

/// Whether a formula says what a symbol is, and not what its square is.
fn names_a_symbol(formula: &Formula) -> bool {
    matches!(formula.as_equation(), Some((Expr::Symbol(_), _)))
}
