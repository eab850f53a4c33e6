//! What falls with what, in sentences.

use super::super::Report;
use super::super::style::{BOLD, DIM, paint};
use super::super::words::{count, list};
use super::{Graph, Status};

/// Of more than this, a number is told in the first line.
const MOST_NAMED: usize = 12;

impl Graph {
    /// For each failing statement: what falls with it, and what of that stands on its own.
    pub fn text(&self, report: &Report<'_>) -> String {
        let failing = || self.nodes.iter().filter(|n| n.status.is_failing());
        let mut text = format!(
            "{} and {} between them.\n\n",
            count(self.nodes.len(), "statement"),
            count(self.edges.len(), "link")
        );
        for node in failing() {
            let word = match node.status {
                Status::IllDimensioned => "is ill-dimensioned",
                _ => "fails",
            };
            text += &format!(
                "{} {word}; {}",
                paint(BOLD, &node.name),
                self.fall(&node.falls)
            );
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
        let stand = self
            .nodes
            .iter()
            .filter(|n| n.status == Status::Stands)
            .count();
        let closing = match (failing().count(), fallen) {
            (0, _) => "Nothing fails, so nothing falls.".to_owned(),
            (1, 0) => "One statement fails, and nothing rests on it.".to_owned(),
            (failing, 0) => format!("{failing} statements fail, and nothing rests on them."),
            (failing, fallen) => format!(
                "Of {}, {failing} fail and {fallen} fall with them; {stand} of these stand on their own.",
                count(self.nodes.len(), "statement")
            ),
        };
        if failing().count() > 0 {
            text.push('\n');
        }
        text + &paint(BOLD, &closing) + "\n"
    }

    fn fall(&self, falls: &[usize]) -> String {
        match falls {
            [] => "nothing rests on it".into(),
            [one] => format!("with it falls {}", self.nodes[*one].name),
            many if many.len() > MOST_NAMED => {
                format!("with it fall {}", count(many.len(), "statement"))
            }
            many => {
                let names = many.iter().map(|&at| self.nodes[at].name.clone());
                format!("with it fall {}", list(names.collect()))
            }
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
            None => format!("no other way to it was found: {}", node.statement),
        }
    }
}
