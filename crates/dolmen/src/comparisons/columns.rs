//! Closed forms that chains, beds and beams must reproduce: buckling of Hencky (1920) and Greenhill (1881), frequencies of
//! Euler (1744), Kirchhoff (1879) and Huang (1961).

use super::{Case, ValidationError};
use crate::known::columns;
use crate::stability::{BedEdge, chain_limits, chain_stability};
use crate::structure::{BeamTheory, Chain, Inertia, Jointing, Link, Pole, Section, Shaft, Stone};

/// Mass of links that should be weightless, relative to the load: its effect is below rounding.
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
    cases.extend(beds());
    cases.extend(beams()?);
    Ok(cases)
}

/// A square bed that crushes, towards its corner.
fn beds() -> Vec<Case> {
    let case = |share: f64| {
        let bed = BedEdge {
            width_m: 1.0,
            depth_m: Some(1.0),
            strength_pa: Some(1.0 / share),
        };
        Case {
            source: "Dupin (1822)",
            what: format!("M/(N b) that a square bed passes towards its corner, {share} of it crushed"),
            unit: "",
            published: columns::square_cut_across_its_diagonal(share),
            computed: bed.moment_towards_n_m(1.0, [1.0, 1.0]),
            tolerance: 1e-12,
            corrected: None,
            note: "The block of stress is what a straight line cuts off, as the immersed part of a body that floats.",
        }
    };
    [0.125, 0.5, 0.875].map(case).into()
}

/// Frequencies of beams, by both theories.
fn beams() -> Result<Vec<Case>, ValidationError> {
    let [wedge, pyramid] = [columns::pointed_cantilever(1), columns::pointed_cantilever(2)];
    let mut cases = Vec::new();
    for (source, name, published, [depth_m, breadth_m]) in [
        ("Euler (1744)", "uniform", columns::UNIFORM_CANTILEVER, [1.0, 1.0]),
        ("Kirchhoff (1879)", "wedge", wedge, [0.0, 1.0]),
        ("Kirchhoff (1879)", "pyramid", pyramid, [0.0, 0.0]),
        (
            "Kirchhoff (1879)",
            "half pyramid",
            columns::HALVED_CANTILEVER,
            [0.5, 0.5],
        ),
    ] {
        let top = Section { depth_m, breadth_m };
        let computed = beam_coefficients(1.0, top, BeamTheory::BernoulliEuler)?;
        cases.extend(beam_cases(source, name, published, computed));
    }
    for height_m in [10.0, 5.0] {
        // r² = 1/12 of depth over height, s² = r² E/(κG) = r² 2(1 + ν)(12 + 11ν)/(10(1 + ν))
        let r2 = 1.0 / (12.0 * height_m * height_m);
        let s2 = r2 * 0.2 * (12.0 + 11.0 * POISSON_RATIO);
        let published = columns::timoshenko_cantilever(r2.sqrt(), s2.sqrt());
        let top = Section {
            depth_m: 1.0,
            breadth_m: 1.0,
        };
        let computed = beam_coefficients(height_m, top, BeamTheory::Timoshenko)?;
        let name = format!("uniform Timoshenko (H {height_m} h, ν {POISSON_RATIO})");
        cases.extend(beam_cases("Huang (1961)", &name, published, computed));
    }
    Ok(cases)
}

fn beam_cases(source: &'static str, name: &str, published: [f64; 3], computed: Vec<f64>) -> Vec<Case> {
    let pairs = published.into_iter().zip(computed).enumerate();
    let case = |(mode, (published, computed))| Case {
        source,
        what: format!("ω H² √(ρA/EI) of a {name} cantilever, mode {}", mode + 1),
        unit: "",
        published,
        computed,
        tolerance: published * BEAM,
        corrected: None,
        note: "",
    };
    pairs.map(case).collect()
}

/// Relative tolerance: the error of the search for the degree is below its last change, 1e-7.
const BEAM: f64 = 1e-7;
const POISSON_RATIO: f64 = 0.2;

/// ω H² √(ρA/EI) of a beam with a section of 1 × 1 m at the foot.
fn beam_coefficients(height_m: f64, top: Section, theory: BeamTheory) -> Result<Vec<f64>, ValidationError> {
    let shaft = Shaft {
        length_m: height_m,
        foot: Section {
            depth_m: 1.0,
            breadth_m: 1.0,
        },
        top,
    };
    let stone = Stone {
        elastic_modulus_pa: 12.0, // E I = 1
        poisson_ratio: POISSON_RATIO,
        density_kg_m3: 1.0,
    };
    let found = Pole::new(vec![shaft], stone, 0.0)?.frequencies(theory, Jointing::OneStone, 3)?;
    let all = found.map_or_else(Vec::new, |found| found.frequencies_hz);
    Ok(all
        .iter()
        .map(|f| std::f64::consts::TAU * f * height_m * height_m)
        .collect())
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

/// Stiffness of n equal joints of unit links at which the chain just stands with a unit weight at the top.
fn hencky_chain(links: u32) -> Result<f64, ValidationError> {
    let mut all = vec![link(WEIGHTLESS, 1.0, 0.5); links as usize];
    if let Some(top) = all.last_mut() {
        *top = link(1.0, 1.0, 1.0);
    }
    Ok(chain_limits(&Chain::new(all, 1.0)?)?.equal_joints_n_m_rad)
}

/// q H³/EI at which n equal links of a column with H = 1, q = 1 buckle: base spring 2EI/h, other springs EI/h.
fn greenhill_chain(links: u32) -> Result<f64, ValidationError> {
    let n = f64::from(links);
    let h = 1.0 / n;
    let chain = Chain::new(vec![link(h, h, 0.5 * h); links as usize], 1.0)?;
    let stiffness: Vec<f64> = (0..links).map(|i| if i == 0 { 2.0 * n } else { n }).collect(); // EI = 1
    Ok(chain_stability(&chain, &stiffness)?.load_factor)
}
