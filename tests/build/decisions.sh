#!/bin/sh
# Wrong decisions by family of pairs, this library beside floating point: decisions.sh BUILD [PAIRS]
#
# Prints a table. Its columns are the library, the reference in double, and libccd, FCL and Bullet if their Debian
# packages are installed. Of the two detectors of Bullet the better one is shown. PAIRS: pairs of each family, 20000.
. tests/build/count.sh
. tests/build/peers.sh
build=$1
pairs=${2:-20000}
mkdir -p "$build/bench"
if [ -z "$WITHOUT_PEERS" ]; then
  find_peer ccd libccd libccd-dev >&2
  find_peer fcl FCL libfcl-dev >&2
  find_peer bullet Bullet libbullet-dev >&2
fi
make -s build/gjk-decisions BENCH_PEERS="$peers" >"$build/bench/decisions.log" 2>&1 ||
  { cat "$build/bench/decisions.log" >&2; exit 1; }
build/gjk-decisions "$pairs" | awk -F, -v head=pairs \
  -v methods='gjk cold=gjk;reference double=GJK in `double`, tolerance 1e-30;libccd GJK=libccd;FCL indep=FCL;Bullet=Bullet' \
  -v families='near=boxes and hulls of about a unit, 1,000 LSB deep to 1,000 LSB apart;touching=boxes and hulls of all sizes within 3 LSB of touching;stacked=boxes and hulls face to face, within 2 LSB of touching;slivers=10,000 times longer than thick, within 3 LSB of touching;smallest=hulls of up to 4,000 units whose deciding determinant is -1, 0 or 1' \
  -f tests/build/decisions.awk
