//! Functions that a page defines, `f(x) = 3 x^2`, and what is said of them for other arguments and in integrals.

use crate::common::last;

#[test]
fn a_definition_says_what_values_are() {
    let page = |step: &str| {
        last(&format!(
            "The density is\n\n$$ f(x) = 3 x^2 + x \\tag{{1}} $$\n\nThe number $n$ is another one. Hence\n\n$$ {step} $$\n"
        ))
    };
    for right in [
        "f(2) = 14",
        "f(a) = 3 a^2 + a",
        "f(a) + f(b) = 3 (a^2 + b^2) + a + b",
    ] {
        assert_eq!(page(right), "holds", "{right}");
    }
    for wrong in [
        "f(2) = 12",
        "f(a) = 3 a^2",
        "f(a) + f(b) = 3 (a + b)^2 + a + b",
    ] {
        assert_eq!(page(wrong), "fails", "{wrong}");
    }
}

#[test]
fn a_function_is_put_into_integrals() {
    let page = |words: &str, flow: &str| {
        last(&format!(
            "The profile is\n\n$$ v(r) = a (R^2 - r^2) \\tag{{1}} $$\n\nThe flow is\n\n$$ Q = \\int_0^R v(r) \\, 2 \\pi r \\, dr \\tag{{2}} $$\n\n{words}\n\n$$ Q = {flow} $$\n"
        ))
    };
    for words in ["Substituting (1) in (2),", "With this profile we find"] {
        assert_eq!(page(words, r"\frac{\pi a R^4}{2}"), "holds", "{words}");
        assert_eq!(page(words, r"\frac{\pi a R^4}{4}"), "fails", "{words}");
    }
}
