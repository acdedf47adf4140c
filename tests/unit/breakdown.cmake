find_package(Threads REQUIRED)
find_package(nlohmann_json REQUIRED)

add_executable(breakdown_test capture/breakdown_test.cpp ../support/scenes/random_scene.cpp)
target_compile_definitions(breakdown_test PRIVATE RUSHLIGHT_TOOL="")
target_link_libraries(breakdown_test PRIVATE
  rushlight_breakdown nlohmann_json::nlohmann_json Threads::Threads GTest::gtest_main rushlight_options)
gtest_discover_tests(breakdown_test PROPERTIES TIMEOUT 3600)
