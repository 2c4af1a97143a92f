//! Data of reports read back from their JSON.

use serde::Deserializer;
use serde::de::value::{MapDeserializer, SeqDeserializer};
use serde::de::{DeserializeOwned, IntoDeserializer, Visitor};
use serde_json::{Error, Value};

/// Data of a report from what [`to_json`](crate::to_json) wrote: the same values bit by bit, and
/// NaN where a trace has `null`.
///
/// # Errors
/// The text is not JSON, or not of this kind of report.
pub fn from_json<T: DeserializeOwned>(text: &str) -> Result<T, Error> {
    T::deserialize(Numbers(serde_json::from_str(text)?))
}

/// A JSON value in which `null` is NaN where a number is expected.
struct Numbers(Value);

impl<'de> Deserializer<'de> for Numbers {
    type Error = Error;

    fn deserialize_any<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
        match self.0 {
            Value::Array(items) => {
                visitor.visit_seq(SeqDeserializer::new(items.into_iter().map(Self)))
            }
            Value::Object(entries) => {
                let entries = entries.into_iter().map(|(key, value)| (key, Self(value)));
                visitor.visit_map(MapDeserializer::new(entries))
            }
            other => other.deserialize_any(visitor),
        }
    }

    fn deserialize_f64<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
        match self.0 {
            Value::Null => visitor.visit_f64(f64::NAN),
            other => other.deserialize_f64(visitor),
        }
    }

    fn deserialize_option<V: Visitor<'de>>(self, visitor: V) -> Result<V::Value, Error> {
        match self.0 {
            Value::Null => visitor.visit_none(),
            other => visitor.visit_some(Self(other)),
        }
    }

    fn deserialize_newtype_struct<V: Visitor<'de>>(
        self,
        _name: &'static str,
        visitor: V,
    ) -> Result<V::Value, Error> {
        visitor.visit_newtype_struct(self)
    }

    fn deserialize_enum<V: Visitor<'de>>(
        self,
        name: &'static str,
        variants: &'static [&'static str],
        visitor: V,
    ) -> Result<V::Value, Error> {
        self.0.deserialize_enum(name, variants, visitor)
    }

    serde::forward_to_deserialize_any! {
        bool i8 i16 i32 i64 i128 u8 u16 u32 u64 u128 f32 char str string bytes byte_buf unit
        unit_struct seq tuple tuple_struct map struct identifier ignored_any
    }
}

impl IntoDeserializer<'_, Error> for Numbers {
    type Deserializer = Self;

    fn into_deserializer(self) -> Self {
        self
    }
}

/// All numbers of a report as one JSON document, unrounded.
///
/// # Errors
/// Never for the data of this crate: their keys are all text.
pub fn to_json<T: serde::Serialize>(data: &T) -> Result<String, serde_json::Error> {
    serde_json::to_string(data)
}

#[cfg(test)]
mod tests {
    use super::from_json;
    use crate::{BallHistory, RunData, to_json};

    #[test]
    fn data_come_back_bit_by_bit_and_null_as_nan() {
        let numbers = vec![
            0.1 + 0.2,
            f64::NAN,
            -0.0,
            5e-324,
            1.7976931348623157e308,
            3.0,
        ];
        let data = RunData {
            title: "of \"runs\"".to_owned(),
            passes: Some(false),
            stretch_s: None,
            time_s: numbers.clone(),
            balls: vec![BallHistory {
                gap_deg: numbers.clone(),
                ..BallHistory::default()
            }],
            ..RunData::default()
        };
        let text = to_json(&data).unwrap();
        let back: RunData = from_json(&text).unwrap();
        assert_eq!(to_json(&back).unwrap(), text);
        let bits = |v: &[f64]| v.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
        assert_eq!(bits(&back.time_s), bits(&numbers));
        assert_eq!(bits(&back.balls[0].gap_deg), bits(&numbers));
        assert_eq!((back.passes, back.stretch_s), (Some(false), None));
        assert!(from_json::<RunData>("{\"title\": 1}").is_err());
    }
}
