#!/bin/sh
# The most expensive pairs on an emulated Cortex-M3. They must take the recorded iterations, and at most 5 % more than
# the recorded instructions: room for another compiler, but not for a slower path. test_worst_target.sh BUILD
. tests/build/count.sh
build=$1/worst-replay
mkdir -p "$build"

replay() {
  sh tests/build/worst-case.sh "$build" replay >"$build/replayed"
}

# Recorded figures and replayed ones, case by case.
bounded() {
  awk -F'|' '
    FNR == NR && /^case / { split($0, word, " "); id = word[2]; cases++ }
    FNR == NR && /^# iterations / { split($0, word, " "); iterations[id] = word[3]; most[id] = word[5] }
    FNR == NR { next }
    { replayed++ }
    $2 != iterations[$1] { print $1 ": " $2 " iterations, not " iterations[$1]; bad = 1 }
    $3 > most[$1] * 1.05 || $3 == 0 { print $1 ": " $3 " instructions, recorded " most[$1]; bad = 1 }
    END { exit bad || cases == 0 || cases != replayed }' tests/data/worst.txt "$build/replayed"
}

missing="$(missing_package cortex-m3) $(missing_emulator cortex-m3)"
if [ -z "${missing# }" ]; then
  check 'the replay' replay
  check 'iterations and instructions as recorded' bounded
else
  skip 'the most expensive pairs on Cortex-M3' "$missing"
fi
finish worst_target
