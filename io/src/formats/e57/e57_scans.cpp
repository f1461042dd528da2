/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
// Facts of the format: ASTM E2807-11, sections 6 to 8.
#include "formats/e57/e57_scans.h"

#include "files/tool_error.h"
#include "text/printable.h"
#include "text/words.h"

#include <boost/algorithm/string/trim.hpp>
#include <pugixml.hpp>

#include <cmath>
#include <cstring>
#include <limits>

namespace pcl::indoor::tool {
namespace {

constexpr std::uint64_t longest_description = 16 << 20; // bytes: 3,000 scans
constexpr std::size_t longest_name = 60;                // bytes: fits into a line
constexpr std::size_t most_fields = 1000;               // of a point, as of a table

/** The description, an XML tree. */
class Description {
public:
  explicit Description(const std::string& path)
  : path_(path)
  {}

  [[noreturn]] void
  refuse(const std::string& problem) const
  {
    throw ToolError(path_ + ": the description of this E57 file " + problem);
  }

  /** A number that a text or attribute of an element tells. */
  template <typename T>
  T
  number(const char* text, const pugi::xml_node& node) const
  {
    const auto word = boost::algorithm::trim_copy(std::string(text));
    T value = 0;
    if (!readWord(word, value))
      refuse("is damaged: '" + printable(word, longest_name) + "' in " +
             printable(node.name(), longest_name) + " is not a usable number");
    return value;
  }

  /** \param[in] otherwise the value where it is not told */
  template <typename T>
  T
  attribute(const pugi::xml_node& node, const char* name, T otherwise) const
  {
    const auto found = node.attribute(name);
    return found ? number<T>(found.value(), node) : otherwise;
  }

  /** The value of a child; an element without text is 0. */
  std::optional<double>
  child(const pugi::xml_node& node, const char* name) const
  {
    const auto found = node.child(name);
    if (!found)
      return {};
    const char* const text = found.child_value();
    return *text == '\0' ? 0.0 : number<double>(text, found);
  }

private:
  std::string path_;
};

void
readPose(const pugi::xml_node& pose, const Description& about, E57Scan& scan)
{
  const auto rotation = pose.child("rotation"), translation = pose.child("translation");
  Eigen::Quaterniond turn = Eigen::Quaterniond::Identity();
  if (rotation)
    turn = Eigen::Quaterniond(about.child(rotation, "w").value_or(0),
                              about.child(rotation, "x").value_or(0),
                              about.child(rotation, "y").value_or(0),
                              about.child(rotation, "z").value_or(0));
  const Eigen::Vector3d shift(about.child(translation, "x").value_or(0),
                              about.child(translation, "y").value_or(0),
                              about.child(translation, "z").value_or(0));
  const double length = turn.norm();
  if (!(length > 0) || !std::isfinite(length) || !shift.allFinite())
    about.refuse("is damaged: the pose of '" + scan.name + "' is none");
  scan.pose.linear() = turn.normalized().toRotationMatrix();
  scan.pose.translation() = shift;
}

E57Field
readField(const pugi::xml_node& node, const Description& about)
{
  using Kind = E57Field::Kind;
  E57Field field;
  field.name = node.name();
  const std::string type = node.attribute("type").value();
  if (type == "Float") {
    const bool is_single =
        std::strcmp(node.attribute("precision").value(), "single") == 0;
    field.kind = is_single ? Kind::Single : Kind::Double;
    field.bits = is_single ? 32 : 64;
    return field;
  }
  if (type != "Integer" && type != "ScaledInteger") {
    field.kind = Kind::Other;
    return field;
  }
  using Limits = std::numeric_limits<std::int64_t>;
  field.minimum = about.attribute(node, "minimum", Limits::min());
  field.maximum = about.attribute(node, "maximum", Limits::max());
  if (field.maximum < field.minimum)
    about.refuse("is damaged: the maximum of " + printable(field.name, longest_name) +
                 " is less than its minimum");
  const auto range = static_cast<std::uint64_t>(field.maximum) -
                     static_cast<std::uint64_t>(field.minimum);
  while (field.bits < 64 && range >> field.bits != 0)
    ++field.bits;
  if (type == "ScaledInteger") {
    field.kind = Kind::Scaled;
    field.scale = about.attribute(node, "scale", 1.0);
    field.offset = about.attribute(node, "offset", 0.0);
  }
  return field;
}

void
readColorLimits(const pugi::xml_node& limits, const Description& about, E57Scan& scan)
{
  constexpr const char* names[][2] = {{"colorRedMinimum", "colorRedMaximum"},
                                      {"colorGreenMinimum", "colorGreenMaximum"},
                                      {"colorBlueMinimum", "colorBlueMaximum"}};
  for (std::size_t channel = 0; channel < 3; ++channel) {
    const auto least = about.child(limits, names[channel][0]);
    const auto largest = about.child(limits, names[channel][1]);
    if (least && largest && *largest > *least)
      scan.colors[channel] = E57Scan::Limits{*least, *largest};
  }
}

E57Scan
readScan(const pugi::xml_node& node, std::size_t number, const Description& about)
{
  E57Scan scan;
  scan.name = printable(node.child_value("name"), longest_name);
  if (scan.name.empty())
    scan.name = "scan " + std::to_string(number);
  if (const auto pose = node.child("pose"))
    readPose(pose, about, scan);
  readColorLimits(node.child("colorLimits"), about, scan);
  const auto points = node.child("points");
  scan.section = about.attribute(points, "fileOffset", std::uint64_t{0});
  scan.count = about.attribute(points, "recordCount", std::uint64_t{0});
  for (const auto& field : points.child("prototype").children())
    if (field.type() == pugi::node_element)
      scan.fields.push_back(readField(field, about));
  if (scan.fields.size() > most_fields)
    about.refuse("has " + std::to_string(scan.fields.size()) +
                 " fields of a point, at most " + std::to_string(most_fields) +
                 " are read");
  for (const auto& codec : points.child("codecs").children())
    if (codec.type() == pugi::node_element && !codec.child("bitPackCodec"))
      about.refuse("names a way of packing points other than bitPackCodec");
  return scan;
}

/** The header of the file: which bytes the description are. */
std::string
descriptionText(E57Pages& pages)
{
  struct {
    char signature[8];
    std::uint32_t major, minor;
    std::uint64_t length, description, description_length, page_size;
  } header;
  static_assert(sizeof(header) == 48);
  const auto& path = pages.path();
  if (pages.size() == 0)
    throw ToolError(path + ": the file is truncated, an E57 file has at least " +
                    std::to_string(E57Pages::page_size) + " bytes");
  pages.read(0, &header, sizeof(header));
  if (header.major != 1)
    throw ToolError(path + ": this E57 file is of version " +
                    std::to_string(header.major) + "." + std::to_string(header.minor) +
                    ", 1.0 is read");
  if (header.page_size != E57Pages::page_size)
    throw ToolError(path + ": the pages of this E57 file have " +
                    std::to_string(header.page_size) + " bytes, 1024 are read");
  const auto size = pages.size() / E57Pages::content_size * E57Pages::page_size;
  if (header.length > size)
    throw ToolError(path + ": the file is truncated, its header promises " +
                    std::to_string(header.length) + " bytes, it has " +
                    std::to_string(size) + " in whole pages");
  const auto place = pages.logicalPlace(header.description, "its description");
  if (header.description_length > std::min(longest_description, pages.size() - place))
    throw ToolError(path + ": the file is damaged, a description of " +
                    std::to_string(header.description_length) + " bytes is promised");
  std::string text(header.description_length, '\0');
  pages.read(place, text.data(), text.size());
  return text;
}

} // namespace

std::vector<E57Scan>
readE57Scans(E57Pages& pages)
{
  auto text = descriptionText(pages);
  const Description about(pages.path());
  pugi::xml_document document;
  const auto parsed = document.load_buffer_inplace(text.data(), text.size());
  if (parsed.status == pugi::status_out_of_memory)
    throw std::bad_alloc();
  if (!parsed)
    about.refuse("is damaged at its byte " + std::to_string(parsed.offset) + ": " +
                 parsed.description());
  std::vector<E57Scan> scans;
  std::size_t number = 0;
  for (const auto& scan : document.child("e57Root").child("data3D").children())
    if (scan.type() == pugi::node_element)
      scans.push_back(readScan(scan, ++number, about));
  return scans;
}

} // namespace pcl::indoor::tool
