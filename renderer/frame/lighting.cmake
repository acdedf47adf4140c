# Light that is prepared on the CPU: environment prefiltering, the BRDF table, vertex packing.
add_library(rushlight_lighting STATIC
  atmosphere.cpp
  brdf_table.cpp
  cube_image.cpp
  environment.cpp
  environment_cache.cpp
  environment_import.cpp
  equirect.cpp
  irradiance_file.cpp
  irradiance_volume.cpp
  light_patterns.cpp
  reflection_probes.cpp
  sky.cpp
  ltc_fit.cpp
  ltc_lookup.cpp
  ltc_table.cpp
  vertex_packing.cpp)
target_include_directories(rushlight_lighting PUBLIC $<BUILD_INTERFACE:${PROJECT_SOURCE_DIR}/shaders>)
target_link_libraries(rushlight_lighting PUBLIC rushlight_core rushlight_commands PRIVATE rushlight_options)
rushlight_package(rushlight_lighting HEADERS
  irradiance_volume.h
  light_patterns.h
  reflection_probes.h
  sky.h)
