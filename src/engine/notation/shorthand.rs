//! Abbreviations of the `physics` package and its like, written out: `\dv{x}{t}` is `\frac{dx}{dt}`.
//!
//! Only what abbreviates something that can be written without it is here; it then means what that means, and is refused where
//! that is. The arguments stay where they are: tokens are put in before, between and after them, each with the place of the token that it
//! stands for. One pass, no recursion.

use std::borrow::Cow;

use super::commands;
use super::lexer::{Kind, Token};

/// The most tokens in an order of differentiation, `[2]` or `[n]`.
const LONGEST_ORDER: usize = 4;

/// The most groups after one command: `\pdv{f}{x}{y}`.
const MOST_GROUPS: usize = 3;

/// The tokens with abbreviations written out.
pub(super) fn written_out<'a, 's>(raw: &'a [Token<'s>]) -> Cow<'a, [Token<'s>]> {
    let abbreviates =
        |token: &Token| matches!(token.kind, Kind::Command(name) if meaning(name).is_some());
    if !raw.iter().any(abbreviates) {
        return Cow::Borrowed(raw);
    }
    let closing = super::fold::closing(raw);
    let mut changes = Changes {
        raw,
        closing: &closing,
        instead: vec![None; raw.len()],
    };
    for (at, token) in raw.iter().enumerate() {
        if let Kind::Command(name) = token.kind
            && let Some(meaning) = meaning(name)
        {
            changes.write_out(at, meaning);
        }
    }
    let Changes { instead, .. } = changes;
    let mut out = Vec::with_capacity(raw.len());
    for (token, instead) in raw.iter().zip(instead) {
        match instead {
            None => out.push(*token),
            Some(kinds) => out.extend(kinds.into_iter().map(|kind| Token { kind, ..*token })),
        }
    }
    Cow::Owned(out)
}

/// Whether a command is an abbreviation.
pub(super) fn is_abbreviation(command: &str) -> bool {
    meaning(command).is_some()
}

/// What a command abbreviates.
#[derive(Clone, Copy)]
enum Meaning {
    /// `\dv{x}{t}`, with what stands for the `d`.
    Derivative(Kind<'static>),
    /// `\dd{x}`
    Differential,
    /// `\abs{x}`: delimiters around a group.
    Fences([Kind<'static>; 2]),
    /// `\eval{f}_a^b`
    Evaluated,
    /// `\qty(…)`: a group whose delimiters are written, or `\qty{…}`.
    Group,
    /// `\vb{a}`: another command, and the one that it is with a star.
    Command(&'static str, &'static str),
    /// `\mathop{…}`: spacing around a group.
    Spacing,
    /// `\mathrel{…}`: the same around a sign.
    Sign,
    /// `\textcolor{red}{…}`: ink of another colour.
    Colour,
}

fn meaning(command: &str) -> Option<Meaning> {
    Some(match command {
        "dv" | "derivative" | "odv" => Meaning::Derivative(Kind::Letter('d')),
        "pdv" | "partialderivative" => Meaning::Derivative(Kind::Command("partial")),
        "dd" | "differential" => Meaning::Differential,
        "abs" | "absolutevalue" | "vqty" | "norm" => Meaning::Fences([Kind::Char('|'); 2]),
        "pqty" => Meaning::Fences([Kind::Char('('), Kind::Char(')')]),
        "bqty" => Meaning::Fences([Kind::Char('['), Kind::Char(']')]),
        "Bqty" => Meaning::Fences([Kind::Command("{"), Kind::Command("}")]),
        "eval" | "evaluated" => Meaning::Evaluated,
        "qty" | "quantity" => Meaning::Group,
        "vb" | "vectorbold" => Meaning::Command("mathbf", "boldsymbol"),
        "va" | "vectorarrow" => Meaning::Command("vec", "vec"),
        "vu" | "vectorunit" => Meaning::Command("hat", "hat"),
        "vdot" | "dotproduct" => Meaning::Command("cdot", "cdot"),
        "cross" | "crossproduct" | "cp" => Meaning::Command("times", "times"),
        "flatfrac" => Meaning::Command("frac", "frac"),
        "mathop" | "mathbin" | "mathord" | "mathopen" | "mathclose" | "smash" => Meaning::Spacing,
        "mathrel" => Meaning::Sign,
        "textcolor" | "mathcolor" => Meaning::Colour,
        _ => return None,
    })
}

/// Which tokens become which.
struct Changes<'a, 's> {
    raw: &'a [Token<'s>],
    closing: &'a [Option<usize>],
    /// What stands in the place of each token; `None` where it stays.
    instead: Vec<Option<Vec<Kind<'s>>>>,
}

/// The braces of a group.
type Braces = (usize, usize);

impl<'s> Changes<'_, 's> {
    fn kind(&self, at: usize) -> Kind<'s> {
        self.raw.get(at).map_or(Kind::End, |token| token.kind)
    }

    fn put(&mut self, at: usize, kinds: Vec<Kind<'s>>) {
        self.instead[at] = Some(kinds);
    }

    fn group(&self, at: usize) -> Option<Braces> {
        let close = (*self.closing.get(at)?)?;
        Some((at, close))
    }

    fn write_out(&mut self, at: usize, meaning: Meaning) {
        let starred = self.kind(at + 1) == Kind::Char('*');
        let after = at + 1 + usize::from(starred);
        let first = self.group(after);
        let written = match (meaning, first) {
            (Meaning::Derivative(sign), _) => self.derivative(at, after, sign),
            (Meaning::Differential, Some(group)) => self.differential(at, group),
            (Meaning::Differential, None) => {
                self.put(at, vec![Kind::Upright("d")]);
                true
            }
            (Meaning::Fences([open, close]), Some(group)) => self.fence(at, group, open, close),
            (Meaning::Group, Some(group)) => {
                self.fence(at, group, Kind::Command("{"), Kind::Command("}"))
            }
            (Meaning::Group, None) => self.is_delimiter(after) && self.leave_out(at),
            (Meaning::Evaluated, Some(group)) => {
                self.fence(at, group, Kind::Char('.'), Kind::Char('|'))
            }
            (Meaning::Command(plain, with_star), _) => {
                let command = if starred { with_star } else { plain };
                self.put(at, vec![Kind::Command(command)]);
                true
            }
            (Meaning::Spacing, Some(group)) => self.spacing(at, group),
            (Meaning::Sign, Some((open, close))) => {
                [at, open, close].into_iter().all(|at| self.leave_out(at))
            }
            (Meaning::Colour, Some(group)) => self.coloured(at, group),
            // `\mathrel{\mathop:}=`
            (Meaning::Spacing, None) if self.kind(after) == Kind::Char(':') => self.leave_out(at),
            (
                Meaning::Fences(_)
                | Meaning::Evaluated
                | Meaning::Spacing
                | Meaning::Sign
                | Meaning::Colour,
                None,
            ) => false,
        };
        if starred && written {
            self.leave_out(at + 1);
        }
    }

    fn leave_out(&mut self, at: usize) -> bool {
        self.put(at, Vec::new());
        true
    }

    fn is_delimiter(&self, at: usize) -> bool {
        matches!(
            self.kind(at),
            Kind::Char('(' | '[' | '|') | Kind::Command("{" | "lbrace" | "lbrack" | "lvert")
        )
    }

    /// `\left( … \right)` for a group.
    fn fence(&mut self, at: usize, (open, close): Braces, left: Kind<'s>, right: Kind<'s>) -> bool {
        self.leave_out(at);
        self.put(open, vec![Kind::Command("left"), left]);
        self.put(close, vec![Kind::Command("right"), right]);
        true
    }

    /// `\dv[n]{f}{x}`, `\dv{x}`, `\pdv{f}{x}{y}`.
    fn derivative(&mut self, at: usize, mut after: usize, sign: Kind<'s>) -> bool {
        let mut order = Vec::new();
        if self.kind(after) == Kind::Char('[') {
            let inside = after + 1..after + 2 + LONGEST_ORDER;
            let Some(end) = inside.clone().find(|&at| self.kind(at) == Kind::Char(']')) else {
                return false;
            };
            order = (after + 1..end).map(|at| self.kind(at)).collect();
            (after..=end).for_each(|at| {
                self.leave_out(at);
            });
            after = end + 1;
        }
        let mut groups: Vec<Braces> = Vec::new();
        while groups.len() < MOST_GROUPS
            && let Some(group) = self.group(after)
        {
            groups.push(group);
            after = group.1 + 1;
        }
        let raised = |order: &[Kind<'s>]| {
            let mut power = vec![Kind::Char('^'), Kind::Open];
            power.extend_from_slice(order);
            power.push(Kind::Close);
            match order {
                [] => Vec::new(),
                _ => power,
            }
        };
        let is_partial = sign == Kind::Command("partial");
        let (body, variables) = match groups.as_slice() {
            [variable] => (None, vec![*variable]),
            [body, variable] => (Some(*body), vec![*variable]),
            [body, first, second] if is_partial && order.is_empty() => {
                (Some(*body), vec![*first, *second])
            }
            // What stands third after `\dv{f}{x}` is no argument.
            [body, variable, _] if !is_partial => (Some(*body), vec![*variable]),
            _ => return false,
        };
        let above = match variables.len() {
            1 => raised(&order),
            _ => raised(&[Kind::Number("2")]),
        };
        let mut command = vec![Kind::Command("frac")];
        let mut over = vec![Kind::Open, sign];
        over.extend(above);
        match body {
            None => {
                command.extend(over);
                command.push(Kind::Close);
            }
            Some((open, _)) => self.put(open, over),
        }
        self.put(at, command);
        let last = variables.len() - 1;
        for (number, (open, close)) in variables.into_iter().enumerate() {
            self.put(
                open,
                match number {
                    0 => vec![Kind::Open, sign],
                    _ => vec![sign],
                },
            );
            let mut end = raised(&order);
            if number == last {
                end.push(Kind::Close);
            }
            self.put(close, end);
        }
        true
    }

    /// `\dd{x}`, where the braces hold a single name, so that the page does not show whether they are there.
    fn differential(&mut self, at: usize, (open, close): Braces) -> bool {
        if !self.is_name(open + 1, close) {
            return false;
        }
        self.put(at, vec![Kind::Upright("d")]);
        self.leave_out(open) && self.leave_out(close)
    }

    fn is_name(&self, start: usize, end: usize) -> bool {
        let accents = match self.kind(start) {
            Kind::Command(name) => commands::find(commands::ACCENTS, name).is_some(),
            Kind::Letter(_) | Kind::Upright(_) => false,
            _ => return false,
        };
        let mut at = start + 1;
        if accents {
            at = self.group(at).map_or(at + 1, |group| group.1 + 1);
        }
        while at < end {
            at = match self.kind(at) {
                Kind::Char('\'') => at + 1,
                Kind::Char('_' | '^') => self.group(at + 1).map_or(at + 2, |group| group.1 + 1),
                _ => return false,
            };
        }
        at == end
    }

    /// The braces of what is coloured do not show, so where they cannot be those of a term they go: `\textcolor{red}{= b}`, `\textcolor{red}{- b}`.
    fn coloured(&mut self, at: usize, (open, close): Braces) -> bool {
        self.leave_out(at);
        let is_sign = |kind: Kind| match kind {
            Kind::Char(c) => "+-*/=<>,;.&".contains(c),
            Kind::Command(name) => {
                commands::relation(name).is_some() || matches!(name, "cdot" | "times" | "pm" | "mp")
            }
            _ => false,
        };
        let is_relation = |kind: Kind| match kind {
            Kind::Char(c) => "=<>".contains(c),
            Kind::Command(name) => commands::relation(name).is_some(),
            _ => false,
        };
        let ends = [open + 1, close - 1];
        let mut inside = open + 1;
        let mut states = ends.into_iter().any(|at| is_sign(self.kind(at)));
        while inside < close && !states {
            states = is_relation(self.kind(inside));
            inside = self.group(inside).map_or(inside, |group| group.1) + 1;
        }
        !states || self.leave_out(open) && self.leave_out(close)
    }

    /// `\mathop{}`, `\mathop{\mathrm{d}}`: no more than room around a sign. A word is the name of an operator.
    fn spacing(&mut self, at: usize, (open, close): Braces) -> bool {
        self.leave_out(at);
        if close - open <= 2 {
            self.leave_out(open);
            self.leave_out(close);
        }
        if close - open == 2
            && let Kind::Upright(word) = self.kind(open + 1)
            && word != "d"
        {
            let function = commands::is_function(word);
            let kind = if function {
                Kind::Command(word)
            } else {
                Kind::Operator(word)
            };
            self.put(open + 1, vec![kind]);
        }
        true
    }
}
