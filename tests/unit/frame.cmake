# The frame builder and whole frames, on the null backend.
find_package(Threads REQUIRED)
add_executable(frame_test
  draw_list_test.cpp
  facing_groups_test.cpp
  frame_plan_test.cpp
  geometry_store_test.cpp
  instance_world_test.cpp
  decal_clusters_test.cpp
  light_clusters_test.cpp
  material_store_test.cpp
  mesh_lods_test.cpp
  shadow_cascades_test.cpp
  shadow_lights_test.cpp
  shadow_tiles_test.cpp
  spatial_index_test.cpp
  view_math_test.cpp
  radix_sort_test.cpp
  visibility_test.cpp
  whole_frame_test.cpp
  ../support/random_scene.cpp)
target_link_libraries(frame_test PRIVATE
  rushlight_renderer rushlight_null_backend Threads::Threads GTest::gtest_main rushlight_options)
gtest_discover_tests(frame_test)

# On its own: it replaces the global operator new.
add_executable(allocations_test
  allocations_test.cpp
  ../support/allocation_counter.cpp
  ../support/random_scene.cpp)
target_link_libraries(allocations_test PRIVATE
  rushlight_renderer Threads::Threads GTest::gtest_main rushlight_options)
gtest_discover_tests(allocations_test)

# On its own, as it is what the preset tsan is for.
add_executable(render_thread_test
  render_thread_test.cpp
  ../support/random_scene.cpp)
target_link_libraries(render_thread_test PRIVATE
  rushlight_renderer rushlight_null_backend Threads::Threads GTest::gtest_main rushlight_options)
gtest_discover_tests(render_thread_test)
