find_package(hwy REQUIRED)

# What large objects hide, worked out on the CPU.
add_library(rushlight_occlusion STATIC
  occlusion_boxes.cpp
  occlusion_buffer.cpp
  occlusion_clip.cpp
  occlusion_kernels.cpp
  occlusion_mesh.cpp
  occlusion_pick.cpp
  occlusion_setup.cpp)
target_link_libraries(rushlight_occlusion PUBLIC rushlight_core PRIVATE hwy::hwy rushlight_options)
rushlight_package(rushlight_occlusion)
