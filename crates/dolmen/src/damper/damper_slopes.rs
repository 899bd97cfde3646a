//! Derivatives of standard deviations with respect to all unknowns of the dampers, with one solution per frequency instead of two per unknown.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | A λ = b, A = 1 − F g | `inverse` | forces of the dampers; F their stiffness, g as in [`Coupling`] |
//! | B = A⁻¹ | `inverse` | dampers × dampers |
//! | Q = P B, R = g B | `to_points`, `to_places` | response of points and places to a source force at a damper; P = `to_point` |
//! | s | `source` | (dF g + F dg) λ + db: source force from the change of a damper |

use super::damper_coupling::{Coupling, DamperRow};
use super::plan::Table;
use super::{DamperKind, Judged, Plan};
use crate::numeric::{Piece, complex_solve_all};
use dolmen_linalg::Complex64;

/// Step of the central difference in an unknown, which is a logarithm or a place over the floor size: the error is of the order of its square.
pub(super) const SIDE: f64 = 1e-5;

/// A damper with one unknown decreased and increased by a step.
pub(super) struct MovedDamper {
    pub(super) damper: usize,
    pub(super) below: DamperRow,
    pub(super) above: DamperRow,
}

/// All dampers affected by an unknown, moved by [`SIDE`] in both directions.
pub(super) struct MovedDampers(Vec<MovedDamper>);

impl MovedDampers {
    /// The dampers that differ between the two sides.
    pub(super) fn between(below: Vec<DamperRow>, above: Vec<DamperRow>) -> Self {
        let pairs = below.into_iter().zip(above).enumerate();
        let each = pairs.filter_map(|(damper, (below, above))| {
            let is_moved = below.kind != above.kind || below.row != above.row;
            is_moved.then_some(MovedDamper { damper, below, above })
        });
        MovedDampers(each.collect())
    }

    /// The affected dampers of each unknown; `dampers` returns all dampers for given unknowns.
    pub(super) fn of_each(x: &[f64], dampers: impl Fn(&[f64]) -> Vec<DamperRow>) -> Vec<Self> {
        let side = |i: usize, by: f64| {
            let mut moved = x.to_vec();
            moved[i] += by;
            dampers(&moved)
        };
        (0..x.len())
            .map(|i| MovedDampers::between(side(i, -SIDE), side(i, SIDE)))
            .collect()
    }
}

/// Standard deviations and their derivatives with respect to each unknown.
pub(super) struct JudgedSlopes {
    pub(super) judged: Judged,
    pub(super) slopes: Vec<Judged>,
}

impl Judged {
    /// The values after a step `by` along a slope.
    pub(super) fn along(&self, slope: &Judged, by: f64) -> Judged {
        let moved = |own: &[f64], slope: &[f64]| own.iter().zip(slope).map(|(a, b)| a + by * b).collect();
        Judged {
            point_rms: moved(&self.point_rms, &slope.point_rms),
            stroke_rms_m: moved(&self.stroke_rms_m, &slope.stroke_rms_m),
        }
    }
}

/// A damper at one frequency: F, force per unit excitation, and stroke per unit motion.
#[derive(Clone, Copy)]
struct AtFrequency {
    force: Complex64,
    brought: Complex64,
    stroke: Complex64,
}

impl AtFrequency {
    fn of(kind: &DamperKind, omega: f64) -> Self {
        let force = kind.stiffness(omega);
        match kind {
            DamperKind::Viscous { .. } => AtFrequency {
                force,
                brought: force,
                stroke: Complex64::ONE,
            },
            _ => AtFrequency {
                force,
                brought: kind.apparent_mass(omega),
                stroke: kind.stroke_per_acceleration(omega),
            },
        }
    }

    fn slope(below: Self, above: Self) -> Self {
        let of = |a: Complex64, b: Complex64| (b - a) / (2.0 * SIDE);
        AtFrequency {
            force: of(below.force, above.force),
            brought: of(below.brought, above.brought),
            stroke: of(below.stroke, above.stroke),
        }
    }
}

/// Functions of the standard deviations of one or several sets of dampers, with their gradients.
pub(super) fn pieces_of(
    found: &[JudgedSlopes],
    values: impl Fn(&[Judged]) -> Option<Vec<f64>>,
) -> Option<Vec<Piece>> {
    let judged: Vec<Judged> = found.iter().map(|of| of.judged.clone()).collect();
    let unknowns = found.first().map_or(0, |of| of.slopes.len());
    let mut pieces: Vec<Piece> = values(&judged)?
        .into_iter()
        .map(|value| Piece {
            value,
            slope: Vec::with_capacity(unknowns),
        })
        .collect();
    for i in 0..unknowns {
        let side = |by: f64| -> Vec<Judged> {
            let each = found.iter().map(|of| of.judged.along(&of.slopes[i], by));
            each.collect()
        };
        let (above, below) = (values(&side(SIDE))?, values(&side(-SIDE))?);
        for (piece, (above, below)) in pieces.iter_mut().zip(above.into_iter().zip(below)) {
            piece.slope.push((above - below) / (2.0 * SIDE));
        }
    }
    Some(pieces)
}

impl Plan {
    /// Standard deviations from the prepared frequencies, with their slopes. Give `couplings` if the dampers keep their places. `None` at a resonance
    /// without damping.
    pub(super) fn slopes_at_nodes(
        &self,
        couplings: Option<&[Coupling]>,
        dampers: &[DamperRow],
        moved: &[MovedDampers],
    ) -> Option<JudgedSlopes> {
        let outputs = self.problem().points.len() + dampers.len();
        let mut variances = vec![0.0; outputs];
        let mut slopes = vec![vec![0.0; outputs]; moved.len()];
        for (at, table) in self.nodes.iter().enumerate() {
            let own;
            let coupling = match couplings {
                Some(all) => &all[at],
                None => {
                    own = self.coupling(table, dampers);
                    &own
                }
            };
            let node = Node::of(self, (table, coupling), dampers)?;
            node.add_variances(&mut variances);
            for (moved, slopes) in moved.iter().zip(&mut slopes) {
                for damper in &moved.0 {
                    node.add_slopes(dampers, damper, slopes);
                }
            }
        }
        let points = self.problem().points.len();
        let apart = |mut all: Vec<f64>| {
            let stroke_rms_m = all.split_off(points);
            Judged {
                point_rms: all,
                stroke_rms_m,
            }
        };
        let rms: Vec<f64> = variances.into_iter().map(f64::sqrt).collect();
        let of_rms = |slopes: Vec<f64>| -> Vec<f64> {
            let pairs = slopes.iter().zip(&rms);
            pairs.map(|(slope, rms)| slope / (2.0 * rms)).collect()
        };
        Some(JudgedSlopes {
            slopes: slopes.into_iter().map(|of| apart(of_rms(of))).collect(),
            judged: apart(rms.clone()),
        })
    }
}

struct Node<'a> {
    table: &'a Table,
    coupling: &'a Coupling,
    coordinates: usize,
    points: usize,
    loads: usize,
    /// Number of dampers.
    q: usize,
    at: Vec<AtFrequency>,
    is_dashpot: Vec<bool>,
    /// λ: dampers × loads, and g λ.
    forces: Vec<Complex64>,
    pushed: Vec<Complex64>,
    /// Q: points × dampers, R: dampers × dampers.
    to_points: Vec<Complex64>,
    to_places: Vec<Complex64>,
    /// Points, then strokes, × loads.
    responses: Vec<Complex64>,
}

impl<'a> Node<'a> {
    fn of(plan: &Plan, (table, coupling): (&'a Table, &'a Coupling), dampers: &[DamperRow]) -> Option<Self> {
        let (points, loads, q) = (
            plan.problem().points.len(),
            plan.problem().loads.len(),
            dampers.len(),
        );
        let at: Vec<AtFrequency> = dampers
            .iter()
            .map(|damper| AtFrequency::of(&damper.kind, table.omega))
            .collect();
        let is_dashpot: Vec<bool> = dampers
            .iter()
            .map(|damper| matches!(damper.kind, DamperKind::Viscous { .. }))
            .collect();
        let mut a: Vec<Vec<Complex64>> = (0..q)
            .map(|k| {
                let row = (0..q).map(|j| -at[k].force * coupling.g[k * q + j]);
                row.enumerate()
                    .map(|(j, of)| if j == k { of + 1.0 } else { of })
                    .collect()
            })
            .collect();
        let unit = |j: usize| (0..q).map(move |k| if j == k { Complex64::ONE } else { Complex64::ZERO });
        let mut columns: Vec<Vec<Complex64>> = (0..q).map(|j| unit(j).collect()).collect();
        let mut right: Vec<&mut [Complex64]> = columns.iter_mut().map(Vec::as_mut_slice).collect();
        if !complex_solve_all(&mut a, &mut right) {
            return None;
        }
        let times = |rows: usize, left: &[Complex64]| -> Vec<Complex64> {
            let entry = |r: usize, j: usize| (0..q).map(|k| left[r * q + k] * columns[j][k]).sum();
            (0..rows * q).map(|at| entry(at / q, at % q)).collect()
        };
        let mut node = Node {
            table,
            coupling,
            coordinates: plan.coordinates(),
            points,
            loads,
            q,
            to_points: times(points, &coupling.to_point),
            to_places: times(q, &coupling.g),
            forces: vec![Complex64::ZERO; q * loads],
            pushed: vec![Complex64::ZERO; q * loads],
            responses: vec![Complex64::ZERO; (points + q) * loads],
            is_dashpot,
            at,
        };
        node.respond(&columns);
        Some(node)
    }

    fn respond(&mut self, columns: &[Vec<Complex64>]) {
        let (points, loads, q) = (self.points, self.loads, self.q);
        for l in 0..loads {
            let brought: Vec<Complex64> = (0..q).map(|j| self.at[j].brought * self.without(j, l)).collect();
            let force = |k: usize| -> Complex64 {
                let pairs = columns.iter().zip(&brought);
                pairs.map(|(column, brought)| column[k] * brought).sum()
            };
            for k in 0..q {
                self.forces[k * loads + l] = force(k);
            }
            for k in 0..q {
                self.pushed[k * loads + l] = (0..q)
                    .map(|j| self.coupling.g[k * q + j] * self.forces[j * loads + l])
                    .sum();
            }
            for p in 0..points {
                let forced: Complex64 = (0..q)
                    .map(|k| self.coupling.to_point[p * q + k] * self.forces[k * loads + l])
                    .sum();
                self.responses[p * loads + l] = self.table.free[p * loads + l] + forced;
            }
            for k in 0..q {
                self.responses[(points + k) * loads + l] = self.at[k].stroke * self.stirred(k, l);
            }
        }
    }

    /// Excitation of a damper when no dampers act on the structure: an acceleration; a motion for a dashpot.
    fn without(&self, k: usize, l: usize) -> Complex64 {
        match self.is_dashpot[k] {
            true => self.coupling.moved[k * self.loads + l],
            false => self.coupling.felt[k * self.loads + l],
        }
    }

    /// ω² if the excitation is an acceleration, 1 for a dashpot.
    fn weight(&self, k: usize) -> f64 {
        match self.is_dashpot[k] {
            true => 1.0,
            false => self.table.omega * self.table.omega,
        }
    }

    /// Excitation of a damper when all dampers act.
    fn stirred(&self, k: usize, l: usize) -> Complex64 {
        self.without(k, l) + self.weight(k) * self.pushed[k * self.loads + l]
    }

    fn add_variances(&self, variances: &mut [f64]) {
        for (sum, each) in variances.iter_mut().zip(self.responses.chunks(self.loads)) {
            let weighted = each.iter().zip(&self.table.densities);
            *sum += weighted.map(|(h, density)| density * h.norm_sqr()).sum::<f64>();
        }
    }

    /// Contribution of the change of one damper to the derivatives of the variances.
    fn add_slopes(&self, dampers: &[DamperRow], moved: &MovedDamper, slopes: &mut [f64]) {
        let (c, loads, q, j) = (self.coordinates, self.loads, self.q, moved.damper);
        let omega = self.table.omega;
        let [below, above] = [&moved.below, &moved.above].map(|of| AtFrequency::of(&of.kind, omega));
        let d = AtFrequency::slope(below, above);
        let row: Vec<(usize, f64)> = moved
            .below
            .row
            .iter()
            .zip(&moved.above.row)
            .map(|((i, a), (_, b))| (*i, (b - a) / (2.0 * SIDE)))
            .filter(|(_, slope)| *slope != 0.0)
            .collect();
        let at = |list: &dyn Fn(usize) -> Complex64| -> Complex64 {
            row.iter().map(|&(i, slope)| list(i) * slope).sum()
        };
        let place = |k: usize, list: &dyn Fn(usize) -> Complex64| -> Complex64 {
            dampers[k].row.iter().map(|&(i, a)| list(i) * a).sum()
        };
        // derivative of g: row and column of this damper; their common element is the sum of both
        let (mut d_row, mut d_column) = (vec![Complex64::ZERO; q], vec![Complex64::ZERO; q]);
        if !row.is_empty() {
            for k in 0..q {
                d_row[k] = at(&|i| place(k, &|m| self.table.own[i * c + m]));
                d_column[k] = at(&|m| place(k, &|i| self.table.own[i * c + m]));
            }
        }
        for l in 0..loads {
            let force = self.forces[j * loads + l];
            // dg λ, at this damper and at the others
            let own: Complex64 = (0..q).map(|k| d_row[k] * self.forces[k * loads + l]).sum();
            let d_pushed = |k: usize| d_column[k] * force + if k == j { own } else { Complex64::ZERO };
            let felt = match self.is_dashpot[j] {
                true => at(&|i| self.table.moved[i * loads + l]),
                false => at(&|i| self.table.felt[i * loads + l]),
            };
            let here = d.brought * self.without(j, l)
                + self.at[j].brought * felt
                + d.force * self.pushed[j * loads + l]
                + self.at[j].force * d_pushed(j);
            let source = |m: usize| match m == j {
                true => here,
                false => self.at[m].force * d_pushed(m),
            };
            let through = |matrix: &[Complex64], r: usize| -> Complex64 {
                match row.is_empty() {
                    true => matrix[r * q + j] * here,
                    false => (0..q).map(|m| matrix[r * q + m] * source(m)).sum(),
                }
            };
            let density = 2.0 * self.table.densities[l];
            let mut add = |output: usize, change: Complex64| {
                let h = self.responses[output * loads + l];
                slopes[output] += density * (h.re * change.re + h.im * change.im);
            };
            for p in 0..self.points {
                let placed = at(&|i| self.table.to_point[p * c + i]) * force;
                add(p, placed + through(&self.to_points, p));
            }
            for k in 0..q {
                let stirred = self.weight(k) * (d_pushed(k) + through(&self.to_places, k));
                let mut change = self.at[k].stroke * stirred;
                if k == j {
                    change += self.at[j].stroke * felt + d.stroke * self.stirred(j, l);
                }
                add(self.points + k, change);
            }
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::damper::{DamperProblem, DamperSite, PlacedDamper, PlanOptions};
    use crate::dynamics::{LinearSystem, RandomInput, RandomLoad, Spectrum};
    use dolmen_linalg::Matrix;

    /// A floor with torsion under two forces and a base acceleration.
    fn plan(expected: &PlacedDamper) -> Plan {
        let diagonal = Matrix::from_diagonal;
        let mut k = diagonal(&[30.0, 24.0, 500.0]);
        (k[(1, 2)], k[(2, 1)]) = (-18.0, -18.0);
        let structure =
            LinearSystem::new(diagonal(&[1.0, 1.0, 14.0]), diagonal(&[0.2, 0.2, 3.0]), k).unwrap();
        let load = |input: RandomInput| RandomLoad {
            input,
            spectrum: Spectrum::White { density: 1.0 },
        };
        let problem = DamperProblem {
            structure,
            loads: vec![
                load(RandomInput::Force(vec![0.4, 1.0, 2.0])),
                load(RandomInput::Base(vec![0.3, 1.0, 0.0])),
            ],
            points: vec![vec![0.0, 1.0, -5.0], vec![0.0, 1.0, 5.0], vec![1.0, 0.0, 4.0]],
            sites: vec![DamperSite {
                first_degree_of_freedom: 0,
                reference_m: [0.0, 0.0],
                corners_m: vec![[-5.0, -4.0], [5.0, -4.0], [5.0, 4.0], [-5.0, 4.0]],
            }],
            fixed: Vec::new(),
        };
        Plan::new(problem, &[*expected], &PlanOptions::default()).unwrap()
    }

    fn mass() -> PlacedDamper {
        PlacedDamper {
            site: 0,
            place_m: [3.0, 1.0],
            direction_degrees: 80.0,
            mass_kg: 0.05,
            frequency_hz: 0.75,
            damping_ratio: 0.1,
            length_ratio: 1.0,
        }
    }

    /// A mass with a variable place, two columns and a dashpot with fixed places.
    fn rows(plan: &Plan, x: &[f64]) -> Vec<DamperRow> {
        let first = PlacedDamper {
            place_m: [3.0 + 10.0 * x[0], 1.0 + 10.0 * x[1]],
            frequency_hz: 0.75 * x[2].exp(),
            mass_kg: 0.05 * x[3].exp(),
            ..mass()
        };
        let mut all = plan.damper_rows(&[first]);
        let stands = |kind: DamperKind, arm: f64| DamperRow {
            row: vec![(1, 1.0), (2, arm)],
            kind,
        };
        all.push(stands(
            DamperKind::LiquidColumn {
                liquid_mass_kg: 0.04,
                length_ratio: 0.8,
                frequency_hz: 0.7,
                damping_ratio: 0.07 * x[4].exp(),
            },
            -3.0,
        ));
        all.push(stands(
            DamperKind::Viscous {
                coefficient_n_s_m: 0.05 * x[5].exp(),
            },
            5.0,
        ));
        all.push(stands(
            DamperKind::LiquidColumnMass {
                container_mass_kg: 0.02,
                liquid_mass_kg: 0.03,
                length_ratio: 0.7,
                frequency_hz: 0.9 * x[2].exp(), // moved by the same unknown
                damping_ratio: 0.08,
                liquid_frequency_hz: 0.8 * x[6].exp(),
                liquid_damping_ratio: 0.06,
            },
            2.0,
        ));
        all
    }

    #[test]
    fn agrees_slopes_are_those_of_differences() {
        let plan = plan(&mass());
        let x = [0.0; 7];
        let own = rows(&plan, &x);
        let moved = MovedDampers::of_each(&x, |x| rows(&plan, x));
        let found = plan.slopes_at_nodes(None, &own, &moved).unwrap();
        let kept = plan
            .slopes_at_nodes(Some(&plan.couplings(&own)), &own, &moved)
            .unwrap();
        let judged = |x: &[f64]| {
            let rows = rows(&plan, x);
            let of = plan.coupled_at_nodes(&plan.couplings(&rows), &rows);
            [of.point_rms, of.stroke_rms_m].concat()
        };
        let all = |of: &Judged| [of.point_rms.clone(), of.stroke_rms_m.clone()].concat();
        for (a, b) in all(&found.judged).iter().zip(judged(&x)) {
            assert!((a / b - 1.0).abs() < 1e-12, "{a} {b}");
        }
        for i in 0..x.len() {
            let side = |by: f64| {
                let mut moved = x;
                moved[i] += by;
                judged(&moved)
            };
            let (above, below) = (side(2e-5), side(-2e-5));
            let (slopes, without) = (all(&found.slopes[i]), all(&kept.slopes[i]));
            for output in 0..slopes.len() {
                let difference = (above[output] - below[output]) / 4e-5;
                // third-order error of the differences themselves
                let scale = difference.abs().max(0.1 * above[output]);
                assert!(
                    (slopes[output] - difference).abs() < 1e-6 * scale,
                    "{i} {output} {} {difference}",
                    slopes[output]
                );
                assert!((slopes[output] - without[output]).abs() < 1e-12 * scale);
            }
        }
    }
}
