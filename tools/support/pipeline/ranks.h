/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <utility>
#include <vector>

namespace pcl::indoor::tool {

/** \brief What ranks tell each other: the first one, which room is to be finished; the
 * others, which one they have finished, and that they wait for the next. */
struct RankMessage {
  std::int64_t room = -1;        ///< -1: none yet, or no more
  std::uint64_t point_count = 0; ///< of the room
  std::uint64_t has_normals = 0; ///< 1 if its points have
  std::uint64_t key = 0;         ///< of the run, see WorkFolder
  double pose[16] = {};          ///< of the building
  double metres_per_unit = 1.0;  ///< of the scan
};

/** \brief The processes that mpirun, or srun, has started for one run, with MPI between
 * them. Started otherwise there is one process, and MPI is not touched.
 *
 * Waiting does not keep a core busy. All functions are for one thread.
 */
class Ranks {
public:
  /** \param[in] single whether this process works alone, whoever has started it */
  explicit Ranks(bool single = false);
  ~Ranks();
  Ranks(const Ranks&) = delete;
  Ranks&
  operator=(const Ranks&) = delete;

  int
  count() const
  {
    return count_;
  }

  bool
  isFirst() const
  {
    return rank_ == 0;
  }

  void
  send(int rank, const RankMessage& message);

  /** \brief Wait for a message, from any rank. */
  std::pair<int, RankMessage>
  receive();

  /** \brief Tell a rank that waits that there are no more rooms. */
  void
  dismiss(int rank);

  /** \brief Wait for all ranks that are not dismissed, and dismiss them. */
  void
  dismissAll();

  /** \brief End the processes of all ranks, with exit status 1. */
  [[noreturn]] void
  endAll();

private:
  int rank_ = 0, count_ = 1;
  std::vector<bool> is_dismissed_;
};

} // namespace pcl::indoor::tool
