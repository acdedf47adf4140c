# Rays through scenes, and what is baked by them.
find_package(Threads REQUIRED)
add_executable(raytrace_test
  raytrace/baked_area_lights_test.cpp
  lighting/irradiance_volume_test.cpp
  lighting/light_patterns_test.cpp
  raytrace/probe_bake_test.cpp
  raytrace/ray_scene_test.cpp)
target_link_libraries(raytrace_test PRIVATE
  rushlight_raytrace rushlight_jobs Threads::Threads GTest::gtest_main rushlight_options)
gtest_discover_tests(raytrace_test)
