//! The author's macros and files, and the places of what they stand for.

use cradle_verify::derivation::Derivation;
use cradle_verify::document::Span;

use super::{article, document_of, equations, problems, read};

fn with(preamble: &str, body: &str) -> Derivation {
    read(&format!(
        "\\documentclass{{article}}\n{preamble}\n\\begin{{document}}\n{body}\n\\end{{document}}\n"
    ))
}

#[test]
fn definitions_of_every_kind_are_put_in() {
    let derivation = with(
        r"\newcommand{\half}{\frac12}
\newcommand*\ke[2][m]{\half #1 #2^2}
\renewcommand{\vec}[1]{\mathbf{#1}}
\providecommand{\kin}{\text{kin}}
\providecommand{\sin}{\cos}
\DeclareMathOperator{\area}{area}
\DeclarePairedDelimiter{\abs}{\lvert}{\rvert}
\NewDocumentCommand{\quot}{m m}{\frac{#1}{#2}}
\def\twice#1{2#1}
\let\old\ke
\newenvironment{law}[1]{\begin{equation}\label{#1}}{\end{equation}}
\newcommand{\be}{\begin{equation}}\newcommand{\ee}{\end{equation}}",
        r"\be E_\kin = \ke{v} + \ke[\vec u]{M} \ee
\be \abs{x} = \abs*{\twice y} = \sin z \ee
\begin{law}{key} \old{v} = \quot{a}{b} \cdot \area \end{law}",
    );
    assert_eq!(
        equations(&derivation),
        [
            r"1: E_{\text{kin}} = \frac{1}{2} m v^2 + \frac{1}{2} \mathbf{u} M^2",
            r"2: \left| x \right| = \left| 2 y \right| = \sin\left( z \right)",
            r"3: \frac{1}{2} m v^2 = \frac{a}{b} \text{area}",
        ]
    );
    assert_eq!(problems(&derivation), Vec::<String>::new());
}

#[test]
fn a_definition_in_a_group_ends_with_it() {
    let derivation = with(
        r"\newcommand{\x}{a}",
        r"{\renewcommand{\x}{b} \begin{equation} \x = 1 \end{equation}} \begin{equation} \x = 1 \end{equation}
\begin{center}\def\x{c}\end{center} \begin{equation} \x = 1 \end{equation}
{\gdef\x{d}} \begin{equation} \x = 1 \end{equation}",
    );
    assert_eq!(
        equations(&derivation),
        ["1: b = 1", "2: a = 1", "3: a = 1", "4: d = 1"]
    );
}

#[test]
fn a_letter_after_what_a_macro_stands_for_does_not_lengthen_a_command() {
    let derivation = with(r"\newcommand{\m}{\mu}", r"\[ \m v = v \m \]");
    assert_eq!(equations(&derivation), [r"-: \mu v = v \mu"]);
}

#[test]
fn what_is_not_followed_hinders_only_the_equations_that_use_it() {
    let derivation = with(
        r"\edef\a{x}\def\b#1.{#1}\ifx\a\b \newcommand{\c}{1}\else \newcommand{\c}{2}\fi
\NewDocumentCommand{\d}{O{1} m}{#2}",
        r"\[ \a = 1 \] \[ \b y. = 1 \] \[ \c = 1 \] \[ \d{z} = 1 \] \[ w = 1 \]",
    );
    let read = equations(&derivation);
    assert!(
        read[0].contains(r"`\a` is not put in: it is defined by `\edef`"),
        "{}",
        read[0]
    );
    assert!(read[1].contains("delimited"), "{}", read[1]);
    assert!(read[2].contains("depends on a condition"), "{}", read[2]);
    assert!(read[3].contains("not all plain"), "{}", read[3]);
    assert_eq!(read[4], "-: w = 1");
}

#[test]
fn conditions_that_are_plain_are_followed_and_others_are_told() {
    let derivation = with(
        r"\newif\iflong \longtrue",
        r"\iffalse \[ a = 1 \] \else \[ b = 1 \] \fi
\iflong \[ c = 1 \iff d = 1 \] \else \[ e = 1 \] \fi
\ifnum 1<2 \[ f = 1 \] \fi
\[ g = 1 \]",
    );
    assert_eq!(
        equations(&derivation),
        [r"-: b = 1", r"-: c = 1 \iff d = 1", "-: g = 1"]
    );
    assert_eq!(
        problems(&derivation),
        [r"paper.tex:6: what `\ifnum` decides is not known here"]
    );
}

#[test]
fn macros_without_end_and_macros_that_grow_are_told_at_their_use() {
    for preamble in [
        r"\def\a{\a\a}",
        r"\def\a{\a}",
        r"\newcommand{\a}{\b\b}\newcommand{\b}{\a}",
        r"\def\z{xxxxxxxxxx}\def\y{\z\z\z\z\z\z\z\z\z\z}\def\x{\y\y\y\y\y\y\y\y\y\y}\def\w{\x\x\x\x\x\x\x\x\x\x}
\def\v{\w\w\w\w\w\w\w\w\w\w}\def\a{\v\v\v\v\v\v\v\v\v\v}",
    ] {
        let derivation = with(preamble, "text\n\\a\n\n\\[ b = 1 \\]\n\\[ \\a = 1 \\]");
        let told = problems(&derivation);
        assert!(told[0].contains("comes to too much"), "{told:?}");
        let read = equations(&derivation);
        assert_eq!(read[0], "-: b = 1");
        assert!(read[1].contains("comes to too much"), "{read:?}");
    }
}

#[test]
fn what_is_written_ends_with_the_brace_of_a_macro_at_its_end() {
    let source = "\\documentclass{article}\n\\newcommand{\\paren}[1]{\\left( #1 \\right)}\n\\begin{document}\n\
                  \\[ t = \\gamma \\paren{t' + \\frac{vx'}{c^2}} \\]\n\\[ a = \\paren b \\]\n\\end{document}\n";
    let derivation = read(source);
    let document = &derivation.pages[0].document;
    let written = derivation.equations.iter();
    let written: Vec<&str> = written.map(|own| document.written(own.body)).collect();
    let expected = [r"t = \gamma \paren{t' + \frac{vx'}{c^2}}", r"a = \paren b"];
    assert_eq!(written, expected);
}

#[test]
fn a_place_in_a_macro_is_where_it_is_used_and_one_in_its_argument_is_its_own() {
    let source = "\\documentclass{article}\n\\newcommand{\\f}[1]{\\frac{#1}{\\foo}}\n\\begin{document}\n\
                  \\[ a = \\f{b} \\]\n\\[ a = \\f{\\bar} \\]\n\\end{document}\n";
    let derivation = read(source);
    let places: Vec<(usize, usize, &str)> = derivation
        .equations
        .iter()
        .map(|equation| {
            let error = equation.statements.as_ref().unwrap_err();
            let document = &derivation.pages[0].document;
            let place = document.place(error.span).1;
            (place.line, place.column, document.written(error.span))
        })
        .collect();
    assert_eq!(places[0], (4, 8, r"\f{b}"));
    assert_eq!((places[1].0, places[1].1), (5, 11));
}

#[test]
fn a_place_in_what_an_argument_is_by_default_is_where_the_macro_is_used() {
    let source = "\\newcommand{\\f}[2][\\foo]{#1 = #2}\n\\begin{document}\n\\[ \\f{b} \\]\n\\[ \\f[\\bar]{b} \\]\n\\end{document}\n";
    let derivation = read(source);
    let places: Vec<String> = derivation
        .equations
        .iter()
        .map(|equation| {
            let document = &derivation.pages[0].document;
            let error = equation.statements.as_ref().unwrap_err();
            let place = document.place(error.span).1;
            format!(
                "{}:{} {}",
                place.line,
                place.column,
                document.written(error.span)
            )
        })
        .collect();
    assert_eq!(places, ["3:4 \\f{b}", "4:7 \\bar"]);
}

#[test]
fn files_come_in_where_they_are_named_and_places_are_theirs() {
    let documents = document_of(&[
        (
            "book/main.tex",
            "\\documentclass{article}\\input{defs}\\begin{document}\n\\input{parts/a}\n\\include{parts/b}\nBy (1),\n\\begin{equation} c = 1 \\end{equation}\\end{document}",
        ),
        ("book/defs.tex", "\\newcommand{\\one}{1}\n"),
        (
            "book/parts/a.tex",
            "% first line\n\\begin{equation} a = \\one \\end{equation}\n\\input{deep}",
        ),
        (
            "book/parts/deep.tex",
            "\\begin{equation}\n  b = \\oops\n\\end{equation}\n",
        ),
        (
            "book/parts/b.tex",
            "\\begin{equation} d = \\one \\end{equation}\n",
        ),
    ]);
    let derivation = Derivation::new(documents);
    let places: Vec<String> = derivation
        .equations
        .iter()
        .map(|equation| {
            let (path, place) = derivation.pages[equation.page]
                .document
                .place(equation.body);
            format!(
                "{} {path}:{}:{}",
                equation.tag.as_deref().unwrap(),
                place.line,
                place.column
            )
        })
        .collect();
    assert_eq!(
        places,
        [
            "1 book/parts/a.tex:2:18",
            "2 book/parts/deep.tex:2:3",
            "3 book/parts/b.tex:1:18",
            "4 book/main.tex:5:18",
        ]
    );
    assert_eq!(super::premises(&derivation, "4"), ["1"]);
    let error = derivation.equations[1].statements.as_ref().unwrap_err();
    assert_eq!(derivation.pages[0].document.place(error.span).1.column, 7);
}

#[test]
fn missing_files_and_files_that_take_in_themselves_are_told() {
    let derivation = Derivation::new(document_of(&[
        (
            "main.tex",
            "\\[ a = 1 \\]\n\\input{gone}\n\\input{self}\n\\[ b = 1 \\]\n",
        ),
        ("self.tex", "\\[ c = 1 \\]\n\n\\input{self}\n"),
    ]));
    assert_eq!(
        problems(&derivation),
        [
            "main.tex:2: there is no file `gone`",
            "self.tex:3: `self.tex` takes in itself"
        ]
    );
    assert_eq!(equations(&derivation), ["-: a = 1", "-: c = 1", "-: b = 1"]);
}

#[test]
fn a_preamble_declares_for_every_included_page_and_an_included_page_for_itself() {
    let derivation = Derivation::new(document_of(&[
        (
            "m.tex",
            "\\documentclass{article}\n% check: symbols m: mass\n\\begin{document}\\include{a}\\include{b}\\end{document}",
        ),
        (
            "a.tex",
            "% check: symbols k: count, natural\n\\[ k = 1 \\]\n",
        ),
        ("b.tex", "% check: symbols k: M T^{-2}\n\\[ k = m \\]\n"),
    ]));
    let declared: Vec<usize> = derivation
        .pages
        .iter()
        .map(|p| p.dimensions.len())
        .collect();
    assert_eq!(declared, [1, 2, 2]);
    assert_eq!(problems(&derivation), Vec::<String>::new());
}

#[test]
fn verbatim_text_comments_and_code_hold_no_equations() {
    let derivation = read(&article(
        r"\begin{verbatim} $$ a = 1 $$ \end{verbatim} \verb|$$| \lstinline!\[!
\begin{lstlisting}
\begin{equation} b = 1 \end{equation} % check: nonsense
\end{lstlisting}
\begin{comment} \[ c = 1 \] \end{comment}
% \[ d = 1 \]
\url{http://a/%7Eb}\[ e = 50\% \]
\[ f = 1 \]",
    ));
    assert_eq!(equations(&derivation).last().unwrap(), "-: f = 1");
    assert_eq!(derivation.equations.len(), 2);
    assert_eq!(problems(&derivation), Vec::<String>::new());
}

#[test]
fn mathematics_in_an_unknown_environment_is_told() {
    let told = problems(&read(&article("\\begin{myeq}\n E = m c^2\n\\end{myeq}")));
    assert_eq!(
        told,
        ["paper.tex:5: this belongs to mathematics, and stands in text"]
    );
    let told = problems(&read(&article(
        "\\begin{IEEEeqnarray}{rCl}\n E &=& m c^2\n\\end{IEEEeqnarray}",
    )));
    assert_eq!(
        told,
        ["paper.tex:4: the environment `IEEEeqnarray` is not read here"]
    );
}

#[test]
fn words_between_statements_part_them() {
    let derivation = read(&article(
        r"\[ a = b \quad\text{and}\quad c = d, \qquad \text{where } e = f \]
\[ a = b \quad \text{if } c > 0 \]
\[ a = \SI{3}{m} \] \[ a = \num{2.5} \]",
    ));
    let read = equations(&derivation);
    assert_eq!(read[0], "-: a = b | c = d | e = f");
    assert_eq!(read[1], r"-: a = b \quad \text{if } c > 0");
    assert_eq!(read[2], r"-: a = 3 \unit{m}");
    assert_eq!(read[3], "-: a = 2.5");
}

#[test]
fn a_place_leads_back_to_the_file_that_it_was_copied_from() {
    let main = "\\documentclass{article}\\newcommand{\\five}{12345}\\begin{document}\nabc % gone\ndef \\input{sub} \\five{} ghi\n\\end{document}";
    let document = document_of(&[("main.tex", main), ("sub.tex", "one two")]).remove(0);
    let own = |text: &str| {
        let start = document.source.find(text).unwrap();
        let (file, span) = document.written_at(Span::new(start, start + text.len()));
        (file.path.clone(), file.source[span.range()].to_owned())
    };
    let at = |path: &str, text: &str| (path.to_owned(), text.to_owned());
    assert_eq!(own("bc"), at("main.tex", "bc"));
    assert_eq!(own("ne tw"), at("sub.tex", "ne tw"));
    assert_eq!(own("hi"), at("main.tex", "hi"));
    // What a macro stands for was written where it is used.
    assert_eq!(own("234"), at("main.tex", "\\five"));
    assert_eq!(own("45"), own("12345"));
    // What is put together from several pieces of a file reaches from the first of them to the last.
    let (start, end) = (
        document.source.find("bc").unwrap(),
        document.source.find("ef").unwrap(),
    );
    let across = document.written_at(Span::new(start, end + 2)).1;
    assert_eq!(&main[across.range()], "bc % gone\ndef");
    let end = document.source.find("hi").unwrap();
    let around = document.written_at(Span::new(start, end + 2)).1;
    assert!(main[around.range()].starts_with("bc") && main[around.range()].ends_with("hi"));
}
