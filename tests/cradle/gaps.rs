//! Lines of balls with gaps: when who meets whom, and lines that never end.

use cradle_verify::cradle::{Chain, ChainError, Limits, Line};
use cradle_verify::cradle::{list_text, parse_exact, parse_list};

fn line(masses: &str, velocities: &str, e: &str) -> Line {
    let list = |text| parse_list(text).unwrap();
    Line::new(Chain::new(list(masses), list(velocities), parse_exact(e).unwrap()).unwrap())
}

fn story(line: &mut Line) -> Vec<(String, usize)> {
    let events = line.settle(Limits::USUAL).unwrap();
    let told = events
        .iter()
        .map(|e| (e.time.to_string(), e.encounter.left));
    told.collect()
}

fn told(events: &[(&str, usize)]) -> Vec<(String, usize)> {
    events
        .iter()
        .map(|(time, left)| ((*time).to_owned(), *left))
        .collect()
}

#[test]
fn a_pulse_passes_a_gap_in_each_unit_of_time() {
    let mut cradle = line("1, 1, 1, 1", "1, 1, 0, 0", "1");
    let expected = told(&[("1", 1), ("2", 0), ("2", 2), ("3", 1)]);
    assert_eq!(story(&mut cradle), expected);
    assert_eq!(list_text(cradle.velocities()), "(0, 0, 1, 1)");
}

#[test]
fn what_follows_slowly_comes_after_the_pulse_has_passed() {
    // The leftmost pair approaches again before the pulse is through, yet is a long way from meeting.
    let mut cradle = line("1, 1, 1, 1", "1, 0, 0, 0", "9/10");
    let lefts: Vec<usize> = story(&mut cradle).iter().map(|event| event.1).collect();
    assert_eq!(lefts[..3], [0, 1, 2]);
    assert!(lefts.len() > 3);
}

#[test]
fn three_balls_that_stick_meet_for_ever() {
    let mut sticky = line("1, 1, 1", "1, 0, 0", "0");
    let limits = Limits {
        collisions: 50,
        bits: 10_000,
    };
    assert_eq!(
        sticky.settle(limits),
        Err(ChainError::TooManyCollisions(50))
    );
    let few = Limits { bits: 32, ..limits };
    assert!(matches!(
        line("1, 1, 1", "1, 0, 0", "0").settle(few),
        Err(ChainError::NumbersTooLong { bits: 32, .. })
    ));
}

#[test]
fn a_ball_alone_meets_nobody() {
    assert_eq!(line("1", "1", "1").settle(Limits::USUAL), Ok(vec![]));
}
