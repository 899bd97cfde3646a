//! Errors of files that are not available or exceed limits, in both languages.

use crate::files::FileError;
use crate::limits::LimitError;
use dolmen_words::sentences;

sentences! {
    FileError in "file.error" {
        Unreadable { shown, why } => {
            en: "cannot read {shown}: {why}",
            ko: "{shown}을(를) 읽을 수 없다: {why}",
        },
        TooLarge { shown, bytes, most } => {
            en: "{shown} holds {bytes} bytes, but at most {most} are read: cut it, split it into several files, or give --largest-file",
            ko: "{shown}은(는) {bytes}바이트인데 {most}바이트까지만 읽는다. 자르거나, 여러 파일로 나누거나, --largest-file을 준다",
        },
        Outside { shown } => {
            en: "{shown} lies outside the folder of the project, or leads out of it: copy it into that folder, or give --allow-outside if you trust the project file",
            ko: "{shown}은(는) 프로젝트 폴더 밖에 있거나 밖으로 이어진다. 프로젝트 폴더에 복사한다. 프로젝트 파일을 믿을 수 있으면 --allow-outside 옵션을 붙인다",
        },
        NotAFile { shown, what } => {
            en: "{shown} is {what}, but only regular files are read: save what it gives to a file, and name that",
            ko: "{shown}은(는) {what}인데 일반 파일만 읽는다. 그 내용을 파일로 저장해 지정한다",
        },
        Absent { shown } => {
            en: "there is no {shown}",
            ko: "{shown}이(가) 없다",
        },
        Backslash { shown, slashes } => {
            en: "there is no {shown}: write folders with /, \"{slashes}\"",
            ko: "{shown}이(가) 없다. 폴더는 /로 나눈다: \"{slashes}\"",
        },
        Misspelt { shown, near } => {
            en: "there is no {shown}: did you mean \"{near}\", which lies beside it?",
            ko: "{shown}이(가) 없다. 같은 폴더에 있는 \"{near}\"인가?",
        },
        NamedIn { file, line, why } => {
            en: "{file}, line {line}: {why}",
            ko: "{file} {line}행: {why}",
        },
        TextAlone => {
            en: "no files are read here, only the text of the project",
            ko: "여기서는 파일을 읽지 않고 프로젝트의 텍스트만 읽는다",
        },
    }
}

sentences! {
    LimitError in "limit.error" {
        Line { line, bytes, most } => {
            en: "line {line} has {bytes} bytes, but at most {most} are read: write one line a sample, or a face of a mesh; are rows and columns swapped?",
            ko: "{line}행이 {bytes}바이트인데 {most}바이트까지만 읽는다. 자료 하나 또는 메시의 면 하나를 한 행에 쓴다. 행과 열이 바뀌었는가?",
        },
        Columns { line, found, most } => {
            en: "line {line} holds {found} cells, but at most {most} are read, more than any recorder has: are rows and columns swapped? write one line a sample",
            ko: "{line}행에 칸이 {found}개 있는데 {most}개까지만 읽는다. 그렇게 많은 채널의 기록계는 없다. 행과 열이 바뀌었는가? 자료 하나를 한 행에 쓴다",
        },
        Parts { format, what, most } => {
            en: "the {format} file holds more than {most} {what}, which no recorder writes: save the channels that are needed alone",
            ko: "{format} 파일에 {what}이(가) {most}개보다 많다. 그런 기록계는 없다. 필요한 채널만 저장한다",
        },
        Expands { format, packed, unpacked, most, instead } => {
            en: "the {format} file of {packed} bytes unpacks to {unpacked}, but at most {most} are unpacked of it, since no record of vibrations packs so tightly: {instead}",
            ko: "{packed}바이트인 {format} 파일의 압축을 풀면 {unpacked}바이트인데 {most}바이트까지만 푼다. 진동 기록은 그렇게 압축되지 않는다. {instead}",
        },
    }
}
