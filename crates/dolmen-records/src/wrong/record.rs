//! Errors of the file of a record, in both languages.

use super::pieces::{did_you_mean, last_line, scale_or_leave_out};
use crate::limits::LimitError;
use crate::quoted::{listed, shown};
use crate::records::{NotATable, RecordError, SeismicError};
use dolmen::signal::SignalError;
use dolmen_words::sentences;

sentences! {
    RecordError in "records.error" {
        Empty => {
            en: "the file is empty: it holds no line but blank ones and comments; is it the right file?",
            ko: "파일이 비어 있다. 빈 줄과 주석뿐이다. 맞는 파일인가?",
        },
        OnlyHeader { line } => {
            en: "the file holds a header (line {line}) but no samples: is it the right file?",
            ko: "파일에 머리글({line}행)뿐이고 자료가 없다. 맞는 파일인가?",
        },
        UnclearHeader { line } => {
            en: "line {line} holds both names and numbers: if it names the columns, say that the header is present; if it holds samples, correct it",
            ko: "{line}행에 이름과 수가 섞여 있다. 열 이름이면 header를 \"present\"로 하고, 자료이면 고친다",
        },
        Workbook { why } => {
            en: "the workbook {why}",
            ko: "통합 문서: {why}",
        },
        Utf16 => {
            en: "the file is UTF-16 text: save it as UTF-8 (\"CSV UTF-8\" in spreadsheets)",
            ko: "파일이 UTF-16 텍스트이다. UTF-8로 저장한다(스프레드시트의 \"CSV UTF-8\")",
        },
        UnknownUnit { given } as { given: shown(given) } => {
            en: "the unit \"{given}\" is not known: write m/s2, cm/s2 (gal), mm/s2, g, mg, %g, m/s, cm/s, mm/s, um/s, m, cm, mm, or \"unknown\" to keep the numbers as they are",
            ko: "알 수 없는 단위 \"{given}\"이다. m/s2, cm/s2 (gal), mm/s2, g, mg, %g, m/s, cm/s, mm/s, um/s, m, cm, mm 중 하나를 쓴다. 수를 그대로 두려면 \"unknown\"으로 한다",
        },
        NotANumber { line, column, text } as { line, column: shown(column), text: shown(text) } => {
            en: "line {line}, column \"{column}\": \"{text}\" is not a number; correct it, leave the column out, or cut the file",
            ko: "{line}행 \"{column}\" 열의 \"{text}\"은(는) 수가 아니다. 고치거나, 그 열을 빼거나, 파일을 자른다",
        },
        TimeText { line, column, text } as { line, column: shown(column), text: shown(text) } => {
            en: "line {line}, column \"{column}\": the time stamp \"{text}\" is not a number of seconds: give sampling_rate and name the columns to read, then the first and the last date are held against that rate",
            ko: "{line}행 \"{column}\" 열의 시각 \"{text}\"은(는) 초 단위의 수가 아니다. sampling_rate를 입력하고 읽을 열의 이름을 쓰면, 첫 날짜와 마지막 날짜를 그 주파수와 대조한다",
        },
        HeaderAgain { line } => {
            en: "line {line} is the header again: the recorder restarted there, and the time in between is not known; cut the file there, and make the part after it a record of its own",
            ko: "{line}행에 머리글이 다시 나온다. 기록계가 그곳에서 다시 시작하였으며 그 사이의 시간은 알 수 없다. 파일을 그곳에서 나누고 뒷부분을 별도의 기록으로 한다",
        },
        EmptyCell { line, column } as { line, column: shown(column) } => {
            en: "line {line}, column \"{column}\" is empty: a sample is missing; cut the file before or after it, or leave the column out",
            ko: "{line}행 \"{column}\" 열이 비어 있다. 값이 하나 빠졌다. 그 앞이나 뒤에서 파일을 자르거나 그 열을 뺀다",
        },
        NotFinite { line, column, text } as { line, column: shown(column), text: shown(text) } => {
            en: "line {line}, column \"{column}\" holds {text}: a sample is missing; cut the file before or after it, or leave the column out",
            ko: "{line}행 \"{column}\" 열이 {text}이다. 값이 하나 빠졌다. 그 앞이나 뒤에서 파일을 자르거나 그 열을 뺀다",
        },
        UnknownColumn { given, nearest, names } as { given: shown(given), hint: did_you_mean(nearest.as_deref()), names: listed(names) } => {
            en: "there is no column \"{given}\"{hint}; the file has {names}",
            ko: "\"{given}\" 열이 없다{hint}. 파일의 열: {names}",
        },
        ColumnNumber { given, columns } => {
            en: "there is no column {given}: the file has columns 1 to {columns}",
            ko: "{given}번 열이 없다. 파일의 열은 1~{columns}번이다",
        },
        PickedTwice { column, first, second } as { column: shown(column), first: shown(first), second: shown(second) } => {
            en: "column \"{column}\" is read twice, as \"{first}\" and as \"{second}\": give each channel its own column",
            ko: "\"{column}\" 열을 \"{first}\"와(과) \"{second}\"(으)로 두 번 읽는다. 채널마다 다른 열을 쓴다",
        },
        AmbiguousColumn { given, count } as { count, given: shown(given) } => {
            en: "{count} columns are named \"{given}\": ask for the one you mean by its number",
            ko: "이름이 \"{given}\"인 열이 {count}개이다. 읽을 열을 번호로 쓴다",
        },
        Ragged { line, found, expected, last } as { line, found, expected, ending: last_line(*last) } => {
            en: "line {line} holds {found} cells, but the lines before it {expected}: correct it, or cut the file there{ending}",
            ko: "{line}행의 칸은 {found}개인데 앞의 행은 {expected}개이다. 고치거나 거기서 파일을 자른다{ending}",
        },
        DecimalCommas { line, found, expected } => {
            en: "line {line} holds {found} cells below {expected} names: its numbers have decimal commas, and commas separate the cells; save the file with decimal points, or with semicolons between the cells",
            ko: "{line}행의 칸은 {found}개인데 열 이름은 {expected}개이다. 소수점을 쉼표로 썼고 칸도 쉼표로 나누었다. 소수점을 점(.)으로 하거나 칸을 쌍반점(;)으로 나누어 저장한다",
        },
        OnlyTime { column } as { column: shown(column) } => {
            en: "the file holds only the time column \"{column}\": there is nothing to read",
            ko: "파일에 시간 열 \"{column}\"뿐이라 읽을 것이 없다",
        },
        NoRate { names } as { names: listed(names) } => {
            en: "the sampling rate is not known: no column is named time or t (the columns are {names}); give sampling_rate (dates in a column are then held against it), or name a time column in seconds",
            ko: "샘플링 주파수를 알 수 없다. 이름이 time이나 t인 열이 없다(파일의 열: {names}). sampling_rate를 입력하거나(날짜 열이 있으면 이와 대조한다) 초 단위 시간 열의 이름을 쓴다",
        },
        NoRateNpy => {
            en: "the sampling rate is not known: an NPY file cannot hold it; give sampling_rate",
            ko: "샘플링 주파수를 알 수 없다. NPY 파일에는 기록되지 않으므로 sampling_rate를 입력한다",
        },
        LooksLikeTime { column, step } as { column: shown(column), step } => {
            en: "column \"{column}\" rises by {step} from each line to the next, as time stamps or a line count do, not as a sensor: name it as the time column, or name the columns to read",
            ko: "\"{column}\" 열의 값이 행마다 {step}씩 커진다. 센서 값이 아니라 시각이나 행 번호로 보인다. 시간 열로 지정하거나 읽을 열의 이름을 쓴다",
        },
        DatesDisagree { given, column, first, last, samples, dates_hz } as { given, column: shown(column), first: shown(first), last: shown(last), samples, dates_hz: format!("{dates_hz:.3}") } => {
            en: "sampling_rate is {given}, but column \"{column}\" goes from {first} to {last} in {samples} samples, which is {dates_hz} Hz: correct the rate",
            ko: "sampling_rate는 {given}인데, \"{column}\" 열은 {first}에서 {last}까지 {samples}개 자료이므로 {dates_hz} Hz이다. 주파수를 고친다",
        },
        DatesGap { column, line, before, after, step_s } as { column: shown(column), line, before: shown(before), after: shown(after), step_s: format!("{step_s:.3}") } => {
            en: "samples are missing: column \"{column}\" goes from {before} (line {line}) to {after}, {step_s} s later. The sampling rate may be right; do not change it for this. Cut the file there, or write the times in seconds into a column \"time (s)\" (in a spreadsheet: the date less the first, times 86400): short gaps between those are filled",
            ko: "자료가 빠져 있다. \"{column}\" 열이 {before}({line}행)에서 {step_s}초 뒤인 {after}(으)로 건너뛴다. 샘플링 주파수는 맞을 수 있으므로 이 때문에 고치지 않는다. 그 행에서 파일을 자르거나, 시각을 초로 바꾼 \"time (s)\" 열을 둔다(엑셀에서는 첫 시각을 뺀 값에 86400을 곱한다). 그러면 짧은 공백은 채운다",
        },
        TimeUnit { column } as { column: shown(column) } => {
            en: "column \"{column}\" looks like time stamps in a unit that cannot be told: end its name with the unit, (s), (ms), (us), (min) or (h), or give sampling_rate, which then tells the unit",
            ko: "\"{column}\" 열은 시각으로 보이나 단위를 알 수 없다. 열 이름 끝에 단위 (초), (ms), (us), (분), (h)를 쓰거나 sampling_rate를 입력한다. 그러면 단위를 그 주파수로 정한다",
        },
        SlowStamps { column, step, milliseconds_hz } as { column: shown(column), step, milliseconds_hz: format!("{milliseconds_hz:.4}") } => {
            en: "the time stamps of column \"{column}\" lie {step} apart: as seconds that is no rate of a vibration; if they are milliseconds, give sampling_rate = \"{milliseconds_hz} Hz\" or name the column \"time [ms]\"; if they number the samples, leave time_column out and give sampling_rate",
            ko: "\"{column}\" 열의 시각 간격이 {step}이다. 초 단위라면 진동 기록의 간격이 아니다. 밀리초이면 sampling_rate = \"{milliseconds_hz} Hz\"로 하거나 열 이름을 \"time [ms]\"로 한다. 표본의 번호이면 time_column을 빼고 sampling_rate를 입력한다",
        },
        Jitter { line, stamp_s, step_s, even_step_s } as { line, stamp_s, step_s: format!("{step_s:.6}"), even_step_s: format!("{even_step_s:.6}") } => {
            en: "line {line}: the time stamp {stamp_s} s is {step_s} s after the one before, and even steps are {even_step_s} s: no sample is missing there, but the stamps scatter. If the recorder samples evenly and only its stamps scatter, delete the time column and give sampling_rate; else resample the record before",
            ko: "{line}행의 시각 {stamp_s} s는 앞 시각보다 {step_s} s 뒤이고 일정한 간격은 {even_step_s} s이다. 빠진 자료는 없으나 시각이 고르지 않다. 기록계는 일정한 간격으로 기록하는데 시각만 흔들리면 시각 열을 삭제하고 sampling_rate를 준다. 그렇지 않으면 먼저 재표본화한다",
        },
        Uneven { line, stamp_s, step_s, expected_step_s, expected_s } as { line, stamp_s, step_s: format!("{step_s:.6}"), expected_step_s: format!("{expected_step_s:.6}"), expected_s: format!("{expected_s:.6}") } => {
            en: "line {line}: the time stamp {stamp_s} s is {step_s} s after the one before, but even steps of {expected_step_s} s would put it at {expected_s} s: samples are missing or the clock jumped; cut the file there, or resample it before",
            ko: "{line}행의 시각 {stamp_s} s는 앞 시각보다 {step_s} s 뒤인데, 일정한 간격 {expected_step_s} s이면 {expected_s} s이어야 한다. 자료가 빠졌거나 시계가 튀었다. 거기서 파일을 자르거나 먼저 재표본화한다",
        },
        StampsStand { line, stamp, before } => {
            en: "line {line}: the time stamp {stamp} is not after the one before, {before}: print more digits, or give sampling_rate and say which columns to read",
            ko: "{line}행의 시각 {stamp}이(가) 앞의 시각 {before}보다 뒤가 아니다. 시각을 더 많은 자릿수로 출력하거나, sampling_rate를 입력하고 읽을 열을 쓴다",
        },
        CoarseStamps { line, step_s, step_before_s, resolution_s } as { line, step_s: format!("{step_s:.6}"), step_before_s: format!("{step_before_s:.6}"), resolution_s } => {
            en: "line {line}: the time stamp is {step_s} s after the one before, that one {step_before_s} s after its own; printed to {resolution_s} s, this may be rounding or a missing sample: give sampling_rate if none is missing, or print more digits",
            ko: "{line}행의 시각은 앞 시각보다 {step_s} s 뒤이고, 앞 시각은 그 앞보다 {step_before_s} s 뒤이다. {resolution_s} s 단위로 출력되어 반올림인지 자료가 빠졌는지 알 수 없다. 빠진 자료가 없으면 sampling_rate를 입력하고, 아니면 더 많은 자릿수로 출력한다",
        },
        RateDisagrees { given, stamps_hz } as { given, stamps_hz: format!("{stamps_hz:.6}") } => {
            en: "sampling_rate is {given}, but the time stamps say {stamps_hz}: correct it, or leave it out to take that of the stamps; if the stamps count another unit than the head of their column says, correct the head",
            ko: "sampling_rate는 {given}인데 시각으로는 {stamps_hz}이다. 고치거나, 삭제하면 시각의 주파수를 쓴다. 시각의 단위가 열 이름과 다르면 열 이름을 고친다",
        },
        NotNpy => {
            en: "this is no NPY file: it does not begin with \\x93NUMPY",
            ko: "NPY 파일이 아니다. \\x93NUMPY로 시작하지 않는다",
        },
        NpyVersion { major } => {
            en: "the NPY file is of version {major}, but versions 1 to 3 can be read: save it again with numpy.save",
            ko: "NPY 파일의 버전이 {major}인데 1~3만 읽는다. numpy.save로 다시 저장한다",
        },
        NpyHeaderTruncated { bytes } => {
            en: "the NPY file ends within its header, after {bytes} bytes: copy it again",
            ko: "NPY 파일이 머리글 안에서 {bytes}바이트로 끝난다. 다시 복사한다",
        },
        NpyHeader { text } as { text: shown(text) } => {
            en: "the header of the NPY file cannot be understood: \"{text}\"; save it again with numpy.save",
            ko: "NPY 파일의 머리글을 읽을 수 없다: \"{text}\". numpy.save로 다시 저장한다",
        },
        NpyType { given } as { given: shown(given) } => {
            en: "the NPY file holds values of type \"{given}\", but f4, f8, i2, i4 and i8 can be read: save array.astype(\"f8\")",
            ko: "NPY 파일의 자료형이 \"{given}\"인데 f4, f8, i2, i4, i8만 읽는다. array.astype(\"f8\")로 저장한다",
        },
        NpyShape { shape } as { shape: listed(&shape.iter().map(usize::to_string).collect::<Vec<_>>()) } => {
            en: "the array of the NPY file has shape [{shape}], but must have 1 axis (samples) or 2 (samples and channels): save one setup a file",
            ko: "NPY 파일의 배열 모양이 [{shape}]인데, 축이 1개(시각) 또는 2개(시각과 채널)이어야 한다. 측정 배치마다 파일 하나로 저장한다",
        },
        NpyTruncated { shape, held } as { shape: format!("{shape:?}"), held } => {
            en: "the NPY file ends too early: its shape is {shape}, but it holds {held} values; copy it again",
            ko: "NPY 파일이 일찍 끝난다. 모양은 {shape}인데 값이 {held}개이다. 다시 복사한다",
        },
        NpyTrailing { shape, extra } as { extra, shape: format!("{shape:?}") } => {
            en: "the NPY file goes on for {extra} bytes after the last value of its shape {shape}: it is damaged or holds several arrays; save one array a file",
            ko: "NPY 파일에 모양 {shape}의 마지막 값 뒤로 {extra}바이트가 더 있다. 손상되었거나 배열이 여럿이다. 배열마다 파일 하나로 저장한다",
        },
        NpyNamed { given, columns } as { given: shown(given), columns } => {
            en: "column \"{given}\" is asked for by name, but an NPY file has no names: ask for it by its number, 1 to {columns}",
            ko: "\"{given}\" 열을 이름으로 지정했는데 NPY 파일에는 이름이 없다. 1~{columns}의 번호로 쓴다",
        },
        CutShort { format, bytes, wanted } => {
            en: "the {format} file has {bytes} bytes, but {wanted} are needed: it was cut short; copy it again",
            ko: "{format} 파일이 {bytes}바이트인데 {wanted}바이트가 필요하다. 잘린 파일이므로 다시 복사한다",
        },
        Damaged { format, at, what } => {
            en: "the {format} file is damaged at byte {at}: {what}; copy it again",
            ko: "{format} 파일이 {at}바이트 위치에서 손상되었다: {what}. 다시 복사한다",
        },
        NotReadHere { format, what, instead } => {
            en: "the {format} file holds {what}, which is not read: {instead}",
            ko: "{format} 파일에 읽지 않는 내용이 있다: {what}. {instead}",
        },
        NotOfFormat { format, begins } => {
            en: "the file is not of the format {format}: it begins like {begins}; correct format, or leave it out",
            ko: "{format} 형식의 파일이 아니다. 파일의 시작: {begins}. format을 고치거나 삭제한다",
        },
        LineIsNot { format, line, text, wanted } as { line, text: shown(text), wanted, format } => {
            en: "line {line}: \"{text}\" is not {wanted}: the {format} file was cut or edited; copy it again",
            ko: "{line}행의 \"{text}\"이(가) 형식에 맞지 않는다. 이 자리에 있어야 하는 것: {wanted}. {format} 파일이 잘렸거나 편집되었다. 다시 복사한다",
        },
        EndsBefore { format, line, wanted } => {
            en: "the {format} file ends before line {line}, which must be {wanted}: it was cut short; copy it again",
            ko: "{format} 파일이 {line}행 앞에서 끝난다. 그 행에 있어야 하는 것: {wanted}. 잘린 파일이므로 다시 복사한다",
        },
        HeaderLacks { format, what } => {
            en: "the header of the {format} file does not give {what}: it was cut or edited; copy it again",
            ko: "{format} 파일의 머리글에 없는 것: {what}. 잘렸거나 편집되었다. 다시 복사한다",
        },
        SampleCount { format, stated, found } => {
            en: "the header of the {format} file says {stated} samples, but {found} follow: it was cut or edited; copy it again",
            ko: "{format} 파일의 머리글에는 자료가 {stated}개라는데 {found}개가 있다. 잘렸거나 편집되었다. 다시 복사한다",
        },
        Gap { channel, expected_s, found_s } as { channel: shown(channel), found_s, expected_s } => {
            en: "channel {channel}: a block begins {found_s} s after the first, but the samples before it end at {expected_s} s: there is a gap or an overlap; cut the file there",
            ko: "채널 {channel}: 블록 하나가 처음에서 {found_s} s 뒤에 시작하는데 그 앞의 자료는 {expected_s} s에서 끝난다. 자료가 비었거나 겹친다. 거기서 파일을 자른다",
        },
        Variable { name, what } as { name: shown(name), what } => {
            en: "the variable {name} of the MAT file {what}: correct it, or leave it out",
            ko: "MAT 파일의 변수 {name}: {what}. 고치거나 뺀다",
        },
        NoFullScale => {
            en: "the numbers of a WAV file are parts of full scale: give scale = what full scale is in the unit (scale = 1 without a unit keeps them as parts)",
            ko: "WAV 파일의 수는 최대 눈금에 대한 비율이다. scale = 최대 눈금의 값(단위 기준)을 입력한다. 단위 없이 scale = 1이면 비율 그대로 둔다",
        },
        NoScale { format, channel, found, given } as { channel: shown(channel), given, format, found: shown(found) } => {
            en: "channel \"{channel}\": unit is \"{given}\", but the {format} file says that its numbers are in \"{found}\": give scale = what one of them is worth in {given} (1 if they are in {given} already), or leave unit out",
            ko: "채널 \"{channel}\": unit은 \"{given}\"인데 {format} 파일의 수는 \"{found}\" 단위이다. 그 하나가 몇 {given}인지 scale로 입력하거나(이미 {given}이면 1) unit을 삭제한다",
        },
        UnitDisagrees { channel, given, found } as { channel: shown(channel), given, found } => {
            en: "channel \"{channel}\": unit is \"{given}\", but the file says \"{found}\": correct it, or leave it out",
            ko: "채널 \"{channel}\": unit은 \"{given}\"인데 파일에는 \"{found}\"(으)로 되어 있다. 고치거나 삭제한다",
        },
        ColumnUnitDisagrees { column, found, given, scale } as { column: shown(column), found, given, remedy: scale_or_leave_out(*scale) } => {
            en: "column \"{column}\" says {found}, but unit is \"{given}\": correct unit; or, if only this column is in {found}, {remedy}; or, if its name is wrong, give its channel scale = 1",
            ko: "\"{column}\" 열의 이름에는 단위가 {found}인데 unit은 \"{given}\"이다. unit을 고친다. 이 열만 {found}이면 {remedy}. 열 이름이 틀렸으면 그 채널에 scale = 1을 입력한다",
        },
        ColumnUnitsDiffer { column, found, other, unit, scale } as { column: shown(column), found, other: shown(other), unit, remedy: scale_or_leave_out(*scale) } => {
            en: "column \"{other}\" says {unit}, but column \"{column}\" says {found}: one record has one unit; take unit = \"{unit}\" and, for \"{column}\", {remedy}; or, if the name is wrong, give its channel scale = 1",
            ko: "\"{other}\" 열의 이름에는 단위가 {unit}인데 \"{column}\" 열에는 {found}이다. 한 기록의 단위는 하나이다. unit = \"{unit}\"(으)로 하고 \"{column}\" 열은 {remedy}. 열 이름이 틀렸으면 그 채널에 scale = 1을 입력한다",
        },
        FileRateDisagrees { given, found } => {
            en: "sampling_rate is {given}, but the file says {found}: correct it, or leave it out",
            ko: "sampling_rate는 {given}인데 파일에는 {found}(으)로 되어 있다. 고치거나 삭제한다",
        },
        NoRateHere { format } => {
            en: "the sampling rate is not known: the {format} file does not say it; give sampling_rate",
            ko: "샘플링 주파수를 알 수 없다. {format} 파일에 없으므로 sampling_rate를 입력한다",
        },
        TwoStarts { file } as { file: shown(file) } => {
            en: "begins is given for {file}, but the file says itself when it begins: leave begins out, or correct the clock in the file",
            ko: "{file}의 begins를 입력했는데 파일에 시작 시각이 있다. begins를 삭제하거나 파일의 시각을 고친다",
        },
    }
    handed on { NotATable(NotATable), Limit(LimitError), Seismic(Box<SeismicError>), Signal(SignalError) }
}
