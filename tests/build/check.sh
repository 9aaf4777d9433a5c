#!/bin/sh
# A quick look at a change: its formatting, quick tests, and the golden hash of this machine. check.sh BUILD TEST...
. tests/build/count.sh
. tests/build/golden.sh
build=$1
golden_shared=1
shift

# The sources that differ from the last commit.
changed() {
  git diff --name-only --diff-filter=d HEAD -- '*.[ch]' && git ls-files --others --exclude-standard -- '*.[ch]'
}

# formatted FILES...
formatted() {
  [ $# = 0 ] || clang-format --dry-run -Werror "$@"
}

if ! have clang-format; then
  skip 'formatting' clang-format
elif ! have git || ! files=$(changed 2>/dev/null); then
  skip 'formatting' 'git, in a clone'
else
  # shellcheck disable=SC2086
  check "formatting of changed files" formatted $files
fi
for test; do
  check "$(basename "$test")" "$test"
done
check 'the golden hash' golden "$build/check" host "${CC:-cc}" -O2 '-DGJK_PORT_HEADER="hosted/gjk_port.h"'
finish check
