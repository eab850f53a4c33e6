//! Pictures as PDF: vector graphics, and text that can be searched, in a font that the file brings along.
//!
//! One page, version 1.5 (ISO 32000). No date and no random name is in the file: the same picture gives the same bytes.

use std::fmt::Write;

use miniz_oxide::deflate::compress_to_vec_zlib;

use super::FigureError;
use super::font;
use super::palette::Palette;
use super::scene::{Anchor, Ink, Item, Scene, Segment, Shape, Text};
use super::svg::number;
use crate::sorted::Map;

/// How hard to compress.
const EFFORT: u8 = 6;

/// The glyphs of a font that a picture uses, each with a character that it stands for.
type Used = Map<u16, char>;

/// A picture as a PDF file of one page, as large as the picture.
///
/// # Errors
/// The font has not every character.
pub fn pdf(scene: &Scene) -> Result<Vec<u8>, FigureError> {
    font::covers(scene)?;
    let mut used = [Used::new(), Used::new()];
    // Pictures count from the top downwards, pages from the bottom upwards.
    let mut content = format!("1 0 0 -1 0 {} cm\n", number(scene.height));
    fill(&mut content, Ink::Paper);
    let _ = writeln!(
        content,
        "0 0 {} {} re f",
        number(scene.width),
        number(scene.height)
    );
    for item in &scene.items {
        match item {
            Item::Shape(shape) => draw(&mut content, shape),
            Item::Text(text) => write(&mut content, text, &mut used),
        }
    }
    let mut file = File::new();
    file.object(
        "<</Type/Catalog/Pages 2 0 R/Lang(en)/ViewerPreferences<</DisplayDocTitle true>>>>",
    );
    file.object("<</Type/Pages/Kids[3 0 R]/Count 1>>");
    file.object(&format!(
        "<</Type/Page/Parent 2 0 R/MediaBox[0 0 {} {}]/Contents 4 0 R/Resources<</Font<</F0 6 0 R/F1 11 0 R>>>>>>",
        number(scene.width),
        number(scene.height)
    ));
    file.stream("", content.as_bytes());
    file.object(&format!(
        "<</Title {}/Subject {}>>",
        text_string(&scene.title),
        text_string(&scene.description)
    ));
    for (italic, used) in [false, true].into_iter().zip(&used) {
        embed(&mut file, italic, used);
    }
    Ok(file.finish())
}

fn colour(ink: Ink) -> String {
    let parts = Palette::LIGHT.colour(ink);
    let parts = parts.map(|part| format!("{:.4}", f64::from(part) / 255.0));
    parts.join(" ")
}

fn fill(content: &mut String, ink: Ink) {
    let _ = writeln!(content, "{} rg", colour(ink));
}

fn draw(content: &mut String, shape: &Shape) {
    if let Some(ink) = shape.fill {
        fill(content, ink);
    }
    if let Some(stroke) = shape.stroke {
        let dash: Vec<String> = stroke.dash.iter().map(|&length| number(length)).collect();
        let _ = writeln!(
            content,
            "{} RG {} w 1 j [{}] 0 d",
            colour(stroke.ink),
            number(stroke.width),
            dash.join(" ")
        );
    }
    for segment in &shape.path {
        let _ = match segment {
            Segment::Move(x, y) => write!(content, "{} {} m ", number(*x), number(*y)),
            Segment::Line(x, y) => write!(content, "{} {} l ", number(*x), number(*y)),
            Segment::Cubic(points) => write!(content, "{} c ", points.map(number).join(" ")),
            Segment::Close => write!(content, "h "),
        };
    }
    content.push_str(match (shape.fill, shape.stroke) {
        (Some(_), Some(_)) => "B\n",
        (Some(_), None) => "f\n",
        (None, Some(_)) => "S\n",
        (None, None) => "n\n",
    });
}

fn write(content: &mut String, text: &Text, used: &mut [Used; 2]) {
    let length = text.content.width() * text.size;
    let mut along = match text.anchor {
        Anchor::Start => 0.0,
        Anchor::Middle => -length / 2.0,
        Anchor::End => -length,
    };
    fill(content, text.ink);
    content.push_str("BT\n");
    for run in &text.content.0 {
        along -= run.back * text.size;
        let size = run.level.scale() * text.size;
        let down = run.drop() * text.size;
        let mut glyphs = String::new();
        for character in run.text.chars() {
            let Some(glyph) = font::glyph(character, run.italic) else {
                continue;
            };
            used[usize::from(run.italic)]
                .entry(glyph.0)
                .or_insert(character);
            let _ = write!(glyphs, "{:04x}", glyph.0);
        }
        // The letters are turned over once more, for the page has been.
        let (turn, x, y) = match text.upwards {
            true => ("0 -1 -1 0", text.x + down, text.y - along),
            false => ("1 0 0 -1", text.x + along, text.y + down),
        };
        let _ = writeln!(
            content,
            "/F{} {} Tf {turn} {} {} Tm <{glyphs}> Tj",
            usize::from(run.italic),
            number(size),
            number(x),
            number(y)
        );
        along += (run.width() + run.back) * text.size;
    }
    content.push_str("ET\n");
}

/// A font in five objects: as it is used, its glyphs by number, its measures, its file, its characters.
fn embed(file: &mut File, italic: bool, used: &Used) {
    let face = font::face(italic);
    let (name, data, angle) = match italic {
        false => ("CRADLE+Sans", font::UPRIGHT, 0),
        true => ("CRADLE+Sans-Oblique", font::OBLIQUE, -11),
    };
    let thousandth = |units: i16| i32::from(units) * 1000 / i32::from(face.units_per_em());
    let first = file.count() + 1;
    file.object(&format!(
        "<</Type/Font/Subtype/Type0/BaseFont/{name}/Encoding/Identity-H/DescendantFonts[{} 0 R]/ToUnicode {} 0 R>>",
        first + 1,
        first + 4
    ));
    let width = |&glyph: &u16| {
        let width = font::advance(ttf_parser::GlyphId(glyph), italic) * 1000.0;
        format!("{glyph}[{}]", number(width))
    };
    let widths: Vec<String> = used.keys().map(width).collect();
    file.object(&format!(
        "<</Type/Font/Subtype/CIDFontType2/BaseFont/{name}/CIDSystemInfo<</Registry(Adobe)/Ordering(Identity)/Supplement 0>>\
         /CIDToGIDMap/Identity/FontDescriptor {} 0 R/W[{}]>>",
        first + 2,
        widths.join("")
    ));
    let bounds = face.global_bounding_box();
    let corners = [bounds.x_min, bounds.y_min, bounds.x_max, bounds.y_max];
    file.object(&format!(
        "<</Type/FontDescriptor/FontName/{name}/Flags 4/FontBBox[{}]/ItalicAngle {angle}/Ascent {}/Descent {}\
         /CapHeight 729/StemV 80/FontFile2 {} 0 R>>",
        corners.map(|corner| thousandth(corner).to_string()).join(" "),
        thousandth(face.ascender()),
        thousandth(face.descender()),
        first + 3
    ));
    file.stream(&format!("/Length1 {}", data.len()), data);
    file.stream("", to_unicode(used).as_bytes());
}

/// Which character each glyph stands for, so that text can be copied and searched.
fn to_unicode(used: &Used) -> String {
    let mut map = String::from(
        "/CIDInit /ProcSet findresource begin 12 dict begin begincmap\n\
         /CIDSystemInfo <</Registry (Adobe) /Ordering (UCS) /Supplement 0>> def\n\
         /CMapName /Adobe-Identity-UCS def /CMapType 2 def\n\
         1 begincodespacerange <0000> <ffff> endcodespacerange\n",
    );
    let all: Vec<(&u16, &char)> = used.iter().collect();
    for hundred in all.chunks(100) {
        let _ = writeln!(map, "{} beginbfchar", hundred.len());
        for (glyph, character) in hundred {
            let _ = writeln!(map, "<{glyph:04x}> <{}>", utf16(&character.to_string()));
        }
        map.push_str("endbfchar\n");
    }
    map + "endcmap CMapName currentdict /CMap defineresource pop end end\n"
}

fn utf16(text: &str) -> String {
    text.encode_utf16()
        .map(|unit| format!("{unit:04x}"))
        .collect()
}

/// A text of the document's description: UTF-16 with its mark, in hexadecimal, so that nothing needs escaping.
fn text_string(text: &str) -> String {
    format!("<feff{}>", utf16(text))
}

/// A file that is written object by object.
struct File {
    bytes: Vec<u8>,
    offsets: Vec<usize>,
}

impl File {
    fn new() -> Self {
        File {
            // The second line says that the file is not text.
            bytes: b"%PDF-1.5\n%\xe2\xe3\xcf\xd3\n".to_vec(),
            offsets: Vec::new(),
        }
    }

    fn count(&self) -> usize {
        self.offsets.len()
    }

    fn begin(&mut self) {
        self.offsets.push(self.bytes.len());
        let opening = format!("{} 0 obj\n", self.count());
        self.bytes.extend(opening.into_bytes());
    }

    fn object(&mut self, body: &str) {
        self.begin();
        self.bytes.extend(body.as_bytes());
        self.bytes.extend(b"\nendobj\n");
    }

    fn stream(&mut self, more: &str, data: &[u8]) {
        let data = compress_to_vec_zlib(data, EFFORT);
        self.begin();
        let header = format!(
            "<</Length {}/Filter/FlateDecode{more}>>\nstream\n",
            data.len()
        );
        self.bytes.extend(header.into_bytes());
        self.bytes.extend(data);
        self.bytes.extend(b"\nendstream\nendobj\n");
    }

    /// Ends the file: where each object begins, which is the first, and which describes the document.
    fn finish(mut self) -> Vec<u8> {
        let start = self.bytes.len();
        let mut end = format!("xref\n0 {}\n0000000000 65535 f \n", self.count() + 1);
        for offset in &self.offsets {
            let _ = writeln!(end, "{offset:010} 00000 n ");
        }
        let _ = write!(
            end,
            "trailer\n<</Size {}/Root 1 0 R/Info 5 0 R>>\nstartxref\n{start}\n%%EOF\n",
            self.count() + 1
        );
        self.bytes.extend(end.into_bytes());
        self.bytes
    }
}
