#!/bin/sh
# Does the proof of the checker notice faults? prove-checker-faults.sh BUILD [NAME...]: these alone. Each fault is put into a
# copy of the sources, and the function's proof must fail there: at an obligation, not for want of a prover or a line.
. tests/build/count.sh
. tests/build/fault.sh
LC_ALL=C.UTF-8
export LC_ALL
top=$1/prove-checker-faults
shift
chosen=" $* "

# follow INSIDE OLD NEW: annotations that stand beside a line with a fault stay beside it
follow() {
  OLD=$2 NEW=$3 awk '
    /^(before|after) / && (at = index($0, ENVIRON["OLD"])) != 0 {
      $0 = substr($0, 1, at - 1) ENVIRON["NEW"] substr($0, at + length(ENVIRON["OLD"]))
    }
    { print }' "$1" >"$1.changed" && mv "$1.changed" "$1"
}

# fault NAME FILE FUNCTION OLD NEW: replaces literal text, which must occur once.
fault() {
  case $chosen in
    '  ' | *" $1 "*) ;;
    *) return ;;
  esac
  copy=$top/$1
  copy_sources "$copy"
  replace_once "$copy/$2" "$4" "$5" || {
    check "$1: $2 still has '$4', once" false
    return
  }
  follow "$copy/tests/prove/checker/inside.txt" "$4" "$5"
  (cd "$copy" && TRIES=20 sh tests/build/prove-checker.sh build "$3") >"$copy/out" 2>&1
  check "$1: noticed" grep -qE "$6" "$copy/out"
  grep -m 2 -E "$6" "$copy/out" | sed "s/^/  $1: /"
}

for tool in frama-c:frama-c-base why3:why3 z3:z3 cvc4:cvc4 python3:python3 coqc:coq; do
  if ! have "${tool%%:*}"; then
    skip 'the faults' "${tool##*:}"
    finish prove-checker-faults
    exit
  fi
done
wide=src/arith/gjk_wide measure=src/plane/gjk2_measure open='^failed: (int32|plane|claim|plane_cast|space_cast|space): \[wp\]'
fault digits-mixed $wide.c gjk_sum_of_products 'gjk_mac32(gjk_mul32(rh, sl), rl, sh);' 'gjk_mac32(gjk_mul32(rh, sl), rl, sl);' "$open"
fault carry-lost $wide.c gjk_sum_of_products '+ (digit >> 31);' ';' "$open"
fault sign-of-zero $wide.c gjk_sum_of_products_sign_exact '? -1 : (sum.high | sum.low) != 0' '? -1 : sum.low != 0' "$open"
fault low-digit-of-32 $wide.h gjk_low_digit '(gjk_low32(x) & INT32_MAX)' '(gjk_low32(x) & UINT32_MAX)' "$open"
fault touching-is-apart $measure.c gjk2_is_within 'gjk_umul32(r, r), 1)' 'gjk_umul32(r, r), 0)' "$open"
fault borrow-lost $measure.c gjk2_reaches '(sum.high - (sum.low < rest))' 'sum.high' "$open"
fault bound-too-low $measure.h gjk2_length_bound 'y = gjk_magnitude32(n.y);' 'y = gjk_magnitude32(n.x);' "$open"
fault edge-reversed src/plane/gjk2_check.c has_foot 'gjk2_vec edge = gjk2_sub(*q, *p);' 'gjk2_vec edge = gjk2_sub(*p, *q);' "$open"
check=src/plane/gjk2_check.c
fault coordinate-twice $check plane_place 'out->x = w.x;' 'out->x = w.y;' "$open"
fault too-many-named $check load_named 'certificate->count > most)' 'certificate->count > most + 1)' "$open"
fault flat-triangle $check triangle_holds_origin 'a != 0 && a == b' 'a == b' "$open"
fault corner-without-name $check plane_is_enclosing '&w[certificate->count > 2 ? 2 : 0]' '&w[2]' "$open"
fault base-of-other-sign $check plane_set_feature 's->base = gjk2_cross(w[0], w[1]);' 's->base = gjk2_cross(w[1], w[0]);' "$open"
fault radius-left-out $check line_is_clear '(-height, d, radius)' '(-height, d, 0)' "$open"
fault support-not-asked $check plane_is_nearest ' && support(s, s->d) == s->base' '' "$open"
fault proof-of-no-kind $check plane_is_apart 'certificate->proof != GJK2_PROOF_NEAREST || !plane_is_nearest(s, certificate)' 'certificate->proof != GJK2_PROOF_NEAREST' "$open"
fault edge-without-foot $check plane_set_feature 'return s->base < 0 && has_foot(&w[0], &w[1]);' 'return (s->base < 0);' "$open"
fault tie-down $check plane_rounds_to 'quarter = (squared + 3) >> 2;' 'quarter = (squared + 4) >> 2;' "$open"
fault radii-left-out $check plane_proves_distance '(uint32_t)result->distance + (uint32_t)gjk2_convex_radii(s);' '(uint32_t)result->distance;' "$open"
frame=src/plane/gjk2_search_frame.c
fault far-is-near $frame is_long 'UINT64_C(1) << 60;' 'UINT64_C(1) << 62;' "$open"
fault circles-touch $frame start_near '> gjk_mul32(limit, limit)' '>= gjk_mul32(limit, limit)' "$open"
fault far-circles-touch $frame start_far 'gjk_umul32((uint32_t)uy, (uint32_t)uy) >' \
  'gjk_umul32((uint32_t)uy, (uint32_t)uy) >=' "$open"
fault delta-of-other-sign $frame start_near 's->a->centre.y - s->b->centre.y};' 's->b->centre.y - s->a->centre.y};' "$open"
fault centre-of-x src/plane/gjk2_search.h gjk2_frame_is_near 'gjk_sar32(a->centre.y, 2)' 'gjk_sar32(a->centre.x, 2)' "$open"
check=src/query/gjk_check.c
fault long-direction $check is_separating '>= UINT64_C(1) << 62) {' '>= UINT64_C(1) << 63) {' "$open"
fault radius-of-0 $check is_apart 'is_separating(it, &certificate->direction, radius)' 'is_separating(it, &certificate->direction, 0)' "$open"
fault smaller-spheres src/gjk/gjk_iteration.c gjk_iteration_start 'gjk_goal_separates(goal), radius)' 'gjk_goal_separates(goal), radius / 2)' "$open"
fault near-without-foot $check proves_near 'gjk_simplex_set(&it->simplex, certificate->count) && gjk_iteration_near(it)' 'gjk_iteration_near(it)' "$open"
fault normal-of-other-corner src/gjk/gjk_simplex.c set_triangle_normal '&s->slot[w].w, &s->normal);' '&s->slot[y].w, &s->normal);' "$open"
fault volume-of-two src/gjk/gjk_simplex.c volume_sign 'return gjk_dot_sign(&product, &s->slot[k].w);' 'return gjk_dot_sign(&product, &s->slot[j].w);' "$open"
fault product-of-0 src/gjk/gjk_simplex.c set_products 'set_product(s, w, square, &v' 'set_product(s, w, 0, &v' "$open"
fault other-side src/gjk/gjk_simplex.c gjk_simplex_set 's->toward[0][1] > 0 && s->toward[1][0] > 0' 's->toward[0][1] > 0' "$open"
fault vertex-of-a-twice $check load 'certificate->b[i]' 'certificate->a[i]' "$open"
fault high-words-below-0 src/arith/gjk_vector_inline.h gjk_dot_sign 'top < -1 ? -1 : gjk_dot_sign_exact' 'top < 0 ? -1 : gjk_dot_sign_exact' "$open"
fault low-word-of-y src/arith/gjk_vector.c gjk_dot_sign_exact 'gjk_low_balanced(n->z), v->z);' 'gjk_low_balanced(n->z), v->y);' "$open"
fault high-word-of-y src/arith/gjk_vector.c high_bits 'z = gjk_high32(v->z);' 'z = gjk_high32(v->y);' "$open"
fault no-direction-in-a-plane src/arith/gjk_vector.c gjk_search_direction_of_edge 'return (n.x | n.y | n.z) != 0;' 'return (n.x | n.y) != 0;' "$open"
fault square-of-an-edge src/gjk/gjk_simplex.c gjk_simplex_direction 'return s->toward[a][a] != 0;' 'return s->toward[a][b] != 0;' "$open"
fault norm-of-one-core src/gjk/gjk_frame.h gjk_frame_fill '(it->a->core_radius + it->b->core_radius));' '(it->a->core_radius + it->a->core_radius));' "$open"
fault centre-of-y src/gjk/gjk_frame.h gjk_frame_set 'gjk_sar32(a->z, 2) - gjk_sar32(b->z, 2)' 'gjk_sar32(a->z, 2) - gjk_sar32(b->y, 2)' "$open"
fault offset-of-x src/gjk/gjk_frame.h gjk_frame_move 'gjk_shl32(offset.y, shift);' 'gjk_shl32(offset.x, shift);' "$open"
fault digit-of-x src/arith/gjk_wide.c gjk_u192_multiply 'y->limb[j]) + out->limb[i + j];' 'x->limb[j]) + out->limb[i + j];' "$open"
fault near-at-twice src/gjk/gjk_iteration.c gjk_iteration_near '(uint64_t)it->radius * 2)' '(uint64_t)it->radius * 4)' "$open"
fault limit-of-x src/gjk/gjk_frame.c longer_than '(uint32_t)limit, (uint32_t)limit);' '(uint32_t)limit, (uint32_t)x);' "$open"
fault half-too-much src/gjk/gjk_frame.c far_component '((INT64_C(1) << n) >> 1)' '(INT64_C(1) << n)' "$open"
fault flat-tetrahedron src/gjk/gjk_simplex.c gjk_simplex_encloses 'low * high == 0 && low + high != 0' 'low * high == 0' "$open"
fault way-back src/arith/gjk_vector.c gjk_direction_sign 'return direction->opposite ? side : -side;' 'return direction->opposite ? -side : side;' "$open"
fault shares-swapped src/gjk/gjk_simplex.c gjk_simplex_exact_direction 'out->ta = s->toward[a][b];' 'out->ta = s->toward[b][a];' "$open"
fault level-or-before $check none_before 'gjk_direction_sign(direction, &step) > 0' 'gjk_direction_sign(direction, &step) > 1' "$open"
fault b-as-a $check is_support 'direction->opposite = true;' 'direction->opposite = false;' "$open"
fault nearest-at-the-origin $check is_nearest 's->count == 3 && gjk_dot_sign' 's->count == 4 && gjk_dot_sign' "$open"
fault far-at-half src/gjk/gjk_iteration.c gjk_iteration_near '(uint64_t)it->radius * 2)' '(uint64_t)it->radius)' "$open"
fault distance-half-off $check is_rounded '(twice + 1) << it->shift' '(twice + 2) << it->shift' "$open"
fault distance-without-frame $check is_rounded '(twice - 1) << it->shift' '(twice - 1)' "$open"
fault distance-of-any-feature $check gjk_check_distance 'certificate->proof != GJK_PROOF_NEAREST || !is_apart' '!is_apart' "$open"
fault tie-excluded tests/prove/checker/solid.v hull 'Definition above_half (n m f k : Z) := (2 * k - 1) * f * ((2 * k - 1) * f) * m <= 4 * n.' \
  'Definition above_half (n m f k : Z) := (2 * k - 2) * f * ((2 * k - 2) * f) * m <= 4 * n.' '^failed: what holds of vertices'
fault depth-one-less $check is_facet 'compare_to(it, depth) <= 0' 'compare_to(it, depth + 1) <= 0' "$open"
fault facet-inside $check is_facet ' && is_support(it, certificate, &outwards)' '' "$open"
fault level-or-above $check is_level 'farthest(it->b, &opposite) == 0' 'farthest(it->b, &opposite) >= 0' "$open"
fault depth-without-frame $check compare_to '(uint64_t)((uint32_t)d << it->shift) * 2' '(uint64_t)(uint32_t)d * 2' "$open"
fault overlap-not-proven $check intersect 'is_together(&it, &certificate)' 'certificate.count != 0' "$open"
plane=src/plane/gjk2_check.c claim=src/plane/gjk2_claim.c outward=src/plane/gjk2_outward
fault next-is-same $plane plane_lies_from 'gjk_umul32(to, to), more)' 'gjk_umul32(from, from), more)' "$open"
fault depth-of-one-less $plane feature_is_depth '-core, 0);' '-core - 1, 0);' "$open"
fault edge-inside $plane edge_is_depth 'along < 0 || support(s, d) != along' 'along < 0' "$open"
fault edge-of-cores-apart $plane edge_is_depth ' || !cores_intersect(s)' '' "$open"
fault line-or-above $plane line_is_depth 'support(s, d) == 0' 'support(s, d) >= 0' "$open"
fault move-rounded-down $outward.h gjk2_outward_step ' + ((UINT32_C(1) << 30) - 1)' '' "$open"
fault move-from-behind $outward.c gjk2_outward_clears 'gjk2_dot(n, t) - height' 'gjk2_dot(n, t) + height' "$open"
fault normal-of-twice $claim gjk2_claim_normal 'UINT64_C(255) << 29' 'UINT64_C(255) << 30' "$open"
fault normal-backwards $claim plane_same_sign 'u >= 0 : u <= 0' 'u >= 0 : u >= 0' "$open"
fault point-2-beside $claim gjk2_claim_point 'c->shape->convex_radius + 1;' 'c->shape->convex_radius + 2;' "$open"
fault saturated-inside $claim plane_at_end 'coordinate == INT32_MAX' 'coordinate >= 0' "$open"
fault overlap-of-twice $claim gjk2_claim_overlap 'gjk_shl64(depth, 1);' '2 * gjk_shl64(depth, 1);' "$open"
fault gap-of-3 $claim gjk2_claim_gap 'eighths + 16' 'eighths + 24' "$open"
way=src/plane_motion/gjk2_way.c cast=src/plane_motion/gjk2_check_cast.c
fault way-of-a-alone $way gjk2_way_set 'way->t.x = way->of_b.x - way->of_a.x;' 'way->t.x = way->of_b.x;' "$open"
fault centre-in-front $way gjk2_way_may_meet 'ahead > 0 && ahead < gjk2_dot(way->d, way->d)' 'ahead > 0 && ahead < 0' "$open"
fault outermost-inside $way gjk2_way_outermost_of 'if (side > most) {' 'if (side < most) {' "$open"
fault side-of-y $way gjk2_way_side 'gjk_mac32(way->base, way->d.x, o.y)' 'gjk_mac32(way->base, way->d.y, o.y)' "$open"
fault same-side-of-b $cast plane_leaves_beside 'way->b, &way->t, !left,' 'way->b, &way->t, left,' "$open"
fault line-without-sign $cast plane_leaves_beside '(left ? *side < 0 : *side > 0) && gjk2' '*side != 0 && gjk2' "$open"
fault start-alone $cast plane_stays_behind ' && plane_is_behind(most - ahead, n, radius)' '' "$open"
fault vertices-of-a-alone $cast plane_along ' + gjk2_claim_farthest(way->b, gjk2_negate(n))' '' "$open"
fault touching-is-behind $cast plane_is_behind 'height < 0 && radius' 'height <= 0 && radius' "$open"
fault quotient-rounded-up $cast plane_is_quotient 'return high >= 0 &&' 'return high >= -1 &&' "$open"
fault beside-the-edge $cast plane_enters 'side_p > 0 || side_q < 0 || ' 'side_q < 0 || ' "$open"
fault line-before-the-edge $cast plane_enters 'most != gjk2_way_along(way, n, q->o)' 'most < gjk2_way_along(way, n, q->o)' "$open"
fault inside-at-any-gap $cast plane_check_inside 'status != GJK_OK || !decision.yes' 'status != GJK_OK' "$open"
fault hit-is-a-miss $cast gjk2_check_cast 'return result->hit ? GJK_ERROR_UNPROVEN : GJK_OK;' 'return result->hit ? GJK_OK : GJK_ERROR_UNPROVEN;' "$open"
spheres=src/motion/gjk_spheres.c swept=src/motion/gjk_swept.c cast=src/motion/gjk_check_cast.c
fault way-beyond-one-end $spheres is_past 'o > reach || o < t - reach :' 'o > reach || o < t :' "$open"
fault leading-bits-of-x $spheres leading_bits_of 'gjk_shl32((int32_t)v->y, (unsigned)-n);' 'gjk_shl32((int32_t)v->x, (unsigned)-n);' "$open"
fault reach-without-slack $spheres passes '(int32_t)reach1 + 12;' '(int32_t)reach1 - 12;' "$open"
fault limit-rounded-down $spheres passes '2 * z) + 1;' '2 * z) - 1;' "$open"
fault core-of-a-alone $spheres gjk_spheres_part 'radius + a->core_radius + b->core_radius;' 'radius + a->core_radius;' "$open"
fault way-of-b-alone src/motion/gjk_way.c gjk_way_set 'z = of_b.z - of_a.z;' 'z = of_b.z;' "$open"
fault length-too-short $swept half_length '>> 1) + 2);' '>> 1) + 1);' "$open"
fault middle-of-x $swept gjk_swept_set 'ca->y - cb->y + s->back.y' 'ca->y - cb->y + s->back.x' "$open"
fault swept-core-of-b $swept gjk_swept_set 's->swept.core_radius = b->core_radius + length;' 's->swept.core_radius = b->core_radius;' "$open"
fault decision-not-asked $cast prove_within 'status == GJK_OK && decision.yes != within' 'status != GJK_OK' "$open"
fault swept-without-margin $cast check_rounded '&swept.swept, margin, result->hit);' '&swept.swept, 0, result->hit);' "$open"
fault later-at-the-start $cast check_rounded 'prove_within(a, b, margin, false);' 'GJK_OK;' "$open"
fault inside-unproven $cast is_proven ' && prove_start(a, b, 0, result) == GJK_OK;' ';' "$open"
fault end-not-asked tests/prove/checker/hull.v hull 'clear dx dy h r /\ clear dx dy (h - dot dx dy tx ty) r' 'clear dx dy h r' '^failed: what holds of vertices'
fault swept-at-the-start tests/prove/checker/solid.v hull 'v (j - nb)%nat + ahead' 'v (j - nb)%nat + back' '^failed: what holds of vertices'
fault move-other-way tests/prove/checker/hull.v hull 'cleared (dot dx dy tx ty - h)' 'cleared (h - dot dx dy tx ty)' '^failed: what holds of vertices'
fault touching-is-beyond tests/prove/checker/hull.v hull 'Definition farther (s r square : Z) := s * s > r' \
  'Definition farther (s r square : Z) := s * s >= r' '^failed: what holds of vertices'
fault contract-lost tests/prove/checker/plane.h gjk2_reaches \
  '    ensures \result == 0 || \result == 1;
    ensures \result == 1 <==> reaches(h, squared, x, rest); */' '*/' '^no contract: gjk2_reaches'
finish prove-checker-faults
