/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "adam.h"

#include <ATen/Parallel.h>

#include <cmath>

namespace pcl::indoor {

namespace {

/** \brief Factors of a step. */
struct Step {
  float decay;           ///< of the parameters
  float rate;            ///< learning rate over the first moment's correction
  float root_correction; ///< 1 over the root of the second moment's correction
};

constexpr double mean_decay = 0.9;
constexpr double square_decay = 0.999;
constexpr auto keep_mean = static_cast<float>(mean_decay);
constexpr auto keep_square = static_cast<float>(square_decay);
constexpr float epsilon = 1e-8f;

/** \brief One pass over the memory instead of one per operation. */
void
stepOnCPU(const Step& step,
          float* values,
          const float* gradients,
          float* means,
          float* squares,
          std::int64_t count)
{
  at::parallel_for(0, count, 1 << 15, [&](std::int64_t begin, std::int64_t end) {
    for (auto k = begin; k < end; ++k) {
      const float g = gradients[k];
      means[k] = keep_mean * means[k] + (1.0f - keep_mean) * g;
      squares[k] = keep_square * squares[k] + (1.0f - keep_square) * g * g;
      const float root = std::sqrt(squares[k]) * step.root_correction + epsilon;
      values[k] = step.decay * values[k] - step.rate * means[k] / root;
    }
  });
}

void
stepOnDevice(const Step& step,
             at::Tensor& values,
             const at::Tensor& gradients,
             at::Tensor& means,
             at::Tensor& squares)
{
  means.mul_(keep_mean).add_(gradients, 1.0f - keep_mean);
  squares.mul_(keep_square).addcmul_(gradients, gradients, 1.0f - keep_square);
  const auto root = squares.sqrt().mul_(step.root_correction).add_(epsilon);
  values.mul_(step.decay).addcdiv_(means, root, -step.rate);
}

} // namespace

Adam::Adam(const std::vector<at::Tensor>& parameters, double weight_decay)
: parameters_(parameters)
, weight_decay_(weight_decay)
{
  for (const auto& parameter : parameters) {
    means_.push_back(at::zeros_like(parameter.detach()));
    squares_.push_back(at::zeros_like(parameter.detach()));
  }
}

void
Adam::step(double learning_rate)
{
  ++step_count;
  const auto count = static_cast<double>(step_count);
  const double first = 1.0 - std::pow(mean_decay, count);
  const double second = 1.0 - std::pow(square_decay, count);
  const Step step{static_cast<float>(1.0 - learning_rate * weight_decay_),
                  static_cast<float>(learning_rate / first),
                  static_cast<float>(1.0 / std::sqrt(second))};
  for (std::size_t k = 0; k < parameters_.size(); ++k) {
    auto values = parameters_[k].detach(); // shares the memory
    const auto gradients = parameters_[k].grad().contiguous();
    if (values.is_cpu())
      stepOnCPU(step,
                values.data_ptr<float>(),
                gradients.data_ptr<float>(),
                means_[k].data_ptr<float>(),
                squares_[k].data_ptr<float>(),
                values.numel());
    else
      stepOnDevice(step, values, gradients, means_[k], squares_[k]);
    parameters_[k].mutable_grad().reset();
  }
}

std::vector<std::vector<float>>
Adam::moments() const
{
  std::vector<std::vector<float>> result;
  for (const auto* kind : {&means_, &squares_})
    for (const auto& tensor : *kind) {
      const auto values = tensor.to(at::kCPU);
      const auto* first = values.data_ptr<float>();
      result.emplace_back(first, first + values.numel());
    }
  return result;
}

void
Adam::setMoments(const std::vector<std::vector<float>>& moments)
{
  auto source = moments.begin();
  for (auto* kind : {&means_, &squares_})
    for (auto& tensor : *kind) {
      const auto values = at::tensor(*source++, at::kFloat).view_as(tensor);
      tensor.copy_(values);
    }
}

} // namespace pcl::indoor
