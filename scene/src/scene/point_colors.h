/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "files/cloud_file.h"

#include <pcl/indoor/exports.h>

#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief Colours for viewers, by what was found: the option -colour.
 *
 * They are the field rgb, as PCL packs it. A label always has the same colour, in
 * pictures too; 0 and what is not of interest are grey.
 */
struct PCL_INDOOR_EXPORTS PointColors {
  std::string wanted = "auto";

  /** \brief Add the colours; those of the input stay unless the option is given.
   * \param[in,out] file has the fields that the labels are named after; of class, the
   * field is category
   * \param[in] automatic the label that auto means
   * \param[in] up the direction of heights
   * \param[in] other a label that is grey, too
   * \param[in] whole points that show the heights of the scan that \a file is a part
   * of; null: it is the whole
   */
  void
  apply(CloudFile& file,
        const std::string& automatic,
        const Eigen::Vector3f& up = Eigen::Vector3f::UnitZ(),
        std::uint32_t other = 0,
        const PointCloud<PointXYZ>* whole = nullptr) const;
};

} // namespace pcl::indoor::tool
