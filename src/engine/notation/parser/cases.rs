//! What is said under conditions: the cases of a side, `f = \begin{cases} a & x < 0 \\ b & x \geq 0 \end{cases}`, and
//! `a = b \quad \text{if } x > 0`.
//!
//! Each case is a statement of its own, under its condition. `\text{otherwise}` is where none of the conditions before it
//! holds, and is read where each of these is a single relation.

use super::both::refuse_signs;
use super::statement::Place;
use super::{Case, Kind, Parser, Read, refuse, refuse_with};
use crate::algebra::Relation;
use crate::document::Span;
use crate::notation::{Clause, Link, Side, Statement};

/// Words before a condition.
const WORDS: &[&str] = &["if", "for", "when", "whenever", "where", "as long as"];
/// The same after a statement, where "where" says something else.
const TRAILING: &[&str] = &[
    "if",
    "for",
    "when",
    "whenever",
    "provided",
    "provided that",
    "as long as",
];
/// After these a relation that is no equation is a condition: "where $A \neq 0$". An equation says what something means.
const BESIDE: &[&str] = &["where", "with"];
/// Nobody states more conditions of one statement; each is a hypothesis, with which all others are tried.
const MOST_CONDITIONS: usize = 64;
/// Words for where none of the other cases holds.
const OTHERWISE: &[&str] = &["otherwise", "else", "elsewhere"];

impl Parser<'_> {
    /// The cases of the side that begins here, kept for [`Parser::by_cases`]; the sides and links before it.
    pub(super) fn before_cases(&mut self, places: Vec<Place>, links: Vec<Link>) -> Read<Clause> {
        let mut sides = Vec::new();
        for place in places {
            match place {
                Place::Side(side) => sides.push(side),
                Place::Dots(span) => return refuse(span, "dots are not read before cases"),
                Place::Either { sign, .. } => return refuse_signs(sign),
            }
        }
        if !self.cases.is_empty() {
            return refuse(self.span(), "one statement has cases only once");
        }
        self.cases = self.nested(Self::all_cases)?;
        Ok(Clause::Chain { sides, links })
    }

    fn all_cases(&mut self) -> Read<Vec<Case>> {
        let begun = self.span();
        let Kind::Begin(name) = self.peek() else {
            return self.unexpected();
        };
        self.advance();
        let mut cases: Vec<Case> = Vec::new();
        loop {
            self.skip_wide();
            match self.peek() {
                Kind::Row => self.advance(),
                Kind::Finish(end) if end == name && !cases.is_empty() => break,
                Kind::End => {
                    return refuse(begun, format!("the environment `{name}` is never ended"));
                }
                _ => {
                    let case = self.case(&cases)?;
                    cases.push(case);
                    if !matches!(self.peek(), Kind::Row | Kind::Finish(_) | Kind::End) {
                        return self.unexpected();
                    }
                }
            }
        }
        self.advance();
        Ok(cases)
    }

    fn case(&mut self, before: &[Case]) -> Read<Case> {
        let start = self.at;
        let side = match self.place()? {
            Place::Side(side) => side,
            Place::Dots(span) => return refuse(span, "dots are not read in a case"),
            Place::Either { sign, .. } => return refuse_signs(sign),
        };
        let end = self.at;
        self.accept(Kind::Char(','));
        while self.skip_wide() || self.accept(Kind::Cell) {}
        let mut under = Vec::new();
        match self.peek() {
            Kind::Text(words) if OTHERWISE.contains(&plain(words)) => {
                let span = self.span();
                self.advance();
                under = none_of(before, span)?;
            }
            _ if self.quantifies() => self.quantifier(&mut under)?,
            Kind::Text(words) if WORDS.contains(&plain(words)) => {
                self.advance();
                self.conditions(&mut under)?;
            }
            Kind::Row | Kind::Finish(_) => {
                return refuse_with(
                    side.span,
                    "when this case applies is not said",
                    "write `a & x < 0`, or `a & \\text{otherwise}`",
                );
            }
            _ if self.at > end => self.conditions(&mut under)?,
            _ => return self.unexpected(),
        }
        if matches!(self.peek(), Kind::Char(',' | ';' | '.')) {
            self.advance();
        }
        let span = self.since(start);
        self.skip_wide();
        Ok(Case { side, under, span })
    }

    /// `x > 0`, `0 < x < 1`, `x > 0 \text{ and } y > 0`
    fn conditions(&mut self, under: &mut Vec<Clause>) -> Read<()> {
        loop {
            let start = self.at;
            let names = self.shared_names();
            let clause = self.clause()?;
            under.extend(self.share(&names, &clause)?);
            let plain = match &clause {
                Clause::Chain { links, .. } => links.iter().all(|link| !link.questioned),
                Clause::AllEqual { .. } => false,
            };
            if !plain || !self.cases.is_empty() {
                return refuse(self.since(start), "this is not read as a condition");
            }
            under.push(clause);
            self.few_conditions(under)?;
            let end = self.at;
            self.skip_wide();
            match self.peek() {
                Kind::Text(words) if plain_and(words) => self.advance(),
                _ => {
                    self.at = end;
                    return Ok(());
                }
            }
        }
    }

    /// Refuses conditions that are too many to be judged under.
    pub(super) fn few_conditions(&self, under: &[Clause]) -> Read<()> {
        match under.len() > MOST_CONDITIONS {
            true => refuse(
                self.span(),
                "this is said under too many conditions to be judged",
            ),
            false => Ok(()),
        }
    }

    /// `a = b \quad \text{if } x > 0`
    pub(super) fn trailing_conditions(&mut self, clauses: &[Clause]) -> Read<Vec<Clause>> {
        let (end, mut under) = (self.at, Vec::new());
        self.skip_wide();
        self.accept(Kind::Char(','));
        self.skip_wide();
        let quantifies = self.quantifies();
        match self.peek() {
            _ if quantifies => {}
            Kind::Text(words) if TRAILING.contains(&plain(words)) => {}
            Kind::Text(words) if BESIDE.contains(&plain(words)) && self.bounds_next() => {}
            _ => {
                self.at = end;
                return Ok(under);
            }
        }
        if clauses.len() > 1 {
            return refuse(
                self.span(),
                "whether this condition is one of the whole implication is not clear",
            );
        }
        // The cases before it are not its own.
        let cases = std::mem::take(&mut self.cases);
        if !cases.is_empty() {
            return refuse(self.span(), "a condition on all of the cases is not read");
        }
        match quantifies {
            true => self.quantifier(&mut under)?,
            false => self.worded_conditions(&mut under)?,
        }
        if let Kind::Char(',' | ';') = self.peek()
            && !matches!(
                self.kind(self.at + 1),
                Kind::End | Kind::Wide | Kind::Row | Kind::Finish(_)
            )
        {
            return refuse_with(
                self.span(),
                "whether another condition follows, or another statement, is not clear",
                "write `\\text{ and }` before a condition, `\\quad` before a statement",
            );
        }
        Ok(under)
    }

    /// Whether what comes after a word says where something lies, and what nothing is equal to.
    fn bounds_next(&self) -> bool {
        let ends = |kind: &Kind<'_>| {
            matches!(
                kind,
                Kind::End | Kind::Wide | Kind::Row | Kind::Finish(_) | Kind::Text(_)
            )
        };
        let mut relations = (self.at + 1..)
            .map(|at| self.kind(at))
            .take_while(|kind| !ends(kind))
            .filter_map(|kind| match kind {
                Kind::Relation(relation, _) => Some(relation),
                _ => None,
            })
            .peekable();
        let bounds = |relation| {
            use Relation::{Greater, GreaterOrEqual, Less, LessOrEqual, NotEqual};
            matches!(
                relation,
                Greater | GreaterOrEqual | Less | LessOrEqual | NotEqual
            )
        };
        relations.peek().is_some() && relations.all(bounds)
    }

    /// `\text{if } x > 0`, `\text{for } n = 1, 2, \dots`
    fn worded_conditions(&mut self, under: &mut Vec<Clause>) -> Read<()> {
        self.advance();
        let words = self.at;
        if let Some(run) = self.run()
            && self.ends_aside(false)
        {
            self.runs.push(run);
            return Ok(());
        }
        self.at = words;
        self.conditions(under)
    }

    /// A statement whose last side has cases, as a statement for each.
    pub(super) fn by_cases(&mut self, mut statement: Statement) -> Read<Vec<Statement>> {
        let cases = std::mem::take(&mut self.cases);
        if cases.is_empty() {
            return Ok(vec![statement]);
        }
        let (
            Some(Clause::Chain {
                mut sides,
                mut links,
            }),
            true,
        ) = (statement.clauses.pop(), statement.clauses.is_empty())
        else {
            return refuse(statement.span, "cases are not read in an implication");
        };
        let (Some(left), Some(link)) = (sides.last().cloned(), links.pop()) else {
            return refuse(statement.span, "a term is missing before these cases");
        };
        let mut all = Vec::new();
        let share = |sides: Vec<Side>, links: Vec<Link>, under, span| Statement {
            label: None,
            clauses: vec![Clause::Chain { sides, links }],
            connectives: Vec::new(),
            under,
            mark: statement.mark.clone(),
            span,
            others: Vec::new(),
            before: Vec::new(),
            doubts: Vec::new(),
            runs: Vec::new(),
            quantified: statement.quantified.clone(),
        };
        if !links.is_empty() {
            let span = sides.iter().map(|side| side.span).reduce(Span::to);
            let span = span.unwrap_or(left.span);
            all.push(share(std::mem::take(&mut sides), links, Vec::new(), span));
        }
        for case in cases {
            let sides = vec![left.clone(), case.side];
            all.push(share(sides, vec![link], case.under, case.span));
        }
        if let Some(first) = all.first_mut() {
            first.label = statement.label;
            first.before = statement.before;
            first.doubts = statement.doubts;
            first.runs = statement.runs;
        }
        Ok(all)
    }
}

/// Words without the signs around them.
fn plain(words: &str) -> &str {
    words.trim().trim_matches([',', ';', ':', '.']).trim()
}

fn plain_and(words: &str) -> bool {
    plain(words) == "and"
}

/// That none of the cases before applies.
fn none_of(cases: &[Case], span: Span) -> Read<Vec<Clause>> {
    let denied = |case: &Case| {
        let [Clause::Chain { sides, links }] = case.under.as_slice() else {
            return None;
        };
        let [link] = links.as_slice() else {
            return None;
        };
        let relation = link.relation.denied()?;
        let links = vec![Link { relation, ..*link }];
        let sides = sides.clone();
        Some(Clause::Chain { sides, links })
    };
    let all: Option<Vec<Clause>> = cases.iter().map(denied).collect();
    match all.filter(|all| !all.is_empty()) {
        Some(all) => Ok(all),
        None => refuse_with(
            span,
            "what is left for this case is not a plain condition",
            "write the condition out",
        ),
    }
}
