//! The names of the closed list: code name | factor | powers of m, kg, s, A, K, mol | prefixes.

use super::Dimension;
use std::f64::consts::{PI, TAU};

/// One named unit with its prefix already applied.
pub(super) struct Named {
    pub name: String,
    pub mantissa: f64,
    pub decade: i32,
    pub offset: f64,
    pub dimension: Dimension,
    /// The power of an angle in it, which the dimension leaves out.
    pub angle: i32,
}

type Row = (&'static str, f64, i32, [i32; 6], &'static str);

/// Symbol, mantissa, decade, powers of (m, kg, s, A, K, mol), prefixes allowed.
const TABLE: [Row; 39] = [
    ("m", 1.0, 0, [1, 0, 0, 0, 0, 0], "kdcmun"),
    ("g", 1.0, -3, [0, 1, 0, 0, 0, 0], "Mkmun"),
    ("s", 1.0, 0, [0, 0, 1, 0, 0, 0], "mun"),
    ("min", 60.0, 0, [0, 0, 1, 0, 0, 0], ""),
    ("h", 3600.0, 0, [0, 0, 1, 0, 0, 0], ""),
    ("A", 1.0, 0, [0, 0, 0, 1, 0, 0], "kmunp"),
    ("K", 1.0, 0, [0, 0, 0, 0, 1, 0], "mu"),
    ("degC", 1.0, 0, [0, 0, 0, 0, 1, 0], ""),
    ("mol", 1.0, 0, [0, 0, 0, 0, 0, 1], "kmunp"),
    ("N", 1.0, 0, [1, 1, -2, 0, 0, 0], "Mkcmunp"),
    ("dyn", 1.0, -5, [1, 1, -2, 0, 0, 0], "k"),
    ("Nm", 1.0, 0, [2, 1, -2, 0, 0, 0], "Mkcmun"),
    ("J", 1.0, 0, [2, 1, -2, 0, 0, 0], "GMkmunp"),
    ("W", 1.0, 0, [2, 1, -3, 0, 0, 0], "GMkmunp"),
    ("Pa", 1.0, 0, [-1, 1, -2, 0, 0, 0], "GMkhmu"),
    ("V", 1.0, 0, [2, 1, -3, -1, 0, 0], "kmun"),
    ("ohm", 1.0, 0, [2, 1, -3, -2, 0, 0], "GMkm"),
    ("S", 1.0, 0, [-2, -1, 3, 2, 0, 0], "munp"),
    ("T", 1.0, 0, [0, 1, -2, -1, 0, 0], "mun"),
    ("H", 1.0, 0, [2, 1, -2, -2, 0, 0], "mun"),
    ("F", 1.0, 0, [-2, -1, 4, 2, 0, 0], "munp"),
    ("Hz", 1.0, 0, [0, 0, -1, 0, 0, 0], "GMkm"),
    ("rad", 1.0, 0, [0; 6], "mun"),
    ("deg", PI / 180.0, 0, [0; 6], "m"),
    ("arcmin", PI / 10_800.0, 0, [0; 6], ""),
    ("arcsec", PI / 648_000.0, 0, [0; 6], "m"),
    ("rpm", PI / 30.0, 0, [0, 0, -1, 0, 0, 0], ""),
    ("kn", 1852.0 / 3600.0, 0, [1, 0, -1, 0, 0, 0], ""),
    ("rev", TAU, 0, [0; 6], ""),
    ("%", 1.0, -2, [0; 6], ""),
    ("d", 86_400.0, 0, [0, 0, 1, 0, 0, 0], ""),
    ("nmi", 1852.0, 0, [1, 0, 0, 0, 0, 0], ""),
    ("ft", 3048.0, -4, [1, 0, 0, 0, 0, 0], ""),
    ("l", 1.0, -3, [3, 0, 0, 0, 0, 0], "mcdu"),
    ("bar", 1.0, 5, [-1, 1, -2, 0, 0, 0], "m"),
    // 0.45359237 kg under 9.80665 m/s² on a square of 0.0254 m, and the conventional millimetre of mercury
    ("psi", 6894.757293168362, 0, [-1, 1, -2, 0, 0, 0], ""),
    ("mmHg", 133.322387415, 0, [-1, 1, -2, 0, 0, 0], ""),
    ("Wh", 3600.0, 0, [2, 1, -2, 0, 0, 0], "kM"),
    ("1", 1.0, 0, [0; 6], ""),
];

/// The names that hold one power of an angle. A revolution is one too, but what `rev/s` counts is asked for.
const ANGLES: [&str; 5] = ["rad", "deg", "arcmin", "arcsec", "rpm"];

fn decade_of(prefix: char) -> i32 {
    match prefix {
        'G' => 9,
        'M' => 6,
        'k' => 3,
        'h' => 2,
        'd' => -1,
        'c' => -2,
        'm' => -3,
        'u' => -6,
        'n' => -9,
        _ => -12,
    }
}

fn named(row: &Row, prefix: Option<char>) -> Named {
    let (symbol, mantissa, decade, powers, _) = *row;
    Named {
        name: prefix.map(String::from).unwrap_or_default() + symbol,
        mantissa,
        decade: decade + prefix.map_or(0, decade_of),
        offset: if symbol == "degC" { 273.15 } else { 0.0 },
        dimension: Dimension::whole(powers),
        angle: i32::from(ANGLES.contains(&symbol)),
    }
}

/// Every unit of the list, plain names first.
pub(super) fn all() -> impl Iterator<Item = Named> {
    let plain = TABLE.iter().map(|row| named(row, None));
    let prefixed = TABLE.iter().flat_map(|row| row.4.chars().map(|p| named(row, Some(p))));
    plain.chain(prefixed)
}

/// Each plain name with those that it has with prefixes, in the order of the list.
pub(super) fn families() -> impl Iterator<Item = (&'static str, Vec<String>)> {
    TABLE.iter().map(|row| (row.0, row.4.chars().map(|p| named(row, Some(p)).name).collect()))
}

/// The unit of that name, a plain one before one with a prefix.
pub(super) fn find(name: &str) -> Option<Named> {
    let plain = TABLE.iter().find(|row| row.0 == name);
    plain.map(|row| named(row, None)).or_else(|| {
        let mut symbol = name.chars();
        let prefix = symbol.next()?;
        let row = TABLE.iter().find(|row| row.0 == symbol.as_str() && row.4.contains(prefix))?;
        Some(named(row, Some(prefix)))
    })
}
