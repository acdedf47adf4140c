add_executable(lighting_test
  lighting/area_lights_test.cpp
  lighting/brdf_test.cpp
  lighting/occlusion_arc_test.cpp
  lighting/encode_test.cpp
  lighting/environment_import_test.cpp
  lighting/environment_test.cpp
  lighting/sky_test.cpp
  lighting/tonemap_test.cpp)
target_link_libraries(lighting_test PRIVATE
  rushlight_lighting rushlight_jobs rushlight_options GTest::gtest_main)
gtest_discover_tests(lighting_test)
