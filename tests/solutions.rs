//! Laws of change and what is made of them: slopes of what dots stand above, values at places, solutions with these values.

use cradle_verify::audit::Audit;
use cradle_verify::derivation::Derivation;

use crate::common::{last, verdicts};

/// Dots on what the text makes of others that have dots are slopes, as theirs are.
#[test]
fn dots_on_what_is_made_of_what_moves() {
    let masses = "The equations of motion are\n\n$$ m \\ddot{x}_1 = -k x_1 - c (x_1 - x_2) \\tag{1} $$\n\n$$ m \\ddot{x}_2 = -k x_2 - c (x_2 - x_1) \\tag{2} $$\n\n";
    let step = |words: &str, formula: &str| last(&format!("{masses}{words}\n\n$$ {formula} $$\n"));
    for (words, right, wrong) in [
        (
            "Define $s = x_1 + x_2$. The sum of (1) and (2) gives",
            r"m \ddot{s} = -k s",
            r"m \ddot{s} = -2 k s",
        ),
        (
            "Let $d = x_1 - x_2$. Subtracting (2) from (1) gives",
            r"m \ddot{d} = -(k + 2 c) d",
            r"m \ddot{d} = -(k + c) d",
        ),
        (
            "With the mean $X = \\frac12 (x_1 + x_2)$ we get from (1) and (2)",
            r"\ddot X = -\frac{k}{m} X",
            r"\ddot X = \frac{k}{m} X",
        ),
    ] {
        assert_eq!(step(words, right), "holds", "{right}");
        assert_eq!(step(words, wrong), "fails", "{wrong}");
    }
    let bob = "The height is\n\n$$ h = \\ell (1 - \\cos\\theta) $$\n\nThe acceleration is thus\n\n";
    let step = |formula: &str| last(&format!("{bob}$$ {formula} $$\n"));
    assert_eq!(
        step(r"\ddot h = \ell \ddot\theta \sin\theta + \ell \dot\theta^2 \cos\theta"),
        "holds"
    );
    assert_ne!(
        step(r"\ddot h = \ell \ddot\theta \sin\theta - \ell \dot\theta^2 \cos\theta"),
        "holds"
    );
    // A Lagrangian is differentiated by what has a dot as by a name.
    let polar = "The bob has the coordinates\n\n$$ x = \\ell \\sin\\theta, \\qquad y = -\\ell \\cos\\theta $$\n\nwith constant $\\ell$. Its kinetic energy $T = \\frac12 m (\\dot x^2 + \\dot y^2)$ does not depend on $\\ddot\\theta$. The Lagrangian is\n\n$$ L = \\frac12 m \\ell^2 \\dot\\theta^2 + m g \\ell \\cos\\theta \\tag{1} $$\n\nHence\n\n$$ \\frac{\\partial L}{\\partial \\dot\\theta} = m \\ell^2 \\dot\\theta $$\n";
    assert_eq!(last(polar), "holds");
    assert_ne!(
        last(&polar.replace("= m \\ell^2", "= 2 m \\ell^2")),
        "holds"
    );
    // A flow need not be the slope of what has its letter.
    let heat = "The heat is\n\n$$ Q = m c T $$\n\nand the power\n\n$$ \\dot Q = \\dot m c T $$\n";
    assert_eq!(verdicts(heat), ["given", "given"]);
}

const SLOPE: &str = "The slope is\n\n$$ \\frac{dw}{dx} = a x $$\n\n";

/// A law of change leaves open which solution is meant; that the text tells by a value at a place.
#[test]
fn the_solution_with_a_value_at_a_place() {
    let words = [
        "Integrating, with $w = 0$ at $x = b$, we get",
        "Integrating, with $w = 0$ at the wall $x = b$, we get",
        "The film is fixed at the wall, $w = 0$ at $x = b$, so integrating gives",
        "At the wall $x = b$ we have $w = 0$. Integration yields",
        "Integrating from the wall $x = b$, where $w = 0$, we obtain",
        "Suppose that $w = 0$ at $x = b$. Then",
    ];
    for words in words {
        let step = |formula: &str| last(&format!("{SLOPE}{words}\n\n$$ {formula} $$\n"));
        assert_eq!(step(r"w = \frac{a}{2} (x^2 - b^2)"), "holds", "{words}");
        for wrong in [r"w = \frac{a}{2} (x^2 + b^2)", r"w = a (x^2 - b^2)"] {
            assert_eq!(step(wrong), "fails", "{words} {wrong}");
        }
        // It obeys the law, and is 0 at `x = b` only where `b` is.
        assert_ne!(step(r"w = \frac{a}{2} x^2"), "holds", "{words}");
    }
    let start = "If $w = w_0$ when $x = b$, then integration gives\n\n";
    let step = |formula: &str| last(&format!("{SLOPE}{start}$$ {formula} $$\n"));
    assert_eq!(step(r"w = w_0 + \frac{a}{2} (x^2 - b^2)"), "holds");
    assert_eq!(step(r"w = w_0 + \frac{a}{2} (b^2 - x^2)"), "fails");
}

/// Integrating twice takes a value of the slope first.
#[test]
fn values_of_slopes_at_a_place() {
    let rod = |once: &str, twice: &str| {
        verdicts(&format!(
            "The law is\n\n$$ B \\frac{{d^2 y}}{{dx^2}} = F (L - x) \\tag{{1}} $$\n\nThe rod is horizontal at the clamp, $dy/dx = 0$ at $x = 0$, so integrating (1) once gives\n\n$$ B \\frac{{dy}}{{dx}} = F \\left( {once} \\right) $$\n\nand integrating again, with $y = 0$ at $x = 0$,\n\n$$ B y = F \\left( {twice} \\right) $$\n"
        ))
    };
    let (once, twice) = (r"L x - \frac{x^2}{2}", r"\frac{L x^2}{2} - \frac{x^3}{6}");
    assert_eq!(rod(once, twice), ["given", "holds", "holds"]);
    assert_eq!(rod(r"L x + \frac{x^2}{2}", twice)[1], "fails");
    assert_ne!(rod(r"L x - \frac{x^2}{2} + L^2", twice)[1], "holds");
    assert_ne!(rod(once, r"\frac{L x^2}{2} - \frac{x^3}{3}")[2], "holds");
}

/// Solutions of linear laws differ by a constant times an exponential.
#[test]
fn solutions_with_exponentials() {
    let from = |law: &str, words: &str, formula: &str| {
        last(&format!(
            "The law is\n\n$$ {law} $$\n\n{words}\n\n$$ {formula} $$\n"
        ))
    };
    let decay = |words: &str, formula: &str| from(r"\frac{dA}{dt} = -k A", words, formula);
    for words in [
        "With $A = A_0$ at $t = 0$ the solution is",
        "With $A(0) = A_0$ we get",
        "Initially, at $t = 0$, the amount is $A = A_0$. Hence",
    ] {
        assert_eq!(decay(words, "A = A_0 e^{-k t}"), "holds", "{words}");
        for wrong in [
            "A = A_0 e^{-2 k t}",
            "A = 2 A_0 e^{-k t}",
            "A = A_0 e^{k t}",
        ] {
            assert_ne!(decay(words, wrong), "holds", "{words} {wrong}");
        }
    }
    let cooling = |formula: &str| {
        let law = r"\frac{dA}{dt} = k (c - A)";
        from(law, "With $A = A_0$ at $t = 0$ the solution is", formula)
    };
    assert_eq!(cooling("A = c + (A_0 - c) e^{-k t}"), "holds");
    assert_ne!(cooling("A = c + (A_0 - c) e^{k t}"), "holds");
    assert_ne!(cooling("A = c - (A_0 - c) e^{-k t}"), "holds");
}

/// Of several values the solution need have one; those that the text tells last count, where it tells any before the display.
#[test]
fn several_values_at_places() {
    let step = |words: &str, formula: &str| last(&format!("{SLOPE}{words}\n\n$$ {formula} $$\n"));
    let both = "With $w = w_0$ at $x = 0$ and $w = w_1$ at $x = L$ we get";
    assert_eq!(step(both, r"w = w_0 + \frac{a}{2} x^2"), "holds");
    assert_ne!(step(both, r"w = w_0 - \frac{a}{2} x^2"), "holds");
    let first = "With $w = 0$ at $x = 0$ we get\n\n$$ w = \\frac{a}{2} x^2 $$\n\nIf instead $w = u$ at $x = s$, integration of the slope gives";
    assert_eq!(step(first, r"w = u + \frac{a}{2} (x^2 - s^2)"), "holds");
    assert_ne!(step(first, r"w = u + \frac{a}{2} x^2"), "holds");
}

/// What is so at one place is not so for good.
#[test]
fn values_at_one_place_are_none_for_good() {
    let law = "The law is\n\n$$ \\frac{dw}{dx} = -k w $$\n\nThe general solution is\n\n$$ w = C e^{-k x} $$\n\n";
    for words in [
        "At $x = 0$ we have $w = c$. Hence",
        "Initially, at $x = 0$, the value is $w = c$. Therefore",
        "We know that $w = c$ at the point $x = 0$. Then",
        "Since $w = c$ at $x = 0$, we find",
    ] {
        let step = |formula: &str| last(&format!("{law}{words}\n\n$$ {formula} $$\n"));
        assert_eq!(step("C = c"), "holds", "{words}");
        assert_ne!(step("C = 2 c"), "holds", "{words}");
        assert_ne!(step("w = c"), "holds", "{words}");
    }
    // It cannot be false beside something that varies.
    let force = "The force is\n\n$$ F = k v + c $$\n\nAt $t = 0$ we have $v = 0$. Hence\n\n";
    let step = |formula: &str| last(&format!("{force}$$ {formula} $$\n"));
    assert_eq!(step("F = c"), "holds");
    assert_eq!(step("F = 2 c"), "fails");
    assert_ne!(step("F = k v + c = c"), "fails");
    let spring = "The equation of motion is\n\n$$ m \\ddot x = -k x \\tag{1} $$\n\nWith the angular frequency\n\n$$ \\omega = \\sqrt{\\frac{k}{m}} $$\n\nsuppose that it is let go from rest, i.e. $x = A$, $\\dot{x} = 0$ at $t = 0$. Then\n\n";
    let step = |formula: &str| last(&format!("{spring}$$ {formula} $$\n"));
    assert_ne!(step(r"x = A \cos \omega t"), "fails");
    assert_ne!(step("x = A"), "holds");
    assert_ne!(step(r"\dot x = 0"), "holds");
}

/// π is the number where it stands in integrals and laws of change, too.
#[test]
fn pi_in_integrals() {
    let flow = |factor: &str, law: &str| {
        verdicts(&format!(
            "Integrating the slope\n\n$$ \\frac{{dv}}{{dr}} = -2 a r $$\n\nwith $v = 0$ at the wall $r = R$ gives\n\n$$ v(r) = a (R^2 - r^2) $$\n\nThe flow is\n\n$$ Q = \\int_0^R v(r) \\, 2 \\pi r \\, dr $$\n\nSubstituting the profile,\n\n$$ Q = {factor} \\pi a \\left( \\frac{{R^4}}{{2}} - \\frac{{R^4}}{{4}} \\right) $$\n\nthat is\n\n$$ Q = {law} $$\n"
        ))
    };
    let right = flow("2", r"\frac{\pi a R^4}{2}");
    assert_eq!(right[1..], ["holds", "given", "holds", "holds"]);
    // Of what the profile is only a step tells that holds under a condition; with the factor it follows.
    assert_eq!(flow("", r"\frac{\pi a R^4}{2}")[3], "fails");
    assert_eq!(flow("2", r"\frac{\pi a R^4}{4}")[4], "fails");
}

/// Who is shown that a solution holds is told what makes it that one: its slope alone leaves a constant open.
#[test]
fn the_explanation_names_the_value_at_the_place() {
    let text = "The slope obeys\n\n$$ \\frac{dw}{dx} = a x \\tag{1} $$\n\nso with $w = 0$ at $x = b$\n\n$$ w = \\frac{a}{2} (x^2 - b^2) \\tag{2} $$\n";
    let audit = Audit::of(&Derivation::from_markdown("a.md", text));
    let last = audit.entries.last().unwrap();
    assert_eq!(last.verdict.word(), "holds");
    let mut assumed = last.judged.iter().flat_map(|judged| &judged.assumed);
    assert!(assumed.any(|own| own.tells_value_there()));
}
