/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "formats/foreign_format.h"

#include <algorithm>
#include <cctype>
#include <filesystem>
#include <vector>

namespace pcl::indoor::tool {
namespace {

enum class Converter { Pdal, CloudCompare, Gunzip, Unzip };

struct Format {
  const char* name;
  std::vector<std::string> endings; ///< of file names, small letters
  Converter converter;
};

const std::vector<Format> formats = {
    {"a LAZ file", {".laz"}, Converter::Pdal},
    {"an E57 file", {".e57"}, Converter::CloudCompare},
    {"a PTX file", {".ptx"}, Converter::CloudCompare},
    {"a file compressed by gzip", {".gz"}, Converter::Gunzip},
    {"a ZIP archive", {".zip"}, Converter::Unzip}};
const Format& laz = formats[0];
const Format& e57 = formats[1];
const Format& gzip = formats[3];
const Format& zip = formats[4];

std::string
endingOf(const std::string& path)
{
  std::string ending = std::filesystem::path(path).extension().string();
  for (char& letter : ending)
    letter = static_cast<char>(std::tolower(static_cast<unsigned char>(letter)));
  return ending;
}

const Format*
formatOf(const std::string& path, const std::string& beginning)
{
  const auto begins_with = [&](const std::string& magic) {
    return beginning.compare(0, magic.size(), magic) == 0;
  };
  const std::string ending = endingOf(path);
  if (begins_with("LASF")) // and is compressed: LAS is none of these
    return &laz;
  if (begins_with("ASTM-E57"))
    return &e57;
  if (begins_with("\x1f\x8b"))
    return &gzip;
  if (begins_with("PK\x03\x04"))
    return &zip;
  for (const auto& format : formats)
    if (std::count(format.endings.begin(), format.endings.end(), ending) > 0)
      return &format;
  return nullptr;
}

/** A file name as a shell wants it. */
std::string
quoted(const std::string& name)
{
  const auto is_plain = [](char letter) {
    return std::isalnum(static_cast<unsigned char>(letter)) != 0 ||
           std::string("/._-+:@%").find(letter) != std::string::npos;
  };
  if (std::all_of(name.begin(), name.end(), is_plain))
    return name;
  std::string text = "'";
  for (const char letter : name)
    text += letter == '\'' ? std::string("'\\''") : std::string(1, letter);
  return text + "'";
}

} // namespace

std::string
describeForeignFormat(const std::string& path, const std::string& beginning)
{
  const auto* const format = formatOf(path, beginning);
  if (format == nullptr)
    return "";
  const std::string input = quoted(path);
  std::filesystem::path las = path;
  las.replace_extension(".las");
  std::string command;
  switch (format->converter) {
  case Converter::Pdal:
    command = "convert it: pdal translate " + input + " " + quoted(las.string());
    break;
  case Converter::CloudCompare:
    command = "convert it: CloudCompare -SILENT -O " + input +
              " -C_EXPORT_FMT PLY -SAVE_CLOUDS";
    break;
  case Converter::Gunzip:
    command = "unpack it: gunzip -k " + input;
    break;
  case Converter::Unzip:
    command = "unpack it: unzip " + input;
    break;
  }
  return std::string(format->name) + "; " + command;
}

} // namespace pcl::indoor::tool
