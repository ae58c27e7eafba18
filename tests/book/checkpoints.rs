//! Runs the commands of the `console,checkpoint` blocks and compares what they print (`main.rs` has the format).

use std::io::Read;
use std::path::{Path, PathBuf};
use std::process::{Child, Command, Stdio};
use std::time::{Duration, Instant};

use crate::markdown::{self, Fence};
use crate::{Book, Complaints};

/// A reader at a checkpoint doesn't wait longer.
const LIMIT: Duration = Duration::from_mins(2);

/// A command of a block, and the lines that should follow it.
#[derive(Debug, PartialEq)]
struct Step<'a> {
    command: String,
    expected: Vec<&'a str>,
}

/// Runs every checkpoint of the book in the folder `root`.
pub fn complaints(book: &Book, root: &Path) -> Complaints {
    let mut complaints = Vec::new();
    for page in book.chapters() {
        let (fences, _) = markdown::split(&page.text);
        for fence in fences.iter().filter(|f| f.info.contains(&"checkpoint")) {
            if let Err(why) = block(fence, root) {
                complaints.push(format!("{}:{}: {why}", page.name, fence.line));
            }
        }
    }
    complaints
}

/// One block.
fn block(fence: &Fence, root: &Path) -> Result<(), String> {
    let fails = match fence.info[..] {
        ["console", "checkpoint"] => false,
        ["console", "checkpoint", "fails"] => true,
        _ => return Err(format!("`{}` is no kind of block", fence.info.join(","))),
    };
    for step in steps(&fence.lines)? {
        let printed =
            run(&step.command, root, fails).map_err(|why| format!("{}: {why}", step.command))?;
        compare(&step.expected, &printed)
            .map_err(|why| format!("{}: {why}\n--- it printed\n{printed}---", step.command))?;
    }
    Ok(())
}

/// Splits a block at its `$ ` lines.
fn steps<'a>(lines: &[&'a str]) -> Result<Vec<Step<'a>>, String> {
    let mut steps: Vec<Step> = Vec::new();
    let mut goes_on = false;
    for &line in lines {
        if let Some(command) = line.strip_prefix("$ ") {
            goes_on = command.ends_with('\\');
            steps.push(Step {
                command: command.trim_end_matches('\\').to_owned(),
                expected: Vec::new(),
            });
        } else if let Some(step) = steps.last_mut() {
            if goes_on {
                goes_on = line.ends_with('\\');
                step.command += line.trim_end_matches('\\').trim_start();
            } else {
                step.expected.push(line);
            }
        } else {
            return Err("the first line must be a command: `$ …`".into());
        }
    }
    match steps.iter().find(|step| step.expected.is_empty()) {
        None if steps.is_empty() => Err("no command".into()),
        Some(step) => Err(format!("{}: no expected output", step.command)),
        None => Ok(steps),
    }
}

/// Runs a command and returns what it printed.
fn run(command: &str, root: &Path, fails: bool) -> Result<String, String> {
    writes_below_target(command)?;
    let child = shell(command)?
        .current_dir(root)
        .env_remove("DISPLAY")
        .env_remove("WAYLAND_DISPLAY")
        .env_remove("WAYLAND_SOCKET")
        .env("NO_COLOR", "1")
        .stdin(Stdio::null())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .map_err(|e| e.to_string())?;
    let (status, out, err) = finish(child)?;
    let as_wanted = match status {
        Some(0) => !fails,
        Some(1 | 2) => fails,
        _ => false,
    };
    if !as_wanted {
        let status = status.map_or("no status".into(), |s| format!("status {s}"));
        return Err(format!("ended with {status}\n{out}{err}"));
    }
    Ok(if fails { err } else { out })
}

/// Commands run in the repository: what they write goes to the folder that git ignores.
fn writes_below_target(command: &str) -> Result<(), String> {
    let words: Vec<&str> = command.split_whitespace().collect();
    for pair in words.windows(2) {
        if matches!(pair[0], "--dump" | "--screenshot") && !pair[1].starts_with("target/") {
            return Err(format!("writes {}; write below target/", pair[1]));
        }
    }
    Ok(())
}

/// `cargo run` as the binary that is already built; anything else through `sh`.
fn shell(command: &str) -> Result<Command, String> {
    let Some(rest) = command.strip_prefix("cargo run") else {
        let mut sh = Command::new("sh");
        sh.args(["-c", command]);
        return Ok(sh);
    };
    let (options, arguments) = rest.split_once(" -- ").unwrap_or((rest, ""));
    let mut binary = built().join("ch07_findings");
    let mut options = options.split_whitespace();
    while let Some(option) = options.next() {
        let mut name = || options.next().ok_or(format!("{option}: no name"));
        match option {
            "--release" | "-q" | "--quiet" => {}
            "-p" | "--package" | "--bin" => binary = built().join(name()?),
            "--example" => binary = built().join("examples").join(name()?),
            _ => {
                return Err(format!(
                    "`{option}`: the test knows -p, --bin and --example"
                ));
            }
        }
    }
    if !binary.is_file() {
        let name = binary.display();
        return Err(format!(
            "{name} is not built; `cargo build --workspace --bins --examples`"
        ));
    }
    let mut run = Command::new(binary);
    run.args(arguments.split_whitespace());
    Ok(run)
}

/// The folder of the binaries of the profile in which this test was built.
fn built() -> PathBuf {
    let test = std::env::current_exe().expect("the system names the running program");
    let folder = test.ancestors().nth(2).unwrap_or(Path::new("."));
    folder.to_path_buf()
}

/// Waits, with a limit, and collects what was printed.
fn finish(mut child: Child) -> Result<(Option<i32>, String, String), String> {
    let mut out = child.stdout.take().expect("piped");
    let mut err = child.stderr.take().expect("piped");
    std::thread::scope(|scope| {
        let out = scope.spawn(move || read_all(&mut out));
        let err = scope.spawn(move || read_all(&mut err));
        let start = Instant::now();
        let status = loop {
            match child.try_wait().map_err(|e| e.to_string())? {
                Some(status) => break status,
                None if start.elapsed() > LIMIT => {
                    child.kill().map_err(|e| e.to_string())?;
                    return Err(format!("still running after {} s", LIMIT.as_secs()));
                }
                None => std::thread::sleep(Duration::from_millis(10)),
            }
        };
        let text =
            |reader: std::thread::ScopedJoinHandle<String>| reader.join().unwrap_or_default();
        Ok((status.code(), text(out), text(err)))
    })
}

fn read_all(from: &mut impl Read) -> String {
    let mut bytes = Vec::new();
    // A pipe that breaks ends the text; the comparison then says what is missing.
    let _ = from.read_to_end(&mut bytes);
    String::from_utf8_lossy(&bytes).into_owned()
}

/// Whether the text is as expected; if not, the first line that isn't.
fn compare(expected: &[&str], printed: &str) -> Result<(), String> {
    let printed: Vec<&str> = printed.trim_end().lines().map(str::trim_end).collect();
    let expected: Vec<&str> = expected.iter().map(|line| line.trim_end()).collect();
    match mismatch(&expected, &printed) {
        None => Ok(()),
        Some(line) => Err(format!("this was expected and did not come: {line}")),
    }
}

/// The first expected line that can't be found, or a printed one too many.
fn mismatch<'a>(expected: &[&'a str], printed: &[&'a str]) -> Option<String> {
    match (expected, printed) {
        ([], []) | (["..."], _) => None,
        ([], [more, ..]) => Some(format!("(the end; but it goes on with) {more}")),
        (["...", after @ ..], _) => {
            let fits = |skip: usize| mismatch(after, &printed[skip..]).is_none();
            let found = (0..=printed.len()).any(fits);
            (!found).then(|| after.join("\n"))
        }
        ([line, expected @ ..], [first, printed @ ..]) if line_fits(line, first) => {
            mismatch(expected, printed)
        }
        ([line, ..], _) => Some((*line).to_owned()),
    }
}

/// Whether a line is as expected, where `[..]` stands for anything.
fn line_fits(expected: &str, printed: &str) -> bool {
    let mut parts = expected.split("[..]");
    let Some(mut rest) = printed.strip_prefix(parts.next().unwrap_or_default()) else {
        return false;
    };
    let parts: Vec<&str> = parts.collect();
    let Some((last, middle)) = parts.split_last() else {
        return rest.is_empty();
    };
    for part in middle {
        match rest.find(part) {
            Some(at) => rest = &rest[at + part.len()..],
            None => return false,
        }
    }
    rest.ends_with(last)
}

#[test]
fn wildcards_stand_for_anything_within_a_line_and_for_any_lines() {
    let fits = |expected: &[&str], printed| compare(expected, printed).is_ok();
    assert!(fits(&["a [..] ms", "b"], "a 0.25 ms  \nb\n"));
    assert!(fits(&["[..]x[..]y"], "1x2y"));
    assert!(fits(&["a", "...", "z"], "a\nb\nc\nz\n"));
    assert!(fits(&["..."], "a\nb\n"));
    assert!(!fits(&["a [..] ms"], "a 0.25 s"));
    assert!(!fits(&["a"], "a\nb"));
    assert!(!fits(&["a", "b"], "a"));
    assert!(!fits(&["x[..]x"], "x"));
    assert!(!fits(&["a", "...", "z"], "a\nb\nc"));
}

#[test]
fn a_block_may_hold_several_commands_and_long_ones() {
    let steps = steps(&["$ one \\", "  two", "out", "$ three", "a", "b"]).unwrap();
    assert_eq!(steps[0].command, "one two");
    assert_eq!(steps[0].expected, ["out"]);
    assert_eq!(steps[1].command, "three");
    assert_eq!(steps[1].expected, ["a", "b"]);
}
