//! The author's definitions: `\newcommand`, `\def`, `\let`, `\newenvironment` and their like.

use std::rc::Rc;

use super::assemble::Assembler;
use super::token::Token;

/// What a command stands for.
#[derive(Clone, Debug)]
pub(super) struct Macro {
    pub parameters: usize,
    /// What the first argument is where it is not given in brackets.
    pub default: Option<Vec<Token>>,
    /// A star or an option after the name is passed over: sizes of delimiters.
    pub sized: bool,
    pub body: Vec<Token>,
}

/// What a command means.
#[derive(Clone, Debug)]
pub(super) enum Meaning {
    Macro(Rc<Macro>),
    /// It is defined in a way that is not followed; why.
    Unknown(&'static str),
}

/// An environment of the author's.
#[derive(Clone, Debug)]
pub(super) struct Environment {
    pub begin: Rc<Macro>,
    pub end: Rc<Macro>,
}

impl Assembler<'_> {
    pub(super) fn begin_scope(&mut self) {
        self.scopes.push(self.undo.len());
    }

    pub(super) fn end_scope(&mut self) {
        let Some(from) = self.scopes.pop() else {
            return;
        };
        for (name, before) in self.undo.split_off(from).into_iter().rev() {
            match before {
                Some(meaning) => self.macros.insert(name, meaning),
                None => self.macros.remove(&name),
            };
        }
    }

    fn set(&mut self, name: String, meaning: Meaning, global: bool) {
        let before = self.macros.insert(name.clone(), meaning);
        if global {
            self.undo.retain(|(own, _)| *own != name);
        } else if !self.scopes.is_empty() {
            self.undo.push((name, before));
        }
    }

    /// That a name is defined where its definition is not followed.
    pub(super) fn set_unknown(&mut self, name: String, why: &'static str) {
        self.set(name, Meaning::Unknown(why), false);
    }

    /// Reads a definition, if the command is one.
    pub(super) fn defines(&mut self, token: Token, name: &str) -> bool {
        let done = match name {
            "newcommand" | "renewcommand" | "providecommand" | "DeclareRobustCommand" => {
                self.new_command(token, name)
            }
            "def" | "gdef" => self.plain_definition(name == "gdef"),
            "edef" | "xdef" => {
                let defined = self.command_name();
                let body = self.next_token().and_then(|open| self.group_after(open));
                if let (Some(defined), Some(_)) = (&defined, body) {
                    let why = "it is defined by `\\edef`, which is not followed";
                    self.set(defined.clone(), Meaning::Unknown(why), name == "xdef");
                }
                defined.map(drop)
            }
            "long" | "outer" | "protected" => Some(()),
            "global" => {
                self.skip_blank();
                match self.next_token() {
                    Some(next) if self.text(next) == "\\def" => self.plain_definition(true),
                    Some(next) if self.text(next) == "\\let" => self.alias(true),
                    Some(next) => {
                        self.put_back(next);
                        Some(())
                    }
                    None => None,
                }
            }
            "let" => self.alias(false),
            "DeclareMathOperator" => self.operator(token),
            "DeclarePairedDelimiter" => self.delimiters(token),
            "NewDocumentCommand"
            | "RenewDocumentCommand"
            | "ProvideDocumentCommand"
            | "DeclareDocumentCommand" => self.document_command(),
            "newenvironment" | "renewenvironment" => self.new_environment(),
            _ => return false,
        };
        if done.is_none() {
            let message = format!("this `\\{name}` is not followed");
            self.problem(token.origin, message, "write `\\newcommand{\\name}[2]{…}`");
        }
        true
    }

    /// The name of the command to be defined, with or without braces.
    fn command_name(&mut self) -> Option<String> {
        self.skip_blank();
        let first = self.next_token()?;
        let tokens = match self.text(first) {
            "{" => self.group_after(first)?,
            _ => vec![first],
        };
        let spelt = self.spelt(&tokens);
        let name = spelt.trim().strip_prefix('\\')?;
        (!name.is_empty()).then(|| name.to_owned())
    }

    fn star(&mut self) {
        self.skip_blank();
        if let Some(next) = self.next_token()
            && self.text(next) != "*"
        {
            self.put_back(next);
        }
    }

    /// How many arguments, and the default of the first.
    fn parameters(&mut self) -> Option<(usize, Option<Vec<Token>>)> {
        let Some(count) = self.optional() else {
            return Some((0, None));
        };
        let count: usize = self.spelt(&count).trim().parse().ok()?;
        (count <= 9).then_some(())?;
        let default = self.optional();
        Some((count, default))
    }

    fn new_command(&mut self, token: Token, how: &str) -> Option<()> {
        self.star();
        let name = self.command_name()?;
        let (parameters, default) = self.parameters()?;
        let body = self.argument()?;
        if let Some(counter) = name.strip_prefix("the").filter(|c| !c.is_empty()) {
            // How numbers are printed is for the scanner, which counts.
            self.number_format(token, counter, &body);
            if matches!(counter, "equation" | "section" | "chapter" | "subsection") {
                return Some(());
            }
        }
        let known = self.macros.contains_key(&name) || crate::notation::is_command(&name);
        if how == "providecommand" && known {
            return Some(());
        }
        let meaning = Macro {
            parameters,
            default,
            sized: false,
            body,
        };
        self.set(name, Meaning::Macro(Rc::new(meaning)), false);
        Some(())
    }

    fn number_format(&mut self, token: Token, counter: &str, body: &[Token]) {
        if !matches!(counter, "equation" | "section" | "chapter" | "subsection") {
            return;
        }
        self.emit(token);
        let text = format!("{{{counter}}}{{{}}}", self.spelt(body));
        self.insert(&text, token.origin);
    }

    /// `\def\name#1#2{…}`
    fn plain_definition(&mut self, global: bool) -> Option<()> {
        let name = self.command_name()?;
        let (mut parameters, mut delimited) = (0, false);
        let body = loop {
            let token = self.next_token()?;
            match self.text(token) {
                "{" => break self.group_after(token)?,
                "#" => {
                    let digit = self.next_token()?;
                    let number: usize = self.text(digit).parse().unwrap_or(0);
                    delimited |= number != parameters + 1;
                    parameters += 1;
                }
                text if text.trim().is_empty() => {}
                _ => delimited = true,
            }
        };
        let meaning = match delimited {
            true => Meaning::Unknown("its arguments are delimited by other signs than braces"),
            false => Meaning::Macro(Rc::new(Macro {
                parameters,
                default: None,
                sized: false,
                body,
            })),
        };
        self.set(name, meaning, global);
        Some(())
    }

    /// `\let\new=\old`: the meaning of now, whatever becomes of the old name.
    fn alias(&mut self, global: bool) -> Option<()> {
        let name = self.command_name()?;
        self.skip_blank();
        let mut target = self.next_token()?;
        if self.text(target) == "=" {
            self.skip_blank();
            target = self.next_token()?;
        }
        let old = self.text(target).strip_prefix('\\').map(str::to_owned);
        let meaning = match old.and_then(|old| self.macros.get(&old).cloned()) {
            Some(meaning) => meaning,
            None => Meaning::Macro(Rc::new(Macro {
                parameters: 0,
                default: None,
                sized: false,
                body: vec![Token {
                    frozen: true,
                    ..target
                }],
            })),
        };
        self.set(name, meaning, global);
        Some(())
    }

    /// `\DeclareMathOperator{\sgn}{sgn}` stands for `\operatorname{sgn}`.
    fn operator(&mut self, token: Token) -> Option<()> {
        self.star();
        let name = self.command_name()?;
        let inside = self.argument()?;
        let coin = |text: &str| self.coin(text, token.origin);
        let before = vec![coin("\\operatorname"), coin("{")];
        let body = [before, inside, vec![coin("}")]].concat();
        let meaning = Macro {
            parameters: 0,
            default: None,
            sized: false,
            body,
        };
        self.set(name, Meaning::Macro(Rc::new(meaning)), false);
        Some(())
    }

    /// `\DeclarePairedDelimiter{\abs}{\lvert}{\rvert}`
    fn delimiters(&mut self, token: Token) -> Option<()> {
        let name = self.command_name()?;
        let (left, right) = (self.argument()?, self.argument()?);
        let coin = |text: &str| self.coin(text, token.origin);
        let parameter = vec![coin("#"), coin("1")];
        let body = [left, parameter, right].concat();
        let meaning = Macro {
            parameters: 1,
            default: None,
            sized: true,
            body,
        };
        self.set(name, Meaning::Macro(Rc::new(meaning)), false);
        Some(())
    }

    /// `\NewDocumentCommand{\name}{m m}{…}` where all arguments are plain.
    fn document_command(&mut self) -> Option<()> {
        let name = self.command_name()?;
        let arguments = self.argument()?;
        let arguments: String = self.spelt(&arguments).split_whitespace().collect();
        let body = self.argument()?;
        let meaning = match arguments.chars().all(|c| c == 'm') && arguments.len() <= 9 {
            true => Meaning::Macro(Rc::new(Macro {
                parameters: arguments.len(),
                default: None,
                sized: false,
                body,
            })),
            false => Meaning::Unknown("its arguments are not all plain ones (`m`)"),
        };
        self.set(name, meaning, false);
        Some(())
    }

    fn new_environment(&mut self) -> Option<()> {
        self.star();
        let name = self.argument()?;
        let name = self.spelt(&name).trim().to_owned();
        let (parameters, default) = self.parameters()?;
        let (begin, end) = (self.argument()?, self.argument()?);
        let part = |parameters, default, body| {
            Rc::new(Macro {
                parameters,
                default,
                sized: false,
                body,
            })
        };
        let environment = Environment {
            begin: part(parameters, default, begin),
            end: part(0, None, end),
        };
        self.environments.insert(name, Rc::new(environment));
        Some(())
    }
}
