# The frame builder and whole frames, on the null backend.
find_package(Threads REQUIRED)
add_executable(frame_test
  draw_list_test.cpp
  frame_plan_test.cpp
  geometry_store_test.cpp
  light_clusters_test.cpp
  material_store_test.cpp
  shadow_cascades_test.cpp
  view_math_test.cpp
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
target_link_libraries(allocations_test PRIVATE rushlight_renderer GTest::gtest_main rushlight_options)
gtest_discover_tests(allocations_test)
