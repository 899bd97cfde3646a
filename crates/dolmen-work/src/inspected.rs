//! Inspections over the years: number of damages of each kind, and the growth of each damage.

use crate::compared_readings::DamageKey;
use crate::dated_works::works_by_day;
use crate::near_limit::is_near;
use crate::survey_dates::{date, day_of};
use dolmen::monitoring::{
    ANSWERED_DAYS, GrowthOptions, GrowthSeries, MonitoringError, TiltTrend, WatchOptions, growth,
};
use dolmen_project::{DamageKind, Inspection, Project, Severity, WorkKind, WorkPart};
use std::collections::BTreeMap;

/// Findings of inspections over the years.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Inspected {
    /// The inspections by time.
    pub inspections: Vec<InspectionOf>,
    /// Each damage that can be followed, the worst first: at its limit, growing, then by part.
    pub damages: Vec<WatchedDamage>,
    /// Damages that one inspection lists several times.
    pub several: Vec<SeveralAlike>,
    /// Number of entries left out because their surveys have no date.
    pub undated: usize,
}

/// One inspection.
#[derive(Clone, Debug, PartialEq)]
pub struct InspectionOf {
    /// Its survey.
    pub survey: String,
    /// Its day, from 1970-01-01.
    pub day: f64,
    /// Number of damages of each kind, by severity: slight, moderate, severe, not rated.
    pub counts: BTreeMap<DamageKind, [usize; 4]>,
}

impl InspectionOf {
    /// Number of a severity; `None` for those not rated.
    pub fn rated(&self, severity: Option<Severity>) -> usize {
        self.counts.values().map(|of| of[place(severity)]).sum()
    }

    /// Number of damages.
    pub fn all(&self) -> usize {
        self.counts.values().flatten().sum()
    }
}

/// Index of a severity in the counts.
fn place(severity: Option<Severity>) -> usize {
    match severity {
        Some(Severity::Slight) => 0,
        Some(Severity::Moderate) => 1,
        Some(Severity::Severe) => 2,
        None => 3,
    }
}

/// A damage that one inspection lists more than once, so that its entries cannot be distinguished.
#[derive(Clone, Debug, PartialEq)]
pub struct SeveralAlike {
    /// The part.
    pub part: String,
    /// Its kind.
    pub what: DamageKind,
    /// The largest number in one inspection.
    pub most: usize,
}

/// A size of a damage in one inspection.
#[derive(Clone, Debug, PartialEq)]
pub struct SizeRead {
    /// Index of the inspection.
    pub inspection: usize,
    /// Its day.
    pub day: f64,
    /// The size, m.
    pub size_m: f64,
    /// Standard deviation of the reading, m.
    pub sd_m: f64,
}

/// One damage over the years.
#[derive(Clone, Debug, PartialEq)]
pub struct WatchedDamage {
    /// The part.
    pub part: String,
    /// Its kind.
    pub what: DamageKind,
    /// Its name, if inspections give one.
    pub name: Option<String>,
    /// Indices of the inspections that list it.
    pub listed: Vec<usize>,
    /// Its severity in each of them.
    pub severities: Vec<Option<Severity>>,
    /// Its sizes, by time.
    pub readings: Vec<SizeRead>,
    /// Its limit, m.
    pub limit_m: Option<f64>,
    /// The slope of its size.
    pub trend: TiltTrend,
    /// Whether a repair followed the last reading.
    pub is_repaired: bool,
    /// Day of the last repair before the last entry; −∞ without one.
    pub repaired_on: f64,
    /// Whether the last inspection of all lists it.
    pub is_in_last: bool,
}

/// Growth of a damage.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Grown {
    /// The inspection of the first reading.
    pub from: usize,
    /// Last size minus first size, m.
    pub by_m: f64,
    /// Its standard deviation, m.
    pub sd_m: f64,
}

impl Grown {
    /// Whether it grew by more than this number of standard deviations.
    pub fn is_beyond(&self, deviations: f64) -> bool {
        self.by_m > deviations * self.sd_m
    }
}

/// Fewest readings whose differences show their scatter. Our choice.
const SCATTER_FROM: usize = 4;
/// Ratio of the standard deviation to the median absolute deviation of normal values.
const OF_MEDIAN: f64 = 1.4826;

impl WatchedDamage {
    /// The last measured size.
    pub fn last(&self) -> Option<&SizeRead> {
        self.readings.last()
    }

    /// The size to compare with the limit: the last measured one, or the fitted size at that day if it is larger.
    pub fn size_to_judge_m(&self) -> Option<f64> {
        let fitted = self.trend.slope.map_or(f64::NEG_INFINITY, |slope| slope.now);
        self.last().map(|last| last.size_m.max(fitted))
    }

    /// Whether it has reached its limit without a later repair.
    pub fn is_beyond(&self) -> bool {
        let at = self.limit_m.zip(self.size_to_judge_m());
        !self.is_repaired && at.is_some_and(|(limit, size)| size >= limit)
    }

    /// The largest earlier reading at the limit since the last repair, where the size is below it now.
    pub fn was_beyond(&self) -> Option<&SizeRead> {
        let limit = self.limit_m.filter(|_| !self.is_beyond() && !self.is_repaired)?;
        let since = self.readings.iter().filter(|read| read.day > self.repaired_on);
        since
            .filter(|read| read.size_m >= limit)
            .max_by(|a, b| a.size_m.total_cmp(&b.size_m))
    }

    /// The size over its limit.
    pub fn share_of_limit(&self) -> Option<f64> {
        self.limit_m
            .zip(self.size_to_judge_m())
            .map(|(limit, size)| size / limit)
    }

    /// Whether it is near its limit, but has not reached it.
    pub fn is_near(&self) -> bool {
        let is_open = !self.is_repaired && !self.is_beyond();
        is_open && self.share_of_limit().is_some_and(is_near)
    }

    /// Growth from the first reading since the last repair to the last one; `None` for fewer than two readings.
    ///
    /// ```text
    /// σ² = σ_first² + σ_last², each at least d²/2      d: lower median of the differences of successive readings × 1.4826, from four readings on
    /// ```
    ///
    /// The median of the differences is the scatter of the readings, which one or two steps do not change.
    pub fn grown(&self) -> Option<Grown> {
        let since: Vec<&SizeRead> = self
            .readings
            .iter()
            .filter(|read| read.day > self.repaired_on)
            .collect();
        let [first, .., last] = since.as_slice() else {
            return None;
        };
        let mut steps: Vec<f64> = since
            .windows(2)
            .map(|pair| (pair[1].size_m - pair[0].size_m).abs())
            .collect();
        steps.sort_by(f64::total_cmp);
        let scatter = match since.len() >= SCATTER_FROM {
            true => OF_MEDIAN * steps[(steps.len() - 1) / 2] / 2f64.sqrt(),
            false => 0.0,
        };
        Some(Grown {
            from: first.inspection,
            by_m: last.size_m - first.size_m,
            sd_m: first.sd_m.max(scatter).hypot(last.sd_m.max(scatter)),
        })
    }

    /// Whether its severity is worse than in the previous inspection that lists it.
    pub fn is_rated_worse(&self) -> bool {
        let mut rated = self.severities.iter().rev().flatten();
        matches!((rated.next(), rated.next()), (Some(now), Some(before)) if now > before)
    }

    /// Whether the last inspection is the first to list it.
    pub fn is_new(&self) -> bool {
        self.is_in_last && self.listed.len() == 1 && self.listed[0] > 0
    }
}

impl Inspected {
    /// The last inspection.
    pub fn last(&self) -> Option<&InspectionOf> {
        self.inspections.last()
    }

    /// Damages that have reached their limit, without a later repair.
    pub fn beyond(&self) -> impl Iterator<Item = &WatchedDamage> {
        self.damages.iter().filter(|of| of.is_beyond())
    }

    /// Damages missing from the last inspection, without a repair since they were listed.
    pub fn not_listed(&self) -> impl Iterator<Item = &WatchedDamage> {
        self.damages.iter().filter(|of| !of.is_in_last && !of.is_repaired)
    }
}

/// Inspections with a date and an entry.
pub(crate) fn inspections(project: &Project) -> impl Iterator<Item = (f64, &str, &[Inspection])> {
    let surveys = project.surveys.iter();
    surveys.filter_map(|survey| {
        let day = day_of(date(&survey.name)?);
        (!survey.inspections.is_empty()).then_some((day, survey.name.as_str(), survey.inspections.as_slice()))
    })
}

/// The inspections of a project with a damage that has reached its limit; `None` if none has.
pub fn inspected_beyond(project: &Project) -> Option<Inspected> {
    let has_limit = inspections(project).any(|(.., items)| items.iter().any(|item| item.limit.is_some()));
    let found = match has_limit {
        true => inspected(project, &works_by_day(project), None).ok()?,
        false => return None,
    };
    let is_any = found.beyond().next().is_some();
    is_any.then_some(found)
}

/// Results of the inspections of a project over the years; `works` are by day, `newest` is the last day with any information.
pub(crate) fn inspected(
    project: &Project,
    works: &[(f64, WorkPart)],
    newest: Option<f64>,
) -> Result<Inspected, MonitoringError> {
    let mut all: Vec<(f64, &str, &[Inspection])> = inspections(project).collect();
    all.sort_by(|a, b| a.0.total_cmp(&b.0));
    let listed = project.surveys.iter().map(|survey| survey.inspections.len());
    let dated: usize = all.iter().map(|(_, _, items)| items.len()).sum();
    let mut found = Inspected {
        undated: listed.sum::<usize>() - dated,
        ..Inspected::default()
    };
    let mut entries: BTreeMap<DamageKey<'_>, Vec<(usize, &Inspection)>> = BTreeMap::new();
    for (at, (day, survey, items)) in all.iter().enumerate() {
        let mut counts: BTreeMap<DamageKind, [usize; 4]> = BTreeMap::new();
        for item in *items {
            counts.entry(item.what.clone()).or_default()[place(item.severity)] += 1;
            entries.entry(DamageKey::of(item)).or_default().push((at, item));
        }
        found.inspections.push(InspectionOf {
            survey: (*survey).to_owned(),
            day: *day,
            counts,
        });
    }
    let newest = newest.unwrap_or(f64::NEG_INFINITY);
    let last_day = found.last().map_or(newest, |last| last.day.max(newest));
    let repairs: Vec<(usize, f64)> = works
        .iter()
        .enumerate()
        .filter(|(_, (day, work))| work.kind == WorkKind::Repair && *day <= last_day + ANSWERED_DAYS)
        .map(|(at, (day, _))| (at, *day))
        .collect();
    let (alike, told): (Vec<_>, Vec<_>) = entries.into_iter().partition(|(_, entries)| most(entries) > 1);
    found.several = alike
        .iter()
        .map(|(key, entries)| SeveralAlike {
            part: key.part.to_owned(),
            what: key.what.clone(),
            most: most(entries),
        })
        .collect();
    // damages are tested together
    let with_sizes = told
        .iter()
        .filter(|(_, entries)| entries.iter().filter(|(_, item)| item.size.is_some()).count() > 1);
    let usual = WatchOptions::default();
    let options = GrowthOptions {
        repairs,
        limit_m: None,
        significance: usual.significance / with_sizes.count().max(1) as f64,
        replicates: usual.replicates,
        seed: usual.seed,
    };
    for (key, entries) in told {
        let of = damage(key, &entries, &found.inspections, &options)?;
        found.damages.push(of);
    }
    // the worst first, then by name
    found
        .damages
        .sort_by_key(|of| (!of.is_beyond(), !of.trend.is_beyond_chance()));
    Ok(found)
}

/// Largest number of entries of the damage in one inspection.
fn most(entries: &[(usize, &Inspection)]) -> usize {
    let of = |at: usize| entries.iter().filter(|(other, _)| *other == at).count();
    entries.iter().map(|(at, _)| of(*at)).max().unwrap_or(0)
}

fn damage(
    key: DamageKey<'_>,
    entries: &[(usize, &Inspection)],
    inspections: &[InspectionOf],
    options: &GrowthOptions,
) -> Result<WatchedDamage, MonitoringError> {
    let mut readings: Vec<SizeRead> = Vec::new();
    for (at, item) in entries {
        let Some(size) = &item.size else { continue };
        let read = SizeRead {
            inspection: *at,
            day: inspections[*at].day,
            size_m: size.value,
            sd_m: item.reading_sd_m(),
        };
        // for two inspections on one day the larger size counts
        match readings.last_mut().filter(|last| last.day == read.day) {
            Some(last) if last.size_m >= read.size_m => {}
            Some(last) => *last = read,
            None => readings.push(read),
        }
    }
    let limits = entries.iter().rev().filter_map(|(_, item)| item.limit.as_ref());
    let limit_m = limits.map(|limit| limit.value).next();
    let series = GrowthSeries {
        days: readings.iter().map(|read| read.day).collect(),
        sizes_m: readings.iter().map(|read| read.size_m).collect(),
        reading_sds_m: readings.iter().map(|read| read.sd_m).collect(),
    };
    let of = GrowthOptions {
        limit_m,
        ..options.clone()
    };
    let last_entry = entries.last().map_or(0, |(at, _)| *at);
    let since = inspections.get(last_entry).map_or(f64::INFINITY, |last| last.day);
    Ok(WatchedDamage {
        part: key.part.to_owned(),
        what: key.what.clone(),
        name: key.name.map(str::to_owned),
        listed: entries.iter().map(|(at, _)| *at).collect(),
        severities: entries.iter().map(|(_, item)| item.severity).collect(),
        readings,
        limit_m,
        trend: growth(series, &of)?,
        is_repaired: options.repairs.iter().any(|(_, day)| *day > since),
        repaired_on: options
            .repairs
            .iter()
            .map(|(_, day)| *day)
            .filter(|day| *day <= since)
            .fold(f64::NEG_INFINITY, f64::max),
        is_in_last: last_entry + 1 == inspections.len(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::opened::Opened;
    use dolmen_records::NoFiles;

    fn crack(sizes: &[f64], limit: &str) -> WatchedDamage {
        let survey = |(i, size): (usize, &f64)| {
            let item =
                format!("part = \"base\", what = \"crack\", name = \"C1\", size = \"{size} mm\"{limit}");
            format!("[survey.{}-05-01]\ninspections = [ {{ {item} }} ]\n", 2010 + i)
        };
        let text = format!(
            "schema = 1\nkind = \"survey\"\nname = \"P\"\n{}",
            sizes.iter().enumerate().map(survey).collect::<String>()
        );
        let opened = Opened::read(text, "p".to_owned(), &NoFiles).unwrap();
        let found = inspected(&opened.project, &[], None).unwrap();
        found.damages[0].clone()
    }

    #[test]
    fn holds_a_crack_that_grew_tenfold_is_told_by_any_number_of_readings() {
        for before in 1..12 {
            for after in 1..4 {
                let sizes: Vec<f64> = (0..before + after)
                    .map(|i| if i < before { 0.4 } else { 4.0 })
                    .collect();
                let found = crack(&sizes, "");
                let is_told = found.trend.last_off.is_some()
                    || !found.trend.changes.is_empty()
                    || found.trend.is_beyond_chance()
                    || found.grown().is_some_and(|grown| grown.is_beyond(1.96));
                assert!(is_told, "{before} {after}: {found:?}");
            }
            // a tenth of a millimetre is the last digit
            let steady: Vec<f64> = (0..before + 2).map(|i| 0.4 + 0.1 * f64::from(i % 2)).collect();
            assert!(!crack(&steady, "").grown().unwrap().is_beyond(1.96), "{steady:?}");
        }
    }

    #[test]
    fn exact_a_crack_is_near_its_limit_from_eight_tenths_on() {
        let near = |last: f64| crack(&[2.0, last], ", limit = \"3 mm\"").is_near();
        assert_eq!([2.3, 2.42, 2.9, 3.0].map(near), [false, true, true, false]);
    }
}
