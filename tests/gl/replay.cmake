find_library(EGL_LIBRARY EGL REQUIRED)

add_executable(replay_gl_test
  frame/replay_gl_test.cpp
  ../support/scenes/random_scene.cpp
  ../support/gl/test_context.cpp)
target_compile_definitions(replay_gl_test PRIVATE RUSHLIGHT_SOURCE="${PROJECT_SOURCE_DIR}")
target_link_libraries(replay_gl_test PRIVATE
  rushlight_replay rushlight_gl_backend rushlight_testing
  ${EGL_LIBRARY} GTest::gtest_main rushlight_options)
gtest_discover_tests(replay_gl_test PROPERTIES TIMEOUT 3600)

add_executable(replay_cli_gl_test cli/replay_cli_gl_test.cpp)
target_compile_definitions(replay_cli_gl_test PRIVATE
  RUSHLIGHT_TOOL="$<TARGET_FILE:rushlight>" RUSHLIGHT_SOURCE="${PROJECT_SOURCE_DIR}")
target_link_libraries(replay_cli_gl_test PRIVATE rushlight_core GTest::gtest_main rushlight_options)
add_dependencies(replay_cli_gl_test rushlight)
gtest_discover_tests(replay_cli_gl_test PROPERTIES TIMEOUT 3600)

add_executable(sequence_cli_gl_test cli/sequence_cli_gl_test.cpp ../support/scenes/moving_scene.cpp)
target_compile_definitions(sequence_cli_gl_test PRIVATE
  RUSHLIGHT_TOOL="$<TARGET_FILE:rushlight>" RUSHLIGHT_SOURCE="${PROJECT_SOURCE_DIR}")
target_link_libraries(sequence_cli_gl_test PRIVATE
  rushlight_capture nlohmann_json::nlohmann_json GTest::gtest_main rushlight_options)
add_dependencies(sequence_cli_gl_test rushlight)
gtest_discover_tests(sequence_cli_gl_test PROPERTIES TIMEOUT 3600)
