//! What a quantity is at a place that the words name, and steps that are of something else than what stands just before them.

use crate::common::last_noted;

/// The verdict of the last statement of a text that declares nothing, and whether it is told that it is not checked.
fn last(text: &str) -> (&'static str, bool) {
    let (verdict, notes) = last_noted(text);
    (verdict, notes.contains(&"taken-as-given"))
}

const CHECKED: (&str, bool) = ("holds", false);
const FAILS: (&str, bool) = ("fails", false);

#[test]
fn what_is_greatest_is_what_the_quantity_is_there() {
    let page = |place: &str, greatest: &str| {
        last(&format!(
            "The power in the load is\n\n$$ P = \\frac{{E^2 R}}{{(r + R)^2}} $$\n\nand its slope\n\n\
             $$ \\frac{{dP}}{{dR}} = E^2 \\frac{{r - R}}{{(r + R)^3}} $$\n\n{place}\n\n$$ P_{{\\max}} = {greatest} $$\n"
        ))
    };
    for place in [
        "It is largest at $R = r$, where",
        "Hence the maximum is at $R = r$ and amounts to",
        "The slope is zero for $R = r$, so the largest power is",
    ] {
        assert_eq!(page(place, r"\frac{E^2}{4 r}"), CHECKED, "{place}");
        assert_eq!(page(place, r"\frac{E^2}{2 r}"), FAILS, "{place}");
        assert_eq!(page(place, r"\frac{E}{4 r}"), FAILS, "{place}");
    }
    // Where it is greatest is not said.
    let unsaid = page("The largest power is therefore", r"\frac{E^2}{2 r}");
    assert_eq!(unsaid.0, "given");
}

#[test]
fn an_index_names_the_end_of_a_curve() {
    let page = |place: &str, there: &str| {
        last(&format!(
            "The deflection of the beam is\n\n$$ y = \\frac{{F}}{{E I}} \\left( \\frac{{L x^2}}{{2}} - \\frac{{x^3}}{{6}} \\right) $$\n\n\
             {place}\n\n$$ {there} $$\n"
        ))
    };
    let place = "At the free end, $x = L$, the deflection is";
    assert_eq!(page(place, r"y_L = \frac{F L^3}{3 E I}"), CHECKED);
    assert_eq!(page(place, r"y_L = \frac{F L^3}{6 E I}"), FAILS);
    // What follows there speaks of other symbols: the index may mean another load.
    assert_eq!(page(place, r"y_G = \frac{G L^3}{3 E I}").0, "given");
    // No place is named, and nothing is put in.
    let other = "For a beam that is held at both ends one finds";
    assert_eq!(page(other, r"y_m = \frac{F L^3}{192 E I}").0, "given");
}

#[test]
fn an_index_on_what_is_the_same_everywhere_names_something_else() {
    let page = |words: &str| {
        last(&format!(
            "The speed of the first wave is\n\n$$ v = \\sqrt{{g h}} $$\n\n{words}\n\n$$ v_1 = \\sqrt{{2 g h}} $$\n"
        ))
    };
    assert_eq!(page("while that of the second one is").0, "given");
    assert_eq!(page("A stone that falls from there has").0, "given");
}

/// `v^2 = 2 a h` goes on with what `a` is, of which the case before says nothing.
#[test]
fn what_stands_just_before_may_be_of_something_else() {
    let page = |resistance: &str| {
        last(&format!(
            "The flow through the pipe is\n\n$$ Q = \\frac{{c R^4 p}}{{8 \\eta L}} $$\n\nThe mean velocity is\n\n\
             $$ v = \\frac{{R^2 p}}{{8 \\eta L}} $$\n\nThe stress at the wall is\n\n$$ \\tau = \\frac{{R p}}{{2 L}} $$\n\n\
             Let $Z = p/Q$ be the resistance, so that\n\n$$ Z = {resistance} $$\n"
        ))
    };
    assert_eq!(page(r"\frac{8 \eta L}{c R^4}").0, "holds");
    assert_eq!(page(r"\frac{8 \eta L}{c R^3}").0, "fails");
}

/// What is only calculated from what is known is no law, though no word says that it follows.
#[test]
fn what_is_known_in_the_same_symbols_is_no_law() {
    let page = |difference: &str| {
        last(&format!(
            "Each firm earns\n\n$$ G = \\frac{{(a - c)^2}}{{9 b}} \\tag{{1}} $$\n\nwhile a monopolist has\n\n$$ G_m = \\frac{{(a - c)^2}}{{4 b}} \\tag{{2}} $$\n\n\
             The two firms together lose\n\n$$ {difference} \\tag{{3}} $$\n"
        ))
    };
    assert_eq!(page(r"G_m - 2 G = \frac{(a - c)^2}{36 b}").0, "holds");
    assert_eq!(page(r"G_m - 2 G = \frac{(a - c)^2}{18 b}"), FAILS);
    // Another symbol, and it may be a law.
    assert_eq!(page(r"G_m - 2 G = \frac{k (a - c)^2}{18 b}").0, "given");
    let forces = |balance: &str| {
        last(&format!(
            "The spring pulls with\n\n$$ F_1 = k x \\tag{{1}} $$\n\nand the air with\n\n$$ F_2 = b v \\tag{{2}} $$\n\nAt the lowest speed\n\n$$ {balance} \\tag{{3}} $$\n"
        ))
    };
    assert_eq!(forces("F_1 + F_2 = m g").0, "given");
    assert_eq!(forces("F_1 = F_2").0, "given");
}

#[test]
fn a_name_with_something_added_is_what_is_put_in_makes_of_the_whole() {
    let page = |words: &str, step: &str| {
        last(&format!(
            "The force of the spring is\n\n$$ F = F_0 - k x \\tag{{1}} $$\n\nand it rests at\n\n$$ x_r = \\frac{{F_0 - w}}{{2 k}} \\tag{{2}} $$\n\n\
             {words}\n\n$$ {step} $$\n"
        ))
    };
    // What `x_r` is stands in an equation that is not cited.
    for words in [
        "Inserting $x = x_r$ in (1), the force at rest is",
        "With $x = x_r$ equation (1) says that the force is",
    ] {
        assert_eq!(page(words, r"F_r = \frac{F_0 + w}{2}"), CHECKED, "{words}");
        assert_eq!(page(words, r"F_r = \frac{F_0 - w}{2}"), FAILS, "{words}");
    }
    // What is printed speaks of something that nothing before ties to the rest.
    let other = page(
        "Inserting $x = x_r$ in (1), the force at rest is",
        r"F_r = \frac{F_0 + q}{2}",
    );
    assert_eq!(other.0, "given");
}

#[test]
fn what_the_words_say_of_a_new_name_is_what_it_is_taken_from() {
    let page = |words: &str, step: &str| {
        last(&format!(
            "The pull on the cart is\n\n$$ b = \\frac{{P}}{{M}} \\tag{{1}} $$\n\n{words}\n\n$$ {step} $$\n"
        ))
    };
    let words = "It starts at rest, and $u^2 = 2 b z$ after the way $z$, so by (1)";
    assert_eq!(page(words, r"u = \sqrt{\frac{P z}{M}}"), FAILS);
    assert_ne!(page(words, r"u = \sqrt{\frac{2 P z}{M}}").0, "fails");
    let twice = "What the cart keeps is $L = M b - b$, or";
    assert_eq!(page(twice, r"L = P + \frac{P}{M}"), FAILS);
    assert_ne!(page(twice, r"L = P - \frac{P}{M}").0, "fails");
}

#[test]
fn a_condition_in_the_text_says_what_a_name_is() {
    let page = |step: &str| {
        last(&format!(
            "The two pulls are\n\n$$ P = m r s, \\qquad Q = \\frac{{n}}{{s}} $$\n\nThe bead rests if they are equal, $P = Q$. We conclude that\n\n\
             $$ {step} $$\n\nis where it rests.\n"
        ))
    };
    assert_eq!(page(r"s_0 = \frac{n}{m r}"), FAILS);
    assert_ne!(page(r"s_0 = \sqrt{\frac{n}{m r}}").0, "fails");
}

#[test]
fn a_value_at_a_place_is_no_law() {
    let page = |words: &str, step: &str| {
        last(&format!(
            "The answer of the filter is\n\n$$ G(q) = \\frac{{a}}{{1 + a + b q}} $$\n\n{words}\n\n$$ {step} $$\n"
        ))
    };
    let words = "What it lets through of a steady input is the value at $q = 0$,";
    assert_eq!(page(words, r"G(0) = \frac{a}{1 + a}").0, "holds");
    assert_eq!(page(words, r"G(0) = \frac{a}{1 - a}"), FAILS);
    // What brings in something else may be a condition.
    assert_eq!(page(words, r"G(0) = c").0, "given");
    let rate = |step: &str| {
        last(&format!(
            "The rate is\n\n$$ W = \\frac{{p z}}{{H + z}} $$\n\nWhen the dose is $z = H$, the rate comes to\n\n$$ {step} $$\n"
        ))
    };
    assert_eq!(rate(r"W = \frac{p}{2}").0, "holds");
    assert_eq!(rate(r"W = \frac{p}{4}"), FAILS);
}

#[test]
fn the_value_at_a_named_place_is_that_of_what_has_its_argument_left_out() {
    let page = |step: &str| {
        last(&format!(
            "The hull has the area\n\n$$ A = 2 b^2 + 3 b c $$\n\nand with the volume\n\n$$ c = \\frac{{V}}{{b^2}} $$\n\n\
             that is a function of $b$ alone,\n\n$$ {step} $$\n\nAt its best it is $A_0 = A(b_0)$, no less.\n"
        ))
    };
    assert_eq!(page(r"A(b) = 2 b^2 + \frac{3 V}{b}").0, "holds");
    assert_eq!(page(r"A(b) = 2 b^2 + \frac{2 V}{b}"), FAILS);
}
