//! Demand of a response spectrum on the joints of a stack, by modal analysis.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | φ, ω, Γ | `shape`, –, `participation` | a mode of the stack, its factor of participation along x and y | m and rad, rad/s, – |
//! | S, A₀ | `spectral`, `ground` | spectral acceleration of a mode, peak of the ground | m/s² |
//! | ρ | – | correlation coefficient of two modes | – |
//! | α | – | part of S in phase with the ground: A₀/S, or 0 | – |
//! | w | `wrenches` | force and moment of the inertia forces of one mode on the part above a joint, for Γ S = 1 | N, N m |
//! | r, s | [`Resistance`] | part of the force and moment that tips or slides the part, and its resistance | – |
//!
//! ```text
//! w²   = w_r² + Σ Σ ρ √(1 − α_i²) √(1 − α_j²) w_i w_j,   w_r = what moves with the ground at A₀, less the modes with α = 0
//! ```
//!
//! α = A₀/S for modes of shorter periods than the peak of the spectrum (Lindley & Yow), so that stiffer and stiffer joints lead to rigid blocks.
//! A second sum takes it for all modes with S ≥ A₀. The larger of the two counts.
//!
//! # Source
//! U.S. NRC (2006) Regulatory Guide 1.92, revision 2, C.1.3 and C.1.4.1; Lindley, D. W. & Yow, J. R. (1980), modal response summation for seismic
//! qualification. Differs from the source: the second sum.

use super::{ShakenDirection, SiteDemand};
use crate::assess::AssessError;
use crate::blocks::StackMode;
use crate::dynamics::correlation_coefficient;
use crate::stability::stack::{
    DemandVerdict, LimitAnalysis, LimitAnalysisStatus, LimitKind, OnSoil, Resistance, Shaking, StackLimits,
    SwayingForces, cut_resistances, is_statically_determinate, limit_analysis_undilated,
};
use crate::structure::stack::Stack;
use glam::{DMat3, DVec3};
use rayon::prelude::*;
use std::f64::consts::FRAC_PI_4;

/// Least mass participation, along x and along y, of the modes that are included. Our choice: a thousand smaller ones have a thousandth.
const MASS_LEAST: f64 = 1e-6;
/// Largest number of modes that are combined, lowest first; the higher modes move with the ground. Our choice: all modes of a hundred stones on top
/// of each other.
const MODES_MOST: usize = 400;

/// Sine of the angle to an axis below which a direction is along it. Our choice.
const ALONG_AN_AXIS: f64 = 1e-6;

/// Force, N, and moment about the origin, N m.
type Wrench = [f64; 6];

/// Ratio of the capacity of a stack to the demand of a spectrum, and the part that governs.
#[derive(Clone, Debug, PartialEq)]
pub struct ModalRatio {
    /// Ratio of capacity to demand: under the spectrum times this factor a part begins to tip or slide.
    pub ratio: f64,
    /// Tipping or sliding, and the blocks above the joint; `None` where stones share their load and limit analysis governs.
    pub first: Option<(LimitKind, String)>,
    /// Whether the capacity is above, near or below the demand.
    pub verdict: DemandVerdict,
}

struct ModeUnderSpectrum<'a> {
    shape: &'a [[f64; 6]],
    /// Γ along x and y.
    participation: [f64; 2],
    /// S, m/s².
    spectral: f64,
    /// α in each of the two sums.
    in_phase: [f64; SUMS],
}

impl ModeUnderSpectrum<'_> {
    /// √(1 − α²) in one of the sums.
    fn periodic(&self, sum: usize) -> f64 {
        (1.0 - self.in_phase[sum].powi(2)).sqrt()
    }
}

/// Number of sums over the modes: α = A₀/S on the rising branch of the spectrum alone, and for all modes with S ≥ A₀.
const SUMS: usize = 2;

pub(super) struct ModalDemand<'a> {
    stack: &'a Stack,
    modes: Vec<ModeUnderSpectrum<'a>>,
    /// ρ of each pair of modes, row by row.
    correlations: Vec<f64>,
    ground: f64,
}

impl<'a> ModalDemand<'a> {
    pub(super) fn new(
        stack: &'a Stack,
        modes: &'a [StackMode],
        site: &SiteDemand,
        ground: f64,
    ) -> Result<Self, AssessError> {
        let counts = |mode: &&StackMode| {
            mode.effective_mass_ratio[..2]
                .iter()
                .any(|ratio| *ratio > MASS_LEAST)
                && mode.frequency_hz > 0.0
        };
        let (mut shaken, mut frequencies) = (Vec::new(), Vec::new());
        for mode in modes.iter().filter(counts).take(MODES_MOST) {
            let period_s = 1.0 / mode.frequency_hz;
            let spectral = acceleration(site, period_s, ground)?;
            let may_be = [period_s <= site.spectrum.peaks_from_s(), true];
            shaken.push(ModeUnderSpectrum {
                shape: &mode.shape,
                participation: participation(stack, &mode.shape),
                spectral,
                in_phase: may_be.map(|may_be| match may_be && spectral >= ground {
                    true => ground / spectral,
                    false => 0.0,
                }),
            });
            frequencies.push(mode.frequency_hz);
        }
        let zeta = site.damping_ratio;
        let pair = |a: f64, b: f64| correlation_coefficient([a, zeta], [b, zeta]);
        let correlations = frequencies
            .iter()
            .flat_map(|&a| frequencies.iter().map(move |&b| pair(a, b)));
        Ok(ModalDemand {
            stack,
            correlations: correlations.collect(),
            modes: shaken,
            ground,
        })
    }

    /// Capacity under shaking along x, along y, and in any direction. `weakest` is the direction in which the stack begins to move, if one moves it.
    pub(super) fn ratios(
        &self,
        limits: &StackLimits,
        weakest: Option<[f64; 2]>,
    ) -> Result<[ModalRatio; 3], AssessError> {
        let directions = [ShakenDirection::X, ShakenDirection::Y, ShakenDirection::Any];
        let mut least = directions.map(|_| (f64::INFINITY, None));
        for cut in cut_resistances(self.stack, limits)? {
            let combined = self.combined(&cut.blocks, |wrench| wrench);
            for one in &cut.resistances {
                for (direction, least) in directions.iter().zip(&mut least) {
                    let ratio = one.reserve.max(0.0) / combined.largest(&functional(one), *direction);
                    if ratio < least.0 {
                        *least = (ratio, Some((one.kind, cut.above.clone())));
                    }
                }
            }
        }
        if !is_statically_determinate(self.stack) {
            let each = self.each_block();
            let axes = [[1.0, 0.0], [0.0, 1.0]].into_iter();
            let ways: Vec<[f64; 2]> = axes.chain(weakest.into_iter().flat_map(turned_with)).collect();
            let along: Vec<Result<f64, AssessError>> = ways
                .par_iter()
                .map(|way| self.along(*way, &each, limits))
                .collect();
            let along = along.into_iter().collect::<Result<Vec<f64>, _>>()?;
            let any = along.iter().copied().fold(f64::INFINITY, f64::min);
            for (together, least) in [along[0], along[1], any].into_iter().zip(&mut least) {
                if together < least.0 {
                    *least = (together, None);
                }
            }
        }
        Ok(least.map(|(ratio, first)| ModalRatio {
            ratio,
            first,
            verdict: DemandVerdict::of_ratio(ratio),
        }))
    }

    /// Force, and moment about its centroid, of every stone.
    fn each_block(&self) -> Vec<Combined> {
        let blocks = self.stack.blocks().iter().enumerate();
        let each = blocks.map(|(block, stone)| {
            let centroid = DVec3::from(stone.solid.centroid_m());
            self.combined(&[block], |wrench| about(centroid, wrench))
        });
        each.collect()
    }

    /// Ratio of capacity to the largest forces along a direction, acting together, by limit analysis; the smaller of both senses.
    fn along(&self, way: [f64; 2], each: &[Combined], limits: &StackLimits) -> Result<f64, AssessError> {
        // the footing takes the largest share of what overturns it, and less of what moves parts above
        let soil = OnSoil::of(self.stack, &limits.loads)?;
        if !soil.stands() {
            return Ok(0.0);
        }
        let (left, swaying) = (soil.factor(), swaying(each, way));
        let mut least = f64::INFINITY;
        let found: Vec<_> = [way, way.map(|part| -part)]
            .into_par_iter()
            .map(|way| {
                let analysis = LimitAnalysis {
                    loads: limits.loads.clone(),
                    shaking: Shaking::Along(way),
                    swaying: Some(swaying.clone()),
                    ..LimitAnalysis::default()
                };
                limit_analysis_undilated(self.stack, &analysis)
            })
            .collect();
        for found in found {
            let found = found?.analysis;
            least = match found.status {
                LimitAnalysisStatus::DoesNotStand => 0.0,
                LimitAnalysisStatus::Unlimited => least,
                LimitAnalysisStatus::Limited(_) => least.min(found.at_least_g * left),
            };
        }
        Ok(least)
    }

    /// Inertia forces on some blocks, combined over the modes, after `of` is applied to each force and moment.
    fn combined(&self, blocks: &[usize], of: impl Fn(Wrench) -> Wrench) -> Combined {
        let on = |shape: &dyn Fn(usize) -> [f64; 6]| {
            let mut sum = [0.0; 6];
            for &block in blocks {
                add(&mut sum, 1.0, &inertia(self.stack, block, &shape(block)));
            }
            of(sum)
        };
        let wrenches: Vec<Wrench> = self
            .modes
            .iter()
            .map(|mode| on(&|block| mode.shape[block]))
            .collect();
        let mut combined = Combined::default();
        let count = self.modes.len();
        for (of, sum) in combined.sums.iter_mut().enumerate() {
            for (along, rigid) in sum.rigid.iter_mut().enumerate() {
                *rigid = on(&|_| std::array::from_fn(|part| if part == along { self.ground } else { 0.0 }));
                let modes = self.modes.iter().zip(&wrenches);
                for (mode, wrench) in modes.filter(|(mode, _)| mode.in_phase[of] == 0.0) {
                    add(rigid, -mode.participation[along] * self.ground, wrench);
                }
            }
        }
        for (which, (first, second)) in [(0, 0), (0, 1), (1, 1)].into_iter().enumerate() {
            for (i, mode) in self.modes.iter().enumerate() {
                let mut beside = [[0.0; 6]; SUMS];
                for ((other, wrench), rho) in self
                    .modes
                    .iter()
                    .zip(&wrenches)
                    .zip(&self.correlations[i * count..][..count])
                {
                    let push = mode.participation[first]
                        * mode.spectral
                        * other.participation[second]
                        * other.spectral;
                    for (of, beside) in beside.iter_mut().enumerate() {
                        add(
                            beside,
                            rho * push * mode.periodic(of) * other.periodic(of),
                            wrench,
                        );
                    }
                }
                for (sum, beside) in combined.sums.iter_mut().zip(&beside) {
                    for (row, own) in wrenches[i].iter().enumerate() {
                        add(&mut sum.periodic[which][row], *own, beside);
                    }
                }
            }
        }
        combined
    }
}

/// Directions that turn with the stack: the weakest one, the diagonals and the one across, without those along x and y.
fn turned_with([x, y]: [f64; 2]) -> impl Iterator<Item = [f64; 2]> {
    let from = y.atan2(x);
    let ways = (0..4).map(move |turn| (from + f64::from(turn) * FRAC_PI_4).sin_cos());
    let is_along_an_axis = |[x, y]: &[f64; 2]| x.abs().min(y.abs()) < ALONG_AN_AXIS;
    ways.map(|(sin, cos)| [cos, sin])
        .filter(move |way| !is_along_an_axis(way))
}

/// Largest force of every stone along a direction, and largest moment about the axis across it, over all directions of shaking.
fn swaying(each: &[Combined], [x, y]: [f64; 2]) -> Vec<SwayingForces> {
    let all = each.iter().map(|combined| {
        let largest = |row: Wrench| combined.largest(&row, ShakenDirection::Any);
        SwayingForces {
            force_n: [largest([x, y, 0.0, 0.0, 0.0, 0.0]); 2],
            moment_n_m: [largest([0.0, 0.0, 0.0, -y, x, 0.0]); 2],
        }
    });
    all.collect()
}

/// Force and moment, combined over the modes.
#[derive(Default)]
struct Combined {
    sums: [ModalSum; SUMS],
}

/// One sum over the modes.
#[derive(Default)]
struct ModalSum {
    /// Products of what is not in phase with the ground: x with x, x with y, y with y.
    periodic: [[Wrench; 6]; 3],
    /// In phase with the ground along x and along y.
    rigid: [Wrench; 2],
}

impl Combined {
    /// Largest combined force and moment: the larger of the two sums.
    fn largest(&self, row: &Wrench, direction: ShakenDirection) -> f64 {
        let product = |matrix: &[Wrench; 6]| -> f64 {
            matrix
                .iter()
                .zip(row)
                .map(|(line, own)| own * dot(line, row))
                .sum()
        };
        let of = |squares: [f64; 3]| match direction {
            ShakenDirection::X => squares[0].max(0.0).sqrt(),
            ShakenDirection::Y => squares[2].max(0.0).sqrt(),
            ShakenDirection::Any => {
                // the larger eigenvalue belongs to the worst direction in plan
                let [xx, xy, yy] = squares;
                let apart = (0.5 * (xx - yy)).hypot(xy);
                (0.5 * (xx + yy) + apart).max(0.0).sqrt()
            }
        };
        let each = self.sums.iter().map(|sum| {
            let [x, y] = [dot(&sum.rigid[0], row), dot(&sum.rigid[1], row)];
            let mut squares = [0, 1, 2].map(|which| product(&sum.periodic[which]));
            for (square, rigid) in squares.iter_mut().zip([x * x, x * y, y * y]) {
                *square += rigid;
            }
            of(squares)
        });
        each.fold(0.0, f64::max)
    }
}

/// S at a period; before the first row of a table, the larger of that row and the ground acceleration.
fn acceleration(site: &SiteDemand, period_s: f64, ground: f64) -> Result<f64, AssessError> {
    match site.spectrum.points().first() {
        Some(&[least_s, first]) if period_s < least_s => Ok(first.max(ground)),
        _ => site.spectrum.acceleration_m_s2(period_s, site.damping_ratio),
    }
}

/// Γ along x and y: Σ m φ / φᵀ M φ.
fn participation(stack: &Stack, shape: &[[f64; 6]]) -> [f64; 2] {
    let (mut momentum, mut energy) = ([0.0; 2], 0.0);
    for (block, own) in shape.iter().enumerate() {
        let [x, y, z, ..] = *own;
        let centroid = DVec3::from(stack.blocks()[block].solid.centroid_m());
        let force = about(centroid, inertia(stack, block, own));
        momentum[0] += stack.blocks()[block].mass_kg() * x;
        momentum[1] += stack.blocks()[block].mass_kg() * y;
        energy += dot(&force, &[x, y, z, own[3], own[4], own[5]]);
    }
    momentum.map(|sum| sum / energy)
}

/// Force and moment about the origin of a block with the accelerations of a shape, m/s² and rad/s².
fn inertia(stack: &Stack, block: usize, shape: &[f64; 6]) -> Wrench {
    let block = &stack.blocks()[block];
    let [x, y, z, a, b, c] = *shape;
    let force = DVec3::new(x, y, z) * block.mass_kg();
    let turns = DMat3::from_cols_array_2d(&block.solid.inertia_m5()) * DVec3::new(a, b, c);
    let moment = DVec3::from(block.solid.centroid_m()).cross(force) + turns * block.density_kg_m3;
    [force.x, force.y, force.z, moment.x, moment.y, moment.z]
}

/// The force, and its moment about another point.
fn about(point: DVec3, [x, y, z, a, b, c]: Wrench) -> Wrench {
    let moment = DVec3::new(a, b, c) - point.cross(DVec3::new(x, y, z));
    [x, y, z, moment.x, moment.y, moment.z]
}

fn functional(one: &Resistance) -> Wrench {
    let ([x, y, z], [a, b, c]) = (one.force, one.moment);
    [x, y, z, a, b, c]
}

fn add(sum: &mut Wrench, factor: f64, of: &Wrench) {
    for (sum, of) in sum.iter_mut().zip(of) {
        *sum += factor * of;
    }
}

fn dot(a: &Wrench, b: &Wrench) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[cfg(test)]
mod tests {
    use super::super::{EurocodeGround, EurocodeType, Site, site_demand, stack_against_site};
    use super::*;
    use crate::assess::StackCheckOptions;
    use crate::blocks::{ContactRule, stack_modes};
    use crate::structure::stack::{Block, JointMaterial, Placement, Solid};
    use dolmen_linalg::{Matrix, generalized_symmetric_eigen};
    use std::f64::consts::TAU;

    const G: f64 = 9.81;
    /// Five stones and a finial: width, height, m.
    const TOWER: [[f64; 2]; 6] = [
        [1.4, 0.8],
        [1.4, 0.8],
        [1.4, 0.8],
        [1.4, 0.8],
        [1.4, 0.8],
        [0.2, 0.9],
    ];

    fn boxes(sizes: &[[f64; 3]], at: &[[f64; 3]]) -> Stack {
        let blocks = sizes
            .iter()
            .zip(at)
            .enumerate()
            .map(|(i, ([x, y, z], at))| Block {
                name: format!("s{i}"),
                solid: Solid::cuboid(*x, *y, *z).unwrap().placed(&Placement {
                    position_m: *at,
                    ..Placement::default()
                }),
                density_kg_m3: 2600.0,
            });
        Stack::new(blocks.collect(), JointMaterial::with_friction(0.9), G).unwrap()
    }

    fn tower() -> Stack {
        let mut z = 0.0;
        let (mut sizes, mut at) = (Vec::new(), Vec::new());
        for [width, height] in TOWER {
            sizes.push([width, width, height]);
            at.push([0.0, 0.0, z]);
            z += height;
        }
        boxes(&sizes, &at)
    }

    fn site(ground_acceleration_g: f64, vertical: Option<f64>) -> SiteDemand {
        let site = Site::Eurocode8 {
            ground_acceleration_g,
            importance_factor: 1.0,
            spectrum: EurocodeType::One,
            ground: EurocodeGround::B,
        };
        site_demand(&site, 0.05, vertical).unwrap()
    }

    /// Least tipping ratio of all joints of the tower in its plane, and the joint. The model has two degrees of freedom per stone and joint springs
    /// from area and second moment.
    fn in_its_plane(site: &SiteDemand, ground: f64) -> (f64, usize) {
        let (n, normal, shear) = (TOWER.len(), 1e9, 4e8);
        let (mut stiffness, mut mass) = (Matrix::zeros(2 * n, 2 * n), Matrix::zeros(2 * n, 2 * n));
        let (mut z, mut beds, mut middles) = (0.0, Vec::new(), Vec::new());
        for (i, [width, height]) in TOWER.into_iter().enumerate() {
            let m = 2600.0 * width * width * height;
            mass[(2 * i, 2 * i)] = m;
            mass[(2 * i + 1, 2 * i + 1)] = m * (width * width + height * height) / 12.0;
            let bed = if i == 0 { width } else { width.min(TOWER[i - 1][0]) };
            // rows for the slip and the rotation of the joint
            let mut rows = [vec![0.0; 2 * n], vec![0.0; 2 * n]];
            (rows[0][2 * i], rows[0][2 * i + 1], rows[1][2 * i + 1]) = (1.0, -0.5 * height, 1.0);
            if i > 0 {
                (rows[0][2 * i - 2], rows[0][2 * i - 1], rows[1][2 * i - 1]) =
                    (-1.0, -0.5 * TOWER[i - 1][1], -1.0);
            }
            for (row, spring) in rows.iter().zip([shear * bed * bed, normal * bed.powi(4) / 12.0]) {
                for a in 0..2 * n {
                    for b in 0..2 * n {
                        stiffness[(a, b)] += spring * row[a] * row[b];
                    }
                }
            }
            beds.push((z, bed));
            middles.push(z + 0.5 * height);
            z += height;
        }
        let eigen = generalized_symmetric_eigen(&stiffness, &mass).unwrap();
        let omegas: Vec<f64> = eigen.values.iter().map(|value| value.sqrt()).collect();
        let mut least = (f64::INFINITY, 0);
        for (joint, (bed_z, bed)) in beds.into_iter().enumerate() {
            let above = joint..n;
            let weight: f64 = above.clone().map(|i| mass[(2 * i, 2 * i)] * G).sum();
            let level: f64 = above
                .clone()
                .map(|i| mass[(2 * i, 2 * i)] * (middles[i] - bed_z))
                .sum();
            let mut flexible = 0.0;
            let moments: Vec<[f64; 2]> = (0..2 * n)
                .map(|k| {
                    let shape = eigen.vectors.column(k);
                    let gamma: f64 = (0..n).map(|i| mass[(2 * i, 2 * i)] * shape[2 * i]).sum();
                    let moment: f64 = above
                        .clone()
                        .map(|i| {
                            mass[(2 * i, 2 * i)] * shape[2 * i] * (middles[i] - bed_z)
                                + mass[(2 * i + 1, 2 * i + 1)] * shape[2 * i + 1]
                        })
                        .sum();
                    let period_s = TAU / omegas[k];
                    let spectral = site.spectrum.acceleration_m_s2(period_s, 0.05).unwrap();
                    let periodic = (1.0 - (ground / spectral).powi(2)).sqrt();
                    // the spectrum of type 1 on ground B rises until 0.15 s
                    if period_s > 0.15 {
                        flexible += gamma * ground * moment;
                    }
                    let rising = if period_s > 0.15 { 1.0 } else { periodic };
                    [rising, periodic].map(|part| gamma * spectral * moment * part)
                })
                .collect();
            let mut sums = [ground * level - flexible, ground * level].map(|rigid| rigid.powi(2));
            for (k, a) in moments.iter().enumerate() {
                for (l, b) in moments.iter().enumerate() {
                    let rho = correlation_coefficient([omegas[k], 0.05], [omegas[l], 0.05]);
                    for (sum, (a, b)) in sums.iter_mut().zip(a.iter().zip(b)) {
                        *sum += rho * a * b;
                    }
                }
            }
            let ratio = 0.5 * weight * bed / sums[0].max(sums[1]).sqrt();
            if ratio < least.0 {
                least = (ratio, joint);
            }
        }
        least
    }

    #[test]
    fn agrees_with_a_model_in_the_plane() {
        let (stack, site) = (tower(), site(0.053, Some(0.0)));
        let ground = site.peak_ground_acceleration_m_s2.unwrap();
        let modes = stack_modes(&stack, ContactRule::Four).unwrap();
        let found = ModalDemand::new(&stack, &modes, &site, ground).unwrap();
        let (known, joint) = in_its_plane(&site, ground);
        assert_eq!(joint, 5);
        for ratio in found.ratios(&StackLimits::default(), None).unwrap() {
            assert!(
                (ratio.ratio / known - 1.0).abs() < 1e-4,
                "{} {known}",
                ratio.ratio
            );
            assert_eq!(ratio.first, Some((LimitKind::Uplift, "'s4'".to_owned())));
        }
    }

    #[test]
    fn regress_a_finial_that_opens_is_below_demand_though_s_a_on_all_stones_alike_is_not() {
        let stack = tower();
        let modes = stack_modes(&stack, ContactRule::Four).unwrap();
        let options = StackCheckOptions::default();
        let found = stack_against_site(&stack, &options, &site(0.053, None), Some(&modes))
            .unwrap()
            .unwrap();
        for row in &found.rows {
            assert_eq!(row.comparison.verdict, DemandVerdict::Above);
            assert_eq!(row.verdict, DemandVerdict::Below);
        }
        assert_eq!(found.verdict, DemandVerdict::Below);
    }

    #[test]
    fn holds_a_spectrum_without_amplification_asks_at_least_for_rigid_blocks() {
        // S = A₀ at every period: nothing is periodic, everything moves with the ground
        let table = Site::Table {
            source: "level".into(),
            points: vec![[0.0, 1.0], [5.0, 1.0]],
            damping_ratio: 0.05,
            peak_ground_acceleration_m_s2: None,
        };
        let (stack, site) = (tower(), site_demand(&table, 0.05, None).unwrap());
        let modes = stack_modes(&stack, ContactRule::Four).unwrap();
        let found = ModalDemand::new(&stack, &modes, &site, 1.0).unwrap();
        let combined = found.combined(&[5], |wrench| wrench);
        let moment = [0.0, 0.0, 0.0, 0.0, 1.0, 0.0];
        let rigid = dot(&combined.sums[1].rigid[0], &moment);
        let height = 4.0 + 0.45;
        assert!((rigid / (2600.0 * 0.04 * 0.9 * height) - 1.0).abs() < 1e-12);
        let ratio = &found.ratios(&StackLimits::default(), None).unwrap()[2];
        assert!(ratio.ratio <= 2.0 / 9.0 * G * (1.0 + 1e-12), "{}", ratio.ratio);
    }

    /// With all modes periodic both bore a third of what rigid blocks do.
    #[test]
    fn limit_joints_that_hardly_give_bear_what_rigid_blocks_do() {
        let site = site(0.1, Some(0.0));
        let ground = site.peak_ground_acceleration_m_s2.unwrap();
        let mut off = Vec::new();
        for stiffness in [1e12, 1e13] {
            let material = JointMaterial {
                normal_stiffness_pa_m: stiffness,
                shear_stiffness_pa_m: stiffness,
                ..JointMaterial::with_friction(0.9)
            };
            let stack = Stack::new(tower().blocks().to_vec(), material, G).unwrap();
            let modes = stack_modes(&stack, ContactRule::Four).unwrap();
            let found = ModalDemand::new(&stack, &modes, &site, ground).unwrap();
            // the finial tips at 0.2/0.9 of gravity
            let rigid = 2.0 / 9.0 * G / ground;
            for one in found.ratios(&StackLimits::default(), None).unwrap() {
                off.push(1.0 - one.ratio / rigid);
            }
        }
        assert!(off[..3].iter().all(|off| (0.0..0.3).contains(off)), "{off:?}");
        assert!(off[3..].iter().all(|off| (0.0..0.12).contains(off)), "{off:?}");
    }

    #[test]
    fn holds_stones_that_share_their_load_bear_no_more_than_their_cuts() {
        // a slab on four posts
        let mut sizes = vec![[0.3, 0.3, 1.2]; 4];
        sizes.push([2.0, 2.0, 0.3]);
        let mut at: Vec<[f64; 3]> = Vec::new();
        for (x, y) in [(-0.8, -0.8), (0.8, -0.8), (-0.8, 0.8), (0.8, 0.8)] {
            at.push([x, y, 0.0]);
        }
        at.push([0.0, 0.0, 1.2]);
        let (stack, site) = (boxes(&sizes, &at), site(0.1, Some(0.0)));
        let modes = stack_modes(&stack, ContactRule::Four).unwrap();
        let found = ModalDemand::new(&stack, &modes, &site, 1.0).unwrap();
        let [x, y, any] = found.ratios(&StackLimits::default(), None).unwrap();
        assert_eq!(x.first, None);
        assert!((x.ratio / y.ratio - 1.0).abs() < 1e-4);
        assert!(any.ratio <= x.ratio * 1.000_001 && any.ratio > 0.5 * x.ratio);
    }

    /// Two posts, weak along one direction, and a beam: turned in plan they bear the same in any direction.
    #[test]
    fn holds_the_ratio_in_any_direction_turns_with_the_stack() {
        let turned = |yaw_rad: f64| {
            let (sin, cos) = yaw_rad.sin_cos();
            let sizes = [
                ([0.4, 1.0, 2.0], -0.8, 0.0),
                ([0.4, 1.0, 2.0], 0.8, 0.0),
                ([2.0, 1.0, 0.5], 0.0, 2.0),
            ];
            let blocks = sizes.iter().enumerate().map(|(i, (size, x, z))| Block {
                name: format!("s{i}"),
                solid: Solid::cuboid(size[0], size[1], size[2])
                    .unwrap()
                    .placed(&Placement {
                        position_m: [x * cos, x * sin, *z],
                        yaw_rad,
                        ..Placement::default()
                    }),
                density_kg_m3: 2600.0,
            });
            let stack = Stack::new(blocks.collect(), JointMaterial::with_friction(0.9), G).unwrap();
            let modes = stack_modes(&stack, ContactRule::Four).unwrap();
            let options = StackCheckOptions::default();
            let found = stack_against_site(&stack, &options, &site(0.1, None), Some(&modes));
            found.unwrap().unwrap().rows[2].by_modes.as_ref().unwrap().ratio
        };
        let straight = turned(0.0);
        for yaw_rad in [0.3, std::f64::consts::FRAC_PI_4, 1.2] {
            let ratio = turned(yaw_rad);
            assert!(
                (ratio / straight - 1.0).abs() < 1e-5,
                "{yaw_rad}: {ratio} {straight}"
            );
        }
    }
}
