find_package(Threads REQUIRED)

add_executable(metamorphic_gl_test
  frame/metamorphic_gl_test.cpp
  frame/metamorphic_light_gl_test.cpp
  ../support/scenes/metamorphic.cpp
  ../support/scenes/random_scene.cpp
  ../support/gl/test_context.cpp
  ../support/scenes/varied_scene.cpp)
target_link_libraries(metamorphic_gl_test PRIVATE
  rushlight_renderer Threads::Threads ${EGL_LIBRARY} GTest::gtest_main rushlight_options)
gtest_discover_tests(metamorphic_gl_test PROPERTIES TIMEOUT 3600)
