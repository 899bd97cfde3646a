//! Parts of a structure compared with their limits: storeys, joints, dampers.

use crate::frame::{BedsFrom, UnfollowedStorey};
use dolmen::assess::demand::{DRIFT_RATIO_MOST, DriftLimit};
use dolmen::stability::stack::DemandVerdict;

/// The limited quantity.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Limited {
    /// Drift of a storey over its height.
    Drift,
    /// Moment of a joint, N m: at N b/2 the bed stands on its edge.
    BedEdge,
    /// Stroke of a damper, m.
    Room,
}

/// A part of a structure.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Part {
    /// A storey of a frame, by name.
    Storey(String),
    /// The storey of a building below a floor.
    BelowFloor(String),
    /// The joint below a link, by the name of the link.
    JointBelow(String),
    /// A damper, or "NAME liquid".
    Damper(String),
}

impl Part {
    /// Its name, or that of the part above it.
    pub fn name(&self) -> &str {
        match self {
            Part::Storey(name) | Part::BelowFloor(name) | Part::JointBelow(name) | Part::Damper(name) => name,
        }
    }
}

/// A part compared with its limit.
#[derive(Clone, Debug, PartialEq)]
pub struct PartLimit {
    /// The part.
    pub part: Part,
    /// The direction; `None` if all directions are alike.
    pub direction: Option<String>,
    /// The limited quantity.
    pub limited: Limited,
    /// The demand.
    pub demand: f64,
    /// The capacity left by loads without shaking; `None` if no limit is known.
    pub capacity: Option<f64>,
    /// The part of the limit that surveyed tilt and static loads use without shaking; 0 without tilt and loads.
    pub taken: f64,
    /// The lean of a storey without shaking along the direction and across it; 0 without any.
    pub lean: [f64; 2],
}

/// Parts compared with their limits under the spectrum of a site, and the directions without a comparison.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Compared {
    /// Every part.
    pub parts: Vec<PartLimit>,
    /// Directions without a comparison.
    pub not_compared: Vec<NotCompared>,
    /// Frames of one storey whose beds soften within these drifts, and share its stiffness with its joints.
    pub splits: Vec<SplitDrift>,
    /// Storeys whose beds soften within these drifts, which are those of springs.
    pub unfollowed: Vec<(String, UnfollowedStorey)>,
    /// Whether joints have dry friction, so that the worse of sticking and free joints counts.
    pub rubs: bool,
}

/// The drift of a storey by the spectrum where feet lift off, and beds and joints share its stiffness.
#[derive(Clone, Debug, PartialEq)]
pub struct SplitDrift {
    /// The direction.
    pub direction: String,
    /// Origin of the stiffness of the beds: the file, or an extreme.
    pub beds: BedsFrom,
    /// Stiffness of the beds and of the joints, N/m.
    pub shares_n_m: [f64; 2],
    /// Drift ratio of the linear storey, as with all of the stiffness in joints and walls.
    pub in_joints: f64,
    /// Drift ratio at which feet lift off.
    pub uplift: f64,
    /// The storey with the force of its columns at any drift, and its joints; an infinite demand where the spectrum asks for more than they have.
    pub in_beds: PartLimit,
}

/// A direction without a comparison.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct NotCompared {
    /// The direction; `None` if it is the same in all.
    pub direction: Option<String>,
    /// Reason.
    pub why: WhyNotCompared,
}

/// Reason why a direction has no comparison.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum WhyNotCompared {
    /// Its stiffness is unknown.
    StiffnessUnknown,
    /// It falls under its own weight.
    Falls,
    /// It falls under its own weight while its joints slip.
    FallsSlipping,
    /// The spectrum has no value at its damping or periods.
    NoSpectrum,
    /// A side post with a gap may close, which increases the demand above it.
    LoosePost,
    /// Columns that alone support it lift off at a smaller drift, and are softer beyond than the springs of their beds.
    FeetLiftOff,
    /// Columns lift off at a smaller drift, and with the joints beside them have less than the spectrum asks for.
    NoBalance,
}

impl PartLimit {
    /// The drift ratio of a storey compared with the allowable one.
    pub(crate) fn of_drift(part: Part, direction: &str, ratio: f64, limit: Option<&DriftLimit>) -> Self {
        PartLimit {
            part,
            direction: (!direction.is_empty()).then(|| direction.to_owned()),
            limited: Limited::Drift,
            demand: ratio.abs(),
            capacity: limit.map(DriftLimit::ratio),
            taken: 0.0,
            lean: [0.0; 2],
        }
    }

    /// The same with another upper bound on the drift, of which no lean takes a part.
    pub(crate) fn at_most(self, most: Option<f64>) -> Self {
        let Some(most) = most.filter(|most| self.capacity.is_none_or(|capacity| *most < capacity)) else {
            return self;
        };
        PartLimit {
            capacity: Some(most),
            taken: 0.0,
            ..self
        }
    }

    /// The same for a part whose lean without shaking uses some of the limit: lean and drift together, as vectors in plan, stay within it.
    ///
    /// ```text
    /// left = √(limit² − across²) − along
    /// ```
    pub(crate) fn taking(self, lean: [f64; 2]) -> Self {
        let [along, across] = lean.map(f64::abs);
        let left = |limit: f64| ((limit * limit - across * across).max(0.0).sqrt() - along).max(0.0);
        let capacity = self.capacity.map(left);
        PartLimit {
            taken: self
                .capacity
                .zip(capacity)
                .map_or(along, |(limit, left)| limit - left),
            lean: [along, across],
            capacity,
            ..self
        }
    }

    /// The drift of a storey with its lean without shaking.
    pub fn whole_drift(&self) -> f64 {
        (self.demand + self.lean[0]).hypot(self.lean[1])
    }

    /// Capacity over demand; `None` without a limit.
    pub fn ratio(&self) -> Option<f64> {
        Some(self.capacity? / self.demand)
    }

    /// Demand over capacity; `None` without a limit.
    pub fn use_ratio(&self) -> Option<f64> {
        Some(self.demand / self.capacity?)
    }

    /// Whether the drift of a storey is beyond the validity of any model of small drifts: it falls.
    pub fn falls(&self) -> bool {
        self.limited == Limited::Drift && self.whole_drift() > DRIFT_RATIO_MOST
    }

    /// Above, near or below; unknown without a limit.
    pub fn verdict(&self) -> DemandVerdict {
        match self.ratio() {
            _ if self.falls() => DemandVerdict::Below,
            Some(ratio) => DemandVerdict::of_ratio(ratio),
            None => DemandVerdict::Unknown,
        }
    }

    /// Sorting key of parts: larger is worse; a part that falls comes first.
    fn use_of(&self) -> f64 {
        match self.use_ratio() {
            _ if self.falls() => self.whole_drift() / DRIFT_RATIO_MOST * 1e3,
            Some(of) if of.is_nan() => f64::INFINITY,
            Some(of) => of,
            None => -1.0 / (1.0 + self.demand),
        }
    }
}

/// The worst part: the one nearest its limit, or among those without a limit the one with the largest demand.
pub fn worst_part(parts: &[PartLimit], limited: Limited) -> Option<&PartLimit> {
    let of = parts.iter().filter(|part| part.limited == limited);
    of.max_by(|a, b| a.use_of().total_cmp(&b.use_of()))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn drift(name: &str, demand: f64, capacity: Option<f64>) -> PartLimit {
        PartLimit {
            part: Part::Storey(name.into()),
            direction: None,
            limited: Limited::Drift,
            demand,
            capacity,
            taken: 0.0,
            lean: [0.0; 2],
        }
    }

    #[test]
    fn holds_words_follow_capacity_over_demand_and_ten_per_cent_falls_without_a_limit() {
        for (demand, capacity, word) in [
            (0.010, Some(0.015), DemandVerdict::Above),
            (0.0125, Some(0.015), DemandVerdict::Near),
            (0.0151, Some(0.015), DemandVerdict::Below),
            (0.02, None, DemandVerdict::Unknown),
            (0.1001, None, DemandVerdict::Below),
            (f64::NAN, Some(0.015), DemandVerdict::Unknown),
        ] {
            assert_eq!(
                drift("a", demand, capacity).verdict(),
                word,
                "{demand} {capacity:?}"
            );
        }
    }

    #[test]
    fn holds_the_part_nearest_its_limit_is_the_worst() {
        let parts = [
            drift("free", 0.05, None),
            drift("used", 0.010, Some(0.015)),
            drift("most", 0.012, Some(0.015)),
        ];
        let worst = worst_part(&parts, Limited::Drift).unwrap();
        assert_eq!(worst.part.name(), "most");
        let without = [drift("less", 0.01, None), drift("more", 0.02, None)];
        assert_eq!(worst_part(&without, Limited::Drift).unwrap().part.name(), "more");
        assert_eq!(worst_part(&parts, Limited::Room), None);
    }

    #[test]
    fn exact_lean_across_a_direction_takes_less_than_along_it() {
        // 2 % allowed with a lean of 1.2 %: 0.8 % is left along the lean, 1.6 % across it
        let leaning = |lean| drift("storey", 0.01, Some(0.02)).taking(lean);
        let [along, across] = [leaning([0.012, 0.0]), leaning([0.0, -0.012])];
        assert!((along.capacity.unwrap() - 0.008).abs() < 1e-12 && (along.taken - 0.012).abs() < 1e-12);
        assert!((across.capacity.unwrap() - 0.016).abs() < 1e-12 && (across.taken - 0.004).abs() < 1e-12);
        assert!((across.whole_drift() - 0.01_f64.hypot(0.012)).abs() < 1e-12);
        assert_eq!(leaning([0.0, 0.03]).capacity, Some(0.0));
    }
}
