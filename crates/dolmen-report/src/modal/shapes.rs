//! Figures of shapes at the sensors, still and moving.

use super::tables::shapes_table;
use crate::document::{Document, Figure, table_series};
use crate::figures::{likeness, likeness_series, moving_shapes, sensor_shapes};
use dolmen::modal::Modes;
use dolmen_words::{Language, Sentence, messages};

messages! {
    /// Captions of shapes at the sensors.
    pub(crate) enum Shapes in "modal.shapes" {
        AtSensors => { en: "Mode shapes at the sensors.", ko: "센서 위치의 모드형상." },
        AtSensorsMeaning => {
            en: "Only what the channels measured, along their directions; the longest drawn alike in each mode.",
            ko: "채널이 계측한 방향의 성분만 표시하였으며 모드마다 최댓값을 같게 그렸다.",
        },
        OfSetups => {
            en: "Mode shapes at the sensors of all setups.",
            ko: "모든 배치의 센서 위치 모드형상.",
        },
        OfSetupsMeaning => {
            en: "Each setup is scaled to the others at the sensors that stayed.",
            ko: "각 배치는 고정 센서를 기준으로 척도를 맞추었다.",
        },
        OfJoint => {
            en: "Mode shapes at the sensors of all setups, from one identification.",
            ko: "일괄 식별로 얻은 모든 배치의 센서 위치 모드형상.",
        },
        Likeness => {
            en: "Likeness of the mode shapes (MAC), and their components in the complex plane.",
            ko: "모드형상의 유사도(MAC)와 복소평면상의 성분.",
        },
        LikenessMeaning => {
            en: "MAC 1: the same shape at these sensors, 0: nothing in common; two modes above 0.5 are hardly told apart by these sensors. Components on one line (MPC 1) move in or against phase, as in a mode of a lightly damped structure; spread out, they are of close modes, of noise, or of clocks that differ.",
            ko: "MAC 1은 이 센서에서 같은 형상, 0은 공통 성분이 없음을 뜻하며, 0.5를 넘는 두 모드는 이 센서로는 구별하기 어렵다. 성분이 한 직선에 놓이면(MPC 1) 감쇠가 작은 구조물의 모드처럼 동위상 또는 역위상으로 움직이는 것이고, 흩어지면 가까운 모드, 잡음 또는 서로 다른 시계의 영향이다.",
        },
        Moving => {
            en: "The same as lines between the sensors, enlarged; twelve modes at most. In a browser they move.",
            ko: "센서를 이은 모드형상(과장, 최대 12개). 웹브라우저에서는 움직인다.",
        },
        MovingMeaning => {
            en: "Grey: at rest. Lines only join sensors; between them nothing was measured.",
            ko: "회색: 정지 상태. 선은 센서를 이을 뿐 그 사이는 계측하지 않았다.",
        },
    }
}

/// The source of the shapes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ShapeFigures {
    /// One record.
    Record,
    /// Setups put together.
    Setups,
    /// Setups identified as one.
    Joint,
}

/// The shapes, and animated shapes if the sensors have positions.
pub(super) fn shape_figures<'a>(document: &mut Document<'a>, modes: &'a Modes, of: ShapeFigures) {
    let caption: Vec<Sentence> = match of {
        ShapeFigures::Record => vec![Shapes::AtSensors.into(), Shapes::AtSensorsMeaning.into()],
        ShapeFigures::Setups => vec![Shapes::OfSetups.into(), Shapes::OfSetupsMeaning.into()],
        ShapeFigures::Joint => vec![Shapes::OfJoint.into()],
    };
    let still = Figure::drawn(caption, |language| sensor_shapes(modes, language));
    document.charted(still.with_series(|| table_series(&shapes_table(modes))));
    if of != ShapeFigures::Joint && likeness(modes, Language::English).is_some() {
        let caption = vec![Shapes::Likeness.into(), Shapes::LikenessMeaning.into()];
        let alike = Figure::drawn(caption, |language| likeness(modes, language).unwrap_or_default());
        document.charted(alike.with_series(|| likeness_series(modes)));
    }
    if of != ShapeFigures::Joint && moving_shapes(modes, Language::English).is_some() {
        let caption = vec![Shapes::Moving.into(), Shapes::MovingMeaning.into()];
        let moving = Figure::drawn(caption, |language| {
            moving_shapes(modes, language).unwrap_or_default()
        });
        document.charted(moving.with_series(|| table_series(&shapes_table(modes))));
    }
}
