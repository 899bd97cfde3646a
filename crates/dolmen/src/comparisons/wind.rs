//! Wind pressures of codes, and the flagpole of Choi (2021) in a gust.

use super::{Case, ValidationError, naju_flagpole};
use crate::stability::{BedEdge, ChainLoading, JointHold, LinkLoad, chain_under_loads};
use crate::structure::wind::{
    EUROCODE_AIR_KG_M3, EurocodeTerrain, EurocodeWind, KDS_41_AIR_KG_M3, Kds41Exposure, Kds41Wind, Wind,
    WindBody,
};

/// The rigid flagpole: height, m, and mean width of 0.4 m.
const POLE: WindBody = WindBody {
    height_m: 10.8,
    breadth_m: 0.4,
    frequency_hz: Some(6.0),
    damping_ratio: None,
};

pub(super) fn cases() -> Result<Vec<Case>, ValidationError> {
    let mut cases = Vec::new();
    let terrains = [
        ("0", EurocodeTerrain::Zero, 3.028),
        ("I", EurocodeTerrain::I, 2.815),
        ("II", EurocodeTerrain::Ii, 2.401),
        ("III", EurocodeTerrain::Iii, 1.759),
        ("IV", EurocodeTerrain::Iv, 1.226),
    ];
    for (name, terrain, published) in terrains {
        let wind = Wind::Eurocode(EurocodeWind {
            basic_speed_m_s: 26.0,
            terrain,
            orography: 1.0,
            air_density_kg_m3: EUROCODE_AIR_KG_M3,
        });
        cases.push(Case {
            source: "EN 1991-1-4:2005, 4.3–4.5",
            what: format!("q_p/(½ρv_b²) at 10.8 m, terrain {name}"),
            unit: "",
            published,
            computed: wind.pressure(&POLE)?.at_pa(POLE.height_m) / (0.5 * EUROCODE_AIR_KG_M3 * 26.0 * 26.0),
            tolerance: 5e-4,
            corrected: None,
            note: "Worked out by hand from the formulas of the code.",
        });
    }
    let exposures = [
        ("A", Kds41Exposure::A, 3.22),
        ("B", Kds41Exposure::B, 2.52),
        ("C", Kds41Exposure::C, 2.18),
        ("D", Kds41Exposure::D, 1.93),
    ];
    for (name, exposure, published) in exposures {
        let wind = Wind::Kds41(Kds41Wind {
            basic_speed_m_s: 30.0,
            exposure,
            topography: 1.0,
            importance: 1.0,
            air_density_kg_m3: KDS_41_AIR_KG_M3,
        });
        cases.push(Case {
            source: "KDS 41 12 00:2022",
            what: format!("G_D of a stiff pole of 10.8 × 0.4 m, exposure {name}"),
            unit: "",
            published,
            computed: wind.pressure(&POLE)?.response_factor,
            tolerance: 5e-3,
            corrected: None,
            note: "Worked out by hand; the formulas are those of two public programs, the text of the code was not at hand.",
        });
    }
    cases.push(Case {
        source: "Choi (2021), Table 1",
        what: "moment of a gust of 30 m/s (C_f 2.0, width 0.4 m) over W b/2 of the lowest bed, 0.65 m".to_owned(),
        unit: "",
        published: 1.19,
        computed: flagpole_in_a_gust()?,
        tolerance: 5e-3,
        corrected: None,
        note: "By hand: ½ · 1.25 · 30² · 2.0 · 0.4 · 10.83²/2 = 26.4 kN m against 68.30 · 0.65/2 = 22.2 kN m, upright.",
    });
    Ok(cases)
}

fn flagpole_in_a_gust() -> Result<f64, ValidationError> {
    let chain = naju_flagpole(9.81)?;
    let gust = Wind::Gust {
        speed_m_s: 30.0,
        air_density_kg_m3: EUROCODE_AIR_KG_M3,
    };
    let pressure = gust.pressure(&POLE)?;
    let each = chain.joint_heights_m().into_iter().zip(chain.links()).enumerate();
    let loads: Vec<LinkLoad> = each
        .map(|(i, (bottom_m, link))| {
            let strip = pressure.strip(bottom_m, bottom_m + link.length_m);
            let force_n = 2.0 * 0.4 * strip.force_n_m;
            LinkLoad {
                link: i + 1,
                height_m: 0.0,
                force_n,
                moment_n_m: 2.0 * 0.4 * strip.moment_n - force_n * bottom_m,
            }
        })
        .collect();
    let mut holds = vec![JointHold::Held; chain.links().len()];
    holds[0] = JointHold::Bed(BedEdge {
        width_m: 0.65,
        depth_m: Some(0.65),
        strength_pa: None,
    });
    let loading = ChainLoading {
        loads: &loads,
        holds: &holds,
        tilt_rad: 0.0,
    };
    let under = chain_under_loads(&chain, None, &loading)?;
    let joint = under.joints[0];
    Ok(joint.rigid_moment_n_m / joint.limit_n_m.unwrap_or(f64::NAN))
}
