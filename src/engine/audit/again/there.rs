//! What a quantity is at a place: `P_{\max}` is what `P` is where it is greatest, `y_L` what `y` is "at the free end, $x = L$".
//!
//! A new symbol with an index would be defined by what stands for it. Where the quantity itself is known, and what is cited or named
//! says where, that is the step from the one to the other, and it is judged as one. It is refuted only where what follows instead
//! speaks of the same symbols: what is left of others would say that the place was not found. A step that says something else of the
//! new symbol, `v_a^2 = g a`, may follow from a law for the quantity without the index.

use crate::algebra::{Expr, Formula, Symbol, split_subscript};
use crate::derivation::{Assumed, Goal, Source, goals};
use crate::document::Span;
use crate::kernel::Standing;
use crate::search::{Decision, Effort};
use crate::sorted::Set;

use super::super::instances::index;
use super::super::judge::{Found, Judge, step, taken};
use super::super::stated::quantities;
use super::super::{Judged, Outcome};
use super::conditions::{any_part, unbounded};

/// So many equations are looked up that say what the quantity is, the nearest first.
const MOST_MEANINGS: usize = 2;
/// Indices of what is at its most or least.
const EXTREMES: [&str; 6] = ["\\max", "\\min", "max", "min", "\\text{max}", "\\text{min}"];

/// What is found of a symbol that a step would define.
pub(in crate::audit) enum There {
    /// It is what the quantity is there.
    Shown,
    /// It is what the words solve for.
    Solved(Box<Found>),
    /// It is not.
    Refuted(Box<Found>),
}

impl Judge<'_> {
    /// What would define a symbol by its first link, judged as the value of the quantity without the index; or as what the words before the
    /// step say of the symbol itself: "As $v^2 = 2 a h$, by (1)".
    pub(in crate::audit) fn as_value_there(
        &self,
        goal: &Goal,
        premises: &[usize],
        defines: bool,
    ) -> Option<There> {
        let (new, named) = self.defined_anew(goal)?;
        let cited = self.cited(goal, &[], premises);
        let words = self.said_of_the_place(Side::Both);
        let quantity = self.whole_of(new);
        let quantity = quantity.filter(|own| !named.contains(own));
        let asked = Asked {
            new,
            named: &named,
            quantity: quantity.as_ref(),
        };
        let by_itself = || self.said_of_itself(&asked, &cited, &words, premises);
        let by_itself = defines.then(by_itself).flatten();
        let at_a_place = || self.said_of_the_whole(&asked, cited, words, premises);
        let (mut assumed, mut may_fail) = by_itself.or_else(at_a_place)?;
        // "It is greatest at the clamp" means no place that was told before it.
        if self.says_in_a_row(&["at"], &["the", "its"]) {
            let all = assumed.len();
            assumed.retain(|own| !self.is_told_before(own));
            if assumed.len() < all {
                may_fail = MayFail::Never;
            }
        }
        // What may be put for what there is not clear where it is a square that is said: "For circles $a = r$, so … Putting this in (1)".
        let is_named_only =
            |own: &Assumed| own.formula.equates_names() && matches!(own.source, Source::Local(..));
        if !goal.is_of(new) && assumed.iter().any(is_named_only) {
            may_fail = MayFail::Never;
        }
        self.judged_there(goal, assumed, premises, &asked, may_fail)
    }

    /// What a symbol may name a special value of, unless a chain that says what it is goes on to speak of that:
    /// `V_C = I_0/(\omega_0 C) = Q V`.
    pub(super) fn whole_of(&self, symbol: &Symbol) -> Option<Symbol> {
        let statements = self.derivation.equations[self.at].statements();
        let mut chains = statements.iter().map(goals).filter(|chain| {
            let first = chain.first();
            first.is_some_and(|own| own.is_of(symbol))
        });
        let whole = whole(symbol)?;
        let speaks = |own: &Goal| own.formula.names().contains(&whole);
        (!chains.any(|chain| chain.iter().any(speaks))).then_some(whole)
    }

    /// A new symbol that stands alone on the left, or a power of it, and what its value is made of, unless that is a number.
    pub(super) fn defined_anew<'g>(&self, goal: &'g Goal) -> Option<(&'g Symbol, Set<Symbol>)> {
        let (new, value) = goal.formula.said_of()?;
        let named = quantities(value);
        let is_new = self.derivation.equations[self.at].introduces.contains(new);
        (is_new && !named.is_empty()).then_some((new, named))
    }

    /// A new symbol judged as what it is said to name, from such premises; also where all is positive.
    pub(super) fn judged_there(
        &self,
        goal: &Goal,
        assumed: Vec<Assumed>,
        premises: &[usize],
        asked: &Asked,
        may_fail: MayFail,
    ) -> Option<There> {
        let solved = || self.solved_for(goal, asked.quantity?, premises);
        match self.judged_anywhere(goal, (assumed.clone(), premises), asked, may_fail) {
            // What words around it say of the symbol itself may be drawn from it.
            Some(There::Shown) if asked.quantity.is_none() => return Some(There::Shown),
            Some(There::Shown) => {
                let solved = solved().or_else(|| self.solved_from(goal, assumed, premises));
                return Some(solved.unwrap_or(There::Shown));
            }
            Some(found) => return Some(found),
            None => {}
        }
        // That something may be 0 or less can be all that keeps the symbol from being anything at all. Where all is positive, too, there is a
        // counterexample or nothing is said.
        let before = assumed.len();
        let assumed = self.where_all_is_positive(goal, assumed);
        if may_fail == MayFail::Never || assumed.len() == before {
            return None;
        }
        match self.judged_anywhere(goal, (assumed, premises), asked, may_fail)? {
            There::Shown => solved(),
            found => Some(found),
        }
    }

    /// Premises, and that all symbols are positive of which nothing else is said.
    pub(super) fn where_all_is_positive(
        &self,
        goal: &Goal,
        mut assumed: Vec<Assumed>,
    ) -> Vec<Assumed> {
        let claim = self.derivation.claim(self.at, &assumed, &goal.formula);
        let is_set = |symbol: &Symbol| {
            let mut all = assumed.iter();
            all.any(|own| own.formula.set_to_number() == Some(symbol))
        };
        let mut free = unbounded(&claim);
        let positive = |symbol: &Symbol| Formula::positive(Expr::Symbol(symbol.clone()));
        let is_said = |symbol: &Symbol| {
            let positive = positive(symbol);
            assumed.iter().any(|own| *own.formula == positive)
        };
        free.retain(|symbol| symbol.name() != "\\pi" && !is_set(symbol) && !is_said(symbol));
        let positive = |symbol: Symbol| taken(&positive(&symbol));
        assumed.extend(free.into_iter().map(positive));
        assumed
    }

    /// Whether the text told something before the last display that sets a symbol.
    fn is_told_before(&self, own: &Assumed) -> bool {
        let Source::Local(page, local) = own.source else {
            return false;
        };
        let is_value = matches!(
            own.formula.as_equation(),
            Some((Expr::Symbol(_), Expr::Symbol(_) | Expr::Number(_)))
        );
        is_value
            && own.standing == Standing::AtPoint
            && !(self.derivation).is_said_since(self.at, self.derivation.local(page, local).span)
    }

    /// The same from just these premises.
    fn judged_anywhere(
        &self,
        goal: &Goal,
        (assumed, premises): (Vec<Assumed>, &[usize]),
        asked: &Asked,
        may_fail: MayFail,
    ) -> Option<There> {
        match self.decide_from(&assumed, &goal.formula)? {
            Decision::Proven { .. } => Some(There::Shown),
            Decision::Refuted(refuted) if may_fail != MayFail::Never => {
                let mut found = Found::open(Judged {
                    goal: goal.clone(),
                    assumed: assumed.clone(),
                    outcome: Outcome::Refuted(refuted.into()),
                });
                self.instead_from_these(goal, &assumed, premises, &mut found);
                let gives = found.gives(asked, may_fail);
                gives.then(|| There::Refuted(found.into()))
            }
            _ => None,
        }
    }

    /// What a new symbol may be taken from, of which the words before the step say something already; nothing where they do not, or say what
    /// the step says.
    fn said_of_itself(
        &self,
        asked: &Asked,
        cited: &[Assumed],
        words: &[Assumed],
        premises: &[usize],
    ) -> Option<(Vec<Assumed>, MayFail)> {
        let is_own =
            |own: &Assumed| is_said_in_words(own) && own.formula.names().contains(asked.new);
        let all = || cited.iter().chain(words);
        if !all().any(is_own) {
            return None;
        }
        let mut assumed: Vec<Assumed> = Vec::new();
        join(all().cloned(), &mut assumed);
        self.join_meanings(asked, premises, &mut assumed);
        Some((assumed, MayFail::InTheSameSymbols))
    }

    /// What a new symbol may be taken from that names a special value of a quantity.
    fn said_of_the_whole(
        &self,
        asked: &Asked,
        cited: Vec<Assumed>,
        mut words: Vec<Assumed>,
        premises: &[usize],
    ) -> Option<(Vec<Assumed>, MayFail)> {
        let quantity = asked.quantity?;
        if self.is_of_another_thing() {
            return None;
        }
        if self.looks_for_an_extreme() {
            words.retain(|own| !own.is_of(quantity));
        }
        let meanings = self.meanings(quantity, &cited, premises);
        let mut assumed: Vec<Assumed> = Vec::new();
        let may_fail = match meanings.is_empty() {
            false => {
                let is_place = !words.is_empty() || self.names_its_premises();
                let is_place = is_place || is_extreme(asked.new);
                let all = cited.into_iter().chain(words).chain(meanings);
                let all = all.filter(|own| !own.formula.speaks_of_slopes());
                join(all, &mut assumed);
                match is_place && is_put(&assumed, asked) {
                    true => MayFail::InTheSameSymbols,
                    false => MayFail::Never,
                }
            }
            // "Setting $dY/dE = 0$ we find $$E^* = r/2$$"
            true => {
                let mut conditions = cited.iter().chain(&words);
                if !conditions.any(is_said_in_words) {
                    return None;
                }
                join(cited.into_iter().chain(words), &mut assumed);
                MayFail::ByAnyOther
            }
        };
        self.join_meanings(asked, premises, &mut assumed);
        if !assumed
            .iter()
            .any(|own| own.formula.names().contains(quantity))
        {
            return None;
        }
        assumed.push(taken(&Formula::same(asked.new, quantity)));
        Some((assumed, may_fail))
    }

    /// Adds what stands before and says what that is of which the premises speak, `Q_m`, where $Q = Q_m$ is put in, or the step.
    fn join_meanings(&self, asked: &Asked, premises: &[usize], assumed: &mut Vec<Assumed>) {
        let names = assumed.iter().flat_map(|own| own.formula.names());
        let spoken_of: Set<Symbol> = names.chain(asked.named.iter().cloned()).collect();
        let is_asked = |own: &Symbol| own == asked.new || Some(own) == asked.quantity;
        for symbol in spoken_of.iter().filter(|own| !is_asked(own)) {
            let meanings = self.meanings(symbol, assumed, premises);
            let meanings = meanings
                .into_iter()
                .filter(|own| !own.formula.speaks_of_slopes());
            join(meanings, assumed);
        }
    }

    /// Whether a step follows that says what a new symbol is at a place, where that is said without the index of laws in force there: "At
    /// $r = a$ this gives $$v_a^2 = g a$$" after `v^2 = g r`. What does not follow may be said of something else.
    pub(in crate::audit) fn follows_at_place(
        &self,
        goal: &Goal,
        assumed: &[Assumed],
        found: &mut Found,
    ) -> bool {
        let names = goal.formula.names();
        let new = &self.derivation.equations[self.at].introduces;
        let mut new = names.iter().filter(|own| new.contains(*own));
        let (Some(new), None) = (new.next(), new.next()) else {
            return false;
        };
        let quantity = new.without_subscript().filter(|_| index(new).is_some());
        let Some(plain) = quantity else {
            return false;
        };
        // What is put in there is gone.
        let is_place = |own: &Assumed| match (own.source, own.formula.as_equation()) {
            (Source::Local(..), Some((Expr::Symbol(at), value))) => {
                !names.contains(at) && !value.mentions(at) && *at != plain
            }
            _ => false,
        };
        let places: Vec<&Assumed> = assumed.iter().filter(|own| is_place(own)).collect();
        if names.contains(&plain) || places.is_empty() {
            return false;
        }
        let of_place = |law: &Assumed| {
            let said = law.formula.names();
            let mut places = places.iter().flat_map(|own| own.formula.names());
            matches!(law.source, Source::Equation(_))
                && said.contains(&plain)
                && places.any(|own| said.contains(&own))
        };
        let put = Expr::Symbol(new.clone());
        let laws = assumed.iter().filter(|law| of_place(law));
        let said = laws.map(|law| Assumed {
            formula: law
                .formula
                .map_terms(|term| term.substitute(&plain, &put))
                .into(),
            standing: Standing::AtPoint,
            ..law.clone()
        });
        let said: Vec<Assumed> = said.collect();
        let all = || assumed.iter().cloned().chain(said.clone()).collect();
        !said.is_empty() && self.holds_under(goal, all(), &[], Effort::Light, found)
    }

    /// What the words around a step tell, name or mention: "At the free end, $x = L$".
    pub(super) fn said_of_the_place(&self, side: Side) -> Vec<Assumed> {
        let mut words = self.derivation.told(self.at);
        words.extend(self.derivation.named(self.at));
        let start = self.derivation.equations[self.at].span.start;
        let mentioned = self.derivation.mentioned(self.at).into_iter();
        // "If $a = b$, then of course $c = 2 a$. In the general case" leaves what it names.
        let is_meant = |span: Span| {
            let is_there = span.start < start || side == Side::Both && self.goes_on_to(span);
            is_there && !self.derivation.is_left(self.at, span)
        };
        let mentioned = mentioned.filter(|(span, _)| is_meant(*span));
        words.extend(mentioned.map(|(_, formula)| step(&formula)));
        // "Setting $x = 0$ and $x = L$": nobody knows which is meant where.
        let sets = |own: &Assumed| {
            let (left, right) = own.formula.as_equation()?;
            matches!(left, Expr::Symbol(_)).then(|| (left.clone(), right.clone()))
        };
        let set: Vec<(Expr, Expr)> = words.iter().filter_map(sets).collect();
        let is_both = |(of, is): (Expr, Expr)| {
            let mut others = set.iter();
            others.any(|(other, value)| *other == of && *value != is)
        };
        words.retain(|own| !sets(own).is_some_and(is_both));
        let page = self.derivation.equations[self.at].page;
        let is_unknown = |part: &Expr| match part {
            Expr::Apply(name, _) => !self.derivation.is_spoken_of(page, name),
            _ => false,
        };
        words.retain(|own| {
            own.formula.as_equation().is_some() && !any_part(&own.formula, &is_unknown)
        });
        words
    }

    /// Whether the sentence before a step begins to speak of something: "A Carnot engine between them has $$E_C = 1 - a/b$$" gives no value of
    /// the `E` that stands before.
    fn is_of_another_thing(&self) -> bool {
        let said = self.derivation.leading(self.at).unwrap_or_default();
        let mut words = said.split_whitespace();
        let begins = matches!(words.next(), Some("A" | "An"));
        begins && matches!(words.next_back(), Some("has" | "has:"))
    }

    /// Whether the sentence before a step looks for the place itself: "Minimising the radicand in (5) locates the resonance".
    fn looks_for_an_extreme(&self) -> bool {
        const LOOKS: [&str; 8] = [
            "minimising",
            "minimizing",
            "maximising",
            "maximizing",
            "minimise",
            "minimize",
            "maximise",
            "maximize",
        ];
        let words = self.derivation.leading_words(self.at);
        words.iter().any(|word| LOOKS.contains(&word.as_str()))
    }

    /// Whether the sentence that a display is part of goes on to something behind it.
    fn goes_on_to(&self, said: Span) -> bool {
        let own = &self.derivation.equations[self.at];
        let source = &self.derivation.pages[own.page].document.source;
        let written = source.get(own.body.range()).unwrap_or_default();
        let written = written.split("\\tag").next().unwrap_or_default();
        let written = written.split("\\label").next().unwrap_or_default();
        let between = source.get(own.body.end..said.start).unwrap_or_default();
        !written.trim_end().ends_with('.') && !between.contains(". ") && !between.contains(".\n")
    }

    /// What says by a term what a quantity is, in what is cited and else in what stands before, the whole chain.
    fn meanings(&self, quantity: &Symbol, cited: &[Assumed], premises: &[usize]) -> Vec<Assumed> {
        let says = |own: &&Assumed| {
            let sides = own.formula.as_equation();
            let (Some((Expr::Symbol(left), right)), Source::Equation(_)) = (sides, own.source)
            else {
                return false;
            };
            left == quantity && !right.mentions(quantity)
        };
        let [others, _] = self.others(premises);
        let all = || cited.iter().chain(others);
        let mut chains: Vec<Source> = all().filter(says).map(|own| own.source).collect();
        chains.truncate(MOST_MEANINGS);
        let of_chains = all().filter(|own| chains.contains(&own.source));
        of_chains.cloned().collect()
    }
}

/// What is asked of a new symbol.
pub(super) struct Asked<'a> {
    pub new: &'a Symbol,
    /// What its value is said to be made of.
    pub named: &'a Set<Symbol>,
    /// What it may name a special value of.
    pub quantity: Option<&'a Symbol>,
}

/// Where words stand that are looked at.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Side {
    Before,
    /// Also behind the step: "that is, $E = r/2$".
    Both,
}

/// When what would define a symbol is told to be wrong.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum MayFail {
    Never,
    /// Where something else follows that is made of the same symbols.
    InTheSameSymbols,
    /// Where something else follows, whatever it is made of but the quantity itself: the words say all that it is taken from.
    ByAnyOther,
}

impl Found {
    /// Whether something follows in the place of what was refuted.
    fn gives(&self, asked: &Asked, may_fail: MayFail) -> bool {
        let is_meant = |formula: &Formula| match formula.as_equation() {
            Some((_, value)) if may_fail == MayFail::ByAnyOther => {
                let own = quantities(value);
                !own.contains(asked.new) && asked.quantity.is_none_or(|q| !own.contains(q))
            }
            Some((_, value)) => quantities(value) == *asked.named,
            None => false,
        };
        let implied = self.implied.as_ref().map(|own| &own.proven);
        let mended = self.mended.as_ref().filter(|own| own.under.is_empty());
        let mended = mended.map(|own| &own.proven);
        let mut instead = implied.into_iter().chain(mended);
        instead.any(|own| is_meant(&own.claim().goal))
    }
}

/// Whether no display, but the text says that two things are equal.
fn is_said_in_words(own: &Assumed) -> bool {
    !matches!(own.source, Source::Equation(_)) && own.formula.as_equation().is_some()
}

/// Adds hypotheses, or what they come from, that are not there yet.
pub(super) fn join<T: PartialEq>(more: impl Iterator<Item = T>, all: &mut Vec<T>) {
    for own in more {
        if !all.contains(&own) {
            all.push(own);
        }
    }
}

/// Whether something is gone from all that says what a quantity is: something that has a value at the place.
fn is_put(assumed: &[Assumed], asked: &Asked) -> bool {
    let says = |own: &&Assumed| match own.formula.as_equation() {
        Some((Expr::Symbol(left), _)) => {
            Some(left) == asked.quantity && matches!(own.source, Source::Equation(_))
        }
        _ => false,
    };
    assumed.iter().filter(says).all(|own| {
        let spoken_of = own.formula.names();
        let mut rest = spoken_of.iter().filter(|own| Some(*own) != asked.quantity);
        rest.any(|own| !asked.named.contains(own))
    })
}

/// What a symbol may name a special value of: `P` of `P_{\max}`, `E` of `E^*`.
pub(super) fn whole(symbol: &Symbol) -> Option<Symbol> {
    let starred = symbol.name().strip_suffix("^*");
    (symbol.without_subscript()).or_else(|| starred.map(Symbol::new))
}

fn is_extreme(symbol: &Symbol) -> bool {
    let index = split_subscript(symbol.name()).map(|(_, index)| index);
    index.is_some_and(|index| EXTREMES.contains(&index))
}
