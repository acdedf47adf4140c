find_library(EGL_LIBRARY EGL REQUIRED)

add_executable(irradiance_gl_test light/irradiance_gl_test.cpp ../support/scenes/lit_frame.cpp
  ../support/gl/test_context.cpp)
target_link_libraries(irradiance_gl_test PRIVATE
  rushlight_renderer ${EGL_LIBRARY} GTest::gtest_main rushlight_options)
gtest_discover_tests(irradiance_gl_test)

add_executable(bake_cli_gl_test cli/bake_cli_gl_test.cpp)
target_compile_definitions(bake_cli_gl_test PRIVATE
  RUSHLIGHT_TOOL="$<TARGET_FILE:rushlight>" RUSHLIGHT_SOURCE="${PROJECT_SOURCE_DIR}")
target_link_libraries(bake_cli_gl_test PRIVATE rushlight_core GTest::gtest_main rushlight_options)
add_dependencies(bake_cli_gl_test rushlight)
gtest_discover_tests(bake_cli_gl_test PROPERTIES TIMEOUT 3600)
