find_library(EGL_LIBRARY EGL REQUIRED)
find_package(Threads REQUIRED)

add_executable(screen_gl_test
  shadow/contact_shadows_gl_test.cpp
  screen/gtao_gl_test.cpp
  screen/reflections_gl_test.cpp
  ../support/scenes/lit_frame.cpp
  ../support/gl/test_context.cpp)
target_include_directories(screen_gl_test PRIVATE ${PROJECT_SOURCE_DIR}/shaders)
target_link_libraries(screen_gl_test PRIVATE
  rushlight_renderer rushlight_gl_backend Threads::Threads ${EGL_LIBRARY} GTest::gtest_main
  rushlight_options)
gtest_discover_tests(screen_gl_test)
