//! The C library gjk as it is: its structures, constants and functions under their names in C.
//!
//! What each means, and what a caller promises, stands in the comments of `c/gjk.h`. The crate `gjk` is a safe face of it.
#![no_std]
#![allow(unknown_lints, non_camel_case_types, unpredictable_function_pointer_comparisons)]

include!("bindings.rs");
