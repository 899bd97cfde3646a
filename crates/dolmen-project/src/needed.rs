//! Requirements of a structure on its file: keys that must be there, lists of the right length.

use super::error::Fault;
use super::file_number::{At, QuantityRaw};
use super::heaviness::Heaviness;
use super::measure::{Bound, Measure};
use super::quantity::Quantity;
use super::reader::Reader;
use super::wrong::{Common, WrongFile};
use dolmen_words::message::Both;
use std::ops::Range;

/// Most parts of a structure, our choice: far beyond any chain or frame modelled by hand.
const PARTS_MOST: usize = 2000;

/// Reports a missing key.
pub(super) fn missing(reader: &mut Reader, key: &str, message: impl Into<Both>, help: impl Into<Both>) {
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
                WrongFile::HasBothWeightAnd(path.to_string()),
            );
            reader.fault(
                fault
                    .allowed(WrongFile::EitherOne)
                    .help(WrongFile::TakeOneOutWeight),
            );
            None
        }
        (None, None) => {
            let reported =
                reader.is_reported(&format!("{path}.weight")) || reader.is_reported(&format!("{path}.mass"));
            if !reported {
                let fault = Fault::new(
                    part.clone(),
                    path,
                    WrongFile::HasNeitherWeightNor(path.to_string()),
                );
                reader.fault(fault.help(WrongFile::GiveWeightForceOr));
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
    let fault = Fault::new(
        list.span.clone(),
        path,
        WrongFile::HasElements {
            path: path.to_string(),
            count: count.to_string(),
        },
    );
    reader.fault(fault.allowed(WrongFile::MustBeTo(PARTS_MOST.to_string())));
    false
}

/// Reports a list with another length than the number of parts; returns whether the length is right.
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
        WrongFile::HasElementsFor {
            path: path.to_string(),
            count: list.len().to_string(),
            needed: needed.to_string(),
            part: part.to_string(),
        },
    );
    reader.fault(fault.allowed(WrongFile::MustBeOneFor {
        needed: needed.to_string(),
        part: part.to_string(),
    }));
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

/// As many lengths as a place has; `as_written` shows the form.
pub(super) fn lengths<const N: usize>(
    reader: &mut Reader,
    raw: &At<Vec<At<QuantityRaw>>>,
    path: &str,
    as_written: impl Into<Both>,
) -> Option<[Quantity; N]> {
    numbers(
        reader,
        (&raw.value, &raw.span),
        (path, Measure::Length),
        as_written,
    )
}

/// A fixed number of values of one measure, of any sign.
pub(super) fn numbers<const N: usize>(
    reader: &mut Reader,
    (list, span): (&[At<QuantityRaw>], &Range<usize>),
    (path, measure): (&str, Measure),
    as_written: impl Into<Both>,
) -> Option<[Quantity; N]> {
    if list.len() != N {
        let message = Common::HasNumbers {
            path: path.to_string(),
            count: list.len().to_string(),
        };
        let fault = Fault::new(span.clone(), path, message);
        reader.fault(fault.allowed(WrongFile::MustBe {
            n: N.to_string(),
            as_written: as_written.into(),
        }));
        return None;
    }
    let mut all = Vec::with_capacity(N);
    for (i, raw) in list.iter().enumerate() {
        let path = format!("{path}[{}]", i + 1);
        all.extend(reader.quantity(Some(raw), &path, measure, Bound::Any));
    }
    all.try_into().ok()
}
