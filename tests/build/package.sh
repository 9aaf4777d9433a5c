#!/bin/sh
# Writes the library as the packages that other build systems and languages expect, each a folder of BUILD/package:
# package.sh BUILD [NAME...]; all of them, or those named:
#
#   cmake     add_subdirectory, FetchContent
#   zephyr    a module: west.yml, or ZEPHYR_EXTRA_MODULES
#   esp-idf   a component, for the folder components of a project
#   arduino   a library for the Arduino tools and PlatformIO: the two amalgamated files, with examples
#   rust      two crates, gjk-sys and gjk
#   unity     a package for Unity; its Gjk.csproj is for Godot and other .NET
#   npm       an ES module with types, and what npm pack makes of it
#   wheel     the Python module with its shared library, for pip
. tests/build/count.sh
build=$1
shift
names=${*:-cmake zephyr esp-idf arduino rust unity npm wheel}
. tests/build/version.sh
rm -rf "$build/package"
mkdir -p "$build"
amalgamation=$build/package-amalgamation
api=$build/package-api.txt  # what the headers declare, for the scripts of port/bind

# sources NAME: a folder with headers, those of C++ too, sources, ports and the README
sources() {
  to=$build/package/$1
  mkdir -p "$to"
  cp -r include src port README.md "$to"
  (cd "$to/port" && rm -r bind csharp npm package python rust wasm)
}

cmake_package() {
  sources cmake
  cp port/package/cmake/CMakeLists.txt "$build/package/cmake"
}

zephyr_package() {
  sources zephyr
  mkdir "$build/package/zephyr/zephyr"
  cp port/package/zephyr/* "$build/package/zephyr/zephyr"
}

esp_idf_package() {
  sources esp-idf
  cp port/package/esp-idf/CMakeLists.txt "$build/package/esp-idf"
  fill port/package/esp-idf/idf_component.yml.in >"$build/package/esp-idf/idf_component.yml"
}

arduino_package() {
  to=$build/package/arduino
  mkdir -p "$to"
  cp -r "$amalgamation" "$to/src"
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
}

rust_package() {
  to=$build/package/rust
  mkdir -p "$to"
  cp -r port/rust/gjk port/rust/gjk-sys "$to"
  cp -r "$amalgamation" "$to/gjk-sys/c"
  awk -f port/bind/rust.awk "$api" "$api" >"$to/gjk-sys/src/bindings.rs"
  for crate in gjk gjk-sys; do
    rm "$to/$crate/Cargo.toml.in"
    fill "port/rust/$crate/Cargo.toml.in" >"$to/$crate/Cargo.toml"
    cp port/package/LICENCE.txt "$to/$crate"
  done
  printf '[workspace]\nmembers = ["gjk", "gjk-sys"]\n' >"$to/Cargo.toml"
}

unity_package() {
  to=$build/package/unity
  mkdir -p "$to/Runtime/Plugins/x86_64"
  cp port/csharp/*.md port/csharp/Gjk.csproj port/package/LICENCE.txt "$to"
  fill port/csharp/package.json.in >"$to/package.json"
  cp port/csharp/Runtime/* "$to/Runtime"
  awk -f port/bind/csharp.awk "$api" "$api" >"$to/Runtime/Native.cs"
  sed 's/^namespace Gjk /namespace Gjk.Plane /; s/gjk_/gjk2_/g; s/Vec3/Vec/g; s/Gjk\.Pose/Gjk.Plane.Pose/g
    1s|.*|// Shapes at poses, queries and scenes, of the plane: made from Shared.cs.|' port/csharp/Runtime/Shared.cs \
    >"$to/Runtime/PlaneShared.cs"
  cp "$amalgamation"/gjk.[ch] "$to/Runtime/Plugins"
  installed_library &&
    sh tests/build/shared.sh build/host-install/libgjk.a "$to/Runtime/Plugins/x86_64/libgjk.so"
}

# What the module exports is what the package calls; structures that it does not know are left out.
npm_package() {
  if ! have clang || ! have wasm-ld; then
    echo 'package: npm needs clang lld'
    return
  fi
  to=$build/package/npm
  mkdir -p "$to"
  cp port/npm/* port/package/LICENCE.txt "$to"
  rm "$to/package.json.in"
  fill port/npm/package.json.in >"$to/package.json"
  common='intersect|within|within_until|distance|distance_until|penetration|signed_distance|contacts|cast|cast_ray|time_of_impact'
  scene='add|add_at|attach|bind_all|bytes|cast|cast_ray|get|get_stats|hash|init|move|open|query_within|refilter|remove|seal|set_.*|sleep'
  shape='point|segment|triangle|box|hull|cylinder|cone|ellipsoid|polygon|ellipse'
  calls="$common|check_.*|collider_.*|shape_($shape)|scene_($scene|teleport|update|wake)|hull_(build|vertices|write_faces|workspace)"
  calls="$calls|ground_(of_.*|within|distance|contacts|cast.*)|index_build"
  calls="gjk2?_($calls|(quat|rotation)_(from_.*angle|normalize|compose)|size_of)|gjk_port_.*"
  WASM_EXPORTS=$calls sh port/wasm/build.sh "$to/gjk.wasm" -Os -Wl,--import-memory -Wl,--max-memory=4294967296 || return 1
  skip='^gjk2?_(arm|draw|compound|mesh|height_|surface|joint|chain$|chain_range|epa|concave|parts|slide|volume|inertia|mass|principal'
  skip="$skip|hull_(volume|simple|report|table))"
  awk -v as=code -v skip="$skip" -f port/bind/javascript.awk "$api" "$api" >"$to/records.js"
  awk -v as=types -v skip="$skip" -f port/bind/javascript.awk "$api" "$api" >"$to/records.d.ts"
  if have npm; then
    (cd "$to" && npm pack --offline --silent >/dev/null)
  fi
}

wheel_package() {
  if ! have python3; then
    echo 'package: wheel needs python3'
    return
  fi
  mkdir -p "$build/package/wheel"
  installed_library &&
    sh tests/build/shared.sh build/host-install/libgjk.a "$build/package-libgjk.so" libgjk.so port/python/gjk_batch.c &&
    python3 tests/build/wheel.py "$version" "$build/package-libgjk.so" "$build/package/wheel"
}

sh tests/build/amalgamate.sh "$amalgamation" && sh port/bind/api.sh "$build/package-api" >"$api" || exit 1
for name in $names; do
  "$(echo "$name" | tr - _)_package" || exit 1
done
