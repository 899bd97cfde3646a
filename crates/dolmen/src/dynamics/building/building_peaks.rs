//! Largest motions of a building in a run.

/// A largest value and its time.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct Peak {
    /// The value with the largest magnitude, with its sign.
    pub value: f64,
    /// Time of the peak, s.
    pub at_s: f64,
}

/// Largest motions of a floor, relative to the ground.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct FloorPeak {
    /// Displacement of the centre of mass along x, m.
    pub displacement_x_m: Peak,
    /// Displacement of the centre of mass along y, m.
    pub displacement_y_m: Peak,
    /// Rotation, rad.
    pub rotation_rad: Peak,
}

/// Largest drifts of a storey: of the floor above it relative to the floor below it.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct StoreyPeak {
    /// Drift at the centre of mass of the floor above along x, m.
    pub drift_x_m: Peak,
    /// Drift at the centre of mass of the floor above along y, m.
    pub drift_y_m: Peak,
    /// Largest drift along x anywhere on the floor above: at one of its edges. `None` if its outline is unknown.
    pub edge_drift_x_m: Option<Peak>,
    /// Largest drift along y anywhere on the floor above.
    pub edge_drift_y_m: Option<Peak>,
    /// Twist of the storey, rad.
    pub twist_rad: Peak,
    /// Largest drift in any direction at a corner of the floor above, or at its centre of mass if its outline is unknown.
    pub resultant: ResultantDrift,
}

/// A largest drift as a vector: along x and y at one instant.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct ResultantDrift {
    /// Its length, m.
    pub size_m: f64,
    /// Time of the peak, s.
    pub at_s: f64,
    /// Its place on the floor above, in plan, m.
    pub place_m: [f64; 2],
    /// Its direction, degrees from x toward y, −180 to 180.
    #[cfg_attr(feature = "serde", serde(rename = "direction_deg"))]
    pub direction_degrees: f64,
}

/// Largest values of a run, including values between steps: the interpolated peak next to the step with the largest
/// value.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct BuildingPeaks {
    /// Floors, lowest first.
    pub floors: Vec<FloorPeak>,
    /// Storeys, lowest first.
    pub storeys: Vec<StoreyPeak>,
    /// Stroke of each mass, m.
    pub strokes_m: Vec<Peak>,
    /// Rate of each stroke, m/s; for a linear dashpot, the force is the coefficient times this rate.
    pub stroke_rates_m_s: Vec<Peak>,
    /// Shear in the walls of the lowest storey along x and y, N.
    pub base_shear_n: [Peak; 2],
    /// Torque of the base forces about the vertical axis through the centre of all mass, N·m.
    pub base_torque_n_m: Peak,
}
