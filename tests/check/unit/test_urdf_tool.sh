#!/bin/sh
# gjk-convert on robots: a machine as a case that gjk-query answers and certifies, as C with the same answers, a line for what is
# not understood, and mutations under the sanitizers. test_urdf_tool.sh BUILD
. tests/build/count.sh
build=$1
convert=$build/gjk-convert
query=$build/gjk-query
data=tests/data/robot
dir=$build/urdf-test
rm -rf "$dir"
mkdir -p "$dir"

# certified OPTION...: the edges are answered of the machine that these options give, and all answers are certified
certified() {
  "$convert" --urdf --case "$@" $data/six.urdf >"$dir/case.txt" && cat $data/edges.txt >>"$dir/case.txt" &&
    "$query" --arm --certify "$dir/case.txt" >"$dir/answers" 2>"$dir/err" && grep -q '^certify: 7 certified, 0 uncertified, 0 wrong$' "$dir/err"
}

info() {
  is "$1" "$("$convert" --urdf --info $2 "$3")"
}

check 'a case with SRDF' certified --srdf $data/six.srdf
check 'its answers' diff $data/edges.expected "$dir/answers"
check 'it says where pairs come from' grep -q '^# Never tested, besides links with a joint between them: what the robot.s SRDF disables\.$' "$dir/case.txt"
check 'it says what mimics' grep -q '^# Value 7: joint right, prismatic, of link right_finger; it mimics another one, and is free here$' "$dir/case.txt"
cp "$dir/case.txt" "$dir/srdf.txt"
check 'a case without SRDF' certified
check 'it says that samples are no proof' grep -q '^# Without SRDF, by 2000 samples and not proven: links that touched in each of them are never tested, nor are$' "$dir/case.txt"
check 'and which pairs no sample touched' grep -qx '#   upper wrist' "$dir/case.txt"
check 'links beside one without shapes are neighbours' is 'never wrist hand' "$(grep '^never' "$dir/case.txt")"
check 'convex parts' certified --decompose --srdf $data/six.srdf
check 'simpler hulls' certified --vertices 8
check 'another scale' certified --scale 4
check 'a line' info 'links=10 values=8 parts=9 vertices=44 never=5' "--srdf $data/six.srdf" $data/six.urdf
check 'of parts' info 'links=10 values=8 parts=13 vertices=74 never=1' --decompose $data/six.urdf
check 'of fewer vertices' info 'links=10 values=8 parts=9 vertices=32 never=1' '--vertices 8' $data/six.urdf
check 'the same each time' is "$("$convert" --urdf $data/six.urdf 2>/dev/null)" "$("$convert" --urdf $data/six.urdf 2>/dev/null)"

# A column of two turning boxes that overlap whatever they do: by samples, they are never tested.
cat >"$dir/always.urdf" <<END
<robot><link name="a"><collision><geometry><box size="1 1 1"/></geometry></collision></link>
<link name="b"><collision><origin xyz="9 0 0"/><geometry><sphere radius="0.1"/></geometry></collision></link>
<link name="c"><collision><geometry><box size="1 1 1"/></geometry></collision></link>
<joint name="ab" type="continuous"><parent link="a"/><child link="b"/><axis xyz="0 0 1"/></joint>
<joint name="bc" type="continuous"><parent link="b"/><child link="c"/><axis xyz="0 0 1"/></joint></robot>
END
check 'what always touches' is 'never a c' "$("$convert" --urdf --case "$dir/always.urdf" 2>/dev/null | grep '^never')"

# Names that a case cannot hold, and a limit beyond int32, which is none.
sed 's/"a"/"a b"/g; s/"b"/"a_b"/g; s/"c"/"base"/g; s/"continuous"/"revolute"/; s/<\/joint>/<limit lower="-1e9" upper="1"\/>&/' \
  "$dir/always.urdf" >"$dir/names.urdf"
check 'names are made words, and kept apart' is 'link a_b base fixed link a_b_ a_b revolute link base_ a_b_ revolute' \
  "$("$convert" --urdf --case "$dir/names.urdf" 2>/dev/null | grep '^link' | tr '\n' ' ' | sed 's/ $//')"
check 'a limit beyond int32' is 'L limits -2147483648 65536' "$("$convert" --urdf --case "$dir/names.urdf" 2>/dev/null | grep limits | sort -u)"

# The C answers as the case does, and is in flash.
cat >"$dir/main.c" <<END
#include <stdio.h>
int main(void) {
  static const int32_t from[] = {0, 0, 131072, 0, 0, 0, 1311, 1311}, to[] = {0, 0, 196608, 0, 98304, 0, 1311, 1311};
  static const gjk_pose base = GJK_POSE_IDENTITY;
  static const gjk_arm_setup setup = {0, GJK_ARM_TOLERANCE_MIN, 0};
  static gjk_arm_link_room links[10];
  static gjk_arm_part_room parts[9];
  static gjk_arm_pair pairs[GJK_ARM_PAIRS(9, 0)];
  static const gjk_arm_memory memory = {links, parts, pairs, GJK_ARM_PAIRS(9, 0)};
  static gjk_arm arm;
  gjk_arm_edge_result out;
  if (gjk_arm_init(&arm, &robot, &base, &memory) != GJK_OK ||
      gjk_arm_edge_start(&arm, from, to, &setup, NULL, NULL) != GJK_OK ||
      gjk_arm_edge_run(&arm, UINT32_MAX, &out) != GJK_OK || out.answer != GJK_ARM_TOUCH) {
    return 1;
  }
  printf("fold touch lower=%ld upper=%ld a=%u b=%u\\n", (long)out.lower, (long)out.upper, out.pair.part, out.pair.other);
  return 0;
}
END
as_c() {
  "$convert" --urdf --name robot --srdf $data/six.srdf $data/six.urdf >"$dir/robot.c" &&
    cat "$dir/robot.c" "$dir/main.c" >"$dir/program.c" &&
    "${CC:-cc}" -std=c99 -Wall -Wextra -Wpedantic -Werror -Iinclude "$dir/program.c" "$build/host/libgjk.a" \
      "$build/hosted/port/hosted/gjk_hosted.o" -o "$dir/program" && "$dir/program" >"$dir/printed"
}
by_query() {
  sed '/^# Around/,$d' "$dir/srdf.txt" >"$dir/fold.txt"
  printf 'edge fold\nE from 0 0 131072 0 0 0 1311 1311\nE to 0 0 196608 0 98304 0 1311 1311\n' >>"$dir/fold.txt"
  "$query" --arm "$dir/fold.txt" | sed 's/a=left_finger b=column.*/a=7 b=1/'
}
check 'its C compiles and runs' as_c
check 'and answers as the case' is "$(by_query)" "$(cat "$dir/printed")"
if have arm-none-eabi-gcc; then
  check 'its C for Cortex-M3' arm-none-eabi-gcc -std=c99 -mcpu=cortex-m3 -mthumb -Wall -Wextra -Werror -Iinclude \
    -c "$dir/robot.c" -o "$dir/robot.o"
  check 'which is in flash' is 0 "$(arm-none-eabi-size -A "$dir/robot.o" | awk '$1 ~ /^\.(data|bss)/ { n += $2 } END { print n + 0 }')"
else
  skip 'constants on Cortex-M3' gcc-arm-none-eabi
fi

# How XML may be written: the same machine.
cp -r $data/meshes "$dir"
mkdir -p "$dir/robot"
cp -r $data/meshes "$dir/robot"
printf '\357\273\277' >"$dir/marked.urdf"
sed 's/<link name="wrist">/<![CDATA[<link>]]><link name = '"'"'wri\&#115;\&#x74;'"'"' >/; s/$/\r/' $data/six.urdf | sed 1d >>"$dir/marked.urdf"
check 'CDATA, references, CRLF, a byte order mark' is "$("$convert" --urdf --case $data/six.urdf 2>/dev/null)" \
  "$("$convert" --urdf --case "$dir/marked.urdf" 2>/dev/null)"

# What is not understood is refused with its line, and nothing is written.
# refused LINE MESSAGE CHANGES: of six.urdf after sed's changes
refused() {
  sed "$3" $data/six.urdf >"$dir/bad.urdf"
  status 2 "$convert" --urdf "$dir/bad.urdf" && is '' "$(cat "$dir/out")" && is "$dir/bad.urdf:$1: $2" "$(cat "$dir/err")"
}
check 'an unclosed tag' refused 9 "'link' ends where 'collision' of line 6 is open" '9d'
check 'a file that ends' refused 3 "'robot' does not end" '$d'
check 'a tag that does not end' refused 91 "the end of 'robot' does not end" '$s/>//'
check 'a comment that does not end' refused 2 'a comment does not end' '2s/-->//'
check 'a second element' refused 92 "a second element beside the document's" '$s/$/\n<robot\/>/'
check 'text behind' refused 91 "text outside of the document's element" '$s/$/ x/'
check 'DOCTYPE' refused 2 'a declaration that is not understood' '2s/.*/<!DOCTYPE robot>/'
check 'no robot' refused 3 "the document's element is not 'robot'" 's/robot/bot/'
check 'an unknown reference' refused 11 "a reference or byte in 'name' that is not understood" '11s/column/\&nbsp;/'
check 'a value that is not quoted' refused 11 "the value of 'name' is not quoted" '11s/"//g'
check 'an attribute twice' refused 11 "attribute 'name' is there twice" '11s/>/ name="x">/'
check 'a bad number' refused 7 "attribute 'xyz' is not 3 numbers: '0 0 x'" '7s/0.05/x/'
check 'a number that is none' refused 7 "attribute 'xyz' is not 3 numbers: '0 0 nan'" '7s/0.05/nan/'
check 'an infinite number' refused 7 "attribute 'xyz' is not 3 numbers: '0 0 1e999'" '7s/0.05/1e999/'
check 'too many numbers' refused 7 "attribute 'xyz' is not 3 numbers: '0 0 0.05 1'" '7s/0.05/0.05 1/'
check 'a missing size' refused 8 "attribute 'size' is missing" '8s/size=[^/]*//'
check 'a negative size' refused 8 "a shape's size is negative" '8s/0.3 /-0.3 /'
check 'another shape' refused 8 'a shape that is neither box, sphere, cylinder nor mesh' '8s/box/cone/'
check 'two shapes' refused 8 'a second shape in one geometry' '8s/<box/<sphere radius="1"\/>&/'
check 'no shape' refused 8 'a geometry without a shape' '8s/<box.*\/>//;8s/$/<\/geometry>/;8s/<.geometry><.geometry>/<\/geometry>/'
check 'a missing mesh' refused 19 "mesh 'package://robot/meshes/upper.stl' cannot be read" '19s/obj/stl/'
check 'another kind of mesh' refused 19 "mesh 'bad.urdf': unknown kind of file: .obj, .stl, .ply, .off and .txt are known" \
  '19s/package.*obj/bad.urdf/'
check 'a link twice' refused 11 "link 'base' is there twice" '11s/column/base/'
check 'an unknown link' refused 47 "joint 'turn' is of link 'bose', which is not there" '48s/base/bose/'
check 'a joint twice' refused 51 "joint 'turn' is there twice" '51s/shoulder/turn/'
check 'another type' refused 47 "joint 'turn' is of type 'floating': revolute, continuous, prismatic and fixed are known" \
  '47s/continuous/floating/'
check 'an axis of length 0' refused 47 "joint 'turn' has an axis of length 0" '49s/axis xyz="0 0 1"/axis xyz="0 0 0"/'
check 'no limit' refused 51 "joint 'shoulder' has no limit" '54d'
check 'limits turned over' refused 51 "joint 'shoulder' has a lower limit above the upper one" '54s/-1.9/2/'
check 'joints in a circle' refused 51 "joint 'shoulder' is one of joints in a circle" '52s/column/fore/'
check 'two joints of a link' refused 51 "link 'column' hangs on joint 'turn' and on 'shoulder'" '52s/upper/column/'
check 'two roots' refused 45 "link 'tip' hangs on no joint, as 'base'" '87,90d'
check 'too far away' refused 1 'the machine reaches farther than 2048 units: GJK_ERROR_RANGE; see --scale' '53s/0.3/3000/'
check 'a shape too wide' refused 6 "a shape of link 'base' is wider than 4095 units, or too far away" '8s/0.3 /30000 /'

# chain LINKS SHAPE: a robot of so many links, each with this
chain() {
  echo '<robot>'
  for i in $(seq 1 "$1"); do
    echo "<link name='l$i'>$2</link>"
    [ "$i" = 1 ] || echo "<joint name='j$i' type='fixed'><parent link='l$((i / 2))'/><child link='l$i'/></joint>"
  done
  echo '</robot>'
}
chain 40 '<collision><geometry><sphere radius="1"/></geometry></collision>' >"$dir/chain.urdf"
check 'too many links' status 2 "$convert" --urdf "$dir/chain.urdf"
check 'are told' is "$dir/chain.urdf:65: too many links: 40, and a machine has at most 32" "$(cat "$dir/err")"
chain 40 '' >"$dir/frames.urdf"
check 'of too many, those that carry nothing are left out' info 'links=32 values=0 parts=0 vertices=0 never=0' '' "$dir/frames.urdf"
chain 300 '' >"$dir/chain.urdf"
check 'far too many links' status 2 "$convert" --urdf "$dir/chain.urdf"

refused_pairs() {
  sed "$3" $data/six.srdf >"$dir/bad.srdf"
  status 2 "$convert" --urdf --srdf "$dir/bad.srdf" $data/six.urdf && is '' "$(cat "$dir/out")" &&
    is "$dir/bad.srdf:$1: $2" "$(cat "$dir/err")"
}
check 'an unknown link in SRDF' refused_pairs 4 "link 'bose' is not of the robot" '4s/base/bose/'
check 'no second link' refused_pairs 4 "a name is missing: attribute 'link2'" '4s/link2/link3/'
check 'SRDF that is none' refused_pairs 2 "the document's element is not 'robot'" 's/robot/bot/'
check 'an SRDF that is not there' status 2 "$convert" --urdf --srdf "$dir/none.srdf" $data/six.urdf
for options in '--srdf a' '--scale 2' '--urdf --mesh' '--urdf --scale 0' '--urdf --table 1' '--urdf --picture a'; do
  # shellcheck disable=SC2086 # words are wanted
  check "options $options" status 2 "$convert" $options $data/six.urdf
done
finish urdf_tool
