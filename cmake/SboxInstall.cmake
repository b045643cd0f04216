# SPDX-FileCopyrightText: 2026 the sbox-merge authors
# SPDX-License-Identifier: BSD-3-Clause
#
# The library, its headers and the package that find_package(sbox) reads: component "dev".
include(CMakePackageConfigHelpers)

set(package_dir "${CMAKE_INSTALL_LIBDIR}/cmake/sbox")
configure_package_config_file(cmake/sbox-config.cmake.in sbox-config.cmake
                              INSTALL_DESTINATION "${package_dir}")
write_basic_package_version_file(sbox-config-version.cmake COMPATIBILITY SameMinorVersion)

install(TARGETS sbox EXPORT sbox-targets COMPONENT dev)
if(SBOX_BUILD_SLAM)
  install(TARGETS sbox_slam EXPORT sbox-slam-targets COMPONENT dev)
  install(EXPORT sbox-slam-targets NAMESPACE sbox:: DESTINATION "${package_dir}" COMPONENT dev)
endif()
install(DIRECTORY lib/sbox/slam/settings/ DESTINATION "${CMAKE_INSTALL_DATADIR}/sbox"
        COMPONENT commands FILES_MATCHING PATTERN "*.ini")
# Without those that speak of OpenCV and nlohmann_json, which users of the library need not have.
set(own_headers REGEX "/report/(drawing|html)$" EXCLUDE
                REGEX "/(overlay_layers|json_layout|pair_json|[a-z]+_picture)\\.h$" EXCLUDE)
if(NOT SBOX_BUILD_SLAM)
  list(APPEND own_headers REGEX "/slam$" EXCLUDE)
endif()
install(DIRECTORY lib/sbox DESTINATION "${CMAKE_INSTALL_INCLUDEDIR}" COMPONENT dev
        FILES_MATCHING PATTERN "*.h" ${own_headers} REGEX "/settings$" EXCLUDE)
install(EXPORT sbox-targets NAMESPACE sbox:: DESTINATION "${package_dir}" COMPONENT dev)
install(FILES "${CMAKE_CURRENT_BINARY_DIR}/sbox-config.cmake"
              "${CMAKE_CURRENT_BINARY_DIR}/sbox-config-version.cmake"
        DESTINATION "${package_dir}" COMPONENT dev)
