use super::FigureError;
use super::collision::{float, points};
use super::figure::{Figure, Paper, Source, caption, heading, verdicts};
use super::law::{Audited, Law, Standing};
use super::numbers::Numbers;
use super::panel::{Marker, Panel, Range, shares};
use super::rich::Rich;
use super::scene::{Anchor, Ink, Scene, Stroke};
use super::words::exact;
use crate::algebra::{BigInt, BigRational};
use crate::derivation::{Checker, Point};
use crate::parallel::in_order;

/// So many powers of ten to either side of equal masses.
const DECADES: i32 = 3;
/// The impedances of kidney stones in units of that of tissue: the lowest and the highest, roughly.
const STONES: [i64; 2] = [2, 6];
/// Points to a power of ten.
const FINE: i32 = 40;

/// The share of the energy that a struck ball takes, over six powers of ten of the mass ratio.
///
/// It belongs to the report's comparison of a cradle with a shock wave that reaches a kidney stone. The term is that of
/// (64); what is said of the maximum and of very heavy targets is what the audit finds of the claims about them, and
/// at 0 the term is evaluated.
///
/// A wave of sound that meets another medium at a right angle leaves there the same share of its energy, with the ratio of the
/// acoustic impedances for that of the masses: Kinsler et al., *Fundamentals of Acoustics*, 4th ed., § 6.2. Kidney
/// stones have some two to six times the impedance of the tissue around them.
///
/// # Errors
/// The derivation has not these equations.
pub fn lithotripsy(checker: &Checker) -> Result<Figure, FigureError> {
    let efficiency = "64";
    let claims =
        ["maximum", "maximum-only-at-one", "heavy-target"].map(|name| format!("claim {name}"));
    let labels: Vec<&str> = std::iter::once(efficiency)
        .chain(claims.iter().map(String::as_str))
        .collect();
    let audited = Audited::of(checker, &labels)?;
    let law = Law::of(&audited, efficiency, r"\eta")?;
    let eta = |mu: &BigRational| law.value(&Point::new().with_ratio(r"\mu", mu.clone()));
    let mut numbers = Numbers::new(&["mu", "eta"]);
    let rows = in_order(-DECADES * FINE..=DECADES * FINE, |step| {
        // The exponent only chooses a rational number; a ratio and its reciprocal are both there.
        let size = 10_f64.powf(f64::from(step.abs()) / f64::from(FINE));
        let ten_thousandths = (size * 10_000.0).round() as i64;
        let above = BigRational::new(BigInt::from(ten_thousandths), BigInt::from(10_000));
        let mu = if step < 0 { above.recip() } else { above };
        let share = eta(&mu)?;
        Ok(vec![mu, share])
    });
    numbers.rows = rows.into_iter().collect::<Result<_, FigureError>>()?;
    let mut marks = Vec::new();
    let whole = |mu: i64| BigRational::from_integer(BigInt::from(mu));
    for mu in std::iter::once(1).chain(STONES) {
        let mu = whole(mu);
        let share = eta(&mu)?;
        marks.push((mu, share));
    }
    let at_zero = eta(&whole(0))?;
    let mut sources = vec![Source::from(&law)];
    for claim in &claims {
        sources.push(Standing::of(&audited, claim)?.into());
    }
    let scene = draw(Paper::Wide, &numbers, &marks, &at_zero, &sources);
    let narrow = draw(Paper::Narrow, &numbers, &marks, &at_zero, &sources);
    Ok(Figure {
        scene,
        narrow,
        numbers,
        sources,
    })
}

fn draw(
    paper: Paper,
    numbers: &Numbers,
    marks: &[(BigRational, BigRational)],
    at_zero: &BigRational,
    sources: &[Source],
) -> Scene {
    let mut scene = paper.scene("lithotripsy");
    scene.title = "How much of the energy gets across, over six powers of ten".into();
    scene.description = "One curve, symmetric like a bell on the logarithmic axis: the efficiency η against the mass \
        ratio μ from 1/1000 to 1000, with its maximum at μ = 1."
        .into();
    let title =
        Rich::words("From the cradle to the kidney stone: how much of the energy gets across");
    let more = heading(&mut scene, 66.0, &title);
    let panel = Panel {
        left: 66.0,
        top: 48.0 + more,
        right: paper.pick(694.0, 382.0),
        bottom: 340.0 + more,
        x: Range::logarithmic(1e-3, 1e3),
        y: Range::linear(0.0, 1.15),
    };
    let x_ticks = [
        (1e-3, "10⁻³"),
        (1e-2, "10⁻²"),
        (1e-1, "10⁻¹"),
        (1.0, "1"),
        (1e1, "10"),
        (1e2, "10²"),
        (1e3, "10³"),
    ];
    let y_ticks = shares(panel.y);
    panel.grid(&mut scene, &x_ticks, &y_ticks);
    let limit = Stroke {
        dash: &[3.0, 3.0],
        ..Stroke::solid(Ink::Faint, 1.2)
    };
    panel.across(&mut scene, 1.0, limit);
    panel.upright(&mut scene, 1.0, limit);
    let ratio = paper.pick(
        "Mass of the target in units of the striker’s, ",
        "Mass ratio ",
    );
    let ratio = Rich::words(ratio).math("μ = m₂/m₁");
    let digits = (-DECADES..DECADES).flat_map(|decade| (2..10).map(move |n| (decade, n)));
    let between: Vec<f64> = digits
        .map(|(decade, n)| f64::from(n) * 10_f64.powi(decade))
        .collect();
    panel.below(&mut scene, &x_ticks, &between, ratio);
    let share = Rich::words("Energy transfer efficiency ").math("η");
    panel.at_left(&mut scene, &y_ticks, Ink::Text, share);
    let ink = Ink::Series(1);
    panel.curve(&mut scene, &points(numbers, 0, 1), Stroke::solid(ink, 2.4));
    for (mu, share) in marks {
        let place = panel.at((float(mu), float(share)));
        Marker::Diamond.draw(&mut scene, place, 4.0, ink, false);
        let label = Rich::formula(&format!("μ = {mu}, η = {}", exact(share)));
        let beside = (place.0 + 10.0, place.1 - 7.0);
        scene.inked(beside, Anchor::Start, 12.0, ink, label);
    }
    let upper = (panel.left + 8.0, panel.y_at(1.0) - 6.0);
    let bound = Rich::formula("η ≤ 1").and(paper.pick(", reached by equal masses alone", ""));
    scene.inked(upper, Anchor::Start, 11.5, Ink::Faint, bound);
    let far = Rich::formula("η → 0").and(" as ").math("μ → ∞");
    let near = Rich::formula(&format!("η → {}", exact(at_zero)));
    let near = near.and(" as ").math("μ → 0");
    for (x, anchor, limit) in [
        (panel.right - 8.0, Anchor::End, far),
        (panel.left + 8.0, Anchor::Start, near),
    ] {
        scene.inked(
            (x, panel.y_at(paper.pick(0.06, 0.3))),
            anchor,
            11.5,
            Ink::Faint,
            limit,
        );
    }
    caption(
        &mut scene,
        panel.bottom + 66.0,
        24.0,
        &words(marks, at_zero).and(&verdicts(sources)),
    );
    scene
}

/// What the curve is, and where on it kidney stones are.
fn words(marks: &[(BigRational, BigRational)], at_zero: &BigRational) -> Rich {
    let mut words = Rich::words("The curve is (64). For a wave of sound ")
        .math("μ")
        .and(" is the ratio of the acoustic impedances; kidney stones lie roughly");
    for (at, (mu, share)) in marks.iter().skip(1).enumerate() {
        let (before, curve) = match at {
            0 => (" between ", "the curve"),
            _ => (" and ", "it"),
        };
        words = words
            .and(before)
            .math(&format!("μ = {mu}"))
            .and(&format!(", where {curve} is at "))
            .math(&exact(share));
        words = words.and(if at == 0 { "," } else { ". " });
    }
    words
        .and("At ")
        .math("μ = 0")
        .and(" it is at ")
        .math(&exact(at_zero))
        .and(". ")
}
