# The sandbox in a window of a virtual display.
find_program(XVFB_RUN xvfb-run)
if(XVFB_RUN)
  foreach(what picture view broken_shader broken_level)
    add_test(NAME window_gl.${what}
      COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/window_test.sh ${what} $<TARGET_FILE:sandbox>
        ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_BINARY_DIR}/window_${what})
    set_tests_properties(window_gl.${what} PROPERTIES TIMEOUT 3600)
  endforeach()
endif()
add_test(NAME window.no_display
  COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/window_test.sh no_display $<TARGET_FILE:sandbox>
    ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_BINARY_DIR}/window_no_display)
add_executable(picture_varies frame/picture_varies.cpp)
target_link_libraries(picture_varies PRIVATE rushlight_capture rushlight_options)
