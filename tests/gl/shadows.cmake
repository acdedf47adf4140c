# Shadows in pictures: against rays, and from frame to frame.
add_executable(shadows_gl_test
  shadow/shadow_stability_gl_test.cpp
  shadow/shadow_truth_gl_test.cpp
  ../support/scenes/shadow_truth.cpp
  ../support/scenes/torture_scene.cpp)
target_compile_definitions(shadows_gl_test PRIVATE RUSHLIGHT_CONTENT="${PROJECT_SOURCE_DIR}/content")
target_include_directories(shadows_gl_test PRIVATE ${PROJECT_SOURCE_DIR}/shaders)
target_link_libraries(shadows_gl_test PRIVATE
  rushlight_context rushlight_ray_bridge rushlight_capture rushlight_assets rushlight_jobs
  GTest::gtest_main rushlight_options)
gtest_discover_tests(shadows_gl_test PROPERTIES TIMEOUT 3600)

# Of area lights and of suns, on a fixture of their own.
add_executable(shadow_lights_gl_test
  shadow/area_shadow_gl_test.cpp
  shadow/penumbra_gl_test.cpp
  shadow/second_suns_gl_test.cpp
  shadow/sun_shadows_gl_test.cpp
  ../support/scenes/lit_frame.cpp
  ../support/gl/test_context.cpp)
target_include_directories(shadow_lights_gl_test PRIVATE ${PROJECT_SOURCE_DIR}/shaders)
target_link_libraries(shadow_lights_gl_test PRIVATE
  rushlight_renderer rushlight_raytrace ${EGL_LIBRARY} GTest::gtest_main rushlight_options)
gtest_discover_tests(shadow_lights_gl_test)

# Light through coloured panes, on the same fixture.
add_executable(glass_gl_test
  light/glass_gl_test.cpp
  ../support/scenes/lit_frame.cpp
  ../support/gl/test_context.cpp)
target_include_directories(glass_gl_test PRIVATE ${PROJECT_SOURCE_DIR}/shaders)
target_link_libraries(glass_gl_test PRIVATE
  rushlight_renderer ${EGL_LIBRARY} GTest::gtest_main rushlight_options)
gtest_discover_tests(glass_gl_test)
