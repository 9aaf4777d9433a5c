#!/bin/sh
# Prints NAME SIZE of each public structure and NAME.FIELD OFFSET of each field, as a compiler lays them out: it need not run
# what it compiles. layout.sh FOLDER API COMPILER FLAGS...   API: what port/bind/api.sh has printed
folder=$1
api=$2
shift 2
mkdir -p "$folder"
awk -v as=names -f tests/check/bind/layout.awk "$api" >"$folder/names"
awk -v as=c -f tests/check/bind/layout.awk "$api" >"$folder/layout.c"
"$@" -S "$folder/layout.c" -o "$folder/layout.s" || exit 1
# The table is the only data: a number a line, or so many zero bytes.
awk '$1 ~ /^\.(word|long|int32|4byte)$/ { print $2 }
  $1 ~ /^\.(zero|space|skip)$/ { for (i = 0; i < $2; i += 4) print 0 }' "$folder/layout.s" >"$folder/numbers"
[ "$(wc -l <"$folder/names")" = "$(wc -l <"$folder/numbers")" ] && paste -d ' ' "$folder/names" "$folder/numbers"
