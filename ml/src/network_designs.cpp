/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include <pcl/ml/network_designs.h>

#include <pcl/exceptions.h>

#include <algorithm>
#include <cmath>

namespace pcl::indoor {

namespace {

void
requireClasses(int class_count)
{
  if (class_count < 2)
    PCL_THROW_EXCEPTION(BadArgumentException,
                        "A classifier needs at least 2 classes, not " << class_count);
}

Layer
dense(int count)
{
  return {LayerKind::Dense, {count}};
}

Layer
dropout(float rate)
{
  return {LayerKind::Dropout, {}, rate};
}

/** \brief What the three networks of Table 5.1 end with, from the third convolution's
 * channels on. */
void
addEnd(Network& network, int class_count)
{
  auto& layers = network.layers;
  layers.push_back(dense(1024));
  layers.push_back({LayerKind::Relu});
  layers.push_back(dropout(0.5f));
  layers.push_back(dense(class_count));
}

/** \brief A network on a histogram: roots of its bins, centred and scaled. */
Network
histogramNetwork(const Shape& input)
{
  return {input, {{LayerKind::SquareRoot}, {LayerKind::Scale}}};
}

void
addConvolution(Network& network, const Shape& extents)
{
  network.layers.push_back({LayerKind::Convolution, extents});
  network.layers.push_back({LayerKind::Relu});
}

/** \brief A shared dense layer over points, as a convolution of one position. */
void
addPointLayer(std::vector<Layer>& layers, int channels)
{
  layers.push_back({LayerKind::Convolution, {channels, 1}});
  layers.push_back({LayerKind::BatchNorm});
  layers.push_back({LayerKind::Relu});
}

void
addDense(std::vector<Layer>& layers, int count)
{
  layers.push_back(dense(count));
  layers.push_back({LayerKind::BatchNorm});
  layers.push_back({LayerKind::Relu});
}

/** \brief A transform net: a small PointNet that ends with a matrix. */
Layer
transformNet(int channels, const std::vector<int>& widths)
{
  Layer transform{LayerKind::Transform};
  addPointLayer(transform.inner, widths[1]);
  addPointLayer(transform.inner, widths[3]);
  addPointLayer(transform.inner, widths[4]);
  transform.inner.push_back({LayerKind::MaxOverPositions});
  addDense(transform.inner, widths[5]);
  addDense(transform.inner, widths[6]);
  transform.inner.push_back(dense(channels * channels));
  return transform;
}

} // namespace

Network
eppfNetwork4D(int class_count)
{
  requireClasses(class_count);
  auto network = histogramNetwork({1, 20, 4, 5, 3});
  addConvolution(network, {32, 5, 2, 2, 1});
  addConvolution(network, {64, 5, 2, 2, 1});
  network.layers.push_back({LayerKind::Reshape, {64, 40, 30}});
  addConvolution(network, {48, 5, 5});
  network.layers.push_back({LayerKind::MaxPool, {2, 2}});
  addEnd(network, class_count);
  return network;
}

Network
eppfNetwork3D(int class_count)
{
  requireClasses(class_count);
  auto network = histogramNetwork({1, 20, 4, 15});
  for (const int channels : {32, 64, 48})
    addConvolution(network, {channels, 5, 5, 1});
  network.layers.push_back({LayerKind::Reshape, {48, 40, 30}});
  network.layers.push_back({LayerKind::MaxPool, {2, 2}});
  addEnd(network, class_count);
  return network;
}

Network
eppfNetwork2D(int class_count)
{
  requireClasses(class_count);
  auto network = histogramNetwork({1, 40, 30});
  for (const int channels : {32, 64, 48})
    addConvolution(network, {channels, 5, 5});
  network.layers.push_back({LayerKind::MaxPool, {2, 2}});
  addEnd(network, class_count);
  return network;
}

Network
perceptron(int class_count, const PerceptronOptions& options)
{
  requireClasses(class_count);
  if (options.input_count < 1)
    PCL_THROW_EXCEPTION(BadArgumentException,
                        "A perceptron needs at least 1 input, not "
                            << options.input_count);
  auto network = histogramNetwork({options.input_count});
  if (options.input_dropout > 0.0f)
    network.layers.push_back(dropout(options.input_dropout));
  for (const int count : options.hidden) {
    network.layers.push_back(dense(count));
    network.layers.push_back({LayerKind::Relu});
    network.layers.push_back(dropout(options.dropout));
  }
  network.layers.push_back(dense(class_count));
  return network;
}

Network
pointNet(int class_count, int point_count, double width)
{
  requireClasses(class_count);
  if (point_count < 1 || !(width > 0.0) || width > 16.0)
    PCL_THROW_EXCEPTION(BadArgumentException,
                        "PointNet needs at least 1 point, not "
                            << point_count << ", and a width in 0 ... 16, not "
                            << width);
  std::vector<int> widths;
  for (const int published : {64, 64, 64, 128, 1024, 512, 256})
    widths.push_back(std::max(1, static_cast<int>(std::lround(published * width))));
  Network network{{3, point_count}, {}};
  auto& layers = network.layers;
  layers.push_back(transformNet(3, widths));
  addPointLayer(layers, widths[0]);
  addPointLayer(layers, widths[1]);
  layers.push_back(transformNet(widths[1], widths));
  for (const int k : {2, 3, 4})
    addPointLayer(layers, widths[static_cast<std::size_t>(k)]);
  layers.push_back({LayerKind::MaxOverPositions});
  addDense(layers, widths[5]);
  addDense(layers, widths[6]);
  layers.push_back(dropout(0.3f));
  layers.push_back(dense(class_count));
  return network;
}

} // namespace pcl::indoor
