//! Changes between two steps: bodies come and go, joints break, the mouse pulls, a cell gets another
//! value. Rows stay dense and in order, so that a run with removals is as reproducible as any.

use ch00_scenes::{Body as SceneBody, Cell, Edit, RemoveError, RowId, Scene, TableError};
use glam::Quat;
use thiserror::Error;

use super::World;
use super::load::{push_body, row_of, velocity_of};
use crate::columns::{AnyTable, Table};
use crate::data::{Bodies, NONE, Spring, place_of};
use crate::plan::{Part, Plan};
use crate::systems::resolving::let_go;

/// Names a body for as long as it lives.
pub type BodyId = RowId;

/// Names a joint for as long as it holds.
pub type JointId = RowId;

// ANCHOR: error
/// Why a world can't be changed. Nothing has changed then.
#[derive(Clone, Debug, Error, PartialEq, Eq)]
pub enum ChangeError {
    /// Rows can't come or go while systems have their columns.
    #[error("a row can't be added or removed during a step (in `{system}`); wait until it is over")]
    DuringStep {
        /// The system that runs, or has just run.
        system: &'static str,
    },
    /// The ID names nothing any more.
    #[error(transparent)]
    Row(#[from] TableError),
    /// Something holds the body.
    #[error(transparent)]
    Held(#[from] RemoveError),
}
// ANCHOR_END: error

impl World {
    /// Fails while a step runs.
    fn check_between_steps(&self) -> Result<(), ChangeError> {
        self.running
            .map_or(Ok(()), |system| Err(ChangeError::DuringStep { system }))
    }

    // ANCHOR: add
    /// Adds a body to a world of `scene`, which doesn't hold it yet; gives its ID. If the body needs
    /// columns that the plan has left out, the plan takes them in.
    ///
    /// # Errors
    /// [`ChangeError::DuringStep`].
    pub fn add(&mut self, scene: &Scene, body: &SceneBody) -> Result<BodyId, ChangeError> {
        self.check_between_steps()?;
        let mut with_it = scene.clone();
        with_it.bodies.push(body.clone());
        let plan = Plan::of(&with_it, self.surroundings.method);
        self.widen(scene, &plan);
        let id = push_body(&mut self.data, body);
        let row = self.data.bodies.rows() - 1;
        self.broad.obstacles_for = None;
        self.gather();
        self.set_velocity(row, velocity_of(body));
        Ok(id)
    }
    // ANCHOR_END: add

    // ANCHOR: widen
    /// Takes in what a wider plan has. A column that was left out had no effect, so its values are those
    /// that the scene's bodies began with.
    pub fn widen(&mut self, scene: &Scene, plan: &Plan) {
        let wider = self.plan.joined(plan);
        if wider == self.plan {
            return;
        }
        let before = std::mem::replace(&mut self.plan, wider);
        self.plan.apply(&mut self.data);
        let mut fresh = Bodies::default();
        for body in &scene.bodies {
            fresh.push(row_of(body));
        }
        for (place, spec) in Bodies::COLUMNS.iter().enumerate() {
            let was_out = before.why_left_out(Bodies::NAME, spec.name).is_some();
            if was_out && self.plan.why_left_out(Bodies::NAME, spec.name).is_none() {
                let column = self.data.bodies.column_mut(place);
                column.copy_from(fresh.column(place));
            }
        }
        self.gather();
    }
    // ANCHOR_END: widen

    // ANCHOR: remove
    /// Removes a body. The rows after it move up by one in every table that names them; IDs stay.
    ///
    /// # Errors
    /// [`ChangeError`] during a step, for an ID that names nothing, and for a body that something
    /// holds.
    pub fn remove(&mut self, body: BodyId) -> Result<(), ChangeError> {
        self.check_between_steps()?;
        let row = self.row(body)?;
        self.check_free(row)?;
        let mut keep = vec![true; self.data.bodies.rows()];
        keep[row] = false;
        self.data.bodies.retain_rows(&keep);
        self.data.motions.retain_rows(&keep);
        self.move_up_after(row as u32);
        Ok(())
    }
    // ANCHOR_END: remove

    /// Fails if a joint or a force names the body.
    fn check_free(&self, row: usize) -> Result<(), RemoveError> {
        let data = &self.data;
        let joints = &data.joints;
        let ends = joints.parent.iter().zip(joints.child.iter());
        let holds = |(&parent, &child): (&u32, &u32)| [parent, child].contains(&(row as u32));
        let held_by = ends.zip(joints.scene_joint.iter());
        let held_by = held_by.filter(|(ends, _)| holds(*ends));
        if let Some(&joint) = held_by.map(|(_, joint)| joint).min() {
            let joint = joint as usize;
            return Err(RemoveError::HeldByJoint { body: row, joint });
        }
        let at = |column: &[u32]| column.iter().position(|&named| named as usize == row);
        let pole = at(&data.poles.body).map(|k| data.poles.force[k]);
        let held = || at(&data.fixed_points.body).map(|k| data.fixed_points.force[k]);
        let pushed = || at(&data.pushes.body).map(|k| data.pushes.force[k]);
        if let Some(force) = pole.or_else(held).or_else(pushed) {
            let force = force as usize;
            return Err(RemoveError::HeldByForce { body: row, force });
        }
        Ok(())
    }

    /// Names of rows after a removed one, in all tables that name bodies.
    fn move_up_after(&mut self, gone: u32) {
        let data = &mut self.data;
        let touches = |c: usize| data.contacts.a[c] == gone || data.contacts.b[c] == gone;
        let keep: Vec<bool> = (0..data.contacts.rows()).map(|c| !touches(c)).collect();
        let rows = keep.iter().filter(|&&kept| kept).count();
        data.contacts.retain_rows(&keep);
        data.contacts.ids_mut().set_rows(rows);
        data.touches.clear();
        if data.springs.body.contains(&gone) {
            data.springs.clear();
        }
        self.involved.retain(|&row| row != gone);
        let columns = [
            &mut data.contacts.a[..],
            &mut data.contacts.b,
            &mut data.joints.parent,
            &mut data.joints.child,
            &mut data.poles.body,
            &mut data.fixed_points.body,
            &mut data.pushes.body,
            &mut data.springs.body,
            &mut self.involved,
        ];
        for row in columns.into_iter().flatten() {
            *row -= u32::from(*row > gone);
        }
        for (a, b) in &mut self.broad.ignored {
            *a -= usize::from(*a > gone as usize);
            *b -= usize::from(*b > gone as usize);
        }
        self.broad.pairs.clear();
        self.broad.boxes.clear();
    }

    /// Removes a joint, with its pin or rod and its limit. Its bodies may touch from now on.
    ///
    /// # Errors
    /// [`ChangeError`] during a step, and for an ID that names nothing.
    pub fn remove_joint(&mut self, joint: JointId) -> Result<(), ChangeError> {
        self.check_between_steps()?;
        let stale = || TableError::Stale {
            table: self.data.joints.name().to_owned(),
            row: joint,
        };
        let row = self.data.joints.ids().row(joint).ok_or_else(stale)?;
        self.unhook_parts(row);
        let data = &mut self.data;
        let pair = |j: usize| {
            let (a, b) = (
                data.joints.parent[j] as usize,
                data.joints.child[j] as usize,
            );
            (a.min(b), a.max(b))
        };
        let free = pair(row);
        if (0..data.joints.rows()).all(|j| j == row || pair(j) != free) {
            self.broad.ignored.retain(|&pair| pair != free);
        }
        let index = data.joints.scene_joint[row];
        data.joints.retain_rows(&all_but(data.joints.rows(), row));
        for later in data.joints.scene_joint.iter_mut() {
            *later -= u32::from(*later > index);
        }
        for bound in [&mut data.trees.first, &mut data.trees.end] {
            for place in bound.iter_mut() {
                *place -= u32::from(*place as usize > row);
            }
        }
        Ok(())
    }

    /// Removes what a joint is made of; what comes after it moves up.
    fn unhook_parts(&mut self, row: usize) {
        let data = &mut self.data;
        let (kind, part, limit) = (
            data.joints.kind[row],
            data.joints.part[row],
            data.joints.limit[row],
        );
        let parts: &mut dyn AnyTable = if kind == 0 {
            &mut data.pins
        } else {
            &mut data.rods
        };
        parts.retain_rows(&all_but(parts.rows(), part as usize));
        let rows = data.joints.rows();
        for other in (0..rows).filter(|&other| data.joints.kind[other] == kind) {
            data.joints.part[other] -= u32::from(data.joints.part[other] > part);
        }
        if limit != NONE {
            data.limits
                .retain_rows(&all_but(data.limits.rows(), limit as usize));
            let of_limit = |turn: usize| turn / ch04_ragdolls::MOST_ROWS == limit as usize;
            let keep: Vec<bool> = (0..data.turns.rows()).map(|turn| !of_limit(turn)).collect();
            data.turns.retain_rows(&keep);
            for named in data.joints.limit.iter_mut().filter(|named| **named != NONE) {
                *named -= u32::from(*named > limit);
            }
        }
    }

    /// Ties a body of `scene` to the mouse: the point `anchor` of it, m, to `target` in the world, m; or
    /// lets go. The plan takes in what a pull needs.
    pub fn pull(&mut self, scene: &Scene, pull: Option<ch00_scenes::Pull>) {
        self.data.springs.clear();
        let Some(pull) = pull.filter(|pull| pull.body < self.data.bodies.rows()) else {
            return;
        };
        let plan = self.plan.clone().with(Part::Mouse);
        self.widen(scene, &plan);
        self.data.springs.push(Spring {
            body: pull.body as u32,
            anchor: pull.anchor.as_vec3(),
            target: pull.target.as_vec3(),
            mass: scene.bodies[pull.body].mass as f32,
        });
    }

    // ANCHOR: edit
    /// Gives a cell another value; gives the value that it had. A body that is put elsewhere keeps its
    /// velocities: p* and q* follow.
    ///
    /// # Errors
    /// [`TableError`] for a cell that there isn't or that can't take the value.
    pub fn edit(&mut self, edit: &Edit) -> Result<Cell, TableError> {
        let (place, row) = self.cell_of(edit)?;
        let value = self.checked(edit)?;
        let moves_body = matches!(edit.column.as_str(), "position" | "orientation");
        let velocity = moves_body.then(|| self.velocity(row));
        let column = self.data.table_mut(&edit.table)?.column_mut(place);
        let old = column.cell(row).unwrap_or(value);
        column.set_cell(row, value);
        if let Some(velocity) = velocity {
            let_go(&mut self.data.bodies, row);
            self.gather();
            self.set_velocity(row, velocity);
            self.broad.obstacles_for = None;
        }
        Ok(old)
    }
    // ANCHOR_END: edit

    /// The place of the column and the row that an edit names.
    fn cell_of(&self, edit: &Edit) -> Result<(usize, usize), TableError> {
        let table = self.data.table(&edit.table)?;
        let place = place_of(table, &edit.column)?;
        self.column(&edit.table, &edit.column)?;
        let not_editable = |why: &str| TableError::NotEditable {
            table: edit.table.clone(),
            column: edit.column.clone(),
            why: why.to_owned(),
        };
        if !table.specs()[place].editable {
            return Err(not_editable(
                "other columns or the next step follow from it",
            ));
        }
        if self.running.is_some() {
            return Err(not_editable("a step is running"));
        }
        let row = table.ids().row(edit.row).ok_or_else(|| TableError::Stale {
            table: edit.table.clone(),
            row: edit.row,
        })?;
        Ok((place, row))
    }

    /// The value, if the column can take it.
    fn checked(&self, edit: &Edit) -> Result<Cell, TableError> {
        let bad = |what: String| TableError::BadValue {
            table: edit.table.clone(),
            column: edit.column.clone(),
            what,
        };
        let table = self.data.table(&edit.table)?;
        let kind = table.specs()[place_of(table, &edit.column)?].kind;
        if edit.value.kind() != kind {
            return Err(bad(format!(
                "it holds a {kind:?}, not a {:?}",
                edit.value.kind()
            )));
        }
        if edit
            .value
            .numbers()
            .iter()
            .any(|number| !number.is_finite())
        {
            return Err(bad("a number must be finite".to_owned()));
        }
        match (edit.value, edit.column.as_str()) {
            (Cell::Quaternion(q), _) => {
                let q = Quat::from_array(q);
                if (q.length() - 1.0).abs() > 0.01 {
                    return Err(bad(format!("its length is {}, not 1", q.length())));
                }
                Ok(Cell::Quaternion(q.normalize().to_array()))
            }
            (Cell::Scalar(e), "restitution") if !(0.0..=1.0).contains(&e) => {
                Err(bad(format!("{e} is not between 0 and 1")))
            }
            (Cell::Scalar(mu), "friction" | "static_friction") if mu < 0.0 => {
                Err(bad(format!("{mu} is below 0")))
            }
            (value, _) => Ok(value),
        }
    }
}

/// Marks for all rows but one.
fn all_but(rows: usize, gone: usize) -> Vec<bool> {
    (0..rows).map(|row| row != gone).collect()
}
