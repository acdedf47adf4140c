find_library(EGL_LIBRARY EGL REQUIRED)

add_executable(frame_gl_test
  all_features_gl_test.cpp
  allocations_gl_test.cpp
  culling_gl_test.cpp
  decals_gl_test.cpp
  fog_gl_test.cpp
  interop_gl_test.cpp
  materials_gl_test.cpp
  surfaces_gl_test.cpp
  ../support/allocation_counter.cpp
  ../support/lit_frame.cpp
  ../support/random_scene.cpp
  ../support/test_context.cpp)
target_include_directories(frame_gl_test PRIVATE ${PROJECT_SOURCE_DIR}/shaders)
target_link_libraries(frame_gl_test PRIVATE
  rushlight_renderer rushlight_gl_backend ${EGL_LIBRARY} GTest::gtest_main rushlight_options)
gtest_discover_tests(frame_gl_test)

find_package(Threads REQUIRED)
add_executable(render_thread_gl_test
  render_thread_gl_test.cpp
  ../support/random_scene.cpp
  ../support/test_context.cpp)
target_link_libraries(render_thread_gl_test PRIVATE
  rushlight_renderer rushlight_gl_backend Threads::Threads ${EGL_LIBRARY} GTest::gtest_main
  rushlight_options)
gtest_discover_tests(render_thread_gl_test)
