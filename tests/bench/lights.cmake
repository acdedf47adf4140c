# What many lights cost (`build/release/bin/lights_bench`).
find_library(EGL_LIBRARY EGL REQUIRED)
add_executable(lights_bench lights_bench.cpp ../support/gl/test_context.cpp)
target_link_libraries(lights_bench PRIVATE
  rushlight_renderer rushlight_jobs ${EGL_LIBRARY} benchmark::benchmark rushlight_options)
