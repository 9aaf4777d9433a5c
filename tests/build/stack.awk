# The deepest stack below functions: awk -v roots='gjk_distance ...' -f stack.awk indirect-calls.txt FILE.ci...
#
# The .ci files are gcc's own call graph (-fcallgraph-info=su). Prints 'ROOT BYTES PATH' for each root, with the bytes
# of each frame on the path. Fails for recursion, for a frame of unknown size, and for a call through a pointer that
# indirect-calls.txt does not cover. A helper of the compiler's, which has no call graph, counts HELPER bytes.
BEGIN { HELPER = 32 }

function fail(text) {
  print text
  bad = 1
}

FILENAME ~ /indirect-calls\.txt$/ {
  if ($0 !~ /^#/) { rules++; caller[rules] = $1; callee[rules] = $3; needed[rules] = $4 == "if" ? $5 : "" }
  next
}

/^(node|edge):/ { gsub(/"[^"]*\/src\//, "\"src/") }

/^node:/ && !/shape : ellipse/ {
  split($0, part, "\"")
  name = part[2]
  if (!match($0, /[0-9]+ bytes \(static\)/)) fail("no fixed frame: " name)
  frame[name] = substr($0, RSTART) + 0
}

/^edge:/ {
  split($0, part, "\"")
  if (!seen[part[2], part[4]]++) calls[part[2]] = calls[part[2]] " " part[4]
}

# What name may call: indirect calls replaced by what the rules list.
function targets(name,    list, count, i, rule, other, out, covered) {
  count = split(calls[name], list, " ")
  for (i = 1; i <= count; i++) {
    if (list[i] != "__indirect_call") { out = out " " list[i]; continue }
    covered = 0
    for (rule = 1; rule <= rules; rule++) if (name ~ caller[rule]) {
      covered = 1
      if (needed[rule] != "" && !(needed[rule] in reached)) continue
      for (other in frame) if (other ~ callee[rule]) out = out " " other
    }
    if (!covered) fail("call through a pointer in " name ": not in indirect-calls.txt")
  }
  return out
}

# Bytes below and with name; path[name] is the way down.
function depth(name,    list, count, i, below, deepest) {
  if (name in known) return known[name]
  if (!(name in frame)) { path[name] = name " " HELPER; return known[name] = HELPER }
  if (active[name]) { fail("recursion through " name); return 0 }
  active[name] = 1
  deepest = 0
  path[name] = name " " frame[name]
  count = split(targets(name), list, " ")
  for (i = 1; i <= count; i++) {
    below = depth(list[i])
    if (below > deepest) { deepest = below; path[name] = name " " frame[name] " > " path[list[i]] }
  }
  active[name] = 0
  return known[name] = frame[name] + deepest
}

# What name may reach by calls that are not through a pointer.
function reach(name,    list, count, i) {
  if (name in reached) return
  reached[name]
  count = split(calls[name], list, " ")
  for (i = 1; i <= count; i++) reach(list[i])
}

END {
  count = split(roots, root, " ")
  for (n = 1; n <= count; n++) {
    split("", reached)
    split("", known)
    reach(root[n])
    if (!(root[n] in frame)) fail("no function " root[n])
    printf "%s %d ", root[n], depth(root[n])
    print path[root[n]]
  }
  exit bad
}
