#!/bin/sh
# Static checks of the sources and scripts. test_lint.sh BUILD
exec sh tests/build/lint.sh "$1"
