//! What is wrong with a configuration, in its own text.

use annotate_snippets::{AnnotationKind, Element, Group, Level, Renderer};

use super::diagnostic::with_snippet;
use crate::config::Amiss;

/// All that is wrong, laid out as findings are.
pub fn amiss(amiss: &Amiss) -> String {
    let mut text = String::new();
    for problem in &amiss.problems {
        let title = Level::ERROR.primary_title(problem.message.as_str());
        let marks = [(AnnotationKind::Primary, problem.span, "")];
        let mut group = with_snippet(Group::with_title(title), &amiss.file, &marks);
        if let Some(help) = problem.help.as_deref().filter(|help| !help.is_empty()) {
            group = group.element(Element::Message(Level::HELP.message(help)));
        }
        text += &Renderer::styled().term_width(100).render(&[group]);
        text += "\n\n";
    }
    text
}
