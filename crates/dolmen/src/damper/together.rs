//! Several dampers of any kind together: their effect, and their joint tuning at fixed positions.
//!
//! The unknowns are logarithms: frequency and damping ratio of a tuned mass or liquid column, both pairs for a liquid column mass damper, and
//! optionally the coefficient of a dashpot.

use super::damper_coupling::{Coupling, DamperRow};
use super::damper_slopes::{MovedDampers, pieces_of};
use super::single_damper::DAMPING_MOST;
use super::{AttachedDamper, DamperError, DamperKind, DesignEnd, Freedom, Goal, Judged, Plan, judge};
use crate::numeric::{Minimax, Piece, Worst, minimax};

/// Options for the joint tuning of dampers.
#[derive(Clone, Debug, PartialEq)]
pub struct TogetherOptions {
    /// The quantity to minimise: [`Goal::LargestRms`] or [`Goal::MeanSquare`].
    pub goal: Goal,
    /// Upper bound of the standard deviation of each damper's stroke, m; empty for no bound.
    pub stroke_rms_most_m: Vec<f64>,
    /// Whether the coefficients of dashpots are unknowns too; default: fixed. A larger dashpot is better until it acts as a rigid strut, so
    /// its price must decide.
    pub coefficients: Freedom,
    /// Largest number of steps of one search; default 60 (our choice).
    pub iterations_most: usize,
}

impl Default for TogetherOptions {
    fn default() -> Self {
        TogetherOptions {
            goal: Goal::LargestRms,
            stroke_rms_most_m: Vec::new(),
            coefficients: Freedom::Kept,
            iterations_most: 60,
        }
    }
}

/// Result of tuning dampers together.
#[derive(Clone, Debug, PartialEq)]
pub struct Together {
    /// The dampers with their tuning.
    pub dampers: Vec<AttachedDamper>,
    /// Standard deviations of points and strokes, from the assembled matrices.
    pub judged: Judged,
    /// Value of the goal.
    pub cost: f64,
    /// The end of the search.
    pub end: DesignEnd,
}

/// Largest ratio between a tuned and the given frequency, either way.
const FREQUENCY_FACTOR_MOST: f64 = 2.0;
/// Largest ratio between a tuned and the given coefficient of a dashpot, either way.
const COEFFICIENT_FACTOR_MOST: f64 = 1e3;
/// Relative shift of the frequencies in the second start, alternately down and up, so that equal dampers separate.
const APART: f64 = 0.06;
/// Slope of the penalty on a stroke above its bound: ln of the cost per ln of the stroke.
const STROKE_PRICE: f64 = 50.0;
/// Length of the last step below which the search counts as converged.
const LAST_STEP_MOST: f64 = 1e-6;

/// Tunes all dampers together, at fixed positions, so that the goal is smallest.
///
/// # Errors
/// [`DamperError`] if a damper is outside its range or on a floor that the plan does not list, or if the goal is a peak.
///
/// # Limits
/// Finds a local optimum, the better one of two searches: from the given tunings, and from the same tunings with the frequencies shifted by 6
/// %. Frequencies stay within a factor of 2 of the given ones, coefficients of dashpots within a factor of 1000. Tested by `damper_designs`.
pub fn tune_together(
    plan: &Plan,
    start: &[AttachedDamper],
    options: &TogetherOptions,
) -> Result<Together, DamperError> {
    if options.goal == Goal::LargestPeak {
        return Err(DamperError::NoMap);
    }
    let damper_rows = plan.damper_rows_of(start)?;
    let mut search = Search {
        plan,
        start,
        couplings: plan.couplings(&damper_rows),
        damper_rows,
        options,
    };
    let given = search.unknowns();
    let mut starts = vec![given.clone()];
    let mut side = 1.0;
    let mut parted = given;
    for (x, knob) in parted.iter_mut().zip(search.knobs()) {
        if let Knob::Frequency(_) = knob {
            *x += side * APART;
            side = -side;
        }
    }
    if start.len() > 1 {
        starts.push(parted);
    }
    let how = Minimax::steps(options.iterations_most);
    let found = starts.into_iter().filter_map(|x| minimax(x, &how, &mut search));
    let least = found.reduce(|best, next| if next.worst < best.worst { next } else { best });
    let least = least.ok_or(DamperError::NoOptimum {
        what: "the dampers' tunings together",
        iterations: 0,
    })?;
    let dampers = search.dampers(&least.x);
    let limits = search.knobs().into_iter().map(|knob| search.limits(knob));
    let at_limit = limits
        .zip(&least.x)
        .any(|([low, high], x)| *x <= low || *x >= high);
    let judged = plan.exact_attached(&dampers)?;
    Ok(Together {
        cost: cost_of(&judged, options.goal),
        judged,
        dampers,
        end: match (at_limit, least.last_step <= LAST_STEP_MOST) {
            (true, _) => DesignEnd::Limit,
            (false, true) => DesignEnd::Optimum,
            (false, false) => DesignEnd::Stalled,
        },
    })
}

/// The goal from standard deviations: the largest, or the root mean square.
pub fn cost_of(judged: &Judged, goal: Goal) -> f64 {
    let rms = &judged.point_rms;
    match goal {
        Goal::MeanSquare => (rms.iter().map(|rms| rms * rms).sum::<f64>() / rms.len() as f64).sqrt(),
        Goal::LargestRms | Goal::LargestPeak => rms.iter().copied().fold(0.0, f64::max),
    }
}

impl Plan {
    /// Standard deviations of the points and strokes with dampers of any kind, from the assembled matrices.
    ///
    /// # Errors
    /// [`DamperError`] if a damper is outside its range.
    pub fn exact_attached(&self, dampers: &[AttachedDamper]) -> Result<Judged, DamperError> {
        let problem = self.problem();
        let all: Vec<AttachedDamper> = dampers.iter().chain(&problem.fixed).cloned().collect();
        let mut judged = judge(&problem.structure, &problem.loads, &problem.points, &all)?;
        judged.stroke_rms_m.truncate(dampers.len());
        Ok(judged)
    }
}

#[derive(Clone, Copy)]
enum Knob {
    Frequency(usize),
    Damping(usize),
    LiquidFrequency(usize),
    LiquidDamping(usize),
    Coefficient(usize),
}

struct Search<'a> {
    plan: &'a Plan,
    start: &'a [AttachedDamper],
    damper_rows: Vec<DamperRow>,
    /// Positions are fixed, so the couplings are computed once.
    couplings: Vec<Coupling>,
    options: &'a TogetherOptions,
}

impl Search<'_> {
    fn knobs(&self) -> Vec<Knob> {
        let each = self
            .start
            .iter()
            .enumerate()
            .map(|(k, damper)| match damper.kind {
                DamperKind::TunedMass { .. } | DamperKind::LiquidColumn { .. } => {
                    vec![Knob::Frequency(k), Knob::Damping(k)]
                }
                DamperKind::LiquidColumnMass { .. } => vec![
                    Knob::Frequency(k),
                    Knob::Damping(k),
                    Knob::LiquidFrequency(k),
                    Knob::LiquidDamping(k),
                ],
                DamperKind::Viscous { .. } => match self.options.coefficients {
                    Freedom::Free => vec![Knob::Coefficient(k)],
                    Freedom::Kept => Vec::new(),
                },
            });
        each.collect::<Vec<_>>().concat()
    }

    fn given(&self, knob: Knob) -> f64 {
        let mut kinds: Vec<DamperKind> = self.start.iter().map(|damper| damper.kind).collect();
        value(&mut kinds, knob).map_or(f64::NAN, |value| *value)
    }

    /// ln of the smallest and largest allowed value.
    fn limits(&self, knob: Knob) -> [f64; 2] {
        let given = self.given(knob);
        match knob {
            Knob::Frequency(_) | Knob::LiquidFrequency(_) => {
                let reach = FREQUENCY_FACTOR_MOST.ln();
                [given.ln() - reach, given.ln() + reach]
            }
            Knob::Damping(_) | Knob::LiquidDamping(_) => [self.plan.damping_least().ln(), DAMPING_MOST.ln()],
            Knob::Coefficient(_) => {
                let reach = COEFFICIENT_FACTOR_MOST.ln();
                [given.ln() - reach, given.ln() + reach]
            }
        }
    }

    fn unknowns(&self) -> Vec<f64> {
        let each = self.knobs().into_iter().map(|knob| match knob {
            Knob::Damping(_) | Knob::LiquidDamping(_) => {
                self.given(knob).max(1.001 * self.plan.damping_least()).ln()
            }
            _ => self.given(knob).ln(),
        });
        each.collect()
    }

    fn kinds(&self, x: &[f64]) -> Vec<DamperKind> {
        let mut kinds: Vec<DamperKind> = self.start.iter().map(|damper| damper.kind).collect();
        for (knob, x) in self.knobs().into_iter().zip(x) {
            let [low, high] = self.limits(knob);
            if let Some(of) = value(&mut kinds, knob) {
                *of = x.clamp(low, high).exp();
            }
        }
        kinds
    }

    fn dampers(&self, x: &[f64]) -> Vec<AttachedDamper> {
        let pairs = self.kinds(x).into_iter().zip(self.start);
        pairs
            .map(|(kind, damper)| AttachedDamper {
                kind,
                row: damper.row.clone(),
            })
            .collect()
    }

    fn rows(&self, x: &[f64]) -> Vec<DamperRow> {
        let each = self.damper_rows.iter().zip(self.kinds(x));
        each.map(|(row, kind)| DamperRow {
            row: row.row.clone(),
            kind,
        })
        .collect()
    }

    /// ln of each function whose maximum the search minimises.
    fn values(&self, judged: &Judged) -> Option<Vec<f64>> {
        let mut values = match self.options.goal {
            Goal::MeanSquare => vec![cost_of(judged, Goal::MeanSquare).ln()],
            _ => judged.point_rms.iter().map(|rms| rms.ln()).collect(),
        };
        let own = values.clone();
        for (stroke, most) in judged.stroke_rms_m.iter().zip(&self.options.stroke_rms_most_m) {
            let price = STROKE_PRICE * (stroke / most).ln();
            values.extend(own.iter().map(|value| value + price));
        }
        values.iter().all(|value| value.is_finite()).then_some(values)
    }
}

fn value(kinds: &mut [DamperKind], knob: Knob) -> Option<&mut f64> {
    let (Knob::Frequency(k)
    | Knob::Damping(k)
    | Knob::LiquidFrequency(k)
    | Knob::LiquidDamping(k)
    | Knob::Coefficient(k)) = knob;
    match (kinds.get_mut(k)?, knob) {
        (
            DamperKind::TunedMass { frequency_hz, .. }
            | DamperKind::LiquidColumn { frequency_hz, .. }
            | DamperKind::LiquidColumnMass { frequency_hz, .. },
            Knob::Frequency(_),
        ) => Some(frequency_hz),
        (
            DamperKind::TunedMass { damping_ratio, .. }
            | DamperKind::LiquidColumn { damping_ratio, .. }
            | DamperKind::LiquidColumnMass { damping_ratio, .. },
            Knob::Damping(_),
        ) => Some(damping_ratio),
        (
            DamperKind::LiquidColumnMass {
                liquid_frequency_hz, ..
            },
            Knob::LiquidFrequency(_),
        ) => Some(liquid_frequency_hz),
        (
            DamperKind::LiquidColumnMass {
                liquid_damping_ratio, ..
            },
            Knob::LiquidDamping(_),
        ) => Some(liquid_damping_ratio),
        (DamperKind::Viscous { coefficient_n_s_m }, Knob::Coefficient(_)) => Some(coefficient_n_s_m),
        _ => None,
    }
}

impl Worst for Search<'_> {
    fn worst(&mut self, x: &[f64]) -> Option<f64> {
        let judged = self.plan.coupled_at_nodes(&self.couplings, &self.rows(x));
        self.values(&judged)?.into_iter().reduce(f64::max)
    }

    fn pieces(&mut self, x: &[f64]) -> Option<Vec<Piece>> {
        let moved = MovedDampers::of_each(x, |x| self.rows(x));
        let found = self
            .plan
            .slopes_at_nodes(Some(&self.couplings), &self.rows(x), &moved)?;
        pieces_of(&[found], |judged| self.values(&judged[0]))
    }
}
