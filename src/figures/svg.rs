//! Pictures as SVG: text stays text, and colours follow the reader's choice of a light or a dark page. On paper they
//! are light.

use std::fmt::Write;

use super::palette::{Palette, SERIES};
use super::rich::Rich;
use super::scene::{Anchor, Ink, Item, Scene, Segment, Shape, Text};
use crate::notation::escape_by;

/// A picture as an SVG document, or as an element to be put into a page of HTML.
///
/// Its class is `cradle-figure`, and its colours are custom properties of that class. Title and description are those
/// that are read aloud. Nothing of the text can be taken for markup.
pub fn svg(scene: &Scene) -> String {
    let name = escape(&scene.name);
    let (width, height) = (number(scene.width), number(scene.height));
    let mut text = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" class=\"cradle-figure\" role=\"img\" \
         aria-labelledby=\"{name}-title {name}-desc\" width=\"{width}\" height=\"{height}\" \
         viewBox=\"0 0 {width} {height}\" \
         font-family=\"DejaVu Sans, Verdana, Helvetica, Arial, sans-serif\">\n"
    );
    let _ = writeln!(
        text,
        "<title id=\"{name}-title\">{}</title>",
        escape(&scene.title)
    );
    let _ = writeln!(
        text,
        "<desc id=\"{name}-desc\">{}</desc>",
        escape(&scene.description)
    );
    let _ = writeln!(text, "<style>{}</style>", style());
    let _ = writeln!(
        text,
        "<rect width=\"{width}\" height=\"{height}\"{}/>",
        fill(Some(Ink::Paper))
    );
    for item in &scene.items {
        match item {
            Item::Shape(shape) => write_shape(&mut text, shape),
            Item::Text(line) => write_text(&mut text, line),
        }
    }
    text.push_str("</svg>\n");
    text
}

/// Text with nothing in it that markup is made of, and nothing that XML has no place for.
pub(super) fn escape(text: &str) -> String {
    escape_by(text, |_| Some(char::REPLACEMENT_CHARACTER))
}

/// Every colour as a custom property, for light and for dark pages, and a class for each use of it.
fn style() -> String {
    let inks = || {
        let plain = [Ink::Paper, Ink::Text, Ink::Faint, Ink::Grid];
        plain.into_iter().chain((0..SERIES).map(Ink::Series))
    };
    let properties = |palette: &Palette| -> String {
        let property = |ink| format!("--cradle-{}:{};", name(ink), hex(palette.colour(ink)));
        inks().map(property).collect()
    };
    let mut style = format!(
        ".cradle-figure{{{}}}@media screen and (prefers-color-scheme:dark){{.cradle-figure{{{}}}}}",
        properties(&Palette::LIGHT),
        properties(&Palette::DARK)
    );
    for ink in inks() {
        let name = name(ink);
        let _ = write!(
            style,
            ".cradle-figure .f-{name}{{fill:var(--cradle-{name})}}\
             .cradle-figure .s-{name}{{stroke:var(--cradle-{name})}}"
        );
    }
    style
}

fn name(ink: Ink) -> String {
    match ink {
        Ink::Paper => "paper".into(),
        Ink::Text => "text".into(),
        Ink::Faint => "faint".into(),
        Ink::Grid => "grid".into(),
        Ink::Series(at) => (at % SERIES).to_string(),
    }
}

fn hex([red, green, blue]: [u8; 3]) -> String {
    format!("#{red:02x}{green:02x}{blue:02x}")
}

/// The colour twice: as it is on white, and as a class, which wins where style sheets are read.
fn fill(ink: Option<Ink>) -> String {
    match ink {
        Some(ink) => format!(
            " fill=\"{}\" class=\"f-{}\"",
            hex(Palette::LIGHT.colour(ink)),
            name(ink)
        ),
        None => " fill=\"none\"".to_owned(),
    }
}

fn write_shape(text: &mut String, shape: &Shape) {
    let mut path = String::new();
    for segment in &shape.path {
        let _ = match segment {
            Segment::Move(x, y) => write!(path, "M{} {}", number(*x), number(*y)),
            Segment::Line(x, y) => write!(path, "L{} {}", number(*x), number(*y)),
            Segment::Cubic(points) => {
                path.push('C');
                path.push_str(&points.map(number).join(" "));
                Ok(())
            }
            Segment::Close => write!(path, "Z"),
        };
    }
    let _ = write!(text, "<path d=\"{path}\"");
    let Some(stroke) = shape.stroke else {
        let _ = writeln!(text, "{}/>", fill(shape.fill));
        return;
    };
    let mut classes = format!("s-{}", name(stroke.ink));
    match shape.fill {
        Some(ink) => {
            let _ = write!(text, " fill=\"{}\"", hex(Palette::LIGHT.colour(ink)));
            let _ = write!(classes, " f-{}", name(ink));
        }
        None => text.push_str(" fill=\"none\""),
    }
    let _ = write!(
        text,
        " stroke=\"{}\" class=\"{classes}\" stroke-width=\"{}\" stroke-linejoin=\"round\"",
        hex(Palette::LIGHT.colour(stroke.ink)),
        number(stroke.width)
    );
    if !stroke.dash.is_empty() {
        let lengths: Vec<String> = stroke.dash.iter().map(|&length| number(length)).collect();
        let _ = write!(text, " stroke-dasharray=\"{}\"", lengths.join(" "));
    }
    text.push_str("/>\n");
}

fn write_text(text: &mut String, line: &Text) {
    let anchor = match line.anchor {
        Anchor::Start => "",
        Anchor::Middle => " text-anchor=\"middle\"",
        Anchor::End => " text-anchor=\"end\"",
    };
    let (x, y) = (number(line.x), number(line.y));
    let turned = match line.upwards {
        true => format!(" transform=\"rotate(-90 {x} {y})\""),
        false => String::new(),
    };
    let _ = writeln!(
        text,
        "<text x=\"{x}\" y=\"{y}\" font-size=\"{}\"{anchor}{turned}{}>{}</text>",
        number(line.size),
        fill(Some(line.ink)),
        runs(&line.content, line.size)
    );
}

/// Pieces of text, each moved from the one before it.
fn runs(content: &Rich, size: f64) -> String {
    let mut text = String::new();
    let mut down = 0.0;
    for run in &content.0 {
        let drop = run.drop() * size;
        let mut attributes = String::new();
        if run.italic {
            attributes.push_str(" font-style=\"italic\"");
        }
        if run.level.scale() < 1.0 {
            let _ = write!(
                attributes,
                " font-size=\"{}\"",
                number(run.level.scale() * size)
            );
        }
        if run.back != 0.0 {
            let _ = write!(attributes, " dx=\"{}\"", number(-run.back * size));
        }
        if drop != down {
            let _ = write!(attributes, " dy=\"{}\"", number(drop - down));
        }
        down = drop;
        let content = escape(&run.text);
        match attributes.is_empty() {
            true => text.push_str(&content),
            false => {
                let _ = write!(text, "<tspan{attributes}>{content}</tspan>");
            }
        }
    }
    text
}

/// A coordinate, to a hundredth of a point.
pub(super) fn number(value: f64) -> String {
    let text = format!("{value:.2}");
    let text = text.trim_end_matches('0').trim_end_matches('.');
    match text {
        "-0" => "0".to_owned(),
        text => text.to_owned(),
    }
}
