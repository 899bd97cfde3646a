//! Blocks that rock and overturn.

use super::sliding::sine_history;
use super::*;

pub(crate) fn rocker(normal_stiffness_pa_m: f64, damping_ratio: f64) -> Stack {
    let material = JointMaterial {
        damping_ratio,
        ..material(normal_stiffness_pa_m, 5.0)
    };
    Stack::new(
        vec![stone([2.0 * HALF_WIDTH_M, 1.0, 2.0 * HALF_HEIGHT_M], [0.0; 3])],
        material,
        GRAVITY_M_S2,
    )
    .unwrap()
}

pub(crate) fn tilts(history: &StackHistory) -> Vec<f64> {
    let samples = 0..history.time_s.len();
    samples
        .map(|sample| {
            let [w, _, y, _] = history.pose(sample, 0).rotation;
            2.0 * y.atan2(w)
        })
        .collect()
}

/// Times of the impacts, s, and the largest tilt before each and after the last, over α.
pub(crate) fn rocked(history: &StackHistory) -> (Vec<f64>, Vec<f64>) {
    let alpha = slenderness_rad(HALF_WIDTH_M, HALF_HEIGHT_M);
    let (mut impacts, mut peaks, mut peak) = (Vec::new(), Vec::new(), 0.0_f64);
    for (sample, pair) in tilts(history).windows(2).enumerate() {
        peak = peak.max(pair[0].abs());
        if pair[0] * pair[1] < 0.0 {
            let part = pair[0] / (pair[0] - pair[1]);
            let [from, to] = [history.time_s[sample], history.time_s[sample + 1]];
            impacts.push(from + part * (to - from));
            peaks.push(peak / alpha);
            peak = 0.0;
        }
    }
    peaks.push(peak / alpha);
    (impacts, peaks)
}

pub(crate) fn release(rule: ContactRule, duration_s: f64) -> Springs {
    Springs {
        contact_rule: rule,
        duration_s: Some(duration_s),
        output_step_s: 1e-3,
        starts: vec![Start {
            pivot_m: [HALF_WIDTH_M, 0.0, 0.0],
            turn_rad: [0.0, 0.5 * slenderness_rad(HALF_WIDTH_M, HALF_HEIGHT_M), 0.0],
            ..Start::of(0)
        }],
        ..Springs::default()
    }
}

pub(crate) fn rocking() {
    let alpha = slenderness_rad(HALF_WIDTH_M, HALF_HEIGHT_M);
    let p = frequency_parameter_rad_s(HALF_WIDTH_M, HALF_HEIGHT_M, GRAVITY_M_S2);
    let (r, released) = (velocity_ratio(alpha), 0.5 * alpha);
    let history = run(&rocker(1e10, 1.0), None, &release(ContactRule::Corners, 10.0));
    let (impacts, peaks) = rocked(&history);
    let off = |computed: f64, exact: f64| 100.0 * (computed / exact - 1.0);
    println!("{}", quality(&history));
    println!(
        "T/4 {:+.4} %",
        off(impacts[0], quarter_period_s(alpha, p, released))
    );
    let exact = impact_times_s(alpha, p, r, released, 20);
    let first: Vec<String> = (1..6)
        .map(|i| format!("{:+.3}", off(impacts[i], exact[i])))
        .collect();
    println!("impacts 2 to 6 {} %", first.join(" "));
    println!(
        "impact 20 {:+.3} % of {:.4} s",
        off(impacts[19], exact[19]),
        exact[19]
    );
    for impacts in [1, 5, 20] {
        let exact = amplitude_rad(alpha, r, released, impacts) / alpha;
        println!(
            "amplitude after {impacts}: {:.4} α, {:+.3} %",
            peaks[impacts as usize],
            off(peaks[impacts as usize], exact)
        );
    }
}

pub(crate) fn step() {
    let mut times = Vec::new();
    for step_s in [160e-6, 80e-6, 40e-6, 20e-6, 10e-6, 5e-6, 2.5e-6] {
        let options = Springs {
            time_step_s: Some(step_s),
            ..release(ContactRule::Corners, 10.0)
        };
        let history = run(&rocker(1e10, 1.0), None, &options);
        times.push((step_s, rocked(&history).0[19]));
    }
    let [.., (_, before), (_, last)] = times[..] else {
        return;
    };
    let limit = 2.0 * last - before; // first order
    for (step_s, time) in &times {
        println!(
            "{:.1} µs: impact 20 at {time:.5} s, {:+.5} s from {limit:.5}",
            1e6 * step_s,
            time - limit
        );
    }
    for step_s in [400e-6, 200e-6, 100e-6, 50e-6, 25e-6] {
        let history = sine_history(1e9, Some(step_s));
        println!(
            "{:.0} µs: peak slip {:.5} mm",
            1e6 * step_s,
            1e3 * history.joints[0].peak_slip_m
        );
    }
}

pub(crate) fn restitution() {
    for (rule, k, damping) in [
        (ContactRule::Corners, 1e10, 1.0),
        (ContactRule::Four, 1e9, 1.0),
        (ContactRule::Four, 1e9, 0.3),
        (ContactRule::Four, 1e9, 0.05),
        (ContactRule::Four, 1e10, 1.0),
        (ContactRule::Four, 1e10, 0.3),
        (ContactRule::Four, 1e10, 0.05),
        (ContactRule::Four, 1e9, 20.0),
    ] {
        let history = run(&rocker(k, damping), None, &release(rule, 1.6));
        let (_, peaks) = rocked(&history);
        println!(
            "{rule:?} k_n {k:.0e} damping {damping}: {:.4} α after one impact; {}",
            peaks[1],
            quality(&history)
        );
    }
}

pub(crate) fn overturning() {
    const STEP_S: f64 = 5e-4;
    let alpha = slenderness_rad(HALF_WIDTH_M, HALF_HEIGHT_M);
    let p = frequency_parameter_rad_s(HALF_WIDTH_M, HALF_HEIGHT_M, GRAVITY_M_S2);
    let falls = |shape: Pulse, q: f64, amplitude: f64| {
        let omega = q * p;
        let (end, wave): (f64, fn(f64) -> f64) = match shape {
            Pulse::HalfSine => (std::f64::consts::PI, f64::sin),
            Pulse::Sine => (std::f64::consts::TAU, f64::sin),
            Pulse::Cosine => (std::f64::consts::TAU, f64::cos),
        };
        let samples = (end / omega / STEP_S) as usize;
        let series =
            (0..=samples).map(|i| amplitude * alpha * GRAVITY_M_S2 * wave(omega * i as f64 * STEP_S));
        let motion = GroundMotion::new("pulse", STEP_S, vec![(Component::X, series.collect())]).unwrap();
        let options = Springs {
            contact_rule: ContactRule::Corners,
            duration_s: Some(4.0),
            output_step_s: 1e-3,
            ..Springs::default()
        };
        let history = run(&rocker(1e10, 1.0), Some(&motion), &options);
        let tilts = tilts(&history);
        let first = tilts
            .iter()
            .find(|tilt| tilt.abs() > 0.01)
            .copied()
            .unwrap_or(0.0);
        let struck = tilts.iter().any(|tilt| tilt * first < -1e-4);
        matches!(history.outcome, Outcome::Fell { .. }) && !struck
    };
    for shape in [Pulse::HalfSine, Pulse::Sine, Pulse::Cosine] {
        let mut off = Vec::new();
        for q in [1.0, 2.0, 3.0, 4.0] {
            let exact = first_overturning(shape, q, Equation::Exact, alpha, None).unwrap();
            let (mut stands, mut fallen) = (0.96 * exact, 1.04 * exact);
            for _ in 0..7 {
                let middle = 0.5 * (stands + fallen);
                match falls(shape, q, middle) {
                    true => fallen = middle,
                    false => stands = middle,
                }
            }
            off.push(format!("{:+.2}", 100.0 * (0.5 * (stands + fallen) / exact - 1.0)));
        }
        println!("{shape:?}, ω/p 1 to 4: {} %", off.join(" "));
    }
}

// Sliding and twisting: the stone of 300 × 200 × 100 mm.
