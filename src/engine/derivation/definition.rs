//! Definitions: which equations are the first to speak of a symbol, and where the text says what a new symbol means.

use std::collections::BTreeSet;
use std::ops::Range;

use crate::algebra::{Expr, Formula, Place, Relation, Symbol, split_subscript};
use crate::document::{Citation, Span};
use crate::notation::{Clause, Connective, Spanned, Statement, read_expr, read_formulas};

use super::equation::{conditions, first_goal, formulas, of_page};
use super::names::without_dots;
use super::page::{Page, Premises};
use super::running::family;
use super::slopes::TIME;
use super::supposed::{Local, is_number};
use super::{Equation, Kind, counts};
use crate::sorted::{Set, Tree};

/// Leaves only those as definitions whose symbol occurs nowhere before, in reading order, nor in an equation that is supposed
/// where they stand ("Let $x = 2$ and $W = w$"), and notes which symbols are new.
pub(super) fn settle(equations: &mut [Equation], pages: &[Page], constants: &BTreeSet<Symbol>) {
    let mut seen = BTreeSet::new();
    let mut sequences = Sequences::default();
    for (number, page) in pages.iter().enumerate() {
        let own = of_page(number, equations);
        let own = &mut equations[own];
        let mut here = BTreeSet::new();
        let alone = stands_alone(page, own);
        let known = if alone { &mut here } else { &mut seen };
        settle_page(own, page, known, &mut sequences, constants);
        seen.extend(here);
    }
}

/// The same on a page, after what was `seen` before.
fn settle_page(
    equations: &mut [Equation],
    page: &Page,
    seen: &mut BTreeSet<Symbol>,
    sequences: &mut Sequences,
    constants: &BTreeSet<Symbol>,
) {
    // What the text gives as a function is none that displays define.
    let told = page.locals.iter().flat_map(|own| &own.formulas);
    let mut applied = Formula::applied_in(told.flat_map(|own| own.terms()));
    let mut of_display = page.locals.iter().filter(|own| own.of_display).peekable();
    let mut case: Option<Symbol> = None;
    let meant: Vec<Set<Symbol>> = (0..equations.len())
        .map(|at| meant_after(at, equations, page))
        .collect();
    for (equation, mut explained) in equations.iter_mut().zip(meant) {
        // A condition speaks of what it names, be the display of that place or not: "With $w = w_0$ at $x = 0$ the solution is".
        while let Some(own) = of_display.next_if(|own| own.span.end <= equation.span.start) {
            seen.extend(own.names());
        }
        let locals = equation.locals.iter().map(|&local| &page.locals[local]);
        let supposed = locals.flat_map(|local| &local.formulas);
        let supposed = supposed.filter(|formula| formula.as_equation().is_some());
        seen.extend(supposed.flat_map(|formula| formula.names()));
        let mut defines = std::mem::take(&mut equation.defines);
        let mut introduces = Set::new();
        // So do those in rows of their own.
        if equation.row == 0 {
            case = None;
        }
        explained.retain(|own| !seen.contains(own) && !sequences.have(own));
        let mut explains = false;
        for (part, statement) in equation.statements().iter().enumerate() {
            // All cases of a definition define the same symbol.
            let defined = defined_symbol(statement, seen, &applied, case.as_ref());
            // `\text{const} = p V` says something of `p V`.
            let defined = defined
                .filter(|symbol| !sequences.know(symbol, seen) && !constants.contains(symbol));
            // "The magnification $M = -s'/s$ is": the display says what comes of it.
            let told = (defined.as_ref())
                .is_some_and(|symbol| is_told(symbol, statement, equation, (page, seen)));
            explains |= told;
            let defined = defined.filter(|_| !told);
            if defined.is_none() {
                defines.remove(&part);
            }
            case = defined.filter(|_| !statement.under.is_empty());
            for formula in formulas(statement) {
                for symbol in formula.names() {
                    // A dot speaks of the time.
                    if without_dots(&symbol).is_some() {
                        seen.insert(Symbol::new(TIME));
                    }
                    if explained.contains(&symbol) {
                        continue;
                    }
                    let is_new = seen.insert(symbol.clone()) && !sequences.have(&symbol);
                    let is_name = !is_number(&symbol) || page.domains.contains_key(&symbol);
                    if is_new && is_name {
                        introduces.insert(symbol);
                    }
                }
                (formula.terms().into_iter())
                    .for_each(|term| term.collect_applied(&|_| true, &mut applied));
                sequences.learn(&formula);
                if equation.kind == Kind::Given || defines.contains(&part) {
                    sequences.learn_term(&formula, page);
                }
            }
        }
        if equation.statements.is_err() {
            seen.extend(names_in(&page.document.source, equation.body));
        }
        (equation.defines, equation.introduces) = (defines, introduces);
        equation.explained = explained;
        equation.explains = explains;
    }
}

/// The symbols of an equation of which the next display says what they mean, as words between them announce: "where the wavelength is".
fn meant_after(at: usize, equations: &[Equation], page: &Page) -> Set<Symbol> {
    let mut found = Set::new();
    let (own, Some(next)) = (&equations[at], equations.get(at + 1)) else {
        return found;
    };
    let between = own.span.end..next.span.start;
    let between = page.document.source.get(between).unwrap_or_default();
    let words = between.trim_start_matches(|c: char| !c.is_alphabetic());
    let goes_on = words
        .strip_prefix("where")
        .is_some_and(|rest| rest.starts_with(char::is_whitespace) && !rest.contains(". "));
    if !goes_on || next.drawn || own.statements.is_err() {
        return found;
    }
    let names = own.statements().iter().flat_map(formulas);
    let names: Set<Symbol> = names.flat_map(|own| own.names()).collect();
    let left = own.statements().first().and_then(first_goal);
    let left = left.and_then(|goal| match goal.formula.as_equation()?.0 {
        Expr::Symbol(symbol) => Some(symbol.clone()),
        _ => None,
    });
    for goal in next.statements().iter().filter_map(first_goal) {
        if let Some((Expr::Symbol(symbol), value)) = goal.formula.as_equation()
            && names.contains(symbol)
            && left.as_ref() != Some(symbol)
            && !value.mentions(symbol)
            && !left.as_ref().is_some_and(|left| value.mentions(left))
        {
            found.insert(symbol.clone());
        }
    }
    found
}

/// Whether a page goes on from no other: no directive says what its equations follow from, and it cites nothing that is not its own. Its letters are its own, too.
fn stands_alone(page: &Page, own: &[Equation]) -> bool {
    if page.is_annotated() || page.document.is_latex {
        return false;
    }
    let labels = own.iter().flat_map(|e| e.keys.iter().chain(&e.tag));
    let labels: BTreeSet<&String> = labels.collect();
    let is_own = |citation: &Citation| labels.contains(&citation.tag);
    let mut cited = own.iter().map(|equation| &equation.premises);
    cited.all(|cited| match cited {
        Premises::Cited(cited) => cited.iter().all(is_own),
        Premises::Named(_) => false,
    })
}

/// Whether the text has told in passing what a symbol is, or something of all that a statement about it speaks of.
fn is_told(
    symbol: &Symbol,
    statement: &Statement,
    equation: &Equation,
    (page, seen): (&Page, &BTreeSet<Symbol>),
) -> bool {
    // What is gathered here costs something for each equation.
    if equation.told.is_empty() && equation.named.is_empty() {
        return false;
    }
    let formulas_of = |&local: &usize| &page.locals[local].formulas;
    // "The block rises until $m g h = K$, which gives": its height is drawn from that.
    let mut named = equation.named.iter().flat_map(formulas_of);
    if equation.drawn && named.any(|formula| formula.names().contains(symbol)) {
        return true;
    }
    let mut told = equation.told.iter().flat_map(formulas_of);
    let said: Set<Symbol> = formulas(statement)
        .iter()
        .flat_map(Formula::names)
        .collect();
    // "$v^2 = 2 a \ell$. Combining this with (1) yields" tells what the new one is by what is known.
    // Of a root nobody has said yet where it lies what it is taken of.
    let takes_root = |own: &Formula| own.terms().into_iter().any(|term| term.any(&Expr::is_root));
    let has_root = formulas(statement).iter().any(takes_root);
    let ties = |names: &Set<Symbol>| {
        let mut others = names.iter().filter(|own| *own != symbol);
        equation.drawn
            && !has_root
            && names.contains(symbol)
            && others.all(|own| seen.contains(own))
    };
    told.any(|formula| match formula.as_equation() {
        Some((Expr::Symbol(own), _)) if own == symbol => true,
        // "All of it becomes kinetic energy, $U = K$, where" goes on to say what the new one is.
        Some((Expr::Symbol(_), Expr::Symbol(_))) => said.is_subset(&formula.names()),
        Some(_) => said.is_subset(&formula.names()) || ties(&formula.names()),
        None => false,
    })
}

/// The symbols by themselves on a side of what could not be read as a whole: what is said of them is not known, but they are not new.
fn names_in(source: &str, body: Span) -> BTreeSet<Symbol> {
    let text = source.get(body.range()).unwrap_or_default();
    let mut start = body.start;
    let sides = text.split_inclusive(['=', '<', '>', ',', '&']);
    let names = sides.filter_map(|side| {
        let span = Span::new(start, start + side.len() - 1);
        start += side.len();
        match read_expr(source, span) {
            Ok(Expr::Symbol(symbol)) => Some(symbol),
            _ => None,
        }
    });
    names.collect()
}

/// The letters that mostly count something.
const COUNTING: [&str; 7] = ["i", "j", "k", "l", "m", "n", "N"];

/// What is known of sequences, by their names, each with its index.
#[derive(Default)]
struct Sequences(Tree<Symbol, Vec<(Symbol, Sequence)>>);

/// What is known of a sequence.
#[derive(Default)]
struct Sequence {
    /// How many elements it takes to begin a recurrence.
    order: Option<i64>,
    /// All elements are given at once: `L_n = 3 n`.
    whole: bool,
    /// Each element is given in terms of others': `y_n = x_n^2`.
    tied: bool,
}

impl Sequences {
    fn entry(&mut self, stem: Symbol, index: &Symbol) -> &mut Sequence {
        let known = self.0.entry(stem).or_default();
        let at = known.iter().position(|(own, _)| own == index);
        let at = at.unwrap_or_else(|| {
            known.push((index.clone(), Sequence::default()));
            known.len() - 1
        });
        &mut known[at].1
    }

    /// The sequences of which a symbol is an element, each with its index, and its place there.
    fn of(&self, symbol: &Symbol) -> impl Iterator<Item = (&Symbol, &Sequence, Place)> {
        let stem = split_subscript(symbol.name()).map(|(stem, _)| Symbol::new(stem));
        let known = stem
            .and_then(|stem| self.0.get(&stem))
            .into_iter()
            .flatten();
        known.filter_map(|(index, own)| Some((index, own, symbol.place(index)?.1)))
    }

    fn learn_term(&mut self, formula: &Formula, page: &Page) {
        let Some((Expr::Symbol(symbol), right)) = formula.as_equation() else {
            return;
        };
        // `V_R = 4 b R` is the potential at the radius R, and `V_0` no element of anything.
        let counts = |symbol: &Symbol| {
            let declared = page.domains.get(symbol).is_some_and(|own| own.integer);
            declared || COUNTING.contains(&symbol.name())
        };
        for index in right.free_symbols().iter().filter(|own| counts(own)) {
            if let Some(stem) = family(formula, index) {
                self.entry(stem, index).whole = true;
            }
        }
        // `y_n = x_n^2` says what `y_{n+1}` is, but `y_1` may be what the sequence begins with.
        if let Some((_, text)) = split_subscript(symbol.name())
            && let index = Symbol::new(text)
            && index.can_be_index()
            && right.depends_on(&index)
            && let Some((stem, Place::Running(0))) = symbol.place(&index)
        {
            self.entry(stem, &index).tied = true;
        }
    }

    /// Whether a symbol is an element of a sequence of which something is known.
    fn have(&self, symbol: &Symbol) -> bool {
        let mut known = self.of(symbol);
        known.any(|(_, own, _)| own.whole || own.order.is_some())
    }

    fn learn(&mut self, formula: &Formula) {
        for (index, offsets) in counts::recurrences(formula) {
            for (stem, (least, greatest)) in offsets {
                if least < greatest {
                    let order = &mut self.entry(stem, &index).order;
                    *order = Some(order.map_or(greatest - least, |own| own.min(greatest - least)));
                }
            }
        }
    }

    /// Whether a symbol is an element of such a sequence that the recurrence leads to: it needs no definition, though it may
    /// not have been written before. The first so many elements do.
    fn know(&self, symbol: &Symbol, seen: &BTreeSet<Symbol>) -> bool {
        self.of(symbol).any(|(index, own, place)| {
            let given = own.whole && place != Place::Running(0);
            let tied = own.tied && matches!(place, Place::Running(offset) if offset != 0);
            given
                || tied
                || own.order.is_some_and(|order| match place {
                    Place::Running(_) => true,
                    Place::Number(_) => {
                        let stem = symbol.place(index).map(|(stem, _)| stem);
                        let number = |s: &&Symbol| {
                            matches!(s.place(index), Some((own, Place::Number(_))) if Some(&own) == stem.as_ref())
                        };
                        seen.iter().filter(number).count() as i64 >= order
                    }
                    Place::Unclear => false,
                })
        })
    }
}

/// `s`, of `s = …`, or of `s^2 = … = …`, where it has not occurred before, on this page or an earlier one, or in the case before only.
fn defined_symbol(
    statement: &Statement,
    seen: &BTreeSet<Symbol>,
    applied: &Set<Symbol>,
    case: Option<&Symbol>,
) -> Option<Symbol> {
    let Some(Clause::Chain { sides, links }) = statement.clauses.first() else {
        return None;
    };
    let (side, link) = (sides.first()?, links.first()?);
    // An equivalence asserts neither side.
    let is_equivalent = |own: &Spanned<Connective>| own.value == Connective::Equivalent;
    if statement.connectives.iter().any(is_equivalent) {
        return None;
    }
    // Nothing before speaks of it, nor what the statement says of it.
    let unsaid = |symbol: &Symbol| sides.iter().skip(1).all(|side| !side.expr.mentions(symbol));
    let is_new = |symbol: &Symbol| !seen.contains(symbol) && unsaid(symbol);
    let symbol = match &side.expr {
        Expr::Symbol(symbol) => symbol,
        // `B(z) = f(z - d) + f(z + d)`
        Expr::Apply(function, arguments)
            if (!applied.contains(function) || case == Some(function))
                && arguments.iter().all(|own| matches!(own, Expr::Symbol(_))) =>
        {
            function
        }
        // `s^2 = \frac{1}{N} \sum_i (x_i - m)^2 = …` says what a variance is, and goes on.
        Expr::Power(base, exponent) if sides.len() > 2 => match (&**base, &**exponent) {
            (Expr::Symbol(symbol), Expr::Number(_)) => symbol,
            _ => return None,
        },
        // So does `\frac{E_2}{E_1} = \dots` of a ratio, where neither is known.
        Expr::Quotient(over, under) if sides.len() > 2 => match (&**over, &**under) {
            (Expr::Symbol(over), Expr::Symbol(under)) if is_new(under) && over != under => over,
            _ => return None,
        },
        _ => return None,
    };
    // "$\pi = 3.14$" rounds a number; as a name for something else it is defined as others are.
    if symbol.name() == "\\pi"
        && sides
            .iter()
            .skip(1)
            .all(|s| s.expr.free_symbols().is_empty())
    {
        return None;
    }
    let under = conditions(statement);
    let defines = link.relation == Relation::Equal
        && !link.questioned
        && (is_new(symbol) || case == Some(symbol) && !under.is_empty() && unsaid(symbol))
        && !under
            .iter()
            .flat_map(Formula::terms)
            .any(|term| term.mentions(symbol));
    defines.then(|| symbol.clone())
}

/// The symbols of the first so many equations and suppositions of a page, gathered when they are asked for.
#[derive(Default)]
pub(super) struct Known {
    symbols: BTreeSet<Symbol>,
    equations: usize,
    locals: usize,
}

impl Known {
    /// Takes up what is new in the first so many.
    pub fn learn(&mut self, equations: &[Equation], locals: &[Local]) {
        let newer = equations.get(self.equations..).unwrap_or_default();
        self.symbols
            .extend(newer.iter().flat_map(Equation::symbols));
        let newer = locals.get(self.locals..).unwrap_or_default();
        self.symbols.extend(newer.iter().flat_map(Local::names));
        (self.equations, self.locals) = (equations.len(), locals.len());
    }

    /// Whether what was learnt speaks of a symbol.
    pub fn speaks_of(&self, symbol: &Symbol) -> bool {
        self.symbols.contains(symbol)
    }

    /// Whether what stands after a display only says what is meant there: bounds its symbols, or says by `s = …` what a symbol
    /// means that occurs first there. Such an equation can be made true whatever the symbols on its right are, as long as none
    /// of these is what the display defines by it.
    pub fn says_what_is_meant(
        &mut self,
        body: Span,
        page: &Page,
        equations: &[Equation],
        last: Range<usize>,
    ) -> bool {
        let Ok(read) = read_formulas(&page.document.source, body) else {
            return false;
        };
        let said: Vec<Formula> = read.iter().flat_map(formulas).collect();
        let bounds = |formula: &Formula| {
            use Relation::{Greater, GreaterOrEqual, Less, LessOrEqual, NotEqual};
            matches!(
                formula,
                Formula::Relation {
                    relation: NotEqual | Less | LessOrEqual | Greater | GreaterOrEqual,
                    ..
                }
            )
        };
        if !said.is_empty() && said.iter().all(bounds) {
            return true;
        }
        let [
            Formula::Relation {
                left: Expr::Symbol(symbol),
                relation: Relation::Equal,
                right,
            },
        ] = &said[..]
        else {
            return false;
        };
        let occurs = |formula: &Formula| formula.terms().iter().any(|term| term.mentions(symbol));
        // What stands on the left of an equation of the display.
        let defined = |statement: &Statement| match statement.clauses.first() {
            Some(Clause::Chain { sides, .. }) => match sides.first().map(|side| &side.expr) {
                Some(Expr::Symbol(left)) => left == symbol || right.mentions(left),
                _ => false,
            },
            _ => false,
        };
        self.learn(&equations[..last.start], &page.locals);
        let statements = || {
            equations[last.clone()]
                .iter()
                .flat_map(Equation::statements)
        };
        !right.mentions(symbol)
            && statements()
                .flat_map(formulas)
                .any(|formula| occurs(&formula))
            && !self.symbols.contains(symbol)
            && !statements().any(defined)
    }
}
