// SOURCE     Simulated histories with known changes (`made_history`): three modes, temperature ± 12 °C, AR(1) 0.3, readings accurate to
//            0.12 %.
// GOAL       Without the effect of weather, two surveys of a history differ by chance as often as stated; a step between them has its size.
// TOLERANCE  5 % of unchanged pairs called changed, and 95 % of intervals with the truth, each within its Clopper-Pearson interval (99 %).

use dolmen::assess::{SurveyChange, SurveyChangeOptions, Surveyed, TemperatureKnowledge, survey_change};
use dolmen::monitoring::{History, MadeHistory, WatchOptions, made_history, watch};
use dolmen::numeric::clopper_pearson;

/// The last survey above freezing, compared with the fourth.
fn compared(history: &History) -> SurveyChange {
    let options = WatchOptions {
        replicates: 0,
        ..WatchOptions::default()
    };
    let is_warm = |i: &usize| history.surveys[*i].temperature_c.is_some_and(|t| t > 0.0);
    let from = (3..history.surveys.len()).find(is_warm).unwrap();
    let to = (0..history.surveys.len()).rev().find(is_warm).unwrap();
    let history_of_both = watch(history, &options).unwrap().between(from, to);
    assert_eq!(history_of_both.len(), 3);
    let survey = |i: usize| Surveyed {
        name: history.surveys[i].name.clone(),
        temperature_c: history.surveys[i].temperature_c,
        modes: history.surveys[i].modes.clone(),
    };
    let options = SurveyChangeOptions {
        history: history_of_both,
        ..SurveyChangeOptions::default()
    };
    survey_change(&survey(from), &survey(to), &[], &options).unwrap()
}

#[test]
fn holds_two_surveys_differ_by_chance_as_stated() {
    let histories = 120;
    for surveys in [24, 60] {
        let all = (0..histories).map(|seed: usize| {
            let of = MadeHistory {
                surveys,
                seed: 31_000 + seed as u64,
                ..MadeHistory::default()
            };
            compared(&made_history(&of))
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
        let change = compared(&made_history(&of));
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
