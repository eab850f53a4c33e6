//! What is supposed where: values and hypotheses that prose or a directive brings in, and the special cases that are left again.

use std::sync::Arc;

use crate::algebra::{Expr, Formula, Relation, Symbol};
use crate::document::{Span, SuppositionKind};
use crate::kernel::Standing;
use crate::notation::{SyntaxError, read_formulas};

use super::equation::formulas;
use super::page::Page;
use super::rows::Part;
use crate::sorted::Set;

/// A hypothesis that is in effect in a part of a page.
#[derive(Clone, Debug)]
pub struct Local {
    /// What is supposed.
    pub formulas: Vec<Arc<Formula>>,
    /// `let`: a value for this section alone; otherwise `assuming`, which conclusions carry with them.
    pub is_let: bool,
    /// Where it stands.
    pub span: Span,
    /// Of a special case, the symbols that it sets to a number: what speaks of them again is no longer said of that case.
    pub(super) set: Set<Symbol>,
    /// It is a special case, or was told of one, and is left with it.
    pub(super) of_case: bool,
    /// The text told it in passing.
    pub is_told: bool,
    pub(super) level: u8,
}

impl Local {
    /// Whether it is a special case.
    pub fn is_case(&self) -> bool {
        self.of_case || !self.set.is_empty()
    }

    /// The symbols that it says the value of.
    pub fn values(&self) -> Set<Symbol> {
        self.formulas.iter().flat_map(|f| assigned(f)).collect()
    }

    /// The symbols and sequences that it speaks of.
    pub fn names(&self) -> Set<Symbol> {
        let formulas = self.formulas.iter();
        formulas.flat_map(|formula| formula.names()).collect()
    }
}

impl Page {
    /// What is supposed is so at one point; of constants alone it is so throughout.
    pub fn standing_of(&self, formula: &Formula) -> Standing {
        let is_constant = |s: &Symbol| self.domains.get(s).is_some_and(|d| d.constant);
        match formula.free_symbols().iter().all(is_constant) && formula.sequences().is_empty() {
            true => Standing::Identity,
            false => Standing::AtPoint,
        }
    }

    /// Takes up a `let` or an assumption. Prose that cannot be read supposes nothing; a directive must be readable.
    pub(super) fn suppose(
        &mut self,
        body: Span,
        kind: SuppositionKind,
        level: u8,
        active: &mut Vec<usize>,
        strict: bool,
    ) {
        let is_case = matches!(kind, SuppositionKind::Case { .. });
        let is_fact = matches!(kind, SuppositionKind::Fact { .. });
        let is_let = is_case || kind == SuppositionKind::Let;
        let mut statements = match read_formulas(&self.document.source, body) {
            Ok(statements) => statements,
            Err(error) => {
                if strict {
                    self.complain(error);
                }
                return;
            }
        };
        self.read_exponentials(statements.iter_mut());
        if let Some(conditional) = statements.iter().find(|s| !s.under.is_empty()) {
            if strict {
                self.complain(SyntaxError {
                    span: conditional.span,
                    message: "what is supposed here is said under a condition".into(),
                    help: Some("suppose the condition first".into()),
                });
            }
            return;
        }
        for statement in &statements {
            let formulas = formulas(statement);
            let values: Set<Symbol> = formulas.iter().flat_map(assigned).collect();
            let own: Set<Symbol> = formulas.iter().flat_map(Formula::names).collect();
            let locals = &self.locals;
            active.retain(|&at| {
                let old = &locals[at];
                let before = old.values();
                // "For $m_1 = m_2$, … For $m_2 = 3 m_1$, …" goes from one case to the next.
                let other_case = || {
                    let gives_values = !values.is_empty() && !before.is_empty();
                    gives_values && own.len() > 1 && old.names() == own
                };
                match old.is_let && is_let {
                    true => before.is_disjoint(&values) && !other_case(),
                    // "The height is $x = h$, so … The width is $x = w$, so".
                    false => !is_fact || before.is_disjoint(&values),
                }
            });
            let set = match is_case || is_fact {
                true => formulas.iter().filter_map(set_to_a_number).collect(),
                false => Set::new(),
            };
            active.push(self.locals.len());
            self.locals.push(Local {
                set,
                formulas: formulas.into_iter().map(Arc::new).collect(),
                is_let,
                span: statement.span,
                of_case: is_case || matches!(kind, SuppositionKind::Fact { of_case: true, .. }),
                is_told: is_fact,
                level,
            });
        }
    }

    /// Leaves the cases of whose symbols a display speaks again: "At $t = 0$ the switch is closed. Later $q = I t$". In the
    /// sentence that sets the case it is said of that: "at $\mu = 1$, $\eta = 4 \mu / (1 + \mu)^2 = 1$".
    pub(super) fn leave_cases(&self, display: &[Part], running: &[usize], active: &mut Vec<usize>) {
        let is_left = |at: usize| {
            let set = &self.locals[at].set;
            let statements = || {
                display
                    .iter()
                    .flat_map(|part| part.statements.iter().flatten())
            };
            let mut spoken_of = statements().flat_map(formulas).flat_map(|f| f.names());
            !set.is_empty() && !running.contains(&at) && spoken_of.any(|name| set.contains(&name))
        };
        active.retain(|&at| !is_left(at));
    }
}

/// The symbol that an equation says is a number: `t = 0`.
fn set_to_a_number(formula: &Formula) -> Option<Symbol> {
    match formula {
        Formula::Relation {
            left: Expr::Symbol(symbol),
            relation: Relation::Equal,
            right,
        } if right.free_symbols().iter().all(Symbol::is_unit) => Some(symbol.clone()),
        _ => None,
    }
}

/// The symbols that an equation between them gives a value.
fn assigned(formula: &Formula) -> Set<Symbol> {
    match formula {
        Formula::Relation {
            left: Expr::Symbol(symbol),
            ..
        } => Set::from([symbol.clone()]),
        Formula::AllEqual { sequence, .. } => Set::from([sequence.clone()]),
        Formula::Relation { .. } => Set::new(),
    }
}
