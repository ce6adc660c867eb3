//! The program `gyrospec`: see `gyrospec help`.

use std::process::ExitCode;

fn main() -> ExitCode {
    gyrospec::cli::main()
}
