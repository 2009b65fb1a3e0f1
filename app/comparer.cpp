#include "app/comparer.h"

#include <algorithm>
#include <fmt/format.h>

#include "renderer/base/error.h"
#include "renderer/base/size_text.h"
#include "renderer/picture/exr.h"
#include "renderer/picture/srgb.h"

namespace gbl {
namespace {

constexpr double kSlowestMs = 2000;  // B is drawn smaller where it would hold the window up longer

// As the display shows linear radiance.
Image displayed(const ExrPicture& from, double exposure, Colour colour) {
  Image out{from.size, {}};
  for (const glm::vec3& radiance : from.rgb) {
    for (int k = 0; k < 3; ++k) {
      const double linear = std::clamp(double(radiance[k]) * exposure, 0.0, 1.0);
      const double code = colour == Colour::srgb ? double(srgb_from_linear(static_cast<float>(linear))) : linear;
      out.rgba.push_back(static_cast<uint8_t>(std::lround(255 * (code >= 0 ? code : 0))));  // a NaN is no number: black
    }
    out.rgba.push_back(255);
  }
  return out;
}

bool is_exr(const std::string& file) { return file.size() > 4 && file.substr(file.size() - 4) == ".exr"; }

gl::Texture uploaded(Image image) {
  std::vector<uint8_t> rows;  // GL's go up
  const size_t bytes = 4 * static_cast<size_t>(image.size.x);
  for (int y = image.size.y - 1; y >= 0; --y)
    rows.insert(rows.end(), image.rgba.begin() + static_cast<std::ptrdiff_t>(bytes * static_cast<size_t>(y)),
                image.rgba.begin() + static_cast<std::ptrdiff_t>(bytes * static_cast<size_t>(y + 1)));
  return gl::make_image({.size = image.size,
                         .rgba = rows.data(),
                         .address_u = gl::Address::clamp,
                         .address_v = gl::Address::clamp,
                         .min = gl::Filtering::linear,
                         .label = "compared picture"});
}

// The floats of a part of the picture: what error_stats() reads.
std::vector<float> cropped(const std::vector<float>& all, glm::ivec2 size, glm::ivec2 first, glm::ivec2 count) {
  std::vector<float> out;
  for (int y = size.y - first.y - count.y; y < size.y - first.y; ++y) {  // rows bottom to top
    const auto row = static_cast<std::ptrdiff_t>(
        4 * (static_cast<size_t>(y) * static_cast<size_t>(size.x) + static_cast<size_t>(first.x)));
    out.insert(out.end(), all.begin() + row, all.begin() + row + 4 * count.x);
  }
  return out;
}

}  // namespace

void Comparer::open_picture() {
  if (opened_ == asked_->file) return;
  picture_.reset();
  opened_ = asked_->file;
  const Settings& s = lab_.drawn();
  picture_ = uploaded(is_exr(opened_) ? displayed(read_exr(opened_), s.exposure, s.colour) : read_png(opened_));
}

void Comparer::draw_b(View view) {
  const Settings& a = lab_.drawn();
  Settings b = asked_->b;
  if (b.scene != lab_.scene_name())
    throw Error(ExitCode::bad_input, "B", fmt::format("shows another scene, {}", b.scene), "Tab goes there");
  require_valid(b, lab_.limits());
  b.size = a.size, b.view = a.view;
  if (std::string why = why_missing(view, b); !why.empty())
    throw Error(ExitCode::bad_input, "B", fmt::format("has no {}: {}", row(view).label, why), "choose another view");
  const auto frame = lab_.renderer().resolve(b, *lab_.gpu_scene());
  b.size = lab_.cost().affordable_size(*frame, b.size, kSlowestMs);
  if (!targets_) targets_ = std::make_unique<Targets>();
  lab_.renderer().render(b, *lab_.gpu_scene(), *targets_);
  lab_.renderer().draw_view(view, b, *lab_.gpu_scene(), *targets_,
                            {.stats = lab_.stats_of(view),
                             .stats_of = [this](View v) { return lab_.stats_of(v); },
                             .overlays = lab_.is_main(view) && !asked_->difference});
}

const gl::Texture* Comparer::picture_of_b(View view, bool truth_drawn) {
  switch (asked_->what) {
    case ui::BesideA::settings: draw_b(view); return &targets_->canvases.drawn_view(view)->texture;
    case ui::BesideA::picture: open_picture(); return &*picture_;
    case ui::BesideA::truth: break;
  }
  if (truth_drawn) return &lab_.targets().canvases.drawn_view(View::reference)->texture;
  shown_.missing = fmt::format("working out the reference: {:.0f} %", 100 * lab_.truth_progress());
  waiting_ = true;
  return nullptr;
}

void Comparer::find_difference(View view, const gl::Texture& b) {
  const gl::Texture& a = lab_.targets().canvases.drawn_view(view)->texture;
  if (!errors_ || errors_->texture.size != a.size) {
    errors_ = make_canvas({.size = a.size, .format = Format::rgba32f, .label = "differences"});
    coloured_ = make_canvas({.size = a.size, .linear_filter = true, .label = "difference"});
    shown_.stats.reset();
  }
  lab_.renderer().draw_difference(a, b, *errors_);
  read_.start(errors_->texture);
  waiting_ = true;
}

void Comparer::take_stats() {
  const std::vector<float>* floats = read_.take(false);
  waiting_ |= read_.pending();
  if (!floats || !errors_) return;
  const glm::ivec2 size = errors_->texture.size;
  const glm::ivec2 first = glm::clamp(glm::ivec2(asked_->first * glm::dvec2(size)), glm::ivec2(0), size - 1);
  const glm::ivec2 count =
      glm::clamp(glm::ivec2(glm::ceil(asked_->share * glm::dvec2(size))), glm::ivec2(1), size - first);
  shown_.stats = error_stats(ErrorOf::final, count, cropped(*floats, size, first, count), 0);
  if (shown_.stats->worst.x >= 0) shown_.stats->worst += first;
  const ErrorScale scale = asked_->with_sign ? ErrorScale::with_sign : ErrorScale::magnitude;
  lab_.renderer().colour_difference(errors_->texture, scale, shown_.stats->range, *coloured_);
  shown_.difference = {coloured_->texture.id(), size};
  shown_.legend = error_legend(*shown_.stats, scale);
  shown_.legend.apart.clear();  // every pixel is compared
}

void Comparer::update(const std::optional<ui::CompareRequest>& wanted, bool a_drawn, bool truth_drawn) {
  waiting_ = false;
  if (!wanted) {
    asked_.reset(), targets_.reset(), picture_.reset(), opened_.clear(), read_.drop();
    shown_ = {};
    return;
  }
  const bool anew = a_drawn || asked_ != wanted || !shown_.b.texture;
  asked_ = wanted;
  if (anew) {
    try {
      shown_.missing.clear(), shown_.note.clear();
      const View view = wanted->view;
      if (needs_truth(view))
        throw Error(ExitCode::bad_input, "B", fmt::format("has no {} of its own", row(view).label),
                    "choose another view");
      if (wanted->what == ui::BesideA::truth && view != View::final)
        throw Error(ExitCode::bad_input, "B", "is the truth's finished picture", "1 shows A's");
      const gl::Texture* b = picture_of_b(view, truth_drawn);
      shown_.b = b ? ui::ViewImage{b->id(), b->size} : ui::ViewImage{};
      const glm::ivec2 size = lab_.drawn().size;
      if (b && b->size != size)
        shown_.note = fmt::format("B is {}, stretched to {}", size_text(b->size), size_text(size));
      if (b && wanted->difference) find_difference(view, *b);
    } catch (const Error& e) {
      shown_ = {};
      shown_.missing = e.what();
    }
  }
  take_stats();
}

}  // namespace gbl
