//! Damage of a binary file of a record.

use dolmen_words::message::Both;
use dolmen_words::messages;

messages! {
    /// Damage of a binary file.
    pub(crate) enum Damage in "records.damage" {
        NoSegment => { en: "no segment begins here", ko: "여기서 시작하는 세그먼트가 없다" },
        SegmentOpen => { en: "the segment was never closed: the recorder stopped while it wrote", ko: "세그먼트가 닫히지 않았다. 기록 중에 기록계가 멈췄다" },
        SegmentLength => { en: "the length of the segment is none", ko: "세그먼트의 길이가 올바르지 않다" },
        DescriptionTooLong => { en: "the description of the segment is longer than the segment", ko: "세그먼트의 설명이 세그먼트보다 길다" },
        DescriptionRunsOn => { en: "the description of the segment runs into its samples", ko: "세그먼트의 설명이 자료까지 이어진다" },
        NoneBefore => { en: "samples lie as in the segment before, but there are none", ko: "자료가 앞 세그먼트와 같은 배치라는데 앞 세그먼트가 없다" },
        InterleavedUnlike => { en: "interleaved objects differ in their number of samples", ko: "엇갈려 저장된 채널의 자료 수가 서로 다르다" },
        NoChannelHolds => { en: "no channel holds samples", ko: "자료가 있는 채널이 없다" },
        NoChunks => { en: "the chunks \"fmt \" and \"data\" are not both there, in this order", ko: "\"fmt \"와 \"data\" 청크가 이 순서로 있지 않다" },
        FilterTwice => { en: "chunks went through one filter twice", ko: "청크가 같은 필터를 두 번 거쳤다" },
        ChunkSides => { en: "chunks have another number of sides than the matrix", ko: "청크의 차원이 행렬과 다르다" },
        ChunkSize => { en: "a chunk has no size, or numbers of another", ko: "청크의 크기가 없거나 수의 크기가 다르다" },
        ChunkTree => { en: "a node of the tree of chunks has no mark, or another level", ko: "청크 트리의 노드에 표시가 없거나 단계가 다르다" },
        ChunksMeet => { en: "two chunks begin at one place", ko: "두 청크가 같은 자리에서 시작한다" },
        ChunkPlace => { en: "a chunk begins where none can", ko: "청크가 시작할 수 없는 자리에서 시작한다" },
        ByteOrder => { en: "the mark of the byte order is none", ko: "바이트 순서 표시가 올바르지 않다" },
        NotMat5 => { en: "the version is not that of MAT 5", ko: "MAT 5의 버전이 아니다" },
        NoWholeHead => { en: "the packed variable before this place has no whole head", ko: "이 자리 앞의 압축된 변수에 온전한 머리글이 없다" },
        ShortForm => { en: "an element in short form is longer than 4 bytes", ko: "짧은 형식의 요소가 4바이트보다 길다" },
        Dimensions => { en: "the dimensions of a matrix are no integers of 32 bits", ko: "행렬의 크기가 32비트 정수가 아니다" },
        ObjectHeader => { en: "an object header has neither mark nor version 1", ko: "객체 머리글에 표시도 버전 1도 없다" },
        FurtherBlock => { en: "a further block of an object header has no mark", ko: "객체 머리글의 다음 블록에 표시가 없다" },
        NoHdf5 => { en: "there is no HDF5 behind MATLAB's header", ko: "MATLAB 머리글 뒤에 HDF5가 없다" },
        AddressSizes => { en: "addresses and lengths have other sizes than 8 bytes", ko: "주소와 길이가 8바이트가 아니다" },
        HeapOfNames => { en: "a heap of names has no mark", ko: "이름 힙에 표시가 없다" },
        NodeOfNames => { en: "a node of names has no mark", ko: "이름 노드에 표시가 없다" },
        TreeOfNames => { en: "a node of the tree of names has no mark, or another level", ko: "이름 트리의 노드에 표시가 없거나 단계가 다르다" },
        NameWithoutEnd => { en: "a name has no end", ko: "이름의 끝이 없다" },
        FirstDifference => { en: "the first difference of the block is not 0", ko: "블록의 첫 차이가 0이 아니다" },
        NoBlockHolds => { en: "no block holds samples", ko: "자료가 있는 블록이 없다" },
        ItHoldsMore => { en: "it holds more than it says", ko: "적힌 것보다 길다" },
        WrongSum => { en: "its sum is wrong", ko: "체크섬이 틀리다" },
        EndsTooEarly => { en: "it ends too early", ko: "너무 일찍 끝난다" },
        NoCodes => { en: "its codes are none", ko: "코드가 올바르지 않다" },
        HeadersOfObjects => { en: "headers of objects", ko: "객체의 머리글" },
        Trees => { en: "trees", ko: "트리" },
        NumbersOfVariables => { en: "numbers of variables", ko: "변수의 수" },
        PathBytes(bytes: usize) => {
            en: "a path has {bytes} bytes",
            ko: "경로가 {bytes}바이트이다",
        },
        OneDimension(path: String) => {
            en: "the samples of {path} are not described as numbers of one dimension",
            ko: "{path}의 자료가 1차원의 수로 설명되어 있지 않다",
        },
        PropertyType(code: String) => {
            en: "a property has type {code}, which is none",
            ko: "속성의 종류가 {code}인데 그런 종류는 없다",
        },
        NoWholeChunks(bytes: usize) => {
            en: "{bytes} bytes of samples are no whole chunks of the objects described: was it cut short?",
            ko: "자료 {bytes}바이트가 설명된 채널의 청크 수에 맞지 않는다. 파일이 잘렸는가?",
        },
        NoWholeFrames { bytes: usize, frame: usize } => {
            en: "{bytes} bytes of samples are no whole frames of {frame}",
            ko: "자료 {bytes}바이트가 {frame}바이트 프레임의 배수가 아니다",
        },
        FramesDisagree { channels: usize, rate_hz: f64, frame: usize } => {
            en: "{channels} channels, {rate_hz} Hz and {frame} bytes a frame do not agree",
            ko: "채널 {channels}개, {rate_hz} Hz, 프레임 {frame}바이트가 서로 맞지 않는다",
        },
        MatrixNumbers { rows: usize, columns: usize } => {
            en: "a matrix has {rows} × {columns} numbers",
            ko: "행렬의 수가 {rows} × {columns}개이다",
        },
        BytesHold { bytes: u64, rows: usize, columns: usize } => {
            en: "{bytes} bytes hold {rows} × {columns} numbers",
            ko: "{rows} × {columns}개의 수가 {bytes}바이트이다",
        },
        ChunksMissing { rows: usize, columns: usize, chunks: usize, high: usize, wide: usize } => {
            en: "a matrix of {rows} × {columns} numbers has {chunks} chunks of {high} × {wide}: a part was never written",
            ko: "{rows} × {columns}개 수의 행렬에 {high} × {wide} 청크가 {chunks}개이다. 기록되지 않은 부분이 있다",
        },
        ChunkPacked { whole: usize, packed: usize } => {
            en: "a chunk of {whole} bytes is packed into {packed}",
            ko: "{whole}바이트의 청크가 {packed}바이트로 압축되어 있다",
        },
        ChunkDoesNotUnpack(why: Both) => {
            en: "a chunk does not unpack: {why}",
            ko: "청크의 압축을 풀 수 없다: {why}",
        },
        ChunkUnpacks { whole: usize, unpacked: usize } => {
            en: "a chunk of {whole} bytes unpacks to {unpacked}",
            ko: "{whole}바이트의 청크가 {unpacked}바이트로 풀린다",
        },
        VariableDoesNotUnpack { name: String, why: Both } => {
            en: "the packed variable {name} does not unpack: {why}",
            ko: "압축된 변수 {name}을(를) 풀 수 없다: {why}",
        },
        BeforeDoesNotUnpack(why: Both) => {
            en: "the packed variable before this place does not unpack: {why}",
            ko: "이 자리 앞의 압축된 변수를 풀 수 없다: {why}",
        },
        ElementType(sort: u32) => {
            en: "the element before this place has type {sort}, which is no variable",
            ko: "이 자리 앞의 요소는 종류가 {sort}이어서 변수가 아니다",
        },
        Side(side: String) => {
            en: "a side of a matrix is {side}",
            ko: "행렬의 한 변이 {side}이다",
        },
        ValueType { name: String, sort: u32 } => {
            en: "the values of {name} have type {sort}, which is none",
            ko: "{name}의 값의 종류가 {sort}인데 그런 종류는 없다",
        },
        ValueBytes { name: String, rows: usize, columns: usize, bytes: usize } => {
            en: "{name} is {rows} × {columns}, but holds {bytes} bytes of values",
            ko: "{name}은(는) {rows} × {columns}인데 값이 {bytes}바이트이다",
        },
        Address(address: String) => {
            en: "an address is {address}",
            ko: "주소가 {address}이다",
        },
        Circle(what: Both) => {
            en: "{what} run in a circle, or lie on one another",
            ko: "{what}이(가) 서로 맞물려 끝나지 않거나 겹쳐 있다",
        },
        FirstBlock(version: u8) => {
            en: "version {version} of HDF5's first block is not known",
            ko: "알 수 없는 HDF5 첫 블록의 버전 {version}이다",
        },
        BlockHeader { second: String, part: String, parts: String, packed: String, words: String } => {
            en: "no header of a block: second {second} of the day, part {part} of {parts}, compression {packed}, {words} words",
            ko: "블록의 머리글이 아니다. 하루 중 {second}초, {parts} 중 {part}번째, 압축 {packed}, {words}워드",
        },
        BlockEnd { value: String, last: String } => {
            en: "the block ends at {value}, but states {last} as its last sample",
            ko: "블록이 {value}(으)로 끝나는데 마지막 자료는 {last}이라고 적혀 있다",
        },
    }
}
