//! Reads the conditioning of a record, and the settings for its modes.

use super::file::{ConditioningRaw, EarthquakeChoiceRaw, HarmonicsRaw, MethodRaw, ModalRaw};
use super::records::{BandPass, Conditioning, Cut, LowPass, ModalChoice};
use crate::error::Fault;
use crate::file_number::At;
use crate::reader::Reader;
use crate::written::short;
use crate::wrong::WrongRecords;
use dolmen::modal::{Criteria, Harmonics, Method};
use std::ops::Range;

/// Default order of one filter pass.
const FILTER_ORDER: usize = 4;
/// Largest order of one filter pass.
const FILTER_ORDER_MOST: usize = 10;
/// Largest factor of one decimation.
const DECIMATE_MOST: usize = 1000;
/// Largest count in the settings of the identification.
const COUNT_MOST: usize = 10_000;
/// Longest record and highest rate in a project, s and Hz.
const TIME_MOST_S: f64 = 1e8;
const RATE_MOST_HZ: f64 = 1e6;

pub(super) fn conditioning(reader: &mut Reader, raw: &ConditioningRaw, path: &str) -> Conditioning {
    let cut = raw.cut.as_ref().and_then(|raw| {
        let from_s = reader.within(
            raw.value.from_s.as_ref(),
            &format!("{path}.cut.from_s"),
            0.0,
            TIME_MOST_S,
        )?;
        let to_s = reader.within(
            raw.value.to_s.as_ref(),
            &format!("{path}.cut.to_s"),
            0.0,
            TIME_MOST_S,
        )?;
        ordered(
            reader,
            (from_s, to_s),
            &raw.span,
            &format!("{path}.cut"),
            ("from_s", "to_s"),
        )?;
        Some(Cut { from_s, to_s })
    });
    let order = |reader: &mut Reader, order: Option<&At<i64>>, path: String| match order {
        None => Some(FILTER_ORDER),
        given => reader.count(given, &path, 1, FILTER_ORDER_MOST),
    };
    let least_hz = f64::MIN_POSITIVE;
    let band_pass = raw.band_pass.as_ref().and_then(|raw| {
        let path = format!("{path}.band_pass");
        let low_hz = reader.within(
            raw.value.low_hz.as_ref(),
            &format!("{path}.low_hz"),
            least_hz,
            RATE_MOST_HZ,
        )?;
        let high_hz = reader.within(
            raw.value.high_hz.as_ref(),
            &format!("{path}.high_hz"),
            least_hz,
            RATE_MOST_HZ,
        )?;
        ordered(reader, (low_hz, high_hz), &raw.span, &path, ("low_hz", "high_hz"))?;
        Some(BandPass {
            low_hz,
            high_hz,
            order: order(reader, raw.value.order.as_ref(), format!("{path}.order"))?,
        })
    });
    let low_pass = raw.low_pass.as_ref().and_then(|raw| {
        let path = format!("{path}.low_pass");
        let corner = raw.value.corner_hz.as_ref();
        Some(LowPass {
            corner_hz: reader.within(corner, &format!("{path}.corner_hz"), least_hz, RATE_MOST_HZ)?,
            order: order(reader, raw.value.order.as_ref(), format!("{path}.order"))?,
        })
    });
    let mut count = |raw: &Option<At<i64>>, key: &str, least, most| {
        reader.count(raw.as_ref(), &format!("{path}.{key}"), least, most)
    };
    Conditioning {
        cut,
        detrend_degree: count(&raw.detrend_degree, "detrend_degree", 0, 1),
        band_pass,
        low_pass,
        decimate_factor: count(&raw.decimate_factor, "decimate_factor", 1, DECIMATE_MOST),
    }
}

fn ordered(
    reader: &mut Reader,
    pair: (f64, f64),
    span: &Range<usize>,
    path: &str,
    keys: (&str, &str),
) -> Option<()> {
    if pair.0 < pair.1 {
        return Some(());
    }
    let message = WrongRecords::IsNotBelow {
        path: path.to_string(),
        lower: keys.0.to_string(),
        low: short(pair.0),
        upper: keys.1.to_string(),
        high: short(pair.1),
    };
    reader.fault(Fault::new(span.clone(), path, message).allowed(WrongRecords::NothingWouldBeLeft));
    None
}

/// The range of damping of accepted poles, for the methods that check it.
fn damping_range(reader: &mut Reader, raw: &ModalRaw, path: &str) -> [Option<f64>; 2] {
    let (least, most) = (raw.damping_least.as_ref(), raw.damping_most.as_ref());
    if let (Some(MethodRaw::Fdd | MethodRaw::Efdd | MethodRaw::Fsdd | MethodRaw::Era), Some(given)) =
        (raw.method, least.or(most))
    {
        let message = WrongRecords::DampingLeastAndDamping(path.to_string());
        let fault = Fault::new(given.span.clone(), path, message);
        reader.fault(fault.allowed(WrongRecords::LeaveThemOutOr));
    }
    let defaults = Criteria::default();
    let range = [
        reader.within(least, &format!("{path}.damping_least"), 0.0, 1.0),
        reader.within(most, &format!("{path}.damping_most"), 0.0, 1.0),
    ];
    if let Some(given) = most.or(least) {
        let pair = (
            range[0].unwrap_or(0.0),
            range[1].unwrap_or(defaults.damping_ratio_most),
        );
        ordered(reader, pair, &given.span, path, ("damping_least", "damping_most"));
    }
    range
}

/// The given method; with measured inputs the method for these.
fn method_of(raw: &ModalRaw) -> Option<Method> {
    let has_inputs = raw.inputs.as_ref().is_some_and(|inputs| !inputs.is_empty());
    let written = raw.method.map(|method| match method {
        MethodRaw::Fdd => Method::Fdd,
        MethodRaw::Efdd => Method::Efdd,
        MethodRaw::Fsdd => Method::Fsdd,
        MethodRaw::SsiCov => Method::SsiCov,
        MethodRaw::SsiData => Method::SsiData,
        MethodRaw::Bayoma => Method::Bayoma,
        MethodRaw::Plscf => Method::Plscf,
        MethodRaw::Era => Method::Era,
        MethodRaw::Okid => Method::Okid,
    });
    written.or(has_inputs.then_some(Method::Okid))
}

/// Rejects inputs unless the method uses them.
fn inputs_and_method(reader: &mut Reader, raw: &ModalRaw, path: &str) {
    let first = raw.inputs.as_ref().and_then(|inputs| inputs.first());
    if let (Some(method), Some(first)) = (raw.method, first)
        && method != MethodRaw::Okid
    {
        let path = format!("{path}.inputs");
        let message = WrongRecords::InputsOfAnotherMethod(path.clone());
        reader.fault(Fault::new(first.span.clone(), &path, message).allowed(WrongRecords::LeaveOutTheMethod));
    }
}

fn names(given: &Option<Vec<At<String>>>) -> Vec<String> {
    given.iter().flatten().map(|name| name.value.clone()).collect()
}

pub(super) fn modal(reader: &mut Reader, raw: &ModalRaw, path: &str) -> ModalChoice {
    let low = raw.frequency_low_hz.as_ref();
    let high = raw.frequency_high_hz.as_ref();
    let frequency_low_hz = reader.within(low, &format!("{path}.frequency_low_hz"), 0.0, RATE_MOST_HZ);
    let frequency_high_hz = reader.within(high, &format!("{path}.frequency_high_hz"), 0.0, RATE_MOST_HZ);
    if let (Some(low), Some(high), Some(raw)) = (frequency_low_hz, frequency_high_hz, high) {
        ordered(
            reader,
            (low, high),
            &raw.span,
            path,
            ("frequency_low_hz", "frequency_high_hz"),
        );
    }
    let [damping_least, damping_most] = damping_range(reader, raw, path);
    inputs_and_method(reader, raw, path);
    let mut frequencies = |given: &Option<Vec<At<f64>>>, key: &str| -> Vec<f64> {
        let each = given.iter().flatten().enumerate();
        each.filter_map(|(i, hz)| reader.within(Some(hz), &format!("{path}.{key}[{i}]"), 0.0, RATE_MOST_HZ))
            .collect()
    };
    let pick_hz = frequencies(&raw.pick_hz, "pick_hz");
    let accept_hz = frequencies(&raw.accept, "accept");
    let mut count = |raw: &Option<At<i64>>, key: &str, least| {
        reader.count(raw.as_ref(), &format!("{path}.{key}"), least, COUNT_MOST)
    };
    ModalChoice {
        method: method_of(raw),
        references: names(&raw.references),
        inputs: names(&raw.inputs),
        pick_hz,
        accept_hz,
        harmonics: raw.harmonics.map(|harmonics| match harmonics {
            HarmonicsRaw::Flag => Harmonics::Flag,
            HarmonicsRaw::Remove => Harmonics::Remove,
        }),
        without_earthquake: raw.earthquake == Some(EarthquakeChoiceRaw::None),
        spectrogram: raw.spectrogram.as_ref().map(|name| name.value.clone()),
        frequency_low_hz,
        frequency_high_hz,
        damping_least,
        damping_most,
        order_most: count(&raw.order_most, "order_most", 2),
        block_rows: count(&raw.block_rows, "block_rows", 2),
        modes_wanted: count(&raw.modes_wanted, "modes_wanted", 1),
    }
}
