# Turns listed shader files into one C++ file that holds their texts.
# Included, it defines rushlight_embed_shaders(); run as a script (cmake -P), it writes the file.

function(rushlight_embed_shaders output root)
  set(paths ${ARGN})
  list(TRANSFORM paths PREPEND ${root}/)
  add_custom_command(OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${output} -DROOT=${root} "-DFILES=${ARGN}"
            -P ${CMAKE_CURRENT_FUNCTION_LIST_FILE}
    DEPENDS ${paths} ${CMAKE_CURRENT_FUNCTION_LIST_FILE} ${root}/files.cmake
    COMMENT "Embedding the shaders"
    VERBATIM)
endfunction()

if(CMAKE_SCRIPT_MODE_FILE AND OUTPUT)
  set(code "// Generated from the files of shaders/files.cmake.\n")
  string(APPEND code "#include \"renderer/backend/gl/programs/gl_shader_library.h\"\n\n")
  string(APPEND code "namespace rushlight {\nnamespace {\n\nconstexpr ShaderText kShaders[] = {\n")
  foreach(name IN LISTS FILES)
    file(READ ${ROOT}/${name} text)
    string(APPEND code "    {\"${name}\", R\"glsl(${text})glsl\"},\n")
  endforeach()
  string(APPEND code "};\n\n}  // namespace\n\n")
  string(APPEND code "std::span<const ShaderText> embeddedShaders() { return kShaders; }\n\n")
  string(APPEND code "}  // namespace rushlight\n")
  file(WRITE ${OUTPUT} "${code}")
endif()
