//! What nobody declares is inferred, formula by formula in reading order.

use std::sync::Arc;

use crate::algebra::{Formula, Rational};
use crate::kernel::dimension::{
    Comparison, Disagreement, Form, IllDimensioned, Part, Said, Scope, Unknown, WellDimensioned,
    check_agreement, check_disagreement, comparisons,
};

use super::rescale::rescaling;
use super::system::{Fit, System};
use crate::sorted::Map;

/// A formula to be read, with what is said of its symbols.
#[derive(Clone, Debug)]
pub struct Reading {
    /// The formula.
    pub formula: Formula,
    /// What is said of its symbols.
    pub scope: Arc<Scope>,
}

/// A disagreement, and where its parts come from.
#[derive(Clone, Debug)]
pub struct Conflict<O> {
    /// The kernel's evidence.
    pub evidence: IllDimensioned,
    /// Which of the readings is at fault.
    pub reading: usize,
    /// The origin of each part of the evidence, the one at fault first.
    pub origins: Vec<O>,
}

/// What has been inferred so far. `O` is how the caller names a statement.
#[derive(Clone, Debug)]
pub struct Inference<O> {
    system: System,
    /// The comparisons that are taken up: formula, position, origin.
    sources: Vec<(Reading, usize, O)>,
}

impl<O> Default for Inference<O> {
    fn default() -> Self {
        Inference {
            system: System::default(),
            sources: Vec::new(),
        }
    }
}

impl<O: Clone> Inference<O> {
    /// Reads the formulas of one statement. One that disagrees with itself, with what is declared or with what was
    /// read before teaches nothing; nor does one that is only tried.
    ///
    /// # Errors
    /// What it disagrees with.
    pub fn read(
        &mut self,
        readings: &[Reading],
        origin: &O,
        only_tried: bool,
    ) -> Result<(), Box<Conflict<O>>> {
        let compared: Vec<(usize, usize, Comparison)> = readings
            .iter()
            .enumerate()
            .flat_map(|(reading, r)| {
                let all = comparisons(&r.formula, &r.scope);
                (0..)
                    .zip(all)
                    .map(move |(at, comparison)| (reading, at, comparison))
            })
            .collect();
        let (mark, known) = (self.system.mark(), self.sources.len());
        let found = self.disagreement(readings, &compared, origin);
        if found.is_some() || only_tried {
            self.system.rewind(mark);
            self.sources.truncate(known);
        }
        let Some(found) = found else {
            return Ok(());
        };
        // What is wrong by itself is at fault alone.
        if found.origins.len() > 1 {
            let alone = Inference::default().disagreement(readings, &compared, origin);
            return Err(Box::new(alone.unwrap_or(found)));
        }
        Err(Box::new(found))
    }

    fn disagreement(
        &mut self,
        readings: &[Reading],
        compared: &[(usize, usize, Comparison)],
        origin: &O,
    ) -> Option<Conflict<O>> {
        let declared = compared.iter().find(|(_, _, comparison)| {
            let quotient = comparison.quotient();
            quotient.unknowns.is_empty() && !quotient.is_none()
        });
        if let Some(declared) = declared {
            return self.conflict(readings, declared, origin, &Map::new());
        }
        for one in compared {
            let (reading, at, comparison) = one;
            let source = self.sources.len();
            let before = self.system.mark();
            if let Fit::Bad(with) = self.system.add(comparison.quotient(), source) {
                return self.conflict(readings, one, origin, &with);
            }
            if self.system.mark() > before {
                self.sources
                    .push((readings[*reading].clone(), *at, origin.clone()));
            }
        }
        None
    }

    /// The evidence, if the kernel takes it for such.
    fn conflict(
        &self,
        readings: &[Reading],
        (reading, at, comparison): &(usize, usize, Comparison),
        origin: &O,
        with: &Map<usize, Rational>,
    ) -> Option<Conflict<O>> {
        let part = |reading: &Reading, comparison, multiplier| Part {
            formula: reading.formula.clone(),
            scope: Arc::clone(&reading.scope),
            comparison,
            multiplier,
        };
        let mut parts = vec![part(&readings[*reading], *at, Rational::one())];
        let mut origins = vec![origin.clone()];
        for (source, multiplier) in with {
            let (reading, at, origin) = &self.sources[*source];
            parts.push(part(reading, *at, multiplier.clone()));
            origins.push(origin.clone());
        }
        let solution = parts.iter().fold(Map::new(), |mut all, part| {
            all.extend(self.solution(&part.scope, &part.formula));
            all
        });
        let solved = |form: &Form| form.with(&solution).known;
        let left = solved(&comparison.left.form);
        let right = comparison.right.as_ref().map(|right| solved(&right.form));
        let evidence = check_disagreement(Disagreement {
            parts,
            rescaling: rescaling(&left, &right.unwrap_or_default()),
            solution,
        });
        Some(Conflict {
            evidence: evidence.ok()?,
            reading: *reading,
            origins,
        })
    }

    /// What is known of the unknowns of a formula.
    fn solution(&self, scope: &Scope, formula: &Formula) -> Map<Unknown, Form> {
        let mut solution = Map::new();
        let mut look = |said: Option<&Said>| {
            if let Some(said @ Said::Unknown(unknown)) = said {
                let own = Form::said(said);
                let value = self.system.value(&own);
                if value != own {
                    solution.insert(*unknown, value);
                }
            }
        };
        super::occur::symbols(formula, &mut |symbol| look(scope.symbols.get(symbol)));
        super::occur::sequences(formula, &mut |sequence| look(scope.sequences.get(sequence)));
        solution
    }

    /// The dimension of something, as far as it is known.
    pub fn value(&self, form: &Form) -> Form {
        self.system.value(form)
    }

    /// The kernel's evidence that all dimensions in a formula agree, if they do.
    pub fn agreement(&self, formula: &Formula, scope: &Scope) -> Option<WellDimensioned> {
        check_agreement(formula, scope, &self.solution(scope, formula)).ok()
    }
}
