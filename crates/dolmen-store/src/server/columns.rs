//! Converts values to parameters of a statement, and columns of a row to values.

use crate::database::Value;
use crate::error::StoreError;
use crate::incoming::shown;
use dolmen_work::kept::StoreFault;
use postgres::types::{ToSql, Type};
use postgres::{Row, Statement};

type Parameter = Box<dyn ToSql + Sync>;

fn wrong_kind(of: &Type) -> StoreError {
    let why = format!("a value of another kind than {}", of.name());
    StoreFault::Damaged { why }.into()
}

/// The parameters of a statement, with its types.
pub(crate) fn parameters(statement: &Statement, values: &[Value]) -> Result<Vec<Parameter>, StoreError> {
    let types = statement.params();
    if types.len() != values.len() {
        let why = format!("{} values for {} parameters", values.len(), types.len());
        return Err(StoreFault::Failed { why }.into());
    }
    values
        .iter()
        .zip(types)
        .map(|(value, of)| parameter(value, of))
        .collect()
}

fn parameter(value: &Value, of: &Type) -> Result<Parameter, StoreError> {
    let is_text = [Type::TEXT, Type::VARCHAR, Type::NAME].contains(of);
    Ok(match value {
        Value::Text(text) if text.contains('\0') => {
            let shown = shown(text);
            return Err(StoreFault::ZeroByte { shown }.into());
        }
        Value::Text(text) if is_text => Box::new(text.clone()),
        Value::Whole(whole) if *of == Type::INT8 => Box::new(*whole),
        Value::Number(number) if *of == Type::FLOAT8 => Box::new(*number),
        Value::Null if is_text => Box::new(None::<String>),
        Value::Null if *of == Type::INT8 => Box::new(None::<i64>),
        Value::Null if *of == Type::FLOAT8 => Box::new(None::<f64>),
        _ => return Err(wrong_kind(of)),
    })
}

/// The values of a row.
pub(crate) fn own_row(row: &Row) -> Result<Vec<Value>, StoreError> {
    (0..row.len()).map(|at| own_value(row, at)).collect()
}

fn own_value(row: &Row, at: usize) -> Result<Value, StoreError> {
    let of = row.columns()[at].type_();
    let unread = |_: postgres::Error| wrong_kind(of);
    let whole = |whole: Option<i64>| whole.map_or(Value::Null, Value::Whole);
    Ok(match *of {
        Type::INT8 => whole(row.try_get(at).map_err(unread)?),
        Type::INT4 => whole(row.try_get::<_, Option<i32>>(at).map_err(unread)?.map(i64::from)),
        Type::BOOL => whole(row.try_get::<_, Option<bool>>(at).map_err(unread)?.map(i64::from)),
        Type::FLOAT8 => {
            let number: Option<f64> = row.try_get(at).map_err(unread)?;
            number.map_or(Value::Null, Value::Number)
        }
        Type::TEXT | Type::VARCHAR | Type::NAME => {
            let text: Option<String> = row.try_get(at).map_err(unread)?;
            text.map_or(Value::Null, Value::Text)
        }
        _ => return Err(wrong_kind(of)),
    })
}
