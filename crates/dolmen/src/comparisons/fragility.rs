//! Fragility and risk: Baker (2015), Cornell (1996).

use super::{Case, ValidationError};
use crate::assess::{
    Fragility, Hazard, Observation, annual_risk, fit_fragility, fit_fragility_by_moments, scatter_split,
    sufficiency,
};

/// Half of the last printed digit.
const SIX_DIGITS: f64 = 5e-7;
const FOUR_DIGITS: f64 = 5e-5;

/// Stripes of 40 motions, and the number of collapses in each.
const STRIPES: [(f64, usize); 8] = [
    (0.2, 0),
    (0.3, 0),
    (0.4, 0),
    (0.6, 4),
    (0.7, 6),
    (0.8, 13),
    (0.9, 12),
    (1.0, 16),
];
const CAPACITIES: [f64; 10] = [0.31, 0.36, 0.42, 0.44, 0.47, 0.52, 0.55, 0.58, 0.66, 0.83];

/// Anscombe's first data set: x, y.
const ANSCOMBE: [[f64; 2]; 11] = [
    [10.0, 8.04],
    [8.0, 6.95],
    [13.0, 7.58],
    [9.0, 8.81],
    [11.0, 8.33],
    [14.0, 9.96],
    [6.0, 7.24],
    [4.0, 4.26],
    [12.0, 10.84],
    [7.0, 4.82],
    [5.0, 5.68],
];

/// A regression compared with printed numbers; sufficiency uses it.
fn of_lines() -> Result<Vec<Case>, ValidationError> {
    let (x, y) = (ANSCOMBE.map(|pair| pair[0]), ANSCOMBE.map(|pair| pair[1]));
    let line = sufficiency(&y, &x)?;
    let row = |what: &str, published: f64, computed: f64, tolerance: f64| Case {
        source: "Anscombe (1973)",
        what: what.to_owned(),
        unit: "",
        published,
        computed,
        tolerance,
        corrected: None,
        note: "The line by which a study tells whether a measure of shaking is sufficient, on the first of four sets.",
    };
    Ok(vec![
        row("slope of a line through 11 points", 0.5, line.slope, 5e-4),
        row("its standard error", 0.118, line.slope_error, 5e-4),
        row("t of it", 4.24, line.slope / line.slope_error, 5e-3),
        Case {
            source: "R 4, anscombe",
            ..row("p of it", 0.00217, line.p_value, 5e-6)
        },
    ])
}

pub(super) fn cases() -> Result<Vec<Case>, ValidationError> {
    let stripes = STRIPES.map(|(intensity, reached)| Observation::Stripe {
        intensity,
        motions: 40,
        reached,
    });
    let stripes = fit_fragility(&stripes)?;
    let moments = fit_fragility_by_moments(&CAPACITIES)?;
    let hazard = Hazard::through(0.11, 475.0, 2.2)?;
    let risk = annual_risk(&hazard, &Fragility::new(0.40, 0.40)?);
    let row = |source, what: &str, published: f64, computed: f64, tolerance: f64| Case {
        source,
        what: what.to_owned(),
        unit: "",
        published,
        computed,
        tolerance,
        corrected: None,
        note: "",
    };
    // ln of the capacities of three samples under three motions: the motions differ by .4, the
    // samples by .3
    let table = [0.0, 0.3, -0.3]
        .map(|sample| [0.0, 0.4, 0.8].map(|motion: f64| Observation::At((sample + motion).exp())));
    let split = scatter_split(
        table.as_flattened(),
        &[0, 1, 2].repeat(3),
        &[0, 0, 0, 1, 1, 1, 2, 2, 2],
    )?;
    let (of_motions, of_inputs) =
        split.map_or((f64::NAN, f64::NAN), |split| (split.of_motions, split.of_inputs));
    let lines = of_lines()?;
    const BAKER: &str = "Baker (2015)";
    const BY_HAND: &str = "By hand";
    let mut all = vec![
        row(
            BAKER,
            "θ, 8 stripes of 40 motions, by likelihood",
            1.076116,
            stripes.curve.theta(),
            SIX_DIGITS,
        ),
        row(BAKER, "β of the same", 0.429237, stripes.curve.beta(), SIX_DIGITS),
        row(
            BY_HAND,
            "standard error of ln θ of the same",
            0.0717,
            stripes.ln_theta_error,
            FOUR_DIGITS,
        ),
        row(
            BY_HAND,
            "standard error of β of the same",
            0.0839,
            stripes.beta_error,
            FOUR_DIGITS,
        ),
        row(
            BY_HAND,
            "θ of 10 capacities, by moments",
            0.494866,
            moments.curve.theta(),
            SIX_DIGITS,
        ),
        row(
            BY_HAND,
            "β of the same",
            0.289162,
            moments.curve.beta(),
            SIX_DIGITS,
        ),
        row(
            BY_HAND,
            "scatter from motion to motion of 3 samples under 3 motions .4 apart in ln",
            0.326599,
            of_motions,
            SIX_DIGITS,
        ),
        row(
            BY_HAND,
            "scatter of the same from sample to sample, .3 apart",
            0.3,
            of_inputs,
            SIX_DIGITS,
        ),
        Case {
            unit: "1e-4/year",
            ..row(
                BY_HAND,
                "rate of a state, θ .40 g, β .40, .11 g in 475 years, k 2.2",
                1.811328,
                1e4 * risk.annual_rate,
                SIX_DIGITS,
            )
        },
        Case {
            unit: "%",
            ..row(
                BY_HAND,
                "its probability in 50 years",
                0.902,
                100.0 * risk.probability_in(50.0),
                5e-4,
            )
        },
    ];
    all.extend(lines);
    Ok(all)
}
