//! The systems: functions whose parameters say what they read and write.

#![expect(
    clippy::needless_pass_by_value,
    reason = "the library hands a system its parameters by value"
)]

use bevy_ecs::prelude::{ChildOf, Children, Entity, Query, Res, Without};
use bevy_ecs::system;
use ch01_hierarchy::Transform;
use ch01_hierarchy::styles::formulas;

// ANCHOR: glow
use super::components::Glow;
// ANCHOR_END: glow
// ANCHOR: spinning
use super::components::Spin;
// ANCHOR_END: spinning
use super::components::{Circle, Global, Local, Step};

// ANCHOR: circle
/// Moves what is on a circle.
pub fn circle(step: Res<Step>, mut circles: Query<(&mut Circle, &mut Local)>) {
    for (mut circle, mut local) in &mut circles {
        circle.angle = formulas::advance(circle.angle, circle.rate, step.0);
        local.0.translation = formulas::circle(circle.radius, circle.angle);
    }
}
// ANCHOR_END: circle

// ANCHOR: spinning
/// Turns what spins.
pub fn spin(step: Res<Step>, mut spins: Query<(&mut Spin, &mut Local)>) {
    for (mut spin, mut local) in &mut spins {
        spin.turned = formulas::advance(spin.turned, spin.rate, step.0);
        local.0.rotation = formulas::turn(spin.turned);
    }
}
// ANCHOR_END: spinning

// ANCHOR: glow
/// Lets the glow follow the rate of spin.
pub fn glow(step: Res<Step>, mut glows: Query<(&Spin, &mut Glow)>) {
    for (spin, mut glow) in &mut glows {
        glow.0 = formulas::follow(glow.0, spin.rate, step.0);
    }
}
// ANCHOR_END: glow

// ANCHOR: follow
/// World transforms, from the roots down.
pub fn follow_parents(
    roots: Query<Entity, Without<ChildOf>>,
    mut nodes: Query<(&Local, &mut Global, Option<&Children>)>,
    children: Query<&Children>,
    mut families: system::Local<Vec<(Entity, Transform)>>,
) {
    families.clear();
    for root in &roots {
        let Ok((local, mut global, children)) = nodes.get_mut(root) else {
            continue;
        };
        global.0 = local.0;
        families.extend(children.map(|_| (root, global.0)));
    }
    let mut next = 0;
    while let Some(&(parent, above)) = families.get(next) {
        next += 1;
        for &child in children.get(parent).into_iter().flatten() {
            let Ok((local, mut global, below)) = nodes.get_mut(child) else {
                continue;
            };
            global.0 = above * local.0;
            families.extend(below.map(|_| (child, global.0)));
        }
    }
}
// ANCHOR_END: follow
