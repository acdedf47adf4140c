# The committed content is what the generator writes, to the byte.
add_test(NAME content_test.generatorWritesTheCommittedBytes
  COMMAND ${CMAKE_COMMAND}
    -DGENERATOR=$<TARGET_FILE:rushlight_content_generator>
    -DCOMMITTED=${PROJECT_SOURCE_DIR}/content
    -DSCRATCH=${CMAKE_CURRENT_BINARY_DIR}/content_again
    -P ${CMAKE_CURRENT_SOURCE_DIR}/compare_content.cmake)
