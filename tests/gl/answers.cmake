find_library(EGL_LIBRARY EGL REQUIRED)

add_executable(explain_gl_test
  frame/explain_gl_test.cpp
  ../support/scenes/lit_frame.cpp
  ../support/gl/test_context.cpp)
target_compile_definitions(explain_gl_test PRIVATE RUSHLIGHT_SOURCE="${PROJECT_SOURCE_DIR}")
target_link_libraries(explain_gl_test PRIVATE
  rushlight_answers rushlight_testing ${EGL_LIBRARY}
  GTest::gtest_main rushlight_options)
gtest_discover_tests(explain_gl_test PROPERTIES TIMEOUT 3600)

add_executable(diagnose_gl_test
  frame/diagnose_gl_test.cpp
  ../support/scenes/faulty_frames.cpp
  ../support/scenes/lit_frame.cpp
  ../support/gl/test_context.cpp)
target_link_libraries(diagnose_gl_test PRIVATE
  rushlight_answers ${EGL_LIBRARY} GTest::gtest_main rushlight_options)
gtest_discover_tests(diagnose_gl_test PROPERTIES TIMEOUT 3600)

find_package(nlohmann_json REQUIRED)
add_executable(answers_cli_gl_test cli/answers_cli_gl_test.cpp)
target_compile_definitions(answers_cli_gl_test PRIVATE
  RUSHLIGHT_TOOL="$<TARGET_FILE:rushlight>" RUSHLIGHT_SOURCE="${PROJECT_SOURCE_DIR}")
target_link_libraries(answers_cli_gl_test PRIVATE
  rushlight_core GTest::gtest_main nlohmann_json::nlohmann_json rushlight_options)
add_dependencies(answers_cli_gl_test rushlight)
gtest_discover_tests(answers_cli_gl_test PROPERTIES TIMEOUT 3600)
