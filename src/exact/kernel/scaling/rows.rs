use super::super::{Claim, Reject, Standing};
use super::product::{Compound, Reader};
use super::{Combination, Product, ScalingProof};
use crate::algebra::{Expr, Formula, Rational, Relation, Symbol};
use crate::sorted::{Map, Set};

/// A product that is the same number in any two situations that are compared.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Row {
    /// Its quantities with their exponents.
    pub product: Product,
    /// Both sides were equated, not only compared.
    pub exact: bool,
}

/// A claim as rows of exponents: what combinations speak of.
///
/// Made from the claim alone, in one way only, so that the search and the kernel mean the same by "row 3".
#[derive(Clone)]
pub struct Rows {
    /// A row for each hypothesis, by its position, and then one for each variable of integration that is
    /// spoken of elsewhere. `None` where a hypothesis says nothing of exponents.
    pub rows: Vec<Option<Row>>,
    /// `left / right` of the goal.
    pub goal: Product,
    /// The two sides of the goal.
    pub sides: (Product, Product),
    /// Quantities that are the same in both situations: π, and for `∝` the constants that it does not name.
    pub held: Set<Expr>,
    reader: Reader,
}

impl Rows {
    /// The rows of a claim.
    ///
    /// # Errors
    /// The goal is no scaling relation, or one of its sides is no product.
    pub fn new(claim: &Claim) -> Result<Rows, Reject> {
        let (left, right) = sides(&claim.goal).ok_or(Reject::UnsupportedRelation)?;
        let mut reader = Reader::new(claim);
        let sides = (reader.read(left)?, reader.read(right)?);
        let held = held(claim);
        let clocks = Clocks::of(claim);
        let mut rows = Vec::new();
        for hypothesis in &claim.hypotheses {
            let usable = match hypothesis.standing {
                Standing::Identity => true,
                Standing::AtPoint => !clocks.moves_in(&hypothesis.formula, claim),
            };
            let fits = usable && holds_here(&hypothesis.formula, claim);
            rows.push(
                fits.then(|| row(&mut reader, &hypothesis.formula))
                    .flatten(),
            );
        }
        for (variable, end) in clocks.spoken_of(claim, &mut reader) {
            let own = Product {
                exponents: Map::from([(Expr::Symbol(variable), Rational::one())]),
                ..Product::default()
            };
            rows.push(Some(Row {
                product: own.over(&end),
                exact: false,
            }));
        }
        Ok(Rows {
            rows,
            goal: sides.0.over(&sides.1),
            sides,
            held,
            reader,
        })
    }

    /// The product without the quantities that are the same in both situations.
    pub fn varying(&self, product: &Product) -> Map<Expr, Rational> {
        let all = product.exponents.iter();
        all.filter(|(term, _)| !self.held.contains(*term))
            .map(|(term, e)| (term.clone(), e.clone()))
            .collect()
    }

    /// What must be shown to scale as 1 for a sum or integral to scale as a product, and the row that it then
    /// gives.
    ///
    /// # Errors
    /// The term is neither, or not understood.
    pub fn compound(&mut self, term: &Expr) -> Result<(Vec<Product>, Row), Reject> {
        let Compound {
            quantity,
            scales_as,
            alike,
        } = self.reader.compound(term)?;
        let whole = Product {
            exponents: Map::from([(quantity, Rational::one())]),
            ..Product::default()
        };
        let row = Row {
            product: whole.over(&scales_as),
            exact: false,
        };
        Ok((alike, row))
    }

    /// Checks that every sum and integral is alike in its parts, then that the goal is the combination.
    pub(super) fn check(mut self, proof: &ScalingProof) -> Result<(), Reject> {
        for alike in &proof.alike {
            let (products, row) = self.compound(&alike.term)?;
            if products.len() != alike.combinations.len() {
                return Err(Reject::IdentityFails);
            }
            for (product, combination) in products.iter().zip(&alike.combinations) {
                self.combination(product, combination)?;
            }
            self.rows.push(Some(row));
        }
        self.combination(&self.goal, &proof.combination)
    }

    fn combination(&self, product: &Product, combination: &Combination) -> Result<(), Reject> {
        let mut rest = product.clone();
        for (position, coefficient) in combination {
            let row = self.rows.get(*position).and_then(Option::as_ref);
            let row = row.ok_or(Reject::NoSuchFact(*position))?;
            rest = rest.times(&row.product, &-coefficient);
        }
        match self.varying(&rest).is_empty() {
            true => Ok(()),
            false => Err(Reject::IdentityFails),
        }
    }
}

/// The sides of a scaling relation.
pub(in crate::kernel) fn sides(formula: &Formula) -> Option<(&Expr, &Expr)> {
    match formula {
        Formula::Relation {
            left,
            relation: Relation::Scales | Relation::Proportional,
            right,
        } => Some((left, right)),
        _ => None,
    }
}

/// What a hypothesis says of exponents.
fn row(reader: &mut Reader, formula: &Formula) -> Option<Row> {
    let Formula::Relation {
        left,
        relation,
        right,
    } = formula
    else {
        return None;
    };
    let exact = match relation {
        Relation::Equal => true,
        Relation::Scales | Relation::Proportional => false,
        _ => return None,
    };
    let (left, right) = (reader.read(left).ok()?, reader.read(right).ok()?);
    Some(Row {
        product: left.over(&right),
        exact,
    })
}

/// Whether a hypothesis `∝` speaks of the situations that the goal speaks of: what it holds constant must be
/// constant there.
fn holds_here(formula: &Formula, claim: &Claim) -> bool {
    let is_proportional = |f: &Formula| {
        matches!(
            f,
            Formula::Relation {
                relation: Relation::Proportional,
                ..
            }
        )
    };
    if !is_proportional(formula) {
        return true;
    }
    let constants = claim
        .domains
        .iter()
        .filter(|(_, d)| d.constant)
        .map(|d| d.0);
    let mut named = constants.filter(|s| mentions(&claim.goal, s));
    is_proportional(&claim.goal) && named.all(|s| mentions(formula, s))
}

/// π where it is the number, and for a goal `∝` the constants that it does not name.
pub(super) fn held(claim: &Claim) -> Set<Expr> {
    let mut held = Set::new();
    let pi = Symbol::new("\\pi");
    if !claim.domains.contains_key(&pi) {
        held.insert(Expr::Symbol(pi));
    }
    if let Formula::Relation {
        relation: Relation::Proportional,
        ..
    } = &claim.goal
    {
        let constants = claim.domains.iter().filter(|(_, d)| d.constant);
        let unnamed = constants.filter(|(s, _)| !mentions(&claim.goal, s));
        held.extend(unnamed.map(|(s, _)| Expr::Symbol(s.clone())));
    }
    held
}

pub(super) fn mentions(formula: &Formula, symbol: &Symbol) -> bool {
    formula.terms().iter().any(|term| term.mentions(symbol))
}

/// The variables of integrals and derivatives, and what stands under these.
#[derive(Default)]
pub(super) struct Clocks {
    /// The upper limits of each variable of integration.
    ends: Map<Symbol, Set<Expr>>,
    moving: Set<Symbol>,
    /// Whether there is a derivative.
    pub slopes: bool,
}

impl Clocks {
    pub fn of(claim: &Claim) -> Clocks {
        let mut clocks = Clocks::default();
        for term in claim.formulas().flat_map(Formula::terms) {
            clocks.collect(term);
        }
        clocks
    }

    fn collect(&mut self, term: &Expr) {
        match term {
            Expr::Integral {
                body, variable, to, ..
            } => {
                let ends = self.ends.entry(variable.clone()).or_default();
                ends.insert((**to).clone());
                self.moving.insert(variable.clone());
                names(body, &mut self.moving);
            }
            Expr::Derivative { body, variable } | Expr::Partial { body, variable, .. } => {
                self.slopes = true;
                self.moving.insert(variable.clone());
                names(body, &mut self.moving);
            }
            _ => {}
        }
        for child in term.children() {
            self.collect(child);
        }
    }

    /// Whether there is an integral.
    pub fn integrals(&self) -> bool {
        !self.ends.is_empty()
    }

    /// Whether a formula speaks of something that moves, outside of an integral.
    fn moves_in(&self, formula: &Formula, claim: &Claim) -> bool {
        let mut outside = Set::new();
        for term in formula.terms() {
            outside_of_integrals(term, &mut outside);
        }
        let fixed = |s: &Symbol| claim.is_constant(s);
        outside.iter().any(|s| self.moving.contains(s) && !fixed(s))
    }

    /// Whether a variable of integration is spoken of by itself outside of its integrals.
    pub fn variable_is_free(&self, claim: &Claim) -> bool {
        let mut outside = Set::new();
        for term in claim.formulas().flat_map(Formula::terms) {
            bare_outside(term, &mut outside);
        }
        self.ends.keys().any(|variable| outside.contains(variable))
    }

    /// The variables of integration, each with the one upper limit that all of its integrals have.
    fn spoken_of(&self, claim: &Claim, reader: &mut Reader) -> Vec<(Symbol, Product)> {
        if !self.variable_is_free(claim) {
            return Vec::new();
        }
        let mut all = Vec::new();
        for (variable, ends) in &self.ends {
            let mut ends = ends.iter();
            if let (Some(end), None) = (ends.next(), ends.next())
                && !end.mentions(variable)
                && let Ok(end) = reader.read(end)
            {
                all.push((variable.clone(), end));
            }
        }
        all
    }
}

/// The symbols of a term, and the names of the functions in it.
fn names(term: &Expr, found: &mut Set<Symbol>) {
    match term {
        Expr::Symbol(symbol) | Expr::Apply(symbol, _) => {
            found.insert(symbol.clone());
        }
        Expr::Element { sequence, .. } => {
            found.insert(sequence.clone());
        }
        _ => {}
    }
    term.children().for_each(|child| names(child, found));
}

fn outside_of_integrals(term: &Expr, found: &mut Set<Symbol>) {
    match term {
        Expr::Integral { from, to, .. } => {
            outside_of_integrals(from, found);
            outside_of_integrals(to, found);
        }
        Expr::Symbol(symbol) | Expr::Apply(symbol, _) => {
            found.insert(symbol.clone());
        }
        _ => {}
    }
    if !matches!(term, Expr::Integral { .. }) {
        let children = term.children();
        children.for_each(|child| outside_of_integrals(child, found));
    }
}

/// The symbols that stand by themselves: not under an integral, not as the argument of an unknown function.
fn bare_outside(term: &Expr, found: &mut Set<Symbol>) {
    match term {
        Expr::Integral { from, to, .. } => {
            bare_outside(from, found);
            bare_outside(to, found);
            return;
        }
        Expr::Apply(..) => return,
        Expr::Symbol(symbol) => {
            found.insert(symbol.clone());
        }
        Expr::Derivative { variable, .. } | Expr::Partial { variable, .. } => {
            found.insert(variable.clone());
        }
        _ => {}
    }
    term.children().for_each(|child| bare_outside(child, found));
}
