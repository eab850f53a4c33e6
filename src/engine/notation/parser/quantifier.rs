//! Of what a statement is said: `x^2 \geq 0 \quad \text{for all } x`, `\forall n \in \mathbb{N}`, `\text{for every } x > 1`.
//!
//! A statement about symbols is meant for all their values anyway, so a quantifier says no more than its bounds: these are
//! conditions of the statement, and whole numbers are as in `n = 1, 2, \dots`. What it quantifies over and is not understood
//! here is refused, for it might be a bound, too.

use super::statement::Place;
use super::{Kind, Parser, Read, refuse, refuse_with};
use crate::algebra::{BigRational, Expr, Relation, Symbol};
use crate::document::Span;
use crate::notation::{Clause, Link, Run, Side};

/// Words that quantify, after "for".
const ALL: &[&str] = &["all", "every", "each", "any", "arbitrary"];
/// Words beside them that bound nothing.
const UNBOUNDED: &[&str] = &[
    "real", "reals", "number", "numbers", "value", "values", "of", "the", "possible", "time",
    "times", "angle", "angles",
];
/// Words between names or conditions of one quantifier.
const JOINING: &[&str] = &["and", "with", "such that", "satisfying"];
/// Words between a quantifier and what is said after it.
const LEADING_ON: &[&str] = &["", "we have", "it holds that", "there holds"];

const HELP: &str = "write a bound, as `x > 0`, or `\\in` with `\\mathbb{R}`, `\\mathbb{N}`, `\\mathbb{Z}` or an interval";

/// What the words of a quantifier say of what they stand before: "for all positive integers".
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(super) struct Kinds {
    sign: Option<Relation>,
    whole: bool,
    /// Of whole numbers, those from 1 on.
    natural: bool,
}

/// What words quantify over, if they do; the word that is not understood, where there is one.
pub(super) fn quantified(words: &str) -> Option<Result<Kinds, &str>> {
    let blank = |c: char| c.is_whitespace() || c == '~';
    let mut words = words.split(blank).filter(|word| !word.is_empty());
    if !words.next()?.eq_ignore_ascii_case("for") {
        return None;
    }
    let (mut kinds, mut plainly) = (Kinds::default(), true);
    for word in words {
        let first = std::mem::take(&mut plainly);
        let own = word.trim_end_matches([',', ':']);
        match own {
            _ if ALL.contains(&own) => {}
            _ if UNBOUNDED.contains(&own) => {}
            "positive" => kinds.sign = Some(Relation::Greater),
            "negative" => kinds.sign = Some(Relation::Less),
            "nonnegative" | "non-negative" => kinds.sign = Some(Relation::GreaterOrEqual),
            "nonzero" | "non-zero" | "nonvanishing" | "non-vanishing" => {
                kinds.sign = Some(Relation::NotEqual);
            }
            "integer" | "integers" | "whole" => kinds.whole = true,
            "natural" | "naturals" => (kinds.whole, kinds.natural) = (true, true),
            // "for small x" quantifies over nothing: the condition is looked for elsewhere.
            _ if first => return None,
            _ => return Some(Err(own)),
        }
    }
    // A mere "for" stands before a condition.
    (!plainly).then_some(Ok(kinds))
}

impl Parser<'_> {
    /// Whether a quantifier begins here.
    pub(super) fn quantifies(&self) -> bool {
        match self.peek() {
            Kind::Command("forall") => true,
            Kind::Text(words) => quantified(words).is_some(),
            _ => false,
        }
    }

    /// `\forall x > 0:` before a statement.
    pub(super) fn leading_quantifier(&mut self, under: &mut Vec<Clause>) -> Read<()> {
        if !self.quantifies() {
            return Ok(());
        }
        self.quantifier(under)?;
        let led_on = match self.peek() {
            Kind::Char(':' | ',' | ';') | Kind::Command("colon") => {
                self.advance();
                true
            }
            Kind::Wide => true,
            Kind::Text(words) => LEADING_ON.contains(&words.trim()),
            _ => false,
        };
        self.skip_wide();
        match self.peek() {
            Kind::Text(words) if LEADING_ON.contains(&words.trim()) => self.advance(),
            _ if led_on => {}
            _ => return self.unexpected(),
        }
        self.skip_wide();
        Ok(())
    }

    /// Takes a quantifier, and adds the conditions that it states.
    pub(super) fn quantifier(&mut self, under: &mut Vec<Clause>) -> Read<()> {
        let kinds = match self.peek() {
            Kind::Text(words) => match quantified(words) {
                Some(Err(word)) => {
                    let message = format!("what is quantified over is not understood: `{word}`");
                    return refuse_with(self.span(), message, HELP);
                }
                Some(Ok(kinds)) => kinds,
                None => return self.unexpected(),
            },
            _ => Kinds::default(),
        };
        self.advance();
        loop {
            self.skip_wide();
            self.quantified_names(&kinds, under)?;
            self.few_conditions(under)?;
            let end = self.at;
            self.skip_wide();
            match self.peek() {
                Kind::Text(words) if JOINING.contains(&words.trim()) => self.advance(),
                _ => {
                    self.at = end;
                    return Ok(());
                }
            }
        }
    }

    /// `x`, `x, y`, `x > 0`, `0 < x < 1`, `x, y \in \mathbb{R}`, `n = 1, 2, \dots`
    fn quantified_names(&mut self, kinds: &Kinds, under: &mut Vec<Clause>) -> Read<()> {
        let start = self.at;
        if let Some(run) = self.run()
            && self.ends_aside(false)
        {
            self.quantified.insert(run.symbol.clone());
            self.runs.push(run);
            return Ok(());
        }
        self.at = start;
        let mut names: Vec<(Symbol, Side)> = Vec::new();
        loop {
            let at = self.at;
            if matches!(self.peek(), Kind::End | Kind::Row | Kind::Char(_)) {
                return refuse_with(self.span(), "what is quantified over is not named", HELP);
            }
            let place = self.place()?;
            if let Kind::Relation(..) = self.peek() {
                self.at = at;
                let clause = self.clause()?;
                return self.bounded_names(names, clause, at, kinds, under);
            }
            let side = match place {
                Place::Side(side) => side,
                _ => return refuse_with(self.since(at), "this is not quantified over", HELP),
            };
            let Expr::Symbol(symbol) = &side.expr else {
                let message = "what is quantified over is not a symbol";
                return refuse_with(side.span, message, HELP);
            };
            names.push((symbol.clone(), side));
            // `x, y`, but not `x, \quad y = 2`.
            if self.peek() == Kind::Char(',') && self.starts_name(self.at + 1) {
                self.advance();
                continue;
            }
            break;
        }
        for (name, side) in &names {
            self.of_kind(kinds, name, side, under);
        }
        match self.accept(Kind::Command("in")) {
            true => self.elements(&names, under),
            false => Ok(()),
        }
    }

    /// What a bound says of the name in it, and of those before it: `x, y > 0`.
    fn bounded_names(
        &mut self,
        before: Vec<(Symbol, Side)>,
        clause: Clause,
        start: usize,
        kinds: &Kinds,
        under: &mut Vec<Clause>,
    ) -> Read<()> {
        let span = self.since(start);
        let Clause::Chain { sides, links } = &clause else {
            return refuse(span, "this is not read as a condition");
        };
        let equal = |link: &Link| link.questioned || link.relation == Relation::Equal;
        if links.iter().any(|link| link.questioned)
            || !before.is_empty() && links.iter().any(equal)
            || !self.cases.is_empty()
        {
            return refuse(span, "this is not read as a condition");
        }
        let named = |side: &Side| match &side.expr {
            Expr::Symbol(symbol) => Some((symbol.clone(), side.clone())),
            _ => None,
        };
        match sides.iter().find_map(named) {
            Some((name, side)) => {
                for (other, beside) in before {
                    let replaced = |own: &Side| match own.expr == side.expr {
                        true => beside.clone(),
                        false => own.clone(),
                    };
                    let (sides, links) = (sides.iter().map(replaced).collect(), links.clone());
                    under.push(Clause::Chain { sides, links });
                    self.of_kind(kinds, &other, &beside, under);
                }
                self.of_kind(kinds, &name, &side, under);
            }
            None if before.is_empty() && *kinds == Kinds::default() => {}
            None => return refuse_with(span, "what is quantified over is not a symbol", HELP),
        }
        under.push(clause);
        Ok(())
    }

    /// What the words of a quantifier say of a name.
    fn of_kind(&mut self, kinds: &Kinds, name: &Symbol, side: &Side, under: &mut Vec<Clause>) {
        self.quantified.insert(name.clone());
        if kinds.whole {
            let from = match kinds.sign {
                _ if kinds.natural => Some(1),
                Some(Relation::Greater) => Some(1),
                Some(Relation::GreaterOrEqual) => Some(0),
                _ => None,
            };
            let symbol = name.clone();
            let to = None;
            self.runs.push(Run { symbol, from, to });
        }
        if let Some(sign) = kinds.sign {
            let zero = Expr::Number(BigRational::from_integer(0.into()));
            under.push(relation(side, sign, zero, side.span));
        }
    }

    /// What `\in …` says of names.
    fn elements(&mut self, names: &[(Symbol, Side)], under: &mut Vec<Clause>) -> Read<()> {
        let start = self.at;
        if let Some(from) = self.whole_numbers() {
            let runs = names.iter().map(|(name, _)| Run {
                symbol: name.clone(),
                from,
                to: None,
            });
            self.runs.extend(runs);
            return Ok(());
        }
        self.at = start;
        let bounds = match self.peek() {
            Kind::Command("mathbb") => self.real_numbers()?,
            Kind::Char('[' | '(' | ']') => self.interval()?,
            _ => return self.no_set(start),
        };
        for (_, side) in names {
            for (sign, end, span) in &bounds {
                under.push(relation(side, *sign, end.clone(), *span));
            }
        }
        Ok(())
    }

    fn no_set<T>(&self, start: usize) -> Read<T> {
        let end = self.tokens.get(start).map_or(self.body, |token| token.span);
        refuse_with(end, "what is quantified over is not understood", HELP)
    }

    /// `\mathbb{R}`, `\mathbb{R}_{>0}`. Whether 0 is in `\mathbb{R}_+` nobody knows.
    fn real_numbers(&mut self) -> Read<Vec<(Relation, Expr, Span)>> {
        let start = self.at;
        self.advance();
        let braced = self.accept(Kind::Open);
        if !self.accept(Kind::Letter('R')) || braced && !self.accept(Kind::Close) {
            return self.no_set(start);
        }
        match self.peek() {
            Kind::Char('_') => {
                self.advance();
                let open = self.accept(Kind::Open);
                let Kind::Relation(sign, false) = self.peek() else {
                    return self.no_set(start);
                };
                self.advance();
                let zero = self.accept(Kind::Number("0"));
                if !(open && zero && self.accept(Kind::Close)) {
                    return self.no_set(start);
                }
                let zero = Expr::Number(BigRational::from_integer(0.into()));
                Ok(vec![(sign, zero, self.since(start))])
            }
            Kind::Char('^' | '\\') | Kind::Command("setminus" | "backslash") => self.no_set(start),
            _ => Ok(Vec::new()),
        }
    }

    /// `[0, 1]`, `(0, 2 a]`, `]0, \infty[`
    fn interval(&mut self) -> Read<Vec<(Relation, Expr, Span)>> {
        let start = self.at;
        let least = match self.peek() {
            Kind::Char('[') => Relation::GreaterOrEqual,
            _ => Relation::Greater,
        };
        self.advance();
        let low = self.end_of_interval()?;
        if !self.accept(Kind::Char(',')) && !self.accept(Kind::Char(';')) {
            return self.no_set(start);
        }
        let high = self.end_of_interval()?;
        let most = match self.peek() {
            Kind::Char(']') => Relation::LessOrEqual,
            Kind::Char(')' | '[') => Relation::Less,
            _ => return self.no_set(start),
        };
        self.advance();
        let span = self.since(start);
        let low = low.map(|low| (least, low, span));
        let high = high.map(|high| (most, high, span));
        Ok(low.into_iter().chain(high).collect())
    }

    /// One end; nothing where it is infinite.
    fn end_of_interval(&mut self) -> Read<Option<Expr>> {
        let signed = usize::from(matches!(self.peek(), Kind::Char('+' | '-')));
        if self.kind(self.at + signed) == Kind::Command("infty") {
            self.at += signed + 1;
            return Ok(None);
        }
        Ok(Some(self.inside(false, Self::sum)?.expr))
    }
}

/// A side compared with a term that stands for itself.
fn relation(side: &Side, relation: Relation, right: Expr, span: Span) -> Clause {
    let right = Side {
        expr: right,
        span,
        terms: vec![span],
        rounding: None,
        truncated: false,
    };
    let link = Link {
        relation,
        questioned: false,
        span,
    };
    Clause::Chain {
        sides: vec![side.clone(), right],
        links: vec![link],
    }
}
