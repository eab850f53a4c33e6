//! The notation that ordinary authors write: read as it is printed, or refused at its place with what to write instead.

use cradle_verify::document::Span;
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
