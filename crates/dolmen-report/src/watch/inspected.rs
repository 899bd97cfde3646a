//! Findings of successive inspections.

use super::chance::chance;
use super::dated_changes::changes_said;
use super::logs::month;
use super::numbers::{HALF_95, bare_logged, logged, percent, plain};
use crate::document::{Finding, Tone};
use crate::engineer::named_damage;
use dolmen::monitoring::ChangeForm;
use dolmen_project::Severity;
use dolmen_words::message::Both;
use dolmen_words::{Digits, Quantity, Sentence, messages};
use dolmen_work::inspected::{Inspected, InspectionOf, WatchedDamage};
use dolmen_work::watched::WatchAnswer;

/// Number of damages that a sentence lists.
const LISTED_MOST: usize = 4;

messages! {
    /// Findings on inspections.
    pub(crate) enum Inspections in "watch.inspections" {
        Counted { last: String, all: usize, severe: usize, moderate: usize, before: String, then: usize, severe_then: usize } => {
            en: "Entries of the inspection of {last}: {all}, {severe} severe and {moderate} moderate; of that of {before}: {then}, {severe_then} severe.",
            ko: "{last} 점검의 항목은 {all}건(심함 {severe}건, 보통 {moderate}건)이며 {before} 점검에서는 {then}건(심함 {severe_then}건)이었다.",
        },
        CountedFirst { last: String, all: usize, severe: usize, moderate: usize } => {
            en: "Entries of the inspection of {last}: {all}, {severe} severe and {moderate} moderate.",
            ko: "{last} 점검의 항목은 {all}건(심함 {severe}건, 보통 {moderate}건)이다.",
        },
        New { last: String, each: Vec<Sentence>, count: usize } => {
            en: "New in the inspection of {last} ({count}): {each}.",
            ko: "{last} 점검에서 새로 발견한 것({count}건): {each}.",
        },
        RatedWorse { last: String, each: Vec<Sentence>, count: usize } => {
            en: "Called worse than before in the inspection of {last} ({count}): {each}.",
            ko: "{last} 점검에서 정도가 나빠진 것({count}건): {each}.",
        },
        NotListed { last: String, each: Vec<Sentence>, count: usize } => {
            en: "Not listed in the inspection of {last}, mended or not looked for ({count}): {each}. If they were mended, enter a repair into «works of [watch]|the list of works».",
            ko: "{last} 점검에 없는 것(보수하였거나 살피지 않음, {count}건): {each}. 보수하였다면 «[watch]의 works에 repair|조치 이력에 보수»로 적는다.",
        },
        Damage { part: String, what: Sentence } => { en: "{what} of “{part}”", ko: "‘{part}’ {what}" },
        Beyond { damage: Sentence, size: Quantity, limit: Quantity, date: String } => {
            en: "{damage}: {size}, at its limit of {limit} or beyond ({date}).",
            ko: "{damage}: {size}(으)로 한계 {limit}에 이르렀거나 넘었다({date}).",
        },
        BeyondNotListed { damage: Sentence, size: Quantity, limit: Quantity, date: String, last: String } => {
            en: "{damage}: {size} on {date}, at its limit of {limit} or beyond, and the inspection of {last} does not list it. If it was mended, enter a repair into «works of [watch]|the list of works»; else look again.",
            ko: "{damage}: {date}에 {size}(으)로 한계 {limit}에 이르렀거나 넘었으나 {last} 점검에 없다. 보수하였다면 «[watch]의 works에 repair|조치 이력에 보수»로 적고, 아니면 다시 살핀다.",
        },
        Near { damage: Sentence, size: Quantity, limit: Quantity, share: Quantity, date: String } => {
            en: "{damage}: NEAR ITS LIMIT: {size} ({date}), {share} of {limit}.",
            ko: "{damage}: 한계에 가까움. {size}({date})(으)로 한계 {limit}의 {share}이다.",
        },
        Reaches { damage: Sentence, yearly: Quantity, half: Quantity, limit: Quantity, when: Both, earliest: Both, latest: Both } => {
            en: "{damage}: {yearly} ± {half} a year, beyond chance; at that rate it reaches its limit of {limit} in {when} ({earliest} to {latest}).",
            ko: "{damage}: 해마다 {yearly} ± {half}씩 유의하게 변한다. 이 속도로는 {when}({earliest}~{latest})에 한계 {limit}에 이른다.",
        },
        Grows { damage: Sentence, yearly: Quantity, half: Quantity, now: Quantity } => {
            en: "{damage}: {yearly} ± {half} a year, beyond chance; now {now}.",
            ko: "{damage}: 해마다 {yearly} ± {half}씩 유의하게 변한다. 현재 {now}이다.",
        },
        Steady { damage: Sentence, least: Quantity, now: Quantity } => {
            en: "{damage}: no trend; a slope of {least} a year would have been seen with 80 % probability. Now {now}.",
            ko: "{damage}: 경향 없음. 해마다 {least}의 변화는 80 %의 확률로 검출되었을 것이다. 현재 {now}이다.",
        },
        FewGrew { damage: Sentence, by: Quantity, from: String, to: String, readings: usize } => {
            en: "{damage}: it grew by {by} from {from} to {to}, more than reading it may be off ({readings} readings; a slope needs four of one level).",
            ko: "{damage}: {from}부터 {to}까지 {by} 커져 측정 오차를 넘는다(측정 {readings}회. 경향을 구하려면 같은 수준에서 4회가 필요하다).",
        },
        FewSteady { damage: Sentence, by: Quantity, readings: usize } => {
            en: "{damage}: it changed by {by}, no more than reading it may be off ({readings} readings; a slope needs four of one level).",
            ko: "{damage}: 변화 {by}은(는) 측정 오차를 넘지 않는다(측정 {readings}회. 경향을 구하려면 같은 수준에서 4회가 필요하다).",
        },
        Grew { damage: Sentence, by: Quantity, from: String, to: String, readings: usize, now: Quantity } => {
            en: "{damage}: it grew by {by} from {from} to {to}, more than reading it may be off, though its {readings} readings show no steady slope. Now {now}: look at it, and whether it goes on.",
            ko: "{damage}: {from}부터 {to}까지 {by} 커져 측정 오차를 넘으나 측정 {readings}회로는 일정한 변화 속도가 보이지 않는다. 현재 {now}이다. 현장을 살피고 계속 변하는지 확인한다.",
        },
        Jumped { damage: Sentence, by: Quantity, half: Quantity, after: String, before: String, cause: Sentence } => {
            en: "{damage}: it jumped by {by} ± {half} between {after} and {before}{cause}: look at it, and whether it goes on.",
            ko: "{damage}: {after}와(과) {before} 사이에 {by} ± {half}만큼 급변하였다{cause}. 현장을 살피고 계속 변하는지 확인한다.",
        },
        Bends { damage: Sentence, about: String, after: String, before: String, by: Quantity, half: Quantity } => {
            en: "{damage}: its slope changed in about {about} ({after} to {before}), by {by} ± {half} a year.",
            ko: "{damage}: 변화 속도가 {about}경({after}~{before})에 해마다 {by} ± {half}만큼 바뀌었다.",
        },
        Alone { damage: Sentence, date: String, read: Quantity, expected: Quantity } => {
            en: "{damage}: read as {read} on {date}, where the readings around it give {expected}: it stands alone, and is left out of the slope. Check its decimal point and unit.",
            ko: "{damage}: {date}의 {read}은(는) 앞뒤 측정값에 따른 {expected}에서 홀로 벗어나 경향에서 제외하였다. 소수점과 단위를 확인한다.",
        },
        LastOff { damage: Sentence, date: String, read: Quantity, expected: Quantity, chance: Sentence } => {
            en: "{damage}: the newest size, {read} ({date}), lies far from the {expected} that the readings before it predict ({chance}); the slope is without it. Check its decimal point and unit; if it is right, look at the damage.",
            ko: "{damage}: 가장 최근의 {read}({date})은(는) 이전 측정값에 따른 {expected}에서 크게 벗어나며({chance}) 경향은 이 값을 빼고 구하였다. 소수점과 단위를 확인하고, 값이 맞다면 손상을 살핀다.",
        },
        WasBeyond { damage: Sentence, size: Quantity, limit: Quantity, date: String } => {
            en: "{damage}: it was at its limit of {limit} or beyond on {date} ({size}), and is not now: check what was written down, and whether it was mended.",
            ko: "{damage}: {date}에 {size}(으)로 한계 {limit}에 이르렀거나 넘었으나 지금은 아니다. 적은 값과 보수 여부를 확인한다.",
        },
        Several { each: Vec<Sentence>, count: usize } => {
            en: "Inspections list several of a kind at one part, so that none of them is followed ({count}): {each}.« Give each a name, the same in every inspection: name = \"C1\".»",
            ko: "한 부재에 같은 손상이 여럿 있어 추적하지 못한 것({count}건): {each}.« 모든 점검에서 같은 이름을 붙인다: name = \"C1\".»",
        },
        Undated { count: usize } => {
            en: "Entries of inspections in surveys whose names begin with no date are left out: {count}.",
            ko: "이름이 날짜로 시작하지 않는 조사의 점검 항목은 제외하였다: {count}건.",
        },
    }
}

/// Name of a damage, with its part.
pub(crate) fn damage_name(of: &WatchedDamage) -> Sentence {
    Inspections::Damage {
        part: of.part.clone(),
        what: named_damage(&of.what, of.name.as_deref()),
    }
    .into()
}

/// A size with as many digits as it has.
pub(super) fn size(metres: f64) -> Quantity {
    let mut size = logged(metres, false, 3);
    size.digits = Digits::Trimmed(3);
    size
}

/// A size with half the width of its interval, both to the same digit.
fn with_half(metres: f64, half_m: f64) -> Quantity {
    Quantity {
        sd_si: Some(1000.0 * half_m),
        ..size(metres)
    }
}

/// Findings on the damages that have reached their limits.
pub(crate) fn beyond_limits(found: &Inspected) -> Vec<Finding> {
    let date = |inspection: usize| {
        let of = found.inspections.get(inspection);
        of.map_or_else(String::new, |of| of.survey.clone())
    };
    let Some(last) = found.last() else {
        return Vec::new();
    };
    found.beyond().filter_map(|of| beyond(of, last, &date)).collect()
}

/// The findings: damages at their limit, growing, new, and their number.
pub(super) fn inspected(answer: &WatchAnswer) -> Vec<Finding> {
    let found = &answer.inspected;
    let Some(last) = found.last() else {
        return undated(found.undated).into_iter().collect();
    };
    let date = |inspection: usize| {
        let of = found.inspections.get(inspection);
        of.map_or_else(String::new, |of| of.survey.clone())
    };
    let mut all = Vec::new();
    for of in &found.damages {
        all.extend(near(of, &date));
        all.extend(growth(of, last, &date));
        all.extend(changed(answer, of, &date));
    }
    let named = |some: Vec<&WatchedDamage>| -> (Vec<Sentence>, usize) {
        let count = some.len();
        let first = some.into_iter().take(LISTED_MOST);
        (first.map(damage_name).collect(), count)
    };
    let last_name = || last.survey.clone();
    let (each, count) = named(found.damages.iter().filter(|of| of.is_new()).collect());
    if count > 0 {
        let last = last_name();
        all.push(Finding::key(Tone::Warn, Inspections::New { last, each, count }));
    }
    let worse = |of: &&WatchedDamage| of.is_in_last && of.is_rated_worse();
    let (each, count) = named(found.damages.iter().filter(worse).collect());
    if count > 0 {
        let last = last_name();
        all.push(Finding::key(
            Tone::Warn,
            Inspections::RatedWorse { last, each, count },
        ));
    }
    let (each, count) = named(found.not_listed().filter(|of| !of.is_beyond()).collect());
    if count > 0 {
        let last = last_name();
        all.push(Finding::key(
            Tone::Unknown,
            Inspections::NotListed { last, each, count },
        ));
    }
    let several = found.several.iter().take(LISTED_MOST);
    let each: Vec<Sentence> = several
        .map(|of| {
            let damage = Inspections::Damage {
                part: of.part.clone(),
                what: named_damage(&of.what, None),
            };
            damage.into()
        })
        .collect();
    if !each.is_empty() {
        let count = found.several.len();
        all.push(Finding::key(Tone::Unknown, Inspections::Several { each, count }));
    }
    all.push(counted(&found.inspections, last));
    all.extend(undated(found.undated));
    all
}

fn undated(count: usize) -> Option<Finding> {
    (count > 0).then(|| Finding::key(Tone::Unknown, Inspections::Undated { count }))
}

/// Their number, compared with the inspection before.
fn counted(all: &[InspectionOf], last: &InspectionOf) -> Finding {
    let severe = last.rated(Some(Severity::Severe));
    let moderate = last.rated(Some(Severity::Moderate));
    let before = all.len().checked_sub(2).and_then(|at| all.get(at));
    let tone = if severe > 0 { Tone::Warn } else { Tone::Plain };
    let said = match before {
        Some(before) => Inspections::Counted {
            last: last.survey.clone(),
            all: last.all(),
            severe,
            moderate,
            before: before.survey.clone(),
            then: before.all(),
            severe_then: before.rated(Some(Severity::Severe)),
        },
        None => Inspections::CountedFirst {
            last: last.survey.clone(),
            all: last.all(),
            severe,
            moderate,
        },
    };
    Finding::key(tone, said)
}

/// A size near its limit.
fn near(of: &WatchedDamage, date: &dyn Fn(usize) -> String) -> Option<Finding> {
    let (read, limit_m) = (of.last()?, of.limit_m?);
    let share = of.share_of_limit().filter(|_| of.is_near())?;
    let said = Inspections::Near {
        damage: damage_name(of),
        size: size(share * limit_m),
        limit: size(limit_m),
        share: percent(share, 0),
        date: date(read.inspection),
    };
    Some(Finding::key(Tone::Warn, said))
}

/// Finding that a damage has reached its limit.
fn beyond(of: &WatchedDamage, last: &InspectionOf, date: &dyn Fn(usize) -> String) -> Option<Finding> {
    let (read, damage) = (of.last()?, damage_name(of));
    let (limit_m, size_m) = (of.limit_m.filter(|_| of.is_beyond())?, of.size_to_judge_m()?);
    let (limit, date, size) = (size(limit_m), date(read.inspection), size(size_m));
    let said = match of.is_in_last {
        true => Inspections::Beyond {
            damage,
            size,
            limit,
            date,
        },
        false => Inspections::BeyondNotListed {
            damage,
            size,
            limit,
            date,
            last: last.survey.clone(),
        },
    };
    Some(Finding::key(Tone::Bad, said))
}

/// Findings from the readings of a damage.
fn growth(of: &WatchedDamage, last: &InspectionOf, date: &dyn Fn(usize) -> String) -> Option<Finding> {
    let (read, damage) = (of.last()?, damage_name(of));
    let now = size(read.size_m);
    if let Some(found) = beyond(of, last, date) {
        return Some(found);
    }
    // a repair ended it
    if of.is_repaired {
        return None;
    }
    let Some(slope) = of.trend.slope else {
        let grown = of.grown()?;
        let (from, readings) = (date(grown.from), of.readings.len());
        let by = with_half(grown.by_m, HALF_95 * grown.sd_m);
        return Some(match grown.is_beyond(HALF_95) {
            true => Finding::key(
                Tone::Warn,
                Inspections::FewGrew {
                    damage,
                    by,
                    from,
                    to: date(read.inspection),
                    readings,
                },
            ),
            false => Finding::new(Tone::Unknown, Inspections::FewSteady { damage, by, readings }),
        });
    };
    if !of.trend.is_beyond_chance() {
        let is_told = !of.trend.changes.is_empty() || of.trend.last_off.is_some();
        if let Some(grown) = of.grown().filter(|grown| !is_told && grown.is_beyond(HALF_95)) {
            let said = Inspections::Grew {
                damage,
                by: with_half(grown.by_m, HALF_95 * grown.sd_m),
                from: date(grown.from),
                to: date(read.inspection),
                readings: of.readings.len(),
                now,
            };
            return Some(Finding::key(Tone::Warn, said));
        }
        let least = logged(slope.seen_from_per_year, false, 3);
        return Some(Finding::new(
            Tone::Plain,
            Inspections::Steady { damage, least, now },
        ));
    }
    let (yearly, half) = (
        bare_logged(slope.per_year, false, 3),
        logged(HALF_95 * slope.sd_per_year, false, 3),
    );
    let reach = slope
        .reach
        .and_then(|reach| Some((reach, reach.years?, reach.years_earliest?, reach.years_latest?)));
    let said = match reach {
        Some((reach, years, earliest, latest)) => Inspections::Reaches {
            damage,
            yearly,
            half,
            limit: size(reach.limit),
            when: month(read.day, years),
            earliest: month(read.day, earliest),
            latest: month(read.day, latest),
        },
        None => Inspections::Grows {
            damage,
            yearly,
            half,
            now,
        },
    };
    Some(Finding::key(Tone::Warn, said))
}

/// Steps, changes of slope, readings that stand alone or are off, and a limit that was reached before.
fn changed(answer: &WatchAnswer, of: &WatchedDamage, date: &dyn Fn(usize) -> String) -> Vec<Finding> {
    let survey = |reading: usize| {
        let of = of.readings.get(reading);
        of.map_or_else(String::new, |of| date(of.inspection))
    };
    let damage = || damage_name(of);
    let mut all = changes_said(answer, &of.trend, &survey, |change| match change.of.form {
        ChangeForm::Step => Inspections::Jumped {
            damage: damage(),
            by: bare_logged(change.of.size, false, 2),
            half: logged(HALF_95 * change.of.sd, false, 2),
            after: change.after,
            before: change.before,
            cause: change.cause.into(),
        },
        ChangeForm::Slope => Inspections::Bends {
            damage: damage(),
            about: change.about,
            after: change.after,
            before: change.before,
            by: bare_logged(change.of.size, false, 3),
            half: logged(HALF_95 * change.of.sd, false, 3),
        },
    });
    let alone = of.trend.outliers.iter().map(|outlier| Inspections::Alone {
        damage: damage(),
        date: survey(outlier.at),
        read: of
            .readings
            .get(outlier.at)
            .map_or_else(|| plain(f64::NAN, 2), |read| size(read.size_m)),
        expected: size(outlier.expected),
    });
    let read_last = of.last();
    let last_off = of
        .trend
        .last_off
        .zip(read_last)
        .map(|(off, read)| Inspections::LastOff {
            damage: damage(),
            date: date(read.inspection),
            read: size(read.size_m),
            expected: with_half(off.expected, off.half_95),
            chance: chance(off.p_value),
        });
    let was_beyond = of
        .was_beyond()
        .zip(of.limit_m)
        .map(|(read, limit_m)| Inspections::WasBeyond {
            damage: damage(),
            size: size(read.size_m),
            limit: size(limit_m),
            date: date(read.inspection),
        });
    let each = alone.chain(last_off).chain(was_beyond);
    all.extend(each.map(|said| Finding::key(Tone::Warn, said)));
    all
}
