/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "formats/ply/ply_body.h"

#include "files/tool_error.h"
#include "formats/table/table_words.h" // for readNumber

#include <pcl/PCLPointField.h>

#include <algorithm>
#include <cstring>
#include <limits>
#include <string_view>
#include <type_traits>

namespace pcl::indoor::tool {
namespace {

template <typename T>
void
storeAs(double value, std::uint8_t* out, const std::string& path)
{
  if constexpr (std::is_integral_v<T>) {
    if (!(value >= static_cast<double>(std::numeric_limits<T>::min()) &&
          value <= static_cast<double>(std::numeric_limits<T>::max())))
      throw ToolError(path + ": the value " + std::to_string(value) +
                      " does not fit its type");
  }
  const T typed = static_cast<T>(value);
  std::memcpy(out, &typed, sizeof(T));
}

} // namespace

std::size_t
plyTypeSize(std::uint8_t type)
{
  switch (type) {
  case PCLPointField::INT8:
  case PCLPointField::UINT8:
    return 1;
  case PCLPointField::INT16:
  case PCLPointField::UINT16:
    return 2;
  case PCLPointField::FLOAT64:
    return 8;
  default:
    return 4;
  }
}

PlyBody::PlyBody(std::string bytes, Encoding encoding, std::string path)
: bytes_(std::move(bytes))
, encoding_(encoding)
, path_(std::move(path))
{}

void
PlyBody::read(std::uint8_t type, std::uint8_t* out)
{
  if (encoding_ == Encoding::Ascii) {
    store(nextNumber(), type, out);
    return;
  }
  const std::size_t size = plyTypeSize(type);
  if (bytes_.size() - at_ < size)
    throwEnd();
  std::memcpy(out, &bytes_[at_], size);
  if (encoding_ == Encoding::Big)
    std::reverse(out, out + size);
  at_ += size;
}

void
PlyBody::throwEnd() const
{
  throw ToolError(path_ + ": the file is truncated, it ends before its last point");
}

double
PlyBody::nextNumber()
{
  constexpr const char* gaps = " \t\r\n";
  const std::size_t begin = bytes_.find_first_not_of(gaps, at_);
  if (begin == bytes_.npos)
    throwEnd();
  at_ = std::min(bytes_.find_first_of(gaps, begin), bytes_.size());
  const auto word = std::string_view(bytes_).substr(begin, at_ - begin);
  double value = 0.0;
  if (!readNumber(word, value))
    throw ToolError(path_ + ": '" + std::string(word.substr(0, 20)) +
                    "' is not a number");
  return value;
}

void
PlyBody::store(double value, std::uint8_t type, std::uint8_t* out) const
{
  switch (type) {
  case PCLPointField::INT8:
    return storeAs<std::int8_t>(value, out, path_);
  case PCLPointField::UINT8:
    return storeAs<std::uint8_t>(value, out, path_);
  case PCLPointField::INT16:
    return storeAs<std::int16_t>(value, out, path_);
  case PCLPointField::UINT16:
    return storeAs<std::uint16_t>(value, out, path_);
  case PCLPointField::INT32:
    return storeAs<std::int32_t>(value, out, path_);
  case PCLPointField::UINT32:
    return storeAs<std::uint32_t>(value, out, path_);
  case PCLPointField::FLOAT32:
    return storeAs<float>(value, out, path_);
  default:
    return storeAs<double>(value, out, path_);
  }
}

} // namespace pcl::indoor::tool
