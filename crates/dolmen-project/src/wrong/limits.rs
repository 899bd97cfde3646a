//! Errors of allowable drifts.

use dolmen_words::messages;

messages! {
    /// Errors of allowable drifts.
    pub(crate) enum WrongLimits in "project.error.limits" {
        LimitsHoldsAllowableDrifts => {
            en: "[limits] holds allowable drifts of storeys, which this kind does not have",
            ko: "[limits]는 층의 허용 층간변위인데 이 종류의 구조물에는 층이 없다",
        },
        TakeItOutJoints => {
            en: "take it out: joints and stones have limits of their own",
            ko: "삭제한다. 접합면과 석재에는 별도의 한계가 있다",
        },
        LimitsHasBothCode => {
            en: "limits has both code and storey_drift",
            ko: "limits에 code와 storey_drift가 모두 있다",
        },
        LimitsHasNeitherCode => {
            en: "limits has neither code nor storey_drift",
            ko: "limits에 code도 storey_drift도 없다",
        },
        WriteCodeKdsWith => {
            en: "write code = \"KDS 41 17 00\" with importance = \"special\", \"I\" or \"II\", or storey_drift = \"1.5 %\"",
            ko: "code = \"KDS 41 17 00\"을 importance = \"special\", \"I\" 또는 \"II\"와 함께 쓰거나 storey_drift = \"1.5 %\"를 쓴다",
        },
        LimitsGoesWithCode { key: String } => {
            en: "limits.{key} goes with a code, but limits has storey_drift",
            ko: "limits.{key}은(는) code와 함께 쓰는데 limits에 storey_drift가 있다",
        },
        IsOfHeight { key: String, ratio: String } => {
            en: "{key} is {ratio} of the height",
            ko: "{key}이(가) 층고의 {ratio}이다",
        },
        MustBeAtMost => {
            en: "must be at most 10 %: no storey is known to stand beyond",
            ko: "10 % 이하이어야 한다. 그보다 큰 층간변위를 견딘 예는 없다",
        },
        DidYouMeanPer => {
            en: "did you mean per cent? \"1.5 %\" is 0.015",
            ko: "백분율인가? \"1.5 %\"는 0.015이다",
        },
        MustBeSpecialI => {
            en: "must be \"special\", \"I\" or \"II\" with KDS 41 17 00",
            ko: "KDS 41 17 00에서는 \"special\", \"I\" 또는 \"II\"이어야 한다",
        },
        MustBeIIi => {
            en: "must be \"I\", \"II\", \"III\" or \"IV\" with EN 1998-1",
            ko: "EN 1998-1에서는 \"I\", \"II\", \"III\" 또는 \"IV\"이어야 한다",
        },
        LimitsHasNoImportance => {
            en: "limits has no \"importance\", but its code needs it",
            ko: "limits의 code에 필요한 \"importance\"가 없다",
        },
        WriteImportanceI => { en: "write importance = \"I\"", ko: "importance = \"I\"를 쓴다" },
        LimitsNonStructuralHas => {
            en: "limits.non_structural has no meaning with code = \"KDS 41 17 00\"",
            ko: "limits.non_structural은 code = \"KDS 41 17 00\"에서 쓰지 않는다",
        },
        ThisClassIsOf => { en: "this class is of another code", ko: "다른 기준의 등급이다" },
    }
}
