add_executable(context_gl_test device/context_gl_test.cpp)
target_link_libraries(context_gl_test PRIVATE rushlight_context GTest::gtest_main rushlight_options)
gtest_discover_tests(context_gl_test)

# The same tests once more with a display, where a virtual one can be had: the window kinds run there alone.
find_program(XVFB_RUN xvfb-run)
if(XVFB_RUN)
  add_test(NAME context_gl_test_with_display
    COMMAND ${PROJECT_SOURCE_DIR}/tests/support/with_display.sh $<TARGET_FILE:context_gl_test>)
endif()
