/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "pictures/svg_drawing.h"

#include <pcl/ml/classification_metrics.h>
#include <pcl/ml/network_training.h>

#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief The epochs of one network after the other of an ensemble. */
using EpochLog = std::vector<std::vector<EpochReport>>;

/** \brief An epoch as a line of CSV.
 * \param[in] network number of the network, from 1
 */
std::string
logLine(std::size_t network, const EpochReport& epoch, bool has_validation);

/** \brief All epochs as CSV, with the header. */
std::string
logText(const EpochLog& log, bool has_validation);

/** \brief Loss and accuracy over the epochs, for training and validation of each
 * network. */
SvgDrawing
curvesPicture(const EpochLog& log, bool has_validation);

/** \brief The scores of a test in one line, in per cent. */
std::string
scoresText(const ConfusionMatrix& confusion);

} // namespace pcl::indoor::tool
