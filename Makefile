# Builds the library, its tools and its tests. `make help` lists what there is.
#
#   make                 the host library, build/gjk-query, build/gjk-convert and build/gjk-demo
#   make demo            answers a scene, certifies it, draws build/demo.svg; then the same as Cortex-M3 firmware
#   make check           a quick look at a change: formatting, warnings, quick tests of every folder, the golden hash of this
#                        machine
#   make setup test      installs the cross tools (Debian, apt-get), then runs every test; GJK_TEST_SEED=N for other random ones
#   make lib TARGET=T    build/T/libgjk.a for host, cortex-m0, -m3, -m4, -m7, -m33, rv32imc or avr
#                        (-m4-fpu and -m7-fpu: the same with floating point, for programs that have some)
#   make demo-stack      lets a pile of crates, balls, capsules and drums fall and rest under the tests' solver: build/stack.svg
#   make demo-plane      two players run, jump and push things over a level of the plane, in two processes that exchange only
#                        keys; then one of them is firmware on an emulated Cortex-M3, then on a big-endian machine:
#                        build/plane.svg
#   make demo-platform   draws the platform game of tests/programs/examples on its ground of tiles: build/platform.svg
#   make demo-parts      a bracket, a torus and a rock in convex parts that enclose them, and a gripper's contacts: build/parts.svg
#   make demo-trace      draws what each iteration of GJK does on some pairs: build/trace.html
#   make page            the page to touch: build/page/index.html, one file with the library as WebAssembly, opens from disk
#   make amalgamation    the library as two files: build/amalgamation/gjk.h and gjk.c
#   make docs            the API reference by doxygen, HTML and man pages: build/docs/html/index.html, build/docs/man
#   make install PREFIX=/usr/local  headers, archive, shared library, pkg-config and CMake files, the C++ headers, the Python
#                        module; DESTDIR=D before all paths
#   make package         the library as CMake, Zephyr, ESP-IDF, Arduino and PlatformIO expect it: build/package
#   make sizes           code by function group and stack by query, per target
#   make bench           on the host, other libraries beside it: what queries cost by family, in instructions (valgrind), ns
#                        and branch mispredictions; then run time against error: tables, build/bench.html and .csv;
#                        BENCH_SECONDS=600 BENCH_PAIRS=5000 (60, 1000) for more; CC=clang for clang's
#   make bench-hull      hulls of points beside qhull and CGAL where installed: times, and answers on hard sets
#   make bench-parts     convex parts beside HACD where installed: number, time, excess, what is left out; MESHES='A.obj ...'
#   make bench-target    instructions, stack and code per query on the emulated cores, beside floating point
#   make readme-figures  counts them afresh and writes the tables of README.md and tests/measure/README.md
#   make worst-case      searches for the most expensive pairs and writes them to tests/data/worst.txt; SEED=1,
#                        MEASUREMENTS=2000000 for each family on the host, and a hundredth of that emulated
#   make matrix          the golden hash from every compiler, level and architecture (sh tests/build/setup.sh matrix
#                        installs the compilers that the tests do without)
#   make prove           shows the absence of undefined behaviour (Frama-C); CHANGED=1: where the code has changed
#   make prove-faults    puts faults into copies of the sources that the proof must notice
#   make prove-checker   proves exact arithmetic that the checkers stand on, over the integers (Frama-C, Why3, Z3, CVC4)
#   make prove-checker-faults   puts faults into copies of it that this proof must notice
#   make lint            clang-format, clang-tidy, cppcheck with MISRA C:2012, shellcheck
#   make coverage        which lines and branches of src the tests reach, over all variants of the code; FILES=. matches the
#                        files that count
#   make mutants         small wrong changes of src that the tests must notice: a random sample of MUTANTS=400 (0: all) by
#                        SEED=1, in files that match FILES=.; lists the survivors
#   make fuzz            fuzzes pairs, the reader of cases, arguments, bodies of many parts, hulls and masses, scenes,
#                        forged claims, casts, the plane, its ground, arms, gjk-convert and robots for SECONDS=60
#   make soak            certifies PAIRS=100000000 random pairs on two cores; goes on where it was interrupted
#                        (SOAK=test_plane_certificates: in the plane)
#   make soak-casts      the same for CASTS=1000000 random casts
#   make numbers         sine, cosine and roots of all 2^32 numbers: their errors are those stated (20 minutes on two cores)
#   make bench-scene     cost of a scene's tick: instructions on an emulated Cortex-M4, time here for 8 to 20,000 bodies, beside
#                        the broad phases of Bullet and FCL where installed; make bench draws it, too. Then scenes at rest
#                        and falling with all contacts, beside Bullet and ODE
#   make scene-soak      1,000,000 random operations on scenes under the sanitizers
#   make demo-lockstep   two processes play a match: they exchange only inputs. Then one of them is firmware on an emulated
#                        Cortex-M3, then on a big-endian machine. With DIVERGE=200 one goes wrong from that tick on, and
#                        what differs is named
#   make clean
#
# OPT=-Os builds for size, DEBUG=-g for a debugger, PORT=mps2 with the port in port/mps2, CC=clang with that compiler. Other
# flags build anew. VARIANT=-x builds in build/T-x, so that such builds are kept apart.

TARGET ?= host
OPT ?= -O2

# The targets: compiler and flags, archiver, and what a program for the target's emulated board is linked with.
# -fcallgraph-info is for `make sizes`.
TOOLS_host := $(CC)
AR_host := ar
PORT_host := hosted

ARM := arm-none-eabi-gcc -mthumb -fcallgraph-info=su
MPS2 := -nostdlib -Tport/mps2/mps2.ld port/mps2/board.c port/board/memory.c
TOOLS_cortex-m0 := $(ARM) -mcpu=cortex-m0
TOOLS_cortex-m3 := $(ARM) -mcpu=cortex-m3
TOOLS_cortex-m4 := $(ARM) -mcpu=cortex-m4
TOOLS_cortex-m7 := $(ARM) -mcpu=cortex-m7
TOOLS_cortex-m4-fpu := $(TOOLS_cortex-m4) -mfloat-abi=hard -mfpu=fpv4-sp-d16 -fno-math-errno -DBOARD_FPU=1
TOOLS_cortex-m7-fpu := $(TOOLS_cortex-m7) -mfloat-abi=hard -mfpu=fpv5-d16 -fno-math-errno -DBOARD_FPU=1
TOOLS_cortex-m33 := $(ARM) -mcpu=cortex-m33
BOARD_cortex-m0 := $(MPS2) -Wl,--defsym=ROM_SIZE=256K,--defsym=RAM_SIZE=16K
BOARD_cortex-m3 := $(MPS2)
BOARD_cortex-m4 := $(MPS2)
BOARD_cortex-m7 := $(MPS2)
BOARD_cortex-m4-fpu := $(MPS2)
BOARD_cortex-m7-fpu := $(MPS2)
BOARD_cortex-m33 := $(MPS2) -Wl,--defsym=ROM_START=0x10000000,--defsym=RAM_START=0x38000000
AR_cortex-m0 := arm-none-eabi-ar
AR_cortex-m3 := $(AR_cortex-m0)
AR_cortex-m4 := $(AR_cortex-m0)
AR_cortex-m7 := $(AR_cortex-m0)
AR_cortex-m4-fpu := $(AR_cortex-m0)
AR_cortex-m7-fpu := $(AR_cortex-m0)
AR_cortex-m33 := $(AR_cortex-m0)

TOOLS_rv32imc := riscv64-unknown-elf-gcc -march=rv32imc -mabi=ilp32 -fcallgraph-info=su
BOARD_rv32imc := -nostdlib -Tport/riscv-virt/riscv-virt.ld port/riscv-virt/board.c port/board/memory.c
AR_rv32imc := riscv64-unknown-elf-ar

# -mcall-prologues: registers are saved in one place, or the queries of the golden hash would not fit.
TOOLS_avr := avr-gcc -mmcu=atmega2560 -mcall-prologues
BOARD_avr := port/avr/board.c
AR_avr := avr-ar

ifeq ($(TOOLS_$(TARGET)),)
$(error TARGET=$(TARGET) is unknown: one of host, cortex-m0, cortex-m3, cortex-m4, cortex-m7, cortex-m33, rv32imc, avr, cortex-m4-fpu, cortex-m7-fpu)
endif

OUT := build/$(TARGET)$(VARIANT)
LIB := $(OUT)/libgjk.a
HOST_LIB := build/host/libgjk.a

WARNINGS := -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow -Werror
INCLUDES := -Iinclude -Iport
COMMON := -std=c99 $(DEBUG) $(WARNINGS) $(INCLUDES)
DEPENDENCIES := -MMD -MP
PORT ?= $(PORT_$(TARGET))
PORT_HEADER = $(if $(1),-DGJK_PORT_HEADER='"$(1)/gjk_port.h"')
FREESTANDING := $(TOOLS_$(TARGET)) $(call PORT_HEADER,$(PORT)) $(COMMON) $(OPT) \
  -ffreestanding -ffunction-sections -fdata-sections
HOSTED = $(TOOLS_host) $(call PORT_HEADER,$(PORT_host)) $(COMMON) $(HOSTED_OPT) -I. -Itests/support
HOSTED_OPT := -O2

.PHONY: bench-hull bench-parts all help lib setup check test unit-tests programs demo demo-stack demo-platform demo-parts demo-plane demo-trace page amalgamation install package sizes bench bench-target readme-figures worst-case matrix prove prove-faults prove-checker prove-checker-faults lint coverage soak soak-casts mutants fuzz bench-scene scene-soak demo-lockstep clean FORCE
all:
	+@$(PARALLEL) lib build/gjk-query build/gjk-convert build/gjk-demo build/hosted/port/hosted/gjk_hosted.o

# A file of flags holds the flags that the files depending on it were built with. It is written only if the flags change, so
# that make builds these files again just then.
FLAGS = @mkdir -p $(@D); flags='$(subst ','\'',$(1))'; \
  [ "$$flags" = "$$(cat $@ 2>/dev/null)" ] || printf '%s\n' "$$flags" >$@

# Folders and names of what is made are left to make itself: a process for each would take 5 ms, thousands of times.
MAKE_FOLDER = $(if $(wildcard $(@D)),,@mkdir -p $(@D))

help:
	@sed -n 's/^#   //p' Makefile

# The library.

lib: $(LIB)

# SOURCES: what the library is made of; part of it is enough for some tests. With ROOMS=1 the sources of a folder of src are
# compiled as one file, in less than half the time.
SOURCES ?= src/*/*.c
ROOMS ?=
IN_LIBRARY := $(wildcard $(SOURCES))
LIB_OBJECTS := $(patsubst %,$(OUT)/%.o,$(if $(ROOMS),$(addprefix gjk-,$(sort $(notdir $(patsubst %/,%,$(dir $(IN_LIBRARY)))))),$(notdir $(IN_LIBRARY:.c=))))
vpath gjk_%.c $(wildcard src/*)
vpath gjk2_%.c $(wildcard src/*)

$(LIB): $(LIB_OBJECTS)
	@rm -f $@ $(filter-out $^,$(wildcard $(OUT)/gjk*.o))
	$(info $()  $@)
	@$(AR_$(TARGET)) rcs $@ $^

$(OUT)/library.flags: FORCE
	@command -v $(firstword $(TOOLS_$(TARGET))) >/dev/null || \
	  { echo '$(firstword $(TOOLS_$(TARGET))) is not installed: `make setup` installs the cross tools' >&2; exit 1; }
	$(call FLAGS,$(FREESTANDING) $(AR_$(TARGET)) $(if $(ROOMS),$(IN_LIBRARY)))

$(filter $(OUT)/gjk-%,$(LIB_OBJECTS)): $(OUT)/gjk-%.o: $(IN_LIBRARY) $(OUT)/library.flags Makefile
	$(info $()  $(TARGET) src/$*)
	@printf '#include "%s"\n' $(filter src/$*/%,$(IN_LIBRARY)) | $(FREESTANDING) $(DEPENDENCIES) -MF $(@:.o=.d) -MT $@ -x c -c - -o $@

$(filter-out $(OUT)/gjk-%,$(LIB_OBJECTS)): $(OUT)/%.o: %.c $(OUT)/library.flags Makefile
	$(info $()  $(TARGET) $<)
	@$(FREESTANDING) $(DEPENDENCIES) -c $< -o $@

ifneq ($(LIB),$(HOST_LIB))
$(HOST_LIB): FORCE
	@$(MAKE) --no-print-directory lib TARGET=host VARIANT= PORT=$(PORT_host)
endif

# Programs for the host: the sources that tests and tools share (SUPPORT), and those of each program.

SUPPORT_SOURCES := $(wildcard tests/support/case/*.c tests/support/reference/*.c tests/support/exact/*.c tests/support/generate/*.c tests/support/scene/*.c tests/support/solver/*.c tests/support/arm/*.c) \
  port/hosted/gjk_hosted.c
SUPPORT := $(SUPPORT_SOURCES:%.c=build/hosted/%.o)
TEST_SCRIPTS := $(wildcard tests/check/unit/test_*.sh)
UNIT_TESTS := $(patsubst tests/check/unit/%.c,build/%,$(wildcard tests/check/unit/test_*.c))
SOURCES_gjk-query := $(wildcard tests/programs/query/*.c) $(addprefix tests/programs/demo/,draw.c geometry.c labels.c svg.c)
SOURCES_gjk-convert := $(wildcard tests/programs/convert/*.c)
SOURCES_gjk-demo := $(filter-out %firmware.c,$(wildcard tests/programs/demo/*.c))
SOURCES_gjk-demo-stack := $(wildcard tests/programs/demo_stack/*.c) $(addprefix tests/programs/demo/,draw.c geometry.c svg.c)
SOURCES_gjk-demo-parts := tests/programs/demo_parts/main.c $(filter-out %/main.c,$(SOURCES_gjk-convert))
SOURCES_gjk-demo-plane := $(filter-out %firmware.c,$(wildcard tests/programs/demo_plane/*.c))
SOURCES_lockstep := tests/programs/lockstep/main.c tests/programs/lockstep/peer.c
QUERY := $(SOURCES_gjk-query:%.c=build/hosted/%.o)
CONVERT := $(SOURCES_gjk-convert:%.c=build/hosted/%.o)
# What some unit test links beside the library.
LINKED_BY_TESTS := $(SUPPORT) $(filter-out %/main.o,$(CONVERT))

build/hosted/programs.flags: FORCE
	$(call FLAGS,$(HOSTED))

build/hosted/%.o: %.c build/hosted/programs.flags Makefile
	$(MAKE_FOLDER)
	$(info $()  $<)
	@$(HOSTED) $(DEPENDENCIES) -c $< -o $@

# What checks answers is not what takes the time.
build/hosted/tests/check/unit/%.o: private HOSTED_OPT := -O1
$(UNIT_TESTS): build/%: build/hosted/tests/check/unit/%.o
build/test_decompose build/test_decompose_outline build/test_enclose build/test_urdf: $(filter-out %/main.o,$(CONVERT))
# Their linker reads just what they need of an archive, in half the time.
build/hosted/libsupport.a: $(SUPPORT)
	@rm -f $@
	@$(AR_host) rcs $@ $^
$(UNIT_TESTS): build/hosted/port/hosted/gjk_hosted.o build/hosted/libsupport.a $(HOST_LIB)
	$(info $()  $@)
	@$(HOSTED) $(filter %.o,$^) build/hosted/libsupport.a $(HOST_LIB) -lm -o $@

# What a user runs compiles just what it links: needed.awk finds that in the sources, and build/hosted/needed holds it.
PROGRAMS := gjk-demo gjk-convert gjk-query gjk-demo-stack gjk-demo-parts lockstep gjk-demo-plane
OBJECTS_OF = $(patsubst %.c,build/host/%.o,$(notdir $(filter src/%,$(1)))) $(patsubst %.c,build/hosted/%.o,$(filter-out src/%,$(1)))
ifeq ($(TARGET),host)
-include build/hosted/needed
build/hosted/needed: $(wildcard src/* src/*/*.[ch] tests/support/* tests/support/*/*.[ch] tests/programs/*/*.[ch] include/*/*.h) tests/build/needed.awk Makefile
	$(MAKE_FOLDER)
	@awk -f tests/build/needed.awk $(foreach program,$(PROGRAMS),needed-$(program)= $(SOURCES_$(program))) \
	  -- src/*/*.c $(SUPPORT_SOURCES) include/*/*.h >$@.$$$$ && mv $@.$$$$ $@
$(foreach program,$(PROGRAMS),$(eval build/$(program): $(call OBJECTS_OF,$(needed-$(program)))))
endif
$(addprefix build/,$(PROGRAMS)):
	$(info $()  $@)
	@$(HOSTED) $(filter %.o,$^) -lm -o $@

# Its game is an example that it includes, which needed.awk does not see.
build/gjk-demo-platform: build/hosted/tests/programs/demo_platform/main.o build/hosted/port/hosted/gjk_hosted.o $(HOST_LIB)
	$(info $()  $@)
	@$(HOSTED) $(filter %.o,$^) $(HOST_LIB) -o $@

# The benchmark. BENCH_PEERS: other libraries to measure, out of ccd, bullet, fcl and ode.

BENCH_PEERS ?=
BENCH := $(patsubst %.c,build/hosted/%.o,$(wildcard tests/measure/bench/*.c)) \
  $(patsubst %,build/hosted/tests/measure/bench/peer/%.o,$(filter-out ode,$(BENCH_PEERS)))
COST := $(patsubst %.c,build/hosted/%.o,$(wildcard tests/measure/cost/*.c)) $(BENCH_PEERS:%=build/hosted/tests/measure/cost/peer/%.o)
PEER_FLAGS = $(shell pkg-config $(1) $(BENCH_PEERS))
PEER_COMPILE = $(CXX) -std=c++17 -O2 -Wall -Wextra $(patsubst -I%,-isystem%,$(filter -I%,$(call PEER_FLAGS,--cflags))) \
  $(DEPENDENCIES)

build/hosted/peers.flags build/hosted/cost-peers.flags: FORCE
	$(call FLAGS,$(CC) $(BENCH_PEERS) $(if $(BENCH_PEERS),$(PEER_COMPILE) $(call PEER_FLAGS,--libs)))

build/hosted/tests/measure/bench/peer/%.o: tests/measure/bench/peer/%.cpp build/hosted/peers.flags Makefile
	$(MAKE_FOLDER)
	$(info $()  $<)
	@$(PEER_COMPILE) -c $< -o $@

build/hosted/tests/measure/cost/peer/%.o: tests/measure/cost/peer/%.cpp build/hosted/cost-peers.flags Makefile
	$(MAKE_FOLDER)
	$(info $()  $<)
	@$(PEER_COMPILE) -c $< -o $@

build/gjk-bench: $(BENCH)
build/gjk-decisions: $(filter-out %/bench/main.o,$(BENCH)) build/hosted/tests/measure/decisions/main.o
build/gjk-cost: $(COST) build/hosted/cost-peers.flags
build/gjk-bench build/gjk-decisions: build/hosted/peers.flags
build/gjk-bench build/gjk-decisions build/gjk-cost: $(SUPPORT) $(HOST_LIB)
	$(info $()  $@)
	@$(if $(BENCH_PEERS),$(CXX),$(CC)) $(filter %.o,$^) $(HOST_LIB) $(if $(BENCH_PEERS),$(call PEER_FLAGS,--libs)) -lm -o $@

# The benchmark of scenes. Of the other libraries only bullet and fcl have a broad phase.
SCENE_PEERS := $(filter bullet fcl,$(BENCH_PEERS))
SCENE_BENCH := $(patsubst %.c,build/hosted/%.o,$(wildcard tests/measure/bench_scene/*.c)) \
  $(SCENE_PEERS:%=build/hosted/tests/measure/bench_scene/peer/%.o)

build/hosted/tests/measure/bench_scene/peer/%.o: tests/measure/bench_scene/peer/%.cpp build/hosted/peers.flags Makefile
	$(MAKE_FOLDER)
	$(info $()  $<)
	@$(PEER_COMPILE) -c $< -o $@

build/scene-bench: $(SCENE_BENCH) $(SUPPORT) $(HOST_LIB) build/hosted/peers.flags
	$(info $()  $@)
	@$(if $(SCENE_PEERS),$(CXX),$(CC)) $(filter-out %.flags,$^) $(if $(SCENE_PEERS),$(call PEER_FLAGS,--libs)) -lm -o $@

# Scenes at rest and falling. Of the other libraries bullet and ode find contacts in them.
REST_PEERS := $(filter bullet ode,$(BENCH_PEERS))
REST := $(patsubst %.c,build/hosted/%.o,$(wildcard tests/measure/bench_scene/rest/*.c)) \
  $(REST_PEERS:%=build/hosted/tests/measure/bench_scene/rest/peer/%.o)

build/hosted/tests/measure/bench_scene/rest/peer/%.o: tests/measure/bench_scene/rest/peer/%.cpp build/hosted/peers.flags Makefile
	$(MAKE_FOLDER)
	$(info $()  $<)
	@$(PEER_COMPILE) -Iinclude -c $< -o $@

build/gjk-rest: $(REST) $(HOST_LIB) build/hosted/peers.flags
	$(info $()  $@)
	@$(if $(REST_PEERS),$(CXX),$(CC)) $(filter %.o,$^) $(HOST_LIB) $(if $(REST_PEERS),$(call PEER_FLAGS,--libs)) -lm -o $@

# Casts whose answer is known. CAST_PEERS, out of BENCH_PEERS: bullet and fcl have casts.
CAST_PEERS := $(filter bullet fcl,$(BENCH_PEERS))
CAST_OBJECTS := $(patsubst %.c,build/hosted/%.o,$(filter-out %/main.c,$(wildcard tests/measure/cast/*.c))) \
  $(CAST_PEERS:%=build/hosted/tests/measure/cast/peer/%.o)

build/hosted/tests/measure/cast/peer/%.o: tests/measure/cast/peer/%.cpp build/hosted/peers.flags Makefile
	$(MAKE_FOLDER)
	$(info $()  $<)
	@$(PEER_COMPILE) -c $< -o $@

build/gjk-casts: tests/measure/cast/main.c $(CAST_OBJECTS) $(SUPPORT) $(HOST_LIB) build/hosted/peers.flags
	$(info $()  $@)
	@$(HOSTED) $(if $(filter bullet,$(CAST_PEERS)),-DCAST_BULLET) $(if $(filter fcl,$(CAST_PEERS)),-DCAST_FCL) -c $< \
	  -o build/hosted/tests/measure/cast/main.o
	@$(if $(CAST_PEERS),$(CXX),$(CC)) build/hosted/tests/measure/cast/main.o $(filter %.o,$^) $(HOST_LIB) \
	  $(if $(CAST_PEERS),$(call PEER_FLAGS,--libs)) -lm -o $@

# Edges of an arm. ARM_PEERS, out of BENCH_PEERS: bullet and fcl.
ARM_PEERS := $(filter bullet fcl,$(BENCH_PEERS))
ARM_PEER_OBJECTS := $(ARM_PEERS:%=build/hosted/tests/measure/arm/peer/%.o)

build/hosted/tests/measure/arm/peer/%.o: tests/measure/arm/peer/%.cpp build/hosted/peers.flags Makefile
	$(MAKE_FOLDER)
	$(info $()  $<)
	@$(PEER_COMPILE) -c $< -o $@

build/gjk-arms: tests/measure/arm/main.c $(ARM_PEER_OBJECTS) $(SUPPORT) $(HOST_LIB) build/hosted/peers.flags
	$(info $()  $@)
	@mkdir -p build/hosted/tests/measure/arm
	@$(HOSTED) $(if $(filter bullet,$(ARM_PEERS)),-DSWEEP_BULLET) $(if $(filter fcl,$(ARM_PEERS)),-DSWEEP_FCL) -c $< \
	  -o build/hosted/tests/measure/arm/main.o
	@$(if $(ARM_PEERS),$(CXX),$(CC)) build/hosted/tests/measure/arm/main.o $(filter %.o,$^) $(HOST_LIB) \
	  $(if $(ARM_PEERS),$(call PEER_FLAGS,--libs)) -lm -o $@

# Decisions and costs in the plane. PLANE_PEERS: other libraries to measure, out of box2d and chipmunk; -alone: none.
PLANE_PEERS ?=
PLANE := $(patsubst %.c,build/hosted/%.o,$(wildcard tests/measure/plane/*.c))
PLANE_PEER_OBJECTS := $(PLANE_PEERS:%=build/hosted/tests/measure/plane/peer/%.o)
PLANE_COMPILE = $(CXX) -std=c++17 -O2 -Wall -Wextra $(DEPENDENCIES)

build/hosted/plane-peers.flags: FORCE
	$(call FLAGS,$(CC) $(PLANE_PEERS) $(if $(PLANE_PEERS),$(PLANE_COMPILE)))

build/hosted/tests/measure/plane/peer/%.o: tests/measure/plane/peer/%.cpp build/hosted/plane-peers.flags Makefile
	$(MAKE_FOLDER)
	$(info $()  $<)
	@$(PLANE_COMPILE) -c $< -o $@

build/gjk-plane: $(PLANE) $(PLANE_PEER_OBJECTS) $(SUPPORT) $(HOST_LIB) build/hosted/plane-peers.flags
	$(info $()  $@)
	@$(if $(PLANE_PEERS),$(CXX),$(CC)) $(filter %.o,$^) $(HOST_LIB) $(PLANE_PEERS:%=-l%) -lm -o $@

build/gjk-plane-alone: $(PLANE) $(SUPPORT) $(HOST_LIB)
	$(info $()  $@)
	@$(CC) $(filter %.o,$^) $(HOST_LIB) -lm -o $@

# Firmware NAME for the target's emulated board is built of NAME.c, and NAME_firmware.c if there is one, of tests/check/target or
# tests/measure/target. -fno-tree-loop-distribute-patterns: memset and start-up code clear memory in loops, which the compiler
# must not turn into calls of memset.

BOARDS := $(wildcard port/board/* port/mps2/* port/riscv-virt/* port/avr/*)
FIRMWARE_NEEDS := $(LIB) $(BOARDS) $(wildcard tests/programs/examples/platform.c tests/support/*.h tests/*/target/*.h tests/programs/demo/*.h tests/programs/demo_plane/*.h tests/support/scene/*.h tests/support/arm/*.h tests/programs/lockstep/*.h include/gjk/*.h include/gjk2/*.h) Makefile
FIRMWARE = $(FREESTANDING) -I. -Itests/support -fno-tree-loop-distribute-patterns $(FIRMWARE_DEFINES) \
  $(filter-out $(FIRMWARE_NEEDS) %.flags,$^) $(BOARD_$(TARGET)) $(LIB) -lgcc -Wl,--gc-sections -o $@

$(OUT)/%.elf.flags: FORCE
	$(call FLAGS,$(FREESTANDING) $(FIRMWARE_DEFINES) $(BOARD_$(TARGET)) $(WORST_CASES))

$(OUT)/%.elf: tests/check/target/%.c tests/check/target/%_firmware.c $(OUT)/%.elf.flags $(FIRMWARE_NEEDS)
	$(info $()  $@)
	@$(FIRMWARE)

$(OUT)/%.elf: tests/measure/target/%.c tests/measure/target/%_firmware.c $(OUT)/%.elf.flags $(FIRMWARE_NEEDS)
	$(info $()  $@)
	@$(FIRMWARE)

$(OUT)/%.elf: tests/measure/target/%.c $(OUT)/%.elf.flags $(FIRMWARE_NEEDS)
	$(info $()  $@)
	@$(FIRMWARE)

$(OUT)/bench.elf: tests/measure/target/bench_gjk.c tests/measure/target/bench_float.c tests/measure/target/bench_double.c
$(OUT)/bench.elf: FIRMWARE_DEFINES += $(if $(filter cortex-m0,$(TARGET)),,-DBENCH_REFERENCE_DEPTH)
$(OUT)/bench.elf $(OUT)/plane_bench.elf $(OUT)/cast_bench.elf: BOARD_cortex-m0 += -Wl,--defsym=STACK_SIZE=4096
$(OUT)/hull_bench.elf: FIRMWARE_DEFINES += $(if $(filter cortex-m0,$(TARGET)),-DHULL_BENCH_POINTS=64)
$(OUT)/parts_bench.elf: FIRMWARE_DEFINES += $(if $(filter cortex-m0,$(TARGET)),-DPARTS_BENCH_PARTS=32)
$(OUT)/plane_bench.elf: tests/measure/target/plane_bench_chain.c
$(OUT)/worst.elf: $(WORST_CASES)
$(OUT)/scene_bench.elf: tests/support/scene/traffic.c
$(OUT)/arm_bench.elf: tests/support/arm/seven.c
# Its code for the Cortex-M0 is counted on the board of the Cortex-M3, which has the memory.
$(OUT)/arm_bench.elf: BOARD_cortex-m0 := $(MPS2)
# A slide over ground takes more stack than the board of RISC-V has for others.
$(OUT)/ground_golden.elf $(OUT)/ground_bench.elf: BOARD_rv32imc += -Wl,--defsym=STACK_SIZE=8192
$(OUT)/scene_golden.elf: tests/support/scene/match.c
$(OUT)/plane_scene_golden.elf: tests/support/scene/plane_match.c
$(OUT)/port.elf: tests/check/target/port_allocation.c port/generic/gjk_arena.c
$(OUT)/levels.elf: tests/check/target/plane_levels.c

$(OUT)/demo.elf: build/demo_scene.c tests/programs/demo/firmware.c tests/programs/demo/arm.c tests/programs/demo/demo_firmware.c $(OUT)/demo.elf.flags $(FIRMWARE_NEEDS)
	$(info $()  $@)
	@$(FIRMWARE) -Itests/programs/demo

$(OUT)/lockstep.elf: tests/programs/lockstep/firmware.c tests/programs/lockstep/peer.c tests/support/scene/match.c $(OUT)/lockstep.elf.flags $(FIRMWARE_NEEDS)
	$(info $()  $@)
	@$(FIRMWARE)

$(OUT)/demo_plane.elf: $(addprefix tests/programs/demo_plane/,firmware.c play.c level.c flat_solver.c) $(OUT)/demo_plane.elf.flags $(FIRMWARE_NEEDS)
	$(info $()  $@)
	@$(FIRMWARE)

# The other goals.

setup:
	@sh tests/build/setup.sh

unit-tests: $(UNIT_TESTS)

# What takes longest is begun first, and programs last, most of which take a second; scripts that want the same libraries are
# not begun together.
LONG_TESTS := $(patsubst %,tests/check/unit/test_%.sh,golden lint prove) build/test_plane_certificates \
  $(patsubst %,tests/check/unit/test_%.sh,ceilings symbols levels) build/test_penetration build/test_certificates \
  $(patsubst %,tests/check/unit/test_%.sh,amalgamation fuzz package scene_golden bench_cost port limit)
TESTS := $(LONG_TESTS) $(filter-out $(LONG_TESTS),$(TEST_SCRIPTS) $(UNIT_TESTS))

# Makes goals in parallel, also where this make is not.
JOBS ?= $(shell nproc 2>/dev/null || echo 2)
PARALLEL = $(MAKE) --no-print-directory $(if $(findstring -j,$(MAKEFLAGS)),,-j$(JOBS))

programs: lib build/gjk-query build/gjk-demo unit-tests build/scene-bench build/gjk-rest build/gjk-plane-alone build/lockstep build/gjk-convert build/gjk-demo-stack build/gjk-demo-platform build/gjk-demo-parts build/gjk-demo-plane

test: $(filter setup,$(MAKECMDGOALS))
	+@$(PARALLEL) programs
	@sh tests/build/run-tests.sh build $(TESTS)

# Quick tests of every folder of src.
QUICK_TESTS := $(addprefix build/test_,wide rotation quotient arm_cases bind contacts contacts_cases penetration_extremes simplex until \
  hull hull_forged mass mass_add height_field surface_brute cast impact_analytic impact_pose parts compound pose_status aabb joint \
  collider_pose draw plane_check plane_contacts plane_polygon plane_impact plane_motion_search plane_scene_words \
  plane_scene_setup plane_scene_query within_until status scene_status scene_setup scene_query scene_contacts concave_start scan \
  support)

check:
	+@$(PARALLEL) lib $(QUICK_TESTS)
	@sh tests/build/check.sh build $(QUICK_TESTS)

demo:
	+@$(PARALLEL) build/gjk-demo
	build/gjk-demo tests/data/arm.txt build/demo.svg
	@sh tests/build/demo-target.sh build tests/data/arm.txt

demo-stack:
	+@$(PARALLEL) build/gjk-demo-stack
	build/gjk-demo-stack build/stack.svg

demo-platform:
	+@$(PARALLEL) build/gjk-demo-platform
	build/gjk-demo-platform build/platform.svg

demo-parts:
	+@$(PARALLEL) build/gjk-demo-parts
	@mkdir -p build/meshes && cp tests/data/meshes/*.obj build/meshes && awk -f tests/data/meshes/torus.awk >build/meshes/torus.obj
	build/gjk-demo-parts build/meshes build/parts.svg

demo-plane:
	+@$(PARALLEL) build/gjk-demo-plane
	@sh tests/build/demo-plane.sh build 900
	@echo '  build/plane.svg'

demo-trace:
	+@$(PARALLEL) build/gjk-query
	@sh tests/build/demo-trace.sh build tests/data/trace.txt
	@echo '  build/trace.html'

page: build/page/index.html
	@echo '  build/page/index.html'

build/page/index.html: $(wildcard src/*/*.[ch] include/*/*.h port/wasm/* tests/programs/page/* tests/programs/page/libc/* \
    tests/measure/README.md tests/programs/query/*.[ch] tests/programs/demo_plane/flat_solver.[ch] tests/support/case/*.[ch] tests/support/reference/*.[ch]) tests/build/page.sh
	@sh tests/build/page.sh build

amalgamation:
	@sh tests/build/amalgamate.sh build/amalgamation
	@echo '  build/amalgamation/gjk.h build/amalgamation/gjk.c'

# Every input of the functions of one number, by two processes.
.PHONY: numbers
numbers: build/test_numbers
	@build/test_numbers 0 2 & half=$$!; build/test_numbers 1 2; odd=$$?; wait $$half && exit $$odd

.PHONY: docs
docs:
	@sh tests/build/docs.sh build
	@cat build/docs/warnings
	@echo '  build/docs/html/index.html build/docs/man'

PREFIX ?= /usr/local
install:
	@sh tests/build/install.sh build $(PREFIX)

package:
	@sh tests/build/package.sh build
	@echo '  build/package'

sizes:
	@sh tests/build/sizes.sh build

bench:
	@sh tests/build/bench.sh build $(BENCH_SECONDS) $(BENCH_PAIRS)

bench-hull:
	@sh tests/build/bench-hull.sh build

bench-parts: $(LINKED_BY_TESTS) $(HOST_LIB)
	@OBJECTS='$^' sh tests/build/bench-parts.sh build $(MESHES)

bench-target:
	@sh tests/build/bench-target.sh build

readme-figures:
	@sh tests/build/readme-figures.sh build

worst-case:
	@sh tests/build/worst-case.sh build $(SEED) $(MEASUREMENTS) $$(($(MEASUREMENTS) / 100))

matrix:
	@sh tests/build/matrix.sh build

prove:
	@sh tests/build/prove.sh build $(if $(CHANGED),--changed)

prove-faults:
	@sh tests/build/prove-faults.sh build

prove-checker:
	@sh tests/build/prove-checker.sh build

prove-checker-faults:
	@sh tests/build/prove-checker-faults.sh build

lint:
	@sh tests/build/lint.sh build

coverage: unit-tests
	@SUPPORT='$(LINKED_BY_TESTS)' FILES='$(FILES)' sh tests/build/coverage.sh build

MUTANTS ?= 400
SEED ?= 1
FILES ?= .
mutants: unit-tests
	@SUPPORT='$(LINKED_BY_TESTS)' FILES='$(FILES)' sh tests/build/mutants.sh build $(MUTANTS) $(SEED)

MEASUREMENTS ?= 2000000
SECONDS ?= 60
fuzz:
	@sh tests/build/fuzz.sh build $(SECONDS) 0

PAIRS ?= 100000000
SOAK ?= test_certificates
soak: build/$(SOAK)
	@sh tests/build/soak.sh build $(PAIRS) $(SOAK)

CASTS ?= 1000000
soak-casts: build/test_cast_certificates
	@sh tests/build/soak.sh build $(CASTS) test_cast_certificates

bench-scene:
	@sh tests/build/bench-scene.sh build

scene-soak:
	@sh tests/build/scene-soak.sh build 1000000

demo-lockstep:
	+@$(PARALLEL) build/lockstep
	@sh tests/build/demo-lockstep.sh build 600 $(DIVERGE)

clean:
	rm -rf build

# The value of a variable, for scripts.
print-%:
	@echo '$($*)'

.SECONDARY:
ifeq ($(filter print-%,$(MAKECMDGOALS)),)
-include $(wildcard $(OUT)/*.d)
ifeq ($(TARGET),host)
-include $(shell find build/hosted -name '*.d' 2>/dev/null)
endif
endif
