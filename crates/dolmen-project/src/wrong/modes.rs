//! Errors of a file of modes beside the project.

use dolmen_words::messages;

messages! {
    /// Errors of a file of modes.
    pub(crate) enum WrongModes in "project.error.modes" {
        MustBeFileSheetLength => {
            en: "must be file, with sheet (of a workbook) or length (of a universal file without units)",
            ko: "file과, 필요하면 sheet(통합 문서) 또는 length(단위가 없는 UFF 파일)만 쓸 수 있다",
        },
        FileOfModes => {
            en: "name a universal file (.uff, .unv) with the modes as dataset 55, or a table (.csv, .xlsx, .ods) with the columns direction and frequency_hz",
            ko: "모드가 데이터셋 55로 든 UFF 파일(.uff, .unv)이나 direction, frequency_hz 열이 있는 표(.csv, .xlsx, .ods)를 지정한다",
        },
        HasItsLength { file: String, length: String } => {
            en: "{file} tells the unit of its lengths itself (dataset 164), but length = \"{length}\" stands beside it",
            ko: "{file}에 길이의 단위가 있는데(데이터셋 164) length = \"{length}\"도 있다",
        },
        NoLength(file: String) => {
            en: "{file} gives places of nodes (dataset 15), but not the unit of its lengths (dataset 164)",
            ko: "{file}에 절점의 좌표(데이터셋 15)는 있으나 길이의 단위(데이터셋 164)가 없다",
        },
        GiveLength => {
            en: "write length = \"m\", \"mm\" or another unit of length beside file",
            ko: "file과 함께 length = \"m\", \"mm\" 등 길이의 단위를 쓴다",
        },
        IsNoLength(length: String) => {
            en: "length = \"{length}\" is no unit of length",
            ko: "length = \"{length}\"은(는) 길이의 단위가 아니다",
        },
        NodeWithoutPlace { file: String, node: String } => {
            en: "{file}: node {node} moves in a mode but has no place (dataset 15 or 2411), though others have one",
            ko: "{file}: 모드에서 움직이는 절점 {node}의 좌표(데이터셋 15 또는 2411)가 없다. 다른 절점에는 있다",
        },
        GiveEveryNode => {
            en: "give every node a place, or none: then only frequencies and damping ratios are read",
            ko: "모든 절점에 좌표를 주거나 모두 뺀다. 모두 빼면 고유진동수와 감쇠비만 읽는다",
        },
        NoColumns(file: String) => {
            en: "{file} lacks the column direction or frequency_hz",
            ko: "{file}에 direction 열이나 frequency_hz 열이 없다",
        },
        EmptyCell { file: String, place: String } => {
            en: "{file}, cell {place}: the mode has no direction or no frequency",
            ko: "{file}, {place} 셀: 모드의 방향이나 고유진동수가 없다",
        },
        GiveColumns => {
            en: "the columns are direction (x, y, torsion or another name), frequency_hz, frequency_sd_hz, damping_ratio and damping_ratio_sd; the first two are required",
            ko: "열은 direction(x, y, torsion 또는 다른 이름), frequency_hz, frequency_sd_hz, damping_ratio, damping_ratio_sd이고 앞의 둘은 반드시 있어야 한다",
        },
    }
}
