//! A virtual X display with the top binary's window on it, and someone who presses keys.

use std::io::{BufRead, BufReader, Read};
use std::path::PathBuf;
use std::process::{Child, Command, ExitStatus, Stdio};
use std::sync::mpsc;
use std::time::{Duration, Instant};

use crate::picture::Picture;

/// Width of the screen and, at the start, of the window, pixels.
pub const WIDTH: u32 = 1280;

/// Height of the screen and, at the start, of the window, pixels.
pub const HEIGHT: u32 = 720;

/// How long the program may take to show its first frame. Tests run beside other tests, so
/// this is no measurement, only the end of patience.
const PATIENCE: Duration = Duration::from_mins(1);

/// A screen and the program on it; both end with it.
pub struct Desktop {
    server: Child,
    display: String,
    program: Child,
    window: String,
    folder: tempfile::TempDir,
    shots: u32,
}

impl Desktop {
    /// Starts a screen, and the top binary on it; returns when its first frame is shown.
    pub fn with_window(args: &[&str]) -> Self {
        let (server, display) = start_server();
        let mut program = Command::new(top_binary())
            .args(args)
            .env("DISPLAY", &display)
            .env_remove("WAYLAND_DISPLAY")
            .env_remove("WAYLAND_SOCKET")
            .stdout(Stdio::null())
            .stderr(Stdio::piped())
            .spawn()
            .unwrap_or_else(|e| panic!("{}: {e}", top_binary().display()));
        let output = program.stderr.take().expect("it was asked for");
        let mut desktop = Self {
            server,
            display,
            program,
            window: String::new(),
            folder: tempfile::tempdir().expect("a folder for pictures"),
            shots: 0,
        };
        await_first_frame(output);
        let title = "From Objects to Shaders";
        desktop.window = desktop.xdotool(&["search", "--onlyvisible", "--name", title]);
        desktop.focus();
        desktop
    }

    /// What is on the screen.
    pub fn screenshot(&mut self) -> Picture {
        self.shots += 1;
        let file = self.folder.path().join(format!("{}.png", self.shots));
        let path = file.to_string_lossy().into_owned();
        self.tool("import", &["-window", "root", &path]);
        Picture::load(&file)
    }

    /// Presses and releases a key.
    pub fn press(&self, key: &str) {
        self.xdotool(&["key", key]);
    }

    /// Drags the mouse with its left button from one pixel to another.
    pub fn drag(&self, from: [u32; 2], to: [u32; 2]) {
        let place = |[x, y]: [u32; 2]| [x.to_string(), y.to_string()];
        let ([x, y], [x2, y2]) = (place(from), place(to));
        self.xdotool(&["mousemove", &x, &y, "mousedown", "1"]);
        self.xdotool(&["mousemove", &x2, &y2, "mouseup", "1"]);
    }

    /// Gives the window another size, pixels.
    pub fn resize(&self, width: u32, height: u32) {
        let (width, height) = (width.to_string(), height.to_string());
        self.xdotool(&["windowsize", "--sync", &self.window, &width, &height]);
    }

    /// Takes the window off the screen, and the keyboard with it.
    pub fn hide(&self) {
        self.xdotool(&["windowunmap", "--sync", &self.window]);
    }

    /// Puts the window back onto the screen.
    pub fn show(&self) {
        self.show_without_keyboard();
        self.focus();
    }

    /// Puts the window back onto the screen; keys don't go there.
    pub fn show_without_keyboard(&self) {
        self.xdotool(&["windowmap", "--sync", &self.window]);
    }

    /// Gives the window the keyboard while a key is held that was pressed elsewhere.
    pub fn focus_with_a_key_held(&self, key: &str) {
        self.xdotool(&["keydown", key]);
        self.focus();
        std::thread::sleep(Duration::from_millis(500));
        self.xdotool(&["keyup", key]);
    }

    /// Gives the window the keyboard: there is no window manager here to do it.
    fn focus(&self) {
        self.xdotool(&["windowfocus", "--sync", &self.window]);
    }

    /// Closes the window with its key and gives the program's exit status.
    pub fn close(&mut self) -> ExitStatus {
        self.press("ctrl+q");
        let end = Instant::now() + PATIENCE;
        while Instant::now() < end {
            if let Some(status) = self.program.try_wait().expect("it was started") {
                return status;
            }
            std::thread::sleep(Duration::from_millis(50));
        }
        panic!("the program is still running after its window was closed");
    }

    fn xdotool(&self, args: &[&str]) -> String {
        self.tool("xdotool", args)
    }

    /// Runs a program on this screen and gives what it prints.
    fn tool(&self, program: &str, args: &[&str]) -> String {
        let output = Command::new(program)
            .args(args)
            .env("DISPLAY", &self.display)
            .output()
            .unwrap_or_else(|e| panic!("{}", missing(program, &e)));
        let said = String::from_utf8_lossy(&output.stderr);
        assert!(output.status.success(), "{program} {args:?}: {said}");
        String::from_utf8_lossy(&output.stdout).trim().to_owned()
    }
}

impl Drop for Desktop {
    fn drop(&mut self) {
        for child in [&mut self.program, &mut self.server] {
            // It may have ended by itself.
            let _ = child.kill();
            let _ = child.wait();
        }
    }
}

/// Starts an X server on a display that is free; it says which.
fn start_server() -> (Child, String) {
    let screen = format!("{WIDTH}x{HEIGHT}x24");
    let mut server = Command::new("Xvfb")
        .args([
            "-displayfd",
            "1",
            "-screen",
            "0",
            &screen,
            "-nolisten",
            "tcp",
            "-r", // a key that is held doesn't repeat
        ])
        .stdout(Stdio::piped())
        .stderr(Stdio::null())
        .spawn()
        .unwrap_or_else(|e| panic!("{}", missing("Xvfb", &e)));
    let output = server.stdout.take().expect("it was asked for");
    let mut number = String::new();
    BufReader::new(output)
        .read_line(&mut number)
        .expect("Xvfb says its display");
    assert!(!number.trim().is_empty(), "Xvfb found no free display");
    (server, format!(":{}", number.trim()))
}

/// Returns when the program has said that its first frame is shown.
fn await_first_frame(output: impl Read + Send + 'static) {
    let (sender, receiver) = mpsc::channel();
    // Reads to the end, so that the program never waits for a reader.
    std::thread::spawn(move || {
        for line in BufReader::new(output).lines().map_while(Result::ok) {
            let _ = sender.send(line);
        }
    });
    let end = Instant::now() + PATIENCE;
    let mut said = Vec::new();
    while let Ok(line) = receiver.recv_timeout(end.saturating_duration_since(Instant::now())) {
        if line.contains("first frame after") {
            return;
        }
        said.push(line);
    }
    panic!(
        "no window (a software Vulkan device must be installed: mesa-vulkan-drivers). \
         The program said:\n{}",
        said.join("\n")
    );
}

/// The top binary beside this test's own folder.
pub fn top_binary() -> PathBuf {
    let test = std::env::current_exe().expect("a test has a path");
    let folder = test.ancestors().nth(2).expect("tests lie in deps");
    let binary = folder
        .join("ch07_findings")
        .with_extension(std::env::consts::EXE_EXTENSION);
    assert!(
        binary.exists(),
        "{} is missing: run `cargo build -p ch07_findings` first",
        binary.display()
    );
    binary
}

fn missing(program: &str, error: &std::io::Error) -> String {
    format!("{program}: {error}; install xvfb, xdotool and imagemagick")
}
