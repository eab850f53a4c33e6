//! What a piece of text says of the display before it and of the next one.

use crate::algebra::Expr;
use crate::document::{Extent, Inserted, Named, Prose, Span, SuppositionKind};
use crate::notation::read_formulas;

use super::super::equation::formulas;
use super::super::supposed::Local;
use super::Reader;

/// What supposes more between two displays is not taken in, and what comes next is not refuted without it.
const MOST_SUPPOSED: usize = 256;
/// Of the values that a piece of text names, so many are looked at.
pub(super) const MOST_MENTIONED: usize = 6;

impl Reader<'_> {
    pub(super) fn prose(&mut self, prose: &Prose) {
        // "Setting the derivatives to zero gives" is said of the displays up to the next words: those say what comes of it.
        if !self.last.is_empty() && !matches!(prose.extent, None | Some(Extent::AsBefore)) {
            self.leave_stationary();
        }
        let tail = if self.last.is_empty() { 0 } else { prose.tail };
        let (of_last, own) = prose.citations.split_at(tail);
        for equation in &mut self.equations[self.last.clone()] {
            equation.cite(of_last, prose.says_from);
        }
        self.between.hear(prose, own);
        self.page.of_places.extend(&prose.of_places);
        self.put_in(&prose.inserted);
        let told_with_last = match prose.joins {
            true => self.told_with_last(),
            false => Vec::new(),
        };
        let before = self.page.locals.len();
        let cases = self.cases_before();
        self.qualities(prose);
        self.page.name_quantities(&prose.quantities);
        let mut mentioned = prose.mentions.clone();
        if prose.suppositions.iter().any(|s| s.kind.begins_a_case()) {
            self.forget_cases();
        }
        match prose.suppositions.len() <= MOST_SUPPOSED {
            true => {
                for supposition in &prose.suppositions {
                    mentioned.extend(self.supposition(supposition, &prose.citations));
                }
            }
            false => self.between.unread.push(prose.span),
        }
        self.kind_of(prose.leading);
        self.page.leave_passages(&mut self.active);
        self.page.forget_moments(&self.active, &mut self.told);
        mentioned.truncate(MOST_MENTIONED);
        for equation in &mut self.equations[std::mem::take(&mut self.last)] {
            equation.mentioned.extend(&mentioned);
        }
        self.between.mentioned.extend(mentioned);
        self.between.mentioned.truncate(MOST_MENTIONED);
        // "For $x = 2 a$ the force vanishes. In general" leaves what it named.
        let left = prose
            .suppositions
            .iter()
            .filter(|own| own.kind.leaves_cases());
        let left = left.map(|own| own.body.start).max().unwrap_or_default();
        let named = prose.named.iter().filter(|own| own.body.start >= left);
        self.between.named = self.named(named, before, prose.leading);
        let mut named = std::mem::take(&mut self.between.named);
        self.leave_old_values(&named);
        self.turn_to_other_cases(before, &cases, &mut named);
        self.between.named = named;
        self.between.named.extend(told_with_last);
    }

    /// What is stationary in the displays before is no longer meant.
    pub(super) fn leave_stationary(&mut self) {
        let over = std::mem::take(&mut self.stationary);
        self.active.retain(|at| !over.contains(at));
    }

    /// Takes up what is put in elsewhere. "It" is what was put in before the display before, or what that says.
    fn put_in(&mut self, inserted: &Inserted) {
        if inserted.cited.is_some() {
            self.between.inserted.clone_from(&inserted.cited);
        } else if inserted.again && !self.last.is_empty() {
            match self.inserted.take() {
                Some(cited) => {
                    self.between.cited.insert(0, cited.clone());
                    self.between.inserted = Some(cited);
                }
                None => self.between.relative = true,
            }
        }
    }

    /// What the sentence of the display before names, and what it tells of that display alone: what goes on with the sentence may be
    /// meant to follow from that, too.
    fn told_with_last(&self) -> Vec<usize> {
        let Some(last) = self.equations[self.last.clone()].last() else {
            return Vec::new();
        };
        let locals = &self.page.locals;
        let told = last.told.iter().filter(|&&at| !locals[at].set.is_empty());
        last.named.iter().chain(told).copied().collect()
    }

    /// Takes up what a sentence names and does not suppose. What displays say already is a value of it, or has to be shown. What the
    /// sentence states that leads on, and cannot be read, may be what the display follows from.
    fn named<'a>(
        &mut self,
        relations: impl Iterator<Item = &'a Named>,
        before: usize,
        leading: Span,
    ) -> Vec<usize> {
        let mut named = Vec::new();
        for &Named { body, is_drawn } in relations {
            let within =
                |local: &Local| body.start <= local.span.start && local.span.end <= body.end;
            // What was told in a sentence of its own is not told any more.
            let is_kept = |at: &usize| self.active.contains(at) || self.told.contains(at);
            let mut own = (before..self.page.locals.len()).filter(is_kept);
            if !own.any(|at| within(&self.page.locals[at]))
                && (!is_drawn || self.is_value(body) || !self.is_said(body))
            {
                let kind = SuppositionKind::Known;
                let known = named.len();
                self.page.suppose(body, kind, self.level, &mut named, false);
                let leads = leading.start <= body.start && body.end <= leading.end;
                if named.len() == known && leads && !self.between.unread.contains(&body) {
                    self.between.unread.push(body);
                }
            }
        }
        named
    }

    /// The cases before the last display that are in effect.
    fn cases_before(&self) -> Vec<usize> {
        let Some(last) = self.equations.last() else {
            return Vec::new();
        };
        let is_before = |&at: &usize| self.page.locals[at].is_case_before(last.span);
        self.active.iter().copied().filter(is_before).collect()
    }

    /// What is told or named since then and cannot be so in one of the cases before is the case that the text has turned to, however it says
    /// so: "To the left of the origin, $x < 0$, we have", "The remaining case is $x < 0$. Here".
    fn turn_to_other_cases(&mut self, since: usize, cases: &[usize], named: &mut Vec<usize>) {
        let locals = &self.page.locals;
        let is_other = |&own: &usize| {
            let rules_out = |&old: &usize| locals[old].is_another_case_than(&locals[own]);
            own >= since && cases.iter().any(rules_out)
        };
        let told = self.told.extract_if(.., |own| is_other(own));
        let mut turned: Vec<usize> = told.collect();
        turned.extend(named.extract_if(.., |own| is_other(own)));
        for own in turned {
            let body = self.page.locals[own].span;
            self.suppose(SuppositionKind::case(true), body);
        }
    }

    /// Whether a text says that something is a number, or what another symbol is: "for equal masses, $m_1 = m_2$,".
    fn is_value(&self, body: Span) -> bool {
        let said = read_formulas(&self.page.document.source, body).unwrap_or_default();
        let mut said = said.iter().flat_map(formulas);
        said.all(|own| {
            matches!(
                own.as_equation(),
                Some((_, Expr::Number(_) | Expr::Symbol(_)))
            )
        })
    }
}
