//! Errors of a store, in both languages, as a part of another sentence.

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
            ko: "{name} 조사가 없다",
        },
        Name { what, shown } => {
            en: "{what} {shown} cannot be kept",
            ko: "{what} {shown}을(를) 저장할 수 없다",
        },
        OtherKind { name, kept, given } => {
            en: "{name} is kept as a {kept}, not as a {given}",
            ko: "{name}은(는) {given}이(가) 아니라 {kept}(으)로 저장되어 있다",
        },
        NoPostgres => {
            en: "this dolmen was built without PostgreSQL",
            ko: "PostgreSQL 기능이 없는 dolmen이다",
        },
        ServerUrl { part } => {
            en: "the address of the server cannot be read: {part}",
            ko: "서버 주소를 읽을 수 없다: {part}",
        },
        ServerTls { mode } => {
            en: "sslmode={mode} asks for encryption, which this dolmen does not speak",
            ko: "sslmode={mode}은(는) 암호화를 요구하는데 이 dolmen은 지원하지 않는다",
        },
        ServerClear { host } => {
            en: "{host} is another machine, and Dolmen speaks no TLS",
            ko: "{host}은(는) 다른 컴퓨터인데 Dolmen은 TLS를 지원하지 않는다",
        },
        ServerDown { shown, why } => {
            en: "no server of PostgreSQL answers at {shown}: {why}",
            ko: "{shown}에서 PostgreSQL 서버가 응답하지 않는다: {why}",
        },
        ServerRefused { shown } => {
            en: "the server refuses {shown}: role or password",
            ko: "서버가 {shown}의 접속을 거부한다: 사용자 또는 비밀번호",
        },
        ServerPassword { shown } => {
            en: "the server asks {shown} for a password",
            ko: "서버가 {shown}의 비밀번호를 요구한다",
        },
        ServerDatabase { shown } => {
            en: "there is no database {shown}",
            ko: "데이터베이스 {shown}이(가) 없다",
        },
        ServerFull { shown } => {
            en: "{shown} takes no more connections",
            ko: "{shown}이(가) 더는 연결을 받지 않는다",
        },
        ServerEncoding { shown, encoding } => {
            en: "{shown} keeps text as {encoding}, not as UTF8",
            ko: "{shown}의 문자 인코딩이 UTF8이 아니라 {encoding}이다",
        },
        ServerEmpty { shown } => {
            en: "there is no store in {shown}",
            ko: "{shown}에 저장소가 없다",
        },
        ServerForeign { shown } => {
            en: "the schema dolmen of {shown} is of another program",
            ko: "{shown}의 스키마 dolmen은 다른 프로그램의 것이다",
        },
        ServerRights { shown } => {
            en: "{shown} lacks the right for this",
            ko: "{shown}에 이 작업을 할 권한이 없다",
        },
        ServerGone { shown } => {
            en: "the connection to {shown} ended",
            ko: "{shown}에 대한 연결이 끊어졌다",
        },
        ZeroByte { shown } => {
            en: "\"{shown}\" holds a zero byte, which PostgreSQL cannot keep",
            ko: "\"{shown}\"에 PostgreSQL이 저장할 수 없는 NUL 바이트가 있다",
        },
        Failed { why } => {
            en: "{why}",
            ko: "{why}",
        },
    }
}
