//! Reads directions in space.

use super::error::Fault;
use super::file_number::At;
use super::file_way::WayRaw;
use super::reader::Reader;
use super::wrong::WrongNumber;

pub(super) fn direction_vector(reader: &mut Reader, raw: &At<WayRaw>, path: &str) -> Option<[f64; 3]> {
    let vector = match &raw.value {
        WayRaw::Axis(axis) => {
            let (sign, letter) = match axis.strip_prefix('-') {
                Some(letter) => (-1.0, letter),
                None => (1.0, axis.strip_prefix('+').unwrap_or(axis)),
            };
            match letter {
                "x" => Some([sign, 0.0, 0.0]),
                "y" => Some([0.0, sign, 0.0]),
                "z" => Some([0.0, 0.0, sign]),
                _ => None,
            }
        }
        WayRaw::Vector(numbers) => unit_vector(numbers),
    };
    if vector.is_none() {
        let fault = Fault::new(
            raw.span.clone(),
            path,
            WrongNumber::IsNotDirection(path.to_string()),
        );
        reader.fault(fault.allowed(WrongNumber::MustBeXX));
    }
    vector
}

fn unit_vector(numbers: &[f64]) -> Option<[f64; 3]> {
    let &[x, y, z] = numbers else {
        return None;
    };
    let length = (x * x + y * y + z * z).sqrt();
    (length > 0.0 && length.is_finite()).then(|| [x / length, y / length, z / length])
}
