//! What sentences say beside displays: what is told in passing, how long it is so, and where it is so no more.

use cradle_verify::audit::Audit;
use cradle_verify::derivation::Derivation;
use cradle_verify::document::Document;

/// The verdicts of a text that declares nothing.
fn verdicts(text: &str) -> Vec<&'static str> {
    let audit = Audit::of(&Derivation::new(vec![Document::markdown("a.md", text)]));
    let entries = audit.entries.iter();
    entries.map(|entry| entry.verdict.word()).collect()
}

/// The findings of a text that declares nothing, by their codes, of the last statement.
fn last(text: &str) -> (&'static str, Vec<&'static str>) {
    let audit = Audit::of(&Derivation::new(vec![Document::markdown("a.md", text)]));
    let last = audit.entries.last().unwrap();
    let codes = last.notes.iter().map(|note| note.code()).collect();
    (last.verdict.word(), codes)
}

/// What the last sentence before a display names it may be drawn from, whatever time it is of.
#[test]
fn laws_in_words_link_what_the_displays_say() {
    let page = |height: &str| {
        verdicts(&format!(
            "The stored energy is\n\n$$ U = \\frac12 k d^2 \\tag{{1}} $$\n\nAll of it becomes kinetic energy, $U = K$, where\n\n\
             $$ K = \\frac12 m v^2 \\tag{{2}} $$\n\nso by (1) and (2)\n\n$$ v^2 = \\frac{{k d^2}}{{m}} \\tag{{3}} $$\n\n\
             The block rises until $m g h = K$, which with (2) and (3) gives\n\n$$ h = {height} \\tag{{4}} $$\n"
        ))
    };
    let right = ["given", "given", "holds", "holds"];
    assert_eq!(page(r"\frac{k d^2}{2 m g}"), right);
    assert_eq!(page(r"\frac{k d^2}{m g}")[3], "fails");
    // "At $x = h$" says where.
    let place = "$$ m g x = \\frac12 m v^2 \\tag{1} $$\n\nAt $x = h$ we stop. By (1)\n\n$$ h = \\frac{v^2}{2 g} $$\n";
    assert_ne!(verdicts(place)[1], "holds");
}

#[test]
fn bounds_of_what_is_introduced_and_meanings_outlast_the_section() {
    let page = |setup: &str, between: &str| {
        last(&format!(
            "# Setup\n\n{setup}\n\n# Laws\n\n$$ m v = m w \\tag{{1}} $$\n\n{between}Hence\n\n$$ v = w $$\n"
        ))
    };
    let stated = ("holds", vec![]);
    let unstated = ("holds", vec!["unstated-condition"]);
    for setup in [
        "We assume $m > 0$.",
        "Throughout we assume that $m \\neq 0$.",
        "There are five balls, each of mass $m > 0$.",
        "The mass $m$ is positive.",
        "Let $m > 0$.",
    ] {
        assert_eq!(page(setup, ""), stated, "{setup}");
    }
    // A case is over with its section, and a letter may be introduced anew.
    assert_eq!(page("If $m > 0$, then nothing is lost.", ""), unstated);
    assert_eq!(
        page("We assume $m > 0$.", "Let $m$ be any number. "),
        unstated
    );

    let ratio = |between: &str, end: &str| {
        verdicts(&format!(
            "$$ w (a + b) = a v \\tag{{1}} $$\n\n## Ratio\n\nLet $\\mu = b/a$ be the ratio. From (1)\n\n\
             $$ w = \\frac{{v}}{{1 + \\mu}} \\tag{{2}} $$\n\n## Energy\n\n{between}From (2)\n\n$$ w^2 = {end} $$\n"
        ))[2]
    };
    assert_eq!(ratio("", r"\frac{v^2}{(1 + b/a)^2}"), "holds");
    assert_eq!(ratio("", r"\frac{v^2}{(1 + a/b)^2}"), "fails");
}
