//! Compares units in column names with each other and with the given unit.

use super::unit::unit_of_label;
use super::{FileUnit, RecordError};
use crate::unit::Unit;
use dolmen::signal::Quantity;

/// A column that is read.
#[derive(Clone, Copy, Debug)]
pub(super) struct NamedColumn<'a> {
    pub(super) name: &'a str,
    /// Whether it has its own scale, which converts its numbers to the unit of the record whatever its name says.
    pub(super) is_scaled: bool,
}

/// The text in brackets at the end of a column name: "ax [mg]", "x (m/s2)", "3층 가속도(gal)".
pub(crate) fn unit_in_name(name: &str) -> FileUnit {
    let inside = name.trim_end().strip_suffix([']', ')', '）']);
    let Some((_, unit)) = inside.and_then(|inside| inside.rsplit_once(['[', '(', '（'])) else {
        return FileUnit::Silent;
    };
    unit_of_label(unit)
}

/// Refuses columns whose names contradict the given unit or, without one, the name of another column.
///
/// # Errors
/// [`RecordError::ColumnUnitDisagrees`], [`RecordError::ColumnUnitsDiffer`]; [`RecordError::NoScale`] where a name says "V", "mV" or "counts"
/// and a unit is given without a scale.
pub(super) fn refuse_other_units(
    columns: &[NamedColumn<'_>],
    given: Unit,
    scales_all: bool,
) -> Result<(), RecordError> {
    let mut first: Option<(&str, Unit)> = None;
    for column in columns.iter().filter(|column| !column.is_scaled) {
        let found = match unit_in_name(column.name) {
            FileUnit::Known(found) => found,
            FileUnit::Other(found) if is_raw(&found) && given != Unit::Unknown && !scales_all => {
                return Err(RecordError::NoScale {
                    format: "csv",
                    channel: column.name.to_owned(),
                    found,
                    given: given.symbol(),
                });
            }
            _ => continue,
        };
        if let (false, Some(scale)) = (scales_all, contradiction(found, given)) {
            return Err(RecordError::ColumnUnitDisagrees {
                column: column.name.to_owned(),
                found: found.symbol(),
                given: given.symbol(),
                scale,
            });
        }
        match first {
            None => first = Some((column.name, found)),
            Some((other, unit)) => {
                if let Some(scale) = contradiction(found, unit) {
                    return Err(RecordError::ColumnUnitsDiffer {
                        column: column.name.to_owned(),
                        found: found.symbol(),
                        other: other.to_owned(),
                        unit: unit.symbol(),
                        scale,
                    });
                }
            }
        }
    }
    Ok(())
}

/// Whether it is a unit of recorders, or of something else than the motions that a record holds; brackets may also contain positions and axes.
fn is_raw(label: &str) -> bool {
    const RAW: [&str; 22] = [
        "v",
        "mv",
        "uv",
        "volt",
        "volts",
        "볼트",
        "밀리볼트",
        "counts",
        "count",
        "카운트",
        "um",
        "㎛",
        "마이크로미터",
        "deg",
        "°",
        "도",
        "rad",
        "mrad",
        "°c",
        "℃",
        "pa",
        "kpa",
    ];
    let plain = label.trim().to_lowercase().replace(['µ', 'μ'], "u");
    RAW.contains(&plain.as_str())
}

/// Factor from one unit to the other, if they differ; `Some(None)` if they measure different quantities.
fn contradiction(found: Unit, other: Unit) -> Option<Option<f64>> {
    if other == Unit::Unknown || (found.si() == other.si() && found.quantity() == other.quantity()) {
        return None;
    }
    let is_one_quantity = found.quantity() == other.quantity() && found.quantity() != Quantity::Unknown;
    Some(is_one_quantity.then(|| found.si() / other.si()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn exact_units_at_the_end_of_names() {
        for (name, unit) in [
            ("3층 가속도(gal)", Unit::Gal),
            ("ax [mg]", Unit::MilliGravity),
            ("x (m/s²) ", Unit::MetrePerSecondSquared),
            ("가속도（g）", Unit::Gravity),
            ("a (G)", Unit::Gravity),
            ("a (GAL)", Unit::Gal),
            ("a(㎨)", Unit::MetrePerSecondSquared),
            ("v [cm/sec]", Unit::CentimetrePerSecond),
        ] {
            assert_eq!(unit_in_name(name), FileUnit::Known(unit), "{name}");
        }
        for (name, unit) in [
            ("가속도(갈)", Unit::Gal),
            ("가속도(㎎)", Unit::MilliGravity),
            ("가속도(밀리지)", Unit::MilliGravity),
            ("속도(μm/s)", Unit::MicrometrePerSecond),
            ("변위(밀리미터)", Unit::Millimetre),
        ] {
            assert_eq!(unit_in_name(name), FileUnit::Known(unit), "{name}");
        }
        assert_eq!(unit_in_name("g"), FileUnit::Silent);
        assert_eq!(unit_in_name("roof (north)"), FileUnit::Other("north".into()));
    }

    #[test]
    fn refuses_columns_in_units_of_recorders_and_of_other_quantities_where_a_unit_is_given() {
        let of = |name| {
            let column = NamedColumn {
                name,
                is_scaled: false,
            };
            refuse_other_units(&[column], Unit::MilliGravity, false)
        };
        // micro is U+03BC here and U+00B5 there
        for name in [
            "하층(볼트)",
            "하층(카운트)",
            "하층(μm)",
            "하층(µm)",
            "하층(㎛)",
            "하층(도)",
            "a(Volts)",
        ] {
            assert!(matches!(of(name), Err(RecordError::NoScale { .. })), "{name}");
        }
        assert!(matches!(
            of("하층(갈)"),
            Err(RecordError::ColumnUnitDisagrees { .. })
        ));
        for name in ["하층(㎎)", "하층(북)", "roof (north)", "a (N)", "x (2)"] {
            assert!(of(name).is_ok(), "{name}");
        }
    }
}
