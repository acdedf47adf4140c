find_package(Threads REQUIRED)
add_executable(reflection_probes_gl_test light/reflection_probes_gl_test.cpp ../support/gl/test_context.cpp)
target_link_libraries(reflection_probes_gl_test PRIVATE
  rushlight_renderer Threads::Threads ${EGL_LIBRARY} GTest::gtest_main rushlight_options)
gtest_discover_tests(reflection_probes_gl_test PROPERTIES TIMEOUT 3600)

find_package(nlohmann_json REQUIRED)
add_executable(surroundings_cli_gl_test cli/surroundings_cli_gl_test.cpp)
target_compile_definitions(surroundings_cli_gl_test PRIVATE
  RUSHLIGHT_TOOL="$<TARGET_FILE:rushlight>" RUSHLIGHT_SOURCE="${PROJECT_SOURCE_DIR}")
target_link_libraries(surroundings_cli_gl_test PRIVATE
  rushlight_testing nlohmann_json::nlohmann_json GTest::gtest_main rushlight_options)
add_dependencies(surroundings_cli_gl_test rushlight)
gtest_discover_tests(surroundings_cli_gl_test PROPERTIES TIMEOUT 3600)

add_executable(probe_bounces_gl_test
  light/probe_bounces_gl_test.cpp
  ../support/scenes/lit_frame.cpp
  ../support/gl/test_context.cpp)
target_link_libraries(probe_bounces_gl_test PRIVATE
  rushlight_scene_bridge rushlight_assets rushlight_gl_backend nlohmann_json::nlohmann_json ${EGL_LIBRARY}
  GTest::gtest_main rushlight_options)
gtest_discover_tests(probe_bounces_gl_test)
