//! The keys of a site.

use super::file::{CodeRaw, SiteRaw};
use crate::file_number::At;
use std::ops::Range;

/// A key of `site`.
#[derive(Clone, Copy)]
pub(super) enum SiteKey {
    Zone,
    ZoneFactor,
    ReturnPeriodYears,
    Soil,
    SpectrumType,
    Ground,
    GroundAcceleration,
    ImportanceFactor,
    PeriodsS,
    Accelerations,
    File,
    Unit,
    PeakGroundAcceleration,
    DampingRatio,
    VerticalRatio,
}

impl SiteKey {
    /// Keys that belong to some codes only, with those codes.
    pub(super) const OF_CODES: [(SiteKey, &[CodeRaw]); 12] = [
        (SiteKey::Zone, &[CodeRaw::Kds17, CodeRaw::Kds41]),
        (SiteKey::ZoneFactor, &[CodeRaw::Kds17, CodeRaw::Kds41]),
        (SiteKey::ReturnPeriodYears, &[CodeRaw::Kds17]),
        (SiteKey::Soil, &[CodeRaw::Kds17, CodeRaw::Kds41]),
        (SiteKey::SpectrumType, &[CodeRaw::Eurocode8]),
        (SiteKey::Ground, &[CodeRaw::Eurocode8]),
        (SiteKey::GroundAcceleration, &[CodeRaw::Eurocode8]),
        (SiteKey::ImportanceFactor, &[CodeRaw::Eurocode8]),
        (SiteKey::PeriodsS, &[CodeRaw::Table]),
        (SiteKey::Accelerations, &[CodeRaw::Table]),
        (SiteKey::File, &[CodeRaw::Table]),
        (SiteKey::PeakGroundAcceleration, &[CodeRaw::Table]),
    ];

    /// The key as written.
    pub(super) fn word(self) -> &'static str {
        match self {
            SiteKey::Zone => "zone",
            SiteKey::ZoneFactor => "zone_factor",
            SiteKey::ReturnPeriodYears => "return_period_years",
            SiteKey::Soil => "soil",
            SiteKey::SpectrumType => "spectrum_type",
            SiteKey::Ground => "ground",
            SiteKey::GroundAcceleration => "ground_acceleration",
            SiteKey::ImportanceFactor => "importance_factor",
            SiteKey::PeriodsS => "periods_s",
            SiteKey::Accelerations => "accelerations",
            SiteKey::File => "file",
            SiteKey::Unit => "unit",
            SiteKey::PeakGroundAcceleration => "peak_ground_acceleration",
            SiteKey::DampingRatio => "damping_ratio",
            SiteKey::VerticalRatio => "vertical_ratio",
        }
    }

    /// Its path in the file.
    pub(super) fn path(self) -> String {
        format!("site.{}", self.word())
    }

    /// Its place, if given.
    pub(super) fn span_in(self, raw: &SiteRaw) -> Option<Range<usize>> {
        fn span<T>(key: &Option<At<T>>) -> Option<Range<usize>> {
            key.as_ref().map(|at| at.span.clone())
        }
        match self {
            SiteKey::Zone => span(&raw.zone),
            SiteKey::ZoneFactor => span(&raw.zone_factor),
            SiteKey::ReturnPeriodYears => span(&raw.return_period_years),
            SiteKey::Soil => span(&raw.soil),
            SiteKey::SpectrumType => span(&raw.spectrum_type),
            SiteKey::Ground => span(&raw.ground),
            SiteKey::GroundAcceleration => span(&raw.ground_acceleration),
            SiteKey::ImportanceFactor => span(&raw.importance_factor),
            SiteKey::PeriodsS => span(&raw.periods_s),
            SiteKey::Accelerations => span(&raw.accelerations),
            SiteKey::File => span(&raw.file),
            SiteKey::Unit => span(&raw.unit),
            SiteKey::PeakGroundAcceleration => span(&raw.peak_ground_acceleration),
            SiteKey::DampingRatio => span(&raw.damping_ratio),
            SiteKey::VerticalRatio => span(&raw.vertical_ratio),
        }
    }

    /// The key of a quantity of the library under a code.
    pub(super) fn of_quantity(quantity: &str, code: CodeRaw) -> Option<Self> {
        match quantity {
            "damping_ratio" => Some(SiteKey::DampingRatio),
            "vertical_ratio" => Some(SiteKey::VerticalRatio),
            "importance_factor" => Some(SiteKey::ImportanceFactor),
            "ground_acceleration_g" => Some(SiteKey::GroundAcceleration),
            "effective_acceleration_g" if code == CodeRaw::Kds17 => Some(SiteKey::ZoneFactor),
            _ => None,
        }
    }
}
