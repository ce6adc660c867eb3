//! FMUs made on the spot, with the C compiler of the machine.

use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::Command;
use zip::write::SimpleFileOptions;

pub const DESCRIPTION: &str = r#"<?xml version="1.0" encoding="UTF-8"?>
<fmiModelDescription fmiVersion="2.0" modelName="mass" guid="{mass}" numberOfEventIndicators="0">
  KINDS
  <UnitDefinitions>
    <Unit name="m"><BaseUnit m="1"/></Unit><Unit name="m/s"><BaseUnit m="1" s="-1"/></Unit>
    <Unit name="m/s2"><BaseUnit m="1" s="-2"/></Unit><Unit name="kg"><BaseUnit kg="1"/></Unit>
    <Unit name="N"><BaseUnit kg="1" m="1" s="-2"/></Unit><Unit name="N.s/m"><BaseUnit kg="1" s="-1"/></Unit>
    <Unit name="N/m"><BaseUnit kg="1" s="-2"/></Unit>
  </UnitDefinitions>
  <ModelVariables>
    <ScalarVariable name="position" valueReference="1" causality="output"><Real unit="m" start="0.1"/></ScalarVariable>
    <ScalarVariable name="speed" valueReference="2" causality="local"><Real unit="m/s" start="0"/></ScalarVariable>
    <ScalarVariable name="force" valueReference="3" causality="input"><Real unit="N" start="0"/></ScalarVariable>
    <ScalarVariable name="body.m" valueReference="4" causality="parameter" variability="fixed"><Real unit="kg" start="2" min="0.1"/></ScalarVariable>
    <ScalarVariable name="d" valueReference="5" causality="parameter" variability="fixed"><Real unit="N.s/m" start="0.5"/></ScalarVariable>
    <ScalarVariable name="k" valueReference="6" causality="parameter" variability="fixed"><Real unit="N/m" start="8"/></ScalarVariable>
    <ScalarVariable name="der(position)" valueReference="7"><Real unit="m/s" derivative="1"/></ScalarVariable>
    <ScalarVariable name="der(speed)" valueReference="8"><Real unit="m/s2" derivative="2"/></ScalarVariable>
  </ModelVariables>
  <ModelStructure>
    <Outputs><Unknown index="1"/></Outputs>
    <Derivatives><Unknown index="7"/><Unknown index="8"/></Derivatives>
  </ModelStructure>
</fmiModelDescription>
"#;

pub const EXCHANGE: &str = r#"<ModelExchange modelIdentifier="mass"/>"#;
pub const SIMULATION: &str =
    r#"<CoSimulation modelIdentifier="mass" canHandleVariableCommunicationStepSize="true"/>"#;

/// The library of a mass whose calls do that after some hundred; none without a C compiler.
pub fn library(folder: &Path, wrong: &str) -> Option<Vec<u8>> {
    let (source, made) = (folder.join("unit.c"), folder.join("unit.so"));
    std::fs::write(&source, include_str!("unit.c")).unwrap();
    let define = format!("-DWRONG={wrong}");
    let compiled = Command::new("cc")
        .args(["-shared", "-fPIC", "-O1", "-w", &define, "-o"])
        .args([&made, &source])
        .status();
    let Ok(status) = compiled else {
        crate::skipped::skipped("no C compiler `cc`: FMUs made on the spot");
        return None;
    };
    assert!(status.success(), "the source of the FMU does not compile");
    Some(std::fs::read(made).unwrap())
}

/// Writes an archive.
pub fn archive(path: &Path, entries: &[(&str, &[u8])]) -> PathBuf {
    let mut zip = zip::ZipWriter::new(std::fs::File::create(path).unwrap());
    for (name, bytes) in entries {
        zip.start_file(*name, SimpleFileOptions::default()).unwrap();
        zip.write_all(bytes).unwrap();
    }
    zip.finish().unwrap();
    path.to_owned()
}

/// Where the library for this machine stands in an archive.
pub fn place() -> String {
    let (system, ending) = if cfg!(target_os = "macos") { ("darwin", "dylib") } else { ("linux", "so") };
    let folder = match std::env::consts::ARCH {
        "x86_64" => format!("{system}64"),
        other => format!("{other}-{system}"),
    };
    format!("binaries/{folder}/mass.{ending}")
}

/// An FMU of the mass.
pub fn mass(folder: &Path, kinds: &str, wrong: &str) -> Option<PathBuf> {
    let description = DESCRIPTION.replace("KINDS", kinds);
    let library = library(folder, wrong)?;
    let entries: [(&str, &[u8]); 2] =
        [("modelDescription.xml", description.as_bytes()), (&place(), &library)];
    Some(archive(&folder.join("mass.fmu"), &entries))
}
