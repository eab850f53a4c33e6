//! The ways in: what a document hands to the reader, and what it gets back.

use std::collections::BTreeSet;
use std::ops::Range;

use super::commands;
use super::fold::{continues, fold, part_columns};
use super::lexer::{Kind, Lexed, Token, lex};
use super::parser::Parser;
use super::{Display, Spanned, Statement, SyntaxError, beside, signs};
use crate::algebra::{Expr, Symbol};
use crate::document::Span;

/// What a page tells of its notation as a whole.
#[derive(Clone, Debug, Default)]
pub struct Context {
    /// The names that it has as functions: what stands in parentheses after them is an argument, `f(x + 1)`.
    pub applied: BTreeSet<Symbol>,
    /// The names that it has as functions and without an argument, too: what is applied to a place is an argument, `v(L/2)`.
    pub valued: BTreeSet<Symbol>,
    /// Through what its sums run, where all of those that say it run through the same.
    pub run: Option<Through>,
    /// Whether it speaks of concentrations: then brackets around letters are one of them, in italics too, `[E S]`.
    pub has_concentrations: bool,
}

/// What sums run through: `i` from 1 to `n`.
#[derive(Clone, Debug, PartialEq)]
pub struct Through {
    /// `i`
    pub index: Symbol,
    /// 1
    pub from: Expr,
    /// `n`
    pub to: Expr,
    /// What they are sums of elements of.
    pub sequences: BTreeSet<Symbol>,
}

/// Reads a displayed equation: `source[body]`, the mathematics between the `$$`s.
///
/// The number and the key are found even if the rest cannot be read. A number typed by hand, `\quad (18)` at the very
/// end, counts as a tag where there is no `\tag`.
///
/// It may be cut out of an alignment: what `&` aligns is nobody's concern.
pub fn read_display(source: &str, body: Span) -> Display {
    display(source, body, lex(source, body), &Context::default())
}

/// Reads a displayed equation that stands in no alignment, so that an `&` in it, outside all environments, is a mistake.
pub fn read_unaligned(source: &str, body: Span) -> Display {
    read_on_page(source, body, false, &Context::default())
}

/// Reads a displayed equation of a page that has functions.
pub fn read_on_page(source: &str, body: Span, is_aligned: bool, context: &Context) -> Display {
    let lexed = match is_aligned {
        true => lex(source, body),
        false => unaligned(lex(source, body)),
    };
    display(source, body, lexed, context)
}

fn display<'s>(source: &'s str, body: Span, mut lexed: Lexed<'s>, context: &'s Context) -> Display {
    if lexed.tags.is_empty()
        && let Some(tag) = typed_tag(source, &mut lexed)
    {
        lexed.tags.push(tag);
    }
    let tag = lexed.tags.first().cloned();
    let label = lexed.labels.first().cloned();
    Display {
        tag,
        label,
        statements: parser(lexed, body, false).within(context).statements(),
    }
}

/// Rows of a display that make one statement, or several that stand side by side.
#[derive(Clone, Debug)]
pub struct Unit {
    /// Which rows.
    pub rows: Range<usize>,
    /// A number typed by hand at the very end.
    pub typed: Option<String>,
    /// What they state, or why that could not be read.
    pub statements: Result<Vec<Statement>, SyntaxError>,
}

/// Reads a display row by row, each given as the pieces of it that are mathematics.
///
/// A row that starts with a relation, or in an empty cell with a sign, goes on with the row before it. In `columns`
/// every second `&` of a row parts two equations. One row that cannot be read does not hinder the others.
pub fn read_rows(source: &str, rows: &[Vec<Span>], columns: bool, context: &Context) -> Vec<Unit> {
    let mut units: Vec<(Range<usize>, Lexed<'_>)> = Vec::new();
    for (at, pieces) in rows.iter().enumerate() {
        let mut lexed = Lexed::default();
        for piece in pieces {
            lexed.append(lex(source, *piece));
        }
        if lexed.tokens.is_empty() {
            continue;
        }
        if columns {
            part_columns(&mut lexed.tokens);
        }
        match units.last_mut() {
            Some((rows, unit)) if continues(&lexed.tokens) => {
                let start = lexed.tokens[0].span.start;
                // `a &= b, \\ &= c`: the comma is that of the line.
                let sign = |kind: Kind| matches!(kind, Kind::Char('+' | '-'));
                let first = lexed.tokens.iter().map(|token| token.kind);
                let mut first = first.filter(|kind| !matches!(kind, Kind::Wide | Kind::Char('&')));
                let comma = |kind: Kind| matches!(kind, Kind::Char(',' | ';'));
                if !first.next().is_some_and(sign)
                    && unit.tokens.last().is_some_and(|last| comma(last.kind))
                {
                    unit.tokens.pop();
                }
                unit.tokens.push(Token {
                    kind: Kind::Row,
                    span: Span::new(start, start),
                    spaced: false,
                });
                unit.append(lexed);
                rows.end = at + 1;
            }
            _ => units.push((at..at + 1, lexed)),
        }
    }
    let read = |(rows, mut lexed): (Range<usize>, Lexed<'_>)| {
        let typed = typed_tag(source, &mut lexed).map(|tag| tag.value);
        let first = lexed.tokens.first().map(|token| token.span);
        let last = lexed.tokens.last().map(|token| token.span);
        let body = first.zip(last).map(|(first, last)| first.to(last));
        let parser = parser(lexed, body.unwrap_or_default(), false);
        let statements = parser.within(context).statements();
        Unit {
            rows,
            typed,
            statements,
        }
    };
    units.into_iter().map(read).collect()
}

/// Makes a mistake of every `&` that aligns nothing.
fn unaligned(mut lexed: Lexed<'_>) -> Lexed<'_> {
    let mut depth = 0_usize;
    for token in &mut lexed.tokens {
        match token.kind {
            Kind::Begin(_) => depth += 1,
            Kind::Finish(_) => depth = depth.saturating_sub(1),
            Kind::Char('&') if depth == 0 => {
                token.kind = Kind::Bad(lexed.errors.len());
                lexed.errors.push(SyntaxError {
                    span: token.span,
                    message: "this `&` aligns nothing here".to_owned(),
                    help: Some(
                        "put the rows into `\\begin{aligned} … \\end{aligned}`; for the word write `\\text{ and }`"
                            .to_owned(),
                    ),
                });
            }
            _ => {}
        }
    }
    lexed
}

/// Reads the formulas of a directive or of inline mathematics, separated by `,`, `;` or the word `and`. The last number of these is in
/// the units of the SI where the text goes on with another one.
pub fn read_formulas(source: &str, body: Span) -> Result<Vec<Statement>, SyntaxError> {
    let mut statements =
        parser(untagged(unaligned(lex(source, body)))?, body, true).statements()?;
    beside::in_si(source, body, &mut statements);
    Ok(statements)
}

/// Reads a single term.
pub fn read_expr(source: &str, body: Span) -> Result<Expr, SyntaxError> {
    parser(untagged(unaligned(lex(source, body)))?, body, true).whole_term()
}

/// Reads a symbol and gives it its canonical name.
pub fn read_symbol(text: &str) -> Result<Symbol, SyntaxError> {
    let span = Span::new(0, text.len());
    match read_expr(text, span)? {
        Expr::Symbol(symbol) => Ok(symbol),
        _ => Err(SyntaxError {
            span,
            message: "this is a term, not a single symbol".to_owned(),
            help: letter_without_backslash(text),
        }),
    }
}

/// What to write where a symbol begins with the name of a letter, without its backslash.
fn letter_without_backslash(text: &str) -> Option<String> {
    let text = text.trim();
    let end = text.find(|c: char| !c.is_ascii_alphabetic());
    let name = &text[..end.unwrap_or(text.len())];
    let letter = commands::find(commands::LETTERS, name)?;
    Some(format!("write `\\{name}` for {letter}"))
}

fn parser(lexed: Lexed<'_>, body: Span, words: bool) -> Parser<'_> {
    Parser::new(signs::apart(fold(&lexed.tokens)), lexed.errors, body, words)
}

fn untagged(lexed: Lexed<'_>) -> Result<Lexed<'_>, SyntaxError> {
    match lexed.tags.first().or(lexed.labels.first()) {
        Some(tag) => Err(SyntaxError {
            span: tag.span,
            message: "only a displayed equation has a number or a key".to_owned(),
            help: None,
        }),
        None => Ok(lexed),
    }
}

/// `\quad (18)` at the end. As a term it would be refused for having no relation, so nothing is misread.
fn typed_tag(source: &str, lexed: &mut Lexed) -> Option<Spanned<String>> {
    let mut end = lexed.tokens.len();
    if matches!(
        lexed.tokens.get(end.checked_sub(1)?)?.kind,
        Kind::Char('.' | ',')
    ) {
        end -= 1;
    }
    let close = lexed
        .tokens
        .get(end.checked_sub(1)?)
        .filter(|token| token.kind == Kind::Char(')'))?;
    let back = |count: usize| -> Option<&Token> { lexed.tokens.get(end.checked_sub(count)?) };
    let lettered = matches!(back(2)?.kind, Kind::Letter(_));
    let first = 2 + usize::from(lettered);
    let (number, open, wide) = (back(first)?, back(first + 1)?, back(first + 2)?);
    let numbered = matches!(number.kind, Kind::Number(_));
    if !numbered || open.kind != Kind::Char('(') || wide.kind != Kind::Wide {
        return None;
    }
    let value = source
        .get(open.span.end..close.span.start)?
        .trim()
        .to_owned();
    let span = open.span.to(close.span);
    let start = end - (first + 2);
    lexed.tokens.drain(start..end);
    Some(Spanned { value, span })
}
