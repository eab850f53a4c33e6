//! Legends: what each line and marker stands for.

use super::panel::Marker;
use super::rich::Rich;
use super::scene::{Anchor, Ink, Scene, Stroke};

/// The size of the text.
const SIZE: f64 = 12.0;
/// From one row to the next.
const ROW: f64 = 19.0;
/// The length of a line's sample.
const SAMPLE: f64 = 46.0;
/// Between a sample and its text.
const GAP: f64 = 8.0;

/// A row of a legend.
pub(super) struct Key {
    /// A piece of the line.
    pub stroke: Option<Stroke>,
    /// A marker, open or not.
    pub marker: Option<(Marker, Ink, bool)>,
    /// What they stand for; a row without line and marker is a heading.
    pub label: Rich,
}

impl Key {
    pub(super) fn heading(text: &str) -> Key {
        Key {
            stroke: None,
            marker: None,
            label: Rich::words(text),
        }
    }

    fn is_heading(&self) -> bool {
        self.stroke.is_none() && self.marker.is_none()
    }
}

/// The width of a legend.
pub(super) fn width(keys: &[Key]) -> f64 {
    let own = |key: &Key| {
        let sample = if key.is_heading() { 0.0 } else { SAMPLE + GAP };
        sample + key.label.width() * SIZE
    };
    keys.iter().map(own).fold(0.0, f64::max)
}

/// The height of a legend.
pub(super) fn height(keys: &[Key]) -> f64 {
    keys.len() as f64 * ROW
}

/// Draws a legend, its corner at the top left, on paper of its own.
pub(super) fn draw(scene: &mut Scene, (x, y): (f64, f64), keys: &[Key]) {
    scene.clear(x - 8.0, y - 4.0, x + width(keys) + 8.0, y + height(keys));
    for (at, key) in keys.iter().enumerate() {
        let baseline = y + at as f64 * ROW + SIZE;
        let middle = baseline - 0.34 * SIZE;
        if key.is_heading() {
            let label = key.label.clone();
            scene.inked((x, baseline), Anchor::Start, SIZE, Ink::Faint, label);
            continue;
        }
        if let Some(stroke) = key.stroke {
            scene.line(&[(x, middle), (x + SAMPLE, middle)], stroke);
        }
        if let Some((marker, ink, open)) = key.marker {
            marker.draw(scene, (x + SAMPLE / 2.0, middle), 3.6, ink, open);
        }
        scene.text(
            (x + SAMPLE + GAP, baseline),
            Anchor::Start,
            SIZE,
            key.label.clone(),
        );
    }
}
