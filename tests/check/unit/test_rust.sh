#!/bin/sh
# The Rust crates as they are packed: the golden hashes of pairs and of scenes in space and in the plane, the layout of every
# structure, saves and errors, the README's example; and that firmware can have them. test_rust.sh BUILD
. tests/build/count.sh
build=$1
dir=$build/rust-test
rm -rf "$dir"
mkdir -p "$dir"
here=$(pwd)
dir=$(cd "$dir" && pwd)
packed=$dir/package/rust
hash_of() {
  sed -n "s/^#define $1 UINT64_C(0x\(.*\))\$/\1/p" "tests/check/target/$2.h"
}

if ! have cargo || ! have rustc; then
  skip 'the Rust crates' 'cargo rustc'
  finish rust
  exit
fi

# cargo WORDS...: without a network, with the library at -O0, which compiles sooner
offline() {
  CARGO_NET_OFFLINE=true CARGO_TARGET_DIR=$dir/target CFLAGS=-O0 cargo "$@" --offline --quiet
}

binary() {
  printf '[[bin]]\nname = "%s"\npath = "%s"\n' "$1" "$2"
}

builds() {
  awk -v as=rust -f tests/check/bind/layout.awk "$dir/package-api.txt" >"$dir/layout.rs"
  awk '/^```rust$/ { inside = 1; next } /^```$/ { inside = 0 } inside' port/rust/gjk/README.md >"$dir/readme.rs"
  mkdir -p "$dir/replay"
  {
    printf '[package]\nname = "replay"\nversion = "0.0.0"\nedition = "2021"\nautobins = false\n[workspace]\n'
    printf '[dependencies]\ngjk = { path = "%s/gjk" }\ngjk-sys = { path = "%s/gjk-sys" }\n' \
      "$packed" "$packed"
    for name in golden scene_golden behaviour; do
      binary $name "$here/tests/check/bind/$name.rs"
    done
    binary layout "$dir/layout.rs"
    binary readme "$dir/readme.rs"
  } >"$dir/replay/Cargo.toml"
  (cd "$dir/replay" && RUSTFLAGS='-D warnings' offline build)
}

runs() {
  program=$dir/target/debug/$1
  shift
  "$program" "$@"
}

other() {
  ! runs "$@"
}

same_layout() {
  sh tests/build/layout.sh "$dir/layout" "$dir/package-api.txt" "${CC:-cc}" "-I$packed/gjk-sys/c" >"$dir/layout.c.txt" &&
    runs layout >"$dir/layout.rust.txt" && diff "$dir/layout.c.txt" "$dir/layout.rust.txt"
}

readme() {
  sed -n 's|.*// prints: ||p' "$dir/readme.rs" >"$dir/expected"
  test -s "$dir/expected" && runs readme >"$dir/printed" && diff "$dir/expected" "$dir/printed"
}

# A function of that body that returns a shape for ever: does it compile?
borrows() {
  printf "use gjk::*;\npub fn f() -> Shape<'static> { %s }\n" "$1" >"$dir/borrows.rs"
  rustc --edition=2021 --crate-type=lib --emit=metadata -o "$dir/borrows.rmeta" -L "$dir/target/debug/deps" \
    --extern "gjk=$(find "$dir/target/debug/deps" -name 'libgjk-*.rlib')" "$dir/borrows.rs"
}

refused() {
  ! borrows "$1" 2>"$dir/refusal" && grep -q 'E0515\|E0597' "$dir/refusal"
}

is_tidy() {
  ! grep -nE '.{131}|[[:blank:]]$|	' "$1"
}

# The sizes of structures as the C compiler of the target has them, with the flags of build.rs, are those of Rust.
firmware() {
  target=thumbv7m-none-eabi
  sh tests/build/layout.sh "$dir/thumb" "$dir/package-api.txt" arm-none-eabi-gcc -mthumb -mcpu=cortex-m3 -fno-short-enums \
    "-I$packed/gjk-sys/c" >"$dir/thumb.txt" || return 1
  mkdir -p "$dir/sysroot"
  {
    printf '#![no_std]\nuse gjk_sys::*;\nuse core::mem::size_of;\n'
    awk '$1 !~ /[.]/ { print "const _: [(); " $2 "] = [(); size_of::<" $1 ">()];" }' "$dir/thumb.txt"
  } >"$dir/sizes.rs"
  set -- "$firmware_rustc" --edition=2021 --target $target --crate-type rlib --emit=metadata -L "$dir/sysroot"
  if [ "$core" != ready ]; then
    # Debian has core as source. Nothing is linked, so builtins may be empty.
    printf '#![feature(no_core, compiler_builtins)]\n#![compiler_builtins]\n#![no_core]\n' >"$dir/builtins.rs"
    RUSTC_BOOTSTRAP=1 "$@" --crate-name compiler_builtins -o "$dir/sysroot/libcompiler_builtins.rmeta" "$dir/builtins.rs" &&
      RUSTC_BOOTSTRAP=1 "$@" --cap-lints allow --crate-name core -o "$dir/sysroot/libcore.rmeta" "$core" || return 1
    set -- "$@" --extern "core=$dir/sysroot/libcore.rmeta"
  fi
  "$@" --crate-name gjk_sys -o "$dir/sysroot/libgjk_sys.rmeta" "$packed/gjk-sys/src/lib.rs" &&
    "$@" --crate-name gjk --extern "gjk_sys=$dir/sysroot/libgjk_sys.rmeta" -o "$dir/sysroot/libgjk.rmeta" "$packed/gjk/src/lib.rs" &&
    "$@" --crate-name sizes --extern "gjk_sys=$dir/sysroot/libgjk_sys.rmeta" -o "$dir/sysroot/libsizes.rmeta" "$dir/sizes.rs"
}

check 'make package' sh tests/build/package.sh "$dir" rust
check 'the crates and the programs' builds
check 'the layout of structures' same_layout
check 'the golden hash' runs golden 3000 "$(hash_of GOLDEN_HASH golden)"
check 'another set has another hash' other golden 149 "$(hash_of GOLDEN_FEW_HASH golden)"
check 'the golden hash of a scene' runs scene_golden 500 "$(hash_of SCENE_GOLDEN_FEW_HASH scene_golden)"
check 'the golden hash of a scene of the plane' runs scene_golden 500 \
  "$(hash_of PLANE_SCENE_GOLDEN_FEW_HASH plane_scene_golden)" plane
check 'another match has another hash' other scene_golden 499 "$(hash_of SCENE_GOLDEN_FEW_HASH scene_golden)"
check 'errors, saves, queries of scenes' runs behaviour
check "the README's example" readme
check 'a sphere lives for ever' borrows 'Shape::sphere(1).unwrap()'
check 'a hull does not outlive its vertices' refused 'let v = [vec3(1, 2, 3)]; Shape::hull(&v, 0).unwrap()'
for file in port/rust/*/src/*.rs port/rust/*/src/*/*.rs port/rust/gjk-sys/build.rs tests/check/bind/*.rs; do
  check "$file is tidy" is_tidy "$file"
done
# A compiler that has core for the target, or beside which Debian has core as source.
core=
for firmware_rustc in rustc /usr/bin/rustc; do
  have "$firmware_rustc" || continue
  core=/usr/src/rustc-$("$firmware_rustc" --version | cut -d ' ' -f 2)/library/core/src/lib.rs
  [ ! -d "$("$firmware_rustc" --print sysroot)/lib/rustlib/thumbv7m-none-eabi" ] || core=ready
  if [ "$core" = ready ] || [ -e "$core" ]; then
    break
  fi
  core=
done
if [ -n "$(missing_package cortex-m3)" ]; then
  skip 'the crates for thumbv7m' gcc-arm-none-eabi
elif [ -z "$core" ]; then
  skip 'the crates for thumbv7m' rust-src
else
  check 'the crates for thumbv7m' firmware
fi
finish rust
