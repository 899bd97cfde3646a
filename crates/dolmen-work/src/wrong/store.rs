//! Why a store cannot answer, in both languages, where it is said within another sentence.

use crate::kept::StoreFault;
use dolmen_words::sentences;

sentences! {
    StoreFault in "store.refused" {
        Unnamed => {
            en: "no store is named",
            ko: "저장소를 지정하지 않았다",
        },
        NoStore { shown } => {
            en: "there is no store {shown}",
            ko: "저장소 {shown}이(가) 없다",
        },
        NotAFile { shown } => {
            en: "{shown} is no regular file",
            ko: "{shown}은(는) 일반 파일이 아니다",
        },
        Foreign { shown } => {
            en: "{shown} is no store of Dolmen",
            ko: "{shown}은(는) Dolmen의 저장소가 아니다",
        },
        NotADatabase => {
            en: "the file is no database",
            ko: "데이터베이스 파일이 아니다",
        },
        Later { found, known } => {
            en: "schema {found} is later than {known}",
            ko: "스키마 {found}이(가) 이 프로그램의 {known}보다 뒤의 것이다",
        },
        Locked => {
            en: "another process is writing",
            ko: "다른 프로그램이 쓰고 있다",
        },
        ReadOnly => {
            en: "the store may only be read",
            ko: "읽기만 할 수 있는 저장소이다",
        },
        Unopenable => {
            en: "the file cannot be opened",
            ko: "파일을 열 수 없다",
        },
        DiskFull => {
            en: "the disk is full",
            ko: "디스크가 가득 찼다",
        },
        Damaged { why } => {
            en: "damaged: {why}",
            ko: "손상되었다: {why}",
        },
        Raw { hash } => {
            en: "the raw file {hash} is missing or changed",
            ko: "원본 파일 {hash}이(가) 없거나 바뀌었다",
        },
        Folder { shown, why } => {
            en: "cannot use {shown}: {why}",
            ko: "{shown}을(를) 쓸 수 없다: {why}",
        },
        NoStructure { name, nearest } as { name } => {
            en: "no structure {name}",
            ko: "구조물 {name}이(가) 없다",
        },
        NoSurvey { name, known } as { name } => {
            en: "no survey {name}",
            ko: "조사 {name}이(가) 없다",
        },
        Name { what, shown } => {
            en: "{what} {shown} cannot be kept",
            ko: "{what} {shown}을(를) 저장할 수 없다",
        },
        OtherKind { name, kept, given } => {
            en: "{name} is kept as a {kept}, not as a {given}",
            ko: "{name}은(는) {given}이(가) 아니라 {kept}(으)로 저장되어 있다",
        },
        Failed { why } => {
            en: "{why}",
            ko: "{why}",
        },
    }
}
