//! The font that ships inside: parts of DejaVu Sans, upright and oblique.
//!
//! Every picture is laid out with its widths, PDF embeds it, PNG is drawn with its outlines. SVG names it and leaves
//! the letters to the viewer's own fonts, most of which are narrower. `fonts/LICENSE` is its licence.

use std::sync::OnceLock;

use ttf_parser::{Face, GlyphId, OutlineBuilder};

use super::FigureError;
use super::scene::{Item, Scene};

/// The file of the upright font.
pub(super) const UPRIGHT: &[u8] = include_bytes!("fonts/sans.ttf");
/// The file of the oblique font.
pub(super) const OBLIQUE: &[u8] = include_bytes!("fonts/oblique.ttf");
/// What stands for a character that the font has not, in ems.
const UNKNOWN: f64 = 0.6;

/// The font for a piece of text.
pub(super) fn face(italic: bool) -> &'static Face<'static> {
    static FACES: OnceLock<[Face<'static>; 2]> = OnceLock::new();
    let read = |file| Face::parse(file, 0).expect("the font that ships inside is one");
    &FACES.get_or_init(|| [read(UPRIGHT), read(OBLIQUE)])[usize::from(italic)]
}

/// The glyph of a character.
pub(super) fn glyph(character: char, italic: bool) -> Option<GlyphId> {
    face(italic).glyph_index(character)
}

/// The width of a glyph in ems.
pub(super) fn advance(glyph: GlyphId, italic: bool) -> f64 {
    let face = face(italic);
    let units = face.glyph_hor_advance(glyph).unwrap_or_default();
    f64::from(units) / f64::from(face.units_per_em())
}

/// The outline of a glyph.
pub(super) fn outline(glyph: GlyphId, italic: bool, to: &mut dyn OutlineBuilder) {
    // A space has none.
    let _ = face(italic).outline_glyph(glyph, to);
}

/// The width of a text in ems.
pub(super) fn width(text: &str, italic: bool) -> f64 {
    let of = |character| glyph(character, italic).map_or(UNKNOWN, |glyph| advance(glyph, italic));
    text.chars().map(of).sum()
}

/// That the font has every character of a picture.
///
/// # Errors
/// The first that it has not.
pub(super) fn covers(scene: &Scene) -> Result<(), FigureError> {
    let texts = scene.items.iter().filter_map(|item| match item {
        Item::Text(text) => Some(text),
        Item::Shape(_) => None,
    });
    for run in texts.flat_map(|text| &text.content.0) {
        let missing = run.text.chars().find(|&c| glyph(c, run.italic).is_none());
        if let Some(character) = missing {
            return Err(FigureError::NoGlyph(character));
        }
    }
    Ok(())
}
