//! Reads the site.

use super::file::{CodeRaw, GroundRaw, HazardRaw, SiteRaw, SoilRaw, ZoneRaw};
use super::key::SiteKey;
use super::part::{HazardPart, HazardSource, SitePart};
use super::place::is_place_alone;
use super::slips::judge_site;
use crate::error::Fault;
use crate::file_number::At;
use crate::measure::{Bound, Measure};
use crate::reader::Reader;
use crate::wrong::said;
use crate::wrong::{Common, WrongSite, either};
use dolmen::assess::demand::{EurocodeGround, EurocodeType, KoreanSite, KoreanZone, Site};
use dolmen::assess::{AssessError, Hazard};
use dolmen::known::STANDARD_GRAVITY_M_S2;
use dolmen::numeric::NumericError;
use dolmen::signal::Quantity;
use dolmen_records::TABLE_BYTES_MOST;
use dolmen_records::records::Unit;
use dolmen_words::message::Both;

/// Damping ratio of the plateaus in codes.
const DAMPING_RATIO: f64 = 0.05;

fn code_word(code: CodeRaw) -> &'static str {
    match code {
        CodeRaw::Kds17 => "KDS 17 10 00",
        CodeRaw::Kds41 => "KDS 41 17 00",
        CodeRaw::Eurocode8 => "EN 1998-1",
        CodeRaw::Table => "table",
    }
}

/// The site; its demand is computed once, so that values outside the code are rejected here.
pub(crate) fn site(reader: &mut Reader, raw: Option<&At<SiteRaw>>) -> Option<SitePart> {
    let raw = raw?;
    reader.mark("site", &raw.span);
    if is_place_alone(&raw.value) {
        return None;
    }
    let Some(code) = raw.value.code.as_ref() else {
        if !reader.is_reported("site.code") {
            let fault = Fault::new(raw.span.clone(), "site.code", WrongSite::SiteLacksCode);
            reader.fault(fault.help(WrongSite::GiveCodeKdsKds));
        }
        return None;
    };
    let code = code.value;
    for key in [SiteKey::PeriodsS, SiteKey::File] {
        if let Some(span) = key.span_in(&raw.value) {
            reader.mark(&key.path(), &span);
        }
    }
    for (key, codes) in SiteKey::OF_CODES {
        if let (Some(span), false) = (key.span_in(&raw.value), codes.contains(&code)) {
            let path = key.path();
            let message = WrongSite::HasNoMeaningWith {
                path: path.to_string(),
                code: code_word(code).to_string(),
            };
            let others: Vec<String> = codes
                .iter()
                .map(|c| format!("code = \"{}\"", code_word(*c)))
                .collect();
            reader.fault(Fault::new(span, &path, message).help(Common::TakeItOutOr(either(&others))));
        }
    }
    let before = reader.faults.len();
    let site = match code {
        CodeRaw::Kds17 | CodeRaw::Kds41 => korea(reader, raw, code),
        CodeRaw::Eurocode8 => eurocode(reader, raw),
        CodeRaw::Table => table(reader, raw),
    };
    let (ratio, zero) = (Measure::Ratio, Bound::NotNegative);
    let damping = reader.plain(
        raw.value.damping_ratio.as_ref(),
        "site.damping_ratio",
        ratio,
        Bound::Positive,
    );
    let vertical_ratio = reader.plain(
        raw.value.vertical_ratio.as_ref(),
        "site.vertical_ratio",
        ratio,
        zero,
    );
    let hazard = raw.value.hazard.as_ref().and_then(|raw| hazard(reader, raw));
    if reader.faults.len() > before {
        return None;
    }
    let damping_ratio = damping.unwrap_or(DAMPING_RATIO);
    let mut part = SitePart {
        site: site?,
        damping_ratio,
        vertical_ratio,
        hazard,
    };
    if part.hazard.is_none() {
        part.hazard = code_hazard(&part.site);
    }
    if let Site::Table {
        damping_ratio: of_table,
        ..
    } = &mut part.site
    {
        *of_table = damping_ratio;
    }
    if let Err(why) = part.demand() {
        let key = key_of(&why, code);
        let path = key.map_or_else(|| "site.code".to_owned(), SiteKey::path);
        let span = key.and_then(|key| key.span_in(&raw.value));
        let span = span.unwrap_or_else(|| raw.span.clone());
        let why = said(&why);
        reader.fault(Fault::new(
            span,
            &path,
            WrongSite::Demand {
                key: path.clone(),
                why,
            },
        ));
        return None;
    }
    judge_site(reader, &part);
    Some(part)
}

/// The hazard of the Korean code, from its own return periods.
fn code_hazard(site: &Site) -> Option<HazardPart> {
    let (Site::Kds17 {
        zone_factor_g, soil, ..
    }
    | Site::Kds41 { zone_factor_g, soil }) = site
    else {
        return None;
    };
    Some(HazardPart {
        curve: Hazard::kds_17(*zone_factor_g, *soil).ok()?,
        source: HazardSource::Kds17,
    })
}

/// Reads a hazard.
fn hazard(reader: &mut Reader, raw: &At<HazardRaw>) -> Option<HazardPart> {
    const PATH: &str = "site.hazard";
    let given = &raw.value;
    let (peaks, periods) = (given.peaks.as_ref()?, given.return_periods_years.as_ref()?);
    let mut peaks_m_s2 = Vec::with_capacity(peaks.value.len());
    for (i, peak) in peaks.value.iter().enumerate() {
        let path = format!("{PATH}.peaks[{}]", i + 1);
        peaks_m_s2.push(reader.plain(Some(peak), &path, Measure::GroundAcceleration, Bound::Positive)?);
    }
    let mut refuse = |message: Both, help: WrongSite| {
        reader.fault(Fault::new(raw.span.clone(), PATH, WrongSite::Hazard(message)).help(help));
    };
    if peaks_m_s2.len() != periods.value.len() {
        refuse(
            WrongSite::PeaksButReturnPeriods {
                peaks: peaks_m_s2.len().to_string(),
                periods: periods.value.len().to_string(),
            }
            .into(),
            WrongSite::GiveEachPeakIts,
        );
        return None;
    }
    let curve = match (peaks_m_s2.as_slice(), &given.k) {
        ([only], Some(k)) => Hazard::through(*only, periods.value[0], k.value),
        ([_], None) => {
            refuse(WrongSite::OnePeakAloneTells.into(), WrongSite::GiveSecondOneOr);
            return None;
        }
        (_, Some(_)) => {
            refuse(WrongSite::KGoesWithOne.into(), WrongSite::TakeItOutTwo);
            return None;
        }
        (several, None) => {
            let points: Vec<[f64; 2]> = several
                .iter()
                .zip(&periods.value)
                .map(|(peak, years)| [*peak, 1.0 / years])
                .collect();
            Hazard::of_points(&points)
        }
    };
    match curve {
        Ok(curve) => Some(HazardPart {
            curve,
            source: HazardSource::File,
        }),
        Err(why) => {
            refuse(said(&why), WrongSite::PeaksRiseAndSo);
            None
        }
    }
}

/// The key that causes an error; `None` where the code itself causes it.
fn key_of(why: &AssessError, code: CodeRaw) -> Option<SiteKey> {
    match why {
        AssessError::SiteSpecific => Some(SiteKey::Soil),
        AssessError::ReturnPeriod { .. } => Some(SiteKey::ReturnPeriodYears),
        AssessError::SpectrumTable { .. } => Some(SiteKey::PeriodsS),
        AssessError::Numeric(NumericError::Range { quantity, .. }) => SiteKey::of_quantity(quantity, code),
        _ => None,
    }
}

/// A key required by a code.
fn needs(reader: &mut Reader, raw: &At<SiteRaw>, key: SiteKey, help: WrongSite) {
    let path = key.path();
    if key.span_in(&raw.value).is_none() && !reader.is_reported(&path) {
        let code = raw.value.code.as_ref().map_or("", |code| code_word(code.value));
        let message = WrongSite::SiteHasNoBut {
            key: key.word().to_owned(),
            code: code.to_string(),
        };
        reader.fault(Fault::new(raw.span.clone(), &path, message).help(help));
    }
}

fn korea(reader: &mut Reader, raw: &At<SiteRaw>, code: CodeRaw) -> Option<Site> {
    let given = &raw.value;
    let factor = reader.plain(
        given.zone_factor.as_ref(),
        "site.zone_factor",
        Measure::GroundAcceleration,
        Bound::Positive,
    );
    let zone_factor_g = match (&given.zone, &given.zone_factor) {
        (Some(_), Some(factor)) => {
            let message = WrongSite::SiteHasBothZone;
            let fault = Fault::new(factor.span.clone(), "site.zone_factor", message);
            reader.fault(fault.help(WrongSite::KeepOneOfThem));
            None
        }
        (Some(zone), None) => Some(
            match zone.value {
                ZoneRaw::I => KoreanZone::I,
                ZoneRaw::Ii => KoreanZone::II,
            }
            .factor_g(),
        ),
        (None, Some(_)) => factor.map(|m_s2| m_s2 / STANDARD_GRAVITY_M_S2),
        (None, None) => {
            needs(reader, raw, SiteKey::Zone, WrongSite::WriteZoneIG);
            None
        }
    };
    needs(reader, raw, SiteKey::Soil, WrongSite::WriteSoilS1Rock);
    let soil = given.soil.as_ref().map(|soil| match soil.value {
        SoilRaw::S1 => KoreanSite::S1,
        SoilRaw::S2 => KoreanSite::S2,
        SoilRaw::S3 => KoreanSite::S3,
        SoilRaw::S4 => KoreanSite::S4,
        SoilRaw::S5 => KoreanSite::S5,
        SoilRaw::S6 => KoreanSite::S6,
    });
    if code == CodeRaw::Kds41 {
        return Some(Site::Kds41 {
            zone_factor_g: zone_factor_g?,
            soil: soil?,
        });
    }
    let help = WrongSite::WriteReturnPeriodYears;
    needs(reader, raw, SiteKey::ReturnPeriodYears, help);
    let years = given.return_period_years.as_ref()?;
    Some(Site::Kds17 {
        zone_factor_g: zone_factor_g?,
        return_period_years: u32::try_from(years.value).unwrap_or(0), // refused by the code
        soil: soil?,
    })
}

fn eurocode(reader: &mut Reader, raw: &At<SiteRaw>) -> Option<Site> {
    let given = &raw.value;
    needs(
        reader,
        raw,
        SiteKey::SpectrumType,
        WrongSite::WriteSpectrumTypeSurface,
    );
    needs(reader, raw, SiteKey::Ground, WrongSite::WriteGroundRockTo);
    needs(
        reader,
        raw,
        SiteKey::GroundAcceleration,
        WrongSite::WriteGroundAccelerationG,
    );
    let ground_m_s2 = reader.plain(
        given.ground_acceleration.as_ref(),
        "site.ground_acceleration",
        Measure::GroundAcceleration,
        Bound::Positive,
    );
    let kind = reader.count(given.spectrum_type.as_ref(), "site.spectrum_type", 1, 2);
    Some(Site::Eurocode8 {
        ground_acceleration_g: ground_m_s2? / STANDARD_GRAVITY_M_S2,
        importance_factor: given
            .importance_factor
            .as_ref()
            .map_or(1.0, |factor| factor.value),
        spectrum: if kind? == 1 {
            EurocodeType::One
        } else {
            EurocodeType::Two
        },
        ground: match given.ground.as_ref()?.value {
            GroundRaw::A => EurocodeGround::A,
            GroundRaw::B => EurocodeGround::B,
            GroundRaw::C => EurocodeGround::C,
            GroundRaw::D => EurocodeGround::D,
            GroundRaw::E => EurocodeGround::E,
        },
    })
}

fn table(reader: &mut Reader, raw: &At<SiteRaw>) -> Option<Site> {
    let given = &raw.value;
    needs(reader, raw, SiteKey::Unit, WrongSite::WriteUnitGOr);
    let factor = given
        .unit
        .as_ref()
        .and_then(|unit| acceleration_unit(reader, unit));
    let peak = reader.plain(
        given.peak_ground_acceleration.as_ref(),
        "site.peak_ground_acceleration",
        Measure::GroundAcceleration,
        Bound::NotNegative,
    );
    let rows = match (&given.file, &given.periods_s, &given.accelerations) {
        (Some(file), None, None) => rows_of_file(reader, file),
        (None, Some(periods), Some(accelerations)) => {
            let (all, other) = (&periods.value, &accelerations.value);
            if all.len() != other.len() {
                let message = WrongSite::SiteAccelerationsHasNumbers {
                    accelerations: other.len().to_string(),
                    periods: all.len().to_string(),
                };
                let fault = Fault::new(accelerations.span.clone(), "site.accelerations", message);
                reader.fault(fault.allowed(WrongSite::MustBeOnePeriod));
                return None;
            }
            Some(all.iter().zip(other).map(|(t, a)| [*t, *a]).collect())
        }
        (Some(file), ..) => {
            let fault = Fault::new(file.span.clone(), "site.file", WrongSite::SiteHasBothFile);
            reader.fault(fault.help(WrongSite::KeepFileOrPeriods));
            None
        }
        _ => {
            needs(reader, raw, SiteKey::PeriodsS, WrongSite::WritePeriodsSAnd);
            needs(
                reader,
                raw,
                SiteKey::Accelerations,
                WrongSite::WriteAccelerationsOnePeriod,
            );
            None
        }
    };
    let factor = factor?;
    let points: Vec<[f64; 2]> = rows?;
    Some(Site::Table {
        source: given.source.as_ref().map_or_else(
            || match &given.file {
                // a name that is the same in every language
                Some(file) => file.value.clone(),
                None => "project.toml".to_owned(),
            },
            |source| source.value.clone(),
        ),
        points: points.into_iter().map(|[t, a]| [t, factor * a]).collect(),
        damping_ratio: DAMPING_RATIO,
        peak_ground_acceleration_m_s2: peak,
    })
}

/// m/s² of a unit of acceleration.
fn acceleration_unit(reader: &mut Reader, unit: &At<String>) -> Option<f64> {
    match Unit::parse(&unit.value) {
        Ok(unit) if unit.quantity() == Quantity::Acceleration => Some(unit.si()),
        _ => {
            let message = WrongSite::SiteUnitIsNo(unit.value.to_string());
            let fault = Fault::new(unit.span.clone(), "site.unit", message);
            reader.fault(fault.allowed(WrongSite::MustBeGM));
            None
        }
    }
}

/// Rows of two numbers, without lines that begin with # and without a first line of names.
fn rows_of_file(reader: &mut Reader, file: &At<String>) -> Option<Vec<[f64; 2]>> {
    let refuse = |reader: &mut Reader, why: Both| {
        let message = WrongSite::SiteFile {
            file: file.value.to_string(),
            why,
        };
        reader.fault(Fault::new(file.span.clone(), "site.file", message));
    };
    let bytes = match reader.files.read(&file.value, TABLE_BYTES_MOST) {
        Ok(bytes) => bytes,
        Err(why) => {
            refuse(reader, said(&why));
            return None;
        }
    };
    let text = String::from_utf8_lossy(&bytes);
    let mut rows = Vec::new();
    let mut has_names = false;
    for (i, line) in text.lines().enumerate() {
        let line = line.trim_start_matches('\u{feff}').trim();
        if line.is_empty() || line.starts_with('#') {
            continue;
        }
        let cells = line.split([',', ';', '\t', ' ']).filter(|cell| !cell.is_empty());
        let numbers: Vec<Option<f64>> = cells.map(|cell| cell.parse::<f64>().ok()).collect();
        match numbers[..] {
            [Some(period_s), Some(acceleration)] => rows.push([period_s, acceleration]),
            _ if rows.is_empty() && !has_names => has_names = true,
            _ => {
                let why = WrongSite::LineIsNotPeriod((i + 1).to_string());
                refuse(reader, why.into());
                return None;
            }
        }
    }
    Some(rows)
}
