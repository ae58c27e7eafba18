//! A contact between two bodies of a level, as the collision tree hands it to the resolution.

use glam::Vec3;

/// One point where two bodies touch.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Contact {
    /// Index of body 1.
    pub a: usize,
    /// Index of body 2, larger than `a`.
    pub b: usize,
    /// Which features of the two bodies meet.
    pub feature: u32,
    /// n̂: unit vector from body 2 to body 1.
    pub normal: Vec3,
    /// How deep they overlap, m; negative for a gap.
    pub depth: f32,
    /// Between the two surfaces, world, m.
    pub point: Vec3,
    /// What body 1 received, N s; 0 until resolved.
    pub impulse: Vec3,
    /// The part of it that held the bodies apart at rest, N s: where the next step begins.
    pub support: f32,
    /// The part of it that was friction at rest, N s.
    pub rub: Vec3,
}

impl Contact {
    /// Who meets whom, and with which features.
    fn key(&self) -> (usize, usize, u32) {
        (self.a, self.b, self.feature)
    }

    // ANCHOR: remember
    /// Hands on what these contacts' predecessors held in the last step. Both lists are in order
    /// of (a, b, feature), so one walk finds who was there before.
    pub fn remember(contacts: &mut [Contact], last: &[Contact]) {
        let mut last = last.iter().peekable();
        for contact in contacts {
            let key = contact.key();
            while last.next_if(|old| old.key() < key).is_some() {}
            if let Some(old) = last.next_if(|old| old.key() == key) {
                contact.support = old.support;
                contact.rub = old.rub;
            }
        }
    }
    // ANCHOR_END: remember
}
