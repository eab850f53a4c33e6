//! Mathematics as it was typed: what is set, that nothing stays raw, and that nothing typed can do harm.

use std::time::{Duration, Instant};

use cradle_verify::notation::typeset;

use super::{has_class, page_of, text_of, tree};

/// A formula as MathML, which is well-formed, and its text.
fn set(source: &str) -> (String, String) {
    let markup = typeset(source);
    let whole = format!("<math>{markup}</math>");
    let tree = roxmltree::Document::parse(&whole).unwrap_or_else(|e| panic!("{e}: {source}"));
    let text = text_of(tree.root());
    (markup, text)
}

#[test]
fn what_is_typed_is_what_is_shown() {
    for (source, shown) in [
        (r"g = 9.81\,\mathrm{m/s^2} \tag{1}", "g=9.81m/s2"),
        (r"k = 200\,\mathrm{N/m}", "k=200N/m"),
        (r"\qty{9.81}{m/s^2}", "9.81m/s2"),
        (r"\unit{\kilo\metre\per\second\squared}", "kms−2"),
        (r"\num{1.6e-19}", "1.6×10−19"),
        (
            r"n v_0 = u_1 + u_2 + \cdots + u_k = \sum_{i=1}^k u_i",
            "nv0=u1+u2+⋯+uk=∑i=1kui",
        ),
        (r"u_1 = u_2 = \dots = u_n", "u1=u2=⋯=un"),
        (r"n = 1, 2, \dots", "n=1,2,…"),
        (r"\lambda, \tau, \Gamma > 0", "λ,τ,Γ>0"),
        (r"x \in [0, 1]", "x∈[0,1]"),
        (r"30^\circ", "30∘"),
        (r"20\,^\circ\mathrm{C}", "20∘C"),
        (r"\approx 3.2 \sim \pm 2", "≈3.2∼±2"),
        (r"x \to \infty", "x→∞"),
        (r"\{1,2\}, \langle x \rangle", "{1,2},⟨x⟩"),
        (r"\nabla\phi \therefore f: x \mapsto x^2", "∇ϕ∴f:x↦x2"),
        (r"\mathbb{R}, \mathcal{L}, \mathfrak{g}", "ℝ,ℒ,𝔤"),
        (r"\text{<svg onload=alert(1)>}", "<svg onload=alert(1)>"),
        (r"\text{for all $n^2$ & more}", "for all n2 & more"),
        (r"\foo{x} + \bar{y}", "foox+y‾"),
        (r"a \not= b \not\in C", "a≠b∉C"),
        (r"1{,}5 \% % a comment", "1,5%"),
        (r"\left. \frac{dU}{dx} \right|_{x=a}", "dUdx|x=a"),
        (r"{a \over b}", "ab"),
        (r"x''", "x′′"),
        (
            r"\dv[2]{x}{t} + \pdv{f}{x}{y} + \dv{t}\qty(a \dd{s})",
            "d2xdt2+∂2f∂x∂y+ddt(ads)",
        ),
        (r"\abs{a} + \vb{b} + \qty{c}", "|a|+b+{c}"),
    ] {
        let (_, text) = set(source);
        assert_eq!(text.replace('\u{a0}', " ").trim(), shown, "{source}");
    }
}

#[test]
fn structure_is_kept() {
    for (source, inside) in [
        (r"\boxed{k = n}", "<mrow class=\"boxed\">"),
        (r"\frac12", "<mfrac><mn>1</mn><mn>2</mn></mfrac>"),
        (r"\sqrt[3]{x}", "<mroot><mi>x</mi><mn>3</mn></mroot>"),
        (r"v'_1^2", "<msubsup><mrow><mi>v</mi>"),
        (r"\lim_{x \to 0} x", "<munder>"),
        (r"\mathrm{d}x", "<mi mathvariant=\"normal\">d</mi>"),
        (r"|x|^2 + |-y|", "|</mo><mo form=\"prefix\">−</mo>"),
        (r"a = -b", "<mo form=\"prefix\">−</mo>"),
        (
            r"a &= b \\ &= -c",
            "<mtr><mtd class=\"r\"></mtd><mtd class=\"l\"><mo>=</mo>",
        ),
        (
            r"\begin{cases} a & x < 0 \\ b & x > 0 \end{cases}",
            "<mtable class=\"cases\">",
        ),
    ] {
        let (markup, _) = set(source);
        assert!(markup.contains(inside), "{source}: {markup}");
    }
}

#[test]
fn whatever_is_typed_is_set_in_linear_time_and_with_bounded_nesting() {
    let pieces = [
        r"\frac{",
        "{",
        "}",
        r"\hat",
        r"\left(",
        r"\right)",
        r"\begin{cases}",
        r"\end{x}",
        "x_a^b",
        r"\text{$",
        r"\text{",
        "$",
        r"\sqrt[",
        r"\num{",
        r"&\\",
        r"\begin{",
        r"\mathbf",
        "|",
        r"\over ",
        r"\begin{array}{\left",
        r"\boxed\sqrt",
        r"\not",
        r"\",
        "%",
        "\u{0}",
        "<",
        "]]>",
    ];
    for piece in pieces {
        let start = Instant::now();
        let (markup, _) = set(&piece.repeat(3_000));
        assert!(start.elapsed() < Duration::from_secs(20), "{piece}");
        let mut depth = 0_i32;
        for tag in markup.split('<').skip(1) {
            let is_closed = tag
                .split_once('>')
                .is_some_and(|(tag, _)| tag.ends_with('/'));
            depth += if tag.starts_with('/') {
                -1
            } else {
                i32::from(!is_closed)
            };
            assert!(depth < 200, "{piece}");
        }
    }
}

#[test]
fn a_display_is_set_as_its_author_wrote_it() {
    let page = page_of(&[(
        "a.md",
        "<!-- check: symbols n: natural -->\n\n$$ n v = u_1 + u_2 + \\cdots + u_n \\tag{1} $$\n\n\
         $$ \\oint \\vec{B} = 2\\,\\mathrm{m/s} \\tag{2} $$\n\n\
         $$ f = \\begin{cases} a & x < 0 \\\\ b & x \\geq 0 \\end{cases} \\tag{3} $$\n\n\
         $$ \\begin{aligned} p &= q \\\\ &= r \\\\ s &= 3\\,\\mathrm{km} \\end{aligned} \\tag{4} $$\n",
    )]);
    let tree = tree(&page);
    let sheets: Vec<String> = tree
        .descendants()
        .filter(|n| has_class(n, "sheet"))
        .map(text_of)
        .collect();
    assert_eq!(
        sheets,
        [
            "nv=u1+u2+⋯+un",
            "∮B→=2m/s",
            "f=aif\u{a0}x<0",
            "f=bif\u{a0}x≥0",
            "p=q=r",
            "s=3km",
        ]
    );
}

#[test]
fn units_that_are_understood_are_upright_letters_behind_a_thin_space() {
    let page = page_of(&[(
        "a.md",
        "<!-- check: law -->\n\n$$ g = 9.81\\,\\mathrm{m/s^2} \\tag{1} $$\n\nBy (1)\n\n$$ 2 g = 19.62\\,\\mathrm{m/s^2} \\tag{2} $$\n",
    )]);
    let tree = tree(&page);
    let premises = tree.descendants().find(|n| has_class(n, "premises"));
    let text = text_of(premises.expect("premises"));
    assert!(text.contains("g=9.81ms−2"), "{text}");
    assert!(
        page.contains("<mn>9.81</mn><mspace width=\"0.17em\"/><mi mathvariant=\"normal\">m</mi>")
    );
}
