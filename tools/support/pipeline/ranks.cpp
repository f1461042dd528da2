/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "pipeline/ranks.h"

#ifdef PCL_INDOOR_WITH_MPI
#define OMPI_SKIP_MPICXX // bindings that nobody needs
#include <mpi.h>
#endif

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <thread>

namespace pcl::indoor::tool {

#ifdef PCL_INDOOR_WITH_MPI

namespace {

/** What launchers tell the processes that they start: Open MPI's mpirun, those by PMI
 * or PMIx, as Slurm's srun. */
bool
isLaunched()
{
  for (const char* name : {"OMPI_COMM_WORLD_SIZE", "PMI_SIZE", "PMIX_RANK"})
    if (std::getenv(name) != nullptr)
      return true;
  return false;
}

} // namespace

Ranks::Ranks(bool single)
{
  if (!single && isLaunched()) {
    int given = 0; // the level of threads
    MPI_Init_thread(nullptr, nullptr, MPI_THREAD_FUNNELED, &given);
    MPI_Comm_rank(MPI_COMM_WORLD, &rank_);
    MPI_Comm_size(MPI_COMM_WORLD, &count_);
  }
  is_dismissed_.assign(static_cast<std::size_t>(count_), false);
}

Ranks::~Ranks()
{
  int is_running = 0;
  MPI_Initialized(&is_running);
  if (is_running != 0)
    MPI_Finalize();
}

void
Ranks::send(int rank, const RankMessage& message)
{
  MPI_Send(&message, sizeof(message), MPI_BYTE, rank, 0, MPI_COMM_WORLD);
}

std::pair<int, RankMessage>
Ranks::receive()
{
  MPI_Status status;
  for (int is_there = 0;;) { // MPI itself would wait in a busy loop
    MPI_Iprobe(MPI_ANY_SOURCE, 0, MPI_COMM_WORLD, &is_there, &status);
    if (is_there != 0)
      break;
    std::this_thread::sleep_for(std::chrono::milliseconds(1));
  }
  RankMessage message;
  MPI_Recv(&message,
           sizeof(message),
           MPI_BYTE,
           status.MPI_SOURCE,
           0,
           MPI_COMM_WORLD,
           MPI_STATUS_IGNORE);
  return {status.MPI_SOURCE, message};
}

void
Ranks::endAll()
{
  MPI_Abort(MPI_COMM_WORLD, EXIT_FAILURE);
  std::_Exit(EXIT_FAILURE);
}

#else // one process

Ranks::Ranks(bool)
: is_dismissed_(1, false)
{}

Ranks::~Ranks() = default;

void
Ranks::send(int, const RankMessage&)
{}

std::pair<int, RankMessage>
Ranks::receive()
{
  return {};
}

void
Ranks::endAll()
{
  std::_Exit(EXIT_FAILURE);
}

#endif

void
Ranks::dismiss(int rank)
{
  send(rank, {});
  is_dismissed_[static_cast<std::size_t>(rank)] = true;
}

void
Ranks::dismissAll()
{
  const auto is_left = [this] {
    return std::find(is_dismissed_.begin() + 1, is_dismissed_.end(), false) !=
           is_dismissed_.end();
  };
  while (is_left())
    dismiss(receive().first);
}

} // namespace pcl::indoor::tool
