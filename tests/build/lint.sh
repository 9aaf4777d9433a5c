#!/bin/sh
# Static checks: lint.sh BUILD [NODES]. clang-format, clang-tidy, cppcheck with its MISRA addon, shellcheck.
#
# NODES: how far clang's analyser follows each function; the default is its own. It takes most of the time.
# The sources may break those MISRA rules that src/README.md lists with a reason, and no others.
. tests/build/count.sh
dir=$1/lint
mkdir -p "$dir"

c_files() {
  find src include port tests -name '*.[ch]' | sort
}

# The sources, without those of the plane that are sources of scenes in space under other names: the rules are about the
# text, and there it is the same.
texts() {
  grep -L '"../scene[a-z_]*/gjk_scene_[a-z_]*\.c"' src/*/*.c
}

# cppcheck has no headers of the compiler; what port.h and wide.h test is given here.
analyse() {
  # shellcheck disable=SC2046
  cppcheck --quiet --std=c99 --platform=unix32 --enable=warning,style,performance,portability --addon=misra \
    -UGJK_PORT_HEADER -DCHAR_BIT=8 -DUINT_MAX=4294967295U -DINT32_MAX=2147483647 -DUINT32_MAX=4294967295U \
    --suppress=shiftNegativeLHS --suppress=shiftTooManyBitsSigned --suppress=ctuuninitvar --suppress=shadowFunction \
    -Iinclude --template='{file}:{line}: {id}: {message}' "$dir"/rooms/*.c 2>"$dir/cppcheck.txt"
}

misra_rules() {
  grep -o 'misra-c2012-[0-9.]*[0-9]' "$dir/cppcheck.txt" | sed 's/misra-c2012-//' | sort -u >"$dir/broken"
  sed -n 's/^| \([0-9]*\.[0-9]*\) | ..*/\1/p' src/README.md | sort -u >"$dir/listed"
  diff "$dir/listed" "$dir/broken"
}

# shellcheck disable=SC2046
rooms "$dir/rooms" $(texts)
if have clang-format; then
  # shellcheck disable=SC2046
  check 'clang-format: every source' clang-format --dry-run -Werror $(c_files)
else
  skip 'clang-format' clang-format
fi
if have clang-tidy; then
  # shellcheck disable=SC2046
  check 'clang-tidy: src, include' nice clang-tidy --quiet $(texts) -- -std=c99 -Iinclude -Iport \
    -Xclang -analyzer-config -Xclang "max-nodes=${2:-225000}"
else
  skip 'clang-tidy' clang-tidy
fi
if have cppcheck; then
  check 'cppcheck runs' analyse
  check 'cppcheck: nothing but MISRA rules' sh -c "! grep -v misra-c2012 '$dir/cppcheck.txt'"
  check 'cppcheck: as many files as there are break some rule' grep -q 'src/arith/gjk_wide.h.*misra' "$dir/cppcheck.txt"
  check 'MISRA C:2012: the rules that src/README.md lists' misra_rules
else
  skip 'cppcheck and MISRA' cppcheck
fi
if have shellcheck; then
  check 'shellcheck: the scripts' shellcheck -s sh -e SC2013,SC2016,SC2086,SC1091,SC2034,SC2154 tests/build/*.sh tests/check/unit/*.sh
else
  skip 'shellcheck' shellcheck
fi
finish lint
