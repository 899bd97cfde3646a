//! Finds which test refused the poles at a peak of the spectrum, and by how much.

use super::remarks::near;
use crate::modal::{Cluster, Clustering, Fate, JudgedPole, Refusal, Stability, Stabilization};

/// The poles of an analysis and their clusters, with the results of all tests.
pub(crate) struct Diagram<'a> {
    pub(crate) stabilization: &'a Stabilization,
    pub(crate) clusters: &'a [Cluster],
    pub(crate) clustering: &'a Clustering,
    pub(crate) duration_s: f64,
}

impl Diagram<'_> {
    /// Why no pole at this peak became a mode: the reason of the cluster with the most orders near the peak, or without a cluster the test
    /// that most poles there failed. `None` if the method takes the peaks themselves as modes.
    pub(crate) fn refusal(&self, peak_hz: f64) -> Option<Refusal> {
        if self.stabilization.poles.is_empty() {
            return None;
        }
        let groups = self
            .clusters
            .iter()
            .filter(|c| near(c.medoid.frequency_hz, peak_hz));
        Some(match groups.max_by_key(|c| c.orders.len()) {
            Some(group) => self.of_group(group),
            None => self.of_poles(peak_hz),
        })
    }

    fn of_poles(&self, peak_hz: f64) -> Refusal {
        let here: Vec<&JudgedPole> = self
            .stabilization
            .poles
            .iter()
            .filter(|p| near(p.pole.frequency_hz, peak_hz))
            .collect();
        let count = |stability: Stability| here.iter().filter(|p| p.stability == stability).count();
        let most = [
            Stability::OutOfRange,
            Stability::Damping,
            Stability::Complex,
            Stability::Scattered,
        ]
        .into_iter()
        .rev()
        .max_by_key(|s| count(*s))
        .filter(|s| count(*s) > 0);
        let Some(most) = most else {
            return Refusal::NoPole;
        };
        let middle = |of: &dyn Fn(&JudgedPole) -> f64| {
            let mut all: Vec<f64> = here
                .iter()
                .filter(|p| p.stability == most)
                .map(|p| of(p))
                .collect();
            all.sort_by(f64::total_cmp);
            all[all.len() / 2]
        };
        let criteria = &self.stabilization.criteria;
        let duration_s = self.duration_s;
        match most {
            Stability::OutOfRange => Refusal::OutOfRange {
                low_hz: criteria.frequency_low_hz,
                high_hz: criteria.frequency_high_hz,
            },
            Stability::Damping => Refusal::Damping {
                damping_ratio: middle(&|p| p.pole.damping_ratio),
                least: criteria.damping_estimate_least_at(peak_hz, duration_s),
                most: criteria.damping_ratio_most,
            },
            Stability::Complex => Refusal::Complex {
                phase_collinearity: middle(&|p| p.pole.phase_collinearity),
                least: criteria.phase_collinearity_least,
            },
            _ => Refusal::Scattered {
                over_floor: middle(&|p| {
                    p.frequency_sd_hz.unwrap_or(f64::INFINITY) / p.pole.floor_hz(duration_s)
                }),
                most: criteria.deviation_over_floor_most,
            },
        }
    }

    /// The test that refused this cluster of poles.
    pub(crate) fn of_group(&self, group: &Cluster) -> Refusal {
        let clustering = self.clustering;
        let floor_hz = group.medoid.floor_hz(self.duration_s);
        match group.fate {
            Fate::Mode => Refusal::Machine,
            Fate::FewOrders => {
                // as in clustering: the required number is a share of the orders from the first order in the cluster
                let mut orders: Vec<usize> = self.stabilization.poles.iter().map(|p| p.pole.order).collect();
                orders.dedup();
                let first = group.orders.first().copied().unwrap_or(0);
                let possible = orders.iter().filter(|order| **order >= first).count();
                let wanted = (clustering.orders_share_least * possible as f64).ceil() as usize;
                Refusal::FewOrders {
                    orders: group.orders.len(),
                    wanted: wanted.max(clustering.orders_least),
                }
            }
            Fate::Scattered => Refusal::Scattered {
                over_floor: group
                    .deviation
                    .as_ref()
                    .map_or(f64::INFINITY, |d| d.frequency_sd_hz)
                    / floor_hz,
                most: clustering.deviation_over_floor_most,
            },
            Fate::Double => Refusal::SplitsOff,
            Fate::Blend => Refusal::Blend {
                damping_ratio: group.medoid.damping_ratio,
            },
        }
    }
}
