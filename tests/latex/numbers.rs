//! Numbers as they are printed, and citations by number and by key.

use cradle_verify::audit::{Audit, Note, Verdict};
use cradle_verify::derivation::Derivation;

use super::{article, equations, premises, problems, read};

fn numbers(source: &str) -> String {
    let derivation = read(source);
    let tags = derivation
        .equations
        .iter()
        .map(|e| e.tag.as_deref().unwrap_or("-").to_owned());
    tags.collect::<Vec<_>>().join(" ")
}

#[test]
fn each_row_of_align_has_a_number_and_a_starred_environment_has_none() {
    let source = article(
        r"
\begin{equation} a = 1 \end{equation}
\begin{equation*} b = 1 \end{equation*}
\[ c = 1 \]
\begin{align} d &= 1 \\ e &= 1 \nonumber \\ f &= 1 \tag{T} \\ g &= 1 \end{align}
\begin{gather} h = 1 \\ i = 1 \end{gather}
\begin{eqnarray} j & = & 1 \\ k & = & 1 \end{eqnarray}
\begin{multline} l = 1 \\ + 2 \end{multline}
$$ m = 1 $$
\begin{equation} \begin{split} n &= 1 \\ &= 2 - 1 \end{split} \end{equation}",
    );
    assert_eq!(numbers(&source), "1 - - 2 - T 3 4 5 6 7 8 - 9");
}

#[test]
fn words_between_rows_end_the_row_before_them() {
    let source = article(
        r"
\begin{align} a &= b + c \intertext{and with it} d &= e \\ \intertext{so} f &= g \shortintertext{or} g &= h \end{align}",
    );
    assert_eq!(
        equations(&read(&source)),
        ["1: a = b + c", "2: d = e", "3: f = g", "4: g = h"]
    );
}

#[test]
fn numbers_follow_sections_appendices_and_subequations() {
    let source = r"\documentclass{article}
\numberwithin{equation}{section}
\begin{document}
\section{One}
\begin{equation} a = 1 \end{equation}
\section*{Not counted}
\begin{subequations} \label{both}
\begin{align} b &= 1 \label{first} \\ c &= 1 \end{align}
\end{subequations}
\begin{equation} d = 1 \end{equation}
\section{Two}
\setcounter{equation}{6}
\begin{equation} e = 1 \end{equation}
\appendix
\section{Three}
\begin{equation} f = 1 \end{equation}
\end{document}";
    assert_eq!(numbers(source), "1.1 1.2a 1.2b 1.3 2.7 A.1");
}

#[test]
fn a_book_numbers_by_chapter_and_a_format_of_the_authors_is_followed() {
    let book = r"\documentclass{book}\begin{document}\chapter{A}\chapter{B}
\begin{equation} a = 1 \end{equation}\section{C}\begin{equation} b = 1 \end{equation}\end{document}";
    assert_eq!(numbers(book), "2.1 2.2");
    let own = r"\documentclass{article}\renewcommand{\theequation}{\Roman{section}-\alph{equation}}
\begin{document}\section{A}\begin{equation} a = 1 \end{equation}\end{document}";
    assert_eq!(numbers(own), "I-a");
}

#[test]
fn an_unknown_counter_value_is_told_and_no_number_is_made_up() {
    let source = article(
        r"\begin{equation} a = 1 \end{equation}\setcounter{equation}{\foo}\begin{equation} b = 1 \end{equation}",
    );
    assert_eq!(numbers(&source), "1 -");
    assert_eq!(problems(&read(&source)).len(), 1);
}

#[test]
fn a_row_that_begins_with_a_relation_goes_on_with_the_row_before() {
    let derivation = read(&article(
        r"\begin{align} a &= b + c \\ &= c + b \\ d &= e \\ &\le f \label{last} \end{align}
From \eqref{last},
\begin{equation} d \le f \end{equation}",
    ));
    assert_eq!(
        equations(&derivation),
        [
            "1: a = b + c",
            "2: b + c = c + b",
            "3: d = e",
            "4: e \\leq f",
            "5: d \\leq f"
        ]
    );
    // What goes on with (3) is cited together with it.
    assert_eq!(premises(&derivation, "5"), ["3", "4"]);
}

#[test]
fn a_row_without_a_number_belongs_to_the_next_that_has_one() {
    let derivation = read(&article(
        r"\begin{align} a &= b \notag \\ &\quad + c \\ d &= e \\ &= f \notag \end{align}",
    ));
    assert_eq!(equations(&derivation), ["1: a = b + c", "2: d = e = f"]);
}

#[test]
fn pairs_of_columns_are_equations_side_by_side() {
    let derivation = read(&article(
        r"\begin{align} a &= b & c &= d \\ e &= f && \text{and} & g &= h \end{align}
\[ \begin{aligned} a &= b & c &= d \end{aligned} \]",
    ));
    assert_eq!(
        equations(&derivation),
        ["1: a = b | c = d", "2: e = f | g = h", "-: a = b | c = d"]
    );
}

#[test]
fn citations_by_key_number_and_range_lead_to_what_is_printed() {
    let derivation = read(&article(
        r"\section{S} \label{sec}
\begin{equation} a = 1 \label{a} \end{equation}
\begin{equation} b = 1 \label{b} \end{equation}
\begin{subequations} \label{sub}
\begin{equation} c = 1 \end{equation} \begin{equation} d = 1 \label{d} \end{equation}
\end{subequations}
As section~\ref{sec} says, by Eq.~(1),
\begin{equation} e = 1 \end{equation}
by \eqref{sub},
\begin{equation} f = 1 \end{equation}
by \cref{a,b},
\begin{equation} g = 1 \end{equation}
by \eqref{a}--\eqref{d},
\begin{equation} h = 1 \end{equation}
by Eqs.~(1)--(2) and \autoref{nothing},
\begin{equation} i = 1 \end{equation}
by \crefrange{a}{b},
\begin{equation} j = 1 \end{equation}
by Eqs.~(\ref{a})--(\ref{d}),
\begin{equation} k = 1 \end{equation}
by (\ref{a})\,--\,(\ref{d}),
\begin{equation} l = 1 \end{equation}
by equations (\ref{a}) to (\ref{d}),
\begin{equation} m = 1 \end{equation}
by (\ref*{a}), (\ref{b}) and \autoref*{d},
\begin{equation} n = 1 \end{equation}",
    ));
    assert_eq!(premises(&derivation, "4"), ["1"]);
    assert_eq!(premises(&derivation, "5"), ["3a", "3b"]);
    assert_eq!(premises(&derivation, "6"), ["1", "2"]);
    assert_eq!(premises(&derivation, "7"), ["1", "2", "3a", "3b"]);
    assert_eq!(premises(&derivation, "8"), ["1", "2", "unknown (nothing)"]);
    assert_eq!(premises(&derivation, "9"), ["1", "2"]);
    for range in ["10", "11", "12"] {
        assert_eq!(premises(&derivation, range), ["1", "2", "3a", "3b"]);
    }
    assert_eq!(premises(&derivation, "13"), ["1", "2", "3b"]);
}

#[test]
fn directives_in_comments_are_about_the_display_or_the_row_they_stand_before() {
    let derivation = read(
        r"\documentclass{article}
\newcommand{\vin}{v_0}
% check: symbols m: mass, positive
%   symbols \vin: velocity
% an ordinary comment with $$ x = y $$
\begin{document}
% check: law
\begin{equation} p = m \vin \end{equation}
\begin{align}
  % check: given
  q &= p \\
  % check: derived; from \eqref{x}, (1)
  r &= q \label{x}
\end{align}
\end{document}",
    );
    let kinds: Vec<&str> = derivation.equations.iter().map(|e| e.kind.word()).collect();
    assert_eq!(kinds, ["given", "given", "derived"]);
    assert_eq!(premises(&derivation, "3"), ["1"]);
    let declared: Vec<String> = derivation.pages[0]
        .dimensions
        .keys()
        .map(|symbol| symbol.to_string())
        .collect();
    assert_eq!(declared, ["m", "v_0"]);
    assert_eq!(problems(&derivation), Vec::<String>::new());
}

#[test]
fn after_equations_that_are_not_read_no_number_is_made_up_until_the_count_begins_anew() {
    let source = r"\documentclass{article}\numberwithin{equation}{section}
\begin{document}\section{A}
\begin{equation} a = 1 \end{equation}
\begin{IEEEeqnarray}{l} b = 1 \end{IEEEeqnarray}
\begin{equation} c = 1 \end{equation}
\section{B}
\begin{equation} d = 1 \end{equation}
\input{gone}
\begin{equation} e = 1 \label{e} \end{equation}
\begin{equation} f = 1 \tag{F} \end{equation}
\end{document}";
    assert_eq!(numbers(source), "1.1 - 2.1 - F");
    assert_eq!(problems(&read(source)).len(), 2);
}

#[test]
fn a_comma_at_the_end_of_a_row_does_not_part_it_from_a_row_that_goes_on() {
    let derivation = read(&article(
        r"\begin{align} a &= b, \\ &= c, \\ \implies c &= a. \end{align}",
    ));
    assert_eq!(equations(&derivation), ["1: a = b", "2: b = c", "3: c = a"]);
}

#[test]
fn a_key_in_a_title_is_no_equation() {
    let derivation = read(&article(
        r"\section{Start\label{start}} As \ref{start} says, \begin{equation} a = 1 \end{equation}",
    ));
    assert_eq!(premises(&derivation, "1"), Vec::<String>::new());
}

#[test]
fn equations_are_numbered_by_section_from_where_that_is_said() {
    let source = r"\documentclass{article}\begin{document}
\begin{equation} a = 1 \end{equation}
\numberwithin{equation}{section}
\section{One}\section{Two}
\begin{equation} b = 1 \end{equation}
\appendix
\section{Three}
\begin{equation} c = 1 \end{equation}
\end{document}";
    assert_eq!(numbers(source), "1 2.1 A.1");
}

#[test]
fn subequations_share_a_number_by_which_they_are_cited() {
    let source = article(
        r"\begin{equation} a = 1 \end{equation}
\begin{subequations} \label{both}
\begin{align} b &= 1 \\ c &= 1 \end{align}
\end{subequations}
By \eqref{both},
\begin{equation} d = 1 \end{equation}",
    );
    assert_eq!(numbers(&source), "1 2a 2b 3");
    assert_eq!(premises(&read(&source), "3"), ["2a", "2b"]);
}

#[test]
fn a_format_that_refers_to_itself_gives_no_number() {
    let source = r"\documentclass{article}\begin{document}
\renewcommand{\theequation}{\theequation}
\begin{equation} a = 1 \end{equation}
\renewcommand{\theequation}{\thesection.\roman{equation}}
\setcounter{equation}{3}
\begin{equation} b = 1 \end{equation}
\end{document}";
    assert_eq!(numbers(source), "- 0.iv");
}

#[test]
fn what_stands_above_a_relation_sign_is_cited() {
    let derivation = read(&article(
        r"
\begin{equation} a = b \label{first} \end{equation}
\begin{equation} c = d \end{equation}
\begin{equation} a + c \overset{\eqref{first}}{=} b + c \stackrel{(2)}{=} b + d. \end{equation}",
    ));
    assert_eq!(premises(&derivation, "3"), ["1", "2"]);
}

#[test]
fn a_section_that_the_sentence_of_a_display_names_is_no_premise() {
    for words in [
        r"as shown in Section~\ref{s}.",
        r"by theorem \ref{s}, and by \eqref{law}.",
        r"where $a$ is defined in Section~\autoref{s}. By \eqref{law}, as in \ref{s},",
    ] {
        let source = format!(
            "\\documentclass{{article}}\\begin{{document}}\\section{{Law}}\\label{{s}}\n\
             \\begin{{equation}}\\label{{law}} a = b \\end{{equation}}\n{words}\n\
             \\begin{{equation}} 2 a = 2 b \\end{{equation}}\\end{{document}}\n"
        );
        let derivation = Derivation::from_latex("page.tex", &source);
        let audit = Audit::of(&derivation);
        let last = audit.entries.last().unwrap();
        assert_eq!(
            (audit.entries.len(), last.verdict),
            (2, Verdict::Holds),
            "{words}"
        );
        let cites_nowhere = |note: &Note| matches!(note, Note::UnknownCitation(..));
        assert!(!last.notes.iter().any(cites_nowhere), "{words}");
    }
}

#[test]
fn a_star_lets_the_count_begin_anew_and_the_number_be_printed_as_before() {
    let source = r"\documentclass{article}\counterwithin*{equation}{section}\begin{document}
\section{A}\begin{equation} a = 1 \end{equation}\begin{equation} b = 1 \end{equation}
\section{B}\begin{equation} c = 1 \end{equation}
\counterwithout*{equation}{section}
\section{C}\begin{equation} d = 1 \end{equation}\end{document}";
    assert_eq!(numbers(source), "1 2 1 2");
}

#[test]
fn what_stands_outside_of_numbered_chapters_has_no_number_of_a_chapter() {
    let source = r"\documentclass{book}\begin{document}
\begin{equation} a = 1 \end{equation}
\frontmatter \chapter{Preface} \begin{equation} b = 1 \end{equation}
\mainmatter \chapter{One} \begin{equation} c = 1 \end{equation}
\backmatter \chapter{End} \begin{equation} d = 1 \end{equation}\end{document}";
    assert_eq!(numbers(source), "1 2 1.1 1.2");
}

#[test]
fn appendices_between_two_sections_are_counted_by_themselves() {
    let source = r"\documentclass{article}\numberwithin{equation}{section}\begin{document}
\section{One}\begin{equation} a = 1 \end{equation}
\begin{appendices}\section{More}\begin{equation} b = 1 \end{equation}\end{appendices}
\section{Two}\begin{equation} c = 1 \end{equation}\end{document}";
    assert_eq!(numbers(source), "1.1 A.1 2.1");
    let report = r"\documentclass{report}\begin{document}\chapter{One}
\begin{appendix}\chapter{More}\begin{equation} a = 1 \end{equation}\end{appendix}\end{document}";
    assert_eq!(numbers(report), "A.1");
}

#[test]
fn a_row_may_count_on_by_a_command_of_the_authors() {
    let source = r"\documentclass{article}\newcommand\numberthis{\addtocounter{equation}{1}\tag{\theequation}}
\newcommand{\eqn}{\refstepcounter{equation}\tag{\theequation}}\begin{document}
\begin{align*} a &= b \\ b &= c \numberthis \label{n} \end{align*}
\[ c = d \eqn \] \begin{equation} e = f \end{equation}\end{document}";
    assert_eq!(
        equations(&read(source)),
        ["-: a = b", "1: b = c", "2: c = d", "3: e = f"]
    );
}
