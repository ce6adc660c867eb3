//! The types of numbers that a unit may have; all of them are `f64` to the caller.

/// How a unit holds a number.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Number {
    /// Real of FMI 2.0
    Float64,
    /// FMI 3.0 only
    Float32,
    /// FMI 3.0 only
    Int8,
    /// FMI 3.0 only
    UInt8,
    /// FMI 3.0 only
    Int16,
    /// FMI 3.0 only
    UInt16,
    /// Integer and enumerations of FMI 2.0
    Int32,
    /// FMI 3.0 only
    UInt32,
    /// Also the enumerations of FMI 3.0
    Int64,
    /// FMI 3.0 only
    UInt64,
    /// 0 and 1
    Boolean,
}

impl Number {
    /// All, in the order of their positions.
    pub(crate) const ALL: [Self; 11] = [
        Self::Float64,
        Self::Float32,
        Self::Int8,
        Self::UInt8,
        Self::Int16,
        Self::UInt16,
        Self::Int32,
        Self::UInt32,
        Self::Int64,
        Self::UInt64,
        Self::Boolean,
    ];

    /// Whether it may be any number rather than a whole one.
    pub fn is_real(self) -> bool {
        matches!(self, Self::Float64 | Self::Float32)
    }

    /// The name in the functions of FMI 3.0.
    pub(crate) fn name(self) -> String {
        format!("{self:?}")
    }
}

/// A type in which foreign code holds numbers.
pub(crate) trait Held: Copy + Default {
    fn of(value: f64) -> Self;
    fn to(self) -> f64;
}

macro_rules! whole {
    ($($t:ty),*) => {$(impl Held for $t {
        fn of(value: f64) -> Self {
            value.round() as Self
        }
        fn to(self) -> f64 {
            self as f64
        }
    })*};
}

whole!(i8, u8, i16, u16, i32, u32, i64, u64);

impl Held for f32 {
    fn of(value: f64) -> Self {
        value as Self
    }
    fn to(self) -> f64 {
        f64::from(self)
    }
}

/// Values as foreign code holds them.
pub(crate) fn held<T: Held>(values: &[f64]) -> Vec<T> {
    values.iter().map(|v| T::of(*v)).collect()
}

/// Runs a call that fills a place of foreign numbers, and takes them over.
pub(crate) fn filled<T: Held, E>(
    values: &mut [f64],
    call: impl FnOnce(&mut [T]) -> Result<(), E>,
) -> Result<(), E> {
    let mut room = vec![T::default(); values.len()];
    call(&mut room)?;
    values.iter_mut().zip(room).for_each(|(v, r)| *v = r.to());
    Ok(())
}
