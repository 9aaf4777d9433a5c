# Finds other libraries to measure. Source it after count.sh.
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
