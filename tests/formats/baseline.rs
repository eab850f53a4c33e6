//! Baselines: what is known passes, what is new does not, and what moved is the same.

use std::path::Path;

use super::{code, err, folder, json, out, root, run, run_in, well};

const COMPARE: [&str; 4] = ["check", "well.md", "--baseline", "known.json"];

fn recorded(test: &str) -> (std::path::PathBuf, String) {
    let (folder, text) = well(test);
    let output = run_in(&folder, &[&COMPARE[..], &["--update-baseline"]].concat());
    assert_eq!(code(&output), 0, "{}", err(&output));
    assert_eq!(err(&output), "wrote known.json: 6 statements, 1 finding\n");
    (folder, text)
}

fn compare(folder: &Path, page: &str, more: &[&str]) -> (i32, String) {
    std::fs::write(folder.join("well.md"), page).unwrap();
    let output = run_in(folder, &[&COMPARE[..], more].concat());
    let text = out(&output);
    let told = text
        .split_once("\nBaseline\n\n")
        .map_or("", |(_, told)| told);
    (code(&output), told.to_owned())
}

#[test]
fn the_file_is_read_by_people() {
    let (folder, _) = recorded("file");
    let text = std::fs::read_to_string(folder.join("known.json")).unwrap();
    insta::assert_snapshot!("baseline", text);
    let left: Vec<_> = std::fs::read_dir(&folder).unwrap().collect();
    assert_eq!(
        left.len(),
        2,
        "something is left beside the page and the baseline"
    );
}

#[test]
fn known_findings_pass_wherever_they_stand() {
    let (folder, text) = recorded("known");
    for page in [
        text.clone(),
        format!("One.\n\n\nTwo.\n\n{text}\nThe end.\n"),
    ] {
        for more in [&[][..], &["--strict-baseline"]] {
            let (code, told) = compare(&folder, &page, more);
            assert_eq!(
                (code, told.as_str()),
                (0, "1 known finding; nothing else has changed.\n")
            );
        }
    }
    let output = run_in(&folder, &[&COMPARE[..], &["--format", "short"]].concat());
    assert_eq!(
        (code(&output), out(&output), err(&output)),
        (0, String::new(), String::new())
    );
}

#[test]
fn a_new_finding_fails_and_is_the_only_one_shown() {
    let (folder, text) = recorded("new");
    let slip = text.replace(r"\frac{v^2}{2 g}", r"\frac{v^2}{5 g}");
    let (number, told) = compare(&folder, &slip, &[]);
    assert_eq!(number, 1);
    assert_eq!(
        told,
        "  new      (4)  fails  well.md\n1 known finding; 1 difference.\n"
    );
    let output = run_in(&folder, &[&COMPARE[..], &["--format", "short"]].concat());
    assert_eq!(out(&output).lines().count(), 1, "{}", out(&output));
    assert!(out(&output).contains("(4)"));
    assert!(err(&output).contains("new      (4)"), "{}", err(&output));
    let human = out(&run_in(&folder, &COMPARE));
    assert!(
        human.contains("error[fails]: equation (4)")
            && !human.contains("error[fails]: equation (6)")
    );
    for (level, expected) in [("error", 1), ("never", 0)] {
        assert_eq!(compare(&folder, &slip, &["--fail-on", level]).0, expected);
    }
}

#[test]
fn a_finding_that_is_gone_fails_only_where_that_is_asked_for() {
    let (folder, text) = recorded("gone");
    let mended = text.replace(r"\frac{v}{3}", r"\frac{v}{2}");
    let (number, told) = compare(&folder, &mended, &[]);
    assert_eq!(number, 0);
    assert_eq!(
        told,
        "  gone     (6)  fails  well.md\n0 known findings; 1 difference.\n"
    );
    let (number, told) = compare(&folder, &mended, &["--strict-baseline"]);
    assert_eq!(number, 1);
    assert_eq!(
        told,
        "  gone     (6)  fails  well.md\n  edited   (6)  well.md\n0 known findings; 2 differences.\n"
    );
}

#[test]
fn what_was_proved_and_is_not_any_more_fails() {
    let (folder, text) = recorded("lost");
    let file = folder.join("known.json");
    let baseline = std::fs::read_to_string(&file).unwrap();
    let page =
        format!("{text}\n<!-- check: derived -->\n$$ |x + y| \\leq |x| + |y| \\tag{{7}} $$\n");
    std::fs::write(folder.join("well.md"), &page).unwrap();
    run_in(&folder, &[&COMPARE[..], &["--update-baseline"]].concat());
    let with = std::fs::read_to_string(&file).unwrap();
    assert_ne!(with, baseline);
    // As if an earlier version had proved it.
    let proved = with.replace(
        r#""verdict":"undecided","codes":["undecided"]"#,
        r#""verdict":"holds","codes":[]"#,
    );
    assert_ne!(proved, with);
    std::fs::write(&file, proved).unwrap();
    let (number, told) = compare(&folder, &page, &[]);
    assert_eq!(number, 1);
    assert_eq!(
        told,
        "  changed  (7)  holds → undecided  well.md\n  new      (7)  undecided  well.md\n1 known finding; 2 differences.\n"
    );
    assert_eq!(compare(&folder, &page, &["--fail-on", "never"]).0, 0);
}

#[test]
fn a_statement_more_or_less_counts_only_strictly() {
    let (folder, text) = recorded("statements");
    let more = format!("{text}\nBy (1):\n\n$$ v - g t = 0 \\tag{{7}} $$\n");
    assert_eq!(compare(&folder, &more, &[]).0, 0);
    let (number, told) = compare(&folder, &more, &["--strict-baseline"]);
    assert_eq!(number, 1);
    assert!(told.starts_with("  added    (7)  well.md\n"), "{told}");
    let fewer = text.split("and the fall lasts").next().unwrap();
    assert_eq!(compare(&folder, fewer, &[]).0, 0);
    let (number, told) = compare(&folder, fewer, &["--strict-baseline"]);
    assert_eq!(number, 1);
    assert!(
        told.contains("removed  (5)") && told.contains("gone     (6)"),
        "{told}"
    );
}

#[test]
fn programs_are_told_as_well() {
    let (folder, text) = recorded("json");
    std::fs::write(
        folder.join("well.md"),
        text.replace(r"\frac{v}{3}", r"\frac{v}{2}"),
    )
    .unwrap();
    let value = json(&run_in(
        &folder,
        &[&COMPARE[..], &["--format", "json"]].concat(),
    ));
    assert_eq!(value["baseline"]["known"], 0);
    let changes: Vec<&str> = value["baseline"]["differences"]
        .as_array()
        .unwrap()
        .iter()
        .map(|d| d["change"].as_str().unwrap())
        .collect();
    assert_eq!(changes, ["gone", "edited"]);
    let junit = {
        std::fs::write(folder.join("well.md"), &text).unwrap();
        out(&run_in(
            &folder,
            &[&COMPARE[..], &["--format", "junit"]].concat(),
        ))
    };
    assert!(
        junit.contains("<skipped message=\"known: ") && !junit.contains("<failure"),
        "{junit}"
    );
}

#[test]
fn the_same_finding_twice_is_not_known_by_the_first() {
    let folder = folder("twice");
    let one = "<!-- check: derived -->\n$$ 1 = 2 $$\n";
    let write = |text: &str| std::fs::write(folder.join("well.md"), text).unwrap();
    write(one);
    run_in(&folder, &[&COMPARE[..], &["--update-baseline"]].concat());
    assert_eq!(code(&run_in(&folder, &COMPARE)), 0);
    write(&format!("{one}\n{one}"));
    assert_eq!(code(&run_in(&folder, &COMPARE)), 1);
}

/// A LaTeX document, where numbers are counted: a slip with a label, one without, and two other findings.
const COUNTED: &str = r"\documentclass{article}
\begin{document}
% check: law
\begin{equation}\label{a} p = m v \end{equation}
Hence
\begin{equation}\label{b} p = 2 m v \end{equation}
and
\begin{equation} p = 3 m v. \end{equation}
In the end, as \eqref{nowhere} says,
\begin{equation} v = p/m \end{equation}
\end{document}
";

/// Puts an equation in front of all others.
fn with_one_in_front(text: &str, equation: &str) -> String {
    let begin = "\\begin{document}\n";
    text.replace(begin, &format!("{begin}{equation}"))
}

/// Records a document and compares another with that, strictly or not.
fn afterwards(test: &str, before: &str, after: &str, more: &[&str]) -> (i32, String) {
    let folder = folder(test);
    let check = ["check", "notes.tex", "--baseline", "known.json"];
    std::fs::write(folder.join("notes.tex"), before).unwrap();
    run_in(&folder, &[&check[..], &["--update-baseline"]].concat());
    std::fs::write(folder.join("notes.tex"), after).unwrap();
    let output = run_in(&folder, &[&check[..], more].concat());
    let text = out(&output);
    let told = text.split_once("\nBaseline\n\n");
    (code(&output), told.map_or("", |(_, told)| told).to_owned())
}

#[test]
fn counted_numbers_shift_and_findings_stay_known() {
    let given = "% check: law\n\\begin{equation} E = m c^2 \\end{equation}\n";
    let after = with_one_in_front(COUNTED, given);
    let (code, told) = afterwards("shifted", COUNTED, &after, &[]);
    assert_eq!(
        (code, told.as_str()),
        (0, "4 known findings; nothing else has changed.\n")
    );
    let (code, told) = afterwards("shifted", COUNTED, &after, &["--strict-baseline"]);
    assert_eq!(
        (code, told.as_str()),
        (
            1,
            "  added    (1)  notes.tex\n4 known findings; 1 difference.\n"
        )
    );
}

#[test]
fn a_slip_put_in_front_is_the_one_that_is_new() {
    let slip = "% check: derived\n\\begin{equation} 1 = 2 \\end{equation}\n";
    let told = afterwards("slip", COUNTED, &with_one_in_front(COUNTED, slip), &[]);
    let expected = "  new      (1)  fails  notes.tex\n4 known findings; 1 difference.\n";
    assert_eq!(told, (1, expected.to_owned()));
    // Where the one that had its number is mended besides, it does not pass for that one.
    let one = "\\documentclass{article}\n\\begin{document}\n% check: derived\n\\begin{equation} 2 = 3 \\end{equation}\n\n% check: derived\n\\begin{equation} 3 = 4 \\end{equation}\n\\end{document}\n";
    let mended = with_one_in_front(&one.replace("2 = 3", "3 = 3"), slip);
    let told = afterwards("slip", one, &mended, &[]);
    let expected = "  gone     (1)  fails  notes.tex\n  new      (1)  fails  notes.tex\n1 known finding; 2 differences.\n";
    assert_eq!(told, (1, expected.to_owned()));
}

#[test]
fn a_statement_is_known_by_its_label_and_by_its_number_where_its_text_changes() {
    let edited = COUNTED.replace("2 m v", "4 m v").replace("3 m v", "5 m v");
    let (code, told) = afterwards("edited", COUNTED, &edited, &[]);
    assert_eq!(
        (code, told.as_str()),
        (0, "4 known findings; nothing else has changed.\n")
    );
    let (code, told) = afterwards("edited", COUNTED, &edited, &["--strict-baseline"]);
    let expected =
        "  edited   (2)  notes.tex\n  edited   (3)  notes.tex\n4 known findings; 2 differences.\n";
    assert_eq!((code, told.as_str()), (1, expected));
    // With another in front, its number alone says nothing of the one without a label.
    let given = "% check: law\n\\begin{equation} E = m c^2 \\end{equation}\n";
    let told = afterwards("edited", COUNTED, &with_one_in_front(&edited, given), &[]);
    let expected = "  gone     (3)  fails  notes.tex\n  new      (4)  fails  notes.tex\n3 known findings; 2 differences.\n";
    assert_eq!(told, (1, expected.to_owned()));
}

#[test]
fn what_is_said_twice_is_told_apart_by_what_was_found() {
    let page = |first: &str| {
        let open = "\\documentclass{article}\n\\begin{document}\n";
        let case = "\\section{A}\nLet $x = 1$. Then\n\\begin{equation} x^2 = x \\end{equation}\n";
        let always = "\\section{B}\n% check: derived; from nothing\n\\begin{equation} x^2 = x \\end{equation}\n";
        format!("{open}{first}{case}{always}\\end{{document}}\n")
    };
    let given = "% check: law\n\\begin{equation} E = m c^2 \\end{equation}\n";
    let (code, told) = afterwards("said-twice", &page(""), &page(given), &[]);
    assert_eq!(
        (code, told.as_str()),
        (0, "1 known finding; nothing else has changed.\n")
    );
}

#[test]
fn numbers_that_are_typed_may_be_typed_anew() {
    let (folder, text) = recorded("renumbered");
    let renumbered = (1..=6).rev().fold(text, |text, number| {
        text.replace(&format!("({number})"), &format!("({})", number + 10))
            .replace(
                &format!("\\tag{{{number}}}"),
                &format!("\\tag{{{}}}", number + 10),
            )
    });
    assert!(renumbered.contains("\\tag{16}"));
    let (code, told) = compare(&folder, &renumbered, &["--strict-baseline"]);
    assert_eq!(
        (code, told.as_str()),
        (0, "1 known finding; nothing else has changed.\n")
    );
}

#[test]
fn a_baseline_of_the_first_version_is_read() {
    let (folder, text) = recorded("first-version");
    let file = folder.join("known.json");
    let now = std::fs::read_to_string(&file).unwrap();
    // There the number of a statement was part of its fingerprint, whatever that is.
    let mut before = now.replace("\"version\": 2", "\"version\": 1");
    while let Some(at) = before.find("\"fingerprint\":\"") {
        let value = at + "\"fingerprint\":\"".len();
        before.replace_range(at..value + 16, "\"fingerprint\" :\"0123456789abcdef");
    }
    std::fs::write(&file, before).unwrap();
    let (code, told) = compare(&folder, &text, &["--strict-baseline"]);
    assert_eq!(
        (code, told.as_str()),
        (0, "1 known finding; nothing else has changed.\n")
    );
}

#[test]
fn what_is_no_baseline_is_refused() {
    let (folder, _) = well("no-baseline");
    let output = run_in(&folder, &COMPARE);
    assert_eq!(code(&output), 2);
    assert!(
        err(&output).contains("--update-baseline"),
        "{}",
        err(&output)
    );
    for (text, said) in [
        ("", "is no JSON"),
        ("[", "line 1 column 1"),
        ("{}", "has no `version`"),
        ("{\"version\": 3, \"statements\": []}", "version 3, not 2"),
        ("{\"version\": 1, \"statements\": [{}]}", "is no baseline"),
        (
            "{\"version\": 1, \"statements\": [], \"x\": 1}",
            "unknown field `x`",
        ),
    ] {
        std::fs::write(folder.join("known.json"), text).unwrap();
        let output = run_in(&folder, &COMPARE);
        assert_eq!(code(&output), 2, "{text}");
        assert!(err(&output).contains(said), "{text}: {}", err(&output));
        assert!(out(&output).is_empty());
    }
    for args in [
        &["check", "well.md", "--update-baseline"][..],
        &["check", "well.md", "--strict-baseline"],
    ] {
        assert_eq!(code(&run_in(&folder, args)), 2, "{args:?}");
    }
}

#[test]
fn the_report_has_the_verdicts_that_are_recorded() {
    let path = "proofs/report.baseline.json";
    let output = run(&["--baseline", path, "--strict-baseline"]);
    let text = out(&output);
    let told = text.split_once("\nBaseline\n").map_or("", |(_, told)| told);
    assert_eq!(
        code(&output),
        0,
        "{}{told}\nIf that is right: cradle-verify --baseline {path} --update-baseline",
        err(&output)
    );
    // What is recorded is what would be written: nothing in it is out of date.
    let copy = folder("report").join("now.json");
    run(&["--baseline", copy.to_str().unwrap(), "--update-baseline"]);
    let (now, recorded) = (
        std::fs::read(copy).unwrap(),
        std::fs::read(root().join(path)).unwrap(),
    );
    assert!(
        now == recorded,
        "run: cradle-verify --baseline {path} --update-baseline"
    );
}
