//! Options and results of columns on compliant beds, over time.

/// Where the viscous dashpots of the columns act.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum ColumnDashpots {
    /// In the beds and joints: the coefficient is c (k_j + k_b e′(θ)/e′(0))/(k_j + k_b), in proportion to the tangent stiffness, and without joints
    /// nearly 0 where feet have lifted off.
    #[default]
    InBeds,
    /// Between the mass and the ground, with the same coefficient at any drift. It brakes columns that rock, the more the stiffer the
    /// beds: c grows as the root of their stiffness, without bound.
    Constant,
}

/// Options of [`rock_on_beds`](super::rock_on_beds).
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct ColumnRun {
    /// m, kg.
    pub mass_kg: f64,
    /// k_j, stiffness of joints and walls beside the columns, linear in the drift, N/m: 0 or more. Default 0.
    pub joints_n_m: f64,
    /// Drift at which the mass counts as fallen, with its lean, where the columns have not fallen before, m. Default infinite.
    pub drift_most_m: f64,
    /// ζ at small drift, –: 0 or more. Default 0.
    pub damping_ratio: f64,
    /// Default: in the beds.
    pub dashpots: ColumnDashpots,
    /// τ, horizontal over vertical: a lean as built or settled. The run starts at rest in balance with it. Default 0.
    pub tilt: f64,
    /// Rotation from which the columns are released at rest, rad; `None`: the state of balance. Default `None`.
    pub start_rad: Option<f64>,
    /// Length of the run, s.
    pub duration_s: f64,
    /// Time between samples of the history, s. Default 0.01.
    pub output_step_s: f64,
}

impl ColumnRun {
    /// Options for a mass, with the defaults.
    pub fn of(mass_kg: f64, duration_s: f64) -> Self {
        ColumnRun {
            mass_kg,
            joints_n_m: 0.0,
            drift_most_m: f64::INFINITY,
            damping_ratio: 0.0,
            dashpots: ColumnDashpots::default(),
            tilt: 0.0,
            start_rad: None,
            duration_s,
            output_step_s: 0.01,
        }
    }
}

/// End of a run of [`rock_on_beds`](super::rock_on_beds).
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum ColumnOutcome {
    /// No foot lifted off.
    Stood,
    /// Feet lifted off, and the columns did not fall.
    Rocked,
    /// Drift and tilt reached the drift at which the columns alone have no resistance, or joints and columns together, or the largest drift allowed.
    Fell {
        /// Time, s; 0 if the tilt alone overturns them.
        at_s: f64,
    },
    /// The peak still changes with the tolerance of the steps: the motion is too irregular to be followed, and nothing is decided.
    NotConverged,
}

/// Balance of energy of a run, J.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct ColumnEnergy {
    /// Work of the ground.
    pub input_j: f64,
    /// Kinetic energy at the end.
    pub kinetic_j: f64,
    /// Increase of the energy in beds, joints, weight and tilt.
    pub stored_j: f64,
    /// Energy dissipated by the dashpots.
    pub damping_j: f64,
}

/// Motion of a mass on columns on compliant beds. Drifts are relative to the lean without stress.
#[derive(Clone, Debug, PartialEq)]
pub struct ColumnHistory {
    /// Its end.
    pub outcome: ColumnOutcome,
    /// Times of the samples, s.
    pub time_s: Vec<f64>,
    /// u at the samples, m.
    pub drift_m: Vec<f64>,
    /// Largest |u|, including times between samples, m.
    pub peak_drift_m: f64,
    /// Time of the largest drift, s.
    pub peak_at_s: f64,
    /// Time of the first lift-off, s.
    pub uplift_s: Option<f64>,
    /// Drift at which feet lift off, m.
    pub uplift_drift_m: f64,
    /// Drift at which they count as fallen, m.
    pub falls_drift_m: f64,
    /// Drift in balance, to which the columns return, m.
    pub rest_drift_m: f64,
    /// Balance of energy.
    pub energy: ColumnEnergy,
    /// Relative change of the peak at the last reduction of the tolerance.
    pub peak_change: f64,
    /// Number of steps.
    pub steps: usize,
}
