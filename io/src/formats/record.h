/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#pragma once

#include <Eigen/Core>

#include <cstdint>
#include <cstring>
#include <stdexcept>
#include <string>
#include <type_traits>
#include <utility>
#include <vector>

namespace pcl::indoor::tool {

/** \brief Thrown where the bytes of a record end too early or too late. */
class DamagedRecord : public std::runtime_error {
public:
  DamagedRecord()
  : std::runtime_error("a record is damaged")
  {}
};

/** \brief Whether the bytes in memory are all there is of a value. */
template <typename T>
struct IsPlain : std::bool_constant<std::is_arithmetic_v<T> || std::is_enum_v<T>> {};
template <typename S, int rows, int columns>
struct IsPlain<Eigen::Matrix<S, rows, columns>>
: std::bool_constant<(rows > 0 && columns > 0)> {};

/** \brief Values as bytes, for files that are read again by the same program on a
 * machine of the same kind: numbers, texts, pairs, vectors, fixed matrices, and structs
 * with a function exchange(record, value), which names their members and serves both
 * ways. */
template <typename Bytes>
class BasicRecordWriter {
public:
  explicit BasicRecordWriter(Bytes bytes = {})
  : bytes_(std::move(bytes))
  {}

  template <typename... Ts>
  void
  operator()(const Ts&... values)
  {
    (put(values), ...);
  }

  const Bytes&
  bytes() const&
  {
    return bytes_;
  }

  Bytes
  bytes() &&
  {
    return std::move(bytes_);
  }

private:
  void
  append(const void* bytes, std::size_t size)
  {
    bytes_.append(static_cast<const char*>(bytes), size);
  }

  template <typename T>
  void
  put(const T& value)
  {
    if constexpr (IsPlain<T>::value)
      append(&value, sizeof(T));
    else
      exchange(*this, const_cast<T&>(value)); // which only reads it
  }

  template <typename A, typename B>
  void
  put(const std::pair<A, B>& pair)
  {
    put(pair.first);
    put(pair.second);
  }

  template <typename T>
  void
  put(const std::vector<T>& values)
  {
    put(static_cast<std::uint64_t>(values.size()));
    if constexpr (IsPlain<T>::value)
      append(values.data(), values.size() * sizeof(T));
    else
      for (const auto& value : values)
        put(value);
  }

  void
  put(const std::string& text)
  {
    put(static_cast<std::uint64_t>(text.size()));
    append(text.data(), text.size());
  }

  Bytes bytes_;
};

using RecordWriter = BasicRecordWriter<std::string>;

/** \brief Takes bytes as a string does, and keeps their number only. */
class ByteCount {
public:
  void
  append(const char*, std::size_t size)
  {
    size_ += size;
  }

  std::size_t
  size() const
  {
    return size_;
  }

private:
  std::size_t size_ = 0;
};

/** \brief A value as bytes; they take no more memory than there are. */
template <typename T>
std::string
recordOf(const T& value)
{
  BasicRecordWriter<ByteCount> count;
  count(value);
  std::string bytes;
  bytes.reserve(count.bytes().size());
  RecordWriter record(std::move(bytes));
  record(value);
  return std::move(record).bytes();
}

/** \brief Takes the values of a RecordWriter out again, in the same order.
 * Every function throws DamagedRecord if there are too few bytes. */
class RecordReader {
public:
  /** \param[in] bytes must outlive the reader */
  explicit RecordReader(const std::string& bytes)
  : bytes_(bytes)
  {}

  template <typename... Ts>
  void
  operator()(Ts&... values)
  {
    (get(values), ...);
  }

  /** \brief Make sure that nothing is left. */
  void
  finish() const
  {
    if (at_ != bytes_.size())
      throw DamagedRecord();
  }

private:
  void
  take(void* target, std::size_t size)
  {
    if (size > bytes_.size() - at_)
      throw DamagedRecord();
    if (size > 0)
      std::memcpy(target, bytes_.data() + at_, size);
    at_ += size;
  }

  /** A number of values of at least so many bytes each. */
  std::size_t
  count(std::size_t bytes_each)
  {
    std::uint64_t number = 0;
    take(&number, sizeof(number));
    if (number > (bytes_.size() - at_) / bytes_each)
      throw DamagedRecord();
    return static_cast<std::size_t>(number);
  }

  /** No other byte may become one. */
  void
  get(bool& value)
  {
    std::uint8_t byte = 0;
    take(&byte, sizeof(byte));
    if (byte > 1)
      throw DamagedRecord();
    value = byte == 1;
  }

  template <typename T>
  void
  get(T& value)
  {
    if constexpr (IsPlain<T>::value)
      take(&value, sizeof(T));
    else
      exchange(*this, value);
  }

  template <typename A, typename B>
  void
  get(std::pair<A, B>& pair)
  {
    get(pair.first);
    get(pair.second);
  }

  template <typename T>
  void
  get(std::vector<T>& values)
  {
    if constexpr (IsPlain<T>::value) {
      values.resize(count(sizeof(T)));
      take(values.data(), values.size() * sizeof(T));
    }
    else {
      values.resize(count(1));
      for (auto& value : values)
        get(value);
    }
  }

  void
  get(std::string& text)
  {
    text.resize(count(1));
    take(text.data(), text.size());
  }

  const std::string& bytes_;
  std::size_t at_ = 0;
};

} // namespace pcl::indoor::tool
