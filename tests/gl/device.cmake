find_library(EGL_LIBRARY EGL REQUIRED)

add_executable(device_test device/device_gl_test.cpp device/shaders_gl_test.cpp ../support/gl/test_context.cpp)
target_link_libraries(device_test PRIVATE
  rushlight_gl_backend ${EGL_LIBRARY} GTest::gtest_main rushlight_options)
gtest_discover_tests(device_test)

add_executable(played_gl_test device/played_gl_test.cpp ../support/gl/played_gl.cpp ../support/gl/test_context.cpp)
target_link_libraries(played_gl_test PRIVATE
  rushlight_renderer rushlight_gl_backend ${EGL_LIBRARY} GTest::gtest_main rushlight_options)
gtest_discover_tests(played_gl_test)
