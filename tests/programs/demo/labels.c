// Places labels: of some hundred places around the anchor it takes the one that hides least.
#include "labels.h"

#include <math.h>

void label_take(label_page *page, label_rectangle r, double weight) {
  if (page->count < LABEL_RECTANGLES_MAX) {
    page->taken[page->count] = r;
    page->weight[page->count++] = weight;
  }
}

// The length that two intervals share, with a margin around the first.
static double shared(double a, double a_length, double b, double b_length) {
  const double margin = 3;
  double low = a - margin > b ? a - margin : b;
  double high = a + a_length + margin < b + b_length ? a + a_length + margin : b + b_length;
  return high > low ? high - low : 0;
}

static double overlap(const label_rectangle *a, const label_rectangle *b) {
  return shared(a->left, a->width, b->left, b->width) * shared(a->top, a->height, b->top, b->height);
}

static double cost(const label_page *page, const label_rectangle *r) {
  const label_rectangle *area = &page->area;
  double sum = 0;
  if (r->left < area->left || r->top < area->top || r->left + r->width > area->left + area->width ||
      r->top + r->height > area->top + area->height) {
    sum += 1e6;
  }
  for (size_t i = 0; i < page->count; i++) {
    sum += page->weight[i] * overlap(r, &page->taken[i]);
  }
  return sum;
}

label_rectangle label_place(label_page *page, point2 anchor, double width, double height, double nearest) {
  enum { ANGLES = 24, RINGS = 12 };
  label_rectangle best = {anchor.x - width / 2, anchor.y - height / 2, width, height};
  double best_cost = 1e30;
  for (int i = 0; i < ANGLES * RINGS; i++) {
    double angle = 2 * 3.14159265358979323846 * (i % ANGLES) / ANGLES, ring = nearest + 10.0 * (i / ANGLES);
    label_rectangle r = {anchor.x + (ring + width / 2 - height / 2) * cos(angle) - width / 2,
                         anchor.y - ring * sin(angle) - height / 2, width, height};
    if (ring <= 0) {
      r.left = anchor.x - width / 2;
    }
    double price = cost(page, &r) + ring * 4;
    if (price < best_cost) {
      best_cost = price;
      best = r;
    }
  }
  label_take(page, best, 20);
  return best;
}
