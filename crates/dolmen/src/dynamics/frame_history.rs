//! The motion of a frame, its end, and all data to draw, check and repeat it.

use super::frame_tenon::TenonFace;

/// End of a run.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum FrameOutcome {
    /// The run is complete.
    Finished,
    /// A storey leaned beyond the validity of small drifts; the run ends there.
    DriftLimit {
        /// The storey, 0 the lowest.
        storey: usize,
        /// Time at which it leaned too far, s.
        at_s: f64,
    },
    /// The caller stopped the run.
    Stopped {
        /// Time of the stop, s.
        at_s: f64,
    },
}

/// A largest value.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FramePeak {
    /// The value with its sign, m, including times between samples.
    pub value_m: f64,
    /// Its time, s.
    pub at_s: f64,
    /// Largest absolute value at the samples of the history, m, for comparison with other programs.
    pub at_samples_m: f64,
}

/// A turning point of the top level.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Turn {
    /// Its time, s.
    pub at_s: f64,
    /// Displacement of the top relative to the ground, m.
    pub displacement_m: f64,
}

/// One slip of a slider in one direction.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Slip {
    /// The storey, 0 the lowest.
    pub storey: usize,
    /// Start, s.
    pub from_s: f64,
    /// End, s: at a stop, a reversal, or the end of the run.
    pub to_s: f64,
    /// Slip distance, with its sign, m.
    pub slip_m: f64,
}

/// The balance of energy at one time, J.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FrameEnergy {
    /// Kinetic energy of motion relative to the ground, J.
    pub kinetic_j: f64,
    /// Energy in the springs, minus the contribution of gravity (P-delta).
    pub stored_j: f64,
    /// Energy at the start and work of the load: of the ground's inertia forces, and of forces at the levels.
    pub input_j: f64,
    /// Energy dissipated by friction.
    pub friction_j: f64,
    /// Energy dissipated by crushing tenons.
    pub crushing_j: f64,
    /// Energy dissipated by dashpots.
    pub damping_j: f64,
}

impl FrameEnergy {
    /// The residual of the balance: the error of the computation.
    pub fn left_over_j(&self) -> f64 {
        self.input_j - self.kinetic_j - self.stored_j - self.friction_j - self.crushing_j - self.damping_j
    }
}

/// A motion of a frame. Histories have one row for each level or storey, lowest first.
#[derive(Clone, Debug, PartialEq)]
pub struct FrameHistory {
    /// Its end.
    pub outcome: FrameOutcome,
    /// Duration of the run, s, to its end or its early end.
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
    /// Both faces of the tenons of each storey at the end, the face for positive drift first; `None` for storeys without tenons.
    pub tenons: Vec<Option<[TenonFace; 2]>>,
    /// Slips of the sliders, in the order of their ends.
    pub slips: Vec<Slip>,
    /// Turning points of the top level, in order.
    pub turns: Vec<Turn>,
    /// Displacements at the end, m.
    pub residual_m: Vec<f64>,
    /// Displacements of the rest position without further slip, m; those at the end if the run ended early, or if there is no rest position.
    pub rest_m: Vec<f64>,
    /// Whether everything was at rest at the end, relative to the ground.
    pub at_rest: bool,
    /// Number of times at which a slider began to slip, reversed or stopped, or a tenon came into contact, opened, crushed or stopped
    /// crushing; simultaneous changes count once.
    pub events: usize,
    /// Number of series, that is, of steps.
    pub steps: usize,
    /// Energy at the samples.
    pub energy: Vec<FrameEnergy>,
}

impl FrameHistory {
    /// Largest residual of the energy balance at any sample, over the energy input, –.
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

    /// Fraction of the run in which the slider of a storey slipped, –.
    pub fn slipping_share(&self, storey: usize) -> f64 {
        let whole_s = self.duration_s;
        let of_storey = self.slips.iter().filter(|s| s.storey == storey);
        let slipping_s = of_storey.fold(0.0, |time, s| time + s.to_s - s.from_s);
        if whole_s > 0.0 { slipping_s / whole_s } else { 0.0 }
    }

    /// Accumulated slip of the slider of a storey, both directions, m.
    pub fn slipped_way_m(&self, storey: usize) -> f64 {
        let of_storey = self.slips.iter().filter(|s| s.storey == storey);
        of_storey.fold(0.0, |way, s| way + s.slip_m.abs())
    }
}

/// The row of a storey's upper level minus that of its lower one.
fn difference(rows: &[Vec<f64>], storey: usize) -> Vec<f64> {
    let upper = &rows[storey];
    match storey.checked_sub(1) {
        None => upper.clone(),
        Some(below) => upper.iter().zip(&rows[below]).map(|(u, l)| u - l).collect(),
    }
}
