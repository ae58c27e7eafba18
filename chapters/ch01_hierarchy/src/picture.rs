//! What the engine shows of its scene graph: the tree in words for `--explain`, and the
//! frames as a drawing for the window.

use std::fmt::Write;

use ch00_scenes::{Drawing, palette};

use crate::{NodeId, SceneGraph};

/// Lines of `--explain` beyond which the tree is cut short.
const MOST_LINES: usize = 60;

/// The nodes below `id`, a line each, indented.
pub fn write_tree(text: &mut String, graph: &SceneGraph, id: NodeId, depth: usize) {
    let Some(node) = graph.get(id) else { return };
    let lines = text.lines().count();
    if lines < MOST_LINES {
        // Writing into a String can't fail.
        let _ = writeln!(text, "{:1$}{2}", "", 2 * depth + 2, node.name());
    } else if lines == MOST_LINES {
        text.push_str("  …\n");
    }
    for child in node.children() {
        write_tree(text, graph, *child, depth + 1);
    }
}

// ANCHOR: frames
/// The axes of every body's node, and a grey link to its parent's.
pub fn frames(graph: &SceneGraph, bodies: &[(NodeId, f32)]) -> Drawing {
    let mut drawing = Drawing::default();
    for &(id, length) in bodies {
        let world = graph.world(id);
        drawing.frame(world.translation, world.rotation, length, 1.5);
        let carrier = graph.parent(id);
        let above = carrier.and_then(|carrier| graph.parent(carrier));
        if let Some(above) = above {
            let end = graph.world(above).translation;
            drawing.line(world.translation, end, 1.5, palette::GREY);
        }
    }
    drawing
}
// ANCHOR_END: frames
