//! Automatic selection of modes: clusters of poles that agree across model orders, one pole per order. The medoid represents the cluster.
//!
//! | symbol | code | meaning |
//! |:--|:--|:--|
//! | d | `distance` | distance between two poles |
//! | μ/2π | `root_hz` | continuous-time eigenvalue over 2π, Hz |

use super::ssi::{Pole, Subspace};
use super::stabilization::{AllOrders, JudgedPole, Stabilization};
use super::uncertainty::Deviations;
use crate::modal::indicators::assurance;
use crate::modal::{ModalError, PoleDeviation, Propagation};
use dolmen_linalg::Complex64;

/// Options of [`clusters`].
#[derive(Clone, Debug, PartialEq)]
pub struct Clustering {
    /// Largest distance d between a pole and the medoid of its cluster; default 0.05 (our choice: several times the scatter of a pole between
    /// orders, and far below 1, the distance of two orthogonal shapes).
    pub distance_most: f64,
    /// Least share of the model orders, from the first with the mode to the highest, 0 to 1; default 0.2 (our choice).
    pub orders_share_least: f64,
    /// Fewest orders; default 4 (our choice).
    pub orders_least: usize,
    /// Largest standard deviation of the frequency of a mode over its lower bound √(ζ/2πN_c), at the order with the smallest standard
    /// deviation; default 3.5 (our choice: modes of simulated records stay below 2, and those of a timber building with amplitude-dependent
    /// stiffness below 3; poles that fit noise start near 3.5).
    pub deviation_over_floor_most: f64,
}

impl Default for Clustering {
    fn default() -> Self {
        Clustering {
            distance_most: 0.05,
            orders_share_least: 0.2,
            orders_least: 4,
            deviation_over_floor_most: 3.5,
        }
    }
}

/// Result for a cluster.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Fate {
    /// The cluster is a mode.
    Mode,
    /// Too few orders have the pole.
    FewOrders,
    /// The standard deviation is too large for the length of the record, at every order.
    Scattered,
    /// The cluster is split off a mode with more orders: its shape is similar, and the frequencies agree within their scatter. Or it lies
    /// between two modes that only higher orders separate. Or its shape is a mixture, at the frequency of a mode with a real one.
    Double,
    /// The cluster ends before the highest orders and has far more damping than the modes: it merges several modes that the record cannot
    /// separate.
    Blend,
}

/// Poles of several orders that agree.
#[derive(Clone, Debug, PartialEq)]
pub struct Cluster {
    /// The pole nearest to all others, among the poles whose standard deviation is near the smallest.
    pub medoid: Pole,
    /// Standard deviations of the medoid; `None` if one or two orders alone have it.
    pub deviation: Option<PoleDeviation>,
    /// Orders with a pole in the cluster, ascending.
    pub orders: Vec<usize>,
    /// Standard deviation of the frequency between the most accurate orders, without outliers, Hz.
    pub frequency_spread_hz: f64,
    /// Standard deviation of the damping ratio between the most accurate orders, without outliers.
    pub damping_ratio_spread: f64,
    /// Result for the cluster.
    pub fate: Fate,
}

/// Clusters the possible poles across orders, and tests each cluster.
///
/// ```text
/// d(i, j) = |μ_i - μ_j| / |μ_j| + 1 - MAC(i, j)
/// ```
/// The pole with the most orders within d ≤ `distance_most` (if equal, with the smallest mean d) starts a cluster; the nearest pole of each
/// order joins it. All poles within this distance are then removed, and the next cluster follows. The medoid represents a cluster. It is
/// chosen from the most accurate orders, of at least twice the number of modes, because lower orders merge modes and are biased without a
/// larger standard deviation (measured: a mode of the twisting building at 7.78 Hz by -0.15 %, six of its standard deviations).
///
/// # Errors
/// [`ModalError::Linalg`].
///
/// # Source
/// Distance: Magalhães, Cunha & Caetano (2009) Mech. Syst. Signal Process. 23:316-329. Differs from the source: greedy clusters instead of a
/// hierarchical tree; the number of modes is not given, but follows from the number of orders in each cluster.
pub fn clusters(
    subspace: &Subspace,
    stabilization: &Stabilization,
    options: &Clustering,
) -> Result<Vec<Cluster>, ModalError> {
    group_poles(
        &AllOrders::of(subspace),
        &mut Propagation::new(subspace),
        stabilization,
        options,
    )
}

/// As [`clusters`], for any poles.
pub(crate) fn group_poles(
    all: &AllOrders<'_>,
    deviations: &mut dyn Deviations,
    stabilization: &Stabilization,
    options: &Clustering,
) -> Result<Vec<Cluster>, ModalError> {
    let poles: Vec<&JudgedPole> = stabilization
        .poles
        .iter()
        .filter(|j| j.stability.possible())
        .collect();
    let groups = group(&poles, options);
    // an order below twice the number of modes merges some of them: they are biased, with an equally small standard deviation
    let found = judged(&groups, &poles, 0, all, (deviations, options))?;
    let modes = found.iter().filter(|c| c.fate == Fate::Mode).count();
    let mut found = judged(&groups, &poles, 2 * modes, all, (deviations, options))?;
    found.sort_by(|a, b| a.medoid.frequency_hz.total_cmp(&b.medoid.frequency_hz));
    Ok(found)
}

/// Fewest orders with a pole of which the deviations are computed: two agree by chance.
const RECURS: usize = 3;

/// The verdict and medoid of each cluster, from the orders that can hold all modes, if there are enough of them.
fn judged(
    groups: &[Vec<usize>],
    poles: &[&JudgedPole],
    first_whole: usize,
    all: &AllOrders<'_>,
    (deviations, options): (&mut dyn Deviations, &Clustering),
) -> Result<Vec<Cluster>, ModalError> {
    let mut found = Vec::with_capacity(groups.len());
    for members in groups {
        let first = members.first().map_or(0, |&m| poles[m].pole.order);
        let possible = all.order_most.saturating_sub(first) / all.order_step + 1;
        let needed = (options.orders_share_least * possible as f64).ceil() as usize;
        let whole: Vec<usize> = members
            .iter()
            .copied()
            .filter(|&m| poles[m].pole.order >= first_whole)
            .collect();
        let best = best_known(
            if whole.len() >= options.orders_least {
                &whole
            } else {
                members
            },
            poles,
        );
        let Some(medoid) = medoid(&best) else { continue };
        let enough = members.len() >= needed.max(options.orders_least);
        let most_hz = options.deviation_over_floor_most * medoid.floor_hz(all.duration_s);
        let deviation = if members.len() >= RECURS {
            Some(deviations.deviation(medoid)?)
        } else {
            None
        };
        let [frequency_spread_hz, damping_ratio_spread] = spreads(medoid, &best, deviation.as_ref());
        found.push(Cluster {
            medoid: medoid.clone(),
            orders: members.iter().map(|&i| poles[i].pole.order).collect(),
            frequency_spread_hz,
            damping_ratio_spread,
            fate: match &deviation {
                _ if !enough => Fate::FewOrders,
                Some(d) if d.frequency_sd_hz > most_hz => Fate::Scattered,
                _ => Fate::Mode,
            },
            deviation,
        });
    }
    for i in 0..found.len() {
        let double = found[i].fate == Fate::Mode && found[..i].iter().any(|mode| splits_off(&found[i], mode));
        if double {
            found[i].fate = Fate::Double;
        }
    }
    let mixtures: Vec<usize> = (0..found.len()).filter(|&i| mixes(&found[i], &found)).collect();
    for i in mixtures {
        found[i].fate = Fate::Double;
    }
    let lumps: Vec<usize> = (0..found.len()).filter(|&i| lumps(&found[i], &found)).collect();
    for i in lumps {
        found[i].fate = Fate::Double;
    }
    let blends: Vec<usize> = (0..found.len())
        .filter(|&i| blends(&found[i], &found, all.order_most))
        .collect();
    for i in blends {
        found[i].fate = Fate::Blend;
    }
    Ok(found)
}

/// Whether `cluster` merges several modes: higher orders split it but cannot separate the modes, and its damping is significantly and far
/// above that of the modes. In 48 simulated records of chains with 5 % damping (two sensors, 10 to 20 minutes, 240 modes), 15 clusters had 8
/// to 14 % damping; this test leaves four of them, and all 151 others (our choice).
fn blends(cluster: &Cluster, all: &[Cluster], order_most: usize) -> bool {
    const ENDS: f64 = 0.85; // of the highest order
    const ABOVE: f64 = 1.5; // of the median of the other modes
    const FROM: f64 = 0.08; // no structure without dampers has more; below, modes of one structure may differ so
    const OTHERS_LEAST: usize = 2;
    const DEVIATIONS: f64 = 2.0;
    let ends = cluster
        .orders
        .last()
        .is_some_and(|last| *last as f64 <= ENDS * order_most as f64);
    let zeta = |c: &Cluster| c.medoid.damping_ratio;
    let is_other = |other: &&Cluster| other.fate == Fate::Mode && !std::ptr::eq(*other, cluster);
    let mut others: Vec<f64> = all.iter().filter(is_other).map(zeta).collect();
    others.sort_by(f64::total_cmp);
    let sd = cluster.deviation.as_ref().map_or(0.0, |d| d.damping_ratio_sd);
    cluster.fate == Fate::Mode
        && ends
        && zeta(cluster) > FROM
        && others.len() >= OTHERS_LEAST
        && zeta(cluster) - DEVIATIONS * sd > ABOVE * others[others.len() / 2]
}

/// Whether `cluster` merges two modes at low orders, one on each side: it ends before one of them begins, it is within their half-power
/// bands, and its shape is in the plane of both.
fn lumps(cluster: &Cluster, all: &[Cluster]) -> bool {
    const AROUND: f64 = 0.3; // relative: what low orders lump lies so near
    const IN_PLANE: f64 = 0.98; // of its square
    let (f, width_hz) = (cluster.medoid.frequency_hz, cluster.half_width_hz());
    let is_later = |other: &Cluster| {
        (other.medoid.frequency_hz - f).abs() <= width_hz + other.half_width_hz()
            && cluster.orders.last() < other.orders.first()
    };
    let is_near = |other: &&Cluster| {
        other.fate == Fate::Mode
            && (other.medoid.frequency_hz / f - 1.0).abs() <= AROUND
            && other.medoid.frequency_hz != f
    };
    let (below, above): (Vec<&Cluster>, Vec<&Cluster>) = all
        .iter()
        .filter(is_near)
        .partition(|other| other.medoid.frequency_hz < f);
    cluster.fate == Fate::Mode
        && below.iter().any(|low| {
            above.iter().any(|high| {
                (is_later(low) || is_later(high))
                    && share_in_plane(&cluster.medoid.shape, [&low.medoid.shape, &high.medoid.shape])
                        >= IN_PLANE
            })
        })
}

/// Share of the squared norm of a shape that is in the plane of two others.
pub(in crate::modal) fn share_in_plane(shape: &[Complex64], plane: [&[Complex64]; 2]) -> f64 {
    let inner =
        |a: &[Complex64], b: &[Complex64]| a.iter().zip(b).map(|(a, b)| a.conj() * b).sum::<Complex64>();
    let square = |a: &[Complex64]| a.iter().map(|z| z.norm_sqr()).sum::<f64>();
    let [a, b] = plane;
    let along = inner(a, b) / square(a);
    let across: Vec<Complex64> = b.iter().zip(a).map(|(b, a)| b - along * a).collect();
    let part = |axis: &[Complex64]| match square(axis) {
        size if size > 1e-12 * square(b) => inner(axis, shape).norm_sqr() / size,
        _ => 0.0, // the two are one shape
    };
    (part(a) + part(&across)) / square(shape)
}

impl Cluster {
    /// Half of the half-power bandwidth, ζ f, Hz.
    fn half_width_hz(&self) -> f64 {
        self.medoid.damping_ratio * self.medoid.frequency_hz
    }

    /// Standard deviation of the frequency, between blocks of time and between orders, Hz.
    fn frequency_sd_hz(&self) -> Option<f64> {
        let of_time = self.deviation.as_ref()?.frequency_sd_hz;
        Some(of_time.hypot(self.frequency_spread_hz))
    }
}

/// Whether `cluster` is the same mode as `mode`, which has at least as many orders.
fn splits_off(cluster: &Cluster, mode: &Cluster) -> bool {
    const DEVIATIONS: f64 = 3.0; // two estimates of one number lie so near in 99.7 % of cases
    const ALIKE: f64 = 0.8; // shapes of distinct modes, a handful of sensors: rarely above
    let (Some(a), Some(b)) = (&cluster.deviation, &mode.deviation) else {
        return false;
    };
    let apart = (cluster.medoid.frequency_hz - mode.medoid.frequency_hz).abs();
    mode.fate == Fate::Mode
        && apart <= DEVIATIONS * a.frequency_sd_hz.hypot(b.frequency_sd_hz)
        && assurance(&cluster.medoid.shape, &mode.medoid.shape) >= ALIKE
}

/// Whether `cluster` is a mixture about another mode: the record does not separate their frequencies, so that only the shapes could, and its shape is
/// complex while that of the other is nearly real. Modes of a symmetric structure may have one frequency, but both have real shapes. Of 19 modes that
/// are none, in 250 simulated records with the faults of the field, 4 were such, and none of 986 true ones (our choice).
fn mixes(cluster: &Cluster, all: &[Cluster]) -> bool {
    const COLLINEARITY_LEAST: f64 = 0.9;
    let is_real = |c: &Cluster| c.medoid.phase_collinearity >= COLLINEARITY_LEAST;
    let is_here = |other: &&Cluster| {
        let apart_hz = (cluster.medoid.frequency_hz - other.medoid.frequency_hz).abs();
        let known = cluster.frequency_sd_hz().zip(other.frequency_sd_hz());
        known.is_some_and(|(own, of_other)| apart_hz < own.hypot(of_other))
    };
    cluster.fate == Fate::Mode
        && !is_real(cluster)
        && all
            .iter()
            .filter(|other| other.fate == Fate::Mode && is_real(other))
            .any(|other| is_here(&other))
}

struct Neighbour {
    index: usize,
    distance: f64,
}

/// Clusters as indices of poles, one per order in ascending order; clusters with the most orders first.
fn group(poles: &[&JudgedPole], options: &Clustering) -> Vec<Vec<usize>> {
    let near: Vec<Vec<Neighbour>> = poles
        .iter()
        .map(|p| neighbours(&p.pole, poles, options.distance_most))
        .collect();
    let mut free = vec![true; poles.len()];
    let mut found = Vec::new();
    loop {
        let best = (0..poles.len())
            .filter(|&i| free[i])
            .map(|i| {
                let members = one_an_order(&near[i], poles, &free);
                let mean = members.iter().map(|m| m.distance).sum::<f64>() / members.len().max(1) as f64;
                (i, members.len(), mean)
            })
            .reduce(|a, b| if (b.1, -b.2) > (a.1, -a.2) { b } else { a });
        let Some((leader, ..)) = best else { break };
        let members = one_an_order(&near[leader], poles, &free);
        found.push(members.iter().map(|m| m.index).collect());
        for n in &near[leader] {
            free[n.index] = false;
        }
        free[leader] = false;
    }
    found
}

/// The members whose standard deviation is near the smallest. At some orders a pole that fits noise is so close to the mode that both are
/// inaccurate.
fn best_known<'a>(members: &[usize], poles: &[&'a JudgedPole]) -> Vec<&'a Pole> {
    const NEAR_LEAST: f64 = 1.3; // the deviations themselves are known to 13 % or so: twice that
    let sd_hz = |i: usize| poles[i].frequency_sd_hz.unwrap_or(f64::INFINITY);
    let least = members.iter().map(|&i| sd_hz(i)).fold(f64::INFINITY, f64::min);
    let near = members.iter().filter(|&&i| sd_hz(i) <= NEAR_LEAST * least);
    near.map(|&i| &poles[i].pole).collect()
}

fn medoid<'a>(poles: &[&'a Pole]) -> Option<&'a Pole> {
    let apart = |p: &Pole| -> f64 { poles.iter().map(|q| (p.root_hz() - q.root_hz()).norm()).sum() };
    poles.iter().copied().min_by(|a, b| apart(a).total_cmp(&apart(b)))
}

fn neighbours(pole: &Pole, poles: &[&JudgedPole], most: f64) -> Vec<Neighbour> {
    let root = pole.root_hz();
    let mut near = Vec::new();
    for (index, other) in poles.iter().map(|j| &j.pole).enumerate() {
        let apart = (other.root_hz() - root).norm() / root.norm();
        if apart <= most {
            let distance = apart + 1.0 - assurance(&pole.shape, &other.shape);
            if distance <= most {
                near.push(Neighbour { index, distance });
            }
        }
    }
    near
}

/// The nearest free neighbour at each order; the neighbours are sorted by order.
fn one_an_order<'a>(near: &'a [Neighbour], poles: &[&JudgedPole], free: &[bool]) -> Vec<&'a Neighbour> {
    let mut members: Vec<&Neighbour> = Vec::new();
    for n in near.iter().filter(|n| free[n.index]) {
        match members.last_mut() {
            Some(last) if poles[last.index].pole.order == poles[n.index].pole.order => {
                if n.distance < last.distance {
                    *last = n;
                }
            }
            _ => members.push(n),
        }
    }
    members
}

/// Standard deviations of frequency, Hz, and damping ratio between the orders, without outliers: low orders that merge two modes differ by
/// many standard deviations.
fn spreads(medoid: &Pole, poles: &[&Pole], deviation: Option<&PoleDeviation>) -> [f64; 2] {
    const STRAY: f64 = 4.0; // deviations: one in 16000 by chance
    let near = |p: &Pole, d: &PoleDeviation| {
        (p.frequency_hz - medoid.frequency_hz).abs() <= STRAY * d.frequency_sd_hz
            && (p.damping_ratio - medoid.damping_ratio).abs() <= STRAY * d.damping_ratio_sd
    };
    let kept = poles.iter().filter(|p| deviation.is_none_or(|d| near(p, d)));
    [
        spread(kept.clone().map(|p| p.frequency_hz)),
        spread(kept.map(|p| p.damping_ratio)),
    ]
}

fn spread(values: impl Iterator<Item = f64> + Clone) -> f64 {
    let n = values.clone().count().max(1) as f64;
    let mean = values.clone().sum::<f64>() / n;
    (values.map(|x| (x - mean).powi(2)).sum::<f64>() / n).sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn cluster(frequency_hz: f64, orders: &[usize], fate: Fate) -> Cluster {
        Cluster {
            medoid: Pole {
                order: orders[0],
                frequency_hz,
                damping_ratio: 0.01,
                shape: vec![Complex64::ONE],
                phase_collinearity: 1.0,
                phase_deviation: 0.0,
                eigenvalue: Complex64::ONE,
            },
            deviation: None,
            orders: orders.to_vec(),
            frequency_spread_hz: 0.0,
            damping_ratio_spread: 0.0,
            fate,
        }
    }

    #[test]
    fn holds_a_group_that_ends_early_and_is_damped_far_above_the_modes_is_no_mode() {
        let damped = |frequency_hz: f64, damping_ratio: f64, last: usize| {
            let orders: Vec<usize> = (2..=last).step_by(2).collect();
            let mut of = cluster(frequency_hz, &orders, Fate::Mode);
            of.medoid.damping_ratio = damping_ratio;
            of
        };
        let all = |zeta: f64, last: usize| {
            vec![
                damped(0.8, 0.051, 24),
                damped(2.35, 0.058, 24),
                damped(5.7, zeta, last),
            ]
        };
        let is_blend = |zeta: f64, last: usize| {
            let all = all(zeta, last);
            blends(&all[2], &all, 24)
        };
        assert!(is_blend(0.122, 8));
        assert!(!is_blend(0.122, 24)); // all orders show it
        assert!(!is_blend(0.079, 8)); // modes of one structure may differ so
        let few = &all(0.122, 8)[1..];
        assert!(!blends(&few[1], few, 24)); // one other says nothing
    }

    #[test]
    fn holds_a_group_between_two_modes_that_only_higher_orders_tell_apart_is_no_mode() {
        let of = |low: &[usize], high: &[usize], fate| {
            let all = [
                cluster(1.2, low, Fate::Mode),
                cluster(1.21, &[32, 40, 48, 56], Fate::Mode),
                cluster(1.22, high, fate),
            ];
            [0, 1, 2].map(|i| lumps(&all[i], &all))
        };
        assert_eq!(of(&[64, 72], &[72, 80], Fate::Mode), [false, true, false]);
        // one of them may exist before, but not both; and none may be rejected
        assert_eq!(of(&[56, 64], &[72, 80], Fate::Mode), [false, true, false]);
        assert_eq!(of(&[56, 64], &[56, 80], Fate::Mode), [false; 3]);
        assert_eq!(of(&[64, 72], &[72, 80], Fate::FewOrders), [false; 3]);
        let far = [
            cluster(1.2, &[64], Fate::Mode),
            cluster(1.21, &[32], Fate::Mode),
            cluster(1.7, &[64], Fate::Mode),
        ];
        assert!(!lumps(&far[1], &far));
    }

    #[test]
    fn holds_a_complex_shape_at_the_frequency_of_a_mode_with_a_real_one_is_no_mode() {
        let of = |frequency_hz: f64, collinearity: f64, fate: Fate| {
            let mut of = cluster(frequency_hz, &[20, 22, 24, 26], fate);
            of.medoid.phase_collinearity = collinearity;
            of.deviation = Some(PoleDeviation {
                frequency_sd_hz: 0.004,
                damping_ratio_sd: 0.003,
                shape_sd: Vec::new(),
                frequency_changes_hz: Vec::new(),
            });
            of
        };
        let mixed = |other: Cluster, own: Cluster| {
            let all = [other, own];
            [0, 1].map(|i| mixes(&all[i], &all))
        };
        let (mode, few) = (Fate::Mode, Fate::FewOrders);
        assert_eq!(mixed(of(1.17, 0.98, mode), of(1.174, 0.62, mode)), [false, true]);
        // two real shapes; two frequencies; both complex; nothing that is a mode
        assert_eq!(mixed(of(1.17, 0.98, mode), of(1.174, 0.95, mode)), [false; 2]);
        assert_eq!(mixed(of(1.17, 0.98, mode), of(1.18, 0.62, mode)), [false; 2]);
        assert_eq!(mixed(of(1.17, 0.85, mode), of(1.174, 0.62, mode)), [false; 2]);
        assert_eq!(mixed(of(1.17, 0.98, few), of(1.174, 0.62, mode)), [false; 2]);
    }

    #[test]
    fn exact_share_of_a_shape_in_the_plane_of_two() {
        let shape = |x: [f64; 3]| x.map(Complex64::from).to_vec();
        let (a, b) = (shape([1.0, 1.0, 0.0]), shape([1.0, 0.5, 0.0]));
        let in_plane = |x: [f64; 3]| share_in_plane(&shape(x), [&a, &b]);
        assert!((in_plane([0.3, -2.0, 0.0]) - 1.0).abs() < 1e-12);
        assert!((in_plane([0.6, 0.0, 0.8]) - 0.36).abs() < 1e-12);
        // two equal shapes span a line
        assert!((share_in_plane(&shape([1.0, 0.0, 0.0]), [&a, &a]) - 0.5).abs() < 1e-12);
    }
}
