// SOURCE     closed forms of random vibration; EN 1991-1-4:2005, Annex B; Davenport (1964).
// GOAL       A structure in a turbulent wind: variances, peak factors, dampers.
// PARAMETERS one mass, one strip; two floors; a twisting floor with a tuned mass, a liquid column, a column on a spring and a link.
// TOLERANCE  5e-5 against the quadrature here (the integral is accurate to 2e-5 of a variance); narrow band and Annex B as each
//            test states.

use dolmen::damper::{AttachedDamper, DampedSystem, DamperError, DamperKind, gust_motion, judge};
use dolmen::dynamics::{LinearSystem, RandomInput, RandomLoad, Spectrum};
use dolmen::structure::wind::{
    COHERENCE_DECAY, EurocodeTerrain, EurocodeWind, GustFace, GustStrip, Turbulence, TurbulenceSpectrum,
    Wind, WindBody, WindError,
};
use dolmen_linalg::{Complex64, Matrix};
use std::f64::consts::{PI, TAU};

const TEN_MINUTES_S: f64 = 600.0;

fn strip(bottom_m: f64, top_m: f64, breadth_m: f64, wind: Turbulence) -> GustStrip {
    GustStrip {
        bottom_m,
        top_m,
        breadth_m,
        force_coefficient: 1.3,
        wind,
    }
}

fn face(strips: Vec<GustStrip>, coherence_decay: f64) -> GustFace {
    GustFace {
        strips,
        air_density_kg_m3: 1.25,
        spectrum: TurbulenceSpectrum::Kaimal,
        coherence_decay,
    }
}

fn mean(speed: f64) -> Turbulence {
    Turbulence {
        mean_speed_m_s: speed,
        intensity: 0.18,
        length_m: 120.0,
    }
}

/// A mass on a spring, kg, Hz, damping ratio.
fn mass(kg: f64, hz: f64, zeta: f64) -> LinearSystem {
    let omega = TAU * hz;
    let one = |x: f64| Matrix::from_diagonal(&[x]);
    LinearSystem::new(one(kg), one(2.0 * zeta * omega * kg), one(kg * omega * omega)).unwrap()
}

/// σ² and σ_ẍ² of a mass under the force on one strip, by Simpson's rule in ln n with 400 000 steps.
fn simpson(kg: f64, hz: f64, zeta: f64, density: impl Fn(f64) -> f64) -> [f64; 2] {
    let (low, high, steps) = (1e-7_f64.ln(), 1e4_f64.ln(), 400_000_u32);
    let step = (high - low) / f64::from(steps);
    let mut sums = [0.0; 2];
    for k in 0..=steps {
        let n = (low + step * f64::from(k)).exp();
        let weight = if k == 0 || k == steps {
            1.0
        } else {
            f64::from(2 + 2 * (k % 2))
        };
        let r = n / hz;
        let stiffness = kg * (TAU * hz).powi(2);
        let h2 = 1.0 / (stiffness * stiffness * ((1.0 - r * r).powi(2) + (2.0 * zeta * r).powi(2)));
        let value = weight * step / 3.0 * n * h2 * density(n);
        sums[0] += value;
        sums[1] += value * (TAU * n).powi(4);
    }
    sums
}

fn one_column() -> Vec<Vec<Vec<f64>>> {
    vec![vec![vec![1.0]]]
}

#[test]
fn agrees_with_own_quadrature_for_one_mass() {
    let wind = mean(28.0);
    let (height, breadth) = (30.0, 20.0);
    let face = face(vec![strip(0.0, height, breadth, wind)], COHERENCE_DECAY);
    // written again: ρ C_f A V, 6.8 f/(1 + 10.2 f)^(5/3), J of both lengths
    let admitted = |x: f64| 2.0 * (x - 1.0 + (-x).exp()) / (x * x);
    let density = |n: f64| {
        let f = n * wind.length_m / wind.mean_speed_m_s;
        let sigma = wind.intensity * wind.mean_speed_m_s;
        let speed = sigma * sigma * 6.8 * f / (1.0 + 10.2 * f).powf(5.0 / 3.0) / n;
        let c = COHERENCE_DECAY * n / wind.mean_speed_m_s;
        let whole = match c * height < 1e-3 {
            true => 1.0 - c * (height + breadth) / 3.0,
            false => admitted(c * height) * admitted(c * breadth),
        };
        (1.25 * 1.3 * height * breadth * wind.mean_speed_m_s).powi(2) * speed * whole
    };
    for (kg, hz, zeta) in [
        (3e5, 0.2, 0.01),
        (3e5, 1.0, 0.02),
        (1e5, 6.0, 0.05),
        (1e6, 0.05, 0.3),
    ] {
        let motion = &gust_motion(&mass(kg, hz, zeta), &[], &face, &one_column(), TEN_MINUTES_S).unwrap()[0];
        let [moved, pushed] = simpson(kg, hz, zeta, density);
        let (x, a) = (motion.displacement(&[1.0]), motion.acceleration(&[1.0]));
        assert!(
            (x.rms.powi(2) / moved - 1.0).abs() < 5e-5,
            "{hz} {} {moved}",
            x.rms.powi(2)
        );
        assert!(
            (a.rms.powi(2) / pushed - 1.0).abs() < 5e-5,
            "{hz} {} {pushed}",
            a.rms.powi(2)
        );
        let still = 0.5 * 1.25 * 1.3 * height * breadth * 784.0 / (kg * (TAU * hz).powi(2));
        assert!((x.mean / still - 1.0).abs() < 1e-12);
        // Davenport: ν T crossings, g = √(2 ln νT) + 0.5772/√(2 ln νT)
        let s = (2.0 * (x.up_crossing_hz * TEN_MINUTES_S).ln()).sqrt();
        assert!((x.peak_factor - s - 0.577_215_664_9 / s).abs() < 1e-9);
        assert!((x.peak() - x.mean - x.peak_factor * x.rms).abs() < 1e-12);
    }
}

#[test]
fn exact_a_narrow_band_sees_white_noise() {
    // ζ = 0.05 %: σ² = σ_slow² + π n S_F(n)/(4 ζ k²), and accelerations from the resonance alone
    let (kg, hz, zeta) = (4e5, 0.4, 5e-4);
    let face = face(vec![strip(0.0, 40.0, 25.0, mean(30.0))], COHERENCE_DECAY);
    let motion = &gust_motion(&mass(kg, hz, zeta), &[], &face, &one_column(), TEN_MINUTES_S).unwrap()[0];
    let stiffness = kg * (TAU * hz).powi(2);
    let resonant = PI * hz * face.force_density_n2_hz(hz)[(0, 0)] / (4.0 * zeta * stiffness * stiffness);
    let a = motion.acceleration(&[1.0]);
    let ratio = a.rms.powi(2) / (resonant * (TAU * hz).powi(4));
    assert!((ratio - 1.0).abs() < 0.01, "{ratio}");
    assert!((a.up_crossing_hz / hz - 1.0).abs() < 0.02, "{}", a.up_crossing_hz);
}

#[test]
fn agrees_with_annex_b_of_the_eurocode_in_resonance() {
    // one mode and one strip over the whole height, the wind at z_s = 0.6 h everywhere, C = 9.2: J J = R_h R_b
    let eurocode = Wind::Eurocode(EurocodeWind {
        basic_speed_m_s: 28.0,
        terrain: EurocodeTerrain::Iii,
        orography: 1.0,
        air_density_kg_m3: 1.25,
    });
    let (h, b, hz, zeta) = (60.0, 24.0, 0.5, 0.004);
    let wind = eurocode.turbulence_at(0.6 * h).unwrap();
    let face = face(vec![strip(0.0, h, b, wind)], 9.2);
    let motion = &gust_motion(&mass(1e6, hz, zeta), &[], &face, &one_column(), TEN_MINUTES_S).unwrap()[0];
    // R² by hand: B.2, B.6 to B.8
    let f_l = hz * wind.length_m / wind.mean_speed_m_s;
    let spectrum = 6.8 * f_l / (1.0 + 10.2 * f_l).powf(5.0 / 3.0);
    let admitted = |size: f64| {
        let eta = 4.6 * size * hz / wind.mean_speed_m_s;
        1.0 / eta - (1.0 - (-2.0 * eta).exp()) / (2.0 * eta * eta)
    };
    let resonant = PI * PI / (2.0 * TAU * zeta) * spectrum * admitted(h) * admitted(b);
    // σ_ẍ = ω² x̄ 2 I_v √R²
    let still = motion.displacement(&[1.0]).mean;
    let by_code = (TAU * hz).powi(2) * still * 2.0 * wind.intensity * resonant.sqrt();
    let computed = motion.acceleration(&[1.0]).rms;
    // the non-resonant part adds some per cent to the acceleration
    assert!((computed / by_code - 1.0).abs() < 0.02, "{computed} {by_code}");
    // displacement: B² of the code is a bound fitted to measured gusts; here ∫ J J S
    let background = 1.0 / (1.0 + 0.9 * ((b + h) / wind.length_m).powf(0.63));
    let by_code = still * 2.0 * wind.intensity * (background + resonant).sqrt();
    let ratio = motion.displacement(&[1.0]).rms / by_code;
    assert!((0.9..1.05).contains(&ratio), "{ratio}");
    // peak factor of the code, 1 + 2 k_p I_v √(B² + R²) over 1 + 7 I_v, compared with mean + g σ
    let body = WindBody {
        height_m: h,
        breadth_m: b,
        frequency_hz: Some(hz),
        damping_ratio: Some(zeta),
    };
    let factor = eurocode.pressure(&body).unwrap().response_factor * (1.0 + 7.0 * wind.intensity);
    let peak = motion.displacement(&[1.0]).peak() / still;
    assert!((peak / factor - 1.0).abs() < 0.06, "{peak} {factor}");
}

#[test]
fn exact_a_stiff_mass_follows_the_gusts() {
    // σ = σ_F/k with σ_F² of the total force: no resonance at 60 Hz
    let wind = mean(25.0);
    let face = face(vec![strip(0.0, 10.0, 8.0, wind)], COHERENCE_DECAY);
    let (kg, hz) = (1e5, 60.0);
    let motion = &gust_motion(&mass(kg, hz, 0.05), &[], &face, &one_column(), TEN_MINUTES_S).unwrap()[0];
    let soft = simpson(1.0, 1e5, 1.0, |n| face.force_density_n2_hz(n)[(0, 0)]);
    let force = soft[0] * (TAU * 1e5).powi(4);
    let stiffness = kg * (TAU * hz).powi(2);
    let ratio = motion.displacement(&[1.0]).rms * stiffness / force.sqrt();
    assert!((ratio - 1.0).abs() < 2e-4, "{ratio}");
}

#[test]
fn exact_two_floors_under_one_gust_and_under_gusts_apart() {
    // two equal masses on separate springs: the sum is twice under one gust, √2 under independent gusts
    let wind = mean(25.0);
    let alone = mass(2e5, 0.8, 0.02);
    let pair = |matrix: &Matrix| Matrix::from_diagonal(&[matrix[(0, 0)]; 2]);
    let both = LinearSystem::new(pair(alone.mass()), pair(alone.damping()), pair(alone.stiffness())).unwrap();
    let columns = vec![vec![vec![1.0, 0.0], vec![0.0, 1.0]]];
    let sum = |gap: f64, decay: f64| {
        let strips = vec![strip(0.0, 4.0, 6.0, wind), strip(4.0 + gap, 8.0 + gap, 6.0, wind)];
        let motion = &gust_motion(&both, &[], &face(strips, decay), &columns, TEN_MINUTES_S).unwrap()[0];
        motion.displacement(&[1.0, 1.0]).rms / motion.displacement(&[1.0, 0.0]).rms
    };
    assert!((sum(0.0, 0.0) - 2.0).abs() < 1e-9);
    assert!((sum(1e7, COHERENCE_DECAY) - 2.0_f64.sqrt()).abs() < 1e-3);
    let between = sum(0.0, COHERENCE_DECAY);
    assert!((2.0_f64.sqrt()..2.0).contains(&between), "{between}");
}

/// A floor that sways and twists: u, v, θ.
fn twisting() -> LinearSystem {
    let (m, inertia) = (2e5, 2e5 * 14.0);
    let k = Matrix::from_rows(&[[4e6, 0.0, 6e5], [0.0, 3e6, -2e6], [6e5, -2e6, 6e7]]);
    let mass = Matrix::from_diagonal(&[m, m, inertia]);
    LinearSystem::new(mass.clone(), k.scaled(0.005), k).unwrap()
}

#[test]
fn agrees_with_assembled_matrices_for_dampers_of_every_kind() {
    let structure = twisting();
    let row = |x: f64, y: f64, angle: f64| vec![angle.cos(), angle.sin(), x * angle.sin() - y * angle.cos()];
    let dampers = vec![
        AttachedDamper {
            kind: DamperKind::TunedMass {
                mass_kg: 4e3,
                frequency_hz: 0.63,
                damping_ratio: 0.1,
            },
            row: row(3.0, 1.0, 1.2),
        },
        AttachedDamper {
            kind: DamperKind::LiquidColumn {
                liquid_mass_kg: 3e3,
                length_ratio: 0.7,
                frequency_hz: 0.7,
                damping_ratio: 0.08,
            },
            row: row(-2.0, 2.0, 0.2),
        },
        AttachedDamper {
            kind: DamperKind::LiquidColumnMass {
                container_mass_kg: 1e3,
                liquid_mass_kg: 2e3,
                length_ratio: 0.6,
                frequency_hz: 0.6,
                damping_ratio: 0.1,
                liquid_frequency_hz: 0.8,
                liquid_damping_ratio: 0.07,
            },
            row: row(1.0, -3.0, 1.5),
        },
        AttachedDamper {
            kind: DamperKind::Viscous {
                coefficient_n_s_m: 2e4,
            },
            row: row(4.0, 0.0, 1.57),
        },
    ];
    let face = face(vec![strip(5.0, 10.0, 12.0, mean(24.0))], COHERENCE_DECAY);
    let column = vec![1.0, 0.0, -0.8];
    let motion = &gust_motion(
        &structure,
        &dampers,
        &face,
        &[vec![column.clone()]],
        TEN_MINUTES_S,
    )
    .unwrap()[0];
    let damped = DampedSystem::new(&structure, &dampers).unwrap();
    // by one solution of the assembled equations at each of 30 000 frequencies
    let (low, high, steps) = (1e-6_f64.ln(), 300.0_f64.ln(), 30_000);
    let step = (high - low) / f64::from(steps);
    let mut rows: Vec<Vec<f64>> = vec![damped.row(&[0.0, 1.0, 2.0])];
    rows.extend(damped.stroke_rows());
    let mut sums = vec![0.0; rows.len()];
    for k in 0..steps {
        let n = (low + step * (f64::from(k) + 0.5)).exp();
        let x = damped
            .system
            .frequency_response(TAU * n, &damped.row(&column))
            .unwrap();
        let density = face.force_density_n2_hz(n)[(0, 0)];
        for (sum, row) in sums.iter_mut().zip(&rows) {
            let moved: Complex64 = row.iter().zip(&x).map(|(a, x)| x * *a).sum();
            *sum += step * n * density * moved.norm_sqr();
        }
    }
    let mut found = vec![motion.displacement(&[0.0, 1.0, 2.0]).rms];
    found.extend(motion.strokes.iter().map(|stroke| stroke.rms));
    assert_eq!(found.len(), 6);
    for (k, (rms, sum)) in found.iter().zip(&sums).enumerate() {
        assert!((rms / sum.sqrt() - 1.0).abs() < 5e-5, "{k}: {rms} {}", sum.sqrt());
    }
    // the ends of the link move apart in the mean wind, a mass does not
    let still = motion.strokes[3].mean;
    let ends: f64 = dampers[3].row.iter().zip(&motion.mean).map(|(a, x)| a * x).sum();
    assert!((still / ends - 1.0).abs() < 1e-12 && motion.strokes[0].mean == 0.0);
}

#[test]
fn exact_the_worst_direction_is_that_of_the_principal_axes() {
    let face = face(vec![strip(5.0, 10.0, 12.0, mean(24.0))], COHERENCE_DECAY);
    let motion = &gust_motion(
        &twisting(),
        &[],
        &face,
        &[vec![vec![1.0, 0.0, -0.8]]],
        TEN_MINUTES_S,
    )
    .unwrap()[0];
    let [x, y] = [[1.0, 0.0, -2.0], [0.0, 1.0, 3.0]];
    let worst = motion.acceleration(&motion.most_accelerated([&x, &y])).rms;
    let along = |degrees: f64| {
        let (sin, cos) = degrees.to_radians().sin_cos();
        let row: Vec<f64> = x.iter().zip(&y).map(|(x, y)| cos * x + sin * y).collect();
        motion.acceleration(&row).rms
    };
    let looked = (0..1800).map(|k| along(0.1 * f64::from(k))).fold(0.0, f64::max);
    assert!((worst / looked - 1.0).abs() < 1e-5, "{worst} {looked}");
}

#[test]
fn agrees_tuning_with_the_whole_field() {
    // six masses on springs, a tuned mass on the highest; with the force patterns and cross spectra that tuning uses
    let n = 6;
    let k = Matrix::from_fn(n, n, |i, j| match i.abs_diff(j) {
        0 => 8e7 * if i + 1 == n { 1.0 } else { 2.0 },
        1 => -8e7,
        _ => 0.0,
    });
    let m = Matrix::from_diagonal(&vec![2e5; n]);
    let structure = LinearSystem::new(m, k.scaled(0.004), k).unwrap();
    let strips: Vec<GustStrip> = (0..n)
        .map(|i| {
            strip(
                4.0 * i as f64,
                4.0 * (i as f64 + 1.0),
                15.0,
                mean(18.0 + 2.0 * i as f64),
            )
        })
        .collect();
    let face = face(strips, COHERENCE_DECAY);
    let unit = |i: usize| (0..n).map(|j| f64::from(u8::from(i == j))).collect::<Vec<f64>>();
    let columns: Vec<Vec<f64>> = (0..n).map(unit).collect();
    let hz = structure.modes().unwrap().angular_frequency_rad_s[0] / TAU;
    let damper = AttachedDamper {
        kind: DamperKind::TunedMass {
            mass_kg: 1e4,
            frequency_hz: 0.95 * hz,
            damping_ratio: 0.1,
        },
        row: unit(n - 1),
    };
    let motion = &gust_motion(
        &structure,
        std::slice::from_ref(&damper),
        &face,
        &[columns],
        TEN_MINUTES_S,
    )
    .unwrap()[0];
    let loads: Vec<RandomLoad> = face
        .independent_shapes(hz, 0.0)
        .unwrap()
        .into_iter()
        .map(|shape| RandomLoad {
            input: RandomInput::Force(shape.clone()),
            spectrum: Spectrum::Gusts {
                face: Box::new(face.clone()),
                shape,
            },
        })
        .collect();
    let points = [unit(n - 1), unit(0)];
    let judged = judge(&structure, &loads, &points, &[damper]).unwrap();
    for (row, rms) in points.iter().zip(&judged.point_rms) {
        let whole = motion.displacement(row).rms;
        assert!((rms / whole - 1.0).abs() < 5e-5, "{rms} {whole}");
    }
    let stroke = motion.strokes[0].rms;
    assert!(
        (judged.stroke_rms_m[0] / stroke - 1.0).abs() < 0.01,
        "{:?} {stroke}",
        judged.stroke_rms_m
    );
}

#[test]
fn refuses_columns_that_do_not_fit_and_faces_that_cannot_be() {
    let wind = mean(24.0);
    let structure = mass(1e5, 1.0, 0.02);
    let whole = face(vec![strip(0.0, 5.0, 8.0, wind)], COHERENCE_DECAY);
    let short = gust_motion(&structure, &[], &whole, &[vec![]], TEN_MINUTES_S).unwrap_err();
    assert!(short.to_string().contains("columns"), "{short}");
    let flat = face(vec![strip(5.0, 5.0, 8.0, wind)], COHERENCE_DECAY);
    let error = gust_motion(&structure, &[], &flat, &one_column(), TEN_MINUTES_S).unwrap_err();
    let expected = WindError::NotPositive {
        quantity: "strip_height_m",
        given: 0.0,
    };
    assert_eq!(error, DamperError::Wind(expected));
}
