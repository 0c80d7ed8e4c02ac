# The four Debian packages: `cpack` in the folder of a finished build.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_PACKAGE_DIRECTORY ${PROJECT_BINARY_DIR}/packages)
set(CPACK_PACKAGE_NAME rigsound)
set(CPACK_PACKAGE_CONTACT "The rigsound authors <maintainers@rigsound.example>")
set(CPACK_PACKAGE_HOMEPAGE_URL "https://rigsound.example")
set(CPACK_STRIP_FILES ON)
set(CPACK_INSTALL_DEFAULT_DIRECTORY_PERMISSIONS
  OWNER_READ OWNER_WRITE OWNER_EXECUTE GROUP_READ GROUP_EXECUTE WORLD_READ WORLD_EXECUTE)
set(CPACK_COMPONENTS_ALL programs library development documentation)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)
set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS ON)
set(CPACK_DEBIAN_PACKAGE_GENERATE_SHLIBS ON)
set(CPACK_PACKAGE_DESCRIPTION_SUMMARY "sound of a percussive drilling rig, live from its fieldbus")
set(CPACK_DEBIAN_ENABLE_COMPONENT_DEPENDS OFF)
set(CPACK_DEBIAN_PACKAGE_SECTION sound)

function(package component name depends section details)
  string(TOUPPER ${component} upper)
  set(CPACK_DEBIAN_${upper}_PACKAGE_NAME ${name} PARENT_SCOPE)
  set(CPACK_DEBIAN_${upper}_PACKAGE_DEPENDS "${depends}" PARENT_SCOPE)
  set(CPACK_DEBIAN_${upper}_PACKAGE_SECTION ${section} PARENT_SCOPE)
  set(CPACK_COMPONENT_${upper}_DESCRIPTION "${details}" PARENT_SCOPE)

  # Debian wants each package to carry its licence and its changes.
  set(doc ${CMAKE_CURRENT_BINARY_DIR}/doc/${name})
  configure_file(debian/copyright ${doc}/copyright COPYONLY)
  configure_file(debian/changelog.in ${doc}/changelog @ONLY)
  execute_process(COMMAND gzip -9nf ${doc}/changelog COMMAND_ERROR_IS_FATAL ANY)
  install(FILES ${doc}/copyright ${doc}/changelog.gz DESTINATION ${CMAKE_INSTALL_DATADIR}/doc/${name} COMPONENT ${component})
endfunction()

package(programs rigsound "systemd (>= 250)" sound
  "The daemon rigsoundd plays what a training simulator's drilling rig does, told\nover CAN or Modbus; the command rigsound prepares sounds from recordings,\nrenders recorded buses and talks to the daemon.")
package(library librigsound1 "" libs "The synthesiser of rigsound behind a C interface.")
package(development librigsound-dev "librigsound1 (= ${PROJECT_VERSION})" libdevel
  "Headers, pkg-config file and CMake package of the synthesiser of rigsound.")
package(documentation rigsound-doc "" doc
  "How rigsound works, module by module, and example programs for its library.")
set(CPACK_DEBIAN_DOCUMENTATION_PACKAGE_ARCHITECTURE all)
set(CPACK_DEBIAN_PROGRAMS_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_SOURCE_DIR}/debian/postinst
  ${CMAKE_CURRENT_SOURCE_DIR}/debian/prerm ${CMAKE_CURRENT_SOURCE_DIR}/debian/postrm)
set(CPACK_DEBIAN_LIBRARY_PACKAGE_CONTROL_EXTRA ${CMAKE_CURRENT_SOURCE_DIR}/debian/triggers)

include(CPack)
