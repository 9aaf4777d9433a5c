// What campaigns of seeded random pairs share. A test says before what it counts: the type campaign, with the pair, how many
// failures there were, and why. Names of cases are those of space, or of the plane where macros name them so.
#ifndef CAMPAIGN_H
#define CAMPAIGN_H

#include <stdlib.h>
#include <string.h>

#include "check.h"

// A pair that fails is printed as a case, which gjk-query reads.
static void expect(campaign *c, bool holds, const char *what) {
  CHECK_MSG(holds, "%s: %s: %s", c->pair.id, what, c->why);
  if (!holds && c->failures++ < FAILURES_SHOWN) {
    case_print(stdout, &c->pair);
    fflush(stdout);
  }
  c->why[0] = '\0';
}

// What the arguments [SEED [COUNT [FAMILY]]] ask for. name: NULL, or the one family; each: of a family.
typedef struct campaign_request {
  uint64_t seed;
  unsigned long count, each;
  const char *name;
} campaign_request;

static inline campaign_request campaign_requested(int argc, char **argv, unsigned long usual, unsigned families) {
  campaign_request r;
  r.seed = argc > 1 ? check_seeded(strtoull(argv[1], NULL, 10)) : check_seed(1);
  r.count = argc > 2 ? strtoul(argv[2], NULL, 10) : usual;
  r.name = argc > 3 ? argv[3] : NULL;
  r.each = r.name != NULL ? r.count : (r.count + families - 1) / families;
  return r;
}

static inline bool campaign_includes(const campaign_request *r, const char *family) {
  return r->name == NULL || strcmp(r->name, family) == 0;
}

// The share of intersecting pairs, percent, must stay between the limits of the family.
static inline void campaign_check_share(const char *name, double share, unsigned least, unsigned most) {
  CHECK_MSG(share >= least, "%s: %.1f %% intersect", name, share);
  CHECK_MSG(share <= most, "%s: %.1f %% intersect", name, share);
}

// A kind of proof must occur with each number of vertices that it can have, in at least one of so many pairs.
typedef struct campaign_proof {
  uint8_t proof;
  unsigned least, most;
  const char *name;
  unsigned long share;
} campaign_proof;

static inline void campaign_check_proofs(const campaign_proof *kinds, size_t count, unsigned long proofs[][5],
                                         unsigned long pairs) {
  for (size_t i = 0; i < count; i++) {
    for (unsigned named = kinds[i].least; named <= kinds[i].most; named++) {
      const unsigned long given = proofs[kinds[i].proof][named];
      printf("%lu times %s of %u pairs\n", given, kinds[i].name, named);
      CHECK_MSG(given > pairs / kinds[i].share, "%s of %u pairs: %lu", kinds[i].name, named, given);
    }
  }
}

#endif
