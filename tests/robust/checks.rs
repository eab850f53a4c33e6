//! What must be so of any text at all, whoever wrote it.
//!
//! Each function goes as far as the program does and says what is amiss. A panic is amiss too, but is not caught here: the audit
//! itself survives one, so whoever calls must look for it ([`super::panics`] in the tests, the fuzzer's own hook elsewhere).

use std::collections::BTreeSet;
use std::path::Path;

use cradle_verify::algebra::{Expr, Symbol};
use cradle_verify::audit::{Audit, Note};
use cradle_verify::derivation::Derivation;
use cradle_verify::document::{Document, File, Item, Span};
use cradle_verify::notation::{
    Context, latex_statement, mathml_statement, plain_formula, read_display, read_formulas,
    read_on_page,
};
use cradle_verify::report::remark::Known;
use cradle_verify::report::{Report, declarations, github, short};

/// What is amiss, if anything is.
pub type Checked = Result<(), String>;

/// A text in the format that its file's name says.
pub fn file(name: &str, bytes: &[u8]) -> Result<Option<Derivation>, String> {
    let text = match cradle_verify::document::decode(bytes) {
        Ok(text) => text,
        Err(error) if error.to_string().is_empty() => return Err("an error without words".into()),
        Err(_) => return Ok(None),
    };
    let documents = match name.rsplit('.').next() {
        Some("tex") => Document::latex(name, text, &()),
        Some("ipynb") => match Document::notebook(name, text) {
            Ok(document) => vec![document],
            Err(error) if error.to_string().is_empty() => return Err("no words".into()),
            Err(_) => return Ok(None),
        },
        _ => vec![Document::markdown(name, text)],
    };
    for document in &documents {
        places(document)?;
    }
    let derivation = Derivation::new(documents);
    read(&derivation)?;
    Ok(Some(derivation))
}

/// Mathematics by itself: what is read is printed so that it reads the same again.
pub fn notation(source: &str) -> Checked {
    let body = Span::new(0, source.len());
    let display = read_display(source, body);
    match &display.statements {
        Ok(statements) => statements.iter().try_for_each(|s| {
            within(s.span, source)?;
            printed(s)
        })?,
        Err(error) => within(error.span, source)?,
    }
    if let Err(error) = read_formulas(source, body) {
        within(error.span, source)?;
    }
    Ok(())
}

/// An audit to its end, in every format: each equation has its entries, and nobody gave up.
pub fn audit(derivation: &Derivation) -> Checked {
    let audit = Audit::of(derivation);
    for (at, equation) in derivation.equations.iter().enumerate() {
        let entries = audit.of_equation(at);
        let expected = equation.statements().len().max(1);
        // A display of several rows may say nothing in one of them.
        let silent = equation.statements.as_ref().is_ok_and(Vec::is_empty);
        if entries.len() != expected && !silent {
            let (got, tag) = (entries.len(), equation.reference());
            return Err(format!("{got} entries for {expected} statements of {tag}"));
        }
        let gave_up = |note: &Note| matches!(note, Note::GivenUp);
        if entries.iter().any(|e| e.notes.iter().any(gave_up)) {
            return Err(format!("gave up on {}", equation.reference()));
        }
    }
    let paths = ["page.md".to_owned()];
    let report = Report {
        derivation,
        audit: &audit,
        paths: &paths,
    };
    let here = Path::new("");
    let remarks = report.remarks(here, &Known::new());
    let mut shown = vec![report.human(true), short(&remarks), github(&remarks)];
    shown.push(report.junit(&remarks, None, here));
    shown.push(serde_json::to_string(&report.json()).map_err(|e| e.to_string())?);
    shown.push(serde_json::to_string(&report.sarif(&remarks, false)).map_err(|e| e.to_string())?);
    shown.push(declarations(derivation));
    shown.push(report.baseline(here).written());
    shown.extend((0..derivation.equations.len()).map(|at| report.explain(at)));
    match shown.iter().position(String::is_empty) {
        // Where there is nothing to remark these two say nothing.
        Some(at) if !(1..=2).contains(&at) => Err(format!("view {at} is empty")),
        _ => Ok(()),
    }
}

/// Every place is one of the document, and leads to one of a file.
fn places(document: &Document) -> Checked {
    let items = document.items.iter().map(Item::span);
    for span in items.chain(document.problems.iter().map(|p| p.span)) {
        place(document, span)?;
    }
    Ok(())
}

fn place(document: &Document, span: Span) -> Checked {
    within(span, &document.source)?;
    let (file, span): (&File, Span) = document.written_at(span);
    within(span, &file.source)?;
    let position = document.position(span.start);
    match position.line >= 1 && position.column >= 1 {
        true => Ok(()),
        false => Err(format!("{position:?} is no place")),
    }
}

fn within(span: Span, text: &str) -> Checked {
    match text.get(span.range()) {
        Some(_) => Ok(()),
        None => Err(format!("{span:?} is no part of {} bytes", text.len())),
    }
}

/// Every display has become an equation, read or not, and every equation that was read reads the same when printed.
fn read(derivation: &Derivation) -> Checked {
    for (number, page) in derivation.pages.iter().enumerate() {
        let document = &page.document;
        for problem in &page.problems {
            place(document, problem.span)?;
        }
        let own = &derivation.equations[derivation.equations_of(number)];
        for item in &document.items {
            let Item::Display { span, body, .. } = item else {
                continue;
            };
            let inside = |part: Span| span.start <= part.start && part.end <= span.end;
            let from = own.partition_point(|e| e.body.start < span.start);
            if !own.get(from).is_some_and(|e| inside(e.body)) {
                return Err(format!("nothing came of `{}`", document.text(*body)));
            }
        }
        for equation in own {
            place(document, equation.body)?;
            place(document, equation.span)?;
            match &equation.statements {
                Ok(statements) => statements.iter().try_for_each(|s| {
                    place(document, s.span)?;
                    printed(s)
                })?,
                Err(error) => place(document, error.span)?,
            }
        }
    }
    Ok(())
}

/// What is printed reads as what it was.
fn printed(statement: &cradle_verify::notation::Statement) -> Checked {
    let once = latex_statement(statement);
    mathml_statement(statement);
    for formula in cradle_verify::derivation::formulas(statement) {
        plain_formula(&formula);
    }
    // By itself a differential reads as a product: the page shows that it is none.
    let is_differential = |part: &Expr| part.as_differential().is_some();
    let said = cradle_verify::derivation::formulas(statement);
    let mut terms = said.iter().flat_map(|own| own.terms());
    if terms.any(|term| term.any(&is_differential)) {
        return Ok(());
    }
    // So does `B(z - a)`: it reads the same where the page has `B` as a function.
    let mut context = Context::default();
    let terms = said.iter().flat_map(|own| own.terms());
    terms.for_each(|term| collect_applied(term, &mut context.applied));
    let again = read_on_page(&once, Span::new(0, once.len()), false, &context).statements;
    let again = match again {
        Ok(again) => again,
        // The parentheses that are printed around integrals in integrals are a depth more each.
        Err(error) if error.message.contains("nested too deeply") => return Ok(()),
        Err(error) => return Err(format!("printed `{once}`: {}", error.message)),
    };
    let twice: Vec<String> = again.iter().map(latex_statement).collect();
    // That `e` is a number, and so what it is worked out to rounded, may only the page tell.
    let exact = |text: &str| text.replace("\\approx", "=");
    match twice.len() == 1 && exact(&twice[0]) == exact(&once) {
        true => Ok(()),
        false => Err(format!("printed `{once}`, read as {twice:?}")),
    }
}

/// What is applied to more than a name or a number in a term.
fn collect_applied(term: &Expr, found: &mut BTreeSet<Symbol>) {
    let is_plain = |own: &Expr| {
        matches!(
            own,
            Expr::Symbol(_) | Expr::Element { .. } | Expr::Number(_)
        )
    };
    if let Expr::Apply(name, arguments) = term
        && !arguments.iter().all(is_plain)
    {
        found.insert(name.clone());
    }
    term.children()
        .for_each(|part| collect_applied(part, found));
}
