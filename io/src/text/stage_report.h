/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <cstddef>
#include <string>

namespace pcl::indoor::tool {

/** \brief Receives progress and warnings; this base class ignores them. */
class StageReport {
public:
  virtual ~StageReport() = default;

  /** \brief A stage begins. */
  virtual void
  start(const std::string& /*what*/)
  {}

  /** \brief How far it is. */
  virtual void
  update(std::size_t /*done*/, std::size_t /*all*/)
  {}

  /** \brief It has ended, with this result. */
  virtual void
  done(const std::string& /*result*/ = "")
  {}

  /** \brief Something is odd about the scan, one line. */
  virtual void
  warn(const std::string& /*line*/)
  {}
};

} // namespace pcl::indoor::tool
