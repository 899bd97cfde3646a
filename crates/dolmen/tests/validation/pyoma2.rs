// SOURCE     pyOMA2 1.4.3, functions build_hank (method "cov"), SSI_fast, SSI_poles; run by bench/ssi_cov/agrees.py,
//            which prints the table below.
// GOAL       The same poles at every order from the same correlations.
//
//    one period of 600 samples, 3 channels:    two resonators under white force + white noise, repeated
//    |--------------|----|                     so that each window of one period holds the same sums of products,
//       600            15                      whichever samples a program starts from
//
// PARAMETERS 20 Hz, 8 block rows, orders 2 to 12.
// PUBLISHED  order, frequency (Hz), damping ratio.
// TOLERANCE  1e-6 relative, 1e-6 of damping: rounding of two programs, amplified by the least singular values (1e-8 found).

use dolmen::modal::{SsiCov, ssi_cov};
use dolmen::signal::{Channel, Record};

const PERIOD: usize = 600;
const BLOCK_ROWS: usize = 8;
const PUBLISHED: &[(usize, f64, f64)] = &[
    (2, 0.8675652556, 0.0660967831),
    (4, 0.8708677232, 0.0641913328),
    (4, 2.0923069397, 0.0211365019),
    (6, 0.8733820026, 0.0654628169),
    (6, 1.7074271178, 0.0388384084),
    (6, 2.0742152030, 0.0233502126),
    (8, 0.8782583415, 0.0655420781),
    (8, 1.9101669427, 0.1340451911),
    (8, 2.0704981859, 0.0137249055),
    (10, 0.8749319590, 0.0616071334),
    (10, 2.0878153219, 0.0104460782),
    (10, 2.1409068002, 0.2433106146),
    (10, 8.1917669620, 0.0215074259),
    (12, 0.8777708109, 0.0535389463),
    (12, 1.4894657822, 0.4628759122),
    (12, 2.0853841552, 0.0130321019),
    (12, 2.4477091069, 0.3661058539),
    (12, 6.3162807135, 0.0561318195),
    (12, 8.8079701857, 0.0516171409),
];

/// The record of agrees.py, sum by sum.
fn record() -> Record {
    let mut state: u32 = 2021;
    let resonators = [(1.90, -0.97), (1.55, -0.96)]; // x_t = a x_(t-1) + b x_(t-2) + u
    let shapes = [[1.0, 0.6, -0.3], [-0.5, 1.0, 0.8]];
    let mut past = [[0.0; 2]; 2];
    let mut rows = Vec::new();
    for t in 0..2 * PERIOD {
        let draws = [(); 5].map(|()| {
            state = state.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
            f64::from(state) / 4_294_967_296.0 - 0.5
        });
        for (((a, b), p), u) in resonators.iter().zip(&mut past).zip(draws) {
            *p = [a * p[0] + b * p[1] + u, p[0]];
        }
        if t >= PERIOD {
            rows.push(
                [0, 1, 2].map(|c| shapes[0][c] * past[0][0] + shapes[1][c] * past[1][0] + draws[2 + c]),
            );
        }
    }
    let n = PERIOD + 2 * BLOCK_ROWS - 1;
    let channel = |c: usize| {
        let mean = (0..n).map(|t| rows[t % PERIOD][c]).sum::<f64>() / n as f64;
        (0..n).map(|t| rows[t % PERIOD][c] - mean).collect()
    };
    let names = ["a", "b", "c"].map(Channel::named).to_vec();
    Record::new(names, (0..3).map(channel).collect(), 20.0).unwrap()
}

#[test]
fn agrees_with_pyoma2_on_every_pole_of_every_order() {
    let options = SsiCov {
        block_rows: BLOCK_ROWS,
        order_most: 12,
        time_blocks: 2,
        ..Default::default()
    };
    let found = ssi_cov(&record(), &options).unwrap();
    assert_eq!(found.poles.len(), PUBLISHED.len());
    for (pole, &(order, frequency_hz, damping_ratio)) in found.poles.iter().zip(PUBLISHED) {
        assert_eq!(pole.order, order);
        assert!(
            (pole.frequency_hz / frequency_hz - 1.0).abs() < 1e-6,
            "{pole:?}, {frequency_hz}"
        );
        assert!(
            (pole.damping_ratio - damping_ratio).abs() < 1e-6,
            "{pole:?}, {damping_ratio}"
        );
    }
}
