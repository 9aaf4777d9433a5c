#!/bin/sh
# Every test that draws random numbers prints its seed, and takes another one from GJK_TEST_SEED. test_seeds.sh BUILD
. tests/build/count.sh
build=$1
export GJK_TEST_PERCENT=1 GJK_TEST_SEED=271828

# A seed that is written where it is used would be neither printed nor given.
no_seed_of_its_own() {
  ! grep -nE 'random_seed\((SEED|[0-9])|generate_pair\([^,]*, *(SEED|[0-9])' "$1"
}

# Its trials are not waited for.
prints_its_seed() {
  $by_lines "$1" >"$build/seeds/pipe" 2>&1 &
  grep -q -m 1 '^seed 271828$' "$build/seeds/pipe"
  found=$?
  kill $! 2>/dev/null
  wait $! 2>/dev/null
  return $found
}

by_lines=
if have stdbuf; then by_lines='stdbuf -oL'; fi
rm -rf "$build/seeds"
mkdir -p "$build/seeds"
mkfifo "$build/seeds/pipe"
count=0
for source in tests/check/unit/test_*.c; do
  name=$(basename "$source" .c)
  if grep -qE 'random_seed\(|generate_pair\(' "$source"; then
    count=$((count + 1))
    check "$name: no seed of its own" no_seed_of_its_own "$source"
    check "$name prints its seed" prints_its_seed "$build/$name"
  fi
done
check 'there are such tests' [ $count -gt 30 ]

# A failed check names the trial, and shows its case in a form that gjk-query reads.
cat >"$build/seeds/fails.c" <<'END'
#include "case/case.h"
#include "check.h"
#include "random.h"
int main(void) {
  static case_posed posed = {GJK_BOX(100, 200, 300), GJK_CAPSULE(50, 90), GJK_POSE_IDENTITY, GJK_POSE_IDENTITY};
  random_state random = random_seed(check_seed(1));
  posed.at_b.position.x = random_range(&random, 1000, 2000);
  check_trial(7, case_show_posed, &posed);
  CHECK(posed.at_b.position.x < 1000);
  return check_done("fails");
}
END
support=$(make -s print-SUPPORT)
# shellcheck disable=SC2086
check 'a test that fails is built' "${CC:-cc}" -std=c99 -Iinclude -Itests/support "$build/seeds/fails.c" $support \
  "$build/host/libgjk.a" -lm -o "$build/seeds/fails"
"$build/seeds/fails" >"$build/seeds/output"
check 'it names the trial and the seed' grep -q '^  trial 7 of seed 271828$' "$build/seeds/output"
sed -n '/^case /,/^B turn/p' "$build/seeds/output" >"$build/seeds/case"
check 'gjk-query answers its case' sh -c "'$build/gjk-query' '$build/seeds/case' | grep -q '^posed separated distance='"
finish seeds
