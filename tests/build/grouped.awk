# 1234567 as 1,234,567: for the awk programs that write the README.
function grouped(number,    out) {
  out = number
  while (match(out, /^[0-9]+[0-9][0-9][0-9]/)) {
    out = substr(out, 1, RLENGTH - 3) "," substr(out, RLENGTH - 2)
  }
  return out
}

# The same to three digits: where a count begins within a tick of the board's counter moves it by one or two.
function about(number,    unit) {
  for (unit = 1; number / unit >= 1000; unit *= 10) {
  }
  return grouped(int(number / unit + 0.5) * unit)
}
