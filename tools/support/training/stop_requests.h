/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

namespace pcl::indoor::tool {

/** \brief Lets Ctrl-C end the training after its epoch, for as long as this lives. */
class StopRequests {
public:
  StopRequests();
  StopRequests(const StopRequests&) = delete;
  StopRequests&
  operator=(const StopRequests&) = delete;
  ~StopRequests();

  /** \brief Was there one? */
  static bool
  isThereOne();

private:
  using Handler = void (*)(int);
  Handler interrupt_;
  Handler terminate_;
};

} // namespace pcl::indoor::tool
