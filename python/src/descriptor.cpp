/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "arguments.h"
#include "arrays.h"
#include "bindings.h"
#include "command_line/preset.h"
#include "listener.h"
#include "object_input.h"
#include "objects/described_object.h"
#include "objects/eppf_options.h"

#include <pybind11/stl.h>

#include <iterator>
#include <string>
#include <utility>
#include <vector>

namespace py = pybind11;

namespace pcl::indoor::python {
namespace {

/** What the command line of pcl_eppf_estimation says of one object. */
struct DescriptorSettings {
  int neighbor_count = 20;
  std::string preset = "default";
  tool::EPPFCommandLine eppf;

  explicit DescriptorSettings(const Arguments& arguments)
  {
    preset = tool::presetOf(arguments.count(), arguments.words()) == "thesis"
                 ? "thesis"
                 : "default";
    tool::OptionParser parser("descriptor", "");
    parser
        .number("-normal_neighbors",
                neighbor_count,
                "neighbours of a normal",
                "points",
                tool::Range::atLeast(3))
        .text("-preset", preset, "of the thesis", {"default", "thesis"});
    eppf.addDescriptorTo(parser,
                         preset == "thesis" ? tool::EPPFDescriptor::EPPF
                                            : tool::EPPFDescriptor::PairHarmonics);
    eppf.addTo(parser);
    arguments.readBy(std::move(parser));
    tool::requireFittingBins(eppf);
  }
};

template <typename SignatureT>
std::vector<float>
valuesOf(const ObjectInput& input, const DescriptorSettings& settings)
{
  const auto object = objectOf(input, settings.neighbor_count);
  const auto signature = tool::describedObject<SignatureT>(
      object.cloud, settings.eppf.options(), nameOf(input));
  return {std::begin(signature.histogram), std::end(signature.histogram)};
}

/** The values of the descriptor that was chosen, as pcl_eppf_estimation has them. */
std::vector<float>
described(const ObjectInput& input, const DescriptorSettings& settings)
{
  switch (settings.eppf.descriptor()) {
  case tool::EPPFDescriptor::EPPF:
    return valuesOf<EPPFSignature1200>(input, settings);
  case tool::EPPFDescriptor::EPPFShort:
    return valuesOf<EPPFSignature540>(input, settings);
  default:
    return valuesOf<PairHarmonicsSignature1200>(input, settings);
  }
}

py::array
descriptor(const ObjectInput& input, const std::vector<std::string>& words)
{
  const DescriptorSettings settings{Arguments(words)};
  return arrayOf(withoutLock([&] { return described(input, settings); }));
}

} // namespace

void
bindDescriptor(py::module_& module)
{
  module.def("descriptor", &descriptor);
}

} // namespace pcl::indoor::python
