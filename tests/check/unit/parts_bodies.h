// Trials with random bodies of many parts, and convex visitors near them.
#ifndef PARTS_BODIES_H
#define PARTS_BODIES_H

#include "check.h"
#include "generate/body.h"
#include "reference/random_shape.h"

static generate_body body, other;
static case_shape visitor;
static case_collider guest;

// Of each body that a seed stands for: what is tried with it.
static void try_body(random_state *random, uint64_t seed);

// Makes the trials; the seeds between are for other.
static void try_bodies(uint64_t seed, unsigned long trials) {
  for (unsigned long i = 0; i < trials; i++) {
    random_state random = random_seed(seed + 2 * i);
    check_trial(i, generate_body_show, &body);
    try_body(&random, seed + 2 * i);
  }
  check_trial(trials, NULL, NULL);
  generate_body_free(&body);
  generate_body_free(&other);
  case_collider_free(&guest);
  case_shape_free(&visitor);
}

#endif
