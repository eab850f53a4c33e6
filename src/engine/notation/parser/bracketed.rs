//! Quantities whose names are written with brackets: means, `\langle x^2 \rangle`, expectations and chances, `\mathrm{E}[X^2]`, `P(X > 3)`,
//! and concentrations, `[\mathrm{H}^+]`.
//!
//! What stands in the brackets is part of the name, in canonical LaTeX; nothing is known of such a quantity but what the page says of it.
//! So it does not follow what is named in it: where that is bound or runs, `\sum_k P(X = k)`, the statement is refused.

use super::name::charged;
use super::{Doubt, DoubtKind, Kind, Parser, Read, Side, refuse, refuse_with};
use crate::algebra::{Expr, Place, Symbol};
use crate::document::Span;
use crate::notation::{Clause, latex, relation_latex, unit};
use crate::sorted::Set;

/// So many tokens of a group are looked through.
const FAR: usize = 200;
/// Upright words that have a value of what stands in any brackets after them.
const MOMENTS: [&str; 11] = [
    "Bias", "Corr", "Cov", "SD", "Std", "Var", "corr", "cov", "sd", "std", "var",
];
/// Upright words for an expectation.
const EXPECTATIONS: [&str; 2] = ["E", "V"];
/// Upright words for a probability.
const CHANCES: [&str; 3] = ["P", "Pr", "Prob"];

/// A quantity with brackets that was read.
pub(super) struct Bracketed {
    /// Its name, without what is written after the brackets.
    name: String,
    /// The symbols in its brackets.
    inside: Set<Symbol>,
    span: Span,
    /// What would make something else of it.
    doubt: Option<DoubtKind>,
}

/// A name that is applied to the group after it.
struct Applied {
    head: String,
    /// Where the group begins.
    group: usize,
    square: bool,
    /// Whether the name may be a factor elsewhere.
    shy: bool,
}

impl Parser<'_> {
    /// Whether a quantity begins here that does not begin with a letter or a word.
    pub(super) fn starts_bracketed(&self, at: usize) -> bool {
        match self.kind(at + self.left(at)) {
            Kind::Command("langle") => true,
            Kind::Char('[') => self.concentration(at).is_some(),
            Kind::Command("Pr") => self.applied(at).is_some(),
            _ => false,
        }
    }

    /// The name of the quantity with brackets that begins here, if one does; takes it.
    pub(super) fn bracketed(&mut self) -> Read<Option<String>> {
        let start = self.at;
        match self.kind(start + self.left(start)) {
            Kind::Command("langle") => return self.mean().map(Some),
            Kind::Char('[') => {
                let Some((name, end)) = self.concentration(start) else {
                    return Ok(None);
                };
                self.at = end;
                let doubt = self
                    .may_have_unit_in_brackets(start)
                    .then(|| DoubtKind::Concentration(Symbol::new(name.as_str())));
                self.remember(start, &name, Set::new(), doubt);
                return Ok(Some(name));
            }
            _ => {}
        }
        let Some(applied) = self.applied(start) else {
            return Ok(None);
        };
        self.at = applied.group;
        let open = self.span();
        let bars = self.is_parted_by_a_bar(self.at + self.left(self.at));
        let Some(delimiter) = self.delimiter() else {
            return Ok(None);
        };
        let (content, inside) = self.name_inside(bars, "\\mid", true)?;
        self.end_group(&delimiter, open)?;
        let (open, close) = match applied.square {
            true => ('[', ']'),
            false => ('(', ')'),
        };
        let name = format!("{}{open}{content}{close}", applied.head);
        let doubt = applied
            .shy
            .then(|| DoubtKind::Applied(Symbol::new(applied.head)));
        self.remember(start, &name, inside, doubt);
        Ok(Some(name))
    }

    fn remember(
        &mut self,
        start: usize,
        name: &str,
        inside: Set<Symbol>,
        doubt: Option<DoubtKind>,
    ) {
        self.bracketed.push(Bracketed {
            name: name.to_owned(),
            inside,
            span: self.since(start),
            doubt,
        });
    }

    fn left(&self, at: usize) -> usize {
        usize::from(self.kind(at) == Kind::Command("left"))
    }

    /// `\langle x^2 \rangle`, `\langle \psi | H | \psi \rangle`.
    fn mean(&mut self) -> Read<String> {
        let start = self.at;
        let left = self.left(start) == 1;
        self.at += 1 + usize::from(left);
        let open = self.since(start);
        let bars = self.is_parted_by_a_bar(self.at - 1);
        let (content, inside) = self.name_inside(bars, "|", false)?;
        let right = self.peek() == Kind::Command("right");
        match self.kind(self.at + usize::from(right)) {
            Kind::Command("rangle") if right == left => self.at += 1 + usize::from(right),
            Kind::End => return refuse(open, "this is never closed"),
            Kind::Char(',') => {
                return refuse_with(
                    open.to(self.span()),
                    "what these angle brackets mean is not clear",
                    "they are read around one term, as its mean; give a product of two a name of its own",
                );
            }
            _ => return self.unexpected(),
        }
        // `\langle a | b \rangle` is a complex number as a rule.
        let parts: Vec<&str> = content.split(" | ").collect();
        if bars && !(matches!(parts.len(), 2 | 3) && parts.first() == parts.last()) {
            return refuse_with(
                self.since(start),
                "states are not read, but for what something is on average in one",
                "give the number a name of its own",
            );
        }
        let name = format!("\\langle {content} \\rangle");
        self.remember(start, &name, inside, None);
        Ok(name)
    }

    /// `\overline{V^2}`: a mean, too, behind the brace that opened there.
    pub(super) fn mean_below_a_line(&mut self, start: usize, open: Span) -> Read<String> {
        let (content, inside) = self.name_inside(false, "|", false)?;
        self.close(open)?;
        let name = format!("\\overline{{{content}}}");
        self.remember(start, &name, inside, None);
        Ok(name)
    }

    /// What stands in brackets, as a part of a name: a term, or where it may be an event, several with relations, bars and commas between
    /// them. What is in doubt there, or could be read otherwise, changes nothing but the name.
    fn name_inside(&mut self, bars: bool, bar: &str, events: bool) -> Read<(String, Set<Symbol>)> {
        let start = self.at;
        let choice = self.choice.take();
        let so_far = (self.choices.len(), self.before.len(), self.doubts.len());
        let (integrals, primitives) = (self.integrals.len(), self.primitives.len());
        let read = self.inside(bars, |parser| {
            let (mut text, mut parts) = (String::new(), Vec::new());
            loop {
                let part = parser.sum()?.expr;
                text += &latex(&part);
                parts.push(part);
                let sign = match parser.peek() {
                    Kind::Char(',') if events => ",",
                    Kind::Relation(relation, false) if events => relation_latex(relation),
                    Kind::Command("mid") if events => bar,
                    Kind::Command("cap") if events => "\\cap",
                    Kind::Command("cup") if events => "\\cup",
                    Kind::Char('|') | Kind::Command("vert" | "mid") if bars => bar,
                    _ => return Ok((text, parts)),
                };
                text += if sign == "," { "" } else { " " };
                text += sign;
                text += " ";
                parser.advance();
            }
        });
        self.choice = choice;
        let (text, parts) = read?;
        self.choices.truncate(so_far.0);
        self.before.truncate(so_far.1);
        self.doubts.truncate(so_far.2);
        self.integrals.truncate(integrals);
        let mut inside = Set::new();
        for part in &parts {
            inside.append(&mut part.free_symbols());
            let runs = |index: &Symbol| self.bound.iter().any(|own| own == index.name());
            let bound = part.any(&|own| match own {
                Expr::Element { index, .. } => runs(index),
                Expr::Symbol(own) => runs(own),
                _ => false,
            });
            if bound || self.primitives.len() > primitives {
                return refuse_follows(self.since(start));
            }
        }
        let nested = self.bracketed.iter();
        let nested: Vec<_> = nested.filter(|own| text.contains(&own.name)).collect();
        for own in nested {
            inside.extend(own.inside.iter().cloned());
        }
        Ok((text, inside))
    }

    /// A name that is applied to the group after it, with a value that is no product.
    fn applied(&self, at: usize) -> Option<Applied> {
        let (head, after) = match (self.kind(at), self.kind(at + 1)) {
            (Kind::Upright(word) | Kind::Operator(word) | Kind::Text(word), _) => {
                let known = [&MOMENTS[..], &EXPECTATIONS, &CHANCES].concat();
                let known = known.contains(&word);
                (format!("\\text{{{}}}", known.then_some(word)?), at + 1)
            }
            (Kind::Command("Pr"), _) => ("\\text{Pr}".to_owned(), at + 1),
            (Kind::Letter('P'), _) => ("P".to_owned(), at + 1),
            (Kind::Command("mathbb"), Kind::Letter(letter @ ('E' | 'P' | 'V'))) => {
                (format!("\\mathbb{{{letter}}}"), at + 2)
            }
            (Kind::Command("mathbb"), Kind::Open) => match (self.kind(at + 2), self.kind(at + 3)) {
                (Kind::Letter(letter @ ('E' | 'P' | 'V')), Kind::Close) => {
                    (format!("\\mathbb{{{letter}}}"), at + 4)
                }
                _ => return None,
            },
            _ => return None,
        };
        let open = after + self.left(after);
        let round = match self.kind(open) {
            Kind::Char('(') => true,
            Kind::Char('[') => false,
            Kind::Command("{" | "lbrace") => false,
            _ => return None,
        };
        let square = head.ends_with("{E}") || head.ends_with("{V}");
        let bare = matches!(head.as_str(), "P" | "\\text{P}" | "\\text{E}" | "\\text{V}");
        let shy = bare && !matches!(self.kind(at), Kind::Operator(_));
        let chance = bare && !square || head.ends_with("{P}") || head.starts_with("\\text{Pr");
        let spaced = self.tokens.get(after).is_some_and(|own| own.spaced);
        // `P(t)` is a function, `\mathrm{E}(1 + x)` a product.
        let is_value = match (chance, shy) {
            (true, _) => !(shy && spaced) && self.is_event(open),
            (false, true) => !round,
            (false, false) => true,
        };
        is_value.then_some(Applied {
            head,
            group: after,
            square,
            shy,
        })
    }

    /// The tokens of the group that opens here, which are in no other one.
    fn outermost(&self, open: usize) -> impl Iterator<Item = Kind<'_>> {
        let mut depth = 0usize;
        let tokens = (open..open + FAR).map_while(move |at| {
            let kind = self.kind(at);
            match kind {
                Kind::Open | Kind::Char('(' | '[') | Kind::Command("{" | "lbrace" | "langle") => {
                    depth += 1;
                }
                Kind::Close | Kind::Char(')' | ']') | Kind::Command("}" | "rbrace" | "rangle") => {
                    depth = depth.checked_sub(1)?
                }
                Kind::End => return None,
                _ => {}
            }
            (depth > 0).then_some((kind, depth))
        });
        let outer = |(kind, depth)| (depth == 1).then_some(kind);
        tokens.filter_map(outer).skip(1)
    }

    /// Whether what stands in a group can be no factor and no argument: a relation, or several things with a sign of sets between them.
    fn is_event(&self, open: usize) -> bool {
        let signs = |kind| {
            matches!(
                kind,
                Kind::Relation(..) | Kind::Command("mid" | "cap" | "cup")
            )
        };
        self.outermost(open).any(signs) || self.is_parted_by_a_bar(open)
    }

    /// Whether a bare bar parts what stands in a group, and does not open a magnitude.
    fn is_parted_by_a_bar(&self, open: usize) -> bool {
        let bar = |kind: Kind| matches!(kind, Kind::Char('|') | Kind::Command("vert"));
        // `\left|` is that of a magnitude.
        let mut grows = false;
        let bars = self.outermost(open).filter(|kind| {
            let grew =
                std::mem::replace(&mut grows, matches!(kind, Kind::Command("left" | "right")));
            bar(*kind) && !grew
        });
        match bars.count() {
            0 => false,
            1 => true,
            _ => !bar(self.kind(open + 1)),
        }
    }

    /// The name of the concentration that stands here, `[\mathrm{CO_2}]`, and the token after it.
    fn concentration(&self, at: usize) -> Option<(String, usize)> {
        let left = self.left(at);
        let mut at = at + left + 1;
        if let Some(found) = self.element_with_index(at).filter(|_| left == 0) {
            return Some(found);
        }
        let (mut word, mut charge) = (String::new(), String::new());
        let mut in_italics = false;
        loop {
            match (self.kind(at), self.kind(at + 1), self.kind(at + 2)) {
                (Kind::Letter(letter), ..) if self.has_concentrations && charge.is_empty() => {
                    word.push(letter);
                    in_italics = true;
                    at += 1;
                }
                (Kind::Upright(text) | Kind::Text(text), ..) if charge.is_empty() => {
                    let (letters, above) = text.split_once('^').unwrap_or((text, ""));
                    word += &letters.replace(['_', '{', '}'], "");
                    charge += &above.replace(['{', '}'], "");
                    at += 1;
                }
                (Kind::Char('_'), Kind::Number(number), _) if charge.is_empty() => {
                    word += number;
                    at += 2;
                }
                (Kind::Char('_'), Kind::Open, Kind::Number(number))
                    if charge.is_empty() && self.kind(at + 3) == Kind::Close =>
                {
                    word += number;
                    at += 4;
                }
                (Kind::Char('^'), Kind::Char(sign @ ('+' | '-')), _) if charge.is_empty() => {
                    charge.push(sign);
                    at += 2;
                }
                (Kind::Char('^'), Kind::Open, _) if charge.is_empty() => {
                    at += 2;
                    if let Kind::Number(number) = self.kind(at) {
                        charge += number;
                        at += 1;
                    }
                    let (Kind::Char(sign @ ('+' | '-')), Kind::Close) =
                        (self.kind(at), self.kind(at + 1))
                    else {
                        return None;
                    };
                    charge.push(sign);
                    at += 2;
                }
                _ => break,
            }
        }
        let right = usize::from(self.kind(at) == Kind::Command("right"));
        let closes = right == left && self.kind(at + right) == Kind::Char(']');
        let capital = word.starts_with(|c: char| c.is_ascii_uppercase());
        let is_name = word.chars().all(char::is_alphanumeric)
            && word.starts_with(char::is_alphabetic)
            && (capital || word.chars().count() > 1 && unit::read(&word).is_err());
        // In italics what begins with a small letter is one like any other.
        let is_name = is_name && (capital || !in_italics);
        let name = || format!("[{}]", charged(&word, &charge));
        (closes && is_name).then(|| (name(), at + right + 1))
    }

    /// The name of the concentration of an element in italics, `Na]_o`, and the token after its bracket. Brackets with an index alone are
    /// nothing else: those around what is evaluated have a limit above, too.
    fn element_with_index(&self, at: usize) -> Option<(String, usize)> {
        let Kind::Letter(first) = self.kind(at) else {
            return None;
        };
        let second = match self.kind(at + 1) {
            Kind::Letter(letter) if letter.is_ascii_lowercase() => Some(letter),
            _ => None,
        };
        let close = at + 1 + usize::from(second.is_some());
        let has_index = first.is_ascii_uppercase()
            && self.kind(close) == Kind::Char(']')
            && self.kind(close + 1) == Kind::Char('_');
        // A group of one token is that token.
        let after = self.after_group(close + 2).filter(|_| has_index)?;
        let word: String = [Some(first), second].into_iter().flatten().collect();
        (self.kind(after) != Kind::Char('^'))
            .then(|| (format!("[{}]", charged(&word, "")), close + 1))
    }

    /// Whether what stands in brackets here may be the unit of the name or the number before it: `I\,[\mathrm{A}]`.
    fn may_have_unit_in_brackets(&self, at: usize) -> bool {
        let Some(before) = at.checked_sub(1) else {
            return false;
        };
        let word = match self.kind(at + self.left(at) + 1) {
            Kind::Upright(word) | Kind::Text(word) => word,
            _ => return false,
        };
        let follows = match self.kind(before) {
            // A differential, `d[\mathrm{A}]`.
            Kind::Letter('d') => false,
            Kind::Number(_) | Kind::Close => true,
            _ => self.starts_name(before),
        };
        follows && unit::read(word).is_ok()
    }

    /// Refuses a statement in which something in brackets is bound or runs, and doubts what may be no quantity.
    pub(super) fn end_bracketed<'c>(
        &mut self,
        clauses: impl Iterator<Item = &'c Clause>,
    ) -> Read<()> {
        let all = std::mem::take(&mut self.bracketed);
        if all.is_empty() {
            return Ok(());
        }
        let sides = clauses.flat_map(|clause| match clause {
            Clause::Chain { sides, .. } => sides.iter().collect::<Vec<&Side>>(),
            Clause::AllEqual { value, .. } => value.iter().collect(),
        });
        let mut moved: Set<Symbol> = self.runs.iter().map(|run| run.symbol.clone()).collect();
        moved.extend(self.quantified.iter().cloned());
        for side in sides {
            collect_moved(&side.expr, &all, &mut moved);
        }
        for own in &all {
            let follows = |name: &Symbol| {
                let mut moved = moved.iter();
                moved.any(|index| name == index || name.place(index).is_some_and(speaks_of_it))
            };
            if own.inside.iter().any(follows) {
                return refuse_follows(own.span);
            }
        }
        let sure = |own: &&Bracketed| own.doubt.is_none();
        let sure: Set<&str> = all.iter().filter(sure).map(|own| &*own.name).collect();
        for own in &all {
            if let Some(kind) = own.doubt.clone()
                && !sure.contains(&*own.name)
            {
                self.doubts.push(Doubt {
                    span: own.span,
                    kind,
                });
            }
        }
        Ok(())
    }
}

fn speaks_of_it((_, place): (Symbol, Place)) -> bool {
    !matches!(place, Place::Number(_))
}

fn refuse_follows<T>(span: Span) -> Read<T> {
    let message = "this depends on what runs or is bound around it, so it is no one quantity";
    refuse_with(
        span,
        message,
        "give it a name with an argument, as in `F(x)`",
    )
}

/// The symbols by which quantities with brackets in them are differentiated, summed, integrated, or that are arguments beside them.
fn collect_moved(expr: &Expr, all: &[Bracketed], moved: &mut Set<Symbol>) {
    if let Some(variable) = expr.binder()
        && expr.any(&|part| matches!(part, Expr::Symbol(own) if own.is_bracketed()))
    {
        moved.insert(variable.clone());
    }
    // `P(A)` beside `P(A \mid B)` speaks of no other event.
    let of_all = |name: &Symbol| {
        let mut all = all.iter();
        all.any(|own| {
            let rest = own.name.strip_prefix(name.name());
            rest.is_some_and(|rest| rest.starts_with(['(', '[']))
        })
    };
    if let Expr::Apply(function, arguments) = expr
        && !of_all(function)
    {
        for argument in &**arguments {
            moved.append(&mut argument.free_symbols());
        }
    }
    expr.children()
        .for_each(|part| collect_moved(part, all, moved));
}
