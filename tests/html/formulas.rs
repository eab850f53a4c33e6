//! MathML: every element has the parts that it must have, and a few formulas in full.

use cradle_verify::document::Span;
use cradle_verify::notation::{mathml_statement, read_display};
use cradle_verify::proofs;

/// How many parts an element has, where that is fixed.
fn parts(element: &str) -> Option<usize> {
    Some(match element {
        "mfrac" | "msub" | "msup" | "mover" | "munder" | "mroot" => 2,
        "msubsup" | "munderover" => 3,
        "mi" | "mn" | "mo" | "mtext" | "mspace" => 0,
        _ => return None,
    })
}

fn checked(markup: &str) {
    let whole = format!("<math>{markup}</math>");
    let tree = roxmltree::Document::parse(&whole).unwrap_or_else(|e| panic!("{e}: {whole}"));
    for node in tree.descendants().filter(|n| n.is_element()) {
        let count = node.children().filter(|n| n.is_element()).count();
        if let Some(parts) = parts(node.tag_name().name()) {
            assert_eq!(count, parts, "{:?} in {whole}", node.tag_name());
        }
    }
}

fn set(latex: &str) -> String {
    let display = read_display(latex, Span::new(0, latex.len()));
    let statements = display
        .statements
        .unwrap_or_else(|e| panic!("{latex}: {}", e.message));
    statements.iter().map(mathml_statement).collect()
}

#[test]
fn all_equations_of_the_pages_that_ship_are_set() {
    for derivation in [proofs::report(), proofs::corrected::corrected()] {
        for equation in &derivation.equations {
            assert!(!equation.statements().is_empty());
            equation
                .statements()
                .iter()
                .for_each(|s| checked(&mathml_statement(s)));
        }
    }
}

/// Formulas of every kind, each with what comes out.
#[test]
fn formulas_in_full() {
    let formulas = [
        r"v'_1 = \frac{m_1 - m_2}{m_1 + m_2} v_0",
        r"{v'_2}^2 = v_0^2",
        r"(E^*)^2 = \dot\delta^{3/2}",
        r"\Delta E_{\text{total}} = -\frac{1}{2} (1 - e^2) E_0",
        r"\left(\sum_{i=1}^k u_i\right)^2 \leq k \sum_{i=1}^k u_i^2",
        r"\frac{d}{dx} x^2 = 2 x",
        r"\int_0^{T} F(t) \, dt = \lim_{x \to \infty} \frac{1}{x}",
        r"\sqrt{2 g h} + \sqrt[3]{x} = |y|",
        r"u_1 = u_2 = \dots = u_n = v \Rightarrow x \stackrel{?}{=} 2 \cdot 3 \quad \times",
        r"\mathbf{p} = \hat{n} \sin\theta",
        r"x^{-1} = 2^n \cdot \frac{1}{2}",
    ];
    let mut shown = String::new();
    for formula in formulas {
        let markup = set(formula);
        checked(&markup);
        let visible = markup
            .replace('\u{2062}', "&#x2062;")
            .replace('\u{2061}', "&#x2061;");
        shown += &format!("{formula}\n  {visible}\n");
    }
    insta::assert_snapshot!(shown);
}
