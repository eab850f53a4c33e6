//! The graph for Graphviz.

use super::{Graph, Node, Status};

impl Graph {
    /// A `digraph` with a cluster for each document. What fails and what falls differ in shape and label as well as
    /// in colour. The same graph gives the same text.
    pub fn dot(&self) -> String {
        let mut text = String::from("digraph derivation {\n");
        text += "  rankdir=LR;\n  node [fontname=\"sans-serif\", fontsize=11];\n";
        text += "  edge [color=\"#8c959f\", arrowsize=0.6];\n";
        for (document, (title, path)) in self.documents.iter().enumerate() {
            let own: Vec<(usize, &Node)> = self
                .nodes
                .iter()
                .enumerate()
                .filter(|(_, node)| node.document == document)
                .collect();
            if own.is_empty() {
                continue;
            }
            let title = if title.is_empty() { path } else { title };
            text += &format!(
                "  subgraph cluster_{document} {{\n    label={};\n",
                quoted(title)
            );
            text += "    color=\"#d0d7de\";\n";
            for (at, node) in own {
                text += &format!("    n{at} [{}];\n", attributes(self, node));
            }
            text += "  }\n";
        }
        for &(from, to) in &self.edges {
            let broken = match self.is_broken((from, to)) {
                true => " [color=\"#cf222e\", penwidth=2, style=dashed]",
                false => "",
            };
            text += &format!("  n{from} -> n{to}{broken};\n");
        }
        text + "}\n"
    }
}

fn attributes(graph: &Graph, node: &Node) -> String {
    let with = || {
        let mut names: Vec<String> = node
            .rests_on
            .iter()
            .take(4)
            .map(|&at| graph.nodes[at].name.clone())
            .collect();
        if node.rests_on.len() > names.len() {
            names.push("…".into());
        }
        names.join(", ")
    };
    let (look, said) = match node.status {
        Status::Given => ("shape=ellipse, color=\"#57606a\"", None),
        Status::Holds => ("shape=box, color=\"#1a7f37\"", None),
        Status::Falls => (
            "shape=box, style=dashed, color=\"#cf222e\"",
            Some(format!("falls with {}", with())),
        ),
        Status::Stands => (
            "shape=box, style=\"dashed,rounded\", color=\"#9a6700\"",
            Some(format!("falls with {}, stands on its own", with())),
        ),
        Status::Fails => (
            "shape=octagon, peripheries=2, style=filled, fillcolor=\"#ffebe9\", color=\"#cf222e\"",
            Some("fails".into()),
        ),
        Status::IllDimensioned => (
            "shape=octagon, peripheries=2, style=filled, fillcolor=\"#ffebe9\", color=\"#cf222e\"",
            Some("ill-dimensioned".into()),
        ),
        Status::CrossedOut => (
            "shape=octagon, color=\"#57606a\"",
            Some("crossed out".into()),
        ),
        Status::Undecided => ("shape=diamond, color=\"#9a6700\"", Some("undecided".into())),
    };
    let label = match said {
        Some(said) => format!("{}\n{said}", node.name),
        None => node.name.clone(),
    };
    format!(
        "label={}, tooltip={}, {look}",
        quoted(&label),
        quoted(&node.statement)
    )
}

/// A string of the language: quotes and backslashes escaped, lines broken with `\n`.
fn quoted(text: &str) -> String {
    let mut quoted = String::from("\"");
    for c in text.chars() {
        match c {
            '"' => quoted += "\\\"",
            '\\' => quoted += "\\\\",
            '\n' => quoted += "\\n",
            c if c.is_control() => quoted.push(' '),
            c => quoted.push(c),
        }
    }
    quoted.push('"');
    quoted
}
