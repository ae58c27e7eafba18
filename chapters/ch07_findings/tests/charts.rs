//! The charts as files: the command writes what it says, the picture shows all that was
//! measured, and the CSV gives the same numbers back.

#[path = "charts/command.rs"]
mod command;
#[path = "charts/drawing.rs"]
mod drawing;
#[path = "charts/measuring.rs"]
mod measuring;

/// Every element is closed, in order, and nothing stands raw that XML wants escaped.
fn assert_well_formed(svg: &str) {
    let mut open: Vec<&str> = Vec::new();
    let mut rest = svg;
    while let Some((text, after)) = rest.split_once('<') {
        assert!(!text.contains('>'), "a raw > in {text:?}");
        let (tag, after) = after.split_once('>').expect("every < has its >");
        assert_eq!(tag.matches('"').count() % 2, 0, "quotes in {tag}");
        if let Some(name) = tag.strip_prefix('/') {
            assert_eq!(open.pop(), Some(name), "closing order");
        } else if !tag.ends_with('/') {
            open.push(tag.split(' ').next().unwrap_or(tag));
        }
        rest = after;
    }
    assert!(open.is_empty(), "not closed: {open:?}");
    let entities = ["&amp;", "&lt;", "&gt;", "&quot;", "&apos;"];
    let known: usize = entities
        .iter()
        .map(|entity| svg.matches(entity).count())
        .sum();
    assert_eq!(svg.matches('&').count(), known, "a raw &");
}
