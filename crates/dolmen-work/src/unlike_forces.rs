//! Surveys whose records say that their modes may be shifted by what moves the structure.

use crate::compared_surveys::ComparedSurveys;
use crate::surveyed::SurveyAnswer;
use dolmen::assess::{ModeChange, SurveyChange};
use dolmen::modal::Note;
use dolmen_project::Project;

/// Why the modes of a record may be shifted although the structure did not change.
#[derive(Clone, Debug, PartialEq)]
pub enum UnlikeForces {
    /// Spectral lines that stand out only in some periods, Hz: steps, or a machine.
    InSpells(Vec<f64>),
    /// Blows, each with its free decay.
    FreeDecays(usize),
    /// Frequencies differ between the halves of the record.
    BetweenHalves,
}

/// What the records of both surveys say of it, survey by survey.
pub(crate) fn unlike_forces(
    project: &Project,
    compared: &ComparedSurveys,
    answers: &[SurveyAnswer],
) -> Vec<(String, UnlikeForces)> {
    let both = [compared.from, compared.to].map(|at| project.surveys[at].name.as_str());
    let own = answers
        .iter()
        .filter(|answer| both.contains(&answer.name.as_str()));
    own.flat_map(|answer| of_survey(answer).into_iter().map(|of| (answer.name.clone(), of)))
        .collect()
}

fn of_survey(answer: &SurveyAnswer) -> Vec<UnlikeForces> {
    let setups = answer.setups.iter().flat_map(|setups| &setups.records);
    let records = || answer.records.iter().chain(setups.clone());
    let in_spells = |note: &Note| match note {
        Note::InSpells { modes } => modes.iter().map(|of| of.frequency_hz).collect(),
        _ => Vec::new(),
    };
    let notes = records().flat_map(|record| &record.analysis.notes);
    let mut at_hz: Vec<f64> = notes.flat_map(in_spells).collect();
    at_hz.sort_by(f64::total_cmp);
    let decays = records().filter_map(|record| record.analysis.free_decays.as_ref());
    let decays: usize = decays.map(|of| of.spans_s.len()).sum();
    let differ = records().any(|record| !record.analysis.between_halves.is_empty());
    let mut all = Vec::new();
    if !at_hz.is_empty() {
        all.push(UnlikeForces::InSpells(at_hz));
    }
    if decays > 0 {
        all.push(UnlikeForces::FreeDecays(decays));
    }
    if differ {
        all.push(UnlikeForces::BetweenHalves);
    }
    all
}

/// The changed modes whose changes forces near the mode could cause, if they are less than half of all: each by less than half the bandwidth ζ f.
///
/// Forces with a line in the band of one mode, such as steps, move its peak within that band, each mode in its own way. A structure that softens
/// moves several.
pub fn within_bands(change: &SurveyChange) -> Vec<&ModeChange> {
    let changed: Vec<&ModeChange> = change.changed().collect();
    if 2 * changed.len() >= change.tested() {
        return Vec::new();
    }
    let is_within = |mode: &&ModeChange| {
        let widest = [&mode.from, &mode.to]
            .into_iter()
            .filter_map(|of| of.damping_ratio);
        widest
            .reduce(f64::max)
            .is_some_and(|zeta| mode.frequency.relative.abs() < zeta)
    };
    changed.into_iter().filter(is_within).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::compare::{CompareOptions, compare};
    use crate::opened::Opened;
    use crate::progress::Silent;
    use dolmen_records::NoFiles;

    /// Frequencies that could be forces' work, of five modes with 1.7 % of damping that change by these parts.
    fn within(by: [f64; 5]) -> Vec<f64> {
        let survey = |date: &str, by: [f64; 5]| {
            let modes = [5.3, 7.9, 11.7, 14.0, 19.3].into_iter().zip(by).map(|(hz, by)| {
                let value = hz * (1.0 + by);
                format!("{{ frequency = {{ value = {value}, sd = 0.005 }}, damping_ratio = 0.017 }}")
            });
            let modes: Vec<String> = modes.collect();
            format!(
                "[survey.{date}]\ntemperature_c = 15\nmodes.x = [{}]\n",
                modes.join(", ")
            )
        };
        let text = format!(
            "schema = 1\nkind = \"survey\"\nname = \"Deck\"\n{}{}",
            survey("2020-05-01", [0.0; 5]),
            survey("2026-05-02", by)
        );
        let opened = Opened::read(text, "p".to_owned(), &NoFiles).unwrap();
        let whole = CompareOptions { from: None, to: None };
        let answer = compare(&opened, &whole, &NoFiles, &Silent).unwrap();
        assert_eq!(answer.unlike_forces, []);
        let change = answer.change.unwrap();
        let all = within_bands(&change);
        all.iter().map(|mode| mode.from.frequency_hz).collect()
    }

    #[test]
    fn holds_one_mode_that_moves_within_its_band_may_be_moved_by_forces() {
        assert_eq!(within([0.0; 5]), [0.0; 0]);
        assert_eq!(within([0.0, -0.009, 0.0, 0.0, 0.0]), [7.9]);
        // beyond its band; and most modes together
        assert_eq!(within([0.0, -0.03, 0.0, 0.0, 0.0]), [0.0; 0]);
        assert_eq!(within([-0.009; 5]), [0.0; 0]);
    }
}
