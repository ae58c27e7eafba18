//! What a window's user can do to bodies: throw one in, take hold of one and pull it, take one out.

use ch00_scenes::Pull;
use glam::DVec3;

use super::Stage;
use crate::ShellError;
use crate::camera::Ray;
use crate::picking::{Hit, pick};
use crate::show::Pair;
use crate::throw::thrown_ball;

impl Stage {
    /// Throws a ball along the line of sight, from before the scene into its middle.
    pub fn throw_ball(&mut self) {
        let sight = self.sight(self.viewport.origin + 0.5 * self.viewport.size);
        let ball = thrown_ball(self.session.scene(), &self.surroundings, sight, self.thrown);
        self.thrown += 1;
        let outcome = self.session.add_body(ball);
        self.report(outcome.map(drop).map_err(ShellError::from));
    }

    /// The body under a line of sight, and how far away.
    #[must_use]
    pub fn under(&self, sight: Ray) -> Option<Hit> {
        pick(&self.session, self.alpha(), &self.surroundings, sight)
    }

    /// Picks the body under a line of sight and takes hold of it; whether there is one that
    /// can move.
    pub fn grab(&mut self, sight: Ray) -> bool {
        if self.beside.is_some() {
            return false;
        }
        let moves = |hit: &Hit| !self.session.scene().bodies[hit.body].is_static();
        let Some(Hit { body, distance }) = self.under(sight).filter(moves) else {
            return false;
        };
        self.picked = Some(body);
        let point = sight.at(distance).as_dvec3();
        let (position, orientation) = self.session.pose(body, self.alpha());
        self.set_pull(Some(Pull {
            body,
            anchor: orientation.inverse() * (point - position),
            target: point,
        }));
        true
    }

    /// Moves the end of the mouse's spring.
    pub fn pull_to(&mut self, target: DVec3) {
        if let Some(pull) = self.pull {
            self.set_pull(Some(Pull { target, ..pull }));
        }
    }

    /// Lets go of the body.
    pub fn let_go(&mut self) {
        if self.pull.is_some() {
            self.set_pull(None);
        }
    }

    fn set_pull(&mut self, pull: Option<Pull>) {
        self.pull = pull;
        self.session.pull(pull);
    }

    /// Removes the picked body, until the next reset. What was shown of the bodies after it stays with
    /// them.
    pub fn remove_picked(&mut self) {
        match self.picked {
            Some(body) => self.remove(body),
            None => self.notice = Some("click a body, then Delete removes it".to_owned()),
        }
    }

    fn remove(&mut self, body: usize) {
        // The engine holds the pulled body by its index.
        let pull = self.pull;
        self.let_go();
        let was_static = self
            .session
            .scene()
            .bodies
            .get(body)
            .is_some_and(ch00_scenes::Body::is_static);
        let outcome = self.session.remove_body(body);
        let left = |i: usize| match &outcome {
            Ok(()) if i == body => None,
            Ok(()) => Some(i - usize::from(i > body)),
            Err(_) => Some(i),
        };
        if let Some(pull) = pull
            && let Some(body) = left(pull.body)
        {
            self.set_pull(Some(Pull { body, ..pull }));
        }
        self.picked = self.picked.and_then(left);
        self.show.pair = self.show.pair.and_then(|pair| {
            let [a, b] = pair.bodies;
            let bodies = [left(a)?, left(b)?];
            Some(Pair { bodies, ..pair })
        });
        if outcome.is_ok() {
            self.surroundings
                .forget(body, was_static, self.session.scene());
            self.generation += 1;
        }
        self.report(outcome.map_err(ShellError::from));
    }
}

#[cfg(test)]
mod tests {
    use ch00_scenes::Settings;
    use glam::Vec3;

    use super::*;
    use crate::clock::Pace;
    use crate::show::Show;
    use crate::stage::tests::stage;
    use crate::test_engine::{CHAPTER, FALLING, balls, resident_balls};

    /// A line of sight at the first body.
    fn sight(stage: &Stage) -> Ray {
        let position = stage.session().state_now().position[0].as_vec3();
        Ray {
            origin: position + 10.0 * Vec3::Y,
            direction: Vec3::NEG_Y,
        }
    }

    fn stage_of_balls(count: usize) -> Stage {
        Stage::new(CHAPTER, balls(count), Pace::Fixed, Show::default())
    }

    /// Where a body is across.
    fn across(stage: &Stage, body: usize) -> f64 {
        stage.session().state_now().position[body].x
    }

    #[test]
    fn resetting_takes_thrown_balls_away() {
        let mut stage = stage();
        let before = stage.session().scene().bodies.len();
        stage.throw_ball();
        stage.throw_ball();
        assert_eq!(stage.session().scene().bodies.len(), before + 2);
        stage.reset();
        assert_eq!(stage.session().scene().bodies.len(), before);
        assert_eq!(stage.notice, None);
    }

    #[test]
    fn a_grabbed_body_is_held_where_it_was_clicked() {
        let mut stage = stage();
        let sight = sight(&stage);
        assert!(stage.grab(sight));
        let pull = *stage.pulled().expect("it was grabbed");
        let (position, orientation) = stage.session().pose(pull.body, 1.0);
        let held = position + orientation * pull.anchor;
        assert!(held.distance(pull.target) < 1e-5);
        stage.let_go();
        assert!(stage.pulled().is_none());
        assert_eq!(stage.picked, Some(0));
    }

    #[test]
    fn a_body_on_the_device_is_grabbed_and_followed_though_its_place_is_late() {
        let mut stage = Stage::new(CHAPTER, resident_balls(3), Pace::Fixed, Show::default());
        for _ in 0..3 {
            stage.advance(stage.session().dt());
        }
        assert!(stage.session().frames_late() > 0);
        let drawn = stage.session().pose(0, stage.alpha()).0.as_vec3();
        let sight = Ray {
            origin: drawn + 10.0 * Vec3::Z,
            direction: Vec3::NEG_Z,
        };
        assert!(stage.grab(sight));
        assert_eq!(stage.picked, Some(0));
        stage.follow_body(Some(0));
        stage.advance(0.0);
        let drawn = stage.session().pose(0, stage.alpha()).0.as_vec3();
        assert_eq!(stage.camera.target, drawn);
    }

    #[test]
    fn the_picked_body_is_removed_and_nothing_is_picked_then() {
        let mut stage = stage_of_balls(3);
        stage.picked = Some(1);
        stage.remove_picked();
        assert_eq!((stage.picked, &stage.notice), (None, &None));
        assert_eq!([0, 1].map(|i| across(&stage, i)), [0.0, 2.0]);
        assert_eq!([0, 1].map(|i| stage.surroundings().0.number(i)), [0, 2]);
        stage.remove_picked();
        assert!(
            stage
                .notice
                .as_ref()
                .is_some_and(|text| text.contains("Delete"))
        );
        assert_eq!(stage.session().state_now().len(), 2);
    }

    #[test]
    fn a_pulled_body_and_a_pair_keep_their_bodies_when_one_before_them_goes() {
        let mut stage = stage_of_balls(4);
        stage.set_pull(Some(Pull {
            body: 2,
            anchor: DVec3::ZERO,
            target: DVec3::ONE,
        }));
        stage.look_at([2, 3]);
        stage.picked = Some(0);
        stage.remove_picked();
        assert_eq!(stage.pulled().map(|pull| pull.body), Some(1));
        assert_eq!(stage.show.pair.map(|pair| pair.bodies), Some([1, 2]));
        stage.picked = Some(1);
        stage.remove_picked();
        assert!(stage.pulled().is_none() && stage.show.pair.is_none());
        stage.pull_to(DVec3::ZERO);
        assert!(stage.pulled().is_none());
    }

    #[test]
    fn a_body_that_cannot_be_removed_stays_picked_and_the_error_is_shown() {
        let mut stage = stage_of_balls(2);
        stage.change_engine(FALLING, Settings::defaults().with_method("heavy"));
        stage.picked = Some(1);
        stage.remove_picked();
        assert_eq!(
            (stage.picked, stage.session().state_now().len()),
            (Some(1), 2)
        );
        assert!(
            stage
                .notice
                .is_some_and(|text| text.contains("can't remove"))
        );
    }

    #[test]
    fn after_a_reset_the_picked_body_is_the_one_that_it_was() {
        let mut stage = stage_of_balls(3);
        stage.picked = Some(0);
        stage.remove_picked();
        stage.picked = Some(1);
        stage.show.pair = Some(Pair::new([0, 1]));
        assert_eq!(across(&stage, 1), 2.0);
        stage.reset();
        assert_eq!(
            (stage.picked, stage.session().state_now().len()),
            (Some(2), 3)
        );
        assert_eq!(stage.show.pair.map(|pair| pair.bodies), Some([1, 2]));
        stage.throw_ball();
        stage.picked = Some(3);
        stage.reset();
        assert_eq!(stage.picked, None);
    }

    #[test]
    fn every_body_can_be_removed_one_after_the_other() {
        let mut stage = stage_of_balls(3);
        stage.throw_ball();
        for _ in 0..4 {
            stage.picked = Some(0);
            stage.remove_picked();
            stage.advance(0.5);
        }
        assert_eq!(
            (stage.session().state_now().len(), &stage.notice),
            (0, &None)
        );
        assert!(
            stage
                .under(Ray {
                    origin: Vec3::ZERO,
                    direction: Vec3::X
                })
                .is_none()
        );
    }
}
