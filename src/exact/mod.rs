//! Integers and rationals of any size behind the exact tier.
