find_package(Threads REQUIRED)
add_executable(gl_faults_gl_test
  device/gl_faults_gl_test.cpp
  ../support/gl/faulty_gl.cpp
  ../support/gl/test_context.cpp)
target_link_libraries(gl_faults_gl_test PRIVATE
  rushlight_renderer rushlight_gl_backend Threads::Threads ${EGL_LIBRARY} GTest::gtest_main rushlight_options)
gtest_discover_tests(gl_faults_gl_test PROPERTIES TIMEOUT 3600)

add_executable(faults_cli_gl_test cli/faults_cli_gl_test.cpp)
target_compile_definitions(faults_cli_gl_test PRIVATE
  RUSHLIGHT_TOOL="$<TARGET_FILE:rushlight>" RUSHLIGHT_SOURCE="${PROJECT_SOURCE_DIR}")
target_link_libraries(faults_cli_gl_test PRIVATE rushlight_core GTest::gtest_main rushlight_options)
add_dependencies(faults_cli_gl_test rushlight)
gtest_discover_tests(faults_cli_gl_test PROPERTIES TIMEOUT 3600)
