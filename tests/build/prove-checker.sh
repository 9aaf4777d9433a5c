#!/bin/sh
# Proves the checkers of decisions, distances, depths and casts, with Frama-C's WP, Why3, Z3 and CVC4, and Coq for points that are
# no vertices: prove-checker.sh BUILD [quick | hull | FUNCTION...]
#
# tests/prove/README.md tells what is proven. Each lemma and each obligation of a function is printed with its prover. One
# that is not proven fails, and so does a function of the list without a contract. What is proven is the sources as they
# are, with comments between their lines: see annotate.awk. `quick` proves the functions marked so, as int32; FUNCTION... these alone;
# `hull` the theorems of hull.v alone.
. tests/build/count.sh
LC_ALL=C.UTF-8
export LC_ALL
build=$1
shift
wanted=$*
dir=$build/prove-checker
spec=tests/prove/checker
WHY3CONFIG=$PWD/$dir/why3.conf
export WHY3CONFIG

# The sources with annotations, and the contracts, in $dir. Without the annotations each file must be as it was.
annotate() {
  mkdir -p "$dir/tests/prove" && cp -r src include "$dir" && cp -r $spec "$dir/tests/prove" || return 1
  for file in $(awk '$1 == "in" { print $2 }' $spec/inside.txt | sort -u); do
    awk -v path="$file" -f tests/build/annotate.awk $spec/inside.txt "$file" >"$dir/$file" || return 1
    sed '/^\/\*@.*\*\/$/d' "$dir/$file" | cmp - "$file" || return 1
  done
}

# WP 25 takes (x >> 4) <= 0 for x <= 0, which is wrong. So annotations shift by a word of their own.
shifts() {
  ! grep -n '>>' $spec/*.h | grep -vE 'axiom shifted:|: *//' && ! grep '^/\*@.*>>' $spec/inside.txt
}

provers() {
  version=$(z3 -version | sed 's/.*version \([0-9.]*\).*/\1/')
  why3 config detect >/dev/null 2>&1
  cat >>"$WHY3CONFIG" <<EOC

[prover]
alternative = "ground"
command = "python3 $PWD/tests/build/prove-ground.py %t %f"
driver = "z3_440"
editor = ""
in_place = false
interactive = false
name = "Z3"
shortcut = "ground"
version = "$version"
EOC
  why3 config list-provers | grep -q 'Z3.*(ground)' && why3 config list-provers | grep -q '^CVC4'
}

# The goals of $1 that are open.
open_goals() {
  grep -E '^\[wp\] \[.*\] Goal' "$1" | grep -v ' : Valid'
}

# wp NAME MACHINE DEFINES FILE OPTION LIST: the goals of functions, `-wp-fct FUNCTION,...`, or of lemmas, `-wp-prop NAME,...`,
# in $dir/NAME.txt. Functions that leave one open are tried once more, with more time; lemmas all. TRIES: the seconds of each try.
wp() {
  name=$1 machine=$2 defines=$3 file=$4 option=$5 left=$6
  : >"$dir/$name.txt"
  for seconds in ${TRIES:-20 80}; do
    (cd "$dir" && nice -n 5 frama-c -wp -wp-rte -rte-no-pointer-call -wp-prover ground,cvc4,z3 -wp-timeout "$seconds" -wp-par 2 \
      -wp-cache update -wp-cache-dir "$cache" -machdep "$machine" -cpp-extra-args="-Iinclude -I. -DGJK_VECTORS=0 $defines" \
      "$option" "$left" $spec/"$file") >"$dir/$name.try" 2>&1
    cat "$dir/$name.try" >>"$dir/$name.txt"
    open_goals "$dir/$name.try" >/dev/null || break
    [ "$option" = -wp-prop ] || left=$(for one in $(echo "$left" | tr , ' '); do
      open_goals "$dir/$name.try" | grep -q "Goal typed_${one}_" && echo "$one"
    done | paste -sd, -)
    [ -n "$left" ] || break
  done
  sed -n 's/^\[wp\] \[\(.*\)\] Goal typed_\([^ ]*\) : Valid.*/\2: \1/p' "$dir/$name.txt" | grep -v ': Qed$' | sed "s/^/$name: /"
  open_goals "$dir/$name.try" | sed "s/^/failed: $name: /"
  grep -qE '^\[wp\] Proved goals: *([0-9]+) / \1$' "$dir/$name.try"
}

# Has each function of the run a contract, from which a goal follows?
contracts() {
  for function in $(echo "$2" | tr , ' '); do
    grep -q "Goal typed_${function}_ensures" "$dir/$1.txt" || { echo "no contract: $function"; return 1; }
  done
}

functions() {
  awk -v file="$1" -v machine="$2" -v wanted=" $wanted " '
    /^#/ || NF == 0 { next }
    $3 == "int32" && machine == "gcc_x86_16" { next }
    $1 == file && (wanted ~ /^ *$/ || index(wanted, " " $2 " ") || wanted == " quick " && $3 == "quick") { list = list (list == "" ? "" : ",") $2 }
    END { print list }' $spec/functions.txt
}

# What a run leaves: its goals in $dir/NAME.goals, and in $dir/NAME.list the functions, if it has any.
work() {
  list=$(functions "$4.c" "$2")
  echo "$list" >"$dir/$1.list"
  [ -z "$list" ] || { wp "$1" "$2" "$3" "$4.c" -wp-fct "$list" >"$dir/$1.goals" && : >"$dir/$1.proven"; }
}

# lemmas FILE [HEADER...]: those of all headers that FILE includes, or of these.
lemmas() {
  file_of=$1
  shift
  names=@lemma
  [ $# = 0 ] || names=$(cd $spec && lemma_names "$@" | paste -sd, -)
  wp "lemmas-$file_of" gcc_x86_32 '' "$file_of.c" -wp-prop "$names" >"$dir/lemmas-$file_of.goals" && : >"$dir/lemmas-$file_of.proven"
}

lemma_names() {
  grep -oh 'lemma [a-z_0-9]*:' "$@" | sed 's/lemma //; s/://'
}

# Is each lemma of each header proven in some file?
each_lemma() {
  for lemma in $(lemma_names $spec/*.h); do
    grep -q "Goal typed_lemma_$lemma : Valid" "$dir"/lemmas-*.txt || { echo "no proof of lemma $lemma"; return 1; }
  done
}

report() {
  list=$(cat "$dir/$1.list")
  [ -n "$list" ] || return 0
  cat "$dir/$1.goals"
  check "$1: each obligation is proven" [ -e "$dir/$1.proven" ]
  check "$1: each function has its contract" contracts "$1" "$list"
}

# The theorems of hull.v and solid.v, from nothing but the axioms of Coq's real numbers.
theorems() {
  for file in hull solid; do
    (cd "$dir" && coqc -q -Q $spec '' $spec/$file.v) >"$dir/$file.txt" 2>&1 || { tail -n 5 "$dir/$file.txt"; return 1; }
    sed -n 's/^\([A-Za-z_.][A-Za-z_.]*\) *:.*/\1/p; s/^\([A-Za-z_]*\.[A-Za-z_]*\)$/\1/p' "$dir/$file.txt" | sort -u >"$dir/$file.axioms"
    ! grep -vxE 'Axioms|ClassicalDedekindReals\.sig_(not|forall)_dec|FunctionalExtensionality\.functional_extensionality_dep' \
      "$dir/$file.axioms" && [ "$(grep -c '^Axioms:' "$dir/$file.txt")" = "$(grep -c '^Theorem' "$dir/$spec/$file.v")" ] || return 1
  done
}

# What src/README.md says has to be believed.
counted() {
  python3 tests/build/trust-lines.py >"$dir/lines.txt" || return 1
  cat "$dir/lines.txt"
  sed 's/:.*//' "$dir/lines.txt" | while read -r said; do
    tr '\n' ' ' <src/README.md | grep -qF "$said" || { echo "src/README.md does not say: $said"; exit 1; }
  done
}

for tool in frama-c:frama-c-base why3:why3 z3:z3 cvc4:cvc4 python3:python3; do
  if ! have "${tool%%:*}"; then
    skip 'the proof of the checker' "${tool##*:}"
    finish prove-checker
    exit
  fi
done
rm -rf "$dir"
# What is proven, by the text of each problem and its prover, so that another run tries only what has changed.
cache=$PWD/$build/proven/$(cat tests/build/prove-ground.py tests/build/prove-checker.sh $spec/operators.h | cksum | tr ' ' -)
mkdir -p "$dir" "$cache"
check 'the annotations stand in the sources, which are as they were' annotate
check 'no annotation shifts as C does' shifts
check 'the provers are known' provers
case $wanted in
  '' | quick) check 'src/README.md counts what has to be believed' counted ;;
esac
[ $failed = 0 ] || { finish prove-checker; exit; }
others='plane claim plane_cast space_cast'
# Two at a time, each with half of the work: WP simplifies on one core.
{
  [ -n "$wanted" ] || lemmas space
  work space gcc_x86_32 '' space
} &
[ -n "$wanted" ] || {
  lemmas plane
  lemmas claim claim.h limbs.h
  lemmas plane_cast plane_cast.h
  lemmas space_cast space_cast.h
}
for which in $others; do
  work $which gcc_x86_32 '' $which
done
work int32 gcc_x86_32 '' wide
[ -n "$wanted" ] || work int16 gcc_x86_16 -DGJK_NARROW_MULTIPLY=1 wide
wait
if [ -z "$wanted" ]; then
  for which in $others space; do
    cat "$dir/lemmas-$which.goals"
    check "each lemma of $which.c is proven" [ -e "$dir/lemmas-$which.proven" ]
  done
  check 'each lemma of the headers is proven in some file' each_lemma
fi
if [ -z "$wanted" ] || [ "$wanted" = hull ]; then
  if have coqc; then
    check 'what holds of vertices decides about all points' theorems
  else
    skip 'the theorems about all points' coq
  fi
fi
for which in int32 $others space; do
  report $which
done
[ -n "$wanted" ] || report int16
finish prove-checker
