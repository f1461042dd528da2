/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "training/stop_requests.h"

#include <csignal>

namespace pcl::indoor::tool {
namespace {

volatile std::sig_atomic_t is_asked_to_stop = 0;

void
askToStop(int)
{
  is_asked_to_stop = 1;
}

} // namespace

StopRequests::StopRequests()
: interrupt_(std::signal(SIGINT, askToStop))
, terminate_(std::signal(SIGTERM, askToStop))
{
  if (interrupt_ == SIG_IGN) // in the background of a script
    std::signal(SIGINT, SIG_IGN);
}

StopRequests::~StopRequests()
{
  std::signal(SIGINT, interrupt_);
  std::signal(SIGTERM, terminate_);
}

bool
StopRequests::isThereOne()
{
  return is_asked_to_stop != 0;
}

} // namespace pcl::indoor::tool
