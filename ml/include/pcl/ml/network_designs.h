/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/indoor/exports.h>
#include <pcl/ml/network.h>

namespace pcl::indoor {

/** \brief The network of Table 5.1 on the thesis's descriptor of 20 x 4 x 5 x 3 bins.
 *
 * Roots of the bins, centred and scaled; two 4D convolutions of 5 x 2 x 2 x 1 (32 and
 * 64 channels), then, as an image of 40 x 30, one of 5 x 5 (48), pooling of 2 x 2,
 * dense 1,024, dropout 0.5, classes. SAME padding, ReLU after each; 14,400 values go
 * into the dense layer (Table 5.1 prints 192, which does not follow from its other
 * sizes).
 */
PCL_INDOOR_EXPORTS Network
eppfNetwork4D(int class_count);

/** \brief Its rival on 20 x 4 x 15 bins: three 3D convolutions of 5 x 5 x 1. */
PCL_INDOOR_EXPORTS Network
eppfNetwork3D(int class_count);

/** \brief Its rival on 40 x 30 bins: three 2D convolutions of 5 x 5. */
PCL_INDOOR_EXPORTS Network
eppfNetwork2D(int class_count);

/** \brief Sizes of a perceptron on a histogram and what else is known of an object. */
struct PerceptronOptions {
  int input_count = 1200;            ///< values of an object, at least 1
  std::vector<int> hidden{256, 256}; ///< values of each hidden layer
  float dropout = 0.5f;              ///< after each hidden layer, 0 ... 1
  float input_dropout = 0.0f;        ///< of the inputs, 0 ... 1
};

/** \brief Square root and scale of each value, then dense layers with ReLU and dropout.
 */
PCL_INDOOR_EXPORTS Network
perceptron(int class_count, const PerceptronOptions& options);

/** \brief PointNet (Qi et al., CVPR 2017), the thesis's baseline, with its input
 * transform (3 x 3) and feature transform (64 x 64).
 * \param[in] point_count points of an object
 * \param[in] width 1: the published widths (64, 64, 64, 128, 1024; 512, 256); else all
 * but the first and the inputs are multiplied by it
 */
PCL_INDOOR_EXPORTS Network
pointNet(int class_count, int point_count, double width = 1.0);

} // namespace pcl::indoor
