//! Limit analysis of one piece of a stack as a conic programme: the accelerations at which its joints can be in equilibrium.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | a | `acceleration` | horizontal acceleration of the inertia forces, over gravity | – |
//! | ν | `towards` | unit vector along which the acceleration is maximised | – |
//! | f | `z` | forces at the corners of joints, each in Coulomb's cone, and in ties, over the weight | – |
//! | v | `x` | velocities and angular velocities of the blocks: a mechanism | – |
//! | A_most | `ACCELERATION_MOST` | upper bound of the search | – |

use super::chosen_toes::ChosenToes;
use super::limit_build::Build;
use super::limit_pushes::Push;
use crate::stability::StabilityError;
use clarabel::algebra::CscMatrix;
use clarabel::solver::{DefaultSettings, DefaultSolver, IPSolver, SolverStatus, SupportedConeT};

/// Acceleration over gravity above which the result is unlimited. Our choice: far above any ground motion.
pub(super) const ACCELERATION_MOST: f64 = 10.0;
/// Tolerance of the solver, over the weight. Our choice: one or two steps more than its default 1e-8.
const SOUGHT: f64 = 1e-10;
/// Tolerance for a rough result. Our choice: several steps fewer.
const SOUGHT_ROUGH: f64 = 1e-7;
/// Largest accepted error of the force balance, of the cones and of the gap between both bounds, over the weight. Our choice; the usual error
/// is 1e-9.
const MISSED_MOST: f64 = 1e-6;
/// Largest overload of a stress block that is left out, over the size of the mechanism. Our choice: the usual error of a solution.
const OVERLOADED_MOST: f64 = 1e-9;
/// Coefficients (of order 1) below this are rounding errors and are left out. Our choice.
const ROUNDING: f64 = 1e-13;

/// Set of accelerations in the search.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum AccelerationSet {
    /// The whole horizontal plane.
    Plane,
    /// Multiples of one direction.
    Line([f64; 2]),
}

/// Result of one solution.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) enum ProgrammeOutcome {
    /// The largest acceleration along `towards` in equilibrium.
    Reaches(Support),
    /// No acceleration is in equilibrium with possible forces.
    Falls,
}

/// The farthest point in a direction of the set of accelerations in equilibrium, with its certificate.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(super) struct Support {
    /// The point; forces in equilibrium exist for it, so it is a lower bound.
    pub(super) point: [f64; 2],
    /// Largest value along the direction from a mechanism: an upper bound.
    pub(super) bound: f64,
    /// Largest error of the force balance or cones, and the gap between both bounds.
    pub(super) missed: f64,
}

/// A conic programme that can be solved for any direction.
///
/// ```text
/// forces      maximise ν·a over f, a:   Σ G f + load + a·m = 0,  f in its cones,  |a| ≤ A_most
/// mechanism   minimise −load·v + Σ strength·|slip| + Σ crushing + A_most |ν − m·v| over v:  Gᵀ v in the dual cones
/// ```
///
/// The solver treats both problems together; the agreement of their values is the certificate. Of the stress blocks of a joint it takes a few,
/// and adds those that a mechanism overloads until it overloads none: the solution is then that of all (column generation).
pub(super) struct Programme<'a> {
    terms: Terms<'a>,
    chosen: ChosenToes,
    solver: DefaultSolver<f64>,
    /// Whether the solver has other settings, after an attempt that missed.
    is_other: bool,
    conic: Conic,
}

/// The conic programme as the solver takes it: minimise costs·x with right − A x in the cones.
struct Conic {
    matrix: CscMatrix<f64>,
    costs: Vec<f64>,
    right: Vec<f64>,
    cones: Vec<SupportedConeT<f64>>,
}

impl Conic {
    fn of(build: Build) -> Self {
        Conic {
            matrix: build.matrix(),
            right: vec![0.0; build.next],
            costs: build.costs,
            cones: build.cones,
        }
    }

    fn solver(&self, settings: DefaultSettings<f64>) -> DefaultSolver<f64> {
        let none = CscMatrix::zeros((self.matrix.n, self.matrix.n));
        let Conic {
            matrix,
            costs,
            right,
            cones,
        } = self;
        DefaultSolver::new(&none, costs, matrix, right, cones, settings)
    }
}

/// What a programme is built from.
pub(super) struct Terms<'a> {
    /// The loads at rest [rows].
    pub(super) at_rest: &'a [f64],
    /// The loads of 1 g along x and y [rows].
    pub(super) shaking: [&'a [f64]; 2],
    /// The possible forces.
    pub(super) pushes: &'a [Push],
    pub(super) within: AccelerationSet,
    pub(super) settings: DefaultSettings<f64>,
}

impl Terms<'_> {
    /// The programme with some of the stress blocks.
    fn build(&self, chosen: &ChosenToes) -> Build {
        let rows = self.at_rest.len();
        let mut build = Build {
            columns: vec![Vec::new(); rows + 1],
            costs: self
                .at_rest
                .iter()
                .map(|load| -load)
                .chain([ACCELERATION_MOST])
                .collect(),
            cones: Vec::new(),
            next: 0,
        };
        let mut add = |ways: &[[f64; 2]]| {
            build.columns[rows].push((build.next, -1.0));
            build.next += 1;
            for way in ways {
                for (row, (x, y)) in self.shaking[0].iter().zip(self.shaking[1]).enumerate() {
                    let value = way[0] * x + way[1] * y;
                    if value.abs() > ROUNDING {
                        build.columns[row].push((build.next, -value));
                    }
                }
                build.next += 1;
            }
            build.cones.push(SupportedConeT::SecondOrderConeT(ways.len() + 1));
        };
        match self.within {
            AccelerationSet::Plane => add(&[[1.0, 0.0], [0.0, 1.0]]),
            AccelerationSet::Line(way) => add(&[way]),
        }
        for (push, (toes, discs)) in self.pushes.iter().zip(chosen.of_pushes()) {
            build.push(push, toes, discs);
        }
        build
    }
}

impl<'a> Programme<'a> {
    /// Builds the programme.
    pub(super) fn new(terms: Terms<'a>) -> Self {
        let chosen = ChosenToes::first(terms.pushes);
        Programme::with(terms, chosen)
    }

    /// Builds the programme with these stress blocks.
    pub(super) fn with(terms: Terms<'a>, chosen: ChosenToes) -> Self {
        let conic = Conic::of(terms.build(&chosen));
        Programme {
            solver: conic.solver(terms.settings.clone()),
            terms,
            chosen,
            is_other: false,
            conic,
        }
    }

    /// The stress blocks that it has.
    pub(super) fn into_chosen(self) -> ChosenToes {
        self.chosen
    }

    /// Builds the programme again, with the stress blocks chosen since.
    fn renew(&mut self) {
        self.conic = Conic::of(self.terms.build(&self.chosen));
        self.solver = self.conic.solver(self.terms.settings.clone());
        self.is_other = false;
    }

    /// Number of unknown forces and accelerations, with all stress blocks.
    pub(super) fn unknowns(&self) -> usize {
        self.conic.right.len() + self.chosen.unknowns_left_out(self.terms.pushes)
    }

    /// The programme with all stress blocks.
    #[cfg(test)]
    pub(super) fn with_all_toes(mut self) -> Self {
        self.chosen.all(self.terms.pushes);
        self.renew();
        self
    }

    /// Number of unknown forces and accelerations that are included.
    #[cfg(test)]
    pub(super) fn rows(&self) -> usize {
        self.conic.right.len()
    }

    /// Number of stress blocks that are not included.
    #[cfg(test)]
    pub(super) fn left_out(&self) -> usize {
        self.chosen.left_out(self.terms.pushes)
    }

    /// Largest acceleration along ν in equilibrium.
    pub(super) fn support(&mut self, towards: [f64; 2]) -> Result<ProgrammeOutcome, StabilityError> {
        loop {
            let found = self.support_of_chosen(towards);
            let x = &self.solver.solution.x;
            let most = match &found {
                // the scale of a mechanism that falls is the energy that it gains
                Ok(ProgrammeOutcome::Falls) => -dot(&self.conic.costs, x) * MISSED_MOST,
                _ => OVERLOADED_MOST * x.iter().fold(1.0_f64, |most, value| most.max(value.abs())),
            };
            let is_more = match found {
                Err(_) => self.chosen.all(self.terms.pushes),
                Ok(_) => self
                    .chosen
                    .add_overloaded(self.terms.pushes, x, self.terms.at_rest.len() + 1, most),
            };
            if !is_more {
                return found;
            }
            self.renew();
        }
    }

    /// The same with the stress blocks chosen so far.
    fn support_of_chosen(&mut self, towards: [f64; 2]) -> Result<ProgrammeOutcome, StabilityError> {
        match self.terms.within {
            AccelerationSet::Plane => self.conic.right[1..3].copy_from_slice(&towards.map(|part| -part)),
            AccelerationSet::Line(way) => self.conic.right[1] = -(way[0] * towards[0] + way[1] * towards[1]),
        }
        if std::mem::take(&mut self.is_other) {
            self.solver = self.conic.solver(self.terms.settings.clone());
        } else {
            let updated = self.solver.update_b(&self.conic.right);
            updated.map_err(|fault| refused(&fault.to_string()))?;
        }
        self.solver.solve();
        let mut found = self.certified(towards);
        for settings in other_attempts() {
            if found.is_ok() {
                return found;
            }
            self.is_other = true;
            self.solver = self.conic.solver(settings);
            self.solver.solve();
            found = self.certified(towards).or(found);
        }
        found
    }

    /// The result of the last solution, if its forces and its mechanism agree.
    fn certified(&self, towards: [f64; 2]) -> Result<ProgrammeOutcome, StabilityError> {
        let solution = &self.solver.solution;
        if matches!(
            solution.status,
            SolverStatus::DualInfeasible | SolverStatus::AlmostDualInfeasible
        ) {
            return self.falls();
        }
        let (x, z) = (&solution.x, &solution.z);
        let point = match self.terms.within {
            AccelerationSet::Plane => [z[1], z[2]],
            AccelerationSet::Line(way) => [z[1] * way[0], z[1] * way[1]],
        };
        let reached = point[0] * towards[0] + point[1] * towards[1];
        let bound = dot(&self.conic.costs, x);
        let size = x.iter().fold(1.0_f64, |most, value| most.max(value.abs()));
        let missed = (self.balance_missed(z).max(self.outside(z, 0.0)))
            .max(self.outside(&self.slips(x, 1.0), 1.0) / size)
            .max((bound - reached).abs());
        // `max` ignores NaN
        let numbers = x.iter().chain(z).all(|value| value.is_finite());
        if missed > MISSED_MOST || !numbers {
            return Err(refused(&format!(
                "{:?} after {} steps, its forces and its mechanism miss each other or the balance by {missed:.1e} of the weight, more than {MISSED_MOST:e}",
                solution.status, solution.iterations
            )));
        }
        Ok(ProgrammeOutcome::Reaches(Support { point, bound, missed }))
    }

    /// Velocities of the mechanism in which the piece falls for any acceleration along ν, or for the smallest acceleration in the opposite
    /// direction; `None` if the piece stands.
    pub(super) fn falling_velocities(
        &mut self,
        towards: [f64; 2],
    ) -> Result<Option<Vec<f64>>, StabilityError> {
        for way in [towards, towards.map(|part| -part)] {
            match self.support(way)? {
                ProgrammeOutcome::Reaches(support) if support.bound > 0.0 => {}
                _ => return Ok(Some(self.velocities().to_vec())),
            }
        }
        Ok(None)
    }

    /// Velocities of the last solution.
    pub(super) fn velocities(&self) -> &[f64] {
        &self.solver.solution.x[..self.terms.at_rest.len()]
    }

    /// The force of each push in the last solution, in its unit: along the first axis of its link, and the components that its columns across
    /// that axis multiply.
    pub(super) fn forces(&self) -> Vec<[f64; 3]> {
        let z = &self.solver.solution.z;
        let mut row = match self.terms.within {
            AccelerationSet::Plane => 3,
            AccelerationSet::Line(_) => 2,
        };
        let mut forces = Vec::with_capacity(self.terms.pushes.len());
        for (push, (toes, discs)) in self.terms.pushes.iter().zip(self.chosen.of_pushes()) {
            let (force, rows) = match push {
                Push::Cone(_) => ([z[row], z[row + 1], z[row + 2]], 3),
                Push::Normal(_) => ([z[row], 0.0, 0.0], 1),
                Push::Toes(_) => {
                    let each = z[row + 1..row + 1 + 3 * toes.len()].chunks_exact(3);
                    let sum = each.fold([0.0; 3], |sum, toe| std::array::from_fn(|k| sum[k] + toe[k]));
                    (sum, 1 + 3 * toes.len())
                }
                Push::Held(_) => {
                    let each = z[row..row + 3 * discs.len()].chunks_exact(3);
                    let sum = each.zip(discs).fold([0.0; 2], |sum, (force, disc)| {
                        let [x, y] = disc.resultant([force[1], force[2]]);
                        [sum[0] + x, sum[1] + y]
                    });
                    ([0.0, sum[0], sum[1]], 3 * discs.len())
                }
                Push::Disc(_, strength) => {
                    let first = row + usize::from(strength.is_finite());
                    ([0.0, z[first], z[first + 1]], first + 2 - row)
                }
                Push::Pull(_, strength) => ([0.0; 3], 1 + usize::from(strength.is_finite())),
            };
            forces.push(force);
            row += rows;
        }
        forces
    }

    /// Checks and returns a mechanism that gains energy for any acceleration.
    fn falls(&self) -> Result<ProgrammeOutcome, StabilityError> {
        let x = &self.solver.solution.x;
        let gains = -dot(&self.conic.costs, x);
        let outside = self.outside(&self.slips(x, 0.0), 1.0);
        if gains > 0.0 && outside <= MISSED_MOST * gains {
            return Ok(ProgrammeOutcome::Falls);
        }
        Err(refused(&format!(
            "a mechanism that falls is outside the joints by {outside:e}, and gains {gains:e}"
        )))
    }

    /// Openings and slips of a mechanism: share·b − A x.
    fn slips(&self, x: &[f64], share: f64) -> Vec<f64> {
        let mut slips: Vec<f64> = self.conic.right.iter().map(|right| share * right).collect();
        for (column, value) in x.iter().enumerate() {
            for at in self.conic.matrix.colptr[column]..self.conic.matrix.colptr[column + 1] {
                slips[self.conic.matrix.rowval[at]] -= self.conic.matrix.nzval[at] * value;
            }
        }
        slips
    }

    /// Residual of the force balance: the largest |Aᵀ z + q|.
    fn balance_missed(&self, z: &[f64]) -> f64 {
        let mut most = 0.0_f64;
        for (column, cost) in self.conic.costs.iter().enumerate() {
            let entries = self.conic.matrix.colptr[column]..self.conic.matrix.colptr[column + 1];
            let sum: f64 = entries
                .map(|at| self.conic.matrix.nzval[at] * z[self.conic.matrix.rowval[at]])
                .sum();
            most = most.max((sum + cost).abs());
        }
        most
    }

    /// Distance of a vector from the cones. Every cone is its own dual, except the cone without slip (`fixed`: 1 for slips, 0 for forces, which
    /// are free).
    fn outside(&self, vector: &[f64], fixed: f64) -> f64 {
        let (mut most, mut row) = (0.0_f64, 0);
        for cone in &self.conic.cones {
            let length = match cone {
                SupportedConeT::SecondOrderConeT(length) => {
                    let across = vector[row + 1..row + length].iter().map(|part| part * part);
                    most = most.max(across.sum::<f64>().sqrt() - vector[row]);
                    *length
                }
                SupportedConeT::NonnegativeConeT(length) => {
                    for part in &vector[row..row + length] {
                        most = most.max(-part);
                    }
                    *length
                }
                SupportedConeT::ZeroConeT(length) => {
                    for part in &vector[row..row + length] {
                        most = most.max(fixed * part.abs());
                    }
                    *length
                }
                _ => 0,
            };
            row += length;
        }
        most
    }
}

pub(super) fn settings() -> DefaultSettings<f64> {
    DefaultSettings {
        verbose: false,
        presolve_enable: false,
        tol_gap_abs: SOUGHT,
        tol_gap_rel: SOUGHT,
        tol_feas: SOUGHT,
        ..DefaultSettings::default()
    }
}

/// Settings of further attempts after a solution that missed by more than [`MISSED_MOST`], each with another path to the same optimum: unscaled, with
/// a stronger regularization, with shorter steps, with a weaker regularization. The first three meet it where the usual settings miss it by 15 %.
fn other_attempts() -> [DefaultSettings<f64>; 4] {
    [
        DefaultSettings {
            equilibrate_enable: false,
            ..settings()
        },
        DefaultSettings {
            static_regularization_constant: 1e-6,
            ..settings()
        },
        DefaultSettings {
            max_step_fraction: 0.7,
            ..settings()
        },
        DefaultSettings {
            static_regularization_constant: 1e-10,
            ..settings()
        },
    ]
}

/// Solver settings for a result of which only the sign matters.
pub(super) fn rough() -> DefaultSettings<f64> {
    DefaultSettings {
        tol_gap_abs: SOUGHT_ROUGH,
        tol_gap_rel: SOUGHT_ROUGH,
        tol_feas: SOUGHT_ROUGH,
        ..settings()
    }
}

/// Velocities [rows] of the mechanism with the largest gain while its corners together open by 1. It is the dual of the smallest tension, equal
/// at every corner, that would be in equilibrium with the loads at rest. `None` if the gain is only rounding.
pub(super) fn least_pull(
    at_rest: &[f64],
    pushes: &[Push],
    units: &[f64],
) -> Result<Option<Vec<f64>>, StabilityError> {
    let rows = at_rest.len();
    let mut build = Build {
        columns: vec![Vec::new(); rows],
        costs: at_rest.iter().map(|load| -load).collect(),
        cones: Vec::new(),
        next: 0,
    };
    let most = units.iter().copied().fold(0.0, f64::max);
    let mut opens = vec![0.0; rows];
    for (push, unit) in pushes.iter().zip(units) {
        build.push(push, &[], &[]);
        if let Push::Cone([normal, ..]) | Push::Normal(normal) = push {
            for &(row, value) in normal {
                opens[row] -= value * most / unit;
            }
        }
    }
    let opens = opens.into_iter().enumerate();
    build.row(&opens.filter(|(_, value)| value.abs() > ROUNDING).collect());
    build.cones.push(SupportedConeT::NonnegativeConeT(1));
    let mut conic = Conic::of(build);
    if let Some(opening) = conic.right.last_mut() {
        *opening = 1.0;
    }
    let mut solver = conic.solver(settings());
    solver.solve();
    let solution = &solver.solution;
    if !matches!(solution.status, SolverStatus::Solved | SolverStatus::AlmostSolved) {
        return Err(refused(&format!(
            "{:?} after {} steps, while looking for the mechanism that falls",
            solution.status, solution.iterations
        )));
    }
    let gains = -dot(&conic.costs, &solution.x);
    Ok((gains > MISSED_MOST).then(|| solution.x[..rows].to_vec()))
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn refused(reason: &str) -> StabilityError {
    StabilityError::ConicProgramme {
        reason: reason.to_owned(),
    }
}
