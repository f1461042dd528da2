/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include "pictures/svg_drawing.h"

#include <pcl/indoor/exports.h>
#include <pcl/ml/classification_metrics.h>

#include <string>
#include <vector>

namespace pcl::indoor::tool {

/** \brief A confusion matrix as a picture: a row per true class, in per cent of the
 * row. */
PCL_INDOOR_EXPORTS SvgDrawing
confusionPicture(const ConfusionMatrix& confusion,
                 const std::vector<std::string>& names);

} // namespace pcl::indoor::tool
