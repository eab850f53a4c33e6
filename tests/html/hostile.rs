//! Documents that would like to be more than text.

use std::time::{Duration, Instant};

use super::{has_class, page_of, text_of, tree};

const HOSTILE: &str = r#"# <script>alert(1)</script> & "quotes" $\text{<i>}$

<!-- check: symbols x: positive -->
<!-- a comment
<script>alert(2)</script> -->

<script>alert(3)</script>

Text <img src=x onerror=alert(4)> and [click](javascript:alert(5)) and [data](data:text/html,x)
and [entity](javascript&#58;alert(6)) and [web](https://example.org/?a=1&b="x") and ![alt <b>](http://example.org/x.png)
and <a href="https://example.org" onclick="alert(7)">raw</a>, `<code>`, [there](#nowhere), [other](//example.org), [file](a.md).

$$ x_{\text{<script>alert(8)</script>}} = 1 \tag{"><script>alert(9)</script>} $$

$$ x = \foo<script>alert(10)</script> \tag{2} $$

$$ x = x \tag{2} $$

<!-- check: claim a"b<c -->
$$ x^2 = x \cdot x $$

See $\nope{<u>}$ and (2).

```html
<b>]]></b>
```
"#;

/// Documents of which everything is wrong, their names included.
pub(super) const HOSTILE_PAGES: &[(&str, &str)] = &[
    ("<b>&\"'.md", HOSTILE),
    ("b<script>.md", "$$ 1 = 2 \\tag{\u{7}\u{fffe}} $$\n"),
];

/// Names of so many letters wherever there can be one: in a heading, in text, of a symbol, an equation and a claim.
pub(super) fn hostile_names(letters: usize) -> String {
    let long = "W".repeat(letters);
    format!(
        "# {long}\n\n{long} and $x_{{\\text{{{long}}}}}$, `{long}`\n\n\
         <!-- check: symbols x_{{\\text{{{long}}}}}: positive -->\n\n<!-- check: claim {long} -->\n\n\
         $$ x_{{\\text{{{long}}}}} = 1 $$\n\n\
         Therefore\n\n$$ x_{{\\text{{{long}}}}}^2 = 3 x_{{\\text{{{long}}}}} \\tag{{{long}}} $$\n\n\
         ```\n{long}\n```\n\n| {long} |\n|---|\n| {long} |\n"
    )
}

#[test]
fn names_of_ten_thousand_letters_leave_the_page_whole_and_of_their_size() {
    let start = Instant::now();
    // The shorter ones are read, and stand in premises, points and proofs; the others are refused.
    let sizes = [900, 10_000, 20_000].map(|letters| {
        let page = page_of(&[("names.md", &hostile_names(letters))]);
        let tree = tree(&page);
        let equations = tree.descendants().filter(|n| has_class(n, "equation"));
        assert_eq!(equations.count(), 2);
        // A name in a drawing is cut, and so is what an address is made of.
        let drawn = tree.descendants().filter(|n| n.tag_name().name() == "text");
        drawn.for_each(|n| assert!(text_of(n).chars().count() < 200));
        for node in tree.descendants() {
            assert!(node.attribute("id").is_none_or(|id| id.len() < 60));
        }
        page.len()
    });
    assert!(sizes[0] < 200_000 && sizes[1] < 1_000_000, "{sizes:?}");
    assert!(sizes[2] < 3 * sizes[1], "{sizes:?}");
    assert!(
        start.elapsed() < Duration::from_secs(60),
        "{:?}",
        start.elapsed()
    );
}

#[test]
fn nothing_of_a_document_becomes_markup() {
    let page = page_of(HOSTILE_PAGES);
    let tree = tree(&page);
    let scripts: Vec<_> = tree
        .descendants()
        .filter(|n| n.tag_name().name() == "script")
        .collect();
    assert_eq!(scripts.len(), 1);
    assert!(text_of(scripts[0]).contains("use strict"));
    for node in tree.descendants() {
        assert!(
            !["img", "b", "i", "u", "iframe"].contains(&node.tag_name().name()),
            "{:?}",
            node.tag_name()
        );
        assert!(node.attributes().all(|a| !a.name().starts_with("on")));
        if let Some(target) = node.attribute("href") {
            let is_safe = target.starts_with('#')
                || target.starts_with("https://example.org/?a=1&b=")
                || target == "a.md";
            assert!(is_safe, "{target}");
        }
    }
    // Seen as it was typed, but for comments.
    let text = text_of(tree.root());
    for typed in [
        "<script>alert(1)</script>",
        "<script>alert(3)</script>",
        "<img src=x onerror=alert(4)>",
    ] {
        assert!(text.contains(typed), "{typed}");
    }
    assert!(!text.contains("alert(2)"));
    assert!(text.contains("click") && text.contains("[image: alt"));
}

#[test]
fn equations_with_one_number_have_names_of_their_own() {
    let page = page_of(&[("twice.md", HOSTILE)]);
    let tree = tree(&page);
    let names: Vec<&str> = tree
        .descendants()
        .filter(|n| has_class(n, "equation"))
        .filter_map(|n| n.attribute("id"))
        .collect();
    assert_eq!(names.len(), 4);
    let all: std::collections::BTreeSet<&&str> = names.iter().collect();
    assert_eq!(all.len(), 4, "{names:?}");
    assert!(names.iter().all(|n| {
        n.chars()
            .all(|c| c.is_ascii_alphanumeric() || "-._".contains(c))
    }));
}

#[test]
fn what_cannot_be_read_is_set_and_its_source_is_kept() {
    let page = page_of(&[("unread.md", HOSTILE)]);
    let tree = tree(&page);
    let equation = tree
        .descendants()
        .find(|n| n.attribute("id") == Some("eq-2"))
        .unwrap();
    let sheet = equation
        .descendants()
        .find(|n| has_class(n, "sheet"))
        .unwrap();
    assert_eq!(text_of(sheet), "x=foo<script>alert(10)</script>");
    assert!(text_of(equation).contains("x = \\foo<script>"));
    assert!(text_of(equation).contains("could not be read"));
}
