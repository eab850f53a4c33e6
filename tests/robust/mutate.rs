//! Pages damaged at random, the same ones for the same number.

/// SplitMix64: a sequence of numbers from one, without a dependency.
///
/// **Source.** G. Steele, D. Lea, C. Flood, "Fast splittable pseudorandom number generators", OOPSLA 2014.
pub struct Chance(u64);

impl Chance {
    /// The sequence with a number.
    pub fn new(seed: u64) -> Self {
        Chance(seed)
    }

    fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A number below another; 0 below 0.
    pub fn below(&mut self, end: usize) -> usize {
        match u64::try_from(end) {
            Ok(end) if end > 0 => usize::try_from(self.next() % end).unwrap_or(0),
            _ => 0,
        }
    }

    fn one_of<'a, T>(&mut self, all: &'a [T]) -> &'a T {
        &all[self.below(all.len())]
    }
}

/// What formulas, directives and documents are broken by.
const PIECES: &[&str] = &[
    "$",
    "$$",
    "\\[",
    "\\]",
    "\\(",
    "\\)",
    "{",
    "}",
    "{}",
    "{{",
    "}}",
    "[",
    "]",
    "(",
    ")",
    "\\left(",
    "\\right)",
    "|",
    "&",
    "\\\\",
    "\\",
    "%",
    "#1",
    "~",
    "^",
    "_",
    "'",
    "''",
    "^{\\prime}",
    "^2",
    "^{-1}",
    "^{1/2}",
    "^{10^{9}}",
    "^{2147483648}",
    "_{i}",
    "_{18446744073709551616}",
    "0",
    "1",
    "-1",
    "99999999999999999999",
    "9223372036854775807",
    "0.1",
    "10^{-400}",
    "/0",
    "=",
    "\\neq",
    "<",
    "\\le",
    "\\approx",
    "\\sim",
    "\\gg",
    "\\to",
    "\\Rightarrow",
    "\\iff",
    "+",
    "-",
    "\\pm",
    "\\cdot",
    "\\times",
    "/",
    "\\dots",
    "\\cdots",
    ",",
    ";",
    ".",
    "!",
    "\\quad",
    "\\frac",
    "\\frac12",
    "\\sqrt",
    "\\sqrt[3]",
    "\\sum_{i=1}^{n}",
    "\\sum_{i=1}^{1000000}",
    "\\prod_{i=1}^{n}",
    "\\int_0^1",
    "\\, dx",
    "\\lim_{x \\to 0}",
    "\\frac{d}{dt}",
    "\\partial",
    "\\sin",
    "\\ln",
    "\\exp",
    "e^",
    "\\pi",
    "\\infty",
    "\\mathrm{",
    "\\text{",
    "\\overline",
    "\\hat",
    "\\vec",
    "\\dot",
    "\\boxed",
    "\\checkmark",
    "\\stackrel{?}{=}",
    "\\tag{1}",
    "\\tag{99999999999999999999}",
    "\\label{a}",
    "\\eqref{a}",
    "\\begin{cases}",
    "\\end{cases}",
    "\\begin{aligned}",
    "\\end{aligned}",
    "\\begin{align}",
    "\\end{align}",
    "\\begin{equation}",
    "\\end{equation}",
    "\\newcommand{\\a}[1]{#1 #1}",
    "\\a",
    "\\def\\b{\\a}",
    "\\iffalse",
    "\\fi",
    "\\input{x}",
    "\\qty{3}{m}",
    "<!--",
    "-->",
    "<!-- check: ",
    "% check: ",
    "law",
    "given",
    "derived",
    "from (1)",
    "assuming x > 0",
    "let x = 0",
    "symbols x: length, positive",
    "data x = 10^{400} \\pm 1",
    "numeric",
    "```",
    "```math",
    "`",
    "> ",
    "# ",
    "- ",
    "    ",
    "\t",
    "\n",
    "\n\n",
    "\r\n",
    "\r",
    "\u{feff}",
    "\0",
    "\u{2028}",
    "\u{301}",
    "é",
    "∑",
    "𝑥",
    "−",
    "(1)",
    "(1)–(9)",
    "(1)-(18446744073709551616)",
    "Eqs. (2) and (3)",
    "Let $x = 1$.",
    "assume $x > 0$",
    "by ",
];

/// A page with a few of its parts damaged; `other` is one to take parts from. It need not be text any more.
pub fn damaged(page: &[u8], other: &[u8], chance: &mut Chance) -> Vec<u8> {
    let mut out = part_of(page, chance).to_vec();
    for _ in 0..=chance.below(6) {
        damage(&mut out, other, chance);
    }
    out
}

/// A few paragraphs that stand together, so that an audit of them is soon done.
fn part_of<'a>(page: &'a [u8], chance: &mut Chance) -> &'a [u8] {
    let ends = page
        .windows(2)
        .enumerate()
        .filter(|(_, pair)| pair == b"\n\n");
    let mut cuts: Vec<usize> = ends.map(|(at, _)| at + 2).collect();
    cuts.insert(0, 0);
    cuts.push(page.len());
    let first = chance.below(cuts.len() - 1);
    let last = (first + 1 + chance.below(12)).min(cuts.len() - 1);
    &page[cuts[first]..cuts[last]]
}

fn damage(out: &mut Vec<u8>, other: &[u8], chance: &mut Chance) {
    let (from, to) = range(out, chance);
    match chance.below(14) {
        0 => {
            if let Some(byte) = out.get_mut(from) {
                *byte ^= 1 << chance.below(8);
            }
        }
        1 => drop(out.drain(from..to)),
        2 => out.truncate(from.max(1)),
        3 => {
            // Told twice, or very often.
            let copies = *chance.one_of(&[1, 1, 2, 50]);
            let piece = out[from..to].repeat(copies);
            out.splice(to..to, piece);
        }
        4 => {
            let (start, end) = range(other, chance);
            out.splice(from..to, other[start..end].iter().copied());
        }
        5 | 6 => exchange_words(out, chance),
        7 => {
            // Nested.
            let (open, close) = *chance.one_of(&[
                ("{", "}"),
                ("(", ")"),
                ("\\frac{1}{", "}"),
                ("\\sqrt{", "}"),
                ("^{", "}"),
                ("_{", "}"),
                ("\\left|", "\\right|"),
                ("\\sin(", ")"),
                ("-(", ")"),
            ]);
            let depth = *chance.one_of(&[1, 2, 3, 70, 300]);
            out.splice(to..to, close.repeat(depth).bytes());
            out.splice(from..from, open.repeat(depth).bytes());
        }
        8 => {
            // Another number.
            let digit = |&at: &usize| out[at].is_ascii_digit();
            if let Some(at) = (from..out.len()).find(digit) {
                let number = chance.one_of(&[
                    "0",
                    "2",
                    "-1",
                    "1/2",
                    "7",
                    "65536",
                    "4294967296",
                    "99999999999999999999",
                ]);
                out.splice(at..=at, number.bytes());
            }
        }
        9 => {
            // Another letter.
            let letter = |&at: &usize| out[at].is_ascii_lowercase();
            if let Some(at) = (from..out.len()).find(letter) {
                out[at] = b'a' + u8::try_from(chance.below(26)).unwrap_or(0);
            }
        }
        _ => {
            let piece = chance.one_of(PIECES);
            out.splice(from..from, piece.bytes());
        }
    }
}

/// Two stretches between spaces change places.
fn exchange_words(out: &mut Vec<u8>, chance: &mut Chance) {
    let words: Vec<&[u8]> = out.split(|&byte| byte == b' ').collect();
    let (one, other) = (chance.below(words.len()), chance.below(words.len()));
    let mut words = words.clone();
    words.swap(one, other);
    *out = words.join(&b' ');
}

/// A short stretch, most of the time.
fn range(text: &[u8], chance: &mut Chance) -> (usize, usize) {
    let from = chance.below(text.len() + 1);
    let longest = *chance.one_of(&[1, 4, 16, 64, 1000]);
    let to = (from + chance.below(longest + 1)).min(text.len());
    (from, to)
}
