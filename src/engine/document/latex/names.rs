//! What the reader knows by name: environments and commands.

/// Environments whose text is not TeX.
pub(super) const VERBATIM: &[&str] = &[
    "verbatim",
    "verbatim*",
    "Verbatim",
    "Verbatim*",
    "BVerbatim",
    "LVerbatim",
    "SaveVerbatim",
    "lstlisting",
    "minted",
    "comment",
    "filecontents",
    "filecontents*",
    "alltt",
];

/// How an environment sets its rows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(in crate::document) enum Rows {
    /// One equation with one number: `equation`.
    One,
    /// One equation over several lines, with one number: `multline`.
    Broken,
    /// A number for each row: `gather`.
    Each,
    /// A number for each row, and pairs of columns: `align`.
    Columns,
}

/// The environments that display mathematics, without their star.
pub(in crate::document) fn display(name: &str) -> Option<Rows> {
    Some(match name {
        "equation" | "displaymath" => Rows::One,
        "multline" => Rows::Broken,
        "gather" | "eqnarray" => Rows::Each,
        "align" | "alignat" | "flalign" | "xalignat" | "xxalignat" => Rows::Columns,
        _ => return None,
    })
}

/// Environments that display mathematics in a way that is not read.
pub(super) const UNREAD: &[&str] = &[
    "IEEEeqnarray",
    "IEEEeqnarraybox",
    "empheq",
    "dmath",
    "dseries",
    "dgroup",
    "darray",
    "dsuspend",
    "subeqnarray",
    "subeqnarrays",
    "mathpar",
    "diagram",
    "numcases",
    "subnumcases",
    "tabbedequation",
    "widetext*",
    "equations",
    "aligned",
    "alignedat",
    "gathered",
    "split",
    "cases",
    "matrix",
    "pmatrix",
    "bmatrix",
    "vmatrix",
    "Bmatrix",
    "Vmatrix",
    "smallmatrix",
    "multlined",
    "dcases",
    "rcases",
];

/// Commands in text whose arguments in braces are no text: how many there are.
pub(super) fn silent(command: &str) -> Option<usize> {
    Some(match command {
        "cite" | "citep" | "citet" | "citeauthor" | "citeyear" | "parencite" | "textcite"
        | "autocite" | "footcite" | "nocite" | "includegraphics" | "bibliography"
        | "bibliographystyle" | "addbibresource" | "vspace" | "hspace" | "usepackage"
        | "RequirePackage" | "pagestyle" | "thispagestyle" | "bibitem" | "pageref" | "nameref"
        | "hypersetup" | "geometry" | "usetikzlibrary" | "pgfplotsset" | "tikzset" | "lstset"
        | "sisetup" | "captionsetup" | "theoremstyle" | "allowdisplaybreaks" | "graphicspath"
        | "includeonly" | "index" | "input" | "include" | "color" | "documentclass"
        | "crefname" | "pagenumbering" | "selectlanguage" | "addtolength" | "linespread" => 1,
        "setlength" | "fontsize" | "newlength" | "definecolor" | "hypertarget" => 2,
        _ => return None,
    })
}

/// Conditions of TeX that are decided by its innermost state, which is not known here.
pub(super) const CONDITIONS: &[&str] = &[
    "if",
    "ifcat",
    "ifnum",
    "ifdim",
    "ifodd",
    "ifvmode",
    "ifhmode",
    "ifmmode",
    "ifinner",
    "ifvoid",
    "ifhbox",
    "ifvbox",
    "ifx",
    "ifeof",
    "iftrue",
    "iffalse",
    "ifcase",
    "ifdefined",
    "ifcsname",
    "iffontchar",
    "ifpdf",
    "ifxetex",
    "ifluatex",
    "ifPDFTeX",
    "ifXeTeX",
    "ifLuaTeX",
];

/// The level of a heading, and the counter that counts it.
pub(super) fn heading(command: &str) -> Option<(u8, &'static str)> {
    Some(match command {
        "part" => (2, "part"),
        "chapter" => (3, "chapter"),
        "section" => (4, "section"),
        "subsection" => (5, "subsection"),
        "subsubsection" => (6, "subsubsection"),
        "paragraph" => (7, "paragraph"),
        "subparagraph" => (8, "subparagraph"),
        _ => return None,
    })
}
