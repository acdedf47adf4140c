add_executable(cameras_test
  cameras_test.cpp
  character_test.cpp
  closest_test.cpp
  frame_clock_test.cpp
  input_test.cpp
  triangle_grid_test.cpp)
target_link_libraries(cameras_test PRIVATE
  rushlight_cameras rushlight_input rushlight_physics rushlight_time
  GTest::gtest_main rushlight_options)
gtest_discover_tests(cameras_test)
