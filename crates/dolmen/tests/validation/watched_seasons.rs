// SOURCE     Simulated histories with known values: tilts read once a year, twice a year and every month, with and without an annual wave;
//            frequencies of which some surveys have no temperature; exchanged marks; a reversed sign.
// GOAL       The tilt stated for today is that of the last readings, and the forecast contains the true value for any dates of reading. No survey is
//            missing from the search for changes.
// TOLERANCE  tilt now: 0.12 mm/m for readings accurate to 0.03 mm/m; intervals of 95 %: 93 to 98 % by the scatter of 306 histories, minus 5 % with a
//            false change.

use dolmen::monitoring::{
    ChangeForm, History, HistorySurvey, MadeHistory, TiltReading, TiltTrend, WatchOptions, Watched, Work,
    made_history, watch,
};
use dolmen::numeric::Random;
use std::f64::consts::TAU;

const YEAR: f64 = 365.25;
const LIMIT: f64 = 1.0 / 150.0;

fn seen(history: &History) -> Watched {
    let options = WatchOptions {
        tilt_limit: Some(LIMIT),
        replicates: 0,
        ..WatchOptions::default()
    };
    watch(history, &options).unwrap()
}

fn survey(day: f64, ratio: f64, datum: Option<&str>) -> HistorySurvey {
    HistorySurvey {
        name: format!("{day}"),
        day,
        temperature_c: None,
        modes: Vec::new(),
        tilts: vec![TiltReading {
            direction: "x".into(),
            datum: datum.map(Into::into),
            ratio,
        }],
    }
}

fn history(surveys: Vec<HistorySurvey>) -> History {
    History {
        surveys,
        works: Vec::new(),
    }
}

/// Seasonal part, mm/m.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Wave {
    None,
    Sine,
    /// 0.02 mm/m per °C for an annual wave of ± 13 °C with ± 2 °C of weather.
    Temperature,
}

/// A tilt of 2.0 mm/m that grows by 0.2 mm/m a year, read so many times a year for thirteen or eight years; and the true tilt of the last day at the
/// times of year at which it is read.
fn made(times_a_year: u32, wave: Wave, seed: u64) -> (History, f64) {
    let mut random = Random::new(seed, 11);
    let years = if times_a_year > 2 { 8 } else { 13 };
    let begins = random.uniform() * YEAR;
    let gap = YEAR / f64::from(times_a_year);
    let season = |day: f64| match wave {
        Wave::None => 0.0,
        Wave::Sine => 0.3 * (TAU * day / YEAR + 1.0).sin(),
        Wave::Temperature => -0.02 * 13.0 * (TAU * day / YEAR).cos(),
    };
    let line = |day: f64| 2.0 + 0.2 * (day - begins) / YEAR;
    let count = years * times_a_year;
    let mut days = Vec::new();
    let surveys = (0..count).map(|i| {
        let day = (begins + gap * f64::from(i) + (10.0 * random.uniform() - 5.0)).round();
        days.push(day);
        let weather = match wave {
            Wave::Temperature => 0.02 * 2.0 * random.normal(),
            _ => 0.0,
        };
        let read = line(day) + season(day) + weather + 0.03 * random.normal();
        survey(day, 1e-3 * read, None)
    });
    let history = history(surveys.collect());
    let of_year: f64 = (0..times_a_year)
        .map(|i| season(begins + gap * f64::from(i)))
        .sum();
    let truth = line(*days.last().unwrap()) + of_year / f64::from(times_a_year);
    (history, truth)
}

#[test]
fn holds_the_tilt_now_and_its_forecast_however_readings_lie_in_the_year() {
    let (mut held, mut all, mut farthest) = (0, 0, 0.0_f64);
    for times_a_year in [1, 2, 12] {
        for wave in [Wave::None, Wave::Sine, Wave::Temperature] {
            for seed in 0..34 {
                let (history, truth) = made(times_a_year, wave, 100 * seed + u64::from(times_a_year));
                let found = seen(&history);
                let slope = found.tilts[0].slope.unwrap();
                let off = 1e3 * slope.now - truth;
                farthest = farthest.max(off.abs());
                assert!(off.abs() < 0.12, "{times_a_year} {wave:?} {seed}: {off}");
                let reach = slope.reach.unwrap();
                let left = (1e3 * LIMIT - truth) / 0.2;
                let of = reach.years_earliest.zip(reach.years_latest);
                let holds = of.is_some_and(|(from, to)| from <= left && left <= to);
                held += u32::from(holds);
                all += 1;
            }
        }
    }
    let share = f64::from(held) / f64::from(all);
    assert!(all == 306 && share >= 0.88, "{held} of {all}, {farthest}");
}

#[test]
fn holds_a_still_tilt_read_in_one_season_is_what_it_was_read() {
    for seed in 0..60 {
        let mut random = Random::new(seed, 5);
        let surveys = (0..13).map(|i| {
            let day = (40.0 + YEAR * f64::from(i) + (10.0 * random.uniform() - 5.0)).round();
            survey(day, 4e-3 + 3e-5 * random.normal(), None)
        });
        let found = seen(&history(surveys.collect()));
        let now = found.tilts[0].slope.unwrap().now;
        assert!((now - 4e-3).abs() < 1e-4, "{seed}: {now}");
    }
}

#[test]
fn holds_surveys_without_a_temperature_take_part_in_the_search() {
    let quarterly = |seed| MadeHistory {
        surveys: 40,
        interval_days: 91.0,
        per_c: -0.0015,
        seed,
        ..MadeHistory::default()
    };
    let without = |history: &mut History, which: &dyn Fn(usize) -> bool| {
        let surveys = history.surveys.iter_mut().enumerate();
        let hidden = surveys.filter(|(i, _)| which(*i));
        hidden.for_each(|(_, survey)| survey.temperature_c = None);
    };
    for seed in 0..10 {
        let mut fallen = made_history(&MadeHistory {
            step: Some((34, -0.05)),
            ..quarterly(900 + seed)
        });
        without(&mut fallen, &|i| i >= 34);
        for mode in seen(&fallen).modes {
            assert_eq!(mode.guessed, [34, 35, 36, 37, 38, 39], "{seed}");
            let steps = mode.changes.iter().filter(|of| of.form == ChangeForm::Step);
            let change = steps.min_by(|a, b| a.ratio.total_cmp(&b.ratio)).unwrap();
            assert!(change.from.abs_diff(34) <= 1, "{seed} {change:?}");
            assert!((change.ratio + 0.05).abs() < 3.5 * change.sd, "{seed} {change:?}");
        }
    }
    // none changed: those in winter alone have none, so that their weather is of one side
    let mut changed = 0;
    for seed in 0..40 {
        let mut still = made_history(&quarterly(2_000 + seed));
        without(&mut still, &|i| i >= 24 && i % 4 == 0);
        let found = seen(&still);
        changed += u32::from(found.modes.iter().any(|mode| !mode.changes.is_empty()));
    }
    assert!(changed <= 5, "{changed} of 40"); // 5 %: at most 5 with 95 %
}

/// Quarterly readings of 2.0 mm/m that grow by 0.4 mm/m a year, with the marks of each.
fn marked(seed: u64, surveys: u32, of_new: u32) -> Vec<HistorySurvey> {
    let mut random = Random::new(seed, 7);
    let each = (0..surveys).map(|i| {
        let day = 91.0 * f64::from(i);
        let (mark, less) = if i + of_new >= surveys {
            ("m2", 2.0)
        } else {
            ("m1", 0.0)
        };
        let read = 2.0 + 0.4 * day / YEAR - less + 0.03 * random.normal();
        survey(day, 1e-3 * read, Some(mark))
    });
    each.collect()
}

#[test]
fn holds_a_new_mark_is_forecast_by_the_slope_of_the_one_before() {
    let mut held = 0;
    for seed in 0..100 {
        for of_new in [2, 4] {
            let surveys = marked(seed, 40, of_new);
            let last = surveys[39].day;
            let found = seen(&history(surveys));
            let new = found
                .tilts
                .iter()
                .find(|of| of.series.datum.as_deref() == Some("m2"));
            let forecast = new.unwrap().forecast().unwrap();
            let truth = (1e3 * LIMIT - 0.4 * last / YEAR) / 0.4;
            let reach = forecast.reach.unwrap();
            let (from, to) = (reach.years_earliest.unwrap(), reach.years_latest.unwrap());
            held += u32::from(from <= truth && truth <= to);
            // a slope of its own, from four readings, is less accurate
            let is_own = new.unwrap().is_beyond_chance();
            assert!(
                is_own || (reach.years.unwrap() / truth - 1.0).abs() < 0.1,
                "{seed} {reach:?}"
            );
        }
    }
    assert!((180..=200).contains(&held), "{held} of 200 hold the truth");
}

fn of_readings(ratio: impl Fn(f64, u32) -> f64) -> TiltTrend {
    let mut random = Random::new(3, 9);
    let surveys = (0..40).map(|i| {
        let day = 91.0 * f64::from(i);
        survey(day, 1e-3 * (ratio(day / YEAR, i) + 0.03 * random.normal()), None)
    });
    seen(&history(surveys.collect())).tilts.remove(0)
}

#[test]
fn holds_a_sign_that_turned_is_asked_about_and_gives_no_year() {
    let turned = |from: u32| of_readings(move |y, i| (2.0 + 0.3 * y) * if i >= from { -1.0 } else { 1.0 });
    for from in [3, 20, 38] {
        let found = turned(from);
        assert!(found.is_sign_in_question(), "{from}: {:?}", found.changes);
        let reach = found.slope.unwrap().reach.unwrap();
        assert!(
            found.forecast().is_none() && reach.years.is_none(),
            "{from}: {reach:?}"
        );
    }
    // a step that does not reverse the sign, and one of another size
    assert!(!of_readings(|y, i| 2.0 + 0.3 * y + if i >= 20 { 1.5 } else { 0.0 }).is_sign_in_question());
    assert!(!of_readings(|y, i| 3.0 + 0.1 * y - if i >= 20 { 4.5 } else { 0.0 }).is_sign_in_question());
}

#[test]
fn holds_the_first_reading_of_a_new_level_is_no_slip() {
    let found = of_readings(|y, i| 2.0 + 0.4 * y - if i >= 20 { 3.0 } else { 0.0 });
    assert!(found.outliers.is_empty(), "{:?}", found.outliers);
    let jump = found.steps().next().unwrap();
    assert_eq!((jump.from, jump.after, jump.before), (20, 19, 20));
}

#[test]
fn holds_a_repair_before_surveys_without_a_temperature_keeps_its_effect() {
    let mut history = made_history(&MadeHistory {
        surveys: 40,
        interval_days: 91.0,
        step: Some((20, 0.06)),
        seed: 31,
        ..MadeHistory::default()
    });
    history.surveys[24..28]
        .iter_mut()
        .for_each(|survey| survey.temperature_c = None);
    history.works.push(Work {
        day: history.surveys[20].day - 5.0,
        splits: true,
        answers: true,
    });
    for mode in seen(&history).modes {
        assert!(mode.changes.is_empty(), "{:?}", mode.changes);
        let work = mode.works[0];
        assert!((work.ratio - 0.06).abs() < 4.0 * work.sd, "{work:?}");
    }
}
