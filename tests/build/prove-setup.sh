# The runs of the proof, and what each analyses with which options: for prove.sh.

# What has a contract instead of a body, but in the driver of the bodies.
CONTRACTS=gjk_add,gjk_sub,gjk_negate,gjk_clz32,gjk_clz64,gjk_mul32,gjk_umul32,gjk_mac32,gjk_dot,gjk_cross,gjk_triangle_normal,gjk_reciprocal,\
gjk_reciprocal_root,gjk_unit,gjk_copy,gjk_height_key

# The same for the drivers of the plane.
PLANE_CONTRACTS=gjk_clz32,gjk_clz64,gjk_mul32,gjk_umul32,gjk_mac32,gjk2_inverse_root,gjk_reciprocal_root
PLANE_LEVELS=main:50,gjk2_search_start:100,start_far:100,gjk2_frame_far:10,framed:10,gjk2_hull_neighbour:300,gjk2_hull_corner:300,gjk2_collider_init:100,gjk2_polygon_order:200

# The split and the number of states kept apart: enough for zero false alarms about initialisation and indices.
QUERY_LEVELS=gjk_iteration_run:300,main:200,ask:200,gjk_penetration:500,gjk_signed_distance:500,report_depth:100,\
ask_penetration:500,ask_signed:500,gjk_distance:200,run_and_narrow:200,narrow:200,\
gjk_distance_until:100,gjk_distance_report:100,stop_early:100,load:100,is_nearest:100,is_facet:100,none_before:100
ITERATION_LEVELS=gjk_simplex_add:50,any_feature:20,confirm_feature:300,refine_nearest:100,gjk_iteration_run:4,add_vertex:300,warm_start:1000,\
gjk_iteration_start:100,gjk_frame_set:100,gjk_frame_set_far:100,main:150,longer_than:50,far_shift:50,run:100
ITERATION_RETURNS=gjk_iteration_start:0,gjk_frame_set:0,gjk_frame_set_far:0,longer_than:0
SEARCH_LEVELS=main:20,seen_vertices_of:20,gjk_simplex_add:10,gjk_iteration_run:10,add_farthest_seen:4,nearest_of_seen:4,try_chain:4,\
try_all_chains:4,mark_and_recall:4,gjk_search_on:4
EPA_HULL_LEVELS=write_horizon:200,gjk_epa_hull_add:500,connect_horizon:1000,add:1000,check_polytope:100,gjk_epa_hull_lowest:50
TABLE_LEVELS=main:50,gjk_hull_table_check:20,gjk_hull_table_make:20,gjk_table_measure:20
BOX_SAT_LEVELS=gjk_box_sat:1000,run:100
MANIFOLDS_LEVELS=keep_contacts:50,join_manifold:20,reduce_manifold:20,take_manifold:50,join_parts:50,join_part:50,find_numbers:50,finish_manifolds:50,\
report_manifolds:50,gjk_parts_manifolds:50,gjk_parts_both_manifolds:50,main:50,ask:50
CAST_LEVELS=main:50,ask:100,gjk_parts_cast:200,gjk_parts_both_cast:200,gjk_parts_cast_ray:200,gjk_parts_both_open:100,set_way_of_a:100,\
cast_against:200,cast_part:100,start_region:100,gjk_parts_frame_set:50
SHAPE_LEVELS=measure_vertices:2,size_of:1,bound_vertices:2,gjk_collider_aabb:4,support_axes:8,turned_vertex:8,refine_axes:8,\
refine_posed:60,refine_lazy:60,support_lazy:20
SURFACE_LEVELS=gjk_surface_settle:2,gjk_face_is_aside:2,gjk_face_is_pierced:2,gjk_face_is_pointed:2,gjk_face_is_over:2,gjk_face_set:10,\
gjk_face_turn:2,relate:2,relate_axis:2,moved_along:2,pulled:2,has_corner:2,reaches_deepest:2,corners_that_meet:8,is_beyond_plane:2
POLYGON_LEVELS=load_face:2,is_broad:2,set_polygon_normal:2,gjk_polygon_from_hull:20,gjk_polygon_settle:20,keep_edge:4,gjk_polygon_lift:2,\
lift_face:4,lift_edge:4,finish_polygon:20,gjk_contact_polygon:20,check_polygon:20,ask:20
IMPACT_LEVELS=gjk_time_of_impact:100,gjk_impact_of_carried:100,start_mover:100,start_impact:100,advance_impact:4,next_x:4,carrier_of:8,pose_both:4
SIMPLEX_LEVELS=check_feature:300,run:300,named:300,gjk_simplex_set:100,set_triangle:100,gjk_simplex_add:100,set_visible:100,add_to_edge:100

# The outcomes of a call kept apart by its last branch, so that what a check found of an index is known after it.
SCENE_LEVELS=main:100,any_scene:0,gjk_scene_init:100,gjk_scene_attach:100,gjk_scene_view_of:100,\
gjk_scene_check_header:100,gjk_scene_check:100,check_pair:50,check_link:50,check_inner:50,check_entry:50,check_pose:30,\
gjk_collider_init:30,query_near:50,within_margins:50

ADD_LEVELS=any_scene:10,add:50,gjk_scene_add:50,gjk_scene_add_at:50,add_to_slot:50,check_setup:50
MOTION_LEVELS=main:20,any_scene:10,gjk_scene_init:20,gjk_scene_update_slice:20,update_all:20

cases() {
  echo primitives-x
  echo pose-x
  echo math-x
  echo joint-x
  for kind in POINT SEGMENT TRIANGLE BOX BAKED LAZY TABLE TABLE_LAZY CYLINDER CONE ELLIPSOID CUSTOM; do
    echo shape-$kind
  done
  for level in 0 1 4; do
    echo hull_table-$level
  done
  for count in 1 4 5; do
    echo hull_build-$count
  done
  echo hull_grow-5
  for dimension in 1 2 3; do
    echo hull_facets-$dimension
  done
  for faces in 0 1; do
    echo hull_check-$faces
  done
  for call in PLAIN ROUND FACES ADD PRINCIPAL; do
    echo mass-$call
  done
  for call in BUILD CHECK WALK FIELD; do
    echo mesh-$call
  done
  echo big-x
  echo region-x
  for query in NEAR DISTANCE DEPTH CONTACTS MANIFOLDS CAST IMPACT; do
    echo parts-$query
    echo parts-BOTH_$query
  done
  for query in RAY CAST_AHEAD IMPACT_AHEAD DRAW; do
    echo parts-$query
  done
  for case in LIST TREE CLASS; do
    echo compound-$case
  done
  for call in CONTACTS SETTLE; do
    echo surface-$call
  done
  echo bind-x
  echo quotient-x
  echo way-x
  echo swept-x
  echo motion-x
  echo integrate-x
  for kinds in 0 1; do
    echo gap-$kinds
    echo advance-$kinds
  done
  echo portal-FIND
  echo portal-CHECK
  for query in CAST RAY CHECK; do
    echo cast-$query
  done
  for kinds in 0 1 2; do
    echo separation-$kinds
  done
  for kinds in 0 1; do
    echo impact-$kinds
  done
  for count in 0 1 2 3 4; do
    echo simplex-$count
  done
  for goal in DISTANCE WITHIN DEPTH SIGNED; do
    echo iteration-GJK_GOAL_$goal
  done
  for count in 1 2 3; do
    echo search-$count
    echo witness-$count
  done
  echo search-CANONICAL
  for kind in SMOOTH POINT SEGMENT BOX TRIANGLE HULL CYLINDER CONE; do
    echo polygon-$kind
  done
  for faces in 0 1 2 3; do
    echo clip-$faces
  done
  echo reduce-x
  for case in 0 1 2; do
    echo facet-$case
    echo epa_hull-$case
  done
  for count in 0 1 3; do
    echo box_sat-$count
  done
  for count in 1 2 3 4; do
    echo epa-$count
  done
  echo contacts-x
  for query in INTERSECT WITHIN WITHIN_UNTIL DISTANCE UNTIL PENETRATION SIGNED CHECK_DECISION CHECK_DISTANCE \
    CHECK_PENETRATION; do
    echo query-$query
  done
  plane_cases
  for bytes in HEADER INIT OPEN; do
    echo scene_block-$bytes
  done
  for call in ADD REMOVE MOVE SHAPE FIELDS BEGIN TEST FINISH REPORT HASH READ; do
    echo scene_ops-$call
  done
  for call in INSERT TAKE BOX RAY NEAREST PASSAGE; do
    echo scene_tree-$call
  done
  for call in CAST CASTS RAY RAYS WITHIN; do
    echo scene_probe-$call
  done
  for call in SET SWEEP TESTING REPORTING; do
    echo scene_motion-$call
  done
  echo scene_slide-x
}

# The levels of those functions that the run's sources have.
plane_levels() {
  files=$sources
  for model in $models; do
    files=$(echo "$files" | sed "s|src/plane/gjk2_${model#plane_}\(_frame\)\?\.c||g")
  done
  # shellcheck disable=SC2086
  found=$(grep -ohE "[ *]($(echo "$PLANE_LEVELS" | sed 's/:[0-9]*//g; s/,/|/g'))\(.*\{\$" $files "tests/prove/$driver.c" |
    sed 's/(.*//; s/^.//' | tr '\n' ' ')
  levels=
  for level in $(echo "$PLANE_LEVELS" | tr , ' '); do
    case " $found" in *" ${level%:*} "*) levels=$levels,$level ;; esac
  done
  echo "${levels#,}"
}

plane_cases() {
  echo plane_pose-x
  echo plane_measure-x
  echo plane_polygon-1
  echo plane_polygon-4
  for kind in POINT SEGMENT BOX TRIANGLE BAKED LAZY ELLIPSE CUSTOM; do
    echo plane_shape-$kind
  done
  for goal in GJK2_GOAL_DISTANCE GJK2_GOAL_WITHIN GJK2_GOAL_DEPTH GJK2_GOAL_SIGNED EDGES CURVED; do
    echo plane_search-$goal
  done
  for ask in SET ASK ENTRY RATIO; do
    echo plane_way-$ask
  done
  for query in CAST RAY CHECK; do
    echo plane_cast-$query
  done
  for kinds in 0 1 2; do
    echo plane_advance-$kinds
  done
  echo plane_face-0
  echo plane_face-1
  for kind in CHAIN HEIGHTS TILES; do
    echo plane_ground-$kind
  done
  echo plane_sweep-x
  echo plane_impact-0
  echo plane_impact-1
  for query in WITHIN WITHIN_UNTIL DISTANCE_CURVED DISTANCE_MIXED DISTANCE_POLYGONS UNTIL PENETRATION SIGNED_CURVED SIGNED_MIXED \
    SIGNED_POLYGONS CHECK_DECISION CHECK_DISTANCE CHECK_PENETRATION; do
    echo plane_query-$query
  done
  echo plane_contacts-x
}

# int32: a 32-bit machine with a long multiplication; int16: an int of 16 bits, products in halves.
runs() {
  cases | sed 's/$/-int32/'
  cases | sed 's/$/-int16/'
}

# room ROOM NAME...: what is named gjk_NAME.c in src/ROOM joins the sources.
room() {
  folder=src/$1
  shift
  for part in "$@"; do
    sources="$sources $folder/gjk_$part.c"
  done
}

# The same of gjk2_NAME.c in src/plane.
plane() {
  for part in "$@"; do
    sources="$sources src/plane/gjk2_$part.c"
  done
}

# copies BODY or WHOLE: gjk_copy has no contract, but its body, or is an assignment: see contracts.h.
copies() {
  contracts=$(echo "$contracts" | sed 's/,gjk_copy//')
  defines="$defines -DPROVE_COPY_$1"
}

# set_up RUN: sets the files that it analyses, contracts, machine, defines and options. joined: Frama-C reads those of src as one
# file, which takes a quarter of the time.
set_up() {
  driver=${1%%-*}
  variant=${1##*-}
  instance=${1#*-}
  instance=${instance%-*}
  defines="-DCASE=$instance"
  sources=
  joined=
  case $variant in
    int16) machine=gcc_x86_16 defines="$defines -DGJK_NARROW_MULTIPLY=1" ;;
    *) machine=gcc_x86_32 ;;
  esac
  models=
  contracts="-eva-use-spec $CONTRACTS"
  case $driver in
    primitives) contracts= && room arith vector && set -- "$1" -eva-slevel 200 ;;
    pose) room arith root rotation && room place angle pose && set -- "$1" -eva-slevel 200 ;;
    joint) room arith root rotation && room place joint pose && set -- "$1" -eva-slevel 200 ;;
    math) room arith number root rotation && room place aim math pose && set -- "$1" -eva-slevel 5 ;;
    polygon)
      sources=$(echo src/contact/gjk_*polygon*.c)
      room arith height_key root rotation unit vector wide && room shape curved disc_base && set -- "$1" -eva-slevel 200
      [ "$instance" != HULL ] || set -- "$@" -eva-min-loop-unroll 12 -eva-slevel-function "$POLYGON_LEVELS"
      ;;
    witness) models=simplex && room arith wide && room gjk witness && set -- "$1" -eva-slevel 200 ;;
    query)
      sources=$(echo src/query/*.c | sed 's|src/query/gjk_contacts[.]c||')
      room arith root unit vector wide
      models='simplex iteration search witness box_sat facet epa'
      levels=$QUERY_LEVELS
      [ "$instance" != PENETRATION ] || levels=$(echo "$levels" | sed 's/gjk_penetration:500/gjk_penetration:50/')
      set -- "$1" -eva-slevel 50 -eva-slevel-function "$levels" -eva-interprocedural-splits \
        -eva-partition-value facet_is_found
      ;;
    iteration)
      models=simplex && room arith vector wide && room gjk frame iteration
      # The outcomes of its steps are too many to keep apart.
      set -- "$1" -eva-slevel 10 -eva-slevel-function "$ITERATION_LEVELS" \
        -eva-split-return-function "$ITERATION_RETURNS"
      ;;
    search)
      models='simplex iteration' && room arith vector wide && room gjk search
      # The outcomes of its steps are too many to keep apart.
      set -- "$1" -eva-slevel 0 -eva-slevel-function "$SEARCH_LEVELS" -eva-split-return-function seen_vertices_of:0 \
        -eva-auto-loop-unroll 8
      ;;
    scene_*)
      joined=1
      # Without what has drivers of its own.
      others=motion,impact,slide,ray,cast,inquiry,passage,within
      models='scene scene_tree'
      case $driver in
        scene_block) models=scene ;;
        scene_tree) models=scene others=$(echo $others | sed 's/passage,//') ;;
        scene_probe) models="$models scene_passage scene_travel" others=motion,impact,slide ;;
        scene_motion) models="$models scene_passage scene_travel scene_events" others=events,report,${others#motion,impact,} ;;
        scene_slide) models="$models scene_cast scene_travel" others=$(echo $others | sed 's/slide,//') ;;
      esac
      sources="$(printf '%s ' src/scene/*.c src/scene_update/*.c src/scene_query/*.c | tr ' ' '\n' | grep -vE "_($(echo "$others" | tr , '|'))[.]c" | tr '\n' ' ') src/arith/gjk_root.c src/query/gjk_status.c src/arith/gjk_wide.c"
      copies WHOLE
      levels=$SCENE_LEVELS
      case $driver in
        scene_probe) levels=$levels,start_cast:50,gjk_scene_cast_near:50,gjk_scene_cast_all:50,gjk_scene_query_within:50 ;;
        scene_slide) levels=$levels,gjk_slide:30,check_slide:50 ;;
      esac
      set -- "$1" -eva-slevel 12 -eva-slevel-function "$levels" -eva-interprocedural-splits -eva-ilevel 64 \
        -eva-auto-loop-unroll 8
      # The outcomes of a sweep are too many to keep apart, those of an addition and of events with what led to them.
      case $driver-$instance in
        scene_motion-*) set -- "$1" -eva-slevel 2 -eva-slevel-function "$MOTION_LEVELS" -eva-auto-loop-unroll 4 ;;
        scene_ops-ADD) set -- "$@" -eva-slevel-function "$ADD_LEVELS" ;;
        scene_ops-FINISH) set -- "$@" -eva-slevel 2 -eva-slevel-function any_scene:10,report:30,gjk_scene_update_slice:30 ;;
        *) set -- "$@" -eva-partition-history 1 -eva-interprocedural-history ;;
      esac
      ;;
    plane_*)
      sources=$(echo src/plane/*.c src/arith/gjk_root.c src/arith/gjk_wide.c)
      contracts="-eva-use-spec $PLANE_CONTRACTS"
      level=50
      moved="src/plane/gjk2_measure.c src/plane/gjk2_collider.c src/arith/gjk_root.c src/arith/gjk_wide.c \
        src/plane_motion/gjk2_way.c"
      case $1 in
        plane_pose*) sources='src/plane/gjk2_angle.c src/plane/gjk2_pose.c src/plane/gjk2_rotation.c' && room arith root ;;
        plane_measure*) sources='src/plane/gjk2_measure.c src/plane/gjk2_outward.c' && room arith root wide ;;
        plane_polygon*) sources='src/plane/gjk2_outline.c src/plane/gjk2_polygon.c' ;;
        plane_way*) level=20 sources="$moved src/plane_motion/gjk2_entry.c" ;;
        plane_cast*)
          level=20 models='plane_distance plane_advance'
          sources="$moved $(echo src/plane_motion/gjk2_cast*.c) src/plane_motion/gjk2_check_cast.c src/plane_motion/gjk2_entry.c \
            src/plane/gjk2_claim.c"
          ;;
        plane_advance*)
          level=2 models='plane_distance plane_face'
          sources="$moved $(echo src/plane_motion/gjk2_cast*.c) src/plane_motion/gjk2_entry.c \
            src/plane_motion/gjk2_advance.c src/plane_motion/gjk2_advance_place.c"
          ;;
        plane_face*)
          level=10 models='plane_distance plane_search'
          sources="$moved src/plane_motion/gjk2_advance_face.c src/plane_motion/gjk2_advance_place.c \
            src/plane/gjk2_canonical.c src/plane/gjk2_hull.c"
          ;;
        plane_ground*)
          level=200
          copies WHOLE
          [ "$instance" != TILES ] || level=5
          kind=$(echo "$instance" | tr '[:upper:]' '[:lower:]')
          sources="src/arith/gjk_root.c src/arith/gjk_wide.c src/plane/gjk2_rotation.c src/ground/gjk2_ground.c \
            src/ground/gjk2_ground_walk.c src/ground/gjk2_ground_$kind.c"
          ;;
        plane_sweep*)
          sources='src/plane_motion/gjk2_integrate.c src/plane_motion/gjk2_sweep.c src/plane_motion/gjk2_way.c'
          plane measure pose rotation && room arith root wide
          ;;
        plane_impact*)
          level=8 models='plane_search plane_edges plane_sweep' sources=$(echo src/plane_motion/gjk2_impact*.c)
          plane canonical collider distance hull measure rotation witness && room arith root wide
          ;;
        plane_search*) level=3 sources= && plane curved_depth edges hull measure search search_frame && room arith root wide ;;
        plane_contacts*)
          level=20 models='plane_search plane_edges plane_meeting' sources=
          plane contacts hull measure && room arith root wide
          ;;
        plane_query*)
          level=8 models='plane_search plane_edges' sources=
          plane canonical check claim distance hull intersect measure meeting outward penetration witness && room arith root wide
          ;;
      esac
      set -- "$1" -eva-slevel $level -eva-slevel-function "$(plane_levels)" -eva-interprocedural-splits
      ;;
    shape)
      models=hull_table sources=$(echo src/shape/*.c | sed 's|src/shape/gjk_hull_table[.]c||')
      room arith root rotation unit vector wide && room place aabb collider && room gjk close simplex
      set -- "$1" -eva-slevel 200
      # Which vertices or half axes bound a box, and which are as far, is too much to keep apart.
      case $instance in BOX | BAKED) set -- "$@" -eva-slevel-function "$SHAPE_LEVELS" ;; esac
      ;;
    hull_table)
      room shape hull_table
      set -- "$1" -eva-slevel 2 -eva-slevel-function "$TABLE_LEVELS" -eva-min-loop-unroll 0 -eva-auto-loop-unroll 8
      ;;
    facet)
      models=simplex contracts=${contracts%,gjk_height_key}
      room arith height_key root unit vector wide && room depth facet
      set -- "$1" -eva-slevel 200 -eva-interprocedural-splits
      ;;
    box_sat)
      models='simplex facet' && room arith root unit vector wide && room depth box_sat box_heights
      copies WHOLE
      set -- "$1" -eva-slevel 2 -eva-slevel-function "$BOX_SAT_LEVELS" -eva-auto-loop-unroll 16 -eva-min-loop-unroll 6 \
        -eva-partition-value facet_is_found
      ;;
    epa_hull)
      room arith height_key vector wide && room depth epa_hull && room gjk simplex
      set -- "$1" -eva-slevel 5 -eva-min-loop-unroll 9 -eva-slevel-function "$EPA_HULL_LEVELS"
      ;;
    epa)
      models='simplex iteration epa_hull facet' && room arith root unit vector wide && room depth epa
      set -- "$1" -eva-slevel 100 -eva-interprocedural-splits -eva-partition-value facet_is_found
      ;;
    contacts)
      models='penetration contact_polygon clip reduce' && room query contacts
      set -- "$1" -eva-slevel 300 -eva-min-loop-unroll 24 -eva-interprocedural-splits
      ;;
    clip)
      level=5
      [ "$instance" != 3 ] || level=1
      room arith vector wide && room contact clip flat && set -- "$1" -eva-slevel $level -eva-min-loop-unroll 24
      ;;
    reduce) room contact reduce && set -- "$1" -eva-slevel 1 -eva-min-loop-unroll 24 ;;
    hull_build | hull_grow | hull_facets | hull_check)
      sources=$(echo src/hull/*.c) && room arith vector wide
      level=50
      case $driver in
        hull_grow) level=2000 ;;
        hull_facets) level=5 ;;
        hull_build) models='hull_grow hull_facets' ;;
      esac
      set -- "$1" -eva-slevel $level
      case $driver in
        hull_check) set -- "$@" -eva-slevel-function main:0,ask:500 ;;
        *) set -- "$@" -eva-interprocedural-splits ;;
      esac
      ;;
    mass)
      # The hull's own work is analysed by hull_facets.
      sources="$(echo src/mass/*.c src/arith/*.c | sed 's|src/mass/gjk_mass_hull[.]c||') src/place/gjk_pose.c src/query/gjk_status.c"
      copies BODY
      [ "$instance" != ROUND ] || models='big big_angle'
      set -- "$1" -eva-slevel 30 -eva-interprocedural-splits
      ;;
    big)
      room arith big big_angle wide
      copies WHOLE
      set -- "$1" -eva-slevel 5
      ;;
    bind)
      # Of the classes only the addresses matter.
      sources=$(echo src/bind/*.c)
      contracts=
      set -- "$1" -eva-slevel 50
      ;;
    mesh)
      sources=$(echo src/mesh/*.c | sed 's|src/mesh/gjk_surface[a-z_]*[.]c||g')
      room arith root rotation vector wide && room parts region
      set -- "$1" -eva-slevel 20 -eva-auto-loop-unroll 8
      ;;
    region)
      room parts region
      set -- "$1" -eva-slevel 200
      ;;
    parts)
      models='region rotation place pairs reduce'
      sources=$(echo src/parts/gjk_parts_*.c src/arith/*.c)
      copies WHOLE
      set -- "$1" -eva-interprocedural-splits -eva-partition-value pairs_results_set
      # Contacts in one place may be any of them: too many outcomes to keep apart.
      case $instance in
        *MANIFOLDS) set -- "$@" -eva-slevel 5 -eva-min-loop-unroll 24 -eva-slevel-function "$MANIFOLDS_LEVELS" ;;
        NEAR | DISTANCE | DEPTH) set -- "$@" -eva-slevel 1000 -eva-partition-history 3 -eva-interprocedural-history ;;
        CAST_AHEAD) set -- "$@" -eva-slevel 10 ;;
        *CAST* | RAY) set -- "$@" -eva-slevel 20 -eva-slevel-function "$CAST_LEVELS" ;;
        BOTH_IMPACT) defines="$defines -DANY_WALK=1" && set -- "$@" -eva-slevel 20 ;;
        BOTH*) set -- "$@" -eva-slevel 20 ;;
        *) set -- "$@" -eva-slevel 100 ;;
      esac
      ;;
    compound)
      models='region place'
      sources=$(echo src/parts/gjk_compound*.c) && room arith root
      set -- "$1" -eva-slevel 500 -eva-interprocedural-splits
      ;;
    surface)
      models='region rotation place pairs manifold'
      sources=$(echo src/mesh/gjk_surface*.c src/mesh/gjk_triangle.c src/parts/gjk_parts_frame.c src/arith/*.c)
      copies WHOLE
      set -- "$1" -eva-slevel 20 -eva-min-loop-unroll 4 -eva-slevel-function "$SURFACE_LEVELS"
      ;;
    quotient) room arith wide && room motion quotient && set -- "$1" -eva-slevel 200 ;;
    way) room motion spheres way && set -- "$1" -eva-slevel 200 ;;
    swept) room arith root vector wide && room motion swept && set -- "$1" -eva-slevel 200 ;;
    motion) room arith root rotation && room motion motion && room place pose && set -- "$1" -eva-slevel 200 ;;
    integrate) room arith root rotation && room motion integrate motion && room place pose && set -- "$1" -eva-slevel 200 ;;
    portal)
      sources=$(echo src/motion/gjk_portal*.c) && room arith vector wide
      set -- "$1" -eva-slevel 30 -eva-interprocedural-splits
      # The outcomes of its turns are too many to keep apart.
      [ "$instance" = CHECK ] || set -- "$1" -eva-slevel 10 -eva-slevel-function grow_portal:2,follow_line:2,look_beyond:2
      ;;
    cast)
      models='portal quotient advance within'
      sources=$(echo src/motion/*cast*.c)
      room motion spheres swept way && room shape class_axes && room arith root unit vector wide
      set -- "$1" -eva-slevel 50 -eva-interprocedural-splits
      ;;
    separation | impact)
      models=motion && room arith root rotation
      case $driver in
        separation) room arith unit vector wide && room motion impact_separation && room place pose && room shape scan ;;
        impact) models='motion impact_separation distance' && room motion impact && room place collider ;;
      esac
      set -- "$1" -eva-slevel 30 -eva-interprocedural-splits
      # The outcomes of its turns are too many to keep apart.
      [ "$driver" = separation ] || set -- "$1" -eva-slevel 30 -eva-slevel-function "$IMPACT_LEVELS"
      ;;
    gap)
      models='simplex iteration search' && room arith root unit wide && room gjk frame && room motion gap
      set -- "$1" -eva-slevel 30 -eva-interprocedural-splits
      ;;
    advance)
      room arith root unit vector wide && room motion advance
      models='simplex gap'
      copies BODY
      set -- "$1" -eva-slevel 30 -eva-interprocedural-splits -eva-warn-copy-indeterminate=-gjk_copy
      ;;
    simplex) room arith vector wide && room gjk simplex && set -- "$1" -eva-slevel 12 -eva-slevel-function "$SIMPLEX_LEVELS" ;;
    *) set -- "$1" -eva-slevel 200 ;;
  esac
  left_out=
  stand_ins=
  for model in $models; do
    case $model in
      plane_*) file=plane/gjk2_${model#plane_} ;;
      *) file="[a-z]*/gjk_$model" ;;
    esac
    left_out="$left_out;s|src/$file\(_frame\)\?\.c||g"
    stand_ins="$stand_ins tests/prove/${model}_model.c"
  done
  [ -z "$models" ] || sources=$(echo "$sources" | sed "${left_out#;}")
  sources="$sources$stand_ins tests/prove/$driver.c"
  shift
  options=$*
}
