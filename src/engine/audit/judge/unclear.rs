//! What makes a verdict doubtful: complex numbers and small changes, partial derivatives that hold nobody knows what fixed, what is constant here and changes there.

use std::cell::LazyCell;

use num_traits::Zero;

use crate::algebra::{Expr, Formula, Relation, Symbol};
use crate::derivation::{Assumed, Beyond, Goal, Source, formulas};
use crate::kernel::Standing;
use crate::notation::{has_decimals, is_figures};
use crate::sorted::Set;

use super::super::{Judged, Outcome, Verdict};
use super::{Found, Judge, sources};

/// So many equations of sections that are over are looked at for what rests on what is left.
const MOST_OVER: usize = 256;

impl Judge<'_> {
    /// Whether something speaks of a partial derivative of which it is not clear what it holds fixed, or how it moves: that
    /// `\frac{d}{dt} \frac{\partial L}{\partial \dot x}` goes with `\ddot x` is nowhere said.
    pub(super) fn is_unclear(&self, judged: &Judged) -> bool {
        let page = self.derivation.equations[self.at].page;
        let unclear = &self.derivation.pages[page].unclear_slopes;
        if self.derivation.pages[page].dependent.is_empty() {
            return false;
        }
        let is_partial = |part: &Expr| matches!(part, Expr::Partial { .. });
        let is_one = |part: &Expr| match part {
            Expr::Derivative { body, .. } => body.any(&is_partial),
            Expr::Partial { body, variable, .. } => unclear
                .iter()
                .any(|(name, own)| own == variable && body.mentions(name)),
            _ => false,
        };
        // What was left out of the counterexample may be what it was to be drawn from.
        let assumed = judged.assumed.iter().chain(&self.usable.assumed);
        let formulas = assumed.map(|own| &*own.formula);
        let mut all = formulas.chain([&judged.goal.formula]);
        all.any(|formula| formula.terms().into_iter().any(|term| term.any(&is_one)))
    }

    /// What two of the premises of a proof that nobody cites give differently, and one of them in a section that is over, the moment `M` of
    /// one load and of another: that, and what equations of that section say it.
    pub(super) fn joins_two_sections(
        &self,
        judged: &Judged,
        premises: &[usize],
    ) -> Option<(Expr, Set<usize>)> {
        let derivation = self.derivation;
        let own = derivation.section_start(self.at);
        let given = judged.assumed.iter().filter_map(|own| match own.source {
            // What is derived of the one is so of the other.
            Source::Equation(at) if !self.is_derived(at) => {
                let (of, value) = own.formula.as_equation()?;
                let is_name = matches!(of, Expr::Symbol(_) | Expr::Limit { .. } | Expr::Apply(..));
                is_name.then_some((at, of, value))
            }
            _ => None,
        });
        let given: Vec<(usize, &Expr, &Expr)> = given.collect();
        let is_other = |(at, of, value): &&(usize, &Expr, &Expr)| {
            let mut others = given.iter();
            *at < own
                && !premises.contains(at)
                && others
                    .any(|(other, also, another)| *other >= own && also == of && another != value)
        };
        let over: Vec<&(usize, &Expr, &Expr)> = given.iter().filter(is_other).collect();
        let first = over.first()?.1.clone();
        Some((first, over.iter().map(|own| own.0).collect()))
    }

    /// Of equations that contradict one another those that hold in a range of their own, where the step says in what range it holds:
    /// "$$E = -a (x + p), \quad -p < x < 0$$" beside "$$E = -b (q - x), \quad 0 < x < q$$".
    pub(super) fn of_other_ranges(&self, contradictory: &[Source]) -> Set<usize> {
        if contradictory.is_empty() {
            return Set::new();
        }
        let bounded = |at: usize| -> Set<Symbol> {
            let said = self.derivation.equations[at]
                .statements()
                .iter()
                .flat_map(formulas);
            let bounds = said.filter(Formula::is_inequality);
            let (lesser, greater): (Vec<_>, Vec<_>) = bounds
                .filter_map(|own| match own {
                    Formula::Relation {
                        left,
                        relation,
                        right,
                    } => Some(match relation {
                        Relation::Less | Relation::LessOrEqual => (left, right),
                        _ => (right, left),
                    }),
                    Formula::AllEqual { .. } => None,
                })
                .unzip();
            let between = greater.into_iter().filter(|own| lesser.contains(own));
            between
                .filter_map(|own| match own {
                    Expr::Symbol(own) => Some(own),
                    _ => None,
                })
                .collect()
        };
        let own = bounded(self.at);
        let others = contradictory.iter().filter_map(|source| match source {
            Source::Equation(at) if *at != self.at => Some(*at),
            _ => None,
        });
        others
            .filter(|&at| !self.over.contains(&at) && bounded(at).iter().any(|of| own.contains(of)))
            .collect()
    }

    /// Whether an equation before follows from others.
    fn is_derived(&self, at: usize) -> bool {
        let mut entries = self.auditor.entries_of(self.at, at);
        entries.any(|entry| entry.verdict == Verdict::Holds)
    }

    /// The goal judged without what a section says that is over, and what was derived from that there.
    pub(super) fn without_what_is_over(
        &self,
        goal: &Goal,
        steps: &[(usize, Formula)],
        premises: &[usize],
        over: Set<usize>,
    ) -> Found {
        let own = self.derivation.section_start(self.at);
        // What was left before is left still, so that there is an end to it.
        let mut over: Set<usize> = over.into_iter().chain(self.over.clone()).collect();
        let first = over.first().copied().unwrap_or(own);
        for at in first.max(own.saturating_sub(MOST_OVER))..own {
            let mut entries = self.auditor.entries_of(self.at, at);
            if entries.any(|entry| entry.premises.iter().any(|premise| over.contains(premise))) {
                over.insert(at);
            }
        }
        let mut usable = self.usable.clone();
        let is_over =
            |own: &Assumed| matches!(own.source, Source::Equation(at) if over.contains(&at));
        usable.assumed.retain(|own| !is_over(own));
        let without = Judge {
            over,
            ..Judge::new(self.auditor, self.at, &usable)
        };
        without.goal(goal, steps, premises)
    }

    /// What is constant by one of the premises of a proof and changes by another.
    pub(super) fn joins_what_moves(&self, judged: &Judged) -> Option<&Symbol> {
        let all = sources(&judged.assumed).into_iter();
        let all: Vec<usize> = all
            .filter_map(|source| match source {
                Source::Equation(premise) => Some(premise),
                _ => None,
            })
            .collect();
        let derivation = self.derivation;
        let constant = all
            .iter()
            .find_map(|&own| derivation.is_released(self.at, own));
        constant.filter(|&symbol| {
            let mut own = all.iter().map(|&own| &derivation.equations[own]);
            own.any(|own| own.released.contains(symbol) && own.symbols().contains(symbol))
        })
    }

    /// Leaves open a step that puts numbers in for something that it does not name: "the torque must be
    /// $$\Gamma = R m (0.357 - 0.342)$$".
    pub(super) fn heed_figures_put_in(&self, goal: &Goal, found: &mut Found) {
        let is_difference = |part: &Expr| match part {
            Expr::Sum(parts) => {
                is_figures(part)
                    && parts.iter().all(has_decimals)
                    && parts.iter().any(|own| matches!(own, Expr::Negate(_)))
            }
            _ => false,
        };
        let terms = goal.formula.terms();
        let are_put_in = |term: &&Expr| !is_figures(term) && term.any(&is_difference);
        if found.mended.is_none() && terms.into_iter().any(|term| are_put_in(&term)) {
            found.leave_open("it puts numbers in for something, and does not say for what");
        }
    }

    /// Whether a goal speaks of what may be complex, or of small changes.
    pub(in crate::audit) fn beyond(&self, goal: &Goal) -> Option<Beyond> {
        let page = self.derivation.equations[self.at].page;
        self.derivation.pages[page].beyond(&goal.formula)
    }

    /// What a counterexample holds constant in a limit or integral of the goal, and the page lets change with what runs there: `u(0)` of
    /// a profile `u(r)`.
    pub(in crate::audit) fn held_and_moving(&self, judged: &Judged) -> Option<Symbol> {
        let Outcome::Refuted(refuted) = &judged.outcome else {
            return None;
        };
        // Few goals have a limit or an integral.
        let said = LazyCell::new(|| {
            (self.derivation).claim(self.at, &judged.assumed, &judged.goal.formula)
        });
        let is_held = |own: &Symbol| refuted.claim().is_constant(own) && !said.is_constant(own);
        let moves = |part: &Expr| {
            let (Expr::Limit { body, variable, .. } | Expr::Integral { body, variable, .. }) = part
            else {
                return None;
            };
            let mut names = body.free_symbols().into_iter();
            let moves = |own: &Symbol| is_held(own) && self.auditor.changes(self.at, own, variable);
            names.find(moves)
        };
        let mut terms = judged.goal.formula.terms().into_iter();
        terms.find_map(|term| term.first(&moves))
    }

    /// Whether a step takes slopes or integrals, and it cannot be told whether something in it changes.
    pub(super) fn is_disputed(&self, judged: &Judged) -> bool {
        let disputed = &self.derivation.equations[self.at].disputed;
        let runs = |part: &Expr| matches!(part, Expr::Derivative { .. } | Expr::Integral { .. });
        let formulas = judged.assumed.iter().map(|own| &*own.formula);
        let mut all = formulas.chain([&judged.goal.formula]);
        let goal = judged.goal.formula.terms();
        !disputed.is_empty()
            && goal.into_iter().any(|term| term.any(&runs))
            && all.any(|formula| !formula.names().is_disjoint(disputed))
    }
}

/// A symbol that a goal speaks of beside others, and of which a premise only says that its square is 0: the `k^2 = 0` of a photon's four-momentum.
pub(super) fn squared_to_nought(judged: &Judged) -> Option<Symbol> {
    let names = judged.goal.formula.names();
    let squared = |own: &Assumed| match own.formula.as_equation()? {
        (Expr::Power(base, exponent), nought) => match &**base {
            Expr::Symbol(symbol)
                if **exponent == Expr::integer(2) && *nought == Expr::integer(0) =>
            {
                Some(symbol.clone())
            }
            _ => None,
        },
        _ => None,
    };
    let mut squared = judged.assumed.iter().filter_map(squared);
    squared.find(|own| names.len() > 1 && names.contains(own))
}

/// Whether a goal takes the slope of something that is given by a term at one point alone: what its slope is there, that does not say.
pub(super) fn takes_slope_at_a_point(judged: &Judged) -> bool {
    let at_point =
        |own: &&Assumed| own.standing == Standing::AtPoint && !own.source.is_of_statement();
    let at_point = judged.assumed.iter().filter(at_point);
    let mut given = at_point.filter_map(|own| own.formula.as_equation());
    let takes = |left: &Expr, right: &Expr| {
        let is_slope = |part: &Expr| match part {
            Expr::Derivative { body, variable } => **body == *left && right.mentions(variable),
            _ => false,
        };
        let mut terms = judged.goal.formula.terms().into_iter();
        terms.any(|term| term.any(&is_slope))
    };
    given.any(|(left, right)| takes(left, right))
}

/// What a goal takes the slope of, if that is given twice, by a term with the variable and by one without: what is constant in a counterexample
/// by the second is not by the first, `\theta = T - T_0` beside `\theta = \theta_0 e^{-x/a}`.
pub(super) fn moves_unseen(judged: &Judged) -> Option<Expr> {
    let given = |of: &Expr, variable: &Symbol, moves: bool| {
        let mut assumed = judged.assumed.iter();
        assumed.any(|own| match own.formula.as_equation() {
            Some((left, right)) => left == of && right.mentions(variable) == moves,
            None => false,
        })
    };
    let unseen = |part: &Expr| match part {
        Expr::Derivative { body, variable } if matches!(**body, Expr::Symbol(_)) => {
            let is_unseen = given(body, variable, true) && given(body, variable, false);
            is_unseen.then(|| (**body).clone())
        }
        _ => None,
    };
    let mut terms = judged.goal.formula.terms().into_iter();
    terms.find_map(|term| term.first(&unseen))
}

/// Whether it says that a value at a place is 0, which the link before has worked out: `\dot x(0) = -A (\gamma \cos\phi + \omega \sin\phi) = 0`
/// is how `\phi` is chosen.
pub(super) fn prescribes(judged: &Judged) -> bool {
    let Some((worked_out, Expr::Number(nought))) = judged.goal.formula.as_equation() else {
        return false;
    };
    let mut steps = judged
        .assumed
        .iter()
        .filter(|own| own.source == Source::Step);
    nought.is_zero()
        && steps.any(|own| {
            let said = own.formula.as_equation();
            said.is_some_and(|(left, right)| left.is_value_somewhere() && right == worked_out)
        })
}

/// What a goal speaks of, if what it is drawn from tells only how it changes, by its differential: `A = \dots` after `\sigma\,dA` may be
/// another thing.
pub(super) fn only_changes(judged: &Judged) -> Option<Symbol> {
    let is_told = |own: &Symbol| {
        let mut assumed = judged.assumed.iter().flat_map(|own| own.formula.terms());
        assumed.any(|term| stands_in(term, own))
    };
    let changes = |own: &Symbol| {
        let is_differential =
            |part: &Expr| part.as_differential().is_some_and(|of| of.mentions(own));
        let mut assumed = judged.assumed.iter().flat_map(|own| own.formula.terms());
        assumed.any(|term| term.any(&is_differential))
    };
    let terms = judged.goal.formula.terms();
    let names = judged.goal.formula.free_symbols().into_iter();
    let mut spoken_of = names.filter(|own| terms.iter().any(|term| stands_in(term, own)));
    spoken_of.find(|own| changes(own) && !is_told(own))
}

/// Whether a symbol stands in a term outside of differentials.
fn stands_in(term: &Expr, symbol: &Symbol) -> bool {
    match term {
        Expr::Symbol(own) | Expr::Apply(own, _) if own == symbol => true,
        term if term.as_differential().is_some() => false,
        term => term.children().any(|part| stands_in(part, symbol)),
    }
}
