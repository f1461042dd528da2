/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "pictures/svg_raster.h"

#include "files/output_file.h"
#include "formats/file_ending.h"
#include "pictures/png_bytes.h"
#include "text/printable.h"

#include <algorithm>

#ifdef PCL_INDOOR_HAS_RSVG

#include <librsvg/rsvg.h>

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdint>
#include <cstdlib>
#include <memory>

namespace pcl::indoor::tool {
namespace {

constexpr double most_pixels = 10000.0; // wide or high

/** Frees what the C libraries made. */
struct Release {
  void
  operator()(RsvgHandle* handle) const
  {
    g_object_unref(handle);
  }

  void
  operator()(cairo_surface_t* surface) const
  {
    cairo_surface_destroy(surface);
  }

  void
  operator()(cairo_t* context) const
  {
    cairo_destroy(context);
  }
};

template <typename T>
using Owned = std::unique_ptr<T, Release>;

bool
sendAll(int file, const void* bytes, std::size_t length)
{
  const auto* data = static_cast<const char*>(bytes);
  while (length > 0) {
    const auto sent = send(file, data, length, MSG_NOSIGNAL);
    if (sent <= 0)
      return false;
    data += sent;
    length -= static_cast<std::size_t>(sent);
  }
  return true;
}

/** The bytes of a PNG file. */
std::string
pngOf(cairo_surface_t* image)
{
  const auto* const pixels = cairo_image_surface_get_data(image);
  const int width = cairo_image_surface_get_width(image);
  std::vector<Color> row(static_cast<std::size_t>(width));
  return pngBytes(width, cairo_image_surface_get_height(image), [&](int y) {
    const auto* pixel = reinterpret_cast<const std::uint32_t*>(
        pixels +
        static_cast<std::ptrdiff_t>(y) * cairo_image_surface_get_stride(image));
    for (auto& color : row) {
      const auto rgb = *pixel++;
      color = {static_cast<std::uint8_t>(rgb >> 16),
               static_cast<std::uint8_t>(rgb >> 8),
               static_cast<std::uint8_t>(rgb)};
    }
    return row.data();
  });
}

/** The bytes of a PNG file; empty if it cannot be drawn. */
std::string
pngOf(const Picture& picture)
{
  const Owned<RsvgHandle> drawing(
      rsvg_handle_new_from_data(reinterpret_cast<const guint8*>(picture.svg.data()),
                                picture.svg.size(),
                                nullptr));
  double width = 0.0, height = 0.0;
  if (!drawing ||
      !rsvg_handle_get_intrinsic_size_in_pixels(drawing.get(), &width, &height))
    return "";
  const double scale =
      std::min(picture.pixels_per_unit, most_pixels / std::max({width, height, 1.0}));
  const Owned<cairo_surface_t> image(cairo_image_surface_create(
      CAIRO_FORMAT_RGB24,
      std::max(1, static_cast<int>(std::floor(scale * width))),
      std::max(1, static_cast<int>(std::floor(scale * height)))));
  const Owned<cairo_t> context(cairo_create(image.get()));
  const RsvgRectangle page{0.0, 0.0, scale * width, scale * height};
  if (!rsvg_handle_render_document(drawing.get(), context.get(), &page, nullptr) ||
      cairo_surface_status(image.get()) != CAIRO_STATUS_SUCCESS ||
      cairo_status(context.get()) != CAIRO_STATUS_SUCCESS)
    return "";
  cairo_surface_flush(image.get());
  return pngOf(image.get());
}

/** In place of GLib's own, which may wait for itself where memory lacks. */
void
endAtErrors(const gchar* /*domain*/,
            GLogLevelFlags level,
            const gchar* /*text*/,
            gpointer /*unused*/)
{
  if (level & (G_LOG_FLAG_FATAL | G_LOG_LEVEL_ERROR))
    _exit(EXIT_FAILURE);
}

/** What the process does that draws: sends the length of each file, and the file. The
 * libraries print and abort where memory lacks. */
[[noreturn]] void
drawAndEnd(const std::vector<Picture>& pictures, int file)
{
  for (const int number : {SIGINT, SIGTERM, SIGHUP})
    std::signal(number, SIG_DFL); // its files are the other process's
  const int nowhere = open("/dev/null", O_WRONLY);
  if (nowhere >= 0)
    dup2(nowhere, STDERR_FILENO);
  g_log_set_default_handler(endAtErrors, nullptr);
  try {
    for (const auto& picture : pictures) {
      constexpr unsigned longest = 60; // seconds
      alarm(longest);
      const auto bytes = pngOf(picture);
      const auto length = bytes.size();
      if (!sendAll(file, &length, sizeof(length)) ||
          !sendAll(file, bytes.data(), length))
        break;
    }
  } catch (...) {
  }
  _exit(EXIT_SUCCESS);
}

/** Reads bytes until there are so many; false if the other end is closed before. */
bool
receiveAll(int file, void* bytes, std::size_t length)
{
  auto* data = static_cast<char*>(bytes);
  while (length > 0) {
    const auto received = recv(file, data, length, 0);
    if (received < 0 && errno == EINTR)
      continue;
    if (received <= 0)
      return false;
    data += received;
    length -= static_cast<std::size_t>(received);
  }
  return true;
}

/** Draws while this process goes on. */
class DrawingProcess {
public:
  explicit DrawingProcess(const std::vector<Picture>& pictures)
  : files_(pictures.size())
  {
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
      return;
    number_ = fork();
    if (number_ == 0)
      drawAndEnd(pictures, ends[1]);
    close(ends[1]);
    file_ = ends[0];
  }

  DrawingProcess(const DrawingProcess&) = delete;
  DrawingProcess&
  operator=(const DrawingProcess&) = delete;

  ~DrawingProcess()
  {
    if (file_ >= 0)
      close(file_);
    if (number_ > 0)
      waitpid(number_, nullptr, 0);
  }

  /** Waits for them; those that do not come whole are empty. */
  std::vector<std::string>
  files()
  {
    std::size_t length = 0;
    for (auto& file : files_) {
      if (file_ < 0 || !receiveAll(file_, &length, sizeof(length)))
        break;
      file.resize(length);
      if (!receiveAll(file_, file.data(), length))
        file.clear();
    }
    return files_;
  }

private:
  std::vector<std::string> files_;
  pid_t number_ = -1;
  int file_ = -1;
};

std::future<std::vector<std::string>>
drawnFiles(const std::vector<Picture>& pictures)
{
  return std::async([process = std::make_unique<DrawingProcess>(pictures)] {
    return process->files();
  });
}

} // namespace

bool
canRasterise()
{
  return true;
}

} // namespace pcl::indoor::tool

#else

namespace pcl::indoor::tool {
namespace {

std::future<std::vector<std::string>>
drawnFiles(const std::vector<Picture>& pictures)
{
  return std::async(std::launch::deferred, [count = pictures.size()] {
    return std::vector<std::string>(count);
  });
}

} // namespace

bool
canRasterise()
{
  return false;
}

} // namespace pcl::indoor::tool

#endif

namespace pcl::indoor::tool {

std::future<std::vector<std::pair<std::string, std::string>>>
rasterised(const std::vector<Picture>& pictures)
{
  std::vector<std::pair<std::string, std::string>> files;
  for (const auto& picture : pictures)
    files.emplace_back(picture.path, "");
  return std::async(
      std::launch::deferred, [files, drawn = drawnFiles(pictures)]() mutable {
        const auto bytes = drawn.get();
        std::string missing;
        for (std::size_t k = 0; k < files.size(); ++k)
          if ((files[k].second = bytes[k]).empty())
            missing += (missing.empty() ? "" : ", ") + files[k].first;
        if (!missing.empty())
          printWarning(missing + " cannot be drawn" +
                       (canRasterise() ? "" : " without librsvg") + ", and left out");
        const auto is_missing = [](const auto& file) { return file.second.empty(); };
        files.erase(std::remove_if(files.begin(), files.end(), is_missing),
                    files.end());
        return files;
      });
}

void
savePictures(const std::vector<Picture>& pictures)
{
  std::vector<Picture> drawn;
  for (const auto& picture : pictures)
    if (fileEnding(picture.path) == ".svg")
      saveText(picture.path, picture.svg);
    else
      drawn.push_back(picture);
  if (drawn.empty())
    return;
  for (const auto& [path, bytes] : rasterised(drawn).get())
    saveText(path, bytes);
}

} // namespace pcl::indoor::tool
