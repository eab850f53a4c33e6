//! What something is solved for, under a name of its own: "Setting $y = 0$ in (1), we find the time of flight $$T = 2 v_0/g$$" after
//! `y = v_0 t - \frac{1}{2} g t^2`.
//!
//! A new symbol alone on the left would be defined by what stands for it. Where the words just before set what a law speaks of to a value, and
//! what is printed is made of what else the law speaks of, the new symbol is the value there of what is gone. It is told to be wrong only where
//! one symbol alone is gone, and something else follows for it in the same symbols.

use crate::algebra::{Expr, Formula, Symbol, effort};
use crate::derivation::{Assumed, Goal, Source};
use crate::sorted::Set;

use super::super::judge::{Judge, step};
use super::super::stated::quantities;
use super::there::{Asked, MayFail, There};

/// So many symbols may be what is solved for.
const MOST_UNKNOWNS: usize = 3;
/// So much work is done for each of them, as [`effort`] counts it.
const MOST_WORK: u64 = 1_000_000;

impl Judge<'_> {
    /// What would define a new symbol by its first link, judged as the value of what the words solve for; nothing where they do not.
    pub(in crate::audit) fn as_solved(&self, goal: &Goal, premises: &[usize]) -> Option<There> {
        let (Expr::Symbol(new), value) = goal.formula.as_equation()? else {
            return None;
        };
        let named = quantities(value);
        let is_new = self.derivation.equations[self.at].introduces.contains(new);
        if !is_new || named.is_empty() {
            return None;
        }
        let mut assumed = self.cited(goal, &[]);
        let mut set = Set::new();
        for own in self.said_of_the_place() {
            set.extend(value_said(&own));
            if !assumed.contains(&own) {
                assumed.push(own);
            }
        }
        let fresh = assumed.iter().filter(|own| self.is_said_just_before(own));
        set.extend(fresh.filter_map(value_said));
        eprintln!("DBG {new} set {set:?} assumed {:?}", assumed.iter().map(|a| format!("{:?} {:?}", a.source, a.formula)).collect::<Vec<_>>());
        if set.is_empty() {
            return None;
        }
        // Who cites nothing means what stands just before.
        if !assumed.iter().any(is_displayed) {
            let nearest = self.others(premises)[0].iter();
            let mut speaking = nearest.filter(|own| is_displayed(own));
            let first = speaking.next().map(|own| own.source);
            let nearest = self.others(premises)[0].iter();
            assumed.extend(nearest.filter(|own| Some(own.source) == first).cloned());
        }
        let spoken: Set<Symbol> = assumed.iter().flat_map(|own| own.formula.names()).collect();
        let is_gone =
            |own: &Symbol| own != new && !named.contains(own) && !set.contains(own) && !own.is_unit();
        let gone: Vec<Symbol> = spoken.into_iter().filter(is_gone).collect();
        if gone.len() > MOST_UNKNOWNS {
            return None;
        }
        let is_value_of = |unknown: &Symbol| {
            Formula::equal(Expr::Symbol(new.clone()), Expr::Symbol(unknown.clone()))
        };
        for unknown in &gone {
            let same = [(goal.clause, is_value_of(unknown))];
            let found = effort::within(MOST_WORK, || self.goal(goal, &same, premises));
            let is_elsewhere = |own: &Assumed| self.is_of_case_before(own);
            if found.judged.outcome.is_proven() && !found.judged.assumed.iter().any(is_elsewhere) {
                return Some(There::Solved(found.into()));
            }
        }
        let [unknown] = &gone[..] else {
            return None;
        };
        let asked = Asked {
            new,
            named: &named,
            quantity: Some(unknown),
        };
        assumed.push(step(&is_value_of(unknown)));
        let found = self.judged_there(goal, assumed, premises, &asked, MayFail::InTheSameSymbols);
        found.filter(|own| matches!(own, There::Refuted(_)))
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
        let said = self.derivation.local(page, local).span.start;
        let before = self.derivation.before_display(self.at);
        let before = before.map(|before| self.derivation.equations[before].span.end);
        before.is_none_or(|before| before <= said)
    }
}

fn is_displayed(own: &Assumed) -> bool {
    matches!(own.source, Source::Equation(_))
}

/// The symbol of which a hypothesis gives the value.
fn value_said(own: &Assumed) -> Option<Symbol> {
    match own.formula.as_equation()? {
        (Expr::Symbol(symbol), _) => Some(symbol.clone()),
        _ => None,
    }
}
