//! What rests on what: each statement with what it was judged from, and what falls with each that fails.
//!
//! [`Graph::of`] gathers it once. `text` tells it in sentences, `dot` and `json` hand it on to other programs, and
//! `svg` draws it where `layout` has put the nodes, with `lines` between them, so that a page can take the drawing in as it is.

mod dot;
mod json;
mod layout;
mod legend;
mod lines;
mod svg;
mod text;

use std::collections::BTreeSet;

use crate::audit::{Entry, Review, Verdict};
use crate::derivation::{Assumed, Source, formulas};
use crate::notation::plain_statement;

use super::Report;
use super::words::shortened;
use crate::sorted::Tree;

pub use json::GraphView;

/// Longer texts tell no more in a drawing.
const LONGEST: usize = 200;

/// The statements of a report, and which rests on which.
#[derive(Clone, Debug)]
pub struct Graph {
    /// The title and the path of each document.
    pub documents: Vec<(String, String)>,
    /// One node for each statement, in reading order.
    pub nodes: Vec<Node>,
    /// From a premise to what was judged from it, by position, sorted.
    pub edges: Vec<(usize, usize)>,
}

/// A statement.
#[derive(Clone, Debug)]
pub struct Node {
    /// Unlike that of any other: `23`, `33/1` for the first of several statements.
    pub id: String,
    /// As a reader knows it: `(23)`, `n-in-n-out 1/2`.
    pub name: String,
    /// The number as printed.
    pub tag: Option<String>,
    /// The name from `claim NAME`.
    pub claim: Option<String>,
    /// Which statement of its display, from 1, where there are several.
    pub part: Option<usize>,
    /// The document, by position.
    pub document: usize,
    /// Where it stands: `path:line:column`.
    pub place: String,
    /// What was found of it.
    pub verdict: Verdict,
    /// What that means for what it is drawn as.
    pub status: Status,
    /// What was read, in one line.
    pub statement: String,
    /// For what fails: what falls with it, by position.
    pub falls: Vec<usize>,
    /// For what falls: the failing statements that it comes from, by position.
    pub rests_on: Vec<usize>,
    /// For what falls: what it follows from all the same, where another way was found.
    pub rederived_from: Option<Vec<Source>>,
}

/// How a statement stands.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Status {
    /// A law, model or definition.
    Given,
    /// Proved, from nothing that fails.
    Holds,
    /// Follows from what it cites, and that comes from something false.
    Falls,
    /// The same, and it follows from something else as well.
    Stands,
    /// Refuted.
    Fails,
    /// Compares what differs in dimension.
    IllDimensioned,
    /// The author crosses it out, and it is wrong.
    CrossedOut,
    /// Neither proved nor refuted.
    Undecided,
}

impl Status {
    /// All of them, in the order of a legend.
    pub const ALL: [Status; 8] = [
        Status::Given,
        Status::Holds,
        Status::Fails,
        Status::IllDimensioned,
        Status::Falls,
        Status::Stands,
        Status::CrossedOut,
        Status::Undecided,
    ];

    /// In words, for a legend.
    pub fn words(self) -> &'static str {
        match self {
            Status::Given => "given",
            Status::Holds => "holds",
            Status::Falls => "falls with what fails",
            Status::Stands => "falls, but follows another way",
            Status::Fails => "fails",
            Status::IllDimensioned => "ill-dimensioned",
            Status::CrossedOut => "crossed out by the author",
            Status::Undecided => "undecided",
        }
    }

    /// Whether it fails and takes others with it.
    pub fn is_failing(self) -> bool {
        matches!(self, Status::Fails | Status::IllDimensioned)
    }

    /// Whether it comes from something that fails.
    pub fn is_fallen(self) -> bool {
        matches!(self, Status::Falls | Status::Stands)
    }

    fn of(entry: &Entry) -> Status {
        match entry.verdict {
            _ if entry.fails_as_marked() => Status::CrossedOut,
            Verdict::Given => Status::Given,
            Verdict::Fails => Status::Fails,
            Verdict::IllDimensioned => Status::IllDimensioned,
            Verdict::Undecided => Status::Undecided,
            Verdict::Holds if entry.rests_on.is_empty() => Status::Holds,
            Verdict::Holds => Status::Falls,
        }
    }
}

impl Graph {
    /// Gathers what rests on what, and looks for other ways to what falls.
    pub fn of(report: &Report<'_>) -> Graph {
        let pages = &report.derivation.pages;
        let title = |at: usize| (pages[at].title.clone(), pages[at].document.path.clone());
        let mut graph = Graph {
            documents: (0..pages.len()).map(title).collect(),
            nodes: Vec::new(),
            edges: Vec::new(),
        };
        let mut ids: BTreeSet<String> = BTreeSet::new();
        for entry in &report.audit.entries {
            let mut node = node(report, entry);
            if !ids.insert(node.id.clone()) {
                // Two equations with one number: the place tells them apart.
                node.id = format!("{}@{}", node.id, node.place);
                while !ids.insert(node.id.clone()) {
                    node.id.push('+');
                }
            }
            graph.nodes.push(node);
        }
        graph.edges = edges(report);
        graph.follow_failures(report);
        graph
    }

    fn follow_failures(&mut self, report: &Report<'_>) {
        let entries = &report.audit.entries;
        let first = |equation: usize| entries.partition_point(|e| e.equation < equation);
        for fallen in Review::new(report.derivation, report.audit).fallen() {
            let own = fallen.entry;
            for &equation in &fallen.with {
                let failing: Vec<usize> = (first(equation)..first(equation + 1))
                    .filter(|&at| self.nodes[at].status.is_failing())
                    .collect();
                for at in failing {
                    self.nodes[at].falls.push(own);
                    self.nodes[own].rests_on.push(at);
                }
            }
            if fallen.instead.is_some() {
                self.nodes[own].status = Status::Stands;
            }
            self.nodes[own].rederived_from = fallen.instead;
        }
    }

    /// Whether an edge hands on what is false: what is derived from it falls, or fails besides.
    pub fn is_broken(&self, (from, to): (usize, usize)) -> bool {
        let (from, to) = (self.nodes[from].status, self.nodes[to].status);
        (from.is_failing() || from.is_fallen()) && (to.is_failing() || to.is_fallen())
    }

    /// What fails itself and is derived from something that fails: it rests on that, and would not stand with it.
    fn failing_besides(&self, own: usize) -> Vec<usize> {
        let start = self.edges.partition_point(|(from, _)| *from < own);
        let from_it = self.edges[start..]
            .iter()
            .take_while(|(from, _)| *from == own);
        let besides = from_it.map(|(_, to)| *to);
        besides
            .filter(|&to| self.nodes[to].status.is_failing())
            .collect()
    }

    /// `7 fail`, `2 are ill-dimensioned`: what is wrong, as the closing sentence of an audit counts it. The words are for one
    /// statement and for several.
    fn wrong(&self, words: [[&str; 2]; 3]) -> Vec<String> {
        let kinds = [Status::Fails, Status::IllDimensioned, Status::CrossedOut].into_iter();
        let numbers = kinds.map(|kind| self.nodes.iter().filter(|n| n.status == kind).count());
        let told = numbers.zip(words).filter(|(number, _)| *number > 0);
        told.map(|(number, [one, several])| match number {
            1 => format!("1 {one}"),
            _ => format!("{number} {several}"),
        })
        .collect()
    }
}

fn node(report: &Report<'_>, entry: &Entry) -> Node {
    let equation = report.equation(entry.equation);
    let (label, name) = (report.label(entry.equation), report.name(entry.equation));
    let (id, name) = match report.part_of(entry) {
        None => (label, name),
        Some((part, parts)) => (format!("{label}/{part}"), format!("{name} {part}/{parts}")),
    };
    let statement = report.statement(entry).map(plain_statement);
    Node {
        id,
        name: shortened(&name, LONGEST),
        tag: equation.tag.clone(),
        claim: equation.name.clone(),
        part: report.part_of(entry).map(|(part, _)| part),
        document: equation.page,
        place: report.place(entry.equation),
        verdict: entry.verdict,
        status: Status::of(entry),
        statement: shortened(&statement.unwrap_or_else(|| "not read".into()), LONGEST),
        falls: Vec::new(),
        rests_on: Vec::new(),
        rederived_from: None,
    }
}

/// From the statement of a premise that was used to what was judged from it.
fn edges(report: &Report<'_>) -> Vec<(usize, usize)> {
    let entries = &report.audit.entries;
    let mut starts: Tree<usize, usize> = Tree::new();
    for (at, entry) in entries.iter().enumerate() {
        starts.entry(entry.equation).or_insert(at);
    }
    let mut edges: BTreeSet<(usize, usize)> = BTreeSet::new();
    for (own, entry) in entries.iter().enumerate() {
        let assumed: Vec<&Assumed> = entry.judged.iter().flat_map(|j| &j.assumed).collect();
        for premise in &entry.premises {
            let Some(&start) = starts.get(premise) else {
                continue;
            };
            let parts = entries[start].parts.max(1);
            let all = start..(start + parts).min(entries.len());
            if parts == 1 {
                edges.insert((start, own));
                continue;
            }
            let statements = report.equation(*premise).statements();
            let is_used = |at: &usize| {
                let stated = statements.get(entries[*at].part).map(formulas);
                let from = assumed
                    .iter()
                    .filter(|a| a.source == Source::Equation(*premise));
                let stated = stated.unwrap_or_default();
                from.into_iter().any(|a| stated.contains(&*a.formula))
            };
            let used: Vec<usize> = all.clone().filter(is_used).collect();
            let used = if used.is_empty() { all.collect() } else { used };
            edges.extend(used.into_iter().map(|part| (part, own)));
        }
    }
    edges.retain(|(from, to)| from != to);
    edges.into_iter().collect()
}
