//! Usual values: how far a value is from them, and the unit that would correct it.

use super::heaviness::Heaviness;
use super::quantity::Quantity;
use super::written::short;
use super::wrong::Slip;
use dolmen_words::message::Both;

pub(super) fn within(value: f64, range: (f64, f64)) -> bool {
    (range.0..=range.1).contains(&value)
}

/// Units that are often confused, with their size relative to the first.
const FAMILIES: [&[(&str, f64)]; 3] = [
    &[("N", 1.0), ("kN", 1e3), ("MN", 1e6)],
    &[("mm", 1.0), ("cm", 10.0), ("m", 1e3)],
    &[("kg", 1.0), ("t", 1e3)],
];
/// Largest ratio to the usual value after a change of unit for which the help names that unit; two may be as near: 300 cm and 300 mm of a usual 1 m.
const NEAR: f64 = 6.0;

/// The units that would correct a value `ratio` times the usual one, the nearest first.
pub(super) fn guess(ratio: f64, unit: &str) -> Slip {
    let family = FAMILIES
        .iter()
        .find(|family| family.iter().any(|(name, _)| *name == unit));
    let own = family.and_then(|family| family.iter().find(|(name, _)| *name == unit));
    let (Some(family), Some((_, own))) = (family, own) else {
        return Slip::ItIsAboutWhat(rounded(ratio));
    };
    let off = |factor: f64| (ratio * factor / own).ln().abs();
    let near = |(name, factor): &&(&str, f64)| *name != unit && off(*factor) <= NEAR.ln();
    let mut near: Vec<&(&str, f64)> = family.iter().filter(near).collect();
    near.sort_by(|a, b| off(a.1).total_cmp(&off(b.1)));
    match near[..] {
        [] => Slip::ItIsAboutWhat(rounded(ratio)),
        [(name, _)] => Slip::DidYouMean(name.to_string()),
        [(name, _), (other, _), ..] => Slip::DidYouMeanEither {
            name: name.to_string(),
            other: other.to_string(),
        },
    }
}

/// A ratio for a message: three significant digits, below 1 as a fraction.
pub(super) fn rounded(ratio: f64) -> String {
    if ratio < 1.0 {
        return format!("1/{}", rounded(1.0 / ratio));
    }
    let exponent = ratio.log10().floor() as i32;
    let unit = 10f64.powi((exponent - 2).max(-2));
    short((ratio / unit).round() * unit)
}

/// The unit of a quantity in the file, for a guess.
pub(super) fn unit_of(quantity: &Quantity) -> &str {
    quantity.written.split_once(' ').map_or("", |(_, unit)| unit)
}

pub(super) fn mass_kg(heaviness: &Heaviness, gravity_m_s2: f64) -> f64 {
    heaviness.mass_kg(gravity_m_s2, &mut Quantity::nominal)
}

pub(super) fn rounded_length(length_m: f64) -> String {
    let exponent = length_m.log10().floor() as i32;
    let unit = 10f64.powi(exponent - 2);
    short((length_m / unit).round() * unit)
}

/// Median of all values but one; `None` if there is no other.
pub(super) fn median_of_others(values: &[f64], but: usize) -> Option<f64> {
    let others = values.iter().enumerate().filter(|(i, _)| *i != but);
    let mut others: Vec<f64> = others.map(|(_, value)| *value).collect();
    others.sort_by(f64::total_cmp);
    let middle = others.len() / 2;
    match others.len() % 2 {
        1 => others.get(middle).copied(),
        _ => Some((others.get(middle.checked_sub(1)?)? * others.get(middle)?).sqrt()),
    }
}

/// Values more than `most` times above or below the median of the others. Of two values only one is odd: the one
/// further from `usual`.
pub(super) fn odd_ones(values: &[f64], most: f64, usual: f64) -> Vec<usize> {
    let odd = |i: usize| {
        median_of_others(values, i).is_some_and(|median| {
            let ratio = values[i] / median;
            ratio > most || ratio < 1.0 / most
        })
    };
    let distance = |i: usize| (values[i] / usual).ln().abs();
    match values.len() {
        2 if odd(0) && distance(0) > distance(1) => vec![0],
        2 if odd(1) => vec![1],
        count => (0..count).filter(|i| odd(*i)).collect(),
    }
}

/// "388 × the link below" or "1/388 of the link above"; `None` for a single part.
pub(super) fn beside_neighbour(parts: &[&Quantity], i: usize, part: Slip) -> Option<Slip> {
    let below = i.checked_sub(1).and_then(|below| parts.get(below));
    let other = below.or_else(|| parts.get(i + 1))?;
    let ratio = parts[i].value / other.value;
    let (part, is_below) = (part.into(), below.is_some());
    let ratio_named = rounded(ratio);
    Some(match (ratio >= 1.0, is_below) {
        (true, true) => Slip::Below {
            ratio: ratio_named,
            part,
        },
        (true, false) => Slip::Above {
            ratio: ratio_named,
            part,
        },
        (false, true) => Slip::OfBelow {
            ratio: ratio_named,
            part,
        },
        (false, false) => Slip::OfAbove {
            ratio: ratio_named,
            part,
        },
    })
}

/// A value compared with others of its kind.
pub(super) fn beside_others(quantity: &Quantity, beside: Both) -> Slip {
    Slip::Beside {
        path: quantity.path.clone(),
        written: quantity.written.clone(),
        beside,
    }
}
