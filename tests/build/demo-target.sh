#!/bin/sh
# Runs the demo's scene as Cortex-M3 firmware, if a cross compiler and an emulator are installed: demo-target.sh BUILD
# SCENE
. tests/build/count.sh
missing="$(missing_package cortex-m3) $(missing_emulator cortex-m3)"
if [ -n "${missing# }" ]; then
  echo
  echo "The same scene on an emulated Cortex-M3 needs $missing: \`make setup\` installs it."
  exit 0
fi
"$1/gjk-demo" --c-source "$2" >"$1/demo_scene.c" || exit 1
sources=$(needed "$1/demo_scene.c" tests/programs/demo/firmware.c tests/programs/demo/arm.c tests/programs/demo/demo_firmware.c)
echo
echo 'The same scene as firmware for a Cortex-M3, emulated:'
unset MAKEFLAGS MFLAGS MAKELEVEL
make --no-print-directory -j2 "$1/cortex-m3-demo/demo.elf" TARGET=cortex-m3 VARIANT=-demo SOURCES="$sources" || exit 1
sh tests/build/emulate.sh cortex-m3 "$1/cortex-m3-demo/demo.elf"
