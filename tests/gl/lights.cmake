add_executable(lights_gl_test
  light/light_patterns_gl_test.cpp
  light/lights_gl_test.cpp
  ../support/scenes/lit_frame.cpp
  ../support/scenes/lit_plane.cpp
  ../support/gl/test_context.cpp)
target_include_directories(lights_gl_test PRIVATE ${PROJECT_SOURCE_DIR}/shaders)
target_link_libraries(lights_gl_test PRIVATE
  rushlight_renderer ${EGL_LIBRARY} GTest::gtest_main rushlight_options)
gtest_discover_tests(lights_gl_test)
