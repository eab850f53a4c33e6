//! What the commands of LaTeX's prose look like.

/// What becomes of a command.
pub(super) enum Command {
    /// Its argument, with something before and behind it.
    Around(&'static str, &'static str),
    /// The rest of the group, likewise.
    Switch(&'static str, &'static str),
    /// A sign.
    Sign(&'static str),
    /// The letter that follows, with this mark.
    Accent(char),
    /// Nothing, with so many arguments.
    Dropped(usize),
    /// The numbers of equations, by their keys; with parentheses, or as they are.
    Numbers(bool),
    /// Keys in brackets.
    Keys,
    /// An argument as it stands.
    Code,
    Begin,
    End,
    Item,
    Paragraph,
}

/// What is known of a command; of others the text of the arguments shows.
pub(super) fn command(name: &str) -> Option<Command> {
    Some(match name {
        "emph" | "textit" | "textsl" => Command::Around("<em>", "</em>"),
        "textbf" => Command::Around("<strong>", "</strong>"),
        "texttt" => Command::Around("<code>", "</code>"),
        "footnote" | "thanks" => Command::Around(" (", ")"),
        "em" | "it" | "itshape" | "slshape" => Command::Switch("<em>", "</em>"),
        "bf" | "bfseries" => Command::Switch("<strong>", "</strong>"),
        "tt" | "ttfamily" => Command::Switch("<code>", "</code>"),
        "%" | "&" | "#" | "_" | "$" | "{" | "}" => Command::Sign(escaped(name)),
        "\\" | "newline" | "linebreak" => Command::Sign("<br/>\n"),
        " " | "\n" | "," | ";" | ":" | "quad" | "qquad" | "enspace" | "thinspace" => {
            Command::Sign("\u{a0}")
        }
        "dots" | "ldots" | "textellipsis" => Command::Sign("…"),
        "LaTeX" => Command::Sign("LaTeX"),
        "TeX" => Command::Sign("TeX"),
        "S" => Command::Sign("§"),
        "P" => Command::Sign("¶"),
        "copyright" => Command::Sign("©"),
        "textdegree" => Command::Sign("°"),
        "textbackslash" => Command::Sign("\\"),
        "textemdash" => Command::Sign("—"),
        "textendash" => Command::Sign("–"),
        "ss" => Command::Sign("ß"),
        "ae" => Command::Sign("æ"),
        "AE" => Command::Sign("Æ"),
        "oe" => Command::Sign("œ"),
        "o" => Command::Sign("ø"),
        "O" => Command::Sign("Ø"),
        "aa" => Command::Sign("å"),
        "AA" => Command::Sign("Å"),
        "l" => Command::Sign("ł"),
        "i" => Command::Sign("ı"),
        "'" => Command::Accent('\u{301}'),
        "`" => Command::Accent('\u{300}'),
        "^" => Command::Accent('\u{302}'),
        "\"" => Command::Accent('\u{308}'),
        "~" => Command::Accent('\u{303}'),
        "=" => Command::Accent('\u{304}'),
        "." => Command::Accent('\u{307}'),
        "c" => Command::Accent('\u{327}'),
        "v" => Command::Accent('\u{30c}'),
        "H" => Command::Accent('\u{30b}'),
        "eqref" | "labelcref" => Command::Numbers(true),
        "ref" | "cref" | "Cref" | "autoref" | "vref" | "pageref" => Command::Numbers(false),
        "cite" | "citep" | "citet" | "citealp" | "parencite" | "textcite" | "autocite" => {
            Command::Keys
        }
        "url" | "path" => Command::Code,
        "begin" => Command::Begin,
        "end" => Command::End,
        "item" => Command::Item,
        "par" => Command::Paragraph,
        "label" | "vspace" | "hspace" | "input" | "include" | "bibliography"
        | "bibliographystyle" | "includegraphics" | "index" | "pagestyle" | "thispagestyle"
        | "href" | "color" | "textcolor" | "phantom" | "bibitem" | "vskip" => Command::Dropped(1),
        "setlength" | "addtolength" | "setcounter" | "addtocounter" | "rule" => Command::Dropped(2),
        "noindent" | "indent" | "medskip" | "bigskip" | "smallskip" | "newpage" | "clearpage"
        | "centering" | "maketitle" | "tableofcontents" | "hfill" | "vfill" | "/" | "-" | "!" => {
            Command::Dropped(0)
        }
        _ => return None,
    })
}

/// A sign that has a meaning in LaTeX, as text.
fn escaped(sign: &str) -> &'static str {
    match sign {
        "%" => "%",
        "&" => "&amp;",
        "#" => "#",
        "_" => "_",
        "$" => "$",
        "{" => "{",
        _ => "}",
    }
}

/// The environments that are lists: what opens them, and what closes them.
pub(super) fn list(environment: &str) -> Option<(&'static str, &'static str)> {
    match environment.trim_end_matches('*') {
        "itemize" | "description" => Some(("<ul>\n", "</ul>\n")),
        "enumerate" => Some(("<ol>\n", "</ol>\n")),
        _ => None,
    }
}

/// How many arguments an environment has that say only how it looks.
pub(super) fn arguments(environment: &str) -> usize {
    match environment.trim_end_matches('*') {
        "tabular" | "longtable" | "minipage" | "multicols" | "thebibliography" => 1,
        "tabularx" => 2,
        _ => 0,
    }
}

/// The sign that several characters of text are: dashes and quotation marks.
pub(super) fn ligature(text: &str) -> Option<(&'static str, &'static str)> {
    const LIGATURES: [(&str, &str); 6] = [
        ("---", "—"),
        ("--", "–"),
        ("``", "“"),
        ("''", "”"),
        ("`", "‘"),
        ("'", "’"),
    ];
    let mut all = LIGATURES.into_iter();
    all.find(|(typed, _)| text.starts_with(typed))
}
