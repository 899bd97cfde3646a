//! Dampers: published tunings for one mode, and the twisting floors of Hwang, Min & Hong with a damper.

use super::{Case, ValidationError};
use crate::damper::{
    Aim, AttachedDamper, DampedSystem, DamperKind, DamperProblem, DamperSite, DesignOptions, Goal, Judged,
    ModalSynthesis, Place, PlacedDamper, Plan, PlanOptions, SingleMode, TuningRule, design, judge,
    optimal_tuning, rule_tuning,
};
use crate::dynamics::{
    FrequencyIntegral, LinearSystem, RandomInput, RandomLoad, ResponseRow, Spectrum, rms_by_integral,
    rms_by_lyapunov,
};
use crate::known::hwang_min_hong as paper;
use crate::known::liquid_column;
use dolmen_linalg::Matrix;
use std::f64::consts::TAU;

const MU: f64 = 0.05;
const SEVEN: f64 = 5.1e-8;
const FLOOR_SOURCE: &str = "Computed apart: dampers on twisting floors";

const FIXED_POINTS: &str =
    "Largest amplitude of its tuning; the fixed points of the source lie at √(1 + 2/μ) = 6.403124.";
const RATIO: &str = "Computed by another program, to four digits. Structure 2 %, white force along y at the centre, m_d = .05 of mode 1 with φ_y = 1 there; c/(2 m ω) = .1273 as printed. \
                     By assembled matrices and Lyapunov's equation.";
const SYNTHESIS: &str = "By modal synthesis (eqs 4 to 9 with damping) and the integral over frequency.";
const RULE: &str = "The source puts a damper farthest from the centre of mode 1. Here e = −.5 m, ω_θ = ω_y: the opposite edge moves more than \
                    without a damper. Corrected: place and tuning best together, x = .4447 m, f/Ω = .97734, ζ = .11653.";
const SIGN: &str = "Eq. 5a gives a damper along x at (X, Y) the row u + Yθ; eq. 12 and the rigid floor make it u − Yθ. Its ratio at y = 4 m with \
                    walls off centre both ways. Corrected: with the right sign.";

pub(super) fn cases() -> Result<Vec<Case>, ValidationError> {
    let mut cases = tunings()?;
    cases.extend(floors()?);
    cases.extend(columns()?);
    Ok(cases)
}

fn case(
    source: &'static str,
    what: impl Into<String>,
    [published, computed, tolerance]: [f64; 3],
    note: &'static str,
) -> Case {
    Case {
        source,
        what: what.into(),
        unit: "",
        published,
        computed,
        tolerance,
        corrected: None,
        note,
    }
}

fn tunings() -> Result<Vec<Case>, ValidationError> {
    let mut cases = Vec::new();
    let mode = SingleMode {
        mass_ratio: MU,
        structure_damping_ratio: 0.0,
    };
    for (rule, aim, published, note) in [
        (
            TuningRule::DenHartog,
            Aim::ForceHarmonic,
            [0.952_381_0, 0.133_630_6, 6.408_443],
            FIXED_POINTS,
        ),
        (
            TuningRule::NishiharaAsami,
            Aim::ForceHarmonic,
            [0.952_372_0, 0.133_937_7, 6.407_921],
            "",
        ),
        (
            TuningRule::WarburtonForce,
            Aim::ForceRandom,
            [0.964_212_2, 0.109_772_2, 4.445_436_4],
            "",
        ),
        (
            TuningRule::WarburtonBase,
            Aim::BaseRandom,
            [0.940_400_8, 0.109_806_1, 4.781_536_8],
            "",
        ),
        (
            TuningRule::WarburtonBaseHarmonic,
            Aim::BaseHarmonic,
            [0.940_400_8, 0.135_333_0, 6.646_274],
            "",
        ),
    ] {
        let tuning = rule_tuning(rule, MU, 0.0)?;
        let cost = mode.cost(&tuning, aim)?;
        let digits = if matches!(aim, Aim::ForceRandom | Aim::BaseRandom) {
            SEVEN
        } else {
            5.1e-7
        };
        let (cost_name, of) = match aim {
            Aim::ForceRandom | Aim::BaseRandom => ("variance, (1/2π) ∫ H² dr", rule.aim()),
            _ => ("largest H", rule.aim()),
        };
        cases.push(case(
            rule.source(),
            format!("f, μ = .05: {of}"),
            [published[0], tuning.frequency_ratio, SEVEN],
            "",
        ));
        cases.push(case(
            rule.source(),
            format!("ζ, μ = .05: {of}"),
            [published[1], tuning.damping_ratio, SEVEN],
            "",
        ));
        cases.push(case(
            rule.source(),
            format!("{cost_name}, μ = .05: {of}"),
            [published[2], cost, digits],
            note,
        ));
    }
    let damped = SingleMode {
        mass_ratio: MU,
        structure_damping_ratio: 0.02,
    };
    let best = optimal_tuning(&damped, Aim::ForceRandom)?;
    for (what, published, computed) in [
        (
            "f by search, structure 2 %",
            0.962_178,
            best.tuning.frequency_ratio,
        ),
        ("ζ by search, structure 2 %", 0.109_772, best.tuning.damping_ratio),
        (
            "RMS over that without a damper, structure 2 %",
            0.528_351,
            (best.cost * 4.0 * 0.02).sqrt(),
        ),
    ] {
        cases.push(case(
            "Computed apart: tuning of a damped mode",
            format!("{what}, μ = .05, white force"),
            [published, computed, 5.1e-7],
            "",
        ));
    }
    Ok(cases)
}

/// A floor with 2 % damping in every mode.
fn floor(stiffness: Matrix) -> Result<LinearSystem, ValidationError> {
    let mass = Matrix::from_diagonal(&[1.0, 1.0, paper::GYRATION_SQUARED_M2]);
    let bare = LinearSystem::new(mass.clone(), Matrix::zeros(3, 3), stiffness.clone())?;
    let modes = bare.modes()?;
    let scaled = Matrix::from_fn(3, 3, |i, j| {
        modes.shapes[(i, j)] * 0.04 * modes.angular_frequency_rad_s[j]
    });
    let c = &(&mass * &(&scaled * &modes.shapes.transpose())) * &mass;
    Ok(LinearSystem::new(mass, c, stiffness)?)
}

fn y_at(x: f64) -> Vec<f64> {
    vec![0.0, 1.0, x]
}

fn white(row: Vec<f64>) -> RandomLoad {
    RandomLoad {
        input: RandomInput::Force(row),
        spectrum: Spectrum::White { density: 1.0 }, // eq. 10
    }
}

fn edges(structure: &LinearSystem, dampers: &[AttachedDamper]) -> Result<Judged, ValidationError> {
    Ok(judge(
        structure,
        &[white(y_at(0.0))],
        &[y_at(-5.0), y_at(5.0)],
        dampers,
    )?)
}

/// The damper of the source at x, with its damping ratio relative to its own frequency.
fn damper(structure: &LinearSystem, x: f64, rule: TuningRule) -> Result<AttachedDamper, ValidationError> {
    let modes = structure.modes()?;
    let tuning = rule_tuning(rule, MU, 0.0)?;
    Ok(AttachedDamper {
        kind: DamperKind::TunedMass {
            mass_kg: MU / modes.shapes[(1, 0)].powi(2),
            frequency_hz: tuning.frequency_ratio * modes.angular_frequency_rad_s[0] / TAU,
            damping_ratio: tuning.damping_ratio,
        },
        row: y_at(x),
    })
}

fn floors() -> Result<Vec<Case>, ValidationError> {
    let mut cases = Vec::new();
    let [kx, ky] = paper::STIFFNESS;
    let e = paper::RIGIDITY_X_M;
    let first = floor(Matrix::from_rows(&[
        [kx, 0.0, 0.0],
        [0.0, ky, ky * e],
        [0.0, ky * e, paper::rotation()],
    ]))?;
    let without = edges(&first, &[])?.point_rms;
    for (x, published) in [
        (-5.0, [0.5982, 0.6034]),
        (0.0, [0.5397, 0.5326]),
        (5.0, [0.5019, 0.4897]),
    ] {
        let damper = damper(&first, x, TuningRule::HwangMinHongLiteral)?;
        let with = edges(&first, std::slice::from_ref(&damper))?.point_rms;
        let synthesis = by_synthesis(
            &first,
            &damper,
            &RandomInput::Force(y_at(0.0)),
            &[y_at(-5.0), y_at(5.0)],
        )?;
        for (i, point) in [-5, 5].into_iter().enumerate() {
            let what = format!("RMS ratio at x = {point} m, damper at x = {x} m");
            let ratio = with[i] / without[i];
            cases.push(case(
                FLOOR_SOURCE,
                what.clone(),
                [published[i], ratio, 5e-5],
                RATIO,
            ));
            let what = format!("{what}, by synthesis");
            cases.push(case(
                FLOOR_SOURCE,
                what,
                [published[i], synthesis[i] / without[i], 5e-5],
                SYNTHESIS,
            ));
        }
    }
    let ky = 3.6456;
    let second = floor(Matrix::from_rows(&[
        [paper::STIFFNESS[0], 0.0, 0.0],
        [0.0, ky, -0.5 * ky],
        [0.0, -0.5 * ky, ky * paper::GYRATION_SQUARED_M2],
    ]))?;
    let without = edges(&second, &[])?.point_rms;
    let best = best_of(&second)?;
    for (x, published) in [
        (5.0, [1.0430, 0.3708]),
        (-5.0, [0.3280, 1.0481]),
        (0.25, [2.087 / 3.601, 2.039 / 4.396]),
    ] {
        let damper = damper(&second, x, TuningRule::DenHartog)?;
        let with = edges(&second, &[damper])?.point_rms;
        for (i, point) in [-5, 5].into_iter().enumerate() {
            let what = format!("second floor: RMS ratio at x = {point} m, damper at x = {x} m");
            let tolerance = if x == 0.25 { 2e-4 } else { 5e-5 };
            let mut of = case(
                FLOOR_SOURCE,
                what,
                [published[i], with[i] / without[i], tolerance],
                RULE,
            );
            of.corrected = Some(best[i] / without[i]);
            cases.push(of);
        }
    }
    let rows = [y_at(-5.0)].map(ResponseRow::displacement);
    let lyapunov = rms_by_lyapunov(&second, &[white(y_at(0.0))], &rows)?[0];
    let integral = rms_by_integral(&second, &[white(y_at(0.0))], &rows, &FrequencyIntegral::default())?[0];
    cases.push(case(
        "Two methods: random vibration",
        "RMS by the integral over frequency over that by Lyapunov's equation",
        [1.0, integral / lyapunov, 1e-6],
        "",
    ));
    cases.push(sign()?);
    Ok(cases)
}

/// Ratios by modal synthesis, with ω = tan s in equal steps of s.
fn by_synthesis(
    structure: &LinearSystem,
    damper: &AttachedDamper,
    input: &RandomInput,
    rows: &[Vec<f64>],
) -> Result<Vec<f64>, ValidationError> {
    const STEPS: u32 = 20_000;
    let modes = ModalSynthesis::new(structure, 3)?;
    let step = std::f64::consts::FRAC_PI_2 / f64::from(STEPS);
    let mut sums = vec![0.0; rows.len()];
    for i in 0..STEPS {
        let s = (f64::from(i) + 0.5) * step;
        let h = modes.response(s.tan(), input, std::slice::from_ref(damper), rows)?;
        for (sum, h) in sums.iter_mut().zip(h) {
            *sum += 2.0 * h.norm_sqr() / s.cos().powi(2) * step;
        }
    }
    Ok(sums.into_iter().map(f64::sqrt).collect())
}

/// Both edges, with position and tuning optimised together.
fn best_of(structure: &LinearSystem) -> Result<Vec<f64>, ValidationError> {
    let DamperKind::TunedMass {
        mass_kg,
        frequency_hz,
        damping_ratio,
    } = damper(structure, 0.0, TuningRule::DenHartog)?.kind
    else {
        return Ok(vec![f64::NAN; 2]);
    };
    let start = PlacedDamper {
        site: 0,
        place_m: [0.25, 0.0],
        direction_degrees: 90.0,
        mass_kg,
        frequency_hz,
        damping_ratio,
        length_ratio: 1.0,
    };
    let problem = DamperProblem {
        structure: structure.clone(),
        loads: vec![white(y_at(0.0))],
        points: vec![y_at(-5.0), y_at(5.0)],
        sites: vec![DamperSite {
            first_degree_of_freedom: 0,
            reference_m: [0.0; 2],
            corners_m: vec![[-5.0, -4.0], [5.0, -4.0], [5.0, 4.0], [-5.0, 4.0]],
        }],
        fixed: Vec::new(),
    };
    let plan = Plan::new(problem, &[start], &PlanOptions::default())?;
    let options = DesignOptions {
        goal: Goal::LargestRms,
        place: Place::AlongX,
        ..DesignOptions::default()
    };
    Ok(design(&plan, &[start], &options)?.judged.point_rms)
}

fn sign() -> Result<Case, ValidationError> {
    let [kx, ky] = paper::STIFFNESS;
    let (ex, ey) = (paper::RIGIDITY_X_M, 1.0);
    let structure = floor(Matrix::from_rows(&[
        [kx, 0.0, -kx * ey],
        [0.0, ky, ky * ex],
        [-kx * ey, ky * ex, paper::rotation()],
    ]))?;
    let edge = vec![1.0, 0.0, -4.0];
    let load = white(vec![1.0, 0.0, 0.0]);
    let omega = structure.modes()?.angular_frequency_rad_s[1];
    let without = judge(
        &structure,
        std::slice::from_ref(&load),
        std::slice::from_ref(&edge),
        &[],
    )?
    .point_rms[0];
    let ratio = |row: Vec<f64>| -> Result<f64, ValidationError> {
        let damper = AttachedDamper {
            kind: DamperKind::TunedMass {
                mass_kg: 0.05,
                frequency_hz: omega / TAU / 1.05,
                damping_ratio: 0.13,
            },
            row,
        };
        let with = judge(
            &structure,
            std::slice::from_ref(&load),
            std::slice::from_ref(&edge),
            &[damper],
        )?;
        Ok(with.point_rms[0] / without)
    };
    let damper = AttachedDamper {
        kind: DamperKind::TunedMass {
            mass_kg: 0.05,
            frequency_hz: omega / TAU / 1.05,
            damping_ratio: 0.13,
        },
        row: vec![1.0, 0.0, 4.0],
    };
    let printed = by_synthesis(&structure, &damper, &load.input, std::slice::from_ref(&edge))?[0] / without;
    let mut of = case(
        "Hwang, Min & Hong",
        "eqs 4 to 9 with the sign of eq. 5a: RMS ratio along x at y = 4 m, damper along x there; beside matrices with that sign",
        [printed, ratio(vec![1.0, 0.0, 4.0])?, 1e-6],
        SIGN,
    );
    of.corrected = Some(ratio(vec![1.0, 0.0, -4.0])?);
    Ok(of)
}

/// Liquid columns: smallest variance by a search near the closed form.
fn columns() -> Result<Vec<Case>, ValidationError> {
    let mut cases = Vec::new();
    for (mu, alpha) in [(0.01, 0.9), (0.05, 0.7)] {
        let one = |x: f64| Matrix::from_rows(&[[x]]);
        let structure = LinearSystem::new(one(1.0), one(0.0), one(1.0))?;
        let variance = |f: f64, zeta: f64| -> Result<f64, ValidationError> {
            let column = AttachedDamper {
                kind: DamperKind::LiquidColumn {
                    liquid_mass_kg: mu,
                    length_ratio: alpha,
                    frequency_hz: f / TAU,
                    damping_ratio: zeta,
                },
                row: vec![1.0],
            };
            let damped = DampedSystem::new(&structure, &[column])?;
            let row = damped.response(&ResponseRow::displacement(vec![1.0]));
            Ok(rms_by_lyapunov(&damped.system, &[damped.load(&white(vec![1.0]))], &[row])?[0].powi(2))
        };
        let [mut f, mut zeta] = liquid_column::least_variance_under_force(mu, alpha);
        let published = [f, zeta];
        f *= 1.01; // a start next to the optimum
        zeta *= 0.98;
        for _ in 0..20 {
            f = vertex(f, 1e-3, |f| variance(f, zeta))?;
            zeta = vertex(zeta, 1e-3, |zeta| variance(f, zeta))?;
        }
        for (what, published, computed) in [
            ("frequency ratio", published[0], f),
            ("damping ratio", published[1], zeta),
        ] {
            cases.push(case(
                "Yalla & Kareem (2000)",
                format!("liquid column, white force: best {what}, μ = {mu}, α = {alpha}"),
                [published, computed, 1e-6],
                "By search on assembled matrices.",
            ));
        }
    }
    Ok(cases)
}

/// Lowest point of the parabola through three points around x.
fn vertex(
    x: f64,
    part: f64,
    of: impl Fn(f64) -> Result<f64, ValidationError>,
) -> Result<f64, ValidationError> {
    let h = part * x;
    let [low, middle, high] = [of(x - h)?, of(x)?, of(x + h)?];
    Ok(x - 0.5 * h * (high - low) / (high - 2.0 * middle + low))
}
