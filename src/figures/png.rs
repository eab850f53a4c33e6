//! Pictures as PNG, drawn with the outlines of the font that ships inside, on white.
//!
//! What is drawn becomes paths in dots, all of them filled. Bands of rows are drawn and compressed several at a time: a band stays
//! in the processor's cache, and what comes out is the same however many work.

use miniz_oxide::deflate::core::deflate_flags::TDEFL_COMPUTE_ADLER32;
use miniz_oxide::deflate::core::{
    CompressorOxide, TDEFLFlush, compress_to_output, create_comp_flags_from_zip_params,
};
use tiny_skia::{
    FillRule, LineJoin, Paint, Path, PathBuilder, Pixmap, Stroke, StrokeDash, Transform,
};
use ttf_parser::OutlineBuilder;

use super::FigureError;
use super::font;
use super::palette::Palette;
use super::scene::{Anchor, Ink, Item, Scene, Segment, Shape, Text};
use crate::parallel::in_order;

/// Dots to a point.
const SCALE: f32 = 2.0;
/// Dots to a metre, at 72 points to an inch.
const DENSITY: u32 = 5669;
/// How hard to compress: the next steps cost more time than all of the drawing, and gain a quarter.
const EFFORT: i32 = 1;
/// No picture is larger, in dots.
const LARGEST: f64 = 10_000.0;
/// Rows of a band.
const BAND: u32 = 64;

/// A picture as a PNG file, two dots to a point.
///
/// # Errors
/// The font has not every character, or the picture is too large.
pub fn png(scene: &Scene) -> Result<Vec<u8>, FigureError> {
    font::covers(scene)?;
    let dots = |length: f64| (length * f64::from(SCALE)).ceil().clamp(1.0, LARGEST) as u32;
    let (width, height) = (dots(scene.width), dots(scene.height));
    let areas: Vec<Area> = scene.items.iter().flat_map(Area::of).collect();
    let bands = (0..height).step_by(BAND as usize);
    let drawn = in_order(bands, |top| {
        Band::drawn(&areas, top, width, BAND.min(height - top))
    });
    let too_large = || FigureError::Picture("it is too large".to_owned());
    let bands: Option<Vec<Band>> = drawn.into_iter().collect();
    Ok(file(
        (width, height),
        &scene.title,
        &bands.ok_or_else(too_large)?,
    ))
}

/// What is covered with one colour: a path in dots.
struct Area {
    path: Path,
    ink: Ink,
}

impl Area {
    fn of(item: &Item) -> Vec<Area> {
        match item {
            Item::Shape(shape) => Area::of_shape(shape),
            Item::Text(text) => Area::of_text(text).into_iter().collect(),
        }
    }

    fn of_shape(shape: &Shape) -> Vec<Area> {
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
            return Vec::new();
        };
        let stroked = shape.stroke.and_then(|own| {
            let dash = own.dash.iter().map(|&length| length as f32).collect();
            let stroke = Stroke {
                width: own.width as f32,
                line_join: LineJoin::Round,
                ..Stroke::default()
            };
            let outline = match StrokeDash::new(dash, 0.0) {
                Some(dash) => path.dash(&dash, SCALE)?.stroke(&stroke, SCALE),
                None => path.stroke(&stroke, SCALE),
            };
            Some((outline?, own.ink))
        });
        let filled = shape.fill.map(|ink| (path, ink));
        let scale = Transform::from_scale(SCALE, SCALE);
        let in_dots = |(path, ink): (Path, Ink)| {
            let path = path.transform(scale)?;
            Some(Area { path, ink })
        };
        filled
            .into_iter()
            .chain(stroked)
            .filter_map(in_dots)
            .collect()
    }

    fn of_text(text: &Text) -> Option<Area> {
        let length = text.content.width() * text.size;
        let mut along = match text.anchor {
            Anchor::Start => 0.0,
            Anchor::Middle => -length / 2.0,
            Anchor::End => -length,
        };
        let mut placed =
            Transform::from_scale(SCALE, SCALE).pre_translate(text.x as f32, text.y as f32);
        if text.upwards {
            placed = placed.pre_concat(Transform::from_rotate(-90.0));
        }
        let mut line = PathBuilder::new();
        for run in &text.content.0 {
            along -= run.back * text.size;
            let size = run.level.scale() * text.size;
            let down = run.drop() * text.size;
            for glyph in run.text.chars().filter_map(|c| font::glyph(c, run.italic)) {
                let em = f64::from(font::face(run.italic).units_per_em());
                let unit = (size / em) as f32;
                let here = placed
                    .pre_translate(along as f32, down as f32)
                    .pre_scale(unit, unit);
                let path = outline(glyph, run.italic).and_then(|path| path.transform(here));
                if let Some(path) = path {
                    line.push_path(&path);
                }
                along += font::advance(glyph, run.italic) * size;
            }
        }
        let path = line.finish()?;
        let ink = text.ink;
        Some(Area { path, ink })
    }

    fn reaches(&self, top: u32, bottom: u32) -> bool {
        let bounds = self.path.bounds();
        bounds.top() < bottom as f32 && bounds.bottom() > top as f32
    }
}

fn colour(ink: Ink) -> tiny_skia::Color {
    let [red, green, blue] = Palette::LIGHT.colour(ink);
    tiny_skia::Color::from_rgba8(red, green, blue, u8::MAX)
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

fn outline(glyph: ttf_parser::GlyphId, italic: bool) -> Option<Path> {
    let mut outline = Outline(PathBuilder::new());
    font::outline(glyph, italic, &mut outline);
    outline.0.finish()
}

/// Some rows, drawn and compressed.
struct Band {
    /// Blocks of a `deflate` stream, to the last bit of a byte.
    compressed: Vec<u8>,
    sum: Adler,
}

impl Band {
    /// `None` if the rows are too long.
    fn drawn(areas: &[Area], top: u32, width: u32, height: u32) -> Option<Self> {
        let mut pixmap = Pixmap::new(width, height)?;
        pixmap.fill(colour(Ink::Paper));
        let up = Transform::from_translate(0.0, -(top as f32));
        for area in areas {
            if area.reaches(top, top + height) {
                let mut paint = Paint::default();
                paint.set_color(colour(area.ink));
                pixmap.fill_path(&area.path, &paint, FillRule::Winding, up, None);
            }
        }
        Some(Band::compressed(&pixmap))
    }

    fn compressed(pixmap: &Pixmap) -> Self {
        let row = pixmap.width() as usize * 4;
        let blank = vec![0; row];
        let mut dots = Vec::with_capacity(pixmap.data().len() + pixmap.height() as usize);
        let mut above: &[u8] = &[];
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
        // Below 0: without the header and the end that a stream has once.
        let flags = create_comp_flags_from_zip_params(EFFORT, -1, 0) | TDEFL_COMPUTE_ADLER32;
        let mut compressor = CompressorOxide::new(flags);
        let mut compressed = Vec::new();
        compress_to_output(&mut compressor, &dots, TDEFLFlush::Sync, |out| {
            compressed.extend_from_slice(out);
            true
        });
        Band {
            compressed,
            sum: Adler {
                sum: compressor.adler32(),
                length: dots.len(),
            },
        }
    }
}

/// The checksum Adler-32 of so many bytes (RFC 1950): 1 and the sum of all, and the sum of what that was after each.
#[derive(Clone, Copy)]
struct Adler {
    sum: u32,
    length: usize,
}

impl Adler {
    const MODULUS: u64 = 65_521;
    const OF_NOTHING: Adler = Adler { sum: 1, length: 0 };

    /// That of these bytes and others after them.
    fn then(self, next: Adler) -> Adler {
        let parts = |sum: u32| (u64::from(sum & 0xffff), u64::from(sum >> 16));
        let ((a, b), (next_a, next_b)) = (parts(self.sum), parts(next.sum));
        // What comes after begins from `a` instead of from 1, in each of its sums.
        let more = a + Self::MODULUS - 1;
        let length = next.length as u64 % Self::MODULUS;
        let low = (next_a + more) % Self::MODULUS;
        let high = (b + next_b + length * (more % Self::MODULUS)) % Self::MODULUS;
        Adler {
            sum: (high << 16 | low) as u32,
            length: self.length + next.length,
        }
    }
}

/// The file: header, density, title and the dots.
fn file((width, height): (u32, u32), title: &str, bands: &[Band]) -> Vec<u8> {
    let mut file = b"\x89PNG\r\n\x1a\n".to_vec();
    let mut header = Vec::new();
    header.extend(width.to_be_bytes());
    header.extend(height.to_be_bytes());
    // Eight bits; red, green, blue and opacity; the only compression and filtering there are; no interlacing.
    header.extend([8, 6, 0, 0, 0]);
    chunk(&mut file, b"IHDR", &header);
    let density = [DENSITY.to_be_bytes(), DENSITY.to_be_bytes()].concat();
    chunk(&mut file, b"pHYs", &[density.as_slice(), &[1]].concat());
    let title = [b"Title\0\0\0\0\0", title.as_bytes()].concat();
    chunk(&mut file, b"iTXt", &title);
    // `deflate` with the largest window, compressed fast; at the end an empty block that says it is the last.
    let mut dots = vec![0x78, 0x01];
    for band in bands {
        dots.extend_from_slice(&band.compressed);
    }
    dots.extend([0x03, 0x00]);
    let sums = bands.iter().map(|band| band.sum);
    let sum = sums.fold(Adler::OF_NOTHING, Adler::then).sum;
    dots.extend(sum.to_be_bytes());
    chunk(&mut file, b"IDAT", &dots);
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
