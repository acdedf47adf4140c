# cmake -DROOT=... -DCLANG_FORMAT=... -P format_test.cmake
# Fails where a C++ file is not as .clang-format has it.
file(GLOB_RECURSE files
  ${ROOT}/engine/*.h ${ROOT}/engine/*.cpp ${ROOT}/renderer/*.h ${ROOT}/renderer/*.cpp
  ${ROOT}/shaders/*.h ${ROOT}/sandbox/*.h ${ROOT}/sandbox/*.cpp
  ${ROOT}/content/*.h ${ROOT}/content/*.cpp ${ROOT}/tests/*.h ${ROOT}/tests/*.cpp)
execute_process(COMMAND ${CLANG_FORMAT} --dry-run --Werror ${files}
  RESULT_VARIABLE result ERROR_VARIABLE text)
if(NOT result EQUAL 0)
  message(FATAL_ERROR "Run clang-format -i on what is named here:\n${text}")
endif()
