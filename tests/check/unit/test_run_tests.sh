#!/bin/sh
# Does the runner of the tests notice what may go wrong with a test? test_run_tests.sh BUILD
. tests/build/count.sh
unset GJK_NO_SKIP  # what these runs do with skips is tested
dir=$1/run_tests
rm -rf "$dir"
mkdir -p "$dir"

# test NAME: a test of that name, its body from the input
make_test() {
  cat >"$dir/$1.sh"
}

make_test good <<'END'
echo 'good: 3 passed, 0 failed'
END
make_test also_good <<'END'
echo 'also_good: 4 passed, 0 failed'
END
make_test partly <<'END'
echo 'partly: 2 passed, 0 failed, 1 skipped'
END
make_test wrong <<'END'
echo 'wrong: 5 passed, 2 failed'
exit 1
END
make_test hides <<'END'
echo 'hides: 5 passed, 0 failed'
exit 1
END
make_test mute <<'END'
echo 'nothing of the kind'
END
make_test empty <<'END'
echo 'empty: 0 passed, 0 failed'
END
make_test killed <<'END'
echo 'killed: 5 passed, 0 failed'
kill -9 $$
END
make_test kills_runner <<'END'
kill -9 $PPID
END
make_test kills_xargs <<'END'
kill -9 "$(ps -o ppid= -p $PPID | tr -d ' ')"
END
mkdir -p "$dir/other"
cp "$dir/good.sh" "$dir/other/good.sh"

# run STATUS LAST TEST...: does the runner end so, with that last line?
run() {
  want=$1 last=$2
  shift 2
  tests=
  for test in "$@"; do
    tests="$tests $dir/$test.sh"
  done
  # shellcheck disable=SC2086
  sh tests/build/run-tests.sh "$dir" $tests >"$dir/output" 2>&1
  status=$?
  cat "$dir/output"
  [ $status = "$want" ] && [ "$(tail -n 1 "$dir/output")" = "$last" ]
}

check 'counts are added up' run 0 '7 passed, 0 failed' good also_good
check 'skips are counted' run 0 '5 passed, 0 failed, 1 skipped' good partly
check 'a failure' run 1 '8 passed, 2 failed' good wrong
check 'an exit status against the count' run 1 '3 passed, 1 failed' good hides
check 'a test without a count' run 1 '3 passed, 1 failed' good mute
check 'a test that counts nothing' run 1 '3 passed, 1 failed' good empty
check 'a test that is killed' run 1 '3 passed, 1 failed' good killed
check 'a test that is not there' run 1 '3 passed, 1 failed' good missing
check 'two tests of one name' run 1 'run-tests: 0 passed, 1 failed: more than one test named good' good other/good
check 'no tests' run 1 '0 passed, 0 failed'

# How many tests have run by then is chance, but those that have not are failures, and so is the end of xargs.
noticed() {
  run 1 '' "$@"
  [ "$status" = 1 ] && grep -q 'failed: xargs ends with status' "$dir/output" &&
    grep -qE '^[0-9]+ passed, [1-9][0-9]* failed$' "$dir/output"  # not the last line: a test may outlive xargs
}

not_run() {
  grep -q "^$1: 0 passed, 1 failed: not run to its end" "$dir/output"
}

check 'a runner that is killed' noticed kills_runner
check 'its test' not_run kills_runner
check 'a runner that is killed, others waiting' noticed kills_runner good also_good partly
check 'the last of them' not_run partly
if have ps; then
  check 'xargs killed' noticed kills_xargs good also_good
else
  skip 'xargs killed' procps
fi
finish run_tests
