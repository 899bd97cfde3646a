//! Ratios with an upper bound.

use super::error::Fault;
use super::file_number::{At, QuantityRaw};
use super::measure::{Bound, Measure};
use super::quantity::Quantity;
use super::reader::Reader;
use super::wrong::WrongNumber;
use dolmen_words::message::Both;

/// Largest damping ratio of a mode. Our choice: a larger number is probably a percentage.
const DAMPING_RATIO_MOST: f64 = 0.5;

pub(super) fn damping_ratio(
    reader: &mut Reader,
    raw: Option<&At<QuantityRaw>>,
    path: &str,
) -> Option<Quantity> {
    let ratio = reader.quantity(raw, path, Measure::Ratio, Bound::NotNegative)?;
    below(reader, ratio, raw, DAMPING_RATIO_MOST, WrongNumber::WriteAsOr)
}

/// A ratio with an upper bound.
pub(super) fn below(
    reader: &mut Reader,
    ratio: Quantity,
    raw: Option<&At<QuantityRaw>>,
    most: f64,
    help: impl Into<Both>,
) -> Option<Quantity> {
    if ratio.value <= most {
        return Some(ratio);
    }
    let span = raw.map_or(0..0, |raw| raw.span.clone());
    let message = format!("{} = {}", ratio.path, ratio.written);
    let fault = Fault::new(span, &ratio.path, message);
    reader.fault(fault.allowed(WrongNumber::ZeroTo(most.to_string())).help(help));
    None
}
