//! The views of a simulation: one for people, one for programs.

use num_rational::BigRational;
use num_traits::One;
use serde_json::{Value, json};

use super::{Balls, End, Simulation, floating};
use crate::cli::table::{signed, strings, table};
use crate::cradle::Law;
use crate::cradle::contact::Parting;

/// The longest number that a table shows in full, in characters.
const SHOWN: usize = 20;

impl Simulation {
    /// For people: the balls, the two sums, and how far the numbers can be trusted.
    pub(in crate::cli) fn human(&self) -> String {
        let Balls {
            masses,
            before,
            arriving,
        } = &self.balls;
        let count = masses.len();
        let noun = if count == 1 { "ball" } else { "balls" };
        let row = |label: &str, cells: Vec<String>| [vec![label.to_owned()], cells].concat();
        let mut motion = vec![row(
            "ball",
            (1..=count).map(|ball| ball.to_string()).collect(),
        )];
        if !masses.iter().all(One::is_one) {
            motion.push(row("mass", masses.iter().map(shown).collect()));
        }
        motion.push(row("velocity before", strings(before)));
        motion.push(row("velocity after", self.after()));
        let mut sums = vec![row(
            "sum",
            ["before", "after", "after − before"]
                .map(str::to_owned)
                .to_vec(),
        )];
        sums.extend(Law::ALL.map(|law| row(&law.to_string(), self.sum(law).to_vec())));
        let mut page = format!(
            "{count} {noun}, {arriving} coming in at speed 1\n\n{}\n{}\n{}",
            table(&motion),
            table(&sums),
            self.remarks()
        );
        if page.contains('≈') {
            page += "  note: ≈ stands before exact numbers too long to print: `--format json` has them in full\n";
        }
        page
    }

    fn after(&self) -> Vec<String> {
        match &self.end {
            End::Pairwise { after, .. } => after.iter().map(shown).collect(),
            End::Hertz(parting) => {
                let velocities = parting.velocities.iter();
                velocities.map(|v| fixed(v.value)).collect()
            }
        }
    }

    /// Before, after, and the difference.
    fn sum(&self, law: Law) -> [String; 3] {
        let Balls { masses, before, .. } = &self.balls;
        let first = law.quantity(masses, before);
        match &self.end {
            End::Pairwise { after, .. } => {
                let second = law.quantity(masses, after);
                let difference = &second - &first;
                let difference = match shown(&difference) {
                    text if text.starts_with('≈') => text,
                    _ => signed(&difference),
                };
                [shown(&first), shown(&second), difference]
            }
            End::Hertz(parting) => {
                let drift = drift(parting, law);
                let second = floating(&first) + drift;
                [shown(&first), decimal(second), format!("{drift:.0e}")]
            }
        }
    }

    fn remarks(&self) -> String {
        match &self.end {
            End::Pairwise {
                restitution,
                collisions,
                ..
            } => {
                let noun = if *collisions == 1 {
                    "collision"
                } else {
                    "collisions"
                };
                let mut text = format!(
                    "{collisions} {noun}, pair by pair, until no two balls approach. The numbers are exact.\n\n  \
                     note: the balls start an equal distance apart, however small, so that only two meet at once\n"
                );
                if !restitution.is_one() {
                    text += &format!(
                        "  note: with restitution {}, what kinetic energy is missing has become heat and sound\n",
                        shown(restitution)
                    );
                }
                text
            }
            End::Hertz(parting) => {
                let errors = parting.velocities.iter().map(|v| v.error);
                format!(
                    "Numeric: each velocity may be off by {:.0e}. That is an estimate, from integrating twice, the second\n\
                     time with a tolerance a hundred times finer.\n\n  \
                     note: the balls touch from the start and push on one another by Hertz's force, F = k δ^(3/2), with one k\n  \
                     note: k decides nothing here: it sets how long the contacts last\n",
                    errors.fold(0.0, f64::max)
                )
            }
        }
    }

    /// For programs. Exact numbers are strings in lowest terms, numeric ones are JSON's own.
    pub(in crate::cli) fn json(&self) -> Value {
        let Balls { masses, before, .. } = &self.balls;
        let mut value = json!({ "masses": strings(masses), "before": strings(before) });
        let exact = matches!(self.end, End::Pairwise { .. });
        value["exact"] = json!(exact);
        match &self.end {
            End::Pairwise {
                after,
                restitution,
                collisions,
            } => {
                value["model"] = json!("pairwise");
                value["restitution"] = json!(restitution.to_string());
                value["collisions"] = json!(collisions);
                value["after"] = json!(strings(after));
            }
            End::Hertz(parting) => {
                let (velocities, errors): (Vec<f64>, Vec<f64>) = parting
                    .velocities
                    .iter()
                    .map(|v| (v.value, v.error))
                    .unzip();
                value["model"] = json!("hertz");
                value["steps"] = json!(parting.steps);
                value["after"] = json!(velocities);
                value["errors"] = json!(errors);
            }
        }
        for law in Law::ALL {
            let first = law.quantity(masses, before);
            value[law.to_string().replace(' ', "_")] = match &self.end {
                End::Pairwise { after, .. } => {
                    let second = law.quantity(masses, after);
                    json!({ "before": first.to_string(), "after": second.to_string() })
                }
                End::Hertz(parting) => {
                    let second = floating(&first) + drift(parting, law);
                    json!({ "before": first.to_string(), "after": second })
                }
            };
        }
        value
    }
}

fn drift(parting: &Parting, law: Law) -> f64 {
    match law {
        Law::Momentum => parting.momentum_drift,
        Law::KineticEnergy => parting.energy_drift,
    }
}

/// An exact number in full, or if that is too long, nearly.
fn shown(value: &BigRational) -> String {
    let text = value.to_string();
    match text.len() <= SHOWN {
        true => text,
        false => format!("≈{}", decimal(floating(value))),
    }
}

/// Six decimals, which is what a table has room for; very large and very small numbers with a power of ten.
fn decimal(value: f64) -> String {
    match value.abs() {
        0.0 => "0.000000".to_owned(),
        1e-4..1e6 => format!("{value:.6}"),
        _ => format!("{value:.5e}"),
    }
}

/// Six decimals whatever the size: a velocity of less is not told apart from none.
fn fixed(value: f64) -> String {
    let text = format!("{value:.6}");
    match text.strip_prefix('-') {
        Some("0.000000") => "0.000000".to_owned(),
        _ => text,
    }
}
