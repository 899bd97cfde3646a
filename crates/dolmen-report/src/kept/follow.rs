//! Records of a watched folder, one line each, and metrics for other programs.

use crate::as_json;
use crate::modal::fault_words;
use dolmen::modal::LastingChange;
use dolmen::monitoring::{NotJudged, SensorChange};
use dolmen_words::message::Both;
use dolmen_words::{Digits, Language, Quantity, Sentence, Unit, Values, messages};
use dolmen_work::follow::{OpenAlarm, RecordTime, Taken, TimeSource, Verdict};
use dolmen_work::surveyed::Earthquake;
use dolmen_work::watched::WatchAnswer;
use serde_json::Value;

messages! {
    /// A new record in a watched folder, and its result.
    pub(crate) enum Followed in "store.followed" {
        Stored { survey: String, source: Sentence, file: String, frequencies: Values, verdict: Sentence, open: Sentence } => {
            en: "{survey} ({source}), {file}: {frequencies}; {verdict}{open}.",
            ko: "{survey}({source}), {file}: 고유진동수 {frequencies}. {verdict}{open}.",
        },
        OpenAlarms(count: usize) => { en: "; open alarms: {count}", ko: ". 조치되지 않은 경보 {count}건" },
        NoOpenAlarm => { en: "", ko: "" },
        Shaken { survey: String, source: Sentence, file: String, peak: Sentence, change: Sentence, open: Sentence } => {
            en: "EARTHQUAKE: {survey} ({source}), {file}: {peak}; {change}; stored apart from the ambient surveys{open}.",
            ko: "지진: {survey}({source}), {file}: {peak}, {change}. 상시진동 조사와 구분하여 저장하였다{open}.",
        },
        PeakOf(peak: Quantity) => { en: "peak {peak}", ko: "최대가속도 {peak}" },
        PeakAtLeast(peak: Quantity) => { en: "peak at least {peak}", ko: "최대가속도 {peak} 이상" },
        NoPeak(over: Quantity) => { en: "{over} times the noise", ko: "잡음의 {over}배" },
        Lasting { frequency: Quantity, by: Quantity } => {
            en: "LASTING CHANGE of {frequency} by {by}",
            ko: "{frequency} 모드에 {by}의 잔류 변화",
        },
        NothingLasts { frequency: Quantity, by: Quantity } => {
            en: "no lasting change beyond chance ({frequency} by {by})",
            ko: "유의한 잔류 변화 없음({frequency} 모드 {by})",
        },
        CannotTell => { en: "whether a change lasts cannot be told from it", ko: "잔류 변화는 이 기록으로 알 수 없음" },
        WithoutModes { survey: String, source: Sentence, file: String, why: Both } => {
            en: "{survey} ({source}), {file}: stored, but it gives no modes: {why}.",
            ko: "{survey}({source}), {file}: 저장하였으나 모드를 찾지 못하였다: {why}.",
        },
        NoModes { survey: String, source: Sentence, file: String } => {
            en: "{survey} ({source}), {file}: stored, but no mode was found in it.",
            ko: "{survey}({source}), {file}: 저장하였으나 확인된 모드가 없다.",
        },
        OfRecord => { en: "as the record says", ko: "기록에 적힌 시각" },
        OfFileName => { en: "as its name says", ko: "파일 이름의 날짜" },
        OfFileTime => { en: "as the file's time says", ko: "파일의 수정 시각" },
        Sensor(fault: Sentence) => { en: "  sensor: {fault}", ko: "  센서: {fault}" },
        ShapesJumped(assurance: Quantity) => {
            en: "  sensor: its shapes are not those of the surveys before it (MAC {assurance}) though its frequencies are: a sensor was turned, moved, exchanged, or its polarity is reversed",
            ko: "  센서: 고유진동수는 이전 조사와 같으나 모드형상이 다르다(MAC {assurance}). 센서의 방향·위치가 바뀌었거나 교체되었거나 극성이 반대이다",
        },
        ShapesJumpedAt { assurance: Quantity, channel: String } => {
            en: "  sensor: its shapes are not those of the surveys before it (MAC {assurance}) though its frequencies are; without {channel} they are: it was turned, moved, exchanged, or its polarity is reversed",
            ko: "  센서: 고유진동수는 이전 조사와 같으나 모드형상이 다르며(MAC {assurance}) {channel}을(를) 빼면 같다. 그 센서의 방향·위치가 바뀌었거나 교체되었거나 극성이 반대이다",
        },
        Traffic { from: Quantity, to: Quantity, peak: Sentence } => {
            en: "  strong shaking, {from} to {to} ({peak}): an earthquake, traffic close by, a gust or blows; the modes are those of the rest of the record",
            ko: "  강한 진동 {from}–{to}({peak}): 지진, 가까운 교통, 돌풍 또는 타격. 모드는 나머지 구간의 것이다",
        },
        LeftOut(channels: Vec<String>) => {
            en: "  left out of the identification: {channels}",
            ko: "  식별에서 제외함: {channels}",
        },
        WrongClock(said: String) => {
            en: "  its clock says {said}, which is not believed: set the clock of the logger",
            ko: "  기록의 시계가 {said}을(를) 가리키므로 따르지 않았다. 기록계의 시계를 맞춘다",
        },
        Quarantined { file: String, place: String, why: Both } => {
            en: "{file} cannot be read and was moved to {place}: {why}.",
            ko: "{file}을(를) 읽을 수 없어 {place}(으)로 옮겼다: {why}.",
        },
        Alarm(frequencies: Values) => {
            en: "ALARM: {frequencies} left what earlier surveys predict, confirmed with this one",
            ko: "경보: {frequencies} 모드가 이전 조사의 예측을 벗어났으며 이 조사로 확정되었다",
        },
        Outside { frequency: Quantity, score: Quantity } => {
            en: "outside of what earlier surveys predict, no alarm yet ({frequency}: score {score})",
            ko: "이전 조사의 예측을 벗어났으나 아직 경보는 아니다({frequency}: 점수 {score})",
        },
        AsPredicted(score: Quantity) => {
            en: "as earlier surveys predict (score farthest out {score})",
            ko: "이전 조사의 예측과 같다(가장 먼 점수 {score})",
        },
        Training => { en: "not judged: too few surveys before it", ko: "판정하지 않음: 이전 조사가 너무 적다" },
        NewLevel => {
            en: "not judged: the level after a repair or alarm is still being learned",
            ko: "판정하지 않음: 보수 또는 경보 이후의 수준을 아직 익히는 중이다",
        },
        Temperature => {
            en: "not judged: too few earlier surveys near its temperature",
            ko: "판정하지 않음: 비슷한 기온의 이전 조사가 너무 적다",
        },
        NoTemperature => { en: "not judged: its temperature is not known", ko: "판정하지 않음: 기온을 알 수 없다" },
        NoMode => {
            en: "not judged: none of the modes that are followed was found",
            ko: "판정하지 않음: 추적 중인 모드가 확인되지 않았다",
        },
        NotFound(frequencies: Values) => {
            en: "NOT FOUND: {frequencies}, which earlier surveys have; they changed by more than modes are looked for, or the record lost them. Look at the structure and measure again",
            ko: "확인되지 않음: 이전 조사에 있던 {frequencies} 모드가 추적 범위를 넘게 변하였거나 기록에서 놓친 것이다. 구조물을 점검하고 다시 계측한다",
        },
        TooFew { given: usize, least: usize } => {
            en: "not judged: {given} days with modes so far, {least} are needed",
            ko: "판정하지 않음: 모드가 있는 날이 {given}일이며 {least}일이 필요하다",
        },
    }
}

fn hertz(frequencies_hz: &[f64]) -> Values {
    let each = frequencies_hz.iter();
    Values(
        each.map(|hz| Quantity::new(*hz, Unit::si("Hz"), Digits::Significant(4)))
            .collect(),
    )
}

fn verdict_words(verdict: &Verdict) -> Sentence {
    let score = |score: f64| Quantity::new(score, Unit::ratio(), Digits::Fixed(1));
    match verdict {
        Verdict::Alarm { frequencies_hz } => Followed::Alarm(hertz(frequencies_hz)),
        Verdict::Outside {
            frequency_hz,
            score: out,
        } => Followed::Outside {
            frequency: Quantity::new(*frequency_hz, Unit::si("Hz"), Digits::Significant(4)),
            score: score(*out),
        },
        Verdict::AsPredicted { score: farthest, .. } => Followed::AsPredicted(score(*farthest)),
        Verdict::NotJudged(NotJudged::Training) => Followed::Training,
        Verdict::NotJudged(NotJudged::NewLevel) => Followed::NewLevel,
        Verdict::NotJudged(NotJudged::Temperature) => Followed::Temperature,
        Verdict::NotJudged(NotJudged::NoTemperature) => Followed::NoTemperature,
        Verdict::NotFound { frequencies_hz } => Followed::NotFound(hertz(frequencies_hz)),
        // stated at the start of its line
        Verdict::Earthquake | Verdict::NoMode => Followed::NoMode,
        Verdict::TooFew { given, least } => Followed::TooFew {
            given: *given,
            least: *least,
        },
    }
    .into()
}

fn peak_of(of: &Earthquake) -> Sentence {
    match of.part().peak_m_s2 {
        Some(peak) => {
            let peak = Quantity::new(peak, Unit::si("m/s²"), Digits::Significant(3));
            match of.found.largest().is_at_least() {
                true => Followed::PeakAtLeast(peak),
                false => Followed::PeakOf(peak),
            }
        }
        None => Followed::NoPeak(Quantity::ratio(of.found.strongest().shaking.over_noise, 2)),
    }
    .into()
}

fn change_of(of: &Earthquake) -> Sentence {
    let parts = |of: &LastingChange| {
        let frequency = Quantity::new(of.before_hz, Unit::si("Hz"), Digits::Significant(4));
        (
            frequency,
            Quantity::new(of.ratio, Unit::percent(), Digits::Significant(2)),
        )
    };
    match (of.found.lasting().map(parts), of.found.shown().first().map(parts)) {
        (Some((frequency, by)), _) => Followed::Lasting { frequency, by },
        (None, Some((frequency, by))) => Followed::NothingLasts { frequency, by },
        (None, None) => Followed::CannotTell,
    }
    .into()
}

/// The verdict of a history on a record.
#[derive(Clone, Copy, Debug)]
pub struct JudgedRecord<'a> {
    /// Verdict on its modes.
    pub verdict: &'a Verdict,
    /// Number of open alarms on its day.
    pub open_alarms: usize,
    /// Change of its sensors, from the shapes.
    pub sensors: Option<&'a SensorChange>,
}

fn jumped(of: &SensorChange) -> Followed {
    let assurance = Quantity::ratio(of.assurance, 2);
    match &of.channel {
        None => Followed::ShapesJumped(assurance),
        Some(channel) => Followed::ShapesJumpedAt {
            assurance,
            channel: channel.clone(),
        },
    }
}

/// A stored record in one line, and a line for each doubtful sensor.
pub fn followed_text(
    survey: &str,
    file: &str,
    taken: &Taken,
    judged: &JudgedRecord<'_>,
    language: Language,
) -> String {
    let JudgedRecord {
        verdict, open_alarms, ..
    } = *judged;
    let (survey, file) = (survey.to_owned(), file.to_owned());
    let RecordTime {
        source,
        not_believed_s,
        ..
    } = &taken.time;
    let source = match source {
        TimeSource::Record => Followed::OfRecord,
        TimeSource::FileName => Followed::OfFileName,
        TimeSource::FileTime => Followed::OfFileTime,
    }
    .into();
    let open = match open_alarms {
        0 => Followed::NoOpenAlarm.into(),
        count => Followed::OpenAlarms(count).into(),
    };
    let head: Sentence = match (&taken.modes, taken.without_modes()) {
        _ if let Some(of) = &taken.earthquake => Followed::Shaken {
            survey,
            source,
            file,
            peak: peak_of(of),
            change: change_of(of),
            open,
        },
        (Ok(modes), _) if modes.modes.is_empty() => Followed::NoModes { survey, source, file },
        (Ok(modes), _) => {
            let frequencies_hz: Vec<f64> = modes.modes.iter().map(|mode| mode.frequency_hz).collect();
            Followed::Stored {
                survey,
                source,
                file,
                frequencies: hertz(&frequencies_hz),
                verdict: verdict_words(verdict),
                open,
            }
        }
        (Err(_), why) => Followed::WithoutModes {
            survey,
            source,
            file,
            why: why.unwrap_or_else(|| Both::from("")),
        },
    }
    .into();
    let mut lines = vec![head];
    lines.extend(not_believed_s.map(|at_s| Followed::WrongClock(super::moment::moment(at_s)).into()));
    lines.extend(
        taken
            .faults
            .iter()
            .map(|fault| Followed::Sensor(fault_words(fault)).into()),
    );
    lines.extend(judged.sensors.map(|of| jumped(of).into()));
    lines.extend(taken.shaking.as_ref().map(|of| {
        let shaking = &of.found.largest().shaking;
        let [from, to] = [shaking.arrival_s, shaking.end_s];
        let time = |at_s: f64| Quantity::new(at_s, Unit::si("s"), Digits::Significant(4));
        Followed::Traffic {
            from: time(from),
            to: time(to),
            peak: peak_of(of),
        }
        .into()
    }));
    if !taken.left_out.is_empty() {
        let channels = taken.left_out.clone();
        lines.push(Followed::LeftOut(channels).into());
    }
    lines.iter().map(|line| line.text(language) + "\n").collect()
}

/// The same as JSON, in one line.
pub fn followed_json(survey: &str, file: &str, taken: &Taken, judged: &JudgedRecord<'_>) -> Value {
    let modes = taken.modes.as_ref().ok();
    as_json!({
        "file": file,
        "survey": survey,
        "open_alarms": judged.open_alarms,
        "shapes_jumped": judged.sensors.map(|of| as_json!({ "mac": of.assurance, "channel": of.channel })),
        "date_from": taken.time.source,
        "modes": modes.map_or_else(Vec::new, |modes| modes.modes.iter().map(|mode| as_json!({
            "frequency_hz": mode.frequency_hz, "frequency_sd_hz": mode.frequency_sd_hz.filter(|sd| sd.is_finite()),
        })).collect()),
        "without_modes": taken.without_modes().map(|why| why.english),
        "sensors": taken.faults.iter().map(|fault| fault_words(fault).text(Language::English)).collect::<Vec<_>>(),
        "left_out": taken.left_out,
        "earthquake": taken.earthquake.as_ref().map(|of| {
            let part = of.part();
            as_json!({
                "peak_acceleration_m_s2": part.peak_m_s2,
                "change_ratio": part.changed,
                "sd": part.changed_sd,
                "peak_at_least": of.found.largest().is_at_least(),
                "events": of.found.events.len(),
                "lasts": of.found.lasting().is_some(),
                "over_noise": of.found.strongest().shaking.over_noise,
            })
        }),
        "strong_shakings": taken.shaking.as_ref().map_or(0, |of| of.found.events.len()),
        "verdict": match judged.verdict {
            Verdict::Alarm { .. } => "alarm",
            Verdict::Outside { .. } => "outside",
            Verdict::AsPredicted { .. } => "as_predicted",
            Verdict::NotJudged(NotJudged::Training) => "training",
            Verdict::NotJudged(NotJudged::NewLevel) => "new_level",
            Verdict::NotJudged(NotJudged::Temperature) => "temperature",
            Verdict::NotJudged(NotJudged::NoTemperature) => "no_temperature",
            Verdict::Earthquake => "earthquake",
            Verdict::NotFound { .. } => "not_found",
            Verdict::NoMode => "no_mode",
            Verdict::TooFew { .. } => "too_few",
        },
    })
}

/// A file that could not be read, and its new path.
pub fn quarantined_text(file: &str, place: &str, why: &Both, language: Language) -> String {
    let said: Sentence = Followed::Quarantined {
        file: file.to_owned(),
        place: place.to_owned(),
        why: why.clone(),
    }
    .into();
    said.text(language) + "\n"
}

/// The same as JSON, in one line.
pub fn quarantined_json(file: &str, place: &str, why: &Both) -> Value {
    as_json!({ "file": file, "quarantined": place, "why": why.english })
}

/// The state of a structure for Prometheus, as a text file of its node exporter.
pub fn metrics_text(
    structure: &str,
    answer: Option<&WatchAnswer>,
    alarms: &[OpenAlarm],
    (last_survey_s, quarantined, now_s): (Option<f64>, usize, f64),
) -> String {
    let label = structure
        .replace('\\', "\\\\")
        .replace('"', "\\\"")
        .replace('\n', "\\n");
    let of = format!("structure=\"{label}\"");
    let mut text = String::new();
    let mut family = |name: &str, help: &str, rows: Vec<(String, f64)>| {
        if rows.is_empty() {
            return;
        }
        text += &format!("# HELP {name} {help}\n# TYPE {name} gauge\n");
        for (labels, value) in rows {
            text += &format!("{name}{{{labels}}} {value}\n");
        }
    };
    let mut last: [Vec<(String, f64)>; 2] = [Vec::new(), Vec::new()];
    for (at, mode) in answer
        .iter()
        .flat_map(|answer| answer.watched.modes.iter().enumerate())
    {
        let label = format!("{of},mode=\"{}\"", at + 1);
        let shown = mode.track.modes.iter().enumerate().rev();
        let newest = shown.filter_map(|(survey, mode)| Some((survey, (*mode)?))).next();
        let found = newest.zip(answer).and_then(|((survey, mode), answer)| {
            let survey = answer.surveys.get(survey)?;
            Some((
                *survey.frequencies_hz.get(mode)?,
                survey.frequency_sds_hz.get(mode).copied().flatten(),
            ))
        });
        if let Some((frequency_hz, sd_hz)) = found {
            last[0].push((label.clone(), frequency_hz));
            last[1].extend(sd_hz.map(|sd_hz| (label, sd_hz)));
        }
    }
    let [frequencies, sds] = last;
    family(
        "dolmen_frequency_hertz",
        "Frequency of a mode, of the last day that shows it.",
        frequencies,
    );
    family("dolmen_frequency_sd_hertz", "Its standard deviation.", sds);
    let count = |word: &str| alarms.iter().filter(|alarm| alarm.sort.word() == word).count() as f64;
    let kinds = ["structure", "earthquake", "tilt", "crack", "sensor"]
        .map(|word| (format!("{of},kind=\"{word}\""), count(word)));
    family(
        "dolmen_open_alarms",
        "Alarms that nobody has answered.",
        kinds.to_vec(),
    );
    family(
        "dolmen_last_survey_timestamp_seconds",
        "When the last record was taken.",
        last_survey_s.map(|at_s| (of.clone(), at_s)).into_iter().collect(),
    );
    family(
        "dolmen_quarantined_files",
        "Files that could not be read.",
        vec![(of.clone(), quarantined as f64)],
    );
    family(
        "dolmen_follow_timestamp_seconds",
        "When the folder was last looked at.",
        vec![(of, now_s.floor())],
    );
    text
}
