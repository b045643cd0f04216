# SPDX-FileCopyrightText: 2026 the sbox-merge authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Debian packages, by `cpack --config build/release/CPackConfig.cmake`: sbox-merge has the commands,
# libsbox-dev the library. Both depend on the versions of the Debian that they were made on.
set(CPACK_GENERATOR DEB)
set(CPACK_PACKAGE_NAME sbox-merge)
set(CPACK_PACKAGE_CONTACT "the sbox-merge authors <sbox-merge@localhost>")
set(CPACK_PACKAGING_INSTALL_PREFIX /usr)
set(CPACK_STRIP_FILES ON)
set(CPACK_COMPONENTS_ALL commands dev)
set(CPACK_DEB_COMPONENT_INSTALL ON)
set(CPACK_DEBIAN_FILE_NAME DEB-DEFAULT)

# CPack indents the lines; what is indented already it takes for verbatim text.
set(about "Input are map files of MRPT (.gridmap, .simplemap) or ROS (.yaml with an image), and MRPT's
rawlogs. The answer is one map and where each map lies in it, with covariance and confidence, or a
plain refusal.")
set(CPACK_DEBIAN_COMMANDS_PACKAGE_NAME sbox-merge)
set(CPACK_DEBIAN_COMMANDS_PACKAGE_SECTION science)
set(CPACK_DEBIAN_COMMANDS_PACKAGE_SHLIBDEPS ON)
set(CPACK_COMPONENT_COMMANDS_DESCRIPTION "${about}")

set(CPACK_DEBIAN_DEV_PACKAGE_NAME libsbox-dev)
set(CPACK_DEBIAN_DEV_PACKAGE_SECTION libdevel)
set(CPACK_DEBIAN_DEV_PACKAGE_DEPENDS
    "libceres-dev, libeigen3-dev, libmrpt-io-dev, libmrpt-maps-dev, libmrpt-obs-dev, libmrpt-slam-dev, libopencv-dev")
set(CPACK_COMPONENT_DEV_DESCRIPTION "${about}\nThis package holds the library.")

foreach(package sbox-merge libsbox-dev)
  set(component dev)
  if(package STREQUAL sbox-merge)
    set(component commands)
  endif()
  install(FILES LICENSE DESTINATION "${CMAKE_INSTALL_DATADIR}/doc/${package}" RENAME copyright
          COMPONENT ${component})
endforeach()
include(CPack)
