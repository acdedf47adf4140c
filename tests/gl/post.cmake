find_library(EGL_LIBRARY EGL REQUIRED)

add_executable(post_gl_test screen/post_gl_test.cpp ../support/gl/test_context.cpp)
target_link_libraries(post_gl_test PRIVATE
  rushlight_passes rushlight_gl_backend ${EGL_LIBRARY} GTest::gtest_main rushlight_options)
gtest_discover_tests(post_gl_test)
