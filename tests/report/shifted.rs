//! The citations of the report that are all off by 41, with a slip of the pen in one of the equations that are cited.

use cradle_verify::audit::{Audit, Note};
use cradle_verify::derivation::Derivation;
use cradle_verify::document::Document;
use cradle_verify::proofs;

/// By how much each citation is said to be off, where one equation of the report reads otherwise.
fn shifts(right: &str, wrong: &str) -> Vec<i64> {
    let mut found = 0;
    let pages = proofs::PAGES.iter().map(|(path, text)| {
        found += text.matches(right).count();
        Document::markdown(*path, text.replace(right, wrong))
    });
    let derivation = Derivation::new(pages.collect());
    assert_eq!(found, 1, "{right}");
    let audit = Audit::of(&derivation);
    let notes = audit.entries.iter().flat_map(|entry| &entry.notes);
    let by = notes.filter_map(|note| match note {
        Note::CitationsShifted { by, .. } => Some(*by),
        _ => None,
    });
    by.collect()
}

#[test]
fn a_slip_in_what_is_cited_changes_no_number() {
    for (right, wrong, fewest) in [
        (r"m_2 v'_2}{m_1} \tag{45}", r"m_2 v'_2}{m_2} \tag{45}", 2),
        (r"v_0} \tag{54}", r"v_1} \tag{54}", 4),
        (
            r"\boxed{v'_1 = \frac{m_1 - m_2}",
            r"\boxed{v'_1 = \frac{m_1 + m_2}",
            5,
        ),
        (r"\right)^2 \tag{62}", r"\right)^3 \tag{62}", 6),
        (
            r"4\mu}{(1+\mu)^2}} \tag{64}",
            r"4\mu}{(1+\mu)^3}} \tag{64}",
            7,
        ),
    ] {
        let by = shifts(right, wrong);
        assert!(
            by.len() >= fewest && by.iter().all(|&by| by == 41),
            "{wrong}: {by:?}"
        );
    }
}

/// Where the number of what is cited is right and its text is wrong, no number is told; nor one that follows only together with what is wrong.
#[test]
fn a_wrong_equation_that_is_cited_is_no_wrong_number() {
    let page = r"
<!-- check: symbols x, y: positive -->

<!-- check: law -->
$$ y = x^2 \tag{1} $$

By (1)
$$ \frac{y}{x} = 2 x \tag{3} $$

By (3)
$$ \frac{y}{x^2} = 1 \tag{4} $$

By (3)
$$ y^2 = x^4 \tag{5} $$
";
    let audit = Audit::of(&Derivation::from_markdown("page.md", page));
    let codes = |notes: &[Note]| -> Vec<&str> { notes.iter().map(Note::code).collect() };
    let found: Vec<Vec<&str>> = audit.entries.iter().map(|e| codes(&e.notes)).collect();
    let [_, wrong, rest @ ..] = &found[..] else {
        panic!("{found:?}");
    };
    assert!(wrong.is_empty());
    assert_eq!(rest, [["miscited"], ["miscited"]]);
}
