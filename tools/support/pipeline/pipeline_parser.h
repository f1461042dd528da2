/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "command_line/options.h"
#include "pipeline/pipeline_options.h"

namespace pcl::indoor::tool {

constexpr const char* single_process_option = "-single_process";

/** \brief The defaults, which the option -preset changes. */
PipelineOptions
pipelineOptions(int argc, const char* const* argv);

/** \brief The command line of the pipeline.
 * \param[in,out] options must outlive the parser */
OptionParser
pipelineParser(PipelineOptions& options);

} // namespace pcl::indoor::tool
