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

# Of area lights and of suns, on a fixture of their own.
add_executable(shadow_lights_gl_test
  area_shadow_gl_test.cpp
  penumbra_gl_test.cpp
  second_suns_gl_test.cpp
  sun_shadows_gl_test.cpp
  ../support/lit_frame.cpp
  ../support/test_context.cpp)
target_include_directories(shadow_lights_gl_test PRIVATE ${PROJECT_SOURCE_DIR}/shaders)
target_link_libraries(shadow_lights_gl_test PRIVATE
  rushlight_renderer rushlight_raytrace ${EGL_LIBRARY} GTest::gtest_main rushlight_options)
gtest_discover_tests(shadow_lights_gl_test)

# Light through coloured panes, on the same fixture.
add_executable(glass_gl_test
  glass_gl_test.cpp
  ../support/lit_frame.cpp
  ../support/test_context.cpp)
target_include_directories(glass_gl_test PRIVATE ${PROJECT_SOURCE_DIR}/shaders)
target_link_libraries(glass_gl_test PRIVATE
  rushlight_renderer ${EGL_LIBRARY} GTest::gtest_main rushlight_options)
gtest_discover_tests(glass_gl_test)
