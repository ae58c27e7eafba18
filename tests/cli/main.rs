//! The command line of the top binary, as its user meets it: exit status, what stands on the
//! standard output and the standard error, and the files that it writes.
//!
//! The tests run the built `ch07_findings` of their own profile, without a display.

mod bad_input;
mod good_runs;
mod race;

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// Runs the program in `folder` without a display.
fn run_in(folder: &Path, arguments: &[&str]) -> Ran {
    let output = Command::new(program())
        .args(arguments)
        .current_dir(folder)
        .env_remove("DISPLAY")
        .env_remove("WAYLAND_DISPLAY")
        .env_remove("WAYLAND_SOCKET")
        .output()
        .expect("the program was found and can be started");
    Ran::new(arguments, &output)
}

/// Runs the program in a folder of its own.
fn run(arguments: &[&str]) -> Ran {
    run_in(folder().path(), arguments)
}

/// An empty folder that goes away with the test.
fn folder() -> tempfile::TempDir {
    tempfile::tempdir().expect("a folder for temporary files")
}

/// What a run of the program came to.
struct Ran {
    command: String,
    status: Option<i32>,
    out: String,
    err: String,
}

impl Ran {
    fn new(arguments: &[&str], output: &Output) -> Self {
        Self {
            command: arguments.join(" "),
            status: output.status.code(),
            out: String::from_utf8_lossy(&output.stdout).into_owned(),
            err: String::from_utf8_lossy(&output.stderr).into_owned(),
        }
    }

    /// The run ended well.
    #[track_caller]
    fn succeeds(self) -> Self {
        assert_eq!(self.status, Some(0), "{}: {}", self.command, self.err);
        self
    }
}

/// The built program: beside the folder in which this test lies.
fn program() -> PathBuf {
    let test = std::env::current_exe().expect("the system names the running program");
    let profile = test.ancestors().nth(2).unwrap_or(Path::new("."));
    let program = profile.join(format!("ch07_findings{}", std::env::consts::EXE_SUFFIX));
    assert!(
        program.is_file(),
        "{} is missing: build it in the profile of this test, with `cargo build -p ch07_findings`",
        program.display()
    );
    program
}
