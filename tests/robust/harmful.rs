//! Inputs that are too long to be kept as files, made from what they are long in.

/// Statements that follow one another on a page.
fn page(statements: &[String]) -> Vec<u8> {
    let displays = statements.iter().map(|s| format!("$$ {s} $$\n\nHence\n"));
    displays.collect::<String>().into_bytes()
}

fn named(count: usize) -> Vec<String> {
    (0..count).map(|at| format!("a_{{{at}}}")).collect()
}

/// A name and a page each.
pub fn made() -> Vec<(String, Vec<u8>)> {
    let nested = |open: &str, depth: usize, inside: &str, close: &str| {
        format!("x = {}{inside}{}", open.repeat(depth), close.repeat(depth))
    };
    let fractions: Vec<String> = (0..40)
        .map(|at| format!("\\frac{{1}}{{a_{{{at}}} + b_{{{at}}} + c}}"))
        .collect();
    let rows = "a &= b \\\\ &= c + a \\\\\n".repeat(1_000);
    let go_on = " \\\\ &= b".repeat(2_000);
    let mut all = vec![
        // Each sum over sums is within its bounds; all of them together were not.
        (
            "sums-in-sums.md",
            page(&[nested("\\sum_{i=1}^{n} ", 60, "a", ""), "x = a".into()]),
        ),
        (
            "sums-of-powers.md",
            page(&[
                "x = \\sum_{i=1}^{500} (a + b i)^{50}".into(),
                "x = 1".into(),
            ]),
        ),
        (
            "integrals-in-integrals.md",
            page(&[nested("\\int_0^1 ", 40, "t^{50}", " dt"), "x = a".into()]),
        ),
        // Multiplying out one denominator after another.
        (
            "many-denominators.md",
            page(&["x = 1".into(), format!("{} = 0", fractions.join(" + "))]),
        ),
        // What a step is judged from grew with the square of the steps, or of the terms.
        (
            "many-summands.md",
            page(&[
                format!("x = {}", named(300).join(" + ")),
                format!("x = {}", named(299).join(" + ")),
            ]),
        ),
        (
            "many-names.md",
            page(&[format!("{} = 1", named(1_000).join(" + "))]),
        ),
        (
            "many-sides.md",
            page(&[format!("x = {}", vec!["a"; 3_000].join(" = "))]),
        ),
        (
            "many-implications.md",
            page(&[vec!["a = b"; 3_000].join(" \\Rightarrow ")]),
        ),
        // Each of them may use all before it.
        (
            "many-statements.md",
            page(&[
                named(3_000).join(" = b, "),
                "a_1 = b, \\qquad a_2 = a_1".into(),
            ]),
        ),
        (
            "many-equal-elements.md",
            page(&[
                "u_1 = u_2 = \\dots = u_{4000000000}".into(),
                "u_5 = u_6 + 1".into(),
            ]),
        ),
        (
            "many-rows.tex",
            format!("\\begin{{align}}\n{rows}\\end{{align}}").into_bytes(),
        ),
        (
            "many-rows-of-one-chain.tex",
            format!("\\begin{{align}}\na &= b{go_on}\n\\end{{align}}").into_bytes(),
        ),
        ("many-empty.md", "$$".repeat(5_000).into_bytes()),
        ("many-unclosed.md", "\\[".repeat(2_000).into_bytes()),
        (
            "many-quotations.md",
            format!("{}$$ a = b $$", "> ".repeat(2_000)).into_bytes(),
        ),
        (
            "nested-arrays.ipynb",
            format!("{{\"cells\":{}{}}}", "[".repeat(20_000), "]".repeat(20_000)).into_bytes(),
        ),
    ];
    // Numbers that no machine integer holds, wherever one is read.
    for number in [
        "2147483648",
        "4294967296",
        "9223372036854775808",
        "18446744073709551616",
        "10^{10^9}",
    ] {
        let statements = [
            format!("x^{{{number}}} = y"),
            format!("x^{{-{number}}} x^{{{number}}} = 1"),
            format!("\\sqrt[{number}]{{x}} = x^{{1/{number}}}"),
            format!("y = u_{{{number}}} + \\sum_{{i={number}}}^{{{number}}} u_i"),
            format!("y = \\sum_{{i=1}}^{{n}} i^{{{number}}}"),
            format!("\\sin({number} x) = 0 \\tag{{{number}}}"),
            format!("e^{{{number}}} > \\pi^{{{number}}} \\cdot {number}"),
            format!("x \\sim y^{{{number}}}"),
            format!("\\lim_{{t \\to {number}}} t^{{{number}}} = x"),
        ];
        all.push(("numbers.md", page(&statements)));
        let counted = format!(
            "\\setcounter{{equation}}{{{number}}}\n\\begin{{equation}} a = b \\end{{equation}}\nby ({number})--(9{number}):\n\\begin{{equation}} b = a \\end{{equation}}"
        );
        all.push(("counters.tex", counted.into_bytes()));
    }
    all.into_iter()
        .map(|(name, page)| (name.to_owned(), page))
        .collect()
}
