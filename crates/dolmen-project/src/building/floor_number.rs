//! A floor of a building by its number.

use crate::error::Fault;
use crate::file_number::At;
use crate::reader::Reader;
use crate::wrong::WrongBuilding;

/// A floor by its number, from 1 at the bottom.
pub(super) fn floor_number(
    reader: &mut Reader,
    raw: Option<&At<i64>>,
    path: &str,
    floors: usize,
) -> Option<usize> {
    let given = raw?;
    let found = usize::try_from(given.value)
        .ok()
        .filter(|floor| (1..=floors).contains(floor));
    if found.is_none() {
        let message = WrongBuilding::ButBuildingHasFloors {
            path: path.to_string(),
            given: given.value.to_string(),
            floors: floors.to_string(),
        };
        let fault = Fault::new(given.span.clone(), path, message);
        reader.fault(fault.allowed(WrongBuilding::MustBeLowestTo(floors.to_string())));
    }
    found
}
