//! Figures of answers: the load factor under uncertain inputs, and variants side by side.

use super::axis::Axis;
use super::ink::{
    Anchor, BLACK, BLUE, GREY, Label, Line, ORANGE, SKY, Shape, VERMILLION, verdict_colour, verdict_shape,
};
use super::plot::{Key, Plot};
use super::words::{Axes, Signs, Titles, say};
use dolmen::assess::Probability;
use dolmen::stability::Verdict;
use dolmen_words::Language;
use dolmen_words::number;

/// Bars of the histogram at most.
const BARS_MOST: usize = 40;

/// Fewest bars of the histogram.
const BARS_LEAST: usize = 8;

/// Histogram of the load factor λ over samples, with the limits 1 (falls) and 1.5 (marginal), the nominal value, and the
/// share of falls with its interval.
pub fn load_factor_distribution(
    samples: &[f64],
    falls: &Probability,
    nominal: Option<f64>,
    language: Language,
) -> String {
    let finite: Vec<f64> = samples.iter().copied().filter(|s| s.is_finite()).collect();
    let marks = [Some(1.0), Some(Verdict::MARGINAL_BELOW), nominal];
    let all: Vec<f64> = finite
        .iter()
        .copied()
        .chain(marks.into_iter().flatten())
        .collect();
    let x = Axis::around(say(Axes::LoadFactor, language), &all, 8);
    let bars = ((finite.len() as f64).sqrt() as usize).clamp(BARS_LEAST, BARS_MOST);
    let (least, most) = finite
        .iter()
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), &s| {
            (a.min(s), b.max(s))
        });
    let width = ((most - least) / bars as f64).max(f64::MIN_POSITIVE);
    let mut counts = vec![0usize; bars];
    for sample in &finite {
        let bar = (((sample - least) / width) as usize).min(bars - 1);
        counts[bar] += 1;
    }
    let tallest = counts.iter().copied().max().unwrap_or(0).max(1) as f64;
    let y = Axis::linear(say(Axes::Samples, language), 0.0, 1.32 * tallest, 4);
    let mut plot = Plot::new([680.0, 300.0], x, y);
    if plot.x.from < 1.0 {
        plot.block([plot.x.from, 0.0], [1.0, plot.y.to], VERMILLION, 0.12);
    }
    for (i, count) in counts.iter().enumerate() {
        let from = least + i as f64 * width;
        // a gap between bars keeps them separate in print
        plot.block(
            [from + 0.06 * width, 0.0],
            [from + 0.94 * width, *count as f64],
            SKY,
            0.9,
        );
    }
    plot.upright(1.0, Line::new(VERMILLION, 1.8));
    plot.upright(Verdict::MARGINAL_BELOW, Line::new(ORANGE, 1.8).dashed());
    if let Some(nominal) = nominal {
        plot.upright(nominal, Line::new(BLACK, 1.8));
        let words = format!(
            "{} λ = {}",
            say(Signs::Nominal, language),
            number::beside_one(nominal, 4)
        );
        plot.key(Key::Line(Line::new(BLACK, 1.8)), words);
    }
    plot.key(
        Key::Line(Line::new(VERMILLION, 1.8)),
        say(Signs::FactorOneFalls, language),
    );
    let marginal = format!(
        "λ = {}: {}",
        number::significant(Verdict::MARGINAL_BELOW, 2),
        say(Signs::BelowItMarginal, language)
    );
    plot.key(Key::Line(Line::new(ORANGE, 1.8).dashed()), marginal);
    let share = format!(
        "P(λ ≤ 1) = {} [{}, {}]",
        number::significant(falls.estimate, 2),
        number::significant(falls.lower, 2),
        number::significant(falls.upper, 2)
    );
    plot.text(
        [plot.x.to, plot.y.to],
        [-6.0, 14.0],
        Label::new(share, Anchor::End).bold(),
    );
    let counted = format!(
        "{} / {} {}, {}{}% {}",
        falls.count,
        falls.samples,
        say(Signs::Samples, language),
        number::trimmed(100.0 * falls.confidence, 3),
        number::NARROW_SPACE,
        say(Signs::Interval, language)
    );
    plot.text(
        [plot.x.to, plot.y.to],
        [-6.0, 31.0],
        Label::new(counted, Anchor::End).small(),
    );
    plot.svg(say(Titles::DistributionOfTheLoadFactor, language))
}

/// One variant in [`variants_compared`].
#[derive(Clone, Debug, PartialEq)]
pub struct VariantDot {
    /// Its name.
    pub name: String,
    /// λ; `None` if unknown.
    pub load_factor: Option<f64>,
    /// The verdict under its weight alone.
    pub verdict: Verdict,
    /// Margin of each joint or storey, lowest first; `None` if no stiffness is sufficient.
    pub margins: Vec<Option<f64>>,
}

/// Load factor and margins of each variant on one axis, the first on top, with the limits 1 and 1.5.
pub fn variants_compared(variants: &[VariantDot], language: Language) -> String {
    let rows: Vec<String> = variants.iter().rev().map(|v| v.name.clone()).collect();
    let margins = variants.iter().flat_map(|v| v.margins.iter().flatten().copied());
    let mut all: Vec<f64> = margins
        .chain(variants.iter().filter_map(|v| v.load_factor))
        .collect();
    all.extend([1.0, Verdict::MARGINAL_BELOW]);
    let finite: Vec<f64> = all.into_iter().filter(|v| v.is_finite()).collect();
    let name = say(Axes::FactorAndMargins, language);
    let x = Axis::logarithmic(name, &finite, language);
    let mut plot = Plot::new([680.0, 96.0 + 44.0 * rows.len() as f64], x, Axis::rows(&rows));
    plot.block([plot.x.from, plot.y.from], [1.0, plot.y.to], VERMILLION, 0.12);
    plot.upright(1.0, Line::new(VERMILLION, 1.6));
    plot.upright(Verdict::MARGINAL_BELOW, Line::new(ORANGE, 1.6).dashed());
    for (row, variant) in variants.iter().rev().enumerate() {
        let row = row as f64;
        for margin in variant.margins.iter().flatten() {
            plot.sized_dot([*margin, row - 0.2], Shape::Ring, 4.0, GREY);
        }
        if let Some(load_factor) = variant.load_factor {
            let verdict = variant.verdict;
            let at = [load_factor, row + 0.14];
            plot.sized_dot(at, verdict_shape(verdict), 6.0, verdict_colour(verdict));
            let label = Label::new(number::beside_one(load_factor, 4), Anchor::Start).bold();
            plot.text(at, [11.0, 0.0], label);
        } else {
            let unknown = Label::new(say(Signs::Unknown, language), Anchor::Start);
            plot.text([1.0, row + 0.14], [10.0, 0.0], unknown);
        }
    }
    plot.key(
        Key::Dot(Shape::Circle, BLUE),
        say(Signs::FactorByVerdict, language),
    );
    plot.key(
        Key::Dot(Shape::Ring, GREY),
        say(Signs::MarginsOfJointsOrStoreys, language),
    );
    plot.key(
        Key::Line(Line::new(VERMILLION, 1.6)),
        say(Signs::OneFalls, language),
    );
    let marginal = format!(
        "{}: {}",
        number::significant(Verdict::MARGINAL_BELOW, 2),
        say(Signs::BelowItMarginal, language)
    );
    plot.key(Key::Line(Line::new(ORANGE, 1.6).dashed()), marginal);
    plot.svg(say(Titles::VariantsCompared, language))
}
