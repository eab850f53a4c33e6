//! A line for each remark: `short` and `github`.

use super::{code, err, hostile, out, run, run_in};

#[test]
fn short_lines_of_the_example() {
    let output = run(&["check", "docs/examples/well.md", "--format", "short"]);
    assert_eq!(code(&output), 1);
    insta::assert_snapshot!("short", out(&output));
}

#[test]
fn annotations_of_the_example() {
    let output = run(&["check", "docs/examples/well.md", "--format", "github"]);
    assert_eq!(code(&output), 1);
    insta::assert_snapshot!("github", out(&output));
}

/// What an editor does: path, line, column, level, code.
fn parsed(line: &str) -> (String, usize, usize, String) {
    let mut parts = line.splitn(4, ':');
    let path = parts.next().unwrap().to_owned();
    let mut number = || {
        parts
            .next()
            .unwrap()
            .parse()
            .unwrap_or_else(|_| panic!("{line}"))
    };
    let (line_number, column) = (number(), number());
    let rest = parts.next().unwrap().trim_start().to_owned();
    (path, line_number, column, rest)
}

#[test]
fn each_line_of_the_report_is_parsed_and_points_into_its_page() {
    let text = out(&run(&["--format", "short"]));
    let (mut last, mut levels) = ((String::new(), 0, 0), Vec::new());
    for line in text.lines() {
        let (path, number, column, rest) = parsed(line);
        let page = std::fs::read_to_string(super::root().join(&path)).unwrap();
        let own = page.lines().nth(number - 1).expect("a line of the page");
        assert!(column >= 1 && column <= own.chars().count() + 1, "{line}");
        let (level, _) = rest.split_once('[').expect("a level and a code");
        levels.push(level.to_owned());
        assert!(
            last <= (path.clone(), number, column),
            "not in order: {line}"
        );
        last = (path, number, column);
    }
    for level in ["error", "warning"] {
        assert!(levels.iter().any(|own| own == level), "no {level}");
    }
}

#[test]
fn no_page_can_write_a_line_of_its_own() {
    let folder = hostile("hostile-lines");
    for format in ["short", "github"] {
        let output = run_in(&folder, &["check", ".", "--format", format]);
        assert_eq!(code(&output), 1, "{}", err(&output));
        let text = out(&output);
        let control = text.chars().find(|c| c.is_control() && *c != '\n');
        assert_eq!(control, None, "{text:?}");
        for line in text.lines() {
            let whole = match format {
                "short" => [": error[", ": warning["]
                    .iter()
                    .any(|own| line.contains(own)),
                _ => {
                    let own = ["::error file=", "::warning file="];
                    let properties = line.trim_start_matches(':').split("::").next().unwrap();
                    own.iter().any(|start| line.starts_with(start))
                        && properties.split(',').count() <= 6
                        && properties.split(',').all(|p| !p.contains(':'))
                }
            };
            assert!(whole, "{line:?}");
        }
        assert!(text.lines().count() >= 4, "{text}");
    }
}

#[test]
fn a_remark_over_several_lines_has_no_columns_for_github() {
    let folder = super::folder("several-lines");
    let page = "<!-- check: derived -->\n$$\n1 + 1\n= 3\n$$\n\n<!-- check: derived -->\n$$\nx =\n y \\tag{2} $$\n";
    std::fs::write(folder.join("page.md"), page).unwrap();
    let output = run_in(&folder, &["check", "page.md", "--format", "github"]);
    let text = out(&output);
    assert!(
        text.contains("line=4,endLine=4,col=3,endColumn=3,"),
        "{text}"
    );
    for line in text.lines() {
        let property = |name: &str| -> Option<usize> {
            let (_, rest) = line.split_once(&format!(",{name}="))?;
            rest.split(',').next()?.parse().ok()
        };
        let one_line = property("line") == property("endLine");
        assert_eq!(one_line, property("col").is_some(), "{line}");
    }
}
