// SOURCE     El Centro 1940 NS in data/el_centro_1940_ns.
// GOAL       Intensity measures agree with other programs; a motion matched to the spectrum of a code stays within the promised
//            limits.
// PARAMETERS El Centro; KDS 17 10 00, zone I, 2400 years, S4: S 0.22 g, F_a 1.36, F_v 1.96; 0.1 to 3 s, damping 5 %.
// AGREES     with eqsig 1.2.17 and numpy 2.4.6 (bench/spectrum/expected.py), for the record interpolated linearly with 40 points a
//            step; Arias intensity for the record at its own samples, D5-95 for its squares interpolated linearly.
// TOLERANCE  1e-4: trapezoids of 0.5 ms. Housner 1e-5: eqsig evaluates peaks only at samples of 0.5 ms. Arias intensity 1e-12: the same
//            sum. D5-95 one of its steps, 0.5 ms.

use dolmen::assess::demand::{KoreanSite, kds_17};
use dolmen::signal::{
    Component, GroundMotion, SignalError, SpectrumMatch, intensity_measures, match_spectrum,
    response_spectrum,
};

fn el_centro() -> GroundMotion {
    let text = include_str!("../../../../data/el_centro_1940_ns/el_centro_1940_ns.csv");
    let samples = text
        .lines()
        .skip(1)
        .map(|line| 9.80665 * line.split_once(',').unwrap().1.parse::<f64>().unwrap());
    GroundMotion::new("El Centro 1940 NS", 0.02, vec![(Component::X, samples.collect())]).unwrap()
}

#[test]
fn agrees_measures_with_eqsig() {
    let m = intensity_measures(&el_centro(), Component::X).unwrap();
    for (name, got, wanted, within) in [
        ("PGA", m.peak_acceleration_m_s2, 0.31882 * 9.80665, 1e-14),
        ("PGV", m.peak_velocity_m_s, 0.36187399033537515, 1e-4),
        ("PGD", m.peak_displacement_m, 0.21190276084883825, 1e-4),
        ("last v", m.last_velocity_m_s, 0.0006766588499986611, 1e-4),
        ("last u", m.last_displacement_m, -0.005328894383452155, 1e-4),
        ("Arias", m.arias_intensity_m_s, 1.8009790609148917, 1e-12),
        (
            "CAV",
            m.cumulative_absolute_velocity_m_s,
            12.366801654719781,
            1e-4,
        ),
        (
            "D5-95",
            m.significant_duration_s,
            23.843218613120854,
            0.7e-3 / 23.8,
        ),
        (
            "Housner",
            m.housner_intensity_m.unwrap(),
            1.2438437125582351,
            1e-5,
        ),
        ("mean period", m.mean_period_s.unwrap(), 0.5359145319851119, 1e-4),
        (
            "predominant",
            m.predominant_period_s.unwrap(),
            0.19225693032688715,
            1e-12,
        ),
    ] {
        assert!((got / wanted - 1.0).abs() < within, "{name}: {got}, {wanted}");
    }
}

#[test]
fn holds_a_match_to_the_spectrum_of_a_code() {
    let demand = kds_17(0.22, KoreanSite::S4).unwrap();
    let target = |period_s: f64| demand.acceleration_m_s2(period_s, 0.05).unwrap();
    let matched = match_spectrum(&el_centro(), Component::X, &target, &SpectrumMatch::default()).unwrap();
    // checked by the spectrum itself, at periods other than the matched ones
    let periods: Vec<f64> = (0..100).map(|k| 0.1 * 30f64.powf(f64::from(k) / 99.0)).collect();
    let spectrum = response_spectrum(&matched.motion, Component::X, &periods, 0.05).unwrap();
    let errors: Vec<f64> = spectrum
        .iter()
        .map(|o| o.pseudo_acceleration_m_s2() / target(o.period_s) - 1.0)
        .collect();
    let rms = (errors.iter().map(|e| e * e).sum::<f64>() / 100.0).sqrt();
    let lowest = errors.iter().fold(0.0, |low: f64, e| low.min(*e));
    assert!(rms <= 0.025, "{rms}");
    assert!(lowest >= -0.10, "{lowest}");
    // the ground is at rest again
    let m = intensity_measures(&matched.motion, Component::X).unwrap();
    assert!(
        m.last_velocity_m_s.abs() < 1e-12 && m.last_displacement_m.abs() < 1e-11,
        "{m:?}"
    );
    // the match is as good as its result states
    assert!((matched.after.root_mean_square - rms).abs() < 0.005 && matched.before.root_mean_square > 0.15);
    let again = match_spectrum(&el_centro(), Component::X, &target, &SpectrumMatch::default()).unwrap();
    assert_eq!(again, matched);
}

#[test]
fn refuses_targets_and_options_that_cannot_be() {
    let say = |target: &dyn Fn(f64) -> f64, options: SpectrumMatch| -> SignalError {
        match_spectrum(&el_centro(), Component::X, target, &options).unwrap_err()
    };
    let plain = SpectrumMatch::default();
    assert!(
        say(&|_| 0.0, plain)
            .to_string()
            .starts_with("target_m_s2 is 0, but must be a positive number")
    );
    assert!(
        say(&|_| f64::NAN, plain)
            .to_string()
            .starts_with("target_m_s2 is NaN")
    );
    assert!(
        say(
            &|_| 1.0,
            SpectrumMatch {
                period_most_s: 0.1,
                ..plain
            }
        )
        .to_string()
        .starts_with("period_most_s is 0.1")
    );
    assert!(
        say(
            &|_| 1.0,
            SpectrumMatch {
                damping_ratio: 5.0,
                ..plain
            }
        )
        .to_string()
        .contains("is it in percent?")
    );
    assert!(
        say(&|_| 1.0, SpectrumMatch { periods: 3, ..plain })
            .to_string()
            .starts_with("periods is 3")
    );
    let still = GroundMotion::new("still", 0.02, vec![(Component::X, vec![0.0; 500])]).unwrap();
    assert!(match_spectrum(&still, Component::X, &|_| 1.0, &plain).is_err());
}
