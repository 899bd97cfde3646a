//! Role of a stack's side supports in its natural frequencies.

use dolmen::blocks::BesideInSmallMotion;
use dolmen_words::messages;

messages! {
    /// Side supports in small motion.
    pub(crate) enum Beside in "stack.beside" {
        Springs { supports: usize } => {
            en: "Side supports that the natural frequencies count as springs, with the stiffness of the file: {supports}. Thresholds leave them out.",
            ko: "고유진동수에 스프링으로 반영한 측면 지지: {supports}개(파일의 강성). 거동 시작 가속도 등 판정에는 반영하지 않는다.",
        },
        OneWay { supports: usize } => {
            en: "Side supports that push in one half of each swing alone (no gap, not pressed at rest, none as stiff opposite): {supports}. The natural frequencies here are those without them; the true ones are higher, and what a survey measures of them is no stiffness of the joints.",
            ko: "진동의 한쪽 반주기에만 닿는 측면 지지(간격이 없고 정지 상태에서 눌리지 않으며 맞은편에 같은 강성의 지지가 없음): {supports}개. 여기의 고유진동수는 이 지지를 뺀 값이고 실제 값은 더 높으므로, 계측값에서 접합부 강성을 곧바로 알 수 없다.",
        },
        Gap { supports: usize } => {
            en: "Side supports with a gap, which the natural frequencies leave out: {supports}. That holds for motion smaller than the gap; where the gap has closed, measured frequencies are higher and the joints are not as stiff as they seem.",
            ko: "간격이 있어 고유진동수에서 뺀 측면 지지: {supports}개. 진동이 간격보다 작을 때의 값이며, 실제로 간격이 막혀 있으면 계측 진동수가 더 높고 접합부 강성은 그만큼 크지 않다.",
        },
    }
}

/// Each kind present, springs first.
pub(crate) fn beside(all: &[BesideInSmallMotion]) -> Vec<Beside> {
    let count = |which: &dyn Fn(BesideInSmallMotion) -> bool| all.iter().filter(|of| which(**of)).count();
    let springs = count(&BesideInSmallMotion::is_spring);
    let one_way = count(&|of| of == BesideInSmallMotion::OneWay);
    let gap = count(&|of| of == BesideInSmallMotion::Gap);
    let each = [
        (springs > 0).then_some(Beside::Springs { supports: springs }),
        (one_way > 0).then_some(Beside::OneWay { supports: one_way }),
        (gap > 0).then_some(Beside::Gap { supports: gap }),
    ];
    each.into_iter().flatten().collect()
}
