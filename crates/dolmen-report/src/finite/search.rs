//! Where a value has numbers that are not finite: serde goes through the value, and nothing is written.

use serde::Serialize;
use serde::ser::{
    self, SerializeMap, SerializeSeq, SerializeStruct, SerializeStructVariant, SerializeTuple,
    SerializeTupleStruct, SerializeTupleVariant, Serializer,
};
use std::fmt;

/// A step into a value.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Step {
    Key(String),
    At(usize),
}

impl fmt::Display for Step {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Step::Key(key) => formatter.write_str(key),
            Step::At(index) => write!(formatter, "[{index}]"),
        }
    }
}

/// A number that is not finite, and the path to it.
pub(super) struct NotFinite {
    pub(super) path: Vec<Step>,
    pub(super) number: f64,
}

impl NotFinite {
    /// What it is, as a word of JSON.
    pub(super) fn word(&self) -> &'static str {
        match self.number {
            f64::INFINITY => "infinite",
            f64::NEG_INFINITY => "minus_infinite",
            _ => "not_a_number",
        }
    }
}

/// Each number that is not finite.
pub(super) fn not_finite_in<T: Serialize + ?Sized>(value: &T) -> Vec<NotFinite> {
    let mut search = Search::default();
    // a value that cannot be serialised was refused before
    let _ = value.serialize(&mut search);
    search.found
}

#[derive(Default)]
struct Search {
    path: Vec<Step>,
    found: Vec<NotFinite>,
}

impl Search {
    fn number(&mut self, number: f64) -> Result<(), Never> {
        if !number.is_finite() {
            let path = self.path.clone();
            self.found.push(NotFinite { path, number });
        }
        Ok(())
    }

    fn within<T: Serialize + ?Sized>(&mut self, step: Step, value: &T) -> Result<(), Never> {
        self.path.push(step);
        let done = value.serialize(&mut *self);
        self.path.pop();
        done
    }

    fn parts(&mut self) -> Parts<'_> {
        Parts {
            search: self,
            next: 0,
            key: String::new(),
            is_variant: false,
        }
    }

    /// The parts of a variant, which stand under its name.
    fn variant(&mut self, name: &str) -> Parts<'_> {
        self.path.push(Step::Key(name.to_owned()));
        Parts {
            is_variant: true,
            ..self.parts()
        }
    }
}

/// The parts of a list or an object.
struct Parts<'a> {
    search: &'a mut Search,
    next: usize,
    key: String,
    is_variant: bool,
}

impl Parts<'_> {
    fn item<T: Serialize + ?Sized>(&mut self, value: &T) -> Result<(), Never> {
        let at = Step::At(self.next);
        self.next += 1;
        self.search.within(at, value)
    }

    fn done(self) -> Result<(), Never> {
        if self.is_variant {
            self.search.path.pop();
        }
        Ok(())
    }
}

/// What serde asks for: the search itself does not fail, a value may.
#[derive(Debug)]
struct Never;

impl fmt::Display for Never {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str("this value cannot be serialised")
    }
}

impl std::error::Error for Never {}

impl ser::Error for Never {
    fn custom<T: fmt::Display>(_: T) -> Self {
        Never
    }
}

macro_rules! finite {
    ($($name:ident: $of:ty),*) => { $(fn $name(self, _: $of) -> Result<(), Never> { Ok(()) })* };
}

impl<'a> Serializer for &'a mut Search {
    type Ok = ();
    type Error = Never;
    type SerializeSeq = Parts<'a>;
    type SerializeTuple = Parts<'a>;
    type SerializeTupleStruct = Parts<'a>;
    type SerializeTupleVariant = Parts<'a>;
    type SerializeMap = Parts<'a>;
    type SerializeStruct = Parts<'a>;
    type SerializeStructVariant = Parts<'a>;

    finite!(serialize_bool: bool, serialize_i8: i8, serialize_i16: i16, serialize_i32: i32, serialize_i64: i64,
        serialize_i128: i128, serialize_u8: u8, serialize_u16: u16, serialize_u32: u32, serialize_u64: u64,
        serialize_u128: u128, serialize_char: char, serialize_str: &str, serialize_bytes: &[u8], serialize_unit_struct: &'static str);

    fn serialize_f32(self, value: f32) -> Result<(), Never> {
        self.number(f64::from(value))
    }

    fn serialize_f64(self, value: f64) -> Result<(), Never> {
        self.number(value)
    }

    fn serialize_none(self) -> Result<(), Never> {
        Ok(())
    }

    fn serialize_some<T: Serialize + ?Sized>(self, value: &T) -> Result<(), Never> {
        value.serialize(self)
    }

    fn serialize_unit(self) -> Result<(), Never> {
        Ok(())
    }

    fn serialize_unit_variant(self, _: &'static str, _: u32, _: &'static str) -> Result<(), Never> {
        Ok(())
    }

    fn serialize_newtype_struct<T: Serialize + ?Sized>(
        self,
        _: &'static str,
        value: &T,
    ) -> Result<(), Never> {
        value.serialize(self)
    }

    fn serialize_newtype_variant<T: Serialize + ?Sized>(
        self,
        _: &'static str,
        _: u32,
        variant: &'static str,
        value: &T,
    ) -> Result<(), Never> {
        self.within(Step::Key(variant.to_owned()), value)
    }

    fn serialize_seq(self, _: Option<usize>) -> Result<Parts<'a>, Never> {
        Ok(self.parts())
    }

    fn serialize_tuple(self, _: usize) -> Result<Parts<'a>, Never> {
        Ok(self.parts())
    }

    fn serialize_tuple_struct(self, _: &'static str, _: usize) -> Result<Parts<'a>, Never> {
        Ok(self.parts())
    }

    fn serialize_tuple_variant(
        self,
        _: &'static str,
        _: u32,
        variant: &'static str,
        _: usize,
    ) -> Result<Parts<'a>, Never> {
        Ok(self.variant(variant))
    }

    fn serialize_map(self, _: Option<usize>) -> Result<Parts<'a>, Never> {
        Ok(self.parts())
    }

    fn serialize_struct(self, _: &'static str, _: usize) -> Result<Parts<'a>, Never> {
        Ok(self.parts())
    }

    fn serialize_struct_variant(
        self,
        _: &'static str,
        _: u32,
        variant: &'static str,
        _: usize,
    ) -> Result<Parts<'a>, Never> {
        Ok(self.variant(variant))
    }
}

macro_rules! list {
    ($($of:ident: $method:ident),*) => { $(impl $of for Parts<'_> {
        type Ok = ();
        type Error = Never;

        fn $method<T: Serialize + ?Sized>(&mut self, value: &T) -> Result<(), Never> {
            self.item(value)
        }

        fn end(self) -> Result<(), Never> {
            self.done()
        }
    })* };
}

list!(SerializeSeq: serialize_element, SerializeTuple: serialize_element, SerializeTupleStruct: serialize_field,
    SerializeTupleVariant: serialize_field);

macro_rules! object {
    ($($of:ident),*) => { $(impl $of for Parts<'_> {
        type Ok = ();
        type Error = Never;

        fn serialize_field<T: Serialize + ?Sized>(&mut self, key: &'static str, value: &T) -> Result<(), Never> {
            self.search.within(Step::Key(key.to_owned()), value)
        }

        fn end(self) -> Result<(), Never> {
            self.done()
        }
    })* };
}

object!(SerializeStruct, SerializeStructVariant);

impl SerializeMap for Parts<'_> {
    type Ok = ();
    type Error = Never;

    fn serialize_key<T: Serialize + ?Sized>(&mut self, key: &T) -> Result<(), Never> {
        // as serde_json writes it
        self.key = match serde_json::to_value(key) {
            Ok(serde_json::Value::String(text)) => text,
            Ok(other) => other.to_string(),
            Err(_) => String::new(),
        };
        Ok(())
    }

    fn serialize_value<T: Serialize + ?Sized>(&mut self, value: &T) -> Result<(), Never> {
        let key = Step::Key(std::mem::take(&mut self.key));
        self.search.within(key, value)
    }

    fn end(self) -> Result<(), Never> {
        self.done()
    }
}
