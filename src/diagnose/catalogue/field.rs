//! The words of a field: what acts in a balance, and what brings it back, told from its unit.

use super::scene::Motion;
use crate::units::Unit;

/// What a field calls the parts of a balance or of a motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Words {
    /// What acts.
    pub acts: &'static str,
    /// What leads it back to rest.
    pub back: &'static str,
    /// What stands behind it and follows with a lag.
    pub store: &'static str,
}

/// The words where terms have a unit and no speed stands: unit of the terms, what acts, what leads back to rest, what
/// stands behind.
const BALANCES: [(&str, [&str; 3]); 12] = [
    ("W", ["a flow of heat", "the loss of heat", "a second store of heat"]),
    ("K/s", ["a heating", "the cooling", "a second store of heat"]),
    ("m^3/s", ["a flow", "the outflow", "a second vessel"]),
    ("m/s", ["a flow", "the outflow", "a second vessel"]),
    ("Pa*m^3/s", ["a flow", "the outflow", "a second chamber"]),
    ("kg/s", ["a flow of mass", "the outflow", "a second vessel"]),
    ("mol/s", ["a flow of substance", "the rate of loss", "a second compartment"]),
    ("mol/(m^3*s)", ["a rate", "the rate of loss", "a second compartment"]),
    ("kg/(m^3*s)", ["a rate", "the rate of loss", "a second compartment"]),
    ("A", ["a current", "the current that leaks", "a second store of charge"]),
    ("V", ["a voltage", "the voltage that drops", "a second circuit"]),
    ("V/s", ["a charging", "the discharge", "a second store of charge"]),
];

/// What any other balance has.
const ANY_BALANCE: [&str; 3] = ["a flow", "the rate of loss", "a second store"];

/// The words at a motion or a balance.
pub(super) fn words(m: &Motion) -> Words {
    let is = |unit: &str| Unit::parse(unit).is_ok_and(|u| u.dimension() == m.force.dimension());
    let [acts, back, store] = if m.speed.is_none() {
        BALANCES.iter().find(|(unit, _)| is(unit)).map_or(ANY_BALANCE, |(_, words)| *words)
    } else if is("N*m") {
        ["a moment", "the restoring moment", "a relaxing part"]
    } else {
        ["a force", "the restoring force", "a relaxing part"]
    };
    Words { acts, back, store }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_furnace_has_no_restoring_force() {
        let at = |force: &str, speed: Option<&str>| {
            let force = Unit::parse(force).unwrap();
            words(&Motion {
                state: "x".into(),
                speed: speed.map(str::to_owned),
                position: None,
                force,
                size: 1.0,
            })
        };
        let heat = at("W", None);
        assert_eq!([heat.acts, heat.back], ["a flow of heat", "the loss of heat"]);
        assert_eq!(at("W", None).store, "a second store of heat");
        assert_eq!(at("mg/(l*h)", None).store, "a second compartment");
        assert_eq!(at("mmol/(l*h)", None).store, "a second compartment");
        assert_eq!(at("mol/s", None).acts, "a flow of substance");
        assert_eq!(at("V/s", None).store, "a second store of charge");
        assert_eq!(at("N", Some("v")).back, "the restoring force");
        assert_eq!(at("N*m/rad", Some("w")).acts, "a moment");
        assert_eq!(at("1/s", None).back, "the rate of loss");
    }
}
