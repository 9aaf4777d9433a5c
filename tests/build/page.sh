#!/bin/sh
# Writes the page, BUILD/page/index.html, one file that opens from disk: page.sh BUILD
#
# The library, gjk-query's answers and what else the page computes become one WebAssembly module, which stands in the page
# in base 64; so do the style sheet and the scripts. Needs clang, wasm-ld (Debian: clang lld).
. tests/build/count.sh
build=$1/page
sources=tests/programs/page
if ! have clang || ! have wasm-ld; then
  echo 'The page needs clang lld: `make setup` installs them.' >&2
  exit 1
fi
mkdir -p "$build"
wasm_objects || exit 1
# shellcheck disable=SC2046
WASM_EXPORTS="gjk_port_.*" sh port/wasm/build.sh "$build/page.wasm" -nostdlibinc -I$sources/libc -I. -Itests/support -Wno-sign-compare \
  $(grep -ohE '\bpage_[a-z0-9_]+\(' $sources/*.h | sed 's/($//; s/^/-Wl,--export=/' | sort -u) \
  $sources/*.c $sources/libc/*.c tests/support/case/[!ac]*.c tests/support/case/answer*.c tests/support/case/case*.c \
  tests/support/reference/reference_float.c tests/support/reference/reference.c tests/support/reference/reference2.c \
  tests/programs/query/motion*.c tests/programs/query/trace.c tests/programs/query/trace_space.c \
  tests/programs/query/trace_plane.c tests/check/target/golden.c tests/check/target/plane_golden.c \
  -DFLAT_BODIES=200 -DFLAT_POINTS=1200 tests/programs/demo_plane/flat_solver.c || exit 1

# A template whose lines @NAME@ are replaced by the files of that name.
base64 -w 0 "$build/page.wasm" >"$build/WASM"
cat $sources/style.css >"$build/STYLE"
# Instructions on a Cortex-M3, of the table of tests/measure/README.md.
awk -F ' *[|] *' '/<!-- figures: cost -->/ { inside = 1; print "const README_COSTS = {" }
  inside && /<!-- end -->/ { exit }
  inside && $2 ~ /: (distance|depth|contacts|intersect)$/ && $5 ~ /^[0-9]/ { printf "  \"%s\": \"%s\",\n", $2, $5 }
  END { print "};" }' tests/measure/README.md >"$build/costs.js"
scripts='core case plane expand solid main idea_steps view_idea view_lattice view_space view_lockstep view_game start'
for script in $scripts; do
  cat "$sources/$script.js"
done | cat port/wasm/gjk.js "$build/costs.js" - >"$build/SCRIPT"
awk -v from="$build" '{
    while (match($0, /@[A-Z]+@/)) {
      name = from "/" substr($0, RSTART + 1, RLENGTH - 2)
      printf "%s", substr($0, 1, RSTART - 1)
      $0 = substr($0, RSTART + RLENGTH)
      while ((getline line <name) > 0) print line
      close(name)
    }
    print
  }' $sources/index.html >"$build/index.html"
rm "$build/WASM" "$build/STYLE" "$build/SCRIPT" "$build/costs.js"
[ "$(wc -c <"$build/index.html")" -lt 1000000 ] || { echo "page.sh: the page is too large" >&2; exit 1; }
