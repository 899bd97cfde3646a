// SOURCE     Welch (1947), Holm (1979): closed forms; SciPy 1.17.1, ttest_ind_from_stats.
// GOAL       A change is found within its stated interval; without a change, one is reported at most as often as stated; and
//            the least detectable change is found as often as stated.
// PARAMETERS normally distributed modes whose standard deviations are estimated from 30 blocks of time; records of four
//            floors whose stiffness falls to 0.97 of its value.
// TOLERANCE  rates over N draws: three standard errors √(p (1 - p)/N) of the stated rate p.

use dolmen::assess::{
    SurveyChange, SurveyChangeOptions, Surveyed, TemperatureEffect, TemperatureKnowledge, survey_change,
};
use dolmen::modal::{Identify, MadeMode, MadeRecord, ObservedMode, ReferenceCase, identify};
use dolmen::numeric::Random;

fn mode(frequency_hz: f64, sd_hz: f64, degrees_of_freedom: f64) -> ObservedMode {
    ObservedMode {
        frequency_hz,
        frequency_sd_hz: Some(sd_hz),
        damping_ratio: None,
        damping_ratio_sd: None,
        degrees_of_freedom,
        direction: None,
        accepted: false,
        shape: Vec::new(),
    }
}

fn survey(name: &str, temperature_c: Option<f64>, modes: Vec<ObservedMode>) -> Surveyed {
    Surveyed {
        name: name.to_owned(),
        temperature_c,
        modes,
    }
}

const TRUTH_HZ: [f64; 4] = [1.1, 2.3, 4.2, 7.7];
const RELATIVE_SD: f64 = 0.002;
const BLOCKS: usize = 30;

/// A survey of four modes whose frequencies scatter, with deviations estimated from blocks that scatter too.
fn drawn(random: &mut Random, factor: f64, temperature_c: Option<f64>) -> Surveyed {
    let modes = TRUTH_HZ.iter().map(|f| {
        let sd_hz = RELATIVE_SD * f;
        let squares: f64 = (1..BLOCKS).map(|_| random.normal().powi(2)).sum();
        let stated_hz = sd_hz * (squares / (BLOCKS - 1) as f64).sqrt();
        mode(
            f * factor + sd_hz * random.normal(),
            stated_hz,
            (BLOCKS - 1) as f64,
        )
    });
    survey("drawn", temperature_c, modes.collect())
}

/// Share of draws in which a change of any mode is reported.
fn alarms(draws: usize, mut draw: impl FnMut(&mut Random) -> SurveyChange) -> f64 {
    let mut random = Random::new(11, 0);
    let found = (0..draws)
        .filter(|_| draw(&mut random).changed().next().is_some())
        .count();
    found as f64 / draws as f64
}

fn near(rate: f64, stated: f64, draws: usize) -> bool {
    (rate - stated).abs() < 3.0 * (stated * (1.0 - stated) / draws as f64).sqrt()
}

#[test]
fn agrees_with_scipy_on_welch_s_test() {
    // ttest_ind_from_stats(2.031, 0.012*30**.5, 30, 2.0, 0.007*20**.5, 20, equal_var=False)
    let from = survey("a", Some(10.0), vec![mode(2.0, 0.007, 19.0)]);
    let to = survey("b", Some(10.0), vec![mode(2.031, 0.012, 29.0)]);
    let found = survey_change(&from, &to, &[], &SurveyChangeOptions::default()).unwrap();
    let evidence = found.modes[0].frequency.evidence.as_ref().unwrap();
    assert!((evidence.statistic - SCIPY[0]).abs() < 1e-12, "{evidence:?}");
    assert!((evidence.p / SCIPY[1] - 1.0).abs() < 1e-9, "{evidence:?}");
    assert_eq!(found.temperature, TemperatureKnowledge::Same);
    let change = &found.modes[0];
    assert!((change.uniform_stiffness - (1.0155_f64.powi(2) - 1.0)).abs() < 1e-12);
}

const SCIPY: [f64; 2] = [2.231428827320963, 0.030763561609950727];

#[test]
fn holds_no_change_is_called_one_as_often_as_stated() {
    const DRAWS: usize = 4000;
    let options = SurveyChangeOptions::default();
    let rate = alarms(DRAWS, |random| {
        let (a, b) = (drawn(random, 1.0, Some(9.0)), drawn(random, 1.0, Some(9.0)));
        survey_change(&a, &b, &[], &options).unwrap()
    });
    assert!(near(rate, 0.05, DRAWS), "{rate}");
    // an uncertain temperature coefficient, with its own true value in each draw: it moves all modes together, so Holm's
    // bound is not reached
    let warm = SurveyChangeOptions {
        temperature: TemperatureEffect::Coefficient {
            per_c: -0.001,
            sd_per_c: 0.0003,
        },
        ..options
    };
    let rate = alarms(DRAWS, |random| {
        let per_c = -0.001 + 0.0003 * random.normal();
        let (a, b) = (
            drawn(random, 1.0, Some(5.0)),
            drawn(random, 1.0 + 20.0 * per_c, Some(25.0)),
        );
        survey_change(&a, &b, &[], &warm).unwrap()
    });
    assert!(rate < 0.05 && rate > 0.01, "{rate}");
}

#[test]
fn holds_the_least_detectable_change_is_found_as_often_as_stated() {
    const DRAWS: usize = 3000;
    let options = SurveyChangeOptions::default();
    let one = |survey: Surveyed| Surveyed {
        modes: survey.modes[..1].to_vec(),
        ..survey
    };
    // with a known standard deviation the stated change is exact
    let exact = |random: &mut Random, factor: f64| {
        let f = TRUTH_HZ[0];
        let sd_hz = RELATIVE_SD * f;
        survey(
            "drawn",
            None,
            vec![mode(f * factor + sd_hz * random.normal(), sd_hz, f64::INFINITY)],
        )
    };
    let mut random = Random::new(3, 1);
    let first = survey_change(&exact(&mut random, 1.0), &exact(&mut random, 1.0), &[], &options).unwrap();
    let detectable = first.detectable().unwrap();
    assert!(
        (detectable / (RELATIVE_SD * 2.0_f64.sqrt() * 2.8015852181129968) - 1.0).abs() < 0.02,
        "{detectable}"
    );
    let rate = alarms(DRAWS, |random| {
        let (a, b) = (exact(random, 1.0), exact(random, 1.0 - detectable));
        survey_change(&a, &b, &[], &options).unwrap()
    });
    assert!(near(rate, 0.8, DRAWS), "{rate}");
    // with a standard deviation estimated from 30 blocks, nearly so
    let rate = alarms(DRAWS, |random| {
        let (a, b) = (
            one(drawn(random, 1.0, None)),
            one(drawn(random, 1.0 - detectable, None)),
        );
        survey_change(&a, &b, &[], &options).unwrap()
    });
    assert!((0.75..0.85).contains(&rate), "{rate}");
}

#[test]
fn holds_a_fitted_coefficient_takes_the_weather_out_and_keeps_the_rate() {
    const DRAWS: usize = 2000;
    let per_c = -0.0012;
    let options = SurveyChangeOptions {
        temperature: TemperatureEffect::Fitted,
        ..Default::default()
    };
    let temperatures = [4.0, 12.0, 19.0, 26.0, 8.0];
    // an effect that no survey states: moisture adds an equal scatter to each survey
    let weather = |random: &mut Random, t: f64| {
        let moisture = 0.003 * random.normal();
        drawn(random, 1.0 + per_c * t + moisture, Some(t))
    };
    let rate = alarms(DRAWS, |random| {
        let earlier: Vec<Surveyed> = temperatures.iter().map(|t| weather(random, *t)).collect();
        let (from, to) = (weather(random, 15.0), weather(random, 24.0));
        survey_change(&from, &to, &earlier, &options).unwrap()
    });
    // moisture moves all modes together: the rate is below the one stated for four independent modes
    assert!(rate < 0.05 && rate > 0.01, "{rate}");
    let mut random = Random::new(5, 5);
    let earlier: Vec<Surveyed> = temperatures
        .iter()
        .map(|t| drawn(&mut random, 1.0 + per_c * t, Some(*t)))
        .collect();
    let (from, to) = (
        drawn(&mut random, 1.0 + per_c * 15.0, Some(15.0)),
        drawn(&mut random, 0.95 * (1.0 + per_c * 30.0), Some(30.0)),
    );
    let found = survey_change(&from, &to, &earlier, &options).unwrap();
    assert_eq!(
        found.temperature,
        TemperatureKnowledge::Corrected { step_c: 15.0 }
    );
    assert_eq!(found.changed().count(), 4);
    for change in &found.modes {
        let fitted = change.fitted.as_ref().unwrap();
        assert!((fitted.per_c - per_c).abs() < 4.0 * fitted.sd_per_c, "{fitted:?}");
        let sd = change.frequency.evidence.as_ref().unwrap().sd;
        assert!(
            (change.frequency.relative + 0.05).abs() < 4.0 * sd + 0.002,
            "{change:?}"
        );
    }
    // 30 °C is warmer than the 26 °C of the line
    assert!(
        found.notes[0]
            .to_string()
            .starts_with("30 °C lies beyond the 4 to 26 °C"),
        "{:?}",
        found.notes
    );
    // too few: a note says so, and nothing is corrected
    let found = survey_change(&from, &to, &earlier[..2], &options).unwrap();
    assert_eq!(
        found.temperature,
        TemperatureKnowledge::Unexplained { step_c: 15.0 }
    );
    assert!(
        found.notes[0]
            .to_string()
            .contains("3 surveys with a temperature"),
        "{:?}",
        found.notes
    );
    assert!(found.temperature.leaves_doubt() && found.modes[0].explaining_per_c.is_some());
}

#[test]
fn holds_a_softer_building_is_seen_in_its_records_within_the_stated_interval() {
    let softer = 0.97_f64.sqrt();
    let of = |seed: u64, factor: f64| {
        let made = ReferenceCase::ClosePairs.made(seed).unwrap();
        let changed = |mode: &MadeMode| MadeMode {
            frequency_hz: factor * mode.frequency_hz,
            ..mode.clone()
        };
        let made = MadeRecord {
            modes: made.modes.iter().map(changed).collect(),
            ..made
        };
        let found = identify(&made.make().unwrap(), &Identify::default()).unwrap();
        let modes = ObservedMode::all(&found.modes, found.settings.time_blocks);
        survey("made", Some(12.0), modes)
    };
    let options = SurveyChangeOptions::default();
    let (before, after, again) = (of(100, 1.0), of(101, softer), of(102, 1.0));
    let found = survey_change(&before, &after, &[], &options).unwrap();
    assert_eq!((found.modes.len(), found.lost.len(), found.new.len()), (8, 0, 0));
    for (i, change) in found.modes.iter().enumerate() {
        assert_eq!((change.pair.first, change.pair.second), (i, i), "{change:?}");
        let evidence = change.frequency.evidence.as_ref().unwrap();
        let off = (change.frequency.relative - (softer - 1.0)).abs();
        assert!(off < 3.0 * evidence.sd, "{off} {evidence:?}");
        let off = (change.uniform_stiffness + 0.03).abs();
        assert!(off < 3.0 * change.uniform_stiffness_sd.unwrap(), "{change:?}");
    }
    assert!(found.changed().count() >= 7, "{:?}", found.changed().count());
    let still = survey_change(&before, &again, &[], &options).unwrap();
    assert_eq!((still.modes.len(), still.changed().count()), (8, 0));
}

#[test]
fn refuses_surveys_and_options_that_make_no_sense() {
    let one = survey("one", None, vec![mode(2.0, 0.01, 29.0)]);
    let none = survey("none", None, Vec::new());
    let message = survey_change(&one, &none, &[], &SurveyChangeOptions::default())
        .unwrap_err()
        .to_string();
    assert!(message.starts_with("survey none has no modes"), "{message}");
    let options = SurveyChangeOptions {
        significance: 0.0,
        ..Default::default()
    };
    let message = survey_change(&one, &one, &[], &options).unwrap_err().to_string();
    assert_eq!(message, "significance is 0, but must be above 0 and below 0.5");
    let options = SurveyChangeOptions {
        temperature: TemperatureEffect::Coefficient {
            per_c: 0.5,
            sd_per_c: 0.0,
        },
        ..Default::default()
    };
    let message = survey_change(&one, &one, &[], &options).unwrap_err().to_string();
    assert_eq!(
        message,
        "the coefficient of temperature is 0.5, but must be within ±0.05 per °C"
    );
}

#[test]
fn holds_of_unchanged_minutes_one_pair_in_twenty_is_called_changed() {
    // 300 pairs: 5 % is 15 ± 4; with one degree of freedom less than the number of blocks it was 25
    let shapes = [[0.33, 0.74, 1.0], [1.0, 0.45, -0.8], [0.8, -1.0, 0.36]];
    let mode = |(frequency_hz, shape): (f64, [f64; 3])| MadeMode {
        frequency_hz,
        damping_ratio: 0.015,
        shape: shape.to_vec(),
    };
    let minute = |seed: u64| {
        let made = MadeRecord {
            modes: [1.5, 4.2, 6.07].into_iter().zip(shapes).map(mode).collect(),
            duration_s: 60.0,
            seed,
            ..MadeRecord::default()
        };
        let found = identify(&made.make().unwrap(), &Identify::default()).unwrap();
        Surveyed {
            name: seed.to_string(),
            temperature_c: Some(10.0),
            modes: ObservedMode::all(&found.modes, found.settings.time_blocks_effective),
        }
    };
    let called = (0..300)
        .filter(|pair| {
            let (before, after) = (minute(2 * pair), minute(2 * pair + 1));
            let change = survey_change(&before, &after, &[], &SurveyChangeOptions::default()).unwrap();
            change.changed().count() > 0
        })
        .count();
    assert!(called <= 23, "{called} of 300");
}
