//! Tables as Parquet, compressed by Snappy: one row group, the columns of the CSV, missing numbers as nulls.

use ::parquet::basic::{Compression, ConvertedType, Repetition, Type as PhysicalType};
use ::parquet::data_type::{ByteArray, ByteArrayType, DoubleType, Int64Type};
use ::parquet::errors::ParquetError;
use ::parquet::file::properties::WriterProperties;
use ::parquet::file::writer::SerializedFileWriter;
use ::parquet::schema::types::Type;
use dolmen_work::study::{Column, ColumnValues};
use std::sync::Arc;

/// Why a table cannot be written.
#[derive(Debug, thiserror::Error)]
#[error("the table cannot be written as Parquet: {0}")]
pub struct TableError(#[from] ParquetError);

/// A table as the bytes of a Parquet file.
///
/// # Errors
/// [`TableError`] for columns with the same name.
pub fn parquet(columns: &[Column]) -> Result<Vec<u8>, TableError> {
    let fields = columns.iter().map(|column| {
        let (physical, converted, repetition) = match column.values {
            ColumnValues::Numbers(_) => (PhysicalType::DOUBLE, ConvertedType::NONE, Repetition::OPTIONAL),
            ColumnValues::Counts(_) => (PhysicalType::INT64, ConvertedType::NONE, Repetition::REQUIRED),
            ColumnValues::Words(_) => (
                PhysicalType::BYTE_ARRAY,
                ConvertedType::UTF8,
                Repetition::REQUIRED,
            ),
        };
        let built = Type::primitive_type_builder(&column.name, physical);
        let built = built
            .with_repetition(repetition)
            .with_converted_type(converted)
            .build();
        built.map(Arc::new)
    });
    let fields = fields.collect::<Result<Vec<_>, ParquetError>>()?;
    let schema = Type::group_type_builder("study").with_fields(fields).build()?;
    let created_by = format!("dolmen {}", env!("CARGO_PKG_VERSION"));
    let properties = WriterProperties::builder()
        .set_compression(Compression::SNAPPY)
        .set_created_by(created_by);
    let mut writer = SerializedFileWriter::new(Vec::new(), Arc::new(schema), Arc::new(properties.build()))?;
    let mut group = writer.next_row_group()?;
    for column in columns {
        let Some(mut chunk) = group.next_column()? else {
            break;
        };
        match &column.values {
            ColumnValues::Numbers(values) => {
                let present: Vec<f64> = values.iter().flatten().copied().collect();
                let levels: Vec<i16> = values.iter().map(|value| i16::from(value.is_some())).collect();
                chunk
                    .typed::<DoubleType>()
                    .write_batch(&present, Some(&levels), None)?;
            }
            ColumnValues::Counts(values) => {
                chunk.typed::<Int64Type>().write_batch(values, None, None)?;
            }
            ColumnValues::Words(values) => {
                let texts: Vec<ByteArray> =
                    values.iter().map(|text| ByteArray::from(text.as_str())).collect();
                chunk.typed::<ByteArrayType>().write_batch(&texts, None, None)?;
            }
        }
        chunk.close()?;
    }
    group.close()?;
    Ok(writer.into_inner()?)
}

#[cfg(test)]
mod tests {
    use super::*;
    use ::parquet::file::reader::{FileReader as _, SerializedFileReader};
    use ::parquet::record::Field;

    #[test]
    fn exact_what_is_written_is_read_again() {
        let columns = [
            (
                "x_m",
                ColumnValues::Numbers(vec![Some(0.1 + 0.2), None, Some(-1e-300)]),
            ),
            ("case", ColumnValues::Counts(vec![1, 2, i64::MAX])),
            (
                "석탑",
                ColumnValues::Words(vec!["가".to_owned(), String::new(), "a,b\n".to_owned()]),
            ),
        ]
        .map(|(name, values)| Column {
            name: name.to_owned(),
            values,
        });
        let bytes = parquet(&columns).unwrap();
        assert_eq!(parquet(&columns).unwrap(), bytes);
        let reader = SerializedFileReader::new(bytes::Bytes::from(bytes)).unwrap();
        let rows: Vec<Vec<Field>> = reader
            .get_row_iter(None)
            .unwrap()
            .map(|row| {
                row.unwrap()
                    .get_column_iter()
                    .map(|(_, field)| field.clone())
                    .collect()
            })
            .collect();
        assert_eq!(
            rows[0],
            [
                Field::Double(0.1 + 0.2),
                Field::Long(1),
                Field::Str("가".to_owned())
            ]
        );
        assert_eq!(rows[1], [Field::Null, Field::Long(2), Field::Str(String::new())]);
        assert_eq!(
            rows[2],
            [
                Field::Double(-1e-300),
                Field::Long(i64::MAX),
                Field::Str("a,b\n".to_owned())
            ]
        );
    }
}
