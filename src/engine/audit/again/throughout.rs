//! What follows because something is so for every value of a variable: `\omega^2 = k/m` from `m \ddot x = -k x` and
//! `x = A \cos(\omega t)`, or coefficients that are compared.
//!
//! At one time alone `x` may be 0, and nothing follows; throughout it is 0 only if `A` is, which nobody means who tries such a solution.

use crate::algebra::{Expr, Formula, Symbol, effort};
use crate::derivation::{Assumed, Goal, Source};
use crate::kernel::{Claim, Standing, definition};
use crate::notation::plain_symbol;
use crate::search::{self, Decision};
use crate::sorted::{self, Map, Set};

use super::super::judge::{Found, Judge, condition, sources, step};
use super::super::{Judged, Outcome, Verdict};
use super::conditions::unbounded;

/// More symbols than this are not held constant.
const MOST_HELD: usize = 14;
/// A law is differentiated so often where a step is held against it.
const MOST_SLOPES: usize = 3;
/// So much work is done for that.
const MOST_WORK: u64 = 2_000_000;

impl Judge<'_> {
    /// Whether a step that was not proved follows from what holds throughout, cited or not.
    pub(super) fn follows_throughout(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        premises: &[usize],
        found: &mut Found,
    ) -> bool {
        if self.names_its_premises() && self.is_directed() {
            return false;
        }
        let sound = self.sound(assumed, &self.failing(premises));
        let all = self.with_others(&sound, premises);
        self.holds_throughout(goal, &all.unwrap_or(sound), found)
    }

    /// Whether the step follows from what holds throughout, with constants that are not 0 in what varies; where roots are taken, with
    /// positive ones.
    fn holds_throughout(&self, goal: &Goal, set: &[Assumed], found: &mut Found) -> bool {
        // What a partial derivative holds fixed is nothing that does not change otherwise.
        let is_partial = |part: &Expr| matches!(part, Expr::Partial { .. });
        let formulas = set.iter().map(|own| &*own.formula);
        let mut formulas = formulas.chain([&goal.formula]);
        if formulas.any(|own| own.terms().into_iter().any(|term| term.any(&is_partial))) {
            return false;
        }
        let mut variables = self.variables_left_out(goal, set);
        // Of a slope what the law does not say to move is constant, too, and may be divided out.
        let mut slopes = Set::new();
        for term in goal.formula.terms() {
            term.collect_variables(&mut slopes);
        }
        variables.extend(slopes);
        (variables.iter()).any(|variable| self.holds_for_all(variable, goal, set, found))
            || (self.compared(goal, set).iter()).any(|(variable, own)| {
                let beside = self.beside_compared(variable, goal, own);
                beside.is_some_and(|beside| self.holds_beside(beside, goal, own, found))
            })
    }

    /// The same for every value of one variable.
    pub(in crate::audit) fn holds_for_all(
        &self,
        variable: &Symbol,
        goal: &Goal,
        set: &[Assumed],
        found: &mut Found,
    ) -> bool {
        let beside = self.beside(variable, goal, set);
        beside.is_some_and(|beside| self.holds_beside(beside, goal, set, found))
    }

    fn holds_beside(
        &self,
        Beside {
            variable,
            held,
            claim,
        }: Beside,
        goal: &Goal,
        set: &[Assumed],
        found: &mut Found,
    ) -> bool {
        let proved = |assumed: &[Assumed]| {
            let claim = self.derivation.claim(self.at, assumed, &goal.formula);
            let claim = search::with_constants(claim, held.iter().cloned());
            search::prove_throughout(claim, variable)
        };
        let with = |assumed: &[Assumed], signs: &[Formula]| -> Vec<Assumed> {
            assumed
                .iter()
                .cloned()
                .chain(signs.iter().map(condition))
                .collect()
        };
        let signs = signs(&claim, &held);
        let Some((derived, signs)) = search::fewest(signs, |signs| proved(&with(set, signs)))
        else {
            return false;
        };
        let mut undeclared = held.clone();
        undeclared.retain(|own| !claim.is_constant(own));
        let still = undeclared.iter().map(|own| stands_still(own, variable));
        let conditions: Vec<Formula> = still.chain(signs.iter().cloned()).collect();
        if !search::is_possible(&claim, &conditions) {
            return false;
        }
        let combined = (set.iter().enumerate()).filter(|(at, _)| derived.combined.contains(at));
        let combined: Vec<&Formula> = combined.map(|(_, own)| &*own.formula).collect();
        // What follows from two equations is so by both.
        let combined = set.iter().filter(|own| combined.contains(&&*own.formula));
        let combined: Vec<Assumed> = combined.cloned().collect();
        // What comes from nothing that varies needs nothing to stand still.
        let is_of_it = |own: &Formula| own.terms().iter().any(|term| term.mentions(variable));
        if combined.is_empty() && !is_of_it(&goal.formula) {
            return false;
        }
        let few = with(&combined, &signs);
        let (kept, derived) = match proved(&few) {
            Some(derived) => (few, derived),
            None => (with(set, &signs), derived),
        };
        let named = derived.proven.claim().free_symbols();
        undeclared.retain(|own| named.contains(&own));
        found.constant = undeclared;
        found.conditions = signs;
        let cited = sources(&self.usable.assumed);
        let used = sources(&kept);
        found.instead = match used.iter().all(|own| cited.contains(own)) {
            true => Vec::new(),
            false => used,
        };
        found.judged.assumed = kept;
        found.judged.outcome = Outcome::Proven(derived.proven.into());
        true
    }

    /// What to say of a step that nothing decided and that is false where what it is drawn from, a law and a function that is put into it, is so
    /// for every value of a variable: `A = \frac{F}{k + m \omega^2}` from `m \ddot x + k x = F \cos\omega t` and `x = A \cos\omega t`.
    pub(in crate::audit) fn fails_throughout(&self, goal: &Goal) -> Option<Found> {
        // "With the trial solution $x = A \cos\omega t$, (1) becomes"
        let told = self.derivation.told_just_before(self.at).into_iter();
        let set: Vec<Assumed> = self.usable.assumed.iter().cloned().chain(told).collect();
        if !goal.is_said_outright() || goal.formula.speaks_of_slopes() {
            return None;
        }
        let told = Formula::names_in(set.iter().flat_map(|own| own.formula.terms()));
        if !goal.formula.names().is_subset(&told) {
            return None;
        }
        let variables = self.variables_left_out(goal, &set);
        effort::within(MOST_WORK, || {
            let mut variables = variables.iter();
            variables.find_map(|variable| {
                self.fails_beside(self.beside(variable, goal, &set)?, goal, &set)
            })
        })
    }

    /// The same of a step that compares, as words say, what stands before it.
    pub(in crate::audit) fn fails_compared(
        &self,
        goal: &Goal,
        premises: &[usize],
    ) -> Option<Found> {
        if !self.compares() || !goal.is_said_outright() || goal.formula.speaks_of_slopes() {
            return None;
        }
        let cited = &self.usable.assumed;
        let near = self.with_others(cited, premises);
        let set = near.unwrap_or_else(|| cited.clone());
        let compared = self.compared(goal, &set);
        effort::within(MOST_WORK, || {
            (compared.iter()).find_map(|(variable, own)| {
                self.fails_beside(self.beside_compared(variable, goal, own)?, goal, own)
            })
        })
    }

    fn fails_beside(
        &self,
        Beside {
            variable,
            held,
            claim,
        }: Beside,
        goal: &Goal,
        set: &[Assumed],
    ) -> Option<Found> {
        let first = slopes(set, &held, variable);
        if first.is_empty() {
            return None;
        }
        // Where a law is so, and its slopes are, as many as it may take, it is so everywhere.
        let mut all_slopes = first.clone();
        let mut last = first;
        for _ in 1..MOST_SLOPES {
            last = last.iter().filter_map(|own| slope(own, variable)).collect();
            all_slopes.extend(last.iter().cloned());
        }
        let more = all_slopes.into_iter().chain(signs(&claim, &held));
        let all: Vec<Assumed> = set
            .iter()
            .cloned()
            .chain(more.map(|own| step(&own)))
            .collect();
        let larger = self.derivation.claim(self.at, &all, &goal.formula);
        let larger = search::with_constants(larger, held.iter().cloned());
        let Decision::Refuted(refuted) = self.decide(&*self.pose_claim(larger).ok()?) else {
            return None;
        };
        let mut found = Found::open(Judged {
            goal: goal.clone(),
            assumed: set.to_vec(),
            outcome: Outcome::Refuted(refuted.into()),
        });
        found.constant = held;
        found.constant.retain(|own| !claim.is_constant(own));
        Some(found)
    }

    /// Leaves open a step that was refuted at one value of a variable only, where what it is drawn from, or stands before, is so for every
    /// value.
    pub(in crate::audit) fn heed_what_varies(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        premises: &[usize],
        found: &mut Found,
    ) {
        let near = match self.names_its_premises() {
            true => None,
            false => self.with_others(assumed, premises),
        };
        let near = near.unwrap_or_else(|| assumed.to_vec());
        // What only says what something else is bounds nothing that the step speaks of.
        let (own, near) = (&self.binding(goal, assumed), self.binding(goal, &near));
        // What is cited says enough where it is known how that varies.
        let variables = self.variables_left_out(goal, &near);
        let compared = self.compared(goal, &near);
        let how_it_varies = |variable, all| {
            let beside = self.beside(variable, goal, all)?;
            let slopes = slopes(all, &beside.held, variable);
            (!slopes.is_empty()).then_some((all, beside, slopes))
        };
        let how_they_vary = variables.iter().find_map(|variable| {
            let mut all = [own, &near].into_iter();
            all.find_map(|all| how_it_varies(variable, all))
        });
        let how_they_vary = how_they_vary.or_else(|| {
            let mut compared = compared.iter();
            compared.find_map(|(variable, own)| how_it_varies(variable, own))
        });
        let Some((all, beside, slopes)) = how_they_vary else {
            return;
        };
        let Beside {
            variable,
            held,
            claim,
        } = beside;
        // With their slopes laws are said of one point: what they lead elsewhere need not be looked for. Definitions are put in.
        let said = all.iter().filter(|own| !works_out_a_slope(&own.formula));
        let said = said.map(|own| match definition(&own.formula) {
            Some(_) => own.clone(),
            None => step(&own.formula),
        });
        let more = slopes.into_iter().chain(signs(&claim, &held));
        let all: Vec<Assumed> = said.chain(more.map(|own| step(&own))).collect();
        let larger = self.derivation.claim(self.at, &all, &goal.formula);
        let larger = search::with_constants(larger, held);
        let reason = format!(
            "it fails at single values of {}, and may follow from what is so at all of them",
            plain_symbol(variable)
        );
        self.heed_larger(goal, assumed, larger, reason, found);
    }

    /// Premises without those that follow from others, and without those that only give by what a step speaks of something that neither it nor
    /// another premise speaks of, `r = \frac{p}{1 + e \cos\varphi}`: for whatever values of the others they are true.
    fn binding(&self, goal: &Goal, set: &[Assumed]) -> Vec<Assumed> {
        let follows = |own: &Assumed| match own.source {
            Source::Equation(at) => self.is_all(Verdict::Holds, at),
            _ => false,
        };
        let named = goal.formula.names();
        let mut kept: Vec<Assumed> = Vec::new();
        for own in set.iter().filter(|own| !follows(own)) {
            if kept.iter().all(|other| other.formula != own.formula) {
                kept.push(own.clone());
            }
        }
        loop {
            let mut uses: Map<Symbol, usize> = Map::new();
            for symbol in kept.iter().flat_map(|own| own.formula.names()) {
                *uses.entry(symbol).or_insert(0) += 1;
            }
            let is_loose =
                |symbol: &Symbol| !named.contains(symbol) && uses.get(symbol) == Some(&1);
            let all = kept.len();
            kept.retain(|own| !gives_any(&own.formula, is_loose));
            if kept.len() == all {
                return kept;
            }
        }
    }

    /// The variables by which the page differentiates and of which premises speak, but not the step, nor of what changes with them.
    fn variables_left_out(&self, goal: &Goal, set: &[Assumed]) -> Vec<Symbol> {
        let named = goal.formula.names();
        let mut variables = self.auditor.variables(self.at);
        variables.retain(|variable| {
            let moves =
                |own: &Symbol| own == variable || self.auditor.changes(self.at, own, variable);
            !named.iter().any(moves) && set.iter().any(|own| varies(own, variable))
        });
        variables
    }

    /// What is not said to move with a variable. Nothing where that is too much, or nothing.
    fn beside<'a>(&self, variable: &'a Symbol, goal: &Goal, set: &[Assumed]) -> Option<Beside<'a>> {
        let claim = self.derivation.claim(self.at, set, &goal.formula);
        Beside::of(claim, variable, |own| {
            self.auditor.changes(self.at, own, variable)
        })
    }

    /// The same in terms that are compared for every value of the variable: all that has no slope are coefficients.
    fn beside_compared<'a>(
        &self,
        variable: &'a Symbol,
        goal: &Goal,
        set: &[Assumed],
    ) -> Option<Beside<'a>> {
        let claim = self.derivation.claim(self.at, set, &goal.formula);
        Beside::of(claim, variable, |own| {
            self.auditor.writes_slope(self.at, own, variable)
        })
    }
}

/// A claim for every value of a variable, beside which some symbols do not move.
struct Beside<'a> {
    variable: &'a Symbol,
    held: Vec<Symbol>,
    claim: Claim,
}

impl<'a> Beside<'a> {
    fn of(
        claim: Claim,
        variable: &'a Symbol,
        moves: impl Fn(&Symbol) -> bool,
    ) -> Option<Beside<'a>> {
        let named = claim.free_symbols().into_iter();
        let held = named.filter(|&own| own != variable && !is_number(own, &claim) && !moves(own));
        let held: Vec<Symbol> = held.cloned().collect();
        (1..=MOST_HELD).contains(&held.len()).then_some(Beside {
            variable,
            held,
            claim,
        })
    }
}

/// Whether a symbol is a unit or π.
fn is_number(symbol: &Symbol, claim: &Claim) -> bool {
    symbol.is_unit() || search::is_pi(symbol, claim)
}

/// That none of what is held constant, and of which nobody says where it lies, is 0; where roots are taken, that it is positive.
fn signs(claim: &Claim, held: &[Symbol]) -> Vec<Formula> {
    let mut terms = claim.goal.terms().into_iter();
    let takes_roots = terms.any(|term| term.any(&Expr::is_root));
    let mut open = unbounded(claim);
    open.retain(|own| held.contains(own));
    // What the step divides by is told rather than what follows from it.
    sorted::sort_by_key(&mut open, |own| !divides(&claim.goal, own));
    let sign = |symbol: Symbol| match takes_roots {
        true => Formula::positive(Expr::Symbol(symbol)),
        false => Formula::nonzero(Expr::Symbol(symbol)),
    };
    open.into_iter().map(sign).collect()
}

/// Whether a symbol stands in a denominator.
fn divides(goal: &Formula, symbol: &Symbol) -> bool {
    let below = |part: &Expr| matches!(part, Expr::Quotient(_, below) if below.mentions(symbol));
    goal.terms().into_iter().any(|term| term.any(&below))
}

/// Whether a premise is so for every value of a variable, and speaks of it.
fn varies(assumed: &Assumed, variable: &Symbol) -> bool {
    let is_variable = |part: &Expr| matches!(part, Expr::Symbol(own) if own == variable);
    let mut terms = assumed.formula.terms().into_iter();
    assumed.standing == Standing::Identity && terms.any(|term| term.any(&is_variable))
}

/// That a symbol does not change with a variable.
pub(in crate::audit) fn stands_still(symbol: &Symbol, variable: &Symbol) -> Formula {
    let slope = Expr::Symbol(symbol.clone()).differentiated_by(variable);
    Formula::equal(slope, Expr::integer(0))
}

/// How laws change that speak of constants, a variable and what is given by these alone; not of what only gives something so.
fn slopes(all: &[Assumed], held: &[Symbol], variable: &Symbol) -> Vec<Formula> {
    let is_known = |own: &Symbol| own == variable || own.is_unit() || held.contains(own);
    let gives = |law: &Assumed| match law.formula.as_equation()? {
        (Expr::Symbol(symbol), term) if term.free_symbols().iter().all(is_known) => {
            Some(symbol.clone())
        }
        _ => None,
    };
    let laws = all.iter().filter(|own| own.standing == Standing::Identity);
    let given: Set<Symbol> = laws.clone().filter_map(gives).collect();
    let is_explicit = |law: &&Assumed| {
        let named = law.formula.names();
        let varies = |own: &Symbol| own == variable || given.contains(own);
        named.iter().any(varies)
            && named.iter().all(|own| is_known(own) || given.contains(own))
            && !law.formula.speaks_of_values()
    };
    let laws = laws.filter(|law| gives(law).is_none() && !works_out_a_slope(&law.formula));
    let laws = laws.filter(is_explicit);
    laws.filter_map(|law| slope(&law.formula, variable))
        .collect()
}

/// Whether an equation says nothing but what the slope of a term is, `\frac{d}{dz} (R^2 + z^2)^{-1} = …`: that ties nothing to anything.
fn works_out_a_slope(law: &Formula) -> bool {
    let Some((Expr::Derivative { body, .. }, value)) = law.as_equation() else {
        return false;
    };
    let mut inner = &**body;
    while let Expr::Derivative { body, .. } = inner {
        inner = body;
    }
    let is_name = matches!(inner, Expr::Symbol(_) | Expr::Apply(..));
    let named = inner.free_symbols();
    !is_name && value.free_symbols().iter().all(|own| named.contains(own))
}

/// Both sides of an equation differentiated.
pub(in crate::audit) fn slope(law: &Formula, variable: &Symbol) -> Option<Formula> {
    let (left, right) = law.as_equation()?;
    let slope = |side: &Expr| side.clone().differentiated_by(variable);
    Some(Formula::equal(slope(left), slope(right)))
}

/// Whether an equation gives one of some symbols, or how it changes, by others: `E I \frac{d^2 w}{dx^2} = M`.
fn gives_any(formula: &Formula, is_meant: impl Fn(&Symbol) -> bool) -> bool {
    fn given(side: &Expr) -> Option<&Symbol> {
        match side {
            Expr::Symbol(symbol) => Some(symbol),
            Expr::Derivative { body, .. } => given(body),
            Expr::Product(factors) => {
                let mut slopes = factors
                    .iter()
                    .filter(|own| matches!(own, Expr::Derivative { .. }));
                let slope = slopes.next()?;
                slopes.next().is_none().then(|| given(slope))?
            }
            _ => None,
        }
    }
    let gives = |side: &Expr, other: &Expr| {
        given(side).is_some_and(|own| is_meant(own) && !other.mentions(own))
    };
    let sides = formula.as_equation();
    sides.is_some_and(|(left, right)| gives(left, right) || gives(right, left))
}
