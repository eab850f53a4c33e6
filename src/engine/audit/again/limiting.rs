//! Steps that are said of a limit: "In the limit $M \to \infty$ we get $$v = -u$$".
//!
//! Such a step is no equation at any point, and none refutes it. What its premises say that the left side is has a limit, exactly, and
//! that is compared with the right side.

use crate::algebra::{Expr, Formula, LimitPoint, Relation, Symbol};
use crate::derivation::{Approach, Assumed, Goal, Source};
use crate::kernel::definition;
use crate::search::{self, Decision};

use super::super::judge::{Found, Judge, condition, sources, step};
use super::super::{Judged, Outcome};
use super::throughout::stands_still;
use crate::sorted::Set;

/// How many definitions are put in one after another.
const MOST_PUT_IN: usize = 8;
/// How many ways to read what goes where are tried.
const MOST_READINGS: usize = 4;
/// Why a step that is said of a limit is neither.
const OPEN: &str = "it is said of a limit, and what that is could not be told";

impl Judge<'_> {
    /// The variable that grows without bound in a step that was proved from what words say that the variable is: "For $C_1 = C_2$" is not
    /// said where `C_2 \to \infty`.
    pub(in crate::audit) fn ties_what_grows(&self, judged: &Judged) -> Option<Symbol> {
        let is_told = |variable: &Symbol| {
            let mut told = judged.assumed.iter();
            told.any(|own| is_told_of(own, variable))
        };
        let (left, right) = judged.goal.formula.as_equation()?;
        [left, right].into_iter().find_map(|side| match side {
            Expr::Limit {
                variable,
                point: LimitPoint::PlusInfinity | LimitPoint::MinusInfinity,
                ..
            } => is_told(variable).then(|| variable.clone()),
            _ => None,
        })
    }

    /// What becomes of a goal that is not proved where it stands, if it is said of a limit: it holds if it does as one of the limits
    /// that may be meant, and fails if it does as none.
    pub(in crate::audit) fn in_limit(
        &self,
        goal: &Goal,
        premises: &[usize],
        found: &Found,
    ) -> Option<Found> {
        let readings = self.derivation.approached(self.at);
        if readings.is_empty() || !goal.suppositions.is_empty() {
            return None;
        }
        let mut refuted = None;
        let mut is_open = readings.len() > MOST_READINGS;
        let mut is_told = false;
        let told = self.derivation.told(self.at);
        let named = self.with_what_is_named(goal, &self.usable.assumed, premises);
        let assumed = named.as_ref().unwrap_or(&self.usable.assumed);
        let cited: Vec<&Assumed> = assumed.iter().chain(&told).collect();
        for approach in readings.iter().take(MOST_READINGS) {
            let Some((limit, used)) = as_limit(goal, approach, &cited) else {
                continue;
            };
            is_told = true;
            let own = self.judged_as_limit(goal, limit, assumed, &used, approach);
            match own.judged.outcome {
                Outcome::Proven(_) => return Some(own),
                // What else the text says there may be meant, too.
                Outcome::Refuted(_) if self.says_more_than(&own.judged.assumed, approach) => {
                    is_open = true;
                }
                Outcome::Refuted(_) => refuted = refuted.or(Some(own)),
                _ => is_open = true,
            }
        }
        if is_told && !is_open {
            return refuted;
        }
        if !is_told && let Some(own) = self.in_limit_of_others(goal, premises, assumed, &readings) {
            return Some(own);
        }
        found.judged.outcome.is_refuted().then(|| {
            let mut open = Found::open(found.judged.clone());
            open.leave_open(OPEN);
            open
        })
    }

    /// Whether the text says something beside a limit that a counterexample does not heed.
    fn says_more_than(&self, assumed: &[Assumed], approach: &Approach) -> bool {
        let said = self.derivation.said_with_limit(self.at);
        said.iter().any(|own| {
            let is_limit = own.names().contains(&approach.variable);
            !is_limit && !assumed.iter().any(|known| *known.formula == *own)
        })
    }

    /// The same of what stands before and is not cited, where nothing that is cited says what the left side is; that refutes nothing.
    fn in_limit_of_others(
        &self,
        goal: &Goal,
        premises: &[usize],
        assumed: &[Assumed],
        readings: &[Approach],
    ) -> Option<Found> {
        let here = self.derivation.equations[self.at].page;
        let is_here = |own: &&Assumed| match own.source {
            Source::Equation(at) => self.derivation.equations[at].page == here,
            _ => true,
        };
        let open = self.open_before(premises);
        let supposed = assumed.iter();
        let supposed = supposed.filter(|own| matches!(own.source, Source::Local(..)));
        let supposed: Vec<Assumed> = supposed.cloned().collect();
        let others = self.others(premises).iter().flatten().chain(&open);
        let others = others.filter(is_here).chain(&supposed);
        let others: Vec<&Assumed> = others.collect();
        for approach in readings.iter().take(MOST_READINGS) {
            let Some((limit, used)) = as_limit(goal, approach, &others) else {
                continue;
            };
            let mut own = self.judged_as_limit(goal, limit, &supposed, &used, approach);
            if own.judged.outcome.is_proven() {
                own.instead = sources(&used);
                return Some(own);
            }
        }
        None
    }

    /// The limit judged from what does not speak of what moves. All else that it speaks of stays where it is.
    pub(in crate::audit) fn judged_as_limit(
        &self,
        goal: &Goal,
        limit: Formula,
        assumed: &[Assumed],
        used: &[Assumed],
        approach: &Approach,
    ) -> Found {
        let variable = &approach.variable;
        let mut assumed: Vec<Assumed> = assumed.to_vec();
        assumed.retain(|own| !own.formula.names().contains(variable) && !used.contains(own));
        let others = limit.free_symbols().into_iter();
        let others = others.filter(|own| own != variable && !own.is_unit());
        assumed.extend(others.map(|own| condition(&stands_still(&own, variable))));
        let goal = Goal {
            formula: limit,
            ..goal.clone()
        };
        let mut found = Found::open(Judged {
            goal: goal.clone(),
            assumed: assumed.clone(),
            outcome: Outcome::open(OPEN),
        });
        let claim = self.derivation.claim(self.at, &assumed, &goal.formula);
        let Ok(posed) = search::pose(claim) else {
            return found;
        };
        match self.decide(&posed) {
            Decision::Proven {
                derived,
                conditions,
            } if conditions.is_empty() => {
                let (kept, least) = self.least(assumed, &goal, &posed, derived);
                let is_cited = |own: &Assumed| !own.source.is_of_statement();
                if kept.iter().any(is_cited) && self.contradicts_itself(&posed) {
                    return found;
                }
                found.judged.assumed = kept;
                found.judged.outcome = Outcome::Proven(least.into());
            }
            Decision::Proven {
                derived,
                conditions,
            } => {
                found.judged.assumed.extend(conditions.iter().map(step));
                if self.is_contradictory(&found.judged.assumed, &goal) {
                    return found;
                }
                found.conditions = conditions;
                found.judged.outcome = Outcome::Proven(derived.proven.into());
            }
            Decision::Refuted(refuted) => found.judged.outcome = Outcome::Refuted(refuted.into()),
            Decision::Open(_) => {}
        }
        // What was put in comes after the hypotheses of the claim.
        found.judged.assumed.extend_from_slice(used);
        found
    }
}

/// `\lim v = -u`, of what premises say that `v` is, with those that say so.
fn as_limit(goal: &Goal, approach: &Approach, all: &[&Assumed]) -> Option<(Formula, Vec<Assumed>)> {
    let Formula::Relation {
        left,
        relation,
        right,
    } = &goal.formula
    else {
        return None;
    };
    let variable = &approach.variable;
    let compares = matches!(relation, Relation::Equal | Relation::Approximately);
    if !compares || right.mentions(variable) || matches!(left, Expr::Symbol(own) if own == variable)
    {
        return None;
    }
    // What the right side speaks of is meant to stay.
    let mut kept = right.free_symbols();
    kept.insert(variable.clone());
    // What goes somewhere with the variable is what is asked for.
    let (body, used) = written_out(left, &kept, all, &|value| value.mentions(variable));
    let limit = Expr::Limit {
        variable: variable.clone(),
        point: approach.point.clone(),
        body: body.clone().into(),
    };
    let is_function = body.mentions(variable);
    is_function.then(|| (Formula::equal(limit, right.clone()), used))
}

/// A term with what premises say that the symbols in it are, and those that say so; what is kept stays. Values that are preferred are put in
/// before others.
pub(super) fn written_out(
    term: &Expr,
    kept: &Set<Symbol>,
    all: &[&Assumed],
    is_preferred: &dyn Fn(&Expr) -> bool,
) -> (Expr, Vec<Assumed>) {
    let (mut body, mut used) = (term.clone(), Vec::<Assumed>::new());
    for _ in 0..MOST_PUT_IN {
        let of_body = body.free_symbols();
        let definitions = all.iter().filter_map(|own| {
            let (symbol, value) = definition(&own.formula)?;
            let is_open = of_body.contains(&symbol) && !kept.contains(&symbol);
            let is_new = is_open && !used.contains(own);
            is_new.then(|| ((*own).clone(), symbol, value))
        });
        let preferred = |(_, _, value): &(Assumed, Symbol, Expr)| is_preferred(value);
        let found = (definitions.clone().find(preferred)).or_else(|| definitions.clone().next());
        let Some((own, symbol, value)) = found else {
            break;
        };
        body = body.substitute(&symbol, &value);
        used.push(own);
    }
    (body, used)
}

/// Whether words, and no equation, say what a symbol is.
pub(in crate::audit) fn is_told_of(own: &Assumed, symbol: &Symbol) -> bool {
    let is_local = matches!(own.source, Source::Local(..));
    is_local && own.formula.as_equation().is_some() && own.formula.names().contains(symbol)
}
