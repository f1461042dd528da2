/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

namespace pcl::indoor {

/** \brief For as long as this lives, libtorch has so many threads, and memory that was
 * freed stays with the process: each step allocates what the last one freed, and having
 * it from the system anew costs a sixth of a step. */
class TrainingResources {
public:
  explicit TrainingResources(int threads);
  TrainingResources(const TrainingResources&) = delete;
  TrainingResources&
  operator=(const TrainingResources&) = delete;
  ~TrainingResources();

private:
  int threads_before_;
};

} // namespace pcl::indoor
