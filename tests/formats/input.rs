//! Standard input, files that are written, what is generated from the arguments, and the watch.

use std::io::{BufRead, BufReader};
use std::path::Path;
use std::process::Stdio;
use std::sync::atomic::AtomicUsize;
use std::time::{Duration, Instant};

use clap::Parser as _;
use cradle_verify::audit::Audit;
use cradle_verify::cli::args::Args;
use cradle_verify::cli::output::{Content, deliver};
use cradle_verify::proofs;
use cradle_verify::report::Report;

use super::{code, command, err, folder, json, out, piped, run, run_in, well};

const FALSE: &str = "<!-- check: derived -->\n$$ 1 + 1 = 3 \\tag{1} $$";

#[test]
fn standard_input_has_the_name_that_it_is_given() {
    let plain = piped(&["check", "-", "--format", "short"], FALSE);
    assert!(
        out(&plain).starts_with("standard input:2:"),
        "{}",
        out(&plain)
    );
    let args = ["check", "-", "--stdin-filename", "a/b.md", "--format"];
    let named = piped(&[&args[..], &["short"]].concat(), FALSE);
    assert_eq!(code(&named), 1);
    assert!(out(&named).starts_with("a/b.md:2:"), "{}", out(&named));
    let sarif = json(&piped(&[&args[..], &["sarif"]].concat(), FALSE));
    let place = &sarif["runs"][0]["results"][0]["locations"][0]["physicalLocation"];
    assert_eq!(place["artifactLocation"]["uri"], "a/b.md");
    let explained = piped(&["explain", "1", "-", "--stdin-filename", "a/b.md"], FALSE);
    assert!(out(&explained).contains("a/b.md:2:"), "{}", out(&explained));
    let useless = run(&["check", "docs", "--stdin-filename", "x"]);
    assert_eq!(code(&useless), 2);
    assert!(
        err(&useless).contains("which is not read"),
        "{}",
        err(&useless)
    );
}

#[test]
fn a_finding_in_a_long_line_is_shown_where_it_is() {
    let shown = |words: &str| {
        let text = FALSE.replace("$$ 1", &format!("{words}$$ 1")) + words;
        out(&piped(&["check", "-"], &text))
    };
    let column = |shown: &str| -> usize {
        let (_, place) = shown.split_once("--> standard input:2:").unwrap();
        place.lines().next().unwrap().parse().unwrap()
    };
    let near = column(&shown(""));
    let far = shown(&"wörd ".repeat(1_000));
    assert_eq!(column(&far), near + 5_000, "{far}");
    let excerpt = far.lines().find(|line| line.contains("$$ 1 + 1 = 3"));
    assert!(excerpt.is_some_and(|line| line.len() < 200), "{far}");
}

#[test]
fn output_goes_to_a_file_as_a_whole() {
    let (folder, _) = well("output");
    let file = folder.join("out.txt");
    std::fs::write(&file, "old and longer than nothing").unwrap();
    for format in ["human", "short", "json", "sarif", "github", "junit"] {
        let args = ["check", "well.md", "--format", format];
        let direct = run_in(&folder, &args);
        let output = run_in(&folder, &[&args[..], &["--output", "out.txt"]].concat());
        assert_eq!(
            (code(&output), out(&output)),
            (1, String::new()),
            "{format}"
        );
        assert_eq!(std::fs::read(&file).unwrap(), direct.stdout, "{format}");
    }
    let names = std::fs::read_dir(&folder).unwrap();
    assert_eq!(names.count(), 2, "a temporary file is left");
    let output = run_in(&folder, &["check", "well.md", "--output", "none/out.txt"]);
    assert_eq!(code(&output), 2);
    assert!(
        err(&output).contains("`none/out.txt` could not be written"),
        "{}",
        err(&output)
    );
    // What cannot be judged leaves the file alone.
    let before = std::fs::read(&file).unwrap();
    assert_eq!(
        code(&run_in(
            &folder,
            &["check", "gone.md", "--output", "out.txt"]
        )),
        2
    );
    assert_eq!(std::fs::read(&file).unwrap(), before);
}

#[test]
fn what_is_read_is_not_written_over() {
    let (folder, text) = well("over");
    std::fs::write(folder.join("cradle.toml"), "files = [\"well.md\"]\n").unwrap();
    std::fs::write(folder.join("part.tex"), "\\[ a = 1 \\]\n").unwrap();
    std::fs::write(folder.join("main.tex"), "\\input{part}\n").unwrap();
    let before = |name: &str| std::fs::read_to_string(folder.join(name)).unwrap();
    for (args, target) in [
        (&["check", "well.md", "-o", "well.md"][..], "well.md"),
        (&["check", ".", "-o", "./well.md"], "well.md"),
        (&["check", "-o", "well.md"], "well.md"),
        (&["check", "-o", "cradle.toml"], "cradle.toml"),
        (&["report", "well.md", "-o", "well.md"], "well.md"),
        (&["graph", "well.md", "-o", "well.md"], "well.md"),
        (&["explain", "6", "well.md", "-o", "well.md"], "well.md"),
        (&["init", "well.md", "-o", "well.md"], "well.md"),
        (&["check", "main.tex", "-o", "part.tex"], "part.tex"),
        (
            &[
                "check",
                "well.md",
                "--baseline",
                "well.md",
                "--update-baseline",
            ],
            "well.md",
        ),
        (
            &[
                "check",
                "main.tex",
                "--baseline",
                "well.md",
                "--update-baseline",
            ],
            "well.md",
        ),
        (&["--baseline", "well.md", "--update-baseline"], "well.md"),
    ] {
        let whole = before(target);
        let output = run_in(&folder, args);
        assert_eq!(
            (code(&output), out(&output)),
            (2, String::new()),
            "{args:?}"
        );
        assert!(err(&output).contains(target), "{args:?}: {}", err(&output));
        assert_eq!(before(target), whole, "{args:?}");
    }
    assert_eq!(before("well.md"), text);
    // Nor is a baseline, by what is said of it.
    let args = ["check", "well.md", "--baseline", "known.json"];
    assert_eq!(
        code(&run_in(
            &folder,
            &[&args[..], &["--update-baseline"]].concat()
        )),
        0
    );
    let whole = before("known.json");
    assert_eq!(
        code(&run_in(
            &folder,
            &[&args[..], &["-o", "known.json"]].concat()
        )),
        2
    );
    assert_eq!(before("known.json"), whole);
    assert_eq!(
        code(&run_in(
            &folder,
            &[&args[..], &["--update-baseline"]].concat()
        )),
        0
    );
}

#[test]
fn latex_on_standard_input_is_known_by_how_it_begins() {
    let paper = "% a paper\n\\documentclass{article}\n\\begin{document}\n\\begin{equation} a = \\foo \\end{equation}\n\\end{document}\n";
    let short = |text: &str| out(&piped(&["check", "-", "--format", "json"], text));
    assert!(short(paper).contains("\"tag\": \"1\""), "{}", short(paper));
    let body = "\\begin{document}\n\\begin{equation} a = 1 \\end{equation}\n\\end{document}\n";
    assert!(short(body).contains("\"tag\": \"1\""), "{}", short(body));
    // A page that shows LaTeX is none, and what has a name is what its name says.
    let page = format!("# How to begin\n\n```tex\n{paper}```\n\n$$ 1 + 1 = 3 \\tag{{9}} $$\n");
    assert!(short(&page).contains("\"tag\": \"9\""), "{}", short(&page));
    let named = piped(
        &["check", "-", "--stdin-filename", "a.md", "--format", "json"],
        paper,
    );
    assert!(!out(&named).contains("\"tag\": \"1\""), "{}", out(&named));
}

#[test]
fn a_file_is_read_once_however_it_is_spelt() {
    let (folder, _) = well("spelt");
    std::fs::create_dir(folder.join("a")).unwrap();
    let whole = folder.display().to_string();
    let once = run_in(&folder, &["check", "well.md", "--format", "short"]);
    for paths in [
        &["well.md", "./well.md"][..],
        &["well.md", "a/../well.md"],
        &["well.md", &whole],
        &["well.md", "."],
    ] {
        let output = run_in(&folder, &[&["check", "--format", "short"], paths].concat());
        assert_eq!(out(&output), out(&once), "{paths:?}");
    }
}

#[cfg(unix)]
#[test]
fn a_link_that_leads_nowhere_is_told() {
    use std::os::unix::fs::symlink;
    let (folder, _) = well("lost");
    let args = ["check", ".", "--format", "short"];
    let before = run_in(&folder, &args);
    // The lock of an editor is no document, nor is a folder around the link.
    symlink("somebody@somewhere.1", folder.join(".#well.md")).unwrap();
    symlink(".", folder.join("around.md")).unwrap();
    assert_eq!(out(&run_in(&folder, &args)), out(&before));
    for (link, target) in [("gone.md", "nowhere"), ("loop.tex", "loop.tex")] {
        symlink(target, folder.join(link)).unwrap();
        let output = run_in(&folder, &args);
        assert_eq!((code(&output), out(&output)), (2, String::new()));
        assert!(err(&output).contains(link), "{}", err(&output));
        std::fs::remove_file(folder.join(link)).unwrap();
    }
}

/// So long a file takes no room on the disk, but its length is read.
#[test]
fn what_is_too_long_is_told_and_keeps_nothing_else_of_a_directory_from_its_audit() {
    let folder = folder("too-long");
    let long = std::fs::File::create(folder.join("long.md")).unwrap();
    long.set_len((256 << 20) + 1).unwrap();
    let alone = run_in(&folder, &["check", "long.md"]);
    assert_eq!(code(&alone), 2);
    assert!(
        err(&alone).contains("`long.md` is longer than 256 MB"),
        "{}",
        err(&alone)
    );
    std::fs::write(folder.join("short.md"), FALSE).unwrap();
    let all = run_in(&folder, &["check", ".", "--format", "short"]);
    assert_eq!(code(&all), 1);
    assert!(
        out(&all).contains("error[unreadable]: `./long.md`"),
        "{}",
        out(&all)
    );
    assert!(out(&all).contains("short.md:2:"), "{}", out(&all));
    std::fs::remove_dir_all(folder).unwrap();
}

#[test]
fn what_is_no_text_keeps_nothing_else_of_a_directory_from_its_audit() {
    let (folder, _) = well("no-text");
    std::fs::write(folder.join("old.tex"), b"Gr\xf6\xdfe \\[ a = b \\]").unwrap();
    std::fs::write(folder.join("old.ipynb"), "{}").unwrap();
    let output = run_in(&folder, &["check", ".", "--format", "short"]);
    let text = out(&output);
    let told = |own: &str| text.lines().any(|line| line.starts_with(own));
    assert_eq!(code(&output), 1);
    assert!(told("well.md:33:27: error[fails]"), "{text}");
    assert!(told("old.tex:1:1: error[unreadable]"), "{text}");
    assert!(told("old.ipynb:1:1: error[unreadable]"), "{text}");
    // Who names it is told that it cannot be done.
    let output = run_in(&folder, &["check", "old.tex", "well.md"]);
    assert_eq!((code(&output), out(&output)), (2, String::new()));
}

#[test]
fn an_unnumbered_equation_is_explained_by_its_place() {
    let folder = super::folder("places");
    let page = "# t\n\n$$ k = 3 $$\n\nHence\n\n$$ 2 k = 7 $$\n\n$$ r = k $$ {#eq-sum}\n";
    std::fs::write(folder.join("un.md"), page).unwrap();
    let found = json(&run_in(&folder, &["check", "un.md", "--format", "sarif"]));
    let text = found["runs"][0]["results"][0]["message"]["text"]
        .as_str()
        .unwrap();
    assert!(
        text.contains("replay: cradle-verify explain un.md:7:4 un.md"),
        "{text}"
    );
    let whole = run_in(&folder, &["explain", "un.md:7:4", "un.md"]);
    assert!(
        out(&whole).contains("2 k = 7") && !out(&whole).contains("r = k"),
        "{}",
        out(&whole)
    );
    for place in [
        "7:4",
        "7:6",
        "./un.md:7:4",
        "un.md:7",
        "line 7",
        "the equation at un.md:7:4",
    ] {
        let output = run_in(&folder, &["explain", place, "un.md"]);
        assert_eq!(out(&output), out(&whole), "{place}: {}", err(&output));
    }
    for place in [
        "un.md:8:1",
        "other.md:7:4",
        "line 8",
        "7:60",
        ":",
        "un.md:x:y",
    ] {
        let output = run_in(&folder, &["explain", place, "un.md"]);
        assert_eq!((code(&output), out(&output)), (2, String::new()), "{place}");
    }
    // A key names one equation.
    let keyed = out(&run_in(&folder, &["explain", "eq-sum", "un.md"]));
    assert!(
        keyed.contains("r = k") && !keyed.contains("2 k = 7"),
        "{keyed}"
    );
}

#[cfg(unix)]
#[test]
fn a_link_and_the_rights_of_a_file_stay() {
    use std::os::unix::fs::{PermissionsExt, symlink};
    let (folder, _) = well("link");
    let (file, link) = (folder.join("real.txt"), folder.join("link.txt"));
    std::fs::write(&file, "").unwrap();
    std::fs::set_permissions(&file, std::fs::Permissions::from_mode(0o600)).unwrap();
    symlink("real.txt", &link).unwrap();
    run_in(&folder, &["check", "well.md", "--output", "link.txt"]);
    assert!(std::fs::symlink_metadata(&link).unwrap().is_symlink());
    assert!(
        std::fs::read_to_string(&file)
            .unwrap()
            .contains("A stone down a well")
    );
    assert_eq!(
        std::fs::metadata(&file).unwrap().permissions().mode() & 0o777,
        0o600
    );
    let through = run_in(
        &folder,
        &[
            "check",
            "well.md",
            "--format",
            "short",
            "--output",
            "/dev/stdout",
        ],
    );
    assert!(
        out(&through).starts_with("well.md:33:"),
        "{}",
        err(&through)
    );
}

#[test]
fn colours_are_only_for_terminals_or_where_they_are_asked_for() {
    let always = out(&run(&["explain", "fails", "--color", "always"]));
    assert!(always.contains('\u{1b}'));
    assert!(!out(&run(&["explain", "fails"])).contains('\u{1b}'));
    for format in ["short", "json", "sarif", "github", "junit"] {
        let text = out(&run(&["--format", format, "--color", "always"]));
        assert!(!text.contains('\u{1b}'), "{format}");
    }
}

#[test]
fn no_page_commands_a_terminal() {
    let folder = super::hostile("hostile-terminal");
    for args in [&["check", "."][..], &["explain", "2", "page.md"]] {
        let text = out(&run_in(&folder, &[args, &["--color", "always"]].concat()));
        for after in text.split('\u{1b}').skip(1) {
            let rest = after.strip_prefix('[').unwrap_or(after);
            let rest = rest.trim_start_matches(|c: char| c.is_ascii_digit() || c == ';');
            assert!(rest.starts_with('m'), "{after:?}");
        }
        let other = |c: char| c.is_control() && !['\n', '\u{1b}'].contains(&c);
        assert_eq!(text.chars().find(|c| other(*c)), None);
    }
}

#[test]
fn colours_stay_and_other_commands_do_not() {
    let written = |text: &str| {
        let path = super::folder("commands").join("text.txt");
        let path = path.to_str().unwrap();
        let args = ["cradle-verify", "report", "--color", "always", "-o", path];
        let args = Args::parse_from(args);
        deliver(&Content::Text(text.to_owned()), &args).unwrap();
        std::fs::read_to_string(path).unwrap()
    };
    let own = "\u{1b}[1;31mfails\u{1b}[0m\n\tδ";
    assert_eq!(written(own), own);
    assert_eq!(
        written("\u{1b}[2J\u{1b}]0;x\u{7}\r\u{9b}31m\u{1b}"),
        "\u{fffd}[2J\u{fffd}]0;x\u{fffd}\u{fffd}\u{fffd}31m\u{fffd}"
    );
}

#[test]
fn where_nothing_is_asked_all_is_as_the_options_say() {
    // The bare command takes these without looking at what could be asked.
    let parsed = Args::parse_from(["cradle-verify"]);
    assert_eq!(format!("{parsed:?}"), format!("{:?}", Args::default()));
}

#[test]
fn the_audit_is_the_same_by_any_number_of_threads() {
    let derivation = proofs::report();
    let seen = |threads: usize| {
        let done = AtomicUsize::new(0);
        let audit = Audit::by(&derivation, threads, &done);
        assert_eq!(done.into_inner(), derivation.equations.len());
        let report = Report {
            derivation: &derivation,
            audit: &audit,
            paths: &[],
        };
        let remarks = report.remarks(std::path::Path::new(""), &Default::default());
        (
            report.human(true),
            serde_json::to_string(&report.json()).unwrap(),
            format!("{remarks:?}"),
        )
    };
    let one = seen(1);
    for threads in [0, 2, 3, 8] {
        assert!(seen(threads) == one, "{threads} threads");
    }
}

#[test]
fn completions_and_manual_pages_know_the_commands() {
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let output = run(&["completions", shell]);
        assert_eq!(code(&output), 0, "{}", err(&output));
        for word in ["explain", "strict-baseline"] {
            assert!(out(&output).contains(word), "{shell}: {word}");
        }
    }
    assert_eq!(code(&run(&["completions", "tcsh"])), 2);
    let page = out(&run(&["man"]));
    assert!(
        page.contains(".TH cradle-verify 1") && page.contains("cradle\\-verify\\-check(1)"),
        "{page}"
    );
    let check = out(&run(&["man", "check"]));
    assert!(
        check.contains(".TH cradle-verify-check 1") && check.contains("strict\\-baseline"),
        "{check}"
    );
    let energy = out(&run(&["man", "plot", "energy"]));
    assert!(
        energy.contains(".TH cradle-verify-plot-energy 1") && energy.contains("\\-\\-material"),
        "{energy}"
    );
    for wrong in [&["man", "plot", "enrgy"][..], &["man", "check", "plot"]] {
        assert_eq!(code(&run(wrong)), 2, "{wrong:?}");
    }
    let unknown = run(&["man", "chekc"]);
    assert_eq!(code(&unknown), 2);
    assert!(err(&unknown).contains("check"), "{}", err(&unknown));
}

/// What a watch says, until it has told a story.
fn watched(
    folder: &Path,
    file: &str,
    story: impl FnOnce(&mut dyn FnMut(&str) -> Result<(), String>) -> Result<(), String>,
) -> Result<(), String> {
    let mut child = command(&["check", file, "--watch", "--format", "short"])
        .current_dir(folder)
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    let (lines, heard) = std::sync::mpsc::channel();
    for pipe in [
        Box::new(child.stdout.take().unwrap()) as Box<dyn std::io::Read + Send>,
        Box::new(child.stderr.take().unwrap()),
    ] {
        let lines = lines.clone();
        std::thread::spawn(move || {
            for line in BufReader::new(pipe).lines().map_while(Result::ok) {
                let _ = lines.send(line);
            }
        });
    }
    let end = Instant::now() + Duration::from_secs(60);
    // The two pipes are heard in either order.
    let mut said: Vec<String> = Vec::new();
    let mut wait_for = |part: &str| -> Result<(), String> {
        loop {
            if let Some(at) = said.iter().position(|line| line.contains(part)) {
                said.remove(at);
                return Ok(());
            }
            let left = end.saturating_duration_since(Instant::now());
            match heard.recv_timeout(left) {
                Ok(line) => said.push(line),
                Err(_) => return Err(format!("not said: {part}; said: {said:?}")),
            }
        }
    };
    let told = story(&mut wait_for);
    child.kill().unwrap();
    child.wait().unwrap();
    told
}

#[test]
fn a_watched_page_is_audited_again_when_it_changes() {
    let (folder, text) = well("watch");
    let page = folder.join("well.md");
    let story = watched(&folder, "well.md", |wait_for| {
        wait_for("watching 1 document; Ctrl-C ends")?;
        std::fs::write(&page, text.replace(r"\frac{v^2}{2 g}", r"\frac{v^2}{50 g}")).unwrap();
        wait_for("well.md:25:8: error[fails]: equation (4)")?;
        wait_for("watching 1 document")?;
        wait_for("error[fails]: equation (6)")?;
        std::fs::remove_file(&page).unwrap();
        wait_for("there is no file or directory")?;
        std::fs::write(&page, &text).unwrap();
        wait_for("watching 1 document")
    });
    assert_eq!(story, Ok(()));
    let refused = piped(&["check", "-", "--watch"], FALSE);
    assert_eq!(code(&refused), 2);
}

#[test]
fn what_a_watched_document_takes_in_is_watched_too() {
    let (folder, _) = well("watch-input");
    let main = r"\begin{document} \input{sub} \end{document}";
    std::fs::write(folder.join("main.tex"), main).unwrap();
    let sub = folder.join("sub.tex");
    let write = |right: &str| {
        let derived = "% check: derived\n";
        std::fs::write(&sub, format!("{derived}\\[ 1 + 1 = {right} \\]\n")).unwrap();
    };
    let story = watched(&folder, "main.tex", |wait_for| {
        // It is not there yet.
        wait_for("main.tex:1:18: error[unreadable]")?;
        wait_for("watching 1 document")?;
        write("3");
        wait_for("sub.tex:2:12: error[fails]")?;
        wait_for("watching 1 document")?;
        write("22");
        wait_for("right 22")?;
        wait_for("watching 1 document")
    });
    assert_eq!(story, Ok(()));
}
