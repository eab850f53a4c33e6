//! Numbers as LaTeX counts and prints them.

use crate::sorted::Tree;

/// A printed number that would be longer is nonsense.
const LONGEST: usize = 64;
/// Formats refer to formats: `\theequation` to `\thesection` to `\thechapter`.
const DEPTH: usize = 8;

/// The counters of a document, and how each is printed.
#[derive(Debug)]
pub(super) struct Numbering {
    counters: Tree<String, i64>,
    formats: Tree<String, String>,
    /// What goes back to 0 when a counter is stepped.
    resets: Tree<String, Vec<String>>,
    chapters: bool,
    /// Whether chapters are counted, as they are outside of `\frontmatter` and `\backmatter`.
    main_matter: bool,
    /// The count of what `appendices` stand between, and how it is printed.
    outer: Option<(i64, String)>,
    /// Whether the counter of equations was set in a way that is not followed: from then on no number is known.
    lost: bool,
}

impl Numbering {
    /// The counters of a class of documents.
    pub(super) fn of_class(class: &str) -> Numbering {
        let chapters = matches!(
            class,
            "book"
                | "report"
                | "scrbook"
                | "scrreprt"
                | "memoir"
                | "amsbook"
                | "extbook"
                | "extreport"
        );
        let mut numbering = Numbering {
            counters: Tree::new(),
            formats: Tree::new(),
            resets: Tree::new(),
            chapters,
            main_matter: true,
            outer: None,
            lost: false,
        };
        let mut within = |child: &str, parent: &str, format: &str| {
            numbering.format(child, format);
            if !parent.is_empty() {
                numbering.within(child, parent);
            }
        };
        within("part", "", "\\Roman{part}");
        within("chapter", "", "\\arabic{chapter}");
        match chapters {
            true => {
                within("section", "chapter", "\\thechapter.\\arabic{section}");
                within("equation", "chapter", "\\chapterpoint\\arabic{equation}");
            }
            false => {
                within("section", "", "\\arabic{section}");
                within("equation", "", "\\arabic{equation}");
            }
        }
        within("subsection", "section", "\\thesection.\\arabic{subsection}");
        within(
            "subsubsection",
            "subsection",
            "\\thesubsection.\\arabic{subsubsection}",
        );
        within("paragraph", "subsubsection", "\\arabic{paragraph}");
        within("subparagraph", "paragraph", "\\arabic{subparagraph}");
        numbering
    }

    fn format(&mut self, counter: &str, format: &str) {
        self.formats.insert(counter.to_owned(), format.to_owned());
    }

    /// `\counterwithin*{equation}{section}`: the count begins anew, and is printed as before.
    pub(super) fn within(&mut self, child: &str, parent: &str) {
        let children = self.resets.entry(parent.to_owned()).or_default();
        if !children.iter().any(|own| own == child) {
            children.push(child.to_owned());
        }
    }

    /// `\numberwithin{equation}{section}`
    pub(super) fn number_within(&mut self, child: &str, parent: &str) {
        self.within(child, parent);
        let format = format!("\\the{parent}.\\arabic{{{child}}}");
        self.format(child, &format);
    }

    /// `\counterwithout{equation}{section}`
    pub(super) fn number_without(&mut self, child: &str, parent: &str) {
        self.apart(child, parent);
        self.format(child, &format!("\\arabic{{{child}}}"));
    }

    /// `\counterwithout*{equation}{section}`
    pub(super) fn apart(&mut self, child: &str, parent: &str) {
        if let Some(children) = self.resets.get_mut(parent) {
            children.retain(|own| own != child);
        }
    }

    /// `\renewcommand{\theequation}{…}`
    pub(super) fn set_format(&mut self, counter: &str, format: &str) {
        self.format(counter, format);
    }

    /// `\frontmatter`, `\mainmatter`, `\backmatter`
    pub(super) fn matter(&mut self, main: bool) {
        self.main_matter = main;
    }

    /// A heading that is numbered.
    pub(super) fn heading(&mut self, counter: &str) {
        if self.main_matter || counter != "chapter" {
            self.step(counter);
        }
    }

    /// What appendices are counted as.
    fn top(&self) -> &'static str {
        match self.chapters {
            true => "chapter",
            false => "section",
        }
    }

    /// `\begin{appendices}`
    pub(super) fn begin_appendices(&mut self) {
        let top = self.top();
        self.outer = Some((self.get(top), self.formats[top].clone()));
        self.appendix();
    }

    /// `\end{appendices}`
    pub(super) fn end_appendices(&mut self) {
        if let Some((value, format)) = self.outer.take() {
            let top = self.top();
            self.set(top, value);
            self.format(top, &format);
        }
    }

    /// `\appendix`
    pub(super) fn appendix(&mut self) {
        let top = self.top();
        self.set(top, 0);
        self.format(top, &format!("\\Alph{{{top}}}"));
        let mut children = self.resets.get(top).cloned().unwrap_or_default();
        while let Some(child) = children.pop() {
            self.set(&child, 0);
        }
    }

    pub(super) fn get(&self, counter: &str) -> i64 {
        self.counters.get(counter).copied().unwrap_or(0)
    }

    pub(super) fn set(&mut self, counter: &str, value: i64) {
        self.counters.insert(counter.to_owned(), value);
        if counter == "equation" {
            self.lost = false;
        }
    }

    /// Counts equations on from where the count is.
    pub(super) fn count_on(&mut self, by: i64) {
        let value = self.get("equation").saturating_add(by);
        self.counters.insert("equation".to_owned(), value);
    }

    /// The counter of equations has a value that is not known.
    pub(super) fn lose(&mut self) {
        self.lost = true;
    }

    /// One more; what counts within begins anew.
    pub(super) fn step(&mut self, counter: &str) {
        let value = self.get(counter).saturating_add(1);
        self.counters.insert(counter.to_owned(), value);
        let mut open = self.resets.get(counter).cloned().unwrap_or_default();
        let mut bound = 64;
        while let (Some(child), true) = (open.pop(), bound > 0) {
            bound -= 1;
            self.counters.insert(child.clone(), 0);
            // Wherever the count was lost, it begins anew.
            self.lost &= child != "equation";
            open.extend(self.resets.get(&child).cloned().unwrap_or_default());
        }
    }

    /// The number of the equation that comes next.
    pub(super) fn next_equation(&mut self) -> Option<String> {
        self.step("equation");
        self.printed("equation")
    }

    /// A counter as it is printed; nothing if its format is not one that is followed.
    pub(super) fn printed(&self, counter: &str) -> Option<String> {
        if self.lost && counter == "equation" {
            return None;
        }
        let mut text = String::new();
        self.print(self.formats.get(counter)?, &mut text, DEPTH)?;
        (!text.is_empty()).then_some(text)
    }

    fn print(&self, format: &str, text: &mut String, depth: usize) -> Option<()> {
        let depth = depth.checked_sub(1)?;
        let mut rest = format;
        while let Some(c) = rest.chars().next() {
            if text.len() > LONGEST {
                return None;
            }
            let Some(command) = rest.strip_prefix('\\') else {
                if !matches!(c, '{' | '}' | '~') && !c.is_whitespace() {
                    text.push(c);
                }
                rest = &rest[c.len_utf8()..];
                continue;
            };
            let end = command
                .find(|c: char| !c.is_ascii_alphabetic())
                .unwrap_or(command.len());
            let (name, after) = command.split_at(end);
            rest = after;
            if let Some(counter) = name.strip_prefix("the").filter(|c| !c.is_empty()) {
                self.print(self.formats.get(counter)?, text, depth)?;
                continue;
            }
            if name == "chapterpoint" {
                // What stands before the first chapter has no number of it.
                if self.get("chapter") > 0 {
                    self.print(self.formats.get("chapter")?, text, depth)?;
                    text.push('.');
                }
                continue;
            }
            let style = match name {
                "arabic" | "alph" | "Alph" | "roman" | "Roman" => name,
                "textup" | "mathrm" | "textrm" | "ensuremath" => continue,
                _ => return None,
            };
            let (counter, after) = after.trim_start().strip_prefix('{')?.split_once('}')?;
            rest = after;
            text.push_str(&spelt(style, self.get(counter.trim()))?);
        }
        Some(())
    }

    /// Begins `subequations`: the number that all of them share, and what is to be restored after them.
    pub(super) fn begin_sub(&mut self) -> (Option<String>, i64, String) {
        let parent = self.next_equation();
        let outer = (self.get("equation"), self.formats["equation"].clone());
        self.counters.insert("equation".to_owned(), 0);
        match &parent {
            Some(parent) => self.format("equation", &format!("{parent}\\alph{{equation}}")),
            None => self.lost = true,
        }
        (parent, outer.0, outer.1)
    }

    pub(super) fn end_sub(&mut self, equation: i64, format: String) {
        self.counters.insert("equation".to_owned(), equation);
        self.formats.insert("equation".to_owned(), format);
    }
}

/// A number in one of LaTeX's styles.
fn spelt(style: &str, value: i64) -> Option<String> {
    let letter = |first: u8| {
        let place = u8::try_from(value).ok().filter(|v| (1..=26).contains(v))?;
        Some(char::from(first + place - 1).to_string())
    };
    match style {
        "alph" => letter(b'a'),
        "Alph" => letter(b'A'),
        "roman" => roman(value),
        "Roman" => roman(value).map(|text| text.to_uppercase()),
        _ => Some(value.to_string()),
    }
}

fn roman(value: i64) -> Option<String> {
    const SIGNS: [(i64, &str); 13] = [
        (1000, "m"),
        (900, "cm"),
        (500, "d"),
        (400, "cd"),
        (100, "c"),
        (90, "xc"),
        (50, "l"),
        (40, "xl"),
        (10, "x"),
        (9, "ix"),
        (5, "v"),
        (4, "iv"),
        (1, "i"),
    ];
    (1..4000).contains(&value).then_some(())?;
    let (mut left, mut text) = (value, String::new());
    for (worth, sign) in SIGNS {
        while left >= worth {
            text.push_str(sign);
            left -= worth;
        }
    }
    Some(text)
}
