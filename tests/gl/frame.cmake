find_library(EGL_LIBRARY EGL REQUIRED)

add_executable(frame_gl_test
  surface/all_features_gl_test.cpp
  device/allocations_gl_test.cpp
  surface/culling_gl_test.cpp
  surface/decals_gl_test.cpp
  light/fog_gl_test.cpp
  device/interop_gl_test.cpp
  surface/materials_gl_test.cpp
  surface/surfaces_gl_test.cpp
  ../support/allocation_counter.cpp
  ../support/scenes/lit_frame.cpp
  ../support/scenes/random_scene.cpp
  ../support/gl/test_context.cpp)
target_include_directories(frame_gl_test PRIVATE ${PROJECT_SOURCE_DIR}/shaders)
target_link_libraries(frame_gl_test PRIVATE
  rushlight_renderer rushlight_gl_backend ${EGL_LIBRARY} GTest::gtest_main rushlight_options)
gtest_discover_tests(frame_gl_test)

find_package(Threads REQUIRED)
add_executable(render_thread_gl_test
  device/render_thread_gl_test.cpp
  ../support/scenes/random_scene.cpp
  ../support/gl/test_context.cpp)
target_link_libraries(render_thread_gl_test PRIVATE
  rushlight_renderer rushlight_gl_backend Threads::Threads ${EGL_LIBRARY} GTest::gtest_main
  rushlight_options)
gtest_discover_tests(render_thread_gl_test)

add_executable(views_gl_test
  frame/views_gl_test.cpp
  ../support/gl/test_context.cpp
  ../support/scenes/random_scene.cpp)
target_link_libraries(views_gl_test PRIVATE
  rushlight_renderer ${EGL_LIBRARY} GTest::gtest_main rushlight_options)
gtest_discover_tests(views_gl_test PROPERTIES TIMEOUT 3600)
