/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "command_line/huge_pages.h"

#include <unistd.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>

namespace pcl::indoor::tool {
namespace {

namespace fs = std::filesystem;

constexpr const char* variable = "GLIBC_TUNABLES";
constexpr double large = 8e6; // bytes; below, to start again takes as long as is won

std::string
firstLineOf(const std::string& path)
{
  std::string line;
  std::ifstream file(path);
  std::getline(file, line);
  return line;
}

} // namespace

void
useHugePages(int argc, char** argv)
{
  const auto is_large = [](const char* argument) {
    return sizeOfInput(argument) >= large;
  };
  if (argc < 2 || std::getenv(variable) != nullptr ||
      std::none_of(argv + 1, argv + argc, is_large) ||
      !areHugePagesOnRequest(
          firstLineOf("/sys/kernel/mm/transparent_hugepage/enabled")))
    return;
  std::error_code error;
  const auto program = fs::read_symlink("/proc/self/exe", error);
  if (error || setenv(variable, "glibc.malloc.hugetlb=1", 0) != 0)
    return;
  execv(program.c_str(), argv);
  unsetenv(variable); // it goes on as it is
}

bool
areHugePagesOnRequest(const std::string& choice)
{
  return choice.find("[madvise]") != std::string::npos;
}

double
sizeOfInput(const std::string& path)
{
  std::error_code error;
  if (fs::is_regular_file(path, error))
    return static_cast<double>(fs::file_size(path, error));
  double sum = 0.0;
  for (fs::directory_iterator file(path, error), end; !error && file != end;
       file.increment(error)) {
    std::error_code ignored;
    if (file->is_regular_file(ignored))
      sum += static_cast<double>(file->file_size(ignored));
  }
  return sum;
}

} // namespace pcl::indoor::tool
