//! Seismic demand by codes: design spectra of a site (one file per code), the demand on stacks, frames and chains, and allowable storey drifts.

mod accidental_torsion;
mod by_modes;
mod circolare;
mod drift_limit;
mod eurocode;
mod korea;
mod of_stack;
mod plane_modes;
mod shaken_direction;
mod site;
mod spectrum;

pub use accidental_torsion::{ACCIDENTAL_ECCENTRICITY, TorsionCode};
pub use by_modes::ModalRatio;
pub use circolare::{
    CircolareFactors, DisplacementCapacity, DisplacementDemand, LocalMechanismCapacity, LocalMechanismDemand,
    circolare_capacity, circolare_demand,
};
pub use drift_limit::{DRIFT_RATIO_MOST, DriftLimit, ImportanceClass, NonStructural, SeismicGrade};
pub use eurocode::{EurocodeGround, EurocodeType, eurocode_8};
pub use korea::{
    Kds41, KoreanSite, KoreanZone, RiskFactor, SoilAmplification, kds_17, kds_17_amplification,
    kds_17_effective_acceleration_g, kds_17_risk_factor, kds_41, kds_41_spectrum,
};
pub use of_stack::{StackDemandCheck, StackDemandRow, checked_stack_against_site, stack_against_site};
pub use plane_modes::{chain_moments_by_spectrum, frame_drifts_by_spectrum};
pub use shaken_direction::ShakenDirection;
pub use site::{Site, SiteDemand, SiteParameters, site_demand};
pub use spectrum::{DesignSpectrum, SpectrumBranches, Unverified, VerticalRatio};
