//! Several setups of one survey in the report.

use super::finding::{Finding, Tone};
use super::modal;
use super::record_words::note_words;
use super::table::{Cell, figure, table};
use super::words::listed;
use crate::figures::{moving_shapes, sensor_shapes};
use crate::text::setup_remarks;
use dolmen::modal::JointSetups;
use dolmen_words::Language;
use dolmen_words::number::{counted, fixed, with_sd};
use dolmen_work::surveyed::SetupsAnswer;
use maud::{Markup, html};

pub(super) fn finding(setups: &SetupsAnswer, language: Language) -> Finding {
    let modes = &setups.modes().modes;
    let (count, records, sensors) = (
        modes.len(),
        setups.records.len(),
        setups.merged.modes.channels.len(),
    );
    let values: Vec<String> = modes
        .iter()
        .map(|m| {
            format!(
                "{}\u{202f}Hz",
                with_sd(m.frequency_hz, m.frequency_sd_hz.unwrap_or(0.0))
            )
        })
        .collect();
    let values = listed(&values, language);
    let differing = setups
        .merged
        .merged
        .iter()
        .filter(|m| m.frequency.differs())
        .count();
    let tone = if differing > 0 { Tone::Warn } else { Tone::Plain };
    Finding::new(
        tone,
        language.pick(
            format!("{records} setups together show {} at {}: {values} (± standard deviation). In {differing} of them the setups differ beyond chance.", counted(count, "mode", "modes"), counted(sensors, "sensor", "sensors")),
            format!("{records}개 측정 배치를 합성하여 센서 {sensors}개에서 모드 {count}개를 찾았다: {values}(± 표준편차). 이 중 {differing}개에서 배치 사이의 차이가 우연을 넘는다."),
        ),
    )
}

/// Each setup by itself, then all together.
pub(super) fn section(survey: &str, setups: &SetupsAnswer, language: Language) -> Markup {
    let merged = &setups.merged;
    html! {
        @for (i, record) in setups.records.iter().enumerate() {
            @let name = language.pick(format!("{survey}, setup {}", i + 1), format!("{survey}, 배치 {}", i + 1));
            (modal::section(&name, record, language))
        }
        h2 { (language.pick("Setups put together", "측정 배치의 합성")) ": " (survey) }
        @if merged.modes.modes.is_empty() {
            p { (language.pick("No mode is shown by every setup.", "모든 배치에서 공통으로 확인된 모드가 없다.")) }
        } @else {
            (modes_table(setups, language))
            (figure(
                &sensor_shapes(&merged.modes, language),
                language.pick(
                    "Mode shapes at the sensors of all setups. Each setup is scaled to the others at the sensors that stayed.",
                    "모든 배치의 센서 위치 모드형상. 각 배치는 고정 센서를 기준으로 척도를 맞추었다.",
                ),
            ))
            @if let Some(moving) = moving_shapes(&merged.modes, language) {
                (figure(
                    &moving,
                    language.pick(
                        "The same, moving: each mode at the same pace, twelve modes at most. Grey: at rest. Lines only join sensors; between them nothing was measured.",
                        "움직이는 모드형상(최대 12개, 모드마다 같은 속도). 회색: 정지 상태. 선은 센서를 이을 뿐 그 사이는 계측하지 않았다.",
                    ),
                ))
            }
        }
        @if let Some(joint) = &setups.joint { (joint_section(joint, survey, language)) }
        @for remark in setup_remarks(setups, language) { p.note { (remark) "." } }
    }
}

/// All setups identified as one.
fn joint_section(joint: &JointSetups, survey: &str, language: Language) -> Markup {
    let head = [
        language.pick("Mode", "모드"),
        language.pick("frequency (Hz)", "고유진동수 (Hz)"),
        language.pick("damping ratio (%)", "감쇠비 (%)"),
        language.pick("phase collinearity", "모드 위상 공선성 (MPC)"),
        language.pick("model orders", "모델 차수 수"),
    ]
    .map(str::to_string);
    let rows: Vec<Vec<Cell>> = joint
        .modes
        .modes
        .iter()
        .enumerate()
        .map(|(i, mode)| {
            let zeta = mode.damping_ratio.map_or("–".to_owned(), |z| {
                with_sd(100.0 * z, 100.0 * mode.damping_ratio_sd.unwrap_or(0.0))
            });
            vec![
                (i + 1).to_string().into(),
                with_sd(mode.frequency_hz, mode.frequency_sd_hz.unwrap_or(0.0)).into(),
                zeta.into(),
                fixed(mode.phase_collinearity, 3).into(),
                mode.orders.len().to_string().into(),
            ]
        })
        .collect();
    let caption = language.pick(
        "Modes of all setups identified as one (PreGER), ± standard deviation: correlations brought to the shaking of the first setup and stacked. These are the modes of the survey; the means above are beside them.",
        "모든 배치를 하나로 식별한 모드(PreGER), ± 표준편차. 상관함수를 첫 배치의 가진 수준으로 환산하여 쌓았다. 이 값이 조사의 모드이며 위의 평균은 비교용이다.",
    );
    html! {
        h2 { (language.pick("Setups identified as one", "측정 배치의 일괄 식별")) ": " (survey) }
        @if joint.modes.modes.is_empty() {
            p { (language.pick("No mode was found.", "모드를 찾지 못했다.")) }
        } @else {
            (table(caption, 1, &head, &rows))
            (figure(
                &sensor_shapes(&joint.modes, language),
                language.pick(
                    "Mode shapes at the sensors of all setups, from one identification.",
                    "일괄 식별로 얻은 모든 배치의 센서 위치 모드형상.",
                ),
            ))
        }
        @for note in &joint.notes { p.note { (note_words(note, language)) } }
    }
}

fn modes_table(setups: &SetupsAnswer, language: Language) -> Markup {
    let merged = &setups.merged;
    let mut head = vec![
        language.pick("Mode", "모드").to_string(),
        language.pick("frequency (Hz)", "고유진동수 (Hz)").to_string(),
        language.pick("damping ratio (%)", "감쇠비 (%)").to_string(),
    ];
    head.extend(
        (1..=setups.records.len())
            .map(|s| language.pick(format!("setup {s} (Hz)"), format!("배치 {s} (Hz)"))),
    );
    head.push(language.pick("p of the difference", "차이의 p").to_string());
    head.push(
        language
            .pick("least MAC of the references", "고정 센서 MAC 최소")
            .to_string(),
    );
    let rows: Vec<Vec<Cell>> = merged
        .modes
        .modes
        .iter()
        .zip(&merged.merged)
        .enumerate()
        .map(|(i, (mode, of))| {
            let zeta = mode.damping_ratio.map_or("–".to_owned(), |z| {
                with_sd(100.0 * z, 100.0 * mode.damping_ratio_sd.unwrap_or(0.0))
            });
            let mut row: Vec<Cell> = vec![
                (i + 1).to_string().into(),
                with_sd(mode.frequency_hz, mode.frequency_sd_hz.unwrap_or(0.0)).into(),
                zeta.into(),
            ];
            row.extend(of.frequency_hz.iter().map(|f| fixed(*f, 4).into()));
            let p = of.frequency.p.map_or("–".to_owned(), |p| fixed(p, 3));
            row.push(if of.frequency.differs() {
                Cell::bad(p)
            } else {
                p.into()
            });
            let least = of
                .reference_assurance
                .iter()
                .flatten()
                .copied()
                .min_by(f64::total_cmp);
            row.push(least.map_or("–".into(), |mac| fixed(mac, 3).into()));
            row
        })
        .collect();
    let caption = language.pick(
        "Modes of all setups, ± standard deviation. Means by inverse variance; p is the probability that setups which agree differ so much (χ²), and where they differ the deviations are widened.",
        "모든 배치의 모드, ± 표준편차. 역분산 가중 평균이며, p는 배치가 서로 일치할 때 이만한 차이가 나타날 확률(χ²)이다. 차이가 크면 표준편차를 넓혔다.",
    );
    table(caption, 1, &head, &rows)
}
