// SOURCE     Simulated histories with known changes (`made_history`): three modes, temperature, AR(1) 0.3, readings accurate to 0.12 %.
// GOAL       Changes are found at their date and with their size, and nowhere else; what cannot be decided is left undecided.
// TOLERANCE  a change of −1.5 % among 365: date ± 10 days, size ± 0.2 %; `examples/watch_power.rs` prints the larger tables.

use dolmen::monitoring::{
    ChangeForm, History, MadeHistory, NotJudged, TiltReading, WatchOptions, Watched, WeatherKnown, Work,
    made_history, watch,
};
use dolmen::numeric::{Random, clopper_pearson};

fn seen(history: &History) -> Watched {
    let options = WatchOptions {
        replicates: 0,
        ..WatchOptions::default()
    };
    watch(history, &options).unwrap()
}

fn changed(found: &Watched) -> usize {
    found.modes.iter().map(|mode| mode.changes.len()).sum()
}

#[test]
fn holds_a_lasting_change_among_365_is_found_at_its_date_and_size() {
    let of = MadeHistory {
        surveys: 365,
        interval_days: 1.0,
        step: Some((200, -0.015)),
        seed: 3,
        ..MadeHistory::default()
    };
    let found = seen(&made_history(&of));
    assert_eq!(found.modes.len(), 3);
    for mode in &found.modes {
        let change = &mode.changes[0];
        assert_eq!(change.form, ChangeForm::Step, "{change:?}");
        assert!(change.from.abs_diff(200) <= 10, "{change:?}");
        assert!(change.after < 200 && 200 <= change.before, "{change:?}");
        assert!((change.ratio + 0.015).abs() < 0.002, "{change:?}");
        assert!((change.ratio + 0.015).abs() < 3.5 * change.sd, "{change:?}");
        assert!(change.p_value < 1e-3);
        let (per_c, sd) = mode.weather.unwrap().per_c.unwrap();
        assert!((per_c + 0.001).abs() < 3.5 * sd, "{per_c} {sd}");
    }
    // the alarm came within ten surveys
    let first = found
        .alarms
        .iter()
        .map(|alarm| alarm.alarm.survey)
        .find(|survey| *survey >= 200);
    assert!(first.is_some_and(|survey| survey < 210), "{:?}", found.alarms);
    assert!(found.alarms.iter().all(|alarm| !alarm.is_answered));
}

#[test]
fn holds_a_change_of_1_2_per_cent_in_60_is_found() {
    let of = MadeHistory {
        step: Some((35, -0.012)),
        seed: 5,
        ..MadeHistory::default()
    };
    let found = seen(&made_history(&of));
    for mode in &found.modes {
        let change = &mode.changes[0];
        assert!(change.from.abs_diff(35) <= 2, "{change:?}");
        assert!((change.ratio + 0.012).abs() < 3.5 * change.sd, "{change:?}");
        // the change stated as detectable in four of five histories is smaller than the one detected
        assert!(
            mode.seen_from_ratio.unwrap() < 0.012,
            "{:?}",
            mode.seen_from_ratio
        );
    }
}

#[test]
fn holds_what_the_last_two_surveys_alone_show_is_no_drift_of_another_size() {
    for seed in 1..=8 {
        let of = MadeHistory {
            surveys: 48,
            step: Some((46, -0.03)),
            seed,
            ..MadeHistory::default()
        };
        let found = seen(&made_history(&of));
        for mode in &found.modes {
            assert!(mode.changes.is_empty(), "seed {seed} {:?}", mode.changes);
            let off = mode.last_off.unwrap();
            assert_eq!((off.from, off.surveys), (46, 2), "seed {seed}");
            assert!((off.ratio + 0.03).abs() < 3.5 * off.sd, "seed {seed} {off:?}");
        }
    }
}

#[test]
fn holds_an_alarm_dates_from_the_survey_with_which_the_change_began() {
    for seed in 1..=8 {
        let of = MadeHistory {
            step: Some((35, -0.012)),
            seed,
            ..MadeHistory::default()
        };
        let found = seen(&made_history(&of));
        let first = found
            .alarms
            .iter()
            .find(|alarm| alarm.alarm.survey >= 35)
            .unwrap();
        assert!(first.alarm.since.abs_diff(35) <= 2, "seed {seed} {first:?}");
    }
}

#[test]
fn holds_unchanged_histories_are_rarely_called_changed() {
    let histories = 40_u64;
    let of = |seed| MadeHistory {
        seed: 7_000 + seed,
        ..MadeHistory::default()
    };
    let called = (0..histories)
        .filter(|seed| changed(&seen(&made_history(&of(*seed)))) > 0)
        .count();
    // 5 % is within the interval of the share, or above it
    let interval = clopper_pearson(called, histories as usize, 0.99).unwrap();
    assert!(interval.lower <= 0.05, "{called} of {histories}");
}

#[test]
fn holds_the_first_frost_is_not_judged() {
    let of = MadeHistory {
        surveys: 40,
        seed: 9,
        ..MadeHistory::default()
    };
    let mut history = made_history(&of);
    for survey in &mut history.surveys {
        survey.temperature_c = survey.temperature_c.map(|t| t.max(1.0));
    }
    let last = history.surveys.last_mut().unwrap();
    last.temperature_c = Some(-9.0);
    for mode in &mut last.modes {
        mode.frequency_hz *= 1.05; // ice in the joints
    }
    let found = seen(&history);
    for mode in &found.modes {
        assert_eq!(
            mode.judged.judged.last().unwrap().score,
            Err(NotJudged::Temperature)
        );
        assert_eq!(mode.strange, [39]);
    }
    assert_eq!(changed(&found), 0);
    assert!(found.alarms.iter().all(|alarm| alarm.alarm.survey != 39));
}

#[test]
fn holds_frost_that_was_learned_is_part_of_the_weather() {
    let of = MadeHistory {
        surveys: 120,
        seasons_c: 18.0,
        seed: 10,
        ..MadeHistory::default()
    };
    let mut history = made_history(&of);
    for survey in &mut history.surveys {
        let frost = (-survey.temperature_c.unwrap()).max(0.0);
        for mode in &mut survey.modes {
            mode.frequency_hz *= 1.0 + 0.004 * frost;
        }
    }
    let found = seen(&history);
    for mode in &found.modes {
        let weather = mode.weather.unwrap();
        assert_eq!(weather.known, WeatherKnown::TemperatureAndFrost);
        let (frost, sd) = weather.frost_per_c.unwrap();
        assert!((frost - 0.004).abs() < 3.5 * sd, "{frost} {sd}");
        assert!(mode.changes.is_empty(), "{:?}", mode.changes);
    }
}

#[test]
fn holds_gaps_stay_gaps_and_close_modes_are_told_by_their_shapes() {
    let of = MadeHistory {
        frequencies_hz: vec![2.1, 2.2, 6.8],
        per_c: 0.0,
        seed: 12,
        ..MadeHistory::default()
    };
    let mut history = made_history(&of);
    let mut random = Random::new(1, 0);
    let mut truth = Vec::new();
    for (i, survey) in history.surveys.iter_mut().enumerate() {
        // from the middle on, the two close modes have exchanged their frequencies
        if i >= 30 {
            let (a, b) = (survey.modes[0].frequency_hz, survey.modes[1].frequency_hz);
            (survey.modes[0].frequency_hz, survey.modes[1].frequency_hz) = (b, a);
            survey.modes.swap(0, 1);
        }
        let first = usize::from(i >= 30);
        let is_missing = i > 0 && random.uniform() < 0.3;
        truth.push((!is_missing).then_some(first));
        if is_missing {
            survey.modes.remove(first);
        }
    }
    let found = seen(&history);
    assert_eq!(found.modes.len(), 3);
    let by_truth = found
        .modes
        .iter()
        .filter(|mode| mode.track.modes == truth)
        .count();
    assert_eq!(
        by_truth,
        1,
        "{:?}\n{truth:?}",
        found.modes.iter().map(|m| &m.track.modes).collect::<Vec<_>>()
    );
}

#[test]
fn holds_a_replaced_sensor_is_named_and_is_no_damage() {
    let mut history = made_history(&MadeHistory {
        seed: 13,
        ..MadeHistory::default()
    });
    for survey in history.surveys.iter_mut().skip(25) {
        for mode in &mut survey.modes {
            mode.shape[1].component *= -0.5;
        }
    }
    let found = seen(&history);
    assert_eq!(found.modes.len(), 3);
    assert_eq!(found.tracked.sensors.len(), 1, "{:?}", found.tracked.sensors);
    let sensor = &found.tracked.sensors[0];
    assert_eq!((sensor.survey, sensor.channel.as_deref()), (25, Some("a2")));
    assert_eq!((changed(&found), found.alarms.len()), (0, 0));
}

#[test]
fn holds_a_sensor_of_one_direction_is_seen_beside_modes_of_another() {
    let mut history = made_history(&MadeHistory {
        seed: 14,
        ..MadeHistory::default()
    });
    for (at, survey) in history.surveys.iter_mut().enumerate() {
        let (along, across) = survey.modes.split_at_mut(2);
        for point in across.iter_mut().flat_map(|mode| &mut mode.shape) {
            point.channel.name = point.channel.name.replace('a', "b");
        }
        if at >= 25 {
            along.iter_mut().for_each(|mode| mode.shape[1].component *= -0.5);
        }
    }
    let found = seen(&history);
    assert_eq!(found.tracked.sensors.len(), 1, "{:?}", found.tracked.sensors);
    let sensor = &found.tracked.sensors[0];
    assert_eq!((sensor.survey, sensor.channel.as_deref()), (25, Some("a2")));
}

#[test]
fn holds_a_repair_is_a_change_only_where_it_was_not_declared() {
    let mut history = made_history(&MadeHistory {
        step: Some((30, 0.08)),
        seed: 14,
        ..MadeHistory::default()
    });
    let undeclared = seen(&history);
    for mode in &undeclared.modes {
        assert!(
            (mode.changes[0].ratio - 0.08).abs() < 0.003 && mode.changes[0].from == 30,
            "{:?}",
            mode.changes
        );
    }
    assert!(
        undeclared
            .alarms
            .iter()
            .any(|alarm| (30..34).contains(&alarm.alarm.survey))
    );
    history.works.push(Work {
        day: history.surveys[30].day - 10.0,
        splits: true,
        answers: true,
    });
    let declared = seen(&history);
    assert_eq!(
        (changed(&declared), declared.alarms.len()),
        (0, 0),
        "{:?}",
        declared.alarms
    );
    for mode in &declared.modes {
        assert!(
            (mode.works[0].ratio - 0.08).abs() < 3.5 * mode.works[0].sd,
            "{:?}",
            mode.works
        );
    }
}

#[test]
fn holds_one_wild_reading_is_named_and_confirms_nothing() {
    let mut history = made_history(&MadeHistory {
        seed: 15,
        ..MadeHistory::default()
    });
    history.surveys[40].modes[0].frequency_hz *= 0.95;
    let found = seen(&history);
    assert_eq!(found.modes[0].outliers, [40]);
    assert_eq!(changed(&found), 0);
    assert!(
        found
            .alarms
            .iter()
            .all(|alarm| alarm.alarm.survey.abs_diff(42) > 2),
        "{:?}",
        found.alarms
    );
}

#[test]
fn holds_tilts_of_two_marks_are_two_series() {
    let mut history = made_history(&MadeHistory {
        surveys: 24,
        seed: 16,
        ..MadeHistory::default()
    });
    for (i, survey) in history.surveys.iter_mut().enumerate() {
        let mark = if i < 12 { "old" } else { "new" };
        let jump = if i < 12 { 0.0 } else { 0.004 };
        survey.tilts.push(TiltReading {
            direction: "x".into(),
            datum: Some(mark.into()),
            ratio: 0.003 + jump + 1e-5 * f64::from(i32::try_from(i % 3).unwrap()),
        });
    }
    let found = seen(&history);
    assert_eq!(found.tilts.len(), 2);
    assert!(
        found.tilts.iter().all(|trend| !trend.is_beyond_chance()),
        "{:?}",
        found.tilts
    );
}

#[test]
fn holds_a_first_year_that_warms_shows_less_and_says_so() {
    let of = MadeHistory {
        surveys: 40,
        interval_days: 9.0,
        seed: 17,
        ..MadeHistory::default()
    };
    let steady = seen(&made_history(&MadeHistory {
        seasons_c: 4.0,
        ..of.clone()
    }));
    let warming = seen(&made_history(&MadeHistory {
        seasons_c: 0.0,
        warming_c: 25.0,
        ..of
    }));
    let mode = &warming.modes[0];
    assert!(
        mode.weather.unwrap().with_time.is_some_and(|r| r > 0.8),
        "{:?}",
        mode.weather
    );
    assert!(steady.modes[0].weather.unwrap().with_time.is_none());
    assert!(mode.seen_from_ratio.unwrap() > 1.2 * steady.modes[0].seen_from_ratio.unwrap());
}

#[test]
fn refuses_days_that_do_not_follow_and_too_few_surveys() {
    let mut history = made_history(&MadeHistory {
        surveys: 5,
        ..MadeHistory::default()
    });
    history.surveys[3].day = history.surveys[2].day;
    let why = watch(&history, &WatchOptions::default()).unwrap_err().to_string();
    assert!(why.starts_with("survey 3 is on day"), "{why}");
    history.surveys.truncate(2);
    let why = watch(&history, &WatchOptions::default()).unwrap_err().to_string();
    assert!(why.starts_with("2 surveys, but a history needs 3"), "{why}");
}
