#!/bin/sh
# Fuzzes pairs, the reader of cases, hostile arguments, bodies of many parts, hulls and masses, scenes, forged claims,
# casts, the plane, its ground, arms, gjk-convert and its reader of robots with libFuzzer:
# fuzz.sh BUILD SECONDS SEED [TARGET...]
#
# The seconds are shared out evenly. 3000x in their place: as many inputs for each target. SEED 0 is a new one each time.
# Runs begin with inputs that once failed (tests/check/fuzz/once) and with those that reached new code before, which are
# kept in BUILD/fuzz/corpus. An input that fails is kept in BUILD/fuzz and printed, a pair also as a case for
# build/gjk-query. The exit status is 1 then.
. tests/build/count.sh
build=$1/fuzz
amount=$2
seed=$3
shift 3
[ $# -gt 0 ] || set -- pairs cases arguments parts solids scene claims casts plane ground arms convert urdf
case $amount in
  *x) limit=-runs=${amount%x} level=-O0 ;;  # a few runs take less time than the compiler saves on them
  *) limit=-max_total_time=$((amount / $#)) level=-O1 ;;
esac
mkdir -p "$build"

flags="-std=c99 -gline-tables-only $level -fsanitize=address,undefined -fno-sanitize-recover=all -Iinclude -I. -Iport -Itests/support"
if ! have clang; then
  echo 'skipped: fuzz: needs clang'
  exit 0
fi
# shellcheck disable=SC2086
if ! echo 'int LLVMFuzzerTestOneInput(const char *d, unsigned long n) { (void)d; (void)n; return 0; }' |
  clang $flags -fsanitize=fuzzer -x c - -o "$build/probe" 2>/dev/null; then
  echo 'skipped: fuzz: needs libclang-rt-dev'
  exit 0
fi

# fuzz TARGET OPTIONS...: one target, for its share of the time
fuzz() {
  target=$1
  shift
  mkdir -p "$build/corpus/$target"
  ln -f "$build/all" "$build/$target" || return 1
  if ! nice "$build/$target" "$limit" -seed="$seed" -timeout=20 -print_final_stats=1 \
    -artifact_prefix="$build/$target-" "$@" "$build/corpus/$target" "$build/seeds-$target" >"$build/$target.log" 2>&1; then
    echo "failed: $target: $(grep -a -m 1 '^fuzz: ' "$build/$target.log")"
    grep -a -E 'ERROR|runtime error|Seed:' "$build/$target.log"
    for input in "$build/$target"-crash-* "$build/$target"-timeout-*; do
      [ -e "$input" ] || continue
      case $target in
        pairs | claims | casts | plane) GJK_FUZZ_PRINT=1 "$build/$target" "$input" 2>/dev/null | tee "$input.case" ;;
      esac
      echo "the input $input, in base64:"
      base64 "$input"
    done
    return 1
  fi
  awk -v target="$target" '
    /number_of_executed_units/ { n = $2 }
    /new_units_added/ { added = $2 }
    / cov: / { for (i = 1; i < NF; i++) if ($i == "cov:") reached = $(i + 1) }
    END {
      printf "%s: %d inputs, %d of them reached new code, %d places reached\n", target, n, added, reached
      exit n < 100
    }' "$build/$target.log"
}

# What the targets share, compiled once. The fuzzer looks at what the library and the reader of cases do, not at the
# oracles: these are as other tests have them.
rm -rf "$build/objects"
mkdir -p "$build/objects"
oracles=$(printf 'build/hosted/%s.o\n' tests/support/exact/*.c tests/support/generate/*.c tests/support/reference/random_shape.c |
  sed 's/\.c\.o$/.o/')
# shellcheck disable=SC2086
make -s $oracles >/dev/null || exit 1
# All targets are one program, linked once, which does what it is called.
{
  printf '#include <stdint.h>\n#include <stdlib.h>\n#include <string.h>\n'
  printf 'int fuzz_%s(const uint8_t *data, size_t size);\n' "$@"
  echo 'static int (*target)(const uint8_t *data, size_t size);'
  echo 'int LLVMFuzzerInitialize(int *count, char ***words);'
  echo 'int LLVMFuzzerInitialize(int *count, char ***words) {'
  echo '  const char *slash = strrchr(**words, 47), *name = slash == NULL ? **words : slash + 1;'
  echo '  (void)count;'
  for target; do
    echo "  if (strcmp(name, \"$target\") == 0) target = fuzz_$target;"
  done
  printf '  return 0;\n}\n'
  echo 'int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);'
  printf 'int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) {\n  return target(data, size);\n}\n'
} >"$build/all.c"
# shellcheck disable=SC2046
rooms "$build/rooms" $(needed tests/check/fuzz/*.c tests/programs/convert/*.c)
for source in $(printf 'tests/check/fuzz/%s.c ' "$@") "$build/all.c" tests/check/fuzz/bytes.c tests/check/fuzz/hostile.c tests/check/fuzz/overlap.c tests/support/case/case.c tests/support/case/case2.c \
  tests/support/case/case2_collider.c tests/support/case/lines.c tests/support/case/number.c tests/support/case/parse.c tests/support/case/parse2.c \
  tests/support/scene/world.c tests/support/scene/session.c tests/programs/convert/*.c "$build"/rooms/*.c; do
  case $source in
    */convert/main.c) continue ;;
    tests/check/fuzz/bytes.c | tests/check/fuzz/hostile.c | tests/check/fuzz/overlap.c) seen= ;;
    tests/check/fuzz/*)
      entry=${source##*/}
      seen="-fsanitize=fuzzer-no-link -DLLVMFuzzerTestOneInput=fuzz_${entry%.c}"
      ;;
    */rooms/* | tests/support/case/* | tests/programs/convert/*) seen=-fsanitize=fuzzer-no-link ;;
    *) seen= ;;
  esac
  # shellcheck disable=SC2086
  clang $flags $seen -c "$source" -o "$build/objects/$(echo "${source%.c}" | tr / -).o" || exit 1
done
# shellcheck disable=SC2086
clang $flags -fsanitize=fuzzer "$build"/objects/*.o $oracles -lm -o "$build/all" || exit 1
# shellcheck disable=SC2046
rm "$build/objects/$(echo "$build/all" | tr / -).o" $(printf "$build/objects/tests-check-fuzz-%s.o " "$@")

mkdir -p "$build/seeds-pairs" "$build/seeds-cases" "$build/seeds-arguments" "$build/seeds-scene" \
  "$build/seeds-claims" "$build/seeds-parts" "$build/seeds-solids" "$build/seeds-casts" "$build/seeds-plane" "$build/seeds-ground" \
  "$build/seeds-arms" "$build/seeds-convert" "$build/seeds-urdf"
# shellcheck disable=SC2086
clang $flags tests/check/fuzz/seeds.c "$build"/objects/*.o $oracles -lm -o "$build/seeds" &&
  "$build/seeds" "$build/seeds-pairs" tests/data/arm.txt tests/data/query.txt tests/data/trackers.txt &&
  "$build/seeds" "$build/seeds-casts" tests/data/cast.txt || exit 1
cp tests/data/*.txt "$build/seeds-cases"
cp "$build"/seeds-pairs/* "$build/seeds-arguments"
# The first byte of a file for gjk-convert is its format. A tetrahedron in three of them and an STL of bytes.
{ printf '\0' && printf 'v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nf 1 3 2\nf 1 2 4\nf 2 3 4\nf 1 4 3\n'; } >"$build/seeds-convert/obj"
{ printf '\3OFF\n4 4 6\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n' && printf '3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n'; } >"$build/seeds-convert/off"
{
  printf '\2ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\nproperty float z\nelement face 4\n'
  printf 'property list uchar int vertex_indices\nend_header\n0 0 0\n1 0 0\n0 1 0\n0 0 1\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 0 3 2\n'
} >"$build/seeds-convert/ply"
{ printf '\1' && head -c 80 /dev/zero && printf '\1\0\0\0' && head -c 50 /dev/zero; } >"$build/seeds-convert/stl"
{ printf '\1solid\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendsolid\n'; } >"$build/seeds-convert/text-stl"
{ printf '\4 0 0 0\n7 7 7\n'; } >"$build/seeds-convert/points"
# A robot and its pairs, without meshes.
sed 's/<mesh filename=[^>]*>/<box size="0.1 0.1 0.2"\/>/' tests/data/robot/six.urdf >"$build/seeds-urdf/six"
{ cat "$build/seeds-urdf/six" && echo '%' && cat tests/data/robot/six.srdf; } >"$build/seeds-urdf/pairs"
for input in tests/check/fuzz/once/*; do
  entry=${input##*/}
  cp "$input" "$build/seeds-${entry%%-*}"
done

status=0
for target in "$@"; do
  case $target in
    cases) fuzz cases -close_fd_mask=2 -max_len=4096 || status=1 ;;
    claims) fuzz claims -max_len=128 || status=1 ;;
    plane) fuzz plane -max_len=512 || status=1 ;;
    scene) fuzz scene -max_len=192 -len_control=10 || status=1 ;;
    parts | solids | arms | ground) fuzz "$target" -max_len=2048 -len_control=0 || status=1 ;;
    urdf) fuzz urdf -max_len=8192 || status=1 ;;
    *) fuzz "$target" -max_len=2048 || status=1 ;;
  esac
done
exit $status
