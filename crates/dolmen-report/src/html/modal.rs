//! Modes from ambient vibration in the report: what was done, figures, table, what to doubt.

use super::decay;
use super::finding::{Finding, Tone};
use super::record_words::{fault_words, history, note_words};
use super::table::{Cell, figure, table};
use super::words::listed;
use crate::figures::{moving_shapes, sensor_shapes, singular_values, stabilization};
use dolmen::modal::{Fate, Method, ModalAnalysis, Mode, Note};
use dolmen_words::Language;
use dolmen_words::number::{self, counted, significant, with_sd};
use dolmen_work::surveyed::RecordAnswer;
use maud::{Markup, html};

/// "1.882 ± 0.004".
fn frequency(mode: &Mode) -> String {
    mode.frequency_sd_hz.map_or_else(
        || significant(mode.frequency_hz, 4),
        |sd| with_sd(mode.frequency_hz, sd),
    )
}

/// Damping ratio in per cent, with its deviation.
fn damping(mode: &Mode, language: Language) -> String {
    match (mode.damping_ratio, mode.damping_ratio_sd) {
        (Some(zeta), Some(sd)) => with_sd(100.0 * zeta, 100.0 * sd),
        (Some(zeta), None) => significant(100.0 * zeta, 2),
        (None, _) => language.pick("unknown", "미상").into(),
    }
}

pub(super) fn findings(record: &RecordAnswer, language: Language) -> Vec<Finding> {
    let analysis = &record.analysis;
    let modes = &analysis.modes.modes;
    let minutes = significant(analysis.modes.duration_s / 60.0, 2);
    let channels = analysis.modes.channels.len();
    if modes.is_empty() {
        return vec![Finding::new(
            Tone::Unknown,
            language.pick(
                format!(
                    "No mode was found in {minutes} minutes of {}.",
                    counted(channels, "channel", "channels")
                ),
                format!("{minutes}분, {channels}채널의 기록에서 모드를 찾지 못하였다."),
            ),
        )];
    }
    let values: Vec<String> = modes
        .iter()
        .map(|m| format!("{}\u{202f}Hz", frequency(m)))
        .collect();
    let values = listed(&values, language);
    let count = modes.len();
    let found = counted(count, "mode was", "modes were");
    let of_channels = counted(channels, "channel", "channels");
    let by_hand = record
        .analysis
        .notes
        .iter()
        .any(|note| matches!(note, Note::NotPicked { .. }));
    let picked = match by_hand {
        true => language.pick(
            "picked by hand of those that the record shows",
            "기록의 모드 중 직접 선택하여",
        ),
        false => language.pick("no peak picked by hand", "수작업 없이"),
    };
    let mut all = vec![Finding::new(
        Tone::Plain,
        language.pick(
            format!("{found} found in {minutes} minutes of {of_channels}, {picked}: {values} (± standard deviation)."),
            format!("{minutes}분, {channels}채널의 기록에서 모드 {count}개를 {picked} 찾았다: {values}(± 표준편차)."),
        ),
    )];
    if !record.faults.is_empty() {
        let faults = record.faults.len();
        all.push(Finding::new(
            Tone::Warn,
            language.pick(
                match faults {
                    1 => "1 fault was seen in its channels; it is named with the record.".to_owned(),
                    _ => {
                        format!("{faults} faults were seen in its channels; they are named with the record.")
                    }
                },
                format!("채널에서 이상 {faults}건이 발견되었다(기록 항목 참조)."),
            ),
        ));
    }
    all
}

/// The section on the record of a survey.
pub(super) fn section(survey: &str, record: &RecordAnswer, language: Language) -> Markup {
    let analysis = &record.analysis;
    html! {
        h2 {
            @if analysis.modes.method == Method::Era {
                (language.pick("Modes from a free decay", "자유감쇠 기록의 모드 분석"))
            } @else {
                (language.pick("Modes from ambient vibration", "상시진동 기록의 모드 분석"))
            }
            ": " (survey)
        }
        (read(record, language))
        (history(&analysis.modes.history, language))
        (figure(
            &singular_values(analysis, language),
            language.pick(
                "Singular values of the spectral matrix. Each peak of the first one that stands above the second is one way of moving; lines mark the modes found.",
                "스펙트럼 행렬의 특이값. 첫째 특이값이 둘째 위로 솟은 봉우리가 하나의 운동 형태이며, 선은 찾은 모드이다.",
            ),
        ))
        @if !analysis.stabilization.poles.is_empty() {
            (figure(
                &stabilization(analysis, language),
                language.pick(
                    "Stabilisation diagram. A mode of the structure comes back at the same frequency in model after model; noise does not.",
                    "안정화 다이어그램. 구조물의 모드는 모델 차수가 바뀌어도 같은 진동수에서 반복되지만 잡음은 그렇지 않다.",
                ),
            ))
        }
        @if !analysis.modes.modes.is_empty() {
            (modes_table(analysis, language))
            (figure(
                &sensor_shapes(&analysis.modes, language),
                language.pick(
                    "Mode shapes at the sensors. Only what the channels measured, along their directions; the longest drawn alike in each mode.",
                    "센서 위치의 모드형상. 채널이 계측한 방향의 성분만 표시하였으며 모드마다 최대값을 같게 그렸다.",
                ),
            ))
            @if let Some(moving) = moving_shapes(&analysis.modes, language) {
                (figure(
                    &moving,
                    language.pick(
                        "The same, moving: each mode at the same pace, twelve modes at most. Grey: at rest. Lines only join sensors; between them nothing was measured.",
                        "움직이는 모드형상(최대 12개, 모드마다 같은 속도). 회색: 정지 상태. 선은 센서를 이을 뿐 그 사이는 계측하지 않았다.",
                    ),
                ))
            }
        }
        @if let Some(decay) = &analysis.decay { (decay::section(decay, language)) } @else { (settings(analysis, language)) }
        @for note in &analysis.notes { p.note { (note_words(note, language)) } }
    }
}

/// What was read, and what looks wrong with it.
fn read(record: &RecordAnswer, language: Language) -> Markup {
    let (channels, samples) = (record.channels, number::fixed(record.samples as f64, 0));
    let rate = number::trimmed(record.sampling_rate_hz, 6);
    let seconds = number::trimmed(record.samples as f64 / record.sampling_rate_hz, 6);
    let unit = if record.unit.is_empty() {
        language
            .pick(
                "unit unknown: amplitudes mean nothing, frequencies and shapes do",
                "단위 미상: 진폭은 의미가 없으나 진동수와 모드형상은 유효",
            )
            .into()
    } else {
        language.pick(format!("unit {}", record.unit), format!("단위 {}", record.unit))
    };
    let used = analysis_channels(record);
    html! {
        p {
            (language.pick("Record ", "기록 ")) code { (record.file) } ": "
            (language.pick(
                format!("{} of {samples} samples at {rate}\u{202f}Hz ({seconds}\u{202f}s), {unit}. Channels used: {used}.", counted(channels, "channel", "channels")),
                format!("{channels}채널, 채널당 표본 {samples}개, {rate}\u{202f}Hz ({seconds}\u{202f}s), {unit}. 사용한 채널: {used}."),
            ))
        }
        @if !record.faults.is_empty() {
            ul.findings { @for fault in &record.faults { li.warn { (fault_words(fault, language)) } } }
        }
    }
}

fn analysis_channels(record: &RecordAnswer) -> String {
    let names: Vec<&str> = record
        .analysis
        .modes
        .channels
        .iter()
        .map(|c| c.name.as_str())
        .collect();
    names.join(", ")
}

fn modes_table(analysis: &ModalAnalysis, language: Language) -> Markup {
    let of_peaks = matches!(analysis.modes.method, Method::Fdd | Method::Efdd | Method::Fsdd);
    let head = [
        language.pick("Mode", "모드").to_string(),
        language.pick("frequency (Hz)", "고유진동수 (Hz)").to_string(),
        language.pick("damping ratio (%)", "감쇠비 (%)").to_string(),
        language
            .pick("floor of its sd (%)", "표준편차 하한 (%)")
            .to_string(),
        language
            .pick("phase collinearity", "모드 위상 공선성 (MPC)")
            .to_string(),
        language.pick("cycles", "관측 주기 수").to_string(),
        language.pick("kurtosis", "첨도").to_string(),
        if of_peaks {
            language.pick("window bias (%)", "창 함수 편의 (%)").to_string()
        } else {
            language.pick("model orders", "모델 차수 수").to_string()
        },
    ];
    let rows: Vec<Vec<Cell>> = analysis
        .modes
        .modes
        .iter()
        .enumerate()
        .map(|(i, mode)| {
            let zeta = mode
                .damping_ratio
                .filter(|_| analysis.modes.method != Method::Era); // the floor is that of ambient vibration
            let floor = zeta.map(|zeta| 100.0 * zeta * mode.damping_floor());
            vec![
                (i + 1).to_string().into(),
                frequency(mode).into(),
                damping(mode, language).into(),
                floor
                    .filter(|f| f.is_finite())
                    .map_or("–".into(), |f| significant(f, 2))
                    .into(),
                number::fixed(mode.phase_collinearity, 3).into(),
                number::fixed(mode.cycles, 0).into(),
                mode.kurtosis
                    .map_or("–".into(), |k| number::fixed(k.kurtosis, 2))
                    .into(),
                if of_peaks {
                    mode.window_bias
                        .map_or("–".into(), |b| format!("{:+.1}", 100.0 * b))
                        .into()
                } else {
                    mode.orders.len().to_string().into()
                },
            ]
        })
        .collect();
    let method = match analysis.modes.method {
        Method::Efdd => language.pick(
            "enhanced frequency domain decomposition",
            "향상된 주파수 영역 분해법(EFDD)",
        ),
        Method::Fsdd => language.pick(
            "frequency-spatial domain decomposition",
            "주파수·공간 영역 분해법(FSDD)",
        ),
        Method::Fdd => language.pick("frequency domain decomposition", "주파수 영역 분해법(FDD)"),
        Method::SsiCov => language.pick(
            "covariance-driven stochastic subspace identification",
            "공분산 기반 확률적 부분공간법(SSI-cov)",
        ),
        Method::SsiData => language.pick(
            "data-driven stochastic subspace identification",
            "데이터 기반 확률적 부분공간법(SSI-data)",
        ),
        Method::Bayoma => language.pick(
            "Bayesian operational modal analysis (subspace method, then the Fourier lines about each mode)",
            "베이지안 운용 모드해석(BAYOMA: 부분공간법으로 찾은 모드를 주변 푸리에 선에 적합)",
        ),
        Method::Plscf => language.pick(
            "poly-reference least squares in the frequency domain",
            "다기준 최소자승 복소주파수법(pLSCF)",
        ),
        Method::Era => language.pick(
            "eigensystem realization of a free decay",
            "자유감쇠의 고유계 실현법(ERA)",
        ),
    };
    let caption = language.pick(
        format!("Modes by {method}, ± standard deviation. The floor is the least deviation of a damping ratio that a record of this length allows (Au 2014); a collinearity of 1 is a real shape; a kurtosis of 3 is random motion, of 1.5 a machine's."),
        format!("{method}에 의한 모드, ± 표준편차. 하한은 이 길이의 기록에서 감쇠비가 가질 수 있는 최소 표준편차(Au 2014)이며, 공선성 1은 실수 모드형상을, 첨도 3은 불규칙 운동을, 1.5는 기계 진동을 뜻한다."),
    );
    table(&caption, 1, &head, &rows)
}

/// Which references were chosen, if they were, in both languages.
fn references(analysis: &ModalAnalysis) -> (String, String) {
    let Some(kept) = analysis.settings.references_keep else {
        return Default::default();
    };
    let channels = &analysis.fdd_modes.channels;
    let names: Vec<&str> = analysis
        .settings
        .references
        .iter()
        .filter_map(|&c| channels.get(c).map(|channel| channel.name.as_str()))
        .collect();
    let (names, kept) = (names.join(", "), number::fixed(100.0 * kept, 0));
    (
        format!(", with references {names} (they keep {kept}\u{202f}% of the motion at the peaks)"),
        format!(", 기준 채널 {names}, 봉우리 운동의 {kept}\u{202f}% 설명"),
    )
}

fn settings(analysis: &ModalAnalysis, language: Language) -> Markup {
    let s = &analysis.settings;
    let (low, high) = (significant(s.range_hz[0], 3), significant(s.range_hz[1], 3));
    let rate = number::trimmed(s.sampling_rate_hz, 5);
    let (rows, order, blocks) = (s.block_rows, s.order_most, s.time_blocks);
    if s.lines > 0 && analysis.modes.method != Method::Plscf {
        let lines = s.lines;
        return html! {
            p { (language.pick(
                format!("Modes are the peaks of a spectrum of {lines} lines. The window bias is what the length of its window would have added to each damping ratio; it has been taken out."),
                format!("모드는 스펙트럼 선 {lines}개의 봉우리이다. 창 함수 편의는 창의 길이가 감쇠비에 더했을 오차이며 이미 제거하였다."),
            )) }
        };
    }
    let refused = |fate: Fate| analysis.clusters.iter().filter(|c| c.fate == fate).count();
    let (few, scattered, double) = (
        refused(Fate::FewOrders),
        refused(Fate::Scattered),
        refused(Fate::Double) + refused(Fate::Blend),
    );
    let (lines, lags) = (s.lines, (2 * s.block_rows).saturating_sub(1));
    let (references_en, references_ko) = references(analysis);
    let (rows_en, rows_ko) = if analysis.modes.method == Method::Plscf {
        (
            format!("{lines} lines of half spectra from {lags} lags{references_en}"),
            format!("반스펙트럼 선 {lines}개(시간 지연 {lags}개{references_ko})"),
        )
    } else {
        (format!("{rows} block rows"), format!("블록 행 {rows}개"))
    };
    html! {
        p { (language.pick(
            format!("Chosen from the data: {rows_en} at {rate}\u{202f}Hz, model orders to {order}, modes accepted between {low} and {high}\u{202f}Hz, deviations from {blocks} blocks of time. Groups of poles not taken as modes: {few} in too few orders, {scattered} too scattered, {double} doubles of another."),
            format!("자료로부터 정한 값: {rows_ko}({rate}\u{202f}Hz), 모델 차수 {order}까지, 모드 채택 범위 {low}–{high}\u{202f}Hz, 표준편차는 시간 블록 {blocks}개에서 산정. 모드로 보지 않은 극점군: 차수 부족 {few}개, 산포 과다 {scattered}개, 중복 {double}개."),
        )) }
    }
}
