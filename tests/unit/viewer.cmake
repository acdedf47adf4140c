add_executable(viewer_test
  sandbox/file_watch_test.cpp
  sandbox/input_script_test.cpp
  sandbox/lamps_test.cpp
  sandbox/square_walk_test.cpp)
target_compile_definitions(viewer_test PRIVATE RUSHLIGHT_CONTENT="${PROJECT_SOURCE_DIR}/content")
target_link_libraries(viewer_test PRIVATE
  rushlight_game rushlight_assets GTest::gtest_main rushlight_options)
gtest_discover_tests(viewer_test)
