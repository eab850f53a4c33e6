//! What is solved for under a name of its own.

use crate::common::last;

const THROW: &str = "A stone is after the time $t$ at the height\n\n$$ y = w t - \\frac{1}{2} g t^2. \\tag{1} $$\n\n";

/// The words may set a value in many ways, and name what is solved for or not.
#[test]
fn value_of_what_words_solve_for() {
    for words in [
        "It lands when $y = 0$. By (1) this takes",
        "Requiring $y = 0$ in (1), we find the time of flight",
        "The time of flight follows from $y = 0$:",
        "The time of flight is obtained from $y = 0$:",
        "The time of flight $D$ is the time after which $y = 0$. From (1),",
        "Let $D$ be the time at which $y = 0$. By (1),",
        "It flies until $y = 0$, that is, for the time",
        "The second root of $y = 0$ is",
        "At the end $y = 0$, and so the flight has taken",
    ] {
        let page = |formula: &str| last(&format!("{THROW}{words}\n\n$$ D = {formula} $$\n"));
        assert_eq!(page(r"\frac{2 w}{g}"), "holds", "{words}");
        assert_eq!(page(r"\frac{w}{g}"), "fails", "{words}");
        assert_eq!(page(r"\frac{2 g}{w}"), "fails", "{words}");
    }
}

/// What goes on with a name goes on at its place.
#[test]
fn name_goes_on_where_it_is_cited() {
    let flight = "It is back when $y = 0$. From (1), the flight takes\n\n$$ D = \\frac{2 w}{g}. \\tag{2} $$\n\nMeanwhile it flies\n\n$$ x = u t. \\tag{3} $$\n\n";
    let page = |formula: &str| {
        last(&format!(
            "{THROW}{flight}Substituting (2) into (3), the range is\n\n$$ {formula} $$\n"
        ))
    };
    assert_eq!(page(r"S = \frac{2 u w}{g}"), "holds");
    assert_eq!(page(r"S = \frac{u w}{g}"), "fails");
    assert_eq!(page("S = u D"), "holds");
    assert_eq!(page("S = 2 u D"), "fails");
}

/// What decays to a part of itself tells an exponent.
#[test]
fn time_of_decay() {
    for (law, right, wrong) in [
        (r"e^{-k t}", r"\frac{\ln 3}{k}", r"\frac{\ln 3}{2 k}"),
        (r"e^{-t/\tau}", r"\tau \ln 3", r"3 \tau \ln 3"),
    ] {
        let page = |formula: &str| {
            last(&format!(
                "The voltage falls as\n\n$$ U = U_0 {law}. \\tag{{1}} $$\n\nFor $U = U_0/3$, (1) yields the time\n\n$$ s = {formula} $$\n"
            ))
        };
        assert_eq!(page(right), "holds", "{law}");
        assert_eq!(page(wrong), "fails", "{law}");
    }
}

/// A new symbol need not name what is known at the place.
#[test]
fn what_may_be_something_else_is_given() {
    let pipe = "A pipe has the resistance\n\n$$ R = \\frac{8 \\eta L}{\\pi a^4}. \\tag{1} $$\n\n";
    let half =
        "To half of the radius, $b = a/2$, belongs\n\n$$ S = \\frac{8 \\eta L}{\\pi b^4} $$\n";
    assert_eq!(last(&format!("{pipe}{half}")), "given");
    // What is 0 at the place is not spoken of there.
    let light = "$$ p = \\gamma m w \\tag{1} $$\n\nFor light, $m = 0$. We now turn to\n\n$$ K = (\\gamma - 1) m c^2 $$\n";
    assert_eq!(last(light), "given");
    // "In general" leaves what was named, so that this follows from nothing.
    let currents = "The currents add up:\n\n$$ I = I_1 + I_2. \\tag{1} $$\n\nIf $I_1 = I_2$, then $I = 2 I_1$. In general the voltage $U = R I$ is\n\n$$ U = 2 R I_1 $$\n";
    assert_eq!(last(currents), "undecided");
    // What is said behind a law draws nothing from it.
    let law = "The path is\n\n$$ x = w t \\tag{1} $$\n\nAt $t = 1$ the body is at $x = w$.\n";
    assert_eq!(last(law), "given");
    // Where all would have to be positive, and cannot be, nothing follows.
    let divider = "In series\n\n$$ \\begin{aligned} U &= U_1 + U_2, \\\\ U_1 &= R_1 I, \\\\ U_2 &= R_2 I. \\end{aligned} $$\n";
    assert_eq!(last(divider), "given");
}

/// A comment between a sentence and the display to which it leads on is none of the text.
#[test]
fn comment_ends_no_sentence() {
    let page = |between: &str| {
        last(&format!(
            "The level obeys\n\n$$ \\frac{{dz}}{{dt}} = q - k z. \\tag{{1}} $$\n\nIn the steady state $\\frac{{dz}}{{dt}} = 0$, so the level is\n\n\
             {between}$$ z = \\frac{{q}}{{k}} $$\n"
        ))
    };
    assert_eq!(page(""), "holds");
    assert_eq!(page("<!-- to be checked -->\n\n"), "holds");
}

/// What is taken a root of is solved for, too.
#[test]
fn time_of_fall() {
    let page = |words: &str, formula: &str| {
        last(&format!(
            "A stone that is let go is at the height\n\n$$ y = H - \\frac{{1}}{{2}} g t^2. \\tag{{1}} $$\n\n{words}\n\n$$ D = {formula} $$\n"
        ))
    };
    for words in [
        "It lands when $y = 0$. By (1), the fall takes",
        "Setting $y = 0$ in (1), we find the time",
    ] {
        assert_eq!(page(words, r"\sqrt{\frac{2 H}{g}}"), "holds", "{words}");
        assert_eq!(page(words, r"\sqrt{\frac{H}{g}}"), "fails", "{words}");
        assert_eq!(page(words, r"\sqrt{\frac{H}{2 g}}"), "fails", "{words}");
    }
}
