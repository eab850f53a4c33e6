//! What is said of several names at once: `a, b > 0`.

use super::{Kind, Parser, Read, refuse_with};
use crate::algebra::{Expr, Relation};
use crate::document::Span;
use crate::notation::{Clause, Side, Statement, commands};

/// Nobody lists more.
const MOST_NAMES: usize = 16;

impl Parser<'_> {
    /// The names before the last one of `a, b > 0`, which is left to be read with what is said of it. None where no such list begins here.
    pub(super) fn shared_names(&mut self) -> Vec<Side> {
        let (start, mut names) = (self.at, Vec::new());
        while names.len() < MOST_NAMES && self.is_name_before_comma(names.is_empty()) {
            let from = self.at;
            let Some(side) = self.bare_name() else { break };
            if let Kind::Relation(relation, false) = self.peek() {
                if !names.is_empty() && bounds(relation) {
                    self.at = from;
                    return names;
                }
                break;
            }
            if !self.accept(Kind::Char(',')) {
                break;
            }
            names.push(side);
        }
        self.at = start;
        Vec::new()
    }

    /// A statement about one name as a statement about each of others.
    pub(super) fn of_each(&self, names: &[Side], statement: &Statement) -> Read<Vec<Statement>> {
        let [clause] = statement.clauses.as_slice() else {
            let message = "whether all of this is said of each of these names is not clear";
            return refuse_with(statement.span, message, "write a statement for each");
        };
        let clauses = self.share(names, clause)?.into_iter();
        let about = |(clause, name): (Clause, &Side)| Statement {
            label: None,
            clauses: vec![clause],
            connectives: Vec::new(),
            under: statement.under.clone(),
            mark: None,
            span: name.span.to(statement.span),
            others: Vec::new(),
            before: Vec::new(),
            doubts: Vec::new(),
            runs: Vec::new(),
            quantified: statement.quantified.clone(),
        };
        Ok(clauses.zip(names).map(about).collect())
    }

    /// What is said of one name, said of others too.
    pub(super) fn share(&self, names: &[Side], clause: &Clause) -> Read<Vec<Clause>> {
        let Clause::Chain { sides, links } = clause else {
            return Ok(Vec::new());
        };
        let with = |name: &Side| {
            let mut sides = sides.clone();
            if let Some(first) = sides.first_mut() {
                first.clone_from(name);
            }
            let links = links.clone();
            Clause::Chain { sides, links }
        };
        let alike = links
            .iter()
            .all(|link| !link.questioned && bounds(link.relation));
        match names.first().zip(names.last()) {
            Some((first, last)) if !alike => refuse_with(
                first.span.to(last.span),
                "whether the same is said of all these names is not clear",
                "write a statement for each",
            ),
            _ => Ok(names.iter().map(with).collect()),
        }
    }

    /// Whether a name, with nothing but scripts, and then a comma stand here; or a relation, if that may be.
    fn is_name_before_comma(&self, only_comma: bool) -> bool {
        let mut at = self.at;
        loop {
            at = match self.kind(at) {
                Kind::Char(',') => return at > self.at,
                Kind::Relation(..) => return at > self.at && !only_comma,
                Kind::Char('\'') | Kind::Letter(_) | Kind::Upright(_) => at + 1,
                Kind::Char('_' | '^') => match self.kind(at + 1) {
                    Kind::Open => match self.after_group(at + 1) {
                        Some(after) => after,
                        None => return false,
                    },
                    _ => at + 2,
                },
                Kind::Command(name) if commands::find(commands::LETTERS, name).is_some() => at + 1,
                Kind::Command(name) if commands::find(commands::ACCENTS, name).is_some() => {
                    match self.kind(at + 1) {
                        Kind::Open => match self.after_group(at + 1) {
                            Some(after) => after,
                            None => return false,
                        },
                        _ => at + 1,
                    }
                }
                _ => return false,
            };
        }
    }

    fn bare_name(&mut self) -> Option<Side> {
        let start = self.at;
        let doubts = self.doubts.len();
        let name = self.name().ok().filter(|name| name.power.is_none());
        self.doubts.truncate(doubts);
        let name = name?;
        let ends = matches!(self.peek(), Kind::Char(',') | Kind::Relation(..));
        let span: Span = self.since(start);
        let expr = self.symbol(&name, span).ok()?;
        (ends && matches!(expr, Expr::Symbol(_))).then(|| Side {
            expr,
            span,
            terms: vec![span],
            rounding: None,
            truncated: false,
        })
    }
}

/// Whether a relation says where something lies, and what nothing is equal to.
fn bounds(relation: Relation) -> bool {
    use Relation::{Greater, GreaterOrEqual, Less, LessOrEqual, NotEqual};
    matches!(
        relation,
        Less | LessOrEqual | Greater | GreaterOrEqual | NotEqual
    )
}
