# rushlight_add_scene_tests(NAME name SCENES folder GOLDENS folder
#   [FLIP max] [PSNR min] [SSIM min] [MAX_ERROR max] [EXACT] [TIMEOUT seconds] [ARGUMENTS ...])
#
# A test `name.SCENE` for every .gltf and .glb file in the folder SCENES: `rushlight check` renders
# it and compares it with GOLDENS/SCENE.png. The limits hold for all; with none, no pixel may
# differ. ARGUMENTS are further options of `rushlight check`, such as --size 320x180. Options of one
# scene stand in SCENES/SCENE.check, as on a command line, and count before those given here; lines
# that begin with # are comments.
#
# What differs is left behind in the folder that the environment variable RUSHLIGHT_EVIDENCE names,
# else in rushlight-evidence of the binary folder. The target `name_goldens` renders all scenes
# again and says how their goldens would change; it changes none, but says the command that does. A
# scene without golden fails until one is accepted.
function(rushlight_add_scene_tests)
  cmake_parse_arguments(PARSE_ARGV 0 arg "EXACT"
    "NAME;SCENES;GOLDENS;FLIP;PSNR;SSIM;MAX_ERROR;TIMEOUT" "ARGUMENTS")
  foreach(needed NAME SCENES GOLDENS)
    if(NOT arg_${needed})
      message(FATAL_ERROR "rushlight_add_scene_tests: ${needed} is missing.")
    endif()
  endforeach()
  if(arg_UNPARSED_ARGUMENTS)
    message(FATAL_ERROR "rushlight_add_scene_tests: unknown arguments: ${arg_UNPARSED_ARGUMENTS}.")
  endif()
  cmake_path(ABSOLUTE_PATH arg_SCENES NORMALIZE)
  cmake_path(ABSOLUTE_PATH arg_GOLDENS NORMALIZE)
  set(options ${arg_ARGUMENTS})
  foreach(limit FLIP PSNR SSIM MAX_ERROR)
    if(DEFINED arg_${limit})
      string(TOLOWER ${limit} option)
      string(REPLACE "_" "-" option ${option})
      list(APPEND options --${option} ${arg_${limit}})
    endif()
  endforeach()
  if(arg_EXACT)
    list(APPEND options --exact)
  endif()

  file(GLOB scenes CONFIGURE_DEPENDS ${arg_SCENES}/*.gltf ${arg_SCENES}/*.glb)
  file(GLOB sidecars CONFIGURE_DEPENDS ${arg_SCENES}/*.check)
  if(NOT scenes)
    message(FATAL_ERROR "rushlight_add_scene_tests: ${arg_SCENES} has no .gltf or .glb file.")
  endif()
  set(review ${CMAKE_CURRENT_BINARY_DIR}/rushlight-goldens/${arg_NAME})
  set(script "file(REMOVE_RECURSE \"${review}\")\n")
  foreach(scene IN LISTS scenes)
    cmake_path(GET scene STEM LAST_ONLY stem)
    set(command $<TARGET_FILE:rushlight::tool> check ${scene}
      --golden ${arg_GOLDENS}/${stem}.png --name ${stem} ${options})
    if(${arg_SCENES}/${stem}.check IN_LIST sidecars)
      list(APPEND command @${arg_SCENES}/${stem}.check)
    endif()
    add_test(NAME ${arg_NAME}.${stem} COMMAND ${command} --name ${arg_NAME}.${stem}
      WORKING_DIRECTORY ${CMAKE_CURRENT_BINARY_DIR})
    if(arg_TIMEOUT)
      set_tests_properties(${arg_NAME}.${stem} PROPERTIES TIMEOUT ${arg_TIMEOUT})
    endif()
    list(JOIN command "\" \"" words)
    string(APPEND script "execute_process(COMMAND \"${words}\" --evidence \"${review}\" --always --no-breakdown\n"
      "  OUTPUT_QUIET RESULT_VARIABLE ended)\n"
      "if(NOT ended MATCHES \"^[01]$\")\n  message(FATAL_ERROR \"${stem} could not be checked.\")\nendif()\n")
  endforeach()
  string(APPEND script "execute_process(COMMAND \"$<TARGET_FILE:rushlight::tool>\" goldens \"${review}\"\n"
    "  COMMAND_ERROR_IS_FATAL ANY)\n")
  file(GENERATE OUTPUT ${CMAKE_CURRENT_BINARY_DIR}/${arg_NAME}_goldens.cmake CONTENT "${script}")
  add_custom_target(${arg_NAME}_goldens
    COMMAND ${CMAKE_COMMAND} -P ${CMAKE_CURRENT_BINARY_DIR}/${arg_NAME}_goldens.cmake
    USES_TERMINAL VERBATIM)
endfunction()
