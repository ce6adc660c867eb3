//! Which gyrocompasses are known by name, and what to ask for of any other.

use crate::gyro::Gyrosphere;
use crate::model::Model;
use crate::units::figure;
use std::fmt::Write;

/// A number of a compass, in words: its name, what it is, what the error does with it, where it comes from.
const WANTED: [[&str; 4]; 8] = [
    ["P", "weight of the sphere", "the mean goes with its square", "the maker; it can be weighed"],
    [
        "H",
        "angular momentum of the rotors",
        "the mean goes with 1/H",
        "the maker: moment of inertia times speed",
    ],
    [
        "C0",
        "stiffness against a sideways push",
        "the mean goes with 1/C0",
        "the maker, or a fit to measured errors",
    ],
    ["T", "lag of that give", "the mean falls as 1/(1 + p^2 T^2)", "the maker, or a fit to measured errors"],
    ["h", "height above the ship's roll axis", "the mean goes with its square", "the ship's drawings"],
    [
        "lP",
        "pendulous moment",
        "changes the spread alone",
        "the maker, or H w^2/(U cos lat), w = 2 pi/84.4 min",
    ],
    ["C", "moment of the liquid damper", "changes the spread alone", "the maker"],
    [
        "F",
        "rate of the damping liquid",
        "changes the spread alone",
        "the maker, or how fast it settles (--free)",
    ],
];

/// The gyrocompasses known by name with the source of their numbers, and what to ask a maker for.
pub fn instruments_text() -> String {
    let mut s = Gyrosphere::seed();
    let mut out = String::from(
        "Gyrocompasses known by name\n\n\
         gyrosphere   the two-rotor gyrocompass of the rolling-error paper (Potemkin 1978); taken where none is named\n",
    );
    let _ = writeln!(
        out,
        "             (by its name it is the model `gyrosphere`, which turns with the Earth as measured, U = {:e} rad/s;\n             \
         without a name it is the paper's, U = {:e} rad/s)",
        turns_with(),
        s.earth_rate
    );
    for [name, what, _, _] in WANTED {
        let value = s.named(name).map_or(f64::NAN, |v| *v);
        let source = match name {
            "lP" => "not in print: chosen here, for an undamped period of 84.4 min",
            "C" | "F" => "not in print: chosen here",
            "h" => "of its Example 3.1; every ship has her own",
            _ => "as printed",
        };
        let _ = writeln!(out, "  {name:<3} = {:>9} {:<6} {what}, {source}", figure(value), unit(name));
    }
    out.push_str(
        "\nNo other stands here: of none does this program know P, H, C0 and T from a source that it could name.\n\n\
         Of your own, ask for\n\n",
    );
    for [name, what, does, from] in WANTED {
        let _ = writeln!(out, "  {name:<3} {:<6} {what:<34} {does:<32} {from}", unit(name));
    }
    out.push_str(
        "\nWhat the mean error does is by (2.4) of the paper, for regular roll of frequency p. Ask too whether anything has dry friction or\n\
         play (--friction, --free-play), and whether liquid moves with the sphere (--flow, --slosh). What a maker measured\n\
         on a Scorsby table is a check: --scorsby computes it.\n\n\
         Write what you have into compass.toml; what is left out stays that of the paper:\n\n[parameters]\n",
    );
    for [name, ..] in WANTED {
        let value = s.named(name).map_or(f64::NAN, |v| *v);
        let _ = writeln!(out, "{name} = {{ value = {value}, unit = \"{}\" }}", unit(name));
    }
    out.push_str("\nand then  gyrospec roll-error compass.toml --sea jonswap --period 9s --card\n");
    out
}

/// U of the built-in model of that name.
fn turns_with() -> f64 {
    let parameters = Model::builtin("gyrosphere").map(|m| m.parameters).unwrap_or_default();
    parameters.iter().find(|p| p.name == "U").map_or(f64::NAN, |p| p.value)
}

fn unit(name: &str) -> &'static str {
    crate::gyro::range::of_compass(name).map_or("", |range| range.unit)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rolling::Compass;

    #[test]
    fn the_file_that_it_shows_is_the_papers_compass() {
        let text = instruments_text();
        let file: String = text
            .lines()
            .skip_while(|l| *l != "[parameters]")
            .take(9)
            .fold(String::new(), |f, l| f + l + "\n");
        let compass = Compass::parse(&file).unwrap();
        assert_eq!(compass.sphere, Gyrosphere::seed());
        assert_eq!(compass.origin.given.len(), WANTED.len());
        // as printed, in CGS: 8.5e6 dyn, 1.55e8 g·cm²/s, 13.5e7 dyn/cm, 0.44 s
        for says in ["P   =        85 N", "H   =      15.5 N*m*s", "C0  =    135000 N/m", "T   =      0.44 s"]
        {
            let line = text.lines().find(|l| l.contains(says)).unwrap_or_else(|| panic!("{says}: {text}"));
            assert!(line.ends_with("as printed"), "{line}");
        }
        let s = Gyrosphere::seed();
        let w = std::f64::consts::TAU / (84.4 * 60.0);
        let schuler = s.momentum * w * w / (s.earth_rate * s.latitude.cos());
        assert!((schuler / s.pendulous - 1.0).abs() < 0.005, "{schuler}");
    }
}
