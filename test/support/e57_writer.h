/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <cstdint>
#include <cstring>
#include <string>
#include <utility>
#include <vector>

namespace pcl::indoor::test {

/** \brief A field of the points of an E57 file: how it is described and its values as
 * bits. */
struct E57Column {
  std::string name, attributes;
  unsigned bits = 0;
  std::vector<std::uint64_t> stored;
};

inline E57Column
e57Doubles(const std::string& name, const std::vector<double>& values)
{
  E57Column column{
      name, "type=\"Float\"", 64, std::vector<std::uint64_t>(values.size())};
  std::memcpy(column.stored.data(), values.data(), values.size() * sizeof(double));
  return column;
}

inline E57Column
e57Floats(const std::string& name, const std::vector<float>& values)
{
  E57Column column{name, "type=\"Float\" precision=\"single\"", 32, {}};
  for (const float value : values) {
    std::uint32_t bits = 0;
    std::memcpy(&bits, &value, sizeof(bits));
    column.stored.push_back(bits);
  }
  return column;
}

/** \param[in] more attributes: for a scaled one scale and offset */
inline E57Column
e57Wholes(const std::string& name,
          std::int64_t minimum,
          std::int64_t maximum,
          const std::vector<std::int64_t>& values,
          const std::string& more = "")
{
  const std::string type = more.empty() ? "Integer" : "ScaledInteger";
  E57Column column{name,
                   "type=\"" + type + "\" minimum=\"" + std::to_string(minimum) +
                       "\" maximum=\"" + std::to_string(maximum) + "\" " + more,
                   0,
                   {}};
  const auto range =
      static_cast<std::uint64_t>(maximum) - static_cast<std::uint64_t>(minimum);
  for (auto rest = range; rest > 0; rest /= 2)
    ++column.bits;
  for (const auto value : values)
    column.stored.push_back(static_cast<std::uint64_t>(value) -
                            static_cast<std::uint64_t>(minimum));
  return column;
}

/** \brief A scan of an E57 file. */
struct E57TestScan {
  std::string name;
  std::vector<E57Column> columns;
  std::string more = {};   ///< elements such as the pose
  std::int64_t count = -1; ///< that is promised; -1: that of the values
};

/** \brief Makes small E57 files (ASTM E2807), bit by bit as the standard has it. */
class E57Writer {
public:
  std::size_t points = 20; ///< of a packet; of some fields a little more
  bool are_apart = false;  ///< each field in packets of its own, one after the other
  bool has_others = true;  ///< packets without data among them
  bool are_shared = false; ///< all scans have the points of the first
  std::string codecs = {};
  std::uint64_t section_id = 1;

  std::string
  file(const std::vector<E57TestScan>& scans)
  {
    logical_.assign(48, '\0');
    std::string xml =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<e57Root type=\"Structure\" "
        "xmlns=\"http://www.astm.org/COMMIT/E57/2010-e57-v1.0\" "
        "xmlns:las=\"http://www.astm.org/COMMIT/E57/2010-las-v1.0\" "
        "xmlns:nor=\"http://www.libe57.org/E57_NOR_surface_normals.txt\">\n"
        "<formatName type=\"String\">ASTM E57 3D Imaging Data File</formatName>\n"
        "<guid type=\"String\">file</guid>\n<versionMajor type=\"Integer\">1"
        "</versionMajor>\n<versionMinor type=\"Integer\"/>\n"
        "<data3D type=\"Vector\" allowHeterogeneousChildren=\"1\">\n";
    std::uint64_t place = 0;
    for (const auto& scan : scans) {
      if (place == 0 || !are_shared)
        place = addPoints(scan);
      xml += describe(scan, place);
    }
    xml += "</data3D>\n<images2D type=\"Vector\"/>\n</e57Root>\n";
    return finish(xml);
  }

  /** \brief Give the pages of a file checksums that fit. */
  static void
  sign(std::string& bytes)
  {
    for (std::size_t page = 0; page + 1024 <= bytes.size(); page += 1024) {
      std::uint32_t crc = 0xffffffff;
      for (std::size_t i = page; i < page + 1020; ++i) {
        crc ^= static_cast<unsigned char>(bytes[i]);
        for (int bit = 0; bit < 8; ++bit)
          crc = crc >> 1 ^ ((crc & 1) != 0 ? 0x82f63b78 : 0);
      }
      for (int k = 0; k < 4; ++k)
        bytes[page + 1020 + static_cast<std::size_t>(k)] =
            static_cast<char>(~crc >> (24 - 8 * k));
    }
  }

private:
  static std::uint64_t
  physical(std::uint64_t logical)
  {
    return logical / 1020 * 1024 + logical % 1020;
  }

  template <typename T>
  static void
  append(std::string& bytes, T value)
  {
    bytes.append(reinterpret_cast<const char*>(&value), sizeof(value));
  }

  static std::string
  packed(const E57Column& column)
  {
    std::string bytes((column.stored.size() * column.bits + 7) / 8, '\0');
    std::size_t at = 0;
    for (const auto value : column.stored)
      for (unsigned bit = 0; bit < column.bits; ++bit, ++at)
        if ((value >> bit & 1) != 0)
          bytes[at / 8] = static_cast<char>(bytes[at / 8] | 1 << at % 8);
    return bytes;
  }

  static void
  fill(std::string& packet)
  {
    while (packet.size() % 4 != 0)
      packet += '\0';
    const auto size = static_cast<std::uint16_t>(packet.size() - 1);
    std::memcpy(&packet[2], &size, sizeof(size));
  }

  /** Packets with data, an index and an empty one among them. */
  void
  addPackets(const std::vector<E57Column>& columns)
  {
    std::vector<std::string> streams;
    for (const auto& column : columns)
      streams.push_back(packed(column));
    std::vector<std::size_t> done(streams.size(), 0);
    const auto has_more = [&] {
      for (std::size_t f = 0; f < streams.size(); ++f)
        if (done[f] < streams[f].size())
          return true;
      return false;
    };
    for (std::size_t number = 0; has_more(); ++number) {
      std::string packet("\1\0\0\0", 4), pieces;
      append(packet, static_cast<std::uint16_t>(streams.size()));
      for (std::size_t f = 0; f < streams.size(); ++f) {
        const bool waits = are_apart && f > 0 && done[f - 1] < streams[f - 1].size();
        const auto size = (points * columns[f].bits + 7) / 8 + f % 3;
        const auto taken = streams[f].substr(done[f], waits ? 0 : size);
        done[f] += taken.size();
        append(packet, static_cast<std::uint16_t>(taken.size()));
        pieces += taken;
      }
      packet += pieces;
      fill(packet);
      std::string other(number % 3 == 0 ? 16 : 8, '\0');
      other[0] = number % 3 == 0 ? '\0' : '\2';
      fill(other);
      logical_ += packet + (number % 3 == 2 || !has_others ? "" : other);
    }
  }

  /** \return the place of the section */
  std::uint64_t
  addPoints(const E57TestScan& scan)
  {
    const auto begin = logical_.size();
    logical_.append(32, '\0');
    addPackets(scan.columns);
    const std::uint64_t header[] = {
        section_id, logical_.size() - begin, physical(begin + 32), 0};
    std::memcpy(&logical_[begin], header, sizeof(header));
    return physical(begin);
  }

  std::string
  describe(const E57TestScan& scan, std::uint64_t place) const
  {
    const auto count = scan.count >= 0
                           ? scan.count
                           : static_cast<std::int64_t>(scan.columns[0].stored.size());
    std::string text =
        "<vectorChild type=\"Structure\">\n<guid type=\"String\">scan</guid>\n<name "
        "type=\"String\">"
        "<![CDATA[" +
        scan.name + "]]></name>\n" + scan.more +
        "<points type=\"CompressedVector\" fileOffset=\"" + std::to_string(place) +
        "\" recordCount=\"" + std::to_string(count) +
        "\">\n<prototype type=\"Structure\">\n";
    for (const auto& column : scan.columns)
      text += "<" + column.name + " " + column.attributes + "/>\n";
    return text + "</prototype>\n<codecs type=\"Vector\">" + codecs +
           "</codecs>\n</points>\n</vectorChild>\n";
  }

  std::string
  finish(const std::string& xml)
  {
    const auto place = logical_.size();
    logical_ += xml;
    logical_.resize((logical_.size() + 1019) / 1020 * 1020, '\0');
    std::string header = "ASTM-E57";
    append(header, std::uint32_t{1});
    append(header, std::uint32_t{0});
    append(header, std::uint64_t{logical_.size() / 1020 * 1024});
    append(header, physical(place));
    append(header, std::uint64_t{xml.size()});
    append(header, std::uint64_t{1024});
    logical_.replace(0, header.size(), header);
    std::string bytes;
    for (std::size_t page = 0; page < logical_.size(); page += 1020)
      bytes += logical_.substr(page, 1020) + std::string(4, '\0');
    sign(bytes);
    return bytes;
  }

  std::string logical_;
};

} // namespace pcl::indoor::test
