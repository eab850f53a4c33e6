//! How long an audit takes: `cargo bench -p benches`. `docs/performance.md` says what was measured, and how.

mod copies;

use std::hint::black_box;

use cradle_verify::audit::{Audit, Dimensions, Outcome, Verdict};
use cradle_verify::derivation::Derivation;
use cradle_verify::kernel::{Candidate, Claim, check};
use cradle_verify::proofs;
use divan::{Bencher, counter::ItemsCount};

fn main() {
    // A copy that is judged otherwise than the original would measure something else.
    let (one, three) = (counts(1), counts(3));
    let tripled: Vec<usize> = one.iter().map(|count| 3 * count).collect();
    assert_eq!(three, tripled, "copies must be judged like the original");
    divan::main();
}

fn counts(copies: usize) -> Vec<usize> {
    let audit = Audit::of(&Derivation::new(copies::documents(copies)));
    let counts = audit.counts();
    Verdict::ALL.iter().map(|verdict| counts[verdict]).collect()
}

/// The built-in report from its text to its verdicts.
#[divan::bench]
fn report(bencher: Bencher) {
    bencher.bench(|| Audit::of(&proofs::report()));
}

/// Reading alone: text to equations with their premises.
#[divan::bench]
fn report_reading(bencher: Bencher) {
    bencher.bench(proofs::report);
}

/// Dimensions alone: scopes, inference, and the kernel's evidence for what disagrees.
#[divan::bench]
fn report_dimensions(bencher: Bencher) {
    let derivation = proofs::report();
    bencher.bench(|| Dimensions::of(&derivation));
}

/// The kernel alone: every certificate and counterexample of the report checked once more.
#[divan::bench]
fn report_kernel(bencher: Bencher) {
    let evidence = evidence(&Audit::of(&proofs::report()));
    bencher.counter(ItemsCount::new(evidence.len())).bench(|| {
        for (claim, candidate) in &evidence {
            let checked = check(claim.clone(), candidate.clone());
            assert!(black_box(checked).is_ok());
        }
    });
}

/// Sections 1 and 3 of the report so many times over, each copy with symbols and numbers of its own.
#[divan::bench(args = [1, 10, 100], sample_count = 5, sample_size = 1)]
fn copies_of_the_algebra(bencher: Bencher, copies: usize) {
    let derivation = Derivation::new(copies::documents(copies));
    bencher
        .counter(ItemsCount::new(copies))
        .bench(|| Audit::of(&derivation));
}

/// The dimensions of the copies.
#[divan::bench(args = [1, 10, 100], sample_count = 5, sample_size = 1)]
fn dimensions_of_copies(bencher: Bencher, copies: usize) {
    let derivation = Derivation::new(copies::documents(copies));
    bencher.bench(|| Dimensions::of(&derivation));
}

/// Takes half a minute: `cargo bench -p benches -- --ignored thousand`.
#[divan::bench(ignore, sample_count = 1, sample_size = 1)]
fn a_thousand_copies_of_the_algebra(bencher: Bencher) {
    let derivation = Derivation::new(copies::documents(1_000));
    bencher
        .counter(ItemsCount::new(1_000usize))
        .bench(|| Audit::of(&derivation));
}

/// Reading the copies alone.
#[divan::bench(args = [1, 10, 100], sample_count = 5, sample_size = 1)]
fn reading_copies(bencher: Bencher, copies: usize) {
    let documents = copies::documents(copies);
    bencher
        .counter(ItemsCount::new(copies))
        .bench(|| Derivation::new(documents.clone()));
}

fn evidence(audit: &Audit) -> Vec<(Claim, Candidate)> {
    let judged = audit.entries.iter().flat_map(|entry| &entry.judged);
    judged
        .filter_map(|judged| match &judged.outcome {
            Outcome::Proven(proven) => Some((
                proven.claim().clone(),
                Candidate::Proof(proven.certificate().clone()),
            )),
            Outcome::Refuted(refuted) => Some((
                refuted.claim().clone(),
                Candidate::Counterexample(refuted.witness().clone()),
            )),
            // Scaling relations have a kernel function of their own, measured by the whole audit.
            _ => None,
        })
        .collect()
}
