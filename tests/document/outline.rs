//! What a general Markdown reader is asked: front matter, headings, and what is no text.

use super::{cited, displays, headings, problems, read};

#[test]
fn front_matter_ends_at_its_fence() {
    let document = read("---\ntitle: $$\n---\n# One");
    assert_eq!(headings(&document), [(1, "One")]);
    assert_eq!(problems(&document), []);
    assert_eq!(headings(&read("\u{feff}# One")), [(1, "One")]);
    // A rule that happens to come first is none, nor is what is not ended.
    for rule in [
        "---\n\n$$x$$\n\n---\n",
        "---\ntitle: $$x$$\n",
        "---\n---\n$$x$$\n",
        "$$x$$",
    ] {
        assert_eq!(displays(&read(rule)), ["x"], "{rule}");
    }
}

#[test]
fn a_display_has_no_structure() {
    let document = read("Text\n$$\na\n=\n`b\n$$\nmore ` text");
    assert_eq!(headings(&document), []);
    assert_eq!(displays(&document), ["a\n=\n`b"]);
    // The same without the display is a heading.
    assert_eq!(
        headings(&read("Text\n\na\n=\n`b\n\nmore ` text")),
        [(1, "a")]
    );
}

#[test]
fn titles_and_link_targets_are_found() {
    let document = read("# A `b` *c* #\n\nsee [the (3)](x_(2).png) there");
    assert_eq!(headings(&document), [(1, "A `b` *c*")]);
    assert_eq!(
        cited("see [the equation (3)](equation_(2).png) there"),
        "3!"
    );
}
