# CPack reads this before each kind of package: two for Debian, one archive of all.
set(CPACK_COMPONENTS_ALL Unspecified sdf libraries)
if(CPACK_GENERATOR STREQUAL "DEB")
  set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
  set(CPACK_COMPONENTS_GROUPING ONE_PER_GROUP)
  set(CPACK_COMPONENT_UNSPECIFIED_GROUP treeline)
  set(CPACK_COMPONENT_LIBRARIES_GROUP treeline)
  set(CPACK_DEBIAN_PACKAGE_SHLIBDEPS_PRIVATE_DIRS /usr/lib/treeline)  # what is there is no dependency
else()
  set(CPACK_COMPONENTS_GROUPING ALL_COMPONENTS_IN_ONE)
  set(CPACK_COMPONENT_INCLUDE_TOPLEVEL_DIRECTORY ON)
endif()
