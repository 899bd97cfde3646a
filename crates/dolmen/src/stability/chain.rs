//! Results of the stability of a chain. The methods are in `chain_limits.rs` and `chain_stability.rs`.

use super::Verdict;

/// Limits from weights and lengths alone, without joint stiffness and side supports. All vectors: lowest joint first, N m/rad.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct ChainLimits {
    /// G_i, gravity moment per rotation of link i together with all links above it.
    pub gravity_moment_n_m_rad: Vec<f64>,
    /// k_cr of Choi (2021), eqs 38–42. **Unsafe**: a chain with these stiffnesses is unstable.
    pub published_critical_n_m_rad: Vec<f64>,
    /// k_b,cr = P_i H_i of Choi (2021) eq. 43: weight above the joint times height of the top above it.
    pub published_buckling_n_m_rad: Vec<f64>,
    /// k_b,cr / k_cr, as in Table 2 of the paper.
    pub published_ratio: Vec<f64>,
    /// M_i = Σ_{j≥i} G_j: exact limit of joint i when every other joint is rigid.
    pub necessary_n_m_rad: Vec<f64>,
    /// Eigenvalues of K with the published k_cr, ascending; the shape of a negative eigenvalue falls.
    pub published_eigenvalues_n_m_rad: Vec<f64>,
    /// Common factor on the published k_cr at which the chain just stands; `None` if no factor suffices, because one k_cr is not positive.
    pub published_critical_factor: Option<f64>,
    /// Common factor on the published P·H at which the chain just stands: above 1 they are unsafe too.
    pub published_buckling_factor: f64,
    /// Common factor on the necessary M_i at which the chain just stands.
    pub necessary_factor: f64,
    /// Stiffness of equal joints at which the chain just stands, N m/rad.
    pub equal_joints_n_m_rad: f64,
}

/// One joint of a chain with known stiffness.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct JointStability {
    /// k_i, N m/rad.
    pub stiffness_n_m_rad: f64,
    /// Smallest k_i at which the chain is stable, with the other joints as given; `None` if it is unstable for any k_i. 0 if a side support
    /// holds it even without this joint.
    pub stiffness_least_n_m_rad: Option<f64>,
    /// k_i / k_i,min, the margin of this joint; `None` if `stiffness_least_n_m_rad` is `None`, infinite if that is 0.
    pub margin: Option<f64>,
    /// Moment in the joint per rad of a common initial tilt, N m/rad; `None` if the chain is unstable.
    pub lean_moment_n_m_rad: Option<f64>,
    /// N b/2, the largest moment that a bed without tension carries by the weight, N m; `None` without a bed width. The bed begins to open
    /// earlier: at a third of this moment for linear pressure.
    pub uplift_moment_n_m: Option<f64>,
    /// Common initial tilt at which the moment in the joint reaches the uplift limit, rad; `None` without a bed width or for an unstable chain.
    pub uplift_tilt_rad: Option<f64>,
}

/// A chain with known joint stiffness.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct ChainStability {
    /// The joints, lowest first.
    pub joints: Vec<JointStability>,
    /// λ, smallest factor on gravity that makes K singular; infinite if gravity causes no moment.
    pub load_factor: f64,
    /// 1/λ, common factor on the stiffnesses at which the chain just stands.
    pub stiffness_factor: f64,
    /// Lower Dunkerley bound of 1/λ: max M_i/k_i.
    pub stiffness_factor_least: f64,
    /// Upper Dunkerley bound of 1/λ: Σ M_i/k_i.
    pub stiffness_factor_most: f64,
    /// The joint, from 1 at the bottom, at which the recursion from the top first fails; `None` if the chain stands.
    pub failing_joint: Option<usize>,
    /// Rotation of each link under gravity per unit of a common initial tilt; empty if the chain is unstable.
    pub lean_amplification: Vec<f64>,
    /// Whether the side support is included in these numbers: there is one, and it has no gap.
    pub side_support_counted: bool,
    /// Whether the chain is stable, marginal or unstable.
    pub verdict: Verdict,
}
