# For find_package(gjk): the targets gjk::gjk (the archive) and gjk::shared of this installation.
get_filename_component(gjk_prefix "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)
if(NOT TARGET gjk::gjk)
  add_library(gjk::gjk STATIC IMPORTED)
  set_target_properties(gjk::gjk PROPERTIES
    IMPORTED_LOCATION "${gjk_prefix}/lib/libgjk.a"
    INTERFACE_INCLUDE_DIRECTORIES "${gjk_prefix}/include")
endif()
if(NOT TARGET gjk::shared AND EXISTS "${gjk_prefix}/lib/libgjk.so")
  add_library(gjk::shared SHARED IMPORTED)
  set_target_properties(gjk::shared PROPERTIES
    IMPORTED_LOCATION "${gjk_prefix}/lib/libgjk.so"
    INTERFACE_INCLUDE_DIRECTORIES "${gjk_prefix}/include")
endif()
