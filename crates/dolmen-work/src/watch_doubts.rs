//! What keeps a history without findings from being good news.

use crate::felt::is_usable;
use crate::survey_dates::date;
use crate::watched::WatchAnswer;
use dolmen::monitoring::WatchedMode;
use dolmen::numeric::quantile;
use serde::Serialize;

/// Fewest surveys whose differences show their scatter. Our choice.
const SURVEYS_LEAST: usize = 8;
/// Ratio of stated deviation to scatter from which both contradict each other. Our choice: by chance, with eight surveys, below 1e-4.
const STATED_FROM: f64 = 3.0;
/// Least step that still counts as seen, relative frequency. Our choice: a fall by it is a loss of a third of the stiffness.
const SEEN_MOST: f64 = 0.2;

/// A mode with stated deviations that its surveys contradict.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct StatedTooLarge {
    /// Its frequency, Hz.
    pub frequency_hz: f64,
    /// Median of the stated standard deviations, relative.
    pub stated: f64,
    /// Upper bound of the scatter of the surveys, relative: root mean square of successive differences over √2, weather included.
    pub scatter: f64,
}

/// Why a structure without a finding is not known to be sound.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[serde(rename_all = "snake_case")]
pub enum NotKnown {
    /// No survey was judged against those before it.
    NotJudged,
    /// Modes are not found in the last surveys.
    ModesMissing,
    /// Surveys are left out, because their names begin with no date.
    SurveysLeftOut,
    /// Only steps larger than a fifth of a frequency are seen, or the stated deviations are too large.
    SeesLittle,
}

impl NotKnown {
    /// Its word in tables and JSON.
    pub fn key(&self) -> &'static str {
        match self {
            NotKnown::NotJudged => "not_judged",
            NotKnown::ModesMissing => "modes_missing",
            NotKnown::SurveysLeftOut => "surveys_left_out",
            NotKnown::SeesLittle => "sees_little",
        }
    }
}

impl WatchAnswer {
    /// Surveys that are left out because their names begin with no date.
    pub fn undated(&self) -> Vec<&str> {
        let surveys = self.project.surveys.iter();
        let undated = surveys.filter(|survey| is_usable(survey) && date(&survey.name).is_none());
        undated.map(|survey| survey.name.as_str()).collect()
    }

    /// The mode whose stated deviations are largest beside its scatter, where that is a contradiction.
    pub fn stated_too_large(&self) -> Option<StatedTooLarge> {
        let each = self.watched.modes.iter().filter_map(|mode| {
            let (mut ratios, mut sds) = (Vec::new(), Vec::new());
            for (survey, at) in self.surveys.iter().zip(&mode.track.modes) {
                let Some(at) = at else { continue };
                ratios.push(survey.frequencies_hz.get(*at)? / mode.track.frequency_hz);
                sds.extend(
                    survey
                        .frequency_sds_hz
                        .get(*at)?
                        .map(|sd| sd / mode.track.frequency_hz),
                );
            }
            if ratios.len() < SURVEYS_LEAST || sds.len() < ratios.len() {
                return None;
            }
            let squares: f64 = ratios.windows(2).map(|pair| (pair[1] - pair[0]).powi(2)).sum();
            let found = StatedTooLarge {
                frequency_hz: mode.track.frequency_hz,
                stated: quantile(&sds, 0.5).ok()?,
                scatter: (0.5 * squares / (ratios.len() - 1) as f64).sqrt(),
            };
            (found.scatter > 0.0 && found.stated > STATED_FROM * found.scatter).then_some(found)
        });
        each.max_by(|a, b| (a.stated / a.scatter).total_cmp(&(b.stated / b.scatter)))
    }

    /// A mode whose disturbance lasts longer than can be told, and is at least as large as its stated deviations.
    pub fn lasting(&self) -> Option<&WatchedMode> {
        self.watched.modes.iter().find(|mode| {
            let read = self.surveys.iter().zip(&mode.track.modes);
            let sds = read.filter_map(|(survey, at)| *survey.frequency_sds_hz.get((*at)?)?);
            let sds: Vec<f64> = sds.map(|sd| sd / mode.track.frequency_hz).collect();
            let stated = quantile(&sds, 0.5).unwrap_or(0.0);
            let disturbance = mode.weather.as_ref().map(|weather| weather.disturbance);
            disturbance.is_some_and(|of| of.is_at_end() && of.sd >= stated)
        })
    }

    /// Whether some mode shows only steps larger than a fifth of its frequency.
    pub fn sees_little(&self) -> bool {
        let mut least = self.watched.modes.iter().filter_map(|mode| mode.seen_from_ratio);
        least.any(|ratio| ratio > SEEN_MOST)
    }

    /// Why a history without findings does not show that the structure is sound; empty if it does.
    pub fn not_known(&self) -> Vec<NotKnown> {
        let watched = &self.watched;
        let mut judged = watched.modes.iter().flat_map(|mode| &mode.judged.judged);
        let is_judged = watched.modes.is_empty() || judged.any(|of| of.score.is_ok());
        let all = [
            (!is_judged, NotKnown::NotJudged),
            (
                !watched.lost.is_empty() || !watched.unseen.is_empty(),
                NotKnown::ModesMissing,
            ),
            (!self.undated().is_empty(), NotKnown::SurveysLeftOut),
            (
                self.sees_little() || self.stated_too_large().is_some(),
                NotKnown::SeesLittle,
            ),
        ];
        all.into_iter()
            .filter_map(|(is_so, why)| is_so.then_some(why))
            .collect()
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::opened::Opened;
    use dolmen::numeric::Random;
    use dolmen_records::NoFiles;

    /// Monthly surveys of 2 Hz with a scatter of 0.2 %, those from `undated` on with names that begin with no date.
    fn monthly(stated: f64, undated: usize) -> WatchAnswer {
        let mut random = Random::new(3, 0);
        let survey = |i: usize| {
            let (hz, name) = (
                2.0 + 0.004 * random.normal(),
                format!("{}-{:02}-05", 2020 + i / 12, i % 12 + 1),
            );
            let name = if i < undated {
                name
            } else {
                format!("\"after {name}\"")
            };
            format!(
                "[survey.{name}]\ntemperature_c = 10.0\nfrequencies.x = [{{ value = {hz}, sd = {} }}]\n",
                stated * hz
            )
        };
        let surveys: String = (0..24).map(survey).collect();
        let text = format!("schema = 1\nkind = \"survey\"\nname = \"Pole\"\n{surveys}");
        let opened = Opened::read(text, "p".to_owned(), &NoFiles).unwrap();
        crate::watch::watch(&opened, &NoFiles, &crate::progress::Silent).unwrap()
    }

    #[test]
    fn holds_what_a_quiet_history_does_not_show_is_known() {
        assert_eq!(monthly(0.002, 24).not_known(), []);
        let large = monthly(0.1, 24);
        assert_eq!(large.not_known(), [NotKnown::SeesLittle]);
        let of = large.stated_too_large().unwrap();
        assert!(
            (of.stated - 0.1).abs() < 1e-3 && (of.scatter - 0.002).abs() < 1e-3,
            "{of:?}"
        );
        let undated = monthly(0.002, 16);
        assert_eq!(
            (undated.not_known(), undated.undated().len()),
            (vec![NotKnown::SurveysLeftOut], 8)
        );
        assert_eq!(
            monthly(0.002, 8).not_known(),
            [NotKnown::NotJudged, NotKnown::SurveysLeftOut]
        );
    }
}
