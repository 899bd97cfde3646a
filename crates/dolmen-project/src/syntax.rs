//! What is looked at before a file is read: the syntax of TOML, the version of the schema.

use super::error::Fault;
use super::schema::SCHEMA_VERSION;
use super::wrong::{WrongToml, of_parser};
use toml::de::DeTable;

/// A fault of TOML itself.
pub(super) fn of_toml(error: &toml::de::Error, text: &str) -> Fault {
    let span = error.span().unwrap_or(0..0);
    let first = error.message().lines().next().unwrap_or_default();
    let rest: Vec<&str> = error.message().lines().skip(1).collect();
    let mut fault = Fault::new(
        span.clone(),
        "",
        WrongToml::ThisIsNotToml {
            first: of_parser(first),
        },
    );
    if !rest.is_empty() {
        fault = fault.allowed(rest.join(", "));
    }
    let bare_point = text.get(..span.start).and_then(|before| before.chars().last());
    let at_point =
        text.get(span.start..).is_some_and(|rest| rest.starts_with('.')) || bare_point == Some('.');
    if first.contains("mantissa") && at_point {
        fault = fault.help(WrongToml::NumberBeginsWithDigit);
    }
    let line = text
        .get(span.start..)
        .map_or("", |rest| rest.lines().next().unwrap_or_default());
    let before = text
        .get(..span.start)
        .and_then(|all| all.rsplit('\n').next())
        .unwrap_or_default();
    let whole = format!("{before}{line}");
    if whole.contains(['“', '”', '‘', '’', '„', '「', '」']) {
        fault = fault.help(WrongToml::CurlyQuotesAreNo);
    } else if let Some(written) = decimal_comma(&whole) {
        fault = fault.help(WrongToml::DecimalCommaWrite {
            number: written.replace(',', "."),
        });
    }
    if first.contains("duplicate key") {
        let line = text.get(span).unwrap_or_default();
        fault = fault.help(WrongToml::IsGivenTwiceIn {
            line: line.to_string(),
        });
    }
    fault
}

/// A number with a decimal comma behind an equals sign: "2,5".
fn decimal_comma(line: &str) -> Option<&str> {
    let (_, value) = line.split_once('=')?;
    let value = value.trim();
    let is_part = |c: char| c.is_ascii_digit() || c == ',' || c == '-';
    let end = value.find(|c: char| !is_part(c)).unwrap_or(value.len());
    let number = &value[..end];
    let (whole, part) = number.split_once(',')?;
    let digits = |text: &str| !text.is_empty() && text.chars().all(|c| c.is_ascii_digit());
    (digits(whole.trim_start_matches('-')) && digits(part)).then_some(number)
}

/// The version is looked at first: a newer file may differ in everything else.
pub(super) fn version(root: &DeTable<'_>) -> Result<(), Vec<Fault>> {
    let Some((given, span)) = root
        .get("schema")
        .and_then(|node| Some((node.get_ref().as_integer()?, node.span())))
    else {
        return Ok(());
    };
    let number = i64::from_str_radix(given.as_str(), given.radix()).ok();
    if number == Some(SCHEMA_VERSION) {
        return Ok(());
    }
    let fault = Fault::new(
        span,
        "schema",
        WrongToml::SchemaIsNotKnown {
            given: given.as_str().to_string(),
        },
    );
    let fault = fault.allowed(WrongToml::MustBe {
        version: SCHEMA_VERSION.to_string(),
    });
    let dolmen = env!("CARGO_PKG_VERSION");
    let help = match number {
        Some(number) if number > SCHEMA_VERSION => WrongToml::FileIsOfNewer {
            dolmen: dolmen.to_string(),
            version: SCHEMA_VERSION.to_string(),
            number: number.to_string(),
        },
        _ => WrongToml::DolmenReadsSchemaWrite {
            dolmen: dolmen.to_string(),
            version: SCHEMA_VERSION.to_string(),
        },
    };
    Err(vec![fault.help(help)])
}
