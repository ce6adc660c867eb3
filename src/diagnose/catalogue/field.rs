//! The words of a field: what acts in a balance, and what brings it back, told from its unit.

use super::scene::Motion;
use crate::units::Unit;

/// What acts in a sum of that unit where no speed stands, and what leads it back to rest.
const BALANCES: [(&str, [&str; 2]); 9] = [
    ("W", ["a flow of heat", "the loss of heat"]),
    ("m^3/s", ["a flow", "the outflow"]),
    ("kg/s", ["a flow of mass", "the outflow"]),
    ("mol/s", ["a flow of substance", "the rate of loss"]),
    ("mol/(m^3*s)", ["a rate", "the rate of loss"]),
    ("kg/(m^3*s)", ["a rate", "the rate of loss"]),
    ("A", ["a current", "the current that leaks"]),
    ("V", ["a voltage", "the voltage that drops"]),
    ("K/s", ["a heating", "the cooling"]),
];

/// The words at a motion or a balance: what acts, and what leads it back.
pub(super) fn words(m: &Motion) -> [&'static str; 2] {
    let is = |unit: &str| Unit::parse(unit).is_ok_and(|u| u.dimension() == m.force.dimension());
    if m.speed.is_some() {
        return if is("N*m") {
            ["a moment", "the restoring moment"]
        } else {
            ["a force", "the restoring force"]
        };
    }
    let balance = BALANCES.iter().find(|(unit, _)| is(unit));
    balance.map_or(["a flow", "the rate of loss"], |(_, words)| *words)
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
        assert_eq!(at("W", None), ["a flow of heat", "the loss of heat"]);
        assert_eq!(at("N", Some("v"))[1], "the restoring force");
        assert_eq!(at("N*m/rad", Some("w"))[0], "a moment");
        assert_eq!(at("1/s", None)[1], "the rate of loss");
    }
}
