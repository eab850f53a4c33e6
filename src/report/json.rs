//! The audit for programs. Every number is exact, so it is a string: `"2/3"`. `docs/schema.json` says the same.

use num_traits::One;
use serde::Serialize;

use crate::algebra::{Expr, Symbol};
use crate::audit::{Counterexamples, Entry, Numeric, Verdict, Weighed};
use crate::derivation::Source;
use crate::dimension::{Conflict, base_letter};
use crate::document::{Document, Position, Span};
use crate::kernel::Assignment;
use crate::kernel::dimension::{Form, What};
use crate::notation::{latex, latex_formula, latex_statement};
use crate::sorted::Map;

use super::Report;
use super::algebraic::Root;
use super::baseline::Comparison;
use super::dimension::{called, declared};
use super::family::{self, Shown};
use super::implied;
use super::numeric::{decimal, headline};
use super::scaling;
use super::words;

/// The whole audit.
#[derive(Clone, Debug, Serialize)]
pub struct AuditView {
    /// The documents in reading order.
    pub documents: Vec<DocumentView>,
    /// How many statements have each verdict; all five are always there.
    pub summary: Map<&'static str, usize>,
    /// How the audit differs from a baseline; absent where there is none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub baseline: Option<Comparison>,
}

/// One document.
#[derive(Clone, Debug, Serialize)]
pub struct DocumentView {
    /// Its path as it was given.
    pub path: String,
    /// Its statements in reading order.
    pub equations: Vec<EquationView>,
    /// What could not be read outside of equations.
    pub problems: Vec<ProblemView>,
}

/// One statement of a displayed equation.
#[derive(Clone, Debug, Serialize)]
pub struct EquationView {
    /// The number as printed; absent where there is none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub tag: Option<String>,
    /// The name from `claim NAME`; absent where there is none.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub name: Option<String>,
    /// Which statement of its display, from 1; absent where the display has one.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub part: Option<usize>,
    /// The file, or the cell of a notebook, where that is not the document's own path.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub file: Option<String>,
    /// The line of the display's mathematics, from 1.
    pub line: usize,
    /// Its column, from 1, in characters.
    pub column: usize,
    /// The display's mathematics as the author wrote it.
    pub latex: String,
    /// What was understood, as canonical LaTeX; absent where it could not be read.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub understood: Option<String>,
    /// `given`, `derived` or `marked`.
    pub kind: &'static str,
    /// `given`, `holds`, `fails`, `ill-dimensioned` or `undecided`.
    pub verdict: &'static str,
    /// What it was judged from: numbers and names, or `path:line:column` where there is neither.
    pub premises: Vec<String>,
    /// The failing equations that it comes from.
    pub rests_on: Vec<String>,
    /// What else there is to say.
    pub notes: Vec<NoteView>,
    /// For what fails: the values of a counterexample, by LaTeX name.
    #[serde(skip_serializing_if = "Map::is_empty")]
    pub witness: Map<String, ValueView>,
    /// For what fails about a symbolic number of elements: a counterexample for every number, where one is found.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub family: Option<FamilyView>,
    /// For what is ill-dimensioned: what differs.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub dimensions: Option<DimensionsView>,
    /// For a scaling relation that fails: each quantity in two situations, by LaTeX name. Both are positive
    /// numbers, written as products of powers.
    #[serde(skip_serializing_if = "Map::is_empty")]
    pub situations: Map<String, Vec<String>>,
    /// For a numeric claim: what the figures say.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub numeric: Option<NumericView>,
    /// What would mend it, where that is known.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub repair: Option<String>,
}

/// A counterexample for every number from some least one on. Terms and formulas are LaTeX.
#[derive(Clone, Debug, Serialize)]
pub struct FamilyView {
    /// The number that is run through: `n`.
    pub parameter: String,
    /// From where on.
    pub least: u32,
    /// Symbols that may have any value in their domain.
    pub free: Vec<String>,
    /// What other symbols are: `n + 1`.
    pub values: Map<String, String>,
    /// The elements, those that are alike together.
    pub elements: Vec<GroupView>,
    /// What the kernel has seen proved for all of them: domains, premises, what else is given, and that what was to be shown is
    /// false.
    pub proved: Vec<CheckView>,
    /// The values for the least number.
    pub first: Map<String, ValueView>,
}

/// Elements that are alike.
#[derive(Clone, Debug, Serialize)]
pub struct GroupView {
    /// How many.
    pub size: String,
    /// What each of them is, by sequence.
    pub values: Map<String, String>,
}

/// Something that was proved of a family.
#[derive(Clone, Debug, Serialize)]
pub struct CheckView {
    /// `domain`, `premise`, `given` or `denial`.
    pub what: &'static str,
    /// The formula that it is about; absent for domains.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub of: Option<String>,
    /// What was proved, with everything put in.
    pub formula: String,
}

/// What figures say of a numeric claim. Ends of intervals are decimals, rounded outwards.
#[derive(Clone, Debug, Serialize)]
pub struct NumericView {
    /// `supported`, `contradicted`, `not-settled` or `not-evaluated`.
    pub outcome: &'static str,
    /// In a sentence.
    pub message: String,
    /// Left over right, of the link that decides.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub ratio: Option<[String; 2]>,
    /// The figures that were used, by LaTeX name.
    pub data: Map<String, DatumView>,
}

/// Figures for a symbol, exact, in SI units.
#[derive(Clone, Debug, Serialize)]
pub struct DatumView {
    /// The least value.
    pub low: String,
    /// The greatest.
    pub high: String,
    /// Who says so.
    pub source: String,
}

/// Two dimensions that differ and may not.
#[derive(Clone, Debug, Serialize)]
pub struct DimensionsView {
    /// `sides`, `summands`, `argument`, `exponent`, `count` or `limit`.
    pub what: &'static str,
    /// One of them, as a declaration spells it: `M L^{2} T^{-2}`.
    pub left: String,
    /// The other.
    pub right: String,
    /// The equations that it disagrees with; none where the declarations alone decide.
    pub disagrees_with: Vec<String>,
    /// A change of units with which one grows more than the other; absent where there is none in exact numbers.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub rescaling: Option<RescalingView>,
}

/// A unit that is made smaller.
#[derive(Clone, Debug, Serialize)]
pub struct RescalingView {
    /// The letter of the base: `L`.
    pub base: &'static str,
    /// How many of the new unit make one of the old.
    pub factor: String,
    /// What the left side is multiplied by.
    pub left: String,
    /// What the right side is multiplied by.
    pub right: String,
}

/// A note.
#[derive(Clone, Debug, Serialize)]
pub struct NoteView {
    /// Its stable code.
    pub code: &'static str,
    /// The note as a clause.
    pub message: String,
}

/// A value: one number, or those of a sequence.
#[derive(Clone, Debug, Serialize)]
#[serde(untagged)]
pub enum ValueView {
    /// `"2/3"`, `"(1+sqrt(5))/2"`, `"root of x^3-2 in [1,2]"`
    Number(String),
    /// `["1", "2/3"]`
    List(Vec<String>),
    /// `{"in_pi": ["0", "4"]}`: 4 π
    InPi {
        /// The coefficients of the powers of π, the constant one first.
        in_pi: Vec<String>,
    },
}

/// A place that could not be read.
#[derive(Clone, Debug, Serialize)]
pub struct ProblemView {
    /// The file, or the cell of a notebook, where that is not the document's own path.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub file: Option<String>,
    /// The line, from 1.
    pub line: usize,
    /// The column, from 1, in characters.
    pub column: usize,
    /// What is wrong.
    pub message: String,
    /// What to write instead; absent where nothing can be said.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub help: Option<String>,
}

/// Where a span stands; its file only where that is not the document's own path.
fn file_of(document: &Document, span: Span) -> (Option<String>, Position) {
    let (path, place) = document.place(span);
    ((path != document.path).then(|| path.to_owned()), place)
}

impl Report<'_> {
    /// The audit of every equation.
    pub fn json(&self) -> AuditView {
        self.view(|_| true)
    }

    /// The audit of some equations, by position.
    pub fn json_of(&self, equations: &[usize]) -> AuditView {
        let mut view = self.view(|entry| equations.contains(&entry.equation));
        view.documents.retain(|d| !d.equations.is_empty());
        view
    }

    fn view(&self, wanted: impl Fn(&Entry) -> bool) -> AuditView {
        let mut summary: Map<&'static str, usize> =
            Verdict::ALL.iter().map(|v| (v.word(), 0)).collect();
        let mut documents = Vec::new();
        for (at, page) in self.derivation.pages.iter().enumerate() {
            let entries = self.audit.entries.iter();
            let own = entries.filter(|e| self.equation(e.equation).page == at && wanted(e));
            let equations: Vec<EquationView> = own.map(|e| self.equation_view(e)).collect();
            for equation in &equations {
                *summary.entry(equation.verdict).or_default() += 1;
            }
            let supposed = self.audit.dimensions.suppositions.iter();
            let supposed = supposed.filter(|((page, _), _)| *page == at);
            let supposed = supposed.map(|(&(page, local), conflict)| {
                let span = self.derivation.local(page, local).span;
                let (file, place) = file_of(&self.derivation.pages[page].document, span);
                ProblemView {
                    file,
                    line: place.line,
                    column: place.column,
                    message: format!("what is supposed here {}", self.fault(conflict)),
                    help: None,
                }
            });
            let problems = page.problems.iter().map(|problem| {
                let (file, place) = file_of(&page.document, problem.span);
                ProblemView {
                    file,
                    line: place.line,
                    column: place.column,
                    message: problem.message.clone(),
                    help: problem.help.clone(),
                }
            });
            let clashes = page.clashes.iter().map(|clash| {
                let finding = self.clashing(at, clash);
                let (file, place) = file_of(&page.document, clash.own);
                ProblemView {
                    file,
                    line: place.line,
                    column: place.column,
                    message: finding.title,
                    help: None,
                }
            });
            documents.push(DocumentView {
                path: page.document.path.clone(),
                equations,
                problems: problems.chain(supposed).chain(clashes).collect(),
            });
        }
        AuditView {
            documents,
            summary,
            baseline: None,
        }
    }

    pub(super) fn equation_view(&self, entry: &Entry) -> EquationView {
        let equation = self.equation(entry.equation);
        let document = &self.derivation.pages[equation.page].document;
        let (file, place) = file_of(document, equation.body);
        let labels = |all: &[usize]| all.iter().map(|&at| self.label(at)).collect();
        let notes = entry.notes.iter().map(|note| NoteView {
            code: note.code(),
            message: self.aside(entry.equation, note).unwrap_or_default(),
        });
        EquationView {
            tag: equation.tag.clone(),
            name: equation.name.clone(),
            part: self.part_of(entry).map(|(part, _)| part),
            file,
            line: place.line,
            column: place.column,
            latex: document.written(equation.body).to_owned(),
            understood: self.statement(entry).map(latex_statement),
            kind: entry.kind.word(),
            verdict: entry.verdict.word(),
            premises: labels(&entry.premises),
            rests_on: labels(&entry.rests_on),
            notes: notes.collect(),
            witness: entry
                .refuted()
                .map(|(_, refuted)| values(refuted.witness()))
                .unwrap_or_default(),
            family: entry
                .refuted()
                .and_then(|(judged, _)| self.family(entry, judged))
                .map(|found| family_view(&found)),
            dimensions: self
                .conflict(entry)
                .map(|conflict| self.dimensions_view(conflict)),
            situations: entry
                .rescaled()
                .map(|(_, refuted, _)| scaling::values(refuted))
                .unwrap_or_default(),
            numeric: entry.numeric.as_deref().map(numeric_view),
            repair: match entry.rescaled() {
                Some((_, refuted, repair)) => repair.map(|r| scaling::repaired(refuted, r)),
                None => implied::instead(entry)
                    .or_else(|| (!entry.missing.is_empty()).then(|| self.supposing(entry)))
                    .or_else(|| entry.notes.iter().find_map(|note| self.repair(note))),
            },
        }
    }

    fn dimensions_view(&self, conflict: &Conflict<Source>) -> DimensionsView {
        let comparison = conflict.evidence.comparison();
        let spelt = |form: &Form| {
            declared(form).unwrap_or_else(|| called(form, &self.audit.dimensions.unknowns))
        };
        let mut disagrees_with: Vec<String> = Vec::new();
        for origin in &conflict.origins[1..] {
            let label = match *origin {
                Source::Equation(at) => self.label(at),
                Source::Local(page, at) => {
                    self.place_of(page, self.derivation.local(page, at).span)
                }
                Source::Step | Source::Taken | Source::Propagation | Source::Nature => continue,
            };
            if *origin != conflict.origins[0] && !disagrees_with.contains(&label) {
                disagrees_with.push(label);
            }
        }
        DimensionsView {
            what: match comparison.what {
                What::Sides => "sides",
                What::Summands => "summands",
                What::Argument(_) => "argument",
                What::Exponent => "exponent",
                What::Count => "count",
                What::Limit => "limit",
            },
            left: spelt(&comparison.left.form),
            right: comparison
                .right
                .as_ref()
                .map_or("dimensionless".into(), |right| spelt(&right.form)),
            disagrees_with,
            rescaling: conflict
                .evidence
                .rescaling()
                .map(|rescaling| RescalingView {
                    base: base_letter(rescaling.base),
                    factor: rescaling.factor.to_string(),
                    left: rescaling.left.to_string(),
                    right: rescaling.right.to_string(),
                }),
        }
    }

    pub(super) fn label(&self, at: usize) -> String {
        match self.equation(at).label() {
            Some(label) => label.to_owned(),
            None => self.place(at),
        }
    }
}

fn numeric_view(numeric: &Numeric) -> NumericView {
    let outcome = numeric.outcome();
    let link = numeric.links.iter().find(|link| link.outcome == *outcome);
    let ratio = link.and_then(|link| link.ratio.as_ref());
    let data = numeric.data.iter().map(|(symbol, (_, datum))| {
        let view = DatumView {
            low: datum.low.to_string(),
            high: datum.high.to_string(),
            source: datum.source.clone(),
        };
        (words::key(symbol), view)
    });
    NumericView {
        outcome: match outcome {
            Weighed::Supported => "supported",
            Weighed::Contradicted => "contradicted",
            Weighed::NotSettled => "not-settled",
            _ => "not-evaluated",
        },
        message: headline(numeric),
        ratio: ratio.map(|r| [decimal(r.low(), false), decimal(r.high(), true)]),
        data: data.collect(),
    }
}

fn family_view(found: &Counterexamples) -> FamilyView {
    let family = found.fails.family();
    let terms = |terms: &Map<Symbol, Expr>| {
        let terms = terms.iter();
        let terms = terms.map(|(symbol, term)| (words::key(symbol), latex(term)));
        terms.collect::<Map<String, String>>()
    };
    let groups = family.groups.iter().map(|group| GroupView {
        size: latex(&group.size),
        values: terms(&group.elements),
    });
    let checks = family::checks(found);
    let kinds = [
        ("domain", checks.possible),
        ("premise", checks.premises),
        ("given", checks.besides),
        ("denial", checks.goal),
    ];
    let proved = kinds.into_iter().flat_map(|(what, all)| {
        let view = move |shown: Shown| CheckView {
            what,
            of: shown.of.map(latex_formula),
            formula: latex_formula(&shown.proven.claim().goal),
        };
        all.into_iter().map(view)
    });
    let free = family::free(&found.fails).into_iter();
    FamilyView {
        parameter: family.parameter.to_string(),
        least: family.least,
        free: free.map(words::key).collect(),
        values: terms(&family.symbols),
        elements: groups.collect(),
        proved: proved.collect(),
        first: values(found.fails.first().witness()),
    }
}

fn values(at: &Assignment) -> Map<String, ValueView> {
    let symbols = at.symbols.iter();
    // Figures are in units of the SI.
    let symbols = symbols.filter(|(own, value)| !own.is_unit() || !value.is_one());
    let symbols = symbols.filter(|(own, _)| !own.is_change());
    let mut all: Map<String, ValueView> = symbols
        .map(|(symbol, value)| (words::key(symbol), ValueView::Number(value.to_string())))
        .collect();
    for (sequence, elements) in &at.sequences {
        let elements = elements.iter().map(|e| e.to_string()).collect();
        all.insert(sequence.to_string(), ValueView::List(elements));
    }
    for ((symbol, variable), value) in &at.derivatives {
        let derivative = Expr::Derivative {
            body: Expr::Symbol(symbol.clone()).into(),
            variable: variable.clone(),
        };
        all.insert(latex(&derivative), ValueView::Number(value.to_string()));
    }
    for ((symbol, variable), higher) in at.course.iter().flat_map(|c| &c.higher) {
        let mut derivative = Expr::Symbol(symbol.clone());
        for value in std::iter::once(None).chain(higher.iter().map(Some)) {
            derivative = Expr::Derivative {
                body: derivative.into(),
                variable: variable.clone(),
            };
            if let Some(value) = value {
                all.insert(latex(&derivative), ValueView::Number(value.to_string()));
            }
        }
    }
    for (call, value) in &at.functions {
        all.insert(latex(call), ValueView::Number(value.to_string()));
    }
    for (symbol, value) in Root::of(at).iter().flat_map(Root::written) {
        all.insert(words::key(&symbol), ValueView::Number(value));
    }
    for (symbol, parts) in &at.in_pi {
        let in_pi = parts.iter().map(|c| c.to_string()).collect();
        all.insert(words::key(symbol), ValueView::InPi { in_pi });
    }
    all
}
