/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <Eigen/Core>

#include <optional>
#include <string>

namespace pcl::indoor {

/** \brief Where a scanner stood. */
struct Station {
  std::string name;
  /** In the frame of the file, the offset that it tells included; nothing if
   * the file does not tell. */
  std::optional<Eigen::Vector3d> position;
};

} // namespace pcl::indoor
