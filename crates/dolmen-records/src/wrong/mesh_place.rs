//! Errors at a place of a mesh.

use dolmen_words::messages;

messages! {
    /// An error at a line or byte.
    pub(crate) enum OfMesh in "meshes.place" {
        FewCorners => { en: "a face has fewer than 3 vertices", ko: "면의 꼭짓점이 3개보다 적다" },
        ManyCorners => { en: "a face has more than 65536 vertices", ko: "면의 꼭짓점이 65536개보다 많다" },
        ThreeCoordinates => { en: "a vertex needs three coordinates", ko: "꼭짓점에는 좌표가 3개 필요하다" },
        NoCoordinates => { en: "the vertices have no x, y and z", ko: "꼭짓점에 x, y, z가 없다" },
        FaceWithoutVertices => { en: "a face before here has no vertices", ko: "이 앞의 면에 꼭짓점이 없다" },
        VertexNotFinite => { en: "a vertex before here is not finite", ko: "이 앞의 꼭짓점이 유한한 수가 아니다" },
        LongHeader => { en: "the header has more than 16384 lines", ko: "머리글이 16384행보다 길다" },
        FirstLine => { en: "the first line of a PLY file is \"ply\"", ko: "PLY 파일의 첫 행은 \"ply\"이다" },
        Format => { en: "the format must be ascii, binary_little_endian or binary_big_endian", ko: "형식은 ascii, binary_little_endian 또는 binary_big_endian이어야 한다" },
        ElementCount => { en: "the number of elements is no number", ko: "요소의 수가 수가 아니다" },
        TypeOfNumber => { en: "a type of number is not known", ko: "알 수 없는 수의 종류이다" },
        PropertyFirst => { en: "a property comes before the first element", ko: "첫 요소보다 앞에 속성이 있다" },
        NoHeaderLine => { en: "this is no line of the header of a PLY file", ko: "PLY 머리글의 행이 아니다" },
        NoEndHeader => { en: "the header has no end_header", ko: "머리글에 end_header가 없다" },
        Vertex => { en: "vertex", ko: "꼭짓점" },
        Element => { en: "element", ko: "요소" },
        ListLength => { en: "the length of a list is not between 0 and 65536", ko: "목록의 길이가 0~65536이 아니다" },
        LongLine => { en: "the line holds more values than the header says", ko: "행의 값이 머리글의 수보다 많다" },
        CornerNotFinite => { en: "a corner of a triangle is not finite", ko: "삼각형의 꼭짓점이 유한한 수가 아니다" },
        ShortLoop => { en: "a loop has fewer than 3 vertices", ko: "loop의 꼭짓점이 3개보다 적다" },
        NoStlLine => { en: "this is no line of an STL file", ko: "STL 파일의 행이 아니다" },
        EndsInTriangle => { en: "the file ends within a triangle: it was cut short", ko: "파일이 삼각형 중간에서 끝난다. 잘린 파일이다" },
    }
}
