//! What prose supposes: "Let $v_1 = 0$", "taking $v'_2 \neq 0$", "At $\mu = 1$", "Setting $Q = 0$", "With $g = 10$ …",
//! "For $N = 3$, …", and what a symbol of a display means: "…, where $k = m \omega^2$".
//!
//! A supposition becomes a hypothesis of what follows, so one too many can make anything true.
//! In doubt nothing is read: not a conclusion drawn in the same sentence ("then", "gives"), not an
//! alternative ("or"), not a condition ("if") but one of what the sentence goes on to display, not a negation, not a question, not a proof by contradiction. A value that is
//! named and not supposed is kept as a mention: where a step fails without it, the finding can say so.

mod cases;
mod common;
mod example;
mod initial;
mod introduction;
mod mathematics;
pub(super) mod named;
mod retraction;
mod vanishing;
mod words;

use self::introduction::{MOST_DESCRIBING, introduced, is_condition};
pub(super) use self::mathematics::relates;
use self::mathematics::{differs, equals_a_name, is_bound, is_letters, is_number, is_value};
use self::words::{
    CONCLUDING, DENYING, DOUBTFUL, HAVING, HYPOTHETICAL, KNOWN, MOMENTARY, NAMED_AFTER,
    NAMED_BEFORE, NAMING, NEGATING, OF_CASES, REASONS, REGIMES, UNDECIDED,
};
use super::circumstance;
use super::conclusion;
use super::prose::{Placed, Token, ends_sentence, in_lower_case, lead};
use super::words::{Listed, Words, is_in_any_case};
use super::{Extent, Span, Supposition, SuppositionKind};
use crate::sorted::{self, Set};

/// So many words may stand between "include" and "again".
const MOST_RECALLED: usize = 8;

/// How far a supposition reaches.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Reach {
    /// "Let", "Assume" as the verb of the sentence: all of it.
    Sentence,
    /// "With $…$, $…$ and $…$": so many more.
    List { left: usize },
    /// "…, taking $…$ and $…$, …": what is joined to it.
    Joined {
        /// Words that may still come before the first.
        patience: usize,
        /// A comma has just been read.
        comma: bool,
        /// Something has been supposed.
        found: bool,
        /// "At $…$": a comma ends it.
        short: bool,
    },
}

/// The suppositions in prose, in order, and the values that it names besides.
pub(super) fn read(source: &str, tokens: &[Placed<'_>]) -> (Vec<Supposition>, Vec<Span>) {
    // A paragraph that no full stop ends goes on with the display after it.
    let stops = |token: &Placed<'_>| match token.0 {
        Token::Stop => ends_sentence(source, token),
        other => !matches!(other, Token::Hidden),
    };
    let end = tokens.iter().rposition(stops).map_or(0, |last| last + 1);
    let mut reader = Reader {
        source,
        tokens: &tokens[..end],
        found: Vec::new(),
        mentions: Vec::new(),
        introduced: Vec::new(),
        leading: 0,
        open: 0,
        sentence: Sentence::from(0),
    };
    for (index, &(token, span)) in tokens[..end].iter().enumerate() {
        match token {
            Token::Stop => reader.stop(span),
            Token::Word(word) => reader.word(index, &in_lower_case(word), span),
            Token::Math(body) => reader.mathematics(index, body),
            token => reader.mark(token),
        }
    }
    let introduced = std::mem::take(&mut reader.introduced);
    let (mut found, mut mentions) = reader.finish();
    if example::take_up(source, &tokens[..end], &mut found, &mut mentions) {
        sorted::sort_by_key(&mut found, |supposition| supposition.body);
    }
    retraction::take_back(source, &tokens[..end], &mut found, &mut mentions);
    retraction::tell_kinds_apart(source, &tokens[..end], &mut found, &mut mentions);
    found.extend(vanishing::read(source, &tokens[..end]));
    found.extend(common::read(source, &tokens[..end]));
    found.extend(introduced.into_iter().map(|body| Supposition {
        kind: SuppositionKind::Anew,
        body,
    }));
    // What is so at one place alone is not supposed for good, and neither is the place.
    let (initial, told) = initial::read(source, &tokens[..end], &found);
    if !told.is_empty() {
        let is_for_good = |own: &Supposition| is_fact(own.kind) || is_hypothesis(own.kind);
        found.retain(|own| !told.contains(&own.body) || !is_for_good(own));
    }
    if !initial.is_empty() {
        let spans = initial.iter().flat_map(|own| match own.kind {
            SuppositionKind::Initial(place) => [own.body, place],
            _ => [own.body, own.body],
        });
        let spans: Set<Span> = spans.collect();
        found.retain(|own| !spans.contains(&own.body));
        mentions.retain(|own| !spans.contains(own));
        found.extend(initial);
    }
    // What is supposed already, or told, is not a case besides.
    if let Some(case) = cases::read(source, &tokens[..end]) {
        let is_own = |own: &&mut Supposition| own.body == case.body && is_no_meaning(own);
        if let Some(own) = found.iter_mut().find(is_own) {
            if let SuppositionKind::Fact { of_case, .. } = &mut own.kind {
                *of_case = true;
            }
        } else {
            found.retain(|own| own.body != case.body);
            mentions.retain(|own| *own != case.body);
            found.push(case);
        }
    }
    sorted::sort_by_key(&mut found, |supposition| supposition.body);
    (found, mentions)
}

/// In a sentence with more words and formulas nothing is told.
const LONGEST_SENTENCE: usize = 200;
/// Reads prose token by token.
struct Reader<'a> {
    source: &'a str,
    tokens: &'a [Placed<'a>],
    found: Vec<Supposition>,
    mentions: Vec<Span>,
    /// The letters that it introduces.
    introduced: Vec<Span>,
    /// Up to here a sentence only leads on: "As a check,".
    leading: usize,
    /// From here on, what was supposed runs on into the display after the text.
    open: usize,
    sentence: Sentence,
}

/// What is known of the sentence that is being read.
struct Sentence {
    /// The first of its suppositions.
    start: usize,
    /// Its first word.
    first: usize,
    begun: bool,
    /// It begins with a special case: "For a horizontal pipe, …".
    special: bool,
    /// It supposes nothing that could be used.
    doubtful: bool,
    /// The word before named a value.
    named: bool,
    /// Something in it is introduced by no verb, but by "with" or "where".
    careful: bool,
    /// It may still tell a fact in passing.
    factual: bool,
    /// It may still tell what a new letter means: "A monopolist would choose the quantity $Q = a/(2 b)$".
    means: bool,
    /// It has drawn a conclusion.
    concluded: bool,
    /// A clause with a reason is open: "Since no heat is lost, $Q = P$". Whether that denies something.
    reason: Option<bool>,
    /// What was introduced last, as far as it reaches.
    active: Option<(SuppositionKind, Reach)>,
}

impl Sentence {
    fn from(start: usize) -> Sentence {
        Sentence {
            start,
            first: 0,
            begun: false,
            special: false,
            doubtful: false,
            named: false,
            careful: false,
            factual: true,
            means: true,
            concluded: false,
            reason: None,
            active: None,
        }
    }
}

impl Reader<'_> {
    fn text(&self, span: Span) -> &str {
        self.source.get(span.range()).unwrap_or_default()
    }

    /// How many tokens from `index` on only lead on: "As a check,". An example is one of what comes next alone.
    fn lead(&self, index: usize) -> usize {
        let rest = &self.tokens[index..];
        let lead = lead(rest);
        let is_example = |(token, _): &Placed<'_>| token.is_among(&["example", "instance"]);
        // "For example, take $x = 1$. We get"
        let stops = || rest.iter().filter(|(token, _)| token.is_stop());
        let leads_on = || stops().count() <= 1;
        match rest[..lead].iter().any(is_example) && !leads_on() {
            true => 0,
            false => lead,
        }
    }

    /// Whether the sentence has supposed nothing yet.
    fn is_silent(&self) -> bool {
        self.found.len() == self.sentence.start
    }

    fn stop(&mut self, span: Span) {
        if self.text(span) == "?" {
            self.withdraw();
        }
        self.sentence = Sentence::from(self.found.len());
        self.open = self.sentence.start;
    }

    fn word(&mut self, index: usize, word: &str, span: Span) {
        let among = |words: &Words| words.has(word);
        if !self.sentence.begun {
            self.sentence.first = index;
            self.leading = self.leading.max(index + self.lead(index));
        }
        if index < self.leading {
            return;
        }
        let of_a_case = || among(&OF_CASES) || among(&REGIMES);
        self.sentence.special |= !self.sentence.begun && of_a_case();
        if self.is_silent()
            && let Some(kind) = generalizes(word, index, self.tokens)
        {
            self.found.push(Supposition { kind, body: span });
        }
        let denies = self.sentence.careful && among(&DENYING);
        let unsaid = self.sentence.active.is_some() && self.is_silent() && among(&NEGATING);
        // A "non-trivial" solution is none of the trivial ones.
        let compound = || index > 0 && matches!(self.tokens[index - 1].0, Token::Dash);
        let conditional = || is_condition(self.source, index, self.tokens);
        if denies || unsaid || among(&DOUBTFUL) && !compound() && !conditional() {
            self.withdraw();
            self.sentence.doubtful = true;
        }
        // "The masses were measured to be" denies nothing.
        let told = || {
            let next = self.tokens.get(index + 1).map(|(token, _)| *token);
            word == "were" && matches!(next, Some(Token::Word(next)) if KNOWN.has(next))
        };
        let begins = || !self.sentence.begun || follows_comma(index, self.tokens);
        if matches!(word, "since" | "because" | "as") && begins() {
            self.sentence.reason = Some(false);
        }
        if let Some(denied) = &mut self.sentence.reason
            && among(&DENYING)
        {
            *denied = true;
        } else if among(&UNDECIDED) || among(&DENYING) && !told() {
            self.sentence.factual = false;
            self.sentence.means &= among(&HYPOTHETICAL);
            // "A ball of radius $r = 2 a$ rolls without slipping": only what comes after it is denied.
            if word != "without" {
                self.withdraw_facts();
            }
        }
        let draws = conclusion::draws(word);
        // "The bars have the lengths $a > b > 0$" concludes nothing.
        let we_have = word == "have" && follows(index, self.tokens, &HAVING);
        self.sentence.concluded |= draws || we_have || matches!(word, "show" | "shows");
        let begun = self.sentence.begun;
        let introduced = || introduced(self.source, word, index, self.tokens, begun);
        self.sentence.active = match self.sentence.active {
            _ if self.sentence.doubtful => None,
            Some(_) if draws || among(&CONCLUDING) => None,
            active => match (active, introduced()) {
                (_, Some(introduced)) => {
                    self.sentence.careful = !matches!(word, "let" | "assume" | "suppose");
                    Some(introduced)
                }
                (Some((kind, reach)), None) => reach.past_word(word).map(|reach| (kind, reach)),
                (None, None) => None,
            },
        };
        self.sentence.named = among(&NAMING) || self.sentence.named && word == "and";
        self.sentence.begun = true;
    }

    fn mathematics(&mut self, index: usize, body: Span) {
        self.sentence.begun = true;
        if self.sentence.reason == Some(true) && relates(self.text(body)) {
            (self.sentence.factual, self.sentence.means) = (false, false);
            self.withdraw_facts();
        }
        let text = self.text(body);
        let (states, is_zero) = (relates(text), text.trim_end().ends_with("= 0"));
        let says_number = is_number(text);
        // "At $x = h$" says where.
        let is_place = follows(index, self.tokens, &NAMED_BEFORE) && equals_a_name(text);
        let active = self.sentence.active;
        if let Some((kind, reach)) = active {
            let may_begin = kind != SuppositionKind::Define || is_zero;
            // "where $I = I_0$ when $t = 0$" means nothing for good.
            let is_then = !may_begin && is_at_a_value(self.source, index, self.tokens);
            if states && !is_then && !(may_begin && is_origin(index, text, reach, self.tokens)) {
                self.found.push(Supposition { kind, body });
                self.sentence.named = false;
            }
            let reach = reach.past_math(states).filter(|_| !(states && is_then));
            self.sentence.active = reach.map(|reach| (kind, reach));
        }
        if !states && self.introduces(index) && is_letters(self.text(body)) {
            self.introduced.push(body);
        }
        if self.sentence.named && states {
            self.mentions.push(body);
        }
        if states && self.is_momentary(index, body) {
            let kind = SuppositionKind::Moment;
            self.found.push(Supposition { kind, body });
        } else if states && self.is_known(index) {
            let kind = SuppositionKind::Known;
            self.found.push(Supposition { kind, body });
        } else if states && self.tells(index, body) {
            let kind = SuppositionKind::Fact {
                runs_on: false,
                of_case: self.sentence.special || self.is_of_moment(index),
            };
            self.found.push(Supposition { kind, body });
        } else if states {
            let own = &self.sentence;
            let is_told = own.means && !own.doubtful && !self.is_of_moment(index);
            if own.active.is_none() && is_told && !says_number && !is_place {
                let kind = SuppositionKind::Meaning;
                self.found.push(Supposition { kind, body });
            }
            // "For $N = 3$ the values are $a = b$."
            self.sentence.concluded = true;
        }
    }

    /// Whether the sentence introduces the letter at `index`: "Let $v$ be", "Here $v$ denotes".
    fn introduces(&self, index: usize) -> bool {
        let lets = matches!(self.sentence.active, Some((SuppositionKind::Let, _)));
        match self.tokens.get(index + 1) {
            Some((Token::Word(word), _)) => {
                lets && NAMED_AFTER.has(word) || matches!(*word, "denotes" | "denote")
            }
            _ => false,
        }
    }

    /// Whether what the sentence says before the token at `index` is said of one moment or place; in doubt it is.
    fn is_of_moment(&self, index: usize) -> bool {
        let before = self
            .tokens
            .get(self.sentence.first..index)
            .unwrap_or_default();
        if before.len() > LONGEST_SENTENCE {
            return true;
        }
        // A moment of inertia is none.
        let is_of = |at: usize| {
            let next = before.get(at + 1);
            before[at].0.is_among(&["moment"]) && next.is_some_and(|(own, _)| own.is_among(&["of"]))
        };
        let names = |at: usize| before[at].0.is_among(&MOMENTARY) && !is_of(at);
        (0..before.len()).any(names) || circumstance::of_sentence(before) == Extent::Moment
    }

    /// Whether the sentence tells what number something is at one moment: "At the turning points $v = 0$, so".
    fn is_momentary(&self, index: usize, body: Span) -> bool {
        let text = self.text(body);
        let own = &self.sentence;
        let is_value = is_value(text) && is_number(text) && !is_named(index, self.tokens);
        if !is_value || own.active.is_some() || own.doubtful || own.concluded || !own.begun {
            return false;
        }
        match self.is_silent() {
            true => {
                let before = &self.tokens[own.first..index];
                let says = matches!(before.last(), Some((Token::Word(_) | Token::Mark(','), _)));
                let is_place = follows(index, self.tokens, &NAMED_BEFORE);
                says && !is_place && circumstance::of_sentence(before) == Extent::Moment
            }
            false => self.joins(index, |kind| kind == SuppositionKind::Moment),
        }
    }

    /// Whether the sentence tells plainly that a relation is known.
    fn is_known(&self, index: usize) -> bool {
        let own = &self.sentence;
        if own.active.is_some() || own.doubtful || !own.factual || is_named(index, self.tokens) {
            return false;
        }
        tells_that(index, self.tokens) || self.joins(index, |kind| kind == SuppositionKind::Known)
    }

    /// Whether an "and" joins the mathematics at `index` to what was supposed just before it, if that is of such a kind.
    fn joins(&self, index: usize, is: impl Fn(SuppositionKind) -> bool) -> bool {
        let last = self.found.last().filter(|last| is(last.kind));
        follows(index, self.tokens, &["and"])
            && last.is_some_and(|last| ends_before(last.body, index, self.tokens))
    }

    /// Whether a relation is a fact that the sentence tells in passing.
    fn tells(&self, index: usize, body: Span) -> bool {
        let (own, text) = (&self.sentence, self.text(body));
        if own.active.is_some() || own.doubtful || !own.factual {
            return false;
        }
        // "At $\mu = 1$, $\eta = 1$" says what follows there.
        let mut others = self.found[own.start..].iter();
        let follows_here =
            own.concluded || others.any(|s| !is_fact(s.kind) && !s.kind.leaves_cases());
        if follows_here && !follows(index, self.tokens, &REASONS) {
            return false;
        }
        // "as it is for $x = 0$" compares, "for $x > 0$ it grows" goes through cases.
        let bounds = is_bound(text) && !differs(text);
        let plainly = match is_number(text) && !bounds {
            true => is_plain(index, self.tokens) || self.joins(index, is_fact),
            false => !(bounds && follows(index, self.tokens, &["for"])),
        };
        // "which starts with $I = I_0$ at $t = 0$" is so then.
        let is_then = is_at_a_value(self.source, index, self.tokens)
            || is_at_a_place(self.source, index, self.tokens);
        // "The magnification $M = f/s$ is": what is no number is no origin.
        let is_name = is_number(text) && is_named(index, self.tokens);
        plainly && !is_name && !is_then && !follows(index, self.tokens, &NAMED_BEFORE)
    }

    /// A bullet or an emphasis before the first word is nothing; inside, a mark ends a phrase.
    fn mark(&mut self, mark: Token<'_>) {
        if mark.is_mark(',') {
            self.sentence.reason = None;
        }
        let Some((kind, reach)) = self.sentence.active else {
            if mark.is_mark(';') {
                self.open = self.found.len();
            }
            return;
        };
        match mark {
            Token::Mark(',') => {
                self.sentence.active = reach.past_comma().map(|reach| (kind, reach));
                return;
            }
            Token::Mark(';') => self.open = self.found.len(),
            _ => {}
        }
        if matches!(reach, Reach::Joined { .. }) && mark != Token::Dash {
            self.sentence.active = None;
        }
    }

    /// Takes back what the sentence has supposed: it only names it.
    fn withdraw(&mut self) {
        let own = (self.found).extract_if(self.sentence.start.., |s| !s.kind.leaves_cases());
        self.mentions
            .extend(own.filter(is_no_meaning).map(|s| s.body));
    }

    fn withdraw_facts(&mut self) {
        let told = (self.found).extract_if(self.sentence.start.., |s| is_fact(s.kind));
        self.mentions
            .extend(told.filter(is_no_meaning).map(|s| s.body));
    }

    fn finish(mut self) -> (Vec<Supposition>, Vec<Span>) {
        for supposition in self.found.iter_mut().skip(self.open) {
            use SuppositionKind::{Case, Fact};
            if let Case { runs_on } | Fact { runs_on, .. } = &mut supposition.kind {
                *runs_on = true;
            }
        }
        sorted::sort(&mut self.mentions);
        (self.found, self.mentions)
    }
}

/// Whether it is told whatever its symbols are. What may be concluded is no value that somebody might have meant to suppose.
fn is_no_meaning(supposition: &Supposition) -> bool {
    supposition.kind != SuppositionKind::Meaning
}

fn is_hypothesis(kind: SuppositionKind) -> bool {
    matches!(kind, SuppositionKind::Let | SuppositionKind::Assume)
}

fn is_fact(kind: SuppositionKind) -> bool {
    use SuppositionKind::{Fact, Known, Meaning};
    matches!(kind, Fact { .. } | Known | Meaning)
}

/// Whether the word before mathematics gives it as a reason: "since $a = b$".
pub fn is_reason(source: &str, body: Span) -> bool {
    let before = source.get(..body.start).unwrap_or_default();
    let before = before.trim_end_matches(|c: char| !c.is_alphabetic());
    let word = before.rsplit(|c: char| !c.is_alphabetic()).next();
    // "They have the same size where $s = t$" says at which place.
    let is_place = |word: &str| {
        let before = before[..before.len() - word.len()].trim_end();
        word == "where" && before.ends_with(char::is_alphabetic)
    };
    word.is_some_and(|word| REASONS.has_in_any_case(word) && !is_place(word))
        || follows_a_reason(source, body)
}

/// Whether the clause before mathematics gives a reason in words: "Since no heat is lost, $a = b$".
fn follows_a_reason(source: &str, body: Span) -> bool {
    let before = source.get(..body.start).unwrap_or_default();
    let before =
        before.trim_end_matches(|c: char| c.is_whitespace() || matches!(c, '$' | '(' | '\\'));
    let Some(before) = before.strip_suffix(',') else {
        return false;
    };
    let clause = before.rsplit([',', '.', ';', ':', '$', '}', ')']).next();
    let mut words = clause.unwrap_or_default().split_whitespace();
    let (first, next) = (words.next(), words.next());
    let rest = words.count();
    let is =
        |word: Option<&str>, among: &[&str]| word.is_some_and(|word| among.has_in_any_case(word));
    // "As a check," gives none.
    let describes = is(
        next,
        &[
            "a", "an", "in", "for", "we", "to", "with", "can", "shown", "expected",
        ],
    );
    is(first, &["since", "because"]) && rest > 0 || is(first, &["as"]) && rest > 1 && !describes
}

/// Whether one of these words, in lower case, stands before what is at `index`.
fn follows(index: usize, tokens: &[Placed<'_>], words: &(impl Listed + ?Sized)) -> bool {
    let before = index.checked_sub(1).and_then(|before| tokens.get(before));
    before.is_some_and(|(token, _)| token.is_among(words))
}

fn follows_comma(index: usize, tokens: &[Placed<'_>]) -> bool {
    let before = index.checked_sub(1).map(|before| tokens[before].0);
    before == Some(Token::Mark(','))
}

/// Whether the words before the mathematics at `index` say that it is known: "we are told that", "was measured to be".
fn tells_that(index: usize, tokens: &[Placed<'_>]) -> bool {
    let word = |by: usize| match index.checked_sub(by).and_then(|at| tokens.get(at)) {
        Some((token @ Token::Word(_), _)) => Some(*token),
        _ => None,
    };
    let is = |by: usize, words: &[&str]| word(by).is_some_and(|own| own.is_among(words));
    let is_known = |by: usize| word(by).is_some_and(|own| own.is_among(&KNOWN));
    if is(1, &["that"]) {
        let mut before = (2..=MOST_DESCRIBING + 2).take_while(|&by| word(by).is_some());
        return before.any(is_known);
    }
    // "We measured $h = 1.20\,\mathrm{m}$"
    is(1, &["be"]) && is(2, &["to"]) && is_known(3)
        || is(1, &["measured"]) && is(2, &["we", "i", "have"])
}

/// Whether mathematics stands two tokens before what is at `index`: one word is between them.
fn ends_before(body: Span, index: usize, tokens: &[Placed<'_>]) -> bool {
    let before = index.checked_sub(2).and_then(|before| tokens.get(before));
    matches!(before, Some((Token::Math(own), _)) if *own == body)
}

/// Whether what stands before the mathematics at `index` makes it a fact of its own: "For a target at rest, $u_2 = 0$, …".
fn is_plain(index: usize, tokens: &[Placed<'_>]) -> bool {
    let before = index.checked_sub(1).map(|before| tokens[before].0);
    matches!(before, Some(Token::Mark(',')) | None)
        || follows(index, tokens, &["with", "since", "because", "using", "is"])
}

/// Whether the mathematics at `index` is told where something begins, or what it is called, and supposed to be no value.
///
/// "With $g = G M/R^2$ at the surface" is a value: an origin is a number.
fn is_origin(index: usize, math: &str, reach: Reach, tokens: &[Placed<'_>]) -> bool {
    let starts = || reach == Reach::Sentence && follows(index, tokens, &NAMED_BEFORE);
    let after = tokens.get(index + 1).map(|(token, _)| *token);
    let placed = matches!(after, Some(Token::Word("at" | "when"))) && !is_number(math);
    // "Let $v > 0$ be the speed" names it and says its sign, "Let $\mu = a b$ be the reduced mass" what it is.
    let named = || is_named(index, tokens) && !placed && !is_bound(math);
    named() && (is_number(math) || equals_a_name(math)) || starts()
}

/// Whether what comes after the mathematics at `index` says for which number it is so: "$q = q_0$ at $t = 0$".
fn is_at_a_value(source: &str, index: usize, tokens: &[Placed<'_>]) -> bool {
    let rest = tokens.get(index + 1..).unwrap_or_default();
    let [(first, _), rest @ ..] = rest else {
        return false;
    };
    let skipped = rest
        .iter()
        .take_while(|(token, _)| token.is_among(&["the", "time", "place", "point"]))
        .count();
    let place = rest.get(skipped).map(|(token, _)| *token);
    first.is_among(&["at", "when"])
        && matches!(place, Some(Token::Math(body))
            if source.get(body.range()).is_some_and(|text| is_value(text) && is_number(text)))
}

/// Whether what comes after the mathematics at `index` says at which place it is so: "Setting $F = m g$ at $v = u$".
fn is_at_a_place(source: &str, index: usize, tokens: &[Placed<'_>]) -> bool {
    let rest = tokens.get(index + 1..).unwrap_or_default();
    matches!(rest, [(Token::Word("at"), _), (Token::Math(body), _), ..]
        if source.get(body.range()).is_some_and(is_value))
}

/// Whether what comes after the mathematics at `index` makes it a name.
fn is_named(index: usize, tokens: &[Placed<'_>]) -> bool {
    match tokens.get(index + 1) {
        Some((Token::Word(word), _)) => NAMED_AFTER.has(word),
        _ => false,
    }
}

/// Whether the word at `index` leaves special cases behind: "in general", "in the general case", "without this assumption", "let us
/// return to"; or cases and moments alone: "for arbitrary $w$", "Later", "In between".
fn generalizes(word: &str, index: usize, tokens: &[Placed<'_>]) -> Option<SuppositionKind> {
    use SuppositionKind::{Elsewhere, General};
    let before = |by: usize| match index.checked_sub(by).and_then(|at| tokens.get(at)) {
        Some((Token::Word(word), _)) => *word,
        _ => "",
    };
    let (last, second) = (before(1), before(2));
    let is_one = |word: &str, words: &[&str]| words.has_in_any_case(word);
    let after = |one: &str| is_in_any_case(last, one);
    let is = |said: bool, kind| said.then_some(kind);
    match word {
        "general" => {
            let the = || after("the") && is_one(second, &["in", "to", "for"]);
            is(after("in") || the(), General)
        }
        "generally" => Some(General),
        "assumption" | "restriction" | "supposition" => {
            const DROPPING: &[&str] = &["dropping", "drop", "lifting", "relaxing", "without"];
            let one = is_one(last, &["this", "that", "the", "our"]);
            is(one && is_one(second, DROPPING), General)
        }
        "to" => is(after("return"), General),
        // "Now we include friction again", "Restoring the friction", "no longer neglecting friction"
        "again" => is(recalls(index, tokens), General),
        "restoring" | "reinstating" | "reinstate" => is(last.is_empty() || after("we"), General),
        "neglect" | "neglecting" | "ignore" | "ignoring" | "assume" | "assuming" => {
            is(after("longer") && is_one(second, &["no"]), General)
        }
        "cases" => is(after("all") && is_one(second, &["in"]), Elsewhere),
        "all" | "any" | "every" if after("at") => is(second.is_empty(), Elsewhere),
        "arbitrary" | "all" | "any" | "every" => is(after("for"), Elsewhere),
        "between" => is(after("in"), Elsewhere),
        "later" | "otherwise" | "else" | "elsewhere" | "meanwhile" => {
            is(last.is_empty(), Elsewhere)
        }
        word if REGIMES.has(word) => is(last.is_empty(), Elsewhere),
        _ => None,
    }
}

/// Whether the words before "again" say that something is taken into account: "Now we include friction again".
fn recalls(index: usize, tokens: &[Placed<'_>]) -> bool {
    const RECALLING: &[&str] = &[
        "include",
        "including",
        "allow",
        "allowing",
        "restore",
        "restoring",
        "admit",
        "reinstate",
        "account",
        "switch",
        "turn",
    ];
    let before = tokens[..index].iter().rev();
    let mut words = before.map_while(|(token, _)| match token {
        Token::Word(_) => Some(*token),
        _ => None,
    });
    words
        .by_ref()
        .take(MOST_RECALLED)
        .any(|word| word.is_among(RECALLING))
}

impl Reach {
    fn past_word(self, word: &str) -> Option<Reach> {
        let (patience, found, short) = match self {
            Reach::Sentence => return Some(self),
            Reach::List { .. } => return (word == "and").then_some(self),
            Reach::Joined {
                patience,
                found,
                short,
                ..
            } => (patience, found, short),
        };
        let patience = patience.checked_sub(1)?;
        let joins = matches!(word, "and" | "that" | "both" | "also");
        (joins || !found).then_some(Reach::Joined {
            patience,
            comma: false,
            found,
            short,
        })
    }

    fn past_math(self, relation: bool) -> Option<Reach> {
        Some(match self {
            Reach::Joined {
                patience,
                found,
                short,
                ..
            } => Reach::Joined {
                patience,
                comma: false,
                found: found || relation,
                short,
            },
            Reach::List { left } => Reach::List {
                left: left.saturating_sub(1),
            },
            Reach::Sentence => self,
        })
    }

    fn past_comma(self) -> Option<Reach> {
        match self {
            Reach::Sentence => Some(self),
            Reach::List { left } => (left > 0).then_some(self),
            Reach::Joined {
                found,
                short,
                comma,
                ..
            } if !found || short || comma => None,
            Reach::Joined {
                patience,
                found,
                short,
                ..
            } => Some(Reach::Joined {
                patience,
                comma: true,
                found,
                short,
            }),
        }
    }
}
