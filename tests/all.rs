//! All tests but those of the kernel, a module for each subject: one program is linked, and its files run side by side.
//!
//! A new file is named here, or in the file of the folder that it is in. `cargo test --test all latex::` runs one of them. The
//! tests of the kernel are in `kernel/`, a program of their own, because mutation testing builds them alone.

mod common;

mod algebra;
mod architecture;
mod cases;
mod cli;
mod contact;
mod corrected;
mod cradle;
mod derivation;
mod dimension;
mod document;
mod doubts;
mod example;
mod examples;
mod figures;
mod formats;
mod functions;
mod graph;
mod html;
mod implied;
mod init;
mod interval;
mod latex;
mod laws;
mod markdown;
mod notation;
mod ordinary;
mod pages;
mod partial;
mod properties;
mod readme;
mod repairs;
mod report;
mod robust;
mod solutions;
mod solved;
mod sorted;
mod stationary;
mod there;
mod told;
mod undeclared;
