//! Displays to equations: one display has as many as it has numbers.
//!
//! In `align` every row has a number of its own. Rows that go on with the one before, `= c` after `a = b`, are read
//! together with it and then taken apart again: the second says `b = c`, and goes on with the first. Of these, a row without a number
//! belongs to the next that has one. Rows that say something of their own are steps, though none of them, or only the last, has a number.

use crate::algebra::{Expr, Formula, Relation};
use crate::document::{Item, Layout, Row, Span};
use crate::notation::{
    Clause, Connective, Context, Display, Link, Other, Statement, SyntaxError, Unit, read_on_page,
    read_rows,
};
use crate::parallel::{in_order, threads};

use super::equation::{Among, formulas};
use super::nested;

/// One equation of a display.
pub(super) struct Part {
    pub tag: Option<String>,
    pub keys: Vec<String>,
    pub group: Vec<String>,
    pub body: Span,
    pub statements: Result<Vec<Statement>, SyntaxError>,
    pub continues: usize,
    /// Where it stands among the statements that share its number, where these are of several rows.
    pub among: Option<Among>,
}

/// What the equations of a display state that could be read.
pub(super) fn statements(display: &[Part]) -> impl Iterator<Item = &Statement> {
    let read = display.iter().map(|part| part.statements.iter());
    read.flatten().flatten()
}

/// The formulas of a display, conditions apart.
pub(super) fn said(display: &[Part]) -> impl Iterator<Item = Formula> {
    statements(display).flat_map(formulas)
}

/// A row goes on with so many rows before it, the nearest: with all of thousands, each would cost as much as they are.
const LONGEST_CHAIN: usize = 64;
/// Nobody says what something is in more pieces: each is held against all.
const MOST_PIECES: usize = 32;
/// Fewer displays than this are not worth another thread.
const WORTH_SHARING: usize = 64;

/// Reads the displays of a long page, several at a time; none of those of a short one, which are read when it is their turn.
pub(super) fn read_ahead(source: &str, items: &[Item], context: &Context) -> Vec<Vec<Part>> {
    let displays = items.iter().filter_map(|item| match item {
        Item::Display { body, layout, .. } => Some((*body, layout.as_deref())),
        _ => None,
    });
    let displays: Vec<(Span, Option<&Layout>)> = displays.collect();
    if displays.len() < 2 * WORTH_SHARING || threads() < 2 {
        return Vec::new();
    }
    let shares = in_order(displays.chunks(WORTH_SHARING), |share| {
        let read = share
            .iter()
            .map(|&(body, layout)| read(source, body, layout, context));
        read.collect::<Vec<_>>()
    });
    shares.into_iter().flatten().collect()
}

/// Reads a display.
pub(super) fn read(
    source: &str,
    body: Span,
    layout: Option<&Layout>,
    context: &Context,
) -> Vec<Part> {
    let Some(layout) = layout else {
        let display = plain(read_on_page(source, body, false, context), body);
        let mut parts = nested::by_rows(source, display);
        say_by_pieces(&mut parts);
        return parts;
    };
    let mut parts = of_layout(source, body, layout, context);
    for part in &mut parts {
        part.continues = part.continues.min(LONGEST_CHAIN);
    }
    say_by_pieces(&mut parts);
    if let Some((number, keys)) = &layout.group {
        let keys = keys.iter().map(|key| format!("{{{key}}}"));
        let number = (!number.is_empty()).then(|| format!("({number})"));
        let group: Vec<String> = keys.chain(number).collect();
        for part in &mut parts {
            part.group.extend(group.iter().cloned());
        }
    }
    parts
}

/// A display whose mathematics says itself what its number is.
fn plain(display: Display, body: Span) -> Part {
    Part {
        tag: display.tag.map(|tag| tag.value),
        keys: display.label.into_iter().map(|key| key.value).collect(),
        group: Vec::new(),
        body,
        statements: display.statements,
        continues: 0,
        among: None,
    }
}

fn of_layout(source: &str, body: Span, layout: &Layout, context: &Context) -> Vec<Part> {
    if let ([row], None) = (&layout.rows[..], &layout.obstacle)
        && row.pieces == [body]
        && !layout.columns
    {
        let mut part = plain(read_on_page(source, body, true, context), body);
        part.tag = row.number.clone().or(part.tag);
        part.keys.extend(row.keys.iter().cloned());
        return nested::by_rows(source, part);
    }
    let pieces: Vec<Vec<Span>> = layout.rows.iter().map(|row| row.pieces.clone()).collect();
    let numbers = layout
        .rows
        .iter()
        .filter(|row| row.number.is_some())
        .count();
    let mut units = read_rows(source, &pieces, layout.columns, context);
    if let Some(problem) = &layout.obstacle {
        for unit in &mut units {
            unit.statements = Err(SyntaxError {
                span: problem.span,
                message: problem.message.clone(),
                help: problem.help.clone(),
            });
        }
    }
    if numbers < 2 && !are_steps(&units) {
        return vec![whole(units, &layout.rows, body)];
    }
    let mut parts = Vec::new();
    for unit in units {
        parts.extend(of_unit(unit, &layout.rows));
    }
    if numbers < 2 {
        share_number(&mut parts);
    }
    parts
}

/// Whether rows with one number, or none, say one thing after another.
fn are_steps(units: &[Unit]) -> bool {
    let says = |unit: &Unit| {
        let said = unit.statements.as_ref();
        said.is_ok_and(|said| !said.is_empty()) && unit.typed.is_none()
    };
    units.len() > 1 && units.iter().all(says)
}

/// The one number of a display is that of all its rows, and so are its keys.
fn share_number(parts: &mut [Part]) {
    let has_name = |part: &Part| part.tag.is_some() || !part.keys.is_empty();
    let Some(named) = parts.iter().position(has_name) else {
        return;
    };
    let tag = parts[named].tag.iter().map(|tag| format!("({tag})"));
    let keys = parts[named].keys.iter().map(|key| format!("{{{key}}}"));
    let group: Vec<String> = tag.chain(keys).collect();
    let others = parts.iter_mut().enumerate().filter(|(at, _)| *at != named);
    others.for_each(|(_, part)| part.group.extend(group.iter().cloned()));
}

/// What a display says several times of one side, each time of another range, is said under these: `f = a, \qquad x < 0` above
/// `f = b, \qquad 0 < x < l`.
fn say_by_pieces(parts: &mut [Part]) {
    let side = |statement: &Statement| match &statement.clauses[..] {
        [Clause::Chain { sides, links }] if links[0].relation == Relation::Equal => {
            Some(sides[0].expr.clone())
        }
        _ => None,
    };
    let orders = |own: &Link| {
        use Relation::{Greater, GreaterOrEqual, Less, LessOrEqual};
        matches!(own.relation, Less | LessOrEqual | Greater | GreaterOrEqual)
    };
    // The bare symbol that is bounded.
    let is_range = |statement: &Statement, of: &Expr| match &statement.clauses[..] {
        [Clause::Chain { sides, links }] if links.iter().all(orders) => {
            let middle = &sides[usize::from(sides.len() == 3)].expr;
            matches!(middle, Expr::Symbol(_)) && sides.len() <= 3 && middle != of
        }
        _ => false,
    };
    let mut found: Vec<(usize, usize, Expr)> = Vec::new();
    for (at, part) in parts.iter().enumerate() {
        let statements: Vec<&Statement> = part.statements.iter().flatten().collect();
        for (first, pair) in statements.windows(2).enumerate() {
            if let Some(own) = side(pair[0]).filter(|own| is_range(pair[1], own)) {
                found.push((at, first, own));
            }
        }
    }
    if found.len() > MOST_PIECES {
        return;
    }
    let several = |of: &Expr| found.iter().filter(|own| own.2 == *of).count() > 1;
    let pieces: Vec<(usize, usize)> = (found.iter().rev())
        .filter(|own| several(&own.2))
        .map(|own| (own.0, own.1))
        .collect();
    for (at, first) in pieces {
        if let Ok(statements) = &mut parts[at].statements {
            let range = statements.remove(first + 1);
            statements[first].under.extend(range.clauses);
        }
    }
}

fn keys(rows: &[Row]) -> Vec<String> {
    rows.iter().flat_map(|row| row.keys.clone()).collect()
}

fn body_of(rows: &[Row]) -> Span {
    let pieces = rows.iter().flat_map(|row| row.pieces.iter().copied());
    pieces.reduce(Span::to).unwrap_or_default()
}

/// A display with one number, or none.
fn whole(units: Vec<Unit>, rows: &[Row], body: Span) -> Part {
    let typed = units.iter().find_map(|unit| unit.typed.clone());
    let statements: Result<Vec<Vec<Statement>>, SyntaxError> =
        units.into_iter().map(|unit| unit.statements).collect();
    Part {
        tag: rows.iter().find_map(|row| row.number.clone()).or(typed),
        keys: keys(rows),
        group: Vec::new(),
        body,
        statements: statements.map(|all| all.into_iter().flatten().collect()),
        continues: 0,
        among: None,
    }
}

/// The equations of rows that were read together.
fn of_unit(unit: Unit, all: &[Row]) -> Vec<Part> {
    let rows = &all[unit.rows];
    let numbered: Vec<usize> = (0..rows.len())
        .filter(|&at| rows[at].number.is_some())
        .collect();
    // The rows of each number: those after the number before it, and at the end all that are left.
    let mut groups: Vec<std::ops::Range<usize>> = Vec::new();
    for &at in &numbered {
        let start = groups.last().map_or(0, |group| group.end);
        groups.push(start..at + 1);
    }
    match groups.last_mut() {
        Some(last) => last.end = rows.len(),
        None => groups.push(0..rows.len()),
    }
    let part = |group: &std::ops::Range<usize>, statements, continues| {
        let own = &rows[group.clone()];
        Part {
            tag: own.iter().find_map(|row| row.number.clone()),
            keys: keys(own),
            group: Vec::new(),
            body: body_of(own),
            statements,
            continues,
            among: None,
        }
    };
    let statements = match unit.statements {
        Err(error) => {
            // None of them is read: which of the rows would be, nobody can say.
            let error = |_: usize| Err(error.clone());
            return (groups.iter().enumerate())
                .map(|(at, group)| part(group, error(at), at))
                .collect();
        }
        Ok(statements) => statements,
    };
    let starts: Vec<usize> = groups
        .iter()
        .map(|group| body_of(&rows[group.clone()]).start)
        .collect();
    let group_of = |span: Span| starts.partition_point(|&start| start <= span.start).max(1) - 1;
    let mut shares: Vec<Vec<Statement>> = vec![Vec::new(); groups.len()];
    for statement in statements {
        for (at, share) in taken_apart(statement, &group_of) {
            if let Some(own) = shares.get_mut(at) {
                own.push(share);
            }
        }
    }
    let mut parts: Vec<Part> = Vec::new();
    for (group, share) in groups.iter().zip(shares) {
        if share.is_empty() {
            // A row that says nothing of its own, such as `+ c`: its number is another of the equation it belongs to.
            if let Some(before) = parts.last_mut() {
                let own = part(group, Ok(Vec::new()), 0);
                before
                    .group
                    .extend(own.tag.iter().map(|tag| format!("({tag})")));
                before.keys.extend(own.keys);
                before.body = before.body.to(own.body);
                continue;
            }
        }
        let continues = parts.len();
        parts.push(part(group, Ok(share), continues));
    }
    // The first has nothing to say where all of it is said further on.
    if parts.len() > 1 && parts[0].statements.as_ref().is_ok_and(Vec::is_empty) {
        let first = parts.remove(0);
        parts[0]
            .group
            .extend(first.tag.iter().map(|tag| format!("({tag})")));
        parts[0].keys.extend(first.keys);
        parts[0].body = first.body.to(parts[0].body);
        for part in &mut parts {
            part.continues = part.continues.saturating_sub(1);
        }
    }
    parts
}

/// A statement by the rows that its relations stand in.
fn taken_apart(
    mut statement: Statement,
    group_of: &impl Fn(Span) -> usize,
) -> Vec<(usize, Statement)> {
    let equivalent = |c: &crate::notation::Spanned<Connective>| c.value == Connective::Equivalent;
    let whole = statement.connectives.iter().any(equivalent)
        || statement
            .clauses
            .iter()
            .any(|clause| matches!(clause, Clause::AllEqual { .. }));
    if whole {
        return vec![(group_of(statement.span), statement)];
    }
    let others = std::mem::take(&mut statement.others);
    let mut apart: Vec<(usize, Statement)> = Vec::new();
    for (at, clause) in statement.clauses.into_iter().enumerate() {
        let Clause::Chain { sides, links } = clause else {
            continue;
        };
        let mut begins_clause = at > 0;
        for (link, pair) in links.iter().zip(sides.windows(2)) {
            let group = group_of(link.span);
            let same = apart.last_mut().filter(|(own, _)| *own == group);
            match same {
                Some((_, share)) if begins_clause => {
                    // An implication within its rows.
                    share.clauses.push(Clause::Chain {
                        sides: pair.to_vec(),
                        links: vec![*link],
                    });
                    if let Some(connective) = statement.connectives.get(at - 1) {
                        share.connectives.push(connective.clone());
                    }
                }
                Some((_, share)) => {
                    if let Some(Clause::Chain { sides, links }) = share.clauses.last_mut() {
                        sides.push(pair[1].clone());
                        links.push(*link);
                    }
                }
                None => apart.push((
                    group,
                    Statement {
                        label: match apart.is_empty() {
                            true => statement.label.clone(),
                            false => None,
                        },
                        clauses: vec![Clause::Chain {
                            sides: pair.to_vec(),
                            links: vec![*link],
                        }],
                        connectives: Vec::new(),
                        under: statement.under.clone(),
                        mark: None,
                        others: Vec::new(),
                        before: Vec::new(),
                        doubts: Vec::new(),
                        runs: statement.runs.clone(),
                        quantified: statement.quantified.clone(),
                        span: pair[0].span.to(pair[1].span),
                    },
                )),
            }
            begins_clause = false;
            if let Some((_, share)) = apart.last_mut() {
                share.span = share.span.to(pair[1].span);
            }
        }
    }
    if let Some((_, last)) = apart.last_mut() {
        last.mark = statement.mark;
    }
    let within = |outer: Span, inner: Span| outer.start <= inner.start && inner.end <= outer.end;
    for (_, share) in &mut apart {
        let own = statement.before.iter();
        let own = own.filter(|before| within(share.span, before.span));
        share.before = own.cloned().collect();
        let own = statement.doubts.iter();
        let own = own.filter(|doubt| within(share.span, doubt.span));
        share.doubts = own.cloned().collect();
    }
    for other in others {
        let shares = taken_apart(other.statement, group_of);
        if shares.len() != apart.len() {
            continue;
        }
        for ((_, share), (_, statement)) in apart.iter_mut().zip(shares) {
            if formulas(share) != formulas(&statement) {
                let span = match within(share.span, other.span) {
                    true => other.span,
                    false => share.span,
                };
                share.others.push(Other {
                    choice: other.choice,
                    span,
                    statement,
                });
            }
        }
    }
    apart
}
