/*
 * SPDX-License-Identifier: BSD-3-Clause
 * Copyright (c) 2026, the pcl_indoor contributors
 */
#include "pictures/plan_png.h"

#include "files/tool_error.h"
#include "text/printable.h"

#ifdef PCL_INDOOR_HAS_RSVG

#include <librsvg/rsvg.h>

#include <fcntl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <memory>
#include <utility>

namespace pcl::indoor::tool {
namespace {

constexpr double pixels_per_unit = 2.0; // 100 pixels per metre: 2.5 mm lines stay sharp

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
sendAll(int file, const unsigned char* data, std::size_t length)
{
  while (length > 0) {
    const auto sent = send(file, data, length, MSG_NOSIGNAL);
    if (sent <= 0)
      return false;
    data += sent;
    length -= static_cast<std::size_t>(sent);
  }
  return true;
}

cairo_status_t
append(void* file, const unsigned char* data, unsigned int length)
{
  return sendAll(*static_cast<int*>(file), data, length) ? CAIRO_STATUS_SUCCESS
                                                         : CAIRO_STATUS_WRITE_ERROR;
}

/** Draw, and write the bytes of the PNG file; false if that fails. */
bool
draw(const std::string& svg, int most_pixels, int file)
{
  const Owned<RsvgHandle> drawing(rsvg_handle_new_from_data(
      reinterpret_cast<const guint8*>(svg.data()), svg.size(), nullptr));
  double width = 0.0, height = 0.0;
  if (!drawing ||
      !rsvg_handle_get_intrinsic_size_in_pixels(drawing.get(), &width, &height))
    return false;
  const double scale =
      std::min(pixels_per_unit, most_pixels / std::max({width, height, 1.0}));
  const Owned<cairo_surface_t> image(cairo_image_surface_create(
      CAIRO_FORMAT_RGB24,
      std::max(1, static_cast<int>(std::floor(scale * width))),
      std::max(1, static_cast<int>(std::floor(scale * height)))));
  const Owned<cairo_t> context(cairo_create(image.get()));
  const RsvgRectangle page{0.0, 0.0, scale * width, scale * height};
  return rsvg_handle_render_document(drawing.get(), context.get(), &page, nullptr) &&
         cairo_surface_write_to_png_stream(image.get(), append, &file) ==
             CAIRO_STATUS_SUCCESS;
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

/** What the process does that draws: the libraries print and abort where memory lacks.
 */
[[noreturn]] void
drawAndEnd(const std::string& svg, int most_pixels, int file)
{
  for (const int number : {SIGINT, SIGTERM, SIGHUP})
    std::signal(number, SIG_DFL); // its files are the other process's
  const int nowhere = open("/dev/null", O_WRONLY);
  if (nowhere >= 0)
    dup2(nowhere, STDERR_FILENO);
  constexpr unsigned longest = 60; // seconds
  alarm(longest);
  g_log_set_default_handler(endAtErrors, nullptr);
  bool is_drawn = false;
  try {
    is_drawn = draw(svg, most_pixels, file);
  } catch (...) {
  }
  _exit(is_drawn ? EXIT_SUCCESS : EXIT_FAILURE);
}

/** All bytes until the other end is closed. */
std::string
readAll(int file)
{
  std::string bytes;
  char part[65536];
  for (ssize_t count = 0; (count = read(file, part, sizeof(part))) != 0;) {
    if (count > 0)
      bytes.append(part, static_cast<std::size_t>(count));
    else if (errno != EINTR)
      break;
  }
  return bytes;
}

/** Draws while this process goes on. */
class DrawingProcess {
public:
  DrawingProcess(const std::string& svg, int most_pixels)
  {
    int ends[2];
    if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends) != 0)
      return;
    number_ = fork();
    if (number_ == 0)
      drawAndEnd(svg, most_pixels, ends[1]);
    close(ends[1]);
    file_ = ends[0];
  }

  DrawingProcess(const DrawingProcess&) = delete;
  DrawingProcess&
  operator=(const DrawingProcess&) = delete;

  ~DrawingProcess() { end(); }

  /** Waits for it. */
  std::string
  picture()
  {
    auto bytes = number_ > 0 ? readAll(file_) : "";
    if (end() != 0)
      throw ToolError("The plan cannot be drawn as PNG");
    return bytes;
  }

private:
  /** Its exit status, once. */
  int
  end()
  {
    int status = EXIT_FAILURE;
    if (file_ >= 0)
      close(std::exchange(file_, -1));
    if (number_ > 0)
      waitpid(std::exchange(number_, -1), &status, 0);
    return status;
  }

  pid_t number_ = -1;
  int file_ = -1;
};

} // namespace

bool
canDrawPlans()
{
  return true;
}

std::future<std::string>
drawnAsPng(const std::string& svg, int most_pixels)
{
  return std::async([drawing = std::make_unique<DrawingProcess>(svg, most_pixels)] {
    return drawing->picture();
  });
}

} // namespace pcl::indoor::tool

#else

namespace pcl::indoor::tool {

bool
canDrawPlans()
{
  return false;
}

std::future<std::string>
drawnAsPng(const std::string& /*svg*/, int /*most_pixels*/)
{
  return std::async(std::launch::deferred, [] { return std::string(); });
}

} // namespace pcl::indoor::tool

#endif

namespace pcl::indoor::tool {

std::future<std::optional<std::string>>
planPicture(const std::string& svg)
{
  using Picture = std::optional<std::string>;
  return std::async(std::launch::deferred, [drawn = drawnAsPng(svg)]() mutable {
    try {
      return canDrawPlans() ? Picture(drawn.get()) : Picture();
    } catch (const ToolError& error) {
      printWarning(messageOf(error) + "; it is left out");
      return Picture();
    }
  });
}

} // namespace pcl::indoor::tool
