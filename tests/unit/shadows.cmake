# What is drawn of shadows, by whole frames on the null backend.
add_executable(shadow_cache_test shadows/shadow_cache_test.cpp)
target_compile_definitions(shadow_cache_test PRIVATE RUSHLIGHT_CONTENT="${PROJECT_SOURCE_DIR}/content")
target_link_libraries(shadow_cache_test PRIVATE
  rushlight_scene_bridge rushlight_assets rushlight_null_backend GTest::gtest_main rushlight_options)
gtest_discover_tests(shadow_cache_test)
