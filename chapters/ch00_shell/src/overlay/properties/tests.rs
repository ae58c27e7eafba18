//! The tables on a screen, by clicks and keys.

pub mod desk;

use egui::Key;

use super::*;
use crate::clock::Pace;
use crate::show::Show;
use crate::tables::sort::{By, Part, Sort};
use crate::test_engine::{CHAPTER, balls};
use desk::Desk;

const POSITION: &str = "position  p  (m)";
const HEIGHT: &str = "height  h  (m)";

/// So many balls, paused, with these columns ticked.
fn desk(count: usize, columns: &[&str]) -> Desk {
    let mut stage = Stage::new(CHAPTER, balls(count), Pace::Fixed, Show::default());
    stage.toggle_pause();
    let mut desk = Desk::new(stage);
    for column in columns {
        desk.click(column);
    }
    desk
}

fn across(desk: &Desk, body: usize) -> f64 {
    desk.stage.session().state_now().position[body].x
}

#[test]
fn a_ticked_column_is_shown_with_the_ids_of_its_rows() {
    let mut desk = desk(3, &[]);
    assert!(desk.ids().is_empty());
    desk.click(POSITION);
    assert_eq!(desk.ids(), ["0", "1", "2"]);
    assert!(
        desk.says("   2.0000   10.0000    0.0000"),
        "{:#?}",
        desk.texts()
    );
    assert!(desk.says("3 of 3 rows"));
    desk.click("none");
    assert!(desk.ids().is_empty());
}

#[test]
fn a_column_that_was_left_out_cannot_be_ticked_and_says_why() {
    let mut desk = desk(2, &["spin  ω  (rad/s)", HEIGHT]);
    assert_eq!(desk.properties.views["bodies"].columns, ["height"]);
    desk.hover("spin  ω  (rad/s)");
    assert!(desk.says("points don't turn"), "{:#?}", desk.texts());
    desk.click("all");
    assert_eq!(desk.properties.views["bodies"].columns.len(), 3);
}

#[test]
fn another_table_has_its_own_columns_and_rows() {
    let mut desk = desk(3, &[POSITION]);
    desk.click("bodies");
    desk.click("pairs  (2 rows)");
    assert!(!desk.says(POSITION));
    desk.click("second  j");
    assert_eq!(desk.ids(), ["0", "1"]);
    desk.click("2"); // in the second row: bodies 1 and 2
    assert_eq!(desk.stage.picked, None, "a pair is no body");
    assert!(desk.says("follow 1"));
}

#[test]
fn clicks_on_a_header_sort_up_and_down_and_not() {
    let mut desk = desk(3, &[HEIGHT]);
    desk.click("ID");
    assert_eq!(desk.ids(), ["0", "1", "2"]);
    desk.click("ID  ▲");
    assert_eq!(desk.ids(), ["2", "1", "0"]);
    desk.click("ID  ▼");
    assert_eq!(desk.ids(), ["0", "1", "2"]);
    assert_eq!(desk.properties.views["bodies"].sort, None);
}

#[test]
fn a_vector_is_sorted_by_what_its_menu_says() {
    let mut desk = desk(3, &[POSITION]);
    desk.click("by length");
    desk.click("x");
    let sort = desk.properties.views["bodies"].sort.expect("it was chosen");
    assert_eq!(
        (sort.by, sort.part),
        (By::Column("position"), Part::Number(0))
    );
    assert!(desk.says("by x"));
    desk.properties.views.get_mut("bodies").expect("shown").sort = Some(Sort {
        is_descending: true,
        ..sort
    });
    desk.settle();
    assert_eq!(desk.ids(), ["2", "1", "0"]);
}

#[test]
fn ids_that_are_typed_are_the_rows_shown_and_bad_ones_leave_the_last() {
    let mut desk = desk(9, &[HEIGHT]);
    desk.click("all, or 7, 9-20, 12.3");
    desk.write("1, 4-6");
    assert_eq!(desk.ids(), ["1", "4", "5", "6"]);
    desk.write("-");
    assert!(desk.says("`4-6-` is no ID"), "{:#?}", desk.texts());
    assert_eq!(desk.ids(), ["1", "4", "5", "6"]);
    desk.press(Key::Backspace);
    assert!(!desk.says("is no ID"));
}

#[test]
fn a_clicked_row_picks_its_body_and_only_the_picked_body_can_be_shown() {
    let mut desk = desk(3, &[HEIGHT]);
    desk.click("2");
    assert_eq!(desk.stage.picked, Some(2));
    desk.click("only the picked body");
    assert_eq!(desk.ids(), ["2"]);
    desk.click("remove");
    assert_eq!(
        (desk.ids(), desk.stage.picked),
        (vec!["0".to_owned(), "1".to_owned()], None)
    );
}

#[test]
fn a_double_click_edits_a_cell_and_the_button_undoes_it() {
    let mut desk = desk(2, &[POSITION]);
    desk.double_click("   1.0000   10.0000    0.0000");
    assert!(desk.says("editing position of 1"));
    desk.choose_all();
    desk.write("-7.5");
    desk.press(Key::Enter);
    assert_eq!((across(&desk, 0), across(&desk, 1)), (0.0, -7.5));
    assert!(!desk.says("editing"));
    desk.click("undo position of 1");
    assert_eq!(across(&desk, 1), 1.0);
    desk.click("redo position of 1");
    assert_eq!(across(&desk, 1), -7.5);
}

#[test]
fn the_numbers_of_a_cell_have_a_field_each() {
    let mut desk = desk(2, &[POSITION]);
    desk.double_click("   1.0000   10.0000    0.0000");
    desk.press(Key::Tab);
    desk.choose_all();
    desk.write("33");
    desk.press(Key::Enter);
    let position = desk.stage.session().state_now().position[1];
    assert_eq!(position.to_array(), [1.0, 33.0, 0.0]);
}

#[test]
fn escape_leaves_the_cell_as_it_was() {
    let mut desk = desk(2, &[POSITION]);
    desk.double_click("   1.0000   10.0000    0.0000");
    desk.choose_all();
    desk.write("5");
    desk.press(Key::Escape);
    assert!(!desk.says("editing"));
    assert_eq!(across(&desk, 1), 1.0);
    assert_eq!(desk.stage.edits().next_undo(), None);
}

#[test]
fn what_cannot_stand_in_a_cell_is_said_and_can_be_mended() {
    let mut desk = desk(2, &[POSITION]);
    desk.double_click("   1.0000   10.0000    0.0000");
    for (bad, why) in [
        ("nonsense", "`nonsense` is no number"),
        ("NaN", "NaN is no finite number"),
        ("inf", "inf is no finite number"),
        ("5000", "more than 1000 m away"),
    ] {
        desk.choose_all();
        desk.write(bad);
        desk.press(Key::Enter);
        assert!(desk.says(why), "{bad}: {:#?}", desk.texts());
        assert_eq!(across(&desk, 1), 1.0);
    }
    desk.choose_all();
    desk.write("4");
    desk.click("apply");
    assert_eq!(across(&desk, 1), 4.0);
}

#[test]
fn while_time_goes_on_and_where_nothing_can_be_edited_a_double_click_says_so() {
    let mut desk = desk(2, &[POSITION, HEIGHT]);
    desk.double_click("  10.0000");
    assert!(desk.says("`height` can't be edited"));
    desk.stage.toggle_pause();
    desk.settle();
    assert!(desk.says("pause to edit"));
    desk.double_click("   1.0000   10.0000    0.0000");
    assert!(!desk.says("editing"));
}

#[test]
fn a_step_closes_a_cell_that_was_being_edited() {
    let mut desk = desk(2, &[POSITION]);
    desk.double_click("   1.0000   10.0000    0.0000");
    desk.click("Step");
    assert!(!desk.says("editing"));
}

#[test]
fn a_followed_row_stays_in_sight_wherever_sorting_moves_it() {
    let mut desk = desk(500, &[HEIGHT]);
    assert!(desk.ids().len() < 30, "only rows in sight are laid out");
    desk.stage.follow_body(Some(400));
    desk.settle();
    assert!(desk.ids().contains(&"400".to_owned()), "{:?}", desk.ids());
    assert!(desk.says("following 400"));
    desk.click("ID");
    desk.click("ID  ▲");
    assert!(desk.ids().contains(&"400".to_owned()), "{:?}", desk.ids());
    desk.click("let go");
    assert_eq!(desk.stage.followed(), None);
}

#[test]
fn a_followed_row_is_let_go_when_it_is_gone_and_while_filtered_out_that_is_said() {
    let mut desk = desk(3, &[HEIGHT]);
    desk.click("1");
    desk.click("follow 1");
    assert_eq!(desk.stage.followed_body(), Some(1));
    desk.click("all, or 7, 9-20, 12.3");
    desk.write("0, 2");
    assert!(desk.says("1 is not among the rows shown"));
    desk.click("remove");
    assert!(desk.says("row 1 is gone"), "{:#?}", desk.texts());
    assert_eq!(desk.ids(), ["0", "2"]);
}

#[test]
fn a_column_to_sort_by_that_is_left_out_is_an_error_and_no_panic() {
    let mut desk = desk(2, &[HEIGHT]);
    desk.properties.views.get_mut("bodies").expect("shown").sort = Some(Sort {
        by: By::Column("spin"),
        part: Part::Whole,
        is_descending: false,
    });
    desk.settle();
    assert!(desk.says("was left out of this scene's plan"));
    assert_eq!(desk.ids(), ["0", "1"]);
}

#[test]
fn removing_all_bodies_leaves_an_empty_table() {
    let mut desk = desk(2, &[POSITION]);
    for id in ["1", "0"] {
        desk.click(id);
        desk.click("remove");
    }
    assert!(desk.ids().is_empty());
    assert!(desk.says("0 of 0 rows"));
    desk.click("Reset");
    assert_eq!(desk.ids(), ["0", "1"]);
}
