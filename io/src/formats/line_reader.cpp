/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "formats/line_reader.h"

#include "files/tool_error.h"

#include <algorithm>

namespace pcl::indoor::tool {

LineReader::LineReader(const std::string& path)
: path_(path)
, stream_(path, std::ios::binary)
{
  if (!stream_)
    throw ToolError(path + ": the file cannot be read");
}

void
LineReader::seek(const Place& place)
{
  stream_.clear();
  stream_.seekg(static_cast<std::streamoff>(place.byte));
  buffer_.clear();
  at_ = 0;
  next_ = place;
}

bool
LineReader::refill()
{
  constexpr std::size_t at_once = 1 << 16;      // bytes
  constexpr std::size_t longest_line = 1 << 16; // bytes
  buffer_.erase(0, at_);
  at_ = 0;
  if (buffer_.size() > longest_line)
    throw ToolError(path_ + ": line " + std::to_string(next_.line) +
                    " is longer than 65536 bytes");
  const auto size = buffer_.size();
  buffer_.resize(size + at_once);
  stream_.read(&buffer_[size], static_cast<std::streamsize>(at_once));
  buffer_.resize(size + static_cast<std::size_t>(stream_.gcount()));
  return buffer_.size() > size;
}

bool
LineReader::next(std::string_view& line)
{
  for (;;) {
    auto end = buffer_.find('\n', at_);
    while (end == buffer_.npos && refill())
      end = buffer_.find('\n', at_);
    if (end == buffer_.npos && at_ == buffer_.size())
      return false;
    end = std::min(end, buffer_.size());
    line = std::string_view(buffer_).substr(at_, end - at_);
    place_ = next_;
    const auto taken = std::min(end + 1, buffer_.size()) - at_;
    at_ += taken;
    next_.byte += taken;
    ++next_.line;
    if (line.find_first_not_of(" \t\r") != line.npos)
      return true;
  }
}

} // namespace pcl::indoor::tool
