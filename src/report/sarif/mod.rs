//! SARIF 2.1.0, for code scanning: a rule for each code, a result for each remark.
//!
//! Columns count characters (`columnKind`), paths are URI references told from where the program was started, and
//! `partialFingerprints` do not change when a paragraph moves.

mod model;

use serde_json::{Value, json};

use crate::document::Position;

use self::model::{
    Artifact, Change, Configuration, Driver, Help, Location, Log, Logical, Outcome, Physical,
    Region, Repair, Replacement, Rule, Run, Text, Tool,
};
use super::Report;
use super::codes::{self, CODES};
use super::place::uri;
use super::remark::{Remark, Saved, Subject};
use crate::sorted::Map;

const SCHEMA: &str =
    "https://docs.oasis-open.org/sarif/sarif/v2.1.0/errata01/os/schemas/sarif-schema-2.1.0.json";
/// The key of our fingerprints; its number is changed with how they are made.
const FINGERPRINT: &str = "cradleVerify/v2";

impl Report<'_> {
    /// The log of one run. `compared` says that there is a baseline, so that each result tells whether it is new.
    pub fn sarif(&self, remarks: &[Remark], compared: bool) -> impl serde::Serialize {
        let results = remarks.iter().map(|remark| self.outcome(remark, compared));
        Log {
            schema: SCHEMA,
            version: "2.1.0",
            runs: [Run {
                tool: Tool {
                    driver: Driver {
                        name: "cradle-verify",
                        semantic_version: env!("CARGO_PKG_VERSION"),
                        rules: rules(),
                    },
                },
                column_kind: "unicodeCodePoints",
                results: results.collect(),
            }],
        }
    }

    fn outcome(&self, remark: &Remark, compared: bool) -> Outcome {
        let mut text = remark.title.clone();
        for (name, said) in &remark.said {
            text += &format!("\n{name}: {}", said.replace('\n', "\n  "));
        }
        let mut place = located(&remark.path, remark.place, remark.saved.as_ref());
        let mut properties = Map::new();
        if let Subject::Entry(at) = remark.subject {
            let name = self.key(at);
            if !name.is_empty() {
                place.logical_locations.push(Logical { name });
            }
            properties = self.properties(at);
        }
        let related = remark
            .context
            .iter()
            .enumerate()
            .map(|(at, seen)| Location {
                id: Some(at + 1),
                message: Some(Text {
                    text: seen.text.clone(),
                }),
                ..located(&seen.path, seen.place, seen.saved.as_ref())
            });
        // In a notebook the text is written otherwise, and nothing could be put in as it is.
        let fixes = remark.fix.iter().filter(|_| remark.saved.is_none());
        let fixes = fixes.map(|(fix, place)| Repair {
            description: Text {
                text: fix.message.clone(),
            },
            artifact_changes: [Change {
                artifact_location: artifact(&remark.path),
                replacements: [Replacement {
                    deleted_region: region(*place),
                    inserted_content: Text {
                        text: fix.text.clone(),
                    },
                }],
            }],
        });
        let state = if remark.known { "unchanged" } else { "new" };
        Outcome {
            rule_id: remark.code,
            rule_index: rule_index(remark.code),
            level: remark.level.word(),
            message: Text { text },
            locations: [place],
            related_locations: related.collect(),
            partial_fingerprints: Map::from([(FINGERPRINT, remark.fingerprint.clone())]),
            baseline_state: compared.then_some(state),
            fixes: fixes.collect(),
            properties,
        }
    }

    /// What else a program may want to know: the statement as it was read, its verdict, the counterexample.
    fn properties(&self, at: usize) -> Map<&'static str, Value> {
        let view = self.equation_view(&self.audit.entries[at]);
        let mut properties = Map::from([
            ("kind", json!(view.kind)),
            ("verdict", json!(view.verdict)),
            ("premises", json!(view.premises)),
        ]);
        properties.extend(view.understood.map(|text| ("understood", json!(text))));
        properties.extend(view.repair.map(|text| ("repair", json!(text))));
        if !view.witness.is_empty() {
            properties.insert("counterexample", json!(view.witness));
        }
        if !view.situations.is_empty() {
            properties.insert("counterexample", json!(view.situations));
        }
        if let Some(dimensions) = view.dimensions {
            properties.insert("dimensions", json!(dimensions));
        }
        properties
    }
}

/// The codes of which something is reported, in the order of [`CODES`].
fn reported() -> impl Iterator<Item = (&'static str, codes::Level)> {
    let all = CODES.iter();
    all.filter_map(|(code, level)| Some((*code, (*level)?)))
}

fn rule_index(code: &str) -> usize {
    reported().position(|(own, _)| own == code).unwrap_or(0)
}

fn rules() -> Vec<Rule> {
    let rules = reported().map(|(id, level)| {
        let help = codes::page(id).map_or("", |(_, text)| text);
        let summary = codes::summary(id).unwrap_or_default();
        Rule {
            id,
            short_description: Text {
                text: id.replace('-', " "),
            },
            full_description: Text { text: summary },
            help: Help {
                text: help,
                markdown: help,
            },
            default_configuration: Configuration {
                level: level.word(),
            },
        }
    });
    rules.collect()
}

fn artifact(path: &str) -> Artifact {
    Artifact { uri: uri(path) }
}

fn located(path: &str, place: (Position, Position), saved: Option<&Saved>) -> Location {
    let own = Physical {
        artifact_location: artifact(path),
        region: region(place),
    };
    let in_notebook = |saved: &Saved| Physical {
        artifact_location: artifact(&saved.path),
        region: Region {
            start_line: saved.lines.0,
            start_column: None,
            end_line: saved.lines.1.max(saved.lines.0),
            end_column: None,
        },
    };
    let cell = saved.map(|saved| Logical {
        name: saved.cell.clone(),
    });
    Location {
        id: None,
        physical_location: saved.map_or(own, in_notebook),
        logical_locations: cell.into_iter().collect(),
        message: None,
    }
}

fn region((start, end): (Position, Position)) -> Region {
    Region {
        start_line: start.line,
        start_column: Some(start.column),
        end_line: end.line,
        end_column: Some(end.column),
    }
}
