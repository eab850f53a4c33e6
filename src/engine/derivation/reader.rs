//! A document read from top to bottom: what headings, text and directives between two displays say of the next one.

use std::ops::Range;
use std::vec;

use crate::algebra::{BigRational, Expr, Formula, Symbol};
use crate::document::{
    Attribute, Citation, Directive, Extent, Inserted, Item, Layout, Named, Premise, Prose,
    Qualities, Slope, Span, Supposition, SuppositionKind, Vanishing, above_signs, is_reason,
};
use crate::notation::{Spanned, SyntaxError, read_formulas};
use crate::sorted::Set;

use super::definition::Known;
use super::equation::formulas;
use super::page::{Page, Premises};
use super::qualities::{self, Sayings};
use super::rows::{self, Part};
use super::supposed::{Local, MOST_BEFORE, rate_of, said_of_moment, slope_by};
use super::{Equation, Kind};

/// Of the values that a piece of text names, so many are looked at.
const MOST_MENTIONED: usize = 6;

/// So many kinds of things with values of their own are kept in mind.
const MOST_KINDS: usize = 8;
/// No shorter word names a kind: "a", "of".
const SHORTEST_NAME: usize = 2;
/// So much of two words is the same where one is made of the other: "conserved", "conservation".
const STEM: usize = 7;

/// What is said between one display and the next.
#[derive(Default)]
struct Between {
    given: bool,
    derived: bool,
    from: Option<Vec<Spanned<Premise>>>,
    name: Option<String>,
    numeric: Option<Option<BigRational>>,
    /// What says that the display is derived.
    derives: Option<Span>,
    cited: Vec<Citation>,
    mentioned: Vec<Span>,
    named: Vec<usize>,
    /// Conditions that are met at one place, and where that is.
    initial: Vec<(Span, Span)>,
    /// What is supposed and could not be read.
    unread: Vec<Span>,
    /// What is put as a condition in words that are not understood.
    conditions: Vec<Span>,
    /// Whether words say that the display follows from something.
    concludes: Option<bool>,
    /// Whether they cite something just before the display.
    cites: bool,
    /// Whether they say what something is meant by.
    defines: bool,
    /// Whether they go on from the display before.
    relative: bool,
    /// Whether they give a reason that is no equation.
    reasons: bool,
    /// Whether they put a condition that is no equation.
    puts_condition: bool,
    /// The names of laws that they give for a reason.
    laws_named: Vec<Span>,
    /// The last sentence of them.
    said_last: Option<Span>,
    /// Whether they go on with what was said before the display before.
    goes_on: bool,
    /// Whether they say that all factors change.
    all_vary: bool,
    /// Whether they divide something by something.
    divides: bool,
    /// The slope that they take of what they cite.
    takes: Option<Slope>,
    /// What they put in elsewhere.
    inserted: Option<Citation>,
    /// Whether they are a mere "where" or "with".
    meant: bool,
    /// Whether they announce several laws.
    laws: bool,
    /// Whether they announce several things by their names: where a page begins with these, all are laws.
    several: bool,
    /// Of how much the display is said.
    extent: Option<Extent>,
    /// Whether they say that something stands still: what comes next follows from that.
    rests: bool,
    /// Where a slope is said to be zero that nobody has written yet.
    slope: Option<Span>,
}

/// What has been read of a page.
pub(super) struct Reader<'p> {
    pub(super) page: &'p mut Page,
    number: usize,
    /// The displays that are still to come, read.
    ahead: vec::IntoIter<Vec<Part>>,
    pub(super) equations: Vec<Equation>,
    /// What was put in elsewhere by the words before the last display: "it" in what goes on from there.
    inserted: Option<Citation>,
    /// Of each equation, what says that it is derived.
    derived: Vec<Option<Span>>,
    pub(super) level: u8,
    section: String,
    /// Where the section begins.
    pub(super) begins: usize,
    /// What is supposed here, as positions in the page's locals.
    pub(super) active: Vec<usize>,
    /// What is told in passing.
    pub(super) told: Vec<usize>,
    /// What is said of symbols by adjectives.
    pub(super) sayings: Sayings,
    /// The cases whose sentence goes on with the next display.
    pub(super) running: Vec<usize>,
    /// The values of examples that were supposed before this are over.
    pub(super) example: usize,
    between: Between,
    /// Whether nothing that introduces the next display makes it a step: at the beginning and after a heading nothing does.
    bare: bool,
    /// Whether the next display, where nothing more than an "and" is said before it, is one of several laws.
    laws: bool,
    /// The display with which the circumstances begin that the text is about.
    circumstances: Option<usize>,
    /// Where the text came to another place: "Outside".
    elsewhere: Option<usize>,
    /// Values for kinds of things, each with the words that name the kind: "$\beta = 2/5$ for a ball".
    kinds: Vec<(Span, Span)>,
    /// The sentences that introduced displays so far.
    introduced: Vec<Span>,
    /// The letters that this section introduces anew.
    pub(super) anew: Set<Symbol>,
    /// The first display of the section.
    first_here: usize,
    /// Of how much the display before is said.
    extent: Extent,
    /// The same where something is cited, too.
    told_extent: Extent,
    /// The equations of the display that the text goes on from.
    last: Range<usize>,
    /// What is spoken of before the last display.
    known: Known,
    /// The same with the last display.
    pub(super) spoken_of: Known,
    /// What displays speak of so far.
    pub(super) displayed: Known,
}

impl<'p> Reader<'p> {
    /// At the top of a page whose declarations are read.
    pub fn new(page: &'p mut Page, number: usize, items: &[Item]) -> Self {
        Reader {
            ahead: rows::read_ahead(&page.document.source, items).into_iter(),
            page,
            number,
            equations: Vec::new(),
            inserted: None,
            derived: Vec::new(),
            level: 0,
            section: String::new(),
            begins: 0,
            active: Vec::new(),
            told: Vec::new(),
            sayings: Sayings::default(),
            running: Vec::new(),
            example: 0,
            between: Between::default(),
            bare: true,
            laws: false,
            circumstances: None,
            elsewhere: None,
            kinds: Vec::new(),
            introduced: Vec::new(),
            anew: Set::new(),
            first_here: 0,
            extent: Extent::Throughout,
            told_extent: Extent::Throughout,
            last: 0..0,
            known: Known::default(),
            spoken_of: Known::default(),
            displayed: Known::default(),
        }
    }

    /// The equations, and of each what says that it is derived.
    pub fn finish(self) -> (Vec<Equation>, Vec<Option<Span>>) {
        (self.equations, self.derived)
    }

    /// Reads on.
    pub fn item(&mut self, item: &Item) {
        match item {
            Item::Heading { level, title, span } => self.heading(*level, title, *span),
            Item::Prose(prose) => self.prose(prose),
            Item::Directives { clauses, .. } => {
                for clause in clauses {
                    self.directive(&clause.value, clause.span);
                }
            }
            Item::Display { span, body, layout } => self.display(*span, *body, layout.as_deref()),
        }
    }

    fn heading(&mut self, level: u8, title: &str, span: Span) {
        if self.page.title.is_empty() {
            self.page.title = title.to_owned();
        }
        (self.level, self.section) = (level, title.to_owned());
        (self.last, self.bare, self.laws) = (0..0, true, false);
        (self.circumstances, self.first_here) = (None, self.equations.len());
        (self.elsewhere, self.anew) = (None, Set::new());
        (self.extent, self.told_extent) = (Extent::Throughout, Extent::Throughout);
        self.leave_section();
        self.begins = span.start;
        let locals = &self.page.locals;
        self.active.retain(|&at| locals[at].outlasts(level));
        let stays = |at: &usize| locals[*at].lasts || locals[*at].level < level;
        self.told.retain(stays);
        self.sayings.below(level);
    }

    fn prose(&mut self, prose: &Prose) {
        let tail = if self.last.is_empty() { 0 } else { prose.tail };
        let (of_last, own) = prose.citations.split_at(tail);
        for equation in &mut self.equations[self.last.clone()] {
            equation.cite(of_last, prose.says_from);
        }
        self.between.hear(prose, own);
        self.put_in(&prose.inserted);
        let told_with_last = match prose.joins {
            true => self.told_with_last(),
            false => Vec::new(),
        };
        let before = self.page.locals.len();
        self.qualities(prose);
        let mut mentioned = prose.mentions.clone();
        if prose.suppositions.iter().any(|s| s.kind.begins_a_case()) {
            self.forget_cases();
        }
        for supposition in &prose.suppositions {
            mentioned.extend(self.supposition(supposition, &prose.citations));
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
        let named = std::mem::take(&mut self.between.named);
        self.leave_old_values(&named);
        self.between.named = named;
        self.between.named.extend(told_with_last);
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

    /// Takes up the value of the kind of things that the sentence is about that leads on to a display: "For a diatomic gas (1) gives".
    fn kind_of(&mut self, leading: Span) {
        let source = &self.page.document.source;
        if self.kinds.is_empty() || leading == Span::default() {
            return;
        }
        let said = words_of(source, leading);
        let newest = self.kinds.len().saturating_sub(MOST_KINDS);
        let kinds = &self.kinds[newest..];
        let all: Vec<Set<String>> = kinds.iter().map(|own| words_of(source, own.0)).collect();
        // What tells a kind from the others: "diatomic" of "diatomic gases".
        let names = |at: usize| {
            let others = (0..all.len()).filter(|&other| all[other] != all[at]);
            let others: Vec<usize> = others.collect();
            let own = all[at].iter();
            let mut own =
                own.filter(|word| others.iter().all(|&other| !all[other].contains(*word)));
            own.any(|word| said.contains(word))
        };
        let meant: Vec<usize> = (0..all.len()).filter(|&at| names(at)).collect();
        let is_one = meant.windows(2).all(|pair| all[pair[0]] == all[pair[1]]);
        let meant: Vec<Span> = meant.into_iter().map(|at| kinds[at].1).collect();
        for body in meant.into_iter().filter(|_| is_one) {
            self.suppose(SuppositionKind::Case { runs_on: true }, body);
        }
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
            let mut own = self.page.locals[before..].iter();
            let within =
                |local: &Local| body.start <= local.span.start && local.span.end <= body.end;
            if !own.any(within) && (!is_drawn || self.is_value(body) || !self.is_said(body)) {
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

    /// Takes up what is said by adjectives: in the display that the sentence is of, too.
    fn qualities(&mut self, prose: &Prose) {
        let mut all = prose.suppositions.iter();
        let left = all.rfind(|own| own.kind.leaves_cases());
        if left.is_some() {
            self.sayings.forget();
        }
        if prose.qualities.iter().any(|own| own.of_case) {
            self.sayings.leave_case();
        }
        let here = |own: &&Qualities| left.is_none_or(|left| left.body.start < own.body.start);
        for quality in prose.qualities.iter().filter(here) {
            self.quality(quality);
        }
        for &body in &prose.changing {
            let changing = qualities::spoken_of(&self.page.document.source, body);
            self.sayings.forget_these(&changing);
        }
    }

    fn quality(&mut self, quality: &Qualities) {
        self.displayed.learn(&self.equations, &[]);
        let named = match quality.by_name {
            true => {
                let place = (quality.body, &self.equations[..], &[][..]);
                match self.page.vanishing(Vanishing::Named, place) {
                    Some(Expr::Symbol(symbol)) => vec![symbol],
                    _ => Vec::new(),
                }
            }
            false => qualities::named(&self.page.document.source, quality.body),
        };
        let attributes = quality.attributes.iter().cloned();
        let attributes: Vec<Spanned<Attribute>> = attributes
            .map(|value| Spanned {
                value,
                span: quality.body,
            })
            .collect();
        for symbol in &named {
            for attribute in &attributes {
                let of_case = quality.of_case;
                let introduces = !of_case && !self.displayed.speaks_of(symbol);
                let level = if introduces { 0 } else { self.level };
                self.sayings.take(symbol, attribute.clone(), level, of_case);
            }
            if quality.goes_on {
                for equation in &mut self.equations[self.last.clone()] {
                    let said = equation.said.entry(symbol.clone()).or_default();
                    said.attributes.extend(attributes.iter().cloned());
                }
            }
        }
    }

    /// What was told of a special case is told no more.
    fn forget_cases(&mut self) {
        let locals = &self.page.locals;
        self.told.retain(|&at| !locals[at].of_case);
    }

    /// Takes up what prose supposes; what it only names is returned.
    fn supposition(
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
            SuppositionKind::General | SuppositionKind::Elsewhere => {
                let all = kind == SuppositionKind::General;
                active.retain(|&at| !page.locals[at].is_left_by(all));
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
            SuppositionKind::Equals(what, to, value) => {
                let term = |what, body| page.vanishing(what, (body, &self.equations, cited));
                match (term(what, body), term(to, value)) {
                    (Some(term), Some(value)) => {
                        page.begin_moment(passage, false, &[], active);
                        active.push(page.suppose_equal(term, value, body, Some(passage)));
                    }
                    _ => self.between.unread.push(body),
                }
            }
            SuppositionKind::Unread => self.between.conditions.push(body),
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

    /// Whether displays say already what the text says something is: that it is something else they would have to show. Of what
    /// nobody spoke of before they can show nothing: "All of it becomes kinetic energy, $U = K$".
    fn is_said(&mut self, body: Span) -> bool {
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
        if matches!(kind, SuppositionKind::Case { .. }) {
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
        self.keep(new.clone(), kind);
        new
    }

    /// Leaves the cases before the last display that speak of the same: "If $R = r$, $$…$$ If $r = 0$, $$…$$".
    fn leave_rivals(&mut self, body: Span) {
        let Some(last) = self.equations.last() else {
            return;
        };
        let mut own = qualities::spoken_of(&self.page.document.source, body);
        own.retain(|symbol| !symbol.is_unit());
        let locals = &self.page.locals;
        let is_rival = |local: &Local| {
            let is_before = local.of_case && local.span.start < last.span.start;
            is_before && !local.is_figure && !local.names().is_disjoint(&own)
        };
        self.active.retain(|&at| !is_rival(&locals[at]));
    }

    fn suppose(&mut self, kind: SuppositionKind, body: Span) {
        let new = self.take_up(kind, body);
        if new.is_empty() && read_formulas(&self.page.document.source, body).is_err() {
            self.between.unread.push(body);
        }
        match kind {
            SuppositionKind::Case { runs_on: true } => self.running.extend(new),
            SuppositionKind::Figure => self.begin_example(new),
            SuppositionKind::Define => {
                for equation in &mut self.equations[self.last.clone()] {
                    equation.locals.extend(new.clone());
                }
            }
            _ => {}
        }
    }

    fn directive(&mut self, directive: &Directive, span: Span) {
        let between = &mut self.between;
        if let Directive::Derived | Directive::From(_) | Directive::Numeric(_) = directive {
            between.derives = Some(span);
        }
        let mut suppose = |body: Span, kind| {
            let active = &mut self.active;
            self.page.suppose(body, kind, self.level, active, true);
        };
        match directive {
            Directive::Given => between.given = true,
            Directive::Derived => between.derived = true,
            Directive::From(premises) => between.from = Some(premises.clone()),
            Directive::Claim(name) => between.name = Some(name.value.clone()),
            Directive::Assuming(body) => suppose(*body, SuppositionKind::Assume),
            Directive::Let(body) => suppose(*body, SuppositionKind::Let),
            Directive::Numeric(near) => between.numeric = Some(near.clone()),
            Directive::Symbols { .. } | Directive::Data { .. } => {}
        }
    }

    fn display(&mut self, span: Span, body: Span, layout: Option<&Layout>) {
        let mut said = std::mem::take(&mut self.between);
        self.inserted = said.inserted.take();
        let source = &self.page.document.source;
        said.cited.extend(above_signs(source, body));
        let read = self.ahead.next();
        let mut read = read.unwrap_or_else(|| rows::read(source, body, layout));
        let statements = read.iter_mut().flat_map(|row| row.statements.as_mut());
        self.page.read_exponentials(statements.flatten());
        self.page
            .leave_cases(&read, &self.running, &mut self.active);
        self.leave_examples(&read);
        self.leave_places(&read);
        // "At the critical point both slopes vanish: $$p' = 0$$" says itself what the words announce.
        if !said.conditions.is_empty() && !said_to_be_zero(&read) {
            said.unread.append(&mut said.conditions);
        }
        let drawn = said.draws(&read);
        if !drawn {
            self.redefine(&read);
        }
        if let Some(span) = said.slope
            && let Some(slope) = slope_by(&read, &self.equations)
        {
            let passage = self.equations.len();
            self.page
                .begin_moment(passage, false, &[], &mut self.active);
            let zero = Expr::integer(0);
            let slope = self.page.suppose_equal(slope, zero, span, Some(passage));
            self.active.push(slope);
        }
        self.take_slope(&said, &read);
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
        self.last = self.equations.len()..self.equations.len() + of_display;
        let alone = self.equations.is_empty() && said.announces_all(&read) && said.from.is_none();
        for (row, (part, at_moment)) in read.into_iter().zip(at_moment).enumerate() {
            let display = (self.equations.len(), part.body);
            let mut equation = self.equation(&said, part, row, drawn);
            // A claim is one display; where that has several numbers the name is that of the last.
            if row + 1 == of_display {
                equation.name = said.name.clone();
            }
            if of_display == 1 {
                equation.span = span;
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
        self.active.retain(|&at| !locals[at].of_display);
        self.leave_told(&said, before);
    }

    /// Whether a law stands on the page already, by its name: "conservation of momentum" after "Momentum is conserved:".
    fn stands(&self, law: Span) -> bool {
        let source = &self.page.document.source;
        let stems = |text| -> Set<String> {
            let words = words_of(source, text).into_iter();
            let words = words.filter(|word| word != "the");
            words
                .map(|word| word.chars().take(STEM).collect())
                .collect()
        };
        let name = stems(law);
        let recent = self.introduced.iter().rev().take(MOST_BEFORE);
        // "The law" may be any.
        name.len() > 1 && recent.into_iter().any(|&own| name.is_subset(&stems(own)))
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
            is_law: self.laws && said.is_uncited() && !drawn,
            circumstances: self.circumstances,
            anew: self.anew.clone(),
            section_start: self.first_here,
            extent: self.extent,
            at_moment: self.told_extent == Extent::Moment,
            moments: 0..0,
            drawn: is_derived,
            numeric: said.numeric.clone().filter(|_| kind != Kind::Given),
            premises: match &said.from {
                Some(named) => Premises::Named(named.clone()),
                None => Premises::Cited(said.cited.clone()),
            },
            row,
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

/// The words of a piece of text that name something, in lower case and without the ending of the plural.
fn words_of(source: &str, text: Span) -> Set<String> {
    let text = source.get(text.range()).unwrap_or_default();
    let words = text.split(|c: char| !c.is_alphabetic());
    let words = words.filter(|word| word.len() > SHORTEST_NAME);
    words
        .map(|word| word.to_lowercase().trim_end_matches('s').to_owned())
        .collect()
}

/// Whether a display says of something that it is zero.
fn said_to_be_zero(read: &[Part]) -> bool {
    let statements = read
        .iter()
        .flat_map(|part| part.statements.iter().flatten());
    let zero = Expr::integer(0);
    let mut said = statements.flat_map(formulas);
    said.any(|own| own.as_equation().is_some() && own.terms().contains(&&zero))
}

impl Between {
    /// Takes up a piece of text, with those of its citations that are of the next display.
    fn hear(&mut self, prose: &Prose, cited: &[Citation]) {
        self.cited.extend_from_slice(cited);
        self.relative |= prose.is_relative && self.concludes.is_none();
        self.concludes = prose.concludes.or(self.concludes);
        self.reasons |= prose.reasons;
        self.laws_named.extend_from_slice(&prose.laws_named);
        self.said_last = prose.said_last.or(self.said_last);
        self.goes_on |= prose.goes_on;
        self.all_vary |= prose.all_vary;
        self.divides |= prose.divides;
        self.takes = prose.slope;
        self.meant |= prose.says_what_is_meant;
        self.laws |= prose.announces_laws;
        self.several = prose.announces_several;
        self.puts_condition |= prose.puts_condition;
        self.extent = prose.extent.or(self.extent);
        self.cites |= prose.closing > 0;
        self.defines |= prose.defines;
    }

    /// Whether nothing is said of what the display comes from.
    fn is_uncited(&self) -> bool {
        let stated = self.given || self.derived || self.from.is_some() || self.numeric.is_some();
        self.cited.is_empty() && !stated && !self.rests
    }

    /// Whether all that is cited is the display itself: "Torricelli's law @eq-law:" announces what is displayed next.
    fn announces_all(&self, read: &[Part]) -> bool {
        self.cited.iter().all(|cited| {
            read.iter().any(|part| match cited.key {
                true => part.keys.contains(&cited.tag),
                false => part.tag.as_ref() == Some(&cited.tag),
            })
        })
    }

    /// Whether words cite something, or say that the display follows, and none that it defines anything.
    fn draws(&self, read: &[Part]) -> bool {
        // What is announced is not cited.
        let cites = self.cites && !self.announces_all(read);
        (self.concludes == Some(true) || cites || self.rests) && !self.defines
    }
}
