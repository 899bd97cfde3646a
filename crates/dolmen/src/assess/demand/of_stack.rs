//! Seismic demand of a site on a stack: on rigid blocks by the peak ground acceleration, on elastic joints by the spectrum.

use super::by_modes::{ModalDemand, ModalRatio};
use super::{ShakenDirection, SiteDemand};
use crate::assess::LeastPressed;
use crate::assess::least_motion::first_motion;
use crate::assess::stack_on_soil::on_soil;
use crate::assess::{AssessError, StackCheck, StackCheckOptions};
use crate::blocks::{StackMode, first_sway, sway_amplification};
use crate::stability::stack::{
    DemandComparison, DemandVerdict, LimitAnalysis, LimitAnalysisStatus, OnSoil, Shaking, SpectralDemand,
    StackDemand, Threshold, compare_with_demand, limit_analysis_undilated,
};
use crate::structure::stack::Stack;

/// Result for one direction of shaking.
#[derive(Clone, Debug, PartialEq)]
pub struct StackDemandRow {
    /// The direction.
    pub direction: ShakenDirection,
    /// Least acceleration at which it begins to move in that direction, without vertical shaking; `None` if it does not stand, or is wedged.
    pub capacity: Option<Threshold>,
    /// Capacity while the vertical acceleration of the site reduces gravity; equal to `capacity` if the site has none.
    pub capacity_with_vertical: Option<Threshold>,
    /// First period in that direction, s; for any direction, the period with the larger S_a; `None` if it is unknown.
    pub period_s: Option<f64>,
    /// Largest Γ φ of the stones in that mode; for any direction, the larger of x and y.
    pub amplification: Option<f64>,
    /// Capacity with the vertical acceleration, compared with both demands as published. For elastic joints, S_a of the first mode acts on all masses
    /// equally, which can be several times too small for the upper masses.
    pub comparison: DemandComparison,
    /// Capacity on elastic joints compared with the forces of all modes; `None` if they are unknown, or if the stack does not stand without shaking.
    pub by_modes: Option<ModalRatio>,
    /// The worse verdict of rigid blocks and of elastic joints by modes. Without modes, the best verdict is unknown.
    pub verdict: DemandVerdict,
}

/// Results for a stack at a site.
#[derive(Clone, Debug, PartialEq)]
pub struct StackDemandCheck {
    /// Downward acceleration of the ground that acts at the same time, m/s²; 0 if the site gives none.
    pub vertical_acceleration_m_s2: f64,
    /// Results along x, along y, then in any direction.
    pub rows: Vec<StackDemandRow>,
    /// The worst verdict of all directions.
    pub verdict: DemandVerdict,
    /// Whether these results are for the stack without some of its static loads. They press on the stack but have no mass; without them it may
    /// resist less.
    pub without_loads: bool,
}

impl StackDemandCheck {
    /// The smallest ratio of capacity to demand, for rigid blocks and for elastic joints by modes; `None` if neither is known.
    pub fn least_ratio(&self) -> Option<f64> {
        let rigid = self.rows.iter().filter_map(|row| row.comparison.rigid.ratio);
        let elastic = self
            .rows
            .iter()
            .filter_map(|row| Some(row.by_modes.as_ref()?.ratio));
        rigid.chain(elastic).min_by(f64::total_cmp)
    }
}

/// Checks a stack at a site: the acceleration at which it begins to move, compared with the demand on rigid blocks and on elastic joints.
///
/// `modes` are those of [`stack_modes`](crate::blocks::stack_modes), if they are known. `None` if the site gives no acceleration of the ground.
///
/// ```text
/// rigid      capacity(a_z) / A_0                  a_z = −v A_0, v the vertical ratio: full value at the same time
/// published  capacity(a_z) / S_a(T₁, ζ)           in any direction the larger S_a of both
/// by modes   least of s / D over every edge and every sliding direction of every joint, s the resistance of weight and friction
///            D² = Σ_kl ρ_kl D_k D_l p_k p_l + D_0²            D_k of the forces m φ_k Γ_k S_k on all that is above, p_k = √(1 − α_k²),
///                                                             D_0 of the forces in phase with the ground: m A_0 less the modes with α = 0
///            α_k = A_0/S_k on the rising branch of the spectrum, 0 beyond; and for all modes with S_k ≥ A_0
///            the larger of both; in any direction the worst direction of shaking
/// ```
///
/// # Errors
/// [`AssessError`] if the stack cannot be checked. If a table has no value at a period, the results that need it are unknown.
///
/// # Limits
/// As for [`crate::assess::check_stack`] and [`compare_with_demand`]. The full vertical peak is combined with the full horizontal peak, which is conservative. If
/// static loads press on stones, the stack is also checked without those that hold it, and the worse result counts. Along x and y the capacity is that of the limit
/// analysis, on the soil if there is one. In the modal analysis the joints stay closed and linear until a part
/// tips or slides. In reality a corner opens earlier (in a rectangle at a third), which lengthens the periods. If stones share their load, the
/// largest force and moment of every stone act together in a limit analysis, which is conservative; "in any direction" is then the least along x and
/// y, and along the direction of least capacity, across it and along both diagonals. The stack does not amplify the vertical
/// acceleration.
///
/// # Source
/// Kim, Koo & Hong (2018), eqs 9 and 16, as published. By modes: Der Kiureghian (1981) for ρ; Lindley & Yow (1980) for the part in phase with the
/// ground.
pub fn stack_against_site(
    stack: &Stack,
    options: &StackCheckOptions,
    site: &SiteDemand,
    modes: Option<&[StackMode]>,
) -> Result<Option<StackDemandCheck>, AssessError> {
    if site.peak_ground_acceleration_m_s2.is_none() {
        return Ok(None);
    }
    let with_loads = first_motion(stack, &options.limits)?;
    let known = KnownMotion {
        with_loads,
        least_pressed: LeastPressed::of(stack, &options.limits, with_loads)?,
    };
    known_against_site(stack, options, site, modes, &known)
}

/// As [`stack_against_site`], for a stack that is checked already with the same options.
///
/// # Errors
/// Those of [`stack_against_site`].
pub fn checked_stack_against_site(
    (stack, check): (&Stack, &StackCheck),
    options: &StackCheckOptions,
    site: &SiteDemand,
    modes: Option<&[StackMode]>,
) -> Result<Option<StackDemandCheck>, AssessError> {
    let known = KnownMotion {
        with_loads: check.capacity,
        least_pressed: check.least_pressed.clone(),
    };
    known_against_site(stack, options, site, modes, &known)
}

/// Least acceleration in any direction at which a stack begins to move; `None` if it does not stand, or if nothing moves it.
struct KnownMotion {
    with_loads: Option<Threshold>,
    /// For the stack without the static loads that hold it; `None` if none presses on stones.
    least_pressed: Option<LeastPressed>,
}

fn known_against_site(
    stack: &Stack,
    options: &StackCheckOptions,
    site: &SiteDemand,
    modes: Option<&[StackMode]>,
    known: &KnownMotion,
) -> Result<Option<StackDemandCheck>, AssessError> {
    let own = || against_site(stack, options, site, modes, known.with_loads);
    let Some(least) = &known.least_pressed else {
        return own();
    };
    let without = stack.with_static_loads(&least.acts);
    let (with, free) = rayon::join(own, || {
        against_site(&without, options, site, modes, least.capacity)
    });
    let (Some(with), free) = (with?, free?) else {
        return Ok(None);
    };
    let ratio = |of: &StackDemandCheck| of.least_ratio().unwrap_or(f64::INFINITY);
    let worse = free.filter(|free| {
        let (own, other) = (severity(&free.verdict), severity(&with.verdict));
        own > other || (own == other && ratio(free) < ratio(&with))
    });
    Ok(Some(match worse {
        Some(free) => StackDemandCheck {
            without_loads: true,
            ..free
        },
        None => with,
    }))
}

fn against_site(
    stack: &Stack,
    options: &StackCheckOptions,
    site: &SiteDemand,
    modes: Option<&[StackMode]>,
    any_way: Option<Threshold>,
) -> Result<Option<StackDemandCheck>, AssessError> {
    let Some(peak) = site.peak_ground_acceleration_m_s2 else {
        return Ok(None);
    };
    let vertical = site.vertical.map_or(0.0, |vertical| vertical.ratio * peak);
    let mut lifted = options.clone();
    lifted.limits.loads.vertical_acceleration_m_s2 -= vertical;
    let weightless = lifted.limits.loads.vertical_acceleration_m_s2 <= -stack.gravity_m_s2();
    let first = [0, 1].map(|axis| {
        let modes = modes?;
        modes
            .get(first_sway(modes, axis)?)
            .filter(|mode| mode.frequency_hz > 0.0)
    });
    // outside the periods of a table, the value is unknown
    let spectral = |first: Option<&StackMode>| {
        let (period_s, damping_ratio) = (1.0 / first?.frequency_hz, site.damping_ratio);
        Some(SpectralDemand {
            period_s,
            damping_ratio,
            acceleration_m_s2: site.spectrum.acceleration_m_s2(period_s, damping_ratio).ok()?,
        })
    };
    let [along_x, along_y] = first.map(spectral);
    let amplification = [0, 1].map(|axis| Some(sway_amplification(stack, first[axis]?, axis)));
    let either = amplification[0].zip(amplification[1]).map(|(x, y)| x.max(y));
    let larger = match (along_x, along_y) {
        (Some(x), Some(y)) if x.acceleration_m_s2 >= y.acceleration_m_s2 => Some(x),
        (Some(_), Some(y)) => Some(y),
        _ => None, // an unknown one may be the larger
    };
    let mut by_modes = [None, None, None];
    if let Some(modes) = modes.filter(|_| !weightless)
        && let Ok(demand) = ModalDemand::new(stack, modes, site, peak)
    {
        let weakest = any_way.map(|threshold| threshold.direction);
        by_modes = demand.ratios(&lifted.limits, weakest)?.map(Some);
    }
    let mut rows = Vec::with_capacity(3);
    for ((direction, spectral, amplification), by_modes) in [
        (ShakenDirection::X, along_x, amplification[0]),
        (ShakenDirection::Y, along_y, amplification[1]),
        (ShakenDirection::Any, larger, either),
    ]
    .into_iter()
    .zip(by_modes)
    {
        let of = |options: &StackCheckOptions| capacity(stack, options, direction);
        let capacity = match direction {
            ShakenDirection::Any => any_way,
            _ => of(options)?,
        };
        let capacity_with_vertical = match vertical {
            _ if weightless => None,
            0.0 => capacity,
            _ => of(&lifted)?,
        };
        let demand = StackDemand {
            peak_ground_acceleration_m_s2: peak,
            spectral,
        };
        let left = match (weightless, capacity_with_vertical) {
            (true, _) => Some(0.0),
            (false, found) => found.map(|threshold| threshold.acceleration_m_s2),
        };
        let comparison = compare_with_demand(left, &demand)?;
        let by_modes = by_modes.filter(|_| spectral.is_some() && left.is_some_and(|left| left > 0.0));
        let elastic = match &by_modes {
            Some(by_modes) => by_modes.verdict,
            None => DemandVerdict::Unknown,
        };
        rows.push(StackDemandRow {
            direction,
            capacity,
            capacity_with_vertical,
            period_s: spectral.map(|spectral| spectral.period_s),
            amplification,
            verdict: worst([comparison.rigid.verdict, elastic]),
            comparison,
            by_modes,
        });
    }
    Ok(Some(StackDemandCheck {
        vertical_acceleration_m_s2: vertical,
        verdict: worst(rows.iter().map(|row| row.verdict)),
        without_loads: false,
        rows,
    }))
}

/// Below if any verdict is below; otherwise unknown if any is unknown; otherwise the worst.
fn worst(verdicts: impl IntoIterator<Item = DemandVerdict>) -> DemandVerdict {
    verdicts
        .into_iter()
        .max_by_key(severity)
        .unwrap_or(DemandVerdict::Unknown)
}

fn severity(verdict: &DemandVerdict) -> u8 {
    match verdict {
        DemandVerdict::Below => 3,
        DemandVerdict::Unknown => 2,
        DemandVerdict::Near => 1,
        DemandVerdict::Above => 0,
    }
}

/// Least acceleration at which the stack begins to move in a direction; `None` if it does not stand.
fn capacity(
    stack: &Stack,
    options: &StackCheckOptions,
    direction: ShakenDirection,
) -> Result<Option<Threshold>, AssessError> {
    let ways = match direction {
        ShakenDirection::Any => return first_motion(stack, &options.limits),
        ShakenDirection::X => [[1.0, 0.0], [-1.0, 0.0]],
        ShakenDirection::Y => [[0.0, 1.0], [0.0, -1.0]],
    };
    let soil = OnSoil::of(stack, &options.limits.loads)?;
    if !soil.stands() {
        return Ok(None);
    }
    let mut least: Option<Threshold> = None;
    for way in ways {
        let analysis = LimitAnalysis {
            loads: options.limits.loads.clone(),
            shaking: Shaking::Along(way),
            ..LimitAnalysis::default()
        };
        match limit_analysis_undilated(stack, &analysis)?.analysis.status {
            LimitAnalysisStatus::DoesNotStand => return Ok(None),
            LimitAnalysisStatus::Unlimited => {}
            LimitAnalysisStatus::Limited(found) => {
                let found = on_soil(stack, &soil, &analysis, &found)?;
                if least.is_none_or(|least| found.acceleration_m_s2 < least.acceleration_m_s2) {
                    least = Some(found);
                }
            }
        }
    }
    Ok(least)
}

#[cfg(test)]
mod tests {
    use super::super::{KoreanSite, Site, site_demand};
    use super::*;
    use crate::structure::stack::{Block, JointMaterial, Placement, Solid};

    const G: f64 = 9.80665;

    /// A stone .4 × .8 × 2 m: rocks along x at .2 g, along y at .4 g.
    fn stone() -> Stack {
        let block = Block {
            name: "stone".into(),
            solid: Solid::cuboid(0.4, 0.8, 2.0).unwrap(),
            density_kg_m3: 2600.0,
        };
        Stack::new(vec![block], JointMaterial::default(), G).unwrap()
    }

    /// Modes of a stone that sways along x and along y with these periods, without turning.
    fn modes(periods_s: &[Option<f64>; 2]) -> Vec<StackMode> {
        let along = |axis: usize| {
            let unit = |part: usize| if part == axis { 1.0 } else { 0.0 };
            Some(StackMode {
                frequency_hz: 1.0 / periods_s[axis]?,
                effective_mass_ratio: std::array::from_fn(unit),
                kinetic_energy_ratio: std::array::from_fn(unit),
                shape: vec![std::array::from_fn(unit)],
            })
        };
        [along(0), along(1)].into_iter().flatten().collect()
    }

    fn site(return_period_years: u32) -> SiteDemand {
        let site = Site::Kds17 {
            zone_factor_g: 0.11,
            return_period_years,
            soil: KoreanSite::S1,
        };
        site_demand(&site, 0.05, None).unwrap()
    }

    #[test]
    fn exact_both_ways_in_each_direction_with_the_vertical_peak() {
        // rock, 200 years: S = .0803 g; plateau 2.8 S to .3 s; v = .77
        let s = 0.11 * 0.73;
        let found = stack_against_site(
            &stone(),
            &StackCheckOptions::default(),
            &site(200),
            Some(&modes(&[Some(0.2), Some(0.6)])),
        )
        .unwrap()
        .unwrap();
        assert!((found.vertical_acceleration_m_s2 - 0.77 * s * G).abs() < 1e-12);
        let left = 1.0 - 0.77 * s;
        let [x, y, any] = &found.rows[..] else { panic!() };
        for (row, tan_alpha, spectral) in [(x, 0.2, 2.8 * s), (y, 0.4, 1.4 * s), (any, 0.2, 2.8 * s)] {
            let capacity = row.capacity.unwrap().acceleration_g;
            // usual tolerance of the limit-analysis solver: 1e-8
            assert!((capacity - tan_alpha).abs() < 1e-8, "{capacity}");
            let ratio = |comparison: crate::stability::stack::Comparison| comparison.ratio.unwrap();
            let rigid = ratio(row.comparison.rigid);
            assert!((rigid - tan_alpha * left / s).abs() < 1e-7, "{rigid}");
            let elastic = ratio(row.comparison.elastic.unwrap());
            assert!((elastic - tan_alpha * left / spectral).abs() < 1e-7, "{elastic}");
            // one mode with all of the mass: the same by modes
            let by_modes = row.by_modes.as_ref().unwrap();
            assert!((by_modes.ratio / elastic - 1.0).abs() < 1e-7, "{by_modes:?}");
        }
        assert_eq!(x.comparison.rigid.verdict, DemandVerdict::Above);
        assert_eq!(x.comparison.verdict, DemandVerdict::Below); // .2 · .938 / .2248
        assert_eq!(y.comparison.verdict, DemandVerdict::Above);
        assert_eq!(any.period_s, Some(0.2));
        assert_eq!(found.verdict, DemandVerdict::Below);
    }

    #[test]
    fn holds_an_unknown_period_is_never_above_demand() {
        let options = StackCheckOptions::default();
        let found = stack_against_site(&stone(), &options, &site(50), Some(&modes(&[Some(0.5), None])));
        let found = found.unwrap().unwrap();
        assert_eq!(found.rows[0].verdict, DemandVerdict::Above);
        assert_eq!(found.rows[1].verdict, DemandVerdict::Unknown);
        assert_eq!(found.rows[2].period_s, None);
        assert_eq!(found.verdict, DemandVerdict::Unknown);
    }

    #[test]
    fn exact_ground_that_falls_faster_than_stone_leaves_nothing() {
        let table = Site::Table {
            source: "made up".into(),
            points: vec![[0.0, 1.2 * G], [2.0, G]],
            damping_ratio: 0.05,
            peak_ground_acceleration_m_s2: None,
        };
        let demand = site_demand(&table, 0.05, Some(1.0)).unwrap();
        let options = StackCheckOptions::default();
        let found = stack_against_site(&stone(), &options, &demand, None)
            .unwrap()
            .unwrap();
        assert!(
            found
                .rows
                .iter()
                .all(|row| row.comparison.rigid.ratio == Some(0.0))
        );
        assert_eq!(found.verdict, DemandVerdict::Below);
    }

    #[test]
    fn exact_the_weaker_way_along_an_axis_counts_whichever_it_is() {
        // two cubes, the upper shifted by .1 m along x and .04 m along y: their common centroid is shifted by half of that, .4 m up
        let shifted = |x: f64, y: f64| {
            let cube = |z: f64, x: f64, y: f64| Block {
                name: format!("at {z}"),
                solid: Solid::cuboid(0.4, 0.4, 0.4).unwrap().placed(&Placement {
                    position_m: [x, y, z],
                    ..Placement::default()
                }),
                density_kg_m3: 2600.0,
            };
            let blocks = vec![cube(0.0, 0.0, 0.0), cube(0.4, x, y)];
            let stack = Stack::new(blocks, JointMaterial::with_friction(0.9), G).unwrap();
            let options = StackCheckOptions::default();
            let found = stack_against_site(&stack, &options, &site(50), None)
                .unwrap()
                .unwrap();
            [0, 1].map(|row| found.rows[row].capacity.unwrap().acceleration_g)
        };
        for (x, y) in [(0.1, 0.04), (-0.1, 0.04), (0.1, -0.04), (-0.1, -0.04)] {
            let found = shifted(x, y);
            for (capacity, wanted) in found.into_iter().zip([0.15 / 0.4, 0.18 / 0.4]) {
                assert!((capacity - wanted).abs() < 1e-7, "{x} {y}: {found:?}");
            }
        }
    }

    #[test]
    fn holds_below_is_worse_than_unknown_and_unknown_than_near() {
        use DemandVerdict::{Above, Below, Near, Unknown};
        for (one, other, wanted) in [
            (Below, Unknown, Below),
            (Near, Unknown, Unknown),
            (Above, Unknown, Unknown),
            (Above, Near, Near),
            (Near, Below, Below),
        ] {
            assert_eq!(worst([one, other]), wanted);
            assert_eq!(worst([other, one]), wanted);
        }
    }
}
