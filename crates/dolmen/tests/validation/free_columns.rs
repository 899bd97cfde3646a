// SOURCE     Winkler (1867) for the bed; Housner (1963) for the rocking of a rigid body; equilibrium of a column on two beds. Frames
//            that rock: Lagrange's equation of columns and beam, and momentum in the motion after the impact.
// GOAL       Force of free-standing columns over drift: uplift, largest force and fall; and their rocking.
// PARAMETERS square and round feet, random from a seed; the column N 200 kN, b = B = 0.5 m, h 4 m.
// PUBLISHED  it falls at 0.542, 0.779, 0.887, 0.936 of b/h for k_w 1e8, 3e8, 1e9, 3e9 N/m³ (small angles, by hand).
// TOLERANCE  1e-8 against strips of the bed; half a unit of the last digit of the table; 1e-6 against time stepping.

use dolmen::dynamics::{Rocking, RockingBlock, RockingOutcome, TimeFunction, rock_block};
use dolmen::numeric::Random;
use dolmen::stability::{FootSection, FreeColumns};
use std::f64::consts::{PI, TAU};

const SQUARE: FootSection = FootSection::Rectangle {
    width_m: 0.5,
    breadth_m: 0.5,
};

fn column(height_m: f64, bed: Option<f64>) -> FreeColumns {
    FreeColumns::new(1, SQUARE, height_m, 200e3, bed).unwrap()
}

/// ∫ f over (a, b) by Simpson's rule.
fn simpson(f: impl Fn(f64) -> f64, a: f64, b: f64, pairs: usize) -> f64 {
    let step = (b - a) / (2 * pairs) as f64;
    let each = (0..=2 * pairs).map(|i| {
        let weight = if i == 0 || i == 2 * pairs {
            1.0
        } else {
            (2 + 2 * (i % 2)) as f64
        };
        weight * f(a + step * i as f64)
    });
    each.sum::<f64>() * step / 3.0
}

/// Force and moment of strips of the bed for pressure k_w θ (x − x0) on x > x0.
fn strips(section: FootSection, gradient: f64, neutral_m: f64) -> [f64; 2] {
    let pressed = |x: f64| gradient * (x - neutral_m);
    match section {
        FootSection::Rectangle { width_m, breadth_m } => {
            let from = neutral_m.max(-0.5 * width_m);
            [0, 1].map(|power| simpson(|x| pressed(x) * breadth_m * x.powi(power), from, 0.5 * width_m, 2))
        }
        FootSection::Circle { diameter_m } => {
            let radius = 0.5 * diameter_m;
            let arc = (neutral_m / radius).clamp(-1.0, 1.0).acos();
            [0, 1].map(|power| {
                let strip = |t: f64| {
                    let x = radius * t.cos();
                    pressed(x) * 2.0 * (radius * t.sin()).powi(2) * x.powi(power)
                };
                simpson(strip, 0.0, arc, 400)
            })
        }
    }
}

#[test]
fn agrees_feet_with_strips_of_the_bed() {
    let mut random = Random::new(20, 0);
    let mut between = |low: f64, high: f64| low * (high / low).powf(random.uniform());
    for case in 0..200 {
        let width_m = between(0.1, 1.0);
        let section = match case % 2 {
            0 => FootSection::Rectangle {
                width_m,
                breadth_m: between(0.1, 1.0),
            },
            _ => FootSection::Circle { diameter_m: width_m },
        };
        let (bed, normal) = (between(1e7, 1e11), between(1e3, 1e6));
        let rotation = section.uplift_rotation_rad(bed, normal) * between(0.1, 1e4);
        let found = section.pressure(bed, normal, rotation);
        // start of the pressure for which the strips carry N, by bisection
        let (mut low, mut high) = (-1e3 * width_m, 0.5 * width_m);
        for _ in 0..200 {
            let middle = 0.5 * (low + high);
            if strips(section, bed * rotation, middle)[0] > normal {
                low = middle;
            } else {
                high = middle;
            }
        }
        let [force, moment] = strips(section, bed * rotation, low);
        assert!((force / normal - 1.0).abs() < 1e-8, "{case}");
        let off = found.eccentricity_m * normal / moment - 1.0;
        assert!(off.abs() < 1e-8, "{case} {section:?} {off}");
        let contact_m = (0.5 * width_m - low).min(width_m);
        assert!(
            (found.contact_m / contact_m - 1.0).abs() < 1e-7,
            "{case} {section:?}"
        );
    }
}

#[test]
fn exact_moments_at_uplift_and_far_beyond() {
    let round = FootSection::Circle { diameter_m: 0.5 };
    for (section, part) in [(SQUARE, 6.0), (round, 8.0)] {
        let lifts = section.uplift_rotation_rad(1e9, 2e5);
        for rotation in [lifts, lifts * (1.0 + 1e-9)] {
            let at = section.pressure(1e9, 2e5, rotation);
            assert!((at.eccentricity_m - 0.5 / part).abs() < 1e-9, "{at:?}");
            assert!((at.contact_m - 0.5).abs() < 1e-3, "{at:?}");
        }
        let far = section.pressure(1e18, 2e5, 0.1).eccentricity_m;
        assert!((far - 0.25).abs() < 1e-4 && far < 0.25, "{far}");
    }
    assert!((SQUARE.uplift_rotation_rad(1e9, 2e5) - 2.0 * 2e5 / (1e9 * 0.125)).abs() < 1e-15);
    assert!((round.uplift_rotation_rad(1e9, 2e5) - 8.0 * 2e5 / (PI * 1e9 * 0.125)).abs() < 1e-15);
}

#[test]
fn exact_rigid_columns_at_finite_rotation() {
    let columns = FreeColumns::new(6, SQUARE, 2.0, 1.2e6, None).unwrap();
    let (alpha, theta) = (0.25_f64.atan(), 0.1_f64);
    let at = columns.at(theta);
    assert!((at.force_n / (1.2e6 * (alpha - theta).tan()) - 1.0).abs() < 1e-14);
    let drift_m = 2.0 * theta.sin() + 0.5 * (1.0 - theta.cos());
    assert!((at.drift_m / drift_m - 1.0).abs() < 1e-14);
    let standing = columns.standing().unwrap().unwrap();
    assert!((standing.greatest.force_n - 1.2e6 * 0.25).abs() < 1e-6);
    assert!((standing.falls.rotation_rad - alpha).abs() < 1e-15 && standing.falls.force_n.abs() < 1e-6);
    assert_eq!(
        (standing.uplift.drift_m, columns.bed_stiffness_n_m()),
        (0.0, None)
    );
    // the work until the fall equals the rise of the weight: from h to the diagonal
    let curve = columns.curve(2001).unwrap();
    let work: f64 = curve
        .windows(2)
        .map(|pair| 0.5 * (pair[0].force_n + pair[1].force_n) * (pair[1].drift_m - pair[0].drift_m))
        .sum();
    let rise_m = 2.0_f64.hypot(0.5) - 2.0;
    assert!((work / (1.2e6 * rise_m) - 1.0).abs() < 1e-6, "{work}");
}

/// Small angles: θ at which b/h − (2/3h) √(2N/(k_w B θ)) = θ, over b/h, by halving beyond θ*.
fn small_angle_fall(bed: f64) -> f64 {
    let (b, h, n) = (0.5, 4.0, 200e3);
    let over = |theta: f64| b / h - 2.0 / (3.0 * h) * f64::sqrt(2.0 * n / (bed * b * theta)) - theta;
    let (mut low, mut high) = ((2.0 * n / (9.0 * bed * b * h * h)).cbrt(), b / h);
    for _ in 0..100 {
        let middle = 0.5 * (low + high);
        if over(middle) > 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    low / (b / h)
}

#[test]
fn published_rotations_of_fall_on_a_bed() {
    for (bed, printed) in [(1e8, 0.542), (3e8, 0.779), (1e9, 0.887), (3e9, 0.936)] {
        assert!((small_angle_fall(bed) - printed).abs() < 5e-4);
        // the same N h/(k_w B b³) at a thousandth of the angles
        let slender = column(4000.0, Some(1000.0 * bed)).standing().unwrap().unwrap();
        let found = slender.falls.rotation_rad / (0.5 / 4000.0);
        assert!((found - small_angle_fall(bed)).abs() < 1e-6, "{bed}: {found}");
        let real = column(4.0, Some(bed)).standing().unwrap().unwrap();
        assert!(
            (real.falls.rotation_rad.tan() * 8.0 - printed).abs() < 1e-3,
            "{real:?}"
        );
        // θ* and V_max in closed form
        let top = (2.0 * 200e3 / (9.0 * 1000.0 * bed * 0.5 * 4000.0_f64.powi(2))).cbrt();
        assert!((slender.greatest.rotation_rad / top - 1.0).abs() < 1e-6);
        let most = 200e3 * (0.5 / 4000.0 - 3.0 * top);
        assert!((slender.greatest.force_n / most - 1.0).abs() < 1e-6);
        assert!(slender.uplift.rotation_rad < top);
    }
}

#[test]
fn holds_columns_stand_on_a_bed_that_is_stiff_enough() {
    // k_w B b³/6 = N h
    let least = 6.0 * 200e3 * 4.0 / 0.0625;
    assert!((column(4.0, Some(1e9)).least_bed_stiffness_n_m3() / least - 1.0).abs() < 1e-14);
    assert_eq!(column(4.0, Some(0.999 * least)).standing(), Ok(None));
    assert!(column(4.0, Some(0.999 * least)).curve(9).unwrap().is_empty());
    assert!((1..40).all(|i| column(4.0, Some(0.999 * least)).at(0.005 * f64::from(i)).force_n < 0.0));
    let stands = column(4.0, Some(1.01 * least)).standing().unwrap().unwrap();
    assert!(stands.greatest.force_n > 0.0 && stands.falls.rotation_rad > stands.greatest.rotation_rad);
    // several columns share the weight
    let six = FreeColumns::new(6, SQUARE, 4.0, 1.2e6, Some(1e9)).unwrap();
    let one = column(4.0, Some(1e9));
    assert!((six.at(0.03).force_n / one.at(0.03).force_n - 6.0).abs() < 1e-12);
    let initial = six.bed_stiffness_n_m().unwrap();
    assert!((initial / (6.0 * 2.0 * 1e9 * 0.5_f64.powi(4) / 12.0 / 16.0) - 1.0).abs() < 1e-14);
    let at = six.at(1e-6);
    assert!((at.force_n / at.drift_m / (initial - 1.2e6 / 4.0) - 1.0).abs() < 1e-9);
}

#[test]
fn holds_stiff_beds_become_rigid() {
    for section in [SQUARE, FootSection::Circle { diameter_m: 0.5 }] {
        let at = |bed| FreeColumns::new(1, section, 4.0, 200e3, bed).unwrap().at(0.05);
        let off = |bed: f64| 1.0 - at(Some(bed)).force_n / at(None).force_n;
        assert!(off(1e10) > off(1e12) && off(1e12) > 0.0 && off(1e17) < 1e-3 && off(1e17) > 0.0);
        assert!((at(Some(1e17)).drift_m / at(None).drift_m - 1.0).abs() < 1e-5);
    }
}

#[test]
fn holds_work_lifts_the_weight_and_presses_the_beds() {
    // small indentations: w at the centre of each foot, energy ½ k_w ∫ w² dA; 1.5e-3 is θ²/2, without rolling it is off by 6e-3
    let (bed, normal, height, theta) = (1e9, 200e3, 4.0, 0.05);
    let columns = column(height, Some(bed));
    let points: Vec<_> = (0..=20_000)
        .map(|i| columns.at(theta * (f64::from(i) / 20_000.0).powi(2)))
        .collect();
    let work: f64 = points
        .windows(2)
        .map(|pair| 0.5 * (pair[0].force_n + pair[1].force_n) * (pair[1].drift_m - pair[0].drift_m))
        .sum();
    let contact = SQUARE.pressure(bed, normal, theta).contact_m;
    assert!(contact < 0.5);
    let upright = normal / (bed * 0.25); // indentation
    let (lowered, pressed) = (
        theta * (contact - 0.25),
        bed * 0.5 * theta * theta * contact.powi(3) / 6.0,
    );
    let rise = height * (theta.cos() - 1.0) - 2.0 * (lowered - upright);
    let stored = normal * rise + 2.0 * (pressed - 0.5 * normal * upright);
    assert!((work / stored - 1.0).abs() < 1.5e-3, "{work} {stored}");
}

/// Quarter period of θ″ = −a(θ) from rest at `top`, by steps of Runge–Kutta and a last one to θ = 0, s.
fn quarter_s(acceleration: impl Fn(f64) -> f64, top: f64, step: f64) -> f64 {
    let (mut theta, mut speed, mut time) = (top, 0.0, 0.0);
    loop {
        let slope = |x: f64, v: f64| (v, -acceleration(x.max(0.0)));
        let (a, b) = slope(theta, speed);
        let (c, d) = slope(theta + 0.5 * step * a, speed + 0.5 * step * b);
        let (e, f) = slope(theta + 0.5 * step * c, speed + 0.5 * step * d);
        let (g, h) = slope(theta + step * e, speed + step * f);
        let next = theta + step / 6.0 * (a + 2.0 * c + 2.0 * e + g);
        if next <= 0.0 {
            return time + theta / -(speed + 0.5 * step * b * theta / (theta - next));
        }
        theta = next;
        speed += step / 6.0 * (b + 2.0 * d + 2.0 * f + h);
        time += step;
    }
}

#[test]
fn agrees_frequencies_of_swings_with_steps_in_time() {
    let gravity = 9.81;
    let mass = 200e3 / gravity;
    // a rigid beam on rigid columns: θ″ = −(g/d) sin(α − θ), d the diagonal (p̂ = p √(2/3) of a heavy beam)
    let (rigid, alpha) = (column(4.0, None), 0.125_f64.atan());
    let pull = gravity / 4.0_f64.hypot(0.5);
    for share in [0.1, 0.5, 0.9] {
        let found = rigid.swing_frequency_hz(mass, 0.0, share * alpha);
        let steps = quarter_s(|theta| pull * (alpha - theta).sin(), share * alpha, 1e-4);
        assert!((4.0 * found * steps - 1.0).abs() < 1e-6, "{share}: {found}");
        // Housner's, for small angles
        let linear = (1.0 / (1.0 - share)).acosh() / pull.sqrt();
        assert!((4.0 * found * linear - 1.0).abs() < 5e-3, "{share}");
    }
    // on a bed, with a spring, at small angles
    let (height, bed) = (400.0, 1e11);
    let slender = column(height, Some(bed));
    let uplift = SQUARE.uplift_rotation_rad(bed, 200e3);
    for (spring, times) in [(0.0, 0.5), (0.0, 20.0), (500.0, 20.0), (500.0, 0.5)] {
        let found = slender.swing_frequency_hz(mass, spring, times * uplift);
        let pull = |theta: f64| (slender.at(theta).force_n / height + spring * theta) / mass;
        let steps = quarter_s(pull, times * uplift, 0.005);
        assert!(
            (4.0 * found * steps - 1.0).abs() < 1e-5,
            "{times} {spring}: {found} {steps}"
        );
    }
    let whole = slender.bed_stiffness_n_m().unwrap() - 200e3 / height;
    let small = slender.swing_frequency_hz(mass, 0.0, 0.1 * uplift);
    assert!(
        (small * TAU / (whole / mass).sqrt() - 1.0).abs() < 1e-5,
        "{small}"
    );
    // a larger amplitude is slower
    let swings = [1.0, 2.0, 5.0, 20.0].map(|times| slender.swing_frequency_hz(mass, 0.0, times * uplift));
    assert!(swings.windows(2).all(|pair| pair[1] < pair[0]), "{swings:?}");
}

#[test]
fn refuses_columns_without_size_or_weight() {
    let fault = FreeColumns::new(4, SQUARE, 4.0, 0.0, None).unwrap_err();
    assert_eq!(fault.to_string(), "axial_n is 0, but must be positive and finite");
    assert!(FreeColumns::new(0, SQUARE, 4.0, 1.0, None).is_err());
    assert!(FreeColumns::new(1, FootSection::Circle { diameter_m: f64::NAN }, 4.0, 1.0, None).is_err());
    assert!(FreeColumns::new(1, SQUARE, 4.0, 1.0, Some(-1.0)).is_err());
}

/// A beam of mass `beam` on columns with the total mass `column`, b 0.5 m, h 4 m.
struct Masses {
    column: f64,
    beam: f64,
}

const B: f64 = 0.5;
const H: f64 = 4.0;
const G: f64 = 9.81;

impl Masses {
    /// θ'' for θ > 0, from the moments of all weights and inertia forces about the feet, over the moment of inertia.
    fn acceleration(&self, theta: f64, ground: f64) -> f64 {
        let alpha = B.atan2(H);
        let (middle, head) = (0.5 * H.hypot(B), H.hypot(B)); // foot to the centre of a column, to its head
        let inertia = self.column * ((B * B + H * H) / 12.0 + middle * middle) + self.beam * head * head;
        let arm = self.column * middle + self.beam * head;
        let side = if theta < 0.0 { -1.0 } else { 1.0 };
        let toward = alpha * side - theta;
        -arm * (G * toward.sin() + ground * toward.cos()) / inertia
    }

    /// Ratio of ω after the impact to before: Σ m v·φ is conserved, with φ the motion about the new edges, where the impulses do no
    /// work.
    fn kept(&self) -> f64 {
        let of = |x: f64, y: f64, x_new: f64| x * x_new + y * y; // v = ω (y, −x) about an edge
        let spin = self.column * (B * B + H * H) / 12.0;
        let before = self.column * of(B / 2.0, H / 2.0, -B / 2.0) + spin + self.beam * of(B, H, -B);
        let after = self.column * of(B / 2.0, H / 2.0, B / 2.0) + spin + self.beam * of(B, H, B);
        before / after
    }
}

#[test]
fn exact_impacts_of_a_rocking_frame() {
    for (column, beam) in [(1.0, 0.0), (1.0, 1.0), (1.0, 5.0), (0.0, 1.0)] {
        let frame = RockingBlock::frame_on_columns(B, H, beam / column, G).unwrap();
        let kept = Masses { column, beam }.kept();
        assert!(
            (frame.velocity_ratio - kept).abs() < 1e-14,
            "{} {kept}",
            frame.velocity_ratio
        );
    }
    let refused = RockingBlock::frame_on_columns(B, H, -1.0, G).unwrap_err();
    assert_eq!(
        refused.to_string(),
        "beam_to_columns is -1, but must be 0 or a positive number"
    );
}

#[test]
fn agrees_with_steps_in_time_of_a_rocking_frame() {
    // one second of a sine of 0.3 g and 1 Hz, then free: it lifts off, rocks and comes to rest
    let (beam, column) = (5.0, 1.0);
    let masses = Masses { column, beam };
    let shaking = |t: f64| if t <= 2.0 { 0.3 * G * (TAU * t).sin() } else { 0.0 };
    let frame = RockingBlock::frame_on_columns(B, H, beam / column, G).unwrap();
    let samples = (0..=2000).map(|i| shaking(i as f64 * 1e-3)).collect();
    let ground = TimeFunction::Sampled {
        time_step_s: 1e-3,
        values: samples,
    };
    let options = Rocking {
        duration_s: Some(6.0),
        output_step_s: 0.01,
        ..Rocking::default()
    };
    let run = rock_block(&frame, &ground, &TimeFunction::Zero, &options).unwrap();
    assert_eq!(run.outcome, RockingOutcome::Rocked);
    // at rest until the ground passes g tan α
    let lift_s = (B / H / 0.3).asin() / TAU;
    assert!((run.uplift_s.unwrap() - lift_s).abs() < 1e-5);
    const STEP: f64 = 1e-5;
    let (mut theta, mut omega, mut t) = (0.0_f64, 0.0_f64, lift_s);
    let mut sample = (lift_s / 0.01).ceil() as usize;
    let mut worst = 0.0_f64;
    let mut side = -1.0; // pushed back by the ground that moves to +x
    theta += side * 1e-12;
    let mut impacts = 0;
    while t < 4.0 {
        let slope = |theta: f64, t: f64| masses.acceleration(theta, shaking(t));
        let k1 = slope(theta, t);
        let middle = theta + 0.5 * STEP * omega;
        let k2 = slope(middle, t + 0.5 * STEP);
        let next = theta + STEP * omega + 0.5 * STEP * STEP * k2;
        let k3 = slope(next, t + STEP);
        let speed = omega + STEP * (k1 + 4.0 * k2 + k3) / 6.0;
        while sample as f64 * 0.01 <= t + STEP {
            let part = (sample as f64 * 0.01 - t) / STEP;
            worst = worst.max((theta + part * (next - theta) - run.rotation_rad[sample]).abs());
            sample += 1;
        }
        (theta, omega, t) = (next, speed, t + STEP);
        if theta * side <= 0.0 {
            side = -side;
            omega *= masses.kept();
            theta = theta.abs().max(1e-15) * side;
            impacts += 1;
        }
    }
    assert!(impacts >= 2, "{impacts}");
    assert!(
        worst < 2e-4 * run.peak_rotation_rad,
        "{worst} {}",
        run.peak_rotation_rad
    );
    // free motion: each impact takes 1 − r² of the energy, and no energy is lost between impacts
    let free: Vec<f64> = run
        .impacts
        .iter()
        .filter(|i| i.at_s > 2.0)
        .map(|i| i.velocity_rad_s)
        .collect();
    assert!(free.len() >= 3);
    for pair in free[1..].windows(2) {
        assert!(
            (pair[1] / pair[0] + frame.velocity_ratio).abs() < 1e-9,
            "{pair:?}"
        );
    }
    // under stronger shaking it falls
    let hard = TimeFunction::Sampled {
        time_step_s: 1e-3,
        values: (0..=2000).map(|i| 5.0 * shaking(i as f64 * 1e-3)).collect(),
    };
    let run = rock_block(&frame, &hard, &TimeFunction::Zero, &options).unwrap();
    assert!(
        matches!(run.outcome, RockingOutcome::Fell { .. }),
        "{:?}",
        run.outcome
    );
}
