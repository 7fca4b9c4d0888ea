# What is installed, in three parts, which are also the Debian packages (PalPackage):
#   tools        the program pal, its documents
#   development  what another project needs to build skills: the runtime, its headers, pal_add_skill, examples
#   workcell     the program workcell, its skills and scenes (see sim/ and skills_pal/)
include(CMakePackageConfigHelpers)

set(pal_package_directory "${CMAKE_INSTALL_LIBDIR}/cmake/pal")
set(pal_documents "${CMAKE_INSTALL_DATADIR}/doc/pal-tools")
file(GLOB_RECURSE pal_documents_sources CONFIGURE_DEPENDS docs/*.md docs/*.svg docs/*.png skills_pal/*.md skills_pal/*.pal)
list(APPEND pal_documents_sources "${PROJECT_SOURCE_DIR}/README.md" "${PROJECT_SOURCE_DIR}/CONTRIBUTING.md")

# pal_manual_page(PROGRAM PART): made of what the program's --help says, and compressed, as Debian wants it.
find_program(PAL_GZIP gzip REQUIRED)
find_package(Python3 REQUIRED COMPONENTS Interpreter)
function(pal_manual_page program part)
  set(page "${PROJECT_BINARY_DIR}/man/${program}.1")
  set(frame "${PROJECT_SOURCE_DIR}/docs/man/${program}.1")
  add_custom_command(OUTPUT "${page}.gz"
    COMMAND Python3::Interpreter "${PROJECT_SOURCE_DIR}/scripts/manual_page" $<TARGET_FILE:${program}> "${frame}" > "${page}"
    COMMAND ${PAL_GZIP} -9nf "${page}"
    DEPENDS ${program} "${frame}" "${PROJECT_SOURCE_DIR}/scripts/manual_page" VERBATIM)
  add_custom_target(manual_of_${program} ALL DEPENDS "${page}.gz")
  file(MAKE_DIRECTORY "${PROJECT_BINARY_DIR}/man")
  install(FILES "${page}.gz" DESTINATION "${CMAKE_INSTALL_MANDIR}/man1" COMPONENT ${part})
endfunction()

# The documents as they are where they are installed: what is not installed there is named, without a link.
set(documents "${PROJECT_BINARY_DIR}/documents")
add_custom_command(OUTPUT "${documents}/stamp"
  COMMAND Python3::Interpreter "${PROJECT_SOURCE_DIR}/scripts/installed_documents" "${PROJECT_SOURCE_DIR}" "${documents}"
  COMMAND ${CMAKE_COMMAND} -E touch "${documents}/stamp"
  DEPENDS "${PROJECT_SOURCE_DIR}/scripts/installed_documents" ${pal_documents_sources} VERBATIM)
add_custom_target(installed_documents ALL DEPENDS "${documents}/stamp")

install(TARGETS pal EXPORT palTargets RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT tools)
pal_manual_page(pal tools)
install(FILES "${PROJECT_BINARY_DIR}/completion.bash" DESTINATION "${CMAKE_INSTALL_DATADIR}/bash-completion/completions" COMPONENT tools
  RENAME pal)
install(FILES "${PROJECT_BINARY_DIR}/completion.zsh" DESTINATION "${CMAKE_INSTALL_DATADIR}/zsh/vendor-completions" COMPONENT tools
  RENAME _pal)
install(FILES "${PROJECT_BINARY_DIR}/completion.fish" DESTINATION "${CMAKE_INSTALL_DATADIR}/fish/vendor_completions.d" COMPONENT tools
  RENAME pal.fish)
install(DIRECTORY "${documents}/" DESTINATION "${pal_documents}" COMPONENT tools PATTERN stamp EXCLUDE)

install(TARGETS pal_runtime pal_trace EXPORT palTargets
  ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT development)
install(EXPORT palTargets NAMESPACE pal:: DESTINATION "${pal_package_directory}" COMPONENT development)
configure_package_config_file(cmake/palConfig.cmake.in "${PROJECT_BINARY_DIR}/palConfig.cmake"
  INSTALL_DESTINATION "${pal_package_directory}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/palConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/palConfig.cmake" "${PROJECT_BINARY_DIR}/palConfigVersion.cmake"
              cmake/PalSkill.cmake cmake/PalCheck.cmake cmake/pal_gdb.py
        DESTINATION "${pal_package_directory}" COMPONENT development)
install(DIRECTORY examples DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/pal-development" COMPONENT development)

# What skills, drivers and devices for the workcell are built with: find_package(pal COMPONENTS workcell).
if(PAL_BUILD_WORKCELL)
  install(TARGETS pal_drivers pal_links pal_sensing pal_skill_modules EXPORT palWorkcellTargets
    ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT development)
  install(EXPORT palWorkcellTargets NAMESPACE pal:: DESTINATION "${pal_package_directory}" COMPONENT development)
  foreach(folder runtime/drivers skills_pal/sensing skills_pal/modules)
    install(DIRECTORY ${folder}/ DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/pal-workcell/${folder}" COMPONENT development
      FILES_MATCHING PATTERN "*.hpp" PATTERN bridge.hpp EXCLUDE PATTERN pseudo_terminal.hpp EXCLUDE)
  endforeach()
endif()

# The programs are there only where their tree is built, so each part alone has its licence, too.
set(pal_parts tools development)
if(PAL_BUILD_WORKCELL)
  pal_manual_page(workcell workcell)
  list(APPEND pal_parts workcell)
endif()
foreach(part IN LISTS pal_parts)
  install(FILES cmake/copyright DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/pal-${part}" COMPONENT ${part})
  install(FILES LICENSE DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/pal-${part}" COMPONENT ${part} RENAME Apache-2.0.txt)
endforeach()
