//! Text of figures as HTML, for pages on which a caption stands below its figure.

use super::rich::{Level, Rich};
use super::svg::escape;

/// Text with its variables slanted and its scripts below and above the line. Nothing of it can be taken for markup.
///
/// ```
/// use cradle_verify::figures::{markup, rich::Rich};
/// let text = Rich::words("At ").math("E_{after}").and(" < 1");
/// assert_eq!(markup(&text), "At <i>E</i><sub>after</sub> &lt; 1");
/// ```
pub fn markup(text: &Rich) -> String {
    let mut markup = String::new();
    for run in &text.0 {
        let mut content = escape(&run.text);
        if run.italic {
            content = format!("<i>{content}</i>");
        }
        markup += &match run.level {
            Level::Base => content,
            Level::Sub => format!("<sub>{content}</sub>"),
            Level::Super => format!("<sup>{content}</sup>"),
        };
    }
    markup
}
