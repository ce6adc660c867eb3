use super::*;

fn u(text: &str) -> Unit {
    Unit::parse(text).unwrap()
}

#[test]
fn every_name_of_the_list_reads_and_no_two_collide() {
    let mut seen = std::collections::BTreeSet::new();
    for n in names::all() {
        assert!(seen.insert(n.name.clone()), "{} stands twice", n.name);
        assert_eq!(u(&n.name).dimension(), n.dimension);
    }
    for name in "m cm mm kg g s ms min h N mN dyn Nm V mV A W Pa K Hz rad deg arcmin kn degC rpm 1".split(' ')
    {
        assert!(seen.contains(name), "{name}");
    }
}

#[test]
fn conversions() {
    let cases = [
        ("g*cm^2/s", 1.55e8, 15.5),
        ("kn", 3600.0, 1852.0),
        ("rpm", 60.0, 2.0 * std::f64::consts::PI),
        ("arcmin", 60.0 * 180.0, std::f64::consts::PI),
        ("dyn", 1e5, 1.0),
        ("1/min", 60.0, 1.0),
        ("cm^0.5", 4.0, 0.4),
        ("mV/(m*s)", 2.0, 0.002),
        ("kg^-1", 2.0, 2.0),
        ("m^(3/2)", 2.0, 2.0),
        ("degC", 0.0, 273.15),
        ("degC/s", 1.0, 1.0),
        ("kmol", 2.0, 2000.0),
        ("mmol/L", 5.0, 5.0),
        ("mol/(L*s)", 2.0, 2000.0),
        ("umol/(m^2*s)", 3.0, 3e-6),
        ("pA/mV", 3.0, 3e-9),
        ("nS*mV", 2.0, 2e-12),
        ("Gohm*pF", 5.0, 5e-3),
    ];
    for (unit, value, si) in cases {
        let got = u(unit).to_si(value);
        assert!((got - si).abs() <= 1e-14 * si.abs(), "{unit}: {got} for {si}");
        assert!((u(unit).from_si(si) - value).abs() <= 1e-12 * value.abs().max(1.0), "{unit}");
    }
}

#[test]
fn errors_name_the_nearest() {
    for (text, near) in [
        ("metre", "m"),
        ("Degc", "degC"),
        ("kts", "kn"),
        ("radd/s", "rad"),
        ("m/sec", "s"),
        ("sec", "s"),
        ("SEC", "s"),
        ("moles", "mol"),
        ("RPM", "rpm"),
        ("OHM", "ohm"),
        ("KN", "kN"),
        ("PA", "Pa"),
        ("HZ", "Hz"),
    ] {
        let e = Unit::parse(text).unwrap_err();
        assert!(e.hint().unwrap().ends_with(&format!(" {near}")), "{text}: {e}");
    }
    assert_eq!(Unit::parse("m/foo").unwrap_err().column(), Some(3));
    for warm in ["°F", "℉", "degF", "Fahrenheit"] {
        assert!(Unit::parse(warm).unwrap_err().hint().unwrap().contains("(x - 32)/1.8"), "{warm}");
    }
    for bad in ["", "m^", "m^0.3", "m**s", "(m", "m s", "/s", "m^1/0", "g^0", "m^-0", "m^(0/2)"] {
        assert!(Unit::parse(bad).is_err(), "{bad}");
    }
}

#[test]
fn the_spelling_of_people_is_read() {
    for (people, list) in [
        ("°C", "degC"),
        ("℃", "degC"),
        ("°", "deg"),
        ("L/min", "l/min"),
        ("µmol/mL", "umol/ml"),
        ("°/s", "deg/s"),
        ("m/s²", "m/s^2"),
        ("m³/h", "m^3/h"),
        ("s⁻¹", "s^-1"),
        ("N·m", "N*m"),
        ("g·cm²/s", "g*cm^2/s"),
        ("Ω", "ohm"),
        ("kΩ", "kohm"),
        ("\u{2126}", "ohm"),
        ("m\u{2126}", "mohm"),
        ("\u{b5}m", "um"),
        ("MOhm", "Mohm"),
        ("Ohm", "ohm"),
        ("µm", "um"),
        ("knots", "kn"),
        ("m10²", "m10²"),
    ] {
        match Unit::parse(list) {
            Ok(unit) => assert_eq!(u(people), unit, "{people}"),
            Err(_) => assert!(Unit::parse(people).is_err(), "{people}"),
        }
    }
    // by their definitions: 1 nmi = 1852 m, 1 ft = 0.3048 m, 1 l = 0.001 m^3, 1 bar = 1e5 Pa, 1 Wh = 3600 J
    let cases = [
        ("nmi", 1.0, 1852.0),
        ("ft", 10.0, 3.048),
        ("l", 1000.0, 1.0),
        ("ml", 1.0, 1e-6),
        ("mbar", 1013.25, 101_325.0),
        ("kWh", 1.0, 3.6e6),
        ("GPa", 1.4, 1.4e9),
        ("GHz", 1.0, 1e9),
        ("%", 50.0, 0.5),
        ("%/s", 50.0, 0.5),
        ("d", 1.0, 86_400.0),
        ("rev", 1.0, std::f64::consts::TAU),
        ("m³/h", 3600.0, 1.0),
        ("l/min", 60.0, 0.001),
    ];
    for (unit, value, si) in cases {
        let got = u(unit).to_si(value);
        assert!((got - si).abs() <= 1e-14 * si.abs(), "{unit}: {got} for {si}");
    }
}

#[test]
fn dimensions_spell_short() {
    for (unit, text) in [
        ("kg*m/s^2", "N"),
        ("deg/s", "1/s"),
        ("V/s", "V/s"),
        ("N/m", "N/m"),
        ("N*m*s", "N*m*s"),
        ("m/s^2", "m/s^2"),
        ("Pa*s", "Pa*s"),
        ("kg*m^2", "m^2*kg"),
        ("deg", "1"),
    ] {
        assert_eq!(u(unit).dimension().to_string(), text);
        assert_eq!(u(text).dimension(), u(unit).dimension());
    }
}

#[test]
fn combinations_keep_their_names() {
    assert_eq!(u("N").over(&u("m^2/s^2")).text(), "N*s^2/m^2");
    assert_eq!(u("degC").over(&u("s")).text(), "K/s");
    assert_eq!(u("g*cm/s^2").times(&u("1/cm")).text(), "g/s^2");
    // derived units first, times last, as they are said: volts, amperes, seconds
    assert_eq!(u("s").times(&u("A*V")).text(), "V*A*s");
    assert_eq!(u("s").times(&u("A")).times(&u("V")).text(), "V*A*s");
    assert_eq!(u("m").times(&u("Nm")).text(), "Nm*m");
    assert_eq!(u("min").times(&u("kW")).text(), "kW*min");
    assert_eq!(u("m").times(&u("N")).times(&u("s")).text(), "N*m*s");
    assert_eq!(u("cm^2").times(&u("g")).over(&u("s")).text(), "cm^2*g/s");
    assert_eq!(u("m/s").power(-0.5).text(), "s^0.5/m^0.5");
}

#[test]
fn an_amount_is_a_quantity_of_its_own() {
    assert_ne!(u("mol/s").dimension(), u("1/s").dimension());
    assert_eq!(u("mol/s").over(&u("mol/m^3")).dimension(), u("m^3/s").dimension());
    // the gas constant's unit makes a pressure of a concentration and a temperature
    let gas = u("J/(mol*K)").times(&u("mol/m^3")).times(&u("K"));
    assert_eq!(gas.dimension(), u("Pa").dimension());
    assert_eq!(u("mmol/(L*h)").dimension().to_string(), "mol/m^3/s");
}
