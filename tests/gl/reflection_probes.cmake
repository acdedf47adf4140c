find_package(Threads REQUIRED)
add_executable(reflection_probes_gl_test reflection_probes_gl_test.cpp ../support/test_context.cpp)
target_link_libraries(reflection_probes_gl_test PRIVATE
  rushlight_renderer Threads::Threads ${EGL_LIBRARY} GTest::gtest_main rushlight_options)
gtest_discover_tests(reflection_probes_gl_test PROPERTIES TIMEOUT 300)
