//! What a structure needs of its file: keys that must be there, lists of the right length.

use super::error::Fault;
use super::file_number::{At, QuantityRaw};
use super::heaviness::Heaviness;
use super::measure::{Bound, Measure};
use super::quantity::Quantity;
use super::reader::Reader;
use std::ops::Range;

/// Most parts of a structure, our choice: no chain or frame that people model by hand comes near.
const PARTS_MOST: usize = 1000;

/// Reports a key that the file lacks.
pub(super) fn missing(reader: &mut Reader, key: &str, message: &str, help: &str) {
    if !reader.is_reported(key) {
        reader.fault(Fault::new(0..0, key, message).at_top().help(help));
    }
}

/// A part's weight or mass: exactly one of the two.
pub(super) fn heaviness(
    reader: &mut Reader,
    weight: Option<&At<QuantityRaw>>,
    mass: Option<&At<QuantityRaw>>,
    path: &str,
    part: &Range<usize>,
) -> Option<Heaviness> {
    match (weight, mass) {
        (Some(weight), None) => {
            let path = format!("{path}.weight");
            let weight = reader.quantity(Some(weight), &path, Measure::Force, Bound::Positive)?;
            Some(Heaviness::Weight(weight))
        }
        (None, Some(mass)) => {
            let path = format!("{path}.mass");
            let mass = reader.quantity(Some(mass), &path, Measure::Mass, Bound::Positive)?;
            Some(Heaviness::Mass(mass))
        }
        (Some(weight), Some(_)) => {
            let fault = Fault::new(
                weight.span.clone(),
                path,
                format!("{path} has both weight and mass"),
            );
            reader.fault(
                fault
                    .allowed("must be one of them")
                    .help("take one out: weight = mass × gravity"),
            );
            None
        }
        (None, None) => {
            let reported =
                reader.is_reported(&format!("{path}.weight")) || reader.is_reported(&format!("{path}.mass"));
            if !reported {
                let fault = Fault::new(part.clone(), path, format!("{path} has neither weight nor mass"));
                reader.fault(fault.help("give weight = … (a force) or mass = …"));
            }
            None
        }
    }
}

/// Reports an empty or too long list; whether it can be read.
pub(super) fn countable<T>(reader: &mut Reader, list: &At<Vec<T>>, path: &str) -> bool {
    let count = list.value.len();
    if (1..=PARTS_MOST).contains(&count) {
        return true;
    }
    let fault = Fault::new(list.span.clone(), path, format!("{path} has {count} elements"));
    reader.fault(fault.allowed(format!("must be 1 to {PARTS_MOST}")));
    false
}

/// Reports a list that is not as long as the structure has parts; whether it is.
pub(super) fn one_each<T>(
    reader: &mut Reader,
    list: &[T],
    span: &Range<usize>,
    path: &str,
    parts: (&str, usize),
) -> bool {
    let (part, needed) = parts;
    if list.len() == needed {
        return true;
    }
    let fault = Fault::new(
        span.clone(),
        path,
        format!("{path} has {} elements for {needed} {part}", list.len()),
    );
    reader.fault(fault.allowed(format!(
        "must be {needed}, one for each of the {part}, lowest first"
    )));
    false
}

/// All elements of a list; `None` if one of them is wrong.
pub(super) fn listed<R, T>(
    reader: &mut Reader,
    raw: Option<&[At<R>]>,
    path: &str,
    mut read: impl FnMut(&mut Reader, &At<R>, &str) -> Option<T>,
) -> Option<Vec<T>> {
    let mut all = Vec::new();
    let mut sound = true;
    for (i, raw) in raw.unwrap_or_default().iter().enumerate() {
        let path = format!("{path}[{}]", i + 1);
        reader.mark(&path, &raw.span);
        match read(reader, raw, &path) {
            Some(one) => all.push(one),
            None => sound = false,
        }
    }
    sound.then_some(all)
}

/// As many lengths as a place has; `as_written` shows how.
pub(super) fn lengths<const N: usize>(
    reader: &mut Reader,
    raw: &At<Vec<At<QuantityRaw>>>,
    path: &str,
    as_written: &str,
) -> Option<[Quantity; N]> {
    if raw.value.len() != N {
        let message = format!("{path} has {} numbers", raw.value.len());
        let fault = Fault::new(raw.span.clone(), path, message);
        reader.fault(fault.allowed(format!("must be {N}: {as_written}")));
        return None;
    }
    let mut all = Vec::with_capacity(N);
    for (i, raw) in raw.value.iter().enumerate() {
        let path = format!("{path}[{}]", i + 1);
        all.extend(reader.quantity(Some(raw), &path, Measure::Length, Bound::Any));
    }
    all.try_into().ok()
}
