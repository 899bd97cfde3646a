//! Makes pagodas from the six factors of Kim, Koo & Hong (2018).
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | N_f | `storeys` | number of storeys | – |
//! | H_t | `body_height_m` | total height of the storeys, without the base | m |
//! | tan α | `slenderness_angle` | half width over height of the centroid above, the smallest of all joints | – |
//! | λ | `body_slenderness` | H_t / width of the body of the first storey | – |
//! | φ | `taper_rad` | taper: the width of the body decreases by tan φ per metre of height | rad |
//! | γ_H | `body_base_height_ratio` | H_t / height of the base | – |

use super::{Block, Placement, Solid, StackError};

/// Width of an eave over that of the body below. Our choice, as in the stack P20.
const EAVE: f64 = 1.68;
/// The two bases and their cover stones: width relative to that of the first body, and fraction of the height of the base. Our
/// choice, as in the stack P20.
const BASE: [(&str, f64, f64); 4] = [
    ("lower base", 2.24, 0.45 / 1.85),
    ("lower base cover", 2.40, 0.25 / 1.85),
    ("upper base", 1.84, 0.90 / 1.85),
    ("upper base cover", 2.00, 0.25 / 1.85),
];
/// Range of λ in the search for tan α. Our choice: pagodas have 2 to 6.
const SLENDERNESS_RANGE: [f64; 2] = [0.2, 50.0];

/// Which of the two slenderness factors is given; it determines the other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum PagodaSlenderness {
    /// λ: total height of the storeys over the width of the first body.
    Body(f64),
    /// tan α: half width over height of the centroid above, the smallest of all joints.
    Angle(f64),
}

/// Factors of a pagoda.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PagodaFactors {
    /// Number of storeys N_f, 1 to 13. Default 3.
    pub storeys: u32,
    /// Total height H_t of the storeys without the base, m. Default 3.
    pub body_height_m: f64,
    /// λ or tan α. Default λ = 3.74, the middle value of the source.
    pub slenderness: PagodaSlenderness,
    /// Taper φ, rad, 0 or more. Default 8°, as in the source.
    pub taper_rad: f64,
    /// Height ratio γ_H. Default 3, as in the source.
    pub body_base_height_ratio: f64,
    /// Density, kg/m³. Default 2600, granite.
    pub density_kg_m3: f64,
}

impl Default for PagodaFactors {
    fn default() -> Self {
        PagodaFactors {
            storeys: 3,
            body_height_m: 3.0,
            slenderness: PagodaSlenderness::Body(3.74),
            taper_rad: 8.0_f64.to_radians(),
            body_base_height_ratio: 3.0,
            density_kg_m3: 2600.0,
        }
    }
}

/// A pagoda made from factors.
#[derive(Clone, Debug, PartialEq)]
pub struct Pagoda {
    /// Square blocks from bottom to top: two bases with their cover stones, then body and eave of each storey.
    pub blocks: Vec<Block>,
    /// tan α, given or derived.
    pub slenderness_angle: f64,
    /// λ, given or derived.
    pub body_slenderness: f64,
}

/// A pagoda of square blocks with these factors.
///
/// ```text
/// b₁ = H_t/λ,   b_k = b₁ q^(k−1),   h_k = (b_k − b_k+1)/tan φ,   q = (1 − λ tan φ)^(1/N_f)
/// ```
///
/// Storeys are similar: their heights decrease in proportion to their widths. Half of each is the body, half the eave, which
/// is 1.68 times as wide as the body. The base has two steps in the proportions of [`p20`](crate::comparisons::p20), scaled to
/// the width of the first body.
///
/// # Errors
/// [`StackError::Dimension`] for a factor out of its range; [`StackError::Pagoda`] if the taper leaves no width at the top, or
/// no body has the required tan α.
///
/// # Limits
/// If the other factors are given, α and λ determine each other, so exactly one of them is an input. For 5 storeys, 8° and γ_H
/// = 3 the source prints tan α 0.338, 0.385, 0.414 for λ 4.67, 3.74, 3.32. These blocks have 0.276, 0.320, 0.348, which is 16
/// to 18 % less; for the tan α of the source, give tan α.
///
/// # Example
/// ```
/// use dolmen::structure::stack::{PagodaFactors, PagodaSlenderness, pagoda};
/// let slenderness = PagodaSlenderness::Angle(0.385);
/// let made = pagoda(&PagodaFactors { storeys: 5, slenderness, ..PagodaFactors::default() })?;
/// assert_eq!(made.blocks.len(), 14);
/// assert!((made.slenderness_angle - 0.385).abs() < 1e-12);
/// # Ok::<(), dolmen::structure::stack::StackError>(())
/// ```
///
/// # Source
/// N. Kim, I. Y. Koo, S.-G. Hong (2018), six factors of Fig. 13, prototypes of Fig. 16. Differs from the source, which defines
/// λ and φ by drawings without dimensions and gives no block sizes: the definitions in the table above and all proportions are
/// our choice.
pub fn pagoda(factors: &PagodaFactors) -> Result<Pagoda, StackError> {
    let range = |quantity, given: f64, holds: bool, allowed| {
        if holds && given.is_finite() {
            return Ok(());
        }
        Err(StackError::Dimension {
            quantity,
            given,
            allowed,
        })
    };
    let positive = [
        ("body_height_m", factors.body_height_m),
        ("body_base_height_ratio", factors.body_base_height_ratio),
        ("density_kg_m3", factors.density_kg_m3),
    ];
    for (quantity, given) in positive {
        range(quantity, given, given > 0.0, "a positive number")?;
    }
    let storeys = f64::from(factors.storeys);
    range("storeys", storeys, (1.0..=13.0).contains(&storeys), "1 to 13")?;
    let taper = factors.taper_rad;
    range(
        "taper_rad",
        taper,
        (0.0..0.7).contains(&taper),
        "0 or more, below 0.7 (40°)",
    )?;
    let body_slenderness = match factors.slenderness {
        PagodaSlenderness::Body(lambda) => {
            range("body_slenderness", lambda, lambda > 0.0, "a positive number")?;
            lambda
        }
        PagodaSlenderness::Angle(tan_alpha) => {
            range(
                "slenderness_angle",
                tan_alpha,
                tan_alpha > 0.0,
                "a positive number",
            )?;
            slenderness_with(factors, tan_alpha)?
        }
    };
    let sizes = sizes(factors, body_slenderness);
    let narrowest = 1.0 - body_slenderness * taper.tan();
    if narrowest <= 0.0 {
        return Err(StackError::Pagoda {
            quantity: "taper_rad",
            given: taper,
            allowed: (1.0 / body_slenderness).atan(),
        });
    }
    let mut blocks = Vec::with_capacity(sizes.len());
    let mut z = 0.0;
    for size in &sizes {
        let place = Placement {
            position_m: [0.0, 0.0, z],
            ..Placement::default()
        };
        blocks.push(Block {
            name: size.name.clone(),
            solid: Solid::cuboid(size.width, size.width, size.height)?.placed(&place),
            density_kg_m3: factors.density_kg_m3,
        });
        z += size.height;
    }
    Ok(Pagoda {
        blocks,
        slenderness_angle: least_slenderness(&sizes),
        body_slenderness,
    })
}

struct StoneSize {
    name: String,
    width: f64,
    height: f64,
}

fn sizes(factors: &PagodaFactors, lambda: f64) -> Vec<StoneSize> {
    let (height, first) = (factors.body_height_m, factors.body_height_m / lambda);
    let storeys = factors.storeys;
    let base = height / factors.body_base_height_ratio;
    let mut sizes: Vec<StoneSize> = BASE
        .iter()
        .map(|&(name, width, part)| StoneSize {
            name: name.to_owned(),
            width: width * first,
            height: part * base,
        })
        .collect();
    // the storeys are similar: each has q times the width of the one below
    let q = (1.0 - lambda * factors.taper_rad.tan())
        .max(0.0)
        .powf(1.0 / f64::from(storeys));
    let powers: Vec<f64> = (0..storeys)
        .scan(1.0, |f, _| Some(std::mem::replace(f, *f * q)))
        .collect();
    let all: f64 = powers.iter().sum();
    for (k, f) in powers.iter().enumerate() {
        for (part, wide) in [("body", 1.0), ("eave", EAVE)] {
            sizes.push(StoneSize {
                name: format!("storey {} {part}", k + 1),
                width: wide * first * f,
                height: 0.5 * height * f / all,
            });
        }
    }
    sizes
}

/// Least value over the joints of (half width of contact) / (height of the centroid above).
fn least_slenderness(sizes: &[StoneSize]) -> f64 {
    let (mut mass, mut moment, mut least) = (0.0, 0.0, f64::INFINITY); // of the part above, about the joint
    for (i, size) in sizes.iter().enumerate().rev() {
        let own = size.width * size.width * size.height;
        moment += mass * size.height + 0.5 * own * size.height;
        mass += own;
        let below = i.checked_sub(1).map_or(size.width, |lower| sizes[lower].width);
        least = least.min(0.5 * size.width.min(below) * mass / moment);
    }
    least
}

/// λ for this tan α: a wider body has a larger tan α.
fn slenderness_with(factors: &PagodaFactors, tan_alpha: f64) -> Result<f64, StackError> {
    let of = |lambda: f64| least_slenderness(&sizes(factors, lambda));
    let widest = SLENDERNESS_RANGE[0];
    let slenderest = SLENDERNESS_RANGE[1].min((1.0 - 1e-9) / factors.taper_rad.tan());
    let refuse = |allowed| {
        Err(StackError::Pagoda {
            quantity: "slenderness_angle",
            given: tan_alpha,
            allowed,
        })
    };
    let (mut low, mut high) = (widest, slenderest);
    if of(low) < tan_alpha {
        return refuse(of(low));
    }
    if of(high) > tan_alpha {
        return refuse(of(high));
    }
    for _ in 0..200 {
        let middle = 0.5 * (low + high);
        if of(middle) > tan_alpha {
            low = middle;
        } else {
            high = middle;
        }
    }
    Ok(0.5 * (low + high))
}

#[cfg(test)]
mod tests {
    use super::super::{JointMaterial, Stack};
    use super::*;

    #[test]
    fn exact_heights_widths_and_names() {
        let factors = PagodaFactors::default();
        let made = pagoda(&factors).unwrap();
        let stack = Stack::new(made.blocks.clone(), JointMaterial::default(), 9.81).unwrap();
        assert!((stack.height_m() - 4.0).abs() < 1e-12 && stack.blocks().len() == 10);
        let width = |name: &str| {
            let block = stack.blocks().iter().find(|block| block.name == name).unwrap();
            2.0 * block.solid.bounds_m()[1][0]
        };
        let first = 3.0 / 3.74;
        assert!((width("storey 1 body") - first).abs() < 1e-14);
        assert!((width("storey 1 eave") - 1.68 * first).abs() < 1e-14);
        // b_k decreases by tan φ per metre: at the foot of the third storey
        let foot = made.blocks[8].solid.bounds_m()[0][2] - 1.0;
        let exact = first - 8.0_f64.to_radians().tan() * foot;
        assert!((width("storey 3 body") - exact).abs() < 1e-12);
    }

    #[test]
    fn holds_the_two_slendernesses_determine_each_other() {
        for lambda in [2.0, 3.32, 4.67] {
            let with = |slenderness| {
                let storeys = 5;
                pagoda(&PagodaFactors {
                    storeys,
                    slenderness,
                    ..PagodaFactors::default()
                })
                .unwrap()
            };
            let made = with(PagodaSlenderness::Body(lambda));
            let again = with(PagodaSlenderness::Angle(made.slenderness_angle));
            assert!((again.body_slenderness / lambda - 1.0).abs() < 1e-9);
        }
    }

    /// Compares only our own values: the difference between these blocks and the tan α of the source, 0.338, 0.385, 0.414 (5
    /// storeys, 8°, γ_H 3). The expected values are the same sum over blocks, written independently.
    #[test]
    fn regress_slenderness_angles_beside_the_printed_ones() {
        for (lambda, ours, printed) in [
            (4.67, 0.276_294_206_8, 0.338),
            (3.74, 0.319_543_911_5, 0.385),
            (3.32, 0.348_493_142_5, 0.414),
        ] {
            let made = pagoda(&PagodaFactors {
                storeys: 5,
                slenderness: PagodaSlenderness::Body(lambda),
                ..PagodaFactors::default()
            })
            .unwrap();
            assert!((made.slenderness_angle - ours).abs() < 1e-9);
            assert!((0.81..0.85).contains(&(ours / printed)));
        }
    }

    #[test]
    fn refuses_factors_that_cannot_be_together() {
        let fault = pagoda(&PagodaFactors {
            slenderness: PagodaSlenderness::Body(8.0),
            ..PagodaFactors::default()
        })
        .unwrap_err();
        assert!(fault.to_string().contains("taper_rad is 0.1396"), "{fault}");
        let fault = pagoda(&PagodaFactors {
            slenderness: PagodaSlenderness::Angle(30.0),
            ..PagodaFactors::default()
        })
        .unwrap_err();
        assert!(fault.to_string().contains("slenderness_angle is 30"), "{fault}");
        let fault = pagoda(&PagodaFactors {
            storeys: 0,
            ..PagodaFactors::default()
        });
        assert_eq!(
            fault.unwrap_err().to_string(),
            "storeys is 0, but must be 1 to 13"
        );
    }
}
