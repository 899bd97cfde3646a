//! Settings that an analysis chose from the data.

use super::tables::of_peaks;
use super::values::{hertz, percent};
use dolmen::modal::{Fate, Method, ModalAnalysis};
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};

messages! {
    /// Automatically chosen settings.
    pub(crate) enum Chosen in "modal.settings" {
        Peaks { lines: usize, low: Quantity, high: Quantity } => {
            en: "Modes are the peaks of a spectrum of {lines} lines, sought between {low} and {high}. The window bias is what the length of its window would have added to each damping ratio; it has been taken out.",
            ko: "모드는 스펙트럼 선 {lines}개의 피크이며 {low}–{high}에서 탐색하였다. 창 함수 편의는 창의 길이가 감쇠비에 더했을 오차이며 이미 제거하였다.",
        },
        Decay { rows: usize, order: usize, low: Quantity, high: Quantity } => {
            en: "A free decay: {rows} block rows, model of order {order}, modes sought between {low} and {high}.",
            ko: "자유감쇠: 블록 행 {rows}개, 모델 차수 {order}, 모드 탐색 범위 {low}–{high}.",
        },
        Orders { how: Sentence, rate: Quantity, order: usize, low: Quantity, high: Quantity, blocks: usize, few: usize, scattered: usize, double: usize } => {
            en: "Chosen from the data: {how} at {rate}, model orders to {order}, modes accepted between {low} and {high}, deviations from {blocks} blocks of time. Groups of poles not taken as modes: {few} in too few orders, {scattered} too scattered, {double} doubles of another.",
            ko: "자료로부터 정한 값: {how}({rate}), 모델 차수 {order}까지, 모드 채택 범위 {low}–{high}, 표준편차는 시간 블록 {blocks}개에서 산정. 모드로 보지 않은 극점군: 차수 부족 {few}개, 산포 과다 {scattered}개, 중복 {double}개.",
        },
        RowsOfReferences { rows: usize, least: usize, lowest: Quantity, references: usize, channels: usize, kept: Quantity } => {
            en: "{rows} block rows (at least {least} for the lowest peak, {lowest}), with the past of {references} of {channels} channels (they explain {kept} of the motion at the peaks)",
            ko: "블록 행 {rows}개(최저 피크 {lowest}에는 {least}개 이상 필요), 채널 {channels}개 가운데 기준 채널 {references}개(피크 운동의 {kept} 설명)",
        },
        Rows { rows: usize, least: usize, lowest: Quantity } => {
            en: "{rows} block rows (at least {least} for the lowest peak, {lowest})",
            ko: "블록 행 {rows}개(최저 피크 {lowest}에는 {least}개 이상 필요)",
        },
        Lines { lines: usize, lags: usize, degrees: usize } => {
            en: "{lines} lines of half spectra from {lags} lags, degrees to {degrees}, shapes without a deviation,",
            ko: "반스펙트럼 선 {lines}개, 시간 지연 {lags}개, 다항식 차수 {degrees}까지, 모드형상의 표준편차 없음",
        },
        LinesOfReferences { lines: usize, lags: usize, degrees: usize, references: Vec<String>, kept: Quantity } => {
            en: "{lines} lines of half spectra from {lags} lags, degrees to {degrees}, shapes without a deviation, with references {references} (they keep {kept} of the motion at the peaks, and few make many degrees possible)",
            ko: "반스펙트럼 선 {lines}개, 시간 지연 {lags}개, 다항식 차수 {degrees}까지, 모드형상의 표준편차 없음, 기준 채널 {references}(피크 운동의 {kept} 설명; 기준 채널이 적을수록 높은 차수가 가능)",
        },
    }
}

/// Settings chosen from the data.
pub(super) fn settings(analysis: &ModalAnalysis) -> Chosen {
    let chosen = &analysis.settings;
    let method = analysis.modes.method;
    let [low, high] = chosen.range_hz.map(hertz);
    if of_peaks(method) {
        let lines = chosen.lines;
        return Chosen::Peaks { lines, low, high };
    }
    if method == Method::Era {
        return Chosen::Decay {
            rows: chosen.block_rows,
            order: chosen.order_most,
            low,
            high,
        };
    }
    let refused = |fate: Fate| analysis.clusters.iter().filter(|c| c.fate == fate).count();
    Chosen::Orders {
        how: how(analysis).into(),
        rate: Quantity::new(chosen.sampling_rate_hz, Unit::si("Hz"), Digits::Trimmed(6)),
        order: chosen.order_most,
        low,
        high,
        blocks: chosen.time_blocks,
        few: refused(Fate::FewOrders),
        scattered: refused(Fate::Scattered),
        double: refused(Fate::Double) + refused(Fate::Blend),
    }
}

fn how(analysis: &ModalAnalysis) -> Chosen {
    let chosen = &analysis.settings;
    if analysis.modes.method != Method::Plscf {
        let (rows, least, lowest) = (
            chosen.block_rows,
            chosen.block_rows_least,
            hertz(chosen.lowest_hz),
        );
        return match chosen.references_keep {
            None => Chosen::Rows { rows, least, lowest },
            Some(kept) => Chosen::RowsOfReferences {
                rows,
                least,
                lowest,
                references: chosen.references.len(),
                channels: analysis.fdd_modes.channels.len(),
                kept: percent(kept, 1),
            },
        };
    }
    let lines = chosen.lines;
    let lags = (2 * chosen.block_rows).saturating_sub(1);
    let degrees = chosen.order_most / chosen.references.len().max(1);
    match chosen.references_keep {
        None => Chosen::Lines { lines, lags, degrees },
        Some(kept) => {
            let channels = &analysis.fdd_modes.channels;
            let references = chosen.references.iter().filter_map(|&c| channels.get(c));
            Chosen::LinesOfReferences {
                lines,
                lags,
                degrees,
                references: references.map(|channel| channel.name.clone()).collect(),
                kept: percent(kept, 0),
            }
        }
    }
}
