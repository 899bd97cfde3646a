//! Why a store cannot answer, and what to do.

use dolmen_words::message::Both;
use dolmen_words::{Sentence, messages};
use dolmen_work::kept::StoreFault;

messages! {
    /// Why a store cannot answer.
    pub(crate) enum Faults in "store.fault" {
        Unnamed => {
            en: "No store is named: give --store FILE, or set DOLMEN_STORE.",
            ko: "저장소를 지정하지 않았다. --store FILE을 주거나 DOLMEN_STORE를 설정한다.",
        },
        NoStore { shown: String } => {
            en: "There is no store {shown}: `dolmen survey add PROJECT --store {shown}` makes it.",
            ko: "저장소 {shown}이(가) 없다. `dolmen survey add PROJECT --store {shown}`으로 만든다.",
        },
        NotAFile { shown: String } => {
            en: "{shown} is no regular file: a store is one file, with a folder FILE.files beside it; name another.",
            ko: "{shown}은(는) 일반 파일이 아니다. 저장소는 파일 하나와 그 옆의 FILE.files 폴더로 이루어진다. 다른 이름을 지정한다.",
        },
        Foreign { shown: String } => {
            en: "{shown} is a database of another program, and is left as it is: name another file.",
            ko: "{shown}은(는) 다른 프로그램의 데이터베이스이므로 손대지 않는다. 다른 파일을 지정한다.",
        },
        NotADatabase => {
            en: "The file is no database, and is left as it is: --store names the file of a store, not a project or record.",
            ko: "데이터베이스 파일이 아니므로 손대지 않는다. --store에는 프로젝트나 기록이 아니라 저장소 파일을 지정한다.",
        },
        Later { found: usize, known: usize } => {
            en: "A later version of Dolmen made this store (schema {found}, this version knows {known}): use that version.",
            ko: "더 새로운 버전의 Dolmen이 만든 저장소이다(스키마 {found}, 이 버전은 {known}까지). 그 버전을 사용한다.",
        },
        Locked => {
            en: "Another process is writing to the store; nothing was stored. Try again, or wait longer with --wait SECONDS.",
            ko: "다른 프로세스가 저장소에 쓰고 있어 아무것도 저장하지 않았다. 다시 실행하거나 --wait SECONDS로 더 기다린다.",
        },
        ReadOnly => {
            en: "The store may only be read here; nothing was stored. Change the rights of the file and its folder, or copy it with `dolmen survey export -o COPY`.",
            ko: "이 저장소는 읽기 전용이므로 아무것도 저장하지 않았다. 파일과 폴더의 권한을 바꾸거나 `dolmen survey export -o COPY`로 사본을 만든다.",
        },
        Unopenable => {
            en: "The file of the store cannot be opened: its folder must exist, and you need the right to read and write both.",
            ko: "저장소 파일을 열 수 없다. 폴더가 있어야 하고 파일과 폴더에 대한 읽기·쓰기 권한이 필요하다.",
        },
        DiskFull => {
            en: "The disk is full; nothing was stored, and what was there before is whole. Make room and run it again.",
            ko: "디스크에 공간이 없어 아무것도 저장하지 않았으며 기존 자료는 온전하다. 공간을 확보한 뒤 다시 실행한다.",
        },
        Damaged { why: String } => {
            en: "The store is damaged ({why}): `dolmen survey verify` lists what is wrong; take the last good copy.",
            ko: "저장소가 손상되었다({why}). `dolmen survey verify`로 손상된 곳을 확인하고 마지막 정상 사본을 사용한다.",
        },
        Raw { hash: String } => {
            en: "The raw file {hash} is missing or was changed: `dolmen survey verify` lists what is wrong; copy it from a good copy of the folder of raw files.",
            ko: "원본 파일 {hash}이(가) 없거나 변경되었다. `dolmen survey verify`로 확인하고 원본 파일 폴더의 정상 사본에서 복사한다.",
        },
        Folder { shown: String, why: Both } => {
            en: "Cannot use {shown}: {why}.",
            ko: "{shown}을(를) 사용할 수 없다: {why}.",
        },
        NoStructure { name: String } => {
            en: "There is no structure \"{name}\" in the store: `dolmen survey list` shows all.",
            ko: "저장소에 구조물 \"{name}\"이(가) 없다. `dolmen survey list`로 전체 목록을 본다.",
        },
        NoStructureBut { name: String, nearest: String } => {
            en: "There is no structure \"{name}\" in the store; did you mean \"{nearest}\"? `dolmen survey list` shows all.",
            ko: "저장소에 구조물 \"{name}\"이(가) 없다. \"{nearest}\"을(를) 찾는가? `dolmen survey list`로 전체 목록을 본다.",
        },
        NoSurvey { name: String, known: String } => {
            en: "There is no survey \"{name}\"; the last ones are {known}.",
            ko: "계측 조사 \"{name}\"이(가) 없다. 최근 조사: {known}.",
        },
        NoSurveys { name: String } => {
            en: "There is no survey \"{name}\": the structure has none.",
            ko: "계측 조사 \"{name}\"이(가) 없다. 이 구조물에는 조사가 없다.",
        },
        StructureName { shown: String } => {
            en: "The name \"{shown}\" cannot be kept: a structure needs 1 to 200 bytes without control characters; give another with --name.",
            ko: "이름 \"{shown}\"은(는) 저장할 수 없다. 구조물 이름은 제어 문자 없이 1~200바이트여야 한다. --name으로 다른 이름을 준다.",
        },
        Path { shown: String } => {
            en: "The file \"{shown}\" cannot be kept: it must lie in the folder of the project and be there; copy it into that folder, and name it by a plain relative path.",
            ko: "파일 \"{shown}\"은(는) 저장할 수 없다. 프로젝트 폴더 안에 있어야 한다. 그 폴더에 복사하고 단순한 상대 경로로 적는다.",
        },
        OtherName { shown: String } => {
            en: "\"{shown}\" cannot be kept: --who and --why need 1 to 200 bytes without control characters.",
            ko: "\"{shown}\"은(는) 저장할 수 없다. --who와 --why는 제어 문자 없이 1~200바이트여야 한다.",
        },
        OtherKind { name: String, kept: String, given: String } => {
            en: "The store keeps \"{name}\" as a {kept}, but this project is a {given}: if it is another structure, give it another name with --name.",
            ko: "저장소의 \"{name}\"은(는) {kept}인데 이 프로젝트는 {given}이다. 다른 구조물이면 --name으로 다른 이름을 준다.",
        },
        NoPostgres => {
            en: "This dolmen was built without PostgreSQL, so nothing was done: build it with `--features postgres`, or name the file of a store.",
            ko: "이 dolmen에는 PostgreSQL 기능이 없어 아무 작업도 하지 않았다. `--features postgres`로 빌드하거나 저장소 파일을 지정한다.",
        },
        ServerUrl { part: String } => {
            en: "The address of the server cannot be read ({part}): write postgresql://ROLE@HOST:PORT/DATABASE, or postgresql:///DATABASE?host=/FOLDER for a socket; in a role or password @ is written %40, / %2F, ? %3F, # %23 and % %25.",
            ko: "서버 주소를 읽을 수 없다({part}). postgresql://ROLE@HOST:PORT/DATABASE로, 소켓이면 postgresql:///DATABASE?host=/FOLDER로 쓴다. 사용자 이름과 비밀번호의 @는 %40, /는 %2F, ?는 %3F, #은 %23, %는 %25로 쓴다.",
        },
        ServerTls { mode: String } => {
            en: "sslmode={mode} asks for an encrypted connection. Dolmen speaks no TLS, so it did not connect: use the socket of the server's own machine, or a tunnel (ssh -L 5433:localhost:5432 HOST) with localhost:5433 in the address.",
            ko: "sslmode={mode}은(는) 암호화된 연결을 요구한다. Dolmen은 TLS를 지원하지 않아 연결하지 않았다. 서버 컴퓨터의 소켓을 쓰거나 터널(ssh -L 5433:localhost:5432 HOST)을 열고 주소에 localhost:5433을 쓴다.",
        },
        ServerClear { host: String } => {
            en: "{host} is another machine, and Dolmen speaks no TLS: all that it sends could be read on the way, so it did not connect. Use a tunnel (ssh -L 5433:localhost:5432 HOST) with localhost:5433 in the address, or say with ?sslmode=disable that the network is safe.",
            ko: "{host}은(는) 다른 컴퓨터이고 Dolmen은 TLS를 지원하지 않는다. 전송 내용이 도중에 노출될 수 있어 연결하지 않았다. 터널(ssh -L 5433:localhost:5432 HOST)을 열고 주소에 localhost:5433을 쓰거나, 안전한 네트워크이면 주소에 ?sslmode=disable을 붙인다.",
        },
        ServerDown { shown: String, why: String } => {
            en: "No server of PostgreSQL answers at {shown} ({why}): is it running there, and are host and port right? Nothing was stored.",
            ko: "{shown}에서 PostgreSQL 서버가 응답하지 않는다({why}). 서버가 실행 중인지, 호스트와 포트가 맞는지 확인한다. 아무것도 저장하지 않았다.",
        },
        ServerRefused { shown: String } => {
            en: "The server refuses {shown}: the role, its password or the rules of the server (pg_hba.conf) do not fit. The password stands in the address, in PGPASSWORD or in the file ~/.pgpass.",
            ko: "서버가 {shown}의 접속을 거부한다. 사용자(role)나 비밀번호 또는 서버의 접속 규칙(pg_hba.conf)이 맞지 않는다. 비밀번호는 주소, PGPASSWORD 또는 ~/.pgpass 파일에 둔다.",
        },
        ServerPassword { shown: String } => {
            en: "The server asks {shown} for a password and none is given: set PGPASSWORD, or write it into the file ~/.pgpass, which only you may read (chmod 600).",
            ko: "서버가 {shown}의 비밀번호를 요구하는데 주어지지 않았다. PGPASSWORD를 설정하거나 본인만 읽을 수 있는(chmod 600) ~/.pgpass 파일에 적는다.",
        },
        ServerDatabase { shown: String } => {
            en: "The server has no database {shown}: `createdb -O ROLE DATABASE` on the server makes it, the first `dolmen survey add` then makes the store in it.",
            ko: "서버에 데이터베이스 {shown}이(가) 없다. 서버에서 `createdb -O ROLE DATABASE`로 만들면 첫 `dolmen survey add`가 그 안에 저장소를 만든다.",
        },
        ServerFull { shown: String } => {
            en: "{shown} takes no more connections, and nothing was stored: try again, or raise max_connections of the server.",
            ko: "{shown}이(가) 더는 연결을 받지 않아 아무것도 저장하지 않았다. 다시 실행하거나 서버의 max_connections를 늘린다.",
        },
        ServerEncoding { shown: String, encoding: String } => {
            en: "{shown} keeps text as {encoding}, which lacks signs of names and notes: make the database with `createdb --encoding UTF8 --template template0`.",
            ko: "{shown}의 문자 인코딩은 {encoding}이라 이름과 메모의 글자를 모두 저장할 수 없다. `createdb --encoding UTF8 --template template0`으로 데이터베이스를 만든다.",
        },
        ServerEmpty { shown: String } => {
            en: "There is no store in {shown}: `dolmen survey add PROJECT` with this --store makes it.",
            ko: "{shown}에 저장소가 없다. 이 --store로 `dolmen survey add PROJECT`를 실행하면 만들어진다.",
        },
        ServerForeign { shown: String } => {
            en: "The schema dolmen of {shown} holds tables of another program, and is left as it is: make another database for the store.",
            ko: "{shown}의 스키마 dolmen에는 다른 프로그램의 테이블이 있으므로 손대지 않는다. 저장소용 데이터베이스를 따로 만든다.",
        },
        ServerRights { shown: String } => {
            en: "{shown} lacks the right for this, or the server is a read-only copy; nothing was stored. The owner of the database gives rights: to read, `grant usage on schema dolmen` and `grant select on all tables in schema dolmen`; to write, `grant insert` as well.",
            ko: "{shown}에 이 작업을 할 권한이 없거나 서버가 읽기 전용 복제본이다. 아무것도 저장하지 않았다. 데이터베이스 소유자가 권한을 준다. 읽기에는 `grant usage on schema dolmen`과 `grant select on all tables in schema dolmen`이, 쓰기에는 `grant insert`도 필요하다.",
        },
        ServerGone { shown: String } => {
            en: "The connection to {shown} ended while it was used. What was acknowledged is on disk; what was under way is stored whole or not at all: run it again, nothing is stored twice.",
            ko: "{shown}에 대한 연결이 작업 중에 끊어졌다. 저장했다고 알린 것은 모두 디스크에 있고, 진행 중이던 것은 전부 저장되었거나 전혀 저장되지 않았다. 다시 실행한다. 두 번 저장되지 않는다.",
        },
        ZeroByte { shown: String } => {
            en: "\"{shown}\" holds a zero byte (NUL), which PostgreSQL cannot keep in text; nothing was stored. Take it out of the project or store that it comes from.",
            ko: "\"{shown}\"에 NUL 바이트(값이 0인 바이트)가 있는데 PostgreSQL은 이를 텍스트로 저장할 수 없어 아무것도 저장하지 않았다. 그것이 든 프로젝트나 저장소에서 지운다.",
        },
        Failed { why: String } => {
            en: "The store cannot answer: {why}.",
            ko: "저장소가 응답할 수 없다: {why}.",
        },
    }
}

/// The sentence on a fault.
pub fn store_fault(fault: &StoreFault) -> Sentence {
    let fault = fault.clone();
    match fault {
        StoreFault::Unnamed => Faults::Unnamed,
        StoreFault::NoStore { shown } => Faults::NoStore { shown },
        StoreFault::NotAFile { shown } => Faults::NotAFile { shown },
        StoreFault::Foreign { shown } => Faults::Foreign { shown },
        StoreFault::NotADatabase => Faults::NotADatabase,
        StoreFault::Later { found, known } => Faults::Later { found, known },
        StoreFault::Locked => Faults::Locked,
        StoreFault::ReadOnly => Faults::ReadOnly,
        StoreFault::Unopenable => Faults::Unopenable,
        StoreFault::DiskFull => Faults::DiskFull,
        StoreFault::Damaged { why } => Faults::Damaged { why },
        StoreFault::Raw { hash } => Faults::Raw { hash },
        StoreFault::Folder { shown, why } => Faults::Folder { shown, why },
        StoreFault::NoStructure { name, nearest: None } => Faults::NoStructure { name },
        StoreFault::NoStructure {
            name,
            nearest: Some(nearest),
        } => Faults::NoStructureBut { name, nearest },
        StoreFault::NoSurvey { name, known } if known.is_empty() => Faults::NoSurveys { name },
        StoreFault::NoSurvey { name, known } => Faults::NoSurvey { name, known },
        StoreFault::Name {
            what: "structure",
            shown,
        } => Faults::StructureName { shown },
        StoreFault::Name { what: "path", shown } => Faults::Path { shown },
        StoreFault::Name { shown, .. } => Faults::OtherName { shown },
        StoreFault::OtherKind { name, kept, given } => Faults::OtherKind { name, kept, given },
        StoreFault::NoPostgres => Faults::NoPostgres,
        StoreFault::ServerUrl { part } => Faults::ServerUrl { part },
        StoreFault::ServerTls { mode } => Faults::ServerTls { mode },
        StoreFault::ServerClear { host } => Faults::ServerClear { host },
        StoreFault::ServerDown { shown, why } => Faults::ServerDown { shown, why },
        StoreFault::ServerRefused { shown } => Faults::ServerRefused { shown },
        StoreFault::ServerPassword { shown } => Faults::ServerPassword { shown },
        StoreFault::ServerDatabase { shown } => Faults::ServerDatabase { shown },
        StoreFault::ServerFull { shown } => Faults::ServerFull { shown },
        StoreFault::ServerEncoding { shown, encoding } => Faults::ServerEncoding { shown, encoding },
        StoreFault::ServerEmpty { shown } => Faults::ServerEmpty { shown },
        StoreFault::ServerForeign { shown } => Faults::ServerForeign { shown },
        StoreFault::ServerRights { shown } => Faults::ServerRights { shown },
        StoreFault::ServerGone { shown } => Faults::ServerGone { shown },
        StoreFault::ZeroByte { shown } => Faults::ZeroByte { shown },
        StoreFault::Failed { why } => Faults::Failed { why },
    }
    .into()
}
