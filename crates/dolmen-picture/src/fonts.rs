//! The fonts of reports and pictures.

/// Pretendard 1.3.9, Regular, SemiBold and Bold (SIL Open Font License 1.1).
pub const FONTS: [&[u8]; 3] = [
    include_bytes!("../../../data/fonts/Pretendard-Regular.otf"),
    include_bytes!("../../../data/fonts/Pretendard-SemiBold.otf"),
    include_bytes!("../../../data/fonts/Pretendard-Bold.otf"),
];
