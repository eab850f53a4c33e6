//! Laws for particular things: `P = \sigma A T^4` says `P_1 = \sigma A T_1^4` as well, where a step speaks of `P_1` and `T_1`.
//!
//! Who compares two cases gives an index to what differs between them, and to nothing else. A law that speaks of one of the indexed
//! symbols itself, `v = v_0 + a t`, is none for that index; nor is one of which a single symbol has the index. A law with an index that runs,
//! `T_i = 2 \pi \sqrt{h_i/g}`, is one for each number.

use num_traits::Zero;

use crate::algebra::{BigRational, Expr, Formula, Symbol, split_subscript};
use crate::derivation::{Assumed, Goal, Source, formulas};
use crate::kernel::Standing;
use crate::sorted::{Map, Set};

use super::Verdict;
use super::judge::{Found, Judge, taken};

/// So many symbols of a law have the index where it is meant for that.
const LEAST_INDEXED: usize = 2;
/// So many displays before are looked at for what a symbol depends on.
const MOST_BEFORE: usize = 64;
/// Words for what goes neither up nor down, and the names of heights.
const LEVEL: [&str; 4] = ["horizontal", "same height", "same level", "equal height"];
/// So many displays before may say it.
const MOST_LEVEL: usize = 3;
const HEIGHTS: [&str; 3] = ["h", "y", "z"];
/// How names write a prime.
const PRIME: &str = "'";
/// So many equations of the display before are laws for particular things where something else is cited.
const MOST_JUST_BEFORE: usize = 8;
/// A step compares few things.
const MOST_INDICES: usize = 4;

impl Judge<'_> {
    /// What equations say of the particular things that a step speaks of; nothing where it speaks of something that none of them does:
    /// that may be what differs as well.
    pub(super) fn instances(&self, goal: &Goal, assumed: &[Assumed]) -> Vec<Assumed> {
        let names = goal.formula.names();
        let said = |own: &&Assumed| matches!(own.source, Source::Equation(_));
        let told = assumed.iter().filter(|own| !said(own));
        let mut spoken = names.clone();
        spoken.extend(told.flat_map(|own| own.formula.names()));
        if !spoken.iter().any(|own| tells_apart(own).is_some()) {
            return Vec::new();
        }
        // "so that $f = v/\lambda$" tells a law, "$n = 2$" a value.
        let mut told = self.derivation.told(self.at);
        told.retain(|own| own.formula.names().len() > LEAST_INDEXED);
        let laws = || assumed.iter().filter(said).chain(&told);
        let has_law = |symbol: &Symbol| {
            let mut terms = laws().flat_map(|own| own.formula.terms());
            terms.any(|term| term.mentions(symbol))
        };
        // Of what has an equation of its own nothing is said by another.
        // A letter that runs is none of a thing, unless it is a number that laws speak of: `\lambda_n = 2 L/n`.
        let is_number = |index: &str| {
            let own = Symbol::new(index.trim_start_matches('_'));
            spoken.contains(&own) || has_law(&own)
        };
        let is_meant = |own: &Symbol| is_of_thing(own) || tells_apart(own).is_some_and(is_number);
        let indexed = spoken.iter().filter(|own| is_meant(own));
        let indexed = indexed.filter_map(|own| Some((own, tells_apart(own)?)));
        let new = indexed.filter(|(own, _)| !has_law(own));
        let indices: Set<&str> = new.map(|(_, index)| index).collect();
        if indices.is_empty() || indices.len() > MOST_INDICES {
            return Vec::new();
        }
        // Where there are slopes a prime may be one.
        let slopes = assumed.iter().any(|own| own.formula.speaks_of_slopes());
        // `\omega = \sqrt{\omega_0^2 - \beta^2}`: there the index tells two quantities of one thing apart, as a prime does not.
        let is_of_one_thing = |index: &str| {
            laws().any(|law| {
                let names = law.formula.names();
                let mut both = names.iter().filter_map(|own| with_index(own, index));
                both.any(|own| names.contains(&own))
            })
        };
        let indices: Set<&str> = (indices.into_iter())
            .filter(|&index| index == PRIME || !is_of_one_thing(index))
            .collect();
        let instance = |(law, least), index| match index {
            PRIME if slopes || goal.formula.speaks_of_slopes() => None,
            index => self.instance(law, index, least, &spoken, &has_law),
        };
        // Where slopes vanish the place has a name, `V_c`, and nothing else needs one.
        let stationary = self.where_slopes_vanish(assumed);
        let before = self.just_before_what_is_cited(assumed);
        let meant = laws().chain(&before).map(|law| (law, LEAST_INDEXED));
        let meant = meant.chain(stationary.iter().map(|law| (law, 1)));
        let all =
            meant.flat_map(|law| indices.iter().filter_map(move |index| instance(law, index)));
        let all: Vec<Assumed> = all.collect();
        let of_instances: Set<Symbol> = all.iter().flat_map(|own| own.formula.names()).collect();
        let mut names = names.iter();
        match names.all(|own| of_instances.contains(own) || has_law(own)) {
            true => all,
            false => Vec::new(),
        }
    }

    /// What stands just before a step that cites something else: "Using (4) to eliminate $q$ from the difference $H_1 - H_2$" after a law for
    /// `H`.
    fn just_before_what_is_cited(&self, assumed: &[Assumed]) -> Vec<Assumed> {
        let before = self.derivation.display_before(self.at).rev();
        let before: Vec<usize> = before.take(MOST_JUST_BEFORE).collect();
        let is_cited = |own: &Assumed| match own.source {
            Source::Equation(at) => before.contains(&at),
            _ => false,
        };
        let is_said = |own: &Assumed| matches!(own.source, Source::Equation(_));
        if before.is_empty() || assumed.iter().any(is_cited) || !assumed.iter().any(is_said) {
            return Vec::new();
        }
        let is_law = |own: &Assumed| {
            matches!(own.source, Source::Equation(_))
                && own.formula.as_equation().is_some()
                && !own.formula.speaks_of_slopes()
        };
        let mut said = self.gathered(&before);
        said.retain(is_law);
        said
    }

    /// Whether a goal speaks of the place at which slopes are said to vanish, and nothing usable says what they are.
    pub(super) fn is_of_unknown_place(&self, goal: &Goal, assumed: &[Assumed]) -> bool {
        let names = goal.formula.names();
        names.iter().any(|own| index(own).is_some())
            && assumed.iter().any(|own| vanishing_slope(own).is_some())
            && self.where_slopes_vanish(assumed).is_empty()
    }

    /// What is 0 where slopes are said to vanish of which equations say what they are: "Setting (3) and (4) to zero".
    fn where_slopes_vanish(&self, assumed: &[Assumed]) -> Vec<Assumed> {
        let vanishing = assumed.iter().filter_map(vanishing_slope);
        let page = self.derivation.equations[self.at].page;
        let before = self.derivation.equations_of(page).start..self.at;
        let is_said = |own: &Formula, slope: &Expr| match own.as_equation() {
            Some((left, term)) if left == slope => Some(term.clone()),
            _ => None,
        };
        let law_of = |slope: &Expr| {
            let mut before = before.clone().rev().take(MOST_BEFORE);
            let at_fault = |at: usize| {
                let mut entries = self.auditor.entries_of(self.at, at);
                entries.any(|entry| entry.verdict == Verdict::Fails)
            };
            before.find_map(|at| {
                let mut said = self.derivation.equations[at]
                    .statements()
                    .iter()
                    .flat_map(formulas);
                let term = said.find_map(|own| is_said(&own, slope))?;
                (!at_fault(at)).then(|| Assumed {
                    source: Source::Equation(at),
                    standing: Standing::AtPoint,
                    ..taken(&Formula::equal(term, Expr::integer(0)))
                })
            })
        };
        // One alone says less than is meant.
        vanishing
            .map(law_of)
            .collect::<Option<_>>()
            .unwrap_or_default()
    }

    /// A law for the thing with an index, where at `least` so much is `spoken` of that has the index.
    fn instance(
        &self,
        law: &Assumed,
        index: &str,
        least: usize,
        spoken: &Set<Symbol>,
        has_law: &impl Fn(&Symbol) -> bool,
    ) -> Option<Assumed> {
        law.formula.as_equation()?;
        let page = self.derivation.equations[self.at].page;
        let names = law.formula.names();
        // What ties elements to one another, `c_{n+1} = -c_n`, is said of all of them.
        let ties = names.iter().any(|name| {
            let below = split_subscript(name.name()).map(|(_, below)| below);
            below.is_some_and(|own| own.starts_with(|c| ('i'..='n').contains(&c)) && own.len() > 1)
        });
        let indexed = |name: &Symbol| {
            let is_plain = split_subscript(name.name()).is_none();
            let own = with_index(name, index)?;
            if !is_plain && (ties || !self.reaches(page, name, index)) {
                return None;
            }
            let exists = spoken.contains(&own) || self.derivation.is_spoken_of(page, &own);
            exists.then(|| (name.clone(), own))
        };
        let mut put: Map<Symbol, Symbol> = names.iter().filter_map(indexed).collect();
        // "In a horizontal pipe": the height is the same at both places.
        let is_height =
            |name: &Symbol, own: &Symbol| HEIGHTS.contains(&name.name()) && !spoken.contains(own);
        if put.iter().any(|(name, own)| is_height(name, own)) && self.is_level() {
            put.retain(|name, own| !is_height(name, own));
        }
        let here = put
            .values()
            .filter(|own| spoken.contains(*own) || has_law(own));
        let here = here.count();
        // What has equations of its own needs no law that is told: `v_1 = \sqrt{\mu/r_1}`.
        let is_known = matches!(law.source, Source::Local(..))
            && put
                .values()
                .all(|own| self.derivation.is_spoken_of_before(self.at, own));
        if here < least || is_known || put.values().any(|own| names.contains(own)) {
            return None;
        }
        // What keeps its name and depends on what differs is another one for each thing: `S_V` of `S_V/R^2 = 4 k T/R`, or the change that
        // `\Delta G^\circ = -R T \ln K` is of.
        let keeps = |own: &&Symbol| !put.contains_key(*own);
        let gives = |own: &Symbol| matches!(law.formula.as_equation(), Some((Expr::Symbol(of), _)) if of == own);
        let is_change = |own: &Symbol| own.name().starts_with("\\Delta") && gives(own);
        let is_another = |own: &Symbol| {
            split_subscript(own.name()).is_some() && self.depends_on(own, &put) || is_change(own)
        };
        if names.iter().filter(keeps).any(is_another) {
            return None;
        }
        let formula = law.formula.map_terms(|term| {
            put.iter().fold(term.clone(), |term, (name, own)| {
                term.substitute(name, &Expr::Symbol(own.clone()))
            })
        });
        Some(Assumed {
            formula: formula.into(),
            ..law.clone()
        })
    }

    /// Whether the text before says that something goes neither up nor down.
    fn is_level(&self) -> bool {
        let page = self
            .derivation
            .equations_of(self.derivation.equations[self.at].page);
        let displays = page.start..=self.at;
        displays.rev().take(MOST_LEVEL).any(|at| {
            let text = self.derivation.text_before(at);
            LEVEL.iter().any(|own| text.contains(own))
        })
    }

    /// Whether a display before gives a symbol by one of these.
    fn depends_on(&self, symbol: &Symbol, others: &Map<Symbol, Symbol>) -> bool {
        let page = self.derivation.equations[self.at].page;
        let before = self.derivation.equations_of(page).start..self.at;
        let before = before.rev().take(MOST_BEFORE);
        let statements = before.flat_map(|at| self.derivation.equations[at].statements());
        let mut said = statements.flat_map(formulas);
        said.any(|own| match own.as_equation() {
            Some((Expr::Symbol(of), term)) => {
                of == symbol && others.keys().any(|other| term.mentions(other))
            }
            _ => false,
        })
    }

    /// Whether an index that runs comes to another one: within its bounds, and in no sequence, of which each element is said by itself.
    fn reaches(&self, page: usize, name: &Symbol, index: &str) -> bool {
        let Some((_, own)) = split_subscript(name.name()) else {
            return false;
        };
        let own = Symbol::new(own);
        let mut sequences = self.derivation.running(page).iter();
        let domain = self.derivation.pages[page].domains.get(&own);
        let is_within = domain.is_none_or(|domain| {
            let number = index.trim_start_matches('_').parse::<i64>();
            number.is_ok_and(|own| domain.contains(&BigRational::from_integer(own.into())))
        });
        is_within && !sequences.any(|running| running.index == own)
    }

    /// Whether a step is about particular things of which laws say something.
    pub(super) fn is_of_instances(&self, goal: &Goal) -> bool {
        !self.instances(goal, &self.usable.assumed).is_empty()
    }

    /// What would define something new by its first link, where a law for particular things says what that is. Who writes a ratio of two
    /// new symbols, or draws the step, means the law; what speaks of more than the law does may define something else, `p_1 = m v_1 + M w`.
    pub(super) fn as_instance(&self, goal: &Goal, premises: &[usize]) -> Option<Found> {
        if !self.is_of_instances(goal) {
            return None;
        }
        let (left, _) = goal.formula.as_equation()?;
        let found = self.goal(goal, &[], premises);
        let is_drawn = self.derivation.equations[self.at].drawn;
        let outcome = &found.judged.outcome;
        let is_meant = is_drawn || !matches!(left, Expr::Symbol(_));
        (outcome.is_proven() || is_meant && outcome.is_refuted()).then_some(found)
    }
}

/// The slope that is said to be 0.
fn vanishing_slope(own: &Assumed) -> Option<&Expr> {
    match own.formula.as_equation()? {
        (slope @ (Expr::Derivative { .. } | Expr::Partial { .. }), Expr::Number(nought)) => {
            nought.is_zero().then_some(slope)
        }
        _ => None,
    }
}

/// The index of a symbol as it is written, `_1`, if it tells things apart and does not run.
pub(super) fn index(symbol: &Symbol) -> Option<&str> {
    let (stem, index) = split_subscript(symbol.name())?;
    let runs = runs(index);
    symbol.name().get(stem.len()..).filter(|_| !runs)
}

/// The states that names have a symbol in, `1` and `2` of `T_1` and `T_2` for `T`, with these names.
pub(super) fn states<'n>(of: &Symbol, names: &'n Set<Symbol>) -> Vec<(&'n str, &'n Symbol)> {
    let states = names.iter().filter_map(|name| {
        let (stem, state) = split_subscript(name.name())?;
        (stem == of.name()).then_some((state, name))
    });
    let mut states: Vec<(&str, &Symbol)> = states.collect();
    states.sort_unstable();
    states
}

/// Whether it has an index that does not run, or a prime.
fn is_of_thing(symbol: &Symbol) -> bool {
    index(symbol).is_some() || tells_apart(symbol) == Some(PRIME)
}

/// What tells a symbol from others of its kind: an index, be it a number that runs, or a prime.
fn tells_apart(symbol: &Symbol) -> Option<&str> {
    let name = symbol.name();
    match split_subscript(name) {
        Some((stem, _)) => name.get(stem.len()..),
        None => name.ends_with('\'').then_some(PRIME),
    }
}

/// A symbol that has no index yet, or one that runs, with one.
fn with_index(symbol: &Symbol, index: &str) -> Option<Symbol> {
    match split_subscript(symbol.name()) {
        None => Some(Symbol::new(format!("{symbol}{index}"))),
        Some((stem, own)) if runs(own) && index.strip_prefix('_').is_some_and(|new| !runs(new)) => {
            Some(Symbol::new(format!("{stem}{index}")))
        }
        Some(_) => None,
    }
}

/// Whether an index is a letter that runs: `i` of `T_i`.
fn runs(index: &str) -> bool {
    index.len() == 1 && index.bytes().all(|byte| (b'i'..=b'n').contains(&byte))
}
