# Shadows in pictures: against rays, and from frame to frame.
add_executable(shadows_gl_test
  shadow_stability_gl_test.cpp
  shadow_truth_gl_test.cpp
  ../support/shadow_truth.cpp
  ../support/torture_scene.cpp)
target_compile_definitions(shadows_gl_test PRIVATE RUSHLIGHT_CONTENT="${PROJECT_SOURCE_DIR}/content")
target_include_directories(shadows_gl_test PRIVATE ${PROJECT_SOURCE_DIR}/shaders)
target_link_libraries(shadows_gl_test PRIVATE
  rushlight_context rushlight_ray_bridge rushlight_capture rushlight_assets rushlight_jobs
  GTest::gtest_main rushlight_options)
gtest_discover_tests(shadows_gl_test PROPERTIES TIMEOUT 600)
