//! What is said for good. A bound of a symbol that is introduced with it ("each of mass $m > 0$"), and the meaning of a new one ("Let
//! $\mu = m_2/m_1$ be the mass ratio"), are so below the headings that follow as well, until the letter is introduced anew there.

use std::cell::LazyCell;
use std::ops::Range;

use crate::algebra::{Expr, Formula, Relation, Symbol};
use crate::document::{Span, SuppositionKind};

use super::equation::formulas;
use super::page::Page;
use super::qualities::spoken_of;
use super::reader::Reader;
use super::rows::{self, Part};
use super::supposed::Local;
use crate::sorted::Set;

impl Local {
    /// Whether all that it says is that symbols are greater or less than numbers, or none.
    pub(super) fn bounds(&self) -> bool {
        self.formulas.iter().all(|own| bounded(own).is_some())
    }

    /// Whether headings do not end it.
    pub(super) fn outlasts(&self, level: u8) -> bool {
        self.lasts || self.level < level && !self.is_momentary()
    }
}

impl Page {
    /// Whether a text says of symbols that they are greater or less than numbers, or none, and nothing else; and they are such.
    fn bounds_such(&self, body: Span, such: impl Fn(&Symbol) -> bool) -> bool {
        let said = self.supposed(body).unwrap_or_default();
        let mut said = said.iter().flat_map(|own| &own.0).peekable();
        said.peek().is_some() && said.all(|own| bounded(own).is_some_and(&such))
    }
}

impl Reader<'_> {
    /// What a text that is told in passing amounts to: the bound of a symbol that it introduces is a hypothesis.
    pub(super) fn as_introduced(&mut self, kind: SuppositionKind, body: Span) -> SuppositionKind {
        let in_passing = matches!(kind, SuppositionKind::Fact { of_case: false, .. });
        self.displayed.learn(&self.equations, &[]);
        let is_new = |symbol: &Symbol| !self.displayed.speaks_of(symbol);
        match in_passing && self.page.bounds_such(body, is_new) {
            true => SuppositionKind::Assume,
            false => kind,
        }
    }

    /// Keeps below the headings that follow what was just supposed, if it is said for good.
    pub(super) fn keep(&mut self, new: Range<usize>, kind: SuppositionKind) {
        if kind == SuppositionKind::Let {
            let own: Set<Symbol> = (self.page.locals[new.clone()].iter())
                .flat_map(Local::names)
                .collect();
            self.forget_lasting(|local| local.bounds() && !local.names().is_disjoint(&own));
        }
        self.displayed.learn(&self.equations, &[]);
        for local in &mut self.page.locals[new] {
            let mut bounded = local.formulas.iter().map(|own| bounded(own));
            let is_new = |symbol: &Symbol| !self.displayed.speaks_of(symbol);
            let bounds_new = bounded.all(|symbol| symbol.is_some_and(is_new));
            let assumes = kind == SuppositionKind::Assume && !local.of_case && bounds_new;
            local.lasts = local.moment.is_none() && (local.means || assumes);
            // "With $\mu = m_2/m_1$ we divide" begins no case, "For $x = 2 a$ the force vanishes" does.
            local.of_case &= !local.means || matches!(kind, SuppositionKind::Fact { .. });
        }
    }

    /// A section without displays sets the stage for those that follow: what it lets be bounded is so there.
    pub(super) fn leave_section(&mut self) {
        let is_setup = (self.equations.last()).is_none_or(|last| last.span.start < self.begins);
        if !is_setup {
            return;
        }
        let begins = self.begins;
        let here = |local: &Local| local.span.start >= begins && local.moment.is_none();
        for &at in &self.active {
            let local = &mut self.page.locals[at];
            local.lasts |= here(local) && !local.of_case && local.bounds();
        }
    }

    /// A letter is introduced anew: "Let $x$ be a real number". What was said of it above belongs to the sections above.
    pub(super) fn introduce_anew(&mut self, body: Span) {
        let anew = spoken_of(&self.page.document.source, body);
        self.forget_lasting(|local| !local.names().is_disjoint(&anew));
        self.sayings.forget_above(&anew, self.begins);
        self.anew.extend(anew);
    }

    /// What a display says afresh of a letter, `E = \dots`, takes the place of the meaning that it had in sections above.
    pub(super) fn redefine(&mut self, display: &[Part]) {
        let statements = rows::statements(display);
        // Where an implication arrives, `\Rightarrow \mu = 1`, is what it finds.
        let first = |statement| formulas(statement).into_iter().next();
        // Few sections have meanings of sections above.
        let said = LazyCell::new(|| statements.filter_map(first).collect::<Vec<Formula>>());
        let afresh = |own: &Formula| match own.as_equation() {
            Some((left @ Expr::Symbol(_), _)) => said
                .iter()
                .any(|said| said.as_equation().is_some_and(|said| said.0 == left) && said != own),
            _ => false,
        };
        self.forget_lasting(|local| local.means && local.formulas.iter().any(|own| afresh(own)));
    }

    fn forget_lasting(&mut self, is_left: impl Fn(&Local) -> bool) {
        let (locals, begins) = (&self.page.locals, self.begins);
        let stays = |at: &usize| {
            let local = &locals[*at];
            !local.lasts || local.span.start >= begins || !is_left(local)
        };
        self.active.retain(stays);
        self.told.retain(stays);
    }
}

/// The symbol that a formula says is greater or less than a number, or none.
fn bounded(formula: &Formula) -> Option<&Symbol> {
    match formula {
        Formula::Relation {
            relation: Relation::Equal,
            ..
        } => None,
        Formula::Relation {
            left: Expr::Symbol(symbol),
            right: Expr::Number(_),
            ..
        }
        | Formula::Relation {
            left: Expr::Number(_),
            right: Expr::Symbol(symbol),
            ..
        } => Some(symbol),
        _ => None,
    }
}
