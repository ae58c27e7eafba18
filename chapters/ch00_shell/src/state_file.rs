//! The file of states that `--dump` asks for, written as a run goes on.

use ch00_scenes::SceneError;
use ch00_scenes::dump::DumpWriter;

use crate::headless::Dump;
use crate::session::Session;

/// An open file of states, or none.
pub(crate) struct StateFile(Option<Open>);

struct Open {
    writer: DumpWriter,
    every: u64,
}

impl StateFile {
    /// Creates the file, if one is wanted, and writes the state before the first step.
    pub(crate) fn create(dump: Option<&Dump>, session: &Session) -> Result<Self, SceneError> {
        let Some(Dump { file, every }) = dump else {
            return Ok(Self(None));
        };
        let real_size = session.engine().info().real_size;
        let mut writer = DumpWriter::create(file, session.state_now().len(), real_size)?;
        writer.frame(0, session.state_now())?;
        Ok(Self(Some(Open {
            writer,
            every: u64::from(*every),
        })))
    }

    /// Writes the state now, if it is its turn or the last.
    pub(crate) fn write(&mut self, session: &Session, last: u32) -> Result<(), SceneError> {
        let Some(open) = &mut self.0 else {
            return Ok(());
        };
        let step = session.steps();
        if !step.is_multiple_of(open.every) && step != u64::from(last) {
            return Ok(());
        }
        let step = u32::try_from(step).unwrap_or(u32::MAX);
        open.writer.frame(step, session.state_now())
    }

    /// Writes what is still in memory.
    pub(crate) fn finish(self) -> Result<(), SceneError> {
        self.0.map_or(Ok(()), |open| open.writer.finish())
    }
}
