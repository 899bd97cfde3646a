// SOURCE     Simulated histories with known changes (`made_history`): three modes, temperature ± 12 °C, AR(1) 0.3, readings accurate to
//            0.12 %.
// GOAL       Without the effect of weather, the first and the last survey of a history differ by chance as often as stated, whatever the
//            weather on these days; a step between them has its size, and is found as often as stated.
// TOLERANCE  5 % of unchanged pairs called changed, 95 % of intervals with the truth, and 80 % of changes of the stated size found, each within
//            its Clopper-Pearson interval (99 %).

use dolmen::assess::{SurveyChange, SurveyChangeOptions, Surveyed, TemperatureKnowledge, survey_change};
use dolmen::monitoring::{History, MadeHistory, WatchOptions, made_history, watch};
use dolmen::numeric::clopper_pearson;

/// The first and the last survey whose weather the history knows, or the very first and last.
#[derive(Clone, Copy, PartialEq)]
enum Ends {
    Known,
    Outermost,
}

/// Two surveys of a history, compared as `dolmen compare` does.
fn compared(history: &History, ends: Ends) -> SurveyChange {
    let options = WatchOptions {
        replicates: 0,
        ..WatchOptions::default()
    };
    let all = watch(history, &options).unwrap();
    let is_taken = |i: &usize| ends == Ends::Outermost || all.is_weather_known(*i);
    let from = (0..history.surveys.len()).find(is_taken).unwrap();
    let to = (0..history.surveys.len()).rev().find(is_taken).unwrap();
    let history_of_both = all.between(from, to);
    let undecided_hz = all.undecided_between(from, to);
    assert_eq!(history_of_both.len() + undecided_hz.len(), 3);
    let survey = |i: usize| Surveyed {
        name: history.surveys[i].name.clone(),
        temperature_c: history.surveys[i].temperature_c,
        modes: history.surveys[i].modes.clone(),
    };
    let options = SurveyChangeOptions {
        history: history_of_both,
        undecided_hz,
        ..SurveyChangeOptions::default()
    };
    survey_change(&survey(from), &survey(to), &[], &options).unwrap()
}

#[test]
fn holds_two_surveys_differ_by_chance_as_stated() {
    let histories = 120;
    for surveys in [12, 24, 60] {
        let all = (0..histories).map(|seed: usize| {
            let of = MadeHistory {
                surveys,
                seed: 31_000 + seed as u64,
                ..MadeHistory::default()
            };
            compared(&made_history(&of), Ends::Known)
        });
        let (mut called, mut held) = (0, 0);
        for change in all {
            assert!(matches!(
                change.temperature,
                TemperatureKnowledge::Corrected { .. }
            ));
            called += usize::from(change.changed().count() > 0);
            let mode = &change.modes[0].frequency;
            held += usize::from(mode.relative.abs() <= mode.evidence.as_ref().unwrap().half_width_95);
        }
        let called_changed = clopper_pearson(called, histories, 0.99).unwrap();
        assert!(
            called_changed.lower <= 0.05,
            "{surveys} surveys: {called} of {histories} called changed"
        );
        let with_truth = clopper_pearson(held, histories, 0.99).unwrap();
        assert!(
            with_truth.upper >= 0.95,
            "{surveys} surveys: {held} of {histories} intervals hold the truth"
        );
    }
}

#[test]
fn holds_a_step_between_two_surveys_has_its_size() {
    for seed in 1..=20 {
        let of = MadeHistory {
            surveys: 24,
            step: Some((14, -0.015)),
            seed,
            ..MadeHistory::default()
        };
        let change = compared(&made_history(&of), Ends::Known);
        for mode in &change.modes {
            let evidence = mode.frequency.evidence.as_ref().unwrap();
            assert!(
                (mode.frequency.relative + 0.015).abs() < 3.5 * evidence.sd,
                "seed {seed} {mode:?}"
            );
            // 1.41 × √(0.12² + 0.10²) % = 0.22 %, and not much more
            assert!((0.001..0.004).contains(&evidence.sd), "seed {seed} {evidence:?}");
        }
    }
}

#[test]
fn holds_a_survey_too_cold_for_the_history_is_not_tested() {
    let mut cold = 0;
    for seed in 0..60 {
        let of = MadeHistory {
            surveys: 24,
            seed: 31_000 + seed,
            ..MadeHistory::default()
        };
        let history = made_history(&of);
        let change = compared(&history, Ends::Outermost);
        let frozen = history
            .surveys
            .iter()
            .filter(|survey| survey.temperature_c.is_some_and(|t| t < 0.0));
        let is_of_few = frozen.clone().count() < 3;
        let is_frozen = |i: usize| history.surveys[i].temperature_c.is_some_and(|t| t < 0.0);
        if is_of_few && (is_frozen(0) || is_frozen(23)) {
            cold += 1;
            assert!(change.modes.iter().all(|mode| mode.is_undecided));
            assert_eq!((change.tested(), change.changed().count()), (0, 0));
        } else {
            assert_eq!(change.tested(), 3, "seed {seed}");
        }
    }
    assert!(cold >= 10, "{cold}");
}

#[test]
fn holds_a_change_of_the_stated_size_is_found_as_often_as_stated() {
    let histories = 100;
    let mut found = 0;
    for seed in 0..histories {
        let of = |step| MadeHistory {
            surveys: 24,
            seed: 52_000 + seed as u64,
            step,
            ..MadeHistory::default()
        };
        let least = compared(&made_history(&of(None)), Ends::Known)
            .detectable()
            .unwrap();
        let change = compared(&made_history(&of(Some((12, -least)))), Ends::Known);
        found += change.changed().count();
    }
    let rate = clopper_pearson(found, 3 * histories, 0.99).unwrap();
    assert!(rate.upper >= 0.8, "{found} of {} changes found", 3 * histories);
}
