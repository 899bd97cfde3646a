//! Errors of meshes, in both languages.

use crate::limits::LimitError;
use crate::meshes::{MeshError, PoseError};
use crate::quoted::shown;
use dolmen_words::sentences;

sentences! {
    MeshError in "meshes.error" {
        Unknown => {
            en: "the file is no OBJ, STL or PLY: none of them begins like this; export the mesh as one of these",
            ko: "OBJ, STL, PLY 파일이 아니다. 이들 형식의 시작과 다르다. 셋 중 하나로 내보낸다",
        },
        PointCloud { format } => {
            en: "the file is a cloud of points ({format}) and bounds no stone: make a closed mesh of it first, for example in CloudCompare or MeshLab (Poisson surface), and export that as OBJ, STL or PLY",
            ko: "파일이 점군({format})이라 석재를 둘러싸는 면이 없다. CloudCompare나 MeshLab(푸아송 표면 재구성) 등으로 닫힌 메시를 먼저 만들어 OBJ, STL, PLY로 내보낸다",
        },
        NoFaces { vertices } => {
            en: "the file holds {vertices} vertices but no faces: export a mesh, not a cloud of points",
            ko: "파일에 꼭짓점 {vertices}개만 있고 면이 없다. 점군이 아니라 메시로 내보낸다",
        },
        Number { line, text } as { line, text: shown(text) } => {
            en: "line {line}: \"{text}\" is not a finite number",
            ko: "{line}행의 \"{text}\"은(는) 유한한 수가 아니다",
        },
        Line { line, what } => {
            en: "line {line}: {what}",
            ko: "{line}행: {what}",
        },
        Vertex { line, given, vertices } => {
            en: "line {line}: a face names vertex {given}, but there are {vertices}",
            ko: "{line}행의 면에 꼭짓점 {given}이(가) 쓰였는데 꼭짓점은 {vertices}개이다",
        },
        Length { expected, held } => {
            en: "the file should have {expected} bytes by its own count, but has {held}: it was cut short or damaged",
            ko: "파일에 적힌 대로면 {expected}바이트이어야 하는데 {held}바이트이다. 잘렸거나 손상되었다",
        },
        CutShort { offset, element, number } => {
            en: "byte {offset}: the file ends within {element} {number}: it was cut short",
            ko: "{offset}바이트: 파일이 {element} {number}에서 끝난다. 잘린 파일이다",
        },
        Byte { offset, what } => {
            en: "byte {offset}: {what}",
            ko: "{offset}바이트: {what}",
        },
        Triangles { found, most } => {
            en: "the mesh has {found} triangles, but at most {most} are cut into stones: decimate it, for example in MeshLab or CloudCompare; edges of 10 mm show a bed as well",
            ko: "메시의 삼각형이 {found}개인데 최대 {most}개까지 석재로 자른다. MeshLab이나 CloudCompare 등에서 줄인다(decimate). 변 길이 10 mm로도 접합면을 똑같이 찾는다",
        },
        Expands { bytes, held, most } => {
            en: "the file of {bytes} bytes holds a mesh of {held}, but at most {most} are read of it: it is damaged; export it again with triangles",
            ko: "{bytes}바이트 파일의 메시가 {held}바이트인데 {most}바이트까지만 읽는다. 손상된 파일이다. 삼각형으로 다시 내보낸다",
        },
    }
    handed on { Limit(LimitError) }
}

sentences! {
    PoseError in "meshes.pose" {
        Count { poses, blocks } => {
            en: "{poses} poses are given for {blocks} blocks: give one of each, in the order of the stack",
            ko: "블록은 {blocks}개인데 자세가 {poses}개이다. 쌓은 순서대로 블록마다 하나를 입력한다",
        },
        NotFinite { block } => {
            en: "the pose of block {block} is not finite",
            ko: "블록 {block}의 자세가 유한한 수가 아니다",
        },
    }
}
