//! The claim that a goal follows from hypotheses, with the domains of all symbols in it.

use crate::algebra::{BigRational, Formula, Relation, Symbol};
use crate::kernel::{Claim, Domain, Hypothesis};
use crate::notation::measured;
use crate::sorted::Map;

use super::Derivation;
use super::assumed::{Assumed, Source};
use super::qualities::Said;

impl Derivation {
    /// Whether a symbol is a constant to which nobody gives a name: one of which is said somewhere that there is one.
    pub fn is_some_constant(&self, symbol: &Symbol) -> bool {
        self.constants.contains(symbol)
    }

    /// What the text says of symbols where an equation stands, or where what it is taken with does, each with the page; another premise may
    /// know better what changes.
    pub fn said(&self, at: usize, assumed: &[Assumed]) -> Map<Symbol, (usize, Said)> {
        let premises = assumed.iter().filter_map(|own| match own.source {
            Source::Equation(premise) => Some(premise),
            _ => None,
        });
        let mut found: Map<Symbol, (usize, Said)> = Map::new();
        for at in std::iter::once(at).chain(premises) {
            let own = &self.equations[at];
            for (symbol, said) in &own.said {
                let told = found.entry(symbol.clone());
                told.or_insert((own.page, said.clone()));
            }
        }
        if !found.is_empty() {
            let premises = assumed.iter().map(|own| &*own.formula);
            let differentiated = Formula::differentiated_in(premises);
            found.retain(|symbol, own| !own.1.is_constant() || !differentiated.contains(symbol));
        }
        found
    }

    /// What an earlier equation speaks of as constant, and what stands before this one has let change since.
    pub fn is_released(&self, at: usize, other: usize) -> Option<&Symbol> {
        let (own, other) = (&self.equations[at], &self.equations[other]);
        let was_constant =
            |symbol: &Symbol| other.is_told_constant(symbol) && other.symbols().contains(symbol);
        let mut released = own.released.iter().filter(|_| own.page == other.page);
        released.find(|symbol| was_constant(symbol))
    }

    /// The claim that a goal of an equation follows from hypotheses, with the domains of all symbols in it.
    pub fn claim(&self, at: usize, assumed: &[Assumed], goal: &Formula) -> Claim {
        let mut claim = Claim {
            domains: Map::new(),
            sequences: Map::new(),
            hypotheses: assumed
                .iter()
                .map(|a| Hypothesis {
                    formula: a.formula.clone(),
                    standing: a.standing,
                })
                .collect(),
            goal: goal.clone(),
        };
        // Declarations are a page's own; those of the pages of premises fill the gaps.
        let own = self.equations[at].page;
        let others = assumed.iter().filter_map(|a| match a.source {
            Source::Equation(premise) => Some(self.equations[premise].page),
            Source::Local(page, _) => Some(page),
            Source::Step | Source::Taken | Source::Propagation | Source::Nature => None,
        });
        let mut pages: Vec<usize> = Vec::with_capacity(assumed.len() + 1);
        pages.push(own);
        pages.extend(others);
        pages.dedup();
        let said = self.said(at, assumed);
        let domain = |symbol: &Symbol| {
            let mut declared = pages
                .iter()
                .filter_map(|&p| self.pages[p].domains.get(symbol));
            // A unit is a positive quantity that never changes.
            let of_unit = || Domain {
                lower: Some((BigRational::from_integer(0.into()), true)),
                constant: true,
                ..Domain::default()
            };
            let declared = declared.next().cloned();
            let own = declared.or_else(|| measured(symbol).map(|_| of_unit()));
            match said.get(symbol) {
                Some((_, said)) => Some(said.narrowed(own)),
                None => own,
            }
        };
        let named = claim.free_symbols();
        // Something is declared of most.
        let mut domains = Vec::with_capacity(named.len());
        let declared = |symbol: &Symbol| Some((symbol.clone(), domain(symbol)?));
        domains.extend(named.into_iter().filter_map(declared));
        claim.domains = Map::from_iter(domains);
        for sequence in Formula::sequences_of(claim.formulas()) {
            let mut declared = pages
                .iter()
                .filter_map(|&p| self.pages[p].element_domain(&sequence));
            let domain: Domain = declared.next().cloned().unwrap_or_default();
            claim.sequences.insert(sequence, domain);
        }
        claim
    }
}

/// Whether a hypothesis leaves room to move: then what follows from it holds around the point too.
pub fn is_open(formula: &Formula) -> bool {
    use Relation::{Greater, Less, NotEqual};
    matches!(
        formula,
        Formula::Relation {
            relation: Less | Greater | NotEqual,
            ..
        }
    )
}
