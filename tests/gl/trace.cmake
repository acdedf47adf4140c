find_package(nlohmann_json REQUIRED)

add_executable(trace_cli_gl_test cli/trace_cli_gl_test.cpp)
target_compile_definitions(trace_cli_gl_test PRIVATE
  RUSHLIGHT_TOOL="$<TARGET_FILE:rushlight>" RUSHLIGHT_SOURCE="${PROJECT_SOURCE_DIR}")
target_link_libraries(trace_cli_gl_test PRIVATE
  rushlight_core nlohmann_json::nlohmann_json GTest::gtest_main rushlight_options)
add_dependencies(trace_cli_gl_test rushlight)
gtest_discover_tests(trace_cli_gl_test PROPERTIES TIMEOUT 3600)
