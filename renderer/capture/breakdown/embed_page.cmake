# Turns the breakdown page's files into one C++ file that holds their texts.
# Included, it defines rushlight_embed_page(); run as a script (cmake -P), it writes the file.

function(rushlight_embed_page output root)
  set(files breakdown.html breakdown.css breakdown.js breakdown_sections.js breakdown_compare.js)
  set(paths ${files})
  list(TRANSFORM paths PREPEND ${root}/)
  add_custom_command(OUTPUT ${output}
    COMMAND ${CMAKE_COMMAND} -DOUTPUT=${output} -DROOT=${root} "-DFILES=${files}"
            -P ${CMAKE_CURRENT_FUNCTION_LIST_FILE}
    DEPENDS ${paths} ${CMAKE_CURRENT_FUNCTION_LIST_FILE}
    COMMENT "Embedding the breakdown page"
    VERBATIM)
endfunction()

if(CMAKE_SCRIPT_MODE_FILE AND OUTPUT)
  set(code "// Generated from renderer/capture/breakdown/page.\n")
  string(APPEND code "#include \"renderer/capture/breakdown/breakdown_page.h\"\n\n")
  string(APPEND code "namespace rushlight {\n\nPageParts breakdownPageParts() {\n    return {\n")
  foreach(name IN LISTS FILES)
    file(READ ${ROOT}/${name} text)
    string(APPEND code "R\"page(${text})page\",\n")
  endforeach()
  string(APPEND code "    };\n}\n\n}  // namespace rushlight\n")
  file(WRITE ${OUTPUT} "${code}")
endif()
