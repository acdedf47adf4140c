find_package(nlohmann_json REQUIRED)

add_executable(assets_test
  assets/assets_corpus_test.cpp
  assets/assets_ies_test.cpp
  assets/assets_image_test.cpp
  assets/assets_load_test.cpp
  assets/assets_pose_test.cpp
  assets/assets_rules_test.cpp
  assets/assets_area_lights_test.cpp
  assets/assets_surroundings_test.cpp
  assets/assets_tangents_test.cpp
  assets/assets_transmission_test.cpp)
target_link_libraries(assets_test PRIVATE
  rushlight_assets rushlight_scene rushlight_jobs OpenImageIO nlohmann_json::nlohmann_json
  GTest::gtest_main
  rushlight_options)
gtest_discover_tests(assets_test)
