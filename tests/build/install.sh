#!/bin/sh
# Installs headers, archive, shared library, pkg-config and CMake files, the C++ headers and the Python module:
# install.sh BUILD PREFIX. `make install` runs it.
#
# Both libraries are built without a port, so nothing in them needs libc. The shared library shows only what the public
# headers name. Its soname changes with each release that a program must be compiled anew for, as gjk/version.h promises:
# while the major version is 0, with the minor one.
. tests/build/count.sh
build=$1
prefix=${2:?install: needs a PREFIX}
root=${DESTDIR:-}$prefix
. tests/build/version.sh
major=${version%%.*}
minor=${version#*.}
minor=${minor%.*}
api=$major
[ "$major" != 0 ] || api=$major.$minor
mkdir -p "$build"
work=$(mktemp -d "$build/install-XXXXXX") || exit 1
trap 'rm -rf "$work"' EXIT
mkdir -p "$root/lib/pkgconfig" "$root/lib/cmake/gjk" "$root/include/gjk" "$root/include/gjk2"

installed_library || exit 1
archive=build/host-install/libgjk.a
sh tests/build/shared.sh "$archive" "$work/libgjk.so.$version" "libgjk.so.$api" port/python/gjk_batch.c || exit 1

cp include/gjk/*.h "$root/include/gjk"
cp include/gjk2/*.h "$root/include/gjk2"
cp "$archive" "$root/lib"
cp "$work/libgjk.so.$version" "$root/lib"
if [ "$api" != "$version" ]; then
  ln -sf "libgjk.so.$version" "$root/lib/libgjk.so.$api"
fi
ln -sf "libgjk.so.$api" "$root/lib/libgjk.so"
fill port/package/gjk.pc.in >"$root/lib/pkgconfig/gjk.pc"
cp port/package/cmake/gjkConfig.cmake "$root/lib/cmake/gjk"
fill port/package/cmake/gjkConfigVersion.cmake.in >"$root/lib/cmake/gjk/gjkConfigVersion.cmake"
cp port/cpp/*.hpp "$root/include"

# The folder in which Python looks for modules of this prefix; else one that PYTHONPATH may name.
modules=$(python3 -c 'import site, sys
for folder in site.getsitepackages():
    if folder.startswith(sys.argv[1] + "/lib/"):
        print(folder)
        break' "$prefix" 2>/dev/null)
modules=${DESTDIR:-}${modules:-$prefix/lib/python3/dist-packages}
mkdir -p "$modules/gjk/plane"
cp port/python/gjk/*.py "$modules/gjk"
cp port/python/gjk/plane/*.py "$modules/gjk/plane"
echo "  $root"
