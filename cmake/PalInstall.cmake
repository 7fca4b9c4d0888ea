# What is installed, in three parts, which are also the Debian packages (PalPackage):
#   tools        the program pal, its documents
#   development  what another project needs to build skills: the runtime, its headers, pal_add_skill, examples
#   workcell     the program workcell, its skills and scenes (see sim/ and skills_pal/)
include(CMakePackageConfigHelpers)

set(pal_package_directory "${CMAKE_INSTALL_LIBDIR}/cmake/pal")
set(pal_documents "${CMAKE_INSTALL_DATADIR}/doc/pal-tools")

install(TARGETS pal EXPORT palTargets RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT tools)
install(FILES docs/man/pal.1 DESTINATION "${CMAKE_INSTALL_MANDIR}/man1" COMPONENT tools)
install(FILES README.md CONTRIBUTING.md DESTINATION "${pal_documents}" COMPONENT tools)
install(DIRECTORY docs DESTINATION "${pal_documents}" COMPONENT tools PATTERN man EXCLUDE)

install(TARGETS pal_runtime pal_trace EXPORT palTargets
  ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT development)
install(EXPORT palTargets NAMESPACE pal:: DESTINATION "${pal_package_directory}" COMPONENT development)
configure_package_config_file(cmake/palConfig.cmake.in "${PROJECT_BINARY_DIR}/palConfig.cmake"
  INSTALL_DESTINATION "${pal_package_directory}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/palConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/palConfig.cmake" "${PROJECT_BINARY_DIR}/palConfigVersion.cmake"
              cmake/PalSkill.cmake cmake/PalCheck.cmake
        DESTINATION "${pal_package_directory}" COMPONENT development)
install(DIRECTORY examples DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/pal-development" COMPONENT development)

# The programs are there only where their tree is built, so who has one part alone has its licence, too.
set(pal_parts tools development)
if(PAL_BUILD_WORKCELL)
  install(FILES docs/man/workcell.1 DESTINATION "${CMAKE_INSTALL_MANDIR}/man1" COMPONENT workcell)
  list(APPEND pal_parts workcell)
endif()
foreach(part IN LISTS pal_parts)
  install(FILES LICENSE DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/pal-${part}" COMPONENT ${part} RENAME copyright)
endforeach()
