//! Errors of numerical methods and matrices, in Korean.

use super::phrase::phrase;
use crate::errors::korean_of;
use dolmen::numeric::NumericError;
use dolmen_linalg::LinalgError;

korean_of! {
    NumericError {
        NumericError::Range { quantity, given, allowed } => "{quantity}이(가) {given}인데 {allowed}이어야 한다", quantity = phrase(quantity), allowed = phrase(allowed);
        NumericError::Count { quantity, given, least, most } => "{quantity}이(가) {given}인데 {least}~{most}이어야 한다", quantity = phrase(quantity);
        NumericError::NotFinite { quantity, number, given } => "{quantity}의 {number}번 값이 {given}인데 유한한 수이어야 한다", quantity = phrase(quantity);
        NumericError::NoSignChange { a, b, at_a, at_b } => "부호가 바뀌지 않는다. 함숫값이 {a}에서 {at_a}, {b}에서 {at_b}이다. 부호가 다른 양 끝을 고른다";
        NumericError::NotANumber { x } => "{x}에서 함숫값이 수가 아니다";
        NumericError::Evaluations { most } => "계산 {most}번 안에 근을 찾지 못했다. evaluations_most나 width_most를 키운다";
    }
}

korean_of! {
    LinalgError {
        LinalgError::NotFinite { what, row, column, value } => "{what}: {row}행 {column}열의 값이 {value}인데 모든 값이 유한한 수이어야 한다", what = phrase(what);
        LinalgError::Shape { what, rows, columns, needed } => "{what}: 행렬이 {rows} × {columns}인데 {needed}이어야 한다", needed = phrase(needed), what = phrase(what);
        LinalgError::NotPositiveDefinite { what } => "{what}: 행렬이 양의 정부호가 아니다", what = phrase(what);
        LinalgError::Singular { what } => "{what}: 행렬이 계산 정밀도로 특이하다", what = phrase(what);
        LinalgError::NoConvergence { what } => "{what}: 반복 계산이 수렴하지 않았다", what = phrase(what);
    }
}
