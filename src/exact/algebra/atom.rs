use std::cmp::Ordering;

use super::{Expr, Symbol, Var};

/// What a polynomial is a polynomial in.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Atom {
    /// A symbol.
    Symbol(Symbol),
    /// The element of a sequence at a definite position, from 1: `u_3`.
    Element {
        /// The sequence.
        sequence: Symbol,
        /// The position.
        position: u32,
    },
    /// The element of a sequence at the bound index of the sum that is being read.
    Bound {
        /// The sequence.
        sequence: Symbol,
        /// The bound index.
        index: Symbol,
    },
    /// `Σ_{i=1}^{to} Π_s s_i^e`: a power sum over a symbolic number of elements.
    PowerSum {
        /// The upper limit.
        to: Symbol,
        /// Each sequence with its exponent, by name; never empty.
        powers: Vec<(Symbol, u32)>,
    },
    /// The positive root of a symbol that is positive; the symbol itself is read as its power.
    Root {
        /// The symbol.
        of: Symbol,
        /// The order of the root.
        order: u32,
    },
    /// A term that is not rational in simpler ones: a root, a function, an undetermined derivative.
    /// Its parts are canonical, so that equal terms are one atom.
    Opaque(Expr),
}

/// Few claims have more unknowns: for so many room is made at once.
const FEW: usize = 12;

/// The unknowns of a set of polynomials, in the order in which they were first met.
#[derive(Clone, Debug, Default)]
pub struct Atoms {
    list: Vec<Atom>,
    /// The same in the order of the atoms.
    sorted: Vec<Var>,
}

impl Atoms {
    /// The unknown that stands for an atom.
    pub fn var(&mut self, atom: Atom) -> Var {
        match self.place(&atom) {
            Ok(at) => self.sorted[at],
            Err(at) => self.put(atom, at),
        }
    }

    /// The same for a symbol, which is copied only where it has not been met.
    pub fn var_of_symbol(&mut self, symbol: &Symbol) -> Var {
        // Most have been met, and among few are found sooner one after another.
        let is_it = |atom: &Atom| matches!(atom, Atom::Symbol(own) if own == symbol);
        if self.list.len() <= 2 * FEW
            && let Some(at) = self.list.iter().position(is_it)
        {
            return Var(at as u32);
        }
        // Symbols come before all other atoms.
        let place = (self.sorted).binary_search_by(|var| match &self.list[var.position()] {
            Atom::Symbol(own) => own.cmp(symbol),
            _ => Ordering::Greater,
        });
        match place {
            Ok(at) => self.sorted[at],
            Err(at) => self.put(Atom::Symbol(symbol.clone()), at),
        }
    }

    /// Takes in an atom that has not been met, at its place among the sorted ones.
    fn put(&mut self, atom: Atom, at: usize) -> Var {
        if self.list.is_empty() {
            self.list.reserve(FEW);
            self.sorted.reserve(FEW);
        }
        // A document of 2^32 symbols does not fit in memory.
        let var = Var(self.list.len() as u32);
        self.list.push(atom);
        self.sorted.insert(at, var);
        var
    }

    fn place(&self, atom: &Atom) -> Result<usize, usize> {
        (self.sorted).binary_search_by(|var| match (&self.list[var.position()], atom) {
            // Most atoms are symbols, and compared in few steps.
            (Atom::Symbol(own), Atom::Symbol(other)) => own.cmp(other),
            (own, other) => own.cmp(other),
        })
    }

    /// The unknown of an atom, if it has been met.
    pub fn find(&self, atom: &Atom) -> Option<Var> {
        self.place(atom).ok().map(|at| self.sorted[at])
    }

    /// The atom that an unknown stands for.
    pub fn atom(&self, var: Var) -> &Atom {
        &self.list[var.position()]
    }

    /// All unknowns with their atoms.
    pub fn iter(&self) -> impl Iterator<Item = (Var, &Atom)> {
        self.list
            .iter()
            .enumerate()
            .map(|(at, atom)| (Var(at as u32), atom))
    }

    /// How many unknowns there are.
    pub fn len(&self) -> usize {
        self.list.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.list.is_empty()
    }
}
