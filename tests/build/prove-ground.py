# Z3 without what is quantified: prove-ground.py SECONDS FILE. Why3 calls it as one of its provers.
#
# Each assertion of a problem that has a quantifier is dropped, but the last, which is the goal. Less is assumed then,
# so `unsat` still proves the goal. Z3 decides polynomials by a method that it does not use beside quantifiers. Why3
# writes definitions as quantified equations, whose names end in 'def: these become definitions of Z3. The first try has
# none of a contract's words, the second those of predicates, the third all.
#
# The last try keeps the axioms of operators.h: what they say of bits is lost to provers that have WP's whole theory of
# bits beside them.
import os
import re
import subprocess
import sys


ELSE = "-else"


def forms(text):
    """The top-level forms, each with the comment before it."""
    name, stack, out = "", [], []
    for token in re.findall(r";[^\n]*|\|[^|]*\||[()]|[^\s()]+", text):
        if token.startswith(";"):
            if not stack:
                name = token.lstrip("; ")
        elif token == "(":
            stack.append([])
        elif token == ")":
            form = stack.pop()
            if stack:
                stack[-1].append(form)
            else:
                out.append((name, form))
        else:
            stack[-1].append(token)
    return out


def text(form):
    return form if isinstance(form, str) else "(" + " ".join(map(text, form)) + ")"


def quantified(form):
    return form in ("forall", "exists") if isinstance(form, str) else any(map(quantified, form))


def symbols(form):
    return {form} & names if isinstance(form, str) else set().union(*map(symbols, form))


def inner(form):
    """(let BINDINGS (= LEFT RIGHT)) as (= LEFT (let BINDINGS RIGHT)); (ite IF (= LEFT THEN) (= LEFT ELSE)) likewise."""
    if form[0] == "let":
        equation = inner(form[2])
        return ["=", equation[1], ["let", form[1], equation[2]]] if equation[0] == "=" else form
    if form[0] == "ite":
        one, other = inner(form[2]), inner(form[3])
        if one[0] == other[0] == "=" and one[1] == other[1]:
            return ["=", one[1], ["ite", form[1], one[2], other[2]]]
    return form


def bare(form):
    """A formula without what says where to use it: (! FORMULA :pattern (TERMS))."""
    return form[1] if form[0] == "!" else form


def definition(name, form, types):
    """(assert (forall (ARGUMENTS) (= (NAME ARGUMENTS) BODY))), or None."""
    function = re.sub("['_]def$", "", name)
    if function == name or function not in types or form[1][0] != "forall":
        return None
    arguments, equation = form[1][1], inner(bare(form[1][2]))
    if equation[0] != "=" or equation[1] != [function] + [a[0] for a in arguments] or quantified(equation[2]):
        return None
    return ["define-fun", function, arguments, types[function], equation[2]]


def flat(form):
    """The arguments of nested quantifiers, and the formula within."""
    arguments = []
    while form[0] == "forall":
        arguments += form[1]
        form = bare(form[2])
    return arguments, form


def access(form, types):
    """(assert (forall (ARGUMENTS PLACE) (= (select (NAME ARGUMENTS) PLACE) BODY))) as NAME's definition, or None."""
    arguments, equation = flat(form[1])
    if equation[0] != "=" or equation[1][0] != "select" or isinstance(equation[1][1], str):
        return None
    (function, *given), place = equation[1][1:]
    kinds = dict(arguments)
    if function not in types or not all(isinstance(a, str) for a in given + [place]):
        return None
    if set(given + [place]) != set(kinds) or not len(given) + 1 == len(kinds) == len(arguments):
        return None
    return ["define-fun", function, [[a, kinds[a]] for a in given], types[function],
            ["lambda", [[place, kinds[place]]], equation[2]]]


def identity(form, types):
    """(assert (forall ((X KIND)) (=> GUARD (= (NAME X) X)))): NAME is X there, and else another function; or None."""
    arguments, rule = flat(form[1])
    if len(arguments) != 1 or rule[0] != "=>" or rule[2][0] != "=" or rule[2][2] != arguments[0][0]:
        return None
    function, *given = rule[2][1]
    if isinstance(function, list) or function not in types or given != [arguments[0][0]]:
        return None
    return ["define-fun", function, arguments, types[function],
            ["ite", rule[1], arguments[0][0], [function + ELSE, arguments[0][0]]]]


def projection(name, form, types):
    """Of (assert (forall (ARGUMENTS) (= (NAME (CONSTRUCTOR ARGUMENTS)) ARGUMENT))): CONSTRUCTOR, number, NAME."""
    function = re.sub("'def$", "", name)
    if function == name or function not in types or form[1][0] != "forall":
        return None
    arguments, equation = [a[0] for a in form[1][1]], form[1][2]
    if equation[0] != "=" or equation[2] not in arguments or len(equation[1]) != 2 or equation[1][0] != function:
        return None
    record = equation[1][1]
    return (record[0], arguments.index(equation[2]), function) if record[1:] == arguments else None


problem = [(n, f) for n, f in forms(open(sys.argv[2]).read()) if f[0] not in ("get-info", "get-model")]
# Records.
types = {f[1]: f[3] for n, f in problem if f[0] == "declare-fun"}
fields = {}
for n, f in problem:
    found = projection(n, f, types) if f[0] == "assert" else None
    if found:
        fields.setdefault(found[0], {})[found[1]] = found[2]
constructors = {f[1]: f for n, f in problem
                if f[0] == "declare-fun" and f[1] in fields and len(fields[f[1]]) == len(f[2])}
selectors = {name for c in constructors for name in fields[c].values()}
records = {f[3] for f in constructors.values()}
sorts = [("", f) for n, f in problem if f[0] == "declare-sort" and f[1] not in records]
datatypes = [("", ["declare-datatypes", [[f[3], "0"]],
                   [[[f[1]] + [[fields[f[1]][i], f[2][i]] for i in range(len(f[2]))]]]])
             for f in constructors.values()]
problem = sorts + datatypes + [(n, f) for n, f in problem if f[0] != "declare-sort" and
                               not (f[0] == "declare-fun" and (f[1] in constructors or f[1] in selectors))]
types = {f[1]: f[3] for n, f in problem if f[0] == "declare-fun"}
goal = max(i for i, (n, f) in enumerate(problem) if f[0] == "assert")
# The goal is that no x contradicts it: so any x, as a constant.
while (isinstance(problem[goal][1][1], list) and problem[goal][1][1][0] == "not" and
       problem[goal][1][1][1][0] == "forall"):
    _, variables, body = problem[goal][1][1][1]
    constants = [("", ["declare-fun", v, [], kind]) for v, kind in variables]
    problem[goal:goal + 1] = constants + [("", ["assert", ["not", body]])]
    goal += len(variables)
names = {f[1] for n, f in problem if f[0] == "declare-fun"}
types = {f[1]: f[3] for n, f in problem if f[0] == "declare-fun"}
goal_form = problem[goal][1]
defined, others = {}, []
for i, (n, f) in enumerate(problem):
    found = f[0] == "assert" and f is not goal_form
    found = found and (definition(n, f, types) or access(f, types) or identity(f, types))
    if found and found[1] not in defined:
        defined[found[1]] = found
        problem[i] = (n, found)
        if found[4][0] == "ite" and found[4][3][0] == found[1] + ELSE:
            others.append(("", ["declare-fun", found[1] + ELSE, [kind for name, kind in found[2]], found[3]]))
problem = others + [(n, f) for n, f in problem if not (f[0] == "declare-fun" and f[1] in defined)]
names |= {f[1] for n, f in others}


def lines(opaque, told):
    """What the goal needs; words whose names begin with one of opaque stay without their definitions. told: with the
    axioms of operators.h about symbols that it needs."""
    shown = [["declare-fun", f[1], [kind for name, kind in f[2]], f[3]]
             if f[0] == "define-fun" and f[1].startswith(opaque) else f for n, f in problem]
    wanted = symbols(goal_form)
    kept = {i for i, f in enumerate(shown) if f is goal_form}
    grown = True
    while grown:
        grown = False
        for i, f in enumerate(shown):
            if i in kept or f[0] not in ("assert", "define-fun"):
                continue
            own = symbols(f)
            if f[0] == "assert" and quantified(f) and not (told and problem[i][0] in operators and own <= wanted):
                continue
            if f[0] == "assert" and own & wanted or f[0] == "define-fun" and f[1] in wanted:
                kept.add(i)
                wanted |= own
                grown = True
    return [text(f) for i, f in enumerate(shown) if f[0] not in ("assert", "define-fun", "declare-fun") or i in kept or
            f[0] == "declare-fun" and f[1] in wanted]


def answer(problem, seconds):
    found = subprocess.run(["z3", "-smt2", "-in", "-T:%d" % seconds], input=problem, text=True, stdout=subprocess.PIPE)
    return found.stdout.strip()


operators = {"Q_" + name for name in re.findall(r"axiom (\w+):", open(os.path.join(os.path.dirname(sys.argv[0]),
             "../prove/checker/operators.h")).read())}
# A problem that is the same in another try gets the time of both.
shares = {}
for opaque, told, share in ((("P_", "L_"), False, 5), (("L_",), False, 3), ((), False, 7), (("P_", "L_"), True, 5)):
    tried = "\n".join(lines(opaque, told))
    shares[tried] = shares.get(tried, 0) + share
seconds = int(sys.argv[1])
answers = []
for tried, share in shares.items():
    answers.append(answer(tried, seconds * share // 20))
    if answers[-1] == "unsat":
        break
# With more time another try may be worth while: Why3 takes this line for a timeout.
print("unsat" if "unsat" in answers else "interrupted by timeout" if "timeout" in answers else "unknown")
