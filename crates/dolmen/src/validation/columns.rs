//! Closed forms of buckling that a chain must reproduce: Hencky (1920) and Greenhill (1881).

use super::{Case, ValidationError};
use crate::known::columns;
use crate::stability::{chain_limits, chain_stability};
use crate::structure::{Chain, Inertia, Link};

/// Mass of links that should be weightless, relative to the load: what it adds is below rounding.
const WEIGHTLESS: f64 = 1e-14;

pub(super) fn cases() -> Result<Vec<Case>, ValidationError> {
    let mut cases = Vec::new();
    for links in [1, 2, 5, 12] {
        cases.push(Case {
            source: "Hencky (1920)",
            what: format!("tip load P L / k at which {links} equal links buckle"),
            unit: "",
            published: columns::hencky_tip_load(links),
            computed: 1.0 / hencky_chain(links)?,
            tolerance: 1e-12,
            corrected: None,
            note: "",
        });
    }
    for (links, tolerance) in [(20, 0.0102), (80, 0.0102 / 16.0)] {
        cases.push(Case {
            source: "Greenhill (1881)",
            what: format!("q H³/EI at which a column of {links} equal links buckles under its own weight"),
            unit: "",
            published: columns::GREENHILL_COLUMN,
            computed: greenhill_chain(links)?,
            tolerance,
            corrected: None,
            note: "A chain approaches the column from below with the square of the number of links.",
        });
    }
    Ok(cases)
}

fn link(weight_n: f64, length_m: f64, centroid_m: f64) -> Link {
    Link {
        mass_kg: weight_n,
        length_m,
        centroid_m,
        inertia: Inertia::ThinRod,
        bed_width_m: None,
    }
}

/// Equal joints that n unit links with a unit weight at the very top need.
fn hencky_chain(links: u32) -> Result<f64, ValidationError> {
    let mut all = vec![link(WEIGHTLESS, 1.0, 0.5); links as usize];
    if let Some(top) = all.last_mut() {
        *top = link(1.0, 1.0, 1.0);
    }
    Ok(chain_limits(&Chain::new(all, 1.0)?)?.equal_joints_n_m_rad)
}

/// q H³/EI of n equal links of a column with H = 1, q = 1: base spring 2EI/h, the others EI/h.
fn greenhill_chain(links: u32) -> Result<f64, ValidationError> {
    let n = f64::from(links);
    let h = 1.0 / n;
    let chain = Chain::new(vec![link(h, h, 0.5 * h); links as usize], 1.0)?;
    let stiffness: Vec<f64> = (0..links).map(|i| if i == 0 { 2.0 * n } else { n }).collect(); // EI = 1
    Ok(chain_stability(&chain, &stiffness)?.load_factor)
}
