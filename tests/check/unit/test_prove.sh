#!/bin/sh
# The quick part of `make prove`, and a run of the assertions that the proof takes as given. test_prove.sh BUILD
. tests/build/count.sh
. tests/build/fault.sh
check 'assertions of the sources hold, without undefined behaviour' sh tests/build/bounds.sh "$1" 4000 4001
check 'at least eighty assertions are checked' sh -c "[ \$(cat build/checked/src/*/*.[ch] | grep -c __builtin_trap) -ge 80 ]"
check 'each run that tests/prove/digests.txt names has held on this code' sh tests/build/prove.sh "$1/stale" --stale

# signed of all runs, as both pages say
counted() (
  . tests/build/prove-setup.sh
  said="signs $(grep -vc '^#' tests/prove/digests.txt) of $(runs | wc -l)"
  for page in src/README.md tests/prove/README.md; do
    tr '\n' ' ' <$page | tr -s ' ' | grep -qF "$said" || { echo "$page does not say: $said"; return 1; }
  done
)
check 'the pages say how many runs have held' counted

# Eva passes over a call by a pointer of another type, so the models' functions must be of the types that the sources call.
drivers_fit() (
  mkdir -p "$1/drivers"
  : >"$1/drivers/__fc_builtin.h"
  build=$1/drivers
  . tests/build/prove-setup.sh
  for run in $(runs | awk -F - '!seen[$1]++'); do
    set_up "$run"
    for source in $sources; do
      case $source in
        tests/*)
          gcc -std=c99 -fsyntax-only -w -Werror=incompatible-pointer-types -Werror=int-conversion $defines -Iinclude -I. \
            -idirafter "$1/drivers" -include tests/prove/contracts.h "$source" || return 1
          ;;
      esac
    done
  done
)
check 'drivers and models of the proof have the types that the sources ask for' drivers_fit "$1"

# altered BUILD FILE SCRIPT: a copy of the sources, in which a script of sed has changed a file
altered() {
  copy_sources "$1/altered"
  sed -i "$3" "$1/altered/$2"
  ! cmp -s "$2" "$1/altered/$2" || return 1
  (cd "$1/altered" && sh tests/build/prove.sh build --stale) >"$1/altered/said"
}
# noticed BUILD RUN FILE SCRIPT: the same makes the run stale
noticed() {
  ! altered "$1" "$3" "$4" && grep -q "^of other code: $2\." "$1/altered/said"
}
poses=src/place/gjk_pose.c simplex=src/gjk/gjk_simplex.h
check 'comments are not looked at' altered "$1" $poses '1i // Another comment.'
check 'a change of the code is noticed' noticed "$1" integrate-x-int32 $poses 's/^gjk_status gjk_quat_normalize(.*{/&;/'
check 'nor are prototypes that no run names' altered "$1" $simplex '/^void gjk_simplex_clear/i void gjk_simplex_named_by_none(gjk_simplex *s);'
check 'a prototype that a run names is' noticed "$1" search-1-int16 $simplex 's/^void gjk_simplex_clear(gjk/void gjk_simplex_clear(const gjk/'

if have frama-c; then
  # All runs of digests.txt have held on this code; two are repeated.
  check 'products, decisions' sh tests/build/prove.sh "$1/quick" primitives-x-int32 query-INTERSECT-int32
else
  skip 'the proof' frama-c-base
fi
finish prove
