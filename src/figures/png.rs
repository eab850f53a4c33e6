//! Pictures as PNG, drawn with the outlines of the font that ships inside, on white.

use miniz_oxide::deflate::compress_to_vec_zlib;
use tiny_skia::{
    FillRule, LineJoin, Paint, Path, PathBuilder, Pixmap, Stroke, StrokeDash, Transform,
};
use ttf_parser::OutlineBuilder;

use super::FigureError;
use super::font;
use super::palette::Palette;
use super::scene::{Anchor, Ink, Item, Scene, Segment, Shape, Text};

/// Dots to a point.
const SCALE: f32 = 2.0;
/// Dots to a metre, at 72 points to an inch.
const DENSITY: u32 = 5669;
/// How hard to compress: the next steps cost more time than all of the drawing, and gain a quarter.
const EFFORT: u8 = 1;
/// No picture is larger, in dots.
const LARGEST: f64 = 10_000.0;

/// A picture as a PNG file, two dots to a point.
///
/// # Errors
/// The font has not every character, or the picture is too large.
pub fn png(scene: &Scene) -> Result<Vec<u8>, FigureError> {
    font::covers(scene)?;
    let dots = |length: f64| (length * f64::from(SCALE)).ceil().clamp(1.0, LARGEST) as u32;
    let (width, height) = (dots(scene.width), dots(scene.height));
    let mut pixmap = Pixmap::new(width, height)
        .ok_or_else(|| FigureError::Picture("it is too large".to_owned()))?;
    let [red, green, blue] = Palette::LIGHT.colour(Ink::Paper);
    pixmap.fill(tiny_skia::Color::from_rgba8(red, green, blue, u8::MAX));
    let scale = Transform::from_scale(SCALE, SCALE);
    for item in &scene.items {
        match item {
            Item::Shape(shape) => draw(&mut pixmap, shape, scale),
            Item::Text(text) => write(&mut pixmap, text, scale),
        }
    }
    Ok(encode(&pixmap, &scene.title))
}

fn paint(ink: Ink) -> Paint<'static> {
    let [red, green, blue] = Palette::LIGHT.colour(ink);
    let mut paint = Paint::default();
    paint.set_color_rgba8(red, green, blue, u8::MAX);
    paint.anti_alias = true;
    paint
}

fn draw(pixmap: &mut Pixmap, shape: &Shape, transform: Transform) {
    let mut builder = PathBuilder::new();
    for segment in &shape.path {
        match *segment {
            Segment::Move(x, y) => builder.move_to(x as f32, y as f32),
            Segment::Line(x, y) => builder.line_to(x as f32, y as f32),
            Segment::Cubic(points) => {
                let [a, b, c, d, x, y] = points.map(|point| point as f32);
                builder.cubic_to(a, b, c, d, x, y);
            }
            Segment::Close => builder.close(),
        }
    }
    // A path without extent leaves no trace.
    let Some(path) = builder.finish() else {
        return;
    };
    if let Some(ink) = shape.fill {
        pixmap.fill_path(&path, &paint(ink), FillRule::Winding, transform, None);
    }
    if let Some(own) = shape.stroke {
        let dash = own.dash.iter().map(|&length| length as f32).collect();
        let stroke = Stroke {
            width: own.width as f32,
            line_join: LineJoin::Round,
            dash: StrokeDash::new(dash, 0.0),
            ..Stroke::default()
        };
        pixmap.stroke_path(&path, &paint(own.ink), &stroke, transform, None);
    }
}

/// Collects outlines, whose y axis points up, in the units of the font.
struct Outline(PathBuilder);

impl OutlineBuilder for Outline {
    fn move_to(&mut self, x: f32, y: f32) {
        self.0.move_to(x, -y);
    }
    fn line_to(&mut self, x: f32, y: f32) {
        self.0.line_to(x, -y);
    }
    fn quad_to(&mut self, x1: f32, y1: f32, x: f32, y: f32) {
        self.0.quad_to(x1, -y1, x, -y);
    }
    fn curve_to(&mut self, x1: f32, y1: f32, x2: f32, y2: f32, x: f32, y: f32) {
        self.0.cubic_to(x1, -y1, x2, -y2, x, -y);
    }
    fn close(&mut self) {
        self.0.close();
    }
}

fn write(pixmap: &mut Pixmap, text: &Text, scale: Transform) {
    let paint = paint(text.ink);
    let length = text.content.width() * text.size;
    let mut along = match text.anchor {
        Anchor::Start => 0.0,
        Anchor::Middle => -length / 2.0,
        Anchor::End => -length,
    };
    let mut placed = scale.pre_translate(text.x as f32, text.y as f32);
    if text.upwards {
        placed = placed.pre_concat(Transform::from_rotate(-90.0));
    }
    for run in &text.content.0 {
        along -= run.back * text.size;
        let size = run.level.scale() * text.size;
        let down = run.drop() * text.size;
        for glyph in run.text.chars().filter_map(|c| font::glyph(c, run.italic)) {
            let em = f64::from(font::face(run.italic).units_per_em());
            if let Some(path) = outline(glyph, run.italic) {
                let unit = (size / em) as f32;
                let here = placed
                    .pre_translate(along as f32, down as f32)
                    .pre_scale(unit, unit);
                pixmap.fill_path(&path, &paint, FillRule::Winding, here, None);
            }
            along += font::advance(glyph, run.italic) * size;
        }
    }
}

fn outline(glyph: ttf_parser::GlyphId, italic: bool) -> Option<Path> {
    let mut outline = Outline(PathBuilder::new());
    font::outline(glyph, italic, &mut outline);
    outline.0.finish()
}

/// The file: header, density, title and the dots.
fn encode(pixmap: &Pixmap, title: &str) -> Vec<u8> {
    let mut file = b"\x89PNG\r\n\x1a\n".to_vec();
    let mut header = Vec::new();
    header.extend(pixmap.width().to_be_bytes());
    header.extend(pixmap.height().to_be_bytes());
    // Eight bits; red, green, blue and opacity; the only compression and filtering there are; no interlacing.
    header.extend([8, 6, 0, 0, 0]);
    chunk(&mut file, b"IHDR", &header);
    let density = [DENSITY.to_be_bytes(), DENSITY.to_be_bytes()].concat();
    chunk(&mut file, b"pHYs", &[density.as_slice(), &[1]].concat());
    let title = [b"Title\0\0\0\0\0", title.as_bytes()].concat();
    chunk(&mut file, b"iTXt", &title);
    let row = pixmap.width() as usize * 4;
    let blank = vec![0; row];
    let mut dots = Vec::with_capacity(pixmap.data().len() + pixmap.height() as usize);
    let mut above = blank.as_slice();
    for line in pixmap.data().chunks_exact(row) {
        if line == above {
            // As its difference from the row above.
            dots.push(2);
            dots.extend_from_slice(&blank);
        } else {
            dots.push(0);
            dots.extend_from_slice(line);
        }
        above = line;
    }
    chunk(&mut file, b"IDAT", &compress_to_vec_zlib(&dots, EFFORT));
    chunk(&mut file, b"IEND", &[]);
    file
}

fn chunk(file: &mut Vec<u8>, kind: &[u8; 4], data: &[u8]) {
    let length = u32::try_from(data.len()).unwrap_or(u32::MAX);
    file.extend(length.to_be_bytes());
    let start = file.len();
    file.extend(kind);
    file.extend(data);
    let sum = crc32fast::hash(&file[start..]);
    file.extend(sum.to_be_bytes());
}
