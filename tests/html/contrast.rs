//! Text is told from its ground, light and dark: the ratio of WCAG 2, from the colours of the page's own style.

use std::collections::BTreeMap;

use super::page_of;

/// The custom properties that are colours, in the order of the style: light, then dark.
fn palettes(page: &str) -> Vec<BTreeMap<&str, [f64; 3]>> {
    let blocks = page
        .split(":root {")
        .skip(1)
        .map(|rest| rest.split('}').next().unwrap());
    let colour = |text: &str| -> Option<[f64; 3]> {
        let hex = text.trim().strip_prefix('#').filter(|hex| hex.len() == 6)?;
        let part = |at: usize| {
            u8::from_str_radix(&hex[at..at + 2], 16)
                .ok()
                .map(|v| f64::from(v) / 255.0)
        };
        Some([part(0)?, part(2)?, part(4)?])
    };
    blocks
        .map(|block| {
            let pairs = block
                .split(';')
                .filter_map(|line| line.trim().strip_prefix("--")?.split_once(':'));
            pairs
                .filter_map(|(name, value)| Some((name, colour(value)?)))
                .collect()
        })
        .collect()
}

fn luminance(colour: [f64; 3]) -> f64 {
    let linear = |c: f64| match c <= 0.040_45 {
        true => c / 12.92,
        false => ((c + 0.055) / 1.055).powf(2.4),
    };
    let [red, green, blue] = colour.map(linear);
    0.2126 * red + 0.7152 * green + 0.0722 * blue
}

fn contrast(one: [f64; 3], other: [f64; 3]) -> f64 {
    let (one, other) = (luminance(one), luminance(other));
    (one.max(other) + 0.05) / (one.min(other) + 0.05)
}

#[test]
fn the_formula_is_that_of_the_guidelines() {
    assert!((contrast([0.0; 3], [1.0; 3]) - 21.0).abs() < 1e-9);
    let grey = [f64::from(0x77_u8) / 255.0; 3];
    assert!((contrast(grey, [1.0; 3]) - 4.478).abs() < 0.001);
}

#[test]
fn every_text_has_contrast_enough_on_every_ground_it_stands_on() {
    let page = page_of(&[]);
    let palettes = palettes(&page);
    assert_eq!(palettes.len(), 2);
    let inks: &[(&str, &[&str])] = &[
        (
            "ink",
            &["paper", "card", "good-fill", "bad-fill", "warn-fill"],
        ),
        ("soft", &["paper", "card"]),
        ("link", &["paper", "card"]),
        ("good", &["paper", "card"]),
        ("bad", &["paper", "card", "bad-fill"]),
        ("warn", &["paper", "card", "warn-fill"]),
    ];
    for palette in &palettes {
        for (ink, grounds) in inks {
            for ground in *grounds {
                let ratio = contrast(palette[ink], palette[ground]);
                assert!(ratio >= 4.5, "{ink} on {ground}: {ratio:.2}");
            }
        }
    }
}
