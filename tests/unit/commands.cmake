find_package(hwy REQUIRED)
add_executable(half_floats_test rhi/half_floats_test.cpp)
target_link_libraries(half_floats_test PRIVATE
  rushlight_half_floats hwy::hwy GTest::gtest_main rushlight_options)
gtest_discover_tests(half_floats_test)

add_executable(commands_test rhi/commands_test.cpp)
target_link_libraries(commands_test PRIVATE
  rushlight_null_backend GTest::gtest_main rushlight_options)
gtest_discover_tests(commands_test)

# Frames as values: files, comparison, validation, replay.
add_executable(frame_file_test rhi/frame_file_test.cpp rhi/validate_commands_test.cpp)
target_link_libraries(frame_file_test PRIVATE
  rushlight_replay rushlight_null_backend GTest::gtest_main rushlight_options)
gtest_discover_tests(frame_file_test)
