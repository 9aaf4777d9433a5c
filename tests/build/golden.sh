# Finds the golden hash of one build of the library. Source count.sh first, then this, then call golden.
#
# An architecture is host, one of Debian's with a cross compiler and qemu-user, or a target of the Makefile with its
# emulated board. COMPILER, gcc or clang, compiles the library and the queries; gcc compiles the rest of the program
# and links it.
golden_linux='i386 aarch64 rv64 s390x powerpc'
golden_cores='cortex-m0 cortex-m3 cortex-m4 cortex-m7 cortex-m33 rv32imc avr'

# What clang gets here beside its flags, so that it uses the vectors of this processor.
if grep -qw avx2 /proc/cpuinfo 2>/dev/null; then golden_avx2=-mavx2; else golden_avx2=; fi

golden_triple() {
  case $1 in
    i386) echo i686-linux-gnu ;;
    rv64) echo riscv64-linux-gnu ;;
    *) echo "$1-linux-gnu" ;;
  esac
}

golden_emulator() {
  case $1 in
    rv64) echo qemu-riscv64 ;;
    powerpc) echo qemu-ppc ;;
    *) echo "qemu-$1" ;;
  esac
}

# The packages that a build lacks: golden_missing ARCHITECTURE COMPILER FLAGS
golden_missing() {
  lacking=
  have "$2" || lacking=" $2"
  case $* in
    *' clang '*-flto*) have ld.lld || lacking="$lacking lld" ;;
  esac
  case $1 in
    host) have gcc || lacking="$lacking gcc" ;;
    cortex-* | rv32imc | avr)
      for package in $(missing_package "$1") $(missing_emulator "$1"); do lacking="$lacking $package"; done
      ;;
    *)
      triple=$(golden_triple "$1")
      have "$triple-gcc" || lacking="$lacking gcc-$triple"
      case $1 in
        aarch64) libc=libc6-dev-arm64-cross ;;
        rv64) libc=libc6-dev-riscv64-cross ;;
        *) libc=libc6-dev-$1-cross ;;
      esac
      [ -e "/usr/$triple/include/stdio.h" ] || lacking="$lacking $libc"
      have "$(golden_emulator "$1")" || lacking="$lacking qemu-user"
      ;;
  esac
  echo "${lacking# }"
}

# The sources that programs of golden hashes, the matches and the demos of two processes link.
golden_sources() {
  needed tests/check/target/*golden*.c tests/programs/lockstep/peer.c tests/programs/demo_plane/[!f]*.c \
    tests/programs/demo_plane/flat_solver.c
}

# Makes the library of a build for all scripts that want the same one, and sets golden_objects to its objects:
# golden_library ARCHITECTURE COMPILER FLAGS... Cores: gcc with one level of optimisation alone. With sanitizers, or with the
# ceilings of tests/support/given_ceilings.h as its last flag, it is the library that other tests share, by the usual compiler.
golden_library() {
  case $* in
    *given_ceilings.h)
      golden_objects=build/host-ceilings
      ceilings_library
      return
      ;;
    'host '*-fsanitize=undefined,address*)  # its assertions are checks, too
      golden_objects=build/checked
      checked_library
      return
      ;;
  esac
  golden_port=
  case $* in
    *hosted/gjk_port.h*) golden_port=hosted ;;
  esac
  golden_flags=$(shift 2; echo "$*" | sed 's/ *-DGJK_PORT_HEADER="[^ ]*//')
  golden_name=$(echo "-$2 $golden_flags $golden_port" | sed 's/-fno-sanitize-recover=all//' | tr -cd 'A-Za-z0-9=-')
  [ "$1" = host ] || golden_name=-$1$golden_name
  case $golden_name in  # the usual library
    -gcc-O2hosted) [ "$("${CC:-cc}" -dumpversion)" != "$(gcc -dumpversion)" ] || golden_name= ;;
  esac
  case $1 in
    host)
      if [ -z "$golden_name" ]; then
        library host ''
      else
        library_by_rooms host "$golden_name" "CC=$2" "PORT=$golden_port" "OPT=$golden_flags" "SOURCES=$(golden_sources)"
      fi
      ;;
    avr)
      golden_objects=build/avr${3#-O2}
      library_by_rooms avr "${3#-O2}" "OPT=$3" "SOURCES=$(golden_sources)"
      return
      ;;
    cortex-m3)  # other tests need it by files
      golden_objects=build/$1${3#-O2}
      library "$1" "${3#-O2}" "OPT=$3"
      return
      ;;
    cortex-* | rv32imc)
      golden_objects=build/$1-rooms${3#-O2}
      library_by_rooms "$1" "-rooms${3#-O2}" "OPT=$3"
      return
      ;;
    *)
      library_by_rooms host "$golden_name" "CC=$(golden_triple "$1")-$2" "PORT=$golden_port" "OPT=$golden_flags" \
        "SOURCES=$(golden_sources)"
      ;;
  esac || return 1
  golden_objects=build/host$golden_name
}

# Builds and runs: golden FOLDER ARCHITECTURE COMPILER FLAGS... Prints the hash; succeeds when it is the golden one.
# With golden_shared=1 it takes the library from golden_library, with golden_many=1 a host has the larger sets.
golden() {
  folder=$1 architecture=$2 compiler=$3
  shift 3
  root=$(pwd)
  mkdir -p "$folder"
  rm -f "$folder"/*
  glue="-std=c99 -Iinclude -Iport -I. -Itests/support -Wl,--gc-sections"
  scene="$root/tests/support/scene/match.c $root/tests/check/target/scene_golden.c $root/tests/check/target/concave_golden.c"
  board=$architecture
  case $architecture$* in  # 256 KB of flash are not enough; Cortex-M3 has every instruction of Cortex-M0
    cortex-m0*-O[03]* | cortex-m0*-fsanitize*) board=cortex-m3 ;;
  esac
  case $architecture in
    host)
      linker=gcc
      glue="$glue tests/check/target/golden_host.c port/hosted/gjk_hosted.c ${golden_many:+-DGOLDEN_MANY}"
      ;;
    cortex-* | rv32imc | avr)
      linker=$(make -s "print-TOOLS_$architecture")
      glue="$glue -ffreestanding -fno-tree-loop-distribute-patterns tests/check/target/golden_firmware.c
        $(make -s "print-BOARD_$board")"
      case $board in
        avr) glue="$glue -DGOLDEN_RUN_PAIRS=GOLDEN_FEW_PAIRS" scene= ;;
        cortex-m0) scene= ;;
        *) glue="$glue -DGOLDEN_SCENE" ;;
      esac
      ;;
    *)
      linker=$(golden_triple "$architecture")-gcc
      glue="$glue -static tests/check/target/golden_host.c port/hosted/gjk_hosted.c"
      ;;
  esac
  case $board in  # what fits the memory
    avr) parts=${golden_shared:+1 8 64} parts=${parts:-1 2 4 8 64} ;;  # simavr is slow: make matrix has all
    cortex-m0) parts='1 6 56 64' ;;
    *) parts=127 ;;
  esac
  core=$linker
  if [ "$compiler" = clang ]; then
    case $architecture in
      rv32imc) triple=riscv32-unknown-elf ;;
      cortex-*) triple='arm-none-eabi -fshort-enums' ;;
      host) triple= ;;
      *) triple=$(golden_triple "$architecture") ;;
    esac
    core="clang ${triple:+--target=$triple} $(echo "$linker" | sed 's/^[^ ]*//; s/-fcallgraph-info=su//')"
  fi
  library="$root/src/*/*.c" golden_objects=
  if [ -n "$golden_shared" ]; then
    golden_library "$architecture" "$compiler" "$@" || return 1
    library=
  fi
  # shellcheck disable=SC2086
  (cd "$folder" && $core -std=c99 -ffreestanding -ffunction-sections -fdata-sections "-I$root/include" \
    "-I$root" "-I$root/port" "-I$root/tests/support" "$@" -c $library "$root/tests/check/target/golden.c" \
    "$root/tests/check/target/plane_golden.c" "$root/tests/check/target/motion_golden.c" \
    "$root/tests/check/target/plane_motion_golden.c" "$root/tests/check/target/parts_golden.c" \
    "$root/tests/check/target/hull_golden.c" $scene) || return 1
  case "$compiler $*" in
    clang*-flto*)
      ld.lld -r "$folder"/*.o -o "$folder/all.lto" && rm "$folder"/*.o && mv "$folder/all.lto" "$folder/all.o" || return 1
      ;;
  esac
  case "$*" in
    *given_ceilings.h) glue="$glue tests/support/given_ceilings.c" ;;
    *-fsanitize=*address*) glue="$glue -fsanitize=undefined,address" ;;
    gcc*-flto*) glue="$glue -flto" ;;
  esac
  for part in $parts; do
    case $board-$part in  # what contacts of surfaces need
      cortex-*-56) stack=-Wl,--defsym=STACK_SIZE=9216 ;;
      cortex-*-127 | rv32imc-127) stack=-Wl,--defsym=STACK_SIZE=12288 ;;  # and what move and slide needs among them
      *) stack= ;;
    esac
    # shellcheck disable=SC2086
    $linker $glue $stack "-DGOLDEN_PARTS=$part" -O2 "$folder"/*.o ${golden_objects:+"$golden_objects"/gjk*.o} -lgcc -o "$folder/golden.elf" || return 1
    case $architecture in
      host) "$folder/golden.elf" ;;
      cortex-* | rv32imc | avr) sh tests/build/emulate.sh "$board" "$folder/golden.elf" ;;
      *) "$(golden_emulator "$architecture")" "$folder/golden.elf" ;;
    esac || return 1
  done
}
