//! Numerical examples: the values that sentences list, how long they are put in, and what a cited equation is said of.

use crate::common::verdicts;

/// The verdict of the last line of a page that begins with two laws of a spring.
fn spring(text: &str) -> &'static str {
    let page = format!(
        "The period is\n\n$$ T^2 = \\frac{{4 m}}{{k}} \\tag{{1}} $$\n\nand the force\n\n$$ F = k a \\tag{{2}} $$\n\n{text}\n"
    );
    verdicts(&page).last().copied().unwrap_or_default()
}

/// A list goes on over units, nouns and powers of ten; a wrong number fails.
#[test]
fn a_sentence_lists_values() {
    for list in [
        "With $k = 50$ N/m and $a = 0.1$ m, (2) gives",
        "With $k = 5.0 \\times 10^{1}$ kg s$^{-2}$ and an amplitude $a = 0.1$ m, equation (2) gives",
        "For a steel spring with $m = 2$ kg, $k = 50$ N/m and a mean amplitude $a = 0.1$ m the force (2) is only",
        "For a numerical example take $k = 50$ N/m and $a = 0.1$ m. From (2)",
        "As an example, consider a spring with $k = 50$ N/m and the amplitude $a = 0.1$ m. From (2)",
        "Example: $k = 50$ N/m, $a = 0.1$ m. Then by (2)",
        "If, for example, $k = 50$ N/m and $a = 0.1$ m, then by (2)",
        "Let us put $k = 50$ N/m and, for the amplitude, $a = 0.1$ m. Then (2) is",
    ] {
        assert_eq!(
            spring(&format!("{list}\n\n$$ F = 50 \\cdot 0.1 = 5 $$")),
            "holds",
            "{list}"
        );
        assert_eq!(
            spring(&format!("{list}\n\n$$ F = 50 \\cdot 0.1 = 6 $$")),
            "fails",
            "{list}"
        );
        let wrong = spring(&format!("{list}\n\n$$ F = \\frac{{50}}{{0.1}} = 500 $$"));
        assert_eq!(wrong, "fails", "{list}");
    }
}

/// Values that are denied, or of two things, or of a place are none of an example.
#[test]
fn what_is_denied_is_no_example() {
    for list in [
        "It would not do with $k = 50$ N/m and $a = 0.1$ m. From (2)",
        "Unlike in the experiment with $k = 50$ N/m and $a = 0.1$ m, (2) gives",
        "We compare springs with $k = 50$ and with $k = 60$. With $a = 0.1$, (2) gives",
        "It is $a = 0.1$ or $k = 50$. From (2)",
    ] {
        assert_ne!(
            spring(&format!("{list}\n\n$$ F = 50 \\cdot 0.1 = 5 $$")),
            "holds",
            "{list}"
        );
    }
}

/// The values are put in until others are given; what is said of any values is not said of these.
#[test]
fn values_are_put_in_by_what_comes_to_a_number() {
    let page = |force: &str, again: &str| {
        verdicts(&format!(
            "$$ T^2 = \\frac{{4 m}}{{k}} \\tag{{1}} $$\n\nand\n\n$$ F = k a \\tag{{2}} $$\n\nWith $k = 50$ N/m, $m = 2$ kg and \
             $a = 0.1$ m, (1) gives\n\n$$ T^2 = 0.16 $$\n\nand from (2)\n\n$$ F = 5 $$\n\nFrom (2) we have, for any amplitude,\n\n\
             $$ F = {force} $$\n\nWith $k = 100$ N/m and $a = 0.2$ m we get from (2)\n\n$$ F = {again} $$\n"
        ))
    };
    let right = ["given", "given", "holds", "holds", "holds", "holds"];
    assert_eq!(page("k a", "20"), right);
    // It is so for these values alone.
    assert_eq!(page("50 a", "20")[4], "fails");
    assert_eq!(page("k a", "5")[5], "fails");
}

/// After a case of its own a step goes on with what was derived for the disc: that its moment of inertia is called so is no case.
#[test]
fn what_a_new_symbol_means_outlasts_the_next_case() {
    let page = |speed: &str| {
        verdicts(&format!(
            "For the disc, with moment of inertia $I = \\frac12 M R^2$ and angular acceleration $\\alpha = a/R$,\n\n$$ F R = I \\alpha \\tag{{1}} $$\n\n\
             Inserting $I$ and $\\alpha$ in (1) gives\n\n$$ F = \\frac12 M a \\tag{{2}} $$\n\nIf there is no load, $M = 0$, the tension is\n\n$$ T = m g \\tag{{3}} $$\n\n\
             Finally, the speed after a height $h$ is\n\n$$ v^2 = 2 a h = {speed} \\tag{{4}} $$\n"
        ))
    };
    let last = |speed: &str| page(speed).pop().unwrap();
    assert_eq!(last(r"\frac{4 F h}{M}"), "holds");
    assert_eq!(last(r"\frac{2 F h}{M}"), "fails");
}

/// What a new symbol means is no case, be it told of one thing; and a value that it is said to have later goes with that.
#[test]
fn a_meaning_goes_with_a_value() {
    let disc = |a: &str| {
        spring(&format!(
            "For the disc, with moment of inertia $I = \\frac12 M R^2$,\n\n$$ N = I w \\tag{{3}} $$\n\nInserting $I$ in (3) gives\n\n\
             $$ N = \\frac12 M R^2 w \\tag{{4}} $$\n\nWith $M = 3$ kg, $R = 2$ m and $w = 5$ s$^{{-2}}$, (4) yields\n\n$$ N = {a} $$"
        ))
    };
    assert_eq!(disc("30"), "holds");
    assert_eq!(disc("60"), "fails");
    let ray = |scene: &str, sine: &str| {
        spring(&format!(
            "For rays\n\n$$ \\frac{{\\sin\\alpha}}{{v_1}} = \\frac{{\\sin\\beta}}{{v_2}} \\tag{{4}} $$\n\nWith the refractive indices \
             $n_1 = c/v_1$ and $n_2 = c/v_2$ this is\n\n$$ n_1 \\sin\\alpha = n_2 \\sin\\beta \\tag{{5}} $$\n\n{scene}\n\n\
             $$ \\sin\\beta = {sine} $$"
        ))
    };
    for scene in [
        "Now let a ray in air ($n_1 = 1$) hit a plate of index $n_2 = n$. By (5)",
        "By (5), with $n_1 = 1$ and $n_2 = n$,",
        "Suppose a ray in air ($n_1 = 1$) hits a plate of index $n_2 = n$. Then (5) gives",
    ] {
        assert_eq!(ray(scene, "\\frac{\\sin\\alpha}{n}"), "holds", "{scene}");
        assert_ne!(ray(scene, "n \\sin\\alpha"), "holds", "{scene}");
    }
    // Another meaning takes its place.
    let other = "Now let $n_1 = 2 c/v_1$ and $n_2 = c/v_2$. By (5)";
    assert_ne!(ray(other, "\\frac{n_1 \\sin\\alpha}{n_2}"), "holds");
}

/// A case with which a sentence goes on after the unit of a display takes the place of the one before.
#[test]
fn a_case_after_a_unit() {
    let page = |last: &str, power: &str| {
        spring(&format!(
            "The power is\n\n$$ P = \\frac{{U^2 R}}{{(r + R)^2}} \\tag{{3}} $$\n\nIt is greatest at $R = r$, where\n\n\
             $$ P_m = \\frac{{U^2}}{{4 r}} \\tag{{4}} $$\n\nFor $U = 12$ V and $r = 0.5$ ohm by (4)\n\n$$ P_m = 72 $$\n\n{last}\n\n\
             $$ P = {power} P_m $$"
        ))
    };
    for last in ["watts, and for $R = 3 r$", "and for $R = 3 r$"] {
        assert_eq!(page(last, "\\frac34"), "holds", "{last}");
        assert_ne!(page(last, "\\frac13"), "holds", "{last}");
        assert_ne!(page(last, ""), "holds", "{last}");
    }
}

/// "This equals" speaks of what the display before says the value of.
#[test]
fn this_equals() {
    let page = |words: &str, root: &str| {
        spring(&format!(
            "The share is\n\n$$ s = \\frac{{4 r R}}{{(r + R)^2}} \\tag{{3}} $$\n\n{words}\n\n$$ R^2 - {root} r R + r^2 = 0 $$"
        ))
    };
    for words in [
        "Half of it is reached when this equals $\\frac12$, which leads to",
        "This equals $\\frac12$ for",
        "It is half used up where this is equal to $\\frac12$, so",
    ] {
        assert_eq!(page(words, "6"), "holds", "{words}");
        assert_eq!(page(words, "5"), "fails", "{words}");
    }
    assert_ne!(page("This does not equal $\\frac12$, and so", "6"), "holds");
}

/// "It" is what was put in elsewhere before.
#[test]
fn inserting_it() {
    let page = |words: &str, force: &str| {
        spring(&format!(
            "The amplitude is\n\n$$ a = 2 m w \\tag{{3}} $$\n\nInserting (3) in (2) gives the force\n\n$$ F = 2 k m w \\tag{{4}} $$\n\n\
             and for the energy\n\n$$ E = \\frac12 k a^2 \\tag{{5}} $$\n\nInserting (3) in (2) again,\n\n$$ F = 2 w k m $$\n\n{words}\n\n\
             $$ E = {force} $$"
        ))
    };
    for words in ["and inserting it in (5)", "Substituting it into (5) we get"] {
        assert_eq!(page(words, "2 k m^2 w^2"), "holds", "{words}");
        assert_eq!(page(words, "k m^2 w^2"), "fails", "{words}");
    }
}

/// What is calculated from a number that was rounded on the way is as near as that, and no nearer.
#[test]
fn numbers_rounded_on_the_way() {
    let page = |number: &str, range: &str| {
        spring(&format!(
            "The range is\n\n$$ L = \\frac{{v^2}}{{g^2}} \\left( \\sqrt{{g^2 + a^2}} - a \\right) \\tag{{3}} $$\n\nWith $v = 20$ m/s, \
             $g = 9.8$ m/s² and $a = 2.0$ m/s² we get from (3)\n\n$$ L = \\frac{{400}}{{96.04}} ({number}) \\approx {range} $$"
        ))
    };
    assert_eq!(page("10.002 - 2.0", "33.3"), "undecided");
    assert_eq!(page("10.0 - 2.0", "33.3"), "undecided");
    assert_eq!(page("10.102 - 2.0", "33.7"), "fails");
    assert_eq!(page("10.002 + 2.0", "50.0"), "fails");
    assert_eq!(page("10.002 - 2.0", "35.3"), "fails");
}

/// What a new symbol is at a place follows from what a law says there without its index; "this" is the display before.
#[test]
fn a_new_symbol_at_a_place() {
    let page = |words: &str, square: &str| {
        spring(&format!(
            "The semi-major axis is\n\n$$ b = \\frac{{p + q}}{{2}} \\tag{{3}} $$\n\nand the speed is given by\n\n\
             $$ v^2 = G \\left( \\frac{{2}}{{r}} - \\frac{{1}}{{b}} \\right) \\tag{{4}} $$\n\n{words}\n\n$$ v_p^2 = {square} $$"
        ))
    };
    let right = "\\frac{2 G q}{p (p + q)}";
    for words in [
        "At pericentre, $r = p$, this gives together with (3)",
        "At pericentre, where $r = p$, this becomes with (3)",
        "For $r = p$ we get from (3) and (4)",
    ] {
        assert_eq!(page(words, right), "holds", "{words}");
        for wrong in ["\\frac{G q}{p (p + q)}", "\\frac{2 G p}{q (p + q)}"] {
            assert_ne!(page(words, wrong), "holds", "{words}");
        }
    }
    // Nothing is said of where that is.
    assert_ne!(page("This gives together with (3)", right), "holds");
    assert_ne!(
        page("At apocentre, $r = q$, this gives together with (3)", right),
        "holds"
    );
}

/// Lines without units reckon in those of the SI; in others nothing is said.
#[test]
fn units_are_left_out() {
    let page = |amplitude: &str, force: &str| {
        spring(&format!(
            "For a spring with $k = 50\\,\\mathrm{{N/m}}$ and $a = {amplitude}$ we find from (2)\n\n$$ F = {force} $$"
        ))
    };
    assert_eq!(page("0.1\\,\\mathrm{m}", "50 \\cdot 0.1 = 5"), "holds");
    assert_ne!(page("0.1\\,\\mathrm{m}", "50 \\cdot 0.2 = 10"), "holds");
    assert_ne!(page("10\\,\\mathrm{cm}", "50 \\cdot 10 = 500"), "holds");
}

/// What is told later takes the place of a value.
#[test]
fn later_values_replace_earlier_ones() {
    let page = |constant: &str, other: &str| {
        verdicts(&format!(
            "$$ w^2 = \\frac{{k}}{{m}} \\tag{{1}} $$\n\nWith $m = 3$ kg and $k = 12$ N/m, (1) gives\n\n$$ w^2 = 4 $$\n\nIf instead \
             $w = 4$, then by (1)\n\n$$ k = {constant} $$\n\nand a mass $m = 5$ kg needs by (1)\n\n$$ k = {other} $$\n"
        ))
    };
    assert_eq!(page("48", "80"), ["given", "holds", "holds", "holds"]);
    assert_eq!(page("36", "80")[2], "fails");
    assert_ne!(page("48", "48")[3], "holds");
}

/// A step is not refuted where its sentence states what cannot be read.
#[test]
fn what_is_stated_and_not_read() {
    let page = |stated: &str| {
        spring(&format!(
            "The slope is\n\n$$ s = \\frac{{u}}{{n}} \\tag{{3}} $$\n\nFrom (3) we have {stated}, hence\n\n$$ u = n + 1 $$"
        ))
    };
    assert_eq!(page("$\\cos b = \\sqrt{1 - \\sin^2 a / n^2}$"), "undecided");
    assert_eq!(page("$n s = u$"), "fails");
}
