//! Any dampers on a prepared problem, frequency by frequency: eqs 7 and 8 of Hwang, Min & Hong with receptances that are known.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | λ | `lambda` | forces of the dampers on the structure: λ = m_a a with the felt acceleration a, K z of a dashpot |
//! | g | `g` | receptances among the places of the dampers, along them |

use super::plan::Table;
use super::{AttachedDamper, DamperError, DamperKind, Judged, PlacedDamper, Plan};
use crate::numeric::complex_solve;
use dolmen_linalg::Complex64;

/// A damper as the sites of a plan see it: z₀ = Σ factor × coordinate, three coordinates a site.
#[derive(Clone, Debug)]
pub(super) struct Ride {
    pub(super) row: Vec<(usize, f64)>,
    pub(super) kind: DamperKind,
}

impl Plan {
    /// Dampers on floors.
    pub(super) fn rides(&self, dampers: &[PlacedDamper]) -> Vec<Ride> {
        let each = dampers.iter().map(|damper| {
            let site = &self.problem().sites[damper.site];
            let coefficients = site.coefficients(damper.place_m, damper.direction_degrees);
            Ride {
                row: (0..3).map(|i| (3 * damper.site + i, coefficients[i])).collect(),
                kind: damper.kind(),
            }
        });
        each.collect()
    }

    /// Dampers on rows of the structure, which may reach only the floors of the plan.
    pub(super) fn rides_of(&self, dampers: &[AttachedDamper]) -> Result<Vec<Ride>, DamperError> {
        let mut rides = Vec::with_capacity(dampers.len());
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
            rides.push(Ride {
                row,
                kind: damper.kind,
            });
        }
        Ok(rides)
    }

    /// Motion of the points and of the dampers in themselves per unit of each load at one frequency: points × loads, then dampers ×
    /// loads; `None` at a resonance without damping.
    pub(super) fn responses(&self, table: &Table, dampers: &[Ride]) -> Option<Vec<Complex64>> {
        let (c, loads, q) = (self.coordinates(), self.problem().loads.len(), dampers.len());
        let points = self.problem().points.len();
        let w2 = table.omega * table.omega;
        // K, and what a felt acceleration or a motion of the place brings
        let forces: Vec<Complex64> = dampers.iter().map(|d| d.kind.stiffness(table.omega)).collect();
        let masses: Vec<Option<Complex64>> = dampers
            .iter()
            .map(|d| match d.kind {
                DamperKind::Viscous { .. } => None,
                _ => Some(d.kind.apparent_mass(table.omega)),
            })
            .collect();
        let place = |k: usize, list: &dyn Fn(usize) -> Complex64| -> Complex64 {
            dampers[k].row.iter().map(|&(i, a)| list(i) * a).sum()
        };
        let g: Vec<Vec<Complex64>> = (0..q)
            .map(|k| {
                (0..q)
                    .map(|j| place(k, &|i| place(j, &|m| table.own[i * c + m])))
                    .collect()
            })
            .collect();
        let mut all = vec![Complex64::ZERO; (points + q) * loads];
        for l in 0..loads {
            let felt = |k: usize| place(k, &|i| table.felt[i * loads + l]);
            let moved = |k: usize| place(k, &|i| table.moved[i * loads + l]);
            let mut lambda: Vec<Complex64> = (0..q)
                .map(|k| match masses[k] {
                    Some(mass) => mass * felt(k),
                    None => forces[k] * moved(k),
                })
                .collect();
            let mut a: Vec<Vec<Complex64>> = (0..q)
                .map(|k| (0..q).map(|j| -forces[k] * g[k][j]).collect())
                .collect();
            for (k, row) in a.iter_mut().enumerate() {
                row[k] += 1.0;
            }
            if !complex_solve(&mut a, &mut lambda) {
                return None;
            }
            for p in 0..points {
                let forced: Complex64 = (0..q)
                    .map(|k| place(k, &|i| table.to_point[p * c + i]) * lambda[k])
                    .sum();
                all[p * loads + l] = table.free[p * loads + l] + forced;
            }
            for (k, damper) in dampers.iter().enumerate() {
                let pushed = (0..q).map(|j| g[k][j] * lambda[j]).sum::<Complex64>();
                all[(points + k) * loads + l] = match masses[k] {
                    Some(_) => (felt(k) + w2 * pushed) * damper.kind.stroke_per_acceleration(table.omega),
                    None => moved(k) + pushed,
                };
            }
        }
        Some(all)
    }

    /// What one frequency adds to the variances of the points and then of the strokes; NaN at a resonance without damping.
    pub(super) fn at_node(&self, table: &Table, dampers: &[Ride]) -> Vec<f64> {
        let loads = self.problem().loads.len();
        match self.responses(table, dampers) {
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
    /// [`DamperError`] if a damper cannot be or is tied to a floor that is not among the sites.
    pub fn judge_attached(&self, dampers: &[AttachedDamper]) -> Result<Judged, DamperError> {
        Ok(self.rides_at_nodes(&self.rides_of(dampers)?))
    }

    pub(super) fn at_nodes(&self, dampers: &[PlacedDamper]) -> Judged {
        self.rides_at_nodes(&self.rides(dampers))
    }

    pub(super) fn rides_at_nodes(&self, dampers: &[Ride]) -> Judged {
        let points = self.problem().points.len();
        let mut variances = vec![0.0; points + dampers.len()];
        for table in &self.nodes {
            for (sum, value) in variances.iter_mut().zip(self.at_node(table, dampers)) {
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
