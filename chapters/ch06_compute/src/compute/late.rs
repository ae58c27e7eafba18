//! States that come down late: asked for now, here some frames later, and nobody waits for them.

use std::cell::Cell;

use ch00_scenes::State;

use super::driver::Driver;
use super::tables::Tables;
use crate::rows::{Drawn, Seen};
use crate::stream::{self, Passes, Readback, StreamError};

/// A state on its way.
#[derive(Debug, Default)]
pub struct Late {
    drawn: Readback,
    seen: Readback,
    status: Readback,
    /// What has arrived of the last request.
    parts: Parts,
    is_asked: bool,
    /// Requests from before are for bodies that have been put elsewhere since.
    oldest: u64,
    asked: u64,
    /// The columns that somebody looks at.
    pub tables: Tables,
    /// The step of the state that is known.
    pub known: Cell<Option<u32>>,
}

#[derive(Debug, Default)]
struct Parts {
    drawn: Option<stream::Late<Drawn>>,
    seen: Option<stream::Late<Seen>>,
    status: Option<stream::Late<u32>>,
}

impl Late {
    /// What is on its way is no longer true.
    pub fn forget(&mut self) {
        self.oldest = self.asked + 1;
        self.is_asked = false;
        self.parts = Parts::default();
        self.tables.forget();
        self.known.set(None);
    }

    /// For the columns of a driver, whose state after so many steps is known.
    #[must_use]
    pub fn of(driver: &Driver, step: u32) -> Self {
        Self {
            tables: Tables::of(driver.columns()),
            known: Cell::new(Some(step)),
            ..Self::default()
        }
    }

    // ANCHOR: glance
    /// Asks for the state after the last step, or looks whether it has come; gives the step that it is of.
    ///
    /// # Errors
    /// A lost device.
    pub fn glance(
        &mut self,
        driver: &mut Driver,
        step: u32,
    ) -> Result<Option<(u32, State)>, StreamError> {
        if !self.is_asked {
            self.ask(driver, step)?;
            return Ok(None);
        }
        driver.columns().gpu().poll()?;
        let all_tables = self.take();
        let Parts {
            drawn: Some(drawn),
            seen: Some(seen),
            status: Some(status),
        } = &self.parts
        else {
            return Ok(None);
        };
        if !all_tables {
            return Ok(None);
        }
        let state = state_of(&drawn.rows, &seen.rows);
        let step = (drawn.frame & u64::from(u32::MAX)) as u32;
        let again = driver.take_status(&status.rows)?;
        self.is_asked = false;
        self.parts = Parts::default();
        if !again {
            self.tables.keep(step);
            self.known.set(Some(step));
        }
        Ok((!again).then_some((step, state)))
    }
    // ANCHOR_END: glance

    fn ask(&mut self, driver: &Driver, step: u32) -> Result<(), StreamError> {
        self.asked += 1;
        let label = self.asked << 32 | u64::from(step);
        let columns = driver.columns();
        let mut passes = Passes::new(columns);
        let mut all = true;
        for (readback, name) in [
            (&mut self.drawn, "drawn"),
            (&mut self.seen, "seen"),
            (&mut self.status, "status"),
        ] {
            let rows = columns.info(name)?.rows;
            all &= passes.read_back(readback, name, 0..rows, label)?;
        }
        self.tables.ask(columns, &mut passes, label)?;
        passes.submit()?;
        self.is_asked = all;
        Ok(())
    }

    /// Keeps what has arrived of the last request; whether all columns have.
    fn take(&mut self) -> bool {
        let (oldest, asked) = (self.oldest, self.asked);
        let is_new = |label: u64| label >> 32 >= oldest && label >> 32 == asked;
        if let Some(late) = self
            .drawn
            .latest()
            .filter(|late: &stream::Late<Drawn>| is_new(late.frame))
        {
            self.parts.drawn = Some(late);
        }
        if let Some(late) = self
            .seen
            .latest()
            .filter(|late: &stream::Late<Seen>| is_new(late.frame))
        {
            self.parts.seen = Some(late);
        }
        if let Some(late) = self
            .status
            .latest()
            .filter(|late: &stream::Late<u32>| is_new(late.frame))
        {
            self.parts.status = Some(late);
        }
        self.tables.take(is_new)
    }
}

/// The state that these rows are.
fn state_of(drawn: &[Drawn], seen: &[Seen]) -> State {
    let mut state = State::default();
    for (drawn, seen) in drawn.iter().zip(seen) {
        state.push(
            drawn.position.as_dvec3(),
            drawn.orientation.as_dquat().normalize(),
            seen.velocity.as_dvec3(),
            seen.angular_velocity.as_dvec3(),
        );
    }
    state
}
