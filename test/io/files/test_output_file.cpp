/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "files/output_file.h"

#include "files/tool_error.h"
#include "support/folder_test.h"

#include <gtest/gtest.h>

#include <csignal>
#include <filesystem>
#include <fstream>
#include <functional>
#include <sys/resource.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/sysmacros.h> // for makedev
#include <sys/un.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

using namespace pcl::indoor::tool;
using pcl::indoor::test::bytesOf;

namespace fs = std::filesystem;

namespace {

class OutputFiles : public pcl::indoor::test::FolderTest {
protected:
  std::ptrdiff_t
  fileCount() const
  {
    return std::distance(fs::directory_iterator(path("")), {});
  }

  /** A character device that may be lost: where root runs the test, not the machine's
   * own. Empty if there is none. */
  std::string
  device(const std::string& name, unsigned minor) const
  {
    if (geteuid() != 0)
      return "/dev/" + name;
    constexpr unsigned memory_devices = 1;
    const bool made =
        mknod(path(name).c_str(), S_IFCHR | 0600, makedev(memory_devices, minor)) == 0;
    return made && std::ofstream(path(name)) ? path(name) : "";
  }

  static std::string
  refusalOf(const std::function<void()>& work)
  {
    try {
      work();
    } catch (const ToolError& error) {
      return error.what();
    }
    return "";
  }
};

/** How a child process that does this work ends. */
int
endOfChild(const std::function<void()>& work)
{
  const pid_t child = fork();
  if (child == 0) {
    work();
    _exit(0);
  }
  int status = 0;
  waitpid(child, &status, 0);
  return status;
}

} // namespace

TEST_F(OutputFiles, AnUnfinishedFileLeavesTheOldOneAndNothingElse)
{
  const auto old = write("out", "old");
  {
    OutputFile file(old);
    file.write("half");
    EXPECT_EQ(fileCount(), 2);
  }
  EXPECT_EQ(bytesOf(old), "old");
  EXPECT_EQ(fileCount(), 1);
  saveText(old, "newer");
  EXPECT_EQ(bytesOf(old), "newer");
  EXPECT_EQ(fileCount(), 1);
}

TEST_F(OutputFiles, AFileKeepsItsPermissions)
{
  const auto old = write("out", "old");
  fs::permissions(old, fs::perms::owner_read | fs::perms::owner_write);
  saveText(old, "new");
  EXPECT_EQ(fs::status(old).permissions(),
            fs::perms::owner_read | fs::perms::owner_write);
}

TEST_F(OutputFiles, OfALinkTheTargetIsReplaced)
{
  fs::create_directory(path("deep"));
  write("deep/target", "old");
  fs::create_symlink("deep/target", path("first"));
  fs::create_symlink("first", path("second"));
  fs::create_symlink("deep/none_yet", path("dangling"));
  for (const char* name : {"second", "dangling"}) {
    requireWritable(path(name));
    saveText(path(name), "new");
    EXPECT_TRUE(fs::is_symlink(path(name)));
    EXPECT_EQ(bytesOf(path(name)), "new");
  }
  EXPECT_EQ(bytesOf(path("deep/target")), "new");
  EXPECT_EQ(bytesOf(path("deep/none_yet")), "new");
  EXPECT_TRUE(fs::is_symlink(path("first")));
  fs::create_symlink("circle", path("circle"));
  EXPECT_NE(refusalOf([&] { requireWritable(path("circle")); }), "");
}

TEST_F(OutputFiles, PipesGetTheBytesAndStayWhatTheyAre)
{
  ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
  requireWritable(path("pipe"));
  std::string read;
  std::thread reader([&] { read = bytesOf(path("pipe")); });
  const std::string text(1 << 20, 'x'); // more than a pipe holds
  saveText(path("pipe"), text);
  reader.join();
  EXPECT_EQ(read, text);
  EXPECT_TRUE(fs::is_fifo(path("pipe")));
}

TEST_F(OutputFiles, DevicesGetTheBytesAndStayWhatTheyAre)
{
  constexpr unsigned null_minor = 3, full_minor = 7;
  const auto null = device("null", null_minor), full = device("full", full_minor);
  if (null.empty() || full.empty())
    GTEST_SKIP() << "no devices can be made here";
  fs::create_symlink(null, path("link"));
  for (const auto& name : {null, path("link")}) {
    requireWritable(name);
    saveText(name, "text");
    EXPECT_TRUE(fs::is_character_file(name));
  }
  EXPECT_TRUE(fs::is_symlink(path("link")));
  EXPECT_EQ(refusalOf([&] { saveText(full, "text"); }),
            full + ": cannot be written, No space left on device");
  EXPECT_TRUE(fs::is_character_file(full));
}

TEST_F(OutputFiles, AReaderThatGoesAwayIsAnError)
{
  ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
  std::thread reader([&] { std::ifstream(path("pipe")).get(); });
  const auto refusal =
      refusalOf([&] { saveText(path("pipe"), std::string(1 << 20, 'x')); });
  reader.join();
  EXPECT_EQ(refusal, path("pipe") + ": cannot be written, Broken pipe");
}

TEST_F(OutputFiles, WhatCannotBeWrittenIsRefusedBefore)
{
  const auto file = write("file", "text");
  const int socket_descriptor = socket(AF_UNIX, SOCK_STREAM, 0);
  sockaddr_un address{};
  address.sun_family = AF_UNIX;
  path("socket").copy(address.sun_path, sizeof(address.sun_path) - 1);
  ASSERT_EQ(bind(socket_descriptor,
                 reinterpret_cast<const sockaddr*>(&address),
                 sizeof(address)),
            0);
  for (const auto& name :
       {path("missing/out"), file + "/out", path(""), path("socket")})
    EXPECT_EQ(refusalOf([&] { requireWritable(name); }).find(name + ": cannot be "),
              0u);
  close(socket_descriptor);
  EXPECT_NO_THROW(requireWritable(path("out")));
  EXPECT_NO_THROW(requireWritable(file));
  EXPECT_THROW(requireFolder(file), ToolError);
  EXPECT_THROW(requireFolder(file + "/deeper"), ToolError);
  EXPECT_NO_THROW(requireFolder(path("a/b/c")));
  EXPECT_EQ(fileCount(), 2); // asking makes nothing
  makeFolder(path("a/b/c"));
  EXPECT_TRUE(fs::is_directory(path("a/b/c")));
  EXPECT_THROW(makeFolder(file + "/deeper"), ToolError);
}

TEST_F(OutputFiles, AFullDiskIsAnErrorAndLeavesNothing)
{
  const auto old = write("out", "old");
  const int status = endOfChild([&] {
    const rlimit largest{1000, 1000};
    setrlimit(RLIMIT_FSIZE, &largest);
    const auto refusal = refusalOf([&] { saveText(old, std::string(2000, 'x')); });
    _exit(refusal == old + ": cannot be written, File too large" ? 0 : 1);
  });
  EXPECT_EQ(status, 0);
  EXPECT_EQ(bytesOf(old), "old");
  EXPECT_EQ(fileCount(), 1);
}

TEST_F(OutputFiles, SignalsRemoveWhatIsUnfinishedAndEndTheProgram)
{
  const auto old = write("out", "old");
  for (const int signal : {SIGINT, SIGTERM, SIGHUP}) {
    const int status = endOfChild([&] {
      OutputFile first(old), second(path("other"));
      first.write("half");
      OutputFile moved(std::move(second));
      moved.write("half");
      raise(signal);
    });
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal) << status;
    EXPECT_EQ(bytesOf(old), "old");
    EXPECT_EQ(fileCount(), 1);
  }
  const int status = endOfChild([&] { // as nohup does
    std::signal(SIGHUP, SIG_IGN);
    OutputFile file(old);
    file.write("new");
    raise(SIGHUP);
    file.commit();
  });
  EXPECT_EQ(status, 0);
  EXPECT_EQ(bytesOf(old), "new");
}

TEST_F(OutputFiles, SeveralAreReplacedTogetherAndOutdatedOnesGo)
{
  write("a", "old");
  write("outdated", "old");
  std::vector<OutputFile> files;
  for (const char* name : {"a", "b"})
    files.push_back(writtenBeside(path(name), "new"));
  EXPECT_EQ(bytesOf(path("a")), "old");
  EXPECT_NE(refusalOf([&] { OutputFile twice(path("a")); }), "");
  ASSERT_EQ(mkfifo(path("pipe").c_str(), 0600), 0);
  commitTogether(files, {path("outdated"), path("not_there"), path("pipe")});
  EXPECT_EQ(bytesOf(path("a")), "new");
  EXPECT_EQ(bytesOf(path("b")), "new");
  EXPECT_TRUE(fs::is_fifo(path("pipe")));
  EXPECT_EQ(fileCount(), 3);
}
