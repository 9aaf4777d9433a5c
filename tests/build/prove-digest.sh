# Of which code each run of the proof is: for prove.sh, after prove-setup.sh.
#
# tests/prove/digests.txt has a line RUN, tab, DIGEST for each run that last held on the code with that digest. It covers the
# files that the run analyses, and the headers that they include, without comments but the `//@` ones; the run's options;
# and what open.txt lists for it.

# Leaves the digest of each file without its comments in $dir/files, and what it includes: FILE, tab, DIGEST, tab, NAMES.
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
          gsub(/[ \t]+/, " ", line)
          sub(/^ /, "", line)
          sub(/ $/, "", line)
          if (line == "") continue
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
  awk -F '\t' 'FNR == NR { split($0, word, " "); sum[word[3]] = word[1] "." word[2]; next } { print $1 "\t" sum[$1] "\t" $2 }' \
    "$dir/sums" "$dir/includes" >"$dir/files"
}

# code_of RUN: the digest of its code and options. Headers are found by their names, which are unique.
code_of() {
  set_up "$1"
  {
    echo "$options|$machine|$defines|$contracts"
    # shellcheck disable=SC2086
    printf '%s\n' $sources tests/prove/contracts.h | awk -F '\t' '
      FNR == NR {
        sum[$1] = $2
        includes[$1] = $3
        name = $1
        sub(/^.*\//, "", name)
        path[name] = $1
        next
      }
      { wanted[++count] = $1 }
      END {
        for (i = 1; i <= count; i++) {
          if (wanted[i] in seen) continue
          seen[wanted[i]]
          print wanted[i], sum[wanted[i]]
          n = split(includes[wanted[i]], header, " ")
          for (k = 1; k <= n; k++) if (header[k] in path) wanted[++count] = path[header[k]]
        }
      }' "$dir/files" - | sort
  } | cksum | tr ' ' .
}

# line_of RUN: what digests.txt says of it where it is fresh.
line_of() {
  printf '%s\t%s\t%s\n' "$1" "$(code_of "$1")" "$(expected -v only="$1" | cut -f 2- | sort | cksum | tr ' ' .)"
}

is_fresh() {
  grep -q "^$1	" tests/prove/digests.txt && grep -qxF "$(line_of "$1")" tests/prove/digests.txt
}

# The runs that digests.txt has no line of, or one of other code.
unsigned() {
  runs | while read -r run; do
    is_fresh "$run" || echo "$run"
  done
}

# Names the runs whose line is of other code, or of another list.
stale() {
  bad=0
  runs >"$dir/known"
  for run in $(grep -v '^#' tests/prove/digests.txt | cut -f 1); do
    grep -qxF "$run" "$dir/known" || { echo "no such run: $run"; bad=1; continue; }
    is_fresh "$run" || { echo "of other code: $run. \`make prove CHANGED=1\` repeats it."; bad=1; }
  done
  return $bad
}

# sign RUN...: writes into digests.txt those that the last analysis shows to hold, if it was of this code.
sign() {
  for run in "$@"; do
    if [ -e "$dir/$run.facts" ] && [ "$(cat "$dir/$run.code")" = "$(code_of "$run")" ] &&
      expected -v only="$run" | cut -f 2- | sort | cmp -s - "$dir/$run.facts"; then
      line_of "$run"
    fi
  done >"$dir/new"
  {
    grep '^#' tests/prove/digests.txt
    grep -v '^#' tests/prove/digests.txt | cat - "$dir/new" | awk -F '\t' '{ last[$1] = $0 } END { for (run in last) print last[run] }' | sort
  } >"$dir/digests"
  cat "$dir/digests" >tests/prove/digests.txt
}
