# SPDX-FileCopyrightText: 2026 the sbox-merge authors
# SPDX-License-Identifier: BSD-3-Clause
#
# Every package the build needs; a missing one is an error.
find_package(mrpt-maps REQUIRED)
find_package(mrpt-io REQUIRED)
find_package(mrpt-obs REQUIRED)
if(SBOX_BUILD_SLAM)
  find_package(mrpt-slam REQUIRED)
endif()
find_package(Eigen3 3.3 REQUIRED NO_MODULE)
find_package(OpenCV REQUIRED COMPONENTS core imgproc imgcodecs)
find_package(Ceres REQUIRED)
find_package(nlohmann_json 3.9 REQUIRED)
find_package(Threads REQUIRED)
if(SBOX_BUILD_APPS)
  find_package(CLI11 2.1 REQUIRED)
  find_package(OpenCV REQUIRED COMPONENTS core imgproc imgcodecs features2d stitching)
endif()
if(SBOX_BUILD_TESTS)
  find_package(Catch2 REQUIRED)
endif()
