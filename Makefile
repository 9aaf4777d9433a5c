# Builds the library, its tools and its tests. `make help` lists the targets.
#
#   make demo            answers a scene, certifies it, draws build/demo.svg
#   make setup test      installs the cross tools (Debian, apt-get), then runs every test
#   make lib TARGET=...  build/TARGET/libgjk.a for host, cortex-m0, -m3, -m4, -m7, -m33, rv32imc or avr

TARGET ?= host
OPT ?= -O2

# One line per target: compiler, then flags. GJK_NARROW_MULTIPLY is for cores without a 32 x 32 -> 64 bit multiplication.
ARM := arm-none-eabi-gcc -mthumb
RISCV := riscv64-unknown-elf-gcc
TOOLS_host := $(CC) -DGJK_PORT_HEADER='"hosted/gjk_port.h"'
TOOLS_cortex-m0 := $(ARM) -mcpu=cortex-m0 -DGJK_NARROW_MULTIPLY=1
TOOLS_cortex-m3 := $(ARM) -mcpu=cortex-m3
TOOLS_cortex-m4 := $(ARM) -mcpu=cortex-m4
TOOLS_cortex-m7 := $(ARM) -mcpu=cortex-m7
TOOLS_cortex-m33 := $(ARM) -mcpu=cortex-m33
TOOLS_rv32imc := $(RISCV) -march=rv32imc -mabi=ilp32
TOOLS_avr := avr-gcc -mmcu=atmega2560 -DGJK_NARROW_MULTIPLY=1
AR_host := ar
AR_cortex-m0 := arm-none-eabi-ar
AR_cortex-m3 := $(AR_cortex-m0)
AR_cortex-m4 := $(AR_cortex-m0)
AR_cortex-m7 := $(AR_cortex-m0)
AR_cortex-m33 := $(AR_cortex-m0)
AR_rv32imc := riscv64-unknown-elf-ar
AR_avr := avr-ar
ifeq ($(TOOLS_$(TARGET)),)
$(error TARGET=$(TARGET) is unknown: one of host, cortex-m0, cortex-m3, cortex-m4, cortex-m7, cortex-m33, rv32imc, avr)
endif

WARNINGS := -Wall -Wextra -Wpedantic -Wconversion -Wsign-conversion -Wshadow -Werror
INCLUDES := -Iinclude -Isrc -Iport
FREESTANDING = $(TOOLS_$(TARGET)) -std=c99 -ffreestanding $(OPT) -ffunction-sections -fdata-sections -g $(WARNINGS) \
  $(INCLUDES) -MMD -MP
HOSTED := $(TOOLS_host) -std=c99 -O2 -g $(WARNINGS) $(INCLUDES) -Itests -MMD -MP

SOURCES := $(wildcard src/*.c)
# VARIANT keeps builds of one target with other flags apart.
LIB := build/$(TARGET)$(VARIANT)/libgjk.a
HOST_LIB := build/host/libgjk.a

# What the tests and tools share, and the programs made of it.
SUPPORT_SOURCES := $(wildcard tests/case/*.c tests/reference/*.c tests/exact/*.c tests/generate/*.c) \
  port/hosted/gjk_hosted.c
SUPPORT := $(SUPPORT_SOURCES:%.c=build/hosted/%.o)
UNIT_TESTS := $(patsubst tests/unit/%.c,build/%,$(wildcard tests/unit/test_*.c))
QUERY := $(patsubst %.c,build/hosted/%.o,$(wildcard tests/query/*.c))
DEMO := $(patsubst %.c,build/hosted/%.o,$(filter-out tests/demo/firmware%.c,$(wildcard tests/demo/*.c)))

.PHONY: all help lib setup test unit-tests demo sizes bench-target clean
all: lib build/gjk-query build/gjk-demo

help:
	@sed -n 's/^#   //p' Makefile
	@echo 'make                 the host library and build/gjk-query'
	@echo 'make sizes           text and stack by function group, per target'
	@echo 'make bench-target    instructions per query on the emulated cores'
	@echo 'make clean'

lib: $(LIB)

$(LIB): $(SOURCES:src/%.c=build/$(TARGET)$(VARIANT)/%.o)
	@rm -f $@
	@echo '  $@'
	@$(AR_$(TARGET)) rcs $@ $^

build/$(TARGET)$(VARIANT)/%.o: src/%.c
	@mkdir -p $(@D)
	@echo '  $(TARGET) $<'
	@$(FREESTANDING) -c $< -o $@

# The host library, when another target is being built.
ifneq ($(TARGET),host)
$(HOST_LIB):
	$(MAKE) lib TARGET=host
endif

# Firmware NAME for an emulated board: tests/target/NAME.c and NAME_firmware.c with the board's start-up.
MPS2 := -nostdlib -Wl,--gc-sections -Tport/mps2/mps2.ld port/mps2/board.c port/mps2/memory.c
BOARD_cortex-m0 := $(MPS2)
BOARD_cortex-m3 := $(MPS2)
BOARD_cortex-m4 := $(MPS2)
BOARD_cortex-m7 := $(MPS2)
BOARD_cortex-m33 := $(MPS2) -Wl,--defsym=ROM_START=0x10000000,--defsym=RAM_START=0x38000000
BOARD_rv32imc := -nostdlib -Wl,--gc-sections -Tport/riscv-virt/riscv-virt.ld port/riscv-virt/board.c port/mps2/memory.c
BOARD_avr := -Wl,--gc-sections port/avr/board.c
FIRMWARE_FLAGS := $(filter-out -Wpedantic,$(WARNINGS))

build/$(TARGET)/%.elf: tests/target/%.c tests/target/%_firmware.c $(LIB)
	@echo '  $@'
	@$(TOOLS_$(TARGET)) -std=c99 -ffreestanding -fno-tree-loop-distribute-patterns $(OPT) -g $(FIRMWARE_FLAGS) \
	  $(INCLUDES) -ffunction-sections $(FIRMWARE_DEFINES) $(filter %.c,$^) $(BOARD_$(TARGET)) $(LIB) -lgcc -o $@

build/hosted/%.o: %.c
	@mkdir -p $(@D)
	@echo '  $<'
	@$(HOSTED) -c $< -o $@

build/gjk-query: $(QUERY) $(SUPPORT) $(HOST_LIB)
	@echo '  $@'
	@$(HOSTED) $^ -lm -o $@

build/gjk-demo: $(DEMO) $(SUPPORT) $(HOST_LIB)
	@echo '  $@'
	@$(HOSTED) $^ -lm -o $@

build/test_%: build/hosted/tests/unit/test_%.o $(SUPPORT) $(HOST_LIB)
	@echo '  $@'
	@$(HOSTED) $^ -lm -o $@

unit-tests: $(UNIT_TESTS)

test: all unit-tests
	@sh tests/build/run-tests.sh build

setup:
	@sh tests/build/setup.sh

demo: build/gjk-demo
	build/gjk-demo tests/data/arm.txt build/demo.svg
	@sh tests/build/demo-target.sh build

sizes:
	@sh tests/build/sizes.sh build

bench-target:
	@sh tests/build/bench-target.sh build

clean:
	rm -rf build

.SECONDARY:
-include $(shell find build -name '*.d' 2>/dev/null)
