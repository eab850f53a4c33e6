//! What audited pages say of a quantity, and what the audit says of that.

use std::borrow::Cow;

use crate::algebra::{BigRational, Expr, Formula, Symbol};
use crate::audit::{Audit, Entry, Verdict};
use crate::derivation::{Checker, Point, goals};
use crate::notation::{latex_formula, plain_formula, read_symbol};

use super::FigureError;

/// A derivation, some of whose equations are judged: those that a figure rests on.
#[derive(Debug)]
pub struct Audited<'a> {
    checker: &'a Checker,
    audit: Cow<'a, Audit>,
}

impl<'a> Audited<'a> {
    /// Judges the equations of these labels, and nothing that they do not depend on.
    ///
    /// # Errors
    /// There is no such equation.
    pub fn of(checker: &'a Checker, labels: &[&str]) -> Result<Self, FigureError> {
        let at = labels.iter().map(|label| position(checker, label));
        let wanted = at.collect::<Result<Vec<usize>, _>>()?;
        Ok(Audited {
            checker,
            audit: checker.audit_of(&wanted),
        })
    }

    /// What was judged: at least the equations asked for.
    pub fn entries(&self) -> &[Entry] {
        &self.audit.entries
    }
}

/// What the audit found of an equation.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Standing {
    /// How the equation is cited: `(41)`, `claim energy-decay`.
    pub label: String,
    /// The verdict; of several statements in one display, the worst.
    pub verdict: Verdict,
    /// The failing equations that it comes from, as they are cited.
    pub rests_on: Vec<String>,
}

impl Standing {
    /// Reads it off the audit.
    ///
    /// # Errors
    /// There is no such equation.
    pub fn of(audited: &Audited<'_>, label: &str) -> Result<Self, FigureError> {
        let Audited { checker, audit } = audited;
        let at = position(checker, label)?;
        let entries = audit.of_equation(at);
        let worst = |entry: &Entry| match entry.verdict {
            Verdict::Given => 0,
            Verdict::Holds => 1,
            Verdict::Undecided => 2,
            Verdict::Fails => 3,
            Verdict::IllDimensioned => 4,
        };
        let entry = entries.iter().max_by_key(|entry| worst(entry));
        let mut rests_on: Vec<usize> = entries.iter().flat_map(|e| e.rests_on.clone()).collect();
        rests_on.sort_unstable();
        rests_on.dedup();
        Ok(Standing {
            label: cited(checker, at),
            verdict: entry.map_or(Verdict::Undecided, |entry| entry.verdict),
            rests_on: rests_on.into_iter().map(|at| cited(checker, at)).collect(),
        })
    }

    /// `holds`, `fails`, `holds if (23) does`.
    pub fn words(&self) -> String {
        let word = match self.verdict {
            Verdict::Given => "is given",
            Verdict::Holds => "holds",
            Verdict::Fails => "fails",
            Verdict::IllDimensioned => "is ill-dimensioned",
            Verdict::Undecided => "is undecided",
        };
        match self.rests_on.as_slice() {
            [] => word.to_owned(),
            failing => format!("{word}, but rests on {}", super::words::list(failing)),
        }
    }
}

/// A quantity as an equation gives it: `symbol = term`.
#[derive(Clone, Debug)]
pub struct Law {
    /// What the audit found of the equation. Of what it proves in the place of one, that it holds.
    pub standing: Standing,
    /// The whole relation.
    pub formula: Formula,
    /// The side that gives the quantity.
    pub term: Expr,
}

impl Law {
    /// What an equation says a symbol is, the symbol and the equation by the names that the page gives them.
    ///
    /// # Errors
    /// There is no such equation, or it has the symbol nowhere alone on one side.
    pub fn of(audited: &Audited<'_>, label: &str, symbol: &str) -> Result<Self, FigureError> {
        let checker = audited.checker;
        let equation = &checker.derivation().equations[position(checker, label)?];
        let stated = equation.statements().iter().flat_map(goals);
        let asserted = stated.filter(|goal| !goal.questioned && goal.suppositions.is_empty());
        let name = read_symbol(symbol).ok();
        let solved = asserted
            .filter_map(|goal| Some((term_for(&goal.formula, name.as_ref()?)?, goal.formula)))
            .last();
        let Some((term, formula)) = solved else {
            return Err(FigureError::NotSolved {
                label: label.to_owned(),
                symbol: symbol.to_owned(),
            });
        };
        Ok(Law {
            standing: Standing::of(audited, label)?,
            formula,
            term,
        })
    }

    /// What the audit has proved in the place of an equation that fails. `None` where it fails not, or nothing is.
    ///
    /// # Errors
    /// There is no such equation.
    pub fn instead_of(audited: &Audited<'_>, label: &str) -> Result<Option<Self>, FigureError> {
        let Audited { checker, audit } = audited;
        let at = position(checker, label)?;
        let entries = audit.of_equation(at).iter();
        let implied = entries.filter_map(|entry| entry.implied.as_deref()).next();
        Ok(implied.and_then(|implied| {
            let formula = implied.proven.claim().goal.clone();
            let (Expr::Symbol(_), term) = formula.as_equation()? else {
                return None;
            };
            Some(Law {
                standing: Standing {
                    label: format!("in place of {}", cited(checker, at)),
                    verdict: Verdict::Holds,
                    rests_on: Vec::new(),
                },
                term: term.clone(),
                formula,
            })
        }))
    }

    /// The value at a point, exactly.
    ///
    /// # Errors
    /// The point leaves out a symbol, or something is divided by 0.
    pub fn value(&self, at: &Point) -> Result<BigRational, FigureError> {
        at.value(&self.term).map_err(|error| FigureError::Evaluate {
            label: self.standing.label.clone(),
            error,
        })
    }

    /// The relation in one line of text.
    pub fn plain(&self) -> String {
        plain_formula(&self.formula)
    }

    /// The relation as LaTeX.
    pub fn latex(&self) -> String {
        latex_formula(&self.formula)
    }
}

/// The side of an equation opposite to a symbol that stands alone.
fn term_for(formula: &Formula, symbol: &Symbol) -> Option<Expr> {
    let alone = |side: &Expr| matches!(side, Expr::Symbol(own) if own == symbol);
    match formula.as_equation()? {
        (left, right) if alone(left) => Some(right.clone()),
        (left, right) if alone(right) => Some(left.clone()),
        _ => None,
    }
}

fn position(checker: &Checker, label: &str) -> Result<usize, FigureError> {
    let missing = || FigureError::NoEquation(label.to_owned());
    checker.position(label).ok_or_else(missing)
}

/// `(41)`, `claim energy-decay`.
pub(super) fn cited(checker: &Checker, at: usize) -> String {
    checker.derivation().equations[at].reference()
}
