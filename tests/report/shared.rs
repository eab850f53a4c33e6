//! What several equations share is told once: on the page for people, and on that for a browser; programs are told of each.

use cradle_verify::derivation::Derivation;
use cradle_verify::report::html::Pictures;
use cradle_verify::report::remark::Remark;

use crate::common;

/// Two numbers that cannot be read, one of them twice, and what is said to follow from them.
const UNREAD: &str = r"
$$ p = q \foo \tag{1} $$

$$ r = s \foo \tag{2} $$

$$ w = x \tag{3} $$

From (1) and (2),

$$ p = r + w, \qquad r = w - 1 \tag{4} $$

and from (1), (2) and (3)

$$ 2 p = r + x \tag{5} $$

From (1) and (2) again,

$$ 3 p = r + x \tag{6} $$
";

#[test]
fn what_rests_on_the_same_unreadable_equations_is_told_once() {
    let derivation = Derivation::from_markdown("page.md", UNREAD);
    let text = common::human(&derivation);
    let told = |text: &str| text.matches("unreadable-premise").count();
    assert_eq!(told(&text), 1, "{text}");
    for line in [
        "(4), (5) and (6) are not judged: (1) and (2) could not be read",
        "= likewise: (5) at page.md:",
        "= likewise: (6) at page.md:",
    ] {
        assert_eq!(text.matches(line).count(), 1, "{line}\n{text}");
    }
    assert!(
        text.contains("? undecided (1) and (2) could not be read"),
        "{text}"
    );
}

#[test]
fn each_of_them_is_told_where_it_stands_to_programs_and_once_for_all_it_lacks() {
    let derivation = Derivation::from_markdown("page.md", UNREAD);
    let remarks = common::reported(&derivation, |report| {
        report.remarks(std::path::Path::new("."), &Default::default())
    });
    let of = |remark: &&Remark| remark.code == "unreadable-premise";
    let titles: Vec<&str> = remarks.iter().filter(of).map(|r| &*r.title).collect();
    assert_eq!(
        titles,
        [
            "equation (4), statement 1 of 2, is not judged: (1) and (2) could not be read",
            "equation (4), statement 2 of 2, is not judged: (1) and (2) could not be read",
            "equation (5) is not judged: (1) and (2) could not be read",
            "equation (6) is not judged: (1) and (2) could not be read",
        ]
    );
}

#[test]
fn the_page_for_a_browser_groups_them_in_the_same_way() {
    let derivation = Derivation::from_markdown("page.md", UNREAD);
    let page = common::reported(&derivation, |report| report.html(&Pictures::default()));
    let found = page.matches(">unreadable-premise<").count();
    assert_eq!(found, 1, "{page}");
}

#[test]
fn what_has_no_number_is_called_by_its_place_once() {
    let page = r"
$$ w = x \foo $$

Hence

$$ x = w $$

and

$$ y = w $$
";
    let derivation = Derivation::from_markdown("page.md", page);
    let text = common::human(&derivation);
    assert!(!text.contains("at page.md:2:4 is at"), "{text}");
    assert!(!text.contains("at page.md:10:4 at"), "{text}");
}

#[test]
fn where_nothing_was_read_the_sentence_says_so() {
    let derivation = Derivation::from_markdown("page.md", "$$ a = b");
    let text = common::human(&derivation);
    assert!(text.contains("No displayed equation was read.\n"), "{text}");
}
