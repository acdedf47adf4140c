# Rays through scenes, and what is baked by them.
find_package(Threads REQUIRED)
add_executable(raytrace_test
  baked_area_lights_test.cpp
  irradiance_volume_test.cpp
  light_patterns_test.cpp
  probe_bake_test.cpp
  ray_scene_test.cpp)
target_link_libraries(raytrace_test PRIVATE
  rushlight_raytrace rushlight_jobs Threads::Threads GTest::gtest_main rushlight_options)
gtest_discover_tests(raytrace_test)
