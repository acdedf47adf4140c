find_library(EGL_LIBRARY EGL REQUIRED)
find_package(Threads REQUIRED)
find_package(nlohmann_json REQUIRED)

add_executable(breakdown_gl_test
  frame/breakdown_gl_test.cpp
  ../support/scenes/lit_frame.cpp
  ../support/scenes/random_scene.cpp
  ../support/gl/test_context.cpp)
target_link_libraries(breakdown_gl_test PRIVATE
  rushlight_breakdown rushlight_gl_backend Threads::Threads ${EGL_LIBRARY} GTest::gtest_main rushlight_options)
gtest_discover_tests(breakdown_gl_test PROPERTIES TIMEOUT 3600)

add_executable(breakdown_cli_gl_test cli/breakdown_cli_gl_test.cpp)
target_compile_definitions(breakdown_cli_gl_test PRIVATE
  RUSHLIGHT_TOOL="$<TARGET_FILE:rushlight>" RUSHLIGHT_SOURCE="${PROJECT_SOURCE_DIR}")
target_link_libraries(breakdown_cli_gl_test PRIVATE
  rushlight_core nlohmann_json::nlohmann_json GTest::gtest_main rushlight_options)
add_dependencies(breakdown_cli_gl_test rushlight)
gtest_discover_tests(breakdown_cli_gl_test PROPERTIES TIMEOUT 3600)
