//! What stands before and is not cited: what a step may follow from in the place of what it cites, or besides.

use crate::algebra::{Formula, Symbol};
use crate::derivation::{Assumed, Kind, Local, Source, unconditional};
use crate::sorted::Set;

use super::super::judge::{Judge, NEARBY, sources};
use super::super::premise::usable;
use super::super::{Entry, Note, Verdict};

/// How many earlier equations are looked at for a step that does not follow from what it cites.
const MOST_RELATIVES: usize = 12;
/// How many more formulas than are cited come of these.
const MOST_BORROWED: usize = 40;
/// How many formulas that are given only later are tried with what does not follow.
const MOST_LATER: usize = 4;

/// The equations that stand before a step and that it does not cite.
#[derive(Clone, Default)]
pub(in crate::audit) struct Before {
    /// What rests on nothing false or open.
    pub(in crate::audit) sound: Vec<usize>,
    /// What rests on no more than what is cited does.
    all: Vec<usize>,
    /// This, and what is left open itself or holds under conditions.
    open: Vec<usize>,
}

impl Judge<'_> {
    /// Hypotheses with the nearest of what stands before and is not cited, if there is anything.
    pub(in crate::audit) fn with_others(
        &self,
        assumed: &[Assumed],
        premises: &[usize],
    ) -> Option<Vec<Assumed>> {
        let [others, _] = self.others(premises);
        // With what it was refuted from, what fails would prove nearly anything.
        let against = match self.names_its_premises() {
            true => Set::new(),
            false => {
                let failing = self.failing(premises);
                let is_joined = self.sound(assumed, &failing).len() < assumed.len();
                self.refuted_from(if is_joined { &failing } else { &[] })
            }
        };
        let near = others.iter().filter(|own| !against.contains(&own.source));
        let near = near.take(NEARBY[1].0).cloned();
        let all: Vec<Assumed> = assumed.iter().cloned().chain(near).collect();
        (all.len() > assumed.len()).then_some(all)
    }

    /// Whether directives on the page say what is given and what follows from what: where none does, citations are seldom complete
    /// either.
    pub(in crate::audit) fn is_directed(&self) -> bool {
        self.derivation.pages[self.derivation.equations[self.at].page].directs
    }

    /// Whether the step may rest on what stands before as its author goes along: nothing is cited, and no directive says what follows.
    pub(in crate::audit) fn cites_loosely(&self) -> bool {
        !self.names_its_premises() && !self.is_directed()
    }

    /// What stands before on the page and is not cited, with what is left open or holds under conditions; empty, where nothing is.
    pub(super) fn open_on_this_page(&self, premises: &[usize]) -> Vec<usize> {
        let Before { all, open, .. } = self.before(premises);
        let mut here = open.clone();
        here.retain(|&other| self.is_on_this_page(other));
        match here.iter().all(|other| all.contains(other)) {
            true => Vec::new(),
            false => here,
        }
    }

    /// Other pages may mean other things by the same letters.
    pub(super) fn is_on_this_page(&self, other: usize) -> bool {
        let page = |at: usize| self.derivation.equations[at].page;
        page(other) == page(self.at)
    }

    /// What that says.
    pub(in crate::audit) fn open_before(&self, premises: &[usize]) -> Vec<Assumed> {
        self.gathered(&self.open_on_this_page(premises))
    }

    /// Whether something of an equation before is undecided.
    pub(super) fn is_undecided(&self, other: usize) -> bool {
        let mut entries = self.auditor.entries_of(self.at, other);
        entries.any(|entry| entry.verdict == Verdict::Undecided)
    }

    /// Whether an equation before has a verdict in all that it says.
    pub(super) fn is_all(&self, verdict: Verdict, other: usize) -> bool {
        let mut entries = self.auditor.entries_of(self.at, other);
        other < self.at && entries.all(|entry| entry.verdict == verdict)
    }

    /// What is cited and does not fail: what does can stand in the way of what follows.
    pub(in crate::audit) fn sound(&self, assumed: &[Assumed], failing: &[usize]) -> Vec<Assumed> {
        let fails = |a: &Assumed| matches!(a.source, Source::Equation(p) if failing.contains(&p));
        assumed.iter().filter(|a| !fails(a)).cloned().collect()
    }

    /// The failing equations that what is cited rests on.
    pub(in crate::audit) fn failing(&self, premises: &[usize]) -> Vec<usize> {
        let premises = premises.iter().copied().collect();
        self.auditor.failing(self.at, &premises)
    }

    /// What was true at a point at which failing equations were found to be false. Where the point tells slopes, also what that was
    /// shown from: what is refuted from a slope is refuted from what that is the slope of.
    pub(super) fn refuted_from(&self, failing: &[usize]) -> Set<Source> {
        let entries = failing
            .iter()
            .flat_map(|&at| self.auditor.entries_of(self.at, at));
        let mut found = Set::new();
        for (judged, refuted) in entries.filter_map(|entry| entry.refuted()) {
            let from = sources(&judged.assumed);
            let witness = refuted.witness();
            if witness.course.is_some() || !witness.derivatives.is_empty() {
                found.extend(from.iter().flat_map(|own| self.shown_from(own)));
            }
            found.extend(from);
        }
        found
    }

    /// What an equation before was proved from.
    fn shown_from(&self, source: &Source) -> Vec<Source> {
        let Source::Equation(at) = *source else {
            return Vec::new();
        };
        // What is given may come later, and was shown from nothing.
        if at >= self.at {
            return Vec::new();
        }
        let entries = self.auditor.entries_of(self.at, at);
        let judged = entries.flat_map(|entry| &entry.judged);
        let proven = judged.filter(|judged| judged.outcome.is_proven());
        proven.flat_map(|judged| sources(&judged.assumed)).collect()
    }

    /// What stands before and is not cited: what is sound, and the same with what rests on no more than what is cited does. Empty, where
    /// that is no more.
    pub(in crate::audit) fn others(&self, premises: &[usize]) -> &[Vec<Assumed>; 2] {
        self.others.get_or_init(|| {
            let Before { sound, all, .. } = self.before(premises);
            match sound.len() == all.len() {
                true => [self.gathered(sound), Vec::new()],
                false => [self.gathered(sound), self.gathered(all)],
            }
        })
    }

    pub(in crate::audit) fn before(&self, premises: &[usize]) -> &Before {
        self.before.get_or_init(|| self.look_before(premises))
    }

    fn look_before(&self, premises: &[usize]) -> Before {
        let relatives = self.derivation.relatives(self.at, MOST_RELATIVES);
        // What is cited may rest on something false already, or not proved; then so may what is found instead.
        let own_premises: Set<usize> = premises.iter().copied().collect();
        let failing = self.auditor.failing(self.at, &own_premises);
        let unproved = self.auditor.unproved(self.at, &own_premises);
        let mut before = Before::default();
        // Of a wrong citation, or one of what is not there, is told whatever is found.
        let (_, _, unknown) = self.derivation.premises(self.at);
        let cites = !premises.is_empty() || !unknown.is_empty();
        let is_other = |own: &usize| {
            !premises.contains(own)
                && !self.over.contains(own)
                && !self.auditor.is_explained_by(*own, self.at)
        };
        for other in relatives.into_iter().filter(is_other) {
            let entries: Vec<&Entry> = self.auditor.entries_of(self.at, other).collect();
            let is_wrong = entries.iter().any(|e| e.is_wrong());
            let is_given = entries.iter().any(|e| e.verdict == Verdict::Given);
            if is_wrong
                || is_given && self.is_of_other_circumstances(other)
                || self.derivation.is_released(self.at, other).is_some()
                || !self.may_borrow(other, cites)
            {
                continue;
            }
            let conditional = |n: &Note| matches!(n, Note::UnstatedCondition(_));
            let proved = || entries.iter().filter(|e| !e.names_a_value());
            let is_open =
                |e: &Entry| e.verdict == Verdict::Undecided || e.notes.iter().any(conditional);
            let is_open = proved().any(|e| is_open(e));
            let on = |n: &Note| match n {
                Note::RestsOnUnproved(on) => on.clone(),
                _ => Vec::new(),
            };
            let notes = proved().flat_map(|e| &e.notes);
            let on: Vec<usize> = notes.flat_map(on).collect();
            let mut rests_on = entries.iter().flat_map(|e| &e.rests_on).peekable();
            if rests_on.peek().is_none() && on.is_empty() && !is_open {
                before.sound.push(other);
            }
            if rests_on.all(|r| failing.contains(r)) {
                before.open.push(other);
                if on.iter().all(|u| unproved.contains(u)) && !is_open {
                    before.all.push(other);
                }
            }
        }
        before
    }

    /// What the text tells here, and what equations that are not cited offer.
    pub(in crate::audit) fn gathered(&self, equations: &[usize]) -> Vec<Assumed> {
        let own = &self.usable.assumed;
        let offer = |premise| self.auditor.offer(self.at, premise);
        let offered = usable(self.derivation, offer, self.at, equations).assumed;
        let told = self.derivation.told(self.at).into_iter();
        let mut gathered: Vec<Assumed> = told.chain(offered).filter(|a| !own.contains(a)).collect();
        gathered.truncate(own.len() + MOST_BORROWED);
        self.leave_out_opposite_roots(&mut gathered);
        // What speaks of nothing that the step does not speak of says most of it; few are all looked at.
        if gathered.len() > NEARBY[0].0 {
            let spoken = self.derivation.equations[self.at].symbols();
            let says_most = |own: &Assumed| own.formula.names().is_subset(&spoken);
            gathered.sort_by_cached_key(|own| !says_most(own));
        }
        gathered
    }

    /// What is given before under other circumstances than the step is.
    pub(super) fn said_under_circumstances(&self, premises: &[usize]) -> Vec<Assumed> {
        let relatives = self.derivation.relatives(self.at, MOST_RELATIVES);
        let is_given = |&other: &usize| {
            let mut entries = self.auditor.entries_of(self.at, other);
            entries.any(|own| own.verdict == Verdict::Given)
        };
        let is_other = |other: &usize| {
            !premises.contains(other) && self.is_of_other_circumstances(*other) && is_given(other)
        };
        let others: Vec<usize> = relatives.into_iter().filter(is_other).collect();
        match others.is_empty() {
            true => Vec::new(),
            false => self.gathered(&others),
        }
    }

    /// Whether the words before a step say that it is of other circumstances than an equation was said under.
    fn is_of_other_circumstances(&self, other: usize) -> bool {
        let equations = &self.derivation.equations;
        let (own, other) = (&equations[self.at], &equations[other]);
        let first = self.derivation.equations_of(own.page).start;
        own.page == other.page
            && other.circumstances.is_some()
            && own.circumstances == Some(self.derivation.display_start(self.at) - first)
    }

    /// Whether all that an earlier equation was shown under is supposed here too: what is not cited brings no special case with it.
    /// In the place of a wrong citation, which is told of, one under mere conditions will do.
    pub(super) fn may_borrow(&self, other: usize, cites: bool) -> bool {
        let own = &self.derivation.equations[self.at];
        let Some(offer) = self.auditor.offer(self.at, other) else {
            return false;
        };
        let goes_on = self.goes_on_from(other);
        offer.under.iter().all(|&(page, local)| {
            let said = self.derivation.local(page, local);
            let bounds = || said.formulas.iter().all(|f| f.as_equation().is_none());
            let special = || said.is_let || said.is_case() || said.is_momentary();
            let means = || said.is_told && said.means && !self.is_replaced(said);
            let is_meant = own.is_under(page, local) || goes_on && !special() || means();
            is_meant && !self.derivation.is_beyond(self.at, (page, local)) || cites && bounds()
        })
    }

    /// Whether something else is said here in the place of what was told.
    fn is_replaced(&self, told: &Local) -> bool {
        let own = &self.derivation.equations[self.at];
        let in_effect = own.locals.iter().chain(&own.told).chain(&own.named);
        let mut others = in_effect.map(|&other| self.derivation.local(own.page, other));
        others.any(|other| told.is_replaced_by(other))
    }

    /// What is given further on in the page and not cited: an author may have used it too soon.
    pub(in crate::audit) fn later(&self, premises: &[usize]) -> Vec<Formula> {
        let equations = &self.derivation.equations;
        let own = self.derivation.equations_of(equations[self.at].page);
        let given = (self.at + 1..own.end)
            .take(MOST_RELATIVES)
            .filter(|at| equations[*at].kind == Kind::Given && !premises.contains(at));
        let statements = given.flat_map(|at| equations[at].statements());
        statements
            .flat_map(unconditional)
            .take(MOST_LATER)
            .collect()
    }
}

/// Whether hypotheses say something of each symbol of a goal: one of which nothing at all is said can have any value.
pub(super) fn speaks_of_all<'a>(
    hypotheses: impl Iterator<Item = &'a Assumed> + Clone,
    goal: &Formula,
) -> bool {
    let said = |symbol: &&Symbol| {
        let mut terms = hypotheses.clone().flat_map(|a| a.formula.terms());
        terms.any(|term| term.mentions(symbol))
    };
    Formula::free_symbols_of(std::iter::once(goal))
        .iter()
        .all(said)
}

/// What `means` some of these symbols, and what does those in that, which join the symbols: taken out of what is said.
pub(super) fn chain_of(
    said: &mut Vec<Assumed>,
    symbols: &mut Set<Symbol>,
    means: impl Fn(&Assumed, &Set<Symbol>) -> bool,
) -> Vec<Assumed> {
    let mut found = Vec::new();
    while let Some(at) = said.iter().position(|own| means(own, symbols)) {
        let own = said.remove(at);
        symbols.extend(own.formula.free_symbols());
        found.push(own);
    }
    found
}
