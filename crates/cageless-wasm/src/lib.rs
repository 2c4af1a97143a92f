//! The engine of pages that compute: [`cageless_live::answer`] behind a plain C ABI.
//!
//! The page writes a request into memory from [`cageless_alloc`], calls [`cageless_request`] and
//! reads the answer at the returned address, a length of four bytes and the text. Both are given
//! back with [`cageless_free`].

use cageless_live::{Control, answer};

#[cfg(target_arch = "wasm32")]
#[link(wasm_import_module = "page")]
unsafe extern "C" {
    /// Takes the fraction of the work that is done; another result than 0 ends it.
    safe fn progress(fraction: f64) -> i32;
}

#[cfg(not(target_arch = "wasm32"))]
fn progress(_: f64) -> i32 {
    0
}

/// Memory of `len` bytes for a request.
#[unsafe(no_mangle)]
pub extern "C" fn cageless_alloc(len: usize) -> *mut u8 {
    Box::into_raw(vec![0u8; len].into_boxed_slice()).cast()
}

/// Gives memory of `len` bytes back.
///
/// # Safety
/// `at` and `len` are those of [`cageless_alloc`], or of an answer with its four bytes of length.
#[unsafe(no_mangle)]
pub unsafe extern "C" fn cageless_free(at: *mut u8, len: usize) {
    // SAFETY: the caller passes what `into_raw` returned.
    drop(unsafe { Box::from_raw(std::ptr::slice_from_raw_parts_mut(at, len)) });
}

/// Answers the request of `len` bytes at `at`. The answer begins with its length, four bytes,
/// the lowest first.
///
/// # Safety
/// `at` and `len` are those of [`cageless_alloc`].
#[unsafe(no_mangle)]
pub unsafe extern "C" fn cageless_request(at: *const u8, len: usize) -> *mut u8 {
    // SAFETY: the caller passes memory of `len` bytes.
    let request = unsafe { std::slice::from_raw_parts(at, len) };
    let text = String::from_utf8_lossy(request);
    let answer = answer(&text, &mut |fraction| match progress(fraction) {
        0 => Control::Continue(()),
        _ => Control::Break(()),
    });
    let mut bytes = (answer.len() as u32).to_le_bytes().to_vec();
    bytes.extend(answer.into_bytes());
    Box::into_raw(bytes.into_boxed_slice()).cast()
}
