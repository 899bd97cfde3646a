//! Numbers that samples do not draw.

use super::error::Fault;
use super::file_number::{At, QuantityRaw};
use super::quantity::Quantity;
use super::reader::Reader;
use super::wrong::WrongNumber;

/// A number that is taken as exact; with a scatter it is refused.
pub(super) fn exact(
    reader: &mut Reader,
    quantity: Option<Quantity>,
    raw: Option<&At<QuantityRaw>>,
) -> Option<Quantity> {
    let quantity = quantity?;
    if quantity.cov.is_some_and(|cov| cov > 0.0) {
        let span = raw.map_or(0..0, |raw| raw.span.clone());
        let message = WrongNumber::HasScatter {
            path: quantity.path.clone(),
            written: quantity.written.clone(),
        };
        let fault = Fault::new(span, &quantity.path, message);
        reader.fault(fault.help(WrongNumber::LeaveScatterOut));
    }
    Some(quantity)
}
