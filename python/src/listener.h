/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pybind11/pybind11.h>

#include <cstddef>
#include <mutex>
#include <string>
#include <utility>
#include <vector>

namespace pcl::indoor::python {

/** \brief Hears what the library says while it works, from any of its threads. */
class Listener {
public:
  /** \param[in] progress called with stage, done and all; or None */
  explicit Listener(pybind11::object progress)
  : progress_(std::move(progress))
  {}

  /** \brief Tell Python how far it is; an exception, also of Ctrl-C, ends the work. */
  void
  update(const std::string& stage, std::size_t done, std::size_t all) const
  {
    const pybind11::gil_scoped_acquire lock;
    if (PyErr_CheckSignals() != 0)
      throw pybind11::error_already_set();
    if (!progress_.is_none())
      progress_(stage, done, all);
  }

  /** \brief Keep a line for the end. */
  void
  say(const std::string& line)
  {
    const std::lock_guard<std::mutex> lock(mutex_);
    lines_.push_back(line);
  }

  const std::vector<std::string>&
  lines() const
  {
    return lines_;
  }

private:
  pybind11::object progress_;
  std::mutex mutex_;
  std::vector<std::string> lines_;
};

/** \brief Work without Python's lock. */
template <typename Work>
auto
withoutLock(const Work& work)
{
  const pybind11::gil_scoped_release release;
  return work();
}

} // namespace pcl::indoor::python
