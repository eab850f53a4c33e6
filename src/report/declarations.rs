//! What is left to declare, page by page: a comment that lists the symbols, and a `check:` comment that may be pasted as it
//! is and completed.
//!
//! The same as a `cradle.toml` is in `configuration`.
//!
//! Pasted as it is, it says nothing that the equations do not say already: a dimension that they give is written down,
//! and what they leave open is `real`. A dimension that would make an equation disagree is not proposed.

use crate::algebra::{Dimension, Symbol};
use crate::audit::Dimensions;
use crate::derivation::{Derivation, Page};
use crate::dimension::declared_name;
use crate::kernel::dimension::Form;

use super::beside::place_beside;
use super::dimension::{declared, every_name};
use super::settling::settling;
use super::symbols::{Found, symbols};
use super::{place, words};
use crate::sorted::{Set, Tree};

/// A dimension that can be declared: of which symbol of which page.
type Proposal = (usize, Symbol, Dimension);

/// What there is to say of a page: its symbols in a list, and what is left to declare.
pub(super) struct Listed {
    pub lines: Vec<String>,
    pub clauses: Vec<Clause>,
}

/// A declaration that is proposed.
pub(super) struct Clause {
    pub symbol: Symbol,
    /// What it is declared to be.
    pub text: String,
    /// What is known of it is its dimension; otherwise nothing is, and the text is a place to fill in.
    pub is_known: bool,
}

/// The symbols of each page with what is left to declare, in the comments of its format.
pub fn declarations(derivation: &Derivation) -> String {
    let pages = derivation.pages.iter().zip(listed(derivation));
    let texts = pages.map(|(page, listed)| {
        let clauses = together(&listed.clauses);
        match page.document.is_latex {
            true => in_latex(&listed.lines, &clauses),
            false => in_markdown(&listed.lines, &clauses),
        }
    });
    texts.collect::<Vec<_>>().join("\n")
}

/// A clause for all that are declared to be the same, in the order of the first of them.
fn together(clauses: &[Clause]) -> Vec<String> {
    let mut texts: Vec<&str> = Vec::new();
    let mut names: Tree<&str, Vec<&str>> = Tree::new();
    for clause in clauses {
        let alike = names.entry(&clause.text).or_default();
        if alike.is_empty() {
            texts.push(&clause.text);
        }
        alike.push(clause.symbol.name());
    }
    let clause = |text: &str| format!("symbols {}: {text}", names[text].join(", "));
    texts.into_iter().map(clause).collect()
}

/// What there is to say of each page.
pub(super) fn listed(derivation: &Derivation) -> Vec<Listed> {
    let dimensions = Dimensions::inferred(derivation);
    let pages = 0..derivation.pages.len();
    let found: Vec<Vec<Found>> = pages
        .map(|page| {
            let mut found = symbols(derivation, &dimensions, page);
            // What is declared is a quantity, and real.
            found.retain(|own| !derivation.pages[page].is_imaginary_unit(&own.name));
            found
        })
        .collect();
    let mut proposals: Vec<Proposal> = Vec::new();
    for (page, symbols) in found.iter().enumerate() {
        for symbol in symbols.iter().filter(|s| is_proposed(s)) {
            if let Some((form, false)) = &symbol.dimension
                && let (Some(_), Some(own)) = (declared(form), form.dimension())
            {
                proposals.push((page, symbol.name.clone(), own.clone()));
            }
        }
    }
    let proposed: Set<(usize, Symbol)> = harmless(derivation, proposals)
        .into_iter()
        .map(|(page, symbol, _)| (page, symbol))
        .collect();
    let pages = found.iter().enumerate().map(|(page, symbols)| {
        let is_proposed = |symbol: &Found| proposed.contains(&(page, symbol.name.clone()));
        of_page(derivation, &dimensions, page, symbols, &is_proposed)
    });
    pages.collect()
}

/// Where another page speaks of a symbol, a word here would hide what it says.
fn is_proposed(symbol: &Found) -> bool {
    symbol.nameable && symbol.elsewhere.is_none()
}

/// The proposals with which no equation disagrees that did not before.
fn harmless(derivation: &Derivation, mut proposals: Vec<Proposal>) -> Vec<Proposal> {
    let before = Dimensions::of(derivation);
    // Once more without the pages at fault, and then none.
    for _ in 0..2 {
        let mut pasted = derivation.clone();
        for (page, symbol, dimension) in &proposals {
            pasted.pages[*page]
                .dimensions
                .insert(symbol.clone(), dimension.clone());
        }
        let after = Dimensions::of(&pasted);
        let equations = after.conflicts.keys();
        let equations = equations.filter(|at| !before.conflicts.contains_key(at));
        let mut wrong: Set<usize> = equations
            .map(|(at, _)| derivation.equations[*at].page)
            .collect();
        let supposed = after.suppositions.keys();
        let supposed = supposed.filter(|at| !before.suppositions.contains_key(at));
        wrong.extend(supposed.map(|(page, _)| page));
        if wrong.is_empty() {
            return proposals;
        }
        proposals.retain(|(page, ..)| !wrong.contains(page));
    }
    Vec::new()
}

fn of_page(
    derivation: &Derivation,
    dimensions: &Dimensions,
    page: usize,
    symbols: &[Found],
    is_inferred: &dyn Fn(&Found) -> bool,
) -> Listed {
    let document = &derivation.pages[page].document;
    let rows: Vec<(String, String, String)> = symbols
        .iter()
        .map(|symbol| {
            let (path, at) = document.place(symbol.span);
            let name = words::key(&symbol.name);
            (
                name,
                format!("{path}:{}", at.line),
                said(derivation, dimensions, page, symbol),
            )
        })
        .collect();
    let width = |text: &dyn Fn(&(String, String, String)) -> usize| rows.iter().map(text).max();
    let names = width(&|row| row.0.chars().count()).unwrap_or(0);
    let places = width(&|row| row.1.chars().count()).unwrap_or(0);
    let mut lines = vec![format!("Symbols of {}", document.path)];
    for (name, place, said) in &rows {
        lines.push(format!("  {name:<names$}  {place:<places$}  {said}"));
    }
    let unread = derivation.equations_of(page);
    let unread = unread.filter(|&at| derivation.equations[at].statements.is_err());
    match unread.count() {
        0 => {}
        1 => {
            lines.push("One equation could not be read; what only stands there is missing.".into())
        }
        n => lines.push(format!(
            "{n} equations could not be read; what only stands there is missing."
        )),
    }
    lines.extend(settled(symbols));

    let mut clauses: Vec<Clause> = Vec::new();
    for symbol in symbols.iter().filter(|s| is_inferred(s)) {
        let form = symbol.dimension.as_ref().map(|(form, _)| form);
        clauses.extend(form.and_then(|form| {
            let name = form.dimension().and_then(declared_name);
            let text = name.or_else(|| declared(form))?;
            let text = match counted(&derivation.pages[page], symbol) {
                Some(domain) => format!("{text}, {domain}"),
                None => text,
            };
            Some(Clause {
                symbol: symbol.name.clone(),
                text,
                is_known: true,
            })
        }));
    }
    let open = symbols.iter().filter(|s| {
        let silent = !s.declared && is_proposed(s) && !is_inferred(s);
        silent && !matches!(s.dimension, Some((_, true)))
    });
    let open = open.map(|s| Clause {
        symbol: s.name.clone(),
        text: counted(&derivation.pages[page], s).unwrap_or("real").into(),
        is_known: false,
    });
    let open: Vec<Clause> = open.collect();
    lines.push(match (clauses.is_empty(), open.is_empty()) {
        // A second declaration that says nothing would not help.
        (true, true) if symbols.iter().any(|s| s.declared && lacks_dimension(s)) => {
            "Nothing is left to declare but dimensions; without one a symbol is compared with nothing.".into()
        }
        (true, true) => "Nothing is left to declare.".into(),
        (_, true) => "Below are the dimensions that the equations give.".into(),
        (true, false) => "Below, `real` says nothing: put a dimension and a domain in its place.".into(),
        (false, false) => "Below are the dimensions that the equations give; `real` says nothing: put a dimension and \
                           a domain in its place."
            .into(),
    });
    clauses.extend(open);
    Listed { lines, clauses }
}

/// The domain of a symbol that nobody declares and that can only be a count: what a sum runs to, the index of a recurrence.
fn counted(page: &Page, symbol: &Found) -> Option<&'static str> {
    let domain = page
        .domains
        .get(&symbol.name)
        .filter(|_| !symbol.declared)?;
    let least = domain.lower.as_ref().map(|(least, _)| least.to_string());
    match least.as_deref() {
        _ if !domain.integer => None,
        Some("1") => Some("natural"),
        Some("0") => Some("integer, >= 0"),
        Some(_) => None,
        None => Some("integer"),
    }
}

fn lacks_dimension(symbol: &Found) -> bool {
    let known = symbol
        .dimension
        .as_ref()
        .and_then(|(form, _)| form.dimension());
    known.is_none()
}

/// What is known of a symbol, in words: where a dimension has several usual names, all of them.
fn said(derivation: &Derivation, dimensions: &Dimensions, page: usize, symbol: &Found) -> String {
    let name = |form: &Form| every_name(form, &dimensions.unknowns);
    let known = match &symbol.dimension {
        Some((form, _)) if form.dimension().is_none() => None,
        known => known.as_ref(),
    };
    let at = place_beside(&derivation.pages[page], &symbol.name);
    let at = at.map_or(String::new(), |place| format!(" in {place}"));
    match (symbol.declared, symbol.elsewhere, known) {
        (true, _, Some((form, true))) => format!("declared{at}: {}", name(form)),
        (true, _, Some((form, false))) => {
            format!(
                "declared{at} without a dimension; the equations give {}",
                name(form)
            )
        }
        (true, _, None) => format!("declared{at} without a dimension; none follows"),
        (false, Some(other), _) => format!(
            "not declared here, but in {}",
            derivation.pages[other].document.path
        ),
        (false, None, Some((form, _))) => {
            format!("not declared; the equations give {}", name(form))
        }
        (false, None, None) => "not declared; no dimension follows".into(),
    }
}

/// Which declarations would do.
fn settled(symbols: &[Found]) -> Option<String> {
    let open = symbols.iter().filter_map(|symbol| {
        let (form, _) = symbol.dimension.as_ref()?;
        (!form.unknowns.is_empty()).then_some((symbol, form))
    });
    let (open, forms): (Vec<&Found>, Vec<&Form>) = open.unzip();
    let chosen = settling(&forms);
    if chosen.is_empty() {
        return None;
    }
    let named = |s: &Found| format!("`{}`", words::key(&s.name));
    let first: Vec<String> = chosen.iter().map(|&at| named(open[at])).collect();
    let others = (0..open.len()).filter(|at| !chosen.contains(at));
    let others: Vec<String> = others.map(|at| named(open[at])).collect();
    let (noun, verb) = match first.len() {
        1 => ("dimension", "settles"),
        _ => ("dimensions", "settle"),
    };
    let those = if others.len() == 1 { "that" } else { "those" };
    Some(match others.is_empty() {
        true => format!("Open: the {noun} of {}.", words::list(first)),
        false => format!(
            "The {noun} of {} {verb} {those} of {}.",
            words::list(first),
            words::list(others),
        ),
    })
}

fn in_markdown(lines: &[String], clauses: &[String]) -> String {
    // A path may hold what ends a comment.
    let lines = lines.iter().map(|line| place::one_line(line));
    let lines: Vec<String> = lines.map(|line| line.replace("-->", "-- >")).collect();
    let list = format!("<!-- {}\n-->\n", lines.join("\n"));
    match clauses.is_empty() {
        true => list,
        false => format!("{list}\n<!-- check:\n{}\n-->\n", clauses.join("\n")),
    }
}

fn in_latex(lines: &[String], clauses: &[String]) -> String {
    let mut text = String::new();
    for line in lines {
        text += &format!("% {}\n", place::one_line(line));
    }
    if !clauses.is_empty() {
        text += "% Paste what follows above the first section: there it holds in the whole document.\n\n";
    }
    for (at, clause) in clauses.iter().enumerate() {
        let begin = if at == 0 { "% check: " } else { "%   " };
        text += &format!("{begin}{clause}\n");
    }
    text
}
