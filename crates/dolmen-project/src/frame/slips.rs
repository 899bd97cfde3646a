//! Probable slips in a frame.

use super::columns;
use super::part::{Axial, FramePart, StoreyPart};
use crate::measure::Measure;
use crate::named_order::storeys_begin_with_top;
use crate::quantity::Quantity;
use crate::reader::Reader;
use crate::usual::{guess, mass_kg, rounded, rounded_length, unit_of, within};
use crate::wrong::{Common, WrongFrame};

const STOREY_MASS_KG: (f64, f64) = (1e3, 2e7);
const STOREY_HEIGHT_M: (f64, f64) = (0.1, 50.0);
/// Usual storey height, for comparison, m.
const STOREY_HEIGHT_USUAL_M: f64 = 5.0;
/// Axial force over the weight carried by the storey. 0 means no P-delta and is not judged.
const AXIAL_SHARE: (f64, f64) = (0.2, 5.0);
/// Largest relative difference from the weights at which an interpretation of the axial forces is the better one.
const AXIAL_MATCH: f64 = 0.25;
/// √(k/m)/2π of a storey, Hz.
const STOREY_FREQUENCY_HZ: (f64, f64) = (0.2, 60.0);

pub(crate) fn judge_frame(reader: &mut Reader, frame: &FramePart) {
    judge_order(reader, frame);
    for storey in &frame.storeys {
        let height = &storey.height;
        if !within(height.value, STOREY_HEIGHT_M) {
            let (least, most) = STOREY_HEIGHT_M;
            let message = Common::StoreyHeight {
                path: height.path.to_string(),
                written: height.written.to_string(),
                least: least.to_string(),
                most: most.to_string(),
            };
            reader.slip(
                &height.path,
                message,
                guess(height.value / STOREY_HEIGHT_USUAL_M, unit_of(height)),
            );
        }
    }
    let masses: Vec<f64> = frame
        .storeys
        .iter()
        .map(|part| mass_kg(&part.heaviness, frame.gravity_m_s2))
        .collect();
    let mut is_mass_odd = false;
    for (storey, mass_kg) in frame.storeys.iter().zip(&masses) {
        if !within(*mass_kg, STOREY_MASS_KG) {
            is_mass_odd = true;
            let given = storey.heaviness.quantity();
            let message = WrongFrame::ButStoreysHaveT {
                path: given.path.to_string(),
                written: given.written.to_string(),
            };
            let ratio = if *mass_kg > 1e5 { 1000.0 } else { 0.001 };
            reader.slip(&given.path, message, guess(ratio, unit_of(given)));
        }
    }
    if is_mass_odd {
        // Axial forces and stiffness are compared with masses.
        return;
    }
    judge_axial(reader, frame, &masses);
    let built = frame.build(&mut Quantity::nominal).ok();
    for (i, storey) in frame.storeys.iter().enumerate() {
        if let (Some(columns), Some(built)) = (&storey.columns, &built) {
            columns::judge(reader, columns, built.storeys()[i].axial_n);
        }
    }
    for direction in &frame.directions {
        let given = direction.stiffness.iter().flatten().zip(&masses);
        // beds of columns alone have their own check
        for (stiffness, mass_kg) in given.filter(|(stiffness, _)| stiffness.value != 0.0) {
            let frequency_hz = (stiffness.value / mass_kg).sqrt() / std::f64::consts::TAU;
            if !within(frequency_hz, STOREY_FREQUENCY_HZ) {
                let (least, most) = STOREY_FREQUENCY_HZ;
                let message = WrongFrame::StoreyAloneWouldSway {
                    path: stiffness.path.to_string(),
                    written: stiffness.written.to_string(),
                    frequency_hz: rounded_length(frequency_hz),
                    least: least.to_string(),
                    most: most.to_string(),
                };
                reader.slip(&stiffness.path, message, Common::StiffnessUnit);
            }
        }
    }
}

/// A list that begins with the top: the lowest storey would then carry the least.
fn judge_order(reader: &mut Reader, frame: &FramePart) {
    let names = frame.storeys.iter().map(|storey| storey.name.as_deref());
    let names: Vec<&str> = names.collect::<Option<_>>().unwrap_or_default();
    if let ([foot, .., top], true) = (names.as_slice(), storeys_begin_with_top(&names)) {
        let (foot, top) = ((*foot).to_owned(), (*top).to_owned());
        let message = WrongFrame::NamesBeginWithTop { foot, top };
        reader.slip("storeys", message, WrongFrame::ListStoreysLowestFirst);
    }
}

/// N_i over the weight above for every storey, with the given numbers read as forces in storeys or loads of levels.
fn axial_shares(storeys: &[StoreyPart], weights: &[f64], axial: Axial) -> Vec<f64> {
    let given: Vec<f64> = storeys
        .iter()
        .map(|storey| storey.axial_force.as_ref().map_or(0.0, |force| force.value))
        .collect();
    let carried = |values: &[f64], i: usize| values[i..].iter().sum::<f64>();
    let force = |i: usize| match axial {
        Axial::Level => carried(&given, i),
        Axial::Storey | Axial::FromMasses => given[i],
    };
    (0..storeys.len())
        .map(|i| force(i) / carried(weights, i))
        .collect()
}

fn judge_axial(reader: &mut Reader, frame: &FramePart, masses: &[f64]) {
    let (axial, other, other_word) = match frame.axial {
        Axial::FromMasses => return,
        Axial::Storey => (Axial::Storey, Axial::Level, "level"),
        Axial::Level => (Axial::Level, Axial::Storey, "storey"),
    };
    let weights: Vec<f64> = masses.iter().map(|mass| mass * frame.gravity_m_s2).collect();
    let shares = axial_shares(&frame.storeys, &weights, axial);
    if shares.iter().all(|share| *share == 0.0) {
        return;
    }
    let matches = |shares: &[f64]| shares.iter().all(|share| (share - 1.0).abs() <= AXIAL_MATCH);
    if !matches(&shares) && matches(&axial_shares(&frame.storeys, &weights, other)) {
        let message = WrongFrame::AxialButAxialForces {
            word: (if axial == Axial::Storey { "storey" } else { "level" }).to_string(),
            other_word: other_word.to_string(),
        };
        reader.slip(
            "axial",
            message,
            WrongFrame::DidYouMeanAxial(other_word.to_string()),
        );
        return;
    }
    for (i, (storey, share)) in frame.storeys.iter().zip(&shares).enumerate() {
        let Some(force) = &storey.axial_force else {
            continue;
        };
        if *share != 0.0 && !within(*share, AXIAL_SHARE) {
            let weight = reader.echo(weights[i..].iter().sum(), Measure::Force);
            let message = WrongFrame::StoreySColumnsWould {
                path: force.path.to_string(),
                written: force.written.to_string(),
                share: rounded(*share),
                weight: weight.to_string(),
            };
            reader.slip(&force.path, message, guess(*share, unit_of(force)));
        }
    }
}
