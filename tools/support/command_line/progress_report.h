/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "command_line/progress.h"
#include "text/printable.h"
#include "text/stage_report.h"

namespace pcl::indoor::tool {

/** \brief Says on the terminal what is being done. */
class ProgressReport : public StageReport {
public:
  explicit ProgressReport(Progress& progress)
  : progress_(progress)
  {}

  void
  start(const std::string& what) override
  {
    progress_.start(what);
  }

  void
  update(std::size_t done, std::size_t all) override
  {
    progress_.update(done, all);
  }

  void
  done(const std::string& result) override
  {
    progress_.done(result);
  }

  void
  warn(const std::string& line) override
  {
    printWarning(line);
  }

private:
  Progress& progress_;
};

} // namespace pcl::indoor::tool
