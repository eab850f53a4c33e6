//! What a document is made of once read.

use super::Span;
use super::inserted::Inserted;
use super::quantity::{Quantity, Subject};
use crate::algebra::{BigRational, Relation};
use crate::notation::Spanned;

/// One piece of a document.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Item {
    /// A heading.
    Heading {
        /// 1 for `#` to 6 for `######`.
        level: u8,
        /// The title as written, without its marks and comments.
        title: String,
        /// The cases that it names: "Case 2: $x < 0$".
        cases: Vec<Supposition>,
        /// The heading with its marks.
        span: Span,
    },
    /// The text between two other items.
    Prose(Box<Prose>),
    /// A displayed equation.
    Display {
        /// With its fences: `$$ a = b $$`.
        span: Span,
        /// The math alone, without the white space around it; never empty.
        body: Span,
        /// How it is set on the page, where the document says so: in LaTeX, and where Markdown has a key outside the
        /// mathematics.
        layout: Option<Box<Layout>>,
    },
    /// A `<!-- check: … -->` comment.
    Directives {
        /// Its clauses that could be read, in order.
        clauses: Vec<Spanned<Directive>>,
        /// The whole comment.
        span: Span,
    },
}

impl Item {
    /// Where the item stands.
    pub fn span(&self) -> Span {
        match self {
            Item::Prose(prose) => prose.span,
            Item::Heading { span, .. }
            | Item::Display { span, .. }
            | Item::Directives { span, .. } => *span,
        }
    }
}

/// How a display is set on the printed page.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Layout {
    /// Its rows, at least one; each may have a number of its own.
    pub rows: Vec<Row>,
    /// Whether `&` parts the rows into pairs of columns, as in `align`: every second one begins another equation.
    pub columns: bool,
    /// Other numbers and keys by which all of it is cited: those of the `subequations` around it.
    pub group: Option<(String, Vec<String>)>,
    /// Why it must not be read as it stands.
    pub obstacle: Option<Problem>,
}

/// A row of a display.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct Row {
    /// Its mathematics without numbers and keys, in order.
    pub pieces: Vec<Span>,
    /// Its number as printed.
    pub number: Option<String>,
    /// The keys by which it is cited.
    pub keys: Vec<String>,
}

/// Text between two other items, and what it says about them.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Prose {
    /// The text.
    pub span: Span,
    /// The mathematics in it, in order.
    pub math: Vec<Inline>,
    /// The equations that it cites, in order.
    pub citations: Vec<Citation>,
    /// What it supposes, in order.
    pub suppositions: Vec<Supposition>,
    /// What it says of symbols by adjectives, in order.
    pub qualities: Vec<Qualities>,
    /// The quantities that it names symbols as, in order.
    pub quantities: Vec<Quantity>,
    /// The quantity that the next display says, by its name: "The kinetic energy of the disc is".
    pub subject: Option<Subject>,
    /// The mathematics of sentences that say that something changes.
    pub changing: Vec<Span>,
    /// Values that it names ("for $n = 3$", "if $v = 0$") without saying plainly that they are supposed, in order.
    pub mentions: Vec<Span>,
    /// The sentence that leads on to the display after it; empty where there is none.
    pub leading: Span,
    /// The relations in the sentences that lead on to the display after it, supposed or not, the nearest sentence first.
    pub named: Vec<Named>,
    /// Whether its last sentence says that what comes next follows: "hence", "gives". `None` where nothing is said.
    pub concludes: Option<bool>,
    /// How many citations, the last of all, stand in its last sentence or after it.
    pub closing: usize,
    /// How many citations, the first of all, stand in the end of a sentence that the display before is in.
    pub tail: usize,
    /// Whether that says what the display comes from: "by (2)".
    pub says_from: bool,
    /// Whether the reason for what comes next is no equation: a law by its name, "since the string does not slip".
    pub reasons: bool,
    /// The names of such laws: "conservation of momentum".
    pub laws_named: Vec<Span>,
    /// Its last sentence, ended or not.
    pub said_last: Option<Span>,
    /// Its sentences that say what is so at a place or in a case: "At $t = 1$ the body is at $x = v$."
    pub of_places: Vec<Span>,
    /// The slope that its last sentence takes of what it cites.
    pub slope: Option<Slope>,
    /// What its last sentence puts in elsewhere.
    pub inserted: Inserted,
    /// Whether its last sentence names the rule by which several factors change together: "by the product rule".
    pub all_vary: bool,
    /// Whether its last sentence divides something by something: "Dividing (2) by (1)".
    pub divides: bool,
    /// Whether its last sentence says what is meant by what comes next: "we define".
    pub defines: bool,
    /// Its first sentence is about the display before it: "which by (2) is".
    pub is_relative: bool,
    /// It is a mere "where" or "with" between two displays, or supposes what comes next: "Now let", "We require that".
    pub says_what_is_meant: bool,
    /// Its last sentence puts a condition in words: "If the stress is to be the same in all of them, then by (1)".
    pub puts_condition: bool,
    /// Its last sentence announces several laws: "The two conditions of equilibrium are".
    pub announces_laws: bool,
    /// Its last sentence announces several things by their names: "The variance and the optimal share are".
    pub announces_several: bool,
    /// Its last sentence says that what comes next takes the place of what it cites: "With friction (1) is replaced by".
    pub replaces: bool,
    /// It goes on with what is said before the display before it: "and perpendicular to it".
    pub goes_on: bool,
    /// The displays before and after it stand in one sentence: "and the variance (1) is then".
    pub joins: bool,
    /// Of how much the display after it is said; `None` where it says nothing.
    pub extent: Option<Extent>,
}

impl Prose {
    /// Forgets the citations that are none.
    pub(crate) fn drop_citations(&mut self, such: impl Fn(&Citation) -> bool) {
        let all = std::mem::take(&mut self.citations);
        let (tail, closing) = (self.tail, all.len() - self.closing);
        for (at, citation) in all.into_iter().enumerate() {
            match such(&citation) {
                true => {
                    self.tail -= usize::from(at < tail);
                    self.closing -= usize::from(at >= closing);
                }
                false => self.citations.push(citation),
            }
        }
    }
}

/// "Differentiating (1) with respect to $t$": a slope that a sentence takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Slope {
    /// Where it is cited what the slope is of.
    pub cited: Span,
    /// The inside of the inline math by which is differentiated.
    pub by: Option<Span>,
    /// Whether that is the time, by words.
    pub by_time: bool,
    /// Whether it is the slope of the slope.
    pub twice: bool,
}

/// What prose says of symbols by adjectives: "where $a$ and $b$ are positive constants".
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Qualities {
    /// The mathematics: a symbol or several; or the word for what a display says the value of.
    pub body: Span,
    /// Whether it is such a word: "for a fixed volume".
    pub by_name: bool,
    /// What is said of it.
    pub attributes: Vec<Attribute>,
    /// It is said of circumstances: "with constant force $F$".
    pub of_case: bool,
    /// The sentence is that of the display before it.
    pub goes_on: bool,
}

/// Of how much a display is said.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Extent {
    /// Of all that the page is about.
    #[default]
    Throughout,
    /// "For a symmetric arrangement", "At constant temperature": under circumstances.
    Circumstances,
    /// "At the top of its flight", "Initially": of one moment or place.
    Moment,
    /// "The minimum is where", "At the maximum", "The condition is": of where it is so.
    Condition,
    /// "and": of what the display before it is said of.
    AsBefore,
}

/// Mathematics in a line of text.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Inline {
    /// With its fences: `$v_0$`.
    pub span: Span,
    /// Without them.
    pub body: Span,
}

/// A relation that prose names.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Named {
    /// The inside of the inline math.
    pub body: Span,
    /// The sentence draws a conclusion before it: "so that $a = b$".
    pub is_drawn: bool,
}

/// An equation cited in prose.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Citation {
    /// The tag or key, without its parentheses. A range of whole numbers has become one citation per number.
    pub tag: String,
    /// The last tag or key of a range that is not of whole numbers.
    pub through: Option<String>,
    /// Cited by a key (`\eqref{…}`) and not by a number.
    pub key: bool,
    /// Where it is cited; for a range, the whole range.
    pub span: Span,
    /// Introduced as an equation ("equation (2)", `\eqref{…}`), so that it must exist. A bare
    /// "(2)" need not: it may be something else.
    pub explicit: bool,
}

/// Inline mathematics that prose supposes.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Supposition {
    /// How it is supposed.
    pub kind: SuppositionKind,
    /// The inside of the inline math.
    pub body: Span,
}

/// How prose supposes something.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SuppositionKind {
    /// "Let $v_1 = 0$": a local value.
    Let,
    /// "At $\mu = 1$", "For $N = 3$, …": a local value, until the text speaks of the symbol as one that may have others.
    Case {
        /// The sentence goes on with the display after it.
        runs_on: bool,
        /// It is put in at one place, "Setting $x_{n+1} = x_n$ in (1)": the next display alone is said of it.
        is_put_in: bool,
    },
    /// "The period is $T = 2 \pi r/v$, so": said in passing. What does not follow without it is tried with it.
    Fact {
        /// The sentence goes on with the display after it.
        runs_on: bool,
        /// It is told of a special case: "For a horizontal pipe, $h_1 = h_2$, (1) becomes".
        of_case: bool,
    },
    /// "With $m = 3$ kg and $g = 9.8$ m/s² (6) yields": a value of a numerical example, which displays put in that come to numbers.
    Figure,
    /// "Hence, writing $r = p^2/m$,": told in passing, if it says what a new symbol means; otherwise it is concluded, or who knows what.
    Meaning,
    /// "At the turning points $v = 0$, so": a value at one moment.
    Moment,
    /// "With $w = w_0$ at $x = 0$ we get": a condition that is met there, which is what the next display follows from if it speaks of
    /// nothing that varies.
    Initial(Span),
    /// "It is known that $v = 3$", "The mass was measured to be $m = 2$": told, and not in passing, so that numbers are told for good, too.
    Known,
    /// "Setting the derivative to zero gives": zero, and not written as an equation.
    Vanishes(Vanishing),
    /// "In equilibrium the right-hand side of (1) vanishes": the same, as long as nothing changes.
    StandsStill(Vanishing),
    /// "Steady states of (1) satisfy": what is cited there says how fast something changes, or the display before, and that is zero.
    AtRest,
    /// "It must be equal to one", "Equating (1) and (2)": what is said at the first place has the value that is named at the second.
    Equals(Vanishing, Vanishing, Span),
    /// "If $x$ is negative, then", "When $m_1$ exceeds $m_2$,": a case, in which that is so of what stands there; of nought where there is no
    /// other.
    Compared {
        /// How it lies to the other.
        relation: Relation,
        /// What it is held against.
        to: Option<Span>,
    },
    /// "Either $x > 0$ or $x < 0$": one of several cases that the text counts. It supposes nothing.
    Alternative,
    /// "In the second case": the one at that place among those, or the last.
    TakenUp(Option<usize>),
    /// "Suppose, on the contrary, that $a = d$": a case that ends with a contradiction.
    Contrary,
    /// "which contradicts (1)": where it ends. It supposes nothing.
    Contradicted,
    /// "Solving (14) for $w$": the cases are left that set that. It supposes nothing.
    SolvedFor,
    /// "Setting the derivative with respect to $q$ to zero gives": the slope by what stands there of what is named or cited, or of what was
    /// displayed last that is made of it.
    StationaryBy {
        /// What is named or cited.
        of: Option<Span>,
        /// Whether all else is held fixed: it is a partial derivative, or there are several.
        partial: bool,
    },
    /// "Both sides vanish": a condition that is not understood. It supposes nothing, and what follows cannot be refuted without it.
    Unread,
    /// "$\beta = 1/2$ for a cylinder and $\beta = 2/5$ for a ball": the value for what is named there. It holds where the text says "for a
    /// cylinder".
    OfKind(Span),
    /// "Let $x$ be a real number": a letter is introduced. It supposes nothing.
    Anew,
    /// "Call their common value $u$": a name for what the display before says is equal.
    Common,
    /// "The ratio $z/a$ is called $u$": a name for the term that stands there.
    Abbreviation(Span),
    /// "In general": all special cases are left. It supposes nothing.
    General,
    /// "For general $x$": the cases are left that speak of that. It supposes nothing.
    Arbitrary,
    /// "Otherwise": what was supposed last is left, and is not so.
    Otherwise,
    /// "Later", "In between": the cases that were gone through and the moments are left, but not what was let.
    Elsewhere,
    /// "In both cases": those are left, and what comes next is said of each of them.
    InAllCases,
    /// "Assume", "Suppose", "taking", "provided that": a hypothesis.
    Assume,
    /// "…, where $k = m \omega^2$" after a display: the meaning of a symbol in it.
    Define,
}

/// What is said to be zero, or to have a value.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Vanishing {
    /// "Setting $F - k x$ to zero": the inline mathematics, a number, or "one".
    Term,
    /// "Setting the derivative to zero": the one that was displayed last; where there is none, that by what is displayed next.
    Slope,
    /// "Setting this to zero": what the display before says the value of.
    Display,
    /// "Equating the two": what the display before that says the value of.
    Previous,
    /// "Setting (5) to zero": what the equation that is cited there says the value of.
    Cited,
    /// "The left-hand side of (5) vanishes": of the equation that is cited there, or of the display before.
    LeftSide,
    /// "The right-hand side of (5) vanishes".
    RightSide,
    /// "which vanishes at $x = a$": the same, told in passing.
    Told,
    /// "the velocity vanishes, so": what the text calls by this word.
    Named,
}

impl SuppositionKind {
    /// A case of which more than the next display is said.
    pub fn case(runs_on: bool) -> Self {
        Self::Case {
            runs_on,
            is_put_in: false,
        }
    }

    /// Whether what was told of another special case is no longer meant.
    pub fn begins_a_case(self) -> bool {
        use SuppositionKind::{Arbitrary, Case, Compared, Contrary, Fact, TakenUp};
        match self {
            Case { .. } | Compared { .. } | Contrary | TakenUp(_) | Arbitrary => true,
            Fact { of_case, .. } => of_case,
            other => other.leaves_cases(),
        }
    }

    /// Whether special cases are left behind.
    pub fn leaves_cases(self) -> bool {
        use SuppositionKind::{Elsewhere, General, InAllCases, Otherwise};
        matches!(self, General | Elsewhere | InAllCases | Otherwise)
    }
}

/// One clause of a `check:` comment.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Directive {
    /// `given`, `law`, `definition`, `model`: the next display is given.
    Given,
    /// `derived`: the next display must be derived.
    Derived,
    /// `from …`: the premises of the next display; none for `from nothing`.
    From(Vec<Spanned<Premise>>),
    /// `claim NAME`: the name of the next display.
    Claim(Spanned<String>),
    /// `assuming FORMULAS`: hypotheses to the end of the section, as raw text.
    Assuming(Span),
    /// `let FORMULAS`: local values to the end of the section, as raw text.
    Let(Span),
    /// `symbols NAMES: ATTRIBUTES`.
    Symbols {
        /// The symbols as raw LaTeX; never empty.
        names: Vec<Span>,
        /// What they are declared to be; never empty.
        attributes: Vec<Spanned<Attribute>>,
    },
    /// `data NAMES: VALUE, "SOURCE"`: figures for numeric claims.
    Data {
        /// The symbols as raw LaTeX; never empty.
        names: Vec<Span>,
        /// The least value.
        low: BigRational,
        /// The greatest value, not below the least.
        high: BigRational,
        /// Where the figures come from.
        source: String,
    },
    /// `numeric`: the next display is a numeric claim; how near `≈` is meant, as a share of the right side.
    Numeric(Option<BigRational>),
}

/// A premise named by `from`.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Premise {
    /// `(42)`
    Tag(String),
    /// `claim cauchy-equality`
    Claim(String),
}

/// What a symbol is declared to be.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Attribute {
    /// A dimension, raw: a name such as `mass`, or base exponents such as `M L^{-1/2} T^{-2}`.
    /// That the name is known is not checked here.
    Dimension(String),
    /// `real`
    Real,
    /// `positive`
    Positive,
    /// `nonnegative`
    Nonnegative,
    /// `nonzero`
    Nonzero,
    /// `integer`
    Integer,
    /// `natural`: an integer, at least 1.
    Natural,
    /// `constant`: depends on no variable of differentiation.
    Constant,
    /// `Euler's number`: the base of the natural logarithm.
    Euler,
    /// `in [0, 1]`, `>= 1`; `None` for a side without bound. Never an empty interval.
    Interval {
        /// The lower bound.
        lower: Option<Bound>,
        /// The upper bound.
        upper: Option<Bound>,
    },
}

/// One end of an interval.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Bound {
    /// Where the interval ends.
    pub value: BigRational,
    /// The end itself is excluded: `(0` or `> 0`.
    pub strict: bool,
}

/// Something in a document that could not be read.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Problem {
    /// The guilty text.
    pub span: Span,
    /// What is wrong, as a headline.
    pub message: String,
    /// What to write instead, where something can be said.
    pub help: Option<String>,
}

impl Problem {
    /// A problem and its repair.
    pub fn new(span: Span, message: impl Into<String>, help: impl Into<String>) -> Problem {
        Problem {
            span,
            message: message.into(),
            help: Some(help.into()),
        }
    }
}
