//! A LaTeX document as its author wrote it, with nothing declared: laws stand in the middle of the text, data are measured, and steps cite
//! what they follow from. Nothing in it fails; each slip of the pen does, where it is made and nowhere else.

use cradle_verify::audit::{Audit, Entry, Note, Verdict};
use cradle_verify::derivation::Derivation;
use cradle_verify::document::Document;

use crate::common::verdicts;

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

/// The verdict on each statement.
#[test]
fn a_page_does_not_begin_with_what_is_no_law() {
    let begins = |words: &str, formula: &str| verdicts(&format!("{words}\n\n$$ {formula} $$\n"))[0];
    let cases = [
        // It speaks of nothing that could be otherwise.
        ("", r"\int_0^1 x^3 \, dx = \frac13", "fails"),
        ("", r"\int_0^1 x^3 \, dx = \frac14", "holds"),
        // Something is worked out.
        ("", r"\frac{d}{dx} \sin(x^2) = \cos(x^2)", "fails"),
        ("", r"\frac{d}{dx} \sin(x^2) = 2 x \cos(x^2)", "holds"),
        ("", r"\int_0^a x^2 \, dx = \frac{a^3}{2}", "fails"),
        ("Hence", r"(a + b)^2 = a^2 + b^2", "fails"),
        (
            "Multiplying out gives",
            r"(a + b)(a - b) = a^2 + b^2",
            "fails",
        ),
        // What is supposed says all that it speaks of.
        ("Let $f(x) = x^3$. Then", r"\frac{df}{dx} = 2 x^2", "fails"),
        ("Let $f(x) = x^3$. Then", r"\frac{df}{dx} = 3 x^2", "holds"),
        ("Suppose $a = b$ and $b = 2 c$. Then", r"a = 3 c", "fails"),
        // These may be laws, models, equations to be solved.
        ("", r"x^2 = 3 x - 2", "given"),
        ("The lemniscate is", r"(x^2 + y^2)^2 = x^2 - y^2", "given"),
        (
            "The differential equation",
            r"\frac{d}{dx} (x y) = x + y",
            "given",
        ),
        ("", r"\frac{dv}{dt} = -k v", "given"),
        (
            "",
            r"\frac{d}{dr} \left( r^2 \frac{dT}{dr} \right) = T r^2",
            "given",
        ),
        ("", r"\sum_{i=1}^{n} m_i = n m", "given"),
        ("", r"\int_0^a F \, dx = F b", "given"),
        ("Let $x = v t$. Then", r"y = w t", "given"),
        ("", r"1\,\text{km} = 1000\,\text{m}", "holds"),
    ];
    for (words, formula, verdict) in cases {
        assert_eq!(begins(words, formula), verdict, "{words} {formula}");
    }
}

#[test]
fn an_identity_does_not_drown_in_what_fails_before_it() {
    let text = r"
$$ \int_0^1 x^3 \, dx = \frac13 $$

$$ \frac{d}{dx} x^3 = 2 x^2 $$

$$ \frac{d}{dx} x^4 = 4 x^3 $$
";
    assert_eq!(verdicts(text), ["fails", "fails", "holds"]);
}

#[test]
fn who_takes_the_slope_of_a_product_lets_all_factors_change() {
    let conditional = |words: &str| {
        let text =
            format!("Let $y = u v$. {words}\n\n$$ \\frac{{dy}}{{dx}} = u \\frac{{dv}}{{dx}} $$\n");
        let audit = Audit::of(&Derivation::from_markdown("page.md", &text));
        let conditional = |note: &Note| matches!(note, Note::UnstatedCondition(_));
        audit.entries[0].notes.iter().any(conditional)
    };
    assert!(conditional("By the product rule,"));
    assert!(conditional("With Leibniz' rule we find"));
    assert!(!conditional("Hence"));
}

/// Where all that changes is the variable itself, the factors are written in it.
#[test]
fn the_quotient_rule_needs_nothing_but_the_variable_to_change() {
    let page = |slope: &str| {
        verdicts(&format!(
            "The power is\n\n$$ P = \\frac{{E^2 R}}{{(r + R)^2}} $$\n\nQuotient rule:\n\n$$ \\frac{{dP}}{{dR}} = {slope} $$\n"
        ))
    };
    let right = r"E^2 \frac{(r + R)^2 - 2 R (r + R)}{(r + R)^4}";
    assert_eq!(page(right)[1], "holds");
    let wrong = r"E^2 \frac{(r + R)^2 - R (r + R)}{(r + R)^4}";
    assert_eq!(page(wrong)[1], "fails");
}

#[test]
fn where_is_said_of_all_displays_of_its_sentence() {
    let two =
        "$$ K = m v^2 \\tag{1} $$\n\nand\n\n$$ V = m x \\tag{2} $$\n\nwhere $m = 2 a$. Hence\n\n";
    let after = |formula: &str| verdicts(&format!("{two}$$ {formula} $$\n"))[2];
    assert_eq!(after("K = 2 a v^2"), "holds");
    assert_eq!(after("V = 2 a x"), "holds");
    assert_eq!(after("K = 3 a v^2"), "fails");
    // And it is differentiated.
    let area = r"The area is

$$ A = \pi r^2 \tag{1} $$

where $r = v t$. Hence

";
    let slope = |formula: &str| verdicts(&format!("{area}$$ {formula} $$\n"))[1];
    assert_eq!(slope(r"\frac{dA}{dt} = 2 \pi v^2 t"), "holds");
    assert_eq!(slope(r"\frac{dA}{dt} = \pi v^2 t"), "fails");
}

#[test]
fn primes_on_functions_are_slopes() {
    let after = |words: &str, formula: &str| verdicts(&format!("{words}\n\n$$ {formula} $$\n"))[0];
    let cases = [
        ("Let $f(x) = x^3$. Then", "f'(x) = 3 x^2", "holds"),
        ("Let $f(x) = x^3$. Then", "f'(x) = 3 x^3", "fails"),
        ("Let $f(x) = x^3$. Then", "f''(x) = 6 x", "holds"),
        ("Let $f(x) = x^3$. Hence", "f' = 3 x^2", "holds"),
        (
            "Let $f(x) = x^3 e^{2 x}$. Then",
            "f'(x) = 3 x^2 e^{2 x} + x^3 e^{2 x}",
            "fails",
        ),
        (
            "The profit is $P(q) = a q - b q^2$, hence",
            "P'(q) = a - 2 b q",
            "holds",
        ),
        (
            "The profit is $P(q) = a q - b q^2$, hence",
            "P'(q) = a - b q",
            "fails",
        ),
        // A prime on what is given in the time is another quantity, in another frame or afterwards.
        (
            "With $x(t) = v t$ and $x'(t) = x(t) - u t$ we have",
            "x'(t) = (v - u) t",
            "holds",
        ),
        ("The velocity is $v(t) = a t$. Then", "v'(t) = a", "given"),
        // It is declared or given as a name of its own.
        ("Consider $y = x^3$. Then", "y' = 3 x^2", "given"),
    ];
    for (words, formula, verdict) in cases {
        assert_eq!(after(words, formula), verdict, "{words} {formula}");
    }
}

#[test]
fn a_solution_goes_through_what_it_begins_with() {
    let solved = |words: &str, formula: &str| {
        let law = "Kirchhoff says\n\n$$ R \\frac{dq}{dt} + \\frac{q}{C} = 0 \\tag{1} $$\n\n";
        verdicts(&format!("{law}{words}\n\n$$ {formula} $$\n"))[1]
    };
    for words in [
        "Its solution is",
        "Its solution with $q(0) = q_0$ is",
        "Its solution with $q = q_0$ at $t = 0$ is",
        "At $t = 0$ the charge is $q = q_0$. The solution of (1) is",
        "Separating the variables and integrating,",
    ] {
        assert_eq!(solved(words, "q = q_0 e^{-t/(R C)}"), "holds", "{words}");
        assert_ne!(solved(words, "q = q_0 e^{-2 t/(R C)}"), "holds", "{words}");
    }
    // It begins with something else.
    let late = "Its solution with $q = q_0$ at $t = 1$ is";
    assert_ne!(solved(late, "q = q_0 e^{-t/(R C)}"), "holds");
}

#[test]
fn what_is_told_in_passing_is_said_of_all_that_it_speaks_of() {
    let before = "$$ a = b \\tag{1} $$\n\n";
    let after =
        |words: &str, formula: &str| verdicts(&format!("{before}{words}\n\n$$ {formula} $$\n"))[1];
    // It can be differentiated, and solved for what it is not about.
    let momentum = "The momentum is $p = m v$. Thus";
    let slope = r"\frac{dp}{dt} = m \frac{dv}{dt} + v \frac{dm}{dt}";
    assert_eq!(after(momentum, slope), "holds");
    assert_eq!(after(momentum, &slope.replace('+', "-")), "fails");
    assert_eq!(
        after("The speed is $v = s/t$. Therefore", "s = v t"),
        "holds"
    );
    assert_eq!(
        after("The speed is $v = s/t$. Therefore", "s = v t^2"),
        "fails"
    );
    // A new symbol may still be given a meaning.
    assert_eq!(
        after("The speed is $v = s/t$. The way is", "s = w u"),
        "given"
    );
}

#[test]
fn laws_come_after_laws() {
    let momentum = "Momentum is conserved,\n\n$$ m_1 u = m_1 v_1 + m_2 v_2 \\tag{1} $$\n\n";
    let energy = "\n\n$$ m_1 u^2 = m_1 v_1^2 + m_2 v_2^2 \\tag{2} $$\n";
    let said = |words: &str| verdicts(&format!("{momentum}{words}{energy}"));
    assert_eq!(said("and so is kinetic energy,"), ["given", "given"]);
    assert_eq!(said("and so kinetic energy is"), ["given", "undecided"]);
    let wheel = "The acceleration is\n\n$$ a = \\frac{g}{1 + \\frac{I}{m R^2}} \\tag{1} $$\n\n";
    let inertia =
        "\n\n$$ I = \\frac12 m R^2 \\tag{2} $$\n\nand so\n\n$$ a = \\frac23 g \\tag{3} $$\n";
    let said = |words: &str| verdicts(&format!("{wheel}{words}{inertia}"));
    assert_eq!(
        said("For a solid cylinder the moment of inertia is"),
        ["given", "given", "holds"]
    );
    assert_eq!(said("Hence the moment of inertia is")[1], "undecided");
}

#[test]
fn an_integrand_is_what_an_equation_says_of_it() {
    let force = "A spring pulls with\n\n$$ F = k x \\tag{1} $$\n\n";
    let work =
        "The work done in stretching it to $L$ is\n\n$$ W = \\int_0^L F \\, dx \\tag{2} $$\n\n";
    let after = |words: &str, value: &str| {
        let page = format!("{force}{work}{words}\n\n$$ W = {value} \\tag{{3}} $$\n");
        verdicts(&page)[2]
    };
    let at_once = |value: &str| {
        let page = format!("{force}By (1),\n\n$$ W = \\int_0^L F \\, dx = {value} \\tag{{2}} $$\n");
        verdicts(&page)[1]
    };
    for words in ["so", "By (1) and (2),"] {
        assert_eq!(after(words, r"\frac{k L^2}{2}"), "holds", "{words}");
        assert_ne!(after(words, r"\frac{k L^3}{3}"), "holds", "{words}");
    }
    assert_eq!(at_once(r"\frac{k L^2}{2}"), "holds");
    assert_eq!(at_once(r"k L^2"), "fails");
}

#[test]
fn what_would_follow_with_what_is_left_open_is_left_open() {
    let growth = "The population grows by\n\n$$ \\frac{dN}{dt} = r N \\left(1 - \\frac{N}{K}\\right) \\tag{1} $$\n\n\
        with constant $r > 0$ and $K > 0$. To solve it, let $u = 1/N$. Then\n\n\
        $$ \\frac{du}{dt} = -\\frac{1}{N^2} \\frac{dN}{dt} \\tag{2} $$\n\n\
        and inserting (1) we find a linear equation,\n\n$$ \\frac{du}{dt} = -r u + \\frac{r}{K} \\tag{3} $$\n\n\
        Its general solution is\n\n$$ u(t) = \\frac{1}{K} + c e^{-r t} \\tag{4} $$\n\n\
        where $c$ is a constant. Hence\n\n$$ N(t) = \\frac{K}{1 + c K e^{-r t}} \\tag{5} $$\n\n";
    let rate = "The growth rate $G = r N (1 - N/K)$ is largest when\n\n\
        $$ \\frac{dG}{dN} = r - \\frac{2 r N}{K} = 0 \\tag{6} $$\n";
    // A growth rate that speaks of what was so before is not read.
    let delayed = growth.replace(r"\frac{N}{K}\right)", r"\frac{N (t - s)}{K}\right)");
    let found = verdicts(&format!("{delayed}{rate}"));
    assert!(found[..5].contains(&"undecided"), "{found:?}");
    assert_eq!(found[5], "undecided");
    assert_eq!(verdicts(&format!("{growth}{rate}"))[5], "undecided");
}

#[test]
fn a_step_may_divide_by_what_nobody_says_is_not_zero() {
    let laws = "$$ m_1 (u - v_1) = m_2 v_2 \\tag{1} $$\n\nand\n\n$$ m_1 (u^2 - v_1^2) = m_2 v_2^2 \\tag{2} $$\n\n";
    let step = |words: &str, sum: &str| {
        verdicts(&format!("{laws}{words}\n\n$$ {sum} = v_2 \\tag{{3}} $$\n"))[2]
    };
    for words in [
        "Dividing (2) by (1), which is allowed because $v_2 \\neq 0$, we get",
        "Dividing (2) by (1) with $v_2 \\neq 0$ we get",
    ] {
        assert_eq!(step(words, "u + v_1"), "holds", "{words}");
        assert_eq!(step(words, "u - v_1"), "fails", "{words}");
    }
    let lens =
        "$$ \\frac1f = (n - 1) \\left(\\frac{1}{R_1} - \\frac{1}{R_2}\\right) \\tag{1} $$\n\n";
    let words = "For a symmetric lens, $R_1 = R$ and $R_2 = -R$, so";
    let focus = |value: &str| verdicts(&format!("{lens}{words}\n\n$$ f = {value} $$\n"))[1];
    assert_eq!(focus(r"\frac{R}{2 (n - 1)}"), "holds");
    assert_eq!(focus(r"\frac{R}{n - 1}"), "fails");
}

#[test]
fn what_is_said_of_one_case_is_said_of_no_other() {
    let page = |words: &str, formula: &str| verdicts(&format!("{words}\n\n$$ {formula} $$\n"))[0];
    let cases = [
        // Two meanings, of which nobody can tell which is meant.
        (
            "Let $y = x^3$ in the first case and $y = x^2$ in the second. In the second,",
            r"\frac{dy}{dx} = 2 x",
            "given",
        ),
        // Places.
        (
            "Inside, $E = k Q r/R^3$. Outside $E = k Q/r^2$. At the surface both give",
            r"E = \frac{k Q}{R^2}",
            "given",
        ),
        // What a word means is a condition, what "this" means is a conclusion.
        (
            "Let $R = p q$ and $C = F + c q$. Break-even means",
            "R = C",
            "given",
        ),
        (
            "Let $R = p q$ and $C = F + c q$. This means",
            "R = C",
            "undecided",
        ),
        // A special case that the text leaves.
        (
            "For $x = 2 a$ the force vanishes. In general",
            "x^2 = 4 a^2",
            "given",
        ),
    ];
    for (words, formula, verdict) in cases {
        assert_eq!(page(words, formula), verdict, "{words}");
    }
    let rod = "$$ q = m g \\tag{1} $$\n\nFor $L = 2 a$ the rod touches the wall. In general, by (1),\n\n$$ q L = 2 m g a \\tag{2} $$\n";
    assert_eq!(verdicts(rod), ["given", "undecided"]);
}

#[test]
fn what_holds_at_all_times_says_more_than_at_one() {
    let law = "$$ m \\ddot x = -k x $$\n\nWe try\n\n$$ x = A \\cos(\\omega t) $$\n\nSubstituting gives\n\n";
    let step = |formula: &str| verdicts(&format!("{law}$$ {formula} $$\n"))[2];
    assert_eq!(step(r"\omega^2 = \frac{k}{m}"), "holds");
    assert_eq!(step(r"\omega^2 = \frac{m}{k}"), "fails");
    let damped = "$$ m \\frac{d^2 x}{dt^2} + b \\frac{dx}{dt} + k x = 0 $$\n\nWe try\n\n$$ x = A e^{r t} $$\n\nThis gives\n\n";
    let step = |formula: &str| verdicts(&format!("{damped}$$ {formula} $$\n"))[2];
    assert_eq!(step("m r^2 + b r + k = 0"), "holds");
    assert_ne!(step("m r^2 - b r + k = 0"), "holds");
    let forced = "$$ m \\ddot x + k x = F \\cos(\\omega t) $$\n\nWe try\n\n$$ x = A \\cos(\\omega t) $$\n\nSubstituting,\n\n$$ (k - m \\omega^2) A \\cos(\\omega t) = F \\cos(\\omega t) $$\n\nComparing coefficients,\n\n";
    let step = |formula: &str| verdicts(&format!("{forced}$$ {formula} $$\n"))[3];
    assert_eq!(step(r"A = \frac{F}{k - m \omega^2}"), "holds");
    assert_eq!(step(r"A = \frac{F}{k + m \omega^2}"), "fails");
}

#[test]
fn two_factors_may_be_divided_out() {
    for (balance, right, wrong) in [
        ("a b x = a b y", "x = y", "x = 2 y"),
        ("m g h = m g s", "h = s", "h = -s"),
        (
            "m c (T - T_1) + m c (T - T_2) = 0",
            r"T = \frac{T_1 + T_2}{2}",
            "T = T_1 + T_2",
        ),
    ] {
        let step =
            |formula: &str| verdicts(&format!("$$ {balance} $$\n\nHence\n\n$$ {formula} $$\n"))[1];
        assert_eq!(step(right), "holds", "{right}");
        assert_eq!(step(wrong), "fails", "{wrong}");
    }
}

#[test]
fn what_announces_a_display_is_no_premise_of_it() {
    let energy = r"E = \frac12 m v^2 \tag{1}";
    for words in [
        "By (1) the energy is $E = m v^2$:",
        "According to (1), the energy is $E = m v^2$; therefore",
        "The energy is $E = m v^2$. Hence",
    ] {
        for formula in ["E = m v^2", "2 E = 2 m v^2"] {
            let page = format!("$$ {energy} $$\n\n{words}\n\n$$ {formula} $$\n");
            assert_eq!(verdicts(&page), ["given", "fails"], "{words} {formula}");
        }
    }
    // What no display has said of a symbol is told.
    let told = "$$ p = m v $$\n\nThe second cart is heavier, $m = 3 M$, so\n\n$$ p = 3 M v $$\n";
    assert_eq!(verdicts(told), ["given", "holds"]);
}

#[test]
fn what_fails_proves_nothing_with_what_it_was_refuted_from() {
    let page = "$$ F = m a \\tag{1} $$\n\nHence\n\n$$ F = 2 m a \\tag{2} $$\n\nHence\n\n$$ F = 9 m a^2 \\tag{3} $$\n";
    assert_eq!(verdicts(page), ["given", "fails", "fails"]);
}

#[test]
fn complex_numbers_are_judged_by_their_parts() {
    let wave =
        "The wave function is\n\n$$ \\psi = A e^{i k x} $$\n\nThe probability density is\n\n";
    let density = |density: &str| verdicts(&format!("{wave}$$ |\\psi|^2 = {density} $$\n"));
    assert_eq!(density("A^2"), ["given", "given", "holds"]);
    // A real density is none that turns.
    assert!(!density("A^2 e^{2 i k x}").contains(&"holds"));
    let circuit = |squared: &str| {
        verdicts(&format!(
            "The impedance is\n\n$$ Z = R + i X $$\n\nHence\n\n$$ |Z|^2 = {squared} $$\n"
        ))
    };
    assert_eq!(circuit("R^2 + X^2"), ["given", "given", "holds"]);
    assert_eq!(circuit("R^2 - X^2"), ["given", "given", "fails"]);
    // A letter that counts, and a current.
    let sum = "This is complex.\n\n$$ s = \\sum_{i=1}^n i $$\n\nHence\n\n$$ s = \\frac{n (n + 1)}{2} $$\n";
    assert_eq!(verdicts(sum)[0], "given");
    let current = "$$ u = R i $$\n\nHence\n\n$$ u^2 = R^2 i^2 $$\n";
    assert_eq!(verdicts(current), ["given", "holds"]);
}

#[test]
fn what_could_not_be_otherwise_is_no_law() {
    let collision = "$$ v = \\frac{m - M}{m + M} u \\tag{1} $$\n\nFor a wall of infinite mass\n\n";
    let limit = |value: &str| {
        let page = format!(
            "{collision}$$ \\lim_{{M \\to \\infty}} \\frac{{m - M}}{{m + M}} u = {value} $$\n"
        );
        verdicts(&page)[1]
    };
    assert_eq!(limit("-u"), "holds");
    assert_eq!(limit("u"), "fails");
    let mass = |kilograms: &str| {
        verdicts(&format!(
            "The mass is\n\n$$ m = 1.2\\,\\mathrm{{t}} = {kilograms}\\,\\mathrm{{kg}} $$\n"
        ))[0]
    };
    assert_eq!(mass("120"), "fails");
    assert_ne!(mass("1200"), "fails");
    let equivalent = |square: &str| verdicts(&format!("$$ x = 1 \\iff {square} $$\n"))[0];
    assert_eq!(equivalent("x^2 = 1"), "fails");
    assert_eq!(equivalent("2 x = 2"), "holds");
}

#[test]
fn the_law_that_a_conclusion_is_called_is_no_reason() {
    let page = |words: &str, law: &str| {
        verdicts(&format!(
            "$$ g h = \\frac12 v^2 $$\n\n{words}\n\n$$ {law} $$\n"
        ))[1]
    };
    assert_eq!(page("This gives Torricelli's law", r"v^2 = 2 g h"), "holds");
    assert_eq!(page("This gives Torricelli's law", r"v^2 = g h"), "fails");
    assert_eq!(page("Newton's second law gives", r"m a = F"), "given");
}

#[test]
fn what_is_only_asked_says_nothing() {
    let page = "$$ a = 2 $$\n\n$$ a^2 \\stackrel{?}{=} 5 \\quad ✗ $$\n\n$$ a^2 \\stackrel{?}{=} 4 \\quad ✓ $$\n";
    assert_eq!(verdicts(page), ["given", "fails", "holds"]);
    // Which case of it applies at a number is not known.
    let cases = "$$ f(x) = \\begin{cases} x^2 & x \\geq 0 \\\\ -x & x < 0 \\end{cases} \\tag{1} $$\n\nBy (1)\n\n$$ f(2) = 4 $$\n";
    assert_eq!(verdicts(cases)[2], "undecided");
}

#[test]
fn a_case_may_be_named_with_its_value() {
    let law = r"a = g \sin\theta - \mu g \cos\theta \tag{1}";
    let step = |words: &str, formula: &str| {
        verdicts(&format!(
            "The acceleration is\n\n$$ {law} $$\n\n{words}\n\n$$ {formula} $$\n"
        ))[1]
    };
    for words in [
        r"For the frictionless case $\mu = 0$ this becomes",
        r"In the frictionless case ($\mu = 0$),",
        r"In the frictionless case, $\mu = 0$, we have",
        r"Without friction ($\mu = 0$) we have",
        r"If there is no friction, $\mu = 0$, then",
        r"For a smooth plane, $\mu = 0$, (1) says",
    ] {
        assert_eq!(step(words, r"a = g \sin\theta"), "holds", "{words}");
        assert_eq!(step(words, r"a = g \cos\theta"), "fails", "{words}");
    }
    for words in [
        r"Unlike for the case $\mu = 0$ we have",
        r"In contrast to the case $\mu = 0$ we have",
        r"In Figure 2 ($\mu = 0$ is dashed) we have",
    ] {
        assert_ne!(step(words, r"a = g \sin\theta"), "holds", "{words}");
    }
}

#[test]
fn rows_between_dollars_have_numbers_of_their_own() {
    let rows = "$$ Q = a + b \\tag{1} $$\n\nThen\n\n$$\\begin{align} R &= Q^2 \\tag{2} \\\\ &= a^2 + 2 a b + b^2 \\tag{3} \\end{align}$$\n\nBy (3)\n\n$$ R - a^2 = 2 a b + b^2 \\tag{4} $$\n";
    assert_eq!(verdicts(rows), ["given", "given", "holds", "holds"]);
}

#[test]
fn a_ratio_of_what_is_new_is_defined_by_what_it_goes_on_with() {
    let page = |ratio: &str| {
        verdicts(&format!(
            "$$ I_1 \\omega_1 = I_2 \\omega_2 \\tag{{1}} $$\n\nThe energies have the ratio\n\n\
             $$ \\frac{{E_2}}{{E_1}} = \\frac{{I_2 \\omega_2^2}}{{I_1 \\omega_1^2}} = {ratio} $$\n"
        ))[1]
    };
    assert_eq!(page(r"\frac{I_1}{I_2}"), "holds");
    assert_eq!(page(r"\frac{I_2}{I_1}"), "fails");
    // Of what is known nothing is defined.
    let known = "$$ E_1 = 2 \\tag{1} $$\n\nThe ratio is\n\n$$ \\frac{E_2}{E_1} = \\frac{a}{b} = \\frac{2 a}{2 b} $$\n";
    assert_ne!(verdicts(known)[1], "holds");
}

#[test]
fn two_factors_are_divided_out_of_what_a_third_may_leave_nought() {
    let page = "$$ m g h = \\frac12 m v^2 + 2 m g R \\tag{1} $$\n\nand\n\n$$ v^2 = g R \\tag{2} $$\n\nBy (1) and (2)\n\n";
    let step = |height: &str| verdicts(&format!("{page}$$ h = {height} $$\n"))[2];
    assert_eq!(step(r"\frac52 R"), "holds");
    assert_eq!(step(r"\frac32 R"), "fails");
}

#[test]
fn a_step_may_follow_from_what_its_sentence_names() {
    let lens = |words: &str, last: &str| {
        verdicts(&format!(
            "$$ M = \\frac{{b}}{{g}} \\tag{{1}} $$\n\n$$ M = \\frac{{f}}{{g - f}} \\tag{{2}} $$\n\n{words}\n\n$$ {last} $$\n"
        ))[2]
    };
    for words in [
        "An object at $g = 2 f$ is thus imaged at",
        "An object is placed at $g = 2 f$. There",
    ] {
        assert_eq!(lens(words, "b = 2 f"), "holds", "{words}");
        assert_eq!(lens(words, "b = 3 f"), "fails", "{words}");
    }
    for words in [
        "Unlike an object at $g = 2 f$ this one is imaged at",
        "Students claim that $g = 2 f$ is thus imaged at",
        "An object is never at $g = 2 f$ and is imaged at",
        "The image $b = 2 f$ is at",
        "The condition $g = 2 f$ is violated, hence the image is at",
        "After the case $g = 2 f$ we turn to",
        "The object, which was at $g = 2 f$, is now imaged at",
    ] {
        assert_ne!(lens(words, "b = 2 f"), "holds", "{words}");
    }
    // What still speaks of the time is not only said of the beginning.
    let decay = "$$ \\frac{dV}{dt} = -\\frac{V}{R C} $$\n\nwith $V = V_0$ at $t = 0$ we conclude\n\n$$ V = V_0 + t R C $$\n";
    assert_ne!(verdicts(decay)[1], "holds");
}

#[test]
fn a_reason_is_so_throughout() {
    let page = |slope: &str| {
        format!(
            "$$ \\eta = \\frac{{4 a}}{{(1+\\mu)^2}} \\tag{{1}} $$\n\nSince $\\mu = a$:\n\n\
             $$ \\eta = \\frac{{4\\mu}}{{(1+\\mu)^2}} \\tag{{2}} $$\n\nBy (2) the derivative is\n\n\
             $$ \\frac{{d\\eta}}{{d\\mu}} = {slope} $$\n"
        )
    };
    let right = page(r"\frac{4 (1 - \mu)}{(1 + \mu)^3}");
    assert_eq!(verdicts(&right)[1..], ["holds", "holds"]);
    let wrong = page(r"\frac{4 (1 + \mu)}{(1 + \mu)^3}");
    assert_eq!(verdicts(&wrong)[1..], ["holds", "fails"]);
}

#[test]
fn nothing_is_defined_by_what_follows_from_what_could_not_be_read() {
    let page = "$$ \\oint E \\cdot dA = \\frac{Q}{\\epsilon} \\tag{1} $$\n\nFrom (1) it follows that\n\n\
                $$ E = \\frac{Q}{2 \\pi r^2 \\epsilon} \\tag{2} $$\n";
    assert_eq!(verdicts(page), ["undecided", "undecided"]);
    let defined = page.replace("From (1) it follows that", "The field is called");
    assert_eq!(verdicts(&defined)[1], "given");
}

#[test]
fn laws_are_stated_in_more_ways_than_one() {
    let last = |page: &str| *verdicts(page).last().unwrap();
    let before = "$$ E = \\frac12 m v^2 \\tag{1} $$\n\n";
    // A law that goes on with what is so anyway, or is converted.
    let value = |own: &str| last(&format!("{before}The car drives at\n\n$$ v = {own} $$\n"));
    assert_eq!(value(r"\qty{18}{km/h} = \qty{5}{m/s}"), "given");
    assert_eq!(value(r"\qty{18}{km/h} = \qty{6}{m/s}"), "fails");
    // What a chain speaks of by the way.
    let chain = |end: &str| {
        let ratio = r"\eta = \frac{E_2}{E} = \frac{\frac12 m_2 w^2}{\frac12 m v^2}";
        last(&format!(
            "{before}The efficiency is\n\n$$ {ratio} = {end} $$\n"
        ))
    };
    assert_eq!(chain(r"\frac{m_2 w^2}{m v^2}"), "given");
    assert_eq!(chain(r"\frac{m_2 w}{m v}"), "fails");
    let words = |words: &str, law: &str| {
        last(&format!(
            "{before}$$ E = V q $$\n\n{words}\n\n$$ {law} $$\n"
        ))
    };
    assert_eq!(words("We assume equal masses:", "m = q"), "given");
    assert_eq!(words("where the velocity is", "v = 2 m q"), "given");
    assert_eq!(
        words("The charge is proportional to the mass:", r"q \propto m"),
        "given"
    );
    assert_eq!(words("Hence by (1)", r"v \propto m"), "fails");
    // What must not vanish is no more than what is divided out.
    assert_eq!(words("It is", r"2 v \neq 4 v"), "holds");
}

#[test]
fn set_equal_to_zero() {
    let page = |end: &str| {
        verdicts(&format!(
            "$$ \\frac{{d\\eta}}{{d\\mu}} = \\frac{{4 (1-\\mu)}}{{(1+\\mu)^3}} \\tag{{1}} $$\n\nSet equal to zero:\n\n\
             $$ \\frac{{4 (1-\\mu)}}{{(1+\\mu)^3}} = 0 \\Rightarrow {end} $$\n"
        ))[1]
    };
    assert_eq!(page(r"1 - \mu = 0"), "holds");
    assert_eq!(page(r"1 + \mu = 0"), "fails");
}

#[test]
fn letters_of_another_page_are_not_those_of_a_page_that_stands_alone() {
    let two = |second: &str| {
        let pages = [
            ("a.md", "$$ A = 3 F $$\n\n$$ P = I V \\tag{9} $$\n"),
            ("b.md", second),
        ];
        let pages =
            pages.map(|(path, text)| cradle_verify::document::Document::markdown(path, text));
        let audit = Audit::of(&Derivation::new(pages.to_vec()));
        audit.entries.last().unwrap().verdict.word()
    };
    assert_eq!(two("The pressure is\n\n$$ P = \\frac{F}{A} $$\n"), "given");
    // What goes on from another page means the same by them.
    assert_eq!(two("By (9) it is\n\n$$ P = \\frac{F}{A} $$\n"), "undecided");
}

#[test]
fn what_is_said_for_all_is_said_under_the_bounds_that_are_named() {
    let judged = |formula: &str| verdicts(&format!("Hence\n\n$$ {formula} $$\n"))[0];
    let cases = [
        (r"x^2 \geq 0 \quad \text{for all } x", "holds"),
        (r"x^2 \geq 0 \quad \text{for any } x", "holds"),
        (r"x^2 \geq 0 \ \forall x \in \mathbb{R}", "holds"),
        (r"\forall x \in \mathbb{R}: x^2 \geq 0", "holds"),
        (r"\text{For all $x > 1$:}\quad x^2 > x", "holds"),
        (r"x^2 > x \quad \text{for all $x > 1$}", "holds"),
        (r"x^2 > x \quad \text{for all $x < 1$}", "fails"),
        (r"n^2 \geq n \quad \text{for every } n \ge 1", "holds"),
        (r"n^2 \geq n \quad \forall n \in \mathbb{N}", "holds"),
        (
            r"n \geq 1 \quad \text{for all positive integers } n",
            "holds",
        ),
        (r"x + 1 > 1 \qquad \forall x > 0", "holds"),
        (r"x y > 0 \quad (\forall x, y > 0)", "holds"),
        (r"x y > 0 \quad (\forall x, y \neq 0)", "fails"),
        (
            r"x y \geq 0 \quad \text{for all } x \in [0, 1] \text{ and } y \in [0, \infty)",
            "holds",
        ),
        (r"x > -1 \quad \text{for all nonnegative } x", "holds"),
        (
            r"x \leq y \quad \text{for all } x \text{ with } x < y",
            "holds",
        ),
        (
            r"\sin^2 t + \cos^2 t = 1 \quad \text{for all times $t$.}",
            "holds",
        ),
    ];
    for (formula, verdict) in cases {
        assert_eq!(judged(formula), verdict, "{formula}");
    }
}

#[test]
fn what_is_said_for_all_is_not_said_of_the_one_that_is_supposed() {
    let page = "# A\n\nLet $x = 1$. Then\n\n$$ x^2 = x \\tag{1} $$\n\n$$ x^2 = x \\quad \\text{for all } x \\tag{2} $$\n";
    assert_eq!(verdicts(page), ["holds", "fails"]);
}

#[test]
fn what_is_quantified_over_and_not_understood_is_refused() {
    let refused = [
        r"x^2 \geq 0 \quad \text{for all solutions } x",
        r"x^2 \geq 0 \quad \forall x \in S",
        r"x^2 > 0 \quad \forall x \in \mathbb{R}_+",
        r"x^2 > 0 \quad \forall x \in \mathbb{C}",
        r"x^2 \geq 0 \quad \text{for all times}",
        r"x^2 \geq 0 \quad \forall",
        r"x^2 \geq \forall x",
        r"\forall x",
        r"\forall",
        r"x \geq 0 \quad \forall x \in [0, 1",
        r"x \geq 0 \quad \forall x \in [",
        r"x \geq 0 \quad \text{for all $x$ and $}",
        r"x \geq 0 \quad \text{for all $$ $x$ $}",
    ];
    for formula in refused {
        let derivation = Derivation::from_markdown("page.md", &format!("$$ {formula} $$\n"));
        assert!(derivation.equations[0].statements.is_err(), "{formula}");
    }
    let many = ["x"; 5000].join(", ");
    let page = format!("$$ x \\geq 0 \\quad \\forall {many} > 0 $$\n");
    let derivation = Derivation::from_markdown("page.md", &page);
    assert!(derivation.equations[0].statements.is_err());
}

/// Where something is divided by powers of sums, these sums are not 0, and no others.
#[test]
fn what_is_divided_by_powers_of_sums() {
    let page = |below: &str, step: &str| {
        verdicts(&format!(
            "$$ y = \\frac{{a}}{{{below}}} \\tag{{1}} $$\n\nHence by (1)\n\n$$ {step} $$\n"
        ))[1]
    };
    for below in [
        "(x + b)^2",
        "(x + b)^3",
        "2 (x + b)^2 (x - b)",
        "(x + b) (a + 1)",
    ] {
        assert_eq!(page(below, r"x + b \neq 0"), "holds", "{below}");
    }
    assert_ne!(page("(x + b)^0", r"x + b \neq 0"), "holds");
    assert_ne!(page("3 (x + b)^0 (x - b)", r"x + b \neq 0"), "holds");
    assert_eq!(page("(x + b)^{-2} + 1", r"x + b \neq 0"), "holds");
    assert_eq!(page("(x + b)^2", r"y (x + b)^2 = a"), "holds");
    assert_eq!(page("(x + b)^3", r"y (x + b)^2 = a"), "fails");
}

/// What is so in two cases is mostly true together only where nothing is left: no step is drawn from both unless it says so.
#[test]
fn cases_are_not_joined() {
    let throw = |before: &str, step: &str| {
        let page = format!(
            "The height and the speed are\n\n$$ h = v t - \\frac12 g t^2 $$\n\n$$ w = v - g t. $$\n\n{before}On landing\n\n\
             $$ h = 0, $$\n\nwhich gives\n\n$$ {step} $$\n"
        );
        *verdicts(&page).last().expect("a step")
    };
    let top = "At the top\n\n$$ w = 0. $$\n\n";
    assert_eq!(throw(top, r"g t = \frac{v}{2}."), "fails");
    assert_eq!(throw(top, r"v t = \frac12 g t^2."), "holds");
    assert_eq!(throw("", r"g t = 2 v."), "holds");

    let battery = |step: &str| {
        let page = format!(
            "The battery has\n\n$$ U = E - R I. \\tag{{1}} $$\n\nIn open circuit no current flows,\n\n$$ I = 0 \\tag{{2}} $$\n\nand hence\n\n\
             $$ U = E. \\tag{{3}} $$\n\nIn short circuit the voltage is zero,\n\n$$ U = 0, \\tag{{4}} $$\n\nand from (1) and (4) it follows \
             that\n\n$$ {step} \\tag{{5}} $$\n"
        );
        verdicts(&page)[4]
    };
    assert_eq!(battery("R I = 7 E."), "fails");
    assert_eq!(battery("R I = E."), "holds");

    // What is 0 because the page says so is no such case.
    let measured = "**Given:**\n\n$$ v_0 = 0\\,\\mathrm{m/s}, \\quad v = 25\\,\\mathrm{m/s}, \\quad t = 10\\,\\mathrm{s} $$\n\nThe acceleration \
                    is\n\n$$ a = \\frac{v - v_0}{t} = 2.5\\,\\mathrm{m/s^2} $$\n\nThe distance is\n\n\
                    $$ s = v_0 t + \\frac12 a t^2 = 125\\,\\mathrm{m} $$\n";
    assert_eq!(verdicts(measured).last(), Some(&"holds"));
}

/// What the page gives as something that changes does not stand still for a step's sake.
#[test]
fn what_changes_by_the_page_does_not_stand_still() {
    let revenue = |slope: &str| {
        verdicts(&format!(
            "The price is\n\n$$ p = a - b q. $$\n\nThe revenue is\n\n$$ R = p q = a q - b q^2. $$\n\nThe marginal revenue is\n\n\
             $$ \\frac{{dR}}{{dq}} = {slope}. $$\n"
        ))[2]
    };
    assert_eq!(revenue("a - b q"), "fails");
    assert_eq!(revenue("a - 2 b q"), "holds");
    let cone = |slope: &str| {
        verdicts(&format!(
            "A cone of water has\n\n$$ r = \\frac{{h}}{{2}} $$\n\nand the volume is\n\n$$ V = \\frac{{1}}{{3}} \\pi r^2 h. $$\n\nHence\n\n\
             $$ \\frac{{dV}}{{dt}} = {slope}. $$\n"
        ))[2]
    };
    assert_eq!(cone(r"\frac{1}{3} \pi r^2 \frac{dh}{dt}"), "fails");
    assert_eq!(cone(r"\pi r^2 \frac{dh}{dt}"), "holds");
    let ball = |slope: &str| {
        verdicts(&format!(
            "The radius grows as\n\n$$ r = u t. $$\n\nThe volume is\n\n$$ V = \\frac{{4}}{{3}} \\pi r^3. $$\n\nDifferentiating with respect to \
             time gives\n\n$$ \\frac{{dV}}{{dt}} = {slope}. $$\n"
        ))[2]
    };
    // That may be said of one moment.
    assert_eq!(ball("0"), "undecided");
    assert_eq!(ball(r"4 \pi u r^2"), "holds");
    let load = |slope: &str| {
        verdicts(&format!(
            "The current is\n\n$$ I = \\frac{{U}}{{R + r}} $$\n\nand the power in the load\n\n\
             $$ P = I^2 R = \\frac{{U^2 R}}{{(R + r)^2}}. $$\n\nWe differentiate:\n\n$$ \\frac{{dP}}{{dR}} = {slope}. $$\n"
        ))[2]
    };
    assert_eq!(load(r"\frac{U^2 (r + R)}{(R + r)^3}"), "fails");
    assert_eq!(load(r"\frac{U^2 (r - R)}{(R + r)^3}"), "holds");
}

/// Of a derivative no more is known than of what is differentiated: not its size where that of a factor is not.
#[test]
fn a_slope_beside_a_factor_without_a_value_has_none() {
    let page = "The radius grows as\n\n$$ r = u t. \\tag{1} $$\n\nThe volume is\n\n$$ V = \\frac{4}{3} \\pi r^3. \\tag{2} $$\n\nHence\n\n\
                $$ \\frac{dV}{dt} = 0. \\tag{3} $$\n";
    let derivation = Derivation::from_markdown("page.md", page);
    let text = crate::common::human(&derivation);
    assert!(text.contains("false at t = 1"), "{text}");
    assert!(!text.contains("left 0, right 0"), "{text}");
}

/// Powers with symbols in the exponent, by their logarithms; where nobody says that the exponent is not 0, that is told.
#[test]
fn adiabats_and_half_lives_are_decided() {
    let adiabats = |ratio: &str| {
        verdicts(&format!(
            "Along the adiabats\n\n$$ T x^{{\\gamma - 1}} = S y^{{\\gamma - 1}} \\tag{{1}} $$\n\n\
             $$ T u^{{\\gamma - 1}} = S v^{{\\gamma - 1}} \\tag{{2}} $$\n\nDividing (1) by (2) and taking the root\n\n\
             $$ \\frac{{x}}{{u}} = {ratio} \\tag{{3}} $$\n"
        ))[2]
    };
    assert_eq!(adiabats(r"\frac{y}{v}"), "holds");
    assert_eq!(adiabats(r"\frac{v}{y}"), "fails");
    let step = |from: &str, to: &str| {
        verdicts(&format!(
            "<!-- check: symbols x, y, c, p, k, t: positive -->\n$$ {from} \\tag{{1}} $$\n\nHence by (1)\n\n$$ {to} \\tag{{2}} $$\n"
        ))[1]
    };
    for (from, right, wrong) in [
        ("x^p = c y", "x = (c y)^{1/p}", "x = (c y)^{2/p}"),
        (r"\ln y = \ln x + 2 \ln c", "y = x c^2", "y = x c^3"),
        (r"c e^{-k t} = \frac{c}{2}", r"k t = \ln 2", r"k t = -\ln 2"),
        ("e^x = e^{2 y}", "x = 2 y", "x = y^2"),
    ] {
        assert_eq!(step(from, right), "holds", "{from}");
        assert_ne!(step(from, wrong), "holds", "{from}");
    }
    assert_eq!(step("x^p = c y", "x = (c y)^{2/p}"), "fails");
}

/// Of two roots an author means one; on which side of the middle it lies is told.
#[test]
fn one_of_two_roots_is_one_side_of_the_middle() {
    let solved = |root: &str| {
        verdicts(&format!(
            "The distances satisfy\n\n$$ s^2 - D s + D f = 0, $$\n\nwhose solution is\n\n$$ s = {root}. $$\n"
        ))[1]
    };
    assert_eq!(solved(r"\frac{D + \sqrt{D^2 - 4 D f}}{2}"), "holds");
    assert_eq!(solved(r"\frac{D - \sqrt{D^2 - 4 D f}}{2}"), "holds");
    assert_ne!(solved(r"\frac{D + \sqrt{D^2 - 2 D f}}{2}"), "holds");
    assert_ne!(solved(r"\frac{D + \sqrt{D^2 + 4 D f}}{2}"), "holds");
}

/// The slope of what the page gives by a term follows or does not, whatever word leads on to it.
#[test]
fn slope_of_what_is_given_is_no_law() {
    let decay = |slope: &str| {
        verdicts(&format!(
            "The level is\n\n$$ y(t) = A e^{{-k t}}. $$\n\nThe derivative is\n\n$$ {slope}. $$\n"
        ))[1]
    };
    assert_eq!(decay("y'(t) = -k A e^{-k t}"), "holds");
    assert_eq!(decay("y'(t) = -A e^{-k t}"), "fails");
    assert_eq!(decay("y'(0) = -k A"), "holds");
    assert_eq!(decay("y'(0) = k A"), "fails");
    assert_eq!(decay("y'(0) = v_0"), "given");
    let wave = |slope: &str| {
        verdicts(&format!(
            "The wave function is\n\n$$ \\psi(x) = A \\sin(k x), $$\n\nwhose second derivative is\n\n$$ \\psi''(x) = {slope}. $$\n"
        ))[1]
    };
    assert_eq!(wave(r"-k^2 A \sin(k x)"), "holds");
    assert_eq!(wave(r"-k A \sin(k x)"), "fails");
    // After a collision a prime is no slope.
    let collision = "Before it the momentum is\n\n$$ p = m v(t) $$\n\nand after it\n\n$$ p = m v'. $$\n\nHence\n\n$$ m v(t) = m v'. $$\n";
    assert_eq!(verdicts(collision)[2], "holds");
}

#[test]
fn differentials_in_the_text_are_no_products() {
    let after = |supposed: &str| verdicts(&format!("Let {supposed}. Then\n\n$$ U = T S $$\n"));
    assert_eq!(after(r"$dU = T\,dS$"), ["given"]);
    assert_eq!(after(r"$a U = T\,a S$"), ["holds"]);
}

#[test]
fn what_holds_under_a_condition_alone_rests_on_nothing_else() {
    let rests = |after: &str| {
        let text =
            format!("$$ F = m a $$\n\nHence\n\n$$ 2 F = 3 m a $$\n\nHence\n\n$$ {after} $$\n");
        let audit = Audit::of(&Derivation::from_markdown("page.md", &text));
        !audit.entries[2].rests_on.is_empty()
    };
    assert!(!rests(r"\tan x = \frac{\sin x}{\cos x}"));
    assert!(!rests(r"\frac{y^2}{y} = y"));
    // What comes from the failing step rests on it under a condition, too.
    assert!(rests(r"\frac{2 F}{m} = 3 a"));
}

/// Who divides one equation by another means that the other is not 0; which symbols that asks for is told.
#[test]
fn what_is_divided_by_is_not_nought() {
    let drawn = |words: &str, value: &str| {
        verdicts(&format!(
            "At the critical point\n\n$$ T V^3 = 2 a (V - b)^2 \\tag{{1}} $$\n\n$$ T V^4 = 3 a (V - b)^3 \\tag{{2}} $$\n\n{words}\n\n$$ V = {value}. $$\n"
        ))[2]
    };
    assert_eq!(drawn("Dividing (2) by (1) gives", "3 b"), "holds");
    assert_eq!(drawn("Dividing (2) by (1) gives", "2 b"), "fails");
    assert_eq!(drawn("From (1) and (2) we get", "3 b"), "fails");
}

/// What is integrated begins with the number that the text gives.
#[test]
fn integration_begins_with_a_number() {
    let integrated = |words: &str, value: &str| {
        verdicts(&format!(
            "The slope is\n\n$$ \\frac{{dw}}{{dx}} = k x \\tag{{1}} $$\n\n{words} gives\n\n$$ w = {value}. $$\n"
        ))[1]
    };
    let from_nought = "Integrating with $w = 0$ at $x = 0$";
    assert_eq!(integrated(from_nought, r"\frac{k x^2}{2}"), "holds");
    assert_eq!(integrated(from_nought, "k x^2"), "fails");
    let from_two = "Integrating with $w = 2$ at $x = 0$";
    assert_eq!(integrated(from_two, r"2 + \frac{k x^2}{2}"), "holds");
    assert_eq!(integrated(from_two, r"\frac{k x^2}{2}"), "fails");
    assert_ne!(
        integrated("Integrating", r"\frac{k x^2}{2}"),
        "holds",
        "nothing is said of where it begins"
    );
}

/// The slope of what a law ties to what moves, with all else in it constant.
#[test]
fn laws_tell_slopes() {
    let slope = |law: &str, slope: &str, value: &str| {
        let text = format!("In equilibrium\n\n$$ {law} $$\n\nHence\n\n$$ {slope} = {value} $$\n");
        verdicts(&text)[1]
    };
    for (law, left, right, wrong) in [
        (
            "T^4 = a S",
            r"\frac{dT}{dS}",
            r"\frac{T}{4 S}",
            r"\frac{4 T}{S}",
        ),
        ("p V = c", r"\frac{dp}{dV}", r"-\frac{p}{V}", r"\frac{p}{V}"),
        (
            "x^2 + y^2 = r^2",
            r"\frac{dy}{dx}",
            r"-\frac{x}{y}",
            r"\frac{x}{y}",
        ),
        (
            "x^2 + x y + y^2 = c",
            r"\frac{dy}{dx}",
            r"-\frac{2 x + y}{x + 2 y}",
            r"-\frac{2 x - y}{x + 2 y}",
        ),
        (
            "y = A x^n",
            r"\frac{dy}{dx}",
            "n A x^{n - 1}",
            "n A x^{n - 2}",
        ),
        (
            "y = A x^n",
            r"\frac{dy}{dx}",
            r"n \frac{y}{x}",
            "A x^{n - 1}",
        ),
        (
            r"p = q e^{-H/(R T)}",
            r"\frac{dp}{dT}",
            r"q \frac{H}{R T^2} e^{-H/(R T)}",
            r"q \frac{H}{R T^3} e^{-H/(R T)}",
        ),
        (
            r"B = \frac{k R^2}{2 (R^2 + z^2)^{3/2}}",
            r"\frac{dB}{dz}",
            r"-\frac{3 k R^2 z}{2 (R^2 + z^2)^{5/2}}",
            r"-\frac{3 k R^2 z}{2 (R^2 - z^2)^{5/2}}",
        ),
    ] {
        assert_eq!(slope(law, left, right), "holds", "{law}: {right}");
        assert_eq!(slope(law, left, wrong), "fails", "{law}: {wrong}");
    }
    // Where the text says that it is constant, so it is.
    let told = |sign: &str| {
        let text = format!(
            "$$ p V = c, $$\n\nwhere $c$ is constant. Hence\n\n$$ \\frac{{dp}}{{dV}} = {sign} \\frac{{p}}{{V}} $$\n"
        );
        verdicts(&text)[1]
    };
    assert_eq!((told("-"), told("")), ("holds", "fails"));
}

/// Exponents between 0 and 1, and what is in units of something else.
#[test]
fn exponents_may_be_fractions() {
    let drawn = |exponent: &str| {
        let text = format!(
            "<!-- check: symbols K, L, A: positive; symbols a: in (0, 1) -->\n\n$$ Y = A K^a L^{{1 - a}} $$\n\nWith $k = K/L$ and $y = Y/L$ this is\n\n$$ y = A k^{{{exponent}}} $$\n"
        );
        verdicts(&text)[1]
    };
    assert_eq!((drawn("a"), drawn("2 a")), ("holds", "fails"));
}

/// Dots are slopes in time where something is differentiated by the time.
#[test]
fn dots_go_with_slopes_in_time() {
    let lost = |rate: &str| {
        let text = format!(
            "The motion obeys\n\n$$ m \\ddot x + b \\dot x + k x = 0 \\tag{{1}} $$\n\nThe energy is\n\n$$ E = \\frac12 m \\dot x^2 + \\frac12 k x^2 \\tag{{2}} $$\n\nDifferentiating (2) and using (1),\n\n$$ \\frac{{dE}}{{dt}} = {rate} $$\n"
        );
        verdicts(&text)[2]
    };
    assert_eq!(lost(r"- b \dot x^2"), "holds");
    assert_eq!(lost(r"- 2 b \dot x^2"), "fails");
    assert_eq!(lost(r"- b \dot x"), "fails");
}

#[test]
fn sums_of_cosines_and_quotients_in_logarithms_are_refuted() {
    let tones = |product: &str| {
        let text = format!(
            "The tones are\n\n$$ y = A \\cos(a t) + A \\cos(b t) $$\n\nWith $a = m + d$ and $b = m - d$ the sum is\n\n$$ y = {product} $$\n"
        );
        verdicts(&text)[1]
    };
    assert_eq!(tones(r"2 A \cos(d t) \cos(m t)"), "holds");
    assert_eq!(tones(r"A \cos(d t) \cos(m t)"), "fails");
    assert_eq!(tones(r"2 A \sin(d t) \cos(m t)"), "fails");
    let vapour = |right: &str| {
        let text = format!(
            "The temperatures give\n\n$$ \\ln p = c - \\frac{{H}}{{T}} \\tag{{1}} $$\n\n$$ \\ln q = c - \\frac{{H}}{{S}} \\tag{{2}} $$\n\nThe difference of (1) and (2) is\n\n$$ \\ln\\frac{{q}}{{p}} = H \\left( {right} \\right) $$\n"
        );
        verdicts(&text)[2]
    };
    assert_eq!(vapour(r"\frac{1}{T} - \frac{1}{S}"), "holds");
    assert_eq!(vapour(r"\frac{1}{S} - \frac{1}{T}"), "fails");
}

/// That an equation has a root is no premise of what does not speak of it.
#[test]
fn a_root_is_not_borrowed() {
    let damped = |right: &str| {
        let text = format!(
            "We abbreviate\n\n$$ \\gamma = \\frac{{b}}{{2 m}}, \\qquad w^2 = \\frac{{k}}{{m}} $$\n\nThe ansatz $x = A e^{{s t}}$ leads to the characteristic equation\n\n$$ s^2 + 2\\gamma s + w^2 = 0 $$\n\nFor weak damping we write $u^2 = w^2 - \\gamma^2$. In terms of the original parameters,\n\n$$ u^2 = {right} $$\n"
        );
        *verdicts(&text).last().expect("a verdict")
    };
    assert_eq!(damped(r"\frac{k}{m} - \frac{b^2}{4 m^2}"), "holds");
    assert_eq!(damped(r"\frac{b^2}{4 m^2} - \frac{k}{m}"), "fails");
}

/// Rows that have no number of their own are steps, one after another.
#[test]
fn rows_without_numbers_are_steps() {
    let judged = |rows: &str, environment: &str| {
        let text = format!(
            "The mass decays: $M c^2 = E + p c$, thus\n\\begin{{{environment}}}\n{rows}\n\\end{{{environment}}}\n"
        );
        let derivation = Derivation::new(Document::latex("rows.tex", text.as_str(), &()));
        let entries = Audit::of(&derivation).entries;
        entries
            .iter()
            .map(|own| own.verdict.word())
            .collect::<Vec<_>>()
    };
    let rows = |value: &str, notag: &str| {
        format!(
            "(M c^2 - E)^2 &= p^2 c^2 = E^2 - m^2 c^4 {notag} \\\\\nE &= \\frac{{M^2 + m^2}}{{{value}}} c^2"
        )
    };
    for (environment, notag) in [("align*", ""), ("align", "\\notag"), ("gather*", "")] {
        assert_eq!(judged(&rows("2 M", notag), environment), ["given", "holds"]);
        assert_eq!(judged(&rows("M", notag), environment), ["given", "fails"]);
    }
    // What goes on with a row is no step of its own.
    let chain = "a &= (b + c)^2 \\\\\n&= b^2 + 2 b c + c^2";
    assert_eq!(judged(chain, "align*").len(), 1);
}

/// Rows that share a number are named by it once.
#[test]
fn what_rows_of_one_number_say_together_is_named_once() {
    let page = "We are given\n\n$$\n\\begin{aligned}\na &= 1, \\\\\na &= 2.\n\\end{aligned} \\tag{1}\n$$\n\nHence\n\n$$ a = 3. \\tag{2} $$\n";
    let said = crate::common::human(&Derivation::from_markdown("a.md", page));
    assert!(said.contains("what cannot all be true: (1)\n"), "{said}");
}
