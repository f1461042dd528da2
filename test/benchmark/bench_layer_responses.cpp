/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// What the layers of a 4D network make of an object, as Fig. 5.17 of the thesis shows
// it:
//
//     bench_layer_responses MODEL OBJECT PICTURE.png
//
// MODEL is of pcl_eppf_train -network 4d. Left the roots of the descriptor's bins, in
// the middle and right the responses of the first filter of the first two layers,
// before ReLU. A row per bin of f4; in it, from top to bottom, a block per bin of f3,
// with f1 along x and f2 along y. The median of a column is white, lower values are
// blue, higher ones red.
#include "command_line/options.h"
#include "objects/object_files.h"
#include "pictures/svg_drawing.h"
#include "pictures/svg_raster.h"

#include <pcl/ml/model_file.h>
#include <pcl/ml/network_inference.h>
#include <pcl/ml/object_classifier.h>

#include <algorithm>
#include <cmath>
#include <cstdio>

using namespace pcl::indoor;
using namespace pcl::indoor::tool;

namespace {

const Shape grid{20, 4, 5, 3}; // bins of f1 ... f4
constexpr int cell = 9;
constexpr double gap = 4.0, left = 40.0, top = 30.0;
constexpr double panel_width = 20 * cell + 20.0,
                 panel_height = 5 * (4 * cell + gap) + 16.0;

/** \brief The value in a bin. */
float
valueAt(const Tensor& tensor, int a, int b, int c, int d)
{
  const int place = ((a * grid[1] + b) * grid[2] + c) * grid[3] + d;
  return tensor.values[static_cast<std::size_t>(place)];
}

/** \brief The roots of the bins, and the values after each of the first two
 * convolutions. */
std::vector<Tensor>
shownValues(const ClassifierModel& model, const std::string& object_path)
{
  const auto object = loadPlacedObject(object_path, 20);
  const auto input =
      classifierInput(classifierPoints(*object.cloud), object.place, model.input, 1);
  const auto& network = model.networks.front();
  if (network.input != Shape{1, grid[0], grid[1], grid[2], grid[3]})
    throw ToolError("the model is of no 4D network on 20 x 4 x 5 x 3 bins");
  std::vector<Tensor> responses;
  networkScores(network, {input}, &responses);
  std::vector<Tensor> shown;
  for (std::size_t k = 0; k < network.layers.size() && shown.size() < 3; ++k)
    if (network.layers[k].kind == LayerKind::SquareRoot ||
        network.layers[k].kind == LayerKind::Convolution)
      shown.push_back(responses[k]);
  return shown;
}

/** \brief White for 0, red for 1, blue for -1. */
Color
signedColor(double value)
{
  const auto faded =
      static_cast<std::uint8_t>(255.0 * (1.0 - std::min(std::abs(value), 1.0)));
  return value < 0.0 ? Color{faded, faded, 255} : Color{255, faded, faded};
}

/** \brief The first channel of a tensor, moved and scaled to -1 ... 1, its median at 0.
 */
Tensor
scaledChannel(const Tensor& tensor)
{
  Tensor channel{grid, tensor.values};
  auto& values = channel.values;
  values.resize(valueCount(grid));
  auto sorted = values;
  std::sort(sorted.begin(), sorted.end());
  const float median = sorted[sorted.size() / 2];
  const float reach =
      std::max({sorted.back() - median, median - sorted.front(), 1e-6f});
  for (float& value : values)
    value = (value - median) / reach;
  return channel;
}

SvgDrawing
pictureOf(const std::vector<Tensor>& shown)
{
  const char* const names[] = {"Roots of bins", "Layer 1", "Layer 2"};
  SvgDrawing picture(left + 3 * panel_width, top + grid[3] * panel_height);
  picture.rectangle({0.0, 0.0}, {picture.width(), picture.height()}, light_grey);
  for (int column = 0; column < 3; ++column) {
    const auto tensor = scaledChannel(shown[static_cast<std::size_t>(column)]);
    const double x = left + column * panel_width;
    picture.text({x, 0.5 * top}, names[column], {Anchor::Start, 15.0});
    for (int d = 0; d < grid[3]; ++d)
      for (int c = 0; c < grid[2]; ++c) {
        PixelImage block(grid[0], grid[1]);
        for (int a = 0; a < grid[0]; ++a)
          for (int b = 0; b < grid[1]; ++b)
            block.set(a, b, signedColor(valueAt(tensor, a, b, c, d)));
        const double y = top + d * panel_height + c * (grid[1] * cell + gap);
        picture.image({x, y}, block.enlarged(cell));
      }
  }
  for (int d = 0; d < grid[3]; ++d)
    picture.text({4.0, top + (d + 0.5) * panel_height - gap},
                 formatted("f4: %d", d + 1));
  return picture;
}

} // namespace

int
main(int argc, char** argv)
{
  if (argc != 4) {
    std::fprintf(stderr, "Syntax is: %s MODEL OBJECT PICTURE.png\n", argv[0]);
    return 1;
  }
  try {
    savePictures(
        {{argv[3], pictureOf(shownValues(loadModel(argv[1]), argv[2])).str()}});
  } catch (const std::exception& error) {
    std::fprintf(stderr, "bench_layer_responses: %s\n", error.what());
    return 1;
  }
}
