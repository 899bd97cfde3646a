//! Notes on the numbers of a change.

use super::directions::ExchangedDirections;
use super::swapped::{SwappedChannels, TurnedChannel};
use crate::assess::error::AssessError;

/// A note on the result of a comparison of surveys.
#[derive(Clone, Debug, PartialEq)]
pub enum ChangeNote {
    /// No line over temperature could be fitted for a mode: its change is not corrected.
    NotFitted {
        /// Frequency before, Hz.
        frequency_hz: f64,
        /// Why.
        why: Box<AssessError>,
    },
    /// The later survey is warmer or colder than all surveys of the fitted line.
    BeyondTheLine {
        /// Temperature of the later survey, °C.
        temperature_c: f64,
        /// Temperature range of the fitted line, °C.
        range_c: [f64; 2],
    },
    /// The earlier surveys scatter about the line over temperature by far more than their standard deviations.
    LineScatters {
        /// Frequency before, Hz.
        frequency_hz: f64,
        /// Deviation of a survey about the line, Hz.
        scatter_hz: f64,
        /// Standard deviation stated by the surveys, Hz.
        stated_hz: f64,
    },
    /// Temperature is correlated with the order of the surveys, so that weather and ageing cannot be separated.
    LineWithTime {
        /// Frequency before, Hz.
        frequency_hz: f64,
        /// Correlation of temperature and order.
        correlation: f64,
    },
    /// Modes with the same frequency in both surveys are not paired, because their shapes differ.
    OtherShapes {
        /// Frequencies of these modes before, Hz.
        frequencies_hz: Vec<f64>,
    },
    /// Two channels look exchanged in one of the surveys.
    Swapped(SwappedChannels),
    /// A channel seems reversed in one of the surveys.
    Turned(TurnedChannel),
    /// The directions x and y look exchanged in one of the surveys.
    DirectionsExchanged(ExchangedDirections),
    /// All frequencies differ by the ratio of the sampling rates of the records.
    RateRatio {
        /// Ratio of the frequencies, after over before.
        factor: f64,
        /// The sampling rates, Hz.
        rates_hz: [f64; 2],
        /// Number of modes with this ratio.
        modes: usize,
    },
    /// No mode has a partner, and the values of one survey are the reciprocals of those of the other.
    Reciprocals {
        /// Number of modes.
        modes: usize,
    },
    /// No mode has a partner, and all frequencies differ by one factor.
    OneFactor {
        /// Ratio of the frequencies, after over before.
        factor: f64,
        /// Number of modes with this factor.
        modes: usize,
    },
}

impl std::fmt::Display for ChangeNote {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            ChangeNote::NotFitted { frequency_hz, why } => write!(
                f,
                "no coefficient of temperature could be fitted for the mode at {frequency_hz:.3} Hz, so that its change is not corrected: {why}"
            ),
            ChangeNote::BeyondTheLine {
                temperature_c,
                range_c,
            } => write!(
                f,
                "{temperature_c} °C lies beyond the {} to {} °C that the coefficients were fitted to: a line need not hold there",
                range_c[0], range_c[1]
            ),
            ChangeNote::LineScatters {
                frequency_hz,
                scatter_hz,
                stated_hz,
            } => write!(
                f,
                "at {frequency_hz:.3} Hz the earlier surveys lie {:.2} % about their line over temperature and state {:.2} %: the structure may have changed \
                 between them, and a change of that size is not seen here",
                100.0 * scatter_hz / frequency_hz,
                100.0 * stated_hz / frequency_hz
            ),
            ChangeNote::LineWithTime {
                frequency_hz,
                correlation,
            } => write!(
                f,
                "at {frequency_hz:.3} Hz temperature {} from survey to survey (correlation {correlation:+.2}): weather and ageing cannot be told apart, and \
                 ageing may have been taken for weather",
                if *correlation > 0.0 { "rises" } else { "falls" }
            ),
            ChangeNote::OtherShapes { frequencies_hz } => {
                let each: Vec<String> = frequencies_hz.iter().map(|hz| format!("{hz:.3}")).collect();
                write!(
                    f,
                    "at {} Hz both surveys have a mode, but with shapes unlike each other, so that it counts as lost and as new: were channels \
                     swapped, or sensors turned or moved?",
                    each.join(", ")
                )
            }
            ChangeNote::Swapped(swapped) => {
                let [a, b] = &swapped.channels;
                write!(
                    f,
                    "channels \"{a}\" and \"{b}\" look swapped in one of the surveys: mean MAC of {} modes {:.2} as they are, {:.2} with the two \
                     exchanged",
                    swapped.modes, swapped.assurance, swapped.exchanged
                )
            }
            ChangeNote::Turned(turned) => write!(
                f,
                "channel \"{}\" looks turned round in one of the surveys: mean MAC of {} modes {:.2} as they are, {:.2} with its sign changed",
                turned.channel, turned.modes, turned.assurance, turned.turned
            ),
            ChangeNote::DirectionsExchanged(found) => write!(
                f,
                "the directions x and y look exchanged in one of the surveys: both have the same {} frequencies, their modes alike to {:.2} as they are and to {:.2} \
                 with x and y exchanged",
                found.modes, found.likeness, found.exchanged
            ),
            ChangeNote::RateRatio {
                factor,
                rates_hz: [before, after],
                modes,
            } => write!(
                f,
                "all {modes} frequencies are {factor:.4} times what they were, the ratio of the sampling rates {before} and {after} Hz: one of these is probably wrong"
            ),
            ChangeNote::Reciprocals { modes } => write!(
                f,
                "no mode has a partner, and the values of one survey are the reciprocals of those of the other ({modes}): periods in s for frequencies in Hz?"
            ),
            ChangeNote::OneFactor { factor, modes } => write!(
                f,
                "no mode has a partner, and all {modes} frequencies are {factor:.3} times what they were: is the sampling rate of a survey wrong?"
            ),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::surveys::{SurveyChangeOptions, Surveyed, survey_change};
    use super::super::temperature::TemperatureEffect;
    use super::*;
    use crate::modal::{ObservedMode, ObservedPoint};
    use crate::signal::Channel;

    fn survey(modes: &[(f64, [f64; 3])]) -> Surveyed {
        let mode = |(frequency_hz, shape): &(f64, [f64; 3])| ObservedMode {
            frequency_hz: *frequency_hz,
            frequency_sd_hz: Some(0.01),
            damping_ratio: None,
            damping_ratio_sd: None,
            degrees_of_freedom: f64::INFINITY,
            direction: None,
            accepted: false,
            shape: ["a", "b", "c"]
                .iter()
                .zip(shape)
                .map(|(name, component)| ObservedPoint::real(Channel::named(*name), *component))
                .collect(),
        };
        Surveyed {
            name: "survey".into(),
            temperature_c: None,
            modes: modes.iter().map(mode).collect(),
        }
    }

    fn notes(from: &[(f64, [f64; 3])], to: &[(f64, [f64; 3])]) -> Vec<ChangeNote> {
        let options = SurveyChangeOptions::default();
        survey_change(&survey(from), &survey(to), &[], &options)
            .unwrap()
            .notes
    }

    const FIRST: [f64; 3] = [0.1, 0.5, 1.0];
    const SECOND: [f64; 3] = [0.6, 0.8, -0.5];

    /// Three channels in the order b, c, a: the frequencies stay, the shapes do not.
    #[test]
    fn holds_swapped_channels_are_asked_about() {
        let swapped = |[a, b, c]: [f64; 3]| [c, a, b];
        let before = [(2.0, FIRST), (5.0, SECOND)];
        let found = notes(&before, &[(2.01, swapped(FIRST)), (5.0, swapped(SECOND))]);
        let asked = ChangeNote::OtherShapes {
            frequencies_hz: vec![2.0, 5.0],
        };
        assert_eq!(found, [asked]);
        assert_eq!(notes(&before, &[(2.01, FIRST), (5.0, SECOND)]), []);
        assert_eq!(notes(&before, &[(2.01, FIRST), (5.2, SECOND)]), []);
    }

    /// Notes for the later survey at 24 °C, if the earlier surveys have these temperatures, °C, and frequencies,
    /// each ± 0.003 Hz.
    fn about_weather(points: &[(f64, f64)]) -> Vec<ChangeNote> {
        let at = |&(temperature_c, frequency_hz): &(f64, f64)| {
            let mut one = survey(&[(frequency_hz, FIRST)]);
            one.temperature_c = Some(temperature_c);
            one.modes[0].frequency_sd_hz = Some(0.003);
            one
        };
        let surveys: Vec<Surveyed> = points.iter().map(at).collect();
        let options = SurveyChangeOptions {
            temperature: TemperatureEffect::Fitted,
            ..SurveyChangeOptions::default()
        };
        survey_change(&surveys[0], &at(&(24.0, 2.04)), &surveys[1..], &options)
            .unwrap()
            .notes
    }

    #[test]
    fn holds_a_line_that_may_have_taken_ageing_for_weather_is_said() {
        let rising = [
            (2.0, 2.17),
            (6.0, 2.151),
            (9.0, 2.13),
            (13.0, 2.109),
            (17.0, 2.083),
            (20.0, 2.062),
        ];
        let is_with_time = |note: &ChangeNote| matches!(note, ChangeNote::LineWithTime { correlation, .. } if *correlation > 0.99);
        assert!(about_weather(&rising).iter().any(is_with_time));
        // seasons of a gate: 2.5 mHz per °C, and a scatter no larger than stated
        let seasons = [
            (11.0, 2.14),
            (27.0, 2.10),
            (15.0, 2.13),
            (-3.0, 2.175),
            (18.0, 2.1225),
            (29.0, 2.095),
        ];
        let said = |notes: Vec<ChangeNote>| {
            let doubts = |note: &ChangeNote| {
                matches!(
                    note,
                    ChangeNote::LineWithTime { .. } | ChangeNote::LineScatters { .. }
                )
            };
            notes.iter().any(doubts)
        };
        assert!(!said(about_weather(&seasons)));
        // all surveys after the first are 3 % lower
        let dropped: Vec<(f64, f64)> = seasons
            .iter()
            .enumerate()
            .map(|(i, &(c, hz))| (c, if i > 0 { 0.97 * hz } else { hz }))
            .collect();
        let scatters = |note: &ChangeNote| matches!(note, ChangeNote::LineScatters { stated_hz, scatter_hz, .. } if scatter_hz > &(3.0 * stated_hz));
        assert!(about_weather(&dropped).iter().any(scatters));
    }

    /// Two exchanged channels give one note, whether the modes still pair or not; a change of shape gives none.
    #[test]
    fn holds_two_exchanged_channels_are_named() {
        let exchanged = |[a, b, c]: [f64; 3]| [c, b, a];
        let before = [(2.0, FIRST), (5.0, SECOND)];
        let found = notes(&before, &[(2.01, exchanged(FIRST)), (5.0, exchanged(SECOND))]);
        let swapped = found.iter().find_map(|note| match note {
            ChangeNote::Swapped(swapped) => Some(swapped),
            _ => None,
        });
        let swapped = swapped.unwrap();
        assert_eq!(swapped.channels, ["a", "c"]);
        assert_eq!(swapped.modes, 2);
        assert!((swapped.exchanged - 1.0).abs() < 1e-12, "{swapped:?}");
        // (0.1·1 + 0.5² + 1·0.1)² / 1.26² and (-0.3 + 0.64 - 0.3)² / 1.25²
        let exact = 0.5 * ((0.45 / 1.26_f64).powi(2) + (0.04 / 1.25_f64).powi(2));
        assert!((swapped.assurance - exact).abs() < 1e-12, "{swapped:?}");
        let said = ChangeNote::Swapped(swapped.clone()).to_string();
        assert!(
            said.starts_with("channels \"a\" and \"c\" look swapped in one of the surveys: mean MAC of 2 modes 0.06 as they are, 1.00 with"),
            "{said}"
        );
        let none = |to: &[(f64, [f64; 3])]| {
            let found = notes(&before, to);
            assert!(
                !found.iter().any(|note| matches!(note, ChangeNote::Swapped(_))),
                "{found:?}"
            );
        };
        none(&[(2.01, FIRST), (5.0, SECOND)]);
        none(&[(2.01, exchanged(FIRST)), (5.3, exchanged(SECOND))]); // one mode alone
        none(&[(2.01, [1.0, 0.2, -0.4]), (5.0, [0.9, -0.8, 0.1])]); // other shapes
    }

    #[test]
    fn holds_a_channel_turned_round_is_named() {
        const THIRD: [f64; 3] = [0.9, -0.7, 0.8];
        let turned = |[a, b, c]: [f64; 3]| [a, -b, c];
        let before = [(2.0, FIRST), (5.0, SECOND), (8.0, THIRD)];
        let found = notes(
            &before,
            &[(2.01, turned(FIRST)), (5.0, turned(SECOND)), (8.0, turned(THIRD))],
        );
        let said: Vec<String> = found.iter().map(ToString::to_string).collect();
        // (.01 - .25 + 1)²/1.26², (.36 - .64 + .25)²/1.25² and (.81 - .49 + .64)²/1.94²: mean .199
        assert!(
            said[0].starts_with("channel \"b\" looks turned round in one of the surveys: mean MAC of 3 modes 0.20 as they are, 1.00 with its sign"),
            "{said:?}"
        );
        let both =
            [&before, &before.map(|(hz, shape)| (1.005 * hz, turned(shape)))].map(|modes| survey(modes));
        let options = SurveyChangeOptions::default();
        let change = survey_change(&both[0], &both[1], &[], &options).unwrap();
        assert_eq!((change.modes.len(), change.not_compared.len()), (3, 0));
        let is_turned = |note: &ChangeNote| matches!(note, ChangeNote::Turned(_));
        assert!(!notes(&before, &before).iter().any(is_turned));
    }

    #[test]
    fn holds_damping_that_changed_beyond_chance_is_counted() {
        let damped = |zeta: f64| {
            let mut survey = survey(&[(2.0, FIRST), (5.0, SECOND)]);
            for mode in &mut survey.modes {
                (mode.damping_ratio, mode.damping_ratio_sd) = (Some(zeta), Some(0.001));
            }
            survey
        };
        let change = |zeta: f64| {
            survey_change(
                &damped(0.015),
                &damped(zeta),
                &[],
                &SurveyChangeOptions::default(),
            )
            .unwrap()
        };
        let doubled = change(0.03);
        assert_eq!(
            (doubled.damping_tested(), doubled.damping_changed().count()),
            (2, 2)
        );
        // .002 over √2 × .001: p = .157
        assert_eq!(change(0.017).damping_changed().count(), 0);
    }

    #[test]
    fn holds_a_wrong_rate_is_asked_about() {
        let before = [(2.0, FIRST), (5.0, SECOND)];
        let found = notes(&before, &[(2.5, FIRST), (6.25, SECOND)]);
        let wanted = ChangeNote::OneFactor {
            factor: 1.25,
            modes: 2,
        };
        assert_eq!(found, [wanted]);
        assert_eq!(notes(&before, &[(2.5, FIRST), (7.0, SECOND)]), []);
    }

    #[test]
    fn holds_periods_and_rad_s_for_frequencies_are_asked_about() {
        let before = [(2.0, FIRST), (5.0, SECOND)];
        let periods = notes(&before, &[(0.5, FIRST), (0.2, SECOND)]);
        assert_eq!(periods, [ChangeNote::Reciprocals { modes: 2 }]);
        let one = notes(&before[..1], &[(0.5, FIRST)]);
        assert_eq!(one, [ChangeNote::Reciprocals { modes: 1 }]);
        let angular = notes(&before[..1], &[(12.566, FIRST)]);
        assert!(
            matches!(angular[..], [ChangeNote::OneFactor { factor, modes: 1 }] if (factor - std::f64::consts::TAU).abs() < 0.001),
            "{angular:?}"
        );
        // one frequency at half may be damage
        assert_eq!(notes(&before[..1], &[(1.0, FIRST)]), []);
    }
}
