// Prints why an answer is right, and the posed vertices that it is about.
#ifndef PAGE_PROOF_H
#define PAGE_PROOF_H

#include "case/answer2.h"

// A line '  proof NAME pairs=A0-B3,... direction=x,y,z proven', or '... unproven'.
void proof_space(FILE *file, const case_question *question, const case_answer *answer, const gjk_collider *a,
                 const gjk_collider *b);
void proof_plane(FILE *file, const case_question *question, const case2_answer *answer, const gjk2_collider *a,
                 const gjk2_collider *b);

// A line '  posed A x,y,z x,y,z ...' of the vertices in the order of their numbers; of a curved shape its centre alone.
void proof_posed(FILE *file, char name, const gjk_collider *c);
void proof_posed2(FILE *file, char name, const gjk2_collider *c);

#endif
