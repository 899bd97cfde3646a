//! Checks before a file is read: the syntax of TOML, the version of the schema.

use super::error::Fault;
use super::schema::SCHEMA_VERSION;
use super::syntax_slips::slip;
use super::wrong::{WrongKey, WrongNumber, WrongToml, of_parser};
use toml::de::DeTable;

/// Errors of a text that is not TOML: the slip that causes all others, or the first fault of each line.
pub(super) fn of_syntax(errors: &[toml::de::Error], text: &str) -> Vec<Fault> {
    if let Some(fault) = slip(text) {
        return vec![fault];
    }
    let mut errors: Vec<&toml::de::Error> = errors.iter().collect();
    let start = |error: &toml::de::Error| error.span().map_or(0, |span| span.start);
    errors.sort_by_key(|error| start(error));
    let line = |error: &toml::de::Error| {
        text.get(..start(error))
            .map_or(0, |before| before.matches('\n').count())
    };
    errors.dedup_by_key(|error| line(error));
    errors.into_iter().map(|error| of_toml(error, text)).collect()
}

/// A fault of TOML itself.
pub(super) fn of_toml(error: &toml::de::Error, text: &str) -> Fault {
    let span = error.span().unwrap_or(0..0);
    let first = error.message().lines().next().unwrap_or_default();
    let rest: Vec<&str> = error.message().lines().skip(1).collect();
    let mut fault = Fault::new(span.clone(), "", WrongToml::ThisIsNotToml(of_parser(first)));
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
    if first.contains("string values must be quoted")
        && let Some(written) = bare_ratio(text.get(span.start..).unwrap_or_default())
    {
        fault = fault.help(WrongKey::PutItInQuotes(written.to_owned()));
    }
    if first.contains("escaped value") || first.contains("unicode value digits") {
        let string = whole[..before.len()].rfind('"').map_or("", |at| &whole[at + 1..]);
        let path = string.split('"').next().unwrap_or_default().replace('\\', "/");
        fault = fault.help(WrongToml::BackslashBeginsSign(path));
    }
    if first.contains("unquoted key") && span.start < span.end {
        fault = fault.help(of_key(&whole, text.get(span.clone()).unwrap_or_default()));
    }
    if first.contains("duplicate key") {
        let line = text.get(span).unwrap_or_default();
        fault = fault.help(WrongToml::IsGivenTwiceIn(line.to_string()));
    }
    fault
}

/// A ratio of two numbers at the beginning of a text, "1/85".
fn bare_ratio(text: &str) -> Option<&str> {
    let is_part = |sign: char| sign.is_ascii_digit() || matches!(sign, '/' | '.' | '-' | '+');
    let written = &text[..text.find(|sign| !is_part(sign)).unwrap_or(text.len())];
    let (above, below) = written.split_once('/')?;
    let is_number = |part: &str| part.parse::<f64>().is_ok();
    (is_number(above) && is_number(below)).then_some(written)
}

/// The remedy for a key that is not bare: the intended key, or its name in quotes.
fn of_key(line: &str, given: &str) -> WrongToml {
    let is_bare = |part: &str| {
        part.bytes()
            .all(|b| b.is_ascii_alphanumeric() || matches!(b, b'-' | b'_'))
    };
    let quote = |part: &str| match is_bare(part) || part.starts_with(['"', '\'']) {
        true => part.to_owned(),
        false => format!("\"{part}\""),
    };
    let header = line
        .trim()
        .strip_prefix('[')
        .and_then(|rest| rest.split(']').next());
    if let Some(name) = header.map(|name| name.trim_start_matches('[')) {
        let table = name.split('.').next().unwrap_or_default().trim();
        if let Some(key) = english_key(table) {
            return WrongToml::KeyIs {
                given: table.to_owned(),
                key: key.to_owned(),
            };
        }
        let parts: Vec<String> = name.split('.').map(|part| quote(part.trim())).collect();
        return WrongToml::QuoteKey(format!("[{}]", parts.join(".")));
    }
    let is_part = |sign: char| !sign.is_whitespace() && !"{}[],.=".contains(sign);
    let word = line.find(given).map_or(given, |at| {
        let end = line[at..]
            .find(|sign| !is_part(sign))
            .map_or(line.len(), |to| at + to);
        &line[at..end]
    });
    match english_key(word) {
        Some(key) => WrongToml::KeyIs {
            given: word.to_owned(),
            key: key.to_owned(),
        },
        None => WrongToml::QuoteKey(format!("\"{word}\"")),
    }
}

/// The key for a Korean word; two where it depends on the table.
fn english_key(word: &str) -> Option<&'static str> {
    const KEYS: [(&[&str], &str); 33] = [
        (&["이름", "명칭"], "name"),
        (&["종류"], "kind"),
        (&["단위"], "units"),
        (&["무게", "중량", "자중"], "weight"),
        (&["질량"], "mass"),
        (&["길이"], "length"),
        (&["높이", "층고"], "height"),
        (&["폭", "너비"], "width (breadth of a link)"),
        (&["깊이", "두께"], "depth"),
        (&["지름", "직경"], "diameter"),
        (&["무게중심"], "centroid"),
        (&["접합면폭", "접합면"], "bed_width"),
        (&["밀도"], "density"),
        (&["마찰", "마찰계수"], "friction"),
        (&["강성"], "stiffness"),
        (&["힘"], "force"),
        (&["축력"], "axial_force"),
        (&["부재"], "links (or blocks)"),
        (&["접합부"], "joints"),
        (&["층"], "storeys (or floors)"),
        (&["바닥"], "floors"),
        (&["감쇠", "감쇠비"], "damping_ratio"),
        (&["조사"], "survey"),
        (&["기온", "온도"], "temperature_c"),
        (&["기울기"], "tilt"),
        (&["진동수", "고유진동수", "주파수"], "frequencies"),
        (&["파일"], "file"),
        (&["열", "컬럼"], "column"),
        (&["방향"], "direction"),
        (&["위치"], "position"),
        (&["채널"], "channels"),
        (&["바람", "풍하중"], "wind"),
        (&["부지", "지진"], "site"),
    ];
    KEYS.iter()
        .find(|(words, _)| words.contains(&word))
        .map(|(_, key)| *key)
}

/// A number with a comma, and the bytes of its line before it.
struct WithComma<'a> {
    at: usize,
    written: &'a str,
}

/// A bare number with a comma after an equals sign, "0,95" or "1,200.5": the last one before the place of the reader's error.
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

/// The error of such a number, with its right form: a comma before three digits may be a decimal sign or separate thousands.
fn of_comma(number: WithComma<'_>, line_at: usize) -> Fault {
    let WithComma { at, written } = number;
    let span = line_at + at..line_at + at + written.len();
    let number = written.to_owned();
    let fault = Fault::new(span, "", WrongToml::NumberHoldsComma(number)).allowed(WrongNumber::UnclearNumber);
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
        (true, false) => WrongToml::DecimalCommaWrite(point),
        (false, _) => WrongToml::ThousandsWrite(none),
    })
}

/// The version is checked first: a newer file may differ in everything else.
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
        WrongToml::SchemaIsNotKnown(given.as_str().to_string()),
    );
    let fault = fault.allowed(WrongToml::MustBe(SCHEMA_VERSION.to_string()));
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
