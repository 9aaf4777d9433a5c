# Of which code each run of the proof is: for prove.sh, after prove-setup.sh.
#
# tests/prove/digests.txt has a line RUN, tab, DIGEST for each run that last held on the code with that digest. It covers the
# files that the run analyses, and the headers that they include, without comments but the `//@` ones and GJK_BITS_VERSION; the
# run's options; and what open.txt lists for it. Of prototypes that take one line of a header, only those that they name count.

# Leaves the digest of each file without its comments in $dir/files, what it includes, and the prototypes that it names: FILE,
# tab, DIGEST, tab, NAMES, tab, FUNCTIONS. Those prototypes are in $dir/prototypes: FUNCTION, tab, LINE.
normalize() {
  normal=$dir/normal
  rm -rf "$normal"
  find src include tests/prove -name '*.[ch]' | sort >"$dir/names"
  awk -v normal="$normal" '
    { files[++count] = $0; folder = $0; sub(/\/[^\/]*$/, "", folder); folders[normal "/" folder] }
    END {
      for (folder in folders) system("mkdir -p " folder)
      for (i = 1; i <= count; i++) {
        file = files[i]
        out = normal "/" file
        printf "" >out
        included = ""
        while ((getline line < file) > 0) {
          if (line !~ /\/\/@/ && line !~ /".*\/\/.*"/) sub(/\/\/.*/, "", line)
          if (file ~ /^(src|include).*h$/ && line ~ /^[a-z].*[ *]gjk2?_[a-z0-9_]+\([^()]*\);$/) {
            name = line
            sub(/\(.*/, "", name)
            sub(/.*[ *]/, "", name)
            print name "\t" line >(normal "/../prototypes")
            continue
          }
          gsub(/[ \t]+/, " ", line)
          sub(/^ /, "", line)
          sub(/ $/, "", line)
          if (line == "" || line ~ /^#define GJK_BITS_VERSION /) continue
          print line >out
          if (line ~ /^# ?include "/) {
            gsub(/^[^"]*"|".*$/, "", line)
            sub(/^.*\//, "", line)
            included = included " " line
          }
        }
        close(file)
        close(out)
        print file "\t" included
      }
    }' "$dir/names" >"$dir/includes"
  (cd "$normal" && xargs cksum <"../names") >"$dir/sums"
  (cd "$normal" && xargs awk '
    FILENAME == "../prototypes" { split($0, part, "\t"); known[part[1]]; next }
    {
      while (match($0, /gjk2?_[a-z0-9_]+/)) {
        name = substr($0, RSTART, RLENGTH)
        $0 = substr($0, RSTART + RLENGTH)
        if (name in known && !((FILENAME, name) in seen)) { seen[FILENAME, name]; print FILENAME "\t" name }
      }
    }' ../prototypes <"../names") >"$dir/named"
  awk -F '\t' '
    FILENAME ~ /sums$/ { split($0, word, " "); sum[word[3]] = word[1] "." word[2]; next }
    FILENAME ~ /named$/ { named[$1] = named[$1] " " $2; next }
    { print $1 "\t" sum[$1] "\t" $2 "\t" named[$1] }' "$dir/sums" "$dir/named" "$dir/includes" >"$dir/files"
}

# digests RUN...: the line that digests.txt has of each where it is fresh. Headers are found by their names, which are unique.
digests() {
  of=$dir/of.$$
  mkdir -p "$of/code" "$of/list"
  for run in "$@"; do
    set_up "$run"
    printf '%s\t%s\t%s\n' "$run" "$options|$machine|$defines|$contracts" "$sources tests/prove/contracts.h"
  done >"$of/runs"
  awk -F '\t' -v folder="$of/code" '
    FILENAME ~ /prototypes$/ { prototype[$1] = prototype[$1] $2; next }
    FILENAME ~ /files$/ {
      sum[$1] = $2
      includes[$1] = $3
      names[$1] = $4
      name = $1
      sub(/^.*\//, "", name)
      path[name] = $1
      next
    }
    {
      out = folder "/" $1
      print $2 >out
      split("", seen)
      split("", told)
      count = split($3, wanted, " ")
      for (i = 1; i <= count; i++) {
        if (wanted[i] in seen) continue
        seen[wanted[i]]
        print wanted[i], sum[wanted[i]] >out
        n = split(includes[wanted[i]], header, " ")
        for (k = 1; k <= n; k++) if (header[k] in path) wanted[++count] = path[header[k]]
        n = split(names[wanted[i]], name_of, " ")
        for (k = 1; k <= n; k++) {
          if (name_of[k] in told) continue
          told[name_of[k]]
          print prototype[name_of[k]] >out
        }
      }
      close(out)
    }' "$dir/prototypes" "$dir/files" "$of/runs"
  expected | sort | awk -F '\t' -v folder="$of/list" '
    FNR == NR { printf "" >(folder "/" $1); close(folder "/" $1); known[$1]; next }
    $1 != last { close(folder "/" last); last = $1 }
    $1 in known { print $2, $3, $4 >(folder "/" $1) }' "$of/runs" -
  # Both list the same names in the same order.
  (cd "$of/code" && cksum -- *) >"$of/codes"
  (cd "$of/list" && cksum -- *) | paste "$of/codes" - | awk '{ print $3 "\t" $1 "." $2 "\t" $4 "." $5 }'
  rm -rf "$of"
}

# code_of RUN: the digest of its code and options.
code_of() {
  digests "$1" | cut -f 2
}

# The runs that digests.txt has no line of, or one of other code.
unsigned() {
  # shellcheck disable=SC2046
  digests $(runs) | grep -vxFf tests/prove/digests.txt | cut -f 1
}

# Names the runs whose line is of other code, or of another list.
stale() {
  bad=0
  runs >"$dir/known"
  grep -v '^#' tests/prove/digests.txt | cut -f 1 >"$dir/signed"
  if grep -vxFf "$dir/known" "$dir/signed" | sed 's/^/no such run: /' | grep .; then
    bad=1
  fi
  # shellcheck disable=SC2046
  if digests $(grep -xFf "$dir/known" "$dir/signed") | grep -vxFf tests/prove/digests.txt | cut -f 1 |
    sed 's/\(.*\)/of other code: \1. `make prove CHANGED=1` repeats it./' | grep .; then
    bad=1
  fi
  return $bad
}

# sign RUN...: writes into digests.txt those that the last analysis shows to hold, if it was of this code.
sign() {
  digests "$@" | while IFS='	' read -r run code list; do
    if [ -e "$dir/$run.facts" ] && [ "$(cat "$dir/$run.code")" = "$code" ] &&
      [ "$(tr '\t' ' ' <"$dir/$run.facts" | cksum | tr ' ' .)" = "$list" ]; then
      printf '%s\t%s\t%s\n' "$run" "$code" "$list"
    fi
  done >"$dir/new"
  {
    grep '^#' tests/prove/digests.txt
    grep -v '^#' tests/prove/digests.txt | cat - "$dir/new" | awk -F '\t' '{ last[$1] = $0 } END { for (run in last) print last[run] }' | sort
  } >"$dir/digests"
  cat "$dir/digests" >tests/prove/digests.txt
}
