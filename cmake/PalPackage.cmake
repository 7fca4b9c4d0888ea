# Debian packages: `cpack -G DEB` in the build folder makes pal-tools, pal-development and pal-workcell.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_VENDOR "pal")
set(CPACK_PACKAGE_CONTACT "PAL maintainers <maintainers@users.noreply.h-seed-700f1ee1.example>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_COMPONENTS_ALL ${pal_parts})
set(CPACK_COMPONENTS_GROUPING IGNORE)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_RELEASE 1)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SHLIBDEPS OFF)  # nothing in it is loaded: each file would be looked at in vain
set(CPACK_DEBIAN_PACKAGE_CONTROL_STRICT_PERMISSION ON)
set(CPACK_DEBIAN_PACKAGE_PRIORITY optional)

set(CPACK_DEBIAN_TOOLS_PACKAGE_SECTION devel)
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_WORKCELL_PACKAGE_SECTION science)

set(pal_this_version "${PROJECT_VERSION}-${CPACK_DEBIAN_PACKAGE_RELEASE}")
# Static libraries and CMake files: building with them needs a compiler, and the pal of the same version.
set(CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS "pal-tools (= ${pal_this_version}), g++ (>= 4:12) | clang, cmake (>= 3.25), make | ninja-build")
if(PAL_BUILD_WORKCELL)
  string(APPEND CPACK_DEBIAN_DEVELOPMENT_PACKAGE_DEPENDS ", libeigen3-dev")  # headers of pal::drivers and pal::sensing
endif()
# pal draws with Graphviz; the workcell loads EGL for a picture, which needs Mesa's drivers where there is no graphics card,
# or else OSMesa, and starts ffmpeg and gnuplot.
set(CPACK_DEBIAN_TOOLS_PACKAGE_SUGGESTS "pal-development (= ${pal_this_version})")
set(CPACK_DEBIAN_WORKCELL_PACKAGE_RECOMMENDS "libegl1, libgl1-mesa-dri")
set(CPACK_DEBIAN_WORKCELL_PACKAGE_SUGGESTS "ffmpeg, gnuplot-nox, libosmesa6")

# The first line of each is its summary; one for all would stand before them.
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "")
set(CPACK_COMPONENT_TOOLS_DESCRIPTION
"proves that robot skills meet their deadlines
The program pal reads robot skills written in PAL, finds what is wrong with
them, proves their response times, ages of data and loads, draws the worst
runs, and writes them as C++20.")
set(CPACK_COMPONENT_DEVELOPMENT_DESCRIPTION
"runtime and headers to build robot skills written in PAL
What a project needs to build and run skills of its own: the runtime as a
static library, its headers, the CMake function pal_add_skill, and examples.")
set(CPACK_COMPONENT_WORKCELL_DESCRIPTION
"simulated PUMA 560 workcell that runs robot skills
A PUMA 560 in MuJoCo with its VAL II and ALTER ports, a force sensor, a range
finder and a gripper, twelve skills that run in it, and the page on which
operations are drawn, run and debugged.")

# Each package has a changelog in Debian's form, and a note on what lintian finds and why it stays.
# SOURCE_DATE_EPOCH makes the date, and so the packages, the same each time.
string(TIMESTAMP pal_date "%a, %d %b %Y %H:%M:%S +0000" UTC)
foreach(part IN LISTS pal_parts)
  set(folder "${PROJECT_BINARY_DIR}/debian/pal-${part}")
  file(WRITE "${folder}/changelog.Debian"
"pal (${pal_this_version}) unstable; urgency=medium

  * See README.md and docs in /usr/share/doc/pal-tools.

 -- ${CPACK_PACKAGE_CONTACT}  ${pal_date}
")
  execute_process(COMMAND ${PAL_GZIP} -9nf "${folder}/changelog.Debian" COMMAND_ERROR_IS_FATAL ANY)
  # Not made for Debian's archive, so no bug asks for it.
  file(WRITE "${folder}/overrides" "pal-${part}: initial-upload-closes-no-bugs\n")
  install(FILES "${folder}/overrides" DESTINATION "${CMAKE_INSTALL_DATADIR}/lintian/overrides" COMPONENT ${part} RENAME pal-${part})
  install(FILES "${folder}/changelog.Debian.gz" DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/pal-${part}" COMPONENT ${part})
endforeach()

include(CPack)
