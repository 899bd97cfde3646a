//! Closed forms that chains and beams must reproduce: buckling of Hencky (1920) and Greenhill (1881), frequencies of
//! Euler (1744) and Kirchhoff (1879).

use super::{Case, ValidationError};
use crate::known::columns;
use crate::stability::{chain_limits, chain_stability};
use crate::structure::{Chain, Inertia, Link, Section, TaperedCantilever};

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
    let [wedge, pyramid] = [columns::pointed_cantilever(1), columns::pointed_cantilever(2)];
    for (source, name, published, [depth, breadth]) in [
        ("Euler (1744)", "uniform", columns::UNIFORM_CANTILEVER, [1.0, 1.0]),
        ("Kirchhoff (1879)", "wedge", wedge, [0.0, 1.0]),
        ("Kirchhoff (1879)", "pyramid", pyramid, [0.0, 0.0]),
    ] {
        let computed = beam_coefficients(depth, breadth)?;
        for (mode, (published, computed)) in published.into_iter().zip(computed).enumerate() {
            cases.push(Case {
                source,
                what: format!("ω H² √(ρA/EI) of a {name} cantilever, mode {}", mode + 1),
                unit: "",
                published,
                computed,
                tolerance: published * BEAM,
                corrected: None,
                note: "",
            });
        }
    }
    Ok(cases)
}

/// Relative error of 40 cubic elements in the third mode of a pyramid, the worst of the nine.
const BEAM: f64 = 3e-6;

/// ω H² √(ρA/EI) of a beam of unit height and section at the foot.
fn beam_coefficients(top_depth_m: f64, top_breadth_m: f64) -> Result<Vec<f64>, ValidationError> {
    let beam = TaperedCantilever {
        height_m: 1.0,
        foot: Section {
            depth_m: 1.0,
            breadth_m: 1.0,
        },
        top: Section {
            depth_m: top_depth_m,
            breadth_m: top_breadth_m,
        },
        elastic_modulus_pa: 12.0, // E I = 1
        density_kg_m3: 1.0,
    };
    let frequencies = beam.frequencies_hz(3)?;
    Ok(frequencies.iter().map(|f| std::f64::consts::TAU * f).collect())
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
