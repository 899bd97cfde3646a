//! What changed between two surveys, in the report.

use super::finding::{Finding, Tone};
use super::table::{Cell, figure, table};
use super::words::listed;
use crate::figures::survey_changes;
use dolmen::assess::{ChangeNote, Difference, ModeChange, SurveyChange, TemperatureKnowledge};
use dolmen::modal::ObservedMode;
use dolmen_words::Language;
use dolmen_words::advice::Advice as _;
use dolmen_words::number::{significant, with_sd};
use maud::{Markup, html};

fn percent(share: f64, decimals: usize) -> String {
    format!("{:+.decimals$}\u{202f}%", 100.0 * share).replace('-', "\u{2212}")
}

fn hertz(modes: &[ObservedMode], language: Language) -> String {
    let all: Vec<String> = modes
        .iter()
        .map(|m| format!("{}\u{202f}Hz", significant(m.frequency_hz, 4)))
        .collect();
    listed(&all, language)
}

pub(super) fn findings(change: &SurveyChange, language: Language) -> Vec<Finding> {
    let (from, to) = (&change.from, &change.to);
    let tested = change.tested();
    let changed = change.changed().count();
    let known = change.modes.len() + change.lost.len();
    let least = change.detectable().map(|d| significant(100.0 * d, 2));
    let (alpha, power) = (
        significant(100.0 * change.significance, 1),
        significant(100.0 * change.power, 2),
    );
    let mut all = doubts(change, language);
    all.extend(damping(change, language));
    all.extend(match least {
        None if change.modes.is_empty() => vec![Finding::new(
            Tone::Unknown,
            language.pick(
                format!("Surveys {from} and {to}: no frequency of one was found again in the other, so nothing could be compared (other directions, or too far apart)."),
                format!("{from} 조사와 {to} 조사: 서로 대응하는 고유진동수가 없어 비교할 수 없다(방향이 다르거나 차이가 너무 크다)."),
            ),
        )],
        None => vec![Finding::new(
            Tone::Unknown,
            language.pick(
                format!("Surveys {from} and {to}: whether a frequency changed cannot be said, since no standard deviations are known."),
                format!("{from} 조사와 {to} 조사: 표준편차를 알 수 없어 고유진동수의 변화 여부를 판단할 수 없다."),
            ),
        )],
        Some(least) if changed == 0 => vec![Finding::new(
            Tone::Plain,
            language.pick(
                format!("From survey {from} to {to} no change was shown in {tested} of {known} frequencies. A change of {least}\u{202f}% would have been seen with {power}\u{202f}% probability; smaller ones could have been missed."),
                format!("{from} 조사에서 {to} 조사까지 고유진동수 {known}개 중 비교한 {tested}개에서 변화가 확인되지 않았다. {least}\u{202f}%의 변화는 {power}\u{202f}%의 확률로 발견되었을 것이나 그보다 작은 변화는 놓쳤을 수 있다."),
            ),
        )],
        Some(_) => vec![Finding::new(
            Tone::Warn,
            language.pick(
                format!("From survey {from} to {to} {changed} of {tested} frequencies changed beyond chance ({alpha}\u{202f}% for all together)."),
                format!("{from} 조사에서 {to} 조사까지 고유진동수 {tested}개 중 {changed}개가 우연을 넘어 변하였다(전체 유의수준 {alpha}\u{202f}%)."),
            ),
        )],
    });
    if change.temperature.leaves_doubt() {
        all.push(Finding::new(Tone::Unknown, temperature(change, language)));
    }
    all
}

/// Which damping ratios changed beyond chance.
fn damping(change: &SurveyChange, language: Language) -> Option<Finding> {
    let each: Vec<String> = change
        .damping_changed()
        .map(|(mode, d)| {
            format!(
                "{}\u{202f}Hz {}",
                significant(mode.from.frequency_hz, 4),
                percent(d.relative, 0)
            )
        })
        .collect();
    let (count, tested) = (each.len(), change.damping_tested());
    let (from, to, alpha) = (
        &change.from,
        &change.to,
        significant(100.0 * change.significance, 1),
    );
    let each = each.join(", ");
    (count > 0).then(|| {
        Finding::new(
            Tone::Warn,
            language.pick(
                format!("From survey {from} to {to} {count} of {tested} damping ratios changed beyond chance ({alpha}\u{202f}% for all together): {each}. Damping follows the strength of the motion too; at equal strength, joints or cracks that rub do this before any frequency moves."),
                format!("{from} 조사에서 {to} 조사까지 감쇠비 {tested}개 중 {count}개가 우연을 넘어 변하였다(전체 유의수준 {alpha}\u{202f}%): {each}. 감쇠비는 진동의 세기에 따라서도 변하나, 세기가 같다면 접합부나 균열의 마찰로 진동수보다 먼저 변할 수 있다."),
            ),
        )
    })
}

/// What was not compared at all, and how else modes may be paired.
fn doubts(change: &SurveyChange, language: Language) -> Vec<Finding> {
    let hz = |frequency_hz: f64| format!("{}\u{202f}Hz", significant(frequency_hz, 4));
    let mut all = Vec::new();
    if !change.other_pairing_hz.is_empty() {
        let pairs = change.other_pairing_hz.iter();
        let each: Vec<String> = pairs
            .map(|[before, after]| format!("{} → {}", hz(*before), hz(*after)))
            .collect();
        let each = each.join(", ");
        all.push(Finding::new(
            Tone::Warn,
            language.pick(
                format!("Which mode is which is not sure: more of them find a partner by {each}. What follows rests on the nearest pairs."),
                format!("모드의 대응이 확실하지 않다. {each}로 대응시키면 더 많은 모드가 짝을 이룬다. 아래 결과는 가장 가까운 대응에 따른다."),
            ),
        ));
    }
    for lost in &change.not_compared {
        let before = hz(lost.from.frequency_hz);
        let (which, which_ko) = if lost.is_lowest {
            ("The lowest mode", "가장 낮은 모드")
        } else {
            ("A mode", "모드")
        };
        let (mut english, mut korean) = (
            format!("{which} ({before}) was not found again and is not compared."),
            format!("{which_ko}({before})가 다시 확인되지 않아 비교하지 못하였다."),
        );
        if let (Some(may_be), Some([r, stiffness])) = (&lost.may_be, lost.change()) {
            let after = hz(may_be.frequency_hz);
            let (mac, mac_ko) = match lost.assurance {
                Some(mac) => (
                    format!(", its shape alike (MAC {mac:.2})"),
                    format!(", MAC {mac:.2}"),
                ),
                None => (String::new(), String::new()),
            };
            english += &format!(
                " A new one lies at {after}{mac}: if it is the same mode, it changed by {} ({} of stiffness).",
                percent(r, 0),
                percent(stiffness, 0)
            );
            korean += &format!(
                " 새로 확인된 {after}{mac_ko}가 같은 모드라면 변화는 {}(강성 {})이다.",
                percent(r, 0),
                percent(stiffness, 0)
            );
        }
        all.push(Finding::new(Tone::Warn, language.pick(english, korean)));
    }
    all
}

fn temperature(change: &SurveyChange, language: Language) -> String {
    let step = |c: f64| format!("{c:+.1}").replace('-', "\u{2212}");
    match &change.temperature {
        TemperatureKnowledge::NotMeasured => language
            .pick(
                "The temperature of one of the two surveys is not known: a change of frequency may be the weather's.",
                "두 조사 중 한 조사의 기온을 알 수 없으므로 고유진동수의 변화는 기온에 의한 것일 수 있다.",
            )
            .into(),
        TemperatureKnowledge::Same => language
            .pick("Both surveys at the same temperature.", "두 조사의 기온이 같다.")
            .into(),
        TemperatureKnowledge::Unexplained { step_c } => language.pick(
            format!("The temperatures of the two surveys differ by {}\u{202f}°C, and what that does to this structure is not known: a change of frequency may be the weather's.", step(*step_c)),
            format!("두 조사의 기온이 {}\u{202f}°C 다르고 기온의 영향을 알 수 없으므로 고유진동수의 변화는 기온에 의한 것일 수 있다.", step(*step_c)),
        ),
        TemperatureKnowledge::Corrected { step_c } => language.pick(
            format!("The temperatures of the two surveys differ by {}\u{202f}°C; what that explains is taken out.", step(*step_c)),
            format!("두 조사의 기온이 {}\u{202f}°C 다르며 그 영향은 제거하였다.", step(*step_c)),
        ),
    }
}

/// The section on two surveys.
pub(super) fn section(change: Option<&SurveyChange>, language: Language) -> Markup {
    let Some(change) = change else {
        return html! {};
    };
    let (from, to) = (&change.from, &change.to);
    let power = significant(100.0 * change.power, 2);
    html! {
        h2 { (language.pick("What changed", "조사 사이의 변화")) ": " (from) " – " (to) }
        p { (temperature(change, language)) }
        @if !change.modes.is_empty() {
            (figure(&survey_changes(change, language), &language.pick(
                format!("Relative change of each frequency with its 95 % interval. A change within the grey band is found with less than {power} % probability."),
                format!("고유진동수별 상대 변화와 95 % 구간. 회색 띠 안의 변화가 발견될 확률은 {power} % 미만이다."),
            )))
            (frequencies(change, language))
            (dampings(change, language))
        }
        @for sentence in remarks(change, language) { p.note { (sentence) } }
        p { (language.pick(
            "No change shown is no proof that nothing changed. Frequencies also follow moisture, added mass and the strength of the motion; the stiffness column holds only if stiffness changed alike everywhere and no mass did.",
            "변화가 확인되지 않았다는 것은 변화가 없다는 증명이 아니다. 고유진동수는 습도, 부가 질량, 진동의 세기에 따라서도 변하며, 강성 열은 강성이 전체에서 같은 비율로 변하고 질량이 변하지 않았을 때에만 성립한다.",
        )) }
    }
}

fn difference(d: &Difference, decimals: usize) -> [Cell; 3] {
    let value = percent(d.relative, decimals);
    match &d.evidence {
        None => [value.into(), "–".into(), "–".into()],
        Some(e) => {
            let text = format!("{value} ± {:.decimals$}", 100.0 * e.half_width_95);
            let text = if e.significant {
                Cell::bad(text)
            } else {
                text.into()
            };
            let p = if e.p_holm < 1e-4 {
                "< 0.0001".to_owned()
            } else {
                format!("{:.4}", e.p_holm)
            };
            [
                text,
                p.into(),
                format!("{:.decimals$}\u{202f}%", 100.0 * e.detectable).into(),
            ]
        }
    }
}

fn frequencies(change: &SurveyChange, language: Language) -> Markup {
    let head = [
        language.pick("Mode", "모드"),
        language.pick("before (Hz)", "이전 (Hz)"),
        language.pick("after (Hz)", "이후 (Hz)"),
        language.pick("explained by temperature", "기온 영향"),
        language.pick("change, 95 % interval", "변화, 95 % 구간"),
        language.pick("p of all", "전체 p"),
        language.pick("seen from", "발견 가능"),
        language.pick("stiffness, if uniform", "강성(균일 가정)"),
        language.pick("MAC", "MAC"),
    ]
    .map(str::to_owned);
    let hz = |m: &ObservedMode| with_sd(m.frequency_hz, m.frequency_sd_hz.unwrap_or(0.0));
    let rows: Vec<Vec<Cell>> = change
        .modes
        .iter()
        .enumerate()
        .map(|(i, mode)| {
            let explained = mode
                .explained_by_temperature
                .map_or("–".to_owned(), |r| percent(r, 2));
            let mut row: Vec<Cell> = vec![
                (i + 1).to_string().into(),
                hz(&mode.from).into(),
                hz(&mode.to).into(),
                explained.into(),
            ];
            row.extend(difference(&mode.frequency, 2));
            row.push(percent(mode.uniform_stiffness, 1).into());
            row.push(
                mode.pair
                    .assurance
                    .map_or("–".into(), |mac| format!("{mac:.3}").into()),
            );
            row
        })
        .collect();
    let caption = language.pick(
        "Frequencies, ± standard deviation. p of all is the probability that any of these changes would look so by chance (Holm); changes from \"seen from\" on are found with the power stated.",
        "고유진동수, ± 표준편차. 전체 p는 우연만으로 이러한 변화가 하나라도 나타날 확률(Holm)이며, 발견 가능은 명시한 검정력으로 발견되는 최소 변화이다.",
    );
    table(caption, 1, &head, &rows)
}

fn dampings(change: &SurveyChange, language: Language) -> Markup {
    let known: Vec<(usize, &ModeChange, &Difference)> = change
        .modes
        .iter()
        .enumerate()
        .filter_map(|(i, mode)| Some((i, mode, mode.damping.as_ref()?)))
        .collect();
    if known.is_empty() {
        return html! {};
    }
    let head = [
        language.pick("Mode", "모드"),
        language.pick("before (%)", "이전 (%)"),
        language.pick("after (%)", "이후 (%)"),
        language.pick("change, 95 % interval", "변화, 95 % 구간"),
        language.pick("p of all", "전체 p"),
        language.pick("seen from", "발견 가능"),
    ]
    .map(str::to_owned);
    let zeta = |m: &ObservedMode| {
        let value = 100.0 * m.damping_ratio.unwrap_or(f64::NAN);
        with_sd(value, 100.0 * m.damping_ratio_sd.unwrap_or(0.0))
    };
    let rows: Vec<Vec<Cell>> = known
        .into_iter()
        .map(|(i, mode, damping)| {
            let mut row: Vec<Cell> = vec![
                (i + 1).to_string().into(),
                zeta(&mode.from).into(),
                zeta(&mode.to).into(),
            ];
            row.extend(difference(damping, 0));
            row
        })
        .collect();
    let caption = language.pick(
        "Damping ratios, ± standard deviation. They follow the strength of the motion too.",
        "감쇠비, ± 표준편차. 진동의 세기에 따라서도 변한다.",
    );
    table(caption, 1, &head, &rows)
}

fn remarks(change: &SurveyChange, language: Language) -> Vec<String> {
    let mut said = Vec::new();
    // those that are named first are not named again
    let said_first = |mode: &ObservedMode| change.not_compared.iter().any(|lost| lost.from == *mode);
    let others: Vec<ObservedMode> = change.lost.iter().filter(|m| !said_first(m)).cloned().collect();
    if others.is_empty() && !change.lost.is_empty() {
        said.push(language.pick(
            "A mode that is not found again may have moved further than pairs may lie apart, or was not shaken.".to_owned(),
            "다시 확인되지 않은 모드는 짝으로 볼 수 있는 범위를 넘어 이동하였거나 가진되지 않았을 수 있다.".to_owned(),
        ));
    }
    if !others.is_empty() {
        let all = hertz(&others, language);
        said.push(language.pick(
            format!("Not found again: {all}. Such a mode may have moved further than pairs may lie apart, or was not shaken."),
            format!("다시 찾지 못한 모드: {all}. 짝으로 볼 수 있는 범위를 넘어 이동하였거나 가진되지 않았을 수 있다."),
        ));
    }
    if !change.new.is_empty() {
        let all = hertz(&change.new, language);
        said.push(language.pick(format!("New: {all}."), format!("새로 나타난 모드: {all}.")));
    }
    let of = |which: &dyn Fn(&ModeChange) -> bool| -> Vec<ObservedMode> {
        change
            .modes
            .iter()
            .filter(|m| which(m))
            .map(|m| m.from.clone())
            .collect()
    };
    let by_frequency = of(&|m| m.pair.assurance.is_none());
    if !by_frequency.is_empty() {
        let all = hertz(&by_frequency, language);
        said.push(language.pick(
            format!("Paired by frequency alone, since fewer than two sensors are in both surveys: {all}."),
            format!("두 조사에 공통인 센서가 두 개 미만이어서 진동수만으로 짝지은 모드: {all}."),
        ));
    }
    let doubtful = of(&|m| m.pair.doubtful());
    if !doubtful.is_empty() {
        let all = hertz(&doubtful, language);
        said.push(language.pick(
            format!("Another pairing is nearly as good: {all} may not be the same mode in both surveys."),
            format!(
                "다른 짝도 거의 같은 정도로 가능하다: {all} 모드는 두 조사에서 같은 모드가 아닐 수 있다."
            ),
        ));
    }
    said.extend(change.notes.iter().map(|note| note_words(note, language)));
    said
}

fn note_words(note: &ChangeNote, language: Language) -> String {
    let korean = match note {
        ChangeNote::NotFitted { frequency_hz, .. } => format!(
            "{}\u{202f}Hz 모드는 기온 계수를 추정할 수 없어 변화를 보정하지 않았다(기온이 있는 이전 조사가 부족하거나 기온 차이가 작다).",
            significant(*frequency_hz, 4)
        ),
        ChangeNote::BeyondTheLine {
            temperature_c,
            range_c,
        } => format!(
            "{temperature_c}\u{202f}°C는 계수를 추정한 기온 범위 {}–{}\u{202f}°C를 벗어나므로 직선이 성립하지 않을 수 있다.",
            range_c[0], range_c[1]
        ),
        ChangeNote::OtherShapes { frequencies_hz } => {
            let each: Vec<String> = frequencies_hz.iter().map(|hz| significant(*hz, 4)).collect();
            format!(
                "{}\u{202f}Hz에서는 두 조사에 모두 모드가 있으나 모드형상이 서로 달라, 사라진 모드와 새로운 모드로 처리하였다. 채널이 바뀌었거나 센서의 방향·위치가 달라지지 않았는지 확인이 필요하다.",
                each.join(", ")
            )
        }
        ChangeNote::Swapped(swapped) => format!(
            "한 조사에서 채널 \"{}\"과(와) \"{}\"이(가) 서로 바뀐 것으로 보인다. 모드 {}개의 평균 MAC가 그대로는 {:.2}, 둘을 바꾸면 {:.2}이다. 바뀐 것이 맞으면 프로젝트 파일에서 두 이름을 바꾸고 다시 비교해야 한다.",
            swapped.channels[0], swapped.channels[1], swapped.modes, swapped.assurance, swapped.exchanged
        ),
        ChangeNote::Turned(turned) => format!(
            "한 조사에서 채널 \"{}\"의 방향이 반대로 된 것으로 보인다. 모드 {}개의 평균 MAC가 그대로는 {:.2}, 부호를 바꾸면 {:.2}이다. 반대가 맞으면 프로젝트 파일에서 방향을 바꾸고 다시 비교해야 한다.",
            turned.channel, turned.modes, turned.assurance, turned.turned
        ),
        ChangeNote::OneFactor { factor, modes } => format!(
            "짝을 이룬 모드가 없고, 진동수 {modes}개가 모두 이전의 {factor:.3}배이다. 한 조사의 샘플링 주파수가 잘못되지 않았는지 확인이 필요하다."
        ),
        ChangeNote::LineScatters {
            frequency_hz,
            scatter_hz,
            stated_hz,
        } => format!(
            "{}\u{202f}Hz에서 이전 조사들은 기온 직선에서 {:.2}\u{202f}% 벗어나지만 각 조사가 제시한 편차는 {:.2}\u{202f}%이다. 그 사이에 구조물이 변하였을 수 있으며, 그 정도의 변화는 여기서 확인되지 않는다.",
            significant(*frequency_hz, 4),
            100.0 * scatter_hz / frequency_hz,
            100.0 * stated_hz / frequency_hz
        ),
        ChangeNote::LineWithTime {
            frequency_hz,
            correlation,
        } => format!(
            "{}\u{202f}Hz에서 기온이 조사 순서에 따라 {}(상관계수 {correlation:+.2}). 기온과 노후화의 영향을 구별할 수 없으며, 노후화를 기온의 영향으로 보았을 수 있다.",
            significant(*frequency_hz, 4),
            if *correlation > 0.0 {
                "높아진다"
            } else {
                "낮아진다"
            }
        ),
    };
    let english = note.advised();
    let end = if english.ends_with('?') { "" } else { "." };
    language.pick(format!("Note: {english}{end}"), korean)
}
