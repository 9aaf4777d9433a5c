#!/bin/sh
# The query tool on machines: answers, certificates, and a line number for whatever is not understood. test_query_arm.sh BUILD
build=$1
tool=$build/gjk-query
data=tests/data/arm_edges.txt
dir=$build/query-arm-test
. tests/build/count.sh
rm -rf "$dir"
mkdir -p "$dir"

check 'edges' status 0 "$tool" --arm --certify $data
check 'answers known' diff tests/data/arm_edges.expected "$dir/out"
check 'all certified' grep -q '^certify: 10 certified, 0 uncertified, 0 wrong$' "$dir/err"
check 'without certificates the same' is "$(cat tests/data/arm_edges.expected)" "$("$tool" --arm $data)"
check 'from standard input' is "$(cat tests/data/arm_edges.expected)" "$("$tool" --arm - <$data)"
sed 's/$/\r/' $data >"$dir/crlf.txt"
check 'with CRLF' is "$(cat tests/data/arm_edges.expected)" "$("$tool" --arm "$dir/crlf.txt")"

# refused LINE TEXT: a file of the machine's first links, then TEXT, is refused at LINE
refused() {
  { printf 'link a base revolute\nL axis 0.0 0.0 1.0\npart a\nP box 1.0 1.0 1.0\nobstacle o\nO point\n'; printf '%b' "$2"; } >"$dir/bad.txt"
  status 2 "$tool" --arm "$dir/bad.txt" && grep -q "^$dir/bad.txt:$1: expected" "$dir/err"
}

check 'a word' refused 7 'lynk b a fixed\n'
check 'a parent that is not there' refused 7 'link b c fixed\n'
check 'a link that is its own parent' refused 7 'link b b fixed\n'
check 'a kind' refused 7 'link b a ball\n'
check 'no kind' refused 7 'link b a\n'
check 'no name' refused 7 'link\n'
check 'a link line' refused 8 'link b a fixed\nL shift 1.0\n'
check 'an empty link line' refused 8 'link b a fixed\nL\n'
check 'too few numbers' refused 8 'link b a fixed\nL at 1.0 2.0\n'
check 'a number' refused 8 'link b a fixed\nL at 1.0 2.0 three\n'
check 'too many words' refused 7 'never a a a\n'
check 'a link never heard of' refused 7 'never a z\n'
check 'a part of nothing' refused 7 'part z\n'
check 'a part without a shape' refused 8 'part a\nP at 0.0 0.0 0.0\n'
check 'a shape' refused 8 'part a\nP cube 1.0\n'
check 'two shapes' refused 9 'part a\nP point\nP point\n'
check 'a line of another block' refused 7 'P point\nL at 0.0 0.0 0.0\n'
check 'a base line' refused 8 'base\nB axis 0.0 0.0 1.0\n'
check 'an edge without an end' refused 8 'edge e\nE from 0.0\n'
check 'an edge with too many values' refused 8 'edge e\nE from 0.0 0.0\n'
check 'an edge line' refused 8 'edge e\nE via 0.0\n'
check 'too many links' refused 38 "$(for i in $(seq 32); do printf 'link l%s a fixed\\n' "$i"; done)"

printf 'link a base revolute\nL axis 0.0 0.0 0.0\nedge e\nE from 0.0\nE to 1.0\n' >"$dir/axis.txt"
check 'what the library refuses is said' is 'e error GJK_ERROR_ROTATION' "$("$tool" --arm "$dir/axis.txt")"
printf 'link a base revolute\nedge e\nE from 0.0\nE to 1.0\nE tolerance 1\n' >"$dir/tolerance.txt"
check 'a tolerance too small' is 'e error GJK_ERROR_RANGE' "$("$tool" --arm "$dir/tolerance.txt")"
printf 'link a base revolute\nedge e\nE from 0.0\nE to 1.0\n' >"$dir/alone.txt"
check 'a machine that nothing can touch' is 'e free gap=134217728 tests=0' "$("$tool" --arm "$dir/alone.txt")"

finish query_arm
