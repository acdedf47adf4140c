# What finding hidden objects costs (`build/release/bin/occlusion_bench`).
add_executable(occlusion_bench occlusion_bench.cpp)
target_link_libraries(occlusion_bench PRIVATE
  rushlight_visibility rushlight_jobs benchmark::benchmark rushlight_options)
