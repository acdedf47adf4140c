# The frame builder and whole frames, on the null backend.
find_package(Threads REQUIRED)
add_executable(frame_test
  visibility/draw_list_test.cpp
  geometry/facing_groups_test.cpp
  pipeline/frame_plan_test.cpp
  geometry/geometry_store_test.cpp
  visibility/instance_world_test.cpp
  lighting/decal_clusters_test.cpp
  lighting/light_clusters_test.cpp
  geometry/material_store_test.cpp
  geometry/mesh_lods_test.cpp
  shadows/shadow_cascades_test.cpp
  shadows/shadow_lights_test.cpp
  shadows/shadow_tiles_test.cpp
  visibility/spatial_index_test.cpp
  geometry/view_math_test.cpp
  visibility/radix_sort_test.cpp
  visibility/visibility_test.cpp
  pipeline/turning_test.cpp
  pipeline/whole_frame_test.cpp
  ../support/scenes/random_scene.cpp)
target_link_libraries(frame_test PRIVATE
  rushlight_renderer rushlight_null_backend Threads::Threads GTest::gtest_main rushlight_options)
gtest_discover_tests(frame_test)

# On its own: it replaces the global operator new.
add_executable(allocations_test
  pipeline/allocations_test.cpp
  ../support/allocation_counter.cpp
  ../support/scenes/random_scene.cpp)
target_link_libraries(allocations_test PRIVATE
  rushlight_renderer Threads::Threads GTest::gtest_main rushlight_options)
gtest_discover_tests(allocations_test)

# On its own, as it is what the preset tsan is for.
add_executable(render_thread_test
  pipeline/render_thread_test.cpp
  ../support/scenes/random_scene.cpp)
target_link_libraries(render_thread_test PRIVATE
  rushlight_renderer rushlight_null_backend Threads::Threads GTest::gtest_main rushlight_options)
gtest_discover_tests(render_thread_test)
