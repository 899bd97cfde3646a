//! Pagodas as rigid blocks: Kim, Koo & Hong (2018), and their formulas for the stacks P10 and P20.

use super::{Case, ValidationError, p10, p20};
use crate::assess::StackCheckOptions;
use crate::assess::demand::{EurocodeGround, EurocodeType, Site, site_demand, stack_against_site};
use crate::blocks::{ContactRule, first_sway, stack_modes};
use crate::known::STANDARD_GRAVITY_M_S2;
use crate::stability::stack::{
    RockingBlock, StackLimits, period_of_thumb, published_rocking_frequency_hz, rocking_blocks, stack_limits,
};
use crate::structure::stack::{Block, JointMaterial, Placement, Solid, Stack};

const SOURCE: &str = "Kim, Koo & Hong (2018)";
/// Source of rows that are not from a paper: computed by hand or by other programs.
const BY_HAND_SOURCE: &str = "By hand: P10 and P20";
const STONE_SOURCE: &str = "By hand: Housner's quantities of a stone";
const ENGINES_SOURCE: &str = "Other engines: P10 on springs";
const PLANE_SOURCE: &str = "Second method: modes in the plane, NumPy";
const ALIKE: &str = "2/9 g over a plateau of .159 g. Corrected: by the forces of all modes the finial has a third of that, and opens under the code's own motion.";
const PLANE: &str = "Two degrees of freedom a stone, joints by area and second moment; the larger of all modes by CQC and of that with the part in phase with the ground.";
const GRAVITY_M_S2: f64 = 9.81;
/// Half a unit of the last digit of Table 2.
const TABLE_2_HZ: f64 = 0.005;
/// Name, height and frequency by eq. 1 of Table 2, m and Hz.
const TABLE_2: [(&str, f64, f64); 8] = [
    ("Jeongnimsa", 8.9, 4.31),
    ("Muryangsa", 7.4, 4.95),
    ("Heungbeopsa", 3.8, 8.16),
    ("Seollimwon", 4.7, 6.96),
    ("Seojeong-ri", 5.9, 5.87),
    ("Seongjusa, five storeys", 6.3, 5.59),
    ("Seongjusa, three storeys", 4.0, 7.86),
    ("Uiseong Tap-ri", 9.6, 4.07),
];

const THUMB: &str =
    "A period from the height alone. Measured: 13 Hz where Table 2 has 4.95, 2.6 Hz where it has 5.87.";
const BY_HAND: &str = "P10 and P20 are made for comparisons; their thresholds by hand, the least half width / height of the \
                       centroid of all parts (eqs 9 and 16), to three digits; μ where that is less.";
const NO_FREQUENCY: &str = "Eq. 12 is a rocking parameter and no natural frequency: 2.6 to 13 Hz were measured. Corrected: the \
                            first frequency of P10 on K_n 1e9, K_s 4e8 Pa/m, contact spread over the joints.";
const ENGINES: &str = "K_n 1e9, K_s 4e8 Pa/m of the source; P10 and its frequency come from comparing engines, to three digits.";
const CORNERS: &str = "Springs at the corners of joints alone are three times too stiff in rocking; measured on several engines.";
const HOUSNER: &str =
    "Closed forms of a uniform rectangle of 0.4 × 2.0 m; computed from the stone as a solid.";

pub(super) fn cases() -> Result<Vec<Case>, ValidationError> {
    let of = |source, what: String, unit, numbers: [f64; 3], corrected, note| Case {
        source,
        what,
        unit,
        published: numbers[0],
        computed: numbers[1],
        tolerance: numbers[2],
        corrected,
        note,
    };
    let mut cases = Vec::new();
    for (name, height_m, published) in TABLE_2 {
        cases.push(of(
            SOURCE,
            format!("Table 2: frequency of {name}, {height_m} m, by eq. 1"),
            "Hz",
            [published, 1.0 / period_of_thumb(height_m)?.period_s, TABLE_2_HZ],
            None,
            THUMB,
        ));
    }
    let rough = JointMaterial::with_friction(0.6);
    let stack = p10(rough, GRAVITY_M_S2)?;
    let sway = |rule| -> Result<f64, ValidationError> {
        let modes = stack_modes(&stack, rule)?;
        Ok(first_sway(&modes, 0).map_or(f64::NAN, |first| modes[first].frequency_hz))
    };
    let spread = sway(ContactRule::Four)?;
    let limits = stack_limits(&stack, &StackLimits::default())?;
    let whole = rocking_blocks(&stack, &limits.cuts[0])?[0];
    cases.push(of(
        SOURCE,
        "eq. 12 on P10, \"about 0.3 Hz\"".to_owned(),
        "Hz",
        [
            0.3,
            published_rocking_frequency_hz(GRAVITY_M_S2, whole.radius_m),
            0.05,
        ],
        Some(spread),
        NO_FREQUENCY,
    ));
    let smooth = JointMaterial::with_friction(0.3);
    for (what, stack, published) in [
        ("P10 rocks", p10(rough, GRAVITY_M_S2)?, 0.324),
        ("P20 rocks", p20(rough, GRAVITY_M_S2)?, 0.251),
        ("P10 with μ = 0.3 slides", p10(smooth, GRAVITY_M_S2)?, 0.300),
    ] {
        let governing = stack_limits(&stack, &StackLimits::default())?.governing;
        let computed = governing.map_or(f64::NAN, |governing| governing.threshold.acceleration_g);
        cases.push(of(
            BY_HAND_SOURCE,
            format!("horizontal acceleration at which {what}"),
            "g",
            [published, computed, 0.0005],
            None,
            BY_HAND,
        ));
    }
    let block = stone()?;
    for (what, unit, published, computed) in [
        (
            "p of a stone of 0.4 × 2.0 m",
            "rad/s",
            2.686_005,
            block.frequency_parameter_rad_s,
        ),
        (
            "α of a stone of 0.4 × 2.0 m",
            "rad",
            0.197_396,
            block.slenderness_rad,
        ),
        (
            "quarter of its period from θ₀ = α/2, linear",
            "s",
            0.490_304,
            block.quarter_period_s(0.5)?,
        ),
        (
            "quarter of its period from θ₀ = α/2, exact",
            "s",
            0.490_864,
            block.quarter_period_exact_s(0.5)?,
        ),
    ] {
        cases.push(of(
            STONE_SOURCE,
            what.to_owned(),
            unit,
            [published, computed, 5e-7],
            None,
            HOUSNER,
        ));
    }
    cases.push(of(
        ENGINES_SOURCE,
        "first frequency of P10 on springs spread over its joints (Fig. 17)".to_owned(),
        "Hz",
        [4.70, spread, 0.005],
        None,
        ENGINES,
    ));
    cases.push(of(
        ENGINES_SOURCE,
        "first frequency of P10: how much higher with springs at the corners alone".to_owned(),
        "%",
        [59.0, 100.0 * (sway(ContactRule::Corners)? / spread - 1.0), 0.5],
        None,
        CORNERS,
    ));
    let (alike, by_modes) = finial()?;
    cases.push(of(
        BY_HAND_SOURCE,
        "five stones and a finial, EN 1998-1: borne over asked for, S_a on all stones alike (eq. 16)"
            .to_owned(),
        "–",
        [1.397_624, alike, 5e-6],
        Some(by_modes),
        ALIKE,
    ));
    cases.push(of(
        PLANE_SOURCE,
        "five stones and a finial, EN 1998-1: borne over asked for, by the forces of all modes".to_owned(),
        "–",
        [0.521_689, by_modes, 5e-5],
        None,
        PLANE,
    ));
    Ok(cases)
}

/// Capacity over demand of five stones of 1.4 m with a slender finial, for the spectrum of EN 1998-1, type 1, ground B, a_g 0.053 g: with S_a on
/// all masses, and by modes.
fn finial() -> Result<(f64, f64), ValidationError> {
    let mut z = 0.0;
    let mut blocks = Vec::new();
    for [width, height] in [[1.4, 0.8]; 5].into_iter().chain([[0.2, 0.9]]) {
        let place = Placement {
            position_m: [0.0, 0.0, z],
            ..Placement::default()
        };
        blocks.push(Block {
            name: format!("stone {}", blocks.len() + 1),
            solid: Solid::cuboid(width, width, height)?.placed(&place),
            density_kg_m3: 2600.0,
        });
        z += height;
    }
    let stack = Stack::new(blocks, JointMaterial::with_friction(0.9), STANDARD_GRAVITY_M_S2)?;
    let site = Site::Eurocode8 {
        ground_acceleration_g: 0.053,
        importance_factor: 1.0,
        spectrum: EurocodeType::One,
        ground: EurocodeGround::B,
    };
    let modes = stack_modes(&stack, ContactRule::Four)?;
    let options = StackCheckOptions::default();
    let found = stack_against_site(
        &stack,
        &options,
        &site_demand(&site, 0.05, Some(0.0))?,
        Some(&modes),
    )?;
    let row = found.and_then(|found| found.rows.into_iter().next());
    let ratios = row.and_then(|row| Some((row.comparison.elastic?.ratio?, row.by_modes?.ratio)));
    Ok(ratios.unwrap_or((f64::NAN, f64::NAN)))
}

/// A stone of 0.4 × 0.4 × 2.0 m that rocks about its edge.
fn stone() -> Result<RockingBlock, ValidationError> {
    let block = Block {
        name: "stone".to_owned(),
        solid: Solid::cuboid(0.4, 0.4, 2.0)?.placed(&Placement::default()),
        density_kg_m3: 2600.0,
    };
    let stack = Stack::new(vec![block], JointMaterial::default(), GRAVITY_M_S2)?;
    let limits = stack_limits(&stack, &StackLimits::default())?;
    Ok(rocking_blocks(&stack, &limits.cuts[0])?[0])
}
