//! What prose supposes: "Let $v_1 = 0$", "taking $v'_2 \neq 0$", "At $\mu = 1$", "Setting $Q = 0$", "With $g = 10$ …",
//! "For $N = 3$, …", and what a symbol of a display means: "…, where $k = m \omega^2$".
//!
//! A supposition becomes a hypothesis of what follows, so one too many can make anything true.
//! In doubt nothing is read: not a conclusion drawn in the same sentence ("then", "gives"), not an
//! alternative ("or"), not a condition ("if") but one of what the sentence goes on to display, not a negation, not a question, not a proof by contradiction. A value that is
//! named and not supposed is kept as a mention: where a step fails without it, the finding can say so.

mod abbreviation;
mod alternatives;
mod around;
mod cases;
mod common;
mod compared;
mod contrary;
mod denial;
mod example;
mod general;
mod initial;
mod introduction;
mod mathematics;
pub(super) mod named;
mod neglected;
mod over;
mod reach;
mod reason;
mod resting;
mod retraction;
mod stationary;
mod telling;
pub(super) mod titled;
mod unknown;
mod unnamed;
mod vanishing;
mod words;

use crate::sorted::{self, Set};

use self::around::{
    follows, follows_comma, is_at_a_value, is_origin, is_said_of_a_place, is_taken_from, says_where,
};
use self::general::generalizes;
use self::introduction::{introduced, is_condition};
use self::mathematics::{equals_a_name, is_letters, is_number};
use self::reach::Reach;
use self::words::{
    BEFORE_LONG, CONCLUDING, DENYING, DOUBTFUL, HAVING, HYPOTHETICAL, KNOWN, NAMED_BEFORE, NAMING,
    NEGATING, OF_CASES, REGIMES, ROOTS, UNDECIDED,
};
use super::prose::{Placed, Token, ends_sentence, in_lower_case, lead};
use super::words::Words;
use super::{Span, Supposition, SuppositionKind, conclusion};

pub(super) use self::mathematics::{relates, stated};
pub use self::named::GENERAL;
pub use self::reason::{is_everywhere, is_reason, is_tried};

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
    found.extend(compared::read(source, &tokens[..end]));
    found.extend(contrary::read(source, &tokens[..end]));
    // Of two values at once nobody knows which is meant where.
    let both = alternatives::both(source, &tokens[..end]);
    found.retain(|own| !both.contains(&own.body));
    found.extend(alternatives::read(source, &tokens[..end]));
    found.extend(over::read(source, &tokens[..end]));
    found.extend(unknown::read(source, &tokens[..end]));
    found.extend(unnamed::read(source, &tokens[..end]));
    let vanishing = vanishing::read(source, &tokens[..end]);
    found.retain(|own| !vanishing.iter().any(|other| other.body == own.body));
    found.extend(vanishing);
    found.extend(common::read(source, &tokens[..end]));
    found.extend(abbreviation::read(source, &tokens[..end]));
    found.extend(introduced.into_iter().map(|body| Supposition {
        kind: SuppositionKind::Anew,
        body,
    }));
    // "from the rim, where $p = p_0$," is said of the rim alone.
    let is_told = |own: &Supposition| {
        matches!(
            own.kind,
            SuppositionKind::Fact { .. } | SuppositionKind::Meaning | SuppositionKind::Define
        )
    };
    found.retain(|own| !is_told(own) || !is_said_of_a_place(source, own.body));
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
            let body = match kind {
                SuppositionKind::InAllCases => self.tokens[index - 2].1.to(span),
                _ => span,
            };
            self.found.push(Supposition { kind, body });
        }
        // "At $r = 0$ it would be": that is said of what would be so.
        let conditional_mood = || {
            let first = self.tokens[self.sentence.first].0;
            let goes_on = !self.tokens[index..]
                .iter()
                .any(|(token, _)| token.is_stop());
            word == "would" && first.is_among(&OF_CASES) && goes_on
        };
        // "A ball of radius $r = 2 a$ rolls without slipping": only what comes after it is denied.
        let denies_before = among(&DENYING) && word != "without";
        let denies = self.sentence.careful && denies_before && !conditional_mood();
        let unsaid = self.sentence.active.is_some() && self.is_silent() && among(&NEGATING);
        // A "non-trivial" solution is none of the trivial ones.
        let compound = || index > 0 && matches!(self.tokens[index - 1].0, Token::Dash);
        let conditional = || {
            // "The energy is $K = E - E'$, or $$…$$" says the same once more.
            let says_again = word == "or" && index + 1 == self.tokens.len();
            says_again || is_condition(self.source, index, self.tokens)
        };
        // "If, on the contrary, $a \neq b$, we have"
        let first = self.tokens[self.sentence.first].0;
        let of_contrary = || word == "contrary" && self.sentence.begun && first.is_among(&OF_CASES);
        if denies || unsaid || among(&DOUBTFUL) && !compound() && !conditional() && !of_contrary() {
            self.withdraw();
            self.sentence.doubtful = true;
        }
        // "The masses were measured to be" denies nothing.
        let told = || {
            let next = self.tokens.get(index + 1).map(|(token, _)| *token);
            word == "were" && matches!(next, Some(Token::Word(next)) if KNOWN.has(next))
        };
        // "A long cable" is told of, "as long as" not.
        let is_of_length = || word == "long" && !follows(index, self.tokens, &BEFORE_LONG);
        let begins = || !self.sentence.begun || follows_comma(index, self.tokens);
        if matches!(word, "since" | "because" | "as") && begins() {
            self.sentence.reason = Some(false);
        } else if word == "because" && !follows(index, self.tokens, &NEGATING) {
            // "which are not zero because $V > b$": what is denied stands before.
            self.sentence.factual = true;
        }
        if let Some(denied) = &mut self.sentence.reason
            && among(&DENYING)
        {
            *denied = true;
        } else if among(&UNDECIDED) && !is_of_length() || among(&DENYING) && !told() {
            self.sentence.factual = false;
            self.sentence.means &= among(&HYPOTHETICAL);
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
        let says_number = is_number(text);
        // "with root $y \approx 0.919$": what solves an equation is not what is always meant.
        let solves = says_number && follows(index, self.tokens, &ROOTS);
        let states = relates(text) && !solves && !is_taken_from(&self.tokens[index..]);
        let is_zero = text.trim_end().ends_with("= 0");
        // "At $x = h$" says where.
        let is_place = follows(index, self.tokens, &NAMED_BEFORE) && equals_a_name(text);
        let case = SuppositionKind::case(true);
        let labelled = states && cases::is_labelled(self.source, index, self.tokens);
        let labelled = labelled.then_some((case, Reach::List { left: 1 }));
        let active = self.sentence.active.or(labelled);
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
        } else if states && (self.is_known(index) || self.finds_constant(body)) {
            let kind = SuppositionKind::Known;
            self.found.push(Supposition { kind, body });
        } else if states && (self.tells(index, body) || self.draws_from_words(index, body)) {
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
            // "The time of flight follows from $y = 0$:"
            if own.active.is_none() && says_where(index, self.tokens) {
                self.mentions.push(body);
            }
            // "For $N = 3$ the values are $a = b$."
            self.sentence.concluded = true;
        }
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
            if let Case { runs_on, .. } | Fact { runs_on, .. } = &mut supposition.kind {
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
