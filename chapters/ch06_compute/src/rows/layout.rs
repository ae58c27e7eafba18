//! How a row is stated, and the WGSL that follows from it.

use std::fmt::Write as _;

use bytemuck::Pod;
use glam::{Quat, Vec3, Vec4};

/// A Rust type that WGSL has too, with the same bits.
pub trait WgslType: Pod {
    /// What WGSL calls it.
    const WGSL: &'static str;
}

impl WgslType for f32 {
    const WGSL: &'static str = "f32";
}

impl WgslType for u32 {
    const WGSL: &'static str = "u32";
}

impl WgslType for Vec3 {
    const WGSL: &'static str = "vec3f";
}

impl WgslType for Vec4 {
    const WGSL: &'static str = "vec4f";
}

impl WgslType for Quat {
    const WGSL: &'static str = "vec4f";
}

impl WgslType for [Vec4; 4] {
    const WGSL: &'static str = "array<vec4f, 4>";
}

impl WgslType for [Vec4; 8] {
    const WGSL: &'static str = "array<vec4f, 8>";
}

/// One property within a row.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct FieldSpec {
    /// As the code and the WGSL call it.
    pub name: &'static str,
    /// As the book's formulas call it.
    pub symbol: &'static str,
    /// Its unit; empty for a pure number.
    pub unit: &'static str,
    /// One sentence.
    pub about: &'static str,
    /// What WGSL calls its type.
    pub wgsl: &'static str,
    /// Bytes from the start of the row.
    pub offset: usize,
}

/// What lies in a buffer at one index.
pub trait Row: Pod + Default {
    /// Its name, in Rust and in WGSL.
    const NAME: &'static str;
    /// One sentence.
    const ABOUT: &'static str;
    /// Its properties, in order.
    const FIELDS: &'static [FieldSpec];
}

// ANCHOR: declaration
/// The WGSL of a row: `struct Place { position: vec3f, reach: f32, }`.
#[must_use]
pub fn declaration<R: Row>() -> String {
    let mut text = format!("// {}\nstruct {} {{\n", R::ABOUT, R::NAME);
    for field in R::FIELDS {
        let unit = if field.unit.is_empty() { "" } else { ", " };
        // Writing to a string can't fail.
        let _ = writeln!(text, "    // {}{unit}{}", field.about, field.unit);
        let _ = writeln!(text, "    {}: {},", field.name, field.wgsl);
    }
    text + "}\n"
}
// ANCHOR_END: declaration

// ANCHOR: rows
/// States rows once: each property's name, type, symbol, unit, and what it is, as its doc comment.
///
/// Gives the Rust struct, as it lies in memory, and what [`declaration`] makes WGSL of.
macro_rules! rows {
    ($(
        $(#[doc = $about:literal])+
        pub struct $Row:ident {
            $(
                $(#[doc = $doc:literal])+
                $field:ident: $Type:ty, $symbol:literal, $unit:literal;
            )+
        }
    )+) => {$(
        $(#[doc = $about])+
        #[repr(C)]
        #[derive(Clone, Copy, Debug, Default, PartialEq, bytemuck::Pod, bytemuck::Zeroable)]
        pub struct $Row {
            $($(#[doc = $doc])+ pub $field: $Type,)+
        }

        impl $crate::rows::Row for $Row {
            const NAME: &'static str = stringify!($Row);
            const ABOUT: &'static str = concat!($($about),+).trim_ascii();
            const FIELDS: &'static [$crate::rows::FieldSpec] = &[$(
                $crate::rows::FieldSpec {
                    name: stringify!($field),
                    symbol: $symbol,
                    unit: $unit,
                    about: concat!($($doc),+).trim_ascii(),
                    wgsl: <$Type as $crate::rows::WgslType>::WGSL,
                    offset: std::mem::offset_of!($Row, $field),
                },
            )+];
        }
    )+};
}
// ANCHOR_END: rows
pub(crate) use rows;

/// A number that Rust and WGSL know by the same name: its name, itself, and what it means.
pub type Number = (&'static str, u32, &'static str);

/// States numbers once: each becomes a constant of Rust, and all of them a list, of which [`constants`]
/// makes those of WGSL.
macro_rules! numbers {
    (
        $(#[doc = $all:literal])+
        pub const $All:ident;
        $($(#[doc = $about:literal])+ pub const $Name:ident = $number:expr;)+
    ) => {
        $($(#[doc = $about])+ pub const $Name: u32 = $number;)+

        $(#[doc = $all])+
        pub const $All: &[$crate::rows::Number] =
            &[$((stringify!($Name), $Name, concat!($($about),+).trim_ascii())),+];
    };
}
pub(crate) use numbers;

/// The WGSL of numbers: `const NONE: u32 = 4294967295u;`.
#[must_use]
pub fn constants(numbers: &[Number]) -> String {
    let mut text = String::new();
    for (name, number, about) in numbers {
        // Writing to a string can't fail.
        let _ = writeln!(text, "// {about}\nconst {name}: u32 = {number}u;");
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::rows::*;

    /// The offsets and the stride that WGSL gives a row.
    fn by_naga<R: Row>() -> (Vec<(String, usize)>, usize) {
        let source = declaration::<R>() + &format!("var<private> one: {};", R::NAME);
        let module = naga::front::wgsl::parse_str(&source).expect("a declaration is WGSL");
        let (_, found) = module
            .types
            .iter()
            .find(|(_, found)| found.name.as_deref() == Some(R::NAME))
            .expect("the struct is there");
        let naga::TypeInner::Struct { members, span } = &found.inner else {
            panic!("{} is a struct", R::NAME);
        };
        let offset = |member: &naga::StructMember| {
            let name = member.name.clone().expect("members have names");
            (name, member.offset as usize)
        };
        (members.iter().map(offset).collect(), *span as usize)
    }

    #[track_caller]
    fn is_the_same_in_both<R: Row>() {
        let ours: Vec<_> = R::FIELDS
            .iter()
            .map(|field| (field.name.to_owned(), field.offset))
            .collect();
        assert_eq!(by_naga::<R>(), (ours, size_of::<R>()), "{}", R::NAME);
    }

    #[test]
    fn every_row_lies_in_memory_as_wgsl_has_it() {
        is_the_same_in_both::<Place>();
        is_the_same_in_both::<Motion>();
        is_the_same_in_both::<Spin>();
        is_the_same_in_both::<Push>();
        is_the_same_in_both::<Solid>();
        is_the_same_in_both::<Material>();
        is_the_same_in_both::<Manifold>();
        is_the_same_in_both::<Impulse>();
        is_the_same_in_both::<Node>();
        is_the_same_in_both::<Limit>();
        is_the_same_in_both::<Turned>();
        is_the_same_in_both::<Held>();
        is_the_same_in_both::<Press>();
        is_the_same_in_both::<Step>();
        is_the_same_in_both::<Drawn>();
        is_the_same_in_both::<Seen>();
        is_the_same_in_both::<Mover>();
        is_the_same_in_both::<Ball>();
        is_the_same_in_both::<Wall>();
        is_the_same_in_both::<GridOf>();
        is_the_same_in_both::<Rigid>();
        is_the_same_in_both::<Bound>();
        is_the_same_in_both::<Partner>();
        is_the_same_in_both::<Contact>();
        is_the_same_in_both::<Memory>();
        is_the_same_in_both::<Pressed>();
        is_the_same_in_both::<Total>();
        is_the_same_in_both::<Holding>();
        is_the_same_in_both::<Before>();
        is_the_same_in_both::<PairsOf>();
        is_the_same_in_both::<Scan>();
        is_the_same_in_both::<Mouse>();
        is_the_same_in_both::<Pivot>();
        is_the_same_in_both::<Pole>();
    }

    #[test]
    fn all_rows_together_are_valid_wgsl() {
        naga::front::wgsl::parse_str(&wgsl()).expect("valid WGSL");
    }
}
