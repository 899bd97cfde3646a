//! Numbers for messages, in readable form.

/// A number for a message: at most six significant digits, without trailing zeros.
pub(super) fn short(value: f64) -> String {
    const DIGITS: i32 = 6;
    if value == 0.0 || !value.is_finite() {
        return value.to_string();
    }
    let exponent = value.abs().log10().floor() as i32;
    if !(-5..12).contains(&exponent) {
        return format!("{value:e}");
    }
    let decimals = (DIGITS - 1 - exponent).clamp(0, 12) as usize;
    let text = format!("{value:.decimals$}");
    match text.contains('.') {
        true => text.trim_end_matches('0').trim_end_matches('.').to_owned(),
        false => text,
    }
}

/// A number as a file writes it: every digit, with an exponent where [`short`] has one.
pub(super) fn in_full(value: f64) -> String {
    let is_usual = value == 0.0 || !value.is_finite() || (1e-5..1e12).contains(&value.abs());
    match is_usual {
        true => value.to_string(),
        false => format!("{value:e}"),
    }
}

/// A number followed by its unit.
pub(super) fn with_unit(number: &str, unit: &str) -> String {
    match unit {
        "" => number.to_owned(),
        "%" => format!("{number} %"),
        unit => format!("{number} {unit}"),
    }
}
