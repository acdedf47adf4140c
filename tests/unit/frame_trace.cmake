find_package(nlohmann_json REQUIRED)

add_executable(frame_trace_test capture/frame_trace_test.cpp)
target_link_libraries(frame_trace_test PRIVATE
  rushlight_breakdown nlohmann_json::nlohmann_json GTest::gtest_main rushlight_options)
gtest_discover_tests(frame_trace_test)
