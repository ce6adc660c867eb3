//! Functional Mock-up Units: models of other programs, by FMI 2.0 and 3.0.
//!
//! A unit is an archive with a description and shared libraries. It is unpacked into a folder of our own, and its library
//! is foreign code: the program runs it in a process of its own, so that its crash is a message.
//!
//! A unit for model exchange is a function here: rates and outputs from time, states, inputs and parameters, which the
//! solver calls and terms may be added to. One for co-simulation, or one whose events move its states, is stepped as a
//! whole (`course`), and only its outputs are known.
//!
//! # References
//! Functional Mock-up Interface Specification 2.0.4 and 3.0.1, Modelica Association.

mod archive;
mod course;
mod description;
mod exchange;
mod seat;
mod xml;

pub(crate) use course::{Course, Drive};
pub(crate) use description::{Role, Variable};
pub(crate) use exchange::{Exchange, Scalar};
pub(crate) use seat::Place;

use crate::record::Source;
use crate::{Error, Result};
use description::Description;
use gyrospec_fmi::{Kind, Library, Version};
use std::path::{Path, PathBuf};
use std::sync::{Arc, Mutex, PoisonError};
use tempfile::TempDir;

/// The variable of the environment that names the folder into which units are unpacked, where somebody else takes it
/// away.
pub(crate) const FOLDER: &str = "GYROSPEC_FMU_FOLDER";

/// A unit that is unpacked and loaded.
pub(crate) struct Fmu {
    pub description: Description,
    pub source: Source,
    /// What it is used for.
    pub kind: Kind,
    library: Arc<Library>,
    folder: TempDir,
    refusal: Mutex<Option<String>>,
}

/// Units that this process has loaded: a library cannot be loaded twice with a state of its own.
static LOADED: Mutex<Vec<Arc<Fmu>>> = Mutex::new(Vec::new());

impl Fmu {
    /// Loads a unit, once a process.
    ///
    /// # Errors
    /// A damaged archive, a description that cannot be read, a platform that is missing, a library that does not load.
    pub fn load(path: &Path) -> Result<Arc<Self>> {
        let path = std::path::absolute(path).unwrap_or_else(|_| path.to_owned());
        let bytes = std::fs::read(&path).map_err(|e| Error::io(&path, &e))?;
        let source = Source::of(&path, &bytes);
        drop(bytes);
        let mut all = LOADED.lock().unwrap_or_else(PoisonError::into_inner);
        if let Some(known) = all.iter().find(|f| f.source == source) {
            return Ok(known.clone());
        }
        let unit = Arc::new(Self::of(&path, source).map_err(|e| e.with_file(&path))?);
        if all.is_empty() {
            gyrospec_fmi::at_exit(take_folders_away);
        }
        all.push(unit.clone());
        Ok(unit)
    }

    fn of(path: &Path, source: Source) -> Result<Self> {
        let folder = archive::unpack(path)?;
        let file = folder.path().join("modelDescription.xml");
        let text = std::fs::read_to_string(&file).map_err(|_| {
            Error::bad_input("the archive has no modelDescription.xml in UTF-8").with_hint("is it an FMU?")
        })?;
        let again = "export the FMU once more: this is for the tool that made it to mend";
        let description =
            Description::read(&text).map_err(|e| if e.hint().is_none() { e.with_hint(again) } else { e })?;
        let is_exchange =
            description.exchange.is_some() && !(description.resets && description.simulation.is_some());
        let kind = if is_exchange { Kind::ModelExchange } else { Kind::CoSimulation };
        let interface =
            description.exchange.as_ref().filter(|_| is_exchange).or(description.simulation.as_ref());
        let identifier = interface.map(|i| i.identifier.clone()).unwrap_or_default();
        let library = binary(folder.path(), description.version, &identifier)?;
        let library = Library::load(&library, description.version, kind)
            .map_err(|e| {
                let there = listed(&folder.path().join("binaries"));
                Error::bad_input(format!("the library of this FMU does not load: {e}")).with_hint(format!(
                    "its libraries are for {there}; export it once more for this machine, with all that its library needs"
                ))
            })?;
        Ok(Self { description, source, kind, library, folder, refusal: Mutex::new(None) })
    }

    /// The folder that an instance finds its resources in.
    fn resources(&self) -> PathBuf {
        self.folder.path().join("resources")
    }

    /// Remembers why a call was refused.
    fn refused(&self, why: &str) {
        self.refusal.lock().unwrap_or_else(PoisonError::into_inner).get_or_insert_with(|| why.to_owned());
    }
}

/// Units stay loaded to the end of the process; then what they were unpacked into goes.
extern "C" fn take_folders_away() {
    for unit in LOADED.try_lock().iter().flat_map(|all| all.iter()) {
        let _ = std::fs::remove_dir_all(unit.folder.path());
    }
}

/// Where the library for this machine lies.
fn binary(folder: &Path, version: Version, identifier: &str) -> Result<PathBuf> {
    let (system, old, ending) = match std::env::consts::OS {
        "windows" => ("windows", "win64", "dll"),
        "macos" => ("darwin", "darwin64", "dylib"),
        _ => ("linux", "linux64", "so"),
    };
    let machine = std::env::consts::ARCH;
    let wanted = match (version, machine) {
        (Version::Two, "x86_64") => old.to_owned(),
        _ => format!("{machine}-{system}"),
    };
    if identifier.contains(['/', '\\']) || identifier == ".." {
        return Err(Error::bad_input(format!("its library has the name {identifier:?}, which is a path")));
    }
    let binaries = folder.join("binaries");
    let file = binaries.join(&wanted).join(format!("{identifier}.{ending}"));
    if file.is_file() {
        return Ok(file);
    }
    let own = listed(&binaries.join(&wanted));
    if !own.is_empty() {
        return Err(Error::bad_input(format!(
            "modelDescription.xml names the library {identifier}.{ending}, and binaries/{wanted} has {own}"
        ))
        .with_hint("export the FMU once more, description and library together"));
    }
    let there = listed(&binaries);
    let has = if there.is_empty() { "no library at all".into() } else { format!("libraries for {there}") };
    Err(Error::bad_input(format!("this FMU has {has}, none for this machine ({wanted})"))
        .with_hint("export it on a machine of this kind, or with its sources compiled"))
}

/// What a folder holds, in words.
fn listed(folder: &Path) -> String {
    let there = std::fs::read_dir(folder).into_iter().flatten().flatten();
    let mut names: Vec<String> = there.map(|e| e.file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names.join(", ")
}
