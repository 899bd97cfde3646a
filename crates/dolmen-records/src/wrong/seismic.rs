//! Errors of the file of a seismic station, in both languages.

use super::pieces::at_line;
use crate::limits::LimitError;
use crate::quoted::shown;
use crate::records::SeismicError;
use dolmen_words::sentences;

sentences! {
    SeismicError in "seismic.error" {
        At2Header { line, text } as { line, text: shown(text) } => {
            en: "line {line}: \"{text}\" does not give NPTS and DT: it must read like \"NPTS= 4000, DT= .0100 SEC\" or \"4000 0.0100 NPTS, DT\"; download the file again",
            ko: "{line}행의 \"{text}\"에 NPTS와 DT가 없다. \"NPTS= 4000, DT= .0100 SEC\" 또는 \"4000 0.0100 NPTS, DT\"와 같아야 한다. 파일을 다시 받는다",
        },
        Quantity { line, what } as { place: at_line(*line), what } => {
            en: "{place}the file holds {what}, not accelerations: take the file of accelerations (of PEER, the one that ends in AT2)",
            ko: "{place}파일의 자료가 가속도가 아니라 {what}이다. 가속도 파일을 쓴다(PEER이면 AT2로 끝나는 파일)",
        },
        At2Unit { line, text } as { line, text: shown(text) } => {
            en: "line {line}: the unit \"{text}\" is not known: give unit = g, gal or m/s2 if you know which is meant",
            ko: "{line}행: 알 수 없는 단위 \"{text}\"이다. 무엇인지 알면 unit을 g, gal 또는 m/s2로 입력한다",
        },
        NotANumber { line, text } as { line, text: shown(text) } => {
            en: "line {line}: \"{text}\" is not a finite number: correct it, or download the file again",
            ko: "{line}행의 \"{text}\"은(는) 유한한 수가 아니다. 고치거나 파일을 다시 받는다",
        },
        Count { stated, found } => {
            en: "the header says {stated} samples, but {found} follow: the file was cut short or edited; download it again",
            ko: "머리글에는 자료가 {stated}개라는데 {found}개가 있다. 잘렸거나 편집되었다. 파일을 다시 받는다",
        },
        Line { line, text, wanted } as { line, text: shown(text), wanted } => {
            en: "line {line}: \"{text}\" is not {wanted}: the file was cut or edited; download it again",
            ko: "{line}행의 \"{text}\"이(가) 형식에 맞지 않는다. 이 자리에 있어야 하는 것: {wanted}. 파일이 잘렸거나 편집되었다. 다시 받는다",
        },
        EndsEarly { line, wanted } => {
            en: "the file ends before line {line}, which must be {wanted}: it was cut short; download it again",
            ko: "파일이 {line}행 앞에서 끝난다. 그 행에 있어야 하는 것: {wanted}. 잘린 파일이므로 다시 받는다",
        },
        Missing { label, lines } => {
            en: "the header ({lines} lines) does not give {label}: the file was cut or edited; download it again",
            ko: "머리글({lines}행)에 {label}이(가) 없다. 파일이 잘렸거나 편집되었다. 다시 받는다",
        },
        Bytes { format, stated, found } => {
            en: "the {format} file has {found} bytes, but its header says {stated}: it was cut short or edited; download it again",
            ko: "{format} 파일이 {found}바이트인데 머리글에는 {stated}바이트로 되어 있다. 잘렸거나 편집되었다. 다시 받는다",
        },
        Sac { what, found } => {
            en: "the SAC header says {found}, but {what}",
            ko: "SAC 머리글의 값이 {found}이다: {what}",
        },
        Damaged { at, what } => {
            en: "the miniSEED record at byte {at}: {what}; download the file again",
            ko: "{at}바이트에서 시작하는 miniSEED 레코드: {what}. 파일을 다시 받는다",
        },
        Encoding { at, encoding } => {
            en: "the miniSEED record at byte {at} has encoding {encoding}, but only 16 and 32 bit integers (1, 3), floats (4, 5) and Steim 1 and 2 (10, 11) are read: convert it before",
            ko: "{at}바이트에서 시작하는 miniSEED 레코드의 부호화가 {encoding}인데 16·32비트 정수(1, 3), 실수(4, 5), Steim 1·2(10, 11)만 읽는다. 먼저 변환한다",
        },
        Gap { channel, expected_s, found_s } as { channel: shown(channel), found_s, expected_s } => {
            en: "channel {channel}: a record begins {found_s} s after the first, but the samples before it end at {expected_s} s: there is a gap or an overlap; cut the file there",
            ko: "채널 {channel}: 레코드 하나가 처음에서 {found_s} s 뒤에 시작하는데 그 앞의 자료는 {expected_s} s에서 끝난다. 자료가 비었거나 겹친다. 거기서 파일을 자른다",
        },
        Counts { line } => {
            en: "line {line}: the numbers are raw counts of the recorder (V0): take the V1 or V2 file, which holds accelerations",
            ko: "{line}행: 수가 기록계의 원시 계수(V0)이다. 가속도가 든 V1이나 V2 파일을 쓴다",
        },
    }
    handed on { Limit(LimitError) }
}
