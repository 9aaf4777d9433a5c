#!/bin/sh
# The C# package, with mono: the golden hashes of pairs and of scenes in space and in the plane, the layout of every structure,
# errors, saves, that no call allocates, the examples of its README and for Godot. test_csharp.sh BUILD
. tests/build/count.sh
build=$1
dir=$build/csharp-test
rm -rf "$dir"
mkdir -p "$dir"
packed=$dir/package/unity
hash_of() {
  sed -n "s/^#define $1 UINT64_C(0x\(.*\))\$/\1/p" "tests/check/target/$2.h"
}

missing=
have mcs || missing="$missing mono-mcs"
have mono || missing="$missing mono-runtime"
if [ -n "$missing" ]; then
  skip 'the C# package' "${missing# }"
  finish csharp
  exit
fi

# compile OUT FLAG|SOURCE...: all warnings are errors
compile() {
  out=$1
  shift
  mcs -unsafe -langversion:7.2 -warnaserror "-out:$dir/$out" "$@"
}

tests() {
  # The plane's match is that of space under other names.
  sed 's/namespace Space {/namespace Flat {\n    using Gjk.Plane;\n/; s/Vec3/Vec/g; s/Quat/Rotation/g' \
    tests/check/bind/Match.cs >"$dir/FlatMatch.cs"
  compile tests.exe "-r:$dir/Gjk.dll" tests/check/bind/*.cs "$dir/FlatMatch.cs"
}

runs() {
  program=$1
  shift
  LD_LIBRARY_PATH=$packed/Runtime/Plugins/x86_64 mono "$dir/$program" "$@"
}

other() {
  ! runs tests.exe "$@"
}

# Names without case and underscores; of an array of structures the first is named in C#.
same_layout() {
  sh tests/build/layout.sh "$dir/layout" "$dir/package-api.txt" "${CC:-cc}" "-I$dir/package-amalgamation" >"$dir/layout.c.txt" &&
    runs tests.exe layout >"$dir/layout.cs.txt" || return 1
  sed 's/^gjk2_/plane./; s/^gjk_//; s/_//g' "$dir/layout.c.txt" | sort >"$dir/of-c"
  sed 's/^Gjk[.]//; s/^\([A-Za-z.]*\)\(Shape\|Collider\|Scene\|Workspace\)Data\([ .]\)/\1\2\3/; /[.][a-z][a-z]*[1-9] /d; s/0\( [0-9]*\)$/\1/; s/_//g' "$dir/layout.cs.txt" |
    tr '[:upper:]' '[:lower:]' | sort >"$dir/of-cs"
  diff "$dir/of-c" "$dir/of-cs"
}

# example NAME FILE SOURCE...: the block of C# in a file prints what its comments say
example() {
  name=$1
  awk '/^```csharp$/ { inside = 1; next } /^```$/ { inside = 0 } inside' "$2" >"$dir/$name.cs"
  shift 2
  sed -n 's|.*// prints: ||p' "$dir/$name.cs" >"$dir/expected"
  test -s "$dir/expected" && compile "$name.exe" "-r:$dir/Gjk.dll" "$dir/$name.cs" "$@" && runs "$name.exe" >"$dir/printed" &&
    diff "$dir/expected" "$dir/printed"
}

# Debian has no Godot 4: what the example uses of it.
godot() {
  cat >"$dir/Godot.cs" <<'END'
using System;
namespace Godot {
    public struct Vector3 {
        public float X, Y, Z;
        public Vector3(float x, float y, float z) { X = x; Y = y; Z = z; }
    }
    public static class GD {
        public static void Print(string text) { Console.WriteLine(text); }
    }
    public class Node3D {
        public Vector3 Position;
        public virtual void _Ready() { }
        public virtual void _PhysicsProcess(double delta) { }
        public virtual void _ExitTree() { }
    }
    public static class Engine {
        public static void Main() {
            Node3D node = new Arena();
            node._Ready();
            for (int i = 0; i < 10; i++) node._PhysicsProcess(1 / 60.0);
            node._ExitTree();
            if (Math.Abs(node.Position.Y - 0.95) > 1e-3) throw new Exception("not there");
        }
    }
}
END
  example godot port/csharp/GODOT.md "$dir/Godot.cs"
}

# A library of other structures is refused.
refuses_another_version() {
  sed 's/public ushort PartCount;/public ushort PartCount; public long Surplus;/' "$packed/Runtime/Native.cs" >"$dir/Other.cs"
  mkdir -p "$dir/other" && compile other/Gjk.dll -target:library "$dir/Other.cs" "$packed"/Runtime/[!N]*.cs &&
    cp "$dir/tests.exe" "$dir/other" && ! runs other/tests.exe golden 1 0 >"$dir/refusal" 2>&1 &&
    grep -qE 'has another gjk_(body_setup|arm_model)' "$dir/refusal"
}

layout() {
  python3 - "$packed" <<'END'
import json, pathlib, sys, xml.dom.minidom
package = pathlib.Path(sys.argv[1])
about = json.loads((package / "package.json").read_text())
assembly = json.loads((package / "Runtime/Gjk.asmdef").read_text())
xml.dom.minidom.parse(str(package / "Gjk.csproj"))
assert about["name"] == about["name"].lower() and assembly["allowUnsafeCode"]
for name in ("README.md", "LICENCE.txt", "Runtime/Native.cs", "Runtime/Plugins/gjk.c", "Runtime/Plugins/x86_64/libgjk.so"):
    assert (package / name).exists(), name
END
}

is_tidy() {
  ! grep -nE '.{141}|[[:blank:]]$|	' "$1"
}

check 'make package' sh tests/build/package.sh "$dir" unity
check 'the package compiles' compile Gjk.dll -target:library "$packed"/Runtime/*.cs
check 'the tests compile' tests
check 'the layout of structures' same_layout
check 'the golden hash' runs tests.exe golden 3000 "$(hash_of GOLDEN_HASH golden)"
check 'another set has another hash' other golden 149 "$(hash_of GOLDEN_FEW_HASH golden)"
check 'the golden hash of a scene' runs tests.exe scene 500 "$(hash_of SCENE_GOLDEN_FEW_HASH scene_golden)"
check 'another match has another hash' other scene 499 "$(hash_of SCENE_GOLDEN_FEW_HASH scene_golden)"
check 'the golden hash of a scene of the plane' runs tests.exe plane 500 \
  "$(hash_of PLANE_SCENE_GOLDEN_FEW_HASH plane_scene_golden)"
check 'errors, saves, no allocations' runs tests.exe behaviour
check "the README's example" example readme port/csharp/README.md
check 'the example for Godot' godot
check 'a library with other structures is refused' refuses_another_version
check 'the layout of the package' layout
for file in port/csharp/Runtime/*.cs tests/check/bind/*.cs; do
  check "$file is tidy" is_tidy "$file"
done
finish csharp
