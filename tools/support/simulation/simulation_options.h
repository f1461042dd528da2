/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "command_line/options.h"
#include "simulation/scanner_options.h"

#include <string>

namespace pcl::indoor::tool {

/** \brief What the command line of pcl_scan_simulation says. */
struct SimulationOptions {
  std::string plan_file, output_file, json_file, stations_file;
  std::string view, target = "0,0,0.7"; // X,Y,Z or random; no view: a moving sensor
  ScannerOptions scanner;
  double leaf_size = 0.04;
  double lean = -1.0;         // degrees; -1: as the plan says
  double lean_towards = -1.0; // degrees; -1: the walls that the plan names
};

/** \brief Its command line.
 * \param[in,out] options must outlive the parser */
OptionParser
simulationParser(SimulationOptions& options);

/** \brief Find out before the work what does not fit together, and what cannot be
 * written.
 * \throws ToolError naming it */
void
requireUsable(const SimulationOptions& options);

} // namespace pcl::indoor::tool
