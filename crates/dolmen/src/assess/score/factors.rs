//! The six factors of a pagoda.

use crate::assess::AssessError;
use crate::structure::stack::{PagodaFactors, pagoda};

/// One of the six factors.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Factor {
    /// Number of storeys N_f.
    Storeys,
    /// Total height H_t of the storeys, without the base.
    BodyHeight,
    /// tan α: half width over height of the centroid above, the smallest of all joints.
    SlendernessAngle,
    /// λ: H_t over the width of the first body.
    BodySlenderness,
    /// Taper φ of the width of the body.
    Taper,
    /// γ_H: H_t over the height of the base.
    BodyBaseHeightRatio,
}

impl Factor {
    /// All factors, in the order of the source.
    pub const ALL: [Factor; 6] = [
        Factor::Storeys,
        Factor::BodyHeight,
        Factor::SlendernessAngle,
        Factor::BodySlenderness,
        Factor::Taper,
        Factor::BodyBaseHeightRatio,
    ];

    /// Its name in files and results.
    pub fn name(self) -> &'static str {
        match self {
            Factor::Storeys => "storeys",
            Factor::BodyHeight => "body_height_m",
            Factor::SlendernessAngle => "slenderness_angle",
            Factor::BodySlenderness => "body_slenderness",
            Factor::Taper => "taper_rad",
            Factor::BodyBaseHeightRatio => "body_base_height_ratio",
        }
    }

    /// Published direction in which the capacity changes as the factor increases: 1 better, −1 worse.
    ///
    /// # Source
    /// N. Kim, I. Y. Koo, S.-G. Hong (2018), sec. 4.3.3: fewer storeys, a larger body, a larger slenderness angle, hence a smaller body
    /// slenderness, less taper, and a lower base are better.
    pub fn published_direction(self) -> f64 {
        match self {
            Factor::Storeys | Factor::BodySlenderness | Factor::Taper => -1.0,
            Factor::BodyHeight | Factor::SlendernessAngle | Factor::BodyBaseHeightRatio => 1.0,
        }
    }
}

/// The six factors of one pagoda, all consistent with each other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct SixFactors {
    /// N_f.
    pub storeys: u32,
    /// H_t, m.
    pub body_height_m: f64,
    /// tan α.
    pub slenderness_angle: f64,
    /// λ.
    pub body_slenderness: f64,
    /// φ, rad.
    pub taper_rad: f64,
    /// γ_H.
    pub body_base_height_ratio: f64,
}

impl SixFactors {
    /// Consistent factors of a pagoda. Of tan α and λ, the one that was not given follows from its blocks.
    ///
    /// # Errors
    /// [`AssessError::Stack`] for factors of an impossible pagoda.
    pub fn of_pagoda(factors: &PagodaFactors) -> Result<Self, AssessError> {
        let made = pagoda(factors)?;
        Ok(SixFactors {
            storeys: factors.storeys,
            body_height_m: factors.body_height_m,
            slenderness_angle: made.slenderness_angle,
            body_slenderness: made.body_slenderness,
            taper_rad: factors.taper_rad,
            body_base_height_ratio: factors.body_base_height_ratio,
        })
    }

    /// The numbers, in the order of [`Factor::ALL`].
    pub fn values(&self) -> [f64; 6] {
        [
            f64::from(self.storeys),
            self.body_height_m,
            self.slenderness_angle,
            self.body_slenderness,
            self.taper_rad,
            self.body_base_height_ratio,
        ]
    }

    /// Coordinates in which capacity is a smooth surface: ln of each factor, except φ.
    ///
    /// # Errors
    /// [`AssessError::Factor`] for a factor that is not positive (for φ: negative).
    pub(super) fn coordinates(&self) -> Result<[f64; 6], AssessError> {
        let mut values = self.values();
        for (factor, value) in Factor::ALL.iter().zip(&mut values) {
            let is_taper = *factor == Factor::Taper;
            let holds = if is_taper { *value >= 0.0 } else { *value > 0.0 };
            if !(holds && value.is_finite()) {
                return Err(AssessError::Factor {
                    factor: factor.name(),
                    given: *value,
                    allowed: if is_taper {
                        "0 or more"
                    } else {
                        "a positive number"
                    },
                });
            }
            if !is_taper {
                *value = value.ln();
            }
        }
        Ok(values)
    }
}
