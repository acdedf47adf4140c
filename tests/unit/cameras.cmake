add_executable(cameras_test
  engine/cameras_test.cpp
  engine/character_test.cpp
  engine/closest_test.cpp
  engine/frame_clock_test.cpp
  engine/input_test.cpp
  engine/triangle_grid_test.cpp)
target_link_libraries(cameras_test PRIVATE
  rushlight_cameras rushlight_input rushlight_physics rushlight_time
  GTest::gtest_main rushlight_options)
gtest_discover_tests(cameras_test)
