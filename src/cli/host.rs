//! Purpose: run a Functional Mock-up Unit, which is foreign code, in a process of its own.
//!
//! Method: a call that names one is run by a second process of this program, with the same words and the same standard
//! streams. This one makes the folder that the unit is unpacked into, waits, takes the folder away, and turns a crash
//! into a message. The second one watches whether a call into the unit ever returns.

use super::fail;
use crate::Error;
use std::ffi::OsString;
use std::path::Path;
use std::process::{Command, ExitCode, ExitStatus};
use std::time::{Duration, Instant};

/// The folder for units: that it is set tells the second process what it is.
use crate::fmu::FOLDER;

/// Seconds that a call into a unit may take, where `GYROSPEC_FMU_SECONDS` does not say.
const LONGEST: u64 = 60;

/// Whether this is the process that units run in.
pub fn is_host() -> bool {
    std::env::var_os(FOLDER).is_some()
}

/// Runs the call in a second process, where its words name a unit; `None` where it is to be run here.
pub fn hosted(words: &[OsString]) -> Option<ExitCode> {
    if is_host() {
        watch();
        return None;
    }
    let named = words.iter().skip(1).map(Path::new).find(|w| names_unit(w))?;
    Some(run(&words[1..]).unwrap_or_else(|e| {
        fail(&Error::not_computed(format!("no process can be started for the FMU: {e}")).with_file(named))
    }))
}

/// Whether a file is a unit, or a model that begins with one.
fn names_unit(word: &Path) -> bool {
    use std::io::Read;
    // a pipe is not opened: that waits for who writes into it, and what it brings is read once
    if !std::fs::metadata(word).is_ok_and(|m| m.is_file()) {
        return false;
    }
    let Ok(mut file) = std::fs::File::open(word) else { return false };
    let mut text = Vec::new();
    // a model file is small; what is longer is a table
    if file.by_ref().take(1 << 20).read_to_end(&mut text).is_err() {
        return false;
    }
    let is_line = |l: &[u8]| {
        l.trim_ascii_start().strip_prefix(b"fmu").is_some_and(|r| r.trim_ascii_start().starts_with(b"="))
    };
    text.starts_with(b"PK\x03\x04")
        || word.extension().is_some_and(|e| e == "toml") && text.split(|b| *b == b'\n').any(is_line)
}

fn run(words: &[OsString]) -> std::io::Result<ExitCode> {
    let folder = tempfile::Builder::new().prefix("gyrospec-").tempdir()?;
    // the second process hears of an interrupt as this one does, and ends first
    let _ = ctrlc::set_handler(|| {});
    let program = std::env::current_exe()?;
    let status = Command::new(program).args(words).env(FOLDER, folder.path()).status()?;
    Ok(ended(status))
}

fn ended(status: ExitStatus) -> ExitCode {
    if let Some(code) = status.code() {
        // Windows ends a process that crashed with the number of its exception
        if let Ok(code) = u8::try_from(code) {
            return ExitCode::from(code);
        }
        return crashed(&format!("ended its process with {code:#x}"));
    }
    #[cfg(unix)]
    if let Some(signal) = std::os::unix::process::ExitStatusExt::signal(&status) {
        let name = match signal {
            4 => "an illegal instruction",
            6 => "an abort: by the library, or because memory is at its end",
            7 | 10 => "a bus error",
            8 => "an arithmetic exception",
            11 => "a segmentation fault",
            9 => "a kill from outside: as a rule, memory is at its end",
            2 | 15 => return ExitCode::from(130),
            _ => "a signal",
        };
        return crashed(&format!("crashed by {name} (signal {signal})"));
    }
    crashed("crashed")
}

fn crashed(how: &str) -> ExitCode {
    let e = Error::not_computed(format!("the process that runs the FMU {how}"));
    fail(&e.with_hint(
        "no file was written; the FMU itself is at fault as a rule: try it in the tool that made it",
    ))
}

#[allow(clippy::exit)]
/// Ends this process when a call into a unit does not return.
fn watch() {
    let said = std::env::var("GYROSPEC_FMU_SECONDS").ok().and_then(|s| s.parse().ok());
    let longest = Duration::from_secs(said.filter(|s| *s > 0).unwrap_or(LONGEST));
    let look = move || {
        let mut last = (gyrospec_fmi::calls(), Instant::now());
        loop {
            std::thread::sleep(Duration::from_millis(200));
            let now = gyrospec_fmi::calls();
            if now != last.0 || now.0 == now.1 {
                last = (now, Instant::now());
            } else if last.1.elapsed() > longest {
                let seconds = longest.as_secs();
                let e =
                    Error::not_computed(format!("a call into the FMU does not return: {seconds} s are over"));
                let _ = fail(&e.with_hint("GYROSPEC_FMU_SECONDS=600 waits longer; no file was written"));
                std::process::exit(3);
            }
        }
    };
    if let Err(e) = std::thread::Builder::new().spawn(look) {
        super::warn(&format!("nothing watches whether the FMU returns: {e}"));
    }
}
