//! CVODE of SUNDIALS, where it is installed: a driver in C is compiled when the bench
//! runs, so that building it needs no SUNDIALS.

use std::ffi::{CStr, c_char, c_int, c_long, c_void};
use std::process::Command;

use anyhow::{Context, Result, bail, ensure};
use libloading::{Library, Symbol};
use tempfile::TempDir;

use super::peer::{EachStep, Follow, Peer, Problem, Reached, TOLERANCES};
use crate::equations::{Equations, Implementation};

const DRIVER: &str = include_str!("cvode_driver.c");

/// SUNDIALS 7 has a core library, 6 a generic one or all of it in CVODE's.
const LIBRARIES: [&[&str]; 3] = [&["-lsundials_core"], &["-lsundials_generic"], &[]];

/// Those that each of them needs besides.
const MODULES: [&str; 4] = [
    "-lsundials_cvode",
    "-lsundials_nvecserial",
    "-lsundials_sunmatrixdense",
    "-lsundials_sunlinsoldense",
];

type Callback = extern "C" fn(*mut c_void, *const f64, *mut f64);
type StepCallback = extern "C" fn(*mut c_void, f64, *const f64);
type Solve = unsafe extern "C" fn(
    Callback,
    StepCallback,
    *mut c_void,
    c_int,
    c_long,
    *mut f64,
    f64,
    f64,
) -> c_int;
type Version = unsafe extern "C" fn() -> *const c_char;

/// The compiled driver, loaded.
pub struct Driver {
    library: Library,
    _folder: TempDir,
}

impl Driver {
    /// Compiles and loads the driver.
    ///
    /// # Errors
    /// No compiler, no SUNDIALS, or one that the driver was not written for.
    pub fn new() -> Result<Self> {
        let folder = tempfile::tempdir()?;
        let source = folder.path().join("cvode_driver.c");
        let object = folder.path().join("cvode_driver.so");
        std::fs::write(&source, DRIVER)?;
        let compiler = std::env::var("CC").unwrap_or_else(|_| "cc".into());
        let mut message = String::new();
        for libraries in LIBRARIES {
            let output = Command::new(&compiler)
                .args(["-O3", "-march=native", "-shared", "-fPIC", "-o"])
                .arg(&object)
                .arg(&source)
                .args(MODULES)
                .args(libraries)
                .arg("-lm")
                .output()
                .with_context(|| format!("{compiler} cannot be run"))?;
            if output.status.success() {
                // SAFETY: our own code; loading it runs no initialisers beyond SUNDIALS's.
                let library = unsafe { Library::new(&object) }?;
                return Ok(Self {
                    library,
                    _folder: folder,
                });
            }
            message = String::from_utf8_lossy(&output.stderr)
                .lines()
                .find(|line| line.contains("error") || line.contains("cannot find"))
                .unwrap_or_default()
                .to_owned();
        }
        bail!("the driver does not compile: {message}")
    }

    /// Version of SUNDIALS.
    ///
    /// # Errors
    /// The driver lacks the function.
    pub fn version(&self) -> Result<String> {
        // SAFETY: the signature is that of the driver; the text is a constant.
        unsafe {
            let version: Symbol<Version> = self.library.get(b"cageless_bench_sundials\0")?;
            Ok(CStr::from_ptr(version()).to_string_lossy().into_owned())
        }
    }
}

/// Family of methods.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Method {
    /// Adams methods with fixed-point iteration.
    Adams,
    /// Backward differentiation with a dense Jacobian by finite differences.
    Bdf,
}

/// One family on one right-hand side.
pub struct Cvode<'p> {
    /// The problem.
    pub problem: &'p Problem,
    /// Family.
    pub method: Method,
    /// The compiled driver.
    pub driver: &'p Driver,
    /// Right-hand side.
    pub equations: Implementation,
}

/// What `context` points at.
struct Call<'e, 's> {
    equations: &'e mut dyn Equations,
    each_step: &'e mut EachStep<'s>,
    dimension: usize,
}

extern "C" fn call_back(context: *mut c_void, y: *const f64, dydt: *mut f64) {
    // SAFETY: the driver passes on the context that `integrate` gave it, and vectors of
    // the dimension that it was told.
    unsafe {
        let call = &mut *context.cast::<Call<'_, '_>>();
        let y = std::slice::from_raw_parts(y, call.dimension);
        let dydt = std::slice::from_raw_parts_mut(dydt, call.dimension);
        call.equations.derivative(y, dydt);
    }
}

extern "C" fn step_call_back(context: *mut c_void, t: f64, y: *const f64) {
    // SAFETY: as in `call_back`.
    unsafe {
        let call = &mut *context.cast::<Call<'_, '_>>();
        let y = std::slice::from_raw_parts(y, call.dimension);
        (call.each_step)(t, y);
    }
}

impl Peer for Cvode<'_> {
    fn name(&self) -> String {
        match self.method {
            Method::Adams => "CVODE Adams".into(),
            Method::Bdf => "CVODE BDF".into(),
        }
    }

    fn equations(&self) -> &'static str {
        self.equations.name()
    }

    fn setting_name(&self) -> &'static str {
        "tolerance"
    }

    fn settings(&self) -> Vec<f64> {
        TOLERANCES.to_vec()
    }

    fn integrate(&self, setting: f64, duration_s: f64) -> Result<Reached> {
        self.follow(setting, duration_s, &mut |_, _| {})
    }
}

impl Follow for Cvode<'_> {
    fn follow(
        &self,
        setting: f64,
        duration_s: f64,
        each_step: &mut EachStep<'_>,
    ) -> Result<Reached> {
        let mut z = self.problem.start.clone();
        let dimension = z.len();
        self.equations.with(&self.problem.case, |equations| {
            let before = equations.evaluations();
            let mut call = Call {
                equations,
                each_step,
                dimension,
            };
            // SAFETY: the signature is that of the driver; `call` and `z` outlive the call.
            let code = unsafe {
                let solve: Symbol<Solve> = self.driver.library.get(b"cageless_bench_cvode\0")?;
                solve(
                    call_back,
                    step_call_back,
                    (&raw mut call).cast(),
                    c_int::from(self.method == Method::Bdf),
                    c_long::try_from(dimension)?,
                    z.as_mut_ptr(),
                    duration_s,
                    setting,
                )
            };
            ensure!(code == 0, "CVODE stopped with code {code}");
            let evaluations = call.equations.evaluations() - before;
            Ok(Reached { z, evaluations })
        })?
    }
}
