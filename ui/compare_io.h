#pragma once
// What the window's A/B comparison asks of the app, and gets.
#include <optional>
#include <string>

#include "renderer/inspect/views.h"
#include "renderer/options/settings.h"
#include "renderer/truth/error_stats.h"

namespace gbl::ui {

struct ViewImage;

// What stands beside the picture A that the window draws.
enum class BesideA { settings, truth, picture };

struct CompareRequest {
  BesideA what = BesideA::settings;
  View view = View::final;        // of the large picture: what is compared
  Settings b;                     // of `settings`; its size is A's
  std::string file;               // of `picture`: PNG or EXR
  bool difference = false;        // worked out and coloured, too
  bool with_sign = false;         // which way, else how far
  glm::dvec2 first{0}, share{1};  // of the picture that the numbers are of, from its top left
  bool operator==(const CompareRequest&) const = default;
};

}  // namespace gbl::ui
