//! What the motion of a frame gives: how it ended, and everything needed to draw, to doubt and to repeat it.

use super::frame_tenon::TenonFace;

/// How a run ended.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FrameOutcome {
    /// It ran to its end.
    Finished,
    /// A storey leaned more than the model of small drifts can say anything of: the run ends there.
    DriftLimit {
        /// The storey, 0 the lowest.
        storey: usize,
        /// When, s.
        at_s: f64,
    },
    /// The caller stopped it.
    Stopped {
        /// When, s.
        at_s: f64,
    },
}

/// A largest value.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FramePeak {
    /// With its sign, m: between the samples too.
    pub value_m: f64,
    /// When, s.
    pub at_s: f64,
    /// Largest absolute value at the samples of the history, m: what programs print that look nowhere else.
    pub at_samples_m: f64,
}

/// A turn of the top level: where its velocity changed sign.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turn {
    /// When, s.
    pub at_s: f64,
    /// Displacement of the top relative to the ground, m.
    pub displacement_m: f64,
}

/// One time in which a slider slipped in one direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slip {
    /// The storey, 0 the lowest.
    pub storey: usize,
    /// It began, s.
    pub from_s: f64,
    /// It ended, s: at a stop, a turn, or the end of the run.
    pub to_s: f64,
    /// Way of the slider, with its sign, m.
    pub slip_m: f64,
}

/// The balance of energy at one time, J.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FrameEnergy {
    /// Of motion relative to the ground.
    pub kinetic_j: f64,
    /// In springs, less what gravity gave by P-delta.
    pub stored_j: f64,
    /// Work of what acts, and what was in the frame at the start: of inertia forces in the frame of the ground, and of forces.
    pub input_j: f64,
    /// Taken by friction.
    pub friction_j: f64,
    /// Taken by tenons that crush.
    pub crushing_j: f64,
    /// Taken by dashpots.
    pub damping_j: f64,
}

impl FrameEnergy {
    /// What is left over: the fault of the computation.
    pub fn left_over_j(&self) -> f64 {
        self.input_j - self.kinetic_j - self.stored_j - self.friction_j - self.crushing_j - self.damping_j
    }
}

/// A motion of a frame. Rows of the histories: one a level or storey, lowest first.
#[derive(Clone, Debug, PartialEq)]
pub struct FrameHistory {
    /// How it ended.
    pub outcome: FrameOutcome,
    /// How long it ran, s: to its end, or to where it was ended.
    pub duration_s: f64,
    /// Times of the samples, s.
    pub time_s: Vec<f64>,
    /// Displacement of each level relative to the ground, m.
    pub displacement_m: Vec<Vec<f64>>,
    /// Velocity of each level relative to the ground, m/s.
    pub velocity_m_s: Vec<Vec<f64>>,
    /// Absolute acceleration of each level, m/s².
    pub acceleration_m_s2: Vec<Vec<f64>>,
    /// Force of the friction element of each storey, N: positive where it resists a drift to the right.
    pub friction_force_n: Vec<Vec<f64>>,
    /// Largest displacement of each level.
    pub displacement_peaks: Vec<FramePeak>,
    /// Largest drift of each storey.
    pub drift_peaks: Vec<FramePeak>,
    /// Both faces of the tenons of each storey at the end, that of positive drift first; `None` of storeys without.
    pub tenons: Vec<Option<[TenonFace; 2]>>,
    /// Times in which sliders slipped, in the order in which they ended.
    pub slips: Vec<Slip>,
    /// Turns of the top level, in order.
    pub turns: Vec<Turn>,
    /// Displacements at the end, m.
    pub residual_m: Vec<f64>,
    /// Displacements at which it comes to rest if nothing slips any more, m; those at the end if it did not run to its end, or has
    /// no place to rest.
    pub rest_m: Vec<f64>,
    /// Whether everything stood still at the end, relative to the ground.
    pub at_rest: bool,
    /// Times at which some slider began to slip, turned or stopped, or some tenon began to bear, opened, crushed or stopped; changes at
    /// one time count once.
    pub events: usize,
    /// Series that were expanded.
    pub steps: usize,
    /// Energy at the samples.
    pub energy: Vec<FrameEnergy>,
}

impl FrameHistory {
    /// Largest share of the energy put in that the balance leaves over, at any sample, –.
    pub fn energy_left_over_ratio(&self) -> f64 {
        let most = self.energy.iter().map(|e| e.input_j.abs()).fold(0.0, f64::max);
        let left = self
            .energy
            .iter()
            .map(|e| e.left_over_j().abs())
            .fold(0.0, f64::max);
        if most > 0.0 { left / most } else { 0.0 }
    }

    /// Drift of a storey at every sample, m.
    pub fn drift_m(&self, storey: usize) -> Vec<f64> {
        difference(&self.displacement_m, storey)
    }

    /// Rate of the drift of a storey at every sample, m/s.
    pub fn drift_speed_m_s(&self, storey: usize) -> Vec<f64> {
        difference(&self.velocity_m_s, storey)
    }

    /// Share of the run in which the slider of a storey slipped, –.
    pub fn slipping_share(&self, storey: usize) -> f64 {
        let whole_s = self.duration_s;
        let of_storey = self.slips.iter().filter(|s| s.storey == storey);
        let slipping_s = of_storey.fold(0.0, |time, s| time + s.to_s - s.from_s);
        if whole_s > 0.0 { slipping_s / whole_s } else { 0.0 }
    }

    /// Whole way that the slider of a storey has slipped, both directions added up, m.
    pub fn slipped_way_m(&self, storey: usize) -> f64 {
        let of_storey = self.slips.iter().filter(|s| s.storey == storey);
        of_storey.fold(0.0, |way, s| way + s.slip_m.abs())
    }
}

/// The row of a storey's upper level less that of its lower one.
fn difference(rows: &[Vec<f64>], storey: usize) -> Vec<f64> {
    let upper = &rows[storey];
    match storey.checked_sub(1) {
        None => upper.clone(),
        Some(below) => upper.iter().zip(&rows[below]).map(|(u, l)| u - l).collect(),
    }
}
