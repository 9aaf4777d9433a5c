#!/bin/sh
# What was built with other flags is built again, and nothing else is. test_flags.sh BUILD
#
# It works on a copy of the Makefile with a library of one file, so that the builds of other tests do not change.
. tests/build/count.sh
dir=$1/flags-test
rm -rf "$dir"
mkdir -p "$dir/src/query" "$dir/tests/check/unit" "$dir/tests/measure/target"
cp Makefile "$dir"
cp -r include port "$dir"
cp src/query/gjk_status.c "$dir/src/query"
cat >"$dir/tests/check/unit/test_tiny.c" <<'END'
int main(void) {
  return 0;
}
END
cat >"$dir/tests/measure/target/tiny.c" <<'END'
int tiny(void);
int tiny(void) {
#ifdef TINY
  return TINY;
#else
  return 0;
#endif
}
END
cat >"$dir/tests/measure/target/tiny_firmware.c" <<'END'
int firmware_main(void);
int firmware_main(void) {
  return 0;
}
END

# again FILE WORDS...: make WORDS writes FILE anew, and a second time leaves it.
again() {
  file=$1
  shift
  before=$(cksum "$dir/$file" 2>/dev/null; ls -i --time-style=full-iso -l "$dir/$file" 2>/dev/null)
  make -s -C "$dir" "$@" || return 1
  after=$(cksum "$dir/$file"; ls -i --time-style=full-iso -l "$dir/$file")
  [ "$before" != "$after" ] || { echo "$file is as it was"; return 1; }
  make -s -C "$dir" "$@" || return 1
  [ "$after" = "$(cksum "$dir/$file"; ls -i --time-style=full-iso -l "$dir/$file")" ] ||
    { echo "$file is written twice"; return 1; }
}

lib=build/host/libgjk.a
unset CC OPT PORT TARGET VARIANT
check 'a library' again $lib lib
check 'another level' again $lib lib OPT=-Os
check 'a folder of src as one file' again $lib lib ROOMS=1
check 'the level of before' again $lib lib
check 'another port' again $lib lib PORT=generic
check 'no port' again $lib lib PORT=
check 'another definition in OPT' again $lib lib OPT='-O2 -DTEXT="a b"'
check 'another archiver' again $lib lib AR_host='ar '
check 'a program' again build/test_tiny build/test_tiny
check 'the library that a program is linked with' again build/test_tiny build/test_tiny OPT=-O1
check 'another variant' again build/host-x/libgjk.a lib VARIANT=-x
check 'another level of a variant' again build/host-x/libgjk.a lib VARIANT=-x OPT=-O0
if have clang && have gcc; then
  check 'gcc' again $lib lib CC=gcc
  check 'clang' again $lib lib CC=clang
  check 'a program with gcc' again build/hosted/tests/check/unit/test_tiny.o build/test_tiny CC=gcc
  check 'a program with clang' again build/hosted/tests/check/unit/test_tiny.o build/test_tiny CC=clang
else
  skip 'another compiler' 'gcc clang'
fi
missing=$(missing_package cortex-m3)
if [ -n "$missing" ]; then
  skip 'firmware with other flags' "$missing"
else
  core=build/cortex-m3
  check 'another target' again $core/libgjk.a lib TARGET=cortex-m3
  check 'firmware' again $core/tiny.elf $core/tiny.elf TARGET=cortex-m3
  check 'firmware with a definition' again $core/tiny.elf $core/tiny.elf TARGET=cortex-m3 FIRMWARE_DEFINES=-DTINY=1
  check 'firmware with another definition' again $core/tiny.elf $core/tiny.elf TARGET=cortex-m3 FIRMWARE_DEFINES=-DTINY=2
  check 'firmware at another level' again $core/tiny.elf $core/tiny.elf TARGET=cortex-m3 FIRMWARE_DEFINES=-DTINY=2 OPT=-Os
  check 'the library of the host beside a target' again $lib build/test_tiny TARGET=cortex-m3 OPT=-Os PORT=mps2
fi
finish flags
