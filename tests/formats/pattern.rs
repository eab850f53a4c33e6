//! Patterns of paths in a `cradle.toml`.

use cradle_verify::config::{Config, matches};

#[test]
fn a_star_stays_in_its_folder_and_two_do_not() {
    for (pattern, path, expected) in [
        ("*.md", "a.md", true),
        ("*.md", "b/a.md", false),
        ("**/*.md", "a.md", true),
        ("**/*.md", "b/c/a.md", true),
        ("b/**/a.md", "b/a.md", true),
        ("b/**/a.md", "c/a.md", false),
        ("ch?pter*.tex", "chapter-1.tex", true),
        ("ch?pter*.tex", "chpter.tex", false),
        ("**", "a/b", true),
        ("*a*a*a*b", "aaaaaaaaaaaaaaaaaaaaaaaaaaaaaa", false),
    ] {
        assert_eq!(matches(pattern, path), expected, "{pattern} {path}");
    }
}

#[test]
fn the_folder_is_what_stands_before_the_first_star() {
    let read = |text: &str| Config::read("cradle.toml", &format!("files = [{text:?}]\n"));
    let folder = |text: &str| {
        let files = read(text).unwrap().files.unwrap();
        let (folder, rest) = files[0].value.folder();
        (folder.to_owned(), rest.map(str::to_owned))
    };
    assert_eq!(folder("./paper.tex"), ("paper.tex".into(), None));
    assert_eq!(folder("a/b/*.md"), ("a/b".into(), Some("*.md".into())));
    assert_eq!(folder("a*/b.md"), (String::new(), Some("a*/b.md".into())));
    assert_eq!(folder("/*.md"), ("/".into(), Some("*.md".into())));
    assert!(read(" ").is_err() && read("a\\b").is_err());
}
