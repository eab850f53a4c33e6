//! What a law says at one of several places that have names: `v_p = \sqrt{\frac{2 \mu r_2}{r_1 (r_1 + r_2)}}` of `v^2 = \mu (\frac2r - \frac1a)`,
//! "at the two ends".
//!
//! Which of the places it is words say, and are not understood; but what the new name stands for is made of their names, and is what the law
//! says at one of them, or something else is meant. It is refuted where the law says so at none, and with one small edit would.

use crate::algebra::{Expr, Formula, LimitPoint, Symbol, effort, split_subscript};
use crate::derivation::{Assumed, Goal, Source, renamed};
use crate::kernel::Standing;
use crate::search::{self, Change, Effort};
use crate::sorted::Set;

use super::super::instances::index;
use super::super::judge::{Found, Judge};
use super::super::premise::ends_of_chains;
use super::super::stated::quantities;

/// So much work is done for that, as [`effort`] counts it.
const MOST_WORK: u64 = 2_000_000;
/// So many laws are looked at, the nearest first, and so many places in each.
const MOST_LAWS: usize = 2;
const MOST_PLACES: usize = 4;

/// What a law says at one place, and what else is known there.
type There = Vec<Assumed>;

impl Judge<'_> {
    /// What to say of a new name for the value of a law at a place, where the law says so at no place that has a name.
    pub(in crate::audit) fn as_no_value_at_a_place(
        &self,
        goal: &Goal,
        premises: &[usize],
    ) -> Option<Found> {
        let (new, named) = self.defined_anew(goal)?;
        let whole = new.without_subscript().filter(|_| index(new).is_some())?;
        let is_plain = goal.is_said_outright() && goal.rounding.is_none();
        if !is_plain || named.contains(&whole) {
            return None;
        }
        let [near, _] = self.others(premises);
        let open = self.open_before(premises);
        let known = || self.usable.assumed.iter().chain(near).chain(&open);
        let is_place = |own: &Symbol| split_subscript(own.name()).is_some();
        let mut ends = Set::new();
        let terms = known().flat_map(|own| own.formula.terms());
        terms.for_each(|term| collect_ends(term, &mut ends));
        let is_end = |own: &Symbol| ends.iter().any(|end| end.1 == own);
        if !named.iter().any(|own| is_place(own) || is_end(own)) {
            return None;
        }
        let is_law = |own: &&Assumed| {
            matches!(own.source, Source::Equation(_))
                && own.formula.as_equation().is_some()
                && !own.formula.speaks_of_slopes()
                && own.formula.names().contains(&whole)
        };
        let mut laws: Vec<&Assumed> = Vec::new();
        for own in known().filter(is_law) {
            if !laws.iter().any(|law| law.formula == own.formula) && laws.len() < MOST_LAWS {
                laws.push(own);
            }
        }
        // `V = \int_a^b E\,dr = \frac{q}{2 \pi} \ln\frac ba` says what `V` is in the end.
        let in_the_end = ends_of_chains(known(), |_| true);
        let known: Vec<&Assumed> = known().chain(&in_the_end).collect();
        let held = || {
            let mut all = laws.iter();
            all.find_map(|law| {
                let places = self.places((law, &whole), &named, &known, &ends)?;
                self.held_at_places(goal, (new, &whole), &named, (law, &places), &known)
            })
        };
        effort::within(MOST_WORK, held)
    }

    fn held_at_places(
        &self,
        goal: &Goal,
        (new, whole): (&Symbol, &Symbol),
        named: &Set<Symbol>,
        (law, places): (&Assumed, &[Vec<(Symbol, Symbol)>]),
        known: &[&Assumed],
    ) -> Option<Found> {
        let there = |of: &Symbol, place: &Vec<(Symbol, Symbol)>| -> There {
            let rename = |own: &Symbol| match place.iter().find(|(named, _)| named == own) {
                Some((_, there)) => there.clone(),
                None if own == whole => of.clone(),
                None => own.clone(),
            };
            let formula = law.formula.map_terms(|term| renamed(term, &rename));
            let said = Assumed {
                formula: formula.into(),
                standing: Standing::AtPoint,
                ..law.clone()
            };
            self.with_meanings(said, of, named, known)
        };
        let claim = |all: &There, formula: &Formula| self.derivation.claim(self.at, all, formula);
        let is_shown = |all: &There, formula: &Formula| {
            let claim = claim(all, formula);
            search::prove_unconditionally(claim, Effort::Light).is_some()
        };
        // What has another name already is none of these: `v_p` at the one end, so `v_a` at the other.
        let is_taken = |place: &Vec<(Symbol, Symbol)>| {
            let mut others = known
                .iter()
                .filter_map(|own| Some((*own, own.formula.said_of()?.0)));
            others.any(|(own, of)| {
                of.without_subscript().as_ref() == Some(whole)
                    && is_shown(&there(of, place), &own.formula)
            })
        };
        let all: Vec<There> = places.iter().map(|place| there(new, place)).collect();
        if all.iter().any(|own| is_shown(own, &goal.formula)) {
            return None;
        }
        let (taken, mut free): (Vec<_>, Vec<_>) =
            places.iter().zip(all).partition(|own| is_taken(own.0));
        free.extend(taken);
        let all: Vec<There> = free.into_iter().map(|own| own.1).collect();
        self.one_slip_away_from_each(goal, &all, is_slip)
    }

    /// What may be put for what a law speaks of and the value does not: names of it that the value is made of, or what has a meaning.
    fn places(
        &self,
        (law, whole): (&Assumed, &Symbol),
        named: &Set<Symbol>,
        known: &[&Assumed],
        ends: &Set<(&Symbol, &Symbol)>,
    ) -> Option<Vec<Vec<(Symbol, Symbol)>>> {
        let page = &self.derivation.pages[self.derivation.equations[self.at].page];
        let mut open = law.formula.names();
        open.retain(|own| own != whole && !named.contains(own) && page.is_quantity(own));
        let is_of = |own: &Symbol, of: &Symbol| own.without_subscript().as_ref() == Some(of);
        let has_ends = ends
            .iter()
            .any(|(of, own)| open.contains(*of) && named.contains(*own));
        let (mut places, mut has_place) = (vec![Vec::new()], false);
        for of in &open {
            let own: Vec<&Symbol> = (named
                .iter()
                .filter(|own| is_of(own, of) || ends.contains(&(of, *own))))
            .collect();
            has_place |= !own.is_empty();
            let put: Vec<Symbol> = match own.is_empty() {
                false => own.into_iter().cloned().collect(),
                true if is_said(of, known) || has_ends && is_tied(of, named, known) => {
                    vec![of.clone()]
                }
                true => {
                    let said = known.iter().filter_map(|own| own.formula.said_of());
                    let said = said.map(|(own, _)| own).filter(|own| is_of(own, of));
                    let mut said: Vec<Symbol> = said.cloned().collect();
                    said.dedup();
                    said
                }
            };
            places = places
                .iter()
                .flat_map(|place: &Vec<(Symbol, Symbol)>| {
                    put.iter().map(move |at| {
                        let mut place = place.clone();
                        place.push((of.clone(), at.clone()));
                        place
                    })
                })
                .collect();
            if places.is_empty() || places.len() > MOST_PLACES {
                return None;
            }
        }
        has_place.then_some(places)
    }

    /// What is said there, with what says what else it speaks of, and the value, all positive.
    fn with_meanings(
        &self,
        said: Assumed,
        own: &Symbol,
        named: &Set<Symbol>,
        known: &[&Assumed],
    ) -> There {
        let mut spoken = said.formula.names();
        spoken.extend(named.iter().cloned());
        let mut all = vec![said];
        for known in known {
            let meaning = known.formula.said_of();
            let is_meant = meaning.is_some_and(|(of, value)| {
                of != own && spoken.contains(of) && quantities(value).is_subset(&spoken)
            });
            if is_meant && !all.iter().any(|other| other.formula == known.formula) {
                all.push((*known).clone());
            }
        }
        all.extend(self.meant_positive(spoken));
        all
    }
}

/// Adds where integrals begin and end, each with what they run over, and where values are taken: `a` and `b` of `\int_a^b E\,dr`.
fn collect_ends<'a>(term: &'a Expr, found: &mut Set<(&'a Symbol, &'a Symbol)>) {
    let mut end = |of: &'a Symbol, place: &'a Expr| {
        if let Expr::Symbol(place) = place {
            found.insert((of, place));
        }
    };
    match term {
        Expr::Integral {
            variable, from, to, ..
        } => {
            end(variable, from);
            end(variable, to);
        }
        Expr::Limit {
            variable,
            point: LimitPoint::Finite(place),
            ..
        } => end(variable, place),
        _ => {}
    }
    term.children().for_each(|part| collect_ends(part, found));
}

/// Whether something says by a symbol what another one is that a value is made of: `V = \frac{q}{2 \pi} \ln\frac ba` of `q`.
fn is_tied(symbol: &Symbol, named: &Set<Symbol>, known: &[&Assumed]) -> bool {
    let mut said = known.iter().filter_map(|own| own.formula.said_of());
    said.any(|(of, value)| named.contains(of) && value.mentions(symbol))
}

/// Whether something says by a term what a symbol is.
fn is_said(symbol: &Symbol, known: &[&Assumed]) -> bool {
    let mut said = known.iter().filter_map(|own| own.formula.said_of());
    said.any(|(of, _)| of == symbol)
}

/// Whether an edit leaves what is spoken of as it is, or takes one place for another.
fn is_slip(change: &Change) -> bool {
    use Change::{Coefficient, Exchanged, Exponent, Inverted, Sign, Symbol as Name};
    matches!(
        change,
        Coefficient | Exchanged { .. } | Exponent | Inverted | Sign | Name { .. }
    )
}
