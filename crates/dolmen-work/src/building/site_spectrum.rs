//! The spectrum of the site as the response of a building reads it.

use crate::error::{Within as _, WorkError};
use crate::wrong::Place;
use dolmen::assess::demand::SiteDemand;

/// Along x and y at the period and damping of a mode.
pub(super) fn spectrum_of(site: &SiteDemand) -> impl Fn(f64, f64) -> Result<[f64; 2], WorkError> {
    |period_s, damping_ratio| {
        let read = site.spectrum.acceleration_m_s2(period_s, damping_ratio);
        let of = || Place::EveryModeCounts {
            period_s: format!("{period_s:.4}"),
            damping_percent: format!("{:.3}", 100.0 * damping_ratio),
        };
        Ok([read.within(of)?; 2])
    }
}
