//! Errors of stacks, in Korean.

use super::phrase::phrase;
use crate::errors::korean_of;
use dolmen::structure::stack::{SliceError, StackError};

korean_of! {
    StackError {
        StackError::Empty => "쌓은 블록이 하나 이상 있어야 한다";
        StackError::Name { name } => "이름이 '{name}'인 블록이 둘이다. 서로 다른 이름을 붙인다";
        StackError::Far { piece, position_m, beyond_m, block, allowed_m } => "{piece}의 position_m이 {position_m:?}(으)로 {block}에서 {beyond_m:.3} m 떨어져 있다. 해당 부재에서 {allowed_m} m 이내이어야 한다. mm 단위이거나 기준점이 다른가?", piece = phrase(piece);
        StackError::Dimension { quantity, given, allowed } => "{quantity}이(가) {given}인데 {allowed}이어야 한다", quantity = phrase(quantity), allowed = phrase(allowed);
        StackError::Sides { given, most } => "각기둥의 변이 {given}개인데 3~{most}개이어야 한다. 그보다 많으면 원통으로 한다";
        StackError::Opening { corner, beyond_m } => "개구부는 석재 안에 있고 석재가 남아야 하는데, 모서리 {corner:?}이(가) {beyond_m:.4} m 밖에 있다. 크기와 위치를 확인한다";
        StackError::Openings { depth_m } => "한 석재의 개구부 둘이 {depth_m:.4} m 겹쳐 겹친 부분이 두 번 빠진다. 옮기거나 하나로 합친다";
        StackError::Points { given } => "볼록 입체에는 점이 4개 이상 필요한데 {given}개이다";
        StackError::Flat { size_m, allowed_m } => "점들이 평평하다. {allowed_m:.6} m 이내에서 한 평면이나 {size_m} m 길이의 직선 위에 있다. 석재에는 두께가 있어야 한다";
        StackError::MeshIndex { triangle, given, vertices } => "메시의 삼각형 {triangle}에 꼭짓점 {given}이(가) 쓰였는데 꼭짓점은 0부터 {vertices}개이다";
        StackError::MeshTriangle { triangle, corners, at_m } => "메시의 삼각형 {triangle}의 두 꼭짓점이 {at_m:?} 부근에서 같은 자리에 있다(꼭짓점 {corners:?}). 그런 삼각형을 삭제한다";
        StackError::MeshEdge { fault, from, from_m, to, to_m, triangles, count, remedy } => "{fault}: 꼭짓점 {from} {from_m:?}에서 꼭짓점 {to} {to_m:?}까지의 모서리에 삼각형이 2개가 아니라 {triangles}개 붙어 있다. 그런 모서리 {count}개 중 첫째이다. {remedy}", fault = phrase(fault), remedy = phrase(remedy);
        StackError::MeshTurned { from, from_m, to, to_m, count } => "메시의 두 삼각형의 바깥쪽이 서로 맞지 않는다. 둘 다 꼭짓점 {from} {from_m:?}에서 꼭짓점 {to} {to_m:?}(으)로 돈다. 그런 모서리 {count}개 중 첫째이다. 삼각형의 방향을 맞춘다";
        StackError::MeshPieces { count, largest, smallest } => "메시가 {count}조각이다(삼각형 {largest}개부터 {smallest}개까지). 하나만 남기거나 조각마다 석재로 나눈다";
        StackError::MeshInverted { volume_m3 } => "메시가 뒤집혀 있다. 부피가 {volume_m3:.6} m³이다. 모든 삼각형의 방향을 뒤집는다";
        StackError::MeshOverfull { volume_m3, hull_volume_m3 } => "메시가 스스로를 뚫고 지나간다. 부피 {volume_m3:.6} m³가 볼록 껍질의 {hull_volume_m3:.6} m³보다 크다. 메시를 고친다";
        StackError::MeshHull { filled, allowed } => "석재가 볼록 껍질의 {filled:.1} %만 채운다. 흩어진 석재는 볼록 껍질로 닿으므로 {allowed:.0} % 이상이어야 한다. 볼록한 부분으로 나눈다", filled = 100.0 * filled, allowed = 100.0 * allowed;
        StackError::MeshBent { at_m, off_m, corners } => "메시의 한 면이 평면을 이루지 않는다. 꼭짓점 {corners}개 중 {at:?}의 점이 나머지의 평면에서 {off_mm:.1} mm 벗어나 있고, 점이 적어 오차가 평균되지 않는다. 이 면을 더 촘촘히 스캔하거나 석재를 box, frustum, 점의 입체로 입력한다", off_mm = 1e3 * off_m, at = at_m.map(|m| (1e4 * m).round() / 1e4);
        StackError::MeshUneven { noise_m, volume_m3, .. } => "메시의 표면이 고르지 않다({scatter}). 평평한 면들이 메시의 부피 {volume_m3:.5} m³를 둘러싸지 못한다. 볼록하지 않거나, 접합면을 찾기에 너무 닳았거나 휘었다. 볼록한 부분으로 나누거나, 접합면을 더 촘촘히 스캔하거나, box, frustum, 점의 입체로 입력한다", scatter = noise_m.map_or("꼭짓점이 적어 흩어짐을 알 수 없음".to_owned(), |noise_m| format!("꼭짓점의 흩어짐 {:.2} mm", 1e3 * noise_m));
        StackError::JointUsed { upper, lower, used, allowed } => "'{upper}'와(과) '{lower}'의 접합면: 겹치는 면의 {used:.0} %만 평평한데 {allowed:.0} % 이상이어야 한다. 접합면을 더 촘촘히 스캔하거나 석재를 점의 입체로 입력한다", used = 100.0 * used, allowed = 100.0 * allowed, lower = phrase(lower);
        StackError::JointRounded { upper, lower, rounded, radius_m } => "'{lower}' 위의 '{upper}': '{rounded}'이(가) 접합면이 아니라 둥근 면(곡률 반지름 {radius_m:.2} m)으로 닿아 어떤 가속도에서도 구른다. 모르타르에 앉혀 있으면 box, frustum, 점의 입체로 입력하고, 쐐기가 받치면 쐐기도 블록으로 입력한다", lower = phrase(lower);
        StackError::JointFacets { upper, lower, share, allowed } => "'{upper}'와(과) '{lower}'이(가) 여러 면에서 닿는데 가장 큰 면이 접촉 면적의 {share:.0} %이다. {allowed:.0} % 이상이어야 한다. 각 접합면의 점을 1, 0.1 또는 0.01 mm로 반올림해 한 평면에 두거나 단순한 형상으로 입력한다", share = 100.0 * share, allowed = 100.0 * allowed, lower = phrase(lower);
        StackError::JointHollow { upper, lower, area, area_allowed, outline, outline_allowed } => "'{lower}' 위의 '{upper}': 볼록 껍질이 닿는 면적 중 {area:.1} %에서만 석재끼리 닿고({area_allowed:.0} % 이상이어야 한다) 그 외곽선은 {outline:.1} %에 걸친다({outline_allowed:.1} % 이상이어야 한다). 둘 중 하나가 그곳에서 볼록하지 않거나 개구부가 접합면에 닿는다. 볼록한 부분으로 나누어 각각 블록으로 입력한다", area = 100.0 * area, area_allowed = 100.0 * area_allowed, outline = 100.0 * outline, outline_allowed = 100.0 * outline_allowed, lower = phrase(lower);
        StackError::CutAway { point_m, normal } => "법선이 {normal:?}이고 {point_m:?}을(를) 지나는 평면 뒤로 석재가 남지 않는다. 평면을 옮기거나 법선을 뒤집는다";
        StackError::OpeningInMesh { area_m2 } => "개구부가 석재 안에 있지 않다. 메시 표면의 {area_m2:.6} m²가 개구부 안에 있다";
        StackError::Pagoda { quantity, given, allowed } => "{quantity}이(가) {given:.4}인데 이 석탑의 다른 인자에서는 한계가 {allowed:.4}이다. 이 값이나 다른 인자를 바꾼다", quantity = phrase(quantity);
        StackError::NotPositive { part, quantity, given } => "{part}: {quantity}이(가) {given}인데 양수이어야 한다", quantity = phrase(quantity);
        StackError::Material { quantity, given, allowed } => "접합면의 {quantity}이(가) {given}인데 {allowed}이어야 한다", quantity = phrase(quantity), allowed = phrase(allowed);
        StackError::Overlap { first, second, depth_m, allowed_m } => "'{first}'와(과) '{second}'이(가) {depth_m:.4} m 겹치는데 석재는 닿기만 할 수 있다({allowed_m} m 이내). 크기와 위치를 확인한다";
        StackError::BedsNotParallel { block, lower, angle_deg, far_m, allowed_m } => "'{block}'이(가) {lower} 위에 놓이지 않는다. 두 접합면이 평행하지 않고 {angle_deg:.2}° 벌어져 먼 쪽 모서리가 {far_m:.4} m 떠 있다. 접합면의 가운데는 {allowed_m} m 이내이어야 한다. 좌표를 확인하거나 사이의 쐐기를 블록으로 준다", lower = phrase(lower);
        StackError::Floating { block, nearest, apart_m: [x_m, y_m, z_m], above_ground_m, allowed_m } => "'{block}'이(가) 떠 있다. {off}지반에서 {above_ground_m:.4} m 위에 있다. 접합면은 {allowed_m} m 이내이어야 한다", off = nearest.as_ref().map_or(String::new(), |stone| format!("{stone}의 윗면에서 x축으로 {x_m:.4} m, y축으로 {y_m:.4} m, z축으로 {z_m:.4} m 떨어져 있고 "));
        StackError::NotOnGround { block, on_ground } => "'{block}' 아래의 지반이 움직인다고 했는데 이 부재는 지반 위에 있지 않다. 지반 위에 있는 부재의 이름을 쓴다({on_ground})", on_ground = on_ground.join(", ");
        StackError::SoilUnderSeveral { count } => "지반(soil)은 기초 하나에 대한 값인데 지반 위의 접합면이 {count}개이다. 모두를 받치는 부재 하나를 두거나 soil을 뺀다";
        StackError::NoBlock { given, last } => "블록 {given}이(가) 없다. 0~{last}번이 있다";
        StackError::NoJoint { given, count } => "접합면 {given}이(가) 없다. 접합면은 {count}개이다";
        StackError::Direction { quantity, given } => "{quantity}이(가) {given:?}인데 유한한 수의 벡터이고 모두 0이 아니어야 한다", quantity = phrase(quantity);
        StackError::Position { quantity, given } => "{quantity}이(가) {given:?}인데 유한한 수 세 개이어야 한다", quantity = phrase(quantity);
    }
}

korean_of! {
    SliceError {
        SliceError::NoBeds => "접합면의 높이가 없다. 탑에는 석재 사이의 접합면이 하나 이상 있다. 각 접합면의 높이를 쓴다";
        SliceError::NotFinite { given } => "접합면의 높이가 {given}인데 유한한 수(m)이어야 한다";
        SliceError::Unsorted { first_m, then_m } => "접합면 {then_m} m이(가) {first_m} m 뒤에 있다. 낮은 것부터 한 번씩 쓴다";
        SliceError::Outside { bed_m, low_m, high_m } => "접합면 {bed_m} m이(가) {low_m:.4}~{high_m:.4} m에 걸친 스캔 밖에 있다. 파일의 좌표(z축이 위쪽)에서 잰 높이를 m로 쓴다";
        SliceError::Thin { low_m, high_m, least_m } => "{low_m:.4}~{high_m:.4} m의 석재 두께가 {thickness_mm:.1} mm인데 {least_mm:.0} mm 이상이어야 한다. 접합면 하나를 뺀다", thickness_mm = 1e3 * (high_m - low_m), least_mm = 1e3 * least_m;
        SliceError::Air { bed_m } => "접합면으로 쓴 높이 {bed_m} m에 석재가 없다. 높이를 고친다";
        SliceError::Hollow { bed_m, area_m2 } => "높이 {bed_m} m의 단면에 {area_m2:.4} m²의 구멍이 있다. 빈 곳을 둘러싼 접합면은 자르지 않는다. 메시의 빈 곳을 메우거나 석재를 점의 입체로 입력한다";
        SliceError::Crossed { bed_m } => "높이 {bed_m} m의 단면 외곽선이 스스로 만나거나 교차한다. 접합면을 몇 mm 옮기거나 그곳의 메시를 고친다";
        SliceError::Corners { bed_m, given, most } => "높이 {bed_m} m의 단면에 모서리점이 {given}개 있는데 {most}개까지 자른다. 메시를 성기게 만든다(모서리 길이 5~50 mm면 충분하다)";
        SliceError::Void { volume_m3 } => "메시의 닫힌 조각 하나가 안팎이 뒤집혀 있다({size_m3:.6} m³). 석재 안에 있는 면을 삭제하거나 그 삼각형의 방향을 뒤집는다", size_m3 = volume_m3.abs();
        SliceError::Volume { ratio, whole_m3, allowed } => "석재의 부피 합이 스캔 부피 {whole_m3:.5} m³의 {percent:.2} %인데 100 ± {allowed:.1} %이어야 한다. 접합면 부근의 스캔이 자르기에 너무 거칠거나 스스로를 뚫고 지나간다", percent = 100.0 * ratio, allowed = 100.0 * allowed;
    }
    handed on SliceError::Mesh(why) => why;
}
