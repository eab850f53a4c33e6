//! What is said where a claim about every element of a sequence is not proved.

use cradle_verify::derivation::Derivation;

use crate::common;

fn said(domain: &str) -> String {
    let page = format!(
        "<!-- check: symbols n: {domain} -->\n<!-- check: law -->\n$$ c_{{n+1}} = c_n + 2, \\qquad c_0 = 1 \\tag{{1}} $$\n\nFrom (1)\n\n$$ c_n = 2 n + 1 \\tag{{2}} $$\n"
    );
    let derivation = Derivation::from_markdown("page.md", &page);
    common::human(&derivation)
}

#[test]
fn where_a_sequence_begins_is_said() {
    let text = said("natural");
    assert!(text.contains("nothing says how `c₀` goes on"), "{text}");
    let text = said("integer, >= 0");
    assert!(text.contains("Nothing is amiss"), "{text}");
}
