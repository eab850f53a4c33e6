//! Abbreviations of the `physics` package as they are set: `\dv{x}{t}`, `\abs{x}`, `\qty( … )`.

use super::Setter;
use crate::notation::escape;
use crate::notation::lexer::two_groups_follow;

impl Setter<'_> {
    /// What an abbreviation is set as, behind its name; `None` where it is none.
    pub(super) fn abbreviation(&mut self, name: &str) -> Option<String> {
        let fence = |sign: &str| format!("<mo stretchy=\"true\">{sign}</mo>");
        Some(match name {
            "dv" | "derivative" | "odv" => self.slope("d"),
            "pdv" | "partialderivative" => self.slope("∂"),
            "dd" | "differential" => match self.at_group() {
                true => format!("<mrow><mi>d</mi>{}</mrow>", self.argument()),
                false => "<mi>d</mi>".to_owned(),
            },
            "abs" | "absolutevalue" | "norm" => {
                self.take("*");
                let bar = fence(if name == "norm" { "‖" } else { "|" });
                format!("<mrow>{bar}{}{bar}</mrow>", self.argument())
            }
            "qty" | "quantity" if !two_groups_follow(self.rest) => match self.at_group() {
                true => format!(
                    "<mrow>{}{}{}</mrow>",
                    fence("{"),
                    self.argument(),
                    fence("}")
                ),
                false => "<mrow></mrow>".to_owned(),
            },
            _ => return None,
        })
    }

    fn at_group(&mut self) -> bool {
        self.skip_blank();
        self.rest.starts_with('{')
    }

    /// `\dv[n]{f}{x}`, or `\dv{x}`, or `\pdv{f}{x}{y}`, behind the name.
    fn slope(&mut self, sign: &str) -> String {
        self.take("*");
        let mut order = String::new();
        if let Some((own, rest)) = self.rest.strip_prefix('[').and_then(|r| r.split_once(']')) {
            order = escape(own);
            self.rest = rest;
        }
        let mut groups = vec![self.argument()];
        while groups.len() < 3 && self.at_group() {
            groups.push(self.argument());
        }
        let body = match groups.len() {
            1 => String::new(),
            _ => groups.remove(0),
        };
        if groups.len() > 1 {
            order = groups.len().to_string();
        }
        let raised = |base: &str| match order.as_str() {
            "" => base.to_owned(),
            order => format!("<msup>{base}<mn>{order}</mn></msup>"),
        };
        let sign = format!("<mi>{sign}</mi>");
        let below: Vec<String> = match groups.as_slice() {
            [one] => vec![format!("{sign}{}", raised(one))],
            all => all.iter().map(|own| format!("{sign}{own}")).collect(),
        };
        format!(
            "<mfrac><mrow>{}{body}</mrow><mrow>{}</mrow></mfrac>",
            raised(&sign),
            below.concat()
        )
    }
}
