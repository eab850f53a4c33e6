//! Right physics with a slip of the pen, and what is proposed in its place: `repairs.md` is to be read.

use cradle_verify::audit::{Audit, Verdict};
use cradle_verify::derivation::Derivation;
use cradle_verify::notation::latex_formula;
use cradle_verify::report::Report;

/// What is proposed for the one failing equation of a section.
fn proposed(section: &str) -> Result<String, String> {
    let derivation = Derivation::from_markdown("repairs.md", section);
    let audit = Audit::of(&derivation);
    let wrong: Vec<_> = audit.entries.iter().filter(|e| e.is_wrong()).collect();
    let [entry] = wrong[..] else {
        let report = Report {
            derivation: &derivation,
            audit: &audit,
            paths: &[],
        };
        return Err(anstream::adapter::strip_str(&report.lines(true)).to_string());
    };
    if entry.verdict != Verdict::Fails {
        return Err(format!("{:?}", entry.verdict));
    }
    if !entry.missing.is_empty() {
        let missing: Vec<String> = entry.missing.iter().map(latex_formula).collect();
        return Ok(format!("missing: {}", missing.join(", ")));
    }
    let mended = entry.mended.iter().map(|m| &m.proven);
    let mut found = mended.chain(entry.implied.iter().map(|i| &i.proven));
    let formula = found.next().map(|p| latex_formula(&p.claim().goal));
    Ok(formula.unwrap_or_else(|| "none".into()))
}

#[test]
fn each_slip_is_undone() {
    let text = include_str!("repairs.md");
    let mut faults = String::new();
    let mut right = 0;
    for section in text.split("\n## ").skip(1) {
        let title = section.lines().next().unwrap_or_default();
        let comment = ["<!-- repair: ", "<!-- missing: "]
            .into_iter()
            .find(|comment| section.contains(comment))
            .expect(title);
        let start = match comment.contains("missing") {
            true => section.find(comment).expect(title) + "<!-- ".len(),
            false => section.find(comment).expect(title) + comment.len(),
        };
        let length = section[start..].find(" -->").expect(title);
        let wanted = &section[start..start + length];
        match proposed(section) {
            Ok(found) if found == wanted => right += 1,
            Ok(found) => faults += &format!("{title}\n    wanted  {wanted}\n    found   {found}\n"),
            Err(lines) => faults += &format!("{title}\n{lines}\n"),
        }
    }
    assert!(faults.is_empty(), "{faults}");
    assert!(right >= 20, "{right}");
}

#[test]
fn many_wrong_equations_are_mended_in_time() {
    let mut page = String::from(
        "<!-- check: law -->\n$$ v = u + a t \\tag{1} $$\n<!-- check: law -->\n$$ s = u t + \\frac12 a t^2 \\tag{2} $$\n",
    );
    for at in 3..103 {
        page += &format!(
            "By (1) and (2):\n$$ v^2 = u^2 + {at} a s + b c d - \\frac{{x y z}}{{1 + p q}} + (m + n)^3 \\tag{{{at}}} $$\n"
        );
    }
    let start = std::time::Instant::now();
    let audit = Audit::of(&Derivation::from_markdown("page.md", &page));
    assert!(
        audit
            .entries
            .iter()
            .skip(2)
            .all(|e| e.verdict == Verdict::Fails)
    );
    assert!(
        start.elapsed() < std::time::Duration::from_secs(20),
        "{:?}",
        start.elapsed()
    );
}
