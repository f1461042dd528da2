# SPDX-License-Identifier: BSD-3-Clause
# Copyright (c) 2026, the pcl_indoor contributors
#
# Builds the checkout that this port lies in.
get_filename_component(SOURCE_PATH "${CMAKE_CURRENT_LIST_DIR}/../../.." ABSOLUTE)

vcpkg_check_linkage(ONLY_DYNAMIC_LIBRARY)
vcpkg_check_features(OUT_FEATURE_OPTIONS FEATURE_OPTIONS
  FEATURES
    tools PCL_INDOOR_BUILD_TOOLS
)
vcpkg_cmake_configure(
  SOURCE_PATH "${SOURCE_PATH}"
  OPTIONS
    ${FEATURE_OPTIONS}
    -DPCL_INDOOR_BUILD_TESTS=OFF
    -DPCL_INDOOR_BUILD_EXPERIMENTS=OFF
    -DPCL_INDOOR_BUILD_PYTHON=OFF
    -DPCL_INDOOR_WITH_TORCH=OFF
)
vcpkg_cmake_install()
vcpkg_cmake_config_fixup(PACKAGE_NAME pcl_indoor CONFIG_PATH lib/cmake/pcl_indoor)
vcpkg_fixup_pkgconfig()
if("tools" IN_LIST FEATURES)
  vcpkg_copy_tools(
    TOOL_NAMES pcl_eppf_classify pcl_eppf_estimation pcl_hough_normals pcl_indoor_export pcl_indoor_pipeline
      pcl_indoor_query pcl_noise_resilient_lccp pcl_room_segmentation pcl_scan_simulation
    AUTO_CLEAN
  )
endif()
file(REMOVE_RECURSE "${CURRENT_PACKAGES_DIR}/debug/include" "${CURRENT_PACKAGES_DIR}/debug/share")
file(INSTALL "${CMAKE_CURRENT_LIST_DIR}/usage" DESTINATION "${CURRENT_PACKAGES_DIR}/share/${PORT}")
vcpkg_install_copyright(FILE_LIST "${SOURCE_PATH}/LICENSE" "${SOURCE_PATH}/LICENSES/MIT.txt")
