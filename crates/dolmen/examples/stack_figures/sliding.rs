//! Blocks that slide.

use super::*;

pub(crate) fn sine_history(k: f64, time_step_s: Option<f64>) -> StackHistory {
    let (g, step_s) = (9.80665, 2e-4);
    let wave = (0..=50_000).map(|i| 0.5 * g * (std::f64::consts::TAU * 2.0 * f64::from(i) * step_s).sin());
    let motion = GroundMotion::new("sine", step_s, vec![(Component::X, wave.collect())]).unwrap();
    let options = Springs {
        time_step_s,
        ..Springs::default()
    };
    run(&pile(1, material(k, 0.3), g), Some(&motion), &options)
}

pub(crate) fn slip_line(k: f64, history: &StackHistory, peak_m: f64, residual_m: f64) {
    let joint = &history.joints[0];
    let residual = joint.slip_m.last().unwrap()[0];
    println!(
        "k_n {k:.0e}: peak {:.4} mm ({:+.4} %), residual {:.4} mm ({:+.4} % of the peak); {}",
        1e3 * joint.peak_slip_m,
        100.0 * (joint.peak_slip_m / peak_m - 1.0),
        1e3 * residual,
        100.0 * (residual - residual_m) / peak_m,
        quality(history)
    );
}

pub(crate) fn sine() {
    let g = 9.80665;
    let exact = sine_slip(0.5 * g, 2.0, 10.0, 0.01, &Friction::single(0.3, g)).unwrap();
    println!(
        "exact {:.5} mm, {:.5} mm",
        1e3 * exact.peak_m,
        1e3 * exact.residual_m
    );
    for k in [1e9, 1e10, 1e11, 1e12] {
        slip_line(k, &sine_history(k, None), exact.peak_m, exact.residual_m);
    }
}

/// El Centro 1940 north-south scaled to a peak, m/s² every 0.02 s.
pub(crate) fn el_centro(peak_m_s2: f64) -> Vec<f64> {
    let text = include_str!("../../../../data/el_centro_1940_ns/el_centro_1940_ns.csv");
    let samples = text
        .lines()
        .skip(1)
        .filter_map(|line| line.split(',').nth(1)?.parse().ok());
    let samples: Vec<f64> = samples.collect();
    let peak = samples.iter().fold(0.0_f64, |most, a: &f64| most.max(a.abs()));
    samples.iter().map(|a| a / peak * peak_m_s2).collect()
}

pub(crate) fn record() {
    let base = el_centro(0.5 * GRAVITY_M_S2);
    let exact = record_slip(&base, 0.02, &Friction::single(0.2, GRAVITY_M_S2)).unwrap();
    let motion = GroundMotion::new("record", 0.02, vec![(Component::X, base)]).unwrap();
    println!(
        "exact {:.5} mm, {:.5} mm",
        1e3 * exact.peak_m,
        1e3 * exact.residual_m
    );
    for k in [1e9, 1e10, 1e11, 1e12] {
        let history = run(
            &pile(1, material(k, 0.2), GRAVITY_M_S2),
            Some(&motion),
            &Springs::default(),
        );
        slip_line(k, &history, exact.peak_m, exact.residual_m);
    }
}
