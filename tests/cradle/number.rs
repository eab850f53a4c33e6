//! Numbers as a person types them.

use cradle_verify::cradle::{NumberError, parse_exact, parse_list};

#[test]
fn every_notation_spells_the_rational_it_seems_to() {
    for (text, value) in [
        ("2", "2"),
        ("+2", "2"),
        ("-1", "-1"),
        ("−1", "-1"),
        (" 2/3 ", "2/3"),
        ("2 / -6", "-1/3"),
        ("0.10", "1/10"),
        (".5", "1/2"),
        ("5.", "5"),
        ("1e-3", "1/1000"),
        ("-2.5E+2", "-250"),
        ("0.5/1.5", "1/3"),
        ("-0", "0"),
    ] {
        assert_eq!(parse_exact(text).unwrap().to_string(), value, "{text}");
    }
}

#[test]
fn what_is_no_number_is_named() {
    for text in [
        "x", "1/2/3", "--1", "+-1", ".", "-", "1.2.3", "1e", "1e2.5", "e5", "0x10", "1 2", "١",
        "inf", "NaN", "/2",
    ] {
        assert_eq!(
            parse_exact(text),
            Err(NumberError::NotANumber(text.to_owned()))
        );
    }
    assert_eq!(parse_exact("  "), Err(NumberError::Empty));
    assert_eq!(
        parse_exact("1/0.0"),
        Err(NumberError::DividesByZero("1/0.0".into()))
    );
    assert_eq!(parse_list("1,,2"), Err(NumberError::Empty));
    assert_eq!(
        parse_list("1, two"),
        Err(NumberError::NotANumber("two".into()))
    );
}

#[test]
fn a_number_can_not_ask_for_all_of_memory() {
    assert!(parse_exact("1e100").is_ok());
    for text in ["1e101", "1e-101", "1e99999999999999999999999", "1/1e101"] {
        assert_eq!(
            parse_exact(text),
            Err(NumberError::ExponentTooLarge(text.to_owned()))
        );
    }
    assert!(parse_exact(&"9".repeat(100)).is_ok());
    assert_eq!(
        parse_exact(&"9".repeat(101)),
        Err(NumberError::TooLong(101))
    );
    assert_eq!(
        parse_list(&"1,".repeat(1000)),
        Err(NumberError::TooManyItems(1001))
    );
}
