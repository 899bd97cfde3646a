//! What is looked at before a file is read: the syntax of TOML, the version of the schema.

use super::error::Fault;
use super::schema::SCHEMA_VERSION;
use super::wrong::{WrongNumber, WrongToml, of_parser};
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
    } else if let Some(number) = number_with_comma(&whole, before.len()) {
        fault = of_comma(number, span.start - before.len());
    }
    if first.contains("duplicate key") {
        let line = text.get(span).unwrap_or_default();
        fault = fault.help(WrongToml::IsGivenTwiceIn {
            line: line.to_string(),
        });
    }
    fault
}

/// A number with a comma: the bytes of its line before it, and it.
struct WithComma<'a> {
    at: usize,
    written: &'a str,
}

/// A bare number with a comma behind an equals sign, "0,95" or "1,200.5": the last one that begins before what the reader stumbled on.
fn number_with_comma(line: &str, stumbled_at: usize) -> Option<WithComma<'_>> {
    let signs = line.match_indices('=').map(|(at, _)| at + 1);
    let mut numbers = signs.filter_map(|behind| {
        let at = behind + line[behind..].find(|c: char| !c.is_whitespace())?;
        let value = &line[at..];
        let is_part = |c: char| c.is_ascii_digit() || matches!(c, ',' | '.' | '-' | '+');
        let end = value.find(|c: char| !is_part(c)).unwrap_or(value.len());
        let written = value[..end].trim_end_matches(',');
        let mut groups = written.trim_start_matches(['-', '+']).split([',', '.']);
        let is_number = groups.all(|group| !group.is_empty() && group.bytes().all(|b| b.is_ascii_digit()));
        (is_number && written.contains(',')).then_some(WithComma { at, written })
    });
    numbers.rfind(|number| number.at <= stumbled_at)
}

/// What is wrong with such a number, and how it is written: a comma before three digits may be a decimal sign or part of thousands.
fn of_comma(number: WithComma<'_>, line_at: usize) -> Fault {
    let WithComma { at, written } = number;
    let span = line_at + at..line_at + at + written.len();
    let number = written.to_owned();
    let fault =
        Fault::new(span, "", WrongToml::NumberHoldsComma { number }).allowed(WrongNumber::UnclearNumber);
    let (point, none) = (written.replace(',', "."), written.replace(',', ""));
    let commas = written.matches(',').count();
    let is_thousands = written.split(',').skip(1).all(|group| {
        let whole = group.split('.').next().unwrap_or_default();
        whole.len() == 3
    });
    let is_decimal = commas == 1 && !written.contains('.');
    fault.help(match (is_decimal, is_thousands) {
        (true, true) => WrongToml::CommaOfThousandsOrDecimals {
            thousands: none,
            decimal: point,
        },
        (true, false) => WrongToml::DecimalCommaWrite { number: point },
        (false, _) => WrongToml::ThousandsWrite { number: none },
    })
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
