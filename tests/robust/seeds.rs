//! What is damaged: the report, the examples, the test pages, and what is made of them.

use std::path::Path;

/// Every document of one ending that the repository has as an example.
pub fn pages(ending: &str) -> Vec<(String, Vec<u8>)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let folders = [
        "proofs/report",
        "proofs/corrected",
        "docs/examples",
        "tests/pages",
        "tests/documents/report",
        "tests/documents/report/sections",
    ];
    let all = folders.iter().flat_map(|folder| files(&root.join(folder)));
    let found: Vec<_> = all
        .filter(|(name, _)| name.ends_with(&format!(".{ending}")))
        .collect();
    assert!(!found.is_empty(), "there are pages in .{ending}");
    found
}

/// The files of a folder, by name.
pub fn files(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let entries = std::fs::read_dir(folder).into_iter().flatten().flatten();
    let mut found: Vec<_> = entries
        .filter_map(|entry| {
            let bytes = std::fs::read(entry.path()).ok()?;
            Some((entry.file_name().to_string_lossy().into_owned(), bytes))
        })
        .collect();
    found.sort();
    found
}

/// Markdown pages as notebooks, a cell for every few paragraphs.
pub fn notebooks() -> Vec<(String, Vec<u8>)> {
    let notebook = |(name, page): (String, Vec<u8>)| {
        let text = String::from_utf8_lossy(&page).into_owned();
        let paragraphs: Vec<&str> = text.split("\n\n").collect();
        let cells = paragraphs.chunks(3).map(|own| {
            let lines: Vec<String> = own
                .join("\n\n")
                .split_inclusive('\n')
                .map(str::to_owned)
                .collect();
            serde_json::json!({ "cell_type": "markdown", "metadata": {}, "source": lines })
        });
        let cells: Vec<serde_json::Value> = cells.collect();
        let notebook = serde_json::json!({ "nbformat": 4, "nbformat_minor": 5, "metadata": {}, "cells": cells });
        (
            name.replace(".md", ".ipynb"),
            notebook.to_string().into_bytes(),
        )
    };
    pages("md").into_iter().map(notebook).collect()
}

/// What stands between the `$$`s of the pages.
pub fn formulas() -> Vec<(String, Vec<u8>)> {
    let of_page = |(name, page): (String, Vec<u8>)| {
        let text = String::from_utf8_lossy(&page).into_owned();
        let inside = text.split("$$").skip(1).step_by(2);
        inside
            .map(|formula| (name.clone(), formula.as_bytes().to_vec()))
            .collect::<Vec<_>>()
    };
    pages("md").into_iter().flat_map(of_page).collect()
}
