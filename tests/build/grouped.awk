# 1234567 as 1,234,567: for the awk programs that write the README.
function grouped(number,    out) {
  out = number
  while (match(out, /^[0-9]+[0-9][0-9][0-9]/)) {
    out = substr(out, 1, RLENGTH - 3) "," substr(out, RLENGTH - 2)
  }
  return out
}
