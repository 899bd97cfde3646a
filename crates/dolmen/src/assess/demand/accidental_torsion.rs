//! Accidental torsion that codes require for buildings.

use super::{DriftLimit, SiteDemand, SiteParameters};

/// Accidental eccentricity of codes, as a fraction of the side of the floor across the shaking: EN 1998-1:2004, eq. 4.3; KDS 41 17 00:2019, of
/// the accidental torsional moment (quoted from memory, not compared with the text).
pub const ACCIDENTAL_ECCENTRICITY: f64 = 0.05;

/// A code that requires accidental torsion.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum TorsionCode {
    /// KDS 41 17 00.
    Kds41,
    /// EN 1998-1.
    Eurocode8,
}

impl TorsionCode {
    /// The code by whose name a building is judged, if it requires accidental torsion: that of the site, otherwise that of the allowable drift.
    ///
    /// # Limits
    /// KDS 17 10 00, which is not for buildings alone, states no such rule; a table is no code.
    pub fn of(site: &SiteDemand, limit: Option<&DriftLimit>) -> Option<Self> {
        match site.parameters {
            SiteParameters::Eurocode { .. } => return Some(TorsionCode::Eurocode8),
            SiteParameters::Korea { .. } if site.code().starts_with("KDS 41") => {
                return Some(TorsionCode::Kds41);
            }
            SiteParameters::Korea { .. } | SiteParameters::Table { .. } => {}
        }
        limit.and_then(Self::of_limit)
    }

    /// The code of an allowable drift, if it requires accidental torsion.
    pub fn of_limit(limit: &DriftLimit) -> Option<Self> {
        match limit {
            DriftLimit::Kds41(_) => Some(TorsionCode::Kds41),
            DriftLimit::Eurocode8 { .. } => Some(TorsionCode::Eurocode8),
            DriftLimit::Given { .. } => None,
        }
    }

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            TorsionCode::Kds41 => "KDS 41 17 00",
            TorsionCode::Eurocode8 => "EN 1998-1",
        }
    }
}

#[cfg(test)]
mod tests {
    use super::super::{KoreanSite, SeismicGrade, Site, site_demand};
    use super::*;

    #[test]
    fn holds_the_code_of_the_site_or_of_the_limit_requires_it() {
        let kds_17 = Site::Kds17 {
            zone_factor_g: 0.11,
            return_period_years: 2400,
            soil: KoreanSite::S3,
        };
        let kds_41 = Site::Kds41 {
            zone_factor_g: 0.11,
            soil: KoreanSite::S3,
        };
        let own = DriftLimit::Given {
            ratio: 0.01,
            source: None,
        };
        let of_grade = DriftLimit::Kds41(SeismicGrade::First);
        for (site, limit, code) in [
            (&kds_41, None, Some(TorsionCode::Kds41)),
            (&kds_41, Some(&own), Some(TorsionCode::Kds41)),
            (&kds_17, Some(&of_grade), Some(TorsionCode::Kds41)),
            (&kds_17, Some(&own), None),
            (&kds_17, None, None),
        ] {
            let demand = site_demand(site, 0.05, None).unwrap();
            assert_eq!(TorsionCode::of(&demand, limit), code, "{site:?} {limit:?}");
        }
    }
}
