//! Adaptive integration of several functions at once, to a tolerance.

/// Nodes of Kronrod's 15-point rule on (−1, 1). The nodes with odd index are those of Gauss's 7-point rule. Piessens et
/// al. (1983) QUADPACK, QK15.
const NODES: [f64; 8] = [
    0.991_455_371_120_812_6,
    0.949_107_912_342_758_5,
    0.864_864_423_359_769_1,
    0.741_531_185_599_394_4,
    0.586_087_235_467_691_1,
    0.405_845_151_377_397_2,
    0.207_784_955_007_898_47,
    0.0,
];
const KRONROD: [f64; 8] = [
    0.022_935_322_010_529_224,
    0.063_092_092_629_978_55,
    0.104_790_010_322_250_18,
    0.140_653_259_715_525_92,
    0.169_004_726_639_267_9,
    0.190_350_578_064_785_4,
    0.204_432_940_075_298_9,
    0.209_482_141_084_727_82,
];
const GAUSS: [f64; 4] = [
    0.129_484_966_168_869_7,
    0.279_705_391_489_276_7,
    0.381_830_050_505_118_9,
    0.417_959_183_673_469_4,
];

/// A node of an integration rule and its weight.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Node {
    pub(crate) x: f64,
    pub(crate) weight: f64,
}

/// Nodes and weights of 15-point rules on intervals that are short enough to integrate each function to `tolerance`
/// times its integral over the whole range. The functions must not change sign. `None` if this takes more than
/// `intervals_most` intervals, or if `functions` returns `None`.
///
/// `breaks` are ascending: both ends of the range, and points of special interest between them. An interval is halved
/// while the 7-point and 15-point rules differ by more than the interval's share of the tolerance.
pub(crate) fn adaptive_nodes(
    breaks: &[f64],
    tolerance: f64,
    intervals_most: usize,
    mut functions: impl FnMut(f64) -> Option<Vec<f64>>,
) -> Option<Vec<Node>> {
    let mut open: Vec<Interval> = Vec::new();
    for pair in breaks.windows(2).filter(|pair| pair[1] > pair[0]) {
        open.push(interval(pair[0], pair[1], &mut functions)?);
    }
    let mut count = open.len();
    let whole = |all: &[Interval], done: &[Interval]| -> Vec<f64> {
        let mut sums = vec![0.0; all.first().or(done.first()).map_or(0, |i| i.integrals.len())];
        for part in all.iter().chain(done) {
            for (sum, value) in sums.iter_mut().zip(&part.integrals) {
                *sum += value;
            }
        }
        sums
    };
    let mut done: Vec<Interval> = Vec::new();
    while !open.is_empty() {
        let total = whole(&open, &done);
        let mut next = Vec::new();
        for part in open {
            let fine = part.errors.iter().zip(&total).all(|(error, total)| {
                *error <= tolerance * total.abs() / (count.max(16) as f64) || *error <= f64::MIN_POSITIVE
            });
            let middle = 0.5 * (part.low + part.high);
            if fine || middle <= part.low || middle >= part.high {
                done.push(part);
            } else {
                next.push(interval(part.low, middle, &mut functions)?);
                next.push(interval(middle, part.high, &mut functions)?);
                count += 1;
                if count > intervals_most {
                    return None;
                }
            }
        }
        open = next;
    }
    done.sort_by(|a, b| a.low.total_cmp(&b.low));
    Some(
        done.iter()
            .flat_map(|part| nodes_15(part.low, part.high))
            .collect(),
    )
}

struct Interval {
    low: f64,
    high: f64,
    integrals: Vec<f64>,
    errors: Vec<f64>,
}

/// Kronrod's 15-point rule, exact for polynomials up to degree 22.
pub(crate) fn nodes_15(low: f64, high: f64) -> Vec<Node> {
    let (middle, half) = (0.5 * (low + high), 0.5 * (high - low));
    let mut nodes = Vec::with_capacity(15);
    for (i, (node, weight)) in NODES.iter().zip(KRONROD).enumerate() {
        let weight = half * weight;
        nodes.push(Node {
            x: middle - half * node,
            weight,
        });
        if i < 7 {
            nodes.push(Node {
                x: middle + half * node,
                weight,
            });
        }
    }
    nodes.sort_by(|a, b| a.x.total_cmp(&b.x));
    nodes
}

fn interval(low: f64, high: f64, functions: &mut impl FnMut(f64) -> Option<Vec<f64>>) -> Option<Interval> {
    let half = 0.5 * (high - low);
    let (mut fine, mut coarse) = (Vec::new(), Vec::new());
    for (i, node) in nodes_15(low, high).into_iter().enumerate() {
        let values = functions(node.x)?;
        if i == 0 {
            fine = vec![0.0; values.len()];
            coarse = vec![0.0; values.len()];
        }
        let gauss = if i % 2 == 1 {
            half * GAUSS[(i / 2).min(6 - i / 2)]
        } else {
            0.0
        };
        for (k, value) in values.into_iter().enumerate() {
            fine[k] += node.weight * value;
            coarse[k] += gauss * value;
        }
    }
    let errors = fine.iter().zip(&coarse).map(|(a, b)| (a - b).abs()).collect();
    Some(Interval {
        low,
        high,
        integrals: fine,
        errors,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_a_narrow_peak() {
        // ∫ over (0, 10) of d / ((x − 1)² + d²) dx
        let d = 1e-4_f64;
        let peak = |x: f64| d / ((x - 1.0) * (x - 1.0) + d * d);
        let nodes = adaptive_nodes(&[0.0, 1.0, 10.0], 1e-12, 1000, |x| Some(vec![peak(x)])).unwrap();
        let sum: f64 = nodes.iter().map(|node| node.weight * peak(node.x)).sum();
        let exact = (9.0 / d).atan() + (1.0 / d).atan();
        assert!((sum / exact - 1.0).abs() < 1e-12, "{sum} {exact}");
        assert!(adaptive_nodes(&[0.0, 10.0], 1e-12, 3, |x| Some(vec![peak(x)])).is_none());
    }
}
