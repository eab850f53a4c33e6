//! The part of JSON Schema (draft 4) that the schema of SARIF uses on what is written.

use serde_json::Value;

/// What is wrong with a value, each with its place; nothing if it is as the schema says.
pub fn faults(value: &Value, schema: &Value) -> Vec<String> {
    let mut found = Vec::new();
    check(value, schema, schema, "$", &mut found);
    found
}

fn check(value: &Value, schema: &Value, root: &Value, place: &str, found: &mut Vec<String>) {
    let Some(rules) = schema.as_object() else {
        panic!("{place}: the schema is no object");
    };
    let mut fault = |what: String| found.push(format!("{place}: {what}"));
    let mut inner: Vec<(&Value, &Value, String)> = Vec::new();
    for (key, rule) in rules {
        match key.as_str() {
            "$ref" => {
                let pointer = rule.as_str().unwrap().trim_start_matches('#');
                inner.push((value, root.pointer(pointer).unwrap(), place.to_owned()));
            }
            "type" => {
                let names: Vec<&str> = match rule {
                    Value::Array(all) => all.iter().filter_map(Value::as_str).collect(),
                    one => vec![one.as_str().unwrap()],
                };
                if !names.iter().any(|name| is_a(value, name)) {
                    fault(format!("{value} is no {rule}"));
                }
            }
            "enum" => {
                if !rule.as_array().unwrap().contains(value) {
                    fault(format!("{value} is none of {rule}"));
                }
            }
            "required" => {
                for name in rule.as_array().unwrap() {
                    if value.is_object() && value.get(name.as_str().unwrap()).is_none() {
                        fault(format!("lacks {name}"));
                    }
                }
            }
            "minimum" | "maximum" => {
                let (own, bound) = (value.as_f64(), rule.as_f64().unwrap());
                let right = own.is_none_or(|own| match key.as_str() {
                    "minimum" => own >= bound,
                    _ => own <= bound,
                });
                if !right {
                    fault(format!("{value} is beyond {rule}"));
                }
            }
            "minItems" => {
                let few = |all: &Vec<Value>| (all.len() as u64) < rule.as_u64().unwrap();
                if value.as_array().is_some_and(few) {
                    fault("has too few items".into());
                }
            }
            "uniqueItems" => {
                let all = value.as_array().map_or(&[][..], |all| all);
                let again = |(at, one): (usize, &Value)| all[..at].contains(one);
                if rule == true && all.iter().enumerate().any(again) {
                    fault("has an item twice".into());
                }
            }
            "anyOf" | "oneOf" => {
                let passes = |own: &&Value| {
                    let mut inside = Vec::new();
                    check(value, own, root, place, &mut inside);
                    inside.is_empty()
                };
                let number = rule.as_array().unwrap().iter().filter(passes).count();
                if number == 0 || key == "oneOf" && number > 1 {
                    fault(format!("matches {number} of {key}"));
                }
            }
            "items" => {
                for (at, item) in value.as_array().into_iter().flatten().enumerate() {
                    inner.push((item, rule, format!("{place}[{at}]")));
                }
            }
            "format" => {
                let text = value.as_str().unwrap_or_default();
                let allowed = |c: char| c.is_ascii_graphic() && !"<>\"{}|\\^`".contains(c);
                match rule.as_str().unwrap() {
                    "uri" | "uri-reference" if text.chars().all(allowed) => {}
                    other => fault(format!("{value} is no {other}")),
                }
            }
            // Texts with a pattern are not written; if one ever is, this must learn the pattern.
            "pattern" => fault(format!("{value} would have to match {rule}")),
            "properties" | "additionalProperties" => {}
            "$schema" | "$defs" | "id" | "title" | "description" | "default" | "definitions" => {}
            other => panic!("{place}: the schema uses `{other}`"),
        }
    }
    for (name, item) in value.as_object().into_iter().flatten() {
        let place = format!("{place}.{name}");
        match (
            schema.get("properties").and_then(|own| own.get(name)),
            schema.get("additionalProperties"),
        ) {
            (Some(rule), _) => inner.push((item, rule, place)),
            (None, Some(Value::Bool(false))) => found.push(format!("{place} is not in the schema")),
            (None, Some(rule)) if rule.is_object() => inner.push((item, rule, place)),
            _ => {}
        }
    }
    for (value, schema, place) in inner {
        check(value, schema, root, &place, found);
    }
}

fn is_a(value: &Value, name: &str) -> bool {
    match name {
        "object" => value.is_object(),
        "array" => value.is_array(),
        "string" => value.is_string(),
        "integer" => value.is_i64() || value.is_u64(),
        "number" => value.is_number(),
        "boolean" => value.is_boolean(),
        "null" => value.is_null(),
        other => panic!("type {other}"),
    }
}
