//! Functions: the known ones, `\sin x`, and unknown ones applied to bare symbols, `P(t)`.

use std::ops::Range;

use super::group::Delimiter;
use super::vector::refuse_vector;
use super::{Before, BeforeKind, Choice, Factor, Kind, Parser, Read, Shape, refuse, refuse_with};
use crate::algebra::{BigRational, Expr, Function, Symbol};
use crate::notation::figures;
use crate::notation::is_composed_place;
use crate::notation::{commands, latex};
use num_traits::{One, Signed};

impl Parser<'_> {
    /// `P(t)` or `v_0(1 - \mu)`: a function if the parentheses hold nothing but bare symbols.
    pub(super) fn application(&mut self, start: usize, function: Factor) -> Read<Factor> {
        let open = self.at;
        let open_span = self.span();
        let Some(delimiter) = self.delimiter() else {
            return self.no_term();
        };
        let is_applied = self.is_applied(&function.expr) && delimiter.close == ")";
        let mut arguments = Vec::new();
        let mut bare = true;
        self.inside(false, |parser| {
            loop {
                let argument = parser.sum()?;
                let symbol = matches!(argument.expr, Expr::Symbol(_) | Expr::Element { .. });
                bare &= symbol && argument.shape == Shape::Tight;
                arguments.push(argument.expr);
                if parser.peek() != Kind::Char(',') {
                    return Ok(());
                }
                if !bare && !is_applied {
                    return parser.unexpected();
                }
                parser.advance();
            }
        })?;
        self.end_group(&delimiter, open_span)?;
        // No argument holds its own function: `f (1 - f)`.
        let holds_itself = || {
            arguments
                .iter()
                .any(|own| own.any(&|part| *part == function.expr))
        };
        if let Expr::Symbol(name) = &function.expr
            && is_applied
            && !bare
            && !holds_itself()
            && !arguments.iter().any(adds_a_number)
        {
            return self.applied_to(start, name, arguments, BeforeKind::Function);
        }
        if let (Expr::Symbol(name), [place]) = (&function.expr, arguments.as_slice())
            && self.has_values(name)
            && delimiter.close == ")"
            && is_composed_place(place)
        {
            return self.applied_to(start, name, arguments, BeforeKind::Function);
        }
        // `N\,(K - N_0)`: nobody sets a space before an argument.
        let is_set_off = || {
            self.tokens.get(open).is_some_and(|token| token.spaced)
                && delimiter.close == ")"
                && arguments.len() == 1
                && (!bare || self.peek() == Kind::Char('^'))
        };
        if let Expr::Symbol(name) = &function.expr
            && let Some(kind) = match () {
                () if is_set_off() => Some(BeforeKind::Product),
                // Whether it is a quantity elsewhere, the page tells.
                () if self.may_be_multiplied((name, start..open), bare, &delimiter, &arguments) => {
                    Some(BeforeKind::Quantity)
                }
                () => None,
            }
        {
            self.before.push(Before {
                name: name.clone(),
                span: self.since(start),
                kind,
            });
            return self.before_factor(start, open, function, arguments);
        }
        if self.may_be_applied(&function.expr, delimiter.close, bare, &arguments) {
            return self.unclear(start, &function.expr);
        }
        if let Some((name, exponent)) = name_raised(&function.expr) {
            if let Expr::Symbol(own) = name
                && bare
                && arguments.len() == 1
                && matches!(exponent, Expr::Number(own) if own.is_positive())
                && (self.is_applied(name) || self.has_values(own))
            {
                let exponent = exponent.clone();
                let value =
                    self.applied_to(start, &own.clone(), arguments, BeforeKind::Function)?;
                return Ok(Factor {
                    expr: Expr::Power(value.expr.into(), exponent.into()),
                    ..value
                });
            }
            self.refuse_raised(start, name, exponent, (bare, &arguments))?;
            self.before
                .extend(self.factor_before(start, name, &arguments));
            return self.before_factor(start, open, function, arguments);
        }
        match (bare, function.expr) {
            (true, Expr::Symbol(symbol)) => {
                let single = arguments.len() == 1;
                if single {
                    self.choices.push((Choice::Product, self.since(start)));
                }
                if single && self.choice == Some(Choice::Product) {
                    let factor = Factor {
                        expr: Expr::Symbol(symbol),
                        ..function
                    };
                    return self.before_factor(start, open, factor, arguments);
                }
                self.applied_to(start, &symbol, arguments, BeforeKind::Function)
            }
            (true, _) => refuse_with(
                self.since(start),
                "this may be a product or a function",
                "for a product write `\\cdot` before the parenthesis",
            ),
            (false, expr) => {
                if let (Expr::Symbol(name), [Expr::Number(_)]) = (&expr, arguments.as_slice())
                    && !(name.name() == "\\pi" && self.is_measure(open))
                {
                    // Whether there is such a function, the page tells.
                    return self.applied_to(start, name, arguments, BeforeKind::Value);
                }
                self.before
                    .extend(self.factor_before(start, &expr, &arguments));
                self.before_factor(start, open, Factor { expr, ..function }, arguments)
            }
        }
    }

    /// The value of a function, with what is written after the parentheses.
    fn applied_to(
        &mut self,
        start: usize,
        name: &Symbol,
        arguments: Vec<Expr>,
        kind: BeforeKind,
    ) -> Read<Factor> {
        self.before.push(Before {
            name: name.clone(),
            span: self.since(start),
            kind,
        });
        let value = Expr::Apply(name.clone(), arguments.into());
        self.scripts(start, value, Shape::Tight, false)
    }

    /// Whether the page has a name as a function, or one that has primes here.
    fn is_applied(&self, name: &Expr) -> bool {
        let (Expr::Symbol(name), Some(applied)) = (name, self.applied) else {
            return false;
        };
        let without_primes = || Symbol::new(name.name().replace('\'', ""));
        applied.contains(name) || name.name().contains('\'') && applied.contains(&without_primes())
    }

    /// Whether the page gives a function of that name, of which values stand elsewhere.
    fn has_values(&self, name: &Symbol) -> bool {
        self.valued.is_some_and(|valued| valued.contains(name))
    }

    /// Whether the number in the parentheses that opened at `open` is one that is measured: π is multiplied by it, `\pi (0.20)^2`, and profits,
    /// `\pi(50)`, are of whole ones. So it is by one of several, `\pi (3000) (12)`.
    fn is_measure(&self, open: usize) -> bool {
        let number = self.tokens[open..self.at]
            .iter()
            .any(|token| match token.kind {
                Kind::Number(text) => text.contains(['.', '{']),
                Kind::Quantity(..) => true,
                _ => false,
            });
        let many = ['^', '(']
            .into_iter()
            .any(|own| self.peek() == Kind::Char(own));
        // `2 \pi (1450)`
        let before = open.checked_sub(2).map(|before| self.kind(before));
        number || many || matches!(before, Some(Kind::Number(_)))
    }

    /// Whether a reader may take a name for a function of what stands in brackets after it, other than `P(t)`.
    ///
    /// Square ones are those of expectations and functionals, `E[X]`; around a sum they are parentheses too, `m[1 + (a - b)]`.
    fn may_be_applied(&self, name: &Expr, close: &str, bare: bool, arguments: &[Expr]) -> bool {
        let number = matches!(arguments, [Expr::Number(_)]);
        let is = |kind: fn(&str) -> bool| stem(name).is_some_and(|name| kind(name.name()));
        match close {
            ")" => !bare && is(commands::is_word),
            _ => bare || number || is(commands::is_functional),
        }
    }

    /// Whether a letter that is a quantity is multiplied by what stands in brackets after it, though others are applied to it: `P[R + S]`, and
    /// `\alpha(k^*)^2`, where the power needs the parentheses.
    fn may_be_multiplied(
        &self,
        (name, written): (&Symbol, Range<usize>),
        bare: bool,
        delimiter: &Delimiter,
        group: &[Expr],
    ) -> bool {
        let raised = || bare && self.peek() == Kind::Char('^');
        match (delimiter.close, group) {
            ("]", [Expr::Sum(_)]) => matches!(name.name(), "E" | "P"),
            (")", [only]) => raised() && (is_raised(only) || self.is_in_exponent(written)),
            _ => false,
        }
    }

    /// Whether a name of one letter stands by itself in the exponent that comes next: `\alpha (k_G)^{\alpha - 1}`.
    fn is_in_exponent(&self, written: Range<usize>) -> bool {
        let name = self.kind(written.start);
        // `\Delta` begins a longer name.
        let is_name = matches!(name, Kind::Letter(_) | Kind::Command(_));
        if written.len() > 1 || !is_name || name == Kind::Command("Delta") {
            return false;
        }
        let mut depth = 0_usize;
        for at in self.at + 1..self.tokens.len() {
            match self.kind(at) {
                Kind::Open => depth += 1,
                Kind::Close if depth < 2 => return false,
                Kind::Close => depth -= 1,
                // The sign of a differential, `dx`, is no name, nor is that of a derivative, `\frac{d}{dx}`.
                _ if self.is_d(at) && self.starts_name(at + 1) => {}
                _ if self.is_d(at) && at >= 2 && self.at_derivative(at - 2) => {}
                kind if kind == name => {
                    return !matches!(self.kind(at + 1), Kind::Char('(' | '_' | '^'));
                }
                _ if depth == 0 => return false,
                _ => {}
            }
        }
        false
    }

    /// The refusal of a name that may be a function or a factor.
    pub(super) fn unclear<T>(&self, start: usize, name: &Expr) -> Read<T> {
        let name = latex(name);
        let message = format!(
            "whether `{name}` is applied to what follows, or multiplied by it, is not clear"
        );
        let help = format!(
            "for a product write `{name} \\cdot (…)`; functions are read as `f(x)`, of bare symbols"
        );
        refuse_with(self.since(start), message, help)
    }

    /// A name that was read as a factor before a parenthesis.
    fn factor_before(&self, start: usize, name: &Expr, group: &[Expr]) -> Option<Before> {
        let Expr::Symbol(symbol) = name else {
            return None;
        };
        let has = |test: &dyn Fn(&Expr) -> bool| group.iter().any(|part| part.any(&test));
        let applied = has(&|part| matches!(part, Expr::Apply(own, _) if own == symbol));
        let kind = match has(&|part| part == name) && !applied {
            true => BeforeKind::Product,
            false => BeforeKind::Factor,
        };
        Some(Before {
            name: symbol.clone(),
            span: self.since(start),
            kind,
        })
    }

    /// `f^{-1}(x)` may be an inverse function, `f^2(x)` the square of a value.
    fn refuse_raised(
        &self,
        start: usize,
        name: &Expr,
        exponent: &Expr,
        (bare, arguments): (bool, &[Expr]),
    ) -> Read<()> {
        let name = latex(name);
        if is_minus_one(exponent) {
            let message = format!(
                "this may be the inverse function of `{name}`, or a product with `1/{name}`"
            );
            let help = format!(
                "for a product write `\\frac{{1}}{{{name}}}`; inverse functions are not read"
            );
            return refuse_with(self.since(start), message, help);
        }
        // `a^2 (E^*)^2`: such a name needs its parentheses.
        let raised =
            self.peek() == Kind::Char('^') && matches!(arguments, [only] if is_raised(only));
        // `4 \pi^2 (0.800)`: that is a number.
        let is_pi = name == "\\pi" && !bare;
        if (bare || matches!(arguments, [Expr::Number(_)])) && !raised && !is_pi {
            let message =
                format!("this may be a power of the value of a function `{name}`, or a product");
            let help = format!(
                "for a product write `\\cdot` before the parenthesis, for a power of a value `{name}(…)^2`"
            );
            return refuse_with(self.since(start), message, help);
        }
        Ok(())
    }

    /// A name, read as a factor, and the group after it.
    fn before_factor(
        &mut self,
        start: usize,
        open: usize,
        name: Factor,
        mut group: Vec<Expr>,
    ) -> Read<Factor> {
        let Some(content) = group.pop().filter(|_| group.is_empty()) else {
            return refuse(
                self.since(open),
                "the arguments of an unknown function must be bare symbols",
            );
        };
        let span = self
            .tokens
            .get(start..open)
            .and_then(|name| Some(name.first()?.span.to(name.last()?.span)))
            .unwrap_or(self.body);
        // `T \left(\frac{\partial S}{\partial T}\right)_V`
        let content = match content {
            partial @ Expr::Partial { .. } if self.peek() == Kind::Char('_') => {
                self.held_fixed(partial)?
            }
            content => content,
        };
        self.pending = Some(self.scripts(open, content, Shape::Tight, false)?);
        Ok(Factor { span, ..name })
    }

    /// `\sin(x)`, or `\sin 2\pi x`: without parentheses the argument is the run of plain factors, side by side.
    pub(super) fn call(&mut self, name: &str) -> Read<Expr> {
        let angle = matches!(name, "sin" | "cos" | "tan" | "cot" | "sec" | "csc");
        let doubles = commands::is_hyperbolic(name) || commands::is_area(name) || name == "cot";
        if doubles && self.doubled {
            // Each would double what is in it.
            let message = match name {
                "cot" => {
                    "a cotangent inside of another one, or of a hyperbolic function, is not read"
                }
                _ => "a hyperbolic function of another one is not read",
            };
            return refuse_with(self.span(), message, "give the inner one a name");
        }
        let outside = (self.angle, self.doubled);
        (self.angle, self.doubled) = (angle, doubles || self.doubled);
        let of_angle =
            std::mem::replace(&mut self.of_angle, angle || commands::is_hyperbolic(name));
        let call = self.call_inner(name);
        (self.angle, self.doubled) = outside;
        self.of_angle = of_angle;
        call
    }

    fn call_inner(&mut self, name: &str) -> Read<Expr> {
        let start = self.at;
        self.advance();
        let of = match (name, self.peek()) {
            ("log", Kind::Char('_')) => Some(self.base()?),
            ("lg", _) => Some(Expr::integer(10)),
            _ => None,
        };
        let mut power = None;
        if self.peek() == Kind::Char('^') {
            let script = self.superscript()?;
            script.refuse_order()?;
            power = match script.power {
                Some(Expr::Number(n)) if n.is_integer() => Some(Expr::Number(n)),
                Some(exponent) if is_minus_one(&exponent) => {
                    let message = format!(
                        "this may be the inverse function of `\\{name}`, or one divided by its value"
                    );
                    let help = match commands::function(&format!("arc{name}")) {
                        Some(_) => {
                            format!("write `\\arc{name}`, or `\\frac{{1}}{{\\{name} …}}`")
                        }
                        None if commands::is_area(&format!("ar{name}")) => format!(
                            "write `\\operatorname{{ar{name}}}`, or `\\frac{{1}}{{\\{name} …}}`"
                        ),
                        None => format!("for a quotient write `\\frac{{1}}{{\\{name} …}}`"),
                    };
                    return refuse_with(self.since(start), message, help);
                }
                _ => {
                    let help = "put the whole function value in parentheses and raise that";
                    return refuse_with(
                        self.since(start),
                        "this power on a function is ambiguous",
                        help,
                    );
                }
            };
        }
        let is_quantity = matches!(name, "ln" | "log" | "lg") && self.starts_bracketed(self.at);
        let delimiter = if is_quantity { None } else { self.delimiter() };
        let argument = match delimiter {
            Some(delimiter) => {
                let group = self.group(delimiter)?;
                if self.peek() == Kind::Char('^') {
                    let help = "put the whole function value, or its argument, in parentheses";
                    return refuse_with(
                        self.span(),
                        "what this power applies to is not clear",
                        help,
                    );
                }
                match self.of_angle && counts_on(&group) && self.is_plain() {
                    true => {
                        let rest = self.plain_argument()?;
                        Expr::Product([group, rest].into())
                    }
                    false => group,
                }
            }
            None => {
                let argument = self.plain_argument()?;
                if let Expr::Power(base, exponent) = &argument
                    && matches!(&**exponent, Expr::Number(n) if n.is_integer())
                    && power.is_none()
                {
                    self.choices.push((Choice::OfValue, self.since(start)));
                    if self.choice == Some(Choice::OfValue) {
                        let value = called(name, of.as_ref(), (**base).clone());
                        return Ok(Expr::Power(value.into(), exponent.clone()));
                    }
                }
                argument
            }
        };
        let message = "functions of vectors are not read";
        refuse_vector(&argument, self.since(start), message)?;
        let call = called(name, of.as_ref(), argument);
        Ok(match power {
            Some(power) => Expr::Power(call.into(), power.into()),
            None => call,
        })
    }

    /// The base of a logarithm: `_{10}`, `_2`.
    fn base(&mut self) -> Read<Expr> {
        self.advance();
        let span = self.span();
        match self.argument("\\log_")? {
            Expr::Number(base) if base.is_integer() && base > BigRational::one() => {
                Ok(Expr::Number(base))
            }
            _ => refuse_with(
                span,
                "a logarithm is read only with a whole number as its base",
                "write `\\frac{\\ln x}{\\ln b}`",
            ),
        }
    }

    /// Whether `^\circ` stands here.
    pub(super) fn at_degrees(&self) -> bool {
        self.are_degrees_at(self.at)
    }

    /// Whether `^\circ` begins at a token.
    pub(super) fn are_degrees_at(&self, at: usize) -> bool {
        let circ = Kind::Command("circ");
        let next = (self.kind(at + 1), self.kind(at + 2));
        let braced = next == (Kind::Open, circ) && self.kind(at + 3) == Kind::Close;
        self.kind(at) == Kind::Char('^') && (next.0 == circ || braced)
    }

    /// Whether the degrees that stand here are those of a temperature, `25^\circ\mathrm{C}`.
    pub(super) fn at_scale(&self) -> bool {
        self.is_scale(self.at + self.length_of_degrees())
    }

    /// Whether a scale of temperatures is named at a token.
    pub(super) fn is_scale(&self, at: usize) -> bool {
        matches!(
            self.kind(at),
            Kind::Upright("C" | "F") | Kind::Letter('C' | 'F')
        )
    }

    /// How many tokens `^\circ` is.
    pub(super) fn length_of_degrees(&self) -> usize {
        match self.kind(self.at + 1) {
            Kind::Open => 4,
            _ => 2,
        }
    }

    /// `30^\circ` is `30 \pi/180`. Whether π is the number on the page is looked at later.
    pub(super) fn degrees(&mut self, start: usize, number: Expr) -> Factor {
        self.at += self.length_of_degrees();
        self.before.push(Before {
            name: Symbol::new("\\pi"),
            span: self.since(start),
            kind: BeforeKind::Degrees,
        });
        Factor {
            expr: figures::degrees(number),
            shape: Shape::Tight,
            span: self.since(start),
            braces: false,
        }
    }
}

/// The symbol of which a term is a sine, a cosine or a tangent, or of which a hyperbolic function is made.
pub(crate) fn angle_of(term: &Expr) -> Option<&Symbol> {
    match argument_of(term)? {
        Expr::Symbol(angle) => Some(angle),
        _ => None,
    }
}

/// What a term is a sine, a cosine or a tangent of; of the sum that a hyperbolic function is made of, `e^u + e^{-u}`, what that is of.
pub(crate) fn argument_of(term: &Expr) -> Option<&Expr> {
    let exponent = |own: &Expr| match own {
        Expr::Call(Function::Exp, of) => Some(of.clone()),
        _ => None,
    };
    match term {
        Expr::Call(Function::Sin | Function::Cos | Function::Tan, of) => Some(of),
        Expr::Sum(terms) => {
            let [up @ Expr::Call(Function::Exp, of), down] = &terms[..] else {
                return None;
            };
            let down = match down {
                Expr::Negate(inner) => inner,
                own => own,
            };
            let negative = Expr::Negate(exponent(up)?);
            (*exponent(down)? == negative).then_some(of)
        }
        _ => None,
    }
}

/// The value of a function, a logarithm perhaps to a base. Hyperbolic functions are what they are in exponentials, a cotangent and its like
/// what they are in sines and cosines.
fn called(name: &str, base: Option<&Expr>, argument: Expr) -> Expr {
    let call = |function, argument: Expr| Expr::Call(function, argument.into());
    let over = |over: Expr, under: Expr| Expr::Quotient(over.into(), under.into());
    let negative = |term: Expr| Expr::Negate(term.into());
    if let Some(base) = base {
        return over(
            call(Function::Ln, argument),
            call(Function::Ln, base.clone()),
        );
    }
    if let Some(function) = commands::function(name) {
        return call(function, argument);
    }
    let one = || Expr::integer(1);
    if commands::is_area(name) {
        return area(name, argument);
    }
    match name {
        "cot" => {
            let cosine = call(Function::Cos, argument.clone());
            return over(cosine, call(Function::Sin, argument));
        }
        "sec" => return over(one(), call(Function::Cos, argument)),
        "csc" => return over(one(), call(Function::Sin, argument)),
        _ => {}
    }
    let up = call(Function::Exp, argument.clone());
    let down = call(Function::Exp, negative(argument.clone()));
    let difference = Expr::Sum([up.clone(), negative(down.clone())].into());
    let sum = Expr::Sum([up, down].into());
    match name {
        "sinh" => over(difference, Expr::integer(2)),
        "cosh" => over(sum, Expr::integer(2)),
        "coth" => over(sum, difference),
        "sech" => over(Expr::integer(2), sum),
        "csch" => over(Expr::integer(2), difference),
        _ => over(difference, sum),
    }
}

/// The inverse of a hyperbolic function by logarithms, which have values just where it has: `\ln(x + \sqrt{x^2 + 1})` of `arsinh x`.
fn area(name: &str, argument: Expr) -> Expr {
    let one = || Expr::integer(1);
    let minus = |term: Expr| Expr::Negate(term.into());
    let sum = |one: Expr, other: Expr| Expr::Sum([one, other].into());
    let logarithm = |of: Expr| Expr::Call(Function::Ln, of.into());
    let with_root = |by: Expr| {
        let square = Expr::Power(argument.clone().into(), Expr::integer(2).into());
        let half = Expr::Number(BigRational::new(1.into(), 2.into()));
        let root = Expr::Power(sum(square, by).into(), half.into());
        logarithm(sum(argument.clone(), root))
    };
    match name {
        "arsinh" | "arcsinh" => with_root(one()),
        "arcosh" | "arccosh" => with_root(minus(one())),
        _ => {
            let quotient = Expr::Quotient(
                sum(one(), argument.clone()).into(),
                sum(one(), minus(argument)).into(),
            );
            let half = Expr::Quotient(one().into(), Expr::integer(2).into());
            Expr::Product([half, logarithm(quotient)].into())
        }
    }
}

/// The name and the exponent of a power of a name.
pub(super) fn name_raised(expr: &Expr) -> Option<(&Expr, &Expr)> {
    match expr {
        Expr::Power(name, exponent) => match **name {
            Expr::Symbol(_) | Expr::Element { .. } => Some((name, exponent)),
            _ => None,
        },
        _ => None,
    }
}

/// The name that a term consists of, perhaps with a power; of an element, that of its sequence.
pub(in crate::notation) fn stem(expr: &Expr) -> Option<&Symbol> {
    match name_raised(expr).map_or(expr, |(name, _)| name) {
        Expr::Symbol(name) | Expr::Element { sequence: name, .. } => Some(name),
        _ => None,
    }
}

/// Whether what stands in parentheses only counts, `2 k + 1`: no sine is taken of it, but of its multiple of what follows, `\sin(2k + 1) x`.
fn counts_on(term: &Expr) -> bool {
    let is_count = |own: &Symbol| matches!(own.name(), "i" | "j" | "k" | "l" | "m" | "n" | "N");
    let mut number = false;
    let mut summand = |own: &Expr| {
        let own = match own {
            Expr::Negate(inner) => inner,
            own => own,
        };
        let is_number = own.free_symbols().is_empty();
        number |= is_number;
        match own {
            _ if is_number => true,
            Expr::Symbol(own) => is_count(own),
            Expr::Product(factors) => factors.iter().all(|own| match own {
                Expr::Symbol(own) => is_count(own),
                own => matches!(own, Expr::Number(own) if own.is_integer()),
            }),
            _ => false,
        }
    };
    match term {
        Expr::Sum(summands) => summands.iter().all(&mut summand) && number,
        _ => false,
    }
}

/// Whether a power of this name needs parentheses around it.
fn is_raised(name: &Expr) -> bool {
    match name {
        Expr::Symbol(name) | Expr::Element { sequence: name, .. } => {
            name.name().contains(['^', ' '])
        }
        _ => false,
    }
}

/// Whether an exponent is `-1`.
pub(in crate::notation) fn is_minus_one(exponent: &Expr) -> bool {
    match exponent {
        Expr::Number(n) => (-n).is_one(),
        Expr::Negate(inner) => matches!(&**inner, Expr::Number(n) if n.is_one()),
        _ => false,
    }
}

/// Whether a number is added to something: `1 - q` is rather a factor than an argument.
fn adds_a_number(term: &Expr) -> bool {
    let is_number = |own: &Expr| match own {
        Expr::Negate(inner) => matches!(**inner, Expr::Number(_)),
        own => matches!(own, Expr::Number(_)),
    };
    matches!(term, Expr::Sum(summands) if summands.iter().any(is_number))
}
