add_executable(lighting_test
  area_lights_test.cpp
  brdf_test.cpp
  occlusion_arc_test.cpp
  encode_test.cpp
  environment_import_test.cpp
  environment_test.cpp
  sky_test.cpp
  tonemap_test.cpp)
target_link_libraries(lighting_test PRIVATE
  rushlight_lighting rushlight_jobs rushlight_options GTest::gtest_main)
gtest_discover_tests(lighting_test)
