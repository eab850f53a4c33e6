//! A display, with what was said before it: its rows become equations.

use crate::algebra::{Expr, Formula, Symbol};
use crate::document::{Extent, Layout, Span, Vanishing, above_signs};
use crate::notation::SyntaxError;
use crate::sorted::Set;

use super::super::equation::formulas;
use super::super::page::Premises;
use super::super::rows::{self, Part};
use super::super::supposed::{said_of_moment, slope_by};
use super::super::{Equation, Kind, qualities};
use super::Reader;
use super::between::Between;
use super::prose::MOST_MENTIONED;

impl Reader<'_> {
    pub(super) fn display(&mut self, span: Span, body: Span, layout: Option<&Layout>) {
        let mut said = std::mem::take(&mut self.between);
        self.inserted = said.inserted.take();
        let source = &self.page.document.source;
        said.cited.extend(above_signs(source, body));
        let read = self.ahead.next();
        let mut read = read.unwrap_or_else(|| rows::read(source, body, layout, &self.page.context));
        let statements = read.iter_mut().flat_map(|row| row.statements.as_mut());
        self.page.read_exponentials(statements.flatten());
        self.page
            .leave_cases(&read, &self.running, &mut self.active);
        self.leave_examples(&read);
        self.leave_places(&read);
        self.leave_limits(&read, &mut said.named);
        // "At the critical point both slopes vanish: $$p' = 0$$" says itself what the words announce.
        if !said.conditions.is_empty() && !said_to_be_zero(&read) {
            said.unread.append(&mut said.conditions);
        }
        let drawn = said.draws(&read);
        if !drawn {
            self.redefine(&read);
        }
        let slope = said
            .slope
            .map(|span| (span, slope_by(&read, &self.equations)));
        // By what is differentiated nobody knows, if the display does not show it.
        if let Some((span, None)) = slope
            && !shows_a_slope(&read)
        {
            said.unread.push(span);
        }
        if let Some((span, Some(slope))) = slope {
            let passage = self.equations.len();
            self.page
                .begin_moment(passage, false, &[], &mut self.active);
            let zero = Expr::integer(0);
            let slope = self.page.suppose_equal(slope, zero, span, Some(passage));
            self.active.push(slope);
        }
        self.take_slope(&said, &read);
        if let (Some(subject), Some(first)) = (said.subject, read.first()) {
            self.page.name_subject(subject, first);
        }
        let of_display = read.len();
        // "Newton's second law along the incline gives … and perpendicular to it …"
        said.reasons |=
            said.goes_on && (self.equations.last()).is_some_and(|own| own.reasons && own.bare);
        self.bare = said.is_uncited()
            && match said.concludes {
                Some(concludes) => !concludes || said.reasons,
                // Where nothing is said between two displays, they are introduced together.
                None => self.bare,
            };
        let law_stands = said.laws_named.iter().any(|&law| self.stands(law));
        self.introduced.extend(said.said_last);
        let goes_on = said.concludes.is_none() || said.extent == Some(Extent::AsBefore);
        let begins = said.several && self.equations.is_empty();
        self.laws = said.laws || begins || self.laws && goes_on;
        if said.extent == Some(Extent::Circumstances) {
            self.circumstances = Some(self.equations.len());
        }
        let or_before = |before: Extent| match said.extent {
            None | Some(Extent::AsBefore) => before,
            Some(extent) => extent,
        };
        self.told_extent = or_before(self.told_extent);
        self.extent = match self.bare {
            true => or_before(self.extent),
            false => Extent::Throughout,
        };
        // Where the display before ends.
        let before = self.equations.last().map_or(0, |last| last.span.end);
        let at_moment = self.said_of_moment(&read);
        let passage = self.passage(&said, &read, &at_moment);
        self.page.forget_moments(&self.active, &mut self.told);
        let steps = (&self.equations[..], &read[..]);
        let not_understood = (self.page).suppose_where_met(&said.initial, steps, &mut self.active);
        said.unread.extend(not_understood);
        // What is not understood is said of all displays that nothing parts.
        if goes_on && self.first_here < self.equations.len() {
            let before = self.equations.last();
            said.unread
                .extend(before.iter().flat_map(|own| &own.unread));
        }
        self.last = self.equations.len()..self.equations.len() + of_display;
        let alone = self.equations.is_empty() && said.announces_all(&read) && said.from.is_none();
        for (row, (part, at_moment)) in read.into_iter().zip(at_moment).enumerate() {
            let display = (self.equations.len(), part.body);
            let mut equation = self.equation(&said, part, row, drawn);
            // A claim is one display; where that has several numbers the name is that of the last.
            if row + 1 == of_display {
                equation.name = said.name.clone();
            }
            // What stands before the first row and after the last is no prose, nor is what parts rows that share a number.
            if row > 0
                && equation.among.is_some()
                && let Some(before) = self.equations.last_mut()
            {
                before.span.end = equation.span.start;
            }
            if row == 0 {
                equation.span.start = span.start;
            }
            if row + 1 == of_display {
                equation.span.end = span.end;
            }
            equation.opens &= alone;
            equation.drawn &= drawn;
            equation.law_stands = law_stands;
            self.derived.push(said.derives);
            self.leave_announced(&mut equation);
            if let Some(passage) = passage {
                let active = &mut self.active;
                equation.moments =
                    (self.page).suppose_at_moment(at_moment, display, passage, active);
            }
            self.equations.push(equation);
        }
        self.running.clear();
        let locals = &self.page.locals;
        let stationary = &self.stationary;
        self.active
            .retain(|at| !locals[*at].of_display || stationary.contains(at));
        self.told.retain(|at| !locals[*at].of_display);
        self.leave_told(&said, before);
    }

    /// Takes up what a new symbol is that the words before its display take as the slope of another: "Differentiating (1) we obtain the
    /// velocity". Where it is not known by what they differentiate, nothing is.
    fn take_slope(&mut self, said: &Between, read: &[Part]) {
        let Some(slope) = said.takes.filter(|_| said.draws(read)) else {
            return;
        };
        self.spoken_of.learn(&self.equations, &self.page.locals);
        let [Ok([statement])] = read
            .iter()
            .map(|part| part.statements.as_deref())
            .collect::<Vec<_>>()[..]
        else {
            return;
        };
        let said_first = formulas(statement).into_iter().next();
        let name = match said_first.as_ref().and_then(Formula::as_equation) {
            Some((Expr::Symbol(name), _)) if !self.spoken_of.speaks_of(name) => name.clone(),
            _ => return,
        };
        let variable = match slope.by {
            Some(body) => qualities::named(&self.page.document.source, body)
                .into_iter()
                .next(),
            None => slope.by_time.then(|| Symbol::new("t")),
        };
        let place = (slope.cited, &self.equations[..], &said.cited[..]);
        let (Some(variable), Some(of)) = (variable, self.page.vanishing(Vanishing::Cited, place))
        else {
            return;
        };
        let mut value = of.differentiated_by(&variable);
        if slope.twice {
            value = value.differentiated_by(&variable);
        }
        let formula = Formula::equal(Expr::Symbol(name), value);
        let local = self.page.suppose_meant(vec![formula], slope.cited);
        let own = &mut self.page.locals[local];
        (own.lasts, own.level) = (false, self.level);
        self.active.push(local);
    }

    /// What the words before a display announce is no case that it is said of: "With $x \geq a$ always, (1) gives $$x \geq a$$".
    fn leave_announced(&self, equation: &mut Equation) {
        if self.running.is_empty() {
            return;
        }
        let said: Vec<Formula> = equation.statements().iter().flat_map(formulas).collect();
        let locals = &self.page.locals;
        let is_said = |at: &usize| locals[*at].formulas.iter().all(|own| said.contains(own));
        let running = &self.running;
        equation
            .locals
            .retain(|at| !running.contains(at) || !is_said(at));
    }

    /// Leaves what was told of one display: what has a number for a value. What was told of a case is not told of laws after it.
    fn leave_told(&mut self, said: &Between, before: usize) {
        let is_law = self.bare && said.is_uncited();
        let locals = &self.page.locals;
        self.told.retain(|&at| {
            let local = &locals[at];
            let is_over = is_law && local.of_case && !local.means && local.span.start < before;
            local.set.is_empty() && !is_over
        });
    }

    /// What a display says of one moment, row by row.
    fn said_of_moment(&mut self, read: &[Part]) -> Vec<Vec<Formula>> {
        let extent = self.extent;
        if !matches!(extent, Extent::Moment | Extent::Condition) {
            return vec![Vec::new(); read.len()];
        }
        self.spoken_of.learn(&self.equations, &self.page.locals);
        let is_known = |symbol: &Symbol| self.spoken_of.speaks_of(symbol);
        let of = |part: &Part| {
            let statements = part.statements.iter().flatten();
            let said = |s| said_of_moment(s, extent, is_known);
            statements.filter_map(said).collect()
        };
        read.iter().map(of).collect()
    }

    /// The passage of the moment that a display is of; where it is of none, moments are left.
    fn passage(
        &mut self,
        said: &Between,
        read: &[Part],
        at_moment: &[Vec<Formula>],
    ) -> Option<usize> {
        if at_moment.iter().all(Vec::is_empty) {
            let is_derived = said.draws(read) || !said.announces_all(read);
            self.page.leave_moments(read, is_derived, &mut self.active);
            return None;
        }
        let goes_on = matches!(said.extent, None | Some(Extent::AsBefore));
        let at = self.equations.len();
        let begun = (self.page).begin_moment(at, goes_on, &self.running, &mut self.active);
        Some(begun)
    }

    /// A row of a display, as far as it can be told without the others.
    fn equation(&self, said: &Between, part: Part, row: usize, drawn: bool) -> Equation {
        let statements = || part.statements.iter().flatten();
        let mark = statements().any(|s| s.mark.is_some());
        let kind = match () {
            () if said.given => Kind::Given,
            () if said.numeric.is_some() => Kind::Derived,
            () if mark => Kind::Marked,
            () => Kind::Derived,
        };
        let by_cases = statements().find(|s| !s.under.is_empty());
        let by_cases = by_cases.filter(|_| said.numeric.is_some()).map(|s| s.span);
        let stated = said.derived || said.numeric.is_some();
        let is_derived = kind == Kind::Derived;
        let opened = row == 0 && self.first_here == self.equations.len();
        let may_define = is_derived && !stated && said.from.is_none();
        let locals = self.in_effect(&part);
        Equation {
            page: self.number,
            tag: part.tag,
            keys: part.keys,
            group: part.group,
            name: None,
            span: part.body,
            body: part.body,
            defines: (0..statements().count()).filter(|_| may_define).collect(),
            statements: match by_cases {
                None => part.statements,
                Some(span) => Err(SyntaxError {
                    span,
                    message: "a numeric claim is not read by cases".into(),
                    help: None,
                }),
            },
            kind,
            introduces: Set::new(),
            explains: false,
            explained: Set::new(),
            opens: is_derived && !stated,
            relative: said.relative,
            bare: self.bare && is_derived && part.continues == 0,
            joined: self.bare && !opened && (row > 0 || said.concludes.is_none()),
            uncited: said.is_uncited() && is_derived && part.continues == 0,
            reasons: said.reasons,
            puts_condition: said.puts_condition,
            said_last: said.said_last,
            law_stands: false,
            all_vary: said.all_vary,
            divides: said.divides,
            meant: said.meant,
            replaces: said.replaces,
            is_law: self.laws && said.is_uncited() && !drawn,
            circumstances: self.circumstances,
            anew: self.anew.clone(),
            section_start: self.first_here,
            extent: self.extent,
            told_extent: self.told_extent,
            moments: 0..0,
            drawn: is_derived,
            numeric: said.numeric.clone().filter(|_| kind != Kind::Given),
            premises: match &said.from {
                Some(named) => Premises::Named(named.clone()),
                None => Premises::Cited(said.cited.clone()),
            },
            row,
            among: part.among,
            continues: part.continues,
            locals,
            told: (self.told.iter().rev().take(MOST_MENTIONED).copied()).collect(),
            said: self.sayings.here(),
            disputed: Set::new(),
            released: Set::new(),
            mentioned: said.mentioned.clone(),
            named: said.named.clone(),
            unread: said.unread.clone(),
            section: self.section.clone(),
        }
    }
}

/// Whether a display speaks of a slope.
fn shows_a_slope(read: &[Part]) -> bool {
    rows::said(read).any(|own| own.speaks_of_slopes())
}

/// Whether a display says of something that it is zero.
fn said_to_be_zero(read: &[Part]) -> bool {
    let zero = Expr::integer(0);
    rows::said(read).any(|own| own.as_equation().is_some() && own.terms().contains(&&zero))
}
