//! What may be assumed where an equation stands: what the text supposes, tells and names, each with where it comes from.

use std::sync::Arc;

use crate::algebra::{Expr, Formula, Symbol};
use crate::document::{Extent, Inline, Span};
use crate::kernel::{Standing, running_in};
use crate::notation::read_formulas;

use super::equation::{Kind, formulas, says_of};
use super::page::Page;
use super::supposed::{Local, said_of_moment};
use super::{Derivation, constants};

/// A hypothesis with where it comes from.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Assumed {
    /// What is assumed.
    pub formula: Arc<Formula>,
    /// Throughout, or at the point in question.
    pub standing: Standing,
    /// Where it comes from.
    pub source: Source,
}

impl Assumed {
    /// Whether the text tells it of one place: that `w` is 0 where `x` is.
    pub fn tells_value_there(&self) -> bool {
        let sides = self.formula.as_equation();
        self.source == Source::Step && matches!(sides, Some((Expr::Limit { .. }, _)))
    }
}

impl Assumed {
    /// Whether it says of a symbol what it is: `s = …`.
    pub fn is_of(&self, symbol: &Symbol) -> bool {
        says_of(&self.formula, symbol)
    }
}

/// Where a hypothesis comes from.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Source {
    /// A `let` or an assumption: page, position in [`Page::locals`](super::Page::locals).
    Local(usize, usize),
    /// An equation, by position.
    Equation(usize),
    /// An earlier step of the same statement, or the other side of an `\iff`.
    Step,
    /// Taken so, where it is not said: that `P_{\max}` is `P` at the place in question.
    Taken,
    /// The law of propagation of uncertainty, where words speak of uncertainties.
    Propagation,
    /// What constants of nature have to do with one another: `c^2 = \frac{1}{\varepsilon_0 \mu_0}`.
    Nature,
}

impl Source {
    /// Whether it comes from nowhere else in the text.
    pub fn is_of_statement(self) -> bool {
        matches!(
            self,
            Source::Step | Source::Taken | Source::Propagation | Source::Nature
        )
    }
}

impl Derivation {
    /// The hypotheses in effect where an equation stands.
    pub fn locals(&self, at: usize) -> Vec<Assumed> {
        self.supposed(at, &self.equations[at].locals)
    }

    /// Those that are so at one moment alone.
    pub fn momentary(&self, at: usize) -> Vec<Assumed> {
        let own = &self.equations[at];
        let locals = own.locals.iter().copied();
        let of_moment = |&local: &usize| self.local(own.page, local).is_momentary();
        self.supposed(at, &locals.filter(of_moment).collect::<Vec<_>>())
    }

    /// Whether an equation says something throughout or of one value alone of what runs in others that it is taken with: "At the top $v = 0$",
    /// or what is given where $t = 0$ is supposed.
    pub fn standing_among(&self, at: usize, others: &[usize]) -> Standing {
        let own = &self.equations[at];
        let given = own.kind == Kind::Given && !own.locals.is_empty();
        let of_moment = |statement| said_of_moment(statement, Extent::Moment, |_| true).is_some();
        let told = own.told_extent == Extent::Moment
            && !own.explains
            && own.statements().iter().all(of_moment);
        if !told && !given {
            return Standing::Identity;
        }
        let statements = others
            .iter()
            .flat_map(|&at| self.equations[at].statements());
        let said: Vec<Formula> = statements.flat_map(formulas).collect();
        let running = running_in(said.iter());
        let page = &self.pages[own.page];
        let fixes = |local: &usize| {
            let local = &page.locals[*local];
            let at_point = |own: &&Arc<Formula>| page.standing_of(local, own) == Standing::AtPoint;
            let mut formulas = local.formulas.iter().filter(at_point);
            formulas.any(|own| {
                own.free_symbols()
                    .iter()
                    .any(|symbol| running.contains(symbol))
            })
        };
        match !running.is_empty() && (told || own.locals.iter().any(fixes)) {
            true => Standing::AtPoint,
            false => Standing::Identity,
        }
    }

    /// What the text before an equation tells in passing, the nearest first. What announces the equation itself is no premise of it.
    pub fn told(&self, at: usize) -> Vec<Assumed> {
        let equation = &self.equations[at];
        let mut told = self.supposed(at, &equation.told);
        if told.is_empty() {
            return told;
        }
        let stated: Vec<Formula> = equation.statements().iter().flat_map(formulas).collect();
        // What was told before the display before is what a chain begins with: `i = C \frac{dv}{dt} = …`
        let before = self
            .before_display(at)
            .filter(|_| stated.len() > 1)
            .map(|before| self.equations[before].span.start);
        let is_before = |own: &Assumed| match own.source {
            Source::Local(page, local) => before > Some(self.local(page, local).span.start),
            _ => false,
        };
        told.retain(|own| is_before(own) || !stated.contains(&own.formula));
        told
    }

    /// What the last sentence before an equation tells in passing.
    pub fn told_just_before(&self, at: usize) -> Vec<Assumed> {
        let Some(sentence) = self.equations[at].said_last else {
            return Vec::new();
        };
        let mut told = self.told(at);
        told.retain(|own| match own.source {
            Source::Local(page, local) => self.local(page, local).span.start >= sentence.start,
            _ => false,
        });
        told
    }

    /// Whether words between what is said and an equation leave cases: "For arbitrary masses".
    pub fn is_left_in_words(&self, at: usize, (page, local): (usize, usize)) -> bool {
        self.equations[at].page == page && self.is_left(at, self.local(page, local).span)
    }

    /// The same of what is said on the page of the equation.
    pub fn is_left(&self, at: usize, said: Span) -> bool {
        let own = &self.equations[at];
        let general = &self.pages[own.page].general;
        let left = general.partition_point(|&place| place < said.start);
        (general.get(left)).is_some_and(|&place| place < own.span.start)
    }

    /// Whether a text supposes something, and does not only tell it.
    pub fn is_supposed(&self, page: usize, body: Span) -> bool {
        let mut locals = self.pages[page].locals.iter();
        locals.any(|own| !own.is_told && body.start <= own.span.start && own.span.end <= body.end)
    }

    /// Whether a whole sentence says what is supposed of a place or a case: "At $t = 1$ the body is at $x = v$."
    pub fn is_said_of_a_place(&self, (page, local): (usize, usize)) -> bool {
        let said = self.local(page, local).span;
        let sentences = &self.pages[page].of_places;
        let after = sentences.partition_point(|own| own.start <= said.start);
        let before = after.checked_sub(1).map(|at| sentences[at]);
        before.is_some_and(|own| said.end <= own.end)
    }

    /// What the sentence that leads on to an equation names, and does not suppose plainly.
    pub fn named(&self, at: usize) -> Vec<Assumed> {
        self.supposed(at, &self.equations[at].named)
    }

    fn supposed(&self, at: usize, locals: &[usize]) -> Vec<Assumed> {
        let number = self.equations[at].page;
        let page = &self.pages[number];
        let meant = locals.iter().filter(|&&local| {
            !page.locals[local].only_names && !self.is_beyond(at, (number, local))
        });
        let all = meant.flat_map(|&local| {
            let source = self.source_of(number, local);
            let local = &page.locals[local];
            local.formulas.iter().map(move |formula| Assumed {
                formula: formula.clone(),
                standing: page.standing_of(local, formula),
                source,
            })
        });
        all.collect()
    }

    /// The values that the text around an equation names without supposing them, with their places.
    pub fn mentioned(&self, at: usize) -> Vec<(Span, Formula)> {
        let equation = &self.equations[at];
        let page = &self.pages[equation.page];
        let bodies = equation.mentioned.iter();
        bodies
            .flat_map(|&body| said_in(page, body).into_iter().map(move |own| (body, own)))
            .collect()
    }

    /// What the mathematics of the last sentence before an equation says, understood or not.
    pub fn written_before(&self, at: usize) -> Vec<Formula> {
        match self.equations[at].said_last {
            Some(sentence) => self.written_in(at, |math| math.body.start >= sentence.start),
            None => Vec::new(),
        }
    }

    /// What the mathematics between an equation and the display before it says, understood or not.
    pub fn written_since(&self, at: usize) -> Vec<Formula> {
        self.written_in(at, |_| true)
    }

    /// The same of some of that mathematics.
    pub fn written_in(&self, at: usize, is_meant: impl Fn(&Inline) -> bool) -> Vec<Formula> {
        let page = &self.pages[self.equations[at].page];
        let inline = self.inline_before(at).filter(|math| is_meant(math));
        inline.flat_map(|math| said_in(page, math.body)).collect()
    }

    /// What says a local hypothesis: the display, where one says it of a moment.
    fn source_of(&self, page: usize, local: usize) -> Source {
        let moment = self.pages[page].locals[local].moment.as_ref();
        match moment.and_then(|moment| moment.display) {
            Some(display) => Source::Equation(self.equations_of(page).start + display),
            None => Source::Local(page, local),
        }
    }

    /// A local hypothesis by its source.
    pub fn local(&self, page: usize, local: usize) -> &Local {
        &self.pages[page].locals[local]
    }
}

/// What a piece of mathematics in the text says, if it can be read, but for what it says under conditions or of some constant.
fn said_in(page: &Page, body: Span) -> Vec<Formula> {
    let mut statements = read_formulas(&page.document.source, body).unwrap_or_default();
    page.read_exponentials(statements.iter_mut());
    let plain = statements.iter().filter(|own| own.under.is_empty());
    let said = plain.flat_map(formulas);
    said.filter(|own| !constants::speaks_of_some(own)).collect()
}
