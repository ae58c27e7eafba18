//! The top binary: every engine and every scene of the book, and its charts.

use std::process::ExitCode;

fn main() -> ExitCode {
    ch07_findings::main()
}
