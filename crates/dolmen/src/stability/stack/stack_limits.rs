//! Limit states of a stack: the horizontal acceleration at which each joint opens and slides.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | p, t | `pivot`, `axis` | a point of the axis of rotation of a part, unit vector along the axis | m, – |
//! | n | `normal` | normal of the joint, upwards | – |
//! | m, c | `mass`, `centroid` | mass and centroid of the part above | kg, m |
//! | F, M | `force`, `moment` | weight (1 + a_z/g) and static loads on the part; moment about the origin | N, N m |
//! | x | – | horizontal acceleration of the inertia forces m x | m/s² |
//! | μ, C | `mu`, `cohesion` | smallest friction coefficient of the joints, cohesion × area | –, N |
//! | f | `compressive_strength_pa` | compressive strength of the stone at the edge of a joint | Pa |
//! | M(θ), K | – | moment of the footing on its soil, and its initial stiffness: see `footing` | N m, N m/rad |

use super::cuts::cuts;
use super::loads::Load;
use super::on_soil::OnSoil;
use super::part::limits_of;
use super::{CutLimits, Governing, LimitKind, StackLimitStates, StackLimits, Threshold};
use crate::stability::{StabilityError, Verdict};
use crate::structure::stack::Stack;

/// Horizontal acceleration at which each part of a stack begins to rock or slide, and the first of these motions.
///
/// ```text
/// rocking about the line (p, t):   x · m (t × (c − p))_h  ≤  −t · (M − p × F)
///     horizontal joint, weight only:  a/g = tan α = distance of the centroid from the edge, in plan / its height
///     smallest along (t × (c − p))_h, so the minimum over all directions is the minimum over the edges
/// sliding, all unit v in the plane: x · m (v + μ n)_h ≤ μ N + C − v · F,  N = −F · n
///     tilted by β, weight only: a/g = tan(φ − β)
/// strength:   the line lies at the centroid of the outermost strip of area N/f, in every direction
/// soil:       the footing turns by θ and lifts off its soil, M(θ) = m h a + M_s + (W h + Σ P z) θ; every part then has a + g θ.
///             a is at most that at which the footing overturns; in full contact a = a_rigid (1 − W h/K) with M_s = P = 0
/// ```
///
/// # Errors
/// [`StabilityError`] for loads and options out of their range.
///
/// # Limits
/// Uplift and sliding are computed separately: a part that twists or opens while it slides needs a limit analysis. In a stack that is not
/// statically determinate, every threshold is an upper bound (three times too high for a beam across two pillars), and the result names no
/// governing joint. Adjacent stones neither support nor push a part; side supports are left out. The tensile strength of a joint is left out,
/// and its cohesion acts only against sliding. If joints differ in friction or strength, the smallest value is used. Each tie acts at its
/// strength, although a brittle tie may break before the next one is stretched.
///
/// # Source
/// Housner (1963) for the single block; Kim, Koo & Hong (2018), eqs 9 and 16 and section 3.4.
/// Differs from the source: includes offsets, tilt, direction, vertical motion, strength and soil.
///
/// # Example
/// ```
/// use dolmen::stability::stack::{stack_limits, StackLimits};
/// use dolmen::structure::stack::{Block, JointMaterial, Solid, Stack};
/// let block = Block { name: "stone".into(), solid: Solid::cuboid(0.4, 0.4, 2.0)?, density_kg_m3: 2600.0 };
/// let stack = Stack::new(vec![block], JointMaterial::default(), 9.81)?;
/// let limits = stack_limits(&stack, &StackLimits::default())?;
/// assert!((limits.uplift.ok_or("falls")?.threshold.acceleration_g - 0.2).abs() < 1e-12);
/// assert!((limits.sliding.ok_or("falls")?.threshold.acceleration_g - 0.6).abs() < 1e-12);
/// # Ok::<(), Box<dyn std::error::Error>>(())
/// ```
pub fn stack_limits(stack: &Stack, options: &StackLimits) -> Result<StackLimitStates, StabilityError> {
    let (loads, soil) = acting(stack, options)?;
    let found = cuts(stack);
    let cut_limits = found
        .cuts
        .into_iter()
        .map(|cut| limits_of(stack, cut, &loads, options, &soil))
        .collect();
    let mut states = StackLimitStates {
        cuts: cut_limits,
        standing: soil.standing.clone(),
        gravity_margin: None,
        verdict: Verdict::Unknown,
        uplift: None,
        sliding: None,
        governing: None,
        governing_with_ties: None,
        footing: soil.limit,
        undecided: found.undecided,
        statically_determinate: found.statically_determinate,
    };
    summarise(&mut states);
    Ok(states)
}

/// Loads on each block, and the soil under them.
pub(super) fn acting(stack: &Stack, options: &StackLimits) -> Result<(Vec<Load>, OnSoil), StabilityError> {
    let loads = options.loads.on_blocks(stack)?;
    let soil = OnSoil::under(stack, &loads, options.loads.vertical_acceleration_m_s2);
    Ok((loads, soil))
}

/// Sets the smallest margin and the first motion of all cuts.
fn summarise(states: &mut StackLimitStates) {
    for cut in &states.cuts {
        let least = states.gravity_margin.unwrap_or(f64::INFINITY);
        // the cut with the smallest margin determines the reason for falling
        if !cut.standing.stands() && (states.standing.stands() || cut.gravity_margin < least) {
            states.standing = cut.standing.clone();
        }
        states.gravity_margin = Some(least.min(cut.gravity_margin));
    }
    if !states.standing.stands() {
        states.verdict = Verdict::Unstable;
        return;
    }
    states.uplift = soonest(&states.cuts, LimitKind::Uplift, |cut| cut.uplift);
    states.sliding = soonest(&states.cuts, LimitKind::Sliding, |cut| cut.sliding);
    if !states.statically_determinate {
        return;
    }
    states.verdict = states
        .gravity_margin
        .map_or(Verdict::Unknown, Verdict::of_gravity_margin);
    states.governing = sooner(states.uplift, states.sliding);
    states.governing_with_ties = sooner(
        soonest(&states.cuts, LimitKind::Uplift, |cut| cut.uplift_with_ties),
        soonest(&states.cuts, LimitKind::Sliding, |cut| cut.sliding_with_ties),
    );
}

fn soonest(
    cuts: &[CutLimits],
    kind: LimitKind,
    of: impl Fn(&CutLimits) -> Option<Threshold>,
) -> Option<Governing> {
    let all = cuts
        .iter()
        .enumerate()
        .filter_map(|(cut, limits)| of(limits).map(|threshold| Governing { kind, cut, threshold }));
    all.reduce(|best, other| {
        if other.threshold.acceleration_m_s2 < best.threshold.acceleration_m_s2 {
            other
        } else {
            best
        }
    })
}

/// The earlier motion; uplift if both occur at the same acceleration.
fn sooner(uplift: Option<Governing>, sliding: Option<Governing>) -> Option<Governing> {
    match (uplift, sliding) {
        (Some(uplift), Some(sliding)) => Some(
            if sliding.threshold.acceleration_m_s2 < uplift.threshold.acceleration_m_s2 {
                sliding
            } else {
                uplift
            },
        ),
        (uplift, sliding) => uplift.or(sliding),
    }
}

#[cfg(test)]
mod tests {
    use super::super::toe::toe;
    use super::super::towers::{P10, leaning, p20, shifted, tower};
    use super::super::{PointForce, StackLoads, Standing, Wind};
    use super::*;
    use crate::structure::stack::{Block, Body, JointMaterial, Placement, SoilBelow, Solid, StaticLoad, Tie};

    fn limits(stack: &Stack) -> StackLimitStates {
        stack_limits(stack, &StackLimits::default()).unwrap()
    }

    /// First uplift, over g.
    fn uplift(stack: &Stack, options: &StackLimits) -> f64 {
        let states = stack_limits(stack, options).unwrap();
        states.uplift.unwrap().threshold.acceleration_g
    }

    #[test]
    fn exact_towers_of_ten_and_twenty_stones() {
        // tan α of every upper part by hand, from weights and heights of boxes
        for (sizes, known) in [(P10.to_vec(), 0.324), (p20(), 0.251)] {
            let states = limits(&tower(&sizes, 0.6));
            let mut least = (f64::INFINITY, 0);
            for from in 0..sizes.len() {
                let (mut weight, mut moment, mut z) = (0.0, 0.0, 0.0);
                for &(width, height) in &sizes[from..] {
                    weight += width * width * height;
                    moment += width * width * height * (z + 0.5 * height);
                    z += height;
                }
                let below = if from == 0 {
                    f64::INFINITY
                } else {
                    sizes[from - 1].0
                };
                let tan_alpha = 0.5 * sizes[from].0.min(below) * weight / moment;
                let found = states.cuts[from].uplift.unwrap().acceleration_g;
                assert!((found - tan_alpha).abs() < 1e-12, "{from}: {found} {tan_alpha}");
                if tan_alpha < least.0 {
                    least = (tan_alpha, from);
                }
            }
            let first = states.uplift.unwrap();
            assert!((least.0 - known).abs() < 5e-4, "{}", least.0);
            assert_eq!(first.cut, least.1);
            assert_eq!(states.governing, Some(first));
            assert!((states.sliding.unwrap().threshold.acceleration_g - 0.6).abs() < 1e-12);
            assert_eq!(states.verdict, Verdict::Stable);
            assert!(states.statically_determinate && states.gravity_margin.unwrap() > 0.999_999);
        }
    }

    #[test]
    fn exact_sliding_governs_smooth_stone() {
        let governing = limits(&tower(&P10, 0.3)).governing.unwrap();
        assert_eq!(governing.kind, LimitKind::Sliding);
        assert!((governing.threshold.acceleration_g - 0.3).abs() < 1e-12);
    }

    #[test]
    fn exact_offset_lowers_one_direction_only() {
        let states = limits(&shifted(&[(1.0, 0.5), (1.0, 1.0)], &[0.0, 0.1], 0.9));
        // the upper stone stands on 0.9 × 1 of the lower one: 0.4 to its edge, 0.5 in y, height 0.5
        let upper = &states.cuts[1];
        assert!((upper.uplift.unwrap().acceleration_g - 0.8).abs() < 1e-12);
        assert!((upper.uplift.unwrap().direction[0] - 1.0).abs() < 1e-12);
        let along = |direction| upper.uplift_in_m_s2(direction).unwrap().unwrap() / 9.81;
        assert!((along([-1.0, 0.0]) - 1.0).abs() < 1e-12);
        assert!((along([0.0, 2.0]) - 1.0).abs() < 1e-12);
        assert!((along([1.0, 1.0]) - 0.8 * 2.0_f64.sqrt()).abs() < 1e-12);
        assert!((upper.gravity_margin - 0.4 / 0.45).abs() < 1e-12);
    }

    #[test]
    fn exact_tilted_joint() {
        let (slope, mu) = (0.01_f64, 0.3_f64);
        let upper = &limits(&leaning(slope, mu)).cuts[1];
        let beta = slope.atan();
        let tan_alpha = (0.2_f64 / 0.5).atan();
        assert!((upper.uplift.unwrap().acceleration_g - (tan_alpha - beta).tan()).abs() < 1e-12);
        assert!((upper.uplift.unwrap().direction[0] - 1.0).abs() < 1e-12);
        let sliding = upper.sliding.unwrap();
        assert!((sliding.acceleration_g - (mu.atan() - beta).tan()).abs() < 1e-9);
        assert!((sliding.direction[0] - 1.0).abs() < 1e-4, "{sliding:?}");
        assert!((upper.gravity_margin - (1.0 - slope / mu)).abs() < 1e-9);
    }

    #[test]
    fn exact_loads_lower_the_threshold() {
        let block = tower(&[(0.4, 2.0)], 0.6);
        let loads = |loads: StackLoads| StackLimits { loads };
        let vertical = loads(StackLoads {
            vertical_acceleration_m_s2: -0.25 * 9.81,
            ..StackLoads::default()
        });
        assert!((uplift(&block, &vertical) - 0.15).abs() < 1e-12);
        let states = stack_limits(&block, &vertical).unwrap();
        assert!((states.sliding.unwrap().threshold.acceleration_g - 0.45).abs() < 1e-12);
        let lateral = loads(StackLoads {
            lateral_m_s2: [0.05 * 9.81, 0.0],
            ..StackLoads::default()
        });
        assert!((uplift(&block, &lateral) - 0.15).abs() < 1e-12);
        let sliding = stack_limits(&block, &lateral).unwrap().sliding.unwrap().threshold;
        assert!((sliding.acceleration_g - 0.55).abs() < 1e-12);
        let weight = 0.32 * 2600.0 * 9.81;
        // a push of 0.04 W at the top: a moment of 0.08 W m, with a resistance of 0.2 W m, m h = 1
        let push = loads(StackLoads {
            forces: vec![PointForce {
                block: 0,
                position_m: Some([0.2, 0.0, 2.0]),
                force_n: [0.04 * weight, 0.0, 0.0],
            }],
            ..StackLoads::default()
        });
        assert!((uplift(&block, &push) - 0.12).abs() < 1e-12);
        // wind on 0.8 m² at half height, oblique: the projected width is 0.4 √2
        let wind = loads(StackLoads {
            wind: Some(Wind {
                pressure_pa: 1000.0,
                direction: [3.0, 0.0],
            }),
            ..StackLoads::default()
        });
        assert!((uplift(&block, &wind) - (0.2 - 800.0 / weight)).abs() < 1e-12);
    }

    #[test]
    fn exact_the_area_of_a_cut_is_that_of_its_patches() {
        // two posts of 1 m² each, 3 m apart, below a beam of 5 m: their hull has 5 m²
        let stone = |size: [f64; 3], position_m: [f64; 3]| {
            let place = Placement {
                position_m,
                ..Placement::default()
            };
            Block {
                name: format!("at {} m", position_m[0]),
                solid: Solid::cuboid(size[0], size[1], size[2]).unwrap().placed(&place),
                density_kg_m3: 2600.0,
            }
        };
        let blocks = vec![
            stone([1.0, 1.0, 2.0], [-2.0, 0.0, 0.0]),
            stone([1.0, 1.0, 2.0], [2.0, 0.0, 0.0]),
            stone([5.0, 1.0, 0.5], [0.0, 0.0, 2.0]),
        ];
        let stack = Stack::new(blocks, JointMaterial::with_friction(0.6), 9.81).unwrap();
        for cut in limits(&stack).cuts.iter().filter(|cut| cut.cut.joints.len() == 2) {
            assert!((cut.area_m2 - 2.0).abs() < 1e-9, "{}", cut.area_m2);
            assert!((cut.contact.moments().area_m2 - 5.0).abs() < 1e-9);
        }
        assert!(limits(&stack).cuts.iter().any(|cut| cut.cut.joints.len() == 2));
    }

    #[test]
    fn exact_strength_moves_the_line_in() {
        // N = 0.32 × 2600 × 9.81 = 8161.92 N over 0.4 m: strip N / (σ 0.4) = 20.4048 mm at 1 MPa, with the axis in its middle
        let block = tower(&[(0.4, 2.0)], 0.6);
        let of_strength = |compressive_strength_pa: f64| {
            let material = JointMaterial {
                compressive_strength_pa: Some(compressive_strength_pa),
                ..JointMaterial::default()
            };
            block.clone().with_material(0, material).unwrap()
        };
        let options = StackLimits::default();
        let crushing = of_strength(1e6);
        let inside = 0.32 * 2600.0 * 9.81 / 1e6 / 0.4 / 2.0;
        assert!((uplift(&crushing, &options) - (0.2 - inside)).abs() < 1e-9);
        // in no direction above the exact limit, and close to it
        let states = stack_limits(&crushing, &options).unwrap();
        let contact = &states.cuts[0].contact;
        let area = 0.32 * 2600.0 * 9.81 / 1e6;
        let around = |k: i32| (f64::from(k).to_radians().cos(), f64::from(k).to_radians().sin());
        for k in (0..90).step_by(3) {
            let (x, y) = around(k);
            let exact = (-89..179).filter_map(|at| {
                let (nu_x, nu_y) = around(at);
                let pivot = toe(std::slice::from_ref(contact), [nu_x, nu_y], area).unwrap();
                let toward = nu_x * x + nu_y * y;
                (toward > 0.01).then(|| (pivot[0] * nu_x + pivot[1] * nu_y) / toward)
            });
            let exact = exact.fold(f64::INFINITY, f64::min);
            let found = states.cuts[0].uplift_in_m_s2([x, y]).unwrap().unwrap() / 9.81;
            assert!(
                found < exact + 1e-9 && found > 0.99 * exact,
                "{k} {found} {exact}"
            );
        }
        let states = stack_limits(&of_strength(5e4), &options).unwrap();
        assert_eq!((states.governing, states.verdict), (None, Verdict::Unstable));
        assert!(
            states
                .standing
                .to_string()
                .starts_with("above the ground the stone crushes")
        );
    }

    #[test]
    fn exact_soil_lowers_every_threshold() {
        let block = tower(&[(0.4, 2.0)], 0.6);
        let fall = 0.32 * 2600.0 * 9.81; // W h, h = 1
        let on = |stiffness: f64| {
            let soil = SoilBelow {
                rocking_stiffness_n_m_rad: stiffness,
                normal_stiffness_pa_m: stiffness / (0.4_f64.powi(4) / 12.0),
                shear_stiffness_pa_m: 1e8,
            };
            block.clone().with_soil(soil).unwrap()
        };
        let usual = StackLimits::default();
        // a = b/(2 h) (1 - (S/K)^⅓)
        for times in [10.0_f64, 1e3, 1e5, 1e7] {
            let exact = 0.2 * (1.0 - (1.0 / times).cbrt());
            let found = uplift(&on(times * fall), &usual);
            assert!((found / exact - 1.0).abs() < 1e-9, "{times}: {found} {exact}");
        }
        let states = stack_limits(&on(0.9 * fall), &usual).unwrap();
        assert_eq!((states.governing, states.verdict), (None, Verdict::Unstable));
        // a part that moves while the bed is closed loses W h/K, as before: sliding at 0.05, the middle third ends at 0.06
        let mut smooth = on(10.0 * fall);
        let mut material = smooth.joints()[0].material;
        (material.friction_static, material.friction_kinetic) = (0.05, 0.05);
        smooth = smooth.with_material(0, material).unwrap();
        let sliding = stack_limits(&smooth, &usual).unwrap().sliding.unwrap();
        assert!(
            (sliding.threshold.acceleration_g - 0.9 * 0.05).abs() < 1e-9,
            "{sliding:?}"
        );
        // a static lateral load of 0.05 g is a part of the push
        let mut both = usual;
        both.loads.lateral_m_s2 = [0.05 * 9.81, 0.0];
        let alone = uplift(&on(10.0 * fall), &StackLimits::default());
        assert!((uplift(&on(10.0 * fall), &both) - (alone - 0.05)).abs() < 1e-9);
    }

    #[test]
    fn exact_loads_turn_the_footing_by_their_heights() {
        // a roof of P = W on top: N = 2 W, S = W h + P 2 h = 3 W h
        let weight = 0.32 * 2600.0 * 9.81;
        let on = |times: f64| {
            let stiffness = times * weight;
            let soil = SoilBelow {
                rocking_stiffness_n_m_rad: stiffness,
                normal_stiffness_pa_m: stiffness / (0.4_f64.powi(4) / 12.0),
                shear_stiffness_pa_m: 1e8,
            };
            let roof = StaticLoad {
                block: 0,
                position_m: [0.0, 0.0, 2.0],
                force_n: [0.0, 0.0, -weight],
            };
            let block = tower(&[(0.4, 2.0)], 0.9).with_static_load(roof).unwrap();
            limits(&block.with_soil(soil).unwrap())
        };
        let exact = 2.0 * 0.2 * (1.0 - 0.1_f64.cbrt());
        let found = on(30.0).uplift.unwrap().threshold.acceleration_g;
        assert!((found / exact - 1.0).abs() < 1e-9, "{found} {exact}");
        // K = 2.9 W h bears the weight, and not the roof
        let states = on(2.9);
        assert_eq!(states.verdict, Verdict::Unstable);
        assert!(
            matches!(states.standing, Standing::SoilTurns { .. }),
            "{:?}",
            states.standing
        );
    }

    #[test]
    fn agrees_a_footing_by_strips_in_any_direction() {
        // another way: pressures of strips across the push, θ stepped, settlement by bisection; sides of 0.5 m, diagonal push
        let (b, l, n, k, s) = (0.5_f64, 0.5_f64, 1e4_f64, 2e6_f64, 0.6e4_f64);
        let strips = 400;
        let at = |i: usize, side: f64| side * ((i as f64 + 0.5) / strips as f64 - 0.5);
        let moment = |theta: f64| {
            let way = 0.5_f64.sqrt();
            let sums = |c: f64| {
                let (mut force, mut moment) = (0.0, 0.0);
                for i in 0..strips {
                    for j in 0..strips {
                        let r = way * (at(i, b) + at(j, l));
                        let p = k * (c + theta * r).max(0.0) * b * l / (strips * strips) as f64;
                        (force, moment) = (force + p, moment + p * r);
                    }
                }
                [force, moment]
            };
            let (mut low, mut high) = (-0.4 * theta, n / (k * b * l) + 0.4 * theta);
            for _ in 0..24 {
                let middle = 0.5 * (low + high);
                match sums(middle)[0] > n {
                    true => high = middle,
                    false => low = middle,
                }
            }
            sums(low)[1]
        };
        let footing = |stiffness_pa_m: f64| super::super::footing::Footing {
            patch: crate::structure::stack::Polygon {
                corners_m: vec![[-0.25, -0.25], [0.25, -0.25], [0.25, 0.25], [-0.25, 0.25]],
            },
            middle_m: [0.0; 3],
            stiffness_pa_m,
            strength_pa: None,
            force_n: n,
            falls_n_m: s,
            lever_kg_m: 1.0,
            settled: [0.0; 2],
            pushed: [0.0; 2],
        };
        let standing = super::super::footing::StandingFooting::of(footing(k), 9.81).unwrap();
        let peak = standing.overturns([0.5_f64.sqrt(), 0.5_f64.sqrt()]).unwrap();
        let theta = peak.turn[0].hypot(peak.turn[1]);
        let strips_at = |theta: f64| moment(theta) - s * theta;
        assert!((strips_at(theta) / peak.acceleration_m_s2 - 1.0).abs() < 1e-3);
        assert!(strips_at(0.9 * theta) < strips_at(theta) && strips_at(1.1 * theta) < strips_at(theta));
    }

    #[test]
    fn exact_ties_and_cohesion_hold() {
        let weight = 0.32 * 2600.0 * 9.81;
        let material = JointMaterial {
            cohesion_pa: 0.1 * weight / 0.16,
            ..JointMaterial::default()
        };
        let tie = Tie {
            lower: Body::Ground,
            upper: 0,
            position_m: [0.0; 3],
            axis: [0.0, 0.0, 1.0],
            axial_stiffness_n_m: 1e8,
            shear_stiffness_n_m: 1e8,
            tension_strength_n: 0.5 * weight,
            shear_strength_n: 0.2 * weight,
        };
        let stack = tower(&[(0.4, 2.0)], 0.6)
            .with_material(0, material)
            .unwrap()
            .with_tie(tie)
            .unwrap();
        let cut = &limits(&stack).cuts[0];
        assert!((cut.uplift.unwrap().acceleration_g - 0.2).abs() < 1e-12);
        assert!((cut.uplift_with_ties.unwrap().acceleration_g - 0.3).abs() < 1e-12);
        assert!((cut.sliding.unwrap().acceleration_g - 0.7).abs() < 1e-12);
        assert!((cut.sliding_with_ties.unwrap().acceleration_g - 0.9).abs() < 1e-12);
    }

    #[test]
    fn exact_a_stack_that_does_not_stand_says_where_and_gives_no_number() {
        let states = limits(&shifted(&[(1.0, 0.5), (1.0, 0.5)], &[0.0, 0.62], 0.6));
        assert_eq!(
            states.standing.to_string(),
            "above 'body 1' the resultant leaves the joint by 0.12 m"
        );
        assert_eq!(states.verdict, Verdict::Unstable);
        assert_eq!(
            (states.uplift, states.sliding, states.governing),
            (None, None, None)
        );
        assert_eq!(states.cuts[1].uplift_in_m_s2([1.0, 0.0]).unwrap(), None);
        let leaning = limits(&leaning(0.01, 0.005));
        assert!(
            leaning.standing.to_string().contains("slides the joint"),
            "{}",
            leaning.standing
        );
    }

    #[test]
    fn exact_a_stone_with_its_weight_on_the_edge_does_not_stand() {
        // half of the stone overhangs: rounding may put the centroid on either side of the edge
        for shift in [0.5, 0.5 - 1e-12, 0.5 + 1e-12] {
            let states = limits(&shifted(&[(1.0, 0.5), (1.0, 0.5)], &[0.0, shift], 0.6));
            assert_eq!(
                (states.verdict, states.uplift),
                (Verdict::Unstable, None),
                "{shift}"
            );
            assert!(states.gravity_margin.unwrap() <= 0.0);
        }
        assert!(
            limits(&shifted(&[(1.0, 0.5), (1.0, 0.5)], &[0.0, 0.499], 0.6))
                .uplift
                .is_some()
        );
    }

    #[test]
    fn refuses_no_weight_and_wrong_options() {
        let block = tower(&[(0.4, 2.0)], 0.6);
        let mut options = StackLimits::default();
        options.loads.vertical_acceleration_m_s2 = -9.81;
        let fault = stack_limits(&block, &options).unwrap_err();
        assert!(fault.to_string().contains("must be above −9.81"));
        for given in [0.0, -1e6, f64::NAN, f64::INFINITY] {
            let material = JointMaterial {
                compressive_strength_pa: Some(given),
                ..JointMaterial::default()
            };
            let fault = block.clone().with_material(0, material).unwrap_err();
            assert!(fault.to_string().contains("compressive_strength_pa"), "{fault}");
        }
    }
}
