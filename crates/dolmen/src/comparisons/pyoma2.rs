//! Poles of a small record by pyOMA2 1.4.3, as printed by `bench/ssi_cov/agrees.py`.

use super::{Case, ValidationError};
use crate::modal::{Plscf, Pole, Ssi, plscf, ssi_cov, ssi_data};
use crate::signal::{Channel, Record};

const SOURCE: &str = "pyOMA2 1.4.3";
const NOTE: &str = "pyOMA2 1.4.3, 600 samples of 3 channels at 20 Hz, 8 block rows, order 12: the first pole. Its method dat decomposes all \
                    stacked samples by QR; here sums of products that follow from each other by displacement. Every pole of every \
                    order agrees to 1e-6 (a test).";
const SAMPLES: usize = 600;
const ORDER: usize = 12;
/// Relative tolerance: rounding of two programs, amplified by the smallest singular values.
const TOLERANCE: f64 = 1e-6;
/// Frequency, Hz, and damping ratio of the first pole of order 12.
const COV: [f64; 2] = [0.8719417232, 0.0563333749];
const COV_OF_TWO: [f64; 2] = [0.8732729954, 0.0543850700];
const DAT: [f64; 2] = [0.8863483865, 0.0331727204];
const DAT_OF_TWO: [f64; 2] = [0.8720130146, 0.0531403545];

const PLSCF: [f64; 2] = [0.8719064583, 0.0497655969];
const PLSCF_ORDER: usize = 9;
const PLSCF_NOTE: &str = "pyOMA2 1.4.3, the same samples, half spectra of 60 lags with an exponential window of 1 %, degree 3: the first pole. Its \
                          own correction adds the window's decay to the damping instead of taking it out, so the window is \
                          taken out of its poles here. Every pole of degrees 1 to 3 agrees to 1e-6 (a test).";

/// Two resonators under white force, and white noise.
fn record() -> Result<Record, ValidationError> {
    let mut state: u32 = 2021;
    let resonators = [(1.90, -0.97), (1.55, -0.96)]; // x_t = a x_(t-1) + b x_(t-2) + u
    let shapes = [[1.0, 0.6, -0.3], [-0.5, 1.0, 0.8]];
    let mut past = [[0.0; 2]; 2];
    let mut samples = vec![Vec::new(); 3];
    for t in 0..2 * SAMPLES {
        let draws = [(); 5].map(|()| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            f64::from(state) / 4_294_967_296.0 - 0.5
        });
        for (((a, b), p), u) in resonators.iter().zip(&mut past).zip(draws) {
            *p = [a * p[0] + b * p[1] + u, p[0]];
        }
        if t >= SAMPLES {
            for (c, channel) in samples.iter_mut().enumerate() {
                channel.push(shapes[0][c] * past[0][0] + shapes[1][c] * past[1][0] + draws[2 + c]);
            }
        }
    }
    let names = ["a", "b", "c"].map(Channel::named).to_vec();
    Ok(Record::new(names, samples, 20.0)?)
}

pub(super) fn cases() -> Result<Vec<Case>, ValidationError> {
    let record = record()?;
    let options = |references: &[usize]| Ssi {
        block_rows: 8,
        order_most: ORDER,
        time_blocks: 2,
        references: references.to_vec(),
        ..Ssi::default()
    };
    let two = options(&[0, 2]);
    let runs = [
        ("cov", ssi_cov(&record, &options(&[]))?.poles, COV),
        (
            "cov, references a and c",
            ssi_cov(&record, &two)?.poles,
            COV_OF_TWO,
        ),
        ("dat", ssi_data(&record, &options(&[]))?.poles, DAT),
        (
            "dat, references a and c",
            ssi_data(&record, &two)?.poles,
            DAT_OF_TWO,
        ),
    ];
    let fraction = plscf(
        &record,
        &Plscf {
            lags: 59,
            order_most: PLSCF_ORDER,
            time_blocks: 2,
            ..Plscf::default()
        },
    )?;
    let mut cases = Vec::new();
    let runs = runs.map(|(method, poles, numbers)| (method, poles, numbers, ORDER, NOTE));
    let of_lines = ("plscf", fraction.poles, PLSCF, PLSCF_ORDER, PLSCF_NOTE);
    for (method, poles, [frequency_hz, damping_ratio], order, note) in runs.into_iter().chain([of_lines]) {
        let first = |poles: &[Pole], of: fn(&Pole) -> f64| {
            poles.iter().find(|p| p.order == order).map_or(f64::NAN, of)
        };
        cases.push(Case {
            source: SOURCE,
            what: format!("method {method}: frequency"),
            unit: "Hz",
            published: frequency_hz,
            computed: first(&poles, |p| p.frequency_hz),
            tolerance: TOLERANCE * frequency_hz,
            corrected: None,
            note,
        });
        cases.push(Case {
            source: SOURCE,
            what: format!("method {method}: damping ratio"),
            unit: "",
            published: damping_ratio,
            computed: first(&poles, |p| p.damping_ratio),
            tolerance: TOLERANCE,
            corrected: None,
            note,
        });
    }
    Ok(cases)
}
