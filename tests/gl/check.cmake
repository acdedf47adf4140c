add_executable(check_cli_gl_test cli/check_cli_gl_test.cpp)
target_compile_definitions(check_cli_gl_test PRIVATE
  RUSHLIGHT_TOOL="$<TARGET_FILE:rushlight>" RUSHLIGHT_SOURCE="${PROJECT_SOURCE_DIR}")
target_link_libraries(check_cli_gl_test PRIVATE rushlight_capture GTest::gtest_main rushlight_options)
add_dependencies(check_cli_gl_test rushlight)
gtest_discover_tests(check_cli_gl_test)
