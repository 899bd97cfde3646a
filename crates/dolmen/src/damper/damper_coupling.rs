//! Couples dampers of any kind to the prepared receptances at each frequency: eqs 7 and 8 of Hwang, Min & Hong.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | λ | `lambda` | forces of the dampers on the structure: λ = m_a a with the felt acceleration a; K z for a dashpot |
//! | g | `g` | receptances between the places of the dampers, along their directions |

use super::plan::Table;
use super::{AttachedDamper, DamperError, DamperKind, Judged, PlacedDamper, Plan};
use crate::numeric::complex_solve_all;
use dolmen_linalg::Complex64;

/// A damper on the coordinates of a plan's sites: z₀ = Σ factor × coordinate, with three coordinates for each site.
#[derive(Clone, Debug)]
pub(super) struct DamperRow {
    pub(super) row: Vec<(usize, f64)>,
    pub(super) kind: DamperKind,
}

/// Receptances of the structure between loads, points and damper places, at one frequency.
pub(super) struct Coupling {
    /// Between the places: places × places.
    pub(super) g: Vec<Complex64>,
    /// Felt acceleration and motion of the places without dampers: places × loads.
    pub(super) felt: Vec<Complex64>,
    pub(super) moved: Vec<Complex64>,
    /// Motion of the points per unit force at a place: points × places.
    pub(super) to_point: Vec<Complex64>,
}

impl Plan {
    pub(super) fn damper_rows(&self, dampers: &[PlacedDamper]) -> Vec<DamperRow> {
        let each = dampers.iter().map(|damper| {
            let site = &self.problem().sites[damper.site];
            let coefficients = site.coefficients(damper.place_m, damper.direction_degrees);
            DamperRow {
                row: (0..3).map(|i| (3 * damper.site + i, coefficients[i])).collect(),
                kind: damper.kind(),
            }
        });
        each.collect()
    }

    /// Dampers whose rows reach only the floors of the plan.
    pub(super) fn damper_rows_of(&self, dampers: &[AttachedDamper]) -> Result<Vec<DamperRow>, DamperError> {
        let mut damper_rows = Vec::with_capacity(dampers.len());
        for (k, damper) in dampers.iter().enumerate() {
            super::assembled::check_row(k + 1, &damper.row, self.problem().structure.degrees_of_freedom())?;
            damper.kind.check()?;
            let mut row = Vec::new();
            for (at, &factor) in damper
                .row
                .iter()
                .enumerate()
                .filter(|(_, factor)| **factor != 0.0)
            {
                let sites = self.problem().sites.iter();
                let mut own = sites.map(|site| at.checked_sub(site.first_degree_of_freedom));
                let Some(site) = own.position(|from| from.is_some_and(|from| from < 3)) else {
                    return Err(DamperError::NoSite { damper: k + 1 });
                };
                row.push((
                    3 * site + at - self.problem().sites[site].first_degree_of_freedom,
                    factor,
                ));
            }
            damper_rows.push(DamperRow {
                row,
                kind: damper.kind,
            });
        }
        Ok(damper_rows)
    }

    /// Receptances of the structure at the places of the dampers at one frequency; they do not depend on the tuning.
    pub(super) fn coupling(&self, table: &Table, dampers: &[DamperRow]) -> Coupling {
        let (c, loads, q) = (self.coordinates(), self.problem().loads.len(), dampers.len());
        let points = self.problem().points.len();
        let place = |k: usize, list: &dyn Fn(usize) -> Complex64| -> Complex64 {
            dampers[k].row.iter().map(|&(i, a)| list(i) * a).sum()
        };
        let pairs =
            |first: usize, second: usize| (0..first * second).map(move |at| (at / second, at % second));
        Coupling {
            g: pairs(q, q)
                .map(|(k, j)| place(k, &|i| place(j, &|m| table.own[i * c + m])))
                .collect(),
            felt: pairs(q, loads)
                .map(|(k, l)| place(k, &|i| table.felt[i * loads + l]))
                .collect(),
            moved: pairs(q, loads)
                .map(|(k, l)| place(k, &|i| table.moved[i * loads + l]))
                .collect(),
            to_point: pairs(points, q)
                .map(|(p, k)| place(k, &|i| table.to_point[p * c + i]))
                .collect(),
        }
    }

    /// Motion of the points, then strokes of the dampers, per unit load at one frequency: points × loads, then dampers × loads;
    /// `None` at a resonance without damping.
    pub(super) fn responses(&self, table: &Table, dampers: &[DamperRow]) -> Option<Vec<Complex64>> {
        self.responses_of(table, &self.coupling(table, dampers), dampers)
    }

    fn responses_of(&self, table: &Table, of: &Coupling, dampers: &[DamperRow]) -> Option<Vec<Complex64>> {
        let (loads, q) = (self.problem().loads.len(), dampers.len());
        let points = self.problem().points.len();
        let w2 = table.omega * table.omega;
        // stiffness K, and force per unit acceleration (per unit motion for a dashpot) of the place
        let forces: Vec<Complex64> = dampers.iter().map(|d| d.kind.stiffness(table.omega)).collect();
        let masses: Vec<Option<Complex64>> = dampers
            .iter()
            .map(|d| match d.kind {
                DamperKind::Viscous { .. } => None,
                _ => Some(d.kind.apparent_mass(table.omega)),
            })
            .collect();
        let mut a: Vec<Vec<Complex64>> = (0..q)
            .map(|k| (0..q).map(|j| -forces[k] * of.g[k * q + j]).collect())
            .collect();
        for (k, row) in a.iter_mut().enumerate() {
            row[k] += 1.0;
        }
        let brought = |k: usize, l: usize| match masses[k] {
            Some(mass) => mass * of.felt[k * loads + l],
            None => forces[k] * of.moved[k * loads + l],
        };
        let mut lambda: Vec<Vec<Complex64>> = (0..loads)
            .map(|l| (0..q).map(|k| brought(k, l)).collect())
            .collect();
        let mut right: Vec<&mut [Complex64]> = lambda.iter_mut().map(Vec::as_mut_slice).collect();
        if !complex_solve_all(&mut a, &mut right) {
            return None;
        }
        let mut all = vec![Complex64::ZERO; (points + q) * loads];
        for (l, lambda) in lambda.iter().enumerate() {
            for p in 0..points {
                let forced: Complex64 = (0..q).map(|k| of.to_point[p * q + k] * lambda[k]).sum();
                all[p * loads + l] = table.free[p * loads + l] + forced;
            }
            for (k, damper) in dampers.iter().enumerate() {
                let pushed = (0..q).map(|j| of.g[k * q + j] * lambda[j]).sum::<Complex64>();
                all[(points + k) * loads + l] = match masses[k] {
                    Some(_) => {
                        (of.felt[k * loads + l] + w2 * pushed)
                            * damper.kind.stroke_per_acceleration(table.omega)
                    }
                    None => of.moved[k * loads + l] + pushed,
                };
            }
        }
        Some(all)
    }

    /// Contribution of one frequency to the variances of the points and then of the strokes; NaN at a resonance without damping.
    pub(super) fn at_node(&self, table: &Table, dampers: &[DamperRow]) -> Vec<f64> {
        self.at_node_of(table, &self.coupling(table, dampers), dampers)
    }

    fn at_node_of(&self, table: &Table, coupling: &Coupling, dampers: &[DamperRow]) -> Vec<f64> {
        let loads = self.problem().loads.len();
        match self.responses_of(table, coupling, dampers) {
            Some(responses) => responses
                .chunks(loads)
                .map(|each| {
                    let weighted = each.iter().zip(&table.densities);
                    weighted.map(|(h, density)| density * h.norm_sqr()).sum()
                })
                .collect(),
            None => vec![f64::NAN; self.problem().points.len() + dampers.len()],
        }
    }

    /// Standard deviations of the points and strokes with dampers of any kind, from the prepared frequencies.
    ///
    /// # Errors
    /// [`DamperError`] if a damper is invalid or connects to a floor that is not among the sites.
    pub fn judge_attached(&self, dampers: &[AttachedDamper]) -> Result<Judged, DamperError> {
        Ok(self.rows_at_nodes(&self.damper_rows_of(dampers)?))
    }

    pub(super) fn at_nodes(&self, dampers: &[PlacedDamper]) -> Judged {
        self.rows_at_nodes(&self.damper_rows(dampers))
    }

    fn rows_at_nodes(&self, dampers: &[DamperRow]) -> Judged {
        let each = self.nodes.iter().map(|table| self.at_node(table, dampers));
        self.of_variances(dampers.len(), each)
    }

    pub(super) fn couplings(&self, dampers: &[DamperRow]) -> Vec<Coupling> {
        let nodes = self.nodes.iter();
        nodes.map(|table| self.coupling(table, dampers)).collect()
    }

    /// Standard deviations from known couplings, for dampers that keep their places.
    pub(super) fn coupled_at_nodes(&self, couplings: &[Coupling], dampers: &[DamperRow]) -> Judged {
        let nodes = self.nodes.iter().zip(couplings);
        let each = nodes.map(|(table, coupling)| self.at_node_of(table, coupling, dampers));
        self.of_variances(dampers.len(), each)
    }

    fn of_variances(&self, dampers: usize, each: impl Iterator<Item = Vec<f64>>) -> Judged {
        let points = self.problem().points.len();
        let mut variances = vec![0.0; points + dampers];
        for node in each {
            for (sum, value) in variances.iter_mut().zip(node) {
                *sum += value;
            }
        }
        let mut point_rms: Vec<f64> = variances.into_iter().map(f64::sqrt).collect();
        let stroke_rms_m = point_rms.split_off(points);
        Judged {
            point_rms,
            stroke_rms_m,
        }
    }
}
