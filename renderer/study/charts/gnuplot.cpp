#include "renderer/study/charts/gnuplot.h"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fmt/format.h>
#include <memory>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include "renderer/base/error.h"

namespace gbl {
namespace {

// Okabe and Ito 2008, "Color Universal Design", without their yellow: too pale on white.
constexpr const char* kColours[] = {"#0072B2", "#D55E00", "#009E73", "#CC79A7", "#E69F00", "#56B4E9", "#000000"};
// gnuplot's numbers: disc, square, triangles, diamond, pentagon.
struct Shape {
  int filled, open;
};
constexpr Shape kShapes[] = {{7, 6}, {5, 4}, {9, 8}, {11, 10}, {13, 12}, {15, 14}};

struct Closer {
  void operator()(std::FILE* f) const { std::fclose(f); }
};
using File = std::unique_ptr<std::FILE, Closer>;

[[noreturn]] void cannot(std::string_view what, std::string_view fix) {
  throw Error(ExitCode::unfinished, "gnuplot", what, fix);
}

// A file without a name: a pipe would block, or kill us, when gnuplot stops reading.
File scratch_file() {
  File file(std::tmpfile());
  if (!file) cannot(std::strerror(errno), fmt::format("make room in {}", P_tmpdir));
  return file;
}

std::string contents(std::FILE* file) {
  std::string text;
  std::rewind(file);
  char block[65536];
  for (size_t n = 0; (n = std::fread(block, 1, sizeof block, file)) > 0;) text.append(block, n);
  return text;
}

std::string first_line(const std::string& text) {
  const size_t begin = text.find_first_not_of(" \t\r\n");
  return begin == std::string::npos ? "" : text.substr(begin, text.find('\n', begin) - begin);
}

// The command's exit status, as waitpid() tells it.
int run(std::FILE* in, std::FILE* out, std::FILE* err) {
  posix_spawn_file_actions_t files;
  posix_spawn_file_actions_init(&files);
  posix_spawn_file_actions_adddup2(&files, fileno(in), 0);
  posix_spawn_file_actions_adddup2(&files, fileno(out), 1);
  posix_spawn_file_actions_adddup2(&files, fileno(err), 2);
  std::string name = "gnuplot", no_user_file = "-d", from_stdin = "-";
  char* arguments[] = {name.data(), no_user_file.data(), from_stdin.data(), nullptr};
  pid_t child = 0;
  const int error = posix_spawnp(&child, name.c_str(), &files, nullptr, arguments, environ);
  posix_spawn_file_actions_destroy(&files);
  if (error == ENOENT)
    cannot("is not installed, so the chart was not drawn", "install the package gnuplot-nox and run this again");
  if (error != 0) cannot(fmt::format("cannot be started: {}", std::strerror(error)), "");
  int status = 0;
  while (waitpid(child, &status, 0) < 0)
    if (errno != EINTR) cannot(std::strerror(errno), "");
  return status;
}

// A chart that was cut short has no end: gnuplot does not say that the disk was full.
bool whole(const std::string& chart) {
  const size_t last = chart.find_last_not_of('\n');
  const std::string_view used = std::string_view(chart).substr(0, last + 1);
  return used.ends_with("</svg>") || used.ends_with(std::string_view("IEND\xae\x42\x60\x82"));
}

}  // namespace

std::string run_gnuplot(const std::string& script) {
  const File in = scratch_file(), out = scratch_file(), err = scratch_file();
  if (std::fwrite(script.data(), 1, script.size(), in.get()) != script.size() || std::fflush(in.get()) != 0)
    cannot(std::strerror(errno), fmt::format("make room in {}", P_tmpdir));
  std::rewind(in.get());
  const int status = run(in.get(), out.get(), err.get());
  if (status != 0)
    cannot(fmt::format("did not draw the chart: {}", first_line(contents(err.get()))),
           "it needs the terminals svg and pngcairo: install the package gnuplot-nox");
  std::string chart = contents(out.get());
  if (!whole(chart)) cannot("its chart was cut short", fmt::format("make room in {}", P_tmpdir));
  return chart;
}

const char* series_colour(size_t n) { return kColours[n % std::size(kColours)]; }

int series_shape(size_t n, bool sound) {
  const Shape& shape = kShapes[n % std::size(kShapes)];
  return sound ? shape.filled : shape.open;
}

std::string legend_heading(const std::string& words) {
  return fmt::format("keyentry with points pt 0 lc rgb '#ffffff' title {}", gnuplot_text(words));
}

// In single quotes nothing is special but the quote itself.
std::string gnuplot_text(const std::string& text) {
  std::string out = "'";
  for (const char c : text) {
    const bool control = static_cast<unsigned char>(c) < 0x20 || c == 0x7f;
    out += control ? std::string(" ") : c == '\'' ? std::string("''") : std::string(1, c);
  }
  return out + "'";
}

}  // namespace gbl
