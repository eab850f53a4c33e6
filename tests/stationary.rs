//! Where slopes by what the text names are zero: least squares, Lagrange's multipliers, optimal prices.

use crate::common::{last_noted, verdicts};

#[test]
fn normal_equations_follow_from_the_sum_of_squares() {
    let page = |words: &str, first: &str| {
        verdicts(&format!(
            "The sum of squares is\n\n$$ S = \\sum_{{i=1}}^n (y_i - a - b x_i)^2. \\tag{{1}} $$\n\n{words}\n\n$$ {first}, \\tag{{2}} $$\n\n\
             $$ \\sum_{{i=1}}^n x_i y_i = a \\sum_{{i=1}}^n x_i + b \\sum_{{i=1}}^n x_i^2. \\tag{{3}} $$\n"
        ))
    };
    for words in [
        "Setting the derivatives with respect to $a$ and $b$ to zero gives",
        "Setting the partial derivatives of $S$ with respect to $a$ and $b$ equal to zero yields",
        "The derivatives of (1) with respect to $a$ and $b$ vanish. Hence",
        "Minimizing $S$ over $a$ and $b$ gives",
        "Minimising (1) with respect to $a$ and $b$ we get",
    ] {
        let right = r"\sum_{i=1}^n y_i = n a + b \sum_{i=1}^n x_i";
        assert_eq!(page(words, right), ["given", "holds", "holds"], "{words}");
        let wrong = r"\sum_{i=1}^n y_i = n a - b \sum_{i=1}^n x_i";
        assert_ne!(page(words, wrong)[1], "holds", "{words}");
    }
}

/// What comes of it is no more said of where the slopes are zero: slips are told.
#[test]
fn what_is_concluded_where_slopes_are_zero_stands() {
    let page = |mean: &str| {
        verdicts(&format!(
            "The sum of squares is\n\n$$ S = \\sum_{{i=1}}^n (y_i - a - b x_i)^2. \\tag{{1}} $$\n\nThe means are\n\n\
             $$ u = \\frac1n \\sum_{{i=1}}^n x_i, \\qquad v = \\frac1n \\sum_{{i=1}}^n y_i. \\tag{{2}} $$\n\n\
             Setting the derivative of $S$ with respect to $a$ equal to zero gives\n\n$$ \\sum_{{i=1}}^n (y_i - a - b x_i) = 0. \\tag{{3}} $$\n\n\
             By (2), (3) means\n\n$$ a = {mean}. \\tag{{4}} $$\n"
        ))
    };
    assert_eq!(page("v - b u")[3..], ["holds", "holds"]);
    assert_eq!(page("v + b u")[3..], ["holds", "fails"]);
}

/// Another section is not about the places where the slopes are zero.
#[test]
fn a_heading_leaves_where_slopes_are_zero() {
    for heading in ["# Prices", "## Prices", "### Prices"] {
        let page = format!(
            "# Profits\n\n## Quantities\n\nThe profit is\n\n$$ P = (a - b q) q - c q. \\tag{{1}} $$\n\n\
             Setting the derivative with respect to $q$ to zero gives\n\n$$ a - 2 b q - c = 0. \\tag{{2}} $$\n\n{heading}\n\n\
             A firm may sell any quantity. By (1)\n\n$$ a = 2 b q + c. \\tag{{3}} $$\n"
        );
        assert_ne!(verdicts(&page)[2], "holds", "{heading}");
    }
}

#[test]
fn multipliers_of_lagrange() {
    let page = |first: &str, last: &str| {
        verdicts(&format!(
            "The budget is\n\n$$ p x + q y = m. \\tag{{1}} $$\n\nThe Lagrangian is\n\n$$ L = x^2 y + \\lambda (m - p x - q y). \\tag{{2}} $$\n\n\
             Its partial derivatives are\n\n$$ \\frac{{\\partial L}}{{\\partial x}} = {first}, \\qquad \\frac{{\\partial L}}{{\\partial y}} = x^2 - \\lambda q. \\tag{{3}} $$\n\n\
             Setting the partial derivatives of (2) with respect to $x$ and $y$ to zero gives\n\n\
             $$ 2 x y = \\lambda p, \\qquad x^2 = \\lambda q. \\tag{{4}} $$\n\nWith $\\lambda \\neq 0$, $q \\neq 0$ and $p \\neq 0$ we obtain from (1) and (4)\n\n$$ x = {last}. \\tag{{5}} $$\n"
        ))
    };
    let right = page(r"2 x y - \lambda p", r"\frac{2 m}{3 p}");
    assert_eq!(right[2..], ["holds", "holds", "holds", "holds", "holds"]);
    // It may be meant with what ties `x` and `y`: then it is left open.
    let wrong = page(r"2 x y + \lambda p", r"\frac{m}{3 p}");
    assert_ne!(wrong[2], "holds");
    assert_ne!(wrong[6], "holds");
}

/// What is divided by besides what is constant is told.
#[test]
fn an_optimal_quantity_divides_by_what_must_not_vanish() {
    let page = |words: &str, quantity: &str| {
        last_noted(&format!(
            "The profit is\n\n$$ P = (a - b q) q - c q. \\tag{{1}} $$\n\n{words}\n\n$$ q = {quantity}. \\tag{{2}} $$\n"
        ))
    };
    for words in [
        "Setting the derivative with respect to $q$ to zero gives",
        "Setting the derivative to zero gives",
        "Setting $\\frac{dP}{dq} = 0$ gives",
        "Maximizing (1) over $q$ gives",
    ] {
        let (verdict, codes) = page(words, r"\frac{a - c}{2 b}");
        assert_eq!(verdict, "holds", "{words}");
        assert!(codes.contains(&"unstated-condition"), "{words}");
        assert_ne!(page(words, r"\frac{a - c}{b}").0, "holds", "{words}");
    }
}

/// Where nobody can tell by what is differentiated, nothing is refuted.
#[test]
fn what_is_differentiated_by_nobody_knows_what_refutes_nothing() {
    let page = "The profit is\n\n$$ P = (a - b q) q - c q. \\tag{1} $$\n\nSetting the derivative to zero gives\n\n$$ a - c = 2 b q. \\tag{2} $$\n";
    assert_eq!(verdicts(page), ["given", "undecided"]);
}

#[test]
fn what_is_denied_or_of_another_order_is_not_zero() {
    for words in [
        "The derivative with respect to $q$ does not vanish. Hence",
        "The second derivative with respect to $q$ is zero for",
        "If the derivative with respect to $q$ would vanish, we had",
    ] {
        let page = format!(
            "The profit is\n\n$$ P = a q - b q^2. \\tag{{1}} $$\n\n{words}\n\n$$ a - 2 b q = 0. \\tag{{2}} $$\n"
        );
        assert_ne!(verdicts(&page)[1], "holds", "{words}");
    }
}

#[test]
fn several_are_set_to_zero_at_once() {
    let page = |last: &str| {
        verdicts(&format!(
            "The forces are\n\n$$ F = a - b x, \\tag{{1}} $$\n\n$$ G = c - d y. \\tag{{2}} $$\n\nSetting (1) and (2) to zero we get\n\n$$ a = b x, \\qquad {last}. \\tag{{3}} $$\n"
        ))
    };
    assert_eq!(page("c = d y"), ["given", "given", "holds", "holds"]);
    assert_eq!(page("c = 2 d y")[3], "fails");
}
