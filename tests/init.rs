//! `init`: what it prints can be pasted as it is, and then every verdict is what it was.

use std::path::{Path, PathBuf};

use crate::common::{pages, root, run};
use cradle_verify::audit::Audit;
use cradle_verify::derivation::Derivation;
use cradle_verify::dimension;
use cradle_verify::report::{Report, configuration, declarations};

fn documents(folder: &str) -> Vec<PathBuf> {
    let entries = std::fs::read_dir(root().join(folder)).unwrap();
    let mut found: Vec<PathBuf> = entries.map(|entry| entry.unwrap().path()).collect();
    found.retain(|path| path.extension().is_some_and(|e| e == "md" || e == "tex"));
    found.sort();
    assert!(!found.is_empty(), "{folder} is empty");
    found
}

fn read(path: &Path, source: &str) -> Derivation {
    let name = path.display().to_string();
    match path.extension().unwrap().to_str() {
        Some("tex") => Derivation::from_latex(&name, source),
        _ => Derivation::from_markdown(&name, source),
    }
}

/// What an audit says: a verdict and the codes of the notes for each statement, and how much could not be read.
fn said(derivation: &Derivation, audit: &Audit) -> (Vec<String>, usize) {
    let entries = audit.entries.iter().map(|entry| {
        let codes: Vec<&str> = entry.notes.iter().map(|note| note.code()).collect();
        let equation = derivation.equations[entry.equation].reference();
        format!("{equation} {} {}", entry.verdict.word(), codes.join(" "))
    });
    let report = Report {
        derivation,
        audit,
        paths: &[],
    };
    (entries.collect(), report.unread())
}

fn round_trip(path: &Path, source: &str) {
    let before = read(path, source);
    changes_nothing(path, source, &before, &Audit::of(&before));
}

fn changes_nothing(path: &Path, source: &str, before: &Derivation, audit: &Audit) {
    let pasted = declarations(before);
    let after = read(path, &format!("{pasted}\n{source}"));
    let own = said(&after, &Audit::of(&after));
    assert_eq!(own, said(before, audit), "{}\n{pasted}", path.display());
    // Nothing is asked for twice.
    let again = declarations(&after);
    assert!(!again.contains("\nsymbols"), "{}\n{again}", path.display());
    assert!(!again.contains("check:"), "{}\n{again}", path.display());
}

#[test]
fn what_is_printed_changes_no_verdict_of_an_example() {
    for path in documents("docs/examples") {
        round_trip(&path, &std::fs::read_to_string(&path).unwrap());
    }
}

#[test]
fn nor_where_the_examples_declare_less() {
    for path in documents("docs/examples") {
        let source = std::fs::read_to_string(&path).unwrap();
        for word in ["velocity", "mass", "length", "time", "energy", "positive"] {
            let fewer = source.lines().filter(|line| {
                let line = line.trim_start_matches(['%', ' ']);
                !(line.starts_with("symbols") && line.contains(word))
            });
            let fewer: Vec<&str> = fewer.collect();
            round_trip(&path, &fewer.join("\n"));
        }
    }
}

#[test]
fn nor_of_any_page_of_the_tests() {
    for page in pages() {
        let path = Path::new(&page.path);
        changes_nothing(path, &page.source, &page.derivation, &page.audit);
    }
}

#[test]
fn nor_of_texts_with_bare_laws_and_counts() {
    for body in [
        "The drag scales as\n\n$$ F \\sim v^2 A $$\n\nThe radiated power is approximately [3]\n\n$$ P \\sim A^2 a^2 $$\n",
        "# A\n\nFriction is proportional to the normal force:\n\n$$ F = \\mu N $$\n\nThe work is\n\n$$ W = F s $$\n\nHence\n\n$$ W = \\mu N s $$\n",
        "The sum is\n\n$$ S = \\sum_{i=1}^{k} u_i $$\n\nBelow\n\n$$ E_{n+1} = q E_n $$\n\nso\n\n$$ E_{n+2} = q^2 E_n $$\n",
    ] {
        round_trip(Path::new("page.md"), body);
        // Nor does a declaration of anything else.
        let declared = format!("<!-- check: symbols e: dimensionless, positive -->\n\n{body}");
        let own = |source: &str| {
            let derivation = read(Path::new("page.md"), source);
            said(&derivation, &Audit::of(&derivation))
        };
        assert_eq!(own(&declared), own(body), "{body}");
    }
}

#[test]
fn what_is_declared_alike_stands_in_one_line_and_counts_are_natural() {
    let page = "The sum is\n\n$$ S = \\sum_{i=1}^{k} u_i $$\n\n$$ a = b + c $$\n";
    let text = declarations(&Derivation::from_markdown("page.md", page));
    let (_, clauses) = text.split_once("check:\n").unwrap();
    assert_eq!(
        clauses, "symbols k: dimensionless, natural\nsymbols S, u_i, a, b, c: real\n-->\n",
        "{text}"
    );
}

#[test]
fn a_configuration_is_added_to_and_nothing_in_it_is_lost() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("init-update");
    let _ = std::fs::remove_dir_all(&folder);
    std::fs::create_dir_all(&folder).unwrap();
    let page = folder.join("page.md");
    let config = folder.join("cradle.toml");
    let [page_path, config_path] = [&page, &config].map(|path| path.to_str().unwrap().to_owned());
    let init = |more: &[&str]| {
        let args = ["init", &page_path, "--toml", "-o", &config_path];
        let done = run(&[&args[..], more].concat());
        let said = String::from_utf8(done.stderr).unwrap();
        (
            done.status.code(),
            said,
            std::fs::read_to_string(&config).unwrap(),
        )
    };
    std::fs::write(&page, "$$ v = a t $$\n").unwrap();
    assert_eq!(init(&["--update"]).0, Some(0));
    let written = "# Mine.\n[symbols]\nv = 'velocity' # the author's own\n\"a, t\" = \"positive\"\n\n# Also mine.\n[severity]\nuncited = \"off\"\n";
    std::fs::write(&config, written).unwrap();
    let (code, said, text) = init(&[]);
    assert_eq!((code, &text[..]), (Some(2), written));
    assert!(said.contains("--update"), "{said}");
    let (code, said, text) = init(&["--update"]);
    assert_eq!((code, &text[..]), (Some(0), written), "{said}");
    std::fs::write(&page, "$$ v = a t $$\n\n$$ w = \\mu u $$\n").unwrap();
    let (code, said, text) = init(&["--update"]);
    assert_eq!(code, Some(0), "{said}");
    assert!(said.contains("added 3 symbols"), "{said}");
    let added: Vec<&str> = text
        .lines()
        .filter(|line| !written.lines().any(|own| own == *line))
        .collect();
    let names: Vec<&str> = added
        .iter()
        .map(|line| line.split(' ').next().unwrap())
        .collect();
    assert_eq!(names, ["w", "'\\mu'", "u"], "{text}");
    for line in written.lines() {
        assert!(text.lines().any(|own| own == line), "{line}: {text}");
    }
    assert_eq!(init(&["--update"]).2, text);
    // A file that is no configuration is left alone.
    std::fs::write(&config, "words\n").unwrap();
    let (code, _, text) = init(&["--update"]);
    assert_eq!((code, &text[..]), (Some(2), "words\n"));
}

#[test]
fn what_is_left_open_is_named_with_what_settles_it() {
    let source = "<!-- check: symbols g: acceleration -->\n\nA tram:\n\n$$ v = u + a t \\tag{1} $$\n\n\
                  $$ h = \\frac{u^2}{2 g} \\tag{2} $$\n";
    let text = declarations(&Derivation::from_markdown("tram.md", source));
    insta::assert_snapshot!(text);
    let tex = "% check: symbols v: velocity\n\\documentclass{article}\\begin{document}\n\
               \\begin{equation} v = a t \\end{equation}\n\\begin{equation} w = 2 v \\end{equation}\\end{document}\n";
    insta::assert_snapshot!(declarations(&Derivation::from_latex("tram.tex", tex)));
}

#[test]
fn a_page_that_another_one_speaks_for_is_left_alone() {
    let pages = [
        (
            "a.md",
            "<!-- check: symbols m: mass, positive -->\n\n<!-- check: law -->\n$$ p = m v \\tag{1} $$\n",
        ),
        ("b.md", "By (1)\n\n$$ v = \\frac{p}{m} \\tag{2} $$\n"),
    ];
    let documents =
        pages.map(|(path, source)| cradle_verify::document::Document::markdown(path, source));
    let text = declarations(&Derivation::new(documents.to_vec()));
    let (_, second) = text.split_once("Symbols of b.md").unwrap();
    assert!(second.contains("not declared here, but in a.md"), "{text}");
    assert!(!second.contains("symbols m"), "{text}");
}

#[test]
fn every_dimension_with_a_name_is_proposed_by_one_that_can_be_declared() {
    for name in dimension::names() {
        let own = dimension::named(name).unwrap();
        let proposed = dimension::declared_name(&own).unwrap();
        assert_eq!(dimension::named(&proposed), Some(own), "{name}: {proposed}");
    }
}

#[test]
fn the_program_prints_it_and_refuses_as_elsewhere() {
    let done = run(&["init", "docs/examples/well.md"]);
    assert_eq!(done.status.code(), Some(0));
    let source = std::fs::read_to_string(root().join("docs/examples/well.md")).unwrap();
    let text = declarations(&Derivation::from_markdown("docs/examples/well.md", &source));
    assert_eq!(String::from_utf8(done.stdout).unwrap(), text);
    for args in [
        &["init", "missing.md"][..],
        &["init", "docs/examples/well.md", "--format", "json"],
        &["init", "docs/examples/well.md", "--builtin", "report"],
    ] {
        let done = run(args);
        assert_eq!(done.status.code(), Some(2), "{args:?}");
        assert!(
            done.stdout.is_empty() && !done.stderr.is_empty(),
            "{args:?}"
        );
    }
    let file = Path::new(env!("CARGO_TARGET_TMPDIR")).join("declarations.md");
    let done = run(&[
        "init",
        "docs/examples/well.md",
        "-o",
        file.to_str().unwrap(),
    ]);
    assert_eq!(done.status.code(), Some(0));
    assert_eq!(std::fs::read_to_string(file).unwrap(), text);
}

#[test]
fn what_follows_from_others_is_not_asked_for() {
    let settling = |equations: &[&str]| {
        let page: String = equations.iter().map(|e| format!("$$ {e} $$\n\n")).collect();
        let text = declarations(&Derivation::from_markdown("page.md", &page));
        let is_said = |line: &&str| line.starts_with("The dimension") || line.starts_with("Open");
        text.lines().find(is_said).unwrap_or_default().to_owned()
    };
    assert_eq!(
        settling(&["v = a t", "q = m^3"]),
        "The dimensions of `v`, `a` and `q` settle those of `t` and `m`."
    );
    assert_eq!(
        settling(&["a > 0", "t > 0", "m^3 > 0"]),
        "Open: the dimensions of `a`, `t` and `m`."
    );
    assert_eq!(settling(&[]), "");
}

#[test]
fn keys_and_texts_of_a_table_are_as_plain_as_can_be() {
    let page = "<!-- check: symbols E: energy -->\n\n$$ E = m_1 + \\mu + v'_1 + \\dot{x}' $$\n";
    let derivation = Derivation::from_markdown("page.md", page);
    let text = configuration(&derivation, &["a\u{7}.md".to_owned()]);
    for line in [
        r#"files = ["a\u0007.md"]"#,
        r#"m_1 = "energy""#,
        r#"'\mu' = "energy""#,
        r#""v'_1" = "energy""#,
        r#""\\dot{x}'" = "energy""#,
    ] {
        assert!(
            text.lines().any(|own| own.starts_with(line)),
            "{line}: {text}"
        );
    }
}
