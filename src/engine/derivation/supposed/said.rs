//! What a piece of text says that is supposed: its mathematics, read.

use crate::algebra::{Expr, Formula, Relation, Symbol, element_parts, element_symbol};
use crate::document::Span;
use crate::notation::{Statement, SyntaxError, read_expr, read_formulas, read_symbol};

use super::super::differentials;
use super::super::doubts::{OnPage, doubtful};
use super::super::equation::formulas;
use super::super::page::Page;
use super::super::qualities::named;
use super::super::slopes::without_slashes;
use super::is_term;

/// No more symbols than this are counted up to in `R_1, \ldots, R_4 > 0`.
const MOST_LISTED: u32 = 32;

impl Page {
    /// What words say of how a term, or each of a list, lies to another one: "If $x$ is negative".
    pub(in crate::derivation) fn compared(
        &self,
        (body, relation, to): (Span, Relation, Option<Span>),
    ) -> Result<Vec<(Vec<Formula>, Span)>, SyntaxError> {
        let source = &self.document.source;
        let right = match to {
            Some(to) => read_expr(source, to)?,
            None => Expr::integer(0),
        };
        let listed = named(source, body).into_iter().map(Expr::Symbol);
        let mut of: Vec<Expr> = listed.collect();
        if of.is_empty() {
            of.push(read_expr(source, body)?);
        }
        let formula = |left: Expr| Formula::Relation {
            left,
            relation,
            right: right.clone(),
        };
        Ok(vec![(of.into_iter().map(formula).collect(), body)])
    }

    /// What a text says that is supposed, statement by statement.
    pub(in crate::derivation) fn supposed(
        &self,
        body: Span,
    ) -> Result<Vec<(Vec<Formula>, Span)>, SyntaxError> {
        let source = &self.document.source;
        let mut statements = match self.read_slopes(body) {
            Ok(statements) => statements,
            Err(error) => {
                let bounds = bounds_of_all(source, body).ok_or(error)?;
                return Ok(vec![(bounds, body)]);
            }
        };
        let declared = |name: &Symbol| self.is_declared(name);
        let doubtful = doubtful(&statements, &declared, &OnPage::default());
        if let Some(error) = doubtful.or_else(|| differentials::shown(&statements, declared)) {
            return Err(error);
        }
        self.read_exponentials(statements.iter_mut());
        match statements.iter().find(|s| !s.under.is_empty()) {
            Some(conditional) => Err(SyntaxError {
                span: conditional.span,
                message: "what is supposed here is said under a condition".into(),
                help: Some("suppose the condition first".into()),
            }),
            None => Ok(statements
                .iter()
                .map(|own| (formulas(own), own.span))
                .collect()),
        }
    }

    /// Reads mathematics in the text, slopes with a slash as displays write them: "In the steady state $dc/dt = 0$".
    pub(in crate::derivation) fn read_slopes(
        &self,
        body: Span,
    ) -> Result<Vec<Statement>, SyntaxError> {
        let source = &self.document.source;
        read_formulas(source, body).or_else(|error| {
            let written = self.slopes_written_out(body);
            let written = written.ok_or_else(|| error.clone())?;
            let mut read =
                read_formulas(&written, Span::new(0, written.len())).map_err(|_| error)?;
            read.iter_mut().for_each(|own| own.span = body);
            Ok(read)
        })
    }

    /// The same of a term.
    pub(in crate::derivation) fn read_slope(&self, body: Span) -> Option<Expr> {
        let written = || {
            let written = self.slopes_written_out(body)?;
            read_expr(&written, Span::new(0, written.len())).ok()
        };
        read_expr(&self.document.source, body).ok().or_else(written)
    }

    /// Mathematics in the text with its slopes as displays write them, if it has any with a slash.
    fn slopes_written_out(&self, body: Span) -> Option<String> {
        let source = &self.document.source;
        let written = without_slashes(source, source.get(body.range())?);
        written.filter(|_| !self.is_declared(&Symbol::new("d")))
    }

    /// Whether a text says by terms what symbols are, such as these.
    pub(in crate::derivation) fn explains(
        &self,
        body: Span,
        such: impl Fn(&Symbol) -> bool,
    ) -> bool {
        let said = self.supposed(body).unwrap_or_default();
        let mut said = said.iter().flat_map(|own| &own.0);
        let explains = |formula: &Formula| match formula.as_equation() {
            Some((Expr::Symbol(symbol), value)) => {
                is_term(value) && such(symbol) && !value.mentions(symbol)
            }
            _ => false,
        };
        said.clone().next().is_some() && said.all(explains)
    }

    /// Whether a text says of a quantity that it is another one, such as these: "All of it becomes kinetic energy, $U = K$".
    pub(in crate::derivation) fn links(&self, body: Span, such: impl Fn(&Symbol) -> bool) -> bool {
        let said = self.supposed(body).unwrap_or_default();
        let mut said = said.iter().flat_map(|own| &own.0);
        let links = |formula: &Formula| match formula.as_equation() {
            Some((Expr::Symbol(one), Expr::Symbol(other))) => !such(one) && such(other),
            _ => false,
        };
        said.clone().next().is_some() && said.all(links)
    }
}

/// What one bound says of several symbols: `a, b > 0` or `R_1, \ldots, R_4 > 0`.
fn bounds_of_all(source: &str, body: Span) -> Option<Vec<Formula>> {
    let text = source.get(body.range())?;
    let (names, bound) = text.rsplit_once(',')?;
    let start = body.end - bound.len();
    let statements = read_formulas(source, Span::new(start, body.end)).ok()?;
    let bounds = statements.iter().flat_map(formulas).collect::<Vec<_>>();
    let [
        bound @ Formula::Relation {
            left: Expr::Symbol(last),
            relation,
            ..
        },
    ] = &bounds[..]
    else {
        return None;
    };
    if *relation == Relation::Equal {
        return None;
    }
    let mut all: Vec<Symbol> = Vec::new();
    let mut dots = false;
    for name in names.split(',').map(str::trim) {
        match name {
            "\\ldots" | "\\dots" | "\\cdots" | "\\dotsc" if !dots => dots = true,
            name if !dots => all.push(read_symbol(name).ok()?),
            _ => return None,
        }
    }
    if dots {
        let (stem, from) = element_parts(all.last()?)?;
        let (own, to) = element_parts(last)?;
        if own != stem || to > from + MOST_LISTED {
            return None;
        }
        all.extend((from + 1..to).map(|position| element_symbol(&stem, position)));
    }
    all.push(last.clone());
    let of =
        |name: &Symbol| bound.map_terms(|term| term.substitute(last, &Expr::Symbol(name.clone())));
    Some(all.iter().map(of).collect())
}
