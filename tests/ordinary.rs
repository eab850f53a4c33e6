//! The notation that ordinary authors write: read as it is printed, or refused at its place with what to write instead.

use cradle_verify::audit::Audit;
use cradle_verify::derivation::Derivation;
use cradle_verify::document::{Document, Span};
use cradle_verify::notation::{latex_statement, read_unaligned};

/// What is understood, statements parted by `;;`; or the place of what is not, and what is said of it.
fn read(source: &str) -> Result<String, (String, String)> {
    let display = read_unaligned(source, Span::new(0, source.len()));
    let statements = display.statements.map_err(|error| {
        let help = error.help.unwrap_or_default();
        let place = source[error.span.range()].to_owned();
        (place, format!("{}; {help}", error.message))
    })?;
    let all: Vec<String> = statements.iter().map(latex_statement).collect();
    Ok(all.join(" ;; "))
}

fn are_read(cases: &[(&str, &str)]) {
    for (source, understood) in cases {
        assert_eq!(read(source).as_deref(), Ok(*understood), "{source}");
        let again = read(&understood.replace(" ;; ", r" \quad "));
        assert_eq!(again.as_deref(), Ok(*understood), "{source}, printed");
    }
}

/// Each with its place, and something of what is said of it.
fn are_refused(cases: &[(&str, &str, &str)]) {
    for (source, place, said) in cases {
        let (at, message) = read(source).expect_err(source);
        assert_eq!(at, *place, "{source}: {message}");
        assert!(message.contains(said), "{source}: {message}");
    }
}

#[test]
fn a_wide_gap_parts_statements() {
    are_read(&[
        ("a = b~~~~c = d", "a = b ;; c = d"),
        (r"a = b \;\;\; c = d", "a = b ;; c = d"),
        (r"a = b \hspace{1cm} c = d", "a = b ;; c = d"),
        (r"a = b \hspace*{2em} c = d", "a = b ;; c = d"),
        (r"a = b \hspace{\parindent} c = d", "a = b ;; c = d"),
        (r"a = b \hfill c = d \hfill (3)", "a = b ;; c = d"),
        (r"a = b \hskip 1cm plus 1fil c = d", "a = b ;; c = d"),
        (
            r"a = b \hphantom{xxx} \text{and} \;\;\; c = d",
            "a = b ;; c = d",
        ),
        (
            r"a = b~~~\text{for } c > 0",
            r"a = b \quad \text{if } c > 0",
        ),
        // What is no wider than a space between words is a product, and beside a sign a gap parts nothing.
        (r"a = b~c \; f \mkern 3mu g", "a = b c f g"),
        (r"a \;\;=\;\; b ~~ + ~~ c", "a = b + c"),
        (r"a = \quad b \hspace{0.1cm} c", "a = b c"),
        (r"a = \phantom{-}b \vphantom{\frac12} c", "a = b c"),
        (r"a = b \;\;\!\!\! c", "a = b c"),
        (
            r"F = 5~~\mathrm{N}",
            r"F = 5 (\unit{kg} \unit{m} \unit{s}^{-2})",
        ),
    ]);
    are_refused(&[
        ("a = b~~~c", "c", "the wide space before it"),
        (
            r"a = \frac{b \hspace{1em} c}{2}",
            r"\hspace{1em}",
            "a wide space",
        ),
        (r"a = b \phantom{-} c", "c", "the wide space before it"),
        (r"a = b \hskip c", r"\hskip", "needs a length"),
        (r"a = b \hskip 1cm plus c", r"\hskip 1cm", "needs a length"),
    ]);
}

#[test]
fn an_alignment_mark_that_aligns_nothing_is_refused() {
    are_refused(&[
        ("a&2 = b", "&", "this `&` aligns nothing"),
        ("a &= 2", "&", r"\begin{aligned}"),
        ("a = b & c = d", "&", "this `&` aligns nothing"),
    ]);
    are_read(&[(r"\begin{aligned} a &= 2 \\ &= b \end{aligned}", "a = 2 = b")]);
}

#[test]
fn characters_are_what_their_commands_print() {
    are_read(&[
        ("α = β²", r"\alpha = \beta^2"),
        ("x⁻¹ = v₁₂ + Ω₀", r"x^{-1} = v_{12} + \Omega_0"),
        ("2·a×b⋅c ≈ φ", r"2 a b c \approx \varphi"),
        (
            "½ m v² = E, ΔE ≥ 0",
            r"\frac{1}{2} m v^2 = E ;; \Delta E \geq 0",
        ),
        ("x = ±2", r"(x - 2) (x - (-2)) = 0"),
        ("y = \\lim_{x→∞} ℏ µ", r"y = \lim_{x \to \infty} \hbar \mu"),
        (
            r"\sin 30° = a",
            r"\sin\left( \frac{30 \pi}{180} \right) = a",
        ),
        (
            r"\sin 30\degree = a",
            r"\sin\left( \frac{30 \pi}{180} \right) = a",
        ),
        (
            "a = b ⇒ ∂_x f = 0",
            r"a = b \Rightarrow \frac{\partial f}{\partial x} = 0",
        ),
        (r"\hslash = h", r"\hbar = h"),
    ]);
    are_refused(&[
        ("x = √2", "√", r"write `\sqrt{…}`"),
        ("x = 2¹²", "¹²", "one digit"),
        ("x² ^3 = y", "^3", "second"),
        ("a – b = c", "–", "write `-`"),
        ("T = 25°C", "°", "write the temperature in kelvin"),
        ("x = a ☃", "☃", "is not known"),
    ]);
}

#[test]
fn braces_around_nothing_hold_nothing() {
    are_read(&[
        (r"{}+a = {}-b{}", "a = -b"),
        (r"\sin{} x = a {} b", r"\sin\left( x \right) = a b"),
        // They part no gap.
        (r"a = b~{}~{}~c = d", "a = b ;; c = d"),
        (r"a = b{~~~~}c = d", "a = b ;; c = d"),
        (r"a = b {\hspace{1cm}} c = d", "a = b ;; c = d"),
        (r"a ={}~~~~b~{}c", "a = b c"),
    ]);
    are_refused(&[
        (r"T^a{}_b = c", "}", "a term is missing"),
        (r"\frac{}{a} = b", "}", "a term is missing"),
        (r"\frac{a}{} = b", "}", "a term is missing"),
        (r"x^{} = b", "}", "a term is missing"),
        (r"a = 1{}2", "2", "two numbers"),
    ]);
}

#[test]
fn cotangents_and_their_like_are_quotients() {
    are_read(&[
        (
            r"\cot x = \sec y \csc z",
            r"\frac{\cos\left( x \right)}{\sin\left( x \right)} = \frac{1}{\cos\left( y \right)} \frac{1}{\sin\left( z \right)}",
        ),
        (
            r"\operatorname{csc} 30^\circ = a",
            r"\frac{1}{\sin\left( \frac{30 \pi}{180} \right)} = a",
        ),
        (
            r"\coth x = a",
            r"\frac{\exp\left( x \right) + \exp\left( -x \right)}{\exp\left( x \right) - \exp\left( -x \right)} = a",
        ),
        (
            r"\operatorname{sech} x = \csch y",
            r"\frac{2}{\exp\left( x \right) + \exp\left( -x \right)} = \frac{2}{\exp\left( y \right) - \exp\left( -y \right)}",
        ),
        (
            r"\operatorname{artanh} x = a",
            r"\frac{1}{2} \ln\left( \frac{1 + x}{1 - x} \right) = a",
        ),
        (
            r"\operatorname{arcosh} x = \operatorname{arcsinh} y",
            r"\ln\left( x + \sqrt{x^2 - 1} \right) = \ln\left( y + \sqrt{y^2 + 1} \right)",
        ),
        // A function after a stroke begins what is divided by.
        (
            r"\sin x/\cos x = \ln a/\ln b",
            r"\frac{\sin\left( x \right)}{\cos\left( x \right)} = \frac{\ln\left( a \right)}{\ln\left( b \right)}",
        ),
    ]);
    are_refused(&[
        (r"\cot\cot x = a", r"\cot", "inside of another one"),
        (
            r"\sinh\operatorname{arsinh} x = a",
            r"\operatorname{arsinh}",
            "of another one",
        ),
        (
            r"\tanh^{-1} x = a",
            r"\tanh^{-1}",
            r"write `\operatorname{artanh}`",
        ),
        (r"\sinh\cot x = a", r"\cot", "inside of another one"),
        (r"\sin^{-1} x = a", r"\sin^{-1}", r"write `\arcsin`"),
        (r"\sinh^{-1} x = a", r"\sinh^{-1}", "inverse function"),
        (
            r"\ln a/b = c",
            "/",
            "where the argument of this function ends",
        ),
        (r"x = \cot y^2 (a + b)", "(a + b)", "where the argument"),
    ]);
}

#[test]
fn what_is_said_of_several_names_is_said_of_each() {
    are_read(&[
        ("a, b > 0", "a > 0 ;; b > 0"),
        (
            r"x = a b, \quad v_1, \dot x, \alpha' \neq 0",
            r"x = a b ;; v_1 \neq 0 ;; \dot{x} \neq 0 ;; \alpha' \neq 0",
        ),
        (
            r"x = y \quad (a, b > 0)",
            r"x = y \quad \text{if } a > 0 \text{ and } b > 0",
        ),
        (
            r"x = y \quad \text{for } a, b > c \geq 0",
            r"x = y \quad \text{if } a > c \geq 0 \text{ and } b > c \geq 0",
        ),
    ]);
    are_refused(&[
        ("x, y = 2", "x", "this is a term"),
        ("x, y + z > 2", "x", "this is a term"),
        ("0 < a, b < 1", "0 < a, b < 1", "whether both lie"),
        (
            r"a, b > 0 \Rightarrow c = d",
            r"b > 0 \Rightarrow c = d",
            "write a statement for each",
        ),
        ("a, b > 0 = c", "a", "whether the same is said"),
        (r"x = y \quad \text{for } a, b = 0", "a", "this is a term"),
    ]);
}

#[test]
fn ink_means_nothing() {
    are_read(&[
        (r"v = {\color{red} x}", "v = x"),
        (r"v = \color[rgb]{1,0,0} x + y", "v = x + y"),
        (r"v \textcolor{red}{= a} \mathcolor{blue}{- b}", "v = a - b"),
        (r"\textcolor{red}{v = a}", "v = a"),
        (r"\textcolor{red}{v}^2 = \smash{x}", "v^2 = x"),
        (r"a = b~~\textcolor{red}{~~c} = d", "a = b ;; c = d"),
        (r"a = b \qed", "a = b"),
        (r"a = b \quad \blacksquare", "a = b"),
        (r"a = b \hbox{ and } c = d", "a = b ;; c = d"),
    ]);
    are_refused(&[
        (
            r"v = 2\textcolor{red}{a + b}",
            "{a + b}",
            "does not print these braces",
        ),
        (
            r"v = \textcolor{red}{a + b}^2",
            "{a + b}",
            "does not print these braces",
        ),
        (r"a = \square", r"\square", "at the very end"),
        (r"a = b \mathrel{\phantom{=}} c", "c", "this is a term"),
    ]);
}

#[test]
fn signs_that_define() {
    for sign in [
        r"\triangleq",
        r"\coloneq",
        "=:",
        r"\colon=",
        r"\mathrel{:=}",
        r"\mathrel{\mathop:}=",
    ] {
        assert_eq!(
            read(&format!("a {sign} b")).as_deref(),
            Ok("a = b"),
            "{sign}"
        );
    }
    are_read(&[(r"a \geqq b \leqq c", r"a \geq b \leq c")]);
}

#[test]
fn short_names_of_units() {
    are_read(&[
        (r"v = \qty{5}{\m\per\s}", r"v = 5 \unit{m} \unit{s}^{-1}"),
        (
            r"F = \SI{5}{\kg\m\per\s\squared}",
            r"F = 5 \unit{kg} \unit{m} \unit{s}^{-2}",
        ),
        (r"x = \SI{5}{\um}", r"x = 5 (0.000001 \unit{m})"),
    ]);
    are_refused(&[(
        r"x = \SI{5}{\quux}",
        r"\SI{5}{\quux}",
        r"the unit `\quux` is not read",
    )]);
}

#[test]
fn what_the_notation_lacks_is_named() {
    are_refused(&[
        (r"x \equiv a \pmod{3}", r"\pmod", "no remainders"),
        (r"\det A = a", r"\det", "give its value a name"),
        (r"x \in [0, 1]", r"\in", r"0 \leq x \leq 1"),
        (r"\|x\| = a", r"\|", "no norms"),
        (r"a \ast b = c", r"\ast", r"\cdot"),
        (r"a = b \because c = d", r"\because", "in the text"),
        (
            r"M = \begin{pmatrix} a & b \\ c & d \end{pmatrix}",
            r"\begin{pmatrix}",
            "no matrices",
        ),
        (
            r"\begin{bmatrix} a \\ b \end{bmatrix} = M",
            r"\begin{bmatrix}",
            "no matrices",
        ),
        (r"y = \lim_{x \to 0^+} f", "0^+", "from one side"),
        (r"y = \lim_{x \to a^{-}} f", "a^{-}", "from one side"),
        (r"y = \iint f", r"\iint", "one inside the other"),
        (r"\dddot x = j", r"\dddot", r"\frac{d^3 x}{dt^3}"),
        (r"a = \textbf{F}", r"\textbf", r"\mathbf"),
    ]);
}

#[test]
fn a_reason_beside_a_row_is_what_it_cites() {
    are_read(&[
        (
            r"\begin{aligned} a &= b && \text{by (1)} \\ &= c & \text{(using Eqs. (1) and (2))} \end{aligned}",
            "a = b = c",
        ),
        (
            r"a = b \quad \text{from } \eqref{law}, \quad c = d",
            "a = b ;; c = d",
        ),
        (r"a = b \quad \text{(by~\eqref{law})}.", "a = b"),
    ]);
    are_refused(&[
        (
            r"a = b \quad \text{(since $x > 0$)}",
            r"\text{(since $x > 0$)}",
            "give it in the text",
        ),
        (
            r"a = b \quad \text{by symmetry}",
            r"\text{by symmetry}",
            "give it in the text",
        ),
        (
            r"a = b \quad \text{by (1), as friction is small}",
            r"\text{by (1), as friction is small}",
            "in the text",
        ),
        (r"a = b \quad \text{by (1)} c", r"\text{by (1)}", "not read"),
    ]);
    let page = |reason: &str| {
        let text = format!(
            "$$ a = b \\tag{{1}} $$\n\n$$ c = d \\tag{{2}} $$\n\n$$ 2 a = 2 b \\quad {reason} $$\n"
        );
        let derivation = Derivation::new(vec![Document::markdown("a.md", text)]);
        let audit = Audit::of(&derivation);
        let last = audit.entries.last().unwrap();
        let codes: Vec<&str> = last.notes.iter().map(|note| note.code()).collect();
        (last.verdict.word(), codes)
    };
    assert_eq!(page(r"\text{by (1)}"), ("holds", vec![]));
    assert_eq!(page(r"\text{by } \eqref{1}"), ("holds", vec![]));
    assert_eq!(page(r"\text{by (2)}").1, ["miscited"]);
}
