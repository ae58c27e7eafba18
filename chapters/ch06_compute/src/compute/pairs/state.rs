//! Where bodies are and how they move, taken from the device and handed to it.

use ch00_scenes::State;

use super::Pairs;
use super::columns::{no_mouse, upload_joints, write_momenta};
use crate::rows::{Drawn, Mouse, Rigid, Seen};
use crate::stream::StreamError;

impl Pairs {
    /// Waits for all steps, and writes where every body is into `state`.
    ///
    /// # Errors
    /// As for [`Self::settle`].
    pub fn read(&mut self, state: &mut State) -> Result<(), StreamError> {
        self.settle()?;
        let rigids: Vec<Rigid> = self.columns.read("rigids")?;
        state.clear();
        for (row, rigid) in rigids.iter().enumerate() {
            let position = if self.bodies.is_static(row) {
                self.bodies.position(row)
            } else {
                rigid.position
            };
            state.push(
                position.as_dvec3(),
                rigid.attitude.as_dquat().normalize(),
                rigid.velocity.as_dvec3(),
                rigid.angular_velocity.as_dvec3(),
            );
        }
        Ok(())
    }

    /// Takes over where bodies are and how they move; what they pressed is forgotten.
    ///
    /// # Errors
    /// As for [`Self::settle`].
    pub fn write(&mut self, state: &State) -> Result<(), StreamError> {
        self.settle()?;
        self.bodies.write(state);
        let mut rigids: Vec<Rigid> = self.columns.read("rigids")?;
        for (row, rigid) in rigids.iter_mut().enumerate() {
            rigid.position = self.bodies.place[row].position;
            rigid.reach = self.bodies.place[row].reach;
            rigid.size = self.bodies.solid[row].size;
            rigid.attitude = self.bodies.attitude[row];
            rigid.velocity = self.bodies.motion[row].velocity;
            rigid.angular_velocity = self.bodies.spin[row].angular_velocity;
        }
        self.columns.write("rigids", &rigids)?;
        write_momenta(&mut self.columns, &self.bodies)?;
        upload_joints(&mut self.columns, self.bodies.rows(), &self.trees)?;
        for name in ["partners_a", "partners_b"] {
            self.columns.clear(name)?;
        }
        if self.draws {
            self.write_drawn()
        } else {
            Ok(())
        }
    }

    /// Writes rows for drawing from now on: a row [`Drawn`] a body, in column `drawn`, and a row [`Seen`]
    /// in `seen`.
    ///
    /// # Errors
    /// No memory for them.
    pub fn draw(&mut self) -> Result<(), StreamError> {
        self.draws = true;
        self.write_drawn()
    }

    /// Writes the rows for drawing as if all had stood still.
    fn write_drawn(&mut self) -> Result<(), StreamError> {
        let rows = 0..self.bodies.rows();
        let drawn = |row: usize| {
            let (position, orientation) = (self.bodies.position(row), self.bodies.attitude[row]);
            Drawn {
                position,
                orientation,
                position_last: position,
                orientation_last: orientation,
                ..Drawn::default()
            }
        };
        let seen = |row: usize| Seen {
            velocity: self.bodies.motion[row].velocity,
            angular_velocity: self.bodies.spin[row].angular_velocity,
            ..Seen::default()
        };
        let (drawn, seen): (Vec<_>, Vec<_>) = rows.map(|row| (drawn(row), seen(row))).unzip();
        self.columns.write("drawn", &drawn)?;
        self.columns.write("seen", &seen)
    }

    /// The mouse pulls from now on, or lets go.
    ///
    /// # Errors
    /// A lost device.
    pub fn pull(&mut self, mouse: Option<Mouse>) -> Result<(), StreamError> {
        self.columns
            .write("mouse", &[mouse.unwrap_or_else(no_mouse)])
    }
}
