use std::path::Path;

use cradle_verify::algebra::{BigInt, BigRational};
use cradle_verify::figures::scene::{Anchor, Item, Text};
use cradle_verify::figures::{self, Figure, FigureError, Material, Palette, Scene};
use cradle_verify::proofs;

fn all() -> Vec<Figure> {
    let checker = proofs::checker();
    vec![
        figures::collision(&checker).unwrap(),
        figures::energy(&checker, &Material::of_the_report()).unwrap(),
        figures::lithotripsy(&checker).unwrap(),
        figures::outcomes(&checker).unwrap(),
    ]
}

fn half() -> BigRational {
    BigRational::new(BigInt::from(1), BigInt::from(2))
}

fn named(name: &str) -> Material {
    Material::new(name, half()).unwrap()
}

/// As many materials as there can be, each with the widest name.
fn crowded() -> Figure {
    let materials: Vec<Material> = (0..Material::MOST)
        .map(|at| named(&format!("{}{at}", "W".repeat(Material::LONGEST_NAME - 1))))
        .collect();
    figures::energy(&proofs::checker(), &materials).unwrap()
}

fn texts(scene: &Scene) -> impl Iterator<Item = &Text> {
    scene.items.iter().filter_map(|item| match item {
        Item::Text(text) => Some(text),
        Item::Shape(_) => None,
    })
}

/// Left, top, right and bottom of a text, a little within its letters.
fn bounds(text: &Text) -> [f64; 4] {
    let length = text.content.width() * text.size;
    let start = match text.anchor {
        Anchor::Start => 0.0,
        Anchor::Middle => -length / 2.0,
        Anchor::End => -length,
    };
    let (high, low) = (0.7 * text.size, 0.15 * text.size);
    match text.upwards {
        false => [
            text.x + start,
            text.y - high,
            text.x + start + length,
            text.y + low,
        ],
        true => [
            text.x - high,
            text.y - start - length,
            text.x + low,
            text.y - start,
        ],
    }
}

#[test]
fn no_text_leaves_the_picture_or_runs_into_another() {
    for figure in all().iter().chain([&crowded()]) {
        let scene = &figure.scene;
        let all: Vec<(String, [f64; 4])> = texts(scene)
            .map(|text| (text.content.plain(), bounds(text)))
            .collect();
        for (at, (text, [left, top, right, bottom])) in all.iter().enumerate() {
            assert!(
                *left >= 0.0 && *right <= scene.width,
                "`{text}` in {}",
                scene.name
            );
            assert!(
                *top >= 0.0 && *bottom <= scene.height,
                "`{text}` in {}",
                scene.name
            );
            for (other, [l, t, r, b]) in &all[..at] {
                let apart = right <= l || r <= left || bottom <= t || b <= top;
                assert!(apart, "`{text}` and `{other}` in {}", scene.name);
            }
        }
    }
}

#[test]
fn svg_is_xml_with_a_title_a_description_and_dark_colours() {
    for figure in all() {
        let text = figures::svg(&figure.scene);
        assert_eq!(text, figures::svg(&figure.scene));
        let document = roxmltree::Document::parse(&text).unwrap();
        let said = |name: &str| {
            let found = document
                .descendants()
                .find(|node| node.has_tag_name(("http://www.w3.org/2000/svg", name)));
            found.and_then(|node| node.text()).unwrap().to_owned()
        };
        assert_eq!(said("title"), figure.scene.title);
        assert_eq!(said("desc"), figure.scene.description);
        assert!(said("style").contains("prefers-color-scheme:dark"));
        let labelled = document
            .root_element()
            .attribute("aria-labelledby")
            .unwrap();
        for id in labelled.split(' ') {
            assert!(
                document
                    .descendants()
                    .any(|node| node.attribute("id") == Some(id))
            );
        }
    }
}

#[test]
fn a_hostile_name_is_text_and_nothing_else() {
    let name = r#"</text><script>&"' x"#;
    let figure = figures::energy(&proofs::checker(), &[named(name)]).unwrap();
    let text = figures::svg(&figure.scene);
    let document = roxmltree::Document::parse(&text).unwrap();
    assert!(
        document
            .descendants()
            .all(|node| node.tag_name().name() != "script")
    );
    let is_there = |node: roxmltree::Node| node.text().is_some_and(|text| text.contains(name));
    assert!(document.descendants().any(is_there));
    assert!(figures::pdf(&figure.scene).is_ok() && figures::png(&figure.scene).is_ok());
}

#[test]
fn a_character_that_the_font_has_not_is_refused_where_the_font_is_needed() {
    let figure = figures::energy(&proofs::checker(), &[named("鋼")]).unwrap();
    assert!(figures::svg(&figure.scene).contains('鋼'));
    let refused = FigureError::NoGlyph('鋼');
    assert_eq!(figures::png(&figure.scene).unwrap_err(), refused);
    assert_eq!(figures::pdf(&figure.scene).unwrap_err(), refused);
}

/// The chunks of a PNG file.
fn chunks(file: &[u8]) -> Vec<(&[u8], &[u8])> {
    assert_eq!(&file[..8], b"\x89PNG\r\n\x1a\n");
    let (mut rest, mut found) = (&file[8..], Vec::new());
    while !rest.is_empty() {
        let length = u32::from_be_bytes(rest[..4].try_into().unwrap()) as usize;
        found.push((&rest[4..8], &rest[8..8 + length]));
        rest = &rest[12 + length..];
    }
    found
}

#[test]
fn png_has_two_dots_to_a_point_and_the_colours_of_the_curves() {
    for figure in all() {
        let file = figures::png(&figure.scene).unwrap();
        assert_eq!(file, figures::png(&figure.scene).unwrap());
        let chunks = chunks(&file);
        let names: Vec<&[u8]> = chunks.iter().map(|chunk| chunk.0).collect();
        assert_eq!(names, [&b"IHDR"[..], b"pHYs", b"iTXt", b"IDAT", b"IEND"]);
        let number =
            |at: usize| u32::from_be_bytes(chunks[0].1[at..at + 4].try_into().unwrap()) as usize;
        let (width, height) = (number(0), number(4));
        assert_eq!(width as f64, 2.0 * figure.scene.width);
        assert_eq!(height as f64, 2.0 * figure.scene.height);
        let mut dots = miniz_oxide::inflate::decompress_to_vec_zlib(chunks[3].1).unwrap();
        let row = 4 * width + 1;
        assert_eq!(dots.len(), row * height);
        for at in (0..dots.len()).step_by(row) {
            // A row is as it is, or the difference from the one above.
            assert!([0, 2].contains(&dots[at]));
            if dots[at] == 2 {
                for dot in at + 1..at + row {
                    dots[dot] = dots[dot].wrapping_add(dots[dot - row]);
                }
            }
        }
        let has = |[red, green, blue]: [u8; 3]| {
            dots.chunks_exact(row).any(|row| {
                let mut dots = row[1..].chunks_exact(4);
                dots.any(|dot| dot == [red, green, blue, u8::MAX])
            })
        };
        let first = figures::scene::Ink::Series(1);
        assert!(has(Palette::LIGHT.colour(first)), "{}", figure.scene.name);
    }
}

#[test]
fn png_checksums_are_those_of_the_standard() {
    let file = figures::png(&all()[0].scene).unwrap();
    // Every PNG file ends with the same twelve bytes.
    assert!(file.ends_with(b"\0\0\0\0IEND\xae\x42\x60\x82"));
}

#[test]
fn pdf_has_its_objects_where_it_says_and_one_page_of_the_size() {
    for figure in all() {
        let file = figures::pdf(&figure.scene).unwrap();
        assert_eq!(file, figures::pdf(&figure.scene).unwrap());
        assert!(file.starts_with(b"%PDF-1.5\n") && file.ends_with(b"%%EOF\n"));
        let text = String::from_utf8_lossy(&file);
        let page = format!(
            "/MediaBox[0 0 {} {}]",
            figure.scene.width, figure.scene.height
        );
        assert!(text.contains(&page), "{page}");
        let end = text.rsplit("startxref\n").next().unwrap();
        let start: usize = end.lines().next().unwrap().parse().unwrap();
        let table = std::str::from_utf8(&file[start..]).unwrap();
        let offsets = table
            .lines()
            .skip(3)
            .take_while(|line| line.ends_with(" n "));
        let mut count = 0;
        for (at, line) in offsets.enumerate() {
            let offset: usize = line[..10].parse().unwrap();
            assert!(file[offset..].starts_with(format!("{} 0 obj\n", at + 1).as_bytes()));
            count += 1;
        }
        assert_eq!(count, 15);
    }
}

#[test]
fn the_committed_figures_are_current() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/figures");
    for figure in all() {
        let path = folder.join(format!("{}.svg", figure.scene.name));
        let committed = std::fs::read_to_string(&path).unwrap();
        let name = &figure.scene.name;
        assert!(
            committed == figures::svg(&figure.scene),
            "docs/figures/{name}.svg is not what is drawn: `cargo run -- plot {name} -o docs/figures/{name}.svg`"
        );
    }
}

#[test]
fn every_colour_stands_out_from_its_paper() {
    use figures::scene::Ink;
    // The relative luminance of the Web Content Accessibility Guidelines 2, and their contrast of graphics.
    let luminance = |colour: [u8; 3]| {
        let linear = colour.map(|part| {
            let part = f64::from(part) / 255.0;
            match part <= 0.04045 {
                true => part / 12.92,
                false => ((part + 0.055) / 1.055).powf(2.4),
            }
        });
        0.2126 * linear[0] + 0.7152 * linear[1] + 0.0722 * linear[2]
    };
    for palette in [Palette::LIGHT, Palette::DARK] {
        let contrast = |ink| {
            let (a, b) = (
                luminance(palette.colour(ink)),
                luminance(palette.colour(Ink::Paper)),
            );
            (a.max(b) + 0.05) / (a.min(b) + 0.05)
        };
        for at in 0..figures::SERIES {
            assert!(contrast(Ink::Series(at)) >= 4.0, "{at}");
        }
        assert!(contrast(Ink::Text) >= 7.0 && contrast(Ink::Faint) >= 4.5);
    }
}
