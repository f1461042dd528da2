/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <ATen/ATen.h>

#include <vector>

namespace pcl::indoor {

/** \brief AdamW (Loshchilov and Hutter, ICLR 2019); without decay, Adam (Kingma and Ba,
 * ICLR 2015). Rates of decay of the moments 0.9 and 0.999, epsilon 1e-8. */
class Adam {
public:
  Adam(const std::vector<at::Tensor>& parameters, double weight_decay);

  /** \brief Change the parameters by their gradients, and forget these. */
  void
  step(double learning_rate);

  /** \brief Number of steps, and first and second moments of each parameter. */
  std::int64_t step_count = 0;
  std::vector<std::vector<float>>
  moments() const;
  void
  setMoments(const std::vector<std::vector<float>>& moments);

private:
  std::vector<at::Tensor> parameters_;
  std::vector<at::Tensor> means_;   // of the gradients
  std::vector<at::Tensor> squares_; // mean squares
  double weight_decay_;
};

} // namespace pcl::indoor
