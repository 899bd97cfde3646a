//! Decimal numbers in text, read in place.
//!
//! Up to 19 digits form an integer m. If m ≤ 2⁵³ and the power of ten is within ±22, both are exact doubles, and one
//! multiplication or division rounds correctly (Clinger 1990, Proc. PLDI, 92-101). Everything else uses the standard library, so
//! that every result equals `str::parse::<f64>` bit for bit.

/// Largest power of ten that is an exact double.
const POWER_MOST: i32 = 22;
const POWERS: [f64; POWER_MOST as usize + 1] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18,
    1e19, 1e20, 1e21, 1e22,
];
/// Every integer up to this is an exact double.
const MANTISSA_MOST: u64 = 1 << 53;
/// Number of digits that always fit 64 bits.
const DIGITS_MOST: usize = 19;
/// Longer cells are not printed numbers; they are copied when the decimal sign is a comma.
const CELL_MOST: usize = 64;

/// A number at the beginning of a text.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Number {
    pub(crate) value: f64,
    /// Index of the first byte after it.
    pub(crate) end: usize,
    /// Decimal place of its last digit; negative where an exponent moved it left of the decimal sign.
    pub(crate) decimals: i32,
}

/// The number in a text, as `str::parse::<f64>` reads it, or `None`.
///
/// # Example
/// ```
/// use dolmen_records::records::parse_number;
/// assert_eq!(parse_number(b"-1.25e-3"), Some(-0.00125));
/// assert_eq!(parse_number(b"1.2.3"), None);
/// ```
pub fn parse_number(text: &[u8]) -> Option<f64> {
    match scan(text, 0, b'.') {
        Some(number) if number.end == text.len() => Some(number.value),
        _ => std::str::from_utf8(text).ok()?.parse().ok(),
    }
}

/// The finite number at `at`, if it is in plain form. Text after it is ignored.
#[inline]
pub(crate) fn scan(text: &[u8], at: usize, decimal_sign: u8) -> Option<Number> {
    let sign = *text.get(at)?;
    let mut mantissa = 0;
    let first = if matches!(sign, b'-' | b'+') { at + 1 } else { at };
    let mut end = digits(text, first, &mut mantissa);
    let mut printed = end - first;
    let mut decimals = 0;
    if text.get(end) == Some(&decimal_sign) {
        let after = digits(text, end + 1, &mut mantissa);
        decimals = after - end - 1;
        printed += decimals;
        end = after;
    }
    if printed == 0 {
        return None;
    }
    let mut decimals = i32::try_from(decimals).ok()?;
    if let Some(b'e' | b'E') = text.get(end) {
        let negative = text.get(end + 1) == Some(&b'-');
        let first = end + 1 + usize::from(matches!(text.get(end + 1), Some(b'-' | b'+')));
        let mut exponent = 0;
        end = digits(text, first, &mut exponent);
        if !(1..=4).contains(&(end - first)) {
            return None;
        }
        // at most 4 digits
        decimals += exponent as i32 * if negative { 1 } else { -1 };
    }
    let exact = printed <= DIGITS_MOST && mantissa <= MANTISSA_MOST && decimals.abs() <= POWER_MOST;
    let value = if exact {
        let power = POWERS[decimals.unsigned_abs() as usize];
        let magnitude = if decimals < 0 {
            mantissa as f64 * power
        } else {
            mantissa as f64 / power
        };
        if sign == b'-' { -magnitude } else { magnitude }
    } else if decimal_sign == b'.' {
        std::str::from_utf8(&text[at..end])
            .ok()?
            .parse()
            .ok()
            .filter(|v: &f64| v.is_finite())?
    } else {
        return None;
    };
    Some(Number { value, end, decimals })
}

/// The number in a whole cell, without blanks, with the given decimal sign. Reads everything that `str::parse` reads, such as NaN.
pub(crate) fn parse_cell(cell: &[u8], decimal_sign: u8) -> Option<Number> {
    if let Some(number) = scan(cell, 0, decimal_sign)
        && number.end == cell.len()
    {
        return Some(number);
    }
    let mut copy = [0; CELL_MOST];
    let copy = copy.get_mut(..cell.len())?;
    copy.copy_from_slice(cell);
    if decimal_sign != b'.' {
        if copy.contains(&b'.') {
            return None;
        }
        copy.iter_mut()
            .filter(|b| **b == decimal_sign)
            .for_each(|b| *b = b'.');
    }
    let text = std::str::from_utf8(copy).ok()?;
    let value = text.parse().ok()?;
    let (mantissa, exponent) = text.split_once(['e', 'E']).unwrap_or((text, "0"));
    Some(Number {
        value,
        end: cell.len(),
        decimals: mantissa.split_once('.').map_or(0, |(_, d)| d.len() as i32)
            - exponent.parse::<i32>().unwrap_or(0).clamp(-400, 400),
    })
}

/// Gathers the digits from `at` on; returns their end. Wraps beyond 19 digits.
#[inline]
fn digits(text: &[u8], mut at: usize, gathered: &mut u64) -> usize {
    while let Some(digit) = text.get(at).map(|b| b.wrapping_sub(b'0'))
        && digit < 10
    {
        *gathered = gathered.wrapping_mul(10).wrapping_add(u64::from(digit));
        at += 1;
    }
    at
}
