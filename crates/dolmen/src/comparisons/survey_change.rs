//! Two surveys of one mode, and a line over temperature, compared with SciPy 1.17.1.

use super::{Case, ValidationError};
use crate::assess::{SurveyChangeOptions, Surveyed, TemperatureEffect, survey_change};
use crate::modal::ObservedMode;

const SOURCE: &str = "SciPy 1.17.1";
const WELCH: &str = "SciPy 1.17.1, ttest_ind_from_stats(2.031, 0.012 √30, 30, 2.0, 0.007 √20, 20, equal_var=False): what a change between two surveys \
                     is tested by.";
const LINE: &str = "SciPy 1.17.1, linregress([18, 5, -3, 27, 11], [2.01, 2.06, 2.11, 1.99, 2.03]): slope and its standard error, over the frequency \
                    of the first survey.";
/// Relative tolerance: SciPy prints 16 digits, but its continued fractions are less accurate.
const TOLERANCE: f64 = 1e-9;

fn survey(
    name: &str,
    temperature_c: f64,
    (frequency_hz, sd_hz, degrees_of_freedom): (f64, f64, f64),
) -> Surveyed {
    Surveyed {
        name: name.to_owned(),
        temperature_c: Some(temperature_c),
        modes: vec![ObservedMode {
            frequency_hz,
            frequency_sd_hz: Some(sd_hz),
            damping_ratio: None,
            damping_ratio_sd: None,
            degrees_of_freedom,
            direction: None,
            accepted: false,
            shape: Vec::new(),
        }],
    }
}

pub(super) fn cases() -> Result<Vec<Case>, ValidationError> {
    let case = |what: &str, unit, published: f64, computed: f64, note| Case {
        source: SOURCE,
        what: what.to_owned(),
        unit,
        published,
        computed,
        tolerance: TOLERANCE * published.abs(),
        corrected: None,
        note,
    };
    let (from, to) = (
        survey("a", 10.0, (2.0, 0.007, 19.0)),
        survey("b", 10.0, (2.031, 0.012, 29.0)),
    );
    let found = survey_change(&from, &to, &[], &SurveyChangeOptions::default())?;
    let evidence = found.modes.first().and_then(|m| m.frequency.evidence.as_ref());
    let [t, p] = evidence.map_or([f64::NAN; 2], |e| [e.statistic, e.p]);
    let options = SurveyChangeOptions {
        temperature: TemperatureEffect::Fitted,
        ..Default::default()
    };
    let exact = |name, t, f| survey(name, t, (f, 0.001, f64::INFINITY));
    let earlier = [
        exact("2", 5.0, 2.06),
        exact("3", -3.0, 2.11),
        exact("4", 27.0, 1.99),
        exact("5", 11.0, 2.03),
    ];
    let found = survey_change(
        &exact("1", 18.0, 2.01),
        &exact("6", 20.0, 2.0),
        &earlier,
        &options,
    )?;
    let line = found.modes.first().and_then(|m| m.fitted.as_ref());
    let [slope, sd] = line.map_or([f64::NAN; 2], |l| [l.per_c * 2.01, l.sd_per_c * 2.01]);
    Ok(vec![
        case(
            "two surveys: Welch's t of a frequency",
            "",
            2.231428827320963,
            t,
            WELCH,
        ),
        case(
            "two surveys: its two-sided probability",
            "",
            0.030763561609950727,
            p,
            WELCH,
        ),
        case(
            "slope of a frequency over temperature",
            "Hz/°C",
            -0.003942451420029894,
            slope,
            LINE,
        ),
        case("its standard error", "Hz/°C", 0.0005475789808280832, sd, LINE),
    ])
}
