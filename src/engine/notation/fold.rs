//! Between lexer and parser: signs that are spelt with several tokens become one, and what depends on its
//! surroundings is decided once, by looking at the neighbours.
//!
//! - `\stackrel{?}{=}`, `\overset{!}{=}`, `\not=`, `:=` become one relation.
//! - A `\times` with nothing after it but the end of its statement is the author's ✗; between factors it is a product.
//! - `\boxed{…}` or `\underline{…}` around whole clauses becomes a pair of marks that the statement reader steps over; around a term it
//!   stays a group.
//! - `&` goes. A row that starts with a relation or a connective continues the statement before it, and so does a
//!   row whose first cell is empty and that starts with a sign; any other row is a statement of its own.

mod system;

use super::commands;
use super::lexer::{Kind, Token};
use super::shorthand;
use super::{Connective, Mark};
use crate::algebra::Relation;

/// The most tokens above a relation sign.
const LONGEST_REMARK: usize = 20;

/// Folds the raw tokens. Linear in their number.
pub(super) fn fold<'s>(raw: &[Token<'s>]) -> Vec<Token<'s>> {
    let raw = shorthand::written_out(raw);
    let mut raw = system::without_braces(bare_words(&raw));
    part_inner_columns(&mut raw);
    // Few formulas have boxes, and what closes where is asked for these alone.
    let boxed = raw.iter().any(|token| is_box(token.kind));
    if boxed {
        part_from_boxes(&mut raw);
    }
    let mut folder = Folder {
        raw: &raw,
        closing: Vec::new(),
        boxes: Vec::new(),
    };
    if boxed {
        folder.closing = closing(&raw);
        folder.find_boxes();
    }
    folder.run()
}

/// `{\rm d}` stands where `\mathrm{d}` would: the braces around a single word go, but where a command takes them. So do braces around
/// nothing, `{}-a`, unless they hold apart indices, `T^a{}_b`.
fn bare_words<'s>(raw: &[Token<'s>]) -> Vec<Token<'s>> {
    // Only what stands in braces by itself, or comes to, is one.
    let is_last = |pair: &[Token]| {
        let is_inner = is_word(pair[0].kind) || matches!(pair[0].kind, Kind::Open);
        is_inner && matches!(pair[1].kind, Kind::Close)
    };
    if !raw.windows(2).any(is_last) {
        return raw.to_vec();
    }
    let mut out: Vec<Token<'s>> = Vec::with_capacity(raw.len());
    let mut open = Vec::new();
    // For each token that is kept, where its group opens.
    let mut groups = Vec::with_capacity(raw.len());
    for (place, token) in raw.iter().enumerate() {
        let at = out.len();
        groups.push(match token.kind {
            Kind::Close => open.pop().unwrap_or(at),
            _ => at,
        });
        if matches!(token.kind, Kind::Open) {
            open.push(at);
        }
        out.push(*token);
        let next = raw.get(place + 1).map(|next| next.kind);
        if let [.., first, last] = out.as_slice()
            && matches!((first.kind, last.kind), (Kind::Open, Kind::Close))
            && !is_argument(&out, &groups, at - 1)
            && !matches!(next, Some(Kind::Char('_' | '^' | '\'')))
        {
            out.truncate(at - 1);
            groups.truncate(at - 1);
            continue;
        }
        if let [.., first, word, last] = out.as_slice()
            && matches!((first.kind, last.kind), (Kind::Open, Kind::Close))
            && is_word(word.kind)
            && !is_argument(&out, &groups, at - 2)
        {
            let (kind, spaced) = (word.kind, first.spaced);
            let span = first.span.to(last.span);
            out.truncate(at - 2);
            groups.truncate(at - 1);
            out.push(Token { kind, span, spaced });
        }
    }
    out
}

fn is_word(kind: Kind) -> bool {
    matches!(kind, Kind::Upright(_) | Kind::Quantity("", _))
}

/// Whether the braces that open here are a script, or what a command applies to.
fn is_argument(tokens: &[Token], groups: &[usize], at: usize) -> bool {
    let kind = |at: Option<usize>| at.and_then(|at| tokens.get(at)).map(|token| token.kind);
    let takes_two = |name: &str| {
        commands::is_fraction(name)
            || commands::is_binomial(name)
            || matches!(name, "stackrel" | "overset")
    };
    let takes_one = |name: &str| {
        matches!(name, "sqrt" | "boxed" | "underbrace" | "overbrace")
            || commands::find(commands::ACCENTS, name).is_some()
    };
    let before = at.checked_sub(1);
    match kind(before) {
        Some(Kind::Char('_' | '^' | ']')) => return true,
        Some(Kind::Open) => return false,
        Some(Kind::Command(name)) if takes_one(name) || takes_two(name) => return true,
        _ => {}
    }
    // The second of two: `\frac{a}{\rm b}`.
    let first = before.and_then(|before| groups.get(before));
    let command = kind(first.and_then(|first| first.checked_sub(1)));
    matches!(command, Some(Kind::Command(name)) if takes_two(name))
}

/// Whether a row goes on with the statement of the row before it.
pub(super) fn continues(row: &[Token]) -> bool {
    let folder = Folder {
        raw: row,
        closing: Vec::new(),
        boxes: Vec::new(),
    };
    folder.continues(0)
}

/// In a row of `align`, `a &= b & c &= d` is two equations: every second `&` parts them, as a wide space does.
pub(super) fn part_columns(row: &mut [Token]) {
    let (mut cells, mut depth) = (0_usize, 0_usize);
    for token in row {
        match token.kind {
            Kind::Begin(_) => depth += 1,
            Kind::Finish(_) => depth = depth.saturating_sub(1),
            Kind::Char('&') if depth == 0 => {
                cells += 1;
                if cells.is_multiple_of(2) {
                    token.kind = Kind::Wide;
                }
            }
            _ => {}
        }
    }
}

/// The same for the rows of the environments in a formula that have such columns.
fn part_inner_columns(raw: &mut [Token]) {
    let mut open: Vec<(bool, usize)> = Vec::new();
    let mut cases: Vec<bool> = Vec::new();
    for token in raw {
        match token.kind {
            Kind::Begin(name) => {
                cases.push(is_cases(name));
                let name = name.trim_end_matches('*');
                let columns = ["align", "aligned", "alignat", "alignedat", "flalign"];
                open.push((columns.contains(&name), 0));
            }
            Kind::Char('&') if cases.last() == Some(&true) => token.kind = Kind::Cell,
            Kind::Finish(_) => {
                open.pop();
                cases.pop();
            }
            Kind::Row => {
                if let Some((_, cells)) = open.last_mut() {
                    *cells = 0;
                }
            }
            Kind::Char('&') => {
                if let Some((true, cells)) = open.last_mut() {
                    *cells += 1;
                    if cells.is_multiple_of(2) {
                        token.kind = Kind::Wide;
                    }
                }
            }
            _ => {}
        }
    }
}

/// The full stop at the end of a box, `\boxed{a = b.}`, is that of the sentence: it goes behind the box.
fn part_from_boxes(raw: &mut [Token]) {
    let mut ends = vec![false; raw.len()];
    for (open, close) in closing(raw).into_iter().enumerate() {
        let boxed = open.checked_sub(1).is_some_and(|at| is_box(raw[at].kind));
        if let Some(slot) = close.and_then(|close| ends.get_mut(close)) {
            *slot = boxed;
        }
    }
    for at in 1..raw.len() {
        if ends[at] && matches!(raw[at - 1].kind, Kind::Char(',' | ';' | '.')) {
            raw.swap(at - 1, at);
        }
    }
}

/// What a command says between two clauses.
fn connective(command: &str) -> Option<Connective> {
    Some(match command {
        "Rightarrow" | "implies" | "Longrightarrow" | "therefore" => Connective::Implies,
        "iff" | "Leftrightarrow" | "Longleftrightarrow" => Connective::Equivalent,
        _ => return None,
    })
}

fn is_box(kind: Kind) -> bool {
    matches!(kind, Kind::Command("boxed" | "underline"))
}

/// Whether what stands above a relation sign is a remark that changes nothing in it: `!`, a citation, a definition.
fn is_remark(above: &[Token]) -> bool {
    let cites = |words: &str| {
        let first = words
            .trim()
            .split([' ', '~', '.', '('])
            .next()
            .unwrap_or("");
        let first = first.to_lowercase();
        let known = [
            "", "def", "by", "using", "see", "eq", "eqs", "equation", "gl",
        ];
        !words.trim().is_empty() && known.contains(&first.as_str())
    };
    let kinds: Vec<Kind> = above.iter().map(|token| token.kind).collect();
    match kinds.as_slice() {
        [Kind::Char('!')] => true,
        [Kind::Text(words) | Kind::Upright(words)] => cites(words),
        [Kind::Text(words), Kind::Reference(_)] => cites(words),
        [first, ..] => {
            let number = |kind: &Kind| {
                matches!(
                    kind,
                    Kind::Number(_)
                        | Kind::Letter(_)
                        | Kind::Reference(_)
                        | Kind::Char('*' | '\'' | ',')
                )
            };
            let plain = |kind: &Kind| matches!(kind, Kind::Reference(_) | Kind::Char('*' | ','));
            match (first, kinds.last()) {
                (Kind::Char('('), Some(Kind::Char(')'))) => {
                    kinds.len() > 2 && kinds[1..kinds.len() - 1].iter().all(number)
                }
                _ => kinds.iter().all(plain),
            }
        }
        [] => false,
    }
}

/// The environments whose rows are cases, each with its condition in a second cell, or equations side by side.
pub(super) fn is_cases(environment: &str) -> bool {
    matches!(environment, "cases" | "dcases")
}

/// For every `{`, where its `}` is.
pub(super) fn closing(raw: &[Token]) -> Vec<Option<usize>> {
    let mut closing = vec![None; raw.len()];
    let mut open = Vec::new();
    for (at, token) in raw.iter().enumerate() {
        match token.kind {
            Kind::Open => open.push(at),
            Kind::Close => {
                if let Some(slot) = open.pop().and_then(|from| closing.get_mut(from)) {
                    *slot = Some(at);
                }
            }
            _ => {}
        }
    }
    closing
}

struct Folder<'a, 's> {
    raw: &'a [Token<'s>],
    /// For every `{`, where its `}` is, if there are boxes.
    closing: Vec<Option<usize>>,
    /// Whether the `\boxed` at this place holds whole clauses.
    boxes: Vec<bool>,
}

impl<'s> Folder<'_, 's> {
    fn kind(&self, at: usize) -> Kind<'s> {
        self.raw.get(at).map_or(Kind::End, |token| token.kind)
    }

    fn run(self) -> Vec<Token<'s>> {
        // As long as the tokens, where there are boxes.
        let mut closes_box = vec![false; self.closing.len()];
        let mut out = Vec::with_capacity(self.raw.len());
        let mut at = 0;
        while let Some(&token) = self.raw.get(at) {
            let before = at;
            at += 1;
            if let Some((kind, length)) = self.relation(before) {
                at = before + length;
                let end = self.raw.get(at - 1).map_or(token.span, |last| last.span);
                out.push(Token {
                    kind,
                    span: token.span.to(end),
                    ..token
                });
                continue;
            }
            let kind = match token.kind {
                Kind::Char('&') => continue,
                // `a &= b` in a system of equations.
                Kind::Cell
                    if self.relation(at).is_some()
                        || matches!(
                            out.last(),
                            Some(Token {
                                kind: Kind::Row | Kind::Begin(_),
                                ..
                            })
                        ) =>
                {
                    continue;
                }
                Kind::Row if self.continues(at) => {
                    while matches!(self.kind(at), Kind::Wide | Kind::Char('&')) {
                        at += 1;
                    }
                    continue;
                }
                Kind::Command("boxed" | "underline") if self.boxes.get(before) == Some(&true) => {
                    if let Some(Some(close)) = self.closing.get(at)
                        && let Some(slot) = closes_box.get_mut(*close)
                    {
                        *slot = true;
                    }
                    let open = self.raw.get(at).map_or(token.span, |open| open.span);
                    at += 1;
                    out.push(Token {
                        kind: Kind::BoxOpen,
                        span: token.span.to(open),
                        ..token
                    });
                    continue;
                }
                Kind::Close if closes_box.get(before) == Some(&true) => Kind::BoxClose,
                Kind::Command("times") if self.is_cross(before, &closes_box) => {
                    Kind::Mark(Mark::Cross)
                }
                Kind::Command("checkmark" | "cmark") => Kind::Mark(Mark::Tick),
                Kind::Command("xmark") => Kind::Mark(Mark::Cross),
                Kind::Text(words) => match words.trim() {
                    "✓" | "✔" => Kind::Mark(Mark::Tick),
                    "✗" | "✘" => Kind::Mark(Mark::Cross),
                    _ => token.kind,
                },
                Kind::Command(name) if let Some(connective) = connective(name) => {
                    Kind::Connective(connective)
                }
                kind => kind,
            };
            out.push(Token { kind, ..token });
        }
        out
    }

    /// The relation that starts here, and over how many tokens it runs.
    fn relation(&self, at: usize) -> Option<(Kind<'s>, usize)> {
        if let Some(relation) = self.plain_relation(at) {
            let defines = relation == Relation::Equal && self.kind(at + 1) == Kind::Char(':');
            return Some((Kind::Relation(relation, false), 1 + usize::from(defines)));
        }
        match self.kind(at) {
            Kind::Char(':') | Kind::Command("colon") if self.kind(at + 1) == Kind::Char('=') => {
                Some((Kind::Relation(Relation::Equal, false), 2))
            }
            Kind::Command("not") if self.kind(at + 1) == Kind::Char('=') => {
                Some((Kind::Relation(Relation::NotEqual, false), 2))
            }
            Kind::Command("stackrel" | "overset") => {
                let close = self.end_of_remark(at + 1)?;
                let above = self.raw.get(at + 2..close)?;
                let asked = matches!(above, [one] if one.kind == Kind::Char('?'));
                if !asked && !is_remark(above) {
                    return None;
                }
                let sign = close + 1;
                match (
                    self.plain_relation(sign),
                    self.kind(sign),
                    self.kind(sign + 2),
                ) {
                    (Some(relation), ..) => Some((Kind::Relation(relation, asked), sign + 1 - at)),
                    (None, Kind::Open, Kind::Close) => {
                        let relation = self.plain_relation(sign + 1)?;
                        Some((Kind::Relation(relation, asked), sign + 3 - at))
                    }
                    _ => None,
                }
            }
            _ => None,
        }
    }

    /// The `}` of the `{` at this place, in which no braces stand, and which is not far away.
    fn end_of_remark(&self, open: usize) -> Option<usize> {
        if self.kind(open) != Kind::Open {
            return None;
        }
        let mut ends = open + 1..open + LONGEST_REMARK;
        ends.find(|&at| matches!(self.kind(at), Kind::Open | Kind::Close | Kind::End))
            .filter(|&at| self.kind(at) == Kind::Close)
    }

    fn plain_relation(&self, at: usize) -> Option<Relation> {
        match self.kind(at) {
            Kind::Char('=') => Some(Relation::Equal),
            Kind::Char('<') => Some(Relation::Less),
            Kind::Char('>') => Some(Relation::Greater),
            Kind::Command(name) => commands::relation(name),
            _ => None,
        }
    }

    /// Whether the row that starts here goes on with the statement before it.
    fn continues(&self, mut at: usize) -> bool {
        let mut empty_cell = false;
        loop {
            match self.kind(at) {
                Kind::Wide => {}
                Kind::Char('&') => empty_cell = true,
                Kind::Char('+' | '-') => return empty_cell,
                Kind::Command(name) if connective(name).is_some() || commands::tends(name) => {
                    return true;
                }
                _ => return self.relation(at).is_some(),
            }
            at += 1;
        }
    }

    fn is_cross(&self, at: usize, closes_box: &[bool]) -> bool {
        let wide_before = at
            .checked_sub(1)
            .is_some_and(|before| self.kind(before) == Kind::Wide);
        let mut next = at + 1;
        while self.kind(next) == Kind::Wide {
            next += 1;
        }
        match self.kind(next) {
            Kind::End | Kind::Row | Kind::Finish(_) | Kind::And | Kind::Char(',' | ';' | '.') => {
                true
            }
            Kind::Close => closes_box.get(next) == Some(&true),
            _ => wide_before && next > at + 1,
        }
    }

    /// Finds the boxes around whole clauses, innermost first, so that each token is looked at once.
    fn find_boxes(&mut self) {
        self.boxes = vec![false; self.raw.len()];
        for at in (0..self.raw.len()).rev() {
            if !is_box(self.kind(at)) {
                continue;
            }
            let Some(&Some(close)) = self.closing.get(at + 1) else {
                continue;
            };
            let mut inside = at + 2;
            let mut holds = false;
            while inside < close && !holds {
                holds = self.relation(inside).is_some() || self.boxes.get(inside) == Some(&true);
                // What is in braces is a term of its own: step over it.
                inside = match self.closing.get(inside) {
                    Some(&Some(end)) => end + 1,
                    _ => inside + 1,
                };
            }
            if let Some(slot) = self.boxes.get_mut(at) {
                *slot = holds;
            }
        }
    }
}
