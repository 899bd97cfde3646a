//! The most likely mode over white noise in the finest lines of a spectrum.

/// Least ratio of a mode at a sine to the surrounding noise, and least width of the mode in lines; below these limits there is no mode.
pub(super) const MODE_OVER_NOISE: f64 = 10.0;
pub(super) const MODE_WIDE: f64 = 4.0;

/// A mode over white noise.
pub(super) struct OneMode {
    /// Expected power of each line.
    pub(super) model: Vec<f64>,
    /// Half of the half-power width, lines.
    pub(super) half_width: f64,
    /// Peak value over the noise.
    pub(super) over_noise: f64,
    /// Power of the mode at its maximum.
    pub(super) top: f64,
    /// Line of this maximum.
    pub(super) centre: f64,
    /// Σ (ln m + P/m) of the lines that were used.
    pub(super) cost: f64,
}

/// The powers, none of them zero; `None` if all are.
pub(super) fn floored(power: Vec<f64>) -> Option<Vec<f64>> {
    let floor = power.iter().sum::<f64>() / power.len() as f64 * 1e-12;
    (floor > 0.0).then(|| power.into_iter().map(|p| p.max(floor)).collect())
}

/// Power of a mode `line`s from its centre, relative to its peak.
pub(super) fn lorentz(line: usize, centre: f64, half_width: f64) -> f64 {
    1.0 / (1.0 + ((line as f64 - centre) / half_width).powi(2))
}

/// Σ ln v of values between 1e-36 and 1e36, from the logarithms of products of 8.
pub(super) fn sum_of_logarithms(mut values: impl Iterator<Item = f64>) -> f64 {
    let mut sum = 0.0;
    loop {
        let mut product = 1.0;
        let mut taken = 0;
        for v in values.by_ref().take(8) {
            product *= v;
            taken += 1;
        }
        sum += f64::ln(product);
        if taken < 8 {
            return sum;
        }
    }
}

/// The most likely mode over white noise, not narrower than `narrowest` lines, fitted without the lines `without`.
pub(super) fn fitted(power: &[f64], without: &[usize], narrowest: f64) -> OneMode {
    let used: Vec<usize> = (0..power.len()).filter(|i| !without.contains(i)).collect();
    // power of the lines before each one, zero for excluded lines
    let mut before = vec![0.0];
    for (i, p) in power.iter().enumerate() {
        before.push(before[i] + if without.contains(&i) { 0.0 } else { *p });
    }
    let (mut least, mut best) = (f64::INFINITY, (0.0, narrowest, 1.0, 0.0));
    let mut half_width = narrowest;
    while half_width < power.len() as f64 {
        let smooth = half_width.ceil() as usize;
        let sum = |i: usize| before[(i + smooth + 1).min(power.len())] - before[i.saturating_sub(smooth)];
        let middle = used
            .iter()
            .copied()
            .max_by(|a, b| sum(*a).total_cmp(&sum(*b)))
            .unwrap_or(0);
        for shift in [-0.8, -0.4, 0.0, 0.4, 0.8] {
            let c = middle as f64 + shift * half_width;
            let mode: Vec<f64> = used.iter().map(|&i| lorentz(i, c, half_width)).collect();
            for step in 0..=8 {
                let beta = 10f64.powf(1.0 - 0.6 * f64::from(step));
                let shape = mode.iter().map(|mode| mode + beta);
                let s = used
                    .iter()
                    .zip(shape.clone())
                    .map(|(&i, shape)| power[i] / shape)
                    .sum::<f64>()
                    / used.len() as f64;
                let cost = used.len() as f64 * s.ln() + sum_of_logarithms(shape);
                if cost < least {
                    (least, best) = (cost, (c, half_width, beta, s));
                }
            }
        }
        half_width *= 1.5;
    }
    let (c, half_width, beta, s) = best;
    OneMode {
        model: (0..power.len())
            .map(|i| s * (lorentz(i, c, half_width) + beta))
            .collect(),
        half_width,
        over_noise: 1.0 / beta,
        top: s,
        centre: c,
        cost: least + used.len() as f64,
    }
}
