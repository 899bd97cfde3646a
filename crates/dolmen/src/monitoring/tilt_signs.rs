//! Steps of a tilt that only change its sign: probably a reading with the wrong sign, not a structure that moved through the vertical.

use super::scan::ChangeForm;
use super::tilt::{TiltChange, TiltTrend};

/// Largest number of readings on either side of a step whose means are compared.
const BESIDE: usize = 3;
/// Sum over difference of the tilts before and after, below which only the sign changed. Our choice.
const OPPOSITE: f64 = 0.1;
/// Least size of a step for this test, in standard deviations. Our choice.
const SIZE_LEAST: f64 = 6.0;

impl TiltTrend {
    /// Whether the tilt after a step equals the tilt before it with the opposite sign.
    pub fn turns_sign(&self, step: &TiltChange) -> bool {
        let ratios = &self.series.ratios;
        let is_sound = |i: &usize| self.outliers.iter().all(|of| of.at != *i);
        let mean =
            |which: Vec<usize>| -> f64 { which.iter().map(|i| ratios[*i]).sum::<f64>() / which.len() as f64 };
        let before = mean((0..step.from).rev().filter(is_sound).take(BESIDE).collect());
        let behind = mean((step.from..ratios.len()).filter(is_sound).take(BESIDE).collect());
        let size = (behind - before).abs();
        step.form == ChangeForm::Step
            && size > SIZE_LEAST * step.sd
            && (behind + before).abs() <= OPPOSITE * size
    }

    /// Whether the first and the last readings have opposite signs only because of such steps. The direction of the tilt is then
    /// uncertain, and there is no forecast.
    pub fn is_sign_in_question(&self) -> bool {
        self.changes.iter().filter(|of| self.turns_sign(of)).count() % 2 == 1
    }
}

/// Removes the time of reaching a limit if the sign is in question.
pub(super) fn without_forecast(trend: &mut TiltTrend) {
    if !trend.is_sign_in_question() {
        return;
    }
    if let Some(reach) = trend.slope.as_mut().and_then(|slope| slope.reach.as_mut()) {
        (reach.years, reach.years_earliest, reach.years_latest) = (None, None, None);
    }
}
