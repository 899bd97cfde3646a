//! Capacity of a local mechanism by Circolare 7/2019 to NTC 2018, C8.7.1.2.1, compared with the demand of a site.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | a₀* | `activation_m_s2` | acceleration of the equivalent oscillator that activates the mechanism | m/s² |
//! | FC | `confidence_factor` | confidence factor | – |
//! | q | `behaviour_factor` | behaviour factor | – |
//! | d_SLV | `limit_m` | allowed displacement of the equivalent oscillator | m |
//! | T_SLV | `period_s` | period at which the displacement demand is read from the spectrum | s |

use super::SiteDemand;
use crate::stability::stack::LocalMechanism;
use std::f64::consts::{PI, TAU};

/// d_SLV over d₀*.
const LIMIT_PART: f64 = 0.4;
/// T_SLV over π √(d_SLV / a(d_SLV)).
const PERIOD_FACTOR: f64 = 1.68;
/// Damping ratio of the displacement spectrum.
const DAMPING_RATIO: f64 = 0.08;

/// Factors that the user of the code chooses.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct CircolareFactors {
    /// Confidence factor FC. Default 1.35, the value of the code if α₀ does not consider the crushing strength.
    pub confidence_factor: f64,
    /// Behaviour factor q of the force-based check. Default 2.
    pub behaviour_factor: f64,
}

impl Default for CircolareFactors {
    fn default() -> Self {
        CircolareFactors {
            confidence_factor: 1.35,
            behaviour_factor: 2.0,
        }
    }
}

/// Capacity of a local mechanism.
#[derive(Clone, Debug, PartialEq)]
pub struct LocalMechanismCapacity {
    /// The mechanism.
    pub mechanism: LocalMechanism,
    /// Activation acceleration a₀*, m/s².
    pub activation_m_s2: f64,
    /// Capacity by the force-based check: peak ground acceleration, m/s²; `None` if a joint slides.
    pub by_force_m_s2: Option<f64>,
    /// Capacity by the displacement-based check; `None` if d₀* is unknown.
    pub displacement: Option<DisplacementCapacity>,
}

/// Capacity of a local mechanism by the displacement-based check.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DisplacementCapacity {
    /// Overturning displacement d₀*, m.
    pub overturning_m: f64,
    /// Allowed displacement d_SLV, m.
    pub limit_m: f64,
    /// a(d_SLV), the acceleration of the capacity curve at d_SLV, m/s².
    pub acceleration_m_s2: f64,
    /// Period T_SLV, s.
    pub period_s: f64,
}

/// Capacity of a local mechanism over the demand of a site.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct LocalMechanismDemand {
    /// Peak ground acceleration of the site, m/s².
    pub ground_m_s2: f64,
    /// Ratio of capacity to demand by the force-based check; `None` if the capacity is unknown.
    pub by_force: Option<f64>,
    /// The displacement-based check; `None` if d₀* is unknown, or if the spectrum is a table that ends before T_SLV.
    pub by_displacement: Option<DisplacementDemand>,
}

/// Displacement-based check of a mechanism at a site.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct DisplacementDemand {
    /// Damping ratio ζ of the spectrum: 8 %, or that of the table.
    pub damping_ratio: f64,
    /// Displacement demand S_De(T_SLV), m.
    pub displacement_m: f64,
    /// Ratio of capacity to demand, d_SLV / S_De(T_SLV).
    pub ratio: f64,
}

/// Capacity of a local mechanism by Circolare 7/2019.
///
/// ```text
/// a₀* = α₀ g / (e* FC)          by force: peak of the ground ≤ q a₀*, q = 2
/// a(d) = a₀* (1 − d/d₀*)        d_SLV = 0.4 d₀*
/// T_SLV = 1.68 π √(d_SLV / a(d_SLV))
/// ```
///
/// # Limits
/// The mechanism is taken to stand on the ground: the amplification that the code requires for parts at a height is not included. d_SLV is not
/// reduced for ties that break, because ties carry no force in these mechanisms. Sliding mechanisms are not checked: the q of the code applies
/// to mechanisms that rotate. The near-collapse state (SLC) is not included. The older circular 617/2009, with periods a third shorter, is not
/// implemented.
///
/// # Source
/// Circolare 7/2019 to NTC 2018, C8.7.1.2.1. Not compared with the text of the code. The tests compare with closed forms of walls, storeys and
/// a portal.
pub fn circolare_capacity(
    mechanism: LocalMechanism,
    gravity_m_s2: f64,
    factors: &CircolareFactors,
) -> LocalMechanismCapacity {
    let activation_m_s2 =
        mechanism.multiplier * gravity_m_s2 / (mechanism.mass_ratio * factors.confidence_factor);
    let displacement = mechanism.overturning_m.map(|overturning_m| {
        let limit_m = LIMIT_PART * overturning_m;
        let acceleration_m_s2 = activation_m_s2 * (1.0 - LIMIT_PART);
        DisplacementCapacity {
            overturning_m,
            limit_m,
            acceleration_m_s2,
            period_s: PERIOD_FACTOR * PI * (limit_m / acceleration_m_s2).sqrt(),
        }
    });
    LocalMechanismCapacity {
        activation_m_s2,
        by_force_m_s2: (!mechanism.slides).then_some(factors.behaviour_factor * activation_m_s2),
        displacement,
        mechanism,
    }
}

/// Checks a local mechanism at a site; `None` if the spectrum of the site does not give the peak ground acceleration.
///
/// ```text
/// by force          q a₀* / A_0
/// by displacement   d_SLV / S_De(T_SLV, 8 %)          S_De = S_a (T / 2π)²
/// ```
///
/// # Limits
/// The spectrum of the site is taken as the spectrum of the life-safety state (SLV), whatever its return period. A table is read at its own
/// damping ratio.
pub fn circolare_demand(
    capacity: &LocalMechanismCapacity,
    site: &SiteDemand,
) -> Option<LocalMechanismDemand> {
    let ground_m_s2 = site.peak_ground_acceleration_m_s2?;
    let damping_ratio = site.spectrum.table_damping_ratio().unwrap_or(DAMPING_RATIO);
    let by_displacement = capacity.displacement.and_then(|displacement| {
        let period_s = displacement.period_s;
        let acceleration_m_s2 = site.spectrum.acceleration_m_s2(period_s, damping_ratio).ok()?;
        let displacement_m = acceleration_m_s2 * (period_s / TAU).powi(2);
        Some(DisplacementDemand {
            damping_ratio,
            displacement_m,
            ratio: displacement.limit_m / displacement_m,
        })
    });
    Some(LocalMechanismDemand {
        ground_m_s2,
        by_force: capacity.by_force_m_s2.map(|borne| borne / ground_m_s2),
        by_displacement,
    })
}

#[cfg(test)]
mod tests {
    use super::super::{KoreanSite, Site, site_demand};
    use super::*;
    use crate::stability::stack::local_mechanism;
    use crate::structure::stack::{Block, JointMaterial, Placement, Solid, Stack};

    /// Boxes: [width, depth, height] and the centre of the base of each.
    fn boxes(sizes: &[([f64; 3], [f64; 3])], friction: f64) -> Stack {
        let blocks = sizes.iter().enumerate().map(|(i, (size, at))| Block {
            name: format!("stone {}", i + 1),
            solid: Solid::cuboid(size[0], size[1], size[2])
                .unwrap()
                .placed(&Placement {
                    position_m: *at,
                    ..Placement::default()
                }),
            density_kg_m3: 2600.0,
        });
        Stack::new(blocks.collect(), JointMaterial::with_friction(friction), 9.81).unwrap()
    }

    fn along_x(stack: &Stack) -> LocalMechanism {
        local_mechanism(stack, [1.0, 0.0]).unwrap().unwrap()
    }

    /// Asserts the mechanism of a wall b × h that overturns as one part: α₀ = b/h, e* = 1, M* = whole mass, d₀* = b/2.
    fn is_one_part(found: &LocalMechanism, b: f64, h: f64, mass_kg: f64) {
        assert_eq!(found.parts.len(), 1, "{found:?}");
        assert!((found.multiplier - b / h).abs() < 1e-7, "{found:?}");
        assert!((found.mass_ratio - 1.0).abs() < 1e-12);
        assert!((found.mass_kg / mass_kg - 1.0).abs() < 1e-9, "{found:?}");
        assert!((found.overturning_m.unwrap() - b / 2.0).abs() < 1e-6, "{found:?}");
        assert!(!found.slides);
    }

    #[test]
    fn exact_wall_as_one_stone_and_in_courses_that_move_together() {
        let stone = along_x(&boxes(&[([0.4, 2.0, 4.0], [0.0; 3])], 0.6));
        is_one_part(&stone, 0.4, 4.0, 0.4 * 2.0 * 4.0 * 2600.0);
        let courses: Vec<_> = (0..8)
            .map(|i| ([0.4, 2.0, 0.5], [0.0, 0.0, 0.5 * f64::from(i)]))
            .collect();
        let courses = along_x(&boxes(&courses, 0.6));
        is_one_part(&courses, 0.4, 4.0, 0.4 * 2.0 * 4.0 * 2600.0);
        // running bond, 2.5 stones per course
        let bond: Vec<_> = (0..4)
            .flat_map(|i| {
                let z = 0.5 * f64::from(i);
                match i % 2 {
                    0 => vec![
                        ([0.4, 1.0, 0.5], [0.0, -0.5, z]),
                        ([0.4, 1.0, 0.5], [0.0, 0.5, z]),
                    ],
                    _ => vec![
                        ([0.4, 0.5, 0.5], [0.0, -0.75, z]),
                        ([0.4, 1.0, 0.5], [0.0, 0.0, z]),
                        ([0.4, 0.5, 0.5], [0.0, 0.75, z]),
                    ],
                }
            })
            .collect();
        is_one_part(&along_x(&boxes(&bond, 0.6)), 0.4, 2.0, 0.4 * 2.0 * 2.0 * 2600.0);
    }

    #[test]
    fn exact_storey_above_the_joint_that_opens() {
        // a slender upper storey of two stones on a broad base: 0.3 m wide, 1.5 m high
        let stack = boxes(
            &[
                ([2.0, 2.0, 0.5], [0.0; 3]),
                ([0.3, 0.3, 1.0], [0.0, 0.0, 0.5]),
                ([0.3, 0.3, 0.5], [0.0, 0.0, 1.5]),
            ],
            0.6,
        );
        let found = along_x(&stack);
        assert_eq!(found.parts[0].blocks, [1, 2]);
        is_one_part(&found, 0.3, 1.5, 0.3 * 0.3 * 1.5 * 2600.0);
    }

    #[test]
    fn exact_sliding_has_no_check() {
        let found = along_x(&boxes(&[([1.0, 1.0, 1.0], [0.0; 3])], 0.3));
        assert!((found.multiplier - 0.3).abs() < 1e-7 && found.slides);
        let capacity = circolare_capacity(found, 9.81, &CircolareFactors::default());
        assert!((capacity.activation_m_s2 - 0.3 * 9.81 / 1.35).abs() < 1e-5);
        assert_eq!((capacity.by_force_m_s2, capacity.displacement), (None, None));
    }

    #[test]
    fn exact_parts_of_a_portal() {
        // pillars 0.4 × 0.4 × 2 m rotate about their feet, the beam 2 × 0.4 × 0.5 m moves without rotation: δ = 1/2, 1/2 and 1
        let stack = boxes(
            &[
                ([0.4, 0.4, 2.0], [-0.8, 0.0, 0.0]),
                ([0.4, 0.4, 2.0], [0.8, 0.0, 0.0]),
                ([2.0, 0.4, 0.5], [0.0, 0.0, 2.0]),
            ],
            2.0,
        );
        let found = along_x(&stack);
        let (pillar, beam): (f64, f64) = (0.32, 0.4);
        let (first, second) = (pillar + beam, 0.5 * pillar + beam);
        let all = 2.0 * pillar + beam;
        assert_eq!(found.parts.len(), 3);
        assert!(
            (found.mass_ratio - first * first / (all * second)).abs() < 1e-6,
            "{found:?}"
        );
        assert!((found.mass_kg - 2600.0 * first * first / second).abs() < 1e-3);
        // virtual work: α₀ Σ P δ = Σ P rise
        let work: f64 = found.parts.iter().map(|part| part.weight_n * part.rises).sum();
        let shaken: f64 = found.parts.iter().map(|part| part.weight_n * part.moves).sum();
        assert!((found.multiplier - work / shaken).abs() < 1e-6);
        assert!(found.overturning_m.is_none() && !found.slides);
    }

    #[test]
    fn exact_period_of_a_wall_and_its_site() {
        let wall = along_x(&boxes(&[([0.4, 2.0, 4.0], [0.0; 3])], 0.6));
        // with FC = 1: 1.68 π √(.08 / (.6 · .981))
        let sure = CircolareFactors {
            confidence_factor: 1.0,
            ..CircolareFactors::default()
        };
        let displacement = circolare_capacity(wall.clone(), 9.81, &sure)
            .displacement
            .unwrap();
        assert!((displacement.period_s - 1.9458).abs() < 2e-4, "{displacement:?}");
        assert!((displacement.limit_m - 0.08).abs() < 1e-6);
        let capacity = circolare_capacity(wall, 9.81, &CircolareFactors::default());
        assert!((capacity.by_force_m_s2.unwrap() - 2.0 * 0.981 / 1.35).abs() < 1e-5);
        let site = Site::Kds17 {
            zone_factor_g: 0.11,
            return_period_years: 2400,
            soil: KoreanSite::S4,
        };
        let site = site_demand(&site, 0.05, None).unwrap();
        let demand = circolare_demand(&capacity, &site).unwrap();
        // A_0 = .2992 g; T = 2.2608 s on the 1/T branch: S_a = η .748 g · .576471/T, η = (6.42/9.42)^.48
        let period_s = 1.68 * PI * (0.08 / (0.6 * 0.981 / 1.35_f64)).sqrt();
        let damped = (6.42_f64 / 9.42).powf(0.48);
        let acceleration = damped * 0.748 * 9.806_65 * (0.576_470_588 / period_s);
        let displacement_m = acceleration * (period_s / TAU).powi(2);
        let found = demand.by_displacement.unwrap();
        assert!(
            (found.displacement_m / displacement_m - 1.0).abs() < 1e-5,
            "{found:?} {displacement_m}"
        );
        assert!((found.ratio * displacement_m - 0.08).abs() < 1e-6);
        assert!((demand.by_force.unwrap() - 2.0 * 0.981 / 1.35 / (0.2992 * 9.806_65)).abs() < 1e-5);
    }
}
