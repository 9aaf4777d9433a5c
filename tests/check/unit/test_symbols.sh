#!/bin/sh
# What the objects need of their surroundings: no symbol on Cortex-M3 and up, elsewhere the integer helpers of the
# compiler that are listed below. No data that changes, no recursion, and little stack. test_symbols.sh BUILD [all]
#
# Without all, Cortex-M7 and -M33, for which the compiler takes the instructions of -M4, are left out, and -M4 at -Os and RV32
# at -O2. Of Cortex-M0 and -M4 at -O2 and RV32 at -Os, compiled by folders, only symbols and data are looked at.
. tests/build/count.sh

# Most bytes of stack of a query, where registers are as wide as the halves of wide integers.
STACK_LIMIT=1064

# allowed TARGET LEVEL: each helper with its reason
allowed() {
  case $1$2 in
    cortex-m0-O2) echo '__aeabi_lmul __aeabi_uidiv __aeabi_idiv __aeabi_lasr' ;;  # ARMv6-M multiplies to 32 bits, and does not divide; a shift in rare code
    cortex-m0-Os) echo '__aeabi_lmul __aeabi_uidiv __aeabi_idiv __aeabi_llsl __aeabi_llsr __aeabi_lasr' ;;  # shifts: a call is shorter
    rv32imc-O2) echo '__ashrdi3' ;;  # the same
    rv32imc-Os) echo '__ashldi3 __lshrdi3 __ashrdi3 memcpy' ;;  # and GCC copies three words by a call
    cortex-m3-clang-*) echo '__aeabi_memclr4 __aeabi_memclr8' ;;  # clears a row; port/board/memory.c has it
  esac
}

# undefined NM OBJECTS: symbols that no object of the library defines
undefined() {
  nm=$1
  shift
  "$nm" "$@" | awk '
    NF == 2 && $1 == "U" { wanted[$2] }
    NF == 3 { defined[$3] }
    END { for (symbol in wanted) if (!(symbol in defined)) print symbol }'
}

# only_allowed TARGET LEVEL NM FOLDER
only_allowed() {
  bad=0
  for symbol in $(undefined "$3" "$4"/gjk*.o); do
    case " $(allowed "$1" "$2") " in
      *" $symbol "*) ;;
      *) echo "$1 $2 needs $symbol"; bad=1 ;;
    esac
  done
  [ $bad = 0 ]
}

no_mutable_data() {
  "$1" "$2"/gjk*.o | awk '
    NR > 1 && $2 > 0 { print "data in " $6; bad = 1 }
    NR > 1 && $3 > 0 { print "bss in " $6; bad = 1 }
    END { exit bad || NR < 2 }'
}

stack() {
  awk -v roots="$2" -f tests/build/stack.awk tests/build/indirect-calls.txt "$1"/gjk*.ci
}

little_stack() {
  stack "$1" 'gjk_intersect gjk_within gjk_within_until gjk_distance' |
    awk -v limit=$STACK_LIMIT '$2 > limit { print; bad = 1 } END { exit bad || NR != 4 }'
}

# Most bytes of stack of a cast, and of a time of impact.
CAST_LIMIT=1888
IMPACT_LIMIT=1848

little_cast_stack() {
  stack "$1" 'gjk_cast gjk_cast_ray' | awk -v limit=$CAST_LIMIT '$2 > limit { print; bad = 1 } END { exit bad || NR != 2 }' &&
    stack "$1" gjk_time_of_impact | awk -v limit=$IMPACT_LIMIT '$2 > limit { print; bad = 1 } END { exit bad || NR != 1 }'
}

# Most bytes of stack in the plane: of a distance; of contacts; of casts and times of impact.
PLANE_DISTANCE_LIMIT=640
PLANE_CONTACTS_LIMIT=1392
PLANE_MOTION_LIMIT=1520

little_plane_stack() {
  stack "$1" 'gjk2_intersect gjk2_within gjk2_distance' |
    awk -v limit=$PLANE_DISTANCE_LIMIT '$2 > limit { print; bad = 1 } END { exit bad || NR != 3 }' &&
    stack "$1" 'gjk2_penetration gjk2_contacts' |
    awk -v limit=$PLANE_CONTACTS_LIMIT '$2 > limit { print; bad = 1 } END { exit bad || NR != 2 }' &&
    stack "$1" 'gjk2_cast gjk2_cast_ray gjk2_time_of_impact' |
    awk -v limit=$PLANE_MOTION_LIMIT '$2 > limit { print; bad = 1 } END { exit bad || NR != 3 }'
}

# apart NM DIR: what the plane needs of the library is of the plane or of src/arith, and nothing else needs the plane.
apart() {
  arith=$(find src/arith -name '*.c' | sed 's|.*/||; s|c$|o|')
  (
    cd "$2" || exit 1
    own=$("$1" gjk2_*.o | awk '$2 == "T" || $2 == "R" { print $3 }')
    shared=$(for object in $arith; do "$1" "$object"; done | awk '$2 == "T" || $2 == "R" { print $3 }')
    "$1" gjk2_*.o | awk '$1 == "U" && $2 ~ /^gjk/ { print $2 }' | sort -u >plane.wanted
    "$1" gjk_*.o | awk '$1 == "U" && $2 ~ /^gjk/ { print $2 }' | sort -u >space.wanted
    printf '%s\n' "$own" "$shared" | sort -u >plane.given
    printf '%s\n' "$own" | sort -u >plane.own
    bad=$(comm -23 plane.wanted plane.given; comm -12 space.wanted plane.own)
    echo "$bad"
    [ -z "$bad" ] && [ -s plane.wanted ] && [ -s space.wanted ]
  )
}

for target in cortex-m0 cortex-m3 cortex-m4 cortex-m7 cortex-m33 rv32imc; do
  prefix=$(tool_prefix $target)
  if [ -n "$(missing_package $target)" ]; then
    skip "symbols of $target" "$(missing_package $target)"
    continue
  fi
  for level in -O2 -Os; do
    case $2-$target$level in
      -cortex-m7-* | -cortex-m33-* | -cortex-m4-Os | -rv32imc-O2) continue ;;
    esac
    made=library variant=${level#-O2}
    case $2-$target$level in
      -cortex-m0-O2 | -cortex-m4-O2) made=library_by_rooms variant=-rooms ;;
      -rv32imc-Os) made=library_by_rooms variant=-rooms-Os ;;
    esac
    objects=build/$target$variant
    check "$target $level compiles" $made $target "$variant" OPT=$level
    check "$target $level needs nothing unlisted" only_allowed $target $level ${prefix}nm "$objects"
    check "$target $level has no mutable data" no_mutable_data ${prefix}size "$objects"
    [ $made = library ] || continue  # the rest needs to know the file of a function
    functions=$(${prefix}nm "$objects"/gjk*.o | awk '$2 == "T" { print $3 }')
    check "$target $level: the plane and space need nothing of each other" apart ${prefix}nm "$objects"
    check "$target $level calls in no circle" stack "$objects" "$functions"
    case $target in
      cortex-m0 | rv32imc) ;;
      *)
        check "$target $level: a query needs at most $STACK_LIMIT bytes of stack" little_stack "$objects"
        check "$target $level: a cast and an impact need little stack" little_cast_stack "$objects"
        check "$target $level: a query of the plane needs little stack" little_plane_stack "$objects"
        ;;
    esac
  done
done

# clang calls libc where gcc does not: a copy whose ends may overlap becomes memmove, which firmware may lack.
missing=$(have clang || echo clang)
missing="$missing $(missing_package cortex-m3)"
if [ "$missing" != ' ' ]; then
  skip 'symbols of cortex-m3 by clang' "$missing"
else
  check 'cortex-m3 -O2 compiles with clang' library cortex-m3 -clang OPT=-O2 WARNINGS= \
    'TOOLS_cortex-m3=clang --target=arm-none-eabi -mcpu=cortex-m3 -fshort-enums'
  check 'cortex-m3 -O2 by clang needs nothing unlisted' only_allowed cortex-m3-clang -O2 arm-none-eabi-nm build/cortex-m3-clang
fi
finish symbols
