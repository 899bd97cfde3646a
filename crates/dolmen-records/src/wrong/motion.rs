//! Errors of the file of a ground motion, in both languages.

use super::pieces::{at_line, no_channel, unit_meant};
use crate::motions::MotionError;
use crate::quoted::{listed, shown};
use crate::records::{RecordError, SeismicError};
use dolmen::signal::SignalError;
use dolmen_words::sentences;

sentences! {
    MotionError in "motions.error" {
        NoFile => {
            en: "no file is given: a motion needs at least one component",
            ko: "파일이 없다. 지반운동에는 성분이 하나 이상 필요하다",
        },
        Component { component, fault } => {
            en: "the {component} component: {fault}",
            ko: "{component} 성분: {fault}",
        },
        Channel { channel, fault } as { channel: shown(channel), fault } => {
            en: "column \"{channel}\": {fault}",
            ko: "\"{channel}\" 열: {fault}",
        },
        Workbook { why } => {
            en: "the workbook {why}",
            ko: "통합 문서: {why}",
        },
        NoUnit => {
            en: "the unit of the accelerations is not known: the file does not say it; give unit = g, gal or m/s2",
            ko: "가속도의 단위를 알 수 없다. 파일에 없으므로 unit을 g, gal 또는 m/s2로 입력한다",
        },
        NoResponse { channel, known } as { channel: shown(channel), known: shown(&known.join(", ")) } => {
            en: "no response is of the channel {channel} at the time of the record; there are {known}: give the RESP file of this channel and time with the record",
            ko: "기록 시각의 채널 {channel}에 맞는 계기응답이 없다. 있는 것: {known}. 이 채널과 시각의 RESP 파일을 함께 입력한다",
        },
        ResponseAndFactor { factor } => {
            en: "factor is {factor}, but a response is given too, which says what a count is worth: give one of them",
            ko: "factor가 {factor}인데 한 카운트의 값을 알려 주는 계기응답도 있다. 둘 중 하나만 입력한다",
        },
        NotAcceleration { given } as { given: shown(given) } => {
            en: "the unit \"{given}\" is not one of acceleration: give g, gal, m/s2, cm/s2, mm/s2 or mg, and a file of accelerations",
            ko: "단위 \"{given}\"은(는) 가속도의 단위가 아니다. g, gal, m/s2, cm/s2, mm/s2 또는 mg로 하고 가속도 파일을 쓴다",
        },
        UnitDisagrees { given, found } => {
            en: "unit is \"{given}\", but the file says \"{found}\": correct it, or leave it out",
            ko: "unit은 \"{given}\"인데 파일에는 \"{found}\"(으)로 되어 있다. 고치거나 삭제한다",
        },
        Peak { peak_g, least_g, most_g, unit, suggested } as { peak_g: format!("{peak_g:.3e}"), least_g, most_g, hint: unit_meant(unit, suggested) } => {
            en: "the peak is {peak_g} g, but must be {least_g} to {most_g} g: {hint}; if the motion is truly so, bring it into that range with --factor and back with --scale",
            ko: "최대값이 {peak_g} g인데 {least_g}~{most_g} g이어야 한다. {hint}. 실제로 그런 지반운동이면 --factor로 그 범위에 넣고 --scale로 되돌린다",
        },
        StepDisagrees { given, found } => {
            en: "sample_step_s (--sample-step) is {given} s, but the file says {found} s: correct it, or leave it out",
            ko: "sample_step_s(--sample-step)는 {given} s인데 파일에는 {found} s로 되어 있다. 고치거나 삭제한다",
        },
        CoarseStamps { line, step_s, step_before_s, resolution_s } as { line, step_s: format!("{step_s:.6}"), step_before_s: format!("{step_before_s:.6}"), resolution_s } => {
            en: "line {line}: the time stamp is {step_s} s after the one before, that one {step_before_s} s after its own; printed to {resolution_s} s, this may be rounding or a missing sample: if none is missing, give the step as sample_step_s (--sample-step), which then counts, or print more digits; else write the missing line, or cut the file there",
            ko: "{line}행의 시각은 앞 시각보다 {step_s} s 뒤이고, 앞 시각은 그 앞보다 {step_before_s} s 뒤이다. {resolution_s} s 단위로 출력되어 반올림인지 자료가 빠졌는지 알 수 없다. 빠진 자료가 없으면 시간 간격을 sample_step_s(--sample-step)로 입력하거나(그 값을 쓴다) 더 많은 자릿수로 출력하고, 빠졌으면 그 행을 채우거나 거기서 파일을 자른다",
        },
        Jitter { line, stamp_s, step_s, even_step_s } as { line, stamp_s, step_s: format!("{step_s:.6}"), even_step_s: format!("{even_step_s:.6}") } => {
            en: "line {line}: the time stamp {stamp_s} s is {step_s} s after the one before, and even steps are {even_step_s} s: no sample is missing there, but the stamps scatter. If the recorder samples evenly and only its stamps scatter, give its step as sample_step_s (--sample-step), which then counts; else resample the motion before",
            ko: "{line}행의 시각 {stamp_s} s는 앞 시각보다 {step_s} s 뒤이고 일정한 간격은 {even_step_s} s이다. 빠진 자료는 없으나 시각이 고르지 않다. 기록계는 일정한 간격으로 기록하는데 시각만 흔들리면 그 간격을 sample_step_s(--sample-step)로 입력한다(그 값을 쓴다). 그렇지 않으면 먼저 재표본화한다",
        },
        OfRate { fault } => {
            en: "{fault} (for a motion: sample_step_s or --sample-step, the time between samples in s, in place of sampling_rate)",
            ko: "{fault} (지반운동에서는 sampling_rate 대신 sample_step_s나 --sample-step에 시간 간격(s)을 입력한다)",
        },
        NoStep { names } as { names: listed(names) } => {
            en: "the time step is not known: no column is named time or t (the columns are {names}); give it as --sample-step, in a project as sample_step_s, or name the time column time",
            ko: "시간 간격을 알 수 없다. 이름이 time이나 t(시간)인 열이 없다(파일의 열: {names}). --sample-step(프로젝트 파일에서는 sample_step_s)으로 입력하거나 시간 열의 이름을 time으로 한다",
        },
        Step { given } => {
            en: "sample_step_s (--sample-step) is {given}, but must be a positive number of seconds",
            ko: "sample_step_s(--sample-step)가 {given}인데 양의 초이어야 한다",
        },
        TimeSteps { first, first_s, second, second_s } => {
            en: "the {first} component has a step of {first_s} s, the {second} of {second_s} s: resample one before",
            ko: "{first} 성분의 시간 간격은 {first_s} s인데 {second} 성분은 {second_s} s이다. 먼저 하나를 재표본화한다",
        },
        Lengths { first, first_samples, second, second_samples } => {
            en: "the {first} component has {first_samples} samples, the {second} {second_samples}: if they begin at the same time, cut all to the shortest with lengths = \"shortest\" in [motion.NAME] or --shortest",
            ko: "{first} 성분의 자료는 {first_samples}개인데 {second} 성분은 {second_samples}개이다. 같은 시각에 시작하면 [motion.NAME]의 lengths = \"shortest\"나 --shortest로 모두 가장 짧은 길이에 맞춘다",
        },
        Factor { given } => {
            en: "factor is {given}, but must be a finite number other than 0",
            ko: "factor가 {given}인데 0이 아닌 유한한 수이어야 한다",
        },
        NotFinite { channel, sample } as { channel: shown(channel), sample } => {
            en: "channel \"{channel}\": sample {sample} (from 0) is not a finite number: cut the file there, or leave the channel out",
            ko: "채널 \"{channel}\": {sample}번 자료(0부터)가 유한한 수가 아니다. 거기서 파일을 자르거나 그 채널을 뺀다",
        },
        MissingCode { line, at_s, value, count } as { place: at_line(line.unwrap_or(0)), at_s: (at_s * 1e6).round() / 1e6, value, count } => {
            en: "{place}the sample at {at_s} s is {value}, a code for a missing value (samples with it: {count}): it is no acceleration. Replace it, for example by the straight line between its neighbours, or cut the record before it",
            ko: "{place}{at_s} s의 자료가 {value}이며 이는 가속도가 아니라 결측을 나타내는 값이다(같은 값의 자료 {count}개). 앞뒤 자료 사이의 직선 등으로 바꾸거나 그 앞에서 기록을 자른다",
        },
        Spike { line, at_s, value, others } as { place: at_line(line.unwrap_or(0)), at_s: (at_s * 1e6).round() / 1e6, value, others } => {
            en: "{place}the sample at {at_s} s is {value}, alone beyond all others, which are at most {others}: a spike of the recorder, or a code for a missing value. Replace it, for example by the straight line between its neighbours, or cut the record before it",
            ko: "{place}{at_s} s의 자료 하나만 {value}이고 나머지는 모두 {others} 이하이다. 계측기의 튐 또는 결측을 나타내는 값이다. 앞뒤 자료 사이의 직선 등으로 바꾸거나 그 앞에서 기록을 자른다",
        },
        Vertical { component } => {
            en: "the record given as {component} is vertical, as its header or column says: give it as z=FILE, and a horizontal record as {component}",
            ko: "{component}(으)로 지정된 기록은 머리글이나 열 이름에 따르면 연직 성분이다. 이 기록은 z=파일로, {component}에는 수평 기록을 지정한다",
        },
        Borehole { component } => {
            en: "the record given as {component} is from a borehole (KiK-net Dir. 1 to 3): deep ground shakes less than the surface that carries the structure. Give the record of the surface, Dir. 4 to 6 (files .NS2, .EW2, .UD2)",
            ko: "{component}(으)로 지정된 기록은 시추공의 기록이다(KiK-net Dir. 1~3). 깊은 지반은 구조물이 놓인 지표면보다 약하게 흔들린다. 지표면의 기록(Dir. 4~6, 파일 .NS2, .EW2, .UD2)을 지정한다",
        },
        Origins { first, first_of, second, second_of } as { first, first_of: shown(first_of), second, second_of: shown(second_of) } => {
            en: "the {first} component is of \"{first_of}\", the {second} of \"{second_of}\": the components of a motion are of one station and one earthquake; give each of these alone",
            ko: "{first} 성분은 \"{first_of}\", {second} 성분은 \"{second_of}\"의 기록이다. 한 지반운동의 성분은 같은 관측소, 같은 지진의 것이어야 한다. 따로 지정한다",
        },
        ColumnsDiffer { column, found, other, unit } as { column: shown(column), found, other: shown(other), unit } => {
            en: "column \"{column}\" is in {found}, but \"{other}\" in {unit}: say which columns are accelerations, columns = {{ x = \"…\", y = \"…\" }} in [motion.NAME] or --columns x=…,y=…; one alone with --channel",
            ko: "\"{column}\" 열의 단위는 {found}인데 \"{other}\" 열의 단위는 {unit}이다. 가속도인 열을 지정한다. [motion.NAME]에는 columns = {{ x = \"…\", y = \"…\" }}, 명령에는 --columns x=…,y=…이다. 하나만 읽으려면 --channel을 쓴다",
        },
        StatedPeak { channel, stated, found, unit } as { channel: shown(channel), stated, unit, found: format!("{found:.6}") } => {
            en: "channel \"{channel}\": the header says that the peak is {stated} {unit}, but that of the samples is {found}: they were damaged or changed; download the file again, or say stated_peak = \"ignore\" in [motion.NAME] or --ignore-stated-peak if you know why",
            ko: "채널 \"{channel}\": 머리글의 최대값은 {stated} {unit}인데 자료의 최대값은 {found}이다. 자료가 손상되었거나 바뀌었다. 파일을 다시 받거나, 이유를 알면 [motion.NAME]에 stated_peak = \"ignore\"를 쓰거나 --ignore-stated-peak로 한다",
        },
        Channels { given, names } as { hint: no_channel(given.as_deref()), count: names.len(), names: listed(names) } => {
            en: "{hint}the file has {count} channels ({names}): say which is which by name or number, columns = {{ x = \"…\", y = \"…\", z = \"…\" }} in [motion.NAME] or --columns x=…,y=…,z=…; one alone with --channel",
            ko: "{hint}파일에 채널이 {count}개 있다({names}). 어느 것이 어느 방향인지 이름이나 번호로 쓴다. [motion.NAME]에는 columns = {{ x = \"…\", y = \"…\", z = \"…\" }}, 명령에는 --columns x=…,y=…,z=…이다. 하나만 읽으려면 --channel을 쓴다",
        },
        Starts { first, second, later_s } => {
            en: "the {second} component begins {later_s} s after the {first}: cut both to one time before",
            ko: "{second} 성분이 {first} 성분보다 {later_s} s 뒤에 시작한다. 먼저 같은 시각에 맞추어 자른다",
        },
        Orientation { why } => {
            en: "{why}: say which file or column is which component, x=… and y=… horizontal, z=… vertical",
            ko: "{why}. x=…와 y=…는 수평, z=…는 연직 성분이 되도록 파일이나 열을 지정한다",
        },
        SameRecord { first, second } => {
            en: "{first} and {second} have the same record: give the record of each direction; one record along a line between them is given once, as x, and rotated with --turn or `turn` in [motion.NAME]",
            ko: "{first} 성분과 {second} 성분의 기록이 같다. 방향마다 그 기록을 준다. 기록 하나를 두 방향 사이로 작용시키려면 x로 한 번만 주고 --turn 또는 [motion.NAME]의 turn으로 돌린다",
        },
    }
    handed on { Seismic(SeismicError), Record(RecordError), Signal(SignalError) }
}
