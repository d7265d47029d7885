//! `carom_table`: a table with its physics.

use std::ffi::c_char;
use std::sync::Arc;

use carom::Shot;

use crate::entry::{ErrorText, enter, given, index, name_or_object, optional_text, to_c};

/// A table with its physics; immutable. Any number of threads may use it at once.
pub struct carom_table {
    /// A shot of one resting ball on it.
    pub(crate) base: Shot,
}

/// What a table is made of. All zero: a pool table of 9 ft with the physics of pool.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_table_def {
    /// The name of a preset, or the object "table" of a shot file as JSON; null for "wpa-9ft".
    pub table: *const c_char,
    /// The name of a preset, or the object "physics" of a shot file as JSON; null for the physics
    /// that belongs to the table.
    pub physics: *const c_char,
}

/// Size and pockets of a table.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_table_size {
    /// Along x between the nose lines, m; infinite for cloth without rails.
    pub width: f64,
    /// Along y between the nose lines, m; infinite for cloth without rails.
    pub length: f64,
    /// Height of the noses above the slate, m.
    pub cushion_height: f64,
    /// Radius of a ball, m, unless a shot gives another.
    pub ball_radius: f64,
    /// Mass of a ball, kg, unless a shot gives another.
    pub ball_mass: f64,
    /// Number of pockets.
    pub pocket_count: i32,
}

/// A pocket of a table.
#[repr(C)]
#[derive(Clone, Copy, Debug)]
pub struct carom_pocket {
    /// Centre of its hole, m.
    pub center: [f64; 2],
    /// Radius of its hole, m.
    pub radius: f64,
}

/// A definition of a table with default values.
///
/// Threads: any.
#[unsafe(no_mangle)]
pub extern "C" fn carom_default_table_def() -> carom_table_def {
    carom_table_def { table: std::ptr::null(), physics: std::ptr::null() }
}

/// Makes a table.
///
/// def: null stands for a definition with default values; its texts are read in the call.
/// Returns the table, or null with the text of the error.
/// Ownership: free it with carom_table_free; shots on it keep what they need. Threads: any.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn carom_table_new(
    def: Option<&carom_table_def>,
    error: *mut c_char,
    error_size: i32,
) -> Option<Box<carom_table>> {
    // SAFETY: the caller's promises in the header.
    unsafe {
        enter(&ErrorText::new(error, error_size), || {
            let def = def.copied().unwrap_or_else(|| carom_default_table_def());
            let table = optional_text(def.table, "def.table")?.unwrap_or("wpa-9ft");
            let physics = optional_text(def.physics, "def.physics")?;
            let physics = physics.map(|text| name_or_object(text, "physics")).transpose()?;
            let base = Shot::bare(name_or_object(table, "table")?, physics)?;
            Ok(Some(Box::new(carom_table { base })))
        })
    }
}

/// Frees a table; null is passed over.
///
/// Ownership: the pointer must not be used afterwards. Threads: any.
#[unsafe(no_mangle)]
pub extern "C" fn carom_table_free(table: Option<Box<carom_table>>) {
    enter(&ErrorText::NONE, || {
        drop(table);
        Ok(())
    });
}

/// Writes the size of a table into out.
///
/// Returns 0, or a negative number for a null pointer.
/// Threads: any.
#[unsafe(no_mangle)]
pub extern "C" fn carom_table_get_size(
    table: Option<&carom_table>,
    out: Option<&mut carom_table_size>,
) -> i32 {
    enter(&ErrorText::NONE, || {
        let (base, out) = (&given(table, "table")?.base, given(out, "out")?);
        let (table, ball) = (base.table(), base.physics().ball);
        *out = carom_table_size {
            width: table.size.x,
            length: table.size.y,
            cushion_height: table.cushion_height,
            ball_radius: ball.radius,
            ball_mass: ball.mass,
            pocket_count: table.pockets.len() as i32,
        };
        Ok(0)
    })
}

/// Writes pocket number pocket of a table into out. Batches, events and calls have the same numbers.
///
/// Returns 0, or a negative number if there is no such pocket.
/// Threads: any.
#[unsafe(no_mangle)]
pub extern "C" fn carom_table_get_pocket(
    table: Option<&carom_table>,
    pocket: i32,
    out: Option<&mut carom_pocket>,
) -> i32 {
    enter(&ErrorText::NONE, || {
        let (base, out) = (&given(table, "table")?.base, given(out, "out")?);
        let table = base.table();
        let pocket = &table.pockets[index(pocket, table.pockets.len(), "pocket")?];
        let center = pocket.center + table.center();
        *out = carom_pocket { center: [center.x, center.y], radius: pocket.radius };
        Ok(0)
    })
}

/// The geometry of a table, JSON: noses, facings, points, pockets, spots.
///
/// Returns the text, or null for a null pointer.
/// Ownership: free the text with carom_text_free. Threads: any.
#[unsafe(no_mangle)]
pub extern "C" fn carom_table_geometry_json(table: Option<&carom_table>) -> *mut c_char {
    enter(&ErrorText::NONE, || to_c(given(table, "table")?.base.table().to_node().to_json()))
}

/// All values of the physics of a table, JSON, as a shot file has them.
///
/// Returns the text, or null for a null pointer.
/// Ownership: free the text with carom_text_free. Threads: any.
#[unsafe(no_mangle)]
pub extern "C" fn carom_table_physics_json(table: Option<&carom_table>) -> *mut c_char {
    enter(&ErrorText::NONE, || to_c(given(table, "table")?.base.physics().to_node().to_json()))
}

/// The table and the physics of a shot.
impl From<&Arc<carom::ShotFile>> for carom_table {
    fn from(shot: &Arc<carom::ShotFile>) -> Self {
        Self { base: shot.shot().clone() }
    }
}
