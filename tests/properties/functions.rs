//! Normal forms of functions against functions: each term as it is read agrees with the term as it is written, to the
//! precision of floating point. It proves nothing, and would show a wrong rule.

use cradle_verify::algebra::{
    Atom, Atoms, Expr, Fraction, Function, Functions, Lowering, Polynomial, Powers, Symbol,
};
use cradle_verify::document::Span;
use cradle_verify::notation::read_expr;
use cradle_verify::sorted::{Map, Set};
use num_traits::ToPrimitive;

const TERMS: [&str; 34] = [
    "\\sin(x + y)",
    "\\sin(x - 3 y)",
    "\\cos(-2 x + 5 y)",
    "\\cos(8 x)",
    "\\sin(9 x)",
    "\\sin(-x)",
    "\\cos(x + y + p + q + 1)",
    "\\sin(\\frac{x + y}{2} - \\frac{3 p}{q})",
    "\\tan(x + 2 y)",
    "\\tan(-x)",
    "\\sin(\\frac{7 \\pi}{6} + x)",
    "\\cos(\\frac{5 \\pi}{4} - y)",
    "\\cos(\\frac{\\pi}{5})",
    "\\sin(-\\frac{2 \\pi}{3})",
    "\\cos(11 \\pi)",
    "\\tan(\\frac{\\pi}{3} + x)",
    "\\exp(2 x - \\frac{y}{3} + 1)",
    "\\exp(3 \\ln p - \\frac{\\ln q}{2})",
    "\\exp(x \\ln p)",
    "\\ln \\frac{12 p^3}{5 q}",
    "\\ln(\\frac{p}{p + q})",
    "\\ln(p \\exp(x))",
    "\\ln(\\sqrt{p} q)",
    "\\ln(p^x)",
    "\\ln(\\sqrt{2} p)",
    "|x - y|",
    "|-3 x y^2 p|",
    "|\\frac{x^3}{2 y - 2 x}|",
    "||x| - |y||",
    "\\sqrt{x^2}",
    "\\sqrt{\\frac{4 x^2}{y^4}}",
    "\\sqrt{x^2 - 2 x y + y^2}",
    "(x^2)^{3/2}",
    "\\sqrt{p x^2}",
];

fn value(term: &Expr, at: &Map<&str, f64>) -> f64 {
    let inner = |term: &Expr| value(term, at);
    match term {
        Expr::Number(number) => number.to_f64().expect("a small number"),
        Expr::Symbol(symbol) => at[symbol.name()],
        Expr::Sum(terms) => terms.iter().map(inner).sum(),
        Expr::Product(factors) => factors.iter().map(inner).product(),
        Expr::Negate(term) => -inner(term),
        Expr::Quotient(above, below) => inner(above) / inner(below),
        Expr::Power(base, exponent) => inner(base).powf(inner(exponent)),
        Expr::Call(function, argument) => {
            let argument = inner(argument);
            match function {
                Function::Sin => argument.sin(),
                Function::Cos => argument.cos(),
                Function::Tan => argument.tan(),
                Function::ArcSin => argument.asin(),
                Function::ArcCos => argument.acos(),
                Function::ArcTan => argument.atan(),
                Function::Exp => argument.exp(),
                Function::Ln => argument.ln(),
                Function::Abs => argument.abs(),
                Function::Ceiling => argument.ceil(),
                Function::Floor => argument.floor(),
            }
        }
        other => panic!("no value for {other:?}"),
    }
}

fn value_of(fraction: &Fraction, atoms: &Atoms, at: &Map<&str, f64>) -> f64 {
    let polynomial = |polynomial: &Polynomial| -> f64 {
        let terms = polynomial.terms().map(|(monomial, coefficient)| {
            let number = coefficient.to_big().to_f64().expect("a small number");
            let powers = monomial.powers().iter().map(|&(var, exponent)| {
                let own = match atoms.atom(var) {
                    Atom::Symbol(symbol) => at[symbol.name()],
                    Atom::Root { of, order } => at[of.name()].powf(1.0 / f64::from(*order)),
                    Atom::Opaque(term) => value(term, at),
                    other => panic!("no value for {other:?}"),
                };
                own.powi(exponent as i32)
            });
            number * powers.product::<f64>()
        });
        terms.sum()
    };
    let below: f64 = fraction
        .denominator()
        .map(|(factor, exponent)| polynomial(factor).powi(exponent as i32))
        .product();
    polynomial(fraction.numerator()) / below
}

/// Points spread over both signs of x and y; p and q are positive.
fn points() -> impl Iterator<Item = Map<&'static str, f64>> {
    (1..=24).map(|n| {
        let spread = |step: f64, width: f64| (f64::from(n) * step).fract() * width;
        Map::from([
            ("x", spread(0.618_034, 6.0) - 3.0),
            ("y", spread(0.414_214, 5.0) - 2.5),
            ("p", spread(0.732_051, 3.0) + 0.1),
            ("q", spread(0.236_068, 3.0) + 0.1),
            ("\\pi", std::f64::consts::PI),
        ])
    })
}

fn close(a: f64, b: f64, tolerance: f64) -> bool {
    (a - b).abs() <= tolerance * (1.0 + a.abs().max(b.abs()))
}

/// The readings that there are: with nothing known, with signs known, with powers taken apart.
fn readings() -> [(Option<Functions>, Option<Powers>); 3] {
    let positive: Set<Symbol> = ["p", "q"].into_iter().map(Symbol::new).collect();
    let functions = Functions {
        pi: true,
        positive: positive.clone(),
        ..Functions::default()
    };
    let powers = Powers {
        roots: Map::from([(Symbol::new("p"), 2)]),
        positive,
        ..Powers::default()
    };
    [
        (None, None),
        (Some(functions.clone()), None),
        (Some(functions), Some(powers)),
    ]
}

#[test]
fn what_is_read_agrees_with_what_is_written() {
    let nothing = Set::new();
    let constants = ["y", "p", "q", "\\pi"]
        .into_iter()
        .map(Symbol::new)
        .collect();
    for text in TERMS {
        let term = read_expr(text, Span::new(0, text.len())).expect("a term");
        for (functions, powers) in readings() {
            let mut atoms = Atoms::default();
            let mut lowering = Lowering {
                sequences: &nothing,
                constants: &constants,
                powers: powers.as_ref(),
                functions: functions.as_ref(),
                ..Lowering::plain(&mut atoms)
            };
            let read = lowering.lower(&term).expect("a small term");
            let slope = lowering.lower(&Expr::Derivative {
                body: term.clone().into(),
                variable: Symbol::new("x"),
            });
            let slope = slope.expect("a small term");
            // Of a power with a letter in its exponent no derivative is known.
            let open = |atom: &Atom| matches!(atom, Atom::Opaque(Expr::Derivative { .. }));
            let known = !atoms.iter().any(|(_, atom)| open(atom));
            for at in points() {
                let written = value(&term, &at);
                let own = value_of(&read, &atoms, &at);
                assert!(
                    close(written, own, 1e-8),
                    "{text} at {at:?}: {written}, read as {own}"
                );
                if !known {
                    continue;
                }
                let step = |h: f64| {
                    let mut near = at.clone();
                    near.insert("x", at["x"] + h);
                    value(&term, &near)
                };
                let (h, own) = (1e-6, value_of(&slope, &atoms, &at));
                let (left, right) = ((step(0.0) - step(-h)) / h, (step(h) - step(0.0)) / h);
                // Next to a pole or a kink the quotients of differences disagree themselves.
                if close(left, right, 1e-4) {
                    let mean = (left + right) / 2.0;
                    assert!(
                        close(mean, own, 1e-3),
                        "d/dx {text} at {at:?}: {mean}, {own}"
                    );
                }
            }
        }
    }
}
