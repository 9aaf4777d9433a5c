// Which plane to cut a piece by.
#ifndef CUTS_H
#define CUTS_H

#include "part.h"
#include "piece.h"

// The corners of a piece as integers: those that are none are replaced by the corners of their unit cube, so that the
// hull of the integers has the piece in it. nearest: by the nearest one, which spares points where the hull is only looked at.
// For free.
int32_t (*cuts_points(const piece *p, const piece_pool *pool, bool nearest, size_t *count))[3];

// slack: notches that are less deep, LSB, are none. pairs: planes through two notches count, too, not only those of
// faces; corners: those through a notch and a corner. They may meet edges where no integers are.
typedef struct cuts_manner {
  long double slack;
  bool pairs, corners;
} cuts_manner;

// Cuts a piece at its notches until there are none, each time by the plane that leaves the fewest in the
// end, as far as a short search tells. False: more than 'limit' pieces.
bool cuts_at_notches(const piece *p, piece_pool *pool, const cuts_manner *manner, size_t limit, piece_list *out);

// Cuts a piece once, so that the hulls of what is left are small, and the cut. hull_volume6: six times its own hull's
// volume. False: no plane cuts it.
bool cuts_once(const piece *p, long double hull_volume6, piece_pool *pool, piece_list *out);

#endif
