#include "app/figure_file.h"

#include <filesystem>
#include <fmt/format.h>

#include "app/figure_writer.h"
#include "app/picture_texts.h"
#include "app/window_system.h"
#include "renderer/base/error.h"
#include "renderer/base/files.h"
#include "renderer/base/made_by.h"
#include "renderer/gl/gl.h"

namespace gbl {
namespace {

// "out/figure-003-normal.png": the first number that is free.
std::filesystem::path free_figure_name(const Settings& s) {
  for (int n = 1;; ++n) {
    auto path = std::filesystem::path("out") / fmt::format("figure-{:03}-{}.png", n, s.view.main);
    if (!std::filesystem::exists(path)) return path;
  }
}

Image shown(glm::ivec2 first, glm::ivec2 size, glm::ivec2 window) {
  std::vector<uint8_t> pixels(4 * static_cast<size_t>(size.x) * static_cast<size_t>(size.y));
  glBindFramebuffer(GL_FRAMEBUFFER, 0);
  glPixelStorei(GL_PACK_ALIGNMENT, 1);
  glReadPixels(first.x, window.y - first.y - size.y, size.x, size.y, GL_RGBA, GL_UNSIGNED_BYTE, pixels.data());
  return image_from_gl_rows(size, std::move(pixels));
}

Image with_caption(Image picture, const ui::Figure& figure, ImguiScreen& screen) {
  const Image caption = screen.picture({picture.size.x, ui::caption_height(figure)}, [&] { ui::draw_caption(figure); });
  picture.rgba.insert(picture.rgba.end(), caption.rgba.begin(), caption.rgba.end());
  picture.size.y += caption.size.y;
  return picture;
}

// Its first line says what is seen, the others how it was made.
FigureWords words_of(const ui::Figure& figure, const std::filesystem::path& path, const std::string& command) {
  const std::string seen = figure.caption.empty() ? "The window of G-Buffer Lab." : figure.caption[0];
  return {.id = path.stem().string(),
          .file = path.filename().string(),
          .title = seen,
          .caption = figure.caption.empty() ? seen : fmt::format("{}", fmt::join(figure.caption, " ")),
          .alt = seen,
          .source = "",
          .command = command,
          .made_by = made_by()};
}

}  // namespace

std::string save_figure(const ui::Figure& figure, glm::ivec2 window, ImguiScreen& screen, const Settings& s,
                        const Machine& machine) {
  const bool whole = figure.size.x <= 0;
  Image image = whole ? shown({0, 0}, window, window) : shown(figure.first, figure.size, window);
  if (!figure.caption.empty()) image = with_caption(std::move(image), figure, screen);
  make_folder("out");
  const std::filesystem::path path = free_figure_name(s);
  const PngText texts = picture_texts("gbufferlab view", s, machine);
  write_png(path, image, texts);
  write_words(path.parent_path(), words_of(figure, path, texts.back().second));
  hand_over(path.string());
  return fmt::format("saved {}", path.string());
}

}  // namespace gbl
