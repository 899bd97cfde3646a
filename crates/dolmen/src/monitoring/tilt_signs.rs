//! Steps of a tilt that only change its sign or its unit: more likely written wrongly than a structure that moved so.

use super::scan::ChangeForm;
use super::tilt::{TiltChange, TiltTrend};

/// Largest number of readings on either side of a step whose means are compared.
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

    /// Mean tilt of the readings before and after a step.
    fn beside(&self, step: &TiltChange) -> [f64; 2] {
        let ratios = &self.series.ratios;
        let is_sound = |i: &usize| self.outliers.iter().all(|of| of.at != *i);
        let mean =
            |which: Vec<usize>| -> f64 { which.iter().map(|i| ratios[*i]).sum::<f64>() / which.len() as f64 };
        let before = mean((0..step.from).rev().filter(is_sound).take(BESIDE).collect());
        let behind = mean((step.from..ratios.len()).filter(is_sound).take(BESIDE).collect());
        [before, behind]
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
