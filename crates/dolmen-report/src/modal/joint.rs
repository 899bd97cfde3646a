//! Setups of one survey identified as one.

use super::notes::note_words;
use super::shapes::{ShapeFigures, shape_figures};
use super::tables::{modes_table, shapes_table};
use super::values::{fixed, hertz};
use crate::document::{Block, Document};
use dolmen::modal::JointSetups;
use dolmen_words::{Digits, Quantity, Unit, messages};

messages! {
    /// Setups identified as one.
    pub(crate) enum Joint in "modal.joint" {
        Head { survey: String } => {
            en: "Setups identified as one: {survey}",
            ko: "측정 배치의 일괄 식별: {survey}",
        },
        Rests { sensors: usize, references: Vec<String>, strength: Vec<Quantity>, rows: usize, rate: Quantity, order: usize, low: Quantity, high: Quantity } => {
            en: "{sensors} sensors; in every setup: {references}; strength of their motion, setup by setup: {strength}. {rows} block rows at {rate}, model orders to {order}, modes sought between {low} and {high}.",
            ko: "센서 {sensors}개; 모든 배치에 있는 센서: {references}; 배치별 그 운동의 세기: {strength}. 블록 행 {rows}개({rate}), 모델 차수 {order}까지, 모드 탐색 범위 {low}–{high}.",
        },
        NoMode => { en: "No mode was found.", ko: "모드를 찾지 못하였다." },
        Caption => {
            en: "Modes of all setups identified as one (PreGER), ± standard deviation.",
            ko: "모든 배치를 하나로 식별한 모드(PreGER), ± 표준편차.",
        },
        Meaning => {
            en: "Correlations brought to the shaking of the first setup and stacked. These are the modes of the survey; the means above are beside them.",
            ko: "상관함수를 첫 배치의 가진 수준으로 환산하여 쌓았다. 이 값이 조사의 모드이며 위의 평균은 비교용이다.",
        },
    }
}

/// The basis of the joint identification of all setups, and its modes.
pub(super) fn section<'a>(document: &mut Document<'a>, survey: &str, joint: &'a JointSetups) {
    document.heading(Joint::Head {
        survey: survey.to_owned(),
    });
    let references = joint.references.iter();
    let references = references.filter_map(|&at| joint.modes.channels.get(at));
    let [low, high] = joint.settings.range_hz.map(hertz);
    let rate_hz = joint.settings.sampling_rate_hz;
    document.paragraph(Joint::Rests {
        sensors: joint.modes.channels.len(),
        references: references.map(|channel| channel.name.clone()).collect(),
        strength: joint.strength.iter().map(|of| fixed(*of, 3)).collect(),
        rows: joint.settings.block_rows,
        rate: Quantity::new(rate_hz, Unit::si("Hz"), Digits::Trimmed(6)),
        order: joint.settings.order_most,
        low,
        high,
    });
    if joint.modes.modes.is_empty() {
        document.paragraph(Joint::NoMode);
    } else {
        let caption = vec![Joint::Caption.into(), Joint::Meaning.into()];
        document.put(Block::Table(modes_table(&joint.modes, caption)));
        document.put(Block::Table(shapes_table(&joint.modes)));
        shape_figures(document, &joint.modes, ShapeFigures::Joint);
    }
    for note in &joint.notes {
        document.note(note_words(note));
    }
}
