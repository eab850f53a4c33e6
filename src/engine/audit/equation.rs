//! One equation: what it may use, its statements one after another, and whether the page begins with it.

use crate::algebra::{Expr, Formula, Symbol, effort};
use crate::derivation::{Assumed, Equation, Goal, Kind, Source, first_goal, formulas, goals};
use crate::kernel::Standing;
use crate::notation::Statement;
use crate::sorted::Set;

use super::cited::unused;
use super::entry::blank;
use super::premise::{Usable, usable};
use super::readings::Circumstances;
use super::{
    Auditor, Entry, Judged, MOST_WORK, Note, Outcome, Verdict, domain, identity, judge, nature,
    stated,
};

/// So many displays of moments that are left may stand between a step and what it goes on from.
const MOST_MOMENTARY: usize = 8;
/// So much work is done for what another reading comes to, in units of [`effort`]: hardly a verdict takes a tenth of it.
const MOST_WORK_AGAIN: u64 = 1_000_000;
/// So many statements of one display are judged: each may use all before it.
const MOST_STATEMENTS: usize = 256;
/// So many statements after one are looked at for what its symbols mean.
const MOST_MEANINGS: usize = 4;

impl Auditor<'_> {
    /// What may be used for a statement with what those after it in the display say that its new symbols are:
    /// `K = E \frac{x}{1 + x}, \qquad x = E/E_0`. Nothing where they say no such thing.
    fn with_meanings(&self, at: usize, part: usize, usable: &Usable) -> Option<Usable> {
        let equation = &self.derivation.equations[at];
        let (own, later) = equation.statements()[part..].split_first()?;
        if later.is_empty() || equation.introduces.is_empty() {
            return None;
        }
        let spoken_of: Set<Symbol> = formulas(own).iter().flat_map(Formula::names).collect();
        let begun = first_goal(own);
        let defines = |new: &Symbol| begun.as_ref().is_some_and(|own| own.is_of(new));
        let means = |goal: &Goal| {
            let new = meant(goal, equation);
            new.is_some_and(|new| spoken_of.contains(new) && !defines(new))
        };
        let later = later
            .iter()
            .take(MOST_MEANINGS)
            .filter(|own| own.under.is_empty());
        let meanings: Vec<Goal> = later.filter_map(first_goal).filter(means).collect();
        if meanings.is_empty() {
            return None;
        }
        let mut usable = usable.clone();
        let said = meanings.iter().map(|goal| Assumed {
            standing: Standing::Identity,
            ..judge::step(&goal.formula)
        });
        usable.assumed.extend(said);
        Some(usable)
    }

    /// Whether a statement says what a new symbol of a statement before it in the display means: `f = 64/\mathrm{Re}, \qquad \mathrm{Re} =
    /// \frac{\rho u D}{\mu}`.
    fn gives_meaning(&self, at: usize, part: usize) -> bool {
        let equation = &self.derivation.equations[at];
        let (before, own) = equation.statements().split_at(part);
        let Some(goal) = own.first().and_then(first_goal) else {
            return false;
        };
        let Some(new) = meant(&goal, equation) else {
            return false;
        };
        // It may go on: `m^2 = \frac{h P}{k A} = \frac{4 h}{k D}`.
        let is_alone = own.first().is_some_and(|own| {
            goals(own).iter().all(|goal| goal.clause == 0) && own.under.is_empty()
        });
        let defines = |own: &Statement| first_goal(own).is_some_and(|own| own.is_of(new));
        let speaks = |own: &Statement| formulas(own).iter().any(|own| own.names().contains(new));
        is_alone && !before.iter().any(defines) && before.iter().any(speaks)
    }

    pub(super) fn equation(&self, at: usize) -> Vec<Entry> {
        let equation = &self.derivation.equations[at];
        let statements = match &equation.statements {
            Ok(statements) => statements,
            Err(error) => {
                let mut entry = blank(at, 0, 1, equation.kind, Verdict::Undecided);
                entry.notes.push(Note::Unreadable(error.clone()));
                return vec![entry];
            }
        };
        if equation.kind == Kind::Given {
            return self.given(at, statements);
        }
        let parts = statements.len();
        let (premises, says_so, unknown) = self.derivation.premises(at);
        let mut premises = premises.to_vec();
        if !says_so {
            self.leave_moments(at, &mut premises);
        }
        premises.retain(|&premise| !self.is_explained_by(premise, at));
        let offer = |premise| self.offer(at, premise);
        let mut usable = usable(self.derivation, offer, at, &premises);
        usable.assumed.extend(self.explained_after(at));
        let stated = equation.symbols();
        let of_nature = nature::relations(&stated, &usable.assumed);
        usable.assumed.extend(of_nature);
        let mut entries = Vec::new();
        // Where a formula is meant is said beside it.
        let domains = match equation.numeric {
            Some(_) => Vec::new(),
            None => domain::domains(statements),
        };
        let said = domains.iter().flat_map(|&part| goals(&statements[part]));
        usable
            .assumed
            .extend(said.map(|goal| judge::step(&goal.formula)));
        for (part, statement) in statements.iter().enumerate() {
            if domains.contains(&part) {
                let mut entry = blank(at, part, parts, Kind::Given, Verdict::Given);
                let stated = |goal| Judged {
                    goal,
                    assumed: Vec::new(),
                    outcome: Outcome::Stated,
                };
                entry.judged = goals(statement).into_iter().map(stated).collect();
                entries.push(entry);
                continue;
            }
            if part >= MOST_STATEMENTS {
                entries.push(one_too_many(at, part, parts, equation.kind, statement));
                continue;
            }
            let with_meanings = self.with_meanings(at, part, &usable);
            let how = Circumstances {
                at,
                part,
                usable: with_meanings.as_ref().unwrap_or(&usable),
                premises: &premises,
                says_so,
                defines: equation.defines.contains(&part) || self.gives_meaning(at, part),
            };
            let mut entry = match equation.numeric {
                Some(_) => effort::within(MOST_WORK, || self.numeric(at, statement, &usable)),
                None => {
                    let found = self.step(statement, &how);
                    let found = self.heed_what_is_unsaid(statement, &how, found);
                    let found = self.look_for_slip(statement, &how, found);
                    self.look_for_slip_in_identity(statement, &how, found)
                }
            };
            if entry.numeric.is_none() {
                self.note_other_reading(statement, &mut entry, &how);
            }
            self.reckon(at, statement, &mut entry);
            (entry.part, entry.parts) = (part, parts);
            if part == 0 {
                let unknown = unknown.iter();
                let unknown = unknown.map(|u| Note::UnknownCitation(u.label.clone(), u.span));
                entry.notes.extend(unknown);
                let later = usable.later.iter();
                entry.notes.extend(later.map(|&p| Note::CitesLater(p)));
            }
            // What a display defines, it goes on with: `a = b, \qquad c = a`.
            if let Some(judged) = entry.judged.first()
                && matches!(judged.outcome, Outcome::Defined | Outcome::Stated)
                && statement.under.is_empty()
            {
                usable.assumed.push(Assumed {
                    formula: judged.goal.formula.clone().into(),
                    standing: Standing::Identity,
                    source: Source::Step,
                });
            }
            entries.push(entry);
        }
        if says_so {
            self.note_unused(at, &premises, &mut entries);
        }
        // A page must begin somewhere: what nothing precedes is given.
        if equation.opens && self.are_laws(at, &entries) {
            if !entries.iter().any(|e| stated::slips(e, equation)) {
                let begin = |(part, statement)| {
                    let mut entry = blank(at, part, parts, Kind::Given, Verdict::Given);
                    self.reckon(at, statement, &mut entry);
                    entry
                };
                return statements.iter().enumerate().map(begin).collect();
            }
            if equation.continues == 0 {
                entries.iter_mut().for_each(stated::begin);
            }
        }
        entries
    }

    /// Whether an equation says what a symbol of the one before it means: it follows from nothing that was drawn from it.
    pub(super) fn is_explained_by(&self, own: usize, next: usize) -> bool {
        own + 1 == next && !self.derivation.equations[own].explained.is_empty()
    }

    /// What the display after an equation says that some of its symbols mean: "where the wavelength is".
    fn explained_after(&self, at: usize) -> Vec<Assumed> {
        let explained = &self.derivation.equations[at].explained;
        let next = match explained.is_empty() {
            true => None,
            false => self.derivation.equations.get(at + 1),
        };
        let statements = next.into_iter().flat_map(|own| own.statements());
        let said = statements.filter_map(first_goal).map(|goal| goal.formula);
        let means = said.filter(|own| match own.as_equation() {
            Some((Expr::Symbol(symbol), _)) => explained.contains(symbol),
            _ => false,
        });
        let means = means.map(|formula| Assumed {
            formula: formula.into(),
            standing: Standing::Identity,
            source: Source::Equation(at + 1),
        });
        means.collect()
    }

    /// The statements of what is given.
    fn given(&self, at: usize, statements: &[Statement]) -> Vec<Entry> {
        let parts = statements.len();
        let given = |(part, statement): (usize, &Statement)| {
            let mut entry = self.givens.entry(at, part, parts);
            let how = Circumstances {
                at,
                part,
                usable: &Usable::default(),
                premises: &[],
                says_so: false,
                defines: false,
            };
            self.note_other_reading(statement, &mut entry, &how);
            self.reckon(at, statement, &mut entry);
            entry
        };
        statements.iter().enumerate().map(given).collect()
    }

    /// A statement that is to be derived.
    pub(super) fn step(&self, statement: &Statement, how: &Circumstances) -> Entry {
        let from = |usable: &Usable| self.statement(statement, &Circumstances { usable, ..*how });
        let lasting = match how.says_so {
            true => self.without_moments(how),
            false => None,
        };
        let entry = effort::within(MOST_WORK, || {
            let plain = lasting.map(|lasting| from(&lasting));
            plain
                .filter(simply_holds)
                .unwrap_or_else(|| from(how.usable))
        });
        if let Some(of_case) = self.in_its_case(statement, how, &entry) {
            return of_case;
        }
        // What stands just before and is false says nothing of an identity, or of what follows without it.
        let is_wrong = |&premise: &usize| self.entries_of(how.at, premise).any(Entry::is_wrong);
        if how.says_so || entry.verdict != Verdict::Undecided || !how.premises.iter().any(is_wrong)
        {
            return entry;
        }
        let offer = |premise| self.offer(how.at, premise);
        let alone = usable(self.derivation, offer, how.at, &[]);
        let alone = Circumstances {
            usable: &alone,
            premises: &[],
            ..*how
        };
        let alone = effort::within(MOST_WORK, || self.statement(statement, &alone));
        let told = self.derivation.told(how.at);
        match simply_holds(&alone) || identity::is_identity(&alone, &told, true) {
            true => alone,
            false => entry,
        }
    }

    /// A step that cites in its own words what is derived for a case, shown where that case is: "Inserting the equilibrium value (3)". It says so.
    fn in_its_case(
        &self,
        statement: &Statement,
        how: &Circumstances,
        entry: &Entry,
    ) -> Option<Entry> {
        let page = &self.derivation.pages[self.derivation.equations[how.at].page];
        let is_open = entry.verdict == Verdict::Undecided && entry.numeric.is_none();
        if !how.says_so || !is_open || how.usable.out_of_scope.is_empty() || page.directs {
            return None;
        }
        let mut usable = how.usable.clone();
        usable.assumed.extend(self.of_other_cases(how.at, &usable));
        let cited = std::mem::take(&mut usable.out_of_scope);
        let how = Circumstances {
            usable: &usable,
            ..*how
        };
        let mut own = effort::within(MOST_WORK, || self.statement(statement, &how));
        if own.verdict != Verdict::Holds {
            return None;
        }
        let is_cited = |own: &Source| matches!(own, Source::Equation(at) if cited.contains(at));
        for note in &mut own.notes {
            if let Note::Uncited(sources) = note {
                sources.retain(|own| !is_cited(own));
            }
        }
        own.notes
            .retain(|note| !matches!(note, Note::Uncited(sources) if sources.is_empty()));
        own.notes.extend(cited.into_iter().map(Note::OutOfScope));
        Some(own)
    }

    fn note_other_reading(&self, statement: &Statement, entry: &mut Entry, how: &Circumstances) {
        let other = effort::within(MOST_WORK_AGAIN, || {
            self.other_reading(statement, entry, how)
        });
        entry.notes.extend(other);
    }

    /// Of what stands before and is not cited, what is said of a moment that is left is no premise; what stands before that may be.
    fn leave_moments(&self, at: usize, premises: &mut Vec<usize>) {
        let of_page = self.derivation.equations[at].page;
        let of_page = self.derivation.equations_of(of_page).start;
        let last = premises.last().copied();
        premises.retain(|&premise| self.is_said_here(at, premise));
        if let Some(last) = last.filter(|_| premises.is_empty()) {
            let mut before = (of_page..last).rev().take(MOST_MOMENTARY);
            premises.extend(before.find(|&premise| self.is_said_here(at, premise)));
        }
    }

    /// What a step may use without what is so at the moment that the text speaks of: that is no premise of what follows from what is
    /// cited. Nothing where there is no such thing, or it is cited.
    fn without_moments(&self, how: &Circumstances) -> Option<Usable> {
        let mut momentary = self.derivation.momentary(how.at);
        let is_cited =
            |a: &Assumed| matches!(a.source, Source::Equation(p) if how.premises.contains(&p));
        momentary.retain(|a| !is_cited(a));
        let mut lasting = how.usable.clone();
        lasting.assumed.retain(|a| !momentary.contains(a));
        (!momentary.is_empty()).then_some(lasting)
    }

    /// Says what is cited and not needed, where all holds. What the text tells may come of what is cited.
    fn note_unused(&self, at: usize, premises: &[usize], entries: &mut [Entry]) {
        let by_words = |note: &Note| match note {
            Note::Uncited(sources) => sources.iter().any(|source| self.is_told(at, source)),
            _ => false,
        };
        if entries.iter().any(|e| e.verdict != Verdict::Holds)
            || entries.iter().flat_map(|e| &e.notes).any(by_words)
        {
            return;
        }
        let unused = unused(entries, premises);
        if let Some(first) = entries.first_mut()
            && !unused.is_empty()
        {
            first.notes.push(Note::UnusedPremise(unused));
        }
    }

    /// Whether what a page begins with is taken as it stands.
    fn are_laws(&self, at: usize, entries: &[Entry]) -> bool {
        let (told, drawn) = (
            self.derivation.told(at),
            self.derivation.equations[at].drawn,
        );
        let is_law = |entry: &Entry| {
            entry.verdict != Verdict::Holds
                && entry.numeric.is_none()
                && !identity::is_step(entry, &told, drawn)
        };
        entries.iter().all(is_law)
    }
}

/// Whether it holds, and nothing is to be said of that but what is taken as constant.
fn simply_holds(entry: &Entry) -> bool {
    let fine = |note: &Note| matches!(note, Note::TakenAsConstant(_));
    entry.verdict == Verdict::Holds && entry.notes.iter().all(fine)
}

/// A statement of a display that states too much.
fn one_too_many(at: usize, part: usize, parts: usize, kind: Kind, statement: &Statement) -> Entry {
    let mut entry = blank(at, part, parts, kind, Verdict::Undecided);
    let open = |goal| Judged {
        goal,
        assumed: Vec::new(),
        outcome: Outcome::open("its display states too much to be judged"),
    };
    entry.judged = goals(statement).into_iter().map(open).collect();
    entry
}

/// The new symbol of which a goal says what it means, or what a power of it is: `\omega^2 = k/m`.
fn meant<'a>(goal: &'a Goal, equation: &Equation) -> Option<&'a Symbol> {
    let (new, term) = goal.formula.said_of()?;
    let is_new = equation.introduces.contains(new);
    (is_new && goal.rounding.is_none() && !term.mentions(new)).then_some(new)
}
