//! Compiles c/gjk.c, the whole library in one file, with a C compiler and an archiver that are called by hand.
//!
//! They are CC_<target> and AR_<target> with underscores, else TARGET_CC and TARGET_AR for another machine, else CC and AR, else
//! cc and ar, or those of GNU for Cortex-M and RISC-V. CFLAGS adds flags.
use std::env;
use std::path::PathBuf;
use std::process::Command;

fn tool(name: &str, target: &str, default: &str) -> String {
    let own = format!("{}_{}", name, target.replace(['-', '.'], "_"));
    let other = format!("TARGET_{}", name);
    let is_cross = env::var("HOST").map_or(false, |host| host != target);
    for variable in [own.as_str(), if is_cross { other.as_str() } else { name }] {
        println!("cargo:rerun-if-env-changed={}", variable);
        if let Ok(value) = env::var(variable) {
            return value;
        }
    }
    let prefix = match target {
        t if !is_cross || t.is_empty() => "",
        t if t.starts_with("thumb") => "arm-none-eabi-",
        t if t.starts_with("riscv") && t.contains("none") => "riscv64-unknown-elf-",
        _ => "",
    };
    let default = if prefix.is_empty() { default } else if name == "CC" { "gcc" } else { "ar" };
    format!("{}{}", prefix, default)
}

/// What makes a C compiler speak the target's calling convention. Enums are ints, as the declarations say.
fn flags(target: &str) -> &'static [&'static str] {
    match target {
        t if t.starts_with("thumbv6m") => &["-mthumb", "-mcpu=cortex-m0", "-fno-short-enums", "-ffreestanding"],
        t if t.starts_with("thumbv7m") => &["-mthumb", "-mcpu=cortex-m3", "-fno-short-enums", "-ffreestanding"],
        "thumbv7em-none-eabi" => &["-mthumb", "-mcpu=cortex-m4", "-mfloat-abi=soft", "-fno-short-enums", "-ffreestanding"],
        "thumbv7em-none-eabihf" => &["-mthumb", "-mcpu=cortex-m4", "-mfloat-abi=hard", "-fno-short-enums", "-ffreestanding"],
        t if t.starts_with("riscv32imc") => &["-march=rv32imc", "-mabi=ilp32", "-ffreestanding"],
        _ => &["-fPIC"],
    }
}

fn run(command: &mut Command) {
    let status = command.status();
    match status {
        Ok(status) if status.success() => {}
        _ => panic!("gjk-sys: {:?} failed: {:?}; CC and AR name other tools", command, status),
    }
}

fn main() {
    let target = env::var("TARGET").unwrap();
    let folder = PathBuf::from(env::var("CARGO_MANIFEST_DIR").unwrap()).join("c");
    let out = PathBuf::from(env::var("OUT_DIR").unwrap());
    let (object, archive) = (out.join("gjk.o"), out.join("libgjk.a"));
    let mut compiler = Command::new(tool("CC", &target, "cc"));
    compiler.args(["-std=c99", "-O2", "-ffunction-sections", "-fdata-sections", "-c"]).args(flags(&target));
    compiler.args(env::var("CFLAGS").unwrap_or_default().split_whitespace());
    run(compiler.arg(folder.join("gjk.c")).arg("-o").arg(&object));
    let _ = std::fs::remove_file(&archive);
    run(Command::new(tool("AR", &target, "ar")).arg("crs").arg(&archive).arg(&object));
    println!("cargo:rustc-link-search=native={}", out.display());
    println!("cargo:rustc-link-lib=static=gjk");
    println!("cargo:include={}", folder.display());
    println!("cargo:rerun-if-changed=c/gjk.c");
    println!("cargo:rerun-if-changed=c/gjk.h");
}
