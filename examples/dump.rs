//! Dump.
use cradle_verify::{audit::*, derivation::*, document::Document};
fn main() {
    let mut paths: Vec<_> = std::env::args().skip(1).collect();
    if paths.is_empty() {
        paths = std::fs::read_dir("proofs/report")
            .unwrap()
            .map(|e| e.unwrap().path().display().to_string())
            .collect();
        paths.sort();
    }
    let docs = paths
        .iter()
        .map(|p| Document::markdown(p.clone(), std::fs::read_to_string(p).unwrap()))
        .collect();
    let t = std::time::Instant::now();
    let d = Derivation::new(docs);
    let parse = t.elapsed();
    let t = std::time::Instant::now();
    let a = Audit::of(&d);
    let el = t.elapsed();
    for p in &d.pages {
        for q in &p.problems {
            println!(
                "PROBLEM {} {:?}: {} {:?}",
                p.document.path,
                p.document.position(q.span.start),
                q.message,
                p.document.text(q.span)
            );
        }
    }
    for e in &a.entries {
        let eq = &d.equations[e.equation];
        let prem: Vec<_> = e
            .premises
            .iter()
            .map(|&p| d.equations[p].reference())
            .collect();
        println!(
            "{:<28} {}/{} {:<8} {:<10} from {} {}",
            eq.reference(),
            e.part + 1,
            e.parts,
            e.kind.word(),
            e.verdict.word(),
            prem.join(" "),
            if e.is_finding() { "FINDING" } else { "" }
        );
        for n in &e.notes {
            println!("      note {} {:?}", n.code(), n);
        }
        if let Some((j, r)) = e.refuted() {
            println!(
                "      {} | {:?}",
                cradle_verify::notation::plain_formula(&j.goal.formula),
                r.witness()
            );
        }
        for j in &e.judged {
            if let Outcome::Open(s) = &j.outcome {
                println!(
                    "      open: {:?} {}",
                    s,
                    cradle_verify::notation::plain_formula(&j.goal.formula)
                );
            }
        }
    }
    println!("{:?}", a.counts());
    println!("parse {parse:?} audit {el:?}");
}
