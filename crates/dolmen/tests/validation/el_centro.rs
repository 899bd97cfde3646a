// SOURCE     El Centro 1940 NS in data/el_centro_1940_ns.
// GOAL       Response spectra are exact, and give both the true peaks and the peaks at the samples.
// PARAMETERS ζ 2 %, T 0.5, 1, 2 s; ζ 5 %, T 0.1 s; g = 386.0886 in/s² = 9.80665 m/s².
// AGREES     with the matrix exponential of the augmented state (mpmath 1.3.0, 100 steps per step of the record, 200 for T
//            0.1 s): true peaks 2.687058, 5.967164, 7.466290 in and 1.61170 mm; at the samples 2.6739, 5.9662, 7.4650 in
//            and 1.50914 mm.
// TOLERANCE  2e-6 in, because the 100 steps may miss the peak; otherwise half a unit of the last printed digit.

use dolmen::signal::{Component, GroundMotion, response_spectrum};

const INCH_M: f64 = 0.0254;

fn el_centro() -> GroundMotion {
    let text = include_str!("../../../../data/el_centro_1940_ns/el_centro_1940_ns.csv");
    let samples = text
        .lines()
        .skip(1)
        .map(|line| 9.80665 * line.split_once(',').unwrap().1.parse::<f64>().unwrap());
    GroundMotion::new("El Centro 1940 NS", 0.02, vec![(Component::X, samples.collect())]).unwrap()
}

#[test]
fn agrees_peak_displacements() {
    let spectrum = response_spectrum(&el_centro(), Component::X, &[0.5, 1.0, 2.0], 0.02).unwrap();
    let wanted = [(2.687058, 2.6739), (5.967164, 5.9662), (7.466290, 7.4650)];
    for (ordinate, (peak_in, at_samples_in)) in spectrum.iter().zip(wanted) {
        let (peak, at_samples) = (
            ordinate.displacement_m / INCH_M,
            ordinate.displacement_at_samples_m / INCH_M,
        );
        assert!((peak - peak_in).abs() < 2e-6, "{peak}");
        assert!((at_samples - at_samples_in).abs() < 0.5e-4, "{at_samples}");
    }
}

#[test]
fn agrees_a_short_period_peaks_between_samples() {
    let short = response_spectrum(&el_centro(), Component::X, &[0.1], 0.05).unwrap()[0];
    assert!((short.displacement_m - 1.61170e-3).abs() < 0.5e-8, "{short:?}");
    assert!(
        (short.displacement_at_samples_m - 1.50914e-3).abs() < 0.5e-8,
        "{short:?}"
    );
}
