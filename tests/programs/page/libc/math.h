// What the references need of math. WebAssembly has roots and roundings as instructions, correctly rounded.
#ifndef PAGE_MATH_H
#define PAGE_MATH_H

#define INFINITY __builtin_inff()

static inline double sqrt(double x) {
  return __builtin_sqrt(x);
}

static inline double fabs(double x) {
  return __builtin_fabs(x);
}

static inline double ceil(double x) {
  return __builtin_ceil(x);
}

static inline double fmax(double a, double b) {
  return a > b || b != b ? a : b;
}

static inline double hypot(double x, double y) {
  return sqrt(x * x + y * y);
}

// Half away from zero. Pre: |x| < 2^31.
static inline long lround(double x) {
  const long whole = (long)x;
  const double rest = x - (double)whole;
  return whole + (rest >= 0.5) - (rest <= -0.5);
}

#endif
