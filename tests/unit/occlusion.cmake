# Occlusion culling on the CPU.
find_package(hwy REQUIRED)
add_executable(occlusion_test
  visibility/occlusion_buffer_test.cpp
  visibility/occlusion_proof_test.cpp
  ../support/reference_raster.cpp)
target_link_libraries(occlusion_test PRIVATE
  rushlight_visibility hwy::hwy Threads::Threads GTest::gtest_main rushlight_options)
gtest_discover_tests(occlusion_test)
