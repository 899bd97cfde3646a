//! What a change of one input does to the answer.

/// What lowering one link's centroid does: the published criterion beside the truth (Choi 2021, Table 3).
#[derive(Clone, Debug, PartialEq)]
pub struct CentroidEffect {
    /// Link, from 1 at the bottom.
    pub link: usize,
    /// Relative change of its centroid height: −0.2 is 20 % lower.
    pub change: f64,
    /// Published k_cr with the change, N m/rad, lowest joint first: some rise, an artefact of that criterion.
    pub published_critical_n_m_rad: Vec<f64>,
    /// Exact limits M_i with the change, N m/rad: none rises.
    pub necessary_n_m_rad: Vec<f64>,
    /// Exact stiffness that equal joints need with the change, N m/rad: it never rises.
    pub equal_joints_n_m_rad: f64,
    /// Load factor with the change; `None` if the joints' stiffness is not known.
    pub load_factor: Option<f64>,
}

/// Sensitivity of a result to one input: d ln(result) / d ln(input), by central difference.
#[derive(Clone, Debug, PartialEq)]
pub struct Sensitivity {
    /// Path of the input in the project file, "links[1].weight".
    pub input: String,
    /// Value of the input, SI.
    pub value: f64,
    /// Elasticity: per cent of change of the result for one per cent of the input.
    pub elasticity: f64,
    /// Coefficient of variation of the input, if given.
    pub cov: Option<f64>,
}
