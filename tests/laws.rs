//! Laws by their names, and for particular things, where nothing is declared.

use crate::common::last_noted;

fn verdict(text: &str) -> &'static str {
    last_noted(text).0
}

/// Who compares two cases gives an index to what differs between them.
#[test]
fn law_is_one_of_particular_things() {
    let ratio = |said: &str| {
        verdict(&format!(
            "The power is\n\n$$ P = s A T^4. $$\n\nIf the temperature is doubled, $T_2 = 2 T_1$, the ratio is\n\n$$ {said}. $$\n"
        ))
    };
    assert_eq!(
        ratio(r"\frac{P_2}{P_1} = \frac{T_2^4}{T_1^4} = 16"),
        "holds"
    );
    assert_eq!(ratio(r"\frac{P_2}{P_1} = \frac{T_2^3}{T_1^3} = 8"), "fails");
    assert_eq!(ratio(r"\frac{P_2}{P_1} = 16"), "holds");
    assert_eq!(ratio(r"\frac{P_2}{P_1} = 8"), "fails");
}

#[test]
fn what_differs_bears_the_index() {
    let drawn = |law: &str, step: &str| {
        verdict(&format!(
            "It is\n\n$$ {law} \\tag{{1}} $$\n\nBy (1), then,\n\n$$ {step}. $$\n"
        ))
    };
    assert_eq!(drawn("E = m v^2/2", "E_1 = m v_1^2/2"), "holds");
    assert_eq!(drawn("E = m v^2/2", "E_1 = m v_1^2"), "fails");
    // The law speaks of the indexed symbol itself.
    assert_ne!(drawn("v = v_0 + a t", "a = 0"), "holds");
    // More than the law speaks of: it may be the momentum of something else.
    assert_eq!(drawn("p = m v", "p_1 = m v_1 + M w"), "given");
    // An index that runs is none of a thing.
    assert_ne!(drawn("p = m v", "p_i = 2 m v_i"), "fails");
}

#[test]
fn law_that_stands_is_no_new_one() {
    let drawn = |words: &str, value: &str| {
        verdict(&format!(
            "Momentum is conserved:\n\n$$ m v = (m + M) w. $$\n\n{words}\n\n$$ w = {value}. $$\n"
        ))
    };
    for words in [
        "Hence the velocity follows from conservation of momentum:",
        "Using momentum conservation we obtain",
        "Solving the momentum balance for $w$:",
    ] {
        assert_eq!(drawn(words, r"\frac{m}{m + M} v"), "holds", "{words}");
        assert_eq!(drawn(words, r"\frac{m}{m + 2 M} v"), "fails", "{words}");
    }
}

/// What is defined is no reason for what follows from its definition.
#[test]
fn definition_may_be_a_reason() {
    let loss = |value: &str| {
        verdict(&format!(
            "The momentum is conserved,\n\n$$ m v_0 = m v'_1 + m v'_2, $$\n\nand the coefficient of restitution $e$ is defined by\n\n\
             $$ v'_2 - v'_1 = e v_0. $$\n\nThe kinetic energy before is\n\n$$ E_0 = \\frac12 m v_0^2 $$\n\nand what is lost is\n\n\
             $$ L = E_0 - \\frac12 m {{v'_1}}^2 - \\frac12 m {{v'_2}}^2. $$\n\n\
             From conservation of momentum and the definition of restitution it follows that\n\n$$ L = {value}. $$\n"
        ))
    };
    assert_eq!(loss(r"\frac12 (1 - e^2) E_0"), "holds");
    assert_eq!(loss("(1 - e^2) E_0"), "fails");
}

/// No law stands there by its name: what is said of heat is one.
#[test]
fn law_that_stands_nowhere_is_given() {
    let text = "The hot body gives off\n\n$$ Q_1 = M_1 c (T_1 - T) $$\n\nand the cold one takes up\n\n$$ Q_2 = M_2 c (T - T_2). $$\n\n\
                Energy conservation gives\n\n$$ Q_1 = Q_2. $$\n";
    assert_eq!(last_noted(text), ("given", vec!["taken-as-given"]));
}

/// Only the first link can come from what is cited, and it defines something.
#[test]
fn beginning_of_a_chain_is_told() {
    let text = "The ball falls according to\n\n$$ m g h = E. \\tag{1} $$\n\nWith $h = 4 R$ the speed is, by (1),\n\n$$ u = \\sqrt{g h} = 2 \\sqrt{g R}. $$\n";
    let (verdict, notes) = last_noted(text);
    assert_eq!(verdict, "holds");
    assert!(notes.contains(&"taken-as-given"), "{notes:?}");
}

#[test]
fn premise_does_not_stand_in_the_way_of_an_inequality() {
    let text = "It is\n\n$$ n v_0 = \\sum_{i=1}^k u_i. $$\n\nFor all real numbers,\n\n$$ \\left(\\sum_{i=1}^k u_i\\right)^2 \\leq k \\sum_{i=1}^k u_i^2. $$\n";
    assert_eq!(verdict(text), "holds");
    assert_eq!(verdict(&text.replace(r"\leq", r"\geq")), "fails");
}
