# Frames as apitrace and RenderDoc see them.
foreach(what apitrace renderdoc)
  add_test(NAME debuggers_gl.${what}
    COMMAND ${CMAKE_CURRENT_SOURCE_DIR}/debuggers_test.sh ${what} $<TARGET_FILE:rushlight>
      ${PROJECT_SOURCE_DIR} ${CMAKE_CURRENT_BINARY_DIR}/debuggers_${what})
  set_tests_properties(debuggers_gl.${what} PROPERTIES
    TIMEOUT 3600 SKIP_RETURN_CODE 77 RUN_SERIAL TRUE)
endforeach()
