/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "rooms/work_folder.h"

#include <optional>
#include <string>

namespace pcl::indoor::tool {

/** \brief A folder for files of one run, removed with all that is in it. */
class TemporaryFolder {
public:
  /** \param[in] parent where it is made; empty: the system's folder for such files
   * \throws ToolError if it cannot be made */
  explicit TemporaryFolder(const std::string& parent);
  ~TemporaryFolder();
  TemporaryFolder(const TemporaryFolder&) = delete;
  TemporaryFolder&
  operator=(const TemporaryFolder&) = delete;

  WorkFolder&
  folder()
  {
    return *folder_;
  }

private:
  std::string path_;
  std::optional<WorkFolder> folder_;
};

} // namespace pcl::indoor::tool
