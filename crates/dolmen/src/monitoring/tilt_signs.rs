//! Steps of a tilt that only change its sign or its unit: more likely written wrongly than a structure that moved so.

use super::scan::ChangeForm;
use super::tilt::{TiltChange, TiltTrend};
use super::weather::YEAR_DAYS;

/// Number of readings on either side of a step whose means are compared at least, if there are so many.
const BESIDE: usize = 3;
/// Sum over difference of the tilts before and after, below which only the sign changed. Our choice.
const OPPOSITE: f64 = 0.1;
/// Least size of a step for this test, in standard deviations. Our choice.
const SIZE_LEAST: f64 = 6.0;
/// Ratios of tilts in other units: %, ‰ or mm/m, m/m, and degrees for mm/m (17.45).
const UNITS: [f64; 4] = [10.0, 100.0, 1000.0, 1000.0 * std::f64::consts::PI / 180.0];
/// Part by which the ratio of tilts may differ from that of units. Our choice.
const ONE_UNIT: f64 = 0.05;

impl TiltTrend {
    /// Whether the tilt after a step equals the tilt before it with the opposite sign.
    pub fn turns_sign(&self, step: &TiltChange) -> bool {
        let [before, behind] = self.beside(step);
        let size = (behind - before).abs();
        step.form == ChangeForm::Step
            && size > SIZE_LEAST * step.sd
            && (behind + before).abs() <= OPPOSITE * size
    }

    /// The tilt after a step over that before it, where it is the ratio of two units.
    pub fn changes_unit(&self, step: &TiltChange) -> Option<f64> {
        let [before, behind] = self.beside(step);
        let ratio = behind / before;
        let of_units = UNITS.into_iter().flat_map(|of| [of, 1.0 / of]);
        let mut near = of_units.filter(|of| (ratio / of - 1.0).abs() <= ONE_UNIT);
        let is_step = step.form == ChangeForm::Step && (behind - before).abs() > SIZE_LEAST * step.sd;
        near.next().filter(|_| is_step)
    }

    /// Mean tilt of the readings of a year after a step, and of those of the year before it in the same season: a tilt follows the sun.
    fn beside(&self, step: &TiltChange) -> [f64; 2] {
        let (days, ratios) = (&self.series.days, &self.series.ratios);
        let is_sound = |i: &usize| self.outliers.iter().all(|of| of.at != *i);
        let near = |of: &mut dyn Iterator<Item = usize>| -> Vec<usize> {
            let sound = of.filter(is_sound).enumerate();
            let is_near = |(count, i): &(usize, usize)| {
                *count < BESIDE || (days[*i] - days[step.from]).abs() <= YEAR_DAYS
            };
            sound.take_while(is_near).map(|(_, i)| i).collect()
        };
        // between the steps before and after it
        let steps = || self.steps().map(|of| of.from);
        let first = steps().filter(|from| *from < step.from).max().unwrap_or(0);
        let last = steps().filter(|from| *from > step.from).min();
        let before = near(&mut (first..step.from).rev());
        let behind = near(&mut (step.from..last.unwrap_or(ratios.len())));
        let apart = |i: usize, j: usize| {
            let years = (days[i] - days[j]) / YEAR_DAYS;
            (years - years.round()).abs()
        };
        let of_season = |i: &usize| {
            let own = before.iter().copied();
            own.min_by(|a, b| apart(*i, *a).total_cmp(&apart(*i, *b)))
        };
        let partners: Vec<usize> = behind.iter().filter_map(of_season).collect();
        let mean =
            |which: &[usize]| -> f64 { which.iter().map(|i| ratios[*i]).sum::<f64>() / which.len() as f64 };
        [mean(&partners), mean(&behind)]
    }

    /// Whether the tilt fell in a step by the ratio of two units: if it did not fall, a forecast from its level would come too late.
    pub fn is_unit_in_question(&self) -> bool {
        let mut ratios = self.changes.iter().filter_map(|of| self.changes_unit(of));
        ratios.any(|ratio| ratio < 1.0)
    }

    /// Whether the first and the last readings have opposite signs only because of such steps. The direction of the tilt is then
    /// uncertain, and there is no forecast.
    pub fn is_sign_in_question(&self) -> bool {
        self.changes.iter().filter(|of| self.turns_sign(of)).count() % 2 == 1
    }
}

/// Removes the time of reaching a limit if the sign or the unit is in question.
pub(super) fn without_forecast(trend: &mut TiltTrend) {
    if !trend.is_sign_in_question() && !trend.is_unit_in_question() {
        return;
    }
    if let Some(reach) = trend.slope.as_mut().and_then(|slope| slope.reach.as_mut()) {
        (reach.years, reach.years_earliest, reach.years_latest) = (None, None, None);
    }
}

#[cfg(test)]
mod tests {
    use super::super::tilt::{TiltSeeking, TiltSeries, tilt_trend};
    use super::*;
    use crate::numeric::Random;
    use std::f64::consts::TAU;

    /// Six readings a year for six and a half years: 3 mm/m and 0.1 mm/m a year beside a yearly wave of 0.3 mm/m; from reading `from` on divided by `by`.
    fn trend(seed: u64, from: usize, by: f64) -> TiltTrend {
        let mut random = Random::new(4, seed);
        let days: Vec<f64> = (0..40).map(|i| 60.0 * f64::from(i)).collect();
        let read = |(i, day): (usize, &f64)| {
            let years = day / YEAR_DAYS;
            let tilt = 3.0 + 0.1 * years + 0.3 * (TAU * years).sin() + 0.05 * random.normal();
            let written = if i < from { tilt } else { tilt / by };
            1e-3 * (100.0 * written).round() / 100.0
        };
        let series = TiltSeries {
            direction: "x".to_owned(),
            datum: None,
            surveys: (0..days.len()).collect(),
            ratios: days.iter().enumerate().map(read).collect(),
            days,
        };
        let how = TiltSeeking {
            significance: 0.05,
            limit: None,
            reading_sd: 0.0,
            replicates: 0,
            seed: 1,
        };
        tilt_trend(series, &[], &how).unwrap()
    }

    #[test]
    fn holds_degrees_are_found_beside_a_yearly_wave_from_any_season_on() {
        let degree = 1000.0 * std::f64::consts::PI / 180.0;
        let mut told = 0;
        for seed in 0..20 {
            // the last three to eight readings are in degrees, as of a season and of more than a year
            for from in 32..38 {
                let found = trend(seed, from, degree);
                let units = found.changes.iter().filter_map(|of| found.changes_unit(of));
                let units: Vec<f64> = units.collect();
                let is_one = |of: &f64| (of * degree - 1.0).abs() < 1e-12;
                assert!(
                    units.len() < 2 && units.iter().all(is_one),
                    "{seed} {from}: {units:?}"
                );
                told += units.len();
            }
            // a structure that came back by four fifths
            let found = trend(seed, 33, 5.0);
            assert!(found.changes.iter().all(|of| found.changes_unit(of).is_none()));
        }
        // 102; the growth of a year takes 3 of the 5 %
        assert!(told >= 100, "{told} of 120");
    }
}
