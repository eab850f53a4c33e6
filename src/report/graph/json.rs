//! The graph for programs; `docs/graph.schema.json` says the same.

use serde::Serialize;

use super::super::Report;
use super::super::words::unplaced;
use super::{Graph, Node};
use crate::derivation::Source;

/// What rests on what.
#[derive(Clone, Debug, Serialize)]
pub struct GraphView {
    /// The paths of the documents, in reading order.
    pub documents: Vec<String>,
    /// The statements, in reading order.
    pub nodes: Vec<NodeView>,
    /// Premises and what was judged from them.
    pub edges: Vec<EdgeView>,
}

/// A statement.
#[derive(Clone, Debug, Serialize)]
pub struct NodeView {
    /// What edges name it by.
    pub id: String,
    /// The number as printed; absent where there is none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tag: Option<String>,
    /// The name from `claim NAME`; absent where there is none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Which statement of its display, from 1; absent where the display has one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub part: Option<usize>,
    /// The path of its document.
    pub document: String,
    /// `path:line:column`.
    pub place: String,
    /// As in the audit.
    pub verdict: &'static str,
    /// For what fails, unless the author crosses it out: the statements that fall with it, by id.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub falls_with: Option<Vec<String>>,
    /// The failing statements that it comes from, by id.
    pub rests_on: Vec<String>,
    /// For what falls: what it follows from all the same, numbers and names; absent where no other way was found.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rederived_from: Option<Vec<String>>,
}

/// A premise and what was judged from it.
#[derive(Clone, Debug, Serialize)]
pub struct EdgeView {
    /// The premise, by id.
    pub from: String,
    /// What was judged from it, by id.
    pub to: String,
}

impl Graph {
    /// The graph, to be written as JSON.
    pub fn json(&self, report: &Report<'_>) -> GraphView {
        let id = |at: usize| self.nodes[at].id.clone();
        let edges = self.edges.iter().map(|&(from, to)| EdgeView {
            from: id(from),
            to: id(to),
        });
        GraphView {
            documents: self
                .documents
                .iter()
                .map(|(_, path)| path.clone())
                .collect(),
            nodes: self
                .nodes
                .iter()
                .map(|n| self.node_view(n, report))
                .collect(),
            edges: edges.collect(),
        }
    }

    fn node_view(&self, node: &Node, report: &Report<'_>) -> NodeView {
        let ids = |all: &[usize]| all.iter().map(|&at| self.nodes[at].id.clone()).collect();
        let source = |source: &Source| match *source {
            Source::Equation(at) => report.label(at),
            Source::Local(page, at) => {
                report.place_of(page, report.derivation.local(page, at).span)
            }
            of_no_place => unplaced(of_no_place).into(),
        };
        NodeView {
            id: node.id.clone(),
            tag: node.tag.clone(),
            name: node.claim.clone(),
            part: node.part,
            document: self.documents[node.document].1.clone(),
            place: node.place.clone(),
            verdict: node.verdict.word(),
            falls_with: node.status.is_failing().then(|| ids(&node.falls)),
            rests_on: ids(&node.rests_on),
            rederived_from: node
                .rederived_from
                .as_ref()
                .map(|all| all.iter().map(source).collect()),
        }
    }
}
