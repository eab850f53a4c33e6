//! Statements: chains of relations, joined by implications, labelled and marked.

use super::both::{self, either};
use super::series::hole_of;
use super::worked_out::{lend_units, loosen};
use super::{Kind, Parser, Read, no_matrix, refuse, refuse_with};
use crate::algebra::{BigRational, Expr, Relation, Symbol, split_subscript};
use crate::document::Span;
use crate::notation::commands;
use crate::notation::fold::is_cases;
use crate::notation::{Choice, Clause, Link, Mark, Other, Side, Spanned, Statement};
use crate::sorted::Set;

/// The environments whose rows are statements.
const ENVIRONMENTS: &[&str] = &[
    "aligned",
    "align",
    "align*",
    "split",
    "gather",
    "gather*",
    "gathered",
    "equation",
    "equation*",
    "cases",
    "dcases",
];

/// Words between statements that say no more than that both are made. "If", "or" and "unless" say something else, and
/// are refused.
const BETWEEN: &[&str] = &[
    "",
    "and",
    "where",
    "with",
    "so",
    "so that",
    "hence",
    "thus",
    "therefore",
    "then",
    "but",
    "also",
    "while",
    "whence",
    "which gives",
    "giving",
    "i.e.",
    "that is",
    "or equivalently",
    "as well as",
    "together with",
    "and hence",
    "and thus",
    "and so",
    "and therefore",
    "and then",
    "and also",
    "we have",
    "we get",
    "we find",
];

/// Whether words, with the punctuation around them, stand between two statements.
fn separates(words: &str) -> bool {
    let words = words.trim().trim_matches([',', ';', ':']).trim();
    BETWEEN.contains(&words)
}

/// Nobody writes more relations in one clause, or more clauses in one statement; each is judged from those before it.
const MOST_RELATIONS: usize = 500;

/// A place in a chain: a term, one with the upper and the lower of two signs, or the dots of `u_1 = \dots = u_n`.
pub(super) enum Place {
    Side(Side),
    /// The sign is where the two differ first.
    Either {
        upper: Side,
        lower: Side,
        sign: Span,
    },
    Dots(Span),
}

impl<'s> Parser<'s> {
    /// All statements, to the end, with what they would be where there is a choice, each choice by itself.
    pub(in crate::notation) fn statements(mut self) -> Read<Vec<Statement>> {
        let mut statements = self.all_statements()?;
        let places = std::mem::take(&mut self.choices);
        let choices: Set<Choice> = places.iter().map(|(choice, _)| *choice).collect();
        for choice in choices {
            let (tokens, errors) = (
                std::mem::take(&mut self.tokens),
                std::mem::take(&mut self.errors),
            );
            self = Parser::new(tokens, errors, self.body, self.words);
            self.choice = Some(choice);
            let others = self.all_statements().unwrap_or_default();
            if others.len() != statements.len() {
                continue;
            }
            for (statement, other) in statements.iter_mut().zip(others) {
                let whole = statement.span;
                let here = |(own, s): &&(Choice, Span)| {
                    *own == choice && whole.start <= s.start && s.end <= whole.end
                };
                let place = places.iter().find(here);
                statement.others.extend(place.map(|&(_, span)| Other {
                    choice,
                    span,
                    statement: other,
                }));
            }
        }
        Ok(statements)
    }

    fn all_statements(&mut self) -> Read<Vec<Statement>> {
        let mut statements = Vec::new();
        let mut environments: Vec<(&'s str, Span)> = Vec::new();
        loop {
            self.skip_wide();
            while let Kind::Begin(name) = self.peek() {
                if name.ends_with("matrix") {
                    return no_matrix(self.span());
                }
                if !ENVIRONMENTS.contains(&name) {
                    return refuse(self.span(), format!("the environment `{name}` is not read"));
                }
                environments.push((name, self.span()));
                self.advance();
                self.skip_wide();
            }
            // The implication goes on from the display before, in which what it follows from is stated.
            if statements.is_empty() && !self.words && matches!(self.peek(), Kind::Connective(_)) {
                self.advance();
                self.skip_wide();
            }
            let remarked = match statements.last_mut() {
                Some(last) => self.aside(last),
                None => false,
            };
            if !remarked {
                let start = self.at;
                let names = self.shared_names();
                let statement = self.statement()?;
                let comma = start
                    .checked_sub(1)
                    .filter(|&at| self.kind(at) == Kind::Char(','));
                if comma.is_some()
                    && let Some(last) = statements.last()
                    && shares_bounds(last, &statement)
                {
                    return refuse_with(
                        last.span.to(statement.span),
                        "whether both lie between these bounds is not clear",
                        "write the bounds of each, as in `0 < a < 1, \\quad 0 < b < 1`",
                    );
                }
                if !names.is_empty() {
                    statements.extend(self.of_each(&names, &statement)?);
                }
                statements.extend(self.by_cases(statement)?);
            }
            let mut separated = self.separator()?;
            while let Kind::Finish(name) = self.peek() {
                match environments.pop() {
                    Some((begun, _)) if begun == name => {}
                    _ => {
                        return refuse(
                            self.span(),
                            format!("this ends `{name}`, which was not begun here"),
                        );
                    }
                }
                self.advance();
                separated |= self.separator()?;
            }
            if self.peek() == Kind::End {
                break;
            }
            if !separated {
                return self.unexpected();
            }
        }
        match environments.pop() {
            Some((name, span)) => refuse(span, format!("the environment `{name}` is never ended")),
            None => Ok(statements),
        }
    }

    pub(super) fn skip_wide(&mut self) -> bool {
        let start = self.at;
        while self.peek() == Kind::Wide {
            self.advance();
        }
        self.at > start
    }

    /// Takes what separates two statements; says whether there was anything.
    fn separator(&mut self) -> Read<bool> {
        let mut separated = self.skip_wide();
        // The sign at the end of a proof.
        if separated
            && matches!(self.peek(), Kind::Command("square" | "blacksquare" | "Box"))
            && matches!(self.kind(self.at + 1), Kind::End | Kind::Char('.'))
        {
            self.advance();
        }
        match self.peek() {
            Kind::Char(',' | ';') => {
                self.advance();
                separated = true;
            }
            Kind::Char('.') => {
                self.advance();
                self.skip_wide();
                if !matches!(self.peek(), Kind::End | Kind::Row | Kind::Finish(_)) {
                    self.at -= 1;
                    return refuse(
                        self.span(),
                        "a full stop ends the formulas, and more follows",
                    );
                }
                separated = true;
            }
            _ => {}
        }
        separated |= self.skip_wide();
        match self.peek() {
            Kind::Text(words) if separates(words) => {
                self.advance();
                separated = true;
            }
            Kind::Text(_) if separated && self.reason() => {
                if matches!(self.peek(), Kind::Char(',' | ';' | '.')) {
                    self.advance();
                }
            }
            Kind::And if self.words => {
                self.advance();
                separated = true;
            }
            _ => {}
        }
        while self.skip_wide() || self.accept(Kind::Row) {
            separated = true;
        }
        Ok(separated)
    }

    fn statement(&mut self) -> Read<Statement> {
        let start = self.at;
        let label = self.label();
        let mut under = Vec::new();
        self.leading_quantifier(&mut under)?;
        let (mut clauses, mut connectives) = (vec![self.clause()?], Vec::new());
        let mut mark = None;
        loop {
            let end = self.at;
            self.skip_closing();
            let span = self.span();
            match self.peek() {
                Kind::Connective(_) if connectives.len() >= MOST_RELATIONS => {
                    return refuse(span, "this statement has too many clauses to be judged");
                }
                Kind::Connective(value) => {
                    self.advance();
                    connectives.push(Spanned { value, span });
                    self.skip_wide();
                    clauses.push(self.clause()?);
                }
                Kind::Mark(value) if mark.is_none() => {
                    self.advance();
                    mark = Some(Spanned::<Mark> { value, span });
                }
                _ => {
                    // A `\quad` after the statement is for the separator to find.
                    while self.at > end && self.kind(self.at - 1) == Kind::Wide {
                        self.at -= 1;
                    }
                    break;
                }
            }
            if mark.is_some() && matches!(self.peek(), Kind::Connective(_)) {
                return refuse(
                    self.span(),
                    "a mark belongs at the end of the whole statement",
                );
            }
        }
        under.extend(self.trailing_conditions(&clauses)?);
        self.no_primitive_is_left()?;
        self.end_bracketed(clauses.iter().chain(&under))?;
        self.doubt_letters(start);
        Ok(Statement {
            label,
            clauses,
            connectives,
            under,
            mark,
            span: self.since(start),
            others: Vec::new(),
            before: std::mem::take(&mut self.before),
            doubts: std::mem::take(&mut self.doubts),
            runs: std::mem::take(&mut self.runs),
            quantified: std::mem::take(&mut self.quantified),
        })
    }

    fn skip_closing(&mut self) {
        while matches!(self.peek(), Kind::Wide | Kind::BoxClose) {
            self.advance();
        }
    }

    /// `\text{Initial: }`
    fn label(&mut self) -> Option<String> {
        let Kind::Text(words) = self.peek() else {
            return None;
        };
        let label = words.trim().strip_suffix(':')?.trim_end();
        if label.is_empty() {
            return None;
        }
        self.advance();
        self.skip_wide();
        Some(label.to_owned())
    }

    pub(super) fn clause(&mut self) -> Read<Clause> {
        while matches!(self.peek(), Kind::Wide | Kind::BoxOpen) {
            self.advance();
        }
        let start = self.at;
        let mut places = vec![self.place_with_signs()?];
        let mut links = Vec::new();
        loop {
            let end = self.at;
            if self.skip_wide() && self.reason() {
                self.skip_wide();
            }
            let (relation, questioned) = match self.peek() {
                Kind::Relation(relation, questioned) => (relation, questioned),
                Kind::Command(name) if commands::tends(name) => (Relation::Tends, false),
                _ => {
                    self.at = end;
                    break;
                }
            };
            if links.len() >= MOST_RELATIONS {
                let help = "part it into several displays";
                return refuse_with(self.span(), "this chain is too long to be judged", help);
            }
            links.push(Link {
                relation,
                questioned,
                span: self.span(),
            });
            self.advance();
            self.skip_wide();
            if let Kind::Relation(..) = self.peek() {
                return refuse(self.span(), "a term is missing between two relation signs");
            }
            if self.peek() == Kind::End {
                let sign = links.last().map_or(self.span(), |link| link.span);
                return refuse(sign, "a term is missing after this relation sign");
            }
            if matches!(self.peek(), Kind::Begin(name) if is_cases(name)) {
                return self.before_cases(places, links);
            }
            places.push(self.place_with_signs()?);
        }
        let span = self.since(start);
        if links.is_empty() {
            return self.lone(start, span);
        }
        // Reactions have arrows, too: `A \to B + C`.
        let equates =
            |link: &Link| matches!(link.relation, Relation::Equal | Relation::Approximately);
        if let Some(arrow) = links.iter().find(|link| link.relation == Relation::Tends)
            && !links.iter().any(equates)
        {
            let (message, help) = commands::complaint("to");
            let span = arrow.span;
            return Err(crate::notation::SyntaxError {
                span,
                message,
                help,
            });
        }
        // `x = 1 \to y = 2 \to x = 3` goes from one statement to the next.
        for (at, pair) in links.windows(3).enumerate() {
            let [before, arrow, after] = pair else {
                continue;
            };
            let goes_on = arrow.relation == Relation::Tends && equates(before) && equates(after);
            if goes_on
                && matches!(places.get(at + 2), Some(Place::Side(side)) if matches!(side.expr, Expr::Symbol(_)))
            {
                return refuse_with(
                    arrow.span,
                    "whether this tends to a limit, or leads to a statement of its own, is not clear",
                    "for statements of their own write `,`, or `\\Rightarrow`",
                );
            }
        }
        let places = either(places, &links)?;
        self.chain(places, links, span)
    }

    /// The refusal of a term without a relation, or of what stopped the reader there.
    fn lone<T>(&self, start: usize, span: Span) -> Read<T> {
        match self.peek() {
            Kind::And if !self.words => self.unexpected(),
            Kind::End
            | Kind::Wide
            | Kind::Row
            | Kind::Finish(_)
            | Kind::BoxClose
            | Kind::And
            | Kind::Mark(_)
            | Kind::Connective(_)
            | Kind::Char(',' | ';' | '.') => {
                let parted = start > 1 && self.kind(start - 1) == Kind::Wide;
                let help = match parted {
                    true => {
                        "the wide space before it parts it from what stands there; a statement needs a relation sign, such as `=`"
                    }
                    false => "a statement needs a relation sign, such as `=`",
                };
                refuse_with(span, "this is a term, not a statement", help)
            }
            _ => self.unexpected(),
        }
    }

    pub(super) fn place(&mut self) -> Read<Place> {
        let start = self.at;
        if let Kind::Command(name) = self.peek()
            && commands::is_dots(name)
        {
            self.advance();
            return Ok(Place::Dots(self.since(start)));
        }
        let outside = self.truncated.replace(false);
        let sum = self.sum();
        let truncated = std::mem::replace(&mut self.truncated, outside) == Some(true);
        let expr = sum?.expr;
        let span = self.since(start);
        let terms = match &expr {
            Expr::Sum(terms) if terms.len() == self.summands.len() => self.summands.clone(),
            _ => vec![span],
        };
        let rounding = self.rounding(start, &expr).map(Box::new);
        Ok(Place::Side(Side {
            expr,
            span,
            terms,
            rounding,
            truncated,
        }))
    }

    fn chain(&mut self, places: Vec<Place>, mut links: Vec<Link>, span: Span) -> Read<Clause> {
        let dots = places
            .iter()
            .enumerate()
            .find_map(|(at, place)| match place {
                Place::Dots(span) => Some((at, *span)),
                Place::Side(_) | Place::Either { .. } => None,
            });
        let mut sides = Vec::new();
        for place in places {
            match place {
                Place::Side(side) => sides.push(side),
                Place::Either { sign, .. } => return both::refuse_signs(sign),
                Place::Dots(span) if dots.is_some_and(|(_, first)| first != span) => {
                    return refuse(span, "dots are read only once in a chain");
                }
                Place::Dots(_) => {}
            }
        }
        match dots {
            None => {
                for (at, link) in links.iter_mut().enumerate() {
                    let ends_in_dots = [at, at + 1].iter().any(|&own| sides[own].truncated);
                    let is_equal =
                        matches!(link.relation, Relation::Equal | Relation::Approximately);
                    if ends_in_dots && is_equal {
                        link.relation = Relation::Approximately;
                        sides[at + 1].rounding = None;
                    }
                }
                lend_units(&mut sides);
                loosen(&mut sides, &mut links);
                let sides = self.differentiated_sides(sides, &links)?;
                Ok(Clause::Chain { sides, links })
            }
            Some((at, dots)) => self.all_equal(sides, at, dots, &links, span),
        }
    }

    /// `u_1 = u_2 = \dots = u_n`: the first elements in order, the dots, the last element, perhaps one value. Longer
    /// terms than elements need one.
    fn all_equal(
        &self,
        sides: Vec<Side>,
        at: usize,
        dots: Span,
        links: &[Link],
        span: Span,
    ) -> Read<Clause> {
        let mismatch = |span| {
            let help = "write `u_1 = u_2 = \\dots = u_n`, perhaps with `= w` at the end";
            refuse_with(
                span,
                "the sides around these dots do not follow one pattern",
                help,
            )
        };
        if let Some(link) = links
            .iter()
            .find(|link| link.relation != Relation::Equal || link.questioned)
        {
            return refuse(
                link.span,
                "a chain with dots is read only with plain `=` signs",
            );
        }
        let mut sides = sides.into_iter();
        let firsts: Vec<Side> = sides.by_ref().take(at).collect();
        let (Some(last), value, None) = (sides.next(), sides.next(), sides.next()) else {
            return mismatch(dots);
        };
        let Expr::Symbol(last_symbol) = &last.expr else {
            let sign = links.last().map_or(span, |link| link.span);
            let Some(value) = &value else {
                return refuse_with(
                    span,
                    "this chain of terms does not say what they are equal to",
                    "write `u_1 w_1 = u_2 w_2 = \\dots = u_n w_n = c`",
                );
            };
            return match self.all_equal_terms(&firsts, &last, value, sign)? {
                Some(clause) => Ok(clause),
                None => mismatch(dots),
            };
        };
        let mut end = None;
        for (number, side) in (1usize..).zip(&firsts) {
            let Expr::Symbol(symbol) = &side.expr else {
                return mismatch(side.span);
            };
            match hole_of(symbol, last_symbol) {
                Some((low, high)) if low == number.to_string() => end = Some(high),
                _ => return mismatch(side.span),
            }
        }
        let Some(end) = end else {
            return mismatch(dots);
        };
        let to = self.end_of_range(end, last.span)?;
        if matches!(&to, Expr::Number(n) if *n <= BigRational::from_integer(firsts.len().into())) {
            return mismatch(last.span);
        }
        let Some((stem, _)) = split_subscript(last_symbol.name()) else {
            return mismatch(last.span);
        };
        Ok(Clause::AllEqual {
            sequence: Symbol::new(stem),
            to,
            value,
            span,
        })
    }
}

/// Whether `0 < a` comes before `b < 1`, which may be said of both.
fn shares_bounds(one: &Statement, other: &Statement) -> bool {
    use Relation::{Greater, GreaterOrEqual, Less, LessOrEqual};
    let bounds = |statement: &Statement| match &statement.clauses[..] {
        [Clause::Chain { sides, links }] => match (&sides[..], &links[..]) {
            ([left, right], [link]) => {
                let is_name = |side: &Side| matches!(side.expr, Expr::Symbol(_));
                let rises = match link.relation {
                    Less | LessOrEqual => true,
                    Greater | GreaterOrEqual => false,
                    _ => return None,
                };
                Some((is_name(left), is_name(right), rises))
            }
            _ => None,
        },
        _ => None,
    };
    match (bounds(one), bounds(other)) {
        (Some((false, true, one)), Some((true, false, other))) => one == other,
        _ => false,
    }
}
