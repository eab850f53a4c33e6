use super::law::{Law, Standing};
use super::numbers::Numbers;
use super::panel::{CAPTION, LARGE};
use super::rich::Rich;
use super::scene::{Anchor, Caption, Scene};
use super::words::list;

/// A picture with the numbers in it, and with what these rest on.
#[derive(Clone, Debug)]
pub struct Figure {
    /// The picture.
    pub scene: Scene,
    /// The same for a narrow screen: what stands beside a curve stands below it.
    pub narrow: Scene,
    /// The numbers behind it, exact.
    pub numbers: Numbers,
    /// The equations that it rests on.
    pub sources: Vec<Source>,
}

/// How much room a picture has from left to right.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Paper {
    /// That of a page or a slide.
    Wide,
    /// That of a telephone, on which the letters are as large.
    Narrow,
}

impl Paper {
    /// What is meant for one or for the other.
    pub(super) fn pick<T>(self, wide: T, narrow: T) -> T {
        match self {
            Paper::Wide => wide,
            Paper::Narrow => narrow,
        }
    }

    /// An empty picture; a page may hold both.
    pub(super) fn scene(self, name: &str) -> Scene {
        let name = match self {
            Paper::Wide => name.to_owned(),
            Paper::Narrow => format!("{name}-narrow"),
        };
        Scene::new(&name, self.pick(720.0, 400.0), 0.0)
    }
}

/// Begins a picture with its heading, and says by how much it is higher for having several lines.
pub(super) fn heading(scene: &mut Scene, left: f64, heading: &Rich) -> f64 {
    let lines = heading.lines((scene.width - left - 16.0) / LARGE);
    let more = (lines.len() - 1) as f64 * 1.3 * LARGE;
    for (at, line) in lines.into_iter().enumerate() {
        let y = 26.0 + at as f64 * 1.3 * LARGE;
        scene.text((left, y), Anchor::Start, LARGE, line);
    }
    more
}

/// An equation that a figure rests on.
#[derive(Clone, Debug)]
pub struct Source {
    /// What the audit found of it.
    pub standing: Standing,
    /// The relation that was evaluated, as LaTeX; `None` where only the verdict counts.
    pub latex: Option<String>,
}

impl From<&Law> for Source {
    fn from(law: &Law) -> Self {
        Source {
            standing: law.standing.clone(),
            latex: Some(law.latex()),
        }
    }
}

impl From<Standing> for Source {
    fn from(standing: Standing) -> Self {
        Source {
            standing,
            latex: None,
        }
    }
}

/// `The audit: (59) holds, (60) holds and (64) holds.`
pub(super) fn verdicts(sources: &[Source]) -> String {
    let mut groups: Vec<(String, Vec<String>)> = Vec::new();
    for source in sources {
        let words = source.standing.words();
        let label = source.standing.label.clone();
        match groups.iter_mut().find(|(own, _)| *own == words) {
            Some((_, labels)) => labels.push(label),
            None => groups.push((words, vec![label])),
        }
    }
    let clause = |(words, labels): (String, Vec<String>)| {
        let words = match labels.len() {
            1 => words,
            _ => plural(&words),
        };
        format!("{} {words}", list(&labels))
    };
    let clauses: Vec<String> = groups.into_iter().map(clause).collect();
    format!("The audit: {}.", clauses.join("; "))
}

/// `holds` of several is `hold`.
fn plural(words: &str) -> String {
    let (verb, rest) = match words.find([' ', ',']) {
        Some(end) => words.split_at(end),
        None => (words, ""),
    };
    let verb = match verb {
        "holds" => "hold",
        "fails" => "fail",
        "is" => "are",
        verb => verb,
    };
    let rest = rest.replace("but rests on", "but rest on");
    format!("{verb}{rest}")
}

/// Ends a picture: the caption below, its words also as the description, and the height that all of it takes.
pub(super) fn caption(scene: &mut Scene, top: f64, left: f64, caption: &Rich) {
    let width = scene.width - 2.0 * left;
    scene.caption = Some(Caption {
        words: caption.clone(),
        above: (top - 1.4 * CAPTION).ceil(),
        items: scene.items.len(),
        description: scene.description.clone(),
    });
    let end = scene.paragraph((left, top), width, CAPTION, caption);
    scene.height = end.ceil();
    let words = caption.plain().replace('\u{a0}', " ");
    scene.description = match scene.description.is_empty() {
        true => words,
        false => format!("{} {words}", scene.description),
    };
}
