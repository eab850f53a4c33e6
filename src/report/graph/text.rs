//! What falls with what, in sentences.

use super::super::Report;
use super::super::style::{BOLD, DIM, paint};
use super::super::words::{count, list};
use super::{Graph, Status};
use crate::notation::unbraced;

/// Of more than this, a number is told in the first line.
const MOST_NAMED: usize = 12;

impl Graph {
    /// For each failing statement: what falls with it, and what of that stands on its own.
    pub fn text(&self, report: &Report<'_>) -> String {
        let failing = || {
            let nodes = self.nodes.iter().enumerate();
            nodes.filter(|(_, node)| node.status.is_failing())
        };
        let mut text = format!(
            "{} and {} between them.\n\n",
            count(self.nodes.len(), "statement"),
            count(self.edges.len(), "link")
        );
        for (own, node) in failing() {
            let word = match node.status {
                Status::IllDimensioned => "is ill-dimensioned",
                _ => "fails",
            };
            text += &format!("{} {word}; {}", paint(BOLD, &node.name), self.fall(own));
            text += &format!("  {}\n", paint(DIM, &node.place));
            let names = node
                .falls
                .iter()
                .map(|&at| self.nodes[at].name.chars().count());
            let width = names.max().unwrap_or(0);
            for &at in &node.falls {
                let own = &self.nodes[at];
                text += &format!("  {:<width$}  {}\n", own.name, self.standing(at, report));
            }
        }
        let fallen = self.nodes.iter().filter(|n| n.status.is_fallen()).count();
        let of_own = self.nodes.iter().filter(|n| n.status == Status::Stands);
        let stand = match (fallen, of_own.count()) {
            (1, 0) => "does not stand on its own".to_owned(),
            (1, _) => "stands on its own".to_owned(),
            (_, 0) => "none of these stands on its own".to_owned(),
            (_, 1) => "1 of these stands on its own".to_owned(),
            (_, stand) => format!("{stand} of these stand on their own"),
        };
        let is_alone = failing().all(|(own, _)| self.failing_besides(own).is_empty());
        let closing = match (failing().count(), fallen) {
            (0, _) => "Nothing fails, so nothing falls.".to_owned(),
            (1, 0) => "One statement fails, and nothing rests on it.".to_owned(),
            (failing, 0) if is_alone => {
                format!("{failing} statements fail, and nothing rests on them.")
            }
            (failing, fallen) => {
                let with = if failing == 1 { "it" } else { "them" };
                let falls = match fallen {
                    0 => format!("nothing else falls with {with}"),
                    1 => format!("1 falls with {with} and {stand}"),
                    _ => format!("{fallen} fall with {with}, and {stand}"),
                };
                let wrong = self.wrong([
                    ["fails", "fail"],
                    ["is ill-dimensioned", "are ill-dimensioned"],
                    [
                        "is crossed out by the author",
                        "are crossed out by the author",
                    ],
                ]);
                let all = count(self.nodes.len(), "statement");
                format!("Of {all}, {}; {falls}.", list(wrong))
            }
        };
        if failing().count() > 0 {
            text.push('\n');
        }
        text + &paint(BOLD, &closing) + "\n"
    }

    /// What falls with a statement that fails, and what is derived from it and fails besides.
    fn fall(&self, own: usize) -> String {
        let mut told = Vec::new();
        match self.nodes[own].falls.as_slice() {
            [] => {}
            [one] => told.push(format!("with it falls {}", self.named(&[*one]))),
            many => told.push(format!("with it fall {}", self.named(many))),
        }
        match self.failing_besides(own).as_slice() {
            [] => {}
            [one] => told.push(format!(
                "{} is derived from it and fails too",
                self.named(&[*one])
            )),
            many => told.push(format!(
                "{} are derived from it and fail too",
                self.named(many)
            )),
        }
        match told.is_empty() {
            true => "nothing rests on it".into(),
            false => told.join("; "),
        }
    }

    fn named(&self, nodes: &[usize]) -> String {
        match nodes {
            many if many.len() > MOST_NAMED => count(many.len(), "statement"),
            all => list(all.iter().map(|&at| self.nodes[at].name.clone()).collect()),
        }
    }

    fn standing(&self, at: usize, report: &Report<'_>) -> String {
        let node = &self.nodes[at];
        match &node.rederived_from {
            Some(sources) if sources.is_empty() => {
                "stands on its own: it follows by algebra alone".into()
            }
            Some(sources) => {
                format!(
                    "stands on its own: it follows from {}",
                    report.sources(sources)
                )
            }
            None => {
                let statement = unbraced(&node.statement);
                format!("no other way to it was found: {statement}")
            }
        }
    }
}
