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
"$1/gjk-demo" --c-source "$2" >"$1/demo_scene.c" &&
  library cortex-m3 '' OPT=-O2 &&
  make -s "$1/cortex-m3/demo.elf" TARGET=cortex-m3 >/dev/null || exit 1
echo
echo 'The same scene on an emulated Cortex-M3:'
sh tests/build/emulate.sh cortex-m3 "$1/cortex-m3/demo.elf"
