use super::*;

/// A file that is removed when the test ends.
struct Temporary(PathBuf);

impl Temporary {
    fn new(name: &str) -> Self {
        let name = format!("ch00_scenes-{}-{name}", std::process::id());
        Self(std::env::temp_dir().join(name))
    }
}

impl Drop for Temporary {
    fn drop(&mut self) {
        let _ = std::fs::remove_file(&self.0);
    }
}

/// One body whose 13 reals are `first`, `first` + 1, …
fn counting(first: f64) -> State {
    let mut state = State::default();
    push_row(&mut state, std::array::from_fn(|i| first + i as f64));
    state
}

fn write(file: &Temporary, real_size: u32, frames: &[(u32, State)]) {
    let mut dump = DumpWriter::create(&file.0, frames[0].1.len(), real_size).unwrap();
    for (step, state) in frames {
        dump.frame(*step, state).unwrap();
    }
    dump.finish().unwrap();
}

#[test]
fn a_dump_in_f64_has_this_layout_byte_by_byte() {
    let file = Temporary::new("f64");
    write(&file, 8, &[(0, counting(1.0)), (258, counting(-7.5))]);
    let mut expected = b"RBD1\x01\0\0\0\x08\0\0\0\0\0\0\0".to_vec();
    for (step, first) in [([0, 0, 0, 0], 1.0), ([2, 1, 0, 0], -7.5)] {
        expected.extend_from_slice(&step);
        expected.extend_from_slice(&[0; 4]);
        for i in 0..13 {
            expected.extend_from_slice(&(first + f64::from(i)).to_le_bytes());
        }
    }
    assert_eq!(std::fs::read(&file.0).unwrap(), expected);
    assert_eq!(expected.len(), 16 + 2 * (8 + 13 * 8));
}

#[test]
fn a_dump_in_f32_has_this_layout_byte_by_byte() {
    let file = Temporary::new("f32");
    write(&file, 4, &[(3, counting(1.0))]);
    let bytes = std::fs::read(&file.0).unwrap();
    assert_eq!(bytes.len(), 16 + 8 + 13 * 4);
    assert_eq!(bytes[8..12], [4, 0, 0, 0]);
    // 1.0 is 3f80_0000, 13.0 is 4150_0000, both little end first.
    assert_eq!(bytes[24..28], [0, 0, 0x80, 0x3f]);
    assert_eq!(bytes[72..76], [0, 0, 0x50, 0x41]);
}

#[test]
fn what_was_written_is_read_back() {
    let file = Temporary::new("back");
    let frames = [(0, counting(0.1)), (10, counting(0.2))];
    write(&file, 8, &frames);
    let dump = DumpReader::open(&file.0).unwrap();
    assert_eq!((dump.bodies(), dump.real_size()), (1, 8));
    let read = dump.frames().unwrap();
    let expected = frames.map(|(step, state)| Frame { step, state });
    assert_eq!(read, expected);
}

#[test]
fn states_that_are_not_finite_are_kept_as_they_are() {
    let file = Temporary::new("nan");
    write(&file, 4, &[(0, counting(f64::INFINITY))]);
    let read = DumpReader::open(&file.0).unwrap().frames().unwrap();
    assert_eq!(read[0].state.not_finite(), 1);
}

#[test]
fn a_path_that_cannot_be_written_is_named() {
    let path = Path::new("/no/such/folder/run.rbd");
    let message = DumpWriter::create(path, 1, 4).unwrap_err().to_string();
    assert!(
        message.starts_with("/no/such/folder/run.rbd: can't write: "),
        "{message}"
    );
}

#[test]
fn a_state_of_another_size_is_refused() {
    let file = Temporary::new("size");
    let mut dump = DumpWriter::create(&file.0, 2, 4).unwrap();
    let message = dump.frame(0, &counting(0.0)).unwrap_err().to_string();
    assert!(
        message.ends_with("the state has 1 bodies, the header says 2"),
        "{message}"
    );
}

#[test]
fn reals_have_four_or_eight_bytes() {
    let file = Temporary::new("reals");
    let message = DumpWriter::create(&file.0, 1, 2).unwrap_err().to_string();
    assert!(
        message.ends_with("a real has 4 or 8 bytes, not 2"),
        "{message}"
    );
    assert!(!file.0.exists());
}

#[test]
fn a_file_that_is_no_dump_is_refused() {
    let file = Temporary::new("other");
    std::fs::write(&file.0, b"{\"name\": \"no dump\"}").unwrap();
    let message = DumpReader::open(&file.0).unwrap_err().to_string();
    assert!(message.contains("doesn't begin with RBD1"), "{message}");
}

#[test]
fn a_frame_that_breaks_off_is_an_error() {
    let file = Temporary::new("short");
    write(&file, 4, &[(0, counting(1.0))]);
    let bytes = std::fs::read(&file.0).unwrap();
    std::fs::write(&file.0, &bytes[..bytes.len() - 1]).unwrap();
    assert!(DumpReader::open(&file.0).unwrap().frames().is_err());
}

#[test]
fn a_header_that_promises_too_many_bodies_costs_no_memory() {
    let file = Temporary::new("promise");
    let bytes = b"RBD1\xff\xff\xff\xff\x08\0\0\0\0\0\0\0\0\0\0\0\0\0\0\0";
    std::fs::write(&file.0, bytes).unwrap();
    assert!(DumpReader::open(&file.0).unwrap().frames().is_err());
}
