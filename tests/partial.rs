//! Partial derivatives in texts that declare nothing: what is right holds, slips fail, and what may be meant in another way does neither.

use crate::common::last;

/// A step from laws.
fn step(laws: &[&str], goal: &str) -> &'static str {
    let mut text = String::new();
    for (number, law) in (1..).zip(laws) {
        text.push_str(&format!(
            "<!-- check: law -->\n\n$$ {law} \\tag{{{number}}} $$\n\n"
        ));
    }
    last(&format!(
        "{text}From (1) to ({}),\n\n$$ {goal} $$\n",
        laws.len()
    ))
}

#[test]
fn what_stands_under_a_derivative_is_differentiated() {
    let cases = [
        (
            r"\frac{\partial}{\partial v}\left[\frac12 m v^2\right] = m v",
            "holds",
        ),
        (
            r"\frac{\partial}{\partial v}\left[\frac12 m v^2\right] = 2 m v",
            "fails",
        ),
        (r"\partial_x^2 (a x^3 + b x) = 6 a x", "holds"),
        (r"\partial_x^2 (a x^3 + b x) = 6 a x + b", "fails"),
        (
            r"\pdv{\sin(k x - \omega t)}{t} = -\omega \cos(k x - \omega t)",
            "holds",
        ),
        (
            r"\pdv{\sin(k x - \omega t)}{t} = \omega \cos(k x - \omega t)",
            "fails",
        ),
    ];
    for (formula, verdict) in cases {
        assert_eq!(
            last(&format!("Hence\n\n$$ {formula} $$\n")),
            verdict,
            "{formula}"
        );
    }
}

/// In an equation that is to be solved for it, `u` depends on `r`.
#[test]
fn an_unknown_function_is_not_held_fixed() {
    let law = r"\frac{\partial}{\partial r}\left(r^2 u\right) = 0";
    assert_eq!(step(&[law], "u = 0"), "undecided");
    assert_eq!(step(&[law], r"u = \frac{C}{r^2}"), "undecided");
    let continuity = r"\frac{\partial \rho}{\partial t} + \frac{\partial}{\partial x}(\rho u) = 0";
    let product = r"\frac{\partial \rho}{\partial t} + u \frac{\partial \rho}{\partial x} = -\rho \frac{\partial u}{\partial x}";
    assert_eq!(step(&[continuity], product), "holds");
}

#[test]
fn of_a_name_its_formula_is_meant() {
    let energy = r"E = \frac12 m v^2 + \frac12 k x^2";
    assert_eq!(
        step(&[energy], r"\frac{\partial E}{\partial v} = m v"),
        "holds"
    );
    assert_eq!(
        step(&[energy], r"\frac{\partial E}{\partial x} = k x"),
        "holds"
    );
    assert_eq!(
        step(&[energy], r"\frac{\partial E}{\partial x} = 2 k x"),
        "fails"
    );
    assert_eq!(step(&[energy], r"\pdv{E}{x}{v} = 0"), "holds");
    assert_eq!(step(&[energy], r"\pdv{E}{x}{v} = k"), "fails");
    let wave = r"y = A \sin(k x - \omega t)";
    let moves = r"\omega = c k";
    assert_eq!(
        step(&[wave, moves], r"\pdv[2]{y}{t} = c^2 \pdv[2]{y}{x}"),
        "holds"
    );
    assert_eq!(
        step(&[wave, moves], r"\pdv[2]{y}{t} = c \pdv[2]{y}{x}"),
        "fails"
    );
    let force = r"F = -\frac{\partial V}{\partial x}";
    let spring = r"V = \frac12 k x^2";
    assert_eq!(step(&[spring, force], "F = -k x"), "holds");
    assert_eq!(step(&[spring, force], "F = k x"), "fails");
    let function = r"f(x, t) = x^2 t";
    assert_eq!(
        step(&[function], r"\frac{\partial f}{\partial x} = 2 x t"),
        "holds"
    );
    assert_eq!(
        step(&[function], r"\frac{\partial f}{\partial x} = x t"),
        "fails"
    );
}

#[test]
fn the_formula_may_stand_further_on_in_a_chain() {
    let lagrange = r"L = T - V = \frac12 m \dot x^2 - m g x";
    assert_eq!(
        step(
            &[lagrange],
            r"\frac{\partial L}{\partial \dot x} = m \dot x"
        ),
        "holds"
    );
    assert_eq!(
        step(&[lagrange], r"\frac{\partial L}{\partial x} = -m g"),
        "holds"
    );
    assert_eq!(
        step(&[lagrange], r"\frac{\partial L}{\partial x} = m g"),
        "fails"
    );
    // With the mass taken as constant.
    let turned = r"\frac{d}{dt} \frac{\partial L}{\partial \dot x} = m \ddot x";
    assert_eq!(step(&[lagrange], turned), "holds");
}

/// In velocity and in momentum: each is right of its own formula, and nothing fails.
#[test]
fn of_several_formulas_the_one_in_the_variable_is_meant() {
    let both = [r"E = \frac12 m v^2 + V", r"E = \frac{p^2}{2 m} + V"];
    assert_eq!(step(&both, r"\frac{\partial E}{\partial v} = m v"), "holds");
    assert_eq!(
        step(&both, r"\frac{\partial E}{\partial p} = \frac{p}{m}"),
        "holds"
    );
    assert_eq!(
        step(&both, r"\frac{\partial E}{\partial v} = 0"),
        "undecided"
    );
    // At constant temperature the energy of a gas is that.
    let gas = [r"U = \frac32 N k T", r"U = \frac32 p V"];
    assert_eq!(
        step(&gas, r"\frac{\partial U}{\partial V} = 0"),
        "undecided"
    );
}

/// Each holds of its own formula, and nothing follows from both at once: one holds `m` fixed, the other one `p`.
#[test]
fn slopes_of_two_formulas_are_not_equal() {
    let both = [r"E = \frac12 m v^2", r"E = \frac12 p v"];
    assert_eq!(step(&both, r"\frac{\partial E}{\partial v} = m v"), "holds");
    assert_eq!(
        step(&both, r"\frac{\partial E}{\partial v} = \frac{p}{2}"),
        "holds"
    );
    assert_eq!(
        step(&both, r"\frac{\partial E}{\partial v} = 2 m v"),
        "undecided"
    );
    let equal =
        r"m v - \frac{p}{2} = \frac{\partial E}{\partial v} - \frac{\partial E}{\partial v}";
    assert_ne!(step(&both, equal), "holds");
}

/// `V` depends on the velocity, too: the momentum is not `m v`.
#[test]
fn what_else_depends_on_the_variable_leaves_it_open() {
    let laws = [r"L = \frac12 m v^2 - V", r"V = q \phi - q v A"];
    for slope in ["m v", "m v + q A", "m v - q A"] {
        let goal = format!(r"\frac{{\partial L}}{{\partial v}} = {slope}");
        assert_eq!(step(&laws, &goal), "undecided", "{goal}");
    }
}

/// Of `L = T - V` what `T` and `V` are given by.
#[test]
fn summands_that_depend_on_the_variable_are_put_in() {
    let laws = [
        r"T = \frac12 m \dot x^2",
        r"V = \frac12 k x^2",
        r"L = T - V",
    ];
    let cases = [
        (r"\pdv{L}{\dot x} = m \dot x", "holds"),
        (r"\pdv{L}{\dot x} = 2 m \dot x", "fails"),
        (r"\pdv{L}{x} = -k x", "holds"),
        (r"\pdv{L}{x} = k x", "fails"),
    ];
    for (goal, verdict) in cases {
        assert_eq!(step(&laws, goal), verdict, "{goal}");
    }
}

/// Dots are slopes where the equations of Lagrange are spoken of, and a coordinate that a Lagrangian lacks is cyclic.
#[test]
fn equations_of_lagrange() {
    let page = |goal: &str| {
        last(&format!(
            r"In polar coordinates

$$ L = \frac12 m (\dot r^2 + r^2 \dot\theta^2) + \frac{{k}}{{r}} \tag{{1}} $$

with $m$ and $k$ constant. The equations of Lagrange are

$$ \dv{{t}}(\pdv{{L}}{{\dot r}}) = \pdv{{L}}{{r}}, \qquad \dv{{t}}(\pdv{{L}}{{\dot\theta}}) = \pdv{{L}}{{\theta}} \tag{{2}} $$

By (1) and (2)

$$ {goal} $$
"
        ))
    };
    let right = [
        r"m \ddot r = m r \dot\theta^2 - \frac{k}{r^2}",
        r"\dv{t}(m r^2 \dot\theta) = 0",
        r"m r^2 \ddot\theta + 2 m r \dot r \dot\theta = 0",
    ];
    for goal in right {
        assert_eq!(page(goal), "holds", "{goal}");
    }
    let wrong = [
        r"m \ddot r = m r \dot\theta^2 + \frac{k}{r^2}",
        r"\dv{t}(m r \dot\theta) = 0",
        r"m r^2 \ddot\theta + m r \dot r \dot\theta = 0",
    ];
    for goal in wrong {
        assert_ne!(page(goal), "holds", "{goal}");
    }
    let falling = r"L = \frac12 m \dot x^2 - m g x";
    let lagrange = r"\dv{t}(\pdv{L}{\dot x}) - \pdv{L}{x} = 0";
    assert_eq!(step(&[falling, lagrange], r"m \ddot x + m g = 0"), "holds");
    assert_ne!(step(&[falling, lagrange], r"m \ddot x - m g = 0"), "holds");
}

#[test]
fn equations_of_hamilton() {
    let laws = [
        r"H = \frac{p^2}{2 m} + \frac12 k x^2",
        r"\dot x = \pdv{H}{p}, \qquad \dot p = -\pdv{H}{x}",
    ];
    assert_eq!(step(&laws, r"\dot x = \frac{p}{m}"), "holds");
    assert_eq!(step(&laws, r"\dot x = \frac{p}{2 m}"), "fails");
    assert_eq!(step(&laws, r"\dot p = -k x"), "holds");
    assert_eq!(step(&laws, r"\dot p = k x"), "fails");
}

/// `y(x, t)` and `y` are one, and `V(x)` is what `\frac{\partial V}{\partial x}` is taken of.
#[test]
fn arguments_are_left_out_or_put_in() {
    let wave = r"y(x, t) = A \sin(k x - \omega t)";
    assert_eq!(step(&[wave], r"\pdv[2]{y}{x} = -k^2 y"), "holds");
    assert_eq!(step(&[wave], r"\pdv[2]{y}{x} = k^2 y"), "fails");
    let lagrange = r"L = \frac12 m v^2 - V(x)";
    assert_eq!(step(&[lagrange], r"\pdv{L}{v} = m v"), "holds");
    assert_eq!(step(&[lagrange], r"\pdv{L}{x} = -\pdv{V}{x}"), "holds");
    assert_eq!(step(&[lagrange], r"\pdv{L}{x} = -\dv{V(x)}{x}"), "holds");
    assert_ne!(step(&[lagrange], r"\pdv{L}{x} = \pdv{V}{x}"), "holds");
}

/// What is told of a term may be a law, from which nothing is drawn with what is in it held fixed.
#[test]
fn a_law_for_an_unknown_function_is_no_slip() {
    let page = |step: &str| {
        let text = format!(
            r"The field obeys

$$ \frac{{\partial}}{{\partial r}}(r^2 u) = r u \tag{{1}} $$
{step}"
        );
        last(&text)
    };
    assert_eq!(page(""), "given");
    assert_eq!(page("\nThus by (1)\n\n$$ u = 0 $$\n"), "undecided");
    assert_eq!(page("\nThus by (1)\n\n$$ 2 r u = r u $$\n"), "undecided");
}

#[test]
fn uncertainties_are_propagated() {
    let power = r"P = U I";
    let error = r"\Delta P = \abs{\pdv{P}{U}} \Delta U + \abs{\pdv{P}{I}} \Delta I";
    let page = |goal: &str| {
        last(&format!(
            "<!-- check:\nsymbols U, I: positive\n-->\n\n<!-- check: law -->\n\n$$ {power} \\tag{{1}} $$\n\n\
             <!-- check: law -->\n\n$$ {error} \\tag{{2}} $$\n\nBy (1) and (2)\n\n$$ {goal} $$\n"
        ))
    };
    assert_eq!(page(r"\Delta P = I \Delta U + U \Delta I"), "holds");
    assert_eq!(page(r"\Delta P = U \Delta U + I \Delta I"), "fails");
    // A diameter is a variable like any other.
    let density = r"\rho = \frac{4 m}{\pi d^2 h}";
    assert_eq!(
        step(&[density], r"\pdv{\rho}{d} = -\frac{8 m}{\pi d^3 h}"),
        "holds"
    );
}

/// `W` depends on the time, and not by itself.
#[test]
fn what_depends_on_the_variable_unseen_is_left_open() {
    let laws = [r"W = \frac12 k x^2", r"x = A \cos(\omega t)"];
    assert_eq!(
        step(&laws, r"\frac{\partial W}{\partial t} = 0"),
        "undecided"
    );
    let wave = [r"y = A \sin(k x - \omega t)", "x = c t"];
    let at_a_place = r"\frac{\partial y}{\partial t} = -\omega A \cos(k x - \omega t)";
    assert_eq!(step(&wave, at_a_place), "undecided");
    // Where the page differentiates by the place, too, that is another variable.
    let both = [wave[0], wave[1], r"\theta = \frac{\partial y}{\partial x}"];
    assert_eq!(step(&both, at_a_place), "holds");
}

#[test]
fn what_is_told_to_be_held_fixed_is() {
    let entropy = r"S = -\left(\frac{\partial F}{\partial T}\right)_V";
    let pressure = r"p = -\left(\frac{\partial F}{\partial V}\right)_T";
    let maxwell = r"\left(\frac{\partial S}{\partial V}\right)_T = \left(\frac{\partial p}{\partial T}\right)_V";
    assert_eq!(step(&[entropy, pressure], maxwell), "holds");
    let isobar = r"\left(\frac{\partial S}{\partial V}\right)_T = \left(\frac{\partial p}{\partial T}\right)_S";
    assert_eq!(step(&[entropy, pressure], isobar), "undecided");
    // Along an isobar the temperature changes.
    let energy = r"U = a T + b V";
    assert_eq!(
        step(
            &[energy],
            r"\left(\frac{\partial U}{\partial V}\right)_p = b"
        ),
        "undecided"
    );
    // Written in what is told to be varied and held fixed, its other letters are parameters.
    let pressure = r"p = \frac{n R T}{V}";
    let slope = |value: &str| {
        let goal = format!(r"V \left(\frac{{\partial p}}{{\partial V}}\right)_T = {value}");
        step(&[pressure], &goal)
    };
    assert_eq!(slope(r"-\frac{n R T}{V}"), "holds");
    assert_eq!(slope(r"\frac{n R T}{V}"), "fails");
    let gas = "<!-- check:\nsymbols N, k: constant\n-->\n\n<!-- check: law -->\n\n$$ U = \\frac32 N k T \\tag{1} $$\n\nBy (1),\n\n";
    let capacity = |value: &str| {
        last(&format!(
            "{gas}$$ \\left(\\frac{{\\partial U}}{{\\partial T}}\\right)_V = {value} $$\n"
        ))
    };
    assert_eq!(capacity(r"\frac32 N k"), "holds");
    assert_eq!(capacity(r"\frac52 N k"), "fails");
}

#[test]
fn dimensions_are_compared() {
    let page = |side: &str| {
        last(&format!(
            "<!-- check:\nsymbols m: mass\nsymbols v: velocity\nsymbols F: force\nsymbols p: momentum\n-->\n\n\
             <!-- check: law -->\n\n$$ E = \\frac12 m v^2 $$\n\n<!-- check: law -->\n\n\
             $$ \\frac{{\\partial E}}{{\\partial v}} = {side} $$\n"
        ))
    };
    assert_eq!(page("F"), "ill-dimensioned");
    assert_eq!(page("p"), "given");
}

/// `\int f \, dx = F + C` holds if `F` is differentiated to `f`.
#[test]
fn integrals_without_limits() {
    let cases = [
        (r"\int x \, dx = \frac{x^2}{2} + C", "holds"),
        (r"\int x \, dx = x^2 + C", "fails"),
        (
            r"\int \cos(\omega t) \, dt = \frac{\sin(\omega t)}{\omega} + C",
            "holds",
        ),
        (
            r"\int \cos(\omega t) \, dt = \omega \sin(\omega t) + C",
            "fails",
        ),
        (r"\int \frac{dx}{x} = \ln x + C", "holds"),
        (r"\int \frac{dx}{x} = \frac{\ln x}{2} + C", "fails"),
        (r"\int (x + 1)\,dx = \int x\,dx + x + C", "holds"),
        (r"\int (x + 1)\,dx = 2 \int x\,dx + x + C", "fails"),
        (
            r"\int x e^{a x} \, dx = \frac{x}{a} e^{a x} - \frac{1}{a^2} e^{a x} + C",
            "holds",
        ),
    ];
    for (formula, verdict) in cases {
        assert_eq!(
            last(&format!("Hence\n\n$$ {formula} $$\n")),
            verdict,
            "{formula}"
        );
    }
    // A name for it; without what it comes to, it may be meant between limits.
    let named = |end: &str| {
        last(&format!(
            "A body falls with\n\n$$ a = g $$\n\nHence\n\n$$ v = \\int a \\, dt{end} $$\n"
        ))
    };
    assert_eq!(named(" = g t + v_0"), "given");
    assert_eq!(named(" = 2 g t + v_0"), "fails");
    assert_eq!(named(""), "undecided");
}
