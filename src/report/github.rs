//! Annotations for GitHub's checks: a workflow command for each remark.
//!
//! `::error file=…,line=…,endLine=…,col=…,endColumn=…,title=…::message`. What would end a property or the line is written
//! as `%` and two digits, so that no document can issue commands of its own. Columns are counted in characters; GitHub
//! shows them only where a remark ends on the line on which it starts, so they are given only there.

use super::codes::Level;
use super::place::one_line;
use super::remark::Remark;

/// A command for each remark that no baseline knows.
pub fn github(remarks: &[Remark]) -> String {
    let mut text = String::new();
    for remark in remarks.iter().filter(|remark| !remark.known) {
        let command = match remark.level {
            Level::Error => "error",
            Level::Warning => "warning",
            Level::Note => "notice",
        };
        text += &format!("::{command} {}", place(remark));
        text += &format!(",title={}", property(remark.code));
        let mut lines = vec![one_line(&remark.title)];
        for (name, said) in &remark.said {
            let said = said.lines().map(one_line).collect::<Vec<_>>();
            lines.push(format!("{name}: {}", said.join("\n  ")));
        }
        text += &format!("::{}\n", message(&lines.join("\n")));
    }
    text
}

fn place(remark: &Remark) -> String {
    if let Some(saved) = &remark.saved {
        let (path, (first, last)) = (property(&saved.path), saved.lines);
        return format!("file={path},line={first},endLine={}", last.max(first));
    }
    let (start, end) = remark.place;
    let mut text = format!("file={}", property(&remark.path));
    text += &format!(",line={},endLine={}", start.line, end.line.max(start.line));
    if end.line == start.line {
        // The last character rather than the first after it.
        let last = end.column.saturating_sub(1).max(start.column);
        text += &format!(",col={},endColumn={last}", start.column);
    }
    text
}

fn message(text: &str) -> String {
    text.replace('%', "%25")
        .replace('\r', "%0D")
        .replace('\n', "%0A")
}

fn property(text: &str) -> String {
    message(&one_line(text))
        .replace(':', "%3A")
        .replace(',', "%2C")
}
