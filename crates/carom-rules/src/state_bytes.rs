//! States as bytes, to save them and to continue from them with the same bits.
//!
//! The bytes have no names and no version of their own: who stores them adds both, and a checksum.

use crate::seat::Seat;
use crate::short_list::ShortList;

/// A value that is written as bytes and read from them again, to the bit. Numbers are little-endian.
pub trait StateBytes: Sized {
    /// Appends the value to `out`.
    fn write_to(&self, out: &mut Vec<u8>);

    /// The value at the start of `bytes`, which then begins behind it; none if there is no such value.
    fn read_from(bytes: &mut &[u8]) -> Option<Self>;
}

macro_rules! number {
    ($($number:ty),*) => {$(
        impl StateBytes for $number {
            fn write_to(&self, out: &mut Vec<u8>) {
                out.extend(self.to_le_bytes());
            }

            fn read_from(bytes: &mut &[u8]) -> Option<Self> {
                let (own, rest) = bytes.split_first_chunk()?;
                *bytes = rest;
                Some(Self::from_le_bytes(*own))
            }
        }
    )*};
}

number!(u8, u16, u32, u64, i32, f64);

impl StateBytes for bool {
    fn write_to(&self, out: &mut Vec<u8>) {
        u8::from(*self).write_to(out);
    }

    fn read_from(bytes: &mut &[u8]) -> Option<Self> {
        match u8::read_from(bytes)? {
            0 => Some(false),
            1 => Some(true),
            _ => None,
        }
    }
}

impl StateBytes for Seat {
    fn write_to(&self, out: &mut Vec<u8>) {
        (*self == 1).write_to(out);
    }

    fn read_from(bytes: &mut &[u8]) -> Option<Self> {
        bool::read_from(bytes).map(Self::from)
    }
}

impl<T: StateBytes> StateBytes for Option<T> {
    fn write_to(&self, out: &mut Vec<u8>) {
        self.is_some().write_to(out);
        if let Some(value) = self {
            value.write_to(out);
        }
    }

    fn read_from(bytes: &mut &[u8]) -> Option<Self> {
        if bool::read_from(bytes)? { T::read_from(bytes).map(Some) } else { Some(None) }
    }
}

impl<T: StateBytes + Copy + Default, const N: usize> StateBytes for [T; N] {
    fn write_to(&self, out: &mut Vec<u8>) {
        self.iter().for_each(|value| value.write_to(out));
    }

    fn read_from(bytes: &mut &[u8]) -> Option<Self> {
        let mut values = [T::default(); N];
        for value in &mut values {
            *value = T::read_from(bytes)?;
        }
        Some(values)
    }
}

impl<T: StateBytes + Copy + Default, const N: usize> StateBytes for ShortList<T, N> {
    fn write_to(&self, out: &mut Vec<u8>) {
        (self.len() as u8).write_to(out);
        self.iter().for_each(|value| value.write_to(out));
    }

    fn read_from(bytes: &mut &[u8]) -> Option<Self> {
        let count = usize::from(u8::read_from(bytes)?);
        (count <= N).then(|| (0..count).map(|_| T::read_from(bytes)).collect())?
    }
}

/// Implements [`StateBytes`] for a struct, field by field, or for an enum without fields, by number.
macro_rules! state_bytes {
    (struct $name:ty { $($field:ident),* $(,)? }) => {
        impl $crate::state_bytes::StateBytes for $name {
            fn write_to(&self, out: &mut Vec<u8>) {
                let Self { $($field),* } = self;
                $($field.write_to(out);)*
            }

            fn read_from(bytes: &mut &[u8]) -> Option<Self> {
                Some(Self { $($field: $crate::state_bytes::StateBytes::read_from(bytes)?),* })
            }
        }
    };
    (enum $name:ty { $($variant:ident),* $(,)? }) => {
        impl $crate::state_bytes::StateBytes for $name {
            fn write_to(&self, out: &mut Vec<u8>) {
                (*self as u8).write_to(out);
            }

            fn read_from(bytes: &mut &[u8]) -> Option<Self> {
                let number = u8::read_from(bytes)?;
                [$(Self::$variant),*].into_iter().find(|variant| *variant as u8 == number)
            }
        }
    };
}

pub(crate) use state_bytes;

#[cfg(test)]
mod tests {
    use super::StateBytes;
    use crate::short_list::ShortList;

    type Three = ShortList<u16, 3>;

    #[test]
    fn values_come_back_from_their_bytes_to_the_bit() {
        let mut out = Vec::new();
        let list: Three = [7, 65535].into_iter().collect();
        let value = (Some([-0.0_f64, f64::NAN]), None::<u32>, list, [true, false]);
        value.0.write_to(&mut out);
        value.1.write_to(&mut out);
        value.2.write_to(&mut out);
        value.3.write_to(&mut out);
        let mut bytes = &out[..];
        let [zero, nan] = Option::<[f64; 2]>::read_from(&mut bytes).flatten().expect("two numbers");
        assert_eq!((zero.to_bits(), nan.to_bits()), ((-0.0_f64).to_bits(), f64::NAN.to_bits()));
        assert_eq!(Option::<u32>::read_from(&mut bytes), Some(None));
        assert_eq!(Three::read_from(&mut bytes), Some(list));
        assert_eq!(<[bool; 2]>::read_from(&mut bytes), Some([true, false]));
        assert!(bytes.is_empty());
    }

    #[test]
    fn bytes_that_no_value_has_are_refused() {
        assert_eq!(bool::read_from(&mut &[2][..]), None);
        assert_eq!(u32::read_from(&mut &[1, 2, 3][..]), None);
        assert_eq!(Three::read_from(&mut &[4, 0, 0, 0, 0, 0, 0, 0, 0][..]), None);
        assert_eq!(Three::read_from(&mut &[2, 0, 0][..]), None);
    }
}
