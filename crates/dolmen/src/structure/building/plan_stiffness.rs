//! Stiffness of one storey in plan, and its eccentricity, from the three frequencies of its floor.
//!
//! | symbol | code | meaning | unit |
//! |:--|:--|:--|:--|
//! | m, ρ | `mass_kg`, `gyration_m` | mass of the floor and its radius of gyration about the centre of mass | kg, m |
//! | w | `weight_takes_n_m` | reduction of the sway stiffness by P-delta, m g/h; 0 without P-delta | N/m |
//! | e_x, e_y | `eccentricity_m` | position of the centre of rigidity relative to the centre of mass | m |
//! | k_x, k_y, k_θ | `stiffness` | along x, along y, against rotation about the centre of rigidity | N/m, N·m/rad |
//! | t | `twist` | ρθ/u of the mode along x, ρθ/v of the mode along y, at the centre of mass | – |
//! | λ_j | | (2π f_j)² | (rad/s)² |

use super::plan_double_root::{DoubleRoot, double_root};
use super::plan_roots::{PlanRoot, roots_with_shapes, roots_with_stated_centre};
use super::plan_scatter::scatter;
use super::plan_storey::{EccentricityFrom, Labelled, PlanMode, PlanMotion, PlanStiffnessError, PlanStorey};

/// Frequencies closer than this fraction are equal: the shapes of coupled sway and twist are then not unique.
const REPEATED: f64 = 1e-6;
/// A mode contradicts the measured motion if another motion has more than this multiple of its energy. Our choice: an observer names the larger
/// part of the motion.
const OTHERWISE: f64 = 2.0;
/// A solution is rejected if the MAC between a measured shape and its own is below this. Our choice: shapes 18° apart.
const SHAPE_LEAST: f64 = 0.9;

/// A mode of a solution whose motion contradicts the measured one.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct MovesOtherwise {
    /// Frequency of the mode, Hz.
    pub frequency_hz: f64,
    /// The measured motion.
    pub measured: PlanMotion,
    /// The predominant motion in this solution.
    pub would_be: PlanMotion,
    /// Share of the energy in that motion.
    pub share: f64,
}

/// A mode of a solution whose shape contradicts the measured one.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct ShapeOtherwise {
    /// Frequency of the mode, Hz.
    pub frequency_hz: f64,
    /// MAC of u, v, ρθ between measurement and solution: 1 for the same shape.
    pub assurance: f64,
}

/// A stiffness with the measured frequencies.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct PlanSolution {
    /// k_x, k_y, N/m, and k_θ about the centre of rigidity, N·m/rad.
    pub stiffness: [f64; 3],
    /// Standard deviations, linearised; `None` if that of a measured value is unknown.
    pub stiffness_sd: Option<[f64; 3]>,
    /// Position of the centre of rigidity relative to the centre of mass, m.
    pub eccentricity_m: [f64; 2],
    /// Standard deviations of this position; `None` if it was given, or if that of a measured value is unknown.
    pub eccentricity_sd_m: Option<[f64; 2]>,
    /// u, v and ρθ of the centre of mass in each mode, ascending; the sum of their squares is 1.
    pub shapes: [[f64; 3]; 3],
    /// The largest change of a stiffness in per cent when each frequency changes by 1 %; 2 if sway and twist do not couple.
    pub amplification: f64,
    /// Whether solutions coincide here within the scatter of the measurement: the standard deviations then cover all of them.
    pub roots_meet: bool,
    /// The first mode that contradicts the measured motion; such a solution is rejected.
    pub moves_otherwise: Option<MovesOtherwise>,
    /// The mode that contradicts its measured shape most; such a solution is rejected.
    pub shape_otherwise: Option<ShapeOtherwise>,
}

impl PlanSolution {
    /// Shares of the energy of each mode, ascending, in u, v and θ of the centre of mass.
    pub fn energy_shares(&self) -> [[f64; 3]; 3] {
        self.shapes.map(|shape| shape.map(|q| q * q))
    }

    /// Whether its modes agree with the measured motions and shapes.
    pub fn is_accepted(&self) -> bool {
        self.moves_otherwise.is_none() && self.shape_otherwise.is_none()
    }
}

/// A stiffness that one frequency determines alone.
#[derive(Clone, Copy, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct SingleStiffness {
    /// The motion that the stiffness resists.
    pub motion: PlanMotion,
    /// k_x, k_y, N/m, or k_θ, N·m/rad.
    pub stiffness: f64,
    /// Standard deviation of the stiffness; `None` if that of the frequency is unknown.
    pub stiffness_sd: Option<f64>,
}

/// Stiffness of a storey from the frequencies of its floor.
#[derive(Clone, Debug, PartialEq)]
#[cfg_attr(feature = "serde", derive(serde::Serialize))]
pub struct PlanStiffness {
    /// Every positive stiffness with the three frequencies, accepted ones first, then by k_x. Empty with fewer frequencies.
    pub solutions: Vec<PlanSolution>,
    /// Source of the eccentricity.
    pub eccentricity_from: EccentricityFrom,
    /// Whether all complex solutions were found. If not, one may be missing.
    pub complete: bool,
    /// With fewer than three frequencies: the stiffnesses that these determine alone.
    pub singles: Vec<SingleStiffness>,
    /// With fewer than three frequencies: the motions whose stiffness is not determined.
    pub free: Vec<PlanMotion>,
}

impl PlanStiffness {
    /// Solutions whose modes agree with the measured motions and shapes.
    pub fn accepted(&self) -> impl Iterator<Item = &PlanSolution> {
        self.solutions.iter().filter(|one| one.is_accepted())
    }
}

/// Finds every stiffness of a storey in plan that gives its floor the measured frequencies.
///
/// ```text
/// K = k_x b_x b_xᵀ + k_y b_y b_yᵀ + k_θ b_θ b_θᵀ − w diag(1, 1, ρ²)                                   3 × 3
/// b_x = [1 0 −e_y]ᵀ,  b_y = [0 1 e_x]ᵀ,  b_θ = [0 0 1]ᵀ,   det(K − λ_j diag(m, m, m ρ²)) = 0,  j = 1…3
/// ```
/// With a given eccentricity, the function follows all six complex solutions and keeps the real positive ones. With the twists of the modes
/// along x and y it finds the eccentricity too: the shapes are orthogonal, and K has no entry between u and v, so one unknown and a cubic
/// remain. If roots of the cubic coincide within the scatter (real roots within 1.96 standard deviations, roots that scatter made complex within
/// 3), the standard deviations of each root cover them all; if scatter removed the roots, the result is the storey between them. The twist of
/// only one of the two modes is not used.
///
/// Solutions whose modes contradict the measured motions or shapes are listed with the reason. With fewer than three frequencies the result has
/// the stiffnesses that single frequencies determine (unless eccentricity prevents this), and the motions that remain undetermined.
///
/// # Errors
/// [`PlanStiffnessError`].
///
/// # Limits
/// One rigid floor, with walls along x and y. Standard deviations are linearised, and masses are taken as exact.
///
/// # Example
/// ```
/// use dolmen::structure::building::{PlanMode, PlanMotion, PlanStorey, plan_stiffness};
/// let storey = PlanStorey { mass_kg: 604e3, gyration_m: 8.0, weight_takes_n_m: 0.0, eccentricity_m: [0.0, 0.0] };
/// let mode = |frequency_hz, motion| PlanMode { frequency_hz, frequency_sd_hz: 0.03, motion: Some(motion), twist: None, shape: None };
/// let modes = [mode(1.5, PlanMotion::X), mode(1.1, PlanMotion::Y), mode(1.3, PlanMotion::Torsion)];
/// let found = plan_stiffness(&storey, &modes)?;
/// let one = found.accepted().next().unwrap();
/// assert!((one.stiffness[1] / (604e3 * (std::f64::consts::TAU * 1.1_f64).powi(2)) - 1.0).abs() < 1e-9);
/// # Ok::<(), dolmen::structure::building::PlanStiffnessError>(())
/// ```
pub fn plan_stiffness(storey: &PlanStorey, modes: &[PlanMode]) -> Result<PlanStiffness, PlanStiffnessError> {
    check(storey, modes)?;
    let mut ascending = modes.to_vec();
    ascending.sort_by(|a, b| a.frequency_hz.total_cmp(&b.frequency_hz));
    let [first, second, third] = ascending[..] else {
        return Ok(of_few(storey, &ascending));
    };
    let modes = [first, second, third];
    let twists = twists(&modes);
    let centred = storey.eccentricity_m == [0.0, 0.0] && twists.is_none();
    for pair in modes.windows(2).filter(|_| !centred) {
        let (before, own) = (pair[0].frequency_hz, pair[1].frequency_hz);
        if own - before <= REPEATED * own {
            return Err(PlanStiffnessError::Repeated { frequency_hz: own });
        }
    }
    let lambda = modes.map(|mode| (std::f64::consts::TAU * mode.frequency_hz).powi(2));
    let (found, from) = match twists {
        Some(labelled) => (
            roots_with_shapes(storey, &lambda, &labelled),
            EccentricityFrom::Twists,
        ),
        None => (
            roots_with_stated_centre(storey, &lambda)?,
            EccentricityFrom::Stated,
        ),
    };
    let moves = |root: &PlanRoot| why_not(&modes, root) == (None, None);
    let double = twists.and_then(|labelled| double_root(storey, &modes, &labelled, moves));
    let mut solutions = Vec::with_capacity(found.roots.len());
    let mut stands_in = double.as_ref().is_some_and(|double| double.is_accepted);
    for root in &found.roots {
        let mut one = solution(storey, &modes, root, from)?;
        if let Some(double) = double.as_ref().filter(|double| double.holds(root)) {
            spread(&mut one, double.deviations(root));
            stands_in &= !one.is_accepted();
        }
        solutions.push(one);
    }
    if let Some(double) = double.filter(|_| stands_in)
        && double.root.stiffness.iter().all(|k| *k > 0.0)
    {
        solutions.push(of_double(&double));
    }
    solutions.sort_by(|a, b| {
        let refused = |one: &PlanSolution| !one.is_accepted();
        let by_stiffness = a.stiffness[0].total_cmp(&b.stiffness[0]);
        refused(a).cmp(&refused(b)).then(by_stiffness)
    });
    Ok(PlanStiffness {
        solutions,
        eccentricity_from: from,
        complete: found.complete,
        singles: Vec::new(),
        free: Vec::new(),
    })
}

fn twists(modes: &[PlanMode; 3]) -> Option<Labelled> {
    let at = |motion| modes.iter().position(|mode| mode.motion == Some(motion));
    let [x, y] = [at(PlanMotion::X)?, at(PlanMotion::Y)?];
    let twist = [modes[x].twist?.ratio, modes[y].twist?.ratio];
    Some(Labelled {
        mode_of: [x, y, 3 - x - y],
        twist,
    })
}

fn check(storey: &PlanStorey, modes: &[PlanMode]) -> Result<(), PlanStiffnessError> {
    let positive = |quantity, given: f64| match given > 0.0 && given.is_finite() {
        true => Ok(()),
        false => Err(PlanStiffnessError::Argument {
            quantity,
            given,
            allowed: "a positive number",
        }),
    };
    let not_negative = |quantity, given: f64| match given >= 0.0 && given.is_finite() {
        true => Ok(()),
        false => Err(PlanStiffnessError::Argument {
            quantity,
            given,
            allowed: "0 or a positive number",
        }),
    };
    let number = |quantity, given: f64| match given.is_finite() {
        true => Ok(()),
        false => Err(PlanStiffnessError::Argument {
            quantity,
            given,
            allowed: "a number",
        }),
    };
    positive("mass_kg", storey.mass_kg)?;
    positive("gyration_m", storey.gyration_m)?;
    not_negative("weight_takes_n_m", storey.weight_takes_n_m)?;
    for given in storey.eccentricity_m {
        number("eccentricity_m", given)?;
    }
    if modes.is_empty() || modes.len() > 3 {
        return Err(PlanStiffnessError::Modes { given: modes.len() });
    }
    for mode in modes {
        positive("frequency_hz", mode.frequency_hz)?;
        not_negative("frequency_sd_hz", mode.frequency_sd_hz)?;
        if let Some(twist) = mode.twist {
            number("twist", twist.ratio)?;
            not_negative("twist sd", twist.sd)?;
        }
        for given in mode.shape.iter().flatten() {
            number("shape", *given)?;
        }
    }
    for motion in PlanMotion::ALL {
        if modes.iter().filter(|mode| mode.motion == Some(motion)).count() > 1 {
            return Err(PlanStiffnessError::Twice { motion });
        }
    }
    Ok(())
}

/// Stiffnesses from fewer than three frequencies: sway along x is uncoupled if e_y is 0, sway along y if e_x is 0, torsion if both are 0.
fn of_few(storey: &PlanStorey, modes: &[PlanMode]) -> PlanStiffness {
    let [e_x, e_y] = storey.eccentricity_m;
    let alone = [e_y == 0.0, e_x == 0.0, e_x == 0.0 && e_y == 0.0];
    let (mut singles, mut free) = (Vec::new(), Vec::new());
    for motion in PlanMotion::ALL {
        let own = modes.iter().find(|mode| mode.motion == Some(motion));
        match own.filter(|_| alone[motion.index()]) {
            Some(mode) => singles.push(single(storey, motion, mode)),
            None => free.push(motion),
        }
    }
    PlanStiffness {
        solutions: Vec::new(),
        eccentricity_from: EccentricityFrom::Stated,
        complete: true,
        singles,
        free,
    }
}

/// k = m ω² + w, and k_θ = ρ² (m ω² + w).
fn single(storey: &PlanStorey, motion: PlanMotion, mode: &PlanMode) -> SingleStiffness {
    let arm = match motion {
        PlanMotion::X | PlanMotion::Y => 1.0,
        PlanMotion::Torsion => storey.gyration_m.powi(2),
    };
    let inertia = storey.mass_kg * (std::f64::consts::TAU * mode.frequency_hz).powi(2);
    let relative = mode.frequency_sd_hz / mode.frequency_hz;
    SingleStiffness {
        motion,
        stiffness: arm * (inertia + storey.weight_takes_n_m),
        stiffness_sd: Some(arm * 2.0 * inertia * relative).filter(|_| relative > 0.0),
    }
}

fn solution(
    storey: &PlanStorey,
    modes: &[PlanMode; 3],
    root: &PlanRoot,
    from: EccentricityFrom,
) -> Result<PlanSolution, PlanStiffnessError> {
    let scatter = scatter(storey, modes, root, from)?;
    let mut solution = PlanSolution {
        stiffness: root.stiffness,
        stiffness_sd: scatter.stiffness_sd,
        eccentricity_m: root.eccentricity_m,
        eccentricity_sd_m: scatter.eccentricity_sd_m,
        shapes: root.shapes,
        amplification: scatter.amplification,
        roots_meet: false,
        moves_otherwise: None,
        shape_otherwise: None,
    };
    solution.moves_otherwise = moves_otherwise(modes, &solution.energy_shares());
    solution.shape_otherwise = shape_otherwise(modes, &solution.shapes);
    Ok(solution)
}

/// The storey at the middle of an interval that agrees with the measured motions, if no real root of the interval does.
fn of_double(double: &DoubleRoot) -> PlanSolution {
    let mut one = PlanSolution {
        stiffness: double.root.stiffness,
        stiffness_sd: None,
        eccentricity_m: double.root.eccentricity_m,
        eccentricity_sd_m: None,
        shapes: double.root.shapes,
        amplification: double.amplification,
        roots_meet: false,
        moves_otherwise: None,
        shape_otherwise: None,
    };
    spread(&mut one, double.deviations(&double.root));
    one
}

fn spread(one: &mut PlanSolution, [k_x, k_y, k_theta, e_x, e_y]: [f64; 5]) {
    one.stiffness_sd = Some([k_x, k_y, k_theta]);
    one.eccentricity_sd_m = Some([e_x, e_y]);
    one.roots_meet = true;
}

fn why_not(modes: &[PlanMode; 3], root: &PlanRoot) -> (Option<MovesOtherwise>, Option<ShapeOtherwise>) {
    let energy_shares = root.shapes.map(|shape| shape.map(|q| q * q));
    (
        moves_otherwise(modes, &energy_shares),
        shape_otherwise(modes, &root.shapes),
    )
}

/// The mode whose measured shape differs most from that of the root.
fn shape_otherwise(modes: &[PlanMode; 3], shapes: &[[f64; 3]; 3]) -> Option<ShapeOtherwise> {
    let dot = |a: &[f64; 3], b: &[f64; 3]| a.iter().zip(b).map(|(a, b)| a * b).sum::<f64>();
    let each = modes.iter().zip(shapes).filter_map(|(mode, own)| {
        let measured = mode.shape?;
        let assurance = dot(&measured, own).powi(2) / (dot(&measured, &measured) * dot(own, own));
        Some(ShapeOtherwise {
            frequency_hz: mode.frequency_hz,
            assurance,
        })
    });
    let least = each.min_by(|a, b| a.assurance.total_cmp(&b.assurance));
    // a value that is not a number is no evidence
    least.filter(|of| of.assurance < SHAPE_LEAST || of.assurance.is_nan())
}

/// Modes that contradict the measured motion. A measured shape says more than the name of the motion, so it is compared separately.
pub(super) fn moves_otherwise(
    modes: &[PlanMode; 3],
    energy_shares: &[[f64; 3]; 3],
) -> Option<MovesOtherwise> {
    let of_mode = |(mode, shares): (&PlanMode, &[f64; 3])| {
        let measured = mode.motion.filter(|_| mode.shape.is_none())?;
        let most = |a: &PlanMotion, b: &PlanMotion| shares[a.index()].total_cmp(&shares[b.index()]);
        let would_be = PlanMotion::ALL.into_iter().max_by(most)?;
        let share = shares[would_be.index()];
        (share > OTHERWISE * shares[measured.index()]).then_some(MovesOtherwise {
            frequency_hz: mode.frequency_hz,
            measured,
            would_be,
            share,
        })
    };
    modes.iter().zip(energy_shares).find_map(of_mode)
}
