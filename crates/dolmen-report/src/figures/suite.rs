//! The spectra of a suite of motions, their mean and the demand.

use super::Figure;
use super::axis::Axis;
use super::ink::{BLACK, BLUE, GREY, Line};
use super::plot::{Key, Plot};
use super::words::{Axes, Titles, say};
use dolmen::known::STANDARD_GRAVITY_M_S2;
use dolmen_words::{Language, messages};
use dolmen_work::motion::SuiteAnswer;

messages! {
    /// Lines of the figure of a suite.
    pub(crate) enum SuiteLines in "figures.suite" {
        Members { count: usize } => { en: "{count} motions, each times its factor", ko: "배율을 적용한 지반운동 {count}개" },
        Mean => { en: "their mean", ko: "평균" },
        Least { percent: String, demand: String } => { en: "{demand}, and {percent} % of it", ko: "{demand}, 그 {percent} %" },
    }
}

/// Width and height, px.
const PX: [f64; 2] = [760.0, 420.0];

/// Each member, the mean, the demand and its required share.
pub fn suite_figure(answer: &SuiteAnswer, language: Language) -> Figure {
    let points = |values: &[f64], factor: f64| -> Vec<[f64; 2]> {
        let both = answer.periods_s.iter().zip(values);
        both.map(|(t, a)| [*t, factor * a / STANDARD_GRAVITY_M_S2])
            .collect()
    };
    let drawn = answer.members.iter().map(|member| &member.acceleration_m_s2);
    let all = drawn.chain([&answer.mean_m_s2, &answer.target_m_s2]).flatten();
    let most = all.fold(0.0_f64, |most, a| most.max(*a)) / STANDARD_GRAVITY_M_S2;
    let x = Axis::logarithmic(say(Axes::Period, language), &answer.periods_s, language);
    let y = Axis::linear(say(Axes::PseudoAcceleration, language), 0.0, 1.08 * most, 6);
    let mut plot = Plot::new(PX, x, y);
    let (one, mean) = (Line::new(GREY, 0.8), Line::new(BLUE, 2.4));
    let (demand, least) = (Line::new(BLACK, 1.8).dashed(), Line::new(BLACK, 0.8).dashed());
    for member in &answer.members {
        plot.line(points(&member.acceleration_m_s2, 1.0), one);
    }
    plot.line(points(&answer.mean_m_s2, 1.0), mean);
    plot.line(points(&answer.target_m_s2, 1.0), demand);
    plot.line(points(&answer.target_m_s2, answer.rule.least_share), least);
    let count = answer.members.len();
    plot.key(Key::Line(mean), say(SuiteLines::Mean, language));
    plot.key(Key::Line(one), say(SuiteLines::Members { count }, language));
    let of_demand = SuiteLines::Least {
        percent: dolmen_words::number::trimmed(100.0 * answer.rule.least_share, 1),
        demand: answer.demand.clone(),
    };
    plot.key(Key::Line(demand), say(of_demand, language));
    let percent = dolmen_words::number::trimmed(100.0 * answer.damping_ratio, 2);
    Figure {
        name: "suite".to_owned(),
        svg: plot.svg(say(Titles::ResponseSpectrum(percent), language)),
    }
}
