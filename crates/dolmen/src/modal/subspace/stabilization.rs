//! Criteria for poles: for each pole alone, and stability from one model order to the next.

use super::uncertainty::Deviations;
use crate::modal::indicators::assurance;
use crate::modal::{ModalError, Pole, Subspace};
use std::f64::consts::PI;

/// Criteria for poles.
#[derive(Clone, Debug, PartialEq)]
pub struct Criteria {
    /// Lowest frequency, Hz; default 0.
    pub frequency_low_hz: f64,
    /// Highest frequency, Hz; default none (infinite).
    pub frequency_high_hz: f64,
    /// Least damping ratio; default none: the smallest that the record can show, see [`damping_least_at`](Self::damping_least_at).
    pub damping_ratio_least: Option<f64>,
    /// Largest damping ratio; default 0.15 (our choice: above any structure without dampers in ambient motion).
    pub damping_ratio_most: f64,
    /// Least modal phase collinearity, 0 to 1; default 0.4 (our choice: two modes 2 % apart have shapes that are not quite real in a
    /// record of 10 minutes).
    pub phase_collinearity_least: f64,
    /// Largest mean phase deviation over a right angle, 0 to 1; default 0.45 (our choice).
    pub phase_deviation_most: f64,
    /// Largest standard deviation of the frequency over its lower bound √(ζ/2πN_c); default 8 (our choice: 1 to 2 for modes of simulated
    /// records, 5 to 8 for a mode close to a noise pole, 10 to 100 for poles that fit noise).
    pub deviation_over_floor_most: f64,
    /// Largest relative change of the frequency from the next lower order; default 0.01 (Peeters & De Roeck 1999).
    pub frequency_change_most: f64,
    /// Largest relative change of the damping ratio from the next lower order; default 0.3 (our choice: the scatter in 10 minutes).
    pub damping_change_most: f64,
    /// Least MAC of the shape with that of the next lower order; default 0.95 (our choice; Peeters & De Roeck use 0.98).
    pub assurance_least: f64,
}

impl Default for Criteria {
    fn default() -> Self {
        Criteria {
            frequency_low_hz: 0.0,
            frequency_high_hz: f64::INFINITY,
            damping_ratio_least: None,
            damping_ratio_most: 0.15,
            phase_collinearity_least: 0.4,
            phase_deviation_most: 0.45,
            deviation_over_floor_most: 8.0,
            frequency_change_most: 0.01,
            damping_change_most: 0.3,
            assurance_least: 0.95,
        }
    }
}

/// Half width of the narrowest mode that a record can resolve, in lines 1/T apart: the standard deviation of its damping ratio is at
/// least 33 %. A narrower line is a sine, or cannot be distinguished from one.
pub(crate) const HALF_WIDTH_LEAST: f64 = 1.5;
/// Range of the least damping ratio of a mode, for any record: steel and single stones go down to 0.0005; machines have tones below 0.002
/// (the four in the Palisaden record: 0.0001 to 0.0019).
const DAMPING_LEAST: [f64; 2] = [0.0005, 0.002];

impl Criteria {
    /// Least damping ratio of a mode at this frequency in a record of this duration: the given one, or
    ///
    /// ```text
    /// ζ f T ≥ 1.5,   between 0.0005 and 0.002
    /// ```
    pub fn damping_least_at(&self, frequency_hz: f64, duration_s: f64) -> f64 {
        let [least, most] = DAMPING_LEAST;
        self.damping_ratio_least
            .unwrap_or_else(|| (HALF_WIDTH_LEAST / (frequency_hz * duration_s)).clamp(least, most))
    }

    /// Least estimate of a damping ratio with which a mode may have the least one: two standard deviations below it, but a line of half width.
    /// A given least damping ratio has no such margin.
    ///
    /// ```text
    /// ζ - 2 √(ζ/2πfT),   ζ f T ≥ 1
    /// ```
    pub fn damping_estimate_least_at(&self, frequency_hz: f64, duration_s: f64) -> f64 {
        const DEVIATIONS: f64 = 2.0;
        const HALF_WIDTH: f64 = 1.0; // a sine has 0.3 or less
        let least = self.damping_least_at(frequency_hz, duration_s);
        let cycles = frequency_hz * duration_s;
        match self.damping_ratio_least {
            Some(given) => given,
            None => (least - DEVIATIONS * (least / (2.0 * PI * cycles)).sqrt())
                .max(HALF_WIDTH / cycles)
                .min(least),
        }
    }

    /// The criteria with the frequency range further limited to this one, Hz.
    pub(crate) fn within(&self, [low_hz, high_hz]: [f64; 2]) -> Self {
        Criteria {
            frequency_low_hz: self.frequency_low_hz.max(low_hz),
            frequency_high_hz: self.frequency_high_hz.min(high_hz),
            ..self.clone()
        }
    }
}

/// Result of the criteria for one pole: the first criterion that it fails, in this order.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Stability {
    /// The pole passes all criteria.
    Stable,
    /// Outside the frequency range of the analysis.
    OutOfRange,
    /// Damping ratio too small or too large: a machine's tone, or noise.
    Damping,
    /// Shape too complex (collinearity or phase deviation): taken as noise.
    Complex,
    /// Standard deviation far too large for the length of the record: the pole fits noise, or is close to a pole that does.
    Scattered,
    /// The next lower order has no pole with a similar frequency.
    FrequencyMoved,
    /// The next lower order has a pole with a similar frequency, but different damping.
    DampingMoved,
    /// The next lower order has a pole with similar frequency and damping, but a different shape.
    ShapeMoved,
}

impl Stability {
    /// Whether the pole passes the criteria for a single pole, without comparison between orders.
    pub fn possible(self) -> bool {
        use Stability::{Complex, Damping, OutOfRange, Scattered};
        !matches!(self, OutOfRange | Damping | Complex | Scattered)
    }
}

/// One pole and its verdict.
#[derive(Clone, Debug, PartialEq)]
pub struct JudgedPole {
    /// The pole.
    pub pole: Pole,
    /// The verdict.
    pub stability: Stability,
    /// Standard deviation of the frequency, Hz; `None` for a pole that fails an earlier criterion.
    pub frequency_sd_hz: Option<f64>,
}

/// The stabilisation diagram: every pole of every order with its verdict.
#[derive(Clone, Debug, PartialEq)]
pub struct Stabilization {
    /// By order, then by frequency.
    pub poles: Vec<JudgedPole>,
    /// The criteria.
    pub criteria: Criteria,
}

/// Poles of all orders of an analysis, with the properties of the record.
pub(crate) struct AllOrders<'a> {
    pub(crate) poles: &'a [Pole],
    pub(crate) duration_s: f64,
    pub(crate) order_most: usize,
    /// Step between successive orders.
    pub(crate) order_step: usize,
}

impl<'a> AllOrders<'a> {
    pub(crate) fn of(subspace: &'a Subspace) -> Self {
        AllOrders {
            poles: &subspace.poles,
            duration_s: subspace.duration_s,
            order_most: subspace.order_most,
            order_step: 2,
        }
    }
}

/// Tests each pole: alone, then by comparison with the possible poles of the next lower order.
///
/// # Errors
/// [`ModalError::Linalg`].
///
/// # Source
/// Lower bound of the standard deviation: Au (2014) Mech. Syst. Signal Process. 48:15-33. Differs from the usual evaluation of the
/// diagram alone: if a mode and a pole that fits noise both recur at every order, the standard deviation distinguishes them.
pub(crate) fn judge_poles(
    all: &AllOrders<'_>,
    deviations: &mut dyn Deviations,
    criteria: &Criteria,
) -> Result<Stabilization, ModalError> {
    let mut judged: Vec<JudgedPole> = Vec::with_capacity(all.poles.len());
    let (mut below, mut start) = (0..0, 0);
    for pole in all.poles {
        if judged.last().is_some_and(|last| last.pole.order != pole.order) {
            (below, start) = (start..judged.len(), judged.len());
        }
        let mut frequency_sd_hz = None;
        let mut stability = hard(pole, criteria, all.duration_s);
        if stability.is_none() {
            let sd_hz = deviations.frequency_sd_hz(pole)?;
            frequency_sd_hz = Some(sd_hz);
            let settled = sd_hz <= criteria.deviation_over_floor_most * pole.floor_hz(all.duration_s);
            stability = if settled { None } else { Some(Stability::Scattered) };
        }
        let possible_below = judged[below.clone()].iter().filter(|j| j.stability.possible());
        judged.push(JudgedPole {
            pole: pole.clone(),
            stability: stability.unwrap_or_else(|| soft(pole, possible_below.map(|j| &j.pole), criteria)),
            frequency_sd_hz,
        });
    }
    Ok(Stabilization {
        poles: judged,
        criteria: criteria.clone(),
    })
}

fn hard(pole: &Pole, c: &Criteria, duration_s: f64) -> Option<Stability> {
    let in_range = (c.frequency_low_hz..=c.frequency_high_hz).contains(&pole.frequency_hz);
    let damped = (c.damping_estimate_least_at(pole.frequency_hz, duration_s)..=c.damping_ratio_most)
        .contains(&pole.damping_ratio);
    let real = pole.phase_collinearity >= c.phase_collinearity_least
        && pole.phase_deviation <= c.phase_deviation_most;
    match (in_range, damped, real) {
        (false, ..) => Some(Stability::OutOfRange),
        (_, false, _) => Some(Stability::Damping),
        (.., false) => Some(Stability::Complex),
        _ => None,
    }
}

fn soft<'a>(pole: &Pole, below: impl Iterator<Item = &'a Pole>, c: &Criteria) -> Stability {
    let rank = |s: &Stability| match s {
        Stability::Stable => 3,
        Stability::ShapeMoved => 2,
        Stability::DampingMoved => 1,
        _ => 0,
    };
    below
        .map(|other| {
            let frequency = (pole.frequency_hz / other.frequency_hz - 1.0).abs();
            let damping = (pole.damping_ratio / other.damping_ratio - 1.0).abs();
            if frequency > c.frequency_change_most {
                Stability::FrequencyMoved
            } else if damping > c.damping_change_most {
                Stability::DampingMoved
            } else if assurance(&pole.shape, &other.shape) < c.assurance_least {
                Stability::ShapeMoved
            } else {
                Stability::Stable
            }
        })
        .max_by_key(rank)
        .unwrap_or(Stability::FrequencyMoved)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_least_estimates_are_two_deviations_below_the_least_ratio() {
        let free = Criteria::default();
        // 0.0005 - 2 √(0.0005/2π·12000)
        let light = free.damping_estimate_least_at(20.0, 600.0);
        assert!((light - 0.000_337_132_5).abs() < 1e-9, "{light}");
        // one and a half lines, and a line
        assert!((free.damping_least_at(2.0, 600.0) - 0.001_25).abs() < 1e-15);
        assert!((free.damping_estimate_least_at(2.0, 600.0) - 1.0 / 1200.0).abs() < 1e-15);
        // a record of few cycles resolves 0.002 at best
        assert_eq!(free.damping_estimate_least_at(0.2, 600.0), 0.002);
        let given = Criteria {
            damping_ratio_least: Some(0.01),
            ..Criteria::default()
        };
        assert_eq!(given.damping_estimate_least_at(20.0, 600.0), 0.01);
    }
}
