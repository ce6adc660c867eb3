//! Names in program code.

use super::glyph::ascii_name;
use crate::{Error, Result};

/// Words of Rust that are no names, and what a file compiled alone needs.
const RUST: &str = "_ Self abstract as async await become box break const continue crate do dyn else enum extern \
    false final fn for gen if impl in let loop macro main match mod move mut override priv pub ref return self static \
    struct super trait true try type typeof unsafe unsized use virtual where while yield None Some Ok Err";

/// Words of Python 3 that are no names, and what the functions call.
const PYTHON: &str = "False None True abs and as assert async await break class continue def del elif else except \
    finally float for from global if import in is lambda math max min nonlocal not or pass raise return try while \
    with yield";

/// Words of C that are no names, and the functions of its library that a name would hide or contradict.
const C: &str = "alignas alignof asm auto bool break case char const constexpr continue default do double else enum \
    extern false float for goto if inline int long nullptr register restrict return short signed sizeof static \
    static_assert struct switch thread_local true typedef typeof typeof_unqual union unsigned void volatile while \
    NULL EOF stdin stdout stderr errno linux unix main abs exit free index div labs NAN INFINITY HUGE_VAL MAXFLOAT \
    acos acosh asin asinh atan atan2 atanh cbrt ceil copysign cos cosh drem erf erfc exp exp10 exp2 expm1 fabs fdim \
    finite floor fma fmax fmin fmod frexp gamma hypot ilogb isfinite isinf isnan isnormal j0 j1 jn ldexp lgamma llrint \
    llround log log10 log1p log2 logb lrint lround math_errhandling modf nan nearbyint nextafter nexttoward pow pow10 \
    remainder remquo rint round scalb scalbln scalbn signbit significand signgam sin sincos sinh sqrt tan tanh tgamma \
    trunc y0 y1 yn";

/// A language that a formula is written in.
#[derive(Clone, Copy, PartialEq, Eq, Debug)]
pub enum CodeLanguage {
    /// Rust, edition 2018 or later.
    Rust,
    /// Python 3.
    Python,
    /// C99 with `math.h`.
    C,
}

impl CodeLanguage {
    fn name(self) -> &'static str {
        match self {
            Self::Rust => "Rust",
            Self::Python => "Python",
            Self::C => "C",
        }
    }

    /// Whether a name begins as the constants of the language's library do.
    fn is_macro(self, name: &str) -> bool {
        self == Self::C && (name.starts_with("M_") || name.starts_with("FP_"))
    }

    fn takes(self, name: &str) -> bool {
        let words = match self {
            Self::Rust => RUST,
            Self::Python => PYTHON,
            Self::C => C,
        };
        self.is_macro(name) || words.split_whitespace().any(|word| word == name)
    }
}

/// A name as the language has it: Greek letters written out, an underscore behind a word that is taken, a letter before one
/// whose beginning is.
///
/// # Errors
/// Bad input, where it holds anything but letters of the alphabet, Greek letters, digits and `_`.
pub fn identifier(name: &str, language: CodeLanguage) -> Result<String> {
    let mut plain = ascii_name(name);
    let letters = plain.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
    if !letters || plain.is_empty() || plain.starts_with(|c: char| c.is_ascii_digit()) {
        let wrong = format!("'{name}' cannot be a name in {}", language.name());
        let kept: String = plain.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '_' }).collect();
        let near = kept.trim_matches('_').trim_start_matches(|c: char| c.is_ascii_digit());
        let near = if near.is_empty() { "result" } else { near };
        return Err(Error::bad_input(wrong)
            .with_hint(format!("write letters, digits and _ and begin with a letter: {near}")));
    }
    if language.is_macro(&plain) {
        plain.insert(0, 'x');
    }
    while language.takes(&plain) {
        plain.push('_');
    }
    Ok(plain)
}

/// The names of arguments, all different.
///
/// # Errors
/// Bad input, where one cannot be written or two become one.
pub fn arguments<'a>(
    symbols: impl IntoIterator<Item = &'a str>,
    language: CodeLanguage,
) -> Result<Vec<String>> {
    let mut names: Vec<(String, &str)> = Vec::new();
    for symbol in symbols {
        let name = identifier(symbol, language)?;
        if let Some((_, other)) = names.iter().find(|(known, _)| *known == name) {
            return Err(Error::bad_input(format!(
                "{other} and {symbol} would both be called {name} in {}",
                language.name()
            ))
            .with_hint("give one of them another letter"));
        }
        names.push((name, symbol));
    }
    Ok(names.into_iter().map(|(name, _)| name).collect())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_that_the_language_takes_is_another() {
        let of = |name: &str, language| identifier(name, language).unwrap();
        assert_eq!(of("M_PI", CodeLanguage::C), "xM_PI");
        assert_eq!(of("M_PI", CodeLanguage::Rust), "M_PI");
        assert_eq!(
            (of("NULL", CodeLanguage::C), of("sin", CodeLanguage::C)),
            ("NULL_".into(), "sin_".into())
        );
        assert_eq!(
            (of("None", CodeLanguage::Rust), of("None", CodeLanguage::Python)),
            ("None_".into(), "None_".into())
        );
    }
}
