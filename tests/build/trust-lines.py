# What has to be believed of the proven checkers, in lines: trust-lines.py. Comments and empty lines do not count.
#
# Proven: the functions of tests/prove/checker/functions.txt. To be read: operators.h; the contracts of the checks and
# the other axioms, with each word that they use; the definitions and theorems of hull.v and solid.v, without proofs.
import re
import sys

spec = "tests/prove/checker/"


def lines(path):
    return [s for s in open(path).read().split("\n") if s.strip() and not s.lstrip().startswith(("//", "#"))]


def function(name):
    """The lines of a function's body and head."""
    head = r"^[a-zA-Z][^\n;{}]*\b" + name + r"\([^;{}]*\) \{\n"
    for path in ("arith/gjk_wide.c", "arith/gjk_wide.h", "arith/gjk_vector.h", "arith/gjk_vector_inline.h",
                 "plane/gjk2_check.c", "plane/gjk2_claim.c", "plane/gjk2_measure.c", "plane/gjk2_measure.h",
                 "plane/gjk2_search.h", "plane/gjk2_outward.c", "plane/gjk2_outward.h", "plane/gjk2_search_frame.c",
                 "plane/gjk2_vector.h", "plane/gjk2_class.h", "query/gjk_check.c", "arith/gjk_vector.c",
                 "gjk/gjk_frame.c", "gjk/gjk_frame.h", "gjk/gjk_iteration.c", "gjk/gjk_iteration.h",
                 "gjk/gjk_simplex.c", "gjk/gjk_simplex.h", "shape/gjk_shape_class.h", "query/gjk_distance.h",
                 "plane_motion/gjk2_way.c", "plane_motion/gjk2_check_cast.c", "motion/gjk_way.c",
                 "motion/gjk_spheres.c", "motion/gjk_swept.c", "motion/gjk_check_cast.c"):
        found = re.search(head + r".*?^\}$", open("src/" + path).read(), re.M | re.S)
        if found:
            return [s for s in found.group().split("\n") if s.strip() and not s.lstrip().startswith("//")]
    sys.exit("no function " + name)


def contracts(files, names):
    """The contracts of these functions and the axioms, with their words: predicates, logic functions and macros."""
    text = "".join(open(spec + name).read() for name in files)
    words = {}
    for clause in re.findall(r"(?:predicate|logic integer) .*?(?:;|\*/)", text, re.S):
        words[re.match(r"(?:predicate|logic integer) (\w+)", clause).group(1)] = clause
    for macro in re.findall(r"^#define (?:.*\\\n)*.*", text, re.M):
        words[re.match(r"#define (\w+)", macro).group(1)] = macro
    contract = r"/\*@ (?:requires|assigns)(?:(?!/\*@).)*?\w+ "
    found = [re.search(contract + name + r"\(", text, re.S).group() for name in names]
    found += re.findall(r"axiom .*?;", text, re.S)
    used, todo = set(), found[:]
    while todo:
        for word in re.findall(r"\w+", todo.pop()):
            if word in words and word not in used:
                used.add(word)
                todo.append(words[word])
    return set(found) | set(words[w] for w in used)


clauses = (contracts(("geometry.h", "wide.h", "plane.h", "plane_depth.h", "plane_cast.h"),
                     ("gjk2_check_decision", "gjk2_check_distance", "gjk2_check_penetration", "gjk2_check_cast",
                      "plane_vertex")) |
           contracts(("geometry.h", "solid.h", "wide.h", "space.h", "measure.h", "depth.h", "space_cast.h"),
                     ("gjk_check_decision", "gjk_check_distance", "gjk_check_penetration", "gjk_check_cast",
                      "gjk_swept_set", "gjk_isqrt64", "space_vertex")))
contract_lines = sum(len(t.split("\n")) for t in clauses)

hull_lines = 0
for name in ("hull.v", "solid.v"):
    text = re.sub(r"^Proof\..*?Qed\.$|^Lemma .*?Qed\.$|\(\*.*?\*\)", "", open(spec + name).read(), flags=re.M | re.S)
    hull_lines += len([s for s in text.split("\n") if s.strip() and not s.startswith("Print")])
axioms = len(lines(spec + "operators.h"))
names = [s.split()[1] for s in lines(spec + "functions.txt")]
print("%d lines of C in %d functions are proven" % (sum(len(function(n)) for n in names), len(names)))
print("%d lines of specification: %d of contracts and their words, %d of operators, %d of definitions and theorems" %
      (contract_lines + axioms + hull_lines, contract_lines, axioms, hull_lines))
