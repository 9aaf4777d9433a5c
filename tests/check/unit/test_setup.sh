#!/bin/sh
# Setup installs what is missing, and waits for another apt. test_setup.sh BUILD
#
# apt-get and the other tools that it calls are stand-ins that note how they were called. Nothing is installed.
. tests/build/count.sh
dir=$1/setup-test
rm -rf "$dir"
mkdir -p "$dir/bin"
dir=$(cd "$dir" && pwd)

# stand_in NAME: makes a program of that name of standard input
stand_in() {
  { echo '#!/bin/sh'; cat; } >"$dir/bin/$1"
  chmod +x "$dir/bin/$1"
}

# Each line of failures is what one call says before it fails; when there are none left it succeeds.
stand_in apt-get <<END
echo "\$*" >>"$dir/calls"
say=\$(head -n 1 "$dir/failures")
sed -i 1d "$dir/failures"
[ -z "\$say" ] && exit 0
echo "\$say" >&2
exit 100
END
stand_in dpkg-query <<END
for package; do :; done
grep -q -x "\$package" "$dir/missing" || echo 'install ok installed'
END
stand_in id <<END
echo 0
END
stand_in sleep <<END
echo "\$1" >>"$dir/sleeps"
END

# setup MISSING FAILURE...: its exit status; calls, sleeps and message are kept
setup() {
  echo "$1" >"$dir/missing"
  shift
  : >"$dir/failures"
  for failure; do
    echo "$failure" >>"$dir/failures"
  done
  : >"$dir/calls"
  : >"$dir/sleeps"
  PATH=$dir/bin:$PATH sh tests/build/setup.sh >"$dir/message" 2>&1
}

calls() {
  sed 's/-o [^ ]* //' "$dir/calls" | tr '\n' ';'
}

lists='E: Could not get lock /var/lib/apt/lists/lock. It is held by process 4242 (apt-get)'
archives='E: Unable to lock directory /var/cache/apt/archives/'
update='update;'
install='install -y --no-install-recommends clang;'
check 'all there' setup none
check 'all there: apt-get is left alone' is '' "$(calls)"
check 'a package missing' setup clang
check 'a package missing: it is installed' is "$update$install" "$(calls)"
check 'no pause without a lock' is 0 "$(wc -l <"$dir/sleeps" | tr -d ' ')"
check "dpkg's lock is waited for" grep -q -e '-o DPkg::Lock::Timeout=[1-9][0-9]* install' "$dir/calls"
check 'the lists are locked twice' setup clang "$lists" "$lists"
check 'the lists are locked twice: update waits' is "$update$update$update$install" "$(calls)"
check 'the lists are locked twice: with pauses' is 2 "$(wc -l <"$dir/sleeps" | tr -d ' ')"
check 'the archives are locked' setup clang '' "$archives"
check 'the archives are locked: install waits' is "$update$install$install" "$(calls)"
check 'no network' sh -c '! "$@"' - env PATH="$dir/bin:$PATH" sh -c "echo 'E: Failed to fetch' >'$dir/failures'
  : >'$dir/calls'; sh tests/build/setup.sh"
check 'no network: once is enough' is "$update" "$(calls)"
not_ever() {
  # shellcheck disable=SC2046
  IFS='
' && ! setup clang $(yes "$lists" | head -n 500)
}
check 'a lock for ever is given up' not_ever
check 'a lock for ever: after minutes' is 120 "$(wc -l <"$dir/sleeps" | tr -d ' ')"
check 'a lock for ever: its holder is named' grep -q 'held by process 4242' "$dir/message"
finish setup
