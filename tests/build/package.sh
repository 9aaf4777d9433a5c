#!/bin/sh
# Writes the library as the packages that other build systems expect, each a folder of BUILD/package: package.sh BUILD
#
#   cmake     add_subdirectory, FetchContent
#   zephyr    a module: west.yml, or ZEPHYR_EXTRA_MODULES
#   esp-idf   a component, for the folder components of a project
#   arduino   a library for the Arduino tools and PlatformIO: the two amalgamated files, with examples
#   rust      two crates, gjk-sys and gjk
#   unity     a package for Unity; its Gjk.csproj is for Godot and other .NET
. tests/build/count.sh
build=$1
. tests/build/version.sh
rm -rf "$build/package"

# sources NAME: a folder with headers, those of C++ too, sources, ports and the README
sources() {
  to=$build/package/$1
  mkdir -p "$to"
  cp -r include src port README.md "$to"
  (cd "$to/port" && rm -r package python wasm bind rust csharp)
}

sources cmake
cp port/package/cmake/CMakeLists.txt "$build/package/cmake"

sources zephyr
mkdir "$build/package/zephyr/zephyr"
cp port/package/zephyr/* "$build/package/zephyr/zephyr"

sources esp-idf
cp port/package/esp-idf/CMakeLists.txt "$build/package/esp-idf"
fill port/package/esp-idf/idf_component.yml.in >"$build/package/esp-idf/idf_component.yml"

to=$build/package/arduino
sh tests/build/amalgamate.sh "$to/src" || exit 1
cp -r port/package/arduino/examples "$to"
cp README.md "$to"
fill port/package/arduino/library.properties.in >"$to/library.properties"
fill port/package/arduino/library.json.in >"$to/library.json"
# A table of words for the editor: types, functions, constants.
{
  grep -ohE '^} gjk2?_[a-z0-9_]+;' include/gjk/*.h include/gjk2/*.h | sed 's/^} //; s/;$/\tKEYWORD1/'
  grep -ohE '\bgjk2?_[a-z0-9_]+\(' include/gjk/*.h include/gjk2/*.h | sed 's/($/\tKEYWORD2/'
  grep -ohE '^#define GJK2?_[A-Z0-9_]+' include/gjk/*.h include/gjk2/*.h | grep -v '_H$' | sed 's/^#define //; s/$/\tLITERAL1/'
} | sort -u >"$to/keywords.txt"

# For other languages: what the headers declare, by the scripts of port/bind.
api=$build/package-api
sh port/bind/api.sh "$api" >"$api.txt" || exit 1
amalgamation=$build/package/arduino/src

to=$build/package/rust
mkdir -p "$to"
cp -r port/rust/gjk port/rust/gjk-sys "$to"
mkdir "$to/gjk-sys/c"
cp "$amalgamation/gjk.c" "$amalgamation/gjk.h" "$to/gjk-sys/c"
awk -f port/bind/rust.awk "$api.txt" "$api.txt" >"$to/gjk-sys/src/bindings.rs"
for crate in gjk gjk-sys; do
  rm "$to/$crate/Cargo.toml.in"
  fill "port/rust/$crate/Cargo.toml.in" >"$to/$crate/Cargo.toml"
  cp port/package/LICENCE.txt "$to/$crate"
done
printf '[workspace]\nmembers = ["gjk", "gjk-sys"]\n' >"$to/Cargo.toml"

# Shared, so that each language finds one; without a port, and so without libc.
library host -install 'OPT=-O2 -fPIC' PORT= || exit 1
to=$build/package/unity
mkdir -p "$to/Runtime/Plugins/x86_64"
cp port/csharp/*.md port/csharp/Gjk.csproj port/package/LICENCE.txt "$to"
fill port/csharp/package.json.in >"$to/package.json"
cp port/csharp/Runtime/* "$to/Runtime"
awk -f port/bind/csharp.awk "$api.txt" "$api.txt" >"$to/Runtime/Native.cs"
sed 's/^namespace Gjk /namespace Gjk.Plane /; s/gjk_/gjk2_/g; s/Vec3/Vec/g; s/Gjk\.Pose/Gjk.Plane.Pose/g
  1s|.*|// Shapes at poses, queries and scenes, of the plane: made from Shared.cs.|' port/csharp/Runtime/Shared.cs \
  >"$to/Runtime/PlaneShared.cs"
cp "$amalgamation/gjk.c" "$amalgamation/gjk.h" "$to/Runtime/Plugins"
sh tests/build/shared.sh build/host-install/libgjk.a "$to/Runtime/Plugins/x86_64/libgjk.so" || exit 1
