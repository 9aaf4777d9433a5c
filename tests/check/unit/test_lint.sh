#!/bin/sh
# Static checks of the sources and scripts, `make lint` with a hundredth of the analyser's steps. test_lint.sh BUILD
exec sh tests/build/lint.sh "$1" 2000
