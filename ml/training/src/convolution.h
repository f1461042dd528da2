/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <ATen/ATen.h>

namespace pcl::indoor {

/** \brief Convolution of stride 1 over 0 to 4 extents of positions, with zeros around
 * (of n - 1, n / 2 after, the rest before), so that the positions stay.
 * \param[in] input (objects, channels in, positions ...)
 * \param[in] weights (channels out, channels in, kernel ...)
 */
at::Tensor
convolution(const at::Tensor& input,
            const at::Tensor& weights,
            const at::Tensor& biases);

/** \brief The same of any 4D kernel: for each position of the last extent, the sum over
 * the kernel's last extent of 3D convolutions. */
at::Tensor
stackedConvolution4D(const at::Tensor& input,
                     const at::Tensor& weights,
                     const at::Tensor& biases);

/** \brief All values of each object times weights (out, in), plus biases. */
at::Tensor
denseLayer(const at::Tensor& input,
           const at::Tensor& weights,
           const at::Tensor& biases);

} // namespace pcl::indoor
