//! What something is solved for, under a name of its own: "Setting $y = 0$ in (1), we find the time of flight $$T = 2 v_0/g$$" after
//! `y = v_0 t - \frac{1}{2} g t^2`.
//!
//! A new symbol alone on the left would be defined by what stands for it. Where the words just before set what a law speaks of to a value, and
//! what is printed is made of what else the law speaks of, the new symbol is the value there of what is gone. It is told to be wrong only where
//! something else follows in the same symbols for one of the symbols that are gone, and for no other.

use crate::algebra::{Expr, Formula, Symbol, effort};
use crate::derivation::{Assumed, Goal, Source};
use crate::search::{self, Decision};
use crate::sorted::Set;

use super::super::judge::{Found, Judge, condition, step, taken};
use super::super::stated::quantities;
use super::conditions::takes_root;
use super::there::{Asked, MayFail, Side, There, join, whole};

/// What a new name for something that is solved for comes after.
const SOLVING: [&str; 8] = [
    "solve",
    "solving",
    "solved",
    "solution",
    "solutions",
    "root",
    "roots",
    "zero",
];
/// So many laws that stand farther back are looked at.
const MOST_LAWS: usize = 8;
/// So many symbols may be what is solved for.
const MOST_UNKNOWNS: usize = 3;
/// So much work is done for each of them, as [`effort`] counts it.
const MOST_WORK: u64 = 1_000_000;

impl Judge<'_> {
    /// What would define a new symbol by its first link, judged as the value of what the words solve for; nothing where they do not.
    pub(in crate::audit) fn as_solved(&self, goal: &Goal, premises: &[usize]) -> Option<There> {
        let (new, named) = self.defined_anew(goal)?;
        let mut assumed = self.cited(goal, &[], premises);
        let mut words = self.said_of_the_place(Side::Before);
        let is_old = |own: &Assumed| {
            matches!(own.source, Source::Local(..)) && !self.is_said_just_before(own)
        };
        let says_where = self.names_its_premises()
            || assumed.iter().any(|own| self.is_said_just_before(own))
            || !words.iter().all(is_old);
        words.extend(self.named_before(premises));
        let fresh = assumed.iter().filter(|own| self.is_said_just_before(own));
        let said: Vec<&Assumed> = words.iter().chain(fresh).collect();
        let set: Vec<Place> = said.iter().copied().filter_map(place).collect();
        // What is a number there is printed as one: `K = (\gamma - 1) m c^2` is not said of $m = 0$.
        let mut numbers = said.iter().filter_map(|own| own.formula.set_to_number());
        if numbers.any(|own| named.contains(own)) {
            return None;
        }
        join(words.into_iter(), &mut assumed);
        // Who cites nothing that speaks of it means what stands just before.
        let speaks = |own: &Assumed| {
            let names = own.formula.names();
            let mut places = set.iter();
            is_displayed(own) && places.any(|place| names.contains(place.of()))
        };
        if !set.is_empty() && !assumed.iter().any(speaks) {
            let spoken = || self.others(premises)[0].iter().filter(|own| speaks(own));
            let nearest = spoken().next().map(|own| own.source);
            assumed.extend(spoken().filter(|own| Some(own.source) == nearest).cloned());
        }
        // Who cites nothing may mean what stands farther back: "In the ground state, $n = 1$, the radius is".
        let farther: Vec<Assumed> = match set.is_empty() || self.names_its_premises() {
            true => Vec::new(),
            false => {
                let mut others = self.open_before(premises);
                others.retain(|own| speaks(own) && !assumed.contains(own));
                others.truncate(MOST_LAWS);
                others
            }
        };
        // Two cases at once say nothing.
        assumed.retain(|own| !self.is_of_case_before(own));
        // The name may say what it is that is solved for: `\omega_0`.
        let by_name = self.whole_of(new);
        let is_by_name = set.is_empty();
        let gone = match set.is_empty() {
            true => by_name
                .iter()
                .filter(|own| self.is_drawn_from(own, &assumed))
                .cloned()
                .collect(),
            false => {
                let gone = gone(set, &named, new, &assumed);
                let named_so = by_name.clone().filter(|own| gone.contains(own));
                named_so.map_or(gone, |own| vec![own])
            }
        };
        // A slope is not what it is the slope of: `w'_L` is no value of `w`.
        if gone.len() > MOST_UNKNOWNS || gone.iter().any(|own| new.differs_by_primes(own)) {
            return None;
        }
        let with = |unknown: &Symbol| {
            let same = taken(&Formula::same(new, unknown));
            assumed.iter().cloned().chain([same]).collect::<Vec<_>>()
        };
        // Where all is positive it is soon seen what follows: only that is looked at in earnest.
        let follows = |unknown: &&Symbol| {
            let all = self.where_all_is_positive(goal, with(unknown));
            effort::within(MOST_WORK, || self.is_proven_from(&all, goal))
        };
        let (likely, others): (Vec<&Symbol>, Vec<&Symbol>) = gone.iter().partition(follows);
        if let Some(first) = likely.first() {
            // What only the words name is not found from what is cited, however hard it is tried.
            let cited = self.cited(goal, &[], premises);
            let by_words = assumed.len() > cited.len();
            let solved = |own: &Symbol| {
                let from_cited = || {
                    let same = taken(&Formula::same(new, own));
                    let all = cited.iter().cloned().chain([same]).collect();
                    self.is_proven_from(&self.where_all_is_positive(goal, all), goal)
                };
                let solved =
                    (!by_words || from_cited()).then(|| self.solved_for(goal, own, premises));
                solved
                    .flatten()
                    .or_else(|| self.solved_from(goal, with(own), premises))
            };
            return likely.iter().copied().find_map(solved).or_else(|| {
                let is_shown = self.is_proven_from(&with(first), goal);
                is_shown.then_some(There::Shown)
            });
        }
        let by_law = farther.iter().find_map(|law| {
            let (Expr::Symbol(unknown), _) = law.formula.as_equation()? else {
                return None;
            };
            if unknown == new || named.contains(unknown) {
                return None;
            }
            let all: Vec<Assumed> = with(unknown).into_iter().chain([law.clone()]).collect();
            let follows = effort::within(MOST_WORK, || {
                self.is_proven_from(&self.where_all_is_positive(goal, all.clone()), goal)
            });
            follows.then(|| self.solved_from(goal, all, premises))?
        });
        if by_law.is_some() {
            return by_law;
        }
        // "A soap bubble has two surfaces, so `\Delta p_s = 4\gamma/R`" is no value of `\Delta p` for all its name; nor is `\pi` the value of
        // `b` in "Each firm then earns" because one symbol was taken for another before.
        if (is_by_name || !says_where) && !self.says(&SOLVING) {
            return None;
        }
        // What a display says plainly and nobody cites keeps its letter: the `v` after `\Delta K = …` at $e = 0$ is no `\Delta K`.
        let plainly = |unknown: &Symbol| {
            let mut laws = assumed.iter().filter(|own| is_displayed(own));
            !self.names_its_premises()
                && by_name.as_ref() != Some(unknown)
                && laws.any(|own| own.is_of(unknown))
        };
        let others = others.into_iter().filter(|unknown| !plainly(unknown));
        let mut told = others.filter_map(|unknown| {
            let asked = Asked {
                new,
                named: &named,
                quantity: Some(unknown),
            };
            let may_fail = MayFail::InTheSameSymbols;
            effort::within(MOST_WORK, || {
                let all = self.where_all_is_positive(goal, with(unknown));
                // What is taken a root of is not read off at once.
                (takes_root(&goal.formula) || self.implies_in(&all, goal, &named))
                    .then(|| self.judged_there(goal, with(unknown), premises, &asked, may_fail))?
            })
        });
        // Where two could be meant nothing is told.
        let first = told.next()?;
        told.next().is_none().then_some(first)
    }

    fn is_proven_from(&self, assumed: &[Assumed], goal: &Goal) -> bool {
        let decision = self.decide_from(assumed, &goal.formula);
        matches!(decision, Some(Decision::Proven { .. }))
    }

    /// Whether premises give something else for what a goal defines, in just these symbols.
    fn implies_in(&self, assumed: &[Assumed], goal: &Goal, named: &Set<Symbol>) -> bool {
        let posed = self.pose(assumed, &goal.formula).ok();
        let implied = posed.and_then(|posed| search::implied(&posed));
        let sides = implied
            .as_ref()
            .and_then(|own| own.proven.claim().goal.as_equation());
        sides.is_some_and(|(_, value)| quantities(value) == *named)
    }

    /// What defines a new symbol, if it follows where that is what another one is there.
    pub(super) fn solved_for(
        &self,
        goal: &Goal,
        unknown: &Symbol,
        premises: &[usize],
    ) -> Option<There> {
        let (Expr::Symbol(new), _) = goal.formula.as_equation()? else {
            return None;
        };
        let same = Formula::same(new, unknown);
        let steps = [(goal.clause, same.clone())];
        let mut found =
            effort::within(MOST_WORK, || self.for_proofs().goal(goal, &steps, premises));
        for own in &mut found.judged.assumed {
            if own.source == Source::Step && *own.formula == same {
                own.source = Source::Taken;
            }
        }
        self.shown(found, premises)
    }

    /// What defines a new symbol, if it follows from what is cited and what the words name.
    pub(super) fn solved_from(
        &self,
        goal: &Goal,
        assumed: Vec<Assumed>,
        premises: &[usize],
    ) -> Option<There> {
        let found = effort::within(MOST_WORK, || {
            let judge = self.for_proofs_from_these();
            judge.judged(goal, assumed, premises)
        });
        self.shown(found, premises)
    }

    /// What a display concludes of a symbol that is new in it, `\frac{dP}{dv} = 0 \Rightarrow v_m = \sqrt{T/3 m}`, judged as the value of what it names.
    /// It fails only where something else follows in the same symbols.
    pub(in crate::audit) fn as_concluded(
        &self,
        goal: &Goal,
        steps: &[(usize, Formula)],
        premises: &[usize],
    ) -> Option<Found> {
        let (Expr::Symbol(new), value) = goal.formula.as_equation()? else {
            return None;
        };
        let equation = &self.derivation.equations[self.at];
        let named = whole(new)?;
        let mut before = steps.iter();
        let is_new = equation.introduces.contains(new)
            && !value.mentions(new)
            && !value.mentions(&named)
            && before.any(|(clause, own)| *clause < goal.clause && own.names().contains(&named));
        if !is_new || steps.iter().any(|(_, own)| own.names().contains(new)) {
            return None;
        }
        // What is so at that place says nothing of slopes there.
        let at_place = steps
            .iter()
            .filter(|(_, own)| !own.speaks_of_slopes())
            .map(|(_, own)| step(own));
        let mut assumed: Vec<Assumed> = at_place.collect();
        assumed.push(taken(&Formula::same(new, &named)));
        // Who sets `(T - 3 m v^2) (1 - b)` to 0 by a choice of `v` means the factor with `v`.
        let others = steps
            .iter()
            .flat_map(|(_, own)| factors_without(own, &named));
        let others: Vec<Assumed> = others
            .map(|own| condition(&Formula::nonzero(own)))
            .collect();
        assumed.extend(others.iter().cloned());
        let alone = self.for_proofs_from_these();
        let mut found = effort::within(MOST_WORK, || alone.judged(goal, assumed.clone(), premises));
        if found.judged.outcome.is_proven() {
            let used = others
                .into_iter()
                .filter(|own| found.judged.assumed.contains(own));
            let used: Vec<Formula> = used.map(|own| Formula::clone(&own.formula)).collect();
            found.conditions.extend(used);
            return Some(found);
        }
        let others = quantities(value);
        let asked = Asked {
            new,
            named: &others,
            quantity: Some(&named),
        };
        let there = effort::within(MOST_WORK, || {
            self.judged_there(goal, assumed, premises, &asked, MayFail::InTheSameSymbols)
        });
        match there? {
            There::Refuted(found) => Some(*found),
            There::Solved(_) | There::Shown => None,
        }
    }

    /// What was found, where it is shown from no case that was set before.
    fn shown(&self, mut found: Found, premises: &[usize]) -> Option<There> {
        // What the words name may say more than what is cited.
        found.may_follow = true;
        let mut assumed = found.judged.assumed.iter();
        let is_elsewhere = assumed.any(|own| self.is_of_case_before(own));
        let is_shown = found.judged.outcome.is_proven() && !is_elsewhere;
        let is_shown = is_shown && self.lingering(&found, premises).is_none();
        is_shown.then(|| There::Solved(found.into()))
    }

    /// Whether a step is drawn from what says something of a symbol, but not plainly what it is: "$$0 = a - 2 b Q$$, from which $$Q_m = a/(2 b)$$".
    fn is_drawn_from(&self, symbol: &Symbol, assumed: &[Assumed]) -> bool {
        let laws = || assumed.iter().filter(|own| is_displayed(own));
        self.derivation.equations[self.at].drawn
            && laws().any(|own| own.formula.names().contains(symbol))
            && !laws().any(|own| own.is_of(symbol))
    }

    /// What the new symbols of cited equations were found to be: "Inserting (2) into (3)" goes on at the time `T = t` of which (2) says how
    /// long it is.
    fn named_before(&self, premises: &[usize]) -> Vec<Assumed> {
        let entries = premises
            .iter()
            .flat_map(|&own| self.auditor.entries_of(self.at, own));
        let judged = entries.flat_map(|entry| &entry.judged);
        let assumed = judged.flat_map(|own| &own.assumed);
        let names = |own: &&Assumed| own.source == Source::Taken && own.formula.equates_names();
        assumed.filter(names).cloned().collect()
    }

    /// Whether a hypothesis is of a case that was set before the display before.
    fn is_of_case_before(&self, own: &Assumed) -> bool {
        let Source::Local(page, local) = own.source else {
            return false;
        };
        self.derivation.local(page, local).is_of_some_case() && !self.is_said_just_before(own)
    }

    /// Whether a hypothesis is said between the display before and this one.
    fn is_said_just_before(&self, own: &Assumed) -> bool {
        let Source::Local(page, local) = own.source else {
            return false;
        };
        let said = self.derivation.local(page, local).span;
        self.derivation.is_said_since(self.at, said)
    }
}

/// The factors without a symbol of a product with it that is said to be 0.
fn factors_without(formula: &Formula, symbol: &Symbol) -> Vec<Expr> {
    match formula.as_equation() {
        Some((Expr::Product(factors), zero))
            if *zero == Expr::integer(0) && factors.iter().any(|own| own.mentions(symbol)) =>
        {
            let is_other = |own: &&Expr| !own.mentions(symbol) && !own.free_symbols().is_empty();
            factors.iter().filter(is_other).cloned().collect()
        }
        _ => Vec::new(),
    }
}

/// The symbols that laws tie to what is set, directly or by one another, and that are neither set nor `named` in what is printed.
fn gone(set: Vec<Place>, named: &Set<Symbol>, new: &Symbol, assumed: &[Assumed]) -> Vec<Symbol> {
    let may_be_gone = |own: &Symbol| own != new && !named.contains(own) && !own.is_unit();
    let laws = assumed.iter().filter(|own| is_displayed(own));
    let mut laws: Vec<Set<Symbol>> = laws.map(|own| own.formula.names()).collect();
    let mut fixed = Set::new();
    let mut tied = Set::new();
    for place in set {
        match place {
            // What no law speaks of is a name: "to half of the radius, $R' = R/2$".
            Place::Value(symbol) if laws.iter().any(|law| law.contains(&symbol)) => {
                tied.insert(symbol.clone());
                fixed.insert(symbol);
            }
            Place::Value(_) => {}
            Place::Rest(symbol) => {
                tied.insert(symbol);
            }
        }
    }
    // Each law is gone through once: what it ties may be what ties another.
    while let Some(at) = laws.iter().position(|law| !law.is_disjoint(&tied)) {
        let law = laws.swap_remove(at);
        tied.extend(law.into_iter().filter(|own| may_be_gone(own)));
    }
    let gone = tied.into_iter();
    gone.filter(|own| may_be_gone(own) && !fixed.contains(own))
        .collect()
}

fn is_displayed(own: &Assumed) -> bool {
    matches!(own.source, Source::Equation(_))
}

/// What words say of the place that is meant.
enum Place {
    /// What a symbol is there.
    Value(Symbol),
    /// That a symbol does not move there.
    Rest(Symbol),
}

impl Place {
    fn of(&self) -> &Symbol {
        match self {
            Place::Value(symbol) | Place::Rest(symbol) => symbol,
        }
    }
}

/// What a hypothesis says of the place that is meant. A measured value says nothing of it.
fn place(own: &Assumed) -> Option<Place> {
    let (left, right) = own.formula.as_equation()?;
    // A name stands for what is known there.
    let place = if own.source == Source::Taken {
        right
    } else {
        left
    };
    match place {
        Expr::Symbol(symbol) if !own.formula.names().iter().any(Symbol::is_unit) => {
            Some(Place::Value(symbol.clone()))
        }
        Expr::Derivative { body, .. } => match &**body {
            Expr::Symbol(symbol) => Some(Place::Rest(symbol.clone())),
            _ => None,
        },
        _ => None,
    }
}
