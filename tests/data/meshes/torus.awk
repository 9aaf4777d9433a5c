# Writes a torus as an OBJ file: radii of 34 and 11 millimetres, 24 by 12 squares, rounded to 0.001.
function rounded(x,   k) {
  k = x < 0 ? -int(.5 - 1000 * x) : int(.5 + 1000 * x)
  return k == 0 ? 0 : k / 1000
}

BEGIN {
  rings = 24
  sides = 12
  turn = 2 * atan2(0, -1)
  for (i = 0; i < rings; i++)
    for (j = 0; j < sides; j++) {
      far = 34 + 11 * cos(turn * j / sides)
      print "v", rounded(far * cos(turn * i / rings)), rounded(far * sin(turn * i / rings)), rounded(11 * sin(turn * j / sides))
    }
  for (i = 0; i < rings; i++)
    for (j = 0; j < sides; j++) {
      here = i * sides + 1
      next_ring = (i + 1) % rings * sides + 1
      after = (j + 1) % sides
      print "f", here + j, next_ring + j, next_ring + after
      print "f", here + j, next_ring + after, here + after
    }
}
