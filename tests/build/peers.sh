# Finds other libraries to measure, and counts by callgrind. Source it after count.sh.
peers=

# find_peer PKG-CONFIG-NAME NAME DEBIAN-PACKAGE: adds one to $peers, or says what it needs.
find_peer() {
  if have g++ && have pkg-config && pkg-config --exists "$1"; then
    peers="$peers${peers:+ }$1"
  else
    skip "bench of $2" "g++ pkg-config $3"
  fi
}

# Those that costs are compared with; WITHOUT_PEERS=1: none.
find_cost_peers() {
  if [ -z "$WITHOUT_PEERS" ]; then
    find_peer ccd libccd libccd-dev
    find_peer bullet Bullet libbullet-dev
    find_peer fcl FCL libfcl-dev
    find_peer ode ODE libode-dev
  fi
}

# Those of the plane, in $plane_peers; WITHOUT_PEERS=1: none. Chipmunk2D has no file for pkg-config.
plane_peers=
find_plane_peers() {
  [ -z "$WITHOUT_PEERS" ] || return 0
  for peer in 'box2d Box2D libbox2d-dev box2d/box2d.h' 'chipmunk Chipmunk2D libchipmunk-dev chipmunk/chipmunk.h'; do
    # shellcheck disable=SC2086
    set -- $peer
    if have g++ && echo "#include <$4>" | g++ -E -x c++ - >/dev/null 2>&1; then
      plane_peers="$plane_peers${plane_peers:+ }$1"
    else
      skip "bench of $2" "g++ $3"
    fi
  done
}

# counted PAIRS FOLDER OPTION PROGRAM ARGUMENT...: what callgrind counts of a program that names its dumps, as callgrind.awk says
# it, in FOLDER. OPTION: --branch-sim=yes or no. Callgrind cannot read the debug information of every compiler.
counted() {
  counted_pairs=$1 counted_at=$2/callgrind counted_option=$3 counted_program=$4
  shift 4
  rm -rf "$counted_at"
  mkdir -p "$counted_at"
  strip -g -o "$counted_at/program" "$counted_program" || return 1
  valgrind --tool=callgrind "$counted_option" --instr-atstart=no --callgrind-out-file="$counted_at/dump" "$counted_at/program" "$@" \
    2>"$counted_at/log" || { cat "$counted_at/log" >&2; return 1; }
  find "$counted_at" -name 'dump.*' -exec awk -v pairs="$counted_pairs" -f tests/build/callgrind.awk {} +
  rm -rf "$counted_at"
}
