/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "files/output_file.h"
#include "training/training_report.h"

#include <cstddef>
#include <fstream>
#include <string>
#include <utility>

namespace pcl::indoor::tool {

/** \brief The epochs as they come, and what is written of them while they come. */
class EpochWriter {
public:
  EpochWriter(std::string path, bool has_validation)
  : path_(std::move(path))
  , has_validation_(has_validation)
  {}

  /** \brief Write what the networks so far gave, also before a resume. */
  void
  write(const EpochLog& log)
  {
    if (path_.empty())
      return;
    stream_.close();
    saveText(path_, logText(log, has_validation_));
    stream_.open(path_, std::ios::app);
  }

  void
  add(std::size_t network, const EpochReport& epoch)
  {
    if (!path_.empty())
      stream_ << logLine(network, epoch, has_validation_) << std::flush;
  }

private:
  std::string path_;
  bool has_validation_;
  std::ofstream stream_;
};

} // namespace pcl::indoor::tool
