//! Names and titles of simulations.

use super::units::seconds;
use dolmen::known::STANDARD_GRAVITY_M_S2;
use dolmen_project::Names;
use dolmen_words::message::Run;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};
use dolmen_work::motion::MotionAnswer;

messages! {
    /// Sentences of every simulation.
    pub(crate) enum Simulated in "simulated" {
        AsItIs => { en: "structure as it is", ko: "현 상태" },
        Earthquake(of: Sentence) => { en: "Simulated earthquake: {of}", ko: "지진응답 시뮬레이션: {of}" },
        Under { of: Sentence, motion: String, peak: Quantity, ending: Sentence } => {
            en: "{of}, under {motion} with a peak of {peak}: {ending}",
            ko: "{of}, {motion}(최대 {peak}) 작용 시: {ending}",
        },
        Cut { end: Quantity, whole: Quantity, ending: Sentence } => {
            en: "the run ended before the motion: {end} of its {whole} were run; no verdict. Until then: {ending}",
            ko: "지반운동이 끝나기 전에 해석을 마쳐 판정하지 않는다({whole} 중 {end}까지 해석). 그때까지: {ending}",
        },
        Stopped(at: Quantity) => {
            en: "the run was stopped at {at}, before its end: no verdict; all values are of the part that was done.",
            ko: "해석이 {at}에 중단되어 판정하지 않는다. 모든 값은 그때까지의 것이다.",
        },
        Ground => { en: "Acceleration of the ground.", ko: "지반 가속도." },
        GroundMeaning => { en: "As it acted.", ko: "해석에 적용한 값." },
        Energy => { en: "Where the energy went.", ko: "에너지 수지." },
        EnergyMeaning => {
            en: "Relative to the ground, all from the start.",
            ko: "지반에 대한 상대 운동 기준이며 시작부터 누적한 값이다.",
        },
    }
}

/// The variant by its title, or by its name in the file; `None` for the structure as it is.
pub(crate) fn version_name(variant: Option<&str>, title: Option<&Names>) -> Option<Sentence> {
    let run = |name: &str| vec![Run::Name(name.to_owned())];
    let name = |english, korean| Sentence::of_runs("name", run(english), run(korean));
    match title {
        Some(title) => Some(name(title.english(), title.korean())),
        None => variant.map(|variant| name(variant, variant)),
    }
}

/// How a version ended under a motion.
pub(crate) fn under(of: Sentence, motion: &MotionAnswer, peak_m_s2: f64, ending: Sentence) -> Sentence {
    let in_g = Unit {
        symbol: "g".to_owned(),
        factor: 1.0 / STANDARD_GRAVITY_M_S2,
    };
    Simulated::Under {
        of,
        motion: motion.motion.name().to_owned(),
        peak: Quantity::new(peak_m_s2, in_g, Digits::Significant(3)),
        ending,
    }
    .into()
}

/// The result of a run up to its end, which was before that of the motion.
pub(crate) fn cut(motion: &MotionAnswer, end_s: f64, ending: Sentence) -> Sentence {
    Simulated::Cut {
        end: seconds(end_s),
        whole: seconds(motion.motion.duration_s()),
        ending,
    }
    .into()
}

/// The sentence with a capital first letter; names stay unchanged.
pub(crate) fn capitalised(mut sentence: Sentence) -> Sentence {
    if let Some(Run::Text(text)) = sentence.english.first_mut() {
        let mut letters = text.chars();
        let first: String = letters.next().into_iter().flat_map(char::to_uppercase).collect();
        *text = first + letters.as_str();
    }
    sentence
}
