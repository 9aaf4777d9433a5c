#!/bin/sh
# Random operations on scenes under the sanitizers: scene-soak.sh BUILD OPERATIONS [SEED]
. tests/build/count.sh
build=$1
shift
mkdir -p "$build"
checked_library && gcc -std=c99 -O1 -g -fsanitize=undefined,address -fno-sanitize-recover=all -Iinclude -I. -Iport -Itests/support \
  build/checked/gjk*.o port/hosted/gjk_hosted.c tests/support/scene/world.c tests/support/scene/session.c \
  tests/check/soak_scene/main.c -o "$build/scene-soak" && "$build/scene-soak" "$@"
