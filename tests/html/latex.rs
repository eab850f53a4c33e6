//! LaTeX documents on the page: their prose is set, and nothing in it does harm.

use cradle_verify::derivation::Derivation;
use cradle_verify::document::Document;

use super::{has_class, page, text_of, tree};

fn page_of_latex(source: &str) -> String {
    page(&Derivation::new(Document::latex("a.tex", source, &())))
}

fn article(body: &str) -> String {
    let page = page_of_latex(&format!(
        "\\documentclass{{article}}\n\\begin{{document}}\n{body}\n\\end{{document}}\n"
    ));
    tree(&page);
    let start = page.find("<article").expect("an article");
    let end = page.find("</article>").expect("its end");
    page[start..end].to_owned()
}

#[test]
fn prose_is_set_as_it_looks_in_print() {
    for (source, shown) in [
        (
            r"\textbf{bold} and \emph{with $x$}",
            "<p><strong>bold</strong> and <em>with <math><mi>x</mi></math></em></p>",
        ),
        (
            r"{\bf old} \textsc{Small} \foo[opt]{unknown}",
            "<p><strong>old</strong> Small unknown</p>",
        ),
        (
            r"50\% --- ``q'' -- `r' A~B",
            "<p>50% — “q” – ‘r’ A\u{a0}B</p>",
        ),
        (
            r"see \cite[p.~3]{k,l}.\footnote{A note.} \LaTeX{} Caf\'e",
            "<p>see [k, l, p.\u{a0}3]. (A note.) LaTeX Cafe\u{301}</p>",
        ),
        (
            "One.\n\nTwo \\\\ three <b>",
            "<p>One.</p>\n<p>Two <br/>\n three &lt;b&gt;</p>",
        ),
        (
            r"\begin{itemize} \item One \item[x] Two \end{itemize}",
            "<ul>\n<li><p>One</p>\n</li>\n<li><p><strong>x</strong> Two</p>\n</li>\n</ul>",
        ),
        (
            r"\section{The \emph{square} $x^2$}",
            "The <em>square</em> <math><msup><mi>x</mi><mn>2</mn></msup></math></h",
        ),
    ] {
        let set = article(&format!("\\[ a = b \\]\n\n{source}\n\n\\[ c = d \\]"));
        assert!(set.contains(shown), "{source}: {set}");
    }
}

#[test]
fn equations_are_cited_by_links() {
    let set = article(
        "\\begin{equation} a = b \\label{e} \\end{equation}\nFrom \\eqref{e}, \\ref{e} and Section~\\ref{s}\n\
         \\begin{itemize}\\item then\n\\begin{equation} a^2 = b^2 \\end{equation}\n\\end{itemize}",
    );
    assert!(
        set.contains("From <a href=\"#eq-1\">(1)</a>, <a href=\"#eq-1\">1</a> and Section\u{a0}s"),
        "{set}"
    );
    assert_eq!(set.matches("class=\"equation\"").count(), 2);
    assert!(!set.contains('\\'), "{set}");
}

#[test]
fn unpaired_braces_and_deep_groups_leave_the_page_whole() {
    for piece in [
        "{",
        "}",
        "\\emph{",
        "\\begin{itemize}\\item ",
        "\\end{itemize}",
        "\\footnote{",
        "\\cite{",
        "\\'",
        "\\item ",
    ] {
        let page = page_of_latex(&format!(
            "\\begin{{document}}{}\n\\begin{{equation}} a = b \\end{{equation}}\n\\end{{document}}",
            piece.repeat(500)
        ));
        let tree = tree(&page);
        assert!(
            tree.descendants().any(|n| has_class(&n, "equation")),
            "{piece}"
        );
        assert!(text_of(tree.root()).contains("a=b"), "{piece}");
    }
}
