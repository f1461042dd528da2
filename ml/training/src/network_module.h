/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <pcl/ml/network.h>

#include <ATen/ATen.h>

namespace pcl::indoor {

/** \brief A Network whose weights libtorch holds and can derive by. */
class NetworkModule {
public:
  /** \param[in] network with weights, see findProblem() */
  NetworkModule(const Network& network, const at::Device& device);

  /** \brief Scores (objects, classes) of inputs (objects, values).
   * \param[in] dropout its draws, on the CPU; null means not in training: no dropout,
   * and BatchNorm takes its running mean and variance instead of changing them
   */
  at::Tensor
  scores(const at::Tensor& inputs, at::Generator* dropout) const;

  /** \brief What is trained, layer by layer: all but Scale's weights and the mean and
   * variance of BatchNorm. */
  const std::vector<at::Tensor>&
  parameters() const
  {
    return parameters_;
  }

  /** \brief The network with the weights as they are now. */
  Network
  network() const;

private:
  /** \brief A layer's weights, and those of its inner layers. */
  struct Weights {
    std::vector<at::Tensor> own;
    std::vector<Weights> inner;
  };

  std::vector<Weights>
  load(const std::vector<Layer>& layers, const at::Device& device);

  at::Tensor
  apply(const std::vector<Layer>& layers,
        const std::vector<Weights>& weights,
        at::Tensor values,
        at::Generator* dropout) const;

  at::Tensor
  apply(const Layer& layer,
        const Weights& weights,
        const at::Tensor& values,
        at::Generator* dropout) const;

  static void
  store(std::vector<Layer>& layers, const std::vector<Weights>& weights);

  Network network_;                    // its weights are those that it came with
  std::vector<at::Tensor> parameters_; // before weights_, whose loading fills it
  std::vector<Weights> weights_;
};

} // namespace pcl::indoor
