#!/bin/sh
# The quick part of `make prove-checker`: products, digits, vectors. test_prove_checker.sh BUILD
sh tests/build/prove-checker.sh "$1/quick-checker" quick
