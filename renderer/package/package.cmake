# What `cmake --install` installs: libraries, their public headers under the paths that they have
# here, the tool, and the files by which find_package(rushlight) finds them.
include(GNUInstallDirs)
include(CMakePackageConfigHelpers)

set(RUSHLIGHT_PACKAGE_DIR ${CMAKE_INSTALL_LIBDIR}/cmake/rushlight)

# rushlight_package(rushlight_NAME [AS NAME] [HEADERS files...])
#
# Installs the library as rushlight::NAME. HEADERS are those that hosts include, and what these
# include; a library without any is there to be linked by others, and is called
# rushlight::internal_NAME.
function(rushlight_package target)
  cmake_parse_arguments(PARSE_ARGV 1 package "" "AS" "HEADERS")
  string(REGEX REPLACE "^rushlight_" "" name ${target})
  if(DEFINED package_AS)
    set(name ${package_AS})
  elseif(NOT DEFINED package_HEADERS)
    set(name internal_${name})
  endif()
  set_target_properties(${target} PROPERTIES EXPORT_NAME ${name})
  target_sources(${target} PUBLIC
    FILE_SET HEADERS BASE_DIRS ${PROJECT_SOURCE_DIR} FILES ${package_HEADERS})
  install(TARGETS ${target} EXPORT rushlightTargets
    ARCHIVE DESTINATION ${CMAKE_INSTALL_LIBDIR}
    FILE_SET HEADERS DESTINATION ${CMAKE_INSTALL_INCLUDEDIR})
endfunction()

# Called last: the tool and the package's own files.
function(rushlight_install_package)
  set_target_properties(rushlight PROPERTIES EXPORT_NAME tool)
  install(TARGETS rushlight EXPORT rushlightTargets RUNTIME DESTINATION ${CMAKE_INSTALL_BINDIR})
  install(EXPORT rushlightTargets NAMESPACE rushlight:: DESTINATION ${RUSHLIGHT_PACKAGE_DIR})
  set(source ${PROJECT_SOURCE_DIR}/renderer/package)
  set(made ${PROJECT_BINARY_DIR}/package)
  configure_package_config_file(${source}/rushlightConfig.cmake.in ${made}/rushlightConfig.cmake
    INSTALL_DESTINATION ${RUSHLIGHT_PACKAGE_DIR})
  write_basic_package_version_file(${made}/rushlightConfigVersion.cmake COMPATIBILITY SameMinorVersion)
  install(FILES ${made}/rushlightConfig.cmake ${made}/rushlightConfigVersion.cmake
    ${source}/rushlightSceneTests.cmake
    DESTINATION ${RUSHLIGHT_PACKAGE_DIR})
  install(FILES ${PROJECT_SOURCE_DIR}/LICENSE DESTINATION ${CMAKE_INSTALL_DOCDIR})
endfunction()
