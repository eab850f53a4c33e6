//! Rates with dots, `\dot v` and `\dot\Omega`, tied by what ties the quantities at all times: "Rolling means $$v = a \Omega$$" says that
//! `\dot v = a \dot\Omega`, and nobody writes that. Where a page has second dots or differentiates by the time, dots are slopes and need none
//! of this.

use crate::algebra::{Expr, Formula, Symbol};
use crate::derivation::{Assumed, Goal, Source, TIME, dotted, formulas, without_dots};
use crate::kernel::Standing;

use super::Judged;
use super::judge::Judge;

/// So many relations are differentiated for a step.
const MOST_RELATIONS: usize = 4;

impl Judge<'_> {
    /// What the premises that give one thing by others throughout say of the rates of which the step or its premises speak.
    pub(super) fn rates_of_relations(&self, goal: &Goal, assumed: &[Assumed]) -> Vec<Assumed> {
        let said = assumed.iter().map(|own| &*own.formula);
        let terms = said.chain([&goal.formula]).flat_map(Formula::terms);
        let names = Formula::names_in(terms);
        if !names.iter().any(|own| without_dots(own).is_some()) {
            return Vec::new();
        }
        let time = Symbol::new(TIME);
        let rate = |own: &Symbol| rate_of(own).filter(|own| names.contains(own));
        let moves = |own: &Symbol| {
            rate(own).is_some() || *own == time || self.auditor.changes(self.at, own, &time)
        };
        let lasting = assumed.iter().filter(|own| {
            own.standing == Standing::Identity && matches!(own.source, Source::Equation(_))
        });
        let tied = lasting.filter_map(|own| {
            let (Expr::Symbol(of), value) = own.formula.as_equation()? else {
                return None;
            };
            let value = differentiated(value, &rate, &moves)?;
            Some(Assumed {
                formula: Formula::equal(Expr::Symbol(rate(of)?), value).into(),
                standing: Standing::AtPoint,
                source: own.source,
            })
        });
        tied.take(MOST_RELATIONS).collect()
    }

    /// What was taken as constant where a relation was differentiated so: the `a` of `v = a \Omega`.
    pub(super) fn held_for_rates(&self, judged: &Judged) -> Vec<Symbol> {
        let is_rate = |own: &Symbol| without_dots(own).is_some();
        let held = |own: &Assumed| {
            let Source::Equation(at) = own.source else {
                return Vec::new();
            };
            let (Some((Expr::Symbol(of), value)), true) =
                (own.formula.as_equation(), own.standing == Standing::AtPoint)
            else {
                return Vec::new();
            };
            let mut said = self.derivation.equations[at].statements().iter();
            if !is_rate(of) || said.any(|said| formulas(said).contains(&*own.formula)) {
                return Vec::new();
            }
            let mut held: Vec<Symbol> = value.free_symbols().into_iter().collect();
            held.retain(|own| !is_rate(own) && !own.is_unit() && own.name() != "\\pi");
            held
        };
        judged.assumed.iter().flat_map(held).collect()
    }
}

/// The name of the rate of something: `\ddot{x}` of `\dot{x}`.
fn rate_of(symbol: &Symbol) -> Option<Symbol> {
    match without_dots(symbol) {
        None => Some(dotted(symbol, false)),
        Some((of, 1)) => Some(dotted(&of, true)),
        Some(_) => None,
    }
}

/// The rate of a term that is linear in what moves.
fn differentiated(
    term: &Expr,
    rate: &impl Fn(&Symbol) -> Option<Symbol>,
    moves: &impl Fn(&Symbol) -> bool,
) -> Option<Expr> {
    let inner = |part: &Expr| differentiated(part, rate, moves);
    let still = |part: &Expr| !part.free_symbols().iter().any(moves);
    match term {
        Expr::Symbol(own) => rate(own).map(Expr::Symbol),
        Expr::Negate(part) => Some(Expr::Negate(inner(part)?.into())),
        Expr::Sum(parts) => {
            let rates: Option<Vec<Expr>> = parts.iter().map(inner).collect();
            Some(Expr::Sum(rates?.into()))
        }
        Expr::Product(parts) => {
            let mut moving = (0..parts.len()).filter(|&at| !still(&parts[at]));
            let (Some(at), None) = (moving.next(), moving.next()) else {
                return None;
            };
            let mut parts = parts.to_vec();
            parts[at] = inner(&parts[at])?;
            Some(Expr::Product(parts.into()))
        }
        Expr::Quotient(above, below) if still(below) => {
            Some(Expr::Quotient(inner(above)?.into(), below.clone()))
        }
        _ => None,
    }
}
