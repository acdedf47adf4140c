find_package(Threads REQUIRED)

# One process: its scenes share their programs, which take longer than their pictures.
add_executable(metamorphic_gl_test
  metamorphic_gl_test.cpp
  metamorphic_light_gl_test.cpp
  ../support/metamorphic.cpp
  ../support/random_scene.cpp
  ../support/test_context.cpp
  ../support/varied_scene.cpp)
target_link_libraries(metamorphic_gl_test PRIVATE
  rushlight_renderer Threads::Threads ${EGL_LIBRARY} GTest::gtest_main rushlight_options)
add_test(NAME metamorphic_gl_test COMMAND metamorphic_gl_test)
set_tests_properties(metamorphic_gl_test PROPERTIES TIMEOUT 120)
