# Component `development`, what another project needs to build skills: the program, the runtime, its headers, pal_add_skill.
include(CMakePackageConfigHelpers)

set(pal_package_directory "${CMAKE_INSTALL_LIBDIR}/cmake/pal")

install(TARGETS pal pal_runtime pal_trace EXPORT palTargets
  RUNTIME DESTINATION "${CMAKE_INSTALL_BINDIR}" COMPONENT development
  ARCHIVE DESTINATION "${CMAKE_INSTALL_LIBDIR}" COMPONENT development)
install(EXPORT palTargets NAMESPACE pal:: DESTINATION "${pal_package_directory}" COMPONENT development)

# As in the source tree: #include "runtime/thread.hpp".
install(DIRECTORY runtime DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}/pal" COMPONENT development
        FILES_MATCHING PATTERN "*.hpp")

configure_package_config_file(cmake/palConfig.cmake.in "${PROJECT_BINARY_DIR}/palConfig.cmake"
  INSTALL_DESTINATION "${pal_package_directory}")
write_basic_package_version_file("${PROJECT_BINARY_DIR}/palConfigVersion.cmake" COMPATIBILITY SameMinorVersion)
install(FILES "${PROJECT_BINARY_DIR}/palConfig.cmake" "${PROJECT_BINARY_DIR}/palConfigVersion.cmake"
              cmake/PalSkill.cmake cmake/PalCheck.cmake
        DESTINATION "${pal_package_directory}" COMPONENT development)
