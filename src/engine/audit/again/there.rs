//! What a quantity is at a place: `P_{\max}` is what `P` is where it is greatest, `y_L` what `y` is "at the free end, $x = L$".
//!
//! A new symbol with an index would be defined by what stands for it. Where the quantity itself is known, and what is cited or named
//! says where, that is the step from the one to the other, and it is judged as one. It is refuted only where what follows instead
//! speaks of the same symbols: what is left of others would say that the place was not found. A step that says something else of the
//! new symbol, `v_a^2 = g a`, may follow from a law for the quantity without the index.

use crate::algebra::{Expr, Formula, Symbol, split_subscript};
use crate::derivation::{Assumed, Goal, Source};
use crate::kernel::Standing;
use crate::search::{Decision, Effort};
use crate::sorted::Set;

use super::super::instances::index;
use super::super::judge::{Found, Judge, step};
use super::super::stated::quantities;
use super::super::{Judged, Outcome};

/// So many equations are looked up that say what the quantity is, the nearest first.
const MOST_MEANINGS: usize = 2;
/// Indices of what is at its most or least.
const EXTREMES: [&str; 6] = ["\\max", "\\min", "max", "min", "\\text{max}", "\\text{min}"];

/// What is found of a symbol that a step would define.
pub(in crate::audit) enum There {
    /// It is what the quantity is there.
    Shown,
    /// It is not.
    Refuted(Box<Found>),
}

impl Judge<'_> {
    /// What would define a symbol by its first link, judged as the value of the quantity without the index.
    pub(in crate::audit) fn as_value_there(
        &self,
        goal: &Goal,
        premises: &[usize],
    ) -> Option<There> {
        let (Expr::Symbol(new), value) = goal.formula.as_equation()? else {
            return None;
        };
        let named = quantities(value);
        let quantity = new.without_subscript()?;
        let is_new = self.derivation.equations[self.at].introduces.contains(new);
        if !is_new || named.is_empty() || named.contains(&quantity) {
            return None;
        }
        let cited = self.cited(goal, &[]);
        let words = self.said_of_the_place();
        let meanings = self.meanings(&quantity, &cited, premises);
        if meanings.is_empty() {
            return None;
        }
        let is_place = !words.is_empty() || self.names_its_premises() || is_extreme(new);
        let mut assumed: Vec<Assumed> = Vec::new();
        for own in cited
            .into_iter()
            .chain(words)
            .chain(meanings.iter().cloned())
        {
            if !own.formula.speaks_of_slopes() && !assumed.contains(&own) {
                assumed.push(own);
            }
        }
        let same = Formula::equal(Expr::Symbol(new.clone()), Expr::Symbol(quantity.clone()));
        assumed.push(step(&same));
        match self.decide_from(&assumed, &goal.formula)? {
            Decision::Proven { .. } => Some(There::Shown),
            Decision::Refuted(refuted) if is_place && self.is_put(&meanings, &quantity, &named) => {
                let mut found = Found::open(Judged {
                    goal: goal.clone(),
                    assumed: assumed.clone(),
                    outcome: Outcome::Refuted(refuted.into()),
                });
                self.instead(goal, &assumed, premises, &mut found);
                found.gives(&named).then(|| There::Refuted(found.into()))
            }
            _ => None,
        }
    }

    /// Whether a step follows that says what a new symbol is at a place, where that is said without the index of laws in force there: "At
    /// $r = a$ this gives $$v_a^2 = g a$$" after `v^2 = g r`. What does not follow may be said of something else.
    pub(in crate::audit) fn follows_at_place(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        found: &mut Found,
    ) -> bool {
        let names = goal.formula.names();
        let new = &self.derivation.equations[self.at].introduces;
        let mut new = names.iter().filter(|own| new.contains(*own));
        let (Some(new), None) = (new.next(), new.next()) else {
            return false;
        };
        let quantity = new.without_subscript().filter(|_| index(new).is_some());
        let Some(plain) = quantity else {
            return false;
        };
        // What is put in there is gone.
        let is_place = |own: &Assumed| match (own.source, own.formula.as_equation()) {
            (Source::Local(..), Some((Expr::Symbol(at), value))) => {
                !names.contains(at) && !value.mentions(at) && *at != plain
            }
            _ => false,
        };
        let places: Vec<&Assumed> = assumed.iter().filter(|own| is_place(own)).collect();
        if names.contains(&plain) || places.is_empty() {
            return false;
        }
        let of_place = |law: &Assumed| {
            let said = law.formula.names();
            let mut places = places.iter().flat_map(|own| own.formula.names());
            matches!(law.source, Source::Equation(_))
                && said.contains(&plain)
                && places.any(|own| said.contains(&own))
        };
        let put = Expr::Symbol(new.clone());
        let laws = assumed.iter().filter(|law| of_place(law));
        let said = laws.map(|law| Assumed {
            formula: law
                .formula
                .map_terms(|term| term.substitute(&plain, &put))
                .into(),
            standing: Standing::AtPoint,
            ..law.clone()
        });
        let said: Vec<Assumed> = said.collect();
        let all = || assumed.iter().cloned().chain(said.clone()).collect();
        !said.is_empty() && self.holds_under(goal, all(), &[], Effort::Light, found)
    }

    /// Whether something is gone from all that says what a quantity is: something that has a value at the place.
    fn is_put(&self, meanings: &[Assumed], quantity: &Symbol, named: &Set<Symbol>) -> bool {
        meanings.iter().all(|own| {
            let spoken_of = own.formula.names();
            let mut rest = spoken_of.iter().filter(|own| *own != quantity);
            rest.any(|own| !named.contains(own))
        })
    }

    /// What the words before a step tell, name or mention: "At the free end, $x = L$".
    fn said_of_the_place(&self) -> Vec<Assumed> {
        let mut words = self.derivation.told(self.at);
        words.extend(self.derivation.named(self.at));
        let mentioned = self.derivation.mentioned(self.at).into_iter();
        words.extend(mentioned.map(|(_, formula)| step(&formula)));
        words.retain(|own| own.formula.as_equation().is_some());
        words
    }

    /// What says by a term what a quantity is, in what is cited and else in what stands before, the whole chain.
    fn meanings(&self, quantity: &Symbol, cited: &[Assumed], premises: &[usize]) -> Vec<Assumed> {
        let says = |own: &&Assumed| {
            let sides = own.formula.as_equation();
            let (Some((Expr::Symbol(left), right)), Source::Equation(_)) = (sides, own.source)
            else {
                return false;
            };
            left == quantity && !right.mentions(quantity)
        };
        let [others, _] = self.others(premises);
        let all = || cited.iter().chain(others);
        let mut chains: Vec<Source> = all().filter(says).map(|own| own.source).collect();
        chains.truncate(MOST_MEANINGS);
        let of_chains = all().filter(|own| chains.contains(&own.source));
        of_chains.cloned().collect()
    }
}

impl Found {
    /// Whether something follows in the place of what was refuted, in just these symbols.
    fn gives(&self, named: &Set<Symbol>) -> bool {
        let in_these = |formula: &Formula| {
            let sides = formula.as_equation();
            sides.is_some_and(|(_, value)| quantities(value) == *named)
        };
        let implied = self.implied.as_ref().map(|own| &own.proven);
        let mended = self.mended.as_ref().filter(|own| own.under.is_empty());
        let mended = mended.map(|own| &own.proven);
        let mut instead = implied.into_iter().chain(mended);
        instead.any(|own| in_these(&own.claim().goal))
    }
}

fn is_extreme(symbol: &Symbol) -> bool {
    let index = split_subscript(symbol.name()).map(|(_, index)| index);
    index.is_some_and(|index| EXTREMES.contains(&index))
}
