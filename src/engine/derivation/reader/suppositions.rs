//! What the text supposes, and what it tells in passing.

use std::ops::Range;

use crate::algebra::{Expr, Formula, Symbol};
use crate::document::{
    Citation, Span, Supposition, SuppositionKind, Vanishing, is_reason, is_tried,
};
use crate::notation::{read_formulas, read_symbol};
use crate::sorted::Set;

use super::super::equation::formulas;
use super::super::qualities;
use super::super::rows::{self, Part};
use super::super::supposed::{
    Local, MOST_BEFORE, give_the_same, parts_sentences, rate_of, rates_at,
};
use super::Reader;

impl Reader<'_> {
    /// What was told of a special case is told no more.
    pub(super) fn forget_cases(&mut self) {
        let locals = &self.page.locals;
        self.told.retain(|&at| !locals[at].of_case);
    }

    /// Takes up what prose supposes; what it only names is returned.
    pub(super) fn supposition(
        &mut self,
        &Supposition { kind, body }: &Supposition,
        cited: &[Citation],
    ) -> Option<Span> {
        let kind = self.as_introduced(kind, body);
        let (new, passage) = (self.page.locals.len().., self.equations.len());
        if matches!(kind, SuppositionKind::Fact { of_case: false, .. }) && self.is_said(body) {
            return Some(body);
        }
        let (page, active) = (&mut *self.page, &mut self.active);
        match kind {
            SuppositionKind::General
            | SuppositionKind::Elsewhere
            | SuppositionKind::InAllCases
            | SuppositionKind::Otherwise => {
                let all = kind == SuppositionKind::General;
                // What is so in each of them is not refuted where none of them is.
                if kind == SuppositionKind::InAllCases && page.has_rival_cases(self.begins) {
                    self.between.unread.push(body);
                }
                let opposite = match kind {
                    SuppositionKind::Otherwise => page.opposite(active, self.begins),
                    _ => None,
                };
                active.retain(|&at| !page.locals[at].is_left_by(all));
                match opposite {
                    Some(Some(formulas)) => active.push(page.suppose_case(formulas, body)),
                    Some(None) => self.between.unread.push(body),
                    None => {}
                }
                page.general.push(body.start);
                self.forget_cases();
                // "Inside, $E = k Q r/R^3$. Outside" leaves what was said of the place before.
                if let Some(from) = self.elsewhere.take() {
                    let locals = &self.page.locals;
                    self.told.retain(|&at| locals[at].span.start < from);
                }
                self.elsewhere = (!all).then_some(body.start);
            }
            SuppositionKind::Moment => {
                page.begin_moment(passage, false, &[], active);
                page.suppose(body, SuppositionKind::Assume, self.level, active, false);
                page.date(new.clone(), passage);
                page.leave_other_values(new, active);
            }
            SuppositionKind::Initial(place) => self.between.initial.push((body, place)),
            SuppositionKind::Fact { runs_on, .. } => {
                self.take_up(kind, body);
                let page = &mut *self.page;
                page.date_with(new, &self.active);
                self.told
                    .retain(|&at| runs_on || page.locals[at].set.is_empty());
            }
            SuppositionKind::Meaning => {
                self.spoken_of.learn(&self.equations, &page.locals);
                let known = &self.spoken_of;
                let is_new = |symbol: &Symbol| !known.speaks_of(symbol);
                if page.explains(body, is_new) || page.links(body, is_new) {
                    self.take_up(kind, body);
                }
            }
            SuppositionKind::Anew => self.introduce_anew(body),
            SuppositionKind::Common => self.name_what_is_common(body),
            SuppositionKind::Abbreviation(term) => self.name_term(body, term),
            SuppositionKind::OfKind(kind) => self.kinds.push((kind, body)),
            SuppositionKind::Known => page.suppose(body, kind, self.level, &mut self.told, false),
            SuppositionKind::Vanishes(what) | SuppositionKind::StandsStill(what) => {
                let place = (body, &self.equations[..], cited);
                match page.vanishing(what, place) {
                    Some(term) if what == Vanishing::Told => {
                        let zero = Expr::integer(0);
                        self.told.push(page.suppose_equal(term, zero, body, None));
                    }
                    Some(term)
                        if let SuppositionKind::StandsStill(_) = kind
                            && let Some(rate) = rate_of(&term, &self.equations) =>
                    {
                        active.push(page.suppose_rest(rate, body));
                        // That says all that the equation says here.
                        let is_side = |own: &Citation| own.span == body;
                        self.between.cited.retain(|own| !is_side(own));
                        self.between.rests = true;
                    }
                    Some(term) => {
                        page.begin_moment(passage, false, &[], active);
                        let zero = Expr::integer(0);
                        active.push(page.suppose_equal(term, zero, body, Some(passage)));
                    }
                    None if what == Vanishing::Slope => self.between.slope = Some(body),
                    None if matches!(what, Vanishing::Term | Vanishing::Told) => {}
                    // Of what has no letter nobody knows what it is to be zero.
                    None => self.between.unread.push(body),
                }
            }
            SuppositionKind::AtRest => {
                let rates = rates_at((body, &self.equations[..], cited));
                // That says all that the equation says here.
                if !rates.is_empty() {
                    self.between.cited.retain(|own| own.span != body);
                    self.between.rests = true;
                }
                active.extend(rates.into_iter().map(|rate| page.suppose_rest(rate, body)));
            }
            SuppositionKind::Equals(what, to, value_at) => {
                let term = |what, body| page.vanishing(what, (body, &self.equations, cited));
                match (term(what, body), term(to, value_at)) {
                    // "Equating (2) and (3)", which both say what `Q` is, supposes nothing.
                    (Some(term), Some(value))
                        if term == value
                            || give_the_same([body, value_at], &self.equations, cited) => {}
                    (Some(term), Some(value)) => {
                        page.begin_moment(passage, false, &[], active);
                        active.push(page.suppose_equal(term, value, body, Some(passage)));
                    }
                    _ => self.between.unread.push(body),
                }
            }
            SuppositionKind::StationaryBy { of, partial } => {
                match page.slope_of((of, body, partial), &self.equations, cited) {
                    Some(slope) => {
                        let slope = page.suppose_stationary(slope, body);
                        self.stationary.push(slope);
                        active.push(slope);
                    }
                    None => self.between.unread.push(body),
                }
            }
            SuppositionKind::Alternative => self.count(body),
            SuppositionKind::TakenUp(place) => self.take_up_case(place),
            SuppositionKind::Contradicted => active.retain(|&at| !page.locals[at].is_contrary),
            SuppositionKind::SolvedFor => {
                let unknown = qualities::named(&page.document.source, body);
                active.retain(|&at| !page.locals[at].sets(&unknown));
            }
            SuppositionKind::Arbitrary => self.leave_rivals(body),
            SuppositionKind::Unread => self.between.conditions.push(body),
            // "Let $x$ be positive" introduces it.
            SuppositionKind::Compared { to: None, .. } if !self.is_compared(body) => {}
            // "…, where $m = 2 a$" of what more than that display speaks of: told in passing.
            SuppositionKind::Define if !self.says_what_is_meant(body) => {
                if !self.page.explains(body, |_| true) {
                    return Some(body);
                }
                self.take_up(SuppositionKind::Meaning, body);
            }
            _ => self.suppose(kind, body),
        }
        None
    }

    /// Whether it makes a case to say of what stands there how it lies to nought: displays speak of it.
    pub(super) fn is_compared(&mut self, body: Span) -> bool {
        self.displayed.learn(&self.equations, &[]);
        let of = qualities::spoken_of(&self.page.document.source, body);
        of.iter().any(|symbol| self.displayed.speaks_of(symbol))
    }

    /// Takes up a case that the text counts, with others of the same sentence.
    fn count(&mut self, body: Span) {
        let source = &self.page.document.source;
        let is_parted = |last: &Span| parts_sentences(source, *last, body);
        if self.alternatives.last().is_none_or(is_parted) {
            self.alternatives.clear();
        }
        self.alternatives.push(body);
    }

    /// Supposes the case at that place among those that were counted, or the last, and no other of them.
    fn take_up_case(&mut self, place: Option<usize>) {
        let counted = &self.alternatives;
        let chosen = place.map_or(counted.last(), |place| counted.get(place));
        let Some(&body) = chosen else {
            return;
        };
        let locals = &self.page.locals;
        let is_other = |at: usize| counted.contains(&locals[at].span);
        self.active.retain(|&at| !is_other(at));
        self.suppose(SuppositionKind::case(true), body);
    }

    /// Whether displays say already what the text says something is: that it is something else they would have to show. Of what
    /// nobody spoke of before they can show nothing: "All of it becomes kinetic energy, $U = K$".
    pub(super) fn is_said(&mut self, body: Span) -> bool {
        let source = &self.page.document.source;
        if is_reason(source, body) {
            return false;
        }
        let said = read_formulas(source, body).unwrap_or_default();
        let said: Vec<Formula> = said.iter().flat_map(formulas).collect();
        self.spoken_of.learn(&self.equations, &self.page.locals);
        let known = |symbol: &Symbol| self.spoken_of.speaks_of(symbol);
        let values = said.iter().filter_map(|own| Some(own.as_equation()?.1));
        if values
            .into_iter()
            .any(|value| !value.free_symbols().iter().all(known))
        {
            return false;
        }
        let mut left = said.iter().filter_map(|own| Some(own.as_equation()?.0));
        let before = self.equations.iter().rev().take(MOST_BEFORE);
        let statements = before.flat_map(|own| own.statements()).flat_map(formulas);
        let known: Vec<Formula> = statements.collect();
        let mut known = known.iter().filter_map(|own| Some(own.as_equation()?.0));
        left.any(|own| known.any(|known| known == own))
    }

    fn says_what_is_meant(&mut self, body: Span) -> bool {
        let last = self.last.clone();
        self.known
            .says_what_is_meant(body, self.page, &self.equations, last)
    }

    /// Takes up what is told in passing, or supposed, and returns where it stands.
    fn take_up(&mut self, kind: SuppositionKind, body: Span) -> Range<usize> {
        use SuppositionKind::{Case, Compared, Contrary};
        if matches!(kind, Case { .. } | Compared { .. } | Contrary) {
            self.leave_rivals(body);
        }
        let before = self.page.locals.len();
        self.spoken_of.learn(&self.equations, &self.page.locals);
        let among = match kind {
            SuppositionKind::Fact { .. } | SuppositionKind::Meaning => &mut self.told,
            _ => &mut self.active,
        };
        self.page.suppose(body, kind, self.level, among, false);
        self.page.restrict(before.., kind, &self.spoken_of);
        let new = before..self.page.locals.len();
        let is_fact = matches!(kind, SuppositionKind::Fact { .. });
        let is_put_in = matches!(
            kind,
            Case {
                is_put_in: true,
                ..
            }
        );
        if is_put_in || is_fact && self.limit_before(body).is_some() {
            for local in &mut self.page.locals[new.clone()] {
                local.of_display = true;
                // What is concluded of a new name for what is put in is so for good.
                let mut names = local.names().into_iter();
                if is_put_in && names.any(|own| !self.spoken_of.speaks_of(&own)) {
                    (local.is_let, local.of_case, local.is_special) = (false, false, false);
                    (local.is_told, local.means) = (true, true);
                }
            }
        }
        if is_tried(&self.page.document.source, body) {
            let (locals, equations) = (&mut self.page.locals, &self.equations);
            locals[new.clone()]
                .iter_mut()
                .for_each(|own| own.say_of_all(equations));
        }
        self.leave_replaced(new.clone());
        self.leave_opposites(new.clone(), body);
        self.keep(new.clone(), kind);
        new
    }

    /// Leaves what one sentence says of two places: "the p side ($x < 0$) contains $N_A$ acceptors and the n side ($x > 0$) $N_D$ donors".
    fn leave_opposites(&mut self, new: Range<usize>, body: Span) {
        let (locals, source) = (&self.page.locals, &self.page.document.source);
        let is_in_passing = |own: Span| {
            let before = source.get(..own.start).unwrap_or_default();
            before.trim_end_matches(['$', '\\']).ends_with('(')
        };
        if !is_in_passing(body) {
            return;
        }
        let is_opposite = |&at: &usize| {
            let old = &locals[at];
            !new.contains(&at)
                && !old.is_equation()
                && is_in_passing(old.span)
                && locals[new.clone()]
                    .iter()
                    .any(|own| old.is_another_case_than(own))
                && !parts_sentences(source, old.span, body)
        };
        if self.active.iter().any(is_opposite) {
            let active = std::mem::take(&mut self.active).into_iter();
            let kept = active.filter(|at| !new.contains(at) && !is_opposite(at));
            self.active = kept.collect();
        }
    }

    /// What the sentence before some mathematics lets go to a limit, if it does: what is told there is so there alone, "For $s \to \infty$ the image
    /// lies at the focal point, $s' = f$".
    fn limit_before(&self, body: Span) -> Option<&str> {
        let source = &self.page.document.source;
        let before = source.get(..body.start).unwrap_or_default();
        let sentence = before.rsplit(". ").next()?;
        let sentence = sentence.rsplit("\n\n").next()?;
        let at = (sentence.find("\\to ")).or_else(|| sentence.find("\\to\\"))?;
        sentence[..at].rsplit(['$', '(']).next()
    }

    /// Leaves what is `named` of a limit where a display speaks of what goes there: it is said of any value again.
    pub(super) fn leave_limits(&self, display: &[Part], named: &mut Vec<usize>) {
        if named.is_empty() {
            return;
        }
        let said: Set<Symbol> = rows::said(display).flat_map(|own| own.names()).collect();
        let is_left = |at: usize| {
            let goes = self.limit_before(self.page.locals[at].span);
            let goes = goes.and_then(|goes| read_symbol(goes.trim()).ok());
            goes.is_some_and(|goes| said.contains(&goes))
        };
        named.retain(|&at| !is_left(at));
    }

    /// Leaves the cases before the last display in which something had another value than the text says now: "Inserting $Q = Q_m$, $$…$$ Now
    /// there are two firms, $Q = q_1 + q_2$".
    fn leave_replaced(&mut self, new: Range<usize>) {
        let Some(last) = self.equations.last() else {
            return;
        };
        let locals = &self.page.locals;
        let own = || locals[new.clone()].iter().filter(|own| own.is_equation());
        let values: Set<Symbol> = own().flat_map(Local::values).collect();
        if values.is_empty() {
            return;
        }
        self.active.retain(|&at| {
            let old = &locals[at];
            let is_left = old.is_case_before(last.span) && !old.values().is_disjoint(&values);
            new.contains(&at) || !is_left
        });
    }

    /// Leaves the cases before the last display that speak of the same: "If $R = r$, $$…$$ If $r = 0$, $$…$$".
    fn leave_rivals(&mut self, body: Span) {
        let Some(last) = self.equations.last() else {
            return;
        };
        let mut own = qualities::spoken_of(&self.page.document.source, body);
        own.retain(|symbol| !symbol.is_unit());
        let locals = &self.page.locals;
        let is_rival =
            |local: &Local| local.is_case_before(last.span) && !local.names().is_disjoint(&own);
        self.active.retain(|&at| !is_rival(&locals[at]));
    }

    pub(super) fn suppose(&mut self, kind: SuppositionKind, body: Span) {
        let new = self.take_up(kind, body);
        if new.is_empty() && read_formulas(&self.page.document.source, body).is_err() {
            self.between.unread.push(body);
        }
        match kind {
            SuppositionKind::Case { runs_on: true, .. } | SuppositionKind::Compared { .. } => {
                self.running.extend(new);
            }
            SuppositionKind::Figure => self.begin_example(new),
            SuppositionKind::Define => {
                for equation in &mut self.equations[self.last.clone()] {
                    equation.locals.extend(new.clone());
                }
            }
            _ => {}
        }
    }
}
