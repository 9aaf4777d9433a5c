# Copies of the sources with faults in them, which a proof must notice. Source it.

# copy_sources FOLDER: what the proofs read
copy_sources() {
  rm -rf "$1"
  mkdir -p "$1/tests"
  cp -r src include "$1"
  cp -r tests/build tests/prove "$1/tests"
}

# replace_once FILE OLD NEW: replaces literal text. Fails, and leaves the file, where OLD does not occur once.
replace_once() {
  OLD=$2 NEW=$3 awk '
    { text = text $0 "\n" }
    END {
      old = ENVIRON["OLD"]
      at = index(text, old)
      if (at == 0 || index(substr(text, at + 1), old) != 0) exit 1
      printf "%s%s%s", substr(text, 1, at - 1), ENVIRON["NEW"], substr(text, at + length(old))
    }' "$1" >"$1.changed" && mv "$1.changed" "$1"
}
