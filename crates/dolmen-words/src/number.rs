//! Numbers as text: significant digits, a value with its standard deviation, prefixes of units.
//!
//! Results are rounded only here. A narrow no-break space (U+202F) separates groups of digits, and a
//! number from its unit; the minus sign is U+2212.

/// Narrow no-break space between groups of digits, and between a number and its unit.
pub const NARROW_SPACE: char = '\u{202f}';

/// Text for a value that is not a number.
pub const NOT_A_NUMBER: &str = "–";

/// Integers with at least this many digits are grouped by threes (ISO 80000-1 does not group four digits).
const GROUPED_FROM_DIGITS: usize = 5;

/// Smaller numbers than ten to this power are written with a power of ten: 0.00012, but 1.2×10⁻⁵.
const LEAST_EXPONENT: i32 = -4;

/// Numbers of at least ten to this power are written with a power of ten: 1 235 000, but 1.2×10⁷.
const MOST_EXPONENT: i32 = 7;

/// f64 holds about 17 significant digits; more would print noise.
const DIGITS_MOST: usize = 17;

/// Half width of a 95 % interval, in standard deviations of a normal distribution.
pub const TWO_SIDED_95: f64 = 1.96;

/// "1 fault", "3 faults". English only: Korean has no plural.
///
/// ```
/// use dolmen_words::number::counted;
/// assert_eq!((counted(1, "floor", "floors"), counted(0, "floor", "floors")), ("1 floor".to_string(), "0 floors".to_string()));
/// ```
pub fn counted(count: usize, one: &str, many: &str) -> String {
    format!("{count} {}", if count == 1 { one } else { many })
}

/// `value` rounded to `digits` significant digits (1 to 17).
///
/// ```
/// use dolmen_words::number::significant;
/// assert_eq!(significant(253.8271, 4), "253.8");
/// assert_eq!(significant(1_234_567.0, 3), "1\u{202f}230\u{202f}000");
/// assert_eq!(significant(-0.5, 2), "\u{2212}0.50");
/// assert_eq!(significant(4.2e-9, 2), "4.2×10⁻⁹");
/// ```
pub fn significant(value: f64, digits: usize) -> String {
    let digits = digits.clamp(1, DIGITS_MOST);
    if let Some(word) = not_finite(value) {
        return word;
    }
    if value == 0.0 {
        return "0".into();
    }
    // Round once, in decimal, so that 9.996 at 3 digits is 10.0 and not 10.00.
    let rounded = format!("{:.*e}", digits - 1, value.abs());
    let (mantissa, exponent) = rounded.split_once('e').unwrap_or((&rounded, "0"));
    let exponent: i32 = exponent.parse().unwrap_or(0);
    let text = if (LEAST_EXPONENT..MOST_EXPONENT).contains(&exponent) {
        let decimals = (digits as i32 - 1 - exponent).max(0) as usize;
        let value: f64 = rounded.parse().unwrap_or(value.abs());
        grouped(&format!("{value:.decimals$}"))
    } else {
        format!("{mantissa}×10{}", superscript(exponent))
    };
    sign(value) + &text
}

/// `value` with at most `digits` significant digits, without trailing zeros: for values from a user's file.
///
/// ```
/// use dolmen_words::number::trimmed;
/// assert_eq!((trimmed(2.610, 5), trimmed(2930.0, 5)), ("2.61".to_string(), "2930".to_string()));
/// assert_eq!((trimmed(1e9, 6), trimmed(2.5e-7, 4)), ("1×10⁹".to_string(), "2.5×10⁻⁷".to_string()));
/// ```
pub fn trimmed(value: f64, digits: usize) -> String {
    let text = significant(value, digits);
    match text.split_once('.') {
        Some((_, decimals)) if decimals.bytes().all(|b| b.is_ascii_digit()) => {
            text.trim_end_matches('0').trim_end_matches('.').into()
        }
        _ => match text.split_once('×') {
            Some((mantissa, power)) if mantissa.contains('.') => {
                let mantissa = mantissa.trim_end_matches('0').trim_end_matches('.');
                format!("{mantissa}×{power}")
            }
            _ => text,
        },
    }
}

/// A ratio with a limit at 1 (load factor, margin). Adds digits until it no longer reads "1" when it is not 1: 0.99997 at
/// 3 digits is not "1.00".
///
/// ```
/// use dolmen_words::number::beside_one;
/// assert_eq!((beside_one(1.0123, 3), beside_one(0.99997, 3)), ("1.01".to_string(), "0.99997".to_string()));
/// ```
pub fn beside_one(value: f64, digits: usize) -> String {
    let mut digits = digits;
    loop {
        let text = significant(value, digits);
        let reads_one = text.trim_end_matches('0') == "1." || text == "1";
        if !reads_one || value == 1.0 || digits >= DIGITS_MOST {
            return text;
        }
        digits += 1;
    }
}

/// `value` with `decimals` digits after the point.
///
/// ```
/// use dolmen_words::number::fixed;
/// assert_eq!(fixed(-12345.678, 1), "\u{2212}12\u{202f}345.7");
/// assert_eq!(fixed(-0.04, 1), "0.0");
/// ```
pub fn fixed(value: f64, decimals: usize) -> String {
    if let Some(word) = not_finite(value) {
        return word;
    }
    let text = format!("{:.decimals$}", value.abs());
    let zero = text.bytes().all(|b| matches!(b, b'0' | b'.'));
    let sign = if zero { String::new() } else { sign(value) };
    sign + &grouped(&text)
}

/// A value and its standard deviation, both rounded to the same digit: the deviation keeps two digits if its leading
/// three digits are below 355, otherwise one.
///
/// Without a deviation (0 or not a number), the value gets four significant digits.
///
/// ```
/// use dolmen_words::number::with_sd;
/// assert_eq!(with_sd(1.88213, 0.00412), "1.882 ± 0.004");
/// assert_eq!(with_sd(253827.1, 1234.0), "253\u{202f}800 ± 1200");
/// assert_eq!(with_sd(1.88213, 0.0), "1.882");
/// ```
///
/// # Source
/// The rounding rule of the Particle Data Group (Review of Particle Physics, introduction, sec. 5.3).
pub fn with_sd(value: f64, sd: f64) -> String {
    /// A deviation whose leading digits are below this keeps two digits.
    const TWO_DIGITS_BELOW: f64 = 3.55;
    if !value.is_finite() || !sd.is_finite() || sd <= 0.0 {
        return significant(value, 4);
    }
    let exponent = sd.log10().floor() as i32;
    let leading = sd / 10f64.powi(exponent);
    // from 9.5 on, one digit rounds up to 10, which has two digits
    let last = if leading < TWO_DIGITS_BELOW {
        exponent - 1
    } else {
        exponent
    };
    let value_exponent = value.abs().max(sd).log10().floor() as i32;
    if value_exponent >= MOST_EXPONENT || last < -12 {
        let power = 10f64.powi(value_exponent);
        let decimals = (value_exponent - last).clamp(0, 12) as usize;
        return format!(
            "({} ± {})×10{}",
            fixed(value / power, decimals),
            fixed(sd / power, decimals),
            superscript(value_exponent)
        );
    }
    let unit = 10f64.powi(last.max(0));
    let decimals = (-last).max(0) as usize;
    let round = |x: f64| fixed((x / unit).round() * unit, decimals);
    if last < 0 {
        format!("{} ± {}", fixed(value, decimals), fixed(sd, decimals))
    } else {
        format!("{} ± {}", round(value), round(sd))
    }
}

/// A fraction as per cent, with `digits` significant digits: 0.0123 is "1.2 %".
///
/// ```
/// assert_eq!(dolmen_words::number::percent(0.0123, 2), "1.2\u{202f}%");
/// ```
pub fn percent(share: f64, digits: usize) -> String {
    format!("{}{NARROW_SPACE}%", significant(100.0 * share, digits))
}

/// A unit with a prefix, and its conversion factor.
#[derive(Clone, Debug, PartialEq)]
pub struct Prefixed {
    /// Value in this unit = SI value × factor.
    pub factor: f64,
    /// "kN·m/rad".
    pub unit: String,
}

impl Prefixed {
    /// `value_si` in this unit, without the unit: for a table whose head names it.
    pub fn number(&self, value_si: f64, digits: usize) -> String {
        significant(value_si * self.factor, digits)
    }

    /// `value_si` in this unit, with the unit and without trailing zeros: for values from a user's file.
    pub fn trimmed(&self, value_si: f64, digits: usize) -> String {
        format!(
            "{}{NARROW_SPACE}{}",
            trimmed(value_si * self.factor, digits),
            self.unit
        )
    }

    /// `value_si` in this unit, with the unit.
    pub fn text(&self, value_si: f64, digits: usize) -> String {
        format!("{}{NARROW_SPACE}{}", self.number(value_si, digits), self.unit)
    }
}

/// The prefix that suits the largest of `values_si`, for a column or an axis with one unit.
///
/// `unit` is an SI unit: "N·m/rad", "N/m", "N", "kg", "m". Forces, moments and stiffness get the prefixes k, M and G;
/// 1000 kg and more become t; all other units stay as they are.
///
/// ```
/// let unit = dolmen_words::number::prefix(&[253827.1, 1933.8], "N·m/rad");
/// assert_eq!((unit.unit.as_str(), unit.number(1933.8, 4)), ("kN·m/rad", "1.934".to_string()));
/// ```
pub fn prefix(values_si: &[f64], unit: &str) -> Prefixed {
    let most = values_si
        .iter()
        .filter(|v| v.is_finite())
        .fold(0.0, |a: f64, v| a.max(v.abs()));
    let same = Prefixed {
        factor: 1.0,
        unit: unit.into(),
    };
    if unit == "kg" && most >= 1e3 {
        return Prefixed {
            factor: 1e-3,
            unit: "t".into(),
        };
    }
    if !unit.starts_with('N') {
        return same;
    }
    let (factor, letter) = match most {
        m if m >= 1e9 => (1e-9, "G"),
        m if m >= 1e6 => (1e-6, "M"),
        m if m >= 1e3 => (1e-3, "k"),
        _ => return same,
    };
    Prefixed {
        factor,
        unit: format!("{letter}{unit}"),
    }
}

/// A value with its unit, under the prefix that suits it.
///
/// ```
/// assert_eq!(dolmen_words::number::engineering(253827.1, "N·m/rad", 4), "253.8\u{202f}kN·m/rad");
/// ```
pub fn engineering(value_si: f64, unit: &str, digits: usize) -> String {
    prefix(&[value_si], unit).text(value_si, digits)
}

fn not_finite(value: f64) -> Option<String> {
    match value {
        v if v.is_nan() => Some(NOT_A_NUMBER.into()),
        f64::INFINITY => Some("∞".into()),
        f64::NEG_INFINITY => Some("\u{2212}∞".into()),
        _ => None,
    }
}

fn sign(value: f64) -> String {
    if value < 0.0 {
        "\u{2212}".into()
    } else {
        String::new()
    }
}

/// Groups the digits of the integer part by threes, from [`GROUPED_FROM_DIGITS`] digits on.
fn grouped(plain: &str) -> String {
    let (whole, rest) = plain.split_at(plain.find('.').unwrap_or(plain.len()));
    if whole.len() < GROUPED_FROM_DIGITS {
        return plain.into();
    }
    let mut text = String::with_capacity(plain.len() + 4);
    for (i, digit) in whole.chars().enumerate() {
        if i > 0 && (whole.len() - i) % 3 == 0 {
            text.push(NARROW_SPACE);
        }
        text.push(digit);
    }
    text + rest
}

/// "⁻⁵" for −5.
pub fn superscript(exponent: i32) -> String {
    exponent
        .to_string()
        .chars()
        .map(|c| match c {
            '-' => '⁻',
            '0' => '⁰',
            '1' => '¹',
            '2' => '²',
            '3' => '³',
            other => char::from_u32('⁴' as u32 + other as u32 - '4' as u32).unwrap_or(other),
        })
        .collect()
}

/// "₁₂" for 12: k₁₂.
pub fn subscript(number: usize) -> String {
    number
        .to_string()
        .chars()
        .map(|c| char::from_u32('₀' as u32 + c as u32 - '0' as u32).unwrap_or(c))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_rounding_carries_into_the_next_digit() {
        assert_eq!(significant(9.996, 3), "10.0");
        assert_eq!(significant(999.96, 4), "1000");
        assert_eq!(significant(0.000_123_4, 2), "0.00012");
        assert_eq!(significant(12_345.0, 5), "12\u{202f}345");
        assert_eq!(significant(9_999_999.0, 3), "1.00×10⁷");
        assert_eq!(significant(0.0, 3), "0");
    }

    #[test]
    fn exact_deviation_rules_the_digits() {
        assert_eq!(with_sd(1.88213, 0.00349), "1.8821 ± 0.0035");
        assert_eq!(with_sd(1.88213, 0.0096), "1.882 ± 0.010");
        assert_eq!(with_sd(0.02, 0.0963), "0.02 ± 0.10");
        assert_eq!(with_sd(185.18, 12.3), "185 ± 12");
        assert_eq!(with_sd(185.18, 44.0), "190 ± 40");
        assert_eq!(with_sd(-4.0, 0.5), "\u{2212}4.0 ± 0.5");
        assert_eq!(with_sd(1.0, f64::NAN), "1.000");
    }

    #[test]
    fn holds_what_is_not_a_number_never_reads_as_one() {
        for text in [
            significant(f64::NAN, 3),
            fixed(f64::NAN, 2),
            with_sd(f64::NAN, 1.0),
        ] {
            assert_eq!(text, NOT_A_NUMBER);
        }
        assert_eq!(significant(f64::NEG_INFINITY, 3), "\u{2212}∞");
    }

    #[test]
    fn exact_prefixes() {
        assert_eq!(engineering(120e6, "N/m", 3), "120\u{202f}MN/m");
        assert_eq!(engineering(1e6, "N", 3), "1.00\u{202f}MN");
        assert_eq!(engineering(999e3, "N", 3), "999\u{202f}kN");
        assert_eq!(engineering(290e3, "kg", 3), "290\u{202f}t");
        assert_eq!(engineering(12.5, "m", 3), "12.5\u{202f}m");
        assert_eq!(engineering(f64::INFINITY, "N", 3), "∞\u{202f}N");
    }

    #[test]
    fn exact_scripts() {
        assert_eq!(
            (superscript(-305), subscript(12)),
            ("⁻³⁰⁵".to_string(), "₁₂".to_string())
        );
        assert_eq!((0..10).map(superscript).collect::<String>(), "⁰¹²³⁴⁵⁶⁷⁸⁹");
    }
}
