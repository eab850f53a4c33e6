use cradle_verify::algebra::{BigInt, BigRational};
use cradle_verify::audit::Verdict;
use cradle_verify::cradle::{efficiency, elastic, energy_loss};
use cradle_verify::figures::{self, Decay, FigureError, Material, first_half};
use cradle_verify::proofs;
use num_traits::{One, Pow, Zero};

use super::report_with;

fn q(above: i64, below: i64) -> BigRational {
    BigRational::new(BigInt::from(above), BigInt::from(below))
}

#[test]
fn the_collision_is_that_of_the_cradle_as_code() {
    let numbers = figures::collision(&proofs::checker()).unwrap().numbers;
    assert_eq!(numbers.columns, ["mu", "v1/v0", "v2/v0", "eta"]);
    assert!(numbers.rows.len() > 100);
    for row in &numbers.rows {
        let (one, zero) = (BigRational::one(), BigRational::zero());
        let (first, second) = elastic(&one, &row[0], &one, &zero);
        let expected = [row[0].clone(), first, second, efficiency(&row[0])];
        assert_eq!(*row, expected);
    }
    assert!(numbers.rows.iter().any(|row| row[0] == q(5, 1)));
}

#[test]
fn the_lithotripsy_curve_has_each_ratio_with_its_reciprocal() {
    let numbers = figures::lithotripsy(&proofs::checker()).unwrap().numbers;
    let (first, last) = (&numbers.rows[0], numbers.rows.last().unwrap());
    assert_eq!(
        (first[0].clone(), last[0].clone()),
        (q(1, 1000), q(1000, 1))
    );
    for (low, high) in numbers.rows.iter().zip(numbers.rows.iter().rev()) {
        assert_eq!(low[0], high[0].recip());
        assert_eq!(low[1], high[1]);
        assert_eq!(low[1], efficiency(&low[0]));
    }
}

#[test]
fn energies_are_powers_of_the_printed_and_of_the_proved_share() {
    let checker = proofs::checker();
    let materials = Material::of_the_report();
    let numbers = figures::energy(&checker, &materials).unwrap().numbers;
    assert_eq!(numbers.rows.len(), 41);
    for material in &materials {
        let e = material.restitution();
        let column = |law| {
            numbers
                .column(&format!("{} {law}", material.name()))
                .unwrap()
        };
        // Half of it is the energy that the striker brings.
        let (one, zero, half) = (BigRational::one(), BigRational::zero(), q(1, 2));
        let left = &one - energy_loss(&one, &one, &one, &zero, e) / half;
        for (n, (printed, restitution)) in column("printed")
            .into_iter()
            .zip(column("restitution"))
            .enumerate()
        {
            assert_eq!(*printed, Pow::pow(e * e, n));
            assert_eq!(*restitution, Pow::pow(left.clone(), n));
        }
    }
}

#[test]
fn the_materials_are_those_of_the_page() {
    let page = proofs::page("proofs/report/4.2-energy-decay.md").unwrap();
    let rows = page.lines().filter(|line| line.starts_with("| "));
    let printed: Vec<(String, BigRational)> = rows
        .filter_map(|row| {
            let cells: Vec<&str> = row.split('|').map(str::trim).collect();
            let value = cradle_verify::cradle::parse_exact(cells[2]).ok()?;
            Some((cells[1].to_owned(), value))
        })
        .collect();
    let own = Material::of_the_report().into_iter();
    let own: Vec<_> = own
        .map(|m| (m.name().to_owned(), m.restitution().clone()))
        .collect();
    assert_eq!(own, printed);
}

/// Both powers multiplied out, in whole numbers.
fn is_first(share: &BigRational, n: u32) -> bool {
    let halved =
        |n: u32| BigInt::from(2) * Pow::pow(share.numer(), n) <= Pow::pow(share.denom(), n);
    halved(n) && (n == 0 || !halved(n - 1))
}

#[test]
fn halving_is_first_in_whole_numbers() {
    for below in 1..60 {
        for above in 0..below {
            let share = q(above, below);
            let found = first_half(&share).unwrap();
            let found = u32::try_from(found).unwrap();
            assert!(is_first(&share, found), "{share}: {found}");
        }
        assert_eq!(first_half(&q(below, below)), None);
        assert_eq!(first_half(&q(below + 1, below)), None);
    }
    for material in Material::of_the_report() {
        let decay = Decay::of(&proofs::checker()).unwrap();
        for law in decay.laws() {
            let found = Decay::halving(law, &material).unwrap().unwrap();
            let share = figures::share(law, &material).unwrap();
            assert!(is_first(&share, u32::try_from(found).unwrap()));
        }
    }
}

#[test]
fn halving_next_to_one_is_not_counted_out() {
    let ten_to = |nines: u32| Pow::pow(BigInt::from(10), nines);
    let next_to_one = |nines| BigRational::new(ten_to(nines) - 1, ten_to(nines));
    for nines in [2, 3, 4] {
        let found = first_half(&next_to_one(nines)).unwrap();
        assert!(is_first(&next_to_one(nines), u32::try_from(found).unwrap()));
    }
    // With sixty nines it is the whole number above ln 2 · (10⁶⁰ − 1/2), nearly.
    let digits = first_half(&next_to_one(60)).unwrap().to_string();
    assert!(
        digits.len() == 60 && digits.starts_with("693147180559945309417232"),
        "{digits}"
    );
}

#[test]
fn outcomes_conserve_momentum_and_energy_and_the_witnesses_are_among_them() {
    let figure = figures::outcomes(&proofs::checker()).unwrap();
    for row in &figure.numbers.rows {
        assert_eq!(row.iter().sum::<BigRational>(), BigRational::one());
        assert_eq!(
            row.iter().map(|v| v * v).sum::<BigRational>(),
            BigRational::one()
        );
    }
    let has = |wanted: [BigRational; 3]| figure.numbers.rows.contains(&wanted.to_vec());
    assert!(has([q(0, 1), q(0, 1), q(1, 1)]));
    assert!(has([q(-1, 3), q(2, 3), q(2, 3)]));
    let svg = figures::svg(&figure.scene);
    assert!(svg.contains("counterexample to (23)"), "{svg}");
}

#[test]
fn a_figure_draws_what_the_page_says() {
    let wrong = r"v'_1 = \frac{2 - \mu}{1 + \mu} v_0 \tag{59}";
    let checker = report_with("3.5", r"v'_1 = \frac{1 - \mu}{1 + \mu} v_0 \tag{59}", wrong);
    let figure = figures::collision(&checker).unwrap();
    let row = figure
        .numbers
        .rows
        .iter()
        .find(|row| row[0] == q(1, 1))
        .unwrap();
    assert_eq!(row[1], q(1, 2));
    assert_eq!(figure.sources[0].standing.verdict, Verdict::Fails);
    assert!(
        figure.scene.description.contains("(59) fails"),
        "{}",
        figure.scene.description
    );
}

#[test]
fn a_law_that_holds_has_nothing_in_its_place() {
    let right = r"E_{\text{after}} = \frac{1 + e^2}{2} E_0. \tag{41}";
    let checker = report_with("2.5", r"E_{\text{after}} = e^2 E_0. \tag{41}", right);
    let decay = Decay::of(&checker).unwrap();
    assert_eq!(decay.printed.standing.verdict, Verdict::Holds);
    assert!(decay.corrected.is_none());
    let figure = figures::energy(&checker, &Material::of_the_report()).unwrap();
    assert_eq!(figure.numbers.columns.len(), 5);
    assert!(!figure.scene.description.contains("Dashed:"));
}

#[test]
fn what_is_no_share_of_the_energy_is_refused() {
    let more = r"E_{\text{after}} = 2 E_0. \tag{41}";
    let checker = report_with("2.5", r"E_{\text{after}} = e^2 E_0. \tag{41}", more);
    let refused = figures::energy(&checker, &Material::of_the_report());
    assert!(matches!(refused, Err(FigureError::NoShare(_))));
    let gone = report_with("3.5", r"\tag{60}", r"\tag{61a}");
    let refused = figures::collision(&gone);
    assert!(matches!(refused, Err(FigureError::NoEquation(label)) if label == "60"));
}
