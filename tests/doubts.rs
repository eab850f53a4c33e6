//! What reads as a power or a product and may be neither: refused at its place where the page does not say what it is, and left alone elsewhere.

use cradle_verify::derivation::Derivation;
use cradle_verify::document::Document;

/// Whether the last display of a page is read; `Err` is what is said of it, and the place.
fn last(text: &str) -> Result<(), String> {
    let derivation = Derivation::new(vec![Document::markdown("page.md", text)]);
    let last = derivation.equations.last().unwrap();
    let source = &derivation.pages[0].document.source;
    match &last.statements {
        Ok(_) => Ok(()),
        Err(error) => Err(format!(
            "{}: {}",
            &source[error.span.range()],
            error.message
        )),
    }
}

fn display(math: &str) -> String {
    format!("$$ {math} $$\n")
}

#[test]
fn what_can_only_be_an_index_is_refused_at_its_place() {
    let refused = [
        (r"T^{\mu\nu} = T^{\nu\mu}", r"^{\mu\nu}"),
        (r"s^2 = g_{\mu\nu} x^\mu x^\nu", r"^\mu"),
        (r"C^\mu = T^\mu_{\;\;\nu} A^\mu", r"^\mu"),
        (r"F^{ij} = -F^{ji}", r"^{ij}"),
        (r"\delta^i_j = a", r"^i"),
        (r"p^\mu p_\mu = m^2", r"^\mu"),
        (r"P = v_k w^k", r"^k"),
        (r"P = \sum_{\mu=1}^{4} v_\mu w^\mu", r"^\mu"),
        (r"B_i = T^k_i A_k", r"^k"),
        (r"\Gamma^\lambda_{\mu\nu} = 0", r"^\lambda"),
        (r"\bar F^{\mu\nu} = 0", r"^{\mu\nu}"),
        (r"m^{eff} = m", r"^{eff}"),
    ];
    for (math, place) in refused {
        let error = last(&display(math)).expect_err(math);
        let (at, message) = error.split_once(": ").unwrap();
        assert_eq!(
            (at, message.starts_with("this may be an index")),
            (place, true),
            "{math}"
        );
    }
}

#[test]
fn powers_stay_powers() {
    let read = [
        r"y = A e^{kx} + e^{i\omega t} + \mathrm e^{ab} + 2^{mn} + r^{n-1} + x^{2n}",
        r"p_1 V_1^\gamma = p_2 V_2^\gamma",
        r"p_i V_i^\gamma = p_f V_f^\gamma",
        r"u_n = u_0 r^n",
        r"x^{nk} = y",
        r"S = \sum_{i=1}^{n} a_i x^i",
        r"x_{in}^n = y",
        r"n v_n x^n = 1",
        r"(a + b)^{cd} = 1",
    ];
    for math in read {
        assert_eq!(last(&display(math)), Ok(()), "{math}");
    }
}

#[test]
fn a_letter_that_is_a_quantity_on_the_page_is_an_exponent() {
    let power = display("y = a^{bc}");
    assert!(last(&power).is_err());
    assert_eq!(last(&format!("{}\n{power}", display("b + c = 1"))), Ok(()));
    let declared = "<!-- check: symbols b, c: real -->\n\n";
    assert_eq!(last(&format!("{declared}{power}")), Ok(()));
    // What the text speaks of may be an index.
    let tensor = display(r"T^{\mu\nu} = T^{\nu\mu}");
    assert!(
        last(&format!(
            "where $\\mu$ and $\\nu$ run from 0 to 3\n\n{tensor}"
        ))
        .is_err()
    );
    // The unit of imaginary numbers is no exponent.
    let complex = display(r"y = e^{i \omega t}");
    assert!(last(&format!("{complex}\n{}", display(r"\delta^i_j = a"))).is_err());
}

#[test]
fn letters_that_spell_something_are_refused() {
    let refused = [
        (r"x = A cos \omega t", "cos", r"write `\cos`"),
        (r"x = Acos(\omega t)", "Acos", r"write `\cos`"),
        (r"E = exp(-x)", "exp", r"write `\exp`"),
        (r"S = n RTln 2", "RTln", r"write `\ln`"),
        (r"y = sinkx", "sinkx", r"write `\sin`"),
        (r"v = sqrt(2 g h)", "sqrt", r"write `\sqrt{…}`"),
        (r"a = e^{tanx}", "tanx", r"write `\tan`"),
        (r"f = L + c \ or\ L", "or", r"write `\text{ or }`"),
        (r"f = L \quad if c > 0", "if", r"write `\text{ if }`"),
        (r"f = L if c > 0", "if", r"write `\text{ if }`"),
        (r"f = L or R", "or", r"write `\text{ or }`"),
        (
            r"I_0 = intensity",
            "intensity",
            r"write `\mathrm{intensity}`",
        ),
        (r"F = mass \cdot a", "mass", r"write `\mathrm{mass}`"),
        (r"x = y for all z", "for", r"write `\mathrm{for}`"),
        (r"x = a (mod 3)", "mod", "the notation has no remainders"),
        (r"m = 5\,kg", "kg", r"write `\,\mathrm{kg}`"),
        (r"v = 36 km/h", "km", r"write `\,\mathrm{km}`"),
    ];
    for (math, place, help) in refused {
        let derivation = Derivation::new(vec![Document::markdown("page.md", display(math))]);
        let error = derivation.equations[0].statements.as_ref().expect_err(math);
        let source = &derivation.pages[0].document.source;
        assert_eq!(&source[error.span.range()], place, "{math}");
        assert!(
            error.help.as_ref().unwrap().starts_with(help),
            "{math}: {error:?}"
        );
    }
}

#[test]
fn letters_side_by_side_are_products() {
    let read = [
        "E = mgh + mv + RT + abc + IRt + ABCD",
        r"V = \int_0^a xydx + lcm",
        "v = at = is",
        r"\eta_{max} = \rho_{water} v_{escape}",
        r"x = \text{area}",
        "y = bcghk",
        "W = m a x",
        "W = m if + n or = 1",
        "F = 2 mg + 3 kT + kg",
    ];
    for math in read {
        assert_eq!(last(&display(math)), Ok(()), "{math}");
    }
    let energy = display("E = 3 kg");
    assert!(last(&energy).is_err());
    assert_eq!(last(&format!("{}\n{energy}", display("k = 2 g"))), Ok(()));
    let force = display("F = max");
    assert!(last(&force).is_err());
    assert_eq!(last(&format!("{}\n{force}", display("m + a = x"))), Ok(()));
    assert_eq!(
        last(&format!("where $m$, $a$ and $x$ are measured\n\n{force}")),
        Ok(())
    );
    // What another word spells does not count.
    assert!(last(&format!("{}\n{force}", display("p = max"))).is_err());
    // Three letters that spell a function are a product where all are declared.
    let function = display("y = ln");
    let factors = display("l + n = 1");
    assert!(last(&format!("{factors}\n{function}")).is_err());
    let declared = "<!-- check: symbols l, n: real -->\n\n";
    assert_eq!(last(&format!("{declared}{function}")), Ok(()));
}

#[test]
fn differences_and_sums_are_no_products() {
    let refused = [
        (r"F t = \Delta(mv)", r"\Delta(mv)"),
        (
            r"L = \Delta\left(I\omega\right)",
            r"\Delta\left(I\omega\right)",
        ),
        (r"E = 2 \Delta\{m v\}", r"\Delta\{m v\}"),
        (r"k = \Delta\frac{1}{\lambda}", r"\Delta"),
        (r"\Sigma F = m a", r"\Sigma"),
        (r"P = \Sigma_i m_i v_i", r"\Sigma_i"),
        (r"\Sigma (F + G) = m a", r"\Sigma (F + G)"),
    ];
    for (math, place) in refused {
        let error = last(&display(math)).expect_err(math);
        let (at, message) = error.split_once(": ").unwrap();
        assert_eq!(
            (at, message.starts_with("whether `")),
            (place, true),
            "{math}"
        );
        // In a supposition it is refused, too.
        let supposed = format!("<!-- check: let {math} -->\n\n{}", display("a = b"));
        let derivation = Derivation::new(vec![Document::markdown("page.md", supposed)]);
        assert_eq!(derivation.pages[0].problems.len(), 1, "{math}");
    }
    let read = [
        r"\Delta \cdot (a + b) = \Delta \cdot c",
        r"\Delta p = \Delta E/c",
        r"x = \frac{-b + \sqrt{\Delta}}{2 a}",
        r"\Sigma_a \phi = 1",
    ];
    for math in read {
        assert_eq!(last(&display(math)), Ok(()), "{math}");
    }
    let product = display(r"y = \Delta (a + b)");
    assert!(last(&product).is_err());
    let others = [
        display(r"\Delta = b^2 - 4 a c"),
        "<!-- check: symbols \\Delta: real -->\n".to_owned(),
        "where $\\Delta$ is a length\n".to_owned(),
    ];
    for other in others {
        assert_eq!(last(&format!("{other}\n{product}")), Ok(()), "{other}");
    }
}

#[test]
fn a_parenthesis_after_the_sine_of_an_angle_is_a_factor() {
    let refused = [
        r"a = \sin x (b + c)",
        r"y = A \sin\omega (t - t_0)",
        r"a = \cos 2 x (b + c)",
        r"a = \sin x (b + \cos 2 x)",
    ];
    for math in refused {
        let error = last(&display(math)).expect_err(math);
        assert!(error.contains("where the argument"), "{math}: {error}");
    }
    let page = |before: &str, math: &str| last(&format!("{}\n{}", display(before), display(math)));
    // What the page says of the angle elsewhere.
    for (before, math) in [
        (
            r"\sin\theta_1 = \frac{a}{c}",
            r"y = D \sin\theta_1 \left( 1 - \frac{b}{n} \right)",
        ),
        (
            r"h = \ell (1 - \cos\theta)",
            r"y = \sin^2\theta (a + b) + \cos 2\theta (a - b)",
        ),
        (
            r"a = b",
            r"y = \sin\theta (\omega_c^2 - \omega^2 \cos\theta)",
        ),
        // The sine of a product with that name makes the parenthesis part of the argument.
        (r"y = A \sin \omega t", r"y = A \sin\omega (t - t_0)"),
    ] {
        assert_eq!(page(before, math), Ok(()), "{math}");
    }
    for (before, math) in [
        (r"y = A \sin k t", r"y = A \sin\omega (t - t_0)"),
        (r"y = A \sin \omega t", r"y = A \sin\omega (t - t_0) u"),
        (r"\sin\theta_2 = \frac{a}{c}", r"y = \sin\theta_1 (a + b)"),
        (r"z = \sin\theta (a + c)", r"y = \sin\theta (a + b)"),
    ] {
        assert!(page(before, math).is_err(), "{math}");
    }
}

#[test]
fn no_argument_holds_its_own_function() {
    let page = |math: &str| last(&format!("{}\n{}", display("N(t) = f(x)"), display(math)));
    for math in [
        r"\frac{dN}{dt} = r N \left( 1 - \frac{N}{K} \right)",
        r"\frac{K}{N (K - N)} = \frac{1}{N} + \frac{1}{K - N}",
    ] {
        assert_eq!(page(math), Ok(()), "{math}");
    }
    for math in ["y = N (t + 1)", "y = N (1 - q)", "y = f (1 - f(x))"] {
        assert!(page(math).is_err(), "{math}");
    }
}

/// What could not be read is counted apart from what was, and could not be decided.
#[test]
fn the_summary_counts_what_is_unreadable() {
    let text = "The speed is\n\n$$ v = u + a t \\tag{1} $$\n\nHence\n\n$$ w = \\sin\\omega (t - s) \\tag{2} $$\n\nBy (1) and (2)\n\n$$ w = v \\tag{3} $$\n";
    let derivation = cradle_verify::derivation::Derivation::from_markdown("page.md", text);
    let told = crate::common::human(&derivation);
    let counted = "Of 3 statements, 1 given, 1 undecided and 1 unreadable.";
    assert!(told.contains(counted), "{told}");
}

#[test]
fn what_the_text_calls_a_function_is_no_factor() {
    let wave = display("u = f(x - v t)");
    let told = [
        "The wave is a function $f$ of $x - v t$.",
        "where $f$ and $g$ are arbitrary functions of one variable",
        "For any functions $g$ and $f$,",
        "Here $f$ denotes a smooth function.",
        "The operator $f$ is linear.",
    ];
    for words in told {
        let error = last(&format!("{words}\n{wave}")).expect_err(words);
        assert!(
            error.starts_with("f(x - v t): whether the function"),
            "{words}: {error}"
        );
    }
    let read = [
        "where $f$ is a function of $t$",
        "where $f$ is a known function of $t$",
        "where $f$ is the frequency. The function $g$ is smooth",
        "The function is $f$",
        "As functions, $g$ and",
    ];
    for words in read {
        assert_eq!(last(&format!("{words}\n{wave}")), Ok(()), "{words}");
    }
}

#[test]
fn what_an_operator_acts_on_is_no_factor() {
    let said = "Let $\\hat H$ be the operator of energy.\n\n";
    let said_of_both = "with the operators $\\hat H$ and $L$\n\n";
    for math in [r"\hat H \psi = E \psi", r"a = 2 \hat H^2 b + c"] {
        let error = last(&format!("{said}{}", display(math))).expect_err(math);
        assert!(
            error.contains("the text calls `\\hat{H}` an operator"),
            "{error}"
        );
        assert_eq!(last(&display(math)), Ok(()), "{math}");
    }
    assert!(last(&format!("{said_of_both}{}", display("L y = f"))).is_err());
    let sum = display(r"\hat H = \frac{p^2}{2 m} + V + 2 \hat H");
    assert_eq!(last(&format!("{said}{sum}")), Ok(()));
}
