#!/bin/sh
# A long campaign of certified pairs, or casts, over two cores: soak.sh BUILD PAIRS [TEST]
#
# Runs chunks of TEST, test_certificates or one of its kind, one seed each. The state of a campaign is a folder of
# BUILD/soak, one for each version of that program. It holds the program, and in 'done' the seeds that are finished. So
# an interrupted campaign goes on where it was, and a larger one after a smaller one does only the rest. A chunk that
# fails shows its pairs as cases for build/gjk-query, keeps them in SEED.log, and runs again the next time.
CHUNK=100000
FIRST_SEED=1000000

# chunk PROGRAM STATE SEED
if [ "$1" = --chunk ]; then
  log=$3/$4.log
  if nice "$2" "$4" $CHUNK >"$log" 2>&1; then
    rm -f "$log"
    echo "$4" >>"$3/done"
    echo finished
  else
    echo "failed $4 $log"
  fi
  exit 0
fi

test=${3:-test_certificates}
chunks=$((($2 + CHUNK - 1) / CHUNK))
version=$(cksum <"$1/$test")
state=$1/soak/${version%% *}
mkdir -p "$state"
[ -e "$state/program" ] || cp "$1/$test" "$state/program"
: >>"$state/done"
awk -v first=$FIRST_SEED -v chunks=$chunks '
  { done[$1] }
  END { for (i = 0; i < chunks; i++) if (!((first + i) in done)) print first + i }' "$state/done" |
  xargs -r -P 2 -n 1 sh "$0" --chunk "$state/program" "$state" |
  {
    before=$(awk -v last=$((FIRST_SEED + chunks)) '$1 < last' "$state/done" | wc -l)
    start=$(date +%s)
    good=0 bad=0
    echo "$((before * CHUNK)) of $((chunks * CHUNK)) pairs are done"
    while read -r outcome seed log; do
      if [ "$outcome" = finished ]; then
        good=$((good + 1))
      else
        bad=$((bad + 1))
        echo "failed: seed $seed, all of it in $log"
        cat "$log"
      fi
      rate=$((good * CHUNK / ($(date +%s) - start + 1) + 1))
      left=$(((chunks - before - good - bad) * CHUNK / rate / 60))
      [ $(((good + bad) % 10)) != 0 ] ||
        echo "$(((before + good) * CHUNK)) pairs certified, $bad chunks failed, $rate pairs a second, $left minutes left"
    done
    echo "soak: $(((before + good) * CHUNK)) pairs certified, $bad chunks failed"
    [ $bad = 0 ] && [ $((before + good)) -ge $chunks ]
  }
