# Cases that a tool must refuse, for check. Source it after count.sh. It takes the variables tool, dir, and word, with which a
# case begins, and the function plain, which leaves out what may change.

# malformed LINE 'expected' 'text of the case, printf format'; the text begins at line 4.
malformed() {
  {
    printf '%s first\nA point\nB point\n' "$word"
    # shellcheck disable=SC2059
    printf "$3"
    printf '\n%s last\nA point\nB point\n' "$word"
  } >"$dir/bad.txt"
  status 2 "$tool" "$dir/bad.txt" || return 1
  message=$(cat "$dir/err")
  case $message in
    "$dir/bad.txt:$1: expected $2"*) ;;
    *) echo "line $1, expected $2, but: $message"; return 1 ;;
  esac
  is 1 "$(wc -l <"$dir/err" | tr -d ' ')" &&
    is 'first intersecting,last intersecting,' "$(plain <"$dir/out" | tr '\n' ',')"
}

bad() {
  check "malformed: $2: $3" malformed "$@"
}
