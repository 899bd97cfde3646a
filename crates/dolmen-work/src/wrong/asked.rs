//! Errors of a requested motion, study or table, in both languages.

use crate::known::known_beside;
use crate::motion::MotionRequestError;
use crate::portfolio::{PortfolioError, columns_said};
use crate::score::ScoreDesignsError;
use crate::study::{JournalError, StudyError};
use dolmen_words::advice::Advice as _;
use dolmen_words::sentences;

sentences! {
    MotionRequestError in "motion.request.error" {
        NoSuchMotion { name, known } as { name, known: known_beside(name, known) } => {
            en: "there is no motion \"{name}\": known are {known}; other motions come from files with --motion-file, or stand in the project file as [motion.\"{name}\"]",
            ko: "지반운동 \"{name}\"이(가) 없다. 있는 것: {known}. 다른 지반운동은 --motion-file로 파일을 주거나 프로젝트 파일에 [motion.\"{name}\"] 표를 쓴다",
        },
        NoBuiltInMotion { name, known } as { name, known: known_beside(name, known) } => {
            en: "there is no built-in motion \"{name}\": known are {known}",
            ko: "내장된 지반운동 \"{name}\"이(가) 없다. 있는 것: {known}",
        },
        NoMotion { known } => {
            en: "no motion is given: name files (`dolmen simulate`: with --motion-file), or take --motion {known}",
            ko: "지반운동이 없다. 파일을 주거나(`dolmen simulate`에서는 --motion-file) --motion {known}을(를) 쓴다",
        },
        OfFilesNotCarried { flag, name } => {
            en: "--{flag} says how the file of a motion is read, and \"{name}\" is no file: Dolmen carries it along x in m/s2, every 0.02 s. Leave --{flag} out, or give your file with --motion-file",
            ko: "--{flag}은(는) 지반운동 파일을 읽는 방법인데 \"{name}\"은(는) 파일이 아니라 Dolmen에 내장된 x 방향 지반운동(m/s2, 0.02 s 간격)이다. --{flag}을(를) 빼거나 --motion-file로 파일을 준다",
        },
        OfFilesNotSurvey { flag, name } => {
            en: "--{flag} says how the file of a motion is read, and \"{name}\" is the record of a survey: leave --{flag} out; the project file says how it is read",
            ko: "--{flag}은(는) 지반운동 파일을 읽는 방법인데 \"{name}\"은(는) 계측 조사의 기록이며 프로젝트 파일에 적힌 대로 읽는다. --{flag}을(를) 뺀다",
        },
        SurveyWithoutProject { name } => {
            en: "the record of survey {name} is a motion of its project: use `dolmen simulate PROJECT --motion survey:{name}`, or give the file with --motion-file",
            ko: "{name} 조사의 기록은 그 프로젝트의 지반운동이다. `dolmen simulate PROJECT --motion survey:{name}`을(를) 쓰거나 --motion-file로 파일을 준다",
        },
        NoMeasuredGround { survey } => {
            en: "survey {survey} has no record of a measured ground: give it `records`, and name the channel of the ground, as in records.modal.inputs = [\"G\"]",
            ko: "{survey} 조사에는 지반을 계측한 기록이 없다. `records`를 적고 지반 채널을 records.modal.inputs = [\"G\"]처럼 적는다",
        },
        NoGroundAcceleration { survey, channel } => {
            en: "channel {channel} of survey {survey} is an input, but no acceleration along x, y or z, so that it cannot move a model: give the unit of its file (m/s2, gal, g) and its direction, as in direction = \"x\"",
            ko: "{survey} 조사의 채널 {channel}은(는) 입력이지만 x, y 또는 z 방향 가속도가 아니므로 모델을 움직일 수 없다. 파일의 단위(m/s2, gal, g)와 direction = \"x\"처럼 방향을 적는다",
        },
        OfFilesNotMade { flag } => {
            en: "--{flag} says how the file of a motion is read, and --make makes one without a file: leave --{flag} out, or give a file instead of --make",
            ko: "--{flag}은(는) 지반운동 파일을 읽는 방법인데 --make는 파일 없이 지반운동을 만든다. --{flag}을(를) 빼거나 --make 대신 파일을 준다",
        },
        Acts { peak_g, most_g } as { peak_g: format!("{peak_g:.3}"), most_g } => {
            en: "the motion that would act has a peak of {peak_g} g, but must have more than 0 and at most {most_g} g, twice what was ever recorded: correct --scale, --peak, the unit or the factor",
            ko: "작용할 지반운동의 최대값이 {peak_g} g인데 0보다 크고 {most_g} g(지금까지 기록된 최대의 두 배) 이하이어야 한다. --scale, --peak, 단위 또는 factor를 고친다",
        },
        ScaleTyped { given } => {
            en: "--scale is {given}, but must be above 0: a record is turned about by --turn 180, or in the project file by a negative scale of its [motion]",
            ko: "--scale이 {given}인데 0보다 커야 한다. 방향을 뒤집으려면 --turn 180을 쓰거나 프로젝트 파일의 [motion]에 음수 scale을 쓴다",
        },
        TurnTyped { given_deg } => {
            en: "--turn is {given_deg}°, but must be -360° to 360°: from x towards y",
            ko: "--turn이 {given_deg}°인데 -360°~360°이어야 한다. x에서 y 쪽으로 돌린다",
        },
        TurnOfChannels { channels } => {
            en: "--turn rotates x towards y, but the directions of the {channels} channels are not given: name them with --columns x=…,y=…, or take one with --channel",
            ko: "--turn은 x에서 y 쪽으로 돌리는데 채널 {channels}개의 방향이 주어지지 않았다. --columns x=…,y=…로 지정하거나 --channel로 하나를 고른다",
        },
        PeakTyped { given } => {
            en: "--peak is {given}, but must be above 0, and of a motion that acts at most 10 g: 0.3g",
            ko: "--peak가 {given}인데 0보다 커야 하고, 구조물에 작용하려면 10 g 이하이어야 한다. 예: 0.3g",
        },
        PeriodTyped { given_s, least_s, most_s } => {
            en: "--period is {given_s} s, but must be {least_s} s to {most_s} s, 8 to 10 million time steps: correct it, or --sample-step",
            ko: "--period가 {given_s} s인데 {least_s} s~{most_s} s(시간 간격의 8배~1000만 배)이어야 한다. 값을 고치거나 --sample-step을 바꾼다",
        },
        ComponentTwice { component } as { component: component.to_string() } => {
            en: "--motion-file: the {component} component is given twice; name each as in {component}=FILE",
            ko: "--motion-file: {component} 성분이 두 번 있다. {component}=파일과 같이 각각 지정한다",
        },
        ColumnWithoutFile { component, column } as { component: component.to_string(), column } => {
            en: "--columns: {component}={column}, but no file holds the {component} component; name it as {component}=FILE, or give one file that holds all",
            ko: "--columns: {component}={column}인데 {component} 성분의 파일이 없다. {component}=파일로 지정하거나, 모든 성분이 든 파일 하나를 지정한다",
        },
        Range { least_s, most_s, allowed_least_s, allowed_most_s } => {
            en: "the periods are {least_s} to {most_s} s, but must lie within {allowed_least_s} and {allowed_most_s} s, the longer at least 1.2 times the shorter",
            ko: "주기 범위가 {least_s}~{most_s} s인데 {allowed_least_s}~{allowed_most_s} s 안에서 긴 쪽이 짧은 쪽의 1.2배 이상이어야 한다",
        },
        NoRecords { files } => {
            en: "none of {files} files holds a horizontal record: give another folder with --from",
            ko: "파일 {files}개에 수평 방향 기록이 없다. --from으로 다른 폴더를 준다",
        },
        NoneReadable { files, file, why } => {
            en: "none of {files} files can be used; {file}: {why}",
            ko: "파일 {files}개를 모두 쓸 수 없다. {file}: {why}",
        },
        NoAcceleration { given } => {
            en: "\"{given}\" is no acceleration: write it as \"0.3 g\" or \"2.94 m/s2\"",
            ko: "\"{given}\"은(는) 가속도가 아니다. \"0.3 g\" 또는 \"2.94 m/s2\"와 같이 쓴다",
        },
        AccelerationWithoutUnit { given, value } => {
            en: "\"{given}\" has no unit: write \"{value} g\" or \"{value} m/s2\"",
            ko: "\"{given}\"에 단위가 없다. \"{value} g\" 또는 \"{value} m/s2\"로 쓴다",
        },
        NoEurocodeGround { given } => {
            en: "--site is \"{given}\", but a ground of Eurocode 8 is A, B, C, D or E",
            ko: "--site가 \"{given}\"인데 유로코드 8의 지반은 A, B, C, D 또는 E이다",
        },
        NoKoreanSite { given } => {
            en: "--site is \"{given}\", but a site of KDS 17 10 00 is S1 to S5; for Eurocode 8 give --ground-acceleration too",
            ko: "--site가 \"{given}\"인데 KDS 17 10 00의 지반은 S1~S5이다. 유로코드 8이면 --ground-acceleration도 준다",
        },
        NothingToMatch => {
            en: "no motion is given to match",
            ko: "부합시킬 지반운동이 없다",
        },
        SeveralToMatch => {
            en: "the file has several channels: name the one to match with --channel, or turn them to x and y with --x-azimuth",
            ko: "파일에 채널이 여럿이다. 부합시킬 채널을 --channel로 지정하거나 --x-azimuth로 x와 y로 돌린다",
        },
    }
}

sentences! {
    StudyError in "study.error" {
        NoSuchStudy { name, known } as { name, known: known_beside(name, known) } => {
            en: "there is no study \"{name}\": the file has {known}",
            ko: "study \"{name}\"이(가) 없다. 파일에 있는 것: {known}",
        },
        NoStudyIn { name, file } => {
            en: "there is no study \"{name}\" in {file}",
            ko: "{file}에 study \"{name}\"이(가) 없다",
        },
        NoStudy => {
            en: "the file has no study: write one as [study.NAME]; docs/study.md has its keys",
            ko: "파일에 study가 없다. [study.이름]을 쓴다. 키는 docs/study.md에 있다",
        },
        StudyOfWhatFalls { load_factor } as { load_factor: format!("{load_factor:.3}") } => {
            en: "it does not stand under its own weight (load factor {load_factor}): no shaking is needed to fell it, and a capacity against shaking would say nothing. `dolmen check` says what it lacks",
            ko: "자중으로 서 있지 못한다(하중배율 {load_factor}). 흔들지 않아도 쓰러지므로 지진에 대한 내력은 뜻이 없다. 무엇이 부족한지는 `dolmen check`로 본다",
        },
        SurveyStudied => {
            en: "a survey holds no structure that could be studied: kind is stack, frame, chain or building",
            ko: "survey에는 해석할 구조물이 없다. kind는 \"stack\", \"frame\", \"chain\" 또는 \"building\"이어야 한다",
        },
        StudyWithoutMotion => {
            en: "the study names no motion: give motions = [\"el-centro-1940-ns\"] or artificial = {{ count = 22 }}",
            ko: "study에 지반운동이 없다. motions = [\"el-centro-1940-ns\"] 또는 artificial = {{ count = 22 }}를 쓴다",
        },
        StudyWithoutScan => {
            en: "the study says not how the shaking grows: give scale or peak",
            ko: "study에서 지반운동을 어떻게 키우는지 알 수 없다. scale이나 peak를 쓴다",
        },
        StudyTooLarge { scans, most } => {
            en: "the study has {scans} scans, but at most {most} are run: vary less, draw fewer samples, or take fewer motions and directions",
            ko: "study의 조합이 {scans}개인데 최대 {most}개까지 해석한다. 바꾸는 값, 표본, 지반운동 또는 방향을 줄인다",
        },
        MapsTooLarge { points, most } => {
            en: "the maps have {points} points, but at most {most} are computed: take fewer frequencies, accelerations, samples or variants",
            ko: "조화 지반운동의 계산점이 {points}개인데 최대 {most}개까지 계산한다. 진동수, 가속도, 표본 또는 대안을 줄인다",
        },
        AfterOfBuilding => {
            en: "after is a motion that leaves a structure in another state, and a building is linear here: once at rest it is as it was before; leave after out",
            ko: "after는 구조물의 상태를 바꾸는 지반운동인데 building은 여기서 선형이므로 멈춘 뒤에는 이전과 같다. after를 뺀다",
        },
        AfterWithoutScan => {
            en: "after is a motion before runs of growing shaking, and the study has none: give scale or peak, or leave after out",
            ko: "after는 지반운동을 키워 가는 해석에 앞서 작용하는데 이 study에는 그런 해석이 없다. scale이나 peak를 주거나 after를 뺀다",
        },
        StudySamplesNothing { samples } => {
            en: "samples is {samples}, but no input has a cov: all samples would be the same. Write joint.friction = {{ value = 0.6, cov = 0.1 }}, or leave samples out",
            ko: "samples가 {samples}인데 cov가 있는 입력이 없어 표본이 모두 같아진다. joint.friction = {{ value = 0.6, cov = 0.1 }}과 같이 쓰거나 samples를 뺀다",
        },
        HarmonicOfOther => {
            en: "harmonic and release are for frames and chains",
            ko: "harmonic과 release는 frame과 chain에 쓴다",
        },
        EveryRunRefused { why } => {
            en: "the inputs of every run were refused: {why}",
            ko: "모든 해석의 입력을 쓸 수 없다: {why}",
        },
        OtherJournal { shown, difference } => {
            en: "{shown} belongs to another state of this study: {difference}. Name another folder with -o, or give --restart to throw its runs away",
            ko: "{shown}은(는) 이 study의 다른 상태의 기록이다: {difference}. -o로 다른 폴더를 지정하거나 --restart로 그 해석을 버린다",
        },
        RunTwice { shown, scan, scale } => {
            en: "{shown}: the run of scan {scan} at scale {scale} is there twice with different results: they come from programs that do not compute alike; start anew with --restart",
            ko: "{shown}: 조합 {scan}, 배율 {scale}의 해석이 서로 다른 결과로 두 번 있다. 계산이 다른 프로그램의 결과이다. --restart로 새로 시작한다",
        },
        StudyWithoutPagoda { name } => {
            en: "study \"{name}\" has no pagoda given by six factors: write pagoda = {{ storeys = 5, … }}",
            ko: "study \"{name}\"에 여섯 인자 점수에 쓸 석탑 정보가 없다. pagoda = {{ storeys = 5, … }}를 추가한다",
        },
        StudyNotRun { study, file } => {
            en: "study \"{study}\" of {file} has no results beside the project file, or they are of another state of it: run dolmen study",
            ko: "{file}의 study \"{study}\"의 결과가 프로젝트 파일 옆에 없거나 다른 상태의 것이다. dolmen study를 실행한다",
        },
        SeveralStudies { names } => {
            en: "it has results of several studies ({names}): name one in the column study",
            ko: "study 여럿의 결과가 있다({names}). study 열에 하나를 쓴다",
        },
    }
}

sentences! {
    JournalError in "journal.error" {
        Header => {
            en: "it is no journal of a study of this program: its first line is another's, or of an older one that judged runs otherwise; --restart throws it away",
            ko: "이 프로그램의 study 기록이 아니다. 첫 줄이 다른 프로그램의 것이거나 판정이 달랐던 예전 것이다. --restart로 버린다",
        },
        Line { line } => {
            en: "line {line} is damaged: restore the file, or start anew with --restart",
            ko: "{line}행이 손상되었다. 파일을 되살리거나 --restart로 새로 시작한다",
        },
    }
}

sentences! {
    ScoreDesignsError in "score-designs.error" {
        Column { column } => {
            en: "the table of designs has no column \"{column}\": write it with `dolmen score --train`",
            ko: "설계의 표에 \"{column}\" 열이 없다. `dolmen score --train`으로 만든다",
        },
        Value { line, column, given, wanted } => {
            en: "line {line}, {column}: \"{given}\" is no {wanted}",
            ko: "{line}행 {column}: \"{given}\"은(는) {wanted}이(가) 아니다",
        },
        Table { why } => {
            en: "the table of designs cannot be read: {why}",
            ko: "설계의 표를 읽을 수 없다: {why}",
        },
    }
}

sentences! {
    PortfolioError in "portfolio.error" {
        Table(why) => {
            en: "{why}",
            ko: "{why}",
        },
        SeveralSheets { known } => {
            en: "the workbook has several sheets ({known}): name the one that is meant, --sheet NAME",
            ko: "통합 문서에 시트가 여럿이다({known}). --sheet 이름으로 하나를 지정한다",
        },
        NoSheets { sheet } => {
            en: "--sheet {sheet} is for a workbook (XLSX, ODS); this table is text: leave it out",
            ko: "--sheet {sheet}은(는) 통합 문서(XLSX, ODS)에 쓴다. 이 표는 텍스트이므로 뺀다",
        },
        NoName as { columns: columns_said() } => {
            en: "the table has no column \"name\": the first line names the columns, {columns}",
            ko: "표에 \"name\" 열이 없다. 첫 줄에 열 이름을 쓴다: {columns}",
        },
        Column { column } as { column, columns: columns_said() } => {
            en: "column \"{column}\" is misspelt or in another unit: columns are {columns} (body_height_m in m, taper_deg in degrees), in English or Korean",
            ko: "열 \"{column}\"은(는) 이름이나 단위가 다르다. 쓸 수 있는 열은 {columns}이다. 탑신 높이는 m, 체감각은 도로 쓴다",
        },
        ColumnTwice { column } => {
            en: "two columns are {column}: keep one of them",
            ko: "{column} 열이 둘이다. 하나만 남긴다",
        },
        Missing { line, name, what } => {
            en: "line {line} ({name}): {what}",
            ko: "{line}행({name}): {what}",
        },
        Value { line, name, column, given, allowed } => {
            en: "line {line} ({name}): {column} is \"{given}\", but must be {allowed}",
            ko: "{line}행({name}): {column}이(가) \"{given}\"인데 {allowed}이어야 한다",
        },
        Refused { line, name, why } as { line, name, why: why.advised_both() } => {
            en: "line {line} ({name}): {why}",
            ko: "{line}행({name}): {why}",
        },
        TwoPagodas { line, name, slenderness_angle, body_slenderness, made } as { line, name, slenderness_angle, body_slenderness, made: format!("{made:.2}") } => {
            en: "line {line} ({name}): slenderness_angle {slenderness_angle} and body_slenderness {body_slenderness} are not of one pagoda: with the other factors a body of {body_slenderness} has an angle of {made}. Give the one that was measured, and leave the other empty",
            ko: "{line}행({name}): 세장각(slenderness_angle) {slenderness_angle}와(과) 몸돌 세장비(body_slenderness) {body_slenderness}은(는) 한 석탑의 값이 아니다. 다른 인자가 같으면 몸돌 세장비 {body_slenderness}의 각은 {made}이다. 잰 값만 쓰고 다른 것은 비운다",
        },
        Twice { name, first, second } => {
            en: "lines {first} and {second} are both \"{name}\": give each structure its own name",
            ko: "{first}행과 {second}행의 이름이 모두 \"{name}\"이다. 구조물마다 다른 이름을 붙인다",
        },
    }
}
