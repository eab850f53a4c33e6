//! Documents that are broken, huge or made to harm.

use cradle_verify::document::Document;
use cradle_verify::document::Item;
use proptest::prelude::*;

use super::{Files, article, document_of, equations, problems, read};

#[test]
fn deep_braces_and_many_openings_are_read_in_time() {
    for body in [
        format!("\\[ {}a{} = 1 \\]", "{".repeat(10_000), "}".repeat(10_000)),
        "{".repeat(10_000),
        "\\f{".repeat(10_000),
        "\\begin{equation} a = 1 ".repeat(3_000),
        "$$ a = 1 \n\n".repeat(3_000),
        "\\[ a ".repeat(10_000),
        "$a ".repeat(10_001),
        "\\iffalse ".repeat(10_000),
        "\\begin{x}".repeat(10_000),
        "\\newcommand{\\a}[1]{".repeat(3_000),
        "\\section{".repeat(3_000),
        "\\verb|".repeat(10_001),
        "% check: ".repeat(3_000),
    ] {
        let source = format!(
            "\\documentclass{{article}}\\newcommand{{\\f}}[1]{{#1}}\\begin{{document}}{body}\\end{{document}}"
        );
        let documents = Document::latex("deep.tex", source, &());
        let told: usize = documents
            .iter()
            .map(|d| d.problems.len() + d.items.len())
            .sum();
        assert!(
            told > 0 || body.starts_with('{') || body.starts_with("\\begin{x}"),
            "{}",
            &body[..20]
        );
    }
}

#[test]
fn a_long_document_is_read_in_linear_time() {
    let one = "Text with $x_1$ and \\emph{words}, by \\eqref{k}. % comment\n\\begin{align} \\a &= b \\\\ &= c \\end{align}\n\n";
    let body = one.repeat(5_000_000 / one.len());
    let source = format!("\\newcommand{{\\a}}{{x}}\n{body}");
    let documents = Document::latex("long.tex", source, &());
    let displays = documents[0]
        .items
        .iter()
        .filter(|i| matches!(i, Item::Display { .. }));
    assert_eq!(displays.count(), 5_000_000 / one.len());
}

#[test]
fn unterminated_displays_are_told_and_the_next_one_is_read() {
    let derivation = read(&article(
        "\\begin{equation} a = 1\n\n\\begin{equation} b = 1 \\end{equation}\n\n$$ c = 1\n\n\\[ d = 1 \\] \\begin{align} e &= 1 \\end{equation}\n\n\\[ f = 1 \\]",
    ));
    assert_eq!(equations(&derivation), ["-: b = 1", "-: d = 1", "-: f = 1"]);
    let told = problems(&derivation);
    assert_eq!(told.len(), 4, "{told:?}");
    assert!(
        told[0].ends_with("this `equation` is never closed"),
        "{told:?}"
    );
    assert!(told[1].ends_with("this `$$` is never closed"), "{told:?}");
    assert!(
        told[2].ends_with("this `align` is never closed"),
        "{told:?}"
    );
}

#[test]
fn line_ends_of_every_kind_and_a_byte_order_mark_are_read() {
    let source = article(
        "Text.\n\n\\begin{align}\n a &= 1 \\\\\n b &= 1\n\\end{align}\n% check: law\n\\[ c = 1 \\]",
    );
    for source in [
        source.clone(),
        source.replace('\n', "\r\n"),
        format!("\u{feff}{source}"),
    ] {
        let derivation = read(&source);
        assert_eq!(equations(&derivation), ["1: a = 1", "2: b = 1", "-: c = 1"]);
        let place = derivation.pages[0]
            .document
            .place(derivation.equations[1].body)
            .1;
        assert_eq!((place.line, place.column), (8, 2));
        assert_eq!(derivation.equations[2].kind.word(), "given");
    }
}

#[test]
fn bytes_that_are_no_text_are_told_in_the_file_that_has_them() {
    let mut files = Files::default();
    files.0.insert("bad.tex", b"\\[ a = \xff \\]".to_vec());
    let documents = Document::latex("main.tex", "\\input{bad}\n\\[ a = \0 \\]", &files);
    let derivation = cradle_verify::derivation::Derivation::new(documents);
    let told = problems(&derivation);
    assert_eq!(
        told,
        ["main.tex:1: `bad.tex` is not UTF-8 text: byte 8, on line 1"]
    );
    assert!(equations(&derivation)[0].contains("is not known"));
}

/// What LaTeX documents are made of, and what they are broken by.
const PARTS: &[&str] = &[
    "\\begin{equation}",
    "\\end{equation}",
    "\\begin{align}",
    "\\end{align}",
    "\\begin{align*}",
    "\\end{align*}",
    "\\begin{gather}",
    "\\end{gather}",
    "\\begin{split}",
    "\\end{split}",
    "\\begin{subequations}",
    "\\end{subequations}",
    "\\[",
    "\\]",
    "$$",
    "$",
    "\\(",
    "\\)",
    "{",
    "}",
    "[",
    "]",
    "%",
    "\n",
    "\n\n",
    " ",
    "\\\\",
    "&",
    "=",
    "a",
    "b",
    "1",
    "+",
    "-",
    "^",
    "_",
    "\\frac",
    "\\label{k}",
    "\\tag{3}",
    "\\notag",
    "\\nonumber",
    "\\intertext{so}",
    "\\text{and}",
    "\\newcommand{\\a}",
    "\\newcommand{\\b}[1]{#1#1}",
    "\\def\\a",
    "#",
    "#1",
    "\\a",
    "\\b",
    "\\let\\a\\b",
    "\\iffalse",
    "\\else",
    "\\fi",
    "\\input{main}",
    "\\include{x}",
    "\\section{S}",
    "\\section*",
    "\\section{S}\\label{s}",
    " as shown in ",
    "\\ref{s}.",
    " by \\cref{k}",
    "\n\nHence ",
    "% check: law\n",
    "% check: from (1)\n",
    "%   symbols m: mass\n",
    "\\verb|x|",
    "\\begin{verbatim}",
    "\\end{verbatim}",
    "\\begin{document}",
    "\\end{document}",
    "\\eqref{k}",
    "(1)",
    "é",
    "\\appendix",
    "\\numberwithin{equation}{section}",
    "\\setcounter{equation}{3}",
    "\\ensuremath{x}",
    "\\%",
    "\\$",
    "\\begin{cases}",
    "\\end{cases}",
    "\\newenvironment{e}{\\begin{equation}}{\\end{equation}}",
    "\\begin{e}",
    "\\end{e}",
    "\\makeatletter",
    "\\quad",
    ",",
    "\r\n",
    "\\",
    "\\operatorname{f}",
    "\\left(",
    "\\right)",
];

/// What takes text away, or puts it elsewhere.
const AWAY: &[&str] = &[
    "%",
    "\\verb",
    "\\if",
    "\\newcommand",
    "\\def",
    "\\let",
    "\\newenv",
    "{e}",
    "\\in",
    "{document}",
    "{verbatim}",
    "\\section",
];

fn tokens(plain: bool) -> impl Strategy<Value = String> {
    let away = |part: &&str| !plain || !AWAY.iter().any(|away| part.contains(away));
    let parts: Vec<&str> = PARTS.iter().copied().filter(away).collect();
    prop::collection::vec(prop::sample::select(parts), 0..60).prop_map(|parts| parts.concat())
}

/// Where displays begin in a text without macros, conditions, verbatim text and comments.
fn openings(text: &str) -> Vec<usize> {
    let mut found = Vec::new();
    let mut at = 0;
    while at < text.len() {
        let rest = &text[at..];
        if rest.starts_with("\\begin{equation}") || rest.starts_with("\\begin{align") {
            found.push(at);
        }
        at += match rest.starts_with('\\') {
            true => 1 + rest[1..].chars().next().map_or(0, char::len_utf8),
            false => rest.chars().next().map_or(1, char::len_utf8),
        };
    }
    found
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(400) })]

    #[test]
    fn no_text_is_too_strange(source in prop_oneof![tokens(false), any::<String>()]) {
        let files = [("main.tex", &*source), ("x.tex", "\\[ x = 1 \\]")];
        let derivation = cradle_verify::derivation::Derivation::new(document_of(&files));
        for page in &derivation.pages {
            let document = &page.document;
            for span in document.items.iter().map(Item::span) {
                prop_assert!(document.source.get(span.range()).is_some());
                let (file, span) = document.written_at(span);
                prop_assert!(file.source.get(span.range()).is_some());
            }
            for problem in &page.problems {
                prop_assert!(document.source.get(problem.span.range()).is_some());
                document.written(problem.span);
            }
        }
        for equation in &derivation.equations {
            if let Err(error) = &equation.statements {
                derivation.pages[equation.page].document.written(error.span);
            }
        }
    }

    #[test]
    fn every_display_is_read_or_told(source in tokens(true)) {
        let documents = document_of(&[("main.tex", &source)]);
        let document = &documents[0];
        let covered = |at: usize| {
            let spans = document.items.iter().filter_map(|item| match item {
                Item::Display { span, .. } => Some(*span),
                _ => None,
            });
            spans.chain(document.problems.iter().map(|p| p.span)).any(|span| {
                let span = document.origin.of(span).1;
                span.start <= at && at < span.end.max(span.start + 1)
            })
        };
        for at in openings(&source) {
            prop_assert!(covered(at), "{at} in {source:?}: {:?}", document.problems);
        }
    }
}
