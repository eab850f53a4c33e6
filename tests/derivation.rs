//! Derivations: which names can be told apart.

use cradle_verify::audit::Audit;
use cradle_verify::derivation::Derivation;

fn read(page: &str) -> Vec<bool> {
    let derivation = Derivation::from_markdown("page.md", page);
    let read = derivation.equations.iter().map(|e| e.statements.is_ok());
    read.collect()
}

#[test]
fn differentials_are_read_where_each_term_has_one() {
    assert_eq!(read(r"$$ dU = T\,dS - p\,dV $$"), [true]);
    assert_eq!(read(r"$$ \mathrm{d}U = T \mathrm{d}S $$"), [true]);
    assert_eq!(read(r"$$ dU = T\,dS - p\,V $$"), [false]);
    assert_eq!(read(r"$$ dS \geq dQ $$"), [false]);
    // Derivatives and integrals are understood.
    assert_eq!(read(r"$$ \frac{dU}{dT} = \int_0^T c\, dT $$"), [true]);
    // Before a parenthesis and before a power they are differentials too.
    assert_eq!(read(r"$$ \mathrm{d}(v^2) = 2v\,\mathrm{d}v $$"), [true]);
    assert_eq!(read(r"$$ d(x^2) = 2x\,dx $$"), [true]);
    assert_eq!(read(r"$$ dx^2 = 2x\,dx $$"), [false]);
    assert_eq!(read(r"$$ d(xy) = x\,dy + y\,dx $$"), [true]);
    // Small changes have names, and no rules.
    assert_eq!(read(r"$$ \delta(x^2) = 2x\delta x $$"), [false]);
    assert_eq!(read(r"$$ \delta W = F\,\delta x $$"), [true]);
    assert_eq!(read(r"$$ ds^2 = dx^2 + dy^2 $$"), [false]);
    assert_eq!(read(r"$$ P = d(m v^2)/dt $$"), [true]);
    // An upright one needs no second.
    for single in ["v = a", "(v) = a", "^2 x = a", "(v^2) = 2 v a"] {
        assert_eq!(
            read(&format!(r"$$ \mathrm{{d}}{single} $$")),
            [false],
            "{single}"
        );
    }
    // What a page shows in one display is so in the next.
    assert_eq!(read("$$ dU = T\\,dS $$\n$$ dU = 0 $$"), [true, true]);
    assert_eq!(read("$$ dU = T\\,dS $$\n$$ dU = 1 $$"), [true, false]);
}

#[test]
fn distance_is_no_differential() {
    assert_eq!(read("$$ d = v t $$\n$$ d a = d b $$"), [true, true]);
    let declared = "<!-- check: symbols d: length -->\n$$ d a = d b $$";
    assert_eq!(read(declared), [true]);
    assert_eq!(read("$$ F = q d E $$"), [true]);
    // A product with a sum, and what the text speaks of.
    assert_eq!(read("$$ A = d(a + b) $$"), [true]);
    assert_eq!(read("$$ A = d(a + b) + d c $$"), [false]);
    let spoken_of = "Between the plates is a distance $d$.\n\n$$ A = d(a + b) + d c $$";
    assert_eq!(read(spoken_of), [true]);
    assert_eq!(read(r"$$ A = d \cdot (a + b) + d^2 $$"), [true]);
    assert_eq!(
        read("$$ F = k \\delta^2 $$\n$$ \\delta a = \\delta(b + c) $$"),
        [true, true]
    );
    let upright = "<!-- check: symbols \\text{d}: length -->\n$$ \\mathrm{d}(a + b) = c $$";
    assert_eq!(read(upright), [true]);
    // In the middle of a chain it stands once.
    assert_eq!(read("$$ W = q d E = F $$"), [true]);
}

#[test]
fn one_symbol_does_not_lie_in_two_places() {
    let clashes = |first: &str, second: &str| {
        let declared = |own: &str| format!("<!-- check: symbols k: {own} -->\n\n");
        let page = format!("# A\n\n{}Words.\n\n{}", declared(first), declared(second));
        Derivation::from_markdown("page.md", &page).pages[0]
            .clashes
            .len()
    };
    assert_eq!(clashes("natural", "positive"), 1);
    assert_eq!(clashes("mass, in (0, 1]", "nonnegative"), 1);
    assert_eq!(clashes("integer", ">= 1"), 1);
    // The same again, or something else about it.
    for (first, second) in [
        ("positive", "positive, constant"),
        ("mass", "positive"),
        ("positive", "mass"),
        ("positive", "> 1"),
        ("real", "positive"),
        ("positive", "constant"),
        ("constant", "positive"),
    ] {
        assert_eq!(clashes(first, second), 0, "{first}; {second}");
    }
}

/// Two sections in which `k` is a number of balls and a stiffness, the latter with an equation, and a third one.
fn two_meanings(second: &str, third: &str) -> Audit {
    Audit::of(&Derivation::from_markdown(
        "page.md",
        &format!(
            "# Balls\n\n<!-- check: symbols k: natural -->\n\n$$ n = k + 1 \\tag{{1}} $$\n\nHence\n\n$$ n \\geq 2 \\tag{{2}} $$\n\n\
             # Springs\n\n<!-- check: symbols k: positive -->\n\nA spring of stiffness $k$:\n\n$$ F = k x \\tag{{3}} $$\n\n{second}\n\n\
             # Balls again\n\n{third}\n"
        ),
    ))
}

fn last_verdict(audit: &Audit) -> &'static str {
    audit.entries.last().unwrap().verdict.word()
}

#[test]
fn a_letter_may_mean_something_else_in_a_section() {
    let second = |words: &str, formula: &str| {
        let audit = two_meanings(&format!("{words}\n\n$$ {formula} \\tag{{4}} $$"), "");
        assert_eq!(audit.entries[1].verdict.word(), "holds");
        last_verdict(&audit)
    };
    // It is what it is declared to be here.
    assert_eq!(second("Hence", "k > 0"), "holds");
    assert_eq!(second("Hence", "k \\geq 1"), "fails");
    assert_eq!(second("By (3)", "2 F = 2 k x"), "holds");
    // What is cited from above speaks of the number of balls.
    assert_eq!(second("By (1) and (3)", "F = (n - 1) x"), "fails");
    assert_eq!(second("By (1)", "n \\geq 2"), "holds");
    // Subsections belong to the section.
    assert_eq!(second("## More\n\nBy (3)", "F/2 = k x/2"), "holds");
}

#[test]
fn behind_its_section_a_letter_means_what_it_meant() {
    let third = |words: &str, formula: &str| {
        let formula = format!("{words}\n\n$$ {formula} \\tag{{4}} $$");
        last_verdict(&two_meanings("", &formula))
    };
    assert_eq!(third("By (1)", "k \\geq 1"), "holds");
    assert_eq!(third("By (1) and (3)", "F = (n - 1) x"), "fails");
}

#[test]
fn a_dimension_is_that_of_the_section() {
    let page = "<!-- check: symbols \\mu: dimensionless, in [0, 1]; symbols F, N: force -->\n\n# Friction\n\n$$ F = \\mu N \\tag{1} $$\n\n\
                # Two bodies\n\n<!-- check: symbols \\mu, m_1, m_2: mass, positive -->\n\nThe reduced mass is\n\n$$ \\mu = \\frac{m_1 m_2}{m_1 + m_2} \\tag{2} $$\n\n\
                Hence\n\n$$ \\mu < m_1 \\tag{3} $$\n";
    let derivation = Derivation::from_markdown("page.md", page);
    assert!(derivation.pages[0].problems.is_empty());
    assert!(derivation.pages[0].clashes.is_empty());
    let audit = Audit::of(&derivation);
    let verdicts: Vec<&str> = audit.entries.iter().map(|e| e.verdict.word()).collect();
    assert_eq!(verdicts, ["given", "given", "holds"]);
}

#[test]
fn a_letter_is_printed_as_it_is_written_and_told_apart_where_both_occur() {
    let second = "By (1) and (3)\n\n$$ F = (n - 1) x \\tag{4} $$";
    let page = format!(
        "# Balls\n\n<!-- check: symbols k: natural -->\n\n$$ n = k + 1 \\tag{{1}} $$\n\n# Springs\n\n<!-- check: symbols k: positive -->\n\n\
         The force is\n\n$$ F = k x \\tag{{3}} $$\n\n{second}\n"
    );
    let derivation = Derivation::from_markdown("page.md", &page);
    let text = crate::common::reported(&derivation, |report| report.human(false));
    assert!(text.contains("(3): F = k x"), "{text}");
    assert!(text.contains("k (line 9) = "), "{text}");
    assert!(!text.contains('\u{1f}'), "{text}");
}
