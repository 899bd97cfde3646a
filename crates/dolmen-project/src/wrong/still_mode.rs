//! Why a damper has no mode for its tuning, in both languages.

use dolmen_words::messages;

messages! {
    /// The motion of a mode at the place of a damper.
    pub(crate) enum StillMode in "project.fault.mode" {
        TurnsAboutIt => { en: "it turns about that place", ko: "그 위치를 중심으로 돈다" },
        OnlyInX => { en: "it moves only in x here", ko: "이 위치에서는 x 방향으로만 움직인다" },
        OnlyInY => { en: "it moves only in y here", ko: "이 위치에서는 y 방향으로만 움직인다" },
        Across => { en: "it moves across that direction", ko: "그 방향에 직각으로 움직인다" },
    }
}
