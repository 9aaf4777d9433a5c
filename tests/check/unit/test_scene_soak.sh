#!/bin/sh
# A short part of what `make scene-soak` runs. test_scene_soak.sh BUILD
. tests/build/count.sh
if have gcc; then
  check 'random operations under the sanitizers' sh tests/build/scene-soak.sh "$1" 20000
else
  skip 'random operations under the sanitizers' gcc
fi
finish scene_soak
