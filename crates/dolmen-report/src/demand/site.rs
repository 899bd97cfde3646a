//! Every number between a site and its spectrum.

use super::words::in_g;
use crate::document::{Block, Cell, Document};
use dolmen::assess::demand::{
    EurocodeGround, EurocodeType, Kds41, KoreanSite, SiteDemand, SiteParameters, SoilAmplification,
    SpectrumBranches,
};
use dolmen::known::STANDARD_GRAVITY_M_S2;
use dolmen_words::{Digits, Quantity, Sentence, Unit, messages};

/// Digits of a code's own numbers.
const DIGITS: Digits = Digits::Trimmed(6);

messages! {
    /// The numbers of a site.
    pub(crate) enum Numbers in "demand.site" {
        Site => {
            en: "The site: every number between it and the spectrum.",
            ko: "부지: 스펙트럼을 정하는 모든 값.",
        },
        ZoneFactor => { en: "zone factor Z", ko: "지진구역계수 Z" },
        ReturnPeriod => { en: "return period", ko: "재현주기" },
        Years(years: Quantity) => { en: "{years} years", ko: "{years}년" },
        RiskFactor => { en: "risk factor I", ko: "위험도계수 I" },
        EffectiveAcceleration => {
            en: "effective acceleration S = Z I",
            ko: "유효수평지반가속도 S = Z I",
        },
        SiteClass => { en: "site class", ko: "지반분류" },
        ShortPeriods => {
            en: "amplification by the soil at short periods Fa",
            ko: "단주기지반증폭계수 Fa",
        },
        OneSecond => {
            en: "amplification by the soil at 1 s Fv",
            ko: "장주기지반증폭계수 Fv",
        },
        Rise(symbol: Sentence) => {
            en: "beginning of the plateau {symbol}",
            ko: "전이주기 {symbol}(최대 응답 구간의 시작)",
        },
        Plateau(symbol: Sentence) => { en: "end of the plateau {symbol}", ko: "전이주기 {symbol}(최대 응답 구간의 끝)" },
        LongPeriods(symbol: Sentence) => {
            en: "beginning of the 1/T² branch {symbol}",
            ko: "전이주기 {symbol}(1/T² 구간의 시작)",
        },
        DesignShort => {
            en: "S_DS of KDS 41 17 00",
            ko: "KDS 41 17 00의 단주기 설계스펙트럼가속도 S_DS",
        },
        DesignOneSecond => {
            en: "S_D1 of KDS 41 17 00",
            ko: "KDS 41 17 00의 1초 주기 설계스펙트럼가속도 S_D1",
        },
        PlateauAcceleration => { en: "plateau", ko: "최대 응답 가속도" },
        ReferenceAcceleration => {
            en: "reference acceleration of the ground a_gR",
            ko: "기준 지반가속도 a_gR",
        },
        ImportanceFactor => { en: "importance factor", ko: "중요도계수" },
        SpectrumType => { en: "type", ko: "스펙트럼 유형" },
        Ground => { en: "ground", ko: "지반분류" },
        SoilFactor => { en: "soil factor S", ko: "지반계수 S" },
        TableRows => { en: "rows of the table", ko: "표의 행 수" },
        TablePeriods => { en: "periods", ko: "주기 범위" },
        Range { least: Quantity, most: Quantity } => {
            en: "{least} to {most}, straight between the rows",
            ko: "{least}–{most}, 행 사이는 선형 보간",
        },
        Peak => { en: "peak of the ground", ko: "최대지반가속도(PGA)" },
        PeakUnknown => { en: "not given", ko: "주어지지 않음" },
        Vertical => { en: "vertical / horizontal", ko: "수직/수평 가속도비" },
        VerticalUnverified(ratio: Quantity) => { en: "{ratio} (unverified)", ko: "{ratio}(미확인)" },
        VerticalNone => {
            en: "not given: none counted",
            ko: "주어지지 않음(고려하지 않음)",
        },
        Damping => { en: "damping", ko: "감쇠비" },
    }
}

type Row = (Sentence, Cell);

/// The numbers of the code or table, and the ground motion.
pub(super) fn section(document: &mut Document<'_>, site: &SiteDemand) {
    document.paragraph(Numbers::Site);
    let mut rows = parameters(&site.parameters);
    rows.extend(shaking(site));
    document.put(Block::KeyValues(rows));
}

fn parameters(parameters: &SiteParameters) -> Vec<Row> {
    match parameters {
        SiteParameters::Korea {
            zone_factor_g,
            return_period_years,
            risk_factor,
            effective_acceleration_g,
            soil,
            amplification,
            design,
            branches,
        } => {
            let years = Numbers::Years(number(f64::from(*return_period_years)));
            let mut rows = vec![
                (Numbers::ZoneFactor.into(), of_g(*zone_factor_g)),
                (Numbers::ReturnPeriod.into(), Cell::words(years)),
                (Numbers::RiskFactor.into(), ratio(*risk_factor)),
                (
                    Numbers::EffectiveAcceleration.into(),
                    of_g(*effective_acceleration_g),
                ),
            ];
            rows.extend(soil_rows(*soil, amplification));
            rows.extend(branch_rows(branches, ["T0", "Ts", "TL"]));
            rows.extend(design.iter().flat_map(design_rows));
            rows.push(plateau(branches));
            rows
        }
        SiteParameters::Eurocode {
            ground_acceleration_g,
            importance_factor,
            spectrum,
            ground,
            soil_factor,
            branches,
        } => {
            let mut rows = vec![
                (
                    Numbers::ReferenceAcceleration.into(),
                    of_g(*ground_acceleration_g),
                ),
                (Numbers::ImportanceFactor.into(), ratio(*importance_factor)),
                (Numbers::SpectrumType.into(), symbol(type_word(*spectrum))),
                (Numbers::Ground.into(), symbol(ground_word(*ground))),
                (Numbers::SoilFactor.into(), ratio(*soil_factor)),
            ];
            rows.extend(branch_rows(branches, ["TB", "TC", "TD"]));
            rows.push(plateau(branches));
            rows
        }
        SiteParameters::Table {
            rows,
            least_s,
            most_s,
        } => {
            let range = Numbers::Range {
                least: number(*least_s),
                most: seconds(*most_s),
            };
            vec![
                (Numbers::TableRows.into(), symbol(&rows.to_string())),
                (Numbers::TablePeriods.into(), Cell::words(range)),
            ]
        }
    }
}

fn soil_rows(soil: KoreanSite, amplification: &SoilAmplification) -> [Row; 3] {
    [
        (Numbers::SiteClass.into(), symbol(&format!("{soil:?}"))),
        (Numbers::ShortPeriods.into(), ratio(amplification.short_periods)),
        (Numbers::OneSecond.into(), ratio(amplification.one_second)),
    ]
}

/// Ends of the branches, with their names in the code.
fn branch_rows(branches: &SpectrumBranches, symbols: [&str; 3]) -> [Row; 3] {
    let [rise, plateau, long] = symbols.map(Sentence::of_symbol);
    [
        (Numbers::Rise(rise).into(), Cell::number(seconds(branches.rise_s))),
        (
            Numbers::Plateau(plateau).into(),
            Cell::number(seconds(branches.plateau_s)),
        ),
        (
            Numbers::LongPeriods(long).into(),
            Cell::number(seconds(branches.displacement_s)),
        ),
    ]
}

fn design_rows(design: &Kds41) -> [Row; 2] {
    [
        (Numbers::DesignShort.into(), of_g(design.short_period_g)),
        (Numbers::DesignOneSecond.into(), of_g(design.one_second_g)),
    ]
}

fn plateau(branches: &SpectrumBranches) -> Row {
    (
        Numbers::PlateauAcceleration.into(),
        Cell::number(in_g(branches.plateau_m_s2, DIGITS)),
    )
}

/// The peak of the ground, its vertical part, and the damping ratio of the spectrum.
fn shaking(site: &SiteDemand) -> [Row; 3] {
    let peak = site.peak_ground_acceleration_m_s2;
    let vertical = match &site.vertical {
        Some(vertical) if vertical.verified => ratio(vertical.ratio),
        Some(vertical) => Cell::words(Numbers::VerticalUnverified(number(vertical.ratio))),
        None => Cell::words(Numbers::VerticalNone),
    };
    let damping = Quantity::new(site.damping_ratio, Unit::percent(), Digits::Trimmed(4));
    [
        (
            Numbers::Peak.into(),
            peak.map_or(Cell::words(Numbers::PeakUnknown), |m_s2| {
                Cell::number(in_g(m_s2, DIGITS))
            }),
        ),
        (Numbers::Vertical.into(), vertical),
        (Numbers::Damping.into(), Cell::number(damping)),
    ]
}

fn number(value: f64) -> Quantity {
    Quantity::new(value, Unit::ratio(), DIGITS)
}

fn ratio(value: f64) -> Cell {
    Cell::number(number(value))
}

fn seconds(value: f64) -> Quantity {
    Quantity::new(value, Unit::si("s"), DIGITS)
}

fn of_g(value_g: f64) -> Cell {
    Cell::number(in_g(value_g * STANDARD_GRAVITY_M_S2, DIGITS))
}

fn symbol(text: &str) -> Cell {
    Cell::words(Sentence::of_symbol(text))
}

/// "1", "2".
pub(crate) fn type_word(kind: EurocodeType) -> &'static str {
    match kind {
        EurocodeType::One => "1",
        EurocodeType::Two => "2",
    }
}

/// "A" to "E".
pub(crate) fn ground_word(ground: EurocodeGround) -> &'static str {
    match ground {
        EurocodeGround::A => "A",
        EurocodeGround::B => "B",
        EurocodeGround::C => "C",
        EurocodeGround::D => "D",
        EurocodeGround::E => "E",
    }
}
