//! Files that are documents of their own, and files that need not be there.

use cradle_verify::derivation::Derivation;

use super::{document_of, equations, problems};

const PART: &str = "\\documentclass[main]{subfiles}\n% \\begin{document}\n% check: symbols p: mass\n\\newcommand{\\x}{y}\n\
                    \\begin{document}\n\\chapter{Two}\\newcommand{\\q}{r}\n\\begin{equation} p = 2 \\q \\end{equation}\n\\end{document}\n\\[ lost = 1 \\]\n";

#[test]
fn of_a_document_that_another_takes_in_only_the_body_is_read() {
    for command in ["subfile", "subfileinclude", "input"] {
        let main = format!(
            "\\documentclass{{report}}\\newcommand{{\\x}}{{x}}\n\\begin{{document}}\n\\chapter{{One}}\n\\begin{{equation}} a = 2 b \\end{{equation}}\n\
             \\{command}{{part}}\n\\chapter{{Three}}\n\\begin{{equation}} \\x = \\q \\end{{equation}}\n\\end{{document}}\n\\[ lost = 1 \\]\n"
        );
        let documents = document_of(&[("main.tex", &main), ("part.tex", PART)]);
        let derivation = Derivation::new(documents);
        let read = equations(&derivation);
        assert_eq!(read[..2], ["1.1: a = 2 b", "2.1: p = 2 r"], "{command}");
        // What the part defines ends with it.
        assert!(read[2].starts_with("3.1: unreadable: `\\q`"), "{read:?}");
        assert_eq!(read.len(), 3);
        assert_eq!(problems(&derivation), Vec::<String>::new());
        let declares = |page: &cradle_verify::derivation::Page| !page.dimensions.is_empty();
        assert!(derivation.pages.iter().any(declares), "{command}");
    }
}

#[test]
fn a_document_in_a_document_in_a_document_ends_where_it_ends() {
    let documents = document_of(&[
        (
            "main.tex",
            "\\begin{document}\\subfile{a}\\[ d = 1 \\]\\end{document}",
        ),
        (
            "a.tex",
            "\\begin{document}\\[ a = 1 \\]\\subfile{b}\\[ c = 1 \\]\\end{document}",
        ),
        ("b.tex", "\\begin{document}\\[ b = 1 \\]"),
    ]);
    assert_eq!(
        equations(&Derivation::new(documents)),
        ["-: a = 1", "-: b = 1", "-: c = 1", "-: d = 1"]
    );
}

#[test]
fn a_file_that_need_not_be_there_is_read_if_it_is() {
    let derivation = Derivation::new(document_of(&[
        (
            "main.tex",
            "\\begin{equation} a = 1 \\end{equation}\n\\InputIfFileExists{there}{\\[ f = 1 \\]}{\\[ n = 1 \\]}\n\
             \\InputIfFileExists{gone}{\\[ n = 1 \\]}{\\[ o = 1 \\]}\n\\IfFileExists{there.tex}{\\[ y = 1 \\]}{\\[ n = 1 \\]}\n\
             \\begin{equation} c = 1 \\end{equation}\n",
        ),
        ("there.tex", "\\begin{equation} b = 1 \\end{equation}\n"),
    ]));
    let read = equations(&derivation);
    let tags = ["1:", "-: f", "2: b", "-: o", "-: y", "3: c"];
    assert_eq!(read.len(), tags.len(), "{read:?}");
    for (read, tag) in read.iter().zip(tags) {
        assert!(read.starts_with(tag), "{read} is not {tag}");
    }
    assert_eq!(problems(&derivation), Vec::<String>::new());
    let short = document_of(&[("main.tex", "\\InputIfFileExists{there}")]);
    assert_eq!(problems(&Derivation::new(short)).len(), 1);
}
