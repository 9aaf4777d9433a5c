#!/bin/sh
# The library in other people's builds: each package serves a consumer in a folder of its own, as its ecosystem does it.
# test_package.sh BUILD
#
# Zephyr's and ESP-IDF's own tools are not in Debian. Stand-ins for the CMake functions that their packages call take
# their place here; that shows which sources and include paths the packages name, no more.
. tests/build/count.sh
. tests/build/version.sh
build=$1
dir=$build/package-test
rm -rf "$dir"
mkdir -p "$dir"
dir=$(cd "$dir" && pwd)
prefix=$dir/prefix
examples='distance safety_stop stack warm rollback flash plane cast parts arm door planner platform'
golden=$(sed -n 's/^#define GOLDEN_HASH UINT64_C(0x\(.*\))$/\1/p' tests/check/target/golden.h)

# prints PROGRAM SOURCE: the program prints what the source says
prints() {
  "$1" >"$1.printed" && sed -n 's|^// prints: ||p' "$2" >"$1.expected" && test -s "$1.expected" &&
    diff "$1.expected" "$1.printed"
}

is_short() {
  most=60
  [ "$1" = door ] && most=80
  [ "$1" = platform ] && most=80
  [ "$1" = planner ] && most=210
  [ "$(wc -l <"tests/programs/examples/$1.c")" -lt $most ]
}

# planner_draws PROGRAM: a picture of the way, the wall and both ends, of numbers only
planner_draws() {
  LD_LIBRARY_PATH=$prefix/lib "$1" "$1.svg" >"$1.said" && edges=$(sed -n 's/^a path of \([0-9]*\) edges.*/\1/p' "$1.said") &&
    [ "$(grep -c '<path .*L' "$1.svg")" = $((24 * edges + 4)) ] && grep -q '^</svg>$' "$1.svg" && ! grep -qE 'nan|inf' "$1.svg" &&
    ! LD_LIBRARY_PATH=$prefix/lib "$1" "$dir/none/way.svg" >"$1.said"
}

every_example_is_listed() {
  for source in tests/programs/examples/*.c; do
    case " $examples " in *" $(basename "$source" .c) "*) ;; *) echo "$source is not run"; return 1 ;; esac
  done
}

# with_pkg_config NAME FLAGS...: an example, built with what pkg-config says of the installation
with_pkg_config() {
  name=$1
  shift
  # shellcheck disable=SC2046
  "${CC:-cc}" -std=c99 -Wall -Wextra -Werror "tests/programs/examples/$name.c" "$@" \
    $(PKG_CONFIG_PATH=$prefix/lib/pkgconfig pkg-config --cflags --libs 'gjk >= 0.1') -o "$dir/$name" &&
    LD_LIBRARY_PATH=$prefix/lib prints "$dir/$name" "tests/programs/examples/$name.c"
}

# The golden hash, its queries answered by the shared library.
shared_bits() {
  mkdir -p "$dir/golden"
  (cd tests/check/target && cp golden.c golden_host.c plane_golden.c motion_golden.c plane_motion_golden.c parts_golden.c \
    hull_golden.c scene_golden.c concave_golden.c "$dir/golden")
  # shellcheck disable=SC2046
  "${CC:-cc}" -std=c99 -O1 "-I$prefix/include" -I. -Iport -Itests/support -Itests/check/target "$dir"/golden/*.c \
    tests/support/scene/match.c port/hosted/gjk_hosted.c "-L$prefix/lib" -lgjk -o "$dir/golden/golden" &&
    LD_LIBRARY_PATH=$prefix/lib "$dir/golden/golden" | grep -q "$golden"
}

# Nothing but public names leaves the shared library, and its soname is that of the API.
exports() {
  nm -D --defined-only "$prefix/lib/libgjk.so" | awk '{ print $3 }' >"$dir/exported"
  test -s "$dir/exported" && ! grep -vxE 'gjk2?_[a-z0-9_]+' "$dir/exported" && grep -qx gjk_distance "$dir/exported" &&
    ! nm -D --undefined-only "$prefix/lib/libgjk.so" | grep -v ' w ' &&
    readelf -d "$prefix/lib/libgjk.so" | grep -q 'soname: \[libgjk\.so\.'"$(echo "$version" | cut -d. -f1,2)"'\]'
}

# Where the library is compiled, each folder of its sources is compiled as one file. With a list in needed, only these are,
# after all of src were named.
cat >"$dir/rooms.cmake" <<'END'
get_target_property(sources gjk SOURCES)
foreach(source ${sources})
  string(REGEX REPLACE ".*/(src/[^/]*/[^/]*)$" "\\1" name "${source}")
  file(APPEND ${CMAKE_BINARY_DIR}/named "${name}\n")
  if(NOT needed OR name IN_LIST needed)
    list(APPEND taken ${source})
  endif()
endforeach()
set_property(TARGET gjk PROPERTY SOURCES ${taken})
if(NOT CMAKE_VERSION VERSION_LESS 3.18)
  foreach(source ${taken})
    get_filename_component(room ${source} DIRECTORY)
    get_filename_component(room ${room} NAME)
    set_source_files_properties(${source} TARGET_DIRECTORY gjk PROPERTIES UNITY_GROUP ${room})
  endforeach()
  set_target_properties(gjk PROPERTIES UNITY_BUILD ON UNITY_BUILD_MODE GROUP)
endif()
END

printf '%s\n' src/*/*.c | sort >"$dir/sources"

# build FOLDER [SOURCES]: configures and builds the project, whose library is of these sources alone, if any are given
build() {
  rm -f "$dir/$1/build/named"
  cmake -S "$dir/$1" -B "$dir/$1/build" "-DCMAKE_PREFIX_PATH=$prefix" -DCMAKE_BUILD_TYPE=Debug "-Dneeded=$(echo "$2" | tr ' ' ';')" &&
    cmake --build "$dir/$1/build" --parallel 2 || return 1
  [ ! -f "$dir/$1/build/named" ] || { grep '^src/' "$dir/$1/build/named" | sort -u | diff "$dir/sources" -; }
}

# consumer FOLDER LINE LIBRARIES PROGRAMS [SOURCES]: a project of CMake, where LINE makes the targets gjk::LIBRARY known. Programs
# are examples, and cpp, that of the README in C++.
consumer() {
  mkdir -p "$dir/$1"
  awk '/^```cpp$/ { inside = 1; next } /^```$/ { inside = 0 } inside' port/README.md >"$dir/$1/cpp.cpp"
  languages=C
  case $4 in *cpp) languages='C CXX' ;; esac
  {
    echo 'cmake_minimum_required(VERSION 3.13)'
    printf 'project(consumer %s)\nset(CMAKE_CXX_STANDARD 17)\n%s\n' "$languages" "$2"
    case $2 in add_subdirectory*) echo "include($dir/rooms.cmake)" ;; esac
    for program in $4; do
      for library in $3; do
        echo "add_executable($program-$library $(consumer_source "$1" $program))"
        echo "target_link_libraries($program-$library PRIVATE gjk::$library)"
      done
    done
  } >"$dir/$1/CMakeLists.txt"
  build "$1" "$5" || return 1
  for program in $4; do
    for library in $3; do
      prints "$dir/$1/build/$program-$library" "$(consumer_source "$1" $program)" || return 1
    done
  done
}

consumer_source() {
  case $2 in
    cpp) echo "$dir/$1/cpp.cpp" ;;
    *) echo "$(pwd)/tests/programs/examples/$2.c" ;;
  esac
}

refuses_another_version() {
  mkdir -p "$dir/other"
  printf 'cmake_minimum_required(VERSION 3.13)\nproject(other NONE)\nfind_package(gjk %s REQUIRED CONFIG)\n' "$1" \
    >"$dir/other/CMakeLists.txt"
  ! cmake -S "$dir/other" -B "$dir/other/build" "-DCMAKE_PREFIX_PATH=$prefix" >"$dir/other/log" 2>&1 &&
    tr -s ' \n' ' ' <"$dir/other/log" | grep -q 'considered but not accepted'
}

# stand_in FOLDER LINES: a project of CMake with functions in the place of Zephyr's or ESP-IDF's
stand_in() {
  mkdir -p "$dir/$1"
  printf 'cmake_minimum_required(VERSION 3.13)\nproject(%s C)\n%s\ninclude(%s)\n' "$1" "$2" "$dir/rooms.cmake" \
    >"$dir/$1/CMakeLists.txt"
  printf 'add_executable(distance %s)\ntarget_link_libraries(distance PRIVATE gjk)\n' \
    "$(pwd)/tests/programs/examples/distance.c" >>"$dir/$1/CMakeLists.txt"
  build "$1" "$of_distance" && prints "$dir/$1/build/distance" tests/programs/examples/distance.c
}

# A gjk_port.h on the include path is taken without a macro, and a macro goes first.
port_by_name() {
  mkdir -p "$dir/port"
  echo '#define GJK_ASSERT(condition) found_by_name(condition)' >"$dir/port/gjk_port.h"
  echo '#define GJK_ASSERT(condition) named_by_macro(condition)' >"$dir/port/other.h"
  printf '#include "src/arith/gjk_port_defaults.h"\nGJK_ASSERT(1)\n' >"$dir/port/use.c"
  "$1" -std=c99 -E -Iinclude -I. "-I$dir/port" "$dir/port/use.c" | grep -q 'found_by_name(1)' &&
    "$1" -std=c99 -E -Iinclude -I. "-I$dir/port" '-DGJK_PORT_HEADER="other.h"' "$dir/port/use.c" | grep -q 'named_by_macro(1)' &&
    "$1" -std=c99 -E -Iinclude -I. "$dir/port/use.c" | grep -q '((void)0)'
}

# What Arduino's library specification asks for, revision 1.5.
arduino_layout() {
  cd "$build/package/arduino" || return 1
  for field in name version author maintainer sentence paragraph category url architectures includes; do
    grep -qE "^$field=.+" library.properties || { echo "no $field"; return 1; }
  done
  grep -qx "version=$version" library.properties && test -f src/gjk.h && test -f src/gjk.c || return 1
  for sketch in examples/*; do
    test -f "$sketch/$(basename "$sketch").ino" || { echo "$sketch: no sketch of its name"; return 1; }
  done
  ! grep -vE "^[A-Za-z0-9_]+$(printf '\t')(KEYWORD1|KEYWORD2|LITERAL1)$" keywords.txt &&
    grep -q "^gjk_distance$(printf '\t')KEYWORD2$" keywords.txt && ! find . -name '*.o' | grep .
}

# sketch NAME COMPILER FLAGS...: a sketch compiles as the Arduino tools compile it, with Arduino.h before it
sketch() {
  name=$1
  compiler=$2
  shift 2
  mkdir -p "$dir/sketch"
  { echo '#include <Arduino.h>'; cat "$build/package/arduino/examples/$name/$name.ino"; } >"$dir/sketch/$name.cpp"
  "$compiler" -std=gnu++11 -Os -w -fno-exceptions -ffunction-sections -fdata-sections -DARDUINO=10819 "$@" \
    "-I$build/package/arduino/src" -c "$dir/sketch/$name.cpp" -o "$dir/sketch/$name.o"
}

arduino_library() {
  compiler=$1
  shift
  "$compiler" -std=gnu11 -w -fsyntax-only "$@" "-I$build/package/arduino/src" "$build/package/arduino/src/gjk.c"
}

json() {
  awk '{ for (i = 1; i <= length($0); i++) { c = substr($0, i, 1)
      if (c == "\"") string = !string
      else if (!string && (c == "{" || c == "[")) depth++
      else if (!string && (c == "}" || c == "]")) depth-- } }
    END { exit depth != 0 || string }' "$1" && grep -q "\"version\": \"$version\"" "$1"
}

check 'make install' make -s install "PREFIX=$prefix"
check 'make package' sh tests/build/package.sh "$build" cmake zephyr esp-idf arduino
check 'each example is run' every_example_is_listed
for example in $examples; do
  check "$example.c: less than 60 lines" is_short $example
done
check 'the shared library shows public names alone' exports
check 'the golden hash of the shared library' shared_bits
for compiler in gcc clang; do
  if have $compiler; then check "a port by its name, $compiler" port_by_name $compiler; else skip "a port by its name" $compiler; fi
done
if have pkg-config; then
  for example in $examples; do
    check "pkg-config: $example" with_pkg_config $example
  done
  check 'the planner draws its way' planner_draws "$dir/planner"
  check 'pkg-config: the archive' with_pkg_config distance -static
  mv "$prefix" "$prefix-moved"
  prefix=$prefix-moved
  check 'pkg-config: an installation that was moved' with_pkg_config distance
else
  skip 'pkg-config' pkg-config
fi
if have cmake; then
  cpp=cpp
  have g++ || { skip 'CMake: the C++ header' g++; cpp=; }
  of_distance=$(needed tests/programs/examples/distance.c)
  check 'CMake: find_package' consumer found "find_package(gjk ${version%.*} REQUIRED CONFIG)" 'gjk shared' "distance plane $cpp"
  check 'CMake: not a later version' refuses_another_version 9.0
  check 'CMake: not an earlier minor version' refuses_another_version 0.0
  check 'CMake: add_subdirectory of the repository' consumer beside "add_subdirectory($(pwd)/port/package/cmake gjk)" gjk distance \
    "$of_distance"
  check 'CMake: add_subdirectory of the package' consumer packed "add_subdirectory($dir/../package/cmake gjk)" gjk "$examples $cpp"
  check 'Zephyr: the module' stand_in zephyr "set(CONFIG_GJK y)
function(zephyr_include_directories)
  include_directories(\${ARGN})
endfunction()
function(zephyr_library_named name)
  add_library(\${name} STATIC \${CMAKE_CURRENT_LIST_FILE})
  set_target_properties(\${name} PROPERTIES LINKER_LANGUAGE C)
endfunction()
function(zephyr_library_sources)
  target_sources(gjk PRIVATE \${ARGN})
endfunction()
include($dir/../package/zephyr/zephyr/CMakeLists.txt)"
  check 'ESP-IDF: the component' stand_in esp "function(idf_component_register)
  cmake_parse_arguments(C \"\" \"\" \"SRCS;INCLUDE_DIRS\" \${ARGN})
  add_library(gjk STATIC \${C_SRCS})
  foreach(folder \${C_INCLUDE_DIRS})
    target_include_directories(gjk PUBLIC $dir/../package/esp-idf/\${folder})
  endforeach()
endfunction()
include($dir/../package/esp-idf/CMakeLists.txt)"
else
  skip 'CMake' cmake
fi
check 'Arduino: layout' arduino_layout
check 'PlatformIO: library.json' json "$build/package/arduino/library.json"
core=/usr/share/arduino/hardware/arduino/avr
mkdir -p "$dir/sketch"
if have avr-g++ && [ -e $core/cores/arduino/Arduino.h ]; then
  avr="-mmcu=atmega2560 -DF_CPU=16000000L -DARDUINO_AVR_MEGA2560 -DARDUINO_ARCH_AVR -I$core/cores/arduino -I$core/variants/mega"
  # shellcheck disable=SC2086
  check 'Arduino: the library for AVR' arduino_library avr-gcc $avr
  for name in Distance Contacts; do
    # shellcheck disable=SC2086
    check "Arduino: $name for AVR" sketch $name avr-g++ $avr
  done
else
  skip 'Arduino for AVR' 'gcc-avr avr-libc arduino-core-avr'
fi
if [ -z "$(missing_package cortex-m3)" ] && have arm-none-eabi-g++; then
  # Debian has no Arduino core for ARM: a stand-in declares what the sketches call.
  mkdir -p "$dir/core"
  printf '#include <stddef.h>\n#include <stdint.h>\nstruct Port { void begin(long); void println(long); };\nextern Port Serial;\n' \
    >"$dir/core/Arduino.h"
  check 'Arduino: the library for ARM' arduino_library arm-none-eabi-gcc -mthumb -mcpu=cortex-m0plus -ffreestanding
  for name in Distance Contacts; do
    check "Arduino: $name for ARM" sketch $name arm-none-eabi-g++ -mthumb -mcpu=cortex-m0plus -ffreestanding "-I$dir/core"
  done
else
  skip 'Arduino for ARM' gcc-arm-none-eabi
fi
finish package
