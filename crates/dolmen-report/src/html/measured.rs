//! What surveys say against the model: a tilt that overturns, a frequency that the model does not have.

use super::finding::{Finding, Tone};
use dolmen::stability::Verdict;
use dolmen_words::Language;
use dolmen_words::number::significant;
use dolmen_work::state::{FrequencyContradiction, State, TiltCheck};

/// Digits of a frequency or a tilt in a sentence.
const DIGITS: usize = 3;

pub(super) fn findings(state: &State, language: Language) -> Vec<Finding> {
    let tilts = state.tilts.iter().map(|tilt| tilt_finding(tilt, language));
    let contradictions = state
        .contradictions
        .iter()
        .map(|found| contradiction(found, language));
    tilts.chain(contradictions).collect()
}

fn tilt_finding(tilt: &TiltCheck, language: Language) -> Finding {
    let one_in = |ratio: f64| format!("1/{}", significant(1.0 / ratio.abs(), DIGITS));
    let (measured, direction, survey) = (one_in(tilt.tilt), &tilt.direction, &tilt.survey);
    let Some(limit) = tilt.uplift_tilt else {
        return Finding::new(
            Tone::Unknown,
            language.pick(
                format!("The tilt of {measured} measured in direction {direction} (survey {survey}) is not checked against overturning: that needs the joints' stiffness and bed widths."),
                format!("{direction} 방향 실측 기울기 {measured}({survey} 조사)에 대한 전도 검토는 하지 못하였다. 접합부 강성과 접합면 폭이 필요하다."),
            ),
        );
    };
    let limit = one_in(limit);
    match tilt.verdict() {
        Verdict::Unstable => Finding::new(
            Tone::Bad,
            language.pick(
                format!("The measured tilt of {measured} in direction {direction} (survey {survey}) is beyond {limit}, at which a bed stands on its edge: it overturns, whatever the load factor."),
                format!("{direction} 방향 실측 기울기 {measured}({survey} 조사)는 접합면이 모서리로만 지지되는 한계 {limit}을 넘는다. 하중배율과 관계없이 전도된다."),
            ),
        ),
        verdict => Finding::of(
            verdict,
            language.pick(
                format!("The measured tilt of {measured} in direction {direction} (survey {survey}) compares with {limit}, at which a bed stands on its edge; beds begin to open at a third of that."),
                format!("{direction} 방향 실측 기울기 {measured}({survey} 조사)는 접합면이 모서리로만 지지되는 한계 {limit}보다 작다. 접합면은 그 3분의 1에서 벌어지기 시작한다."),
            ),
        ),
    }
}

fn contradiction(found: &FrequencyContradiction, language: Language) -> Finding {
    let (measured, computed) = (
        significant(found.measured_hz, DIGITS),
        significant(found.computed_hz, DIGITS),
    );
    let (survey, direction) = (&found.survey, &found.direction);
    Finding::new(
        Tone::Bad,
        language.pick(
            format!("Survey {survey} measured {measured} Hz in direction {direction}; this model has {computed} Hz. Its stiffness or mass is not that of the structure measured, and the verdict is on the model."),
            format!("{survey} 조사의 {direction} 방향 실측 고유진동수는 {measured} Hz이나 해석 모델은 {computed} Hz이다. 모델의 강성 또는 질량이 실제와 다르며, 판정은 모델에 대한 것이다."),
        ),
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn holds_a_tilt_beyond_the_limit_is_bad_and_one_without_limit_unknown() {
        let tilt = |tilt: f64, uplift_tilt| TiltCheck {
            survey: "s".into(),
            direction: "x".into(),
            tilt,
            uplift_tilt,
        };
        let beyond = tilt_finding(&tilt(0.2, Some(0.1)), Language::English);
        assert!(
            beyond.tone == Tone::Bad && beyond.text.contains("1/5.00") && beyond.text.contains("1/10.0"),
            "{beyond:?}"
        );
        assert_eq!(
            tilt_finding(&tilt(0.2, None), Language::Korean).tone,
            Tone::Unknown
        );
        assert_eq!(
            tilt_finding(&tilt(-0.001, Some(0.1)), Language::English).tone,
            Tone::Good
        );
    }
}
