add_executable(gl_faults_gl_test
  gl_faults_gl_test.cpp
  ../support/faulty_gl.cpp
  ../support/test_context.cpp)
target_link_libraries(gl_faults_gl_test PRIVATE
  rushlight_renderer rushlight_gl_backend ${EGL_LIBRARY} GTest::gtest_main rushlight_options)
gtest_discover_tests(gl_faults_gl_test PROPERTIES TIMEOUT 120)
