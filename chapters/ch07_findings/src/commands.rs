//! The top binary's command line: the flags of every chapter, and `chart`, which measures and
//! writes the book's charts.

use std::fmt::Write as _;
use std::fs;
use std::io::{self, ErrorKind, Write as _};
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::Instant;

use ch00_shell::cli::{Args, examples};
use clap::{CommandFactory, FromArgMatches, Parser, Subcommand};

use crate::kept::folder_of_book;
use crate::product::{Known, known};
use crate::race;
use crate::{CHAPTER, FindingsError};

/// The command line.
#[derive(Debug, Parser)]
#[command(version, args_conflicts_with_subcommands = true)]
struct Cli {
    #[command(flatten)]
    args: Args,
    /// Run the scene on two to four engines or methods side by side; or a race of the gallery, by name
    #[arg(long, value_name = "ENGINE[:METHOD][@SUBSTEPS],…|NAME", help_heading = "How it is simulated",
          conflicts_with_all = race::NOT_FOR_A_RACE)]
    race: Option<String>,
    #[command(subcommand)]
    command: Option<Command>,
}

#[derive(Debug, Subcommand)]
enum Command {
    /// Measure the charts of the book and write them as SVG and CSV
    Chart(ChartArgs),
}

#[derive(Debug, clap::Args)]
struct ChartArgs {
    /// Which charts; all of them unless named
    #[arg(value_name = "NAME")]
    names: Vec<String>,
    /// Leave out what takes minutes
    #[arg(long)]
    quick: bool,
    /// Where the files go, instead of the book's own folder
    #[arg(long, value_name = "DIR")]
    out: Option<PathBuf>,
}

/// The program: reads the command line, runs, and says how it ended.
///
/// Exit status 0; 1 for an error, told in one paragraph; 2 for a usage error, told by clap.
#[must_use]
pub fn main() -> ExitCode {
    let mut command = command();
    let matches = command.get_matches_mut();
    match Cli::from_arg_matches(&matches) {
        Ok(cli) => report(run(&cli)),
        Err(error) => error.format(&mut command).exit(),
    }
}

fn report(outcome: Result<(), FindingsError>) -> ExitCode {
    match outcome {
        Ok(()) => ExitCode::SUCCESS,
        Err(error) => {
            eprintln!("error: {error}");
            ExitCode::FAILURE
        }
    }
}

fn run(cli: &Cli) -> Result<(), FindingsError> {
    match &cli.command {
        None => match &cli.race {
            Some(contenders) => race::run(contenders, &cli.args),
            None => Ok(ch00_shell::run_with(&CHAPTER, &cli.args, race::extras())?),
        },
        Some(Command::Chart(args)) => make_charts(args),
    }
}

/// The command line with the lists of what can be chosen.
fn command() -> clap::Command {
    let program = "cargo run --release -p ch07_findings --";
    let chart = format!(
        "\n  {program} chart --help\n      \
         measure the book's charts: which there are, and how"
    );
    Cli::command()
        .name(CHAPTER.name)
        .about(format!("{}\n\n{}", CHAPTER.title, CHAPTER.about))
        .after_help(examples(&CHAPTER) + &race::help(program) + &chart)
        .mut_subcommand("chart", |chart| {
            let mut text = "Charts:\n".to_owned();
            for one in known() {
                let _ = writeln!(text, "  {:<29} {}", one.name, one.about);
            }
            let _ = write!(
                text,
                "\nExamples:\n  {program} chart\n      all charts, into book/src/charts\n  \
                 {program} chart table1 --out charts\n      one of them, elsewhere"
            );
            chart.after_help(text)
        })
}

fn make_charts(args: &ChartArgs) -> Result<(), FindingsError> {
    let charts = chosen(&args.names)?;
    let folder = args.out.clone().unwrap_or_else(folder_of_book);
    check_writable(&folder)?;
    if cfg!(debug_assertions) {
        eprintln!("built without --release: times are not those of the book");
    }
    for chart in charts {
        let start = Instant::now();
        eprintln!("{} …", chart.name);
        let product = chart.make(args.quick, &folder, &mut |text| eprintln!("  {text}"))?;
        if let Some(page) = &product.page {
            print(page, &folder)?;
        }
        for file in product.write(&folder)? {
            eprintln!("  {}", file.display());
        }
        eprintln!("{}: {:.1} s", chart.name, start.elapsed().as_secs_f64());
    }
    Ok(())
}

/// The charts of these names, or all.
fn chosen(names: &[String]) -> Result<Vec<Known>, FindingsError> {
    let all = known();
    if names.is_empty() {
        return Ok(all);
    }
    let find = |name: &String| {
        let found = all.iter().find(|chart| chart.name == *name);
        found.cloned().ok_or_else(|| FindingsError::UnknownChart {
            name: name.clone(),
            known: all
                .iter()
                .map(|chart| chart.name.as_str())
                .collect::<Vec<_>>()
                .join(", "),
        })
    };
    names.iter().map(find).collect()
}

/// Makes the folder and a file in it, which goes again: before measuring for minutes.
fn check_writable(folder: &Path) -> Result<(), FindingsError> {
    let probe = folder.join(format!(".probe-{}", std::process::id()));
    let check = || {
        fs::create_dir_all(folder)?;
        fs::write(&probe, "")?;
        fs::remove_file(&probe)
    };
    check().map_err(|source| FindingsError::Write {
        path: folder.to_owned(),
        source,
    })
}

/// Writes to the standard output. That nobody reads it any more (`| head`) is no error.
fn print(text: &str, folder: &Path) -> Result<(), FindingsError> {
    match io::stdout().lock().write_all(text.as_bytes()) {
        Err(source) if source.kind() != ErrorKind::BrokenPipe => Err(FindingsError::Write {
            path: folder.to_owned(),
            source,
        }),
        _ => Ok(()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_command_line_is_consistent() {
        command().debug_assert();
    }

    #[test]
    fn without_names_all_charts_are_made() {
        let all = chosen(&[]).expect("nothing is asked for");
        assert_eq!(all.len(), known().len());
    }

    #[test]
    fn an_unknown_chart_is_answered_with_the_known_ones() {
        let error = chosen(&["tabel1".to_owned()]).expect_err("there is none");
        let message = error.to_string();
        for word in ["`tabel1`", "table1", "bounce", "erratum_12"] {
            assert!(message.contains(word), "{message}");
        }
    }

    #[test]
    fn flags_of_a_run_and_charts_do_not_mix() {
        let words = ["ch07_findings", "--headless", "chart"];
        assert!(command().try_get_matches_from(words).is_err());
    }
}
