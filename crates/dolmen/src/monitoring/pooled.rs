//! Combines several surveys of one day into one, by medians.

use super::MonitoringError;
use super::history::{HistorySurvey, TiltReading};
use super::tracking::{Track, Tracking, track};
use crate::modal::ObservedMode;
use crate::numeric::middle_mean;
use std::f64::consts::PI;

/// Combines the surveys of one day. Name and day are those of the first survey. A mode is kept if at least half of the surveys with modes
/// have it; it has the median frequency and the shape of the survey nearest to the median. Temperature and tilts are medians as well.
///
/// ```text
/// sd of the median of k readings = rms(σ_i) √(c/k),   c = 1 for one or two readings, π/2 for more
/// ```
/// The standard deviations are those of the readings. Effects of sun, wind and traffic within the day are part of the disturbance of the
/// history, which is estimated from the days.
///
/// # Errors
/// As [`track`]; [`MonitoringError::TooFewSurveys`] without surveys.
///
/// # Source
/// Kenney & Keeping (1962) Mathematics of statistics, 14.4: the median of many normal readings has π/2 times the variance of their mean, of
/// three 1.35 times.
pub fn pooled(surveys: &[HistorySurvey], options: &Tracking) -> Result<HistorySurvey, MonitoringError> {
    let Some(first) = surveys.first() else {
        return Err(MonitoringError::TooFewSurveys { given: 0, least: 1 });
    };
    if surveys.len() == 1 {
        return Ok(first.clone());
    }
    let all = Tracking {
        found_least: 1,
        share_least: 0.0,
        ..options.clone()
    };
    let tracked = track(surveys, &all)?;
    let with_modes = surveys.iter().filter(|survey| !survey.modes.is_empty()).count();
    let mut modes: Vec<ObservedMode> = tracked
        .tracks
        .iter()
        .filter(|track| 2 * track.found() >= with_modes)
        .filter_map(|track| mode(surveys, track))
        .collect();
    modes.sort_by(|a, b| a.frequency_hz.total_cmp(&b.frequency_hz));
    let temperatures: Vec<f64> = surveys.iter().filter_map(|survey| survey.temperature_c).collect();
    Ok(HistorySurvey {
        name: first.name.clone(),
        day: first.day,
        temperature_c: (!temperatures.is_empty()).then(|| middle_mean(temperatures)),
        modes,
        tilts: tilts(surveys),
    })
}

fn mode(surveys: &[HistorySurvey], track: &Track) -> Option<ObservedMode> {
    let read: Vec<&ObservedMode> = track
        .modes
        .iter()
        .zip(surveys)
        .filter_map(|(mode, survey)| survey.modes.get((*mode)?))
        .collect();
    let frequency_hz = middle_mean(read.iter().map(|mode| mode.frequency_hz).collect());
    let apart = |mode: &&&ObservedMode| (mode.frequency_hz - frequency_hz).abs();
    let nearest = *read.iter().min_by(|a, b| apart(a).total_cmp(&apart(b)))?;
    let of = |value: fn(&ObservedMode) -> Option<f64>| -> Vec<f64> {
        read.iter().filter_map(|mode| value(mode)).collect()
    };
    let zetas = of(|mode| mode.damping_ratio);
    Some(ObservedMode {
        frequency_hz,
        frequency_sd_hz: sd_of_median(&of(|mode| mode.frequency_sd_hz), read.len()),
        damping_ratio_sd: sd_of_median(&of(|mode| mode.damping_ratio_sd), zetas.len()),
        damping_ratio: (!zetas.is_empty()).then(|| middle_mean(zetas)),
        accepted: read.iter().any(|mode| mode.accepted),
        ..nearest.clone()
    })
}

fn sd_of_median(sds: &[f64], readings: usize) -> Option<f64> {
    if sds.is_empty() || readings == 0 {
        return None;
    }
    let mean_square = sds.iter().map(|sd| sd * sd).sum::<f64>() / sds.len() as f64;
    let of_mean = if readings > 2 { PI / 2.0 } else { 1.0 };
    Some((mean_square * of_mean / readings as f64).sqrt())
}

fn tilts(surveys: &[HistorySurvey]) -> Vec<TiltReading> {
    let mut all: Vec<(TiltReading, Vec<f64>)> = Vec::new();
    for tilt in surveys.iter().flat_map(|survey| &survey.tilts) {
        let own = all
            .iter_mut()
            .find(|(first, _)| first.direction == tilt.direction && first.datum == tilt.datum);
        match own {
            Some((_, ratios)) => ratios.push(tilt.ratio),
            None => all.push((tilt.clone(), vec![tilt.ratio])),
        }
    }
    let medians = all.into_iter();
    medians
        .map(|(first, ratios)| TiltReading {
            ratio: middle_mean(ratios),
            ..first
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn survey(frequencies_hz: &[f64], temperature_c: Option<f64>, tilt: f64) -> HistorySurvey {
        HistorySurvey {
            name: "2026-11-25".to_owned(),
            day: 20_782.0,
            temperature_c,
            modes: frequencies_hz
                .iter()
                .map(|frequency_hz| ObservedMode {
                    frequency_hz: *frequency_hz,
                    frequency_sd_hz: Some(0.01),
                    damping_ratio: Some(0.02),
                    damping_ratio_sd: None,
                    degrees_of_freedom: f64::INFINITY,
                    direction: None,
                    accepted: false,
                    shape: Vec::new(),
                })
                .collect(),
            tilts: vec![TiltReading {
                direction: "x".to_owned(),
                datum: None,
                ratio: tilt,
            }],
        }
    }

    #[test]
    fn exact_a_day_is_its_medians_and_a_mode_that_few_show_is_none() {
        let day = [
            survey(&[2.00, 5.0], Some(10.0), 1e-3),
            survey(&[2.02], Some(14.0), 2e-3),
            survey(&[2.90, 2.01], None, 9e-3), // a wrong reading
            survey(&[2.03], Some(12.0), 2e-3),
            survey(&[], None, 3e-3),
        ];
        let pooled = pooled(&day, &Tracking::default()).unwrap();
        let [mode] = pooled.modes.as_slice() else {
            panic!("{pooled:?}")
        };
        assert!((mode.frequency_hz - 2.015).abs() < 1e-12, "{mode:?}");
        let sd = 0.01 * (PI / 8.0).sqrt();
        assert!((mode.frequency_sd_hz.unwrap() - sd).abs() < 1e-12, "{mode:?}");
        assert_eq!((pooled.temperature_c, pooled.tilts[0].ratio), (Some(12.0), 2e-3));
        // of two readings, the mean
        let two = super::pooled(&day[..2], &Tracking::default()).unwrap();
        assert!((two.modes[0].frequency_hz - 2.01).abs() < 1e-12);
        assert!((two.modes[0].frequency_sd_hz.unwrap() - 0.01 / 2f64.sqrt()).abs() < 1e-12);
        assert_eq!(super::pooled(&day[..1], &Tracking::default()).unwrap(), day[0]);
    }

    #[test]
    fn agrees_the_deviation_of_the_median_with_simulated_days() {
        // normal readings: splitmix64 (Steele et al. 2014), then Box and Muller; the median of 9 has the variance 0.16610 (Teichroew 1956)
        let mut state = 7_u64;
        let mut uniform = move || {
            state = state.wrapping_add(0x9E37_79B9_7F4A_7C15);
            let mut z = state;
            z = (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9);
            z = (z ^ (z >> 27)).wrapping_mul(0x94D0_49BB_1331_11EB);
            ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 53) as f64
        };
        let mut normal = move || (-2.0 * (1.0 - uniform()).ln()).sqrt() * (2.0 * PI * uniform()).cos();
        let days = 20_000;
        let square: f64 = (0..days)
            .map(|_| middle_mean((0..9).map(|_| normal()).collect()).powi(2))
            .sum();
        let found = (square / f64::from(days)).sqrt();
        let told = sd_of_median(&[1.0; 9], 9).unwrap();
        assert!((found / 0.166_10_f64.sqrt() - 1.0).abs() < 0.02, "{found}");
        assert!(told >= found && told < 1.05 * found, "{told} {found}");
    }
}
