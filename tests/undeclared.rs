//! A LaTeX document as its author wrote it, with nothing declared: laws stand in the middle of the text, data are measured, and steps cite
//! what they follow from. Nothing in it fails; each slip of the pen does, where it is made and nowhere else.

use cradle_verify::audit::{Audit, Entry, Note, Verdict};
use cradle_verify::derivation::Derivation;
use cradle_verify::document::Document;

const LECTURE: &str = include_str!("documents/lecture.tex");

/// What is amiss: the number of the equation, and the verdict or the note.
fn amiss(text: &str) -> Vec<(String, &'static str)> {
    let derivation = Derivation::new(Document::latex("lecture.tex", text, &()));
    let audit = Audit::of(&derivation);
    let number = |entry: &Entry| {
        let tag = &derivation.equations[entry.equation].tag;
        tag.clone().unwrap_or_default()
    };
    let mut all = Vec::new();
    for entry in &audit.entries {
        if entry.is_wrong() || entry.verdict == Verdict::Undecided {
            all.push((number(entry), entry.verdict.word()));
        }
        let grave = |note: &&Note| note.is_finding() && !matches!(note, Note::RestsOn(_));
        let notes = entry.notes.iter().filter(grave);
        all.extend(notes.map(|note| (number(entry), note.code())));
    }
    all
}

/// That something falls at all is the one thing that a reader has to know.
fn known() -> (String, &'static str) {
    ("3".into(), "unstated-condition")
}

#[test]
fn nothing_fails_where_nothing_is_declared() {
    assert_eq!(amiss(LECTURE), [known()]);
}

#[test]
fn each_slip_fails_where_it_is_made() {
    let slips = [
        (
            r"x = \frac{2 v_x v_y}{g}.",
            r"x = \frac{2 v_x v_y}{g^2}.",
            "4",
        ),
        (r"\sin 2\theta}{g}", r"\sin^2\theta}{g}", "6"),
        (r"+ k q \dot{q} = 0", r"- k q \dot{q} = 0", "9"),
        (
            r"\dot{E} = m \dot{q}\ddot{q}",
            r"\dot{E} = m \dot{q}\dot{q}",
            "9",
        ),
        (r"\frac{Q^2}{2 C}", r"\frac{Q^2}{C}", "12"),
        ("C = C_1 + C_2", "C = C_1 - C_2", "14"),
        ("C = C_1 + C_2", "C = C_1 + 2 C_2", "14"),
        (r"U_i = \frac32 p V", r"U_i = \frac23 p V", "17"),
        (r"\frac{f}{g_o - f}", r"\frac{g_o}{g_o - f}", "21"),
        (r"M = \frac12", r"M = \frac13", "23"),
    ];
    for (right, wrong, number) in slips {
        assert!(LECTURE.contains(right), "{right}");
        let found = amiss(&LECTURE.replacen(right, wrong, 1));
        let fails: Vec<&str> = found
            .iter()
            .filter(|(_, what)| *what == "fails")
            .map(|(number, _)| number.as_str())
            .collect();
        assert_eq!(fails, [number], "{wrong}: {found:?}");
    }
}

#[test]
fn a_law_with_the_wrong_sign_fails_where_it_is_used() {
    for (right, wrong, number) in [
        (r"m \ddot{q} = -k q", r"m \ddot{q} = k q", "9"),
        ("Q = C_1 U + C_2 U", "Q = C_1 U - C_2 U", "14"),
    ] {
        let found = amiss(&LECTURE.replacen(right, wrong, 1));
        assert!(
            found.contains(&(number.into(), "fails")),
            "{wrong}: {found:?}"
        );
    }
}

#[test]
fn laws_come_after_laws() {
    let verdicts = |text: &str| -> Vec<&'static str> {
        let audit = Audit::of(&Derivation::from_markdown("page.md", text));
        let entries = audit.entries.iter();
        entries.map(|entry| entry.verdict.word()).collect()
    };
    let momentum = "Momentum is conserved,\n\n$$ m_1 u = m_1 v_1 + m_2 v_2 \\tag{1} $$\n\n";
    let energy = "\n\n$$ m_1 u^2 = m_1 v_1^2 + m_2 v_2^2 \\tag{2} $$\n";
    let said = |words: &str| verdicts(&format!("{momentum}{words}{energy}"));
    assert_eq!(said("and so is kinetic energy,"), ["given", "given"]);
    assert_eq!(said("and so kinetic energy is"), ["given", "fails"]);
    let wheel = "The acceleration is\n\n$$ a = \\frac{g}{1 + \\frac{I}{m R^2}} \\tag{1} $$\n\n";
    let inertia =
        "\n\n$$ I = \\frac12 m R^2 \\tag{2} $$\n\nand so\n\n$$ a = \\frac23 g \\tag{3} $$\n";
    let said = |words: &str| verdicts(&format!("{wheel}{words}{inertia}"));
    assert_eq!(
        said("For a solid cylinder the moment of inertia is"),
        ["given", "given", "holds"]
    );
    assert_eq!(said("Hence the moment of inertia is")[1], "fails");
}
