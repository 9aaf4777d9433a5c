#!/bin/sh
# Random operations on scenes under the sanitizers: scene-soak.sh BUILD OPERATIONS [SEED]
build=$1
shift
mkdir -p "$build"
sources=$(echo src/*/*.c | tr ' ' '\n' | grep -v /gjk2_)  # what it links
# shellcheck disable=SC2086
gcc -std=c99 -O1 -g -fsanitize=undefined,address -fno-sanitize-recover=all -Iinclude -I. -Iport -Itests/support \
  '-DGJK_PORT_HEADER="hosted/gjk_port.h"' $sources port/hosted/gjk_hosted.c tests/support/scene/world.c tests/support/scene/session.c \
  tests/check/soak_scene/main.c -o "$build/scene-soak" && "$build/scene-soak" "$@"
