# Probes against the path-traced truth.
add_executable(irradiance_error
  irradiance_error.cpp
  ${PROJECT_SOURCE_DIR}/sandbox/tool/probes.cpp
  ${PROJECT_SOURCE_DIR}/sandbox/tool/progress.cpp)
target_link_libraries(irradiance_error PRIVATE
  rushlight_assets rushlight_capture rushlight_jobs rushlight_ray_bridge rushlight_options)
