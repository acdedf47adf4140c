find_package(Threads REQUIRED)

# One process: its scenes share their programs, which take longer than their pictures.
add_executable(metamorphic_gl_test
  frame/metamorphic_gl_test.cpp
  frame/metamorphic_light_gl_test.cpp
  ../support/scenes/metamorphic.cpp
  ../support/scenes/random_scene.cpp
  ../support/gl/test_context.cpp
  ../support/scenes/varied_scene.cpp)
target_link_libraries(metamorphic_gl_test PRIVATE
  rushlight_renderer Threads::Threads ${EGL_LIBRARY} GTest::gtest_main rushlight_options)
add_test(NAME metamorphic_gl_test COMMAND metamorphic_gl_test)
set_tests_properties(metamorphic_gl_test PROPERTIES TIMEOUT 120)
